//! Arms at which a sweep found a defect (`arms/found/`). Each arm is examined by everything that a sweep asks of it,
//! and at the joint vectors at the head of its file. The generated code of the arm is compared with its evaluation.

use denhart_tests::random::Random;
use denhart_tests::sweep::replay::replay;

/// A module for each file: name, joints, file.
macro_rules! found {
    ($($name:ident $dof:tt $file:literal;)*) => {$(
        mod $name {
            #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
            #[arm(spec = $file)]
            struct Found;

            #[test]
            fn replayed() {
                super::check(include_str!(concat!("../", $file)));
            }

            #[test]
            fn evaluated() {
                denhart_tests::evaluated::inverse::<Found, $dof>($file, denhart_tests::margins_of!(Found), denhart_tests::branch_of!(Found));
            }
        }
    )*};
}

fn check(text: &str) {
    let outcome = replay(text).expect("an arm file");
    assert!(outcome.refused.is_none() && outcome.poses > 500, "{:?}, {} poses", outcome.refused, outcome.poses);
    assert!(outcome.failures.is_empty(), "{:#?}", outcome.failures);
}

found! {
    // A wrist in the middle is not decoupled.
    sweep_1_139 6 "arms/found/sweep_1_139.yaml";
    // Three parallel axes behind a free joint: the first stage does not depend on it.
    sweep_1_229 6 "arms/found/sweep_1_229.yaml";
    sweep_1_544 7 "arms/found/sweep_1_544.yaml";
    // The roots of the first stage lie in two intervals.
    sweep_1_780 6 "arms/found/sweep_1_780.yaml";
    // A slide between the free joint and the stage.
    sweep_1_274 6 "arms/found/sweep_1_274.yaml";
    // Two free joints, and a stage that has no root with either at its default.
    sweep_1_714 6 "arms/found/sweep_1_714.yaml";
    sweep_1_1142 6 "arms/found/sweep_1_1142.yaml";
    // Two free joints that have to move together.
    // A given slide of 1e308.
    sweep_1_433 7 "arms/found/sweep_1_433.yaml";
    // Axes that miss the structure by 1e-11: every branch is verified.
    sweep_1_4073 6 "arms/found/sweep_1_4073.yaml";
    // Axes 4 and 5 are parallel but for 1e-7 degrees, whose cosine is 1: not one turn.
    sweep_1_15785 6 "arms/found/sweep_1_15785.yaml";
    // A fifth joint that slides where a pose needs one that rolls.
    sweep_1_4652 5 "arms/found/sweep_1_4652.yaml";
    // A quartic with a fourfold root, behind which a joint is free.
    fourfold_root 6 "arms/found/fourfold_root.yaml";
    // Two equations for the first joint: by the uncertainty of its root the other equation may be missed.
    sweep_7_1362 5 "arms/found/sweep_7_1362.yaml";
    // A wrist in line in a later pass is no flip of one beside.
    sweep_7_7152 6 "arms/found/sweep_7_7152.yaml";
    // A free joint meets an equation at several places: a solution for each.
    sweep_1_5719 6 "arms/found/sweep_1_5719.yaml";
    sweep_1_1329 6 "arms/found/sweep_1_1329.yaml";
    // Of two rings with axes that meet and axes that are parallel, one has a link of hardly any length.
    sweep_1_3911 6 "arms/found/sweep_1_3911.yaml";
    target_beside_parallel_axes 6 "arms/found/target_beside_parallel_axes.yaml";
    // Axes that meet when the code is generated meet at every target.
    nearly_meeting 6 "arms/found/nearly_meeting.yaml";
    turned_meeting 6 "arms/found/turned_meeting.yaml";
}

#[derive(Debug, Clone, Copy, Default, denhart::Arm)]
#[arm(spec = "arms/found/turned_meeting.yaml", scalar = "f32")]
struct TurnedMeeting;

/// Rounding moves axes that meet by 1e-8 of the reach.
#[test]
fn axes_meet_in_single_precision() {
    let mut random = Random::named("turned_meeting");
    for _ in 0..500 {
        let q: [f32; 6] = std::array::from_fn(|_| random.uniform(-3.0, 3.0) as f32);
        let solutions = TurnedMeeting.inverse(&TurnedMeeting.forward(&q));
        assert!(solutions.status().is_reachable(), "{q:?}: {solutions:?}");
    }
}
