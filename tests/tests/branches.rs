//! One branch alone is the same solution as among all.

use std::f64::consts::TAU;

use denhart::effort::effort_of;
use denhart::{Branch, Elbow, Flags, InverseBranch, InverseKinematics, Pose, Shoulder, Solution, Status, Wrist};
use denhart_tests::arms::*;
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::subject::{Specified, Subject};

fn same_as_among_all<A>()
where
    A: Specified<6> + InverseBranch<f64, 6> + InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let (arm, subject) = (A::default(), Subject::new::<A>());
    let (space, mut random) = (Space::of(&subject), Random::named(&subject.name));
    let mut compared = 0;
    for _ in 0..500 {
        let target = arm.forward(&space.random(&mut random));
        let solutions = arm.inverse(&target);
        for solution in solutions.as_ref() {
            // Where branches meet, either root may be the one that stayed.
            if solution.flags == Flags::EXACT || solution.flags == Flags::EXACT | Flags::OUT_OF_LIMITS {
                let alone = arm.inverse_branch(&target, solution.branch);
                assert_eq!(alone, Ok(*solution), "{}", subject.name);
                compared += 1;
            }
        }
        // Every branch that is not listed has no solution, and says by how much it misses.
        for branch in all_branches(solutions.as_ref()) {
            let listed = solutions.as_ref().iter().any(|solution| solution.branch == branch);
            match arm.inverse_branch(&target, branch) {
                Ok(alone) => assert!(listed || alone.flags.contains(Flags::BOUNDARY), "{}: {alone}", subject.name),
                Err(Status::Unreachable { residual }) => {
                    assert!(!listed && residual > 0.0, "{}: {branch}", subject.name)
                }
                Err(status) => panic!("{}: {status}", subject.name),
            }
        }
    }
    assert!(compared > 500, "{}: only {compared}", subject.name);
}

/// Every combination of the parts that the branches of these solutions have.
fn all_branches(solutions: &[Solution<f64, 6>]) -> Vec<Branch> {
    let Some(first) = solutions.first() else { return Vec::new() };
    let mut all = vec![Branch::NONE];
    let mut choose = |parts: &[&dyn Fn(Branch) -> Branch]| {
        all = all.iter().flat_map(|branch| parts.iter().map(|part| part(*branch))).collect();
    };
    if first.branch.shoulder().is_some() {
        choose(&[&|b| b.with_shoulder(Shoulder::Left), &|b| b.with_shoulder(Shoulder::Right)]);
    }
    if first.branch.elbow().is_some() {
        choose(&[&|b| b.with_elbow(Elbow::Up), &|b| b.with_elbow(Elbow::Down)]);
    }
    if first.branch.wrist().is_some() {
        choose(&[&|b| b.with_wrist(Wrist::NoFlip), &|b| b.with_wrist(Wrist::Flip)]);
    }
    if first.branch.root().is_some() {
        choose(&[&|b| b.with_root(1), &|b| b.with_root(2), &|b| b.with_root(3), &|b| b.with_root(4)]);
    }
    all
}

/// The list next to a reference, of a whole branch and of one without its wrist, is what agrees of the whole list.
fn the_part_that_agrees<A>()
where
    A: Specified<6> + InverseBranch<f64, 6> + InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let (arm, subject) = (A::default(), Subject::new::<A>());
    let (space, mut random) = (Space::of(&subject), Random::named(&subject.name));
    let mut shorter = 0;
    for _ in 0..500 {
        let (target, near) = (arm.forward(&space.random(&mut random)), space.random(&mut random));
        let all = arm.inverse_near(&target, &near);
        let all = all.as_ref();
        let regular = |s: &Solution<f64, 6>| (s.flags | Flags::OUT_OF_LIMITS) == (Flags::EXACT | Flags::OUT_OF_LIMITS);
        if !all.iter().all(regular) {
            continue;
        }
        let mut some = arm.inverse(&target);
        for Solution { branch, .. } in all {
            let mut wide = Branch::NONE.with_root(branch.root().unwrap_or(0));
            wide = branch.shoulder().map_or(wide, |side| wide.with_shoulder(side));
            wide = branch.elbow().map_or(wide, |side| wide.with_elbow(side));
            for asked in [*branch, wide] {
                arm.inverse_branch_near_into(&target, asked, &near, true, &mut some);
                let agrees = |s: &&Solution<f64, 6>| {
                    let wrist = asked.wrist().is_none_or(|wrist| Some(wrist) == s.branch.wrist());
                    (s.branch.shoulder(), s.branch.elbow()) == (branch.shoulder(), branch.elbow())
                        && s.branch.root() == branch.root()
                        && wrist
                };
                // The other solution of a wrist may be listed beside the one that is asked for.
                let beside = some.as_ref().iter().all(|s| {
                    (s.branch.shoulder(), s.branch.elbow()) == (branch.shoulder(), branch.elbow())
                        && s.branch.root() == branch.root()
                });
                assert!(beside, "{}: {asked}", subject.name);
                let wanted: Vec<_> = all.iter().filter(agrees).copied().collect();
                let listed: Vec<_> = some.as_ref().iter().filter(agrees).copied().collect();
                assert_eq!(listed, wanted, "{}: {asked}", subject.name);
                shorter += usize::from(wanted.len() < all.len());
            }
        }
    }
    assert!(shorter > 500, "{}: only {shorter}", subject.name);
}

/// Calls a function for arms of every kind of plan.
macro_rules! for_each_kind {
    ($function:ident) => {
        $function::<Puma560>();
        $function::<Ur5>();
        $function::<Stanford>();
        $function::<AbbIrb2400>();
        $function::<MecademicMeca500>();
        $function::<SphericalShoulder6r>();
        $function::<Gen3rSphwrist>();
    };
}

#[test]
fn one_branch_is_the_same_as_among_all() {
    for_each_kind!(same_as_among_all);
}

#[test]
fn a_branch_next_to_a_reference_is_the_part_of_the_list_that_agrees() {
    for_each_kind!(the_part_that_agrees);
}

/// Beside a straight wrist joints 4 and 6 turn against each other, and miss the target by little: a family of solutions. The
/// member at the reference is listed. Where the way from there is long, only a list that keeps its place takes evaluations.
#[test]
fn a_list_keeps_the_place_of_its_reference() {
    let listed = |bend: f64, turned: f64, keeps_place| {
        let (q, near) = ([0.3, -0.6, 0.4, 0.5, bend, 0.2], [0.3, -0.6, 0.4, 0.5 + turned, bend, 0.2 - turned]);
        let target = AbbIrb2400.forward(&q);
        let mut found = AbbIrb2400.inverse(&target);
        let call = || AbbIrb2400.inverse_branch_near_into(&target, Branch::NONE, &near, keeps_place, &mut found);
        let ((), effort) = effort_of(call);
        let nearest = found.first().copied().expect("a solution");
        assert!(nearest.is_exact(), "{nearest}");
        (effort.evaluations, nearest.q[3] - near[3])
    };
    for keeps_place in [true, false] {
        let (_, off) = listed(1e-6, 2e-9, keeps_place);
        assert!(off.abs() < 1e-12, "{off}");
    }
    let ((kept, off), (any, off_too)) = (listed(1e-4, 0.3, true), listed(1e-4, 0.3, false));
    assert!(any < kept, "{any} and {kept} evaluations");
    assert!((off + 0.3).abs() < 1e-8 && (off_too + 0.3).abs() < 1e-8, "{off} and {off_too}");
}

#[test]
fn where_branches_meet_either_is_answered() {
    // The stretched arm: both elbows are one.
    let straight = 0.0203_f64.atan2(0.4318) - std::f64::consts::FRAC_PI_2;
    let target = Puma560.forward(&[0.3, 0.4, straight, 0.5, 0.6, 0.7]);
    let one = Branch::NONE.with_shoulder(Shoulder::Left).with_wrist(Wrist::NoFlip);
    let sides = [Elbow::Up, Elbow::Down].map(|elbow| Puma560.inverse_branch(&target, one.with_elbow(elbow)));
    let [Ok(up), Ok(down)] = sides else { panic!("{sides:?}") };
    assert_eq!(up.q, down.q);
    assert!(up.flags.contains(Flags::BOUNDARY | Flags::EXACT) && down.flags == up.flags);
    assert_eq!((up.branch, down.branch), (one.with_elbow(Elbow::Up), one.with_elbow(Elbow::Down)));
}

#[test]
fn parts_that_are_not_named_may_be_any() {
    let target = Ur5.forward(&[0.3, -1.2, 1.4, 0.5, 0.6, 0.7]);
    let solutions = Ur5.inverse(&target);
    assert_eq!(Ur5.inverse_branch(&target, Branch::NONE).ok(), solutions.first().copied());
    let down = Ur5.inverse_branch(&target, Branch::NONE.with_elbow(Elbow::Down).with_root(3));
    assert_eq!(down.ok(), solutions.iter().find(|s| s.branch.elbow() == Some(Elbow::Down)).copied());
}

#[test]
fn no_solution_says_why() {
    let mut target = Ur5.forward(&[0.3, -1.2, 1.4, 0.5, 0.6, 0.7]);
    target.translation[0] += 5.0;
    let far = Ur5.inverse_branch(&target, Branch::NONE.with_elbow(Elbow::Up));
    assert!(matches!(far, Err(Status::Unreachable { residual }) if residual > 3.0 && residual < 6.0), "{far:?}");
    target.translation[0] = f64::NAN;
    assert_eq!(Ur5.inverse_branch(&target, Branch::NONE), Err(Status::BadTarget));
}

/// A UR5 with its limits.
#[derive(denhart::Arm)]
#[arm(yaml = "
name: ur5
convention: standard
units: {length: m, angle: deg}
inverse: {weights: {q1: 100}}
joints:
  - {a: 0, alpha: 90, d: 0.089159, theta: 0, limits: [-360, 360]}
  - {a: -0.425, alpha: 0, d: 0, theta: 0, limits: [-360, 360]}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0, limits: [-360, 360]}
")]
struct Limited;

#[test]
fn a_solution_on_every_turn() {
    let target = Limited.forward(&[0.3, -1.2, 1.4, 0.5, 0.6, 0.7]);
    let solutions = Limited.inverse(&target);
    let solution = solutions.nearest().expect("reachable");
    // Limits of a whole turn either way leave every joint two turns.
    let windings: Vec<_> = solution.windings(&Limited).collect();
    assert_eq!((windings.len(), windings[0]), (64, solution.q));
    let inside = |q: &[f64; 6]| q.iter().zip(Limited::LIMITS).all(|(q, [low, high])| (low..=high).contains(q));
    assert!(windings.iter().all(inside));
    let reached = |q: &[f64; 6]| target.residual(&Limited.forward(q)).position < 1e-14;
    assert!(windings.iter().all(reached));
    // The turn next to a reference; across a limit the nearest turn inside; outside the reference is followed.
    let mut wound = solution.q;
    wound[3] += if wound[3] > 0.0 { -TAU } else { TAU };
    let near = Limited.inverse_near(&target, &wound);
    let found = near.nearest().expect("reachable").q;
    assert!((found[3] - wound[3]).abs() < 1e-14 && (solution.next_to(&Limited, &wound).q[3] - wound[3]).abs() < 1e-14);
    let end = std::array::from_fn(|joint| if solution.q[joint] < 0.0 { -TAU } else { TAU });
    let near = Limited.inverse_near(&target, &end);
    assert!(near.iter().all(Solution::is_within_limits) && solution.next_to(&Limited, &end).is_within_limits());
    wound[3] *= 3.0;
    let outside = solution.next_to(&Limited, &wound);
    assert!((outside.q[3] - wound[3]).abs() <= std::f64::consts::PI && !outside.is_within_limits());
}

#[test]
fn weights_choose_the_nearest() {
    let q = [0.3, -1.2, 1.4, 0.5, 0.6, 0.7];
    let target = Limited.forward(&q);
    // Far in every joint but the first.
    let reference = [q[0], q[1] + 3.0, q[2] - 3.0, q[3] + 2.0, q[4] - 1.0, q[5] + 3.0];
    let distance = |q: &[f64; 6], first: f64| -> f64 {
        (0..6).map(|j| (q[j] - reference[j]).powi(2) * if j == 0 { first } else { 1.0 }).sum()
    };
    let weighed = Limited.inverse_near(&target, &reference);
    assert!(weighed.is_sorted_by(|a, b| distance(&a.q, 100.0) <= distance(&b.q, 100.0)));
    assert!(
        !weighed.is_sorted_by(|a, b| distance(&a.q, 1.0) <= distance(&b.q, 1.0)),
        "the weights change nothing here"
    );
}
