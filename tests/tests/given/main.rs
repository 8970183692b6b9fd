//! Arms with joints whose values are given: several of them in a list, and each joint of the arms of seven.
//!
//! An arm is one line of a list: its name, number of joints, task, the given joints in the order of the call, and file. The
//! arms are of this target alone, so that `cargo test -p denhart-tests --no-default-features --test given` builds without
//! all others.

mod arm_angle;
mod calls;
mod each_joint;

use denhart_tests::suite::Grids;

/// One module an arm, one test a group of joint vectors. `holding_a_joint`: an inverse that does. `losing`: the failures that
/// docs/known-gaps.md counts.
macro_rules! arms {
    ($($name:ident $dof:tt $kind:ident $(($axis:literal))? given $($joint:literal)+ $(, $holds:ident)? $(losing $known:literal)?, $file:literal;)*) => {$(
        mod $name {
            use denhart_tests::subject::Subject;
            use denhart_tests::task::{Kind, Task};
            use denhart_tests::{bad_targets, suite};

            denhart_tests::arm!($name Tested $dof $file Task::new(Kind::$kind $(($axis))?)$(.redundant($joint))+ $(.$holds())? $(.losing($known))?);

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

const GRIDS: Grids = Grids { complete: 4096, samples: 2000 };

arms! {
    iiwa_list_of_one 7 Pose given 3, "arms/given/iiwa_list_of_one.yaml";
    iiwa_on_a_rail 8 Pose given 1 4, "arms/given/iiwa_on_a_rail.yaml";
    iiwa_on_a_torso 8 Pose given 4 1, "arms/given/iiwa_on_a_torso.yaml";
    ur5_on_a_table 8 Pose given 1 2, "arms/given/ur5_on_a_table.yaml";
    puma_between_slides 8 Pose given 8 1, "arms/given/puma_between_slides.yaml";
    iiwa_ten_joints 10 Pose given 1 2 3 6 losing 1, "arms/given/iiwa_ten_joints.yaml";
    crx_on_a_table 8 Pose given 2 1, holding_a_joint, "arms/given/crx_on_a_table.yaml";
    sawyer_on_a_rail 8 Pose given 1 4, holding_a_joint, "arms/given/sawyer_on_a_rail.yaml";
    third_axis 7 Pose given 4, holding_a_joint, "arms/given/third_axis.yaml";
    slides_between_turns 8 Pose given 1 8, holding_a_joint, "arms/given/slides_between_turns.yaml";
    position_of_five 5 Position given 4 2, "arms/given/position_of_five.yaml";
    welder_on_a_positioner 8 PositionAxis(2) given 3 1 2, "arms/given/welder_on_a_positioner.yaml";
    planar_of_five 5 PlanarPose given 1 4, "arms/given/planar_of_five.yaml";
}
