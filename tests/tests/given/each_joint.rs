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

/// `file` with joint 1 to 7 given in turn; `losing`: how many poses fail with each, of docs/known-gaps.md. `None`: no joint of
/// the other six can be held.
fn check(file: &str, losing: [Option<usize>; 7]) {
    let path = format!("{}/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{file}: {error}"));
    let (before, after) = text.split_once("redundant: q").expect("the file names a joint");
    let mut found = [None; 7];
    let mut reports = String::new();
    for (joint, failed) in (1..).zip(&mut found) {
        let text = format!("{before}redundant: q{joint}{}", &after[1..]);
        let arm = DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
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
        *failed = Some(report.failed());
        reports += &report.to_string();
    }
    let is_known = |(found, known): (&Option<usize>, &Option<usize>)| match (found, known) {
        (Some(found), Some(known)) => found <= known,
        (found, known) => found == known,
    };
    assert!(found.iter().zip(&losing).all(is_known), "{file}: {found:?}, known are {losing:?}\n{reports}");
}

#[test]
fn sawyer() {
    check("../specs/rethink_sawyer.yaml", [0; 7].map(Some));
}

#[test]
fn xarm7() {
    check("../specs/ufactory_xarm7.yaml", [0; 7].map(Some));
}

#[test]
fn kinova_gen3() {
    check("../specs/kinova_gen3_7dof.yaml", [Some(0), Some(0), Some(0), Some(0), Some(0), None, Some(0)]);
}

#[test]
fn baxter() {
    check("../specs/baxter_left.yaml", [0; 7].map(Some));
}

#[test]
fn franka_panda() {
    check("../specs/franka_panda.yaml", [0; 7].map(Some));
}
