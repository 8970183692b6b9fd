//! Everything that an arm is asked.

use std::panic::{AssertUnwindSafe, catch_unwind};

use denhart::effort::Effort;
use denhart::{Chain, JointKind};
use denhart_codegen::model::Task;
use denhart_dynamic::{DynamicArm, DynamicError};
use nalgebra::Matrix6xX;

use super::outcome::{Failure, Outcome};
use super::{arm, beside};
use crate::boundary::{self, Carried};
use crate::poses::{Space, singular_surface};
use crate::random::Random;
use crate::recover;
use crate::report::Report;
use crate::singular::{self, Svd};
use crate::subject::Subject;
use crate::{bad_targets, effort};

/// Joint vectors and attempts of each kind, so that an arm takes some tens of milliseconds.
const RANDOM: usize = 40;
const REFERENCES: usize = 12;
const GRID: usize = 20;
const SPECIAL: usize = 40;
const SURFACE: usize = 20;
const ON_SURFACE: usize = 80;
const FOLDS: usize = 12;
const EFFORT: usize = 5;

/// Examines an arm file. `drawn` is the chain of the numbers that the file was written from, if they are known; `vectors`
/// are joint vectors that the inverse has to give back besides.
pub fn examine(
    (name, structure): (&str, &'static str),
    text: String,
    drawn: Option<&Chain>,
    vectors: &[Vec<f64>],
) -> Outcome {
    let mut outcome = Outcome {
        name: name.to_owned(),
        structure,
        text,
        refused: None,
        poses: 0,
        failures: Vec::new(),
        most: Effort::default(),
    };
    let arm = match guarded(|| DynamicArm::from_yaml(&outcome.text)) {
        Ok(Ok(arm)) => arm,
        Ok(Err(error)) => {
            outcome.failures.push(Failure::of("the file", "refused", &[], error.to_string()));
            return outcome;
        }
        Err(panic) => {
            outcome.failures.push(Failure::of("the file", "panics", &[], panic));
            return outcome;
        }
    };
    let refused = arm.task().err();
    if let Some(DynamicError::Unsupported(_)) = refused {
        outcome.failures.push(Failure::of("the inverse", "is generated and not evaluated", &[], String::new()));
    }
    outcome.refused = refused.map(|error| error.to_string());
    macro_rules! sized {
        ($($joints:literal)*) => {
            match arm.joints() {
                $($joints => of_size::<$joints>(&mut outcome, &arm, drawn, vectors),)*
                _ => outcome.failures.push(Failure::of("the file", "has too many joints", &[], String::new())),
            }
        };
    }
    sized!(1 2 3 4 5 6 7 8);
    outcome
}

/// The result of a call, or what it panicked with.
fn guarded<R>(call: impl FnOnce() -> R) -> Result<R, String> {
    catch_unwind(AssertUnwindSafe(call)).map_err(|panic| match panic.downcast::<String>() {
        Ok(text) => *text,
        Err(other) => other.downcast::<&str>().map_or_else(|_| "a panic".to_owned(), |text| (*text).to_owned()),
    })
}

fn of_size<const N: usize>(outcome: &mut Outcome, arm: &DynamicArm, drawn: Option<&Chain>, vectors: &[Vec<f64>]) {
    let mut report = Report::new(&outcome.name);
    let mut random = Random::named(&outcome.name);
    let (read, _) = arm::chain(arm.model());
    let reach = arm::reach(arm);
    let limits: [[f64; 2]; N] = std::array::from_fn(|joint| arm.limits()[joint]);
    let kinds = std::array::from_fn(|joint| arm.joint_kinds()[joint]);
    let space = Space::<N>::new(&kinds, &limits, reach);
    let judges = [("forward", drawn.unwrap_or(&read)), ("forward, as read", &read)];
    for (family, chain) in judges {
        let mut vectors = space.grid_samples(4, 5, &mut random);
        vectors.extend((0..5).map(|_| space.random(&mut random)));
        for q in vectors {
            if let Err(panic) = guarded(|| beside::check(arm, chain, reach, family, &q, &mut report)) {
                outcome.failures.push(Failure::of(family, "panics", &q, panic));
            }
        }
    }
    let asks_for_a_pose = arm.model().inverse.task.is_none_or(|task| task == Task::Pose);
    if N == 6
        && asks_for_a_pose
        && outcome.refused.as_ref().is_some_and(|reason| reason.contains("singular everywhere"))
    {
        // A measured arm is refused for its table.
        let table = arm::table(arm.model());
        for q in (0..4).map(|_| space.random(&mut random)) {
            report.count(&q);
            let columns = scaled(table.jacobian(&q).expect("a value a joint"), &kinds, reach);
            let least = Svd::new(columns).least();
            if least > singular::ZERO {
                report.fail("refused", "called singular everywhere", || format!("{least:e} at {q:?}"));
            }
        }
    }
    if let Some((subject, inverse)) = arm::subject::<N>(&outcome.text, arm) {
        let mut family = |name: &'static str, work: &mut dyn FnMut(&mut Report, &mut Random)| {
            if let Err(panic) = guarded(|| work(&mut report, &mut random)) {
                outcome.failures.push(Failure::of(name, "panics", report.at(), panic));
            }
        };
        family("joint vectors of the file", &mut |report, _| {
            for q in vectors.iter().filter_map(|q| <&[f64; N]>::try_from(q.as_slice()).ok()) {
                recover::check(&subject, report, "joint vectors of the file", q);
            }
        });
        family("random", &mut |report, random| {
            for index in 0..RANDOM {
                let q = space.random(random);
                recover::check(&subject, report, "random", &q);
                if index < REFERENCES {
                    recover::check_references(&subject, report, "random", &q, random);
                }
            }
        });
        for (steps, name) in [(4, "90 degree grid"), (8, "45 degree grid"), (24, "15 degree grid")] {
            family(name, &mut |report, random| {
                for q in space.grid_samples(steps, GRID, random) {
                    recover::check(&subject, report, name, &q);
                }
            });
        }
        family("beside special values", &mut |report, random| special(&subject, &space, report, random));
        family("out of reach", &mut |report, random| out_of_reach(&subject, report, random));
        family("bad targets", &mut |report, random| bad_targets::check_some(&subject, &inverse, 1, random, report));
        family("effort", &mut |report, random| {
            outcome.most = effort::check_some(&subject, &inverse, EFFORT, SURFACE, random, report);
        });
    }
    outcome.poses = report.poses();
    outcome.failures.extend(Failure::all(&report));
}

/// The columns of a Jacobian with lengths in reaches.
fn scaled<const N: usize>(jacobian: Matrix6xX<f64>, kinds: &[JointKind; N], reach: f64) -> [[f64; 6]; N] {
    std::array::from_fn(|joint| {
        let unit = if kinds[joint] == JointKind::Revolute { 1.0 } else { reach };
        std::array::from_fn(|row| jacobian[(row, joint)] * if row < 3 { unit / reach } else { unit })
    })
}

/// Joint vectors at and beside values where arms tend to be singular, and where this one is.
fn special<const N: usize>(subject: &Subject<N>, space: &Space<N>, report: &mut Report, random: &mut Random) {
    let families = [
        (space.first_joint_square(random), 4),
        (space.one_special(random), SPECIAL),
        (space.two_special(random), SPECIAL),
        (space.three_special(random), SPECIAL),
        (space.all_special(random), SPECIAL),
        (singular_surface(subject, SURFACE, random), ON_SURFACE),
    ];
    for (family, count) in families.iter().filter(|(family, _)| !family.poses.is_empty()) {
        for _ in 0..*count {
            recover::check(subject, report, family.name, &random.pick(&family.poses));
        }
    }
}

/// Targets at the edge of what the arm reaches, and beyond it.
fn out_of_reach<const N: usize>(subject: &Subject<N>, report: &mut Report, random: &mut Random) {
    // The farthest point takes as long as everything else.
    let outermost = random.below(4) == 0;
    if let Some(carried) = Carried::of(subject).filter(|_| outermost).map(Carried::of_any_arm) {
        boundary::check_outermost(subject, &carried, 1, random, report);
    }
    match subject.task.equations() {
        equations if equations == N => boundary::check_folds(subject, FOLDS, random, report),
        _ => boundary::check_leftover(subject, FOLDS, random, report),
    }
    boundary::check_far(subject, 1, random, report);
}

#[cfg(test)]
mod tests {
    use super::super::replay::replay;
    use super::super::{Kind, draw};
    use super::*;

    #[test]
    fn a_chain_with_another_length_is_told_apart() {
        let mut compared = 0;
        for index in 0..40 {
            let (structure, mut table) = draw(Kind::Common, 3, index);
            let text = table.yaml("drawn");
            let outcome = examine(("drawn", structure), text.clone(), Some(&table.chain()), &[]);
            let forward = |outcome: &Outcome| outcome.failures.iter().any(|failure| failure.family == "forward");
            assert!(!forward(&outcome), "{:?}\n{text}", outcome.failures);
            let rows = table.joints.len();
            if let Some(link) = table.links.get_mut(rows / 2).filter(|link| link.a != 0.0) {
                link.a *= 1.0 + 1e-9;
                let other = examine(("drawn", structure), text, Some(&table.chain()), &[]);
                compared += usize::from(forward(&other));
            }
        }
        assert!(compared > 10, "{compared}");
    }

    #[test]
    fn a_failure_is_replayed_at_its_joint_vector() {
        let (structure, table) = draw(Kind::Common, 3, 2);
        let q = [0.1 + 0.2, -1e-12, std::f64::consts::PI, 4.0, 5.0, 6.0, 7.0];
        let q = q[..table.moving()].to_vec();
        let failure = Failure::of("random", "a rule", &q, String::new());
        let mut outcome = examine(("drawn", structure), table.yaml("drawn"), None, &[]);
        let poses = outcome.poses;
        outcome.failures = vec![failure];
        let text = outcome.replay();
        assert!(text.contains(&format!("{q:?}")), "{text}");
        let again = replay(&text).unwrap();
        assert_eq!(again.poses, poses + usize::from(outcome.refused.is_none()), "{text}");
    }
}
