//! Inverse kinematics of every task but the six-joint pose: nothing is lost, nothing wrong is called exact.
//!
//! An arm is one line of a list: its name, number of joints, task, and file. The arms are of this target alone, so that `cargo test -p denhart-tests --no-default-features --test
//! tasks` builds without all others.

/// One module an arm, one test a group of joint vectors.
macro_rules! arms {
    ($($name:ident $dof:tt $kind:ident $(($axis:ident))? $(given $joint:literal)? $file:literal;)*) => {$(
        pub(crate) mod $name {
            use denhart_tests::subject::Subject;
            use denhart_tests::task::{Kind, Task};
            use denhart_tests::{bad_targets, branches, suite};

            denhart_tests::arm!($name Tested $dof $file Task::new(Kind::$kind $((crate::$axis))?)$(.redundant($joint))?);

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
                denhart_tests::evaluated::inverse::<Tested, $dof>($file, denhart_tests::margins_of!(Tested), denhart_tests::branch_of!(Tested));
            }

            #[test]
            fn residuals() {
                suite::residuals::<Tested, $dof>();
            }

            #[test]
            fn branch_counts() {
                branches::check(&Subject::new::<Tested>());
            }
        }
    )*};
}

mod margins;
mod planar;
mod pose_of_fewer_joints;
mod position;
mod position_angle;
mod position_axis;
mod position_redundant;
mod redundant;
mod redundant_made_up;

use denhart_tests::suite::Grids;

/// Three joints: all grids in full. Four: up to 30 degrees; five: up to 45; seven: 90.
const GRIDS: Grids = Grids { complete: 33_000, samples: 4_000 };

/// The axes of the tool, as `position_axis` has them.
const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;
