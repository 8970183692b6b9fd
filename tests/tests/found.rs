//! Arms at which a sweep found a defect (`arms/found/`): everything that a sweep asks of them, and the joint vectors at the
//! head of their files.

use denhart_tests::sweep::replay::replay;

/// A test for each file.
macro_rules! found {
    ($($name:ident)*) => {$(
        #[test]
        fn $name() {
            let text = include_str!(concat!("../arms/found/", stringify!($name), ".yaml"));
            let outcome = replay(text).expect("an arm file");
            assert!(outcome.refused.is_none() && outcome.poses > 500, "{:?}, {} poses", outcome.refused, outcome.poses);
            assert!(outcome.failures.is_empty(), "{:#?}", outcome.failures);
        }
    )*};
}

found! {
    // A wrist in the middle is not decoupled.
    sweep_1_139
    // Three parallel axes behind a free joint: the first stage does not depend on it.
    sweep_1_229
    sweep_1_544
    sweep_1_1612
    // The roots of the first stage lie in two intervals.
    sweep_1_780
    // A slide between the free joint and the stage.
    sweep_1_274
    // Two free joints, and a stage that has no root with either at home.
    sweep_1_714
    sweep_1_1142
    // A given slide of 1e308.
    sweep_1_433
    // Axes that miss the structure by 1e-11: every branch is verified.
    sweep_1_4073
    // A fifth joint that slides where a pose needs one that rolls.
    sweep_1_4652
}
