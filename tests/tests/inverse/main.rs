//! Inverse kinematics of every arm that has one: nothing is lost, nothing wrong is called exact.
//!
//! One module an arm, one test a group of joint vectors. The complete 30 degree grid (3 million poses an arm) runs with
//! `DENHART_FULL_GRID=1`.

use denhart_tests::suite::Grids;

mod closing;
mod counts;
mod flips;
mod further_runs;

/// Grids up to 45 degrees (262,144 poses) in full.
const COMPLETE: Grids = Grids { complete: 262_144, samples: 20_000 };

/// Grids up to 90 degrees in full.
const SAMPLED: Grids = Grids { complete: 4096, samples: 20_000 };

macro_rules! inverse_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(inverse_tests! { @$kind $name $Type $file COMPLETE })*
    };
    (@forward $name:ident $Type:ident $file:literal $grids:ident) => {};
    (@task $name:ident $Type:ident $file:literal $grids:ident) => {};
    (@held $name:ident $Type:ident $file:literal $grids:ident) => {};
    (@inverse $name:ident $Type:ident $file:literal $grids:ident) => {
        mod $name {
            use denhart_tests::arms::$Type;
            use denhart_tests::subject::Subject;
            use denhart_tests::suite;

            #[test]
            fn random_poses() {
                suite::random_poses(&Subject::new::<$Type>());
            }

            #[test]
            fn grids() {
                suite::grids(&Subject::new::<$Type>(), crate::$grids);
            }

            #[test]
            fn awkward_poses() {
                suite::awkward_poses(&Subject::new::<$Type>());
            }

            #[test]
            fn out_of_reach() {
                suite::out_of_reach(&Subject::new::<$Type>());
            }

            #[test]
            fn bad_targets() {
                denhart_tests::bad_targets::check::<$Type, 6>();
            }

            #[test]
            fn effort() {
                denhart_tests::effort::check::<$Type, 6>(denhart_tests::branch_of!($Type));
            }

            #[test]
            fn evaluated() {
                denhart_tests::evaluated::inverse::<$Type, 6>($file, denhart_tests::margins_of!($Type), denhart_tests::branch_of!($Type));
            }
        }
    };
}

macro_rules! made_up_inverse_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(inverse_tests! { @$kind $name $Type $file SAMPLED })*
    };
}

denhart_tests::published_arms!(inverse_tests);
denhart_tests::made_up_arms!(made_up_inverse_tests);
