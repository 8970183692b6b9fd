//! Published arms of seven joints with each of their joints given: whichever leaves six that are not singular everywhere has an
//! inverse, which loses nothing.
//!
//! The arms are evaluated at run time: the suites compare that with generated code.

use denhart_dynamic::DynamicArm;
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::recover;
use denhart_tests::report::Report;
use denhart_tests::sweep::arm::subject;

/// Random joint vectors, and those with round angles.
const RANDOM: usize = 300;
const ROUND: usize = 200;

/// `file` with joint 1 to 7 given in turn: no pose fails.
fn check(file: &str) {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"));
    let (before, after) = text.split_once("redundant: q").expect("the file names a joint");
    let mut failed = [0; 7];
    let mut reports = String::new();
    for (joint, failed) in (1..).zip(&mut failed) {
        let text = format!("{before}redundant: q{joint}{}", &after[1..]);
        let arm = DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
        let (subject, _) = subject::<7>(&text, &arm).unwrap_or_else(|| panic!("{file}: no inverse with q{joint}"));
        let mut report = Report::new(&format!("{} with q{joint}", subject.name));
        let mut random = Random::named(&format!("{file} q{joint}"));
        let space = Space::of(&subject);
        for _ in 0..RANDOM {
            let q = space.random(&mut random);
            recover::check(&subject, &mut report, "random", &q);
        }
        for steps in [4, 8, 12, 24] {
            for q in space.grid_samples(steps, ROUND, &mut random) {
                recover::check(&subject, &mut report, "grid", &q);
            }
        }
        *failed = report.failed();
        reports += &report.to_string();
    }
    assert_eq!(failed, [0; 7], "{file}\n{reports}");
}

#[test]
fn sawyer() {
    check("../specs/rethink_sawyer.yaml");
}

#[test]
fn xarm7() {
    check("../specs/ufactory_xarm7.yaml");
}

#[test]
fn kinova_gen3() {
    check("../specs/kinova_gen3_7dof.yaml");
}

#[test]
fn baxter() {
    check("../specs/baxter_left.yaml");
}

#[test]
fn franka_panda() {
    check("../specs/franka_panda.yaml");
}
