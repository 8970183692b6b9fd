//! Further runs of the cascade are taken only where they can tell something.

use std::f64::consts::FRAC_PI_2;

use denhart::Pose;
use denhart::effort::{Effort, effort_of};
use denhart_tests::arms::{KukaIiwa7R800, Ur5};

/// Several singularities meet, and the target is moved out of reach. There is one cascade with the weak joint at its
/// default, three at other places, and one for each of two branches. No stage behind the elbow has a level, so none is
/// for a node of its interval.
#[test]
fn nodes_need_a_second_stage_with_a_level() {
    let target = Pose {
        rotation: [
            [1.0, -5.7654238817580144e-12, 8.060303044967118e-14],
            [8.060303048444293e-14, 6.031083606801433e-12, -1.0],
            [5.765423881757528e-12, 1.0, 6.0310836068018975e-12],
        ],
        translation: [-0.9119000000006454, 0.026849999994291194, 0.08915900000860194],
    };
    let (solutions, Effort { cascades, .. }) = effort_of(|| Ur5.inverse(&target));
    assert_eq!((cascades, solutions.exact().count()), (6, 0), "{solutions:?}");
}

/// Joints 1 and 2 are free, and no stage behind them has a level. There is one cascade with both at their defaults, and
/// one at another place. That place is taken once for each of two branches. The last cascade looks for another member of
/// crossing families.
#[test]
fn places_need_a_stage_with_a_level() {
    let target = Pose {
        rotation: [
            [-1.0, 3.873392968711894e-10, -3.4611904222896984e-10],
            [-3.461190422395022e-10, -2.7191547088535445e-11, 1.0],
            [3.873392968617779e-10, 1.0, 2.719154722260095e-11],
        ],
        translation: [4.961787674656226e-10, 125.99999999972127, 340.0000000002756],
    };
    let (solutions, Effort { cascades, .. }) = effort_of(|| KukaIiwa7R800.inverse(&target, FRAC_PI_2));
    assert_eq!((cascades, solutions.exact().count()), (5, 0), "{solutions:?}");
}
