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

/// `file` with joint 1 to 7 given in turn; `unsolved`: the joints without which the others are singular everywhere.
fn check(file: &str, unsolved: &[usize], losing: usize) {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"));
    let (before, after) = text.split_once("redundant: q").expect("the file names a joint");
    for joint in 1..=7 {
        let text = format!("{before}redundant: q{joint}{}", &after[1..]);
        let arm = DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!(arm.task().is_err(), unsolved.contains(&joint), "{file}, q{joint}: {:?}", arm.task());
        let Some((subject, _)) = subject::<7>(&text, &arm) else { continue };
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
        println!("{file} q{joint}: {} failures", report.failed());
        report.assert_at_most(losing);
    }
}

#[test]
fn sawyer() {
    check("arms/held_joint/sawyer_q3.yaml", &[], 0);
}

#[test]
fn xarm7() {
    check("arms/held_joint/xarm7_q3.yaml", &[], 0);
}

#[test]
fn kinova_gen3() {
    check("../specs/kinova_gen3_7dof.yaml", &[], 0);
}

#[test]
fn baxter() {
    check("../specs/baxter_left.yaml", &[], 0);
}

#[test]
fn franka_panda() {
    check("../specs/franka_panda.yaml", &[], 0);
}
