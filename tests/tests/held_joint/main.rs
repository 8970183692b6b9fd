//! Inverse kinematics of arms without three consecutive axes that meet or are parallel: nothing is lost, nothing wrong is
//! called exact.
//!
//! An arm is one line of a list: its name, number of joints, task, the given joint, and file. The arms are of this target alone,
//! so that `cargo test -p denhart-tests --no-default-features --test held_joint` builds without all others.

#![allow(clippy::unwrap_used)]

use denhart_tests::suite::Grids;

/// One module an arm, one test a group of joint vectors. `losing`: the failures that docs/known-gaps.md counts.
macro_rules! arms {
    ($($name:ident $dof:tt $kind:ident $(($axis:literal))? $(given $joint:literal)? $(losing $known:literal)? $file:literal;)*) => {$(
        mod $name {
            use denhart_tests::subject::Subject;
            use denhart_tests::task::{Kind, Task};
            use denhart_tests::{bad_targets, suite};

            denhart_tests::arm!($name Tested $dof $file Task::new(Kind::$kind $(($axis))?)$(.redundant($joint))?.holding_a_joint()$(.losing($known))?);

            #[test]
            fn random_poses() {
                suite::random_poses(&Subject::new::<Tested>());
            }

            #[test]
            fn grids() {
                suite::grids(&Subject::new::<Tested>(), crate::GRIDS);
            }

            #[test]
            fn awkward_poses() {
                suite::awkward_poses(&Subject::new::<Tested>());
            }

            #[test]
            fn out_of_reach() {
                suite::out_of_reach(&Subject::new::<Tested>());
            }

            #[test]
            fn bad_targets() {
                bad_targets::check::<Tested, $dof>();
            }

            #[test]
            fn effort() {
                denhart_tests::effort::check::<Tested, $dof>(denhart_tests::branch_of!(Tested));
            }

            #[test]
            fn evaluated() {
                denhart_tests::evaluated::inverse::<Tested, $dof>(
                    $file,
                    denhart_tests::margins_of!(Tested),
                    denhart_tests::branch_of!(Tested),
                );
            }

            #[test]
            fn residuals() {
                suite::residuals::<Tested, $dof>();
            }
        }
    )*};
}

/// The grid of 90 degrees in full for six joints.
const GRIDS: Grids = Grids { complete: 4096, samples: 2000 };

/// Every set of solutions of `inverse_truth.json` that belongs to an arm of this page is met.
#[test]
fn every_truth() {
    let mut met = 0;
    macro_rules! meet {
        ($($name:ident)*) => { $(met += denhart_tests::suite::truths(&denhart_tests::subject::Subject::new::<$name::Tested>());)* };
    }
    meet!(fanuc_crx10ial kinova_gen3_lite kinova_jaco ufactory_xarm6 gen6r_a manseur_doty_16 two_parallel_6r);
    assert_eq!(met, 7);
}

arms! {
    fanuc_crx10ial 6 Pose "../specs/fanuc_crx10ial.yaml";
    kinova_gen3_lite 6 Pose "../specs/kinova_gen3_lite.yaml";
    kinova_jaco 6 Pose "../specs/kinova_jaco.yaml";
    ufactory_xarm6 6 Pose "../specs/ufactory_xarm6.yaml";
    gen6r_a 6 Pose "../specs/gen6r_a.yaml";
    manseur_doty_16 6 Pose "../specs/manseur_doty_16.yaml";
    two_parallel_6r 6 Pose "../specs/two_parallel_6r.yaml";
    kinova_mico 6 Pose "../specs/kinova_mico.yaml";
    rethink_sawyer 7 Pose given 3 losing 2 "../specs/rethink_sawyer.yaml";
    baxter_left 7 Pose given 3 "../specs/baxter_left.yaml";
    slides_rprrpr 6 Pose "arms/held_joint/slides_rprrpr.yaml";
    slide_rrprrr 6 Pose "arms/held_joint/slide_rrprrr.yaml";
    slide_on_an_axis 6 Pose "arms/held_joint/slide_on_an_axis.yaml";
    zero_lengths 6 Pose losing 1 "arms/held_joint/zero_lengths.yaml";
    four_zero_lengths 6 Pose "arms/held_joint/four_zero_lengths.yaml";
    ufactory_xarm7 7 Pose given 3 "../specs/ufactory_xarm7.yaml";
    axis_rrrrr 5 PositionAxis(2) "arms/held_joint/axis_rrrrr.yaml";
    axis_square_rrrrr 5 PositionAxis(0) "arms/held_joint/axis_square_rrrrr.yaml";
    axis_rrprr 5 PositionAxis(2) "arms/held_joint/axis_rrprr.yaml";
    axis_rprpr 5 PositionAxis(2) "arms/held_joint/axis_rprpr.yaml";
    axis_jaco 5 PositionAxis(2) "arms/held_joint/axis_jaco.yaml";
    axis_rrrrrr_q1 6 PositionAxis(2) given 1 "arms/held_joint/axis_rrrrrr_q1.yaml";
    pose_rrrrr 5 Pose "arms/held_joint/pose_rrrrr.yaml";
    pose_square_rrrrr 5 Pose "arms/held_joint/pose_square_rrrrr.yaml";
    pose_rrprr 5 Pose "arms/held_joint/pose_rrprr.yaml";
    pose_rprpr 5 Pose "arms/held_joint/pose_rprpr.yaml";
}
