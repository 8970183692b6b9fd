//! Inverse kinematics of every arm that has one: nothing is lost, nothing wrong is called exact.
//!
//! One module an arm, one test a group of joint vectors. The complete 30 degree grid (3 million poses an arm) runs with
//! `DENHART_FULL_GRID=1`.

use denhart_tests::boundary;
use denhart_tests::poses::{Space, singular_surface};
use denhart_tests::random::Random;
use denhart_tests::recover;
use denhart_tests::report::Report;
use denhart_tests::subject::Subject;

mod bad_targets;
mod counts;

/// Whether the 45 degree grid (262,144 poses) is complete or sampled.
#[derive(Clone, Copy, PartialEq)]
enum Grids {
    Complete,
    Sampled,
}

fn random_poses(subject: &Subject<6>) {
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    let space = Space::of(subject);
    for _ in 0..2000 {
        let q = space.random(&mut random);
        recover::check(subject, &mut report, "random", &q);
        recover::check_references(subject, &mut report, "random", &q, &mut random);
    }
    report.assert_nothing_new();
}

fn grids(subject: &Subject<6>, grids: Grids) {
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    let space = Space::of(subject);
    for q in space.grid(4) {
        recover::check(subject, &mut report, "90 degree grid", &q);
    }
    if grids == Grids::Complete {
        for q in space.grid(8) {
            recover::check(subject, &mut report, "45 degree grid", &q);
        }
    } else {
        for q in space.grid_samples(8, 20_000, &mut random) {
            recover::check(subject, &mut report, "45 degree grid", &q);
        }
    }
    for q in space.grid_samples(24, 20_000, &mut random) {
        recover::check(subject, &mut report, "15 degree grid", &q);
    }
    if std::env::var_os("DENHART_FULL_GRID").is_some_and(|value| value == "1") {
        for q in space.grid(12) {
            recover::check(subject, &mut report, "30 degree grid", &q);
        }
    } else {
        for q in space.grid_samples(12, 20_000, &mut random) {
            recover::check(subject, &mut report, "30 degree grid", &q);
        }
    }
    report.assert_nothing_new();
}

fn awkward_poses(subject: &Subject<6>) {
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    let space = Space::of(subject);
    for family in [
        space.first_joint_square(&mut random),
        space.one_special(&mut random),
        space.two_special(&mut random),
        space.all_special(&mut random),
        singular_surface(subject, &mut random),
    ] {
        assert!(!family.poses.is_empty(), "{}: nothing in the family {}", subject.name, family.name);
        for q in &family.poses {
            recover::check(subject, &mut report, family.name, q);
        }
    }
    report.assert_nothing_new();
}

fn out_of_reach(subject: &Subject<6>) {
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    if let Some(wrist) = boundary::wrist_center(subject) {
        boundary::check_outermost(subject, &wrist, &mut random, &mut report);
    }
    boundary::check_folds(subject, &mut random, &mut report);
    boundary::check_far(subject, &mut random, &mut report);
    report.assert_nothing_new();
}

macro_rules! inverse_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $attribute:tt;)*) => {
        $(inverse_tests! { @$kind $name $Type Complete })*
    };
    (@forward $name:ident $Type:ident $grids:ident) => {};
    (@task $name:ident $Type:ident $grids:ident) => {};
    (@inverse $name:ident $Type:ident $grids:ident) => {
        mod $name {
            use denhart_tests::arms::$Type;
            use denhart_tests::subject::Subject;

            #[test]
            fn random_poses() {
                crate::random_poses(&Subject::new::<$Type>());
            }

            #[test]
            fn grids() {
                crate::grids(&Subject::new::<$Type>(), crate::Grids::$grids);
            }

            #[test]
            fn awkward_poses() {
                crate::awkward_poses(&Subject::new::<$Type>());
            }

            #[test]
            fn out_of_reach() {
                crate::out_of_reach(&Subject::new::<$Type>());
            }

            #[test]
            fn bad_targets() {
                crate::bad_targets::check(&Subject::new::<$Type>());
            }
        }
    };
}

macro_rules! made_up_inverse_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $attribute:tt;)*) => {
        $(inverse_tests! { @$kind $name $Type Sampled })*
    };
}

denhart_tests::published_arms!(inverse_tests);
denhart_tests::mounted_arms!(made_up_inverse_tests);
denhart_tests::meeting_arms!(made_up_inverse_tests);
denhart_tests::parallel_arms!(made_up_inverse_tests);
denhart_tests::sliding_arms!(made_up_inverse_tests);
denhart_tests::sliding_parallel_arms!(made_up_inverse_tests);
