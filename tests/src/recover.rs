//! The rule that every reachable pose has to pass: the joint vector it was made from comes back.

use std::f64::consts::{PI, TAU};

use denhart::{Flags, JointKind, Solution};

use crate::random::Random;
use crate::report::Report;
use crate::singular::{self, Svd};
use crate::subject::{Answer, Subject, wrap};
use crate::task::Goal;

/// A solution flagged EXACT reaches its target within this, in reaches and in rad. The bound is some thousand
/// roundings, so that it holds after any chain of six joints. The bound is far below every tolerance that lets an
/// inexact solution pass.
pub const CLOSES: f64 = 1e-12;

/// Joint vectors closer than this, in rad and in reaches, are the same.
pub const SAME: f64 = 1e-6;

/// The least singular value from which on an inverse that holds a joint lists every solution.
const HELD_JOINT_REGULAR: f64 = 1e-6;

/// Which function an answer came from.
#[derive(Debug, Clone, Copy)]
pub enum Form<'a, const N: usize> {
    /// `inverse`: angles in `(-pi, pi]`.
    Principal,
    /// `inverse_near` with this reference: angles next to it inside the limits, nearest solution first.
    Near(&'a [f64; N]),
}

/// Checks the pose of `q`: both inverse functions give `q` back by the rule of its distance from singularity.
///
/// With `s` the least singular value of the Jacobian scaled by reach:
/// - `s >= 1e-9`: an EXACT solution equals `q` within `max(1e-6, 1e-14 / s)`, as one rounding of the pose moves the
///   joints by up to `1e-16 / s`;
/// - below, at one rank less than the arm has joints: an EXACT solution equals `q` in every joint that no null space
///   moves. The null spaces are those along the self-motion through `q` and at the solution;
/// - below, at a lower rank: whatever is EXACT closes, and something is;
/// - where two singular values are below the root of rounding, a solution with free joints counts as all of its family;
/// - always: `inverse_near` with reference `q` contains `q` within 1e-6.
///
/// An inverse that holds a joint knows a fourfold root to the fourth root of rounding, and lists some of the solutions that
/// meet there. For `s < 1e-6` it has to list an EXACT solution, which may be missing at one pose in 500.
pub fn check<const N: usize>(subject: &Subject<N>, report: &mut Report, family: &'static str, q: &[f64; N]) {
    report.count(q);
    let target = subject.goal(q);
    let answer = subject.inverse(&target);
    examine(subject, report, family, &target, &answer, Form::Principal);
    let is_singular = subject.task.holds_a_joint && Svd::at(subject, q).least() < HELD_JOINT_REGULAR;
    if !answer.status.is_reachable() && is_singular {
        report.rarely(family, "a singular pose has no solution", || describe(subject, &target, q, &answer));
    } else if !answer.status.is_reachable() {
        report.fail(family, "a pose made from joints is not Reachable", || describe(subject, &target, q, &answer));
    } else if !is_singular && !recovered(subject, q, &answer) && !stood_for(subject, &target, q, &answer) {
        report.fail(family, "inverse lost the joints", || describe(subject, &target, q, &answer));
    }

    check_near(subject, report, family, q, q);
}

/// Checks that `inverse_near` of the pose of `q` contains `q_ref`, which is `q` up to whole turns.
fn check_near<const N: usize>(
    subject: &Subject<N>,
    report: &mut Report,
    family: &'static str,
    q: &[f64; N],
    q_ref: &[f64; N],
) {
    let target = subject.goal(q);
    let near = subject.inverse_near(&target, q_ref);
    examine(subject, report, family, &target, &near, Form::Near(q_ref));
    if !near.exact().any(|solution| subject.distance_with_turns(&solution.q, q_ref) <= SAME) {
        report.fail(family, "inverse_near lost the reference", || describe(subject, &target, q_ref, &near));
    }
}

/// Checks `inverse_near` with references that are whole turns away from `q`, and with one a little beside `q`. Away
/// from singularities `q` is then the nearest solution.
pub fn check_references<const N: usize>(
    subject: &Subject<N>,
    report: &mut Report,
    family: &'static str,
    q: &[f64; N],
    random: &mut Random,
) {
    let turns = |joint: usize, turns: usize| match subject.kinds[joint] {
        JointKind::Revolute => TAU * (turns as f64 - 2.0),
        _ => 0.0,
    };
    let wound = std::array::from_fn(|joint| q[joint] + turns(joint, random.below(5)));
    check_near(subject, report, family, q, &wound);

    if Svd::at(subject, q).least() > 1e-2 {
        let mut beside = std::array::from_fn(|joint| q[joint] + 1e-4 * subject.unit(joint) * random.uniform(-1.0, 1.0));
        for given in subject.task.given.iter() {
            beside[given] = q[given];
        }
        let target = subject.goal(q);
        let near = subject.inverse_near(&target, &beside);
        examine(subject, report, family, &target, &near, Form::Near(&beside));
        // Beside a limit `q` may have been taken to another turn, and is no longer the nearest.
        let keeps_turn = |joint: usize| {
            subject.kinds[joint] != JointKind::Revolute || next_to(q[joint], beside[joint], subject.limits[joint])
        };
        if (0..N).all(keeps_turn)
            && !near.solutions.first().is_some_and(|first| subject.distance_with_turns(&first.q, q) <= SAME)
        {
            report.fail(family, "the nearest solution is not first", || describe(subject, &target, &beside, &near));
        }
    }
}

/// Returns true if an EXACT solution equals `q` as far as the pose determines it, see [`check`].
fn recovered<const N: usize>(subject: &Subject<N>, q: &[f64; N], answer: &Answer<N>) -> bool {
    let found = |tolerance: f64, counts: &dyn Fn(usize) -> bool| {
        answer.exact().any(|solution| subject.distance(&solution.q, q, counts) <= tolerance)
    };
    if found(SAME, &|_| true) {
        return true;
    }
    let svd = Svd::at(subject, q);
    // The same sensitivity as above, of the joints that the pose does determine.
    let tolerance = SAME.max(1e-14 / svd.least_nonzero());
    if svd.rank() == N {
        return found(tolerance, &|_| true);
    }
    if svd.rank() + 1 < N {
        return answer.exact().next().is_some();
    }
    // A free joint that takes another value may lead to a pose that is singular in one more way. An example is a wrist
    // that comes out straight. The joints that move at that pose count as moved too.
    let moved_at: Vec<[bool; N]> = answer.exact().map(|solution| Svd::at(subject, &solution.q).moved()).collect();
    singular::accepts_moved(subject, q, &svd, |moved| {
        answer.exact().zip(&moved_at).any(|(solution, also)| {
            subject.distance(&solution.q, q, |joint| !moved[joint] && !also[joint]) <= tolerance
        })
    })
}

/// Returns true if a solution whose joints are partly free stands for `q`. The arm is asked for the solutions next to
/// this solution, with the free joints where `q` has them. The answer must give `q`. All other joints of that reference
/// are those of the solution, so that nothing but the free joints comes from `q`.
///
/// The rule applies only where two singular values are below the root of rounding. There a fold (a stretched elbow) is
/// not resolved: a distance of `q` from the fold changes the pose by its square, which is rounding. So the pose
/// determines that joint, and with it the Jacobian, only to the root of rounding. Singular values below that root may
/// as well be zero. With two of them the rank is so low that the rule above would ask for closure alone; this rule asks
/// for more.
fn stood_for<const N: usize>(subject: &Subject<N>, target: &Goal, q: &[f64; N], answer: &Answer<N>) -> bool {
    Svd::at(subject, q).below(f64::EPSILON.sqrt()) >= 2
        && answer.exact().filter(|solution| !solution.free.is_empty()).any(|solution| {
            let free = |joint: usize| solution.free.contains(joint);
            let member = std::array::from_fn(|joint| if free(joint) { q[joint] } else { solution.q[joint] });
            let near = subject.inverse_near(target, &member);
            recovered(subject, q, &near)
        })
}

/// Checks what holds for every answer, whether its target can be reached or not. Solutions are finite, distinct, in
/// range and in order, and every flag says the truth.
pub fn examine<const N: usize>(
    subject: &Subject<N>,
    report: &mut Report,
    family: &'static str,
    target: &Goal,
    answer: &Answer<N>,
    form: Form<'_, N>,
) {
    let mut fail = |rule: &'static str, q: &[f64; N]| {
        report.fail(family, rule, || describe(subject, target, q, answer));
    };
    if answer.solutions.len() > subject.max_solutions {
        fail("more than MAX_SOLUTIONS", &[f64::NAN; N]);
    }
    for (index, solution) in answer.solutions.iter().enumerate() {
        if let Some(rule) = broken_rule(subject, target, solution, form) {
            fail(rule, &solution.q);
        }
        let equal = |other: &Solution<f64, N>| subject.distance(&solution.q, &other.q, |_| true) < 1e-9;
        if answer.solutions[..index].iter().any(equal) {
            fail("two solutions are equal", &solution.q);
        }
        let regular = |s: &Solution<f64, N>| s.flags == Flags::EXACT || s.flags == Flags::EXACT | Flags::OUT_OF_LIMITS;
        let named = |other: &Solution<f64, N>| regular(other) && other.branch == solution.branch;
        let principal = matches!(form, Form::Principal);
        if principal && regular(solution) && answer.solutions[..index].iter().any(named) {
            fail("two regular solutions have one name", &solution.q);
        }
    }
    if answer.status.is_reachable() != answer.exact().next().is_some() {
        fail("status and EXACT disagree", &[f64::NAN; N]);
    }
    if let denhart::Status::Unreachable { residual } = answer.status
        && !(residual > 0.0 && residual.is_finite())
    {
        fail("the residual of Unreachable is not positive", &[f64::NAN; N]);
    }
    if let Form::Near(q_ref) = form
        && !in_order(subject, q_ref, &answer.solutions)
    {
        fail("inverse_near is not sorted", q_ref);
    }
}

/// The first rule that a solution breaks by itself.
fn broken_rule<const N: usize>(
    subject: &Subject<N>,
    target: &Goal,
    solution: &Solution<f64, N>,
    form: Form<'_, N>,
) -> Option<&'static str> {
    let Solution { q, flags, free, residual, .. } = solution;
    let is = |flag: Flags| flags.contains(flag);
    let revolute = |joint: usize| subject.kinds[joint] == JointKind::Revolute;
    if !(q.iter().all(|x| x.is_finite()) && residual.position >= 0.0 && residual.orientation >= 0.0) {
        return Some("a value is not finite");
    }
    if !(residual.position.is_finite() && residual.orientation.is_finite()) {
        return Some("a residual is not finite");
    }
    let in_range = |joint: usize| match form {
        _ if !revolute(joint) => true,
        Form::Principal => -PI < q[joint] && q[joint] <= PI,
        Form::Near(q_ref) => next_to(q[joint], q_ref[joint], subject.limits[joint]),
    };
    if !(0..N).all(in_range) {
        return Some(match form {
            Form::Principal => "an angle is not in (-pi, pi]",
            Form::Near(_) => "an angle is not on the turn next to the reference",
        });
    }
    if is(Flags::EXACT) == is(Flags::APPROXIMATE) {
        return Some("neither EXACT nor APPROXIMATE, or both");
    }
    if is(Flags::EXACT) && !subject.miss(target, q).iter().all(|miss| *miss < CLOSES * subject.extension(q)) {
        return Some("EXACT but does not close");
    }
    if is(Flags::FREE) == free.is_empty() || free.iter().any(|joint| joint >= N) {
        return Some("FREE and its mask disagree");
    }
    if free.iter().any(|joint| subject.task.given.contains(joint)) {
        return Some("the joint that is given is called free");
    }
    // Within rounding of a limit either answer will do.
    let beyond = |margin: f64| {
        (0..N).any(|joint| {
            let [low, high] = subject.limits[joint];
            q[joint] < low - margin * subject.unit(joint) || q[joint] > high + margin * subject.unit(joint)
        })
    };
    if (beyond(1e-9) && !is(Flags::OUT_OF_LIMITS)) || (!beyond(-1e-9) && is(Flags::OUT_OF_LIMITS)) {
        return Some("OUT_OF_LIMITS is wrong");
    }
    None
}

/// A reference that is farther outside a limit than this is followed. `inverse_near` follows a reference beyond
/// 7.5e-10, which is 0.05 times the root of rounding. Joint vectors lie powers of ten beside a limit, so that none is
/// between the two.
const FOLLOWED: f64 = 8e-10;

/// Returns true if an angle is on the turn that `inverse_near` has to choose. Of the turns inside the limits, the right
/// turn is the nearest to the reference. If none is inside, or the reference is not, the right turn is within half a
/// turn of the reference. Within rounding of a limit either will do.
fn next_to(angle: f64, reference: f64, [low, high]: [f64; 2]) -> bool {
    let distance = (angle - reference).abs();
    let near = reference + wrap(angle - reference);
    let inside = |angle: f64, margin: f64| angle >= low - margin && angle <= high + margin;
    if inside(near, -1e-9) || !inside(reference, FOLLOWED) || distance <= PI + 1e-9 && inside(near, 1e-9) {
        return distance <= PI + 1e-9;
    }
    let windings = (-12..=12).map(|turns| wrap(angle) + TAU * f64::from(turns));
    let best = windings.filter(|winding| inside(*winding, -1e-9)).map(|winding| (winding - reference).abs());
    match best.min_by(f64::total_cmp) {
        Some(best) => inside(angle, 1e-9) && distance <= best + 1e-9,
        None => distance <= PI + 1e-9 || inside(angle, 1e-9),
    }
}

/// Returns true if the solutions are sorted by their Euclidean distance from the reference. The arm may count a
/// prismatic joint in its own unit or in reaches.
fn in_order<const N: usize>(subject: &Subject<N>, q_ref: &[f64; N], solutions: &[Solution<f64, N>]) -> bool {
    let sorted = |unit: f64| {
        let distance = |solution: &Solution<f64, N>| -> f64 {
            let scale = |joint: usize| if subject.kinds[joint] == JointKind::Revolute { 1.0 } else { unit };
            (0..N).map(|joint| ((solution.q[joint] - q_ref[joint]) / scale(joint)).powi(2)).sum()
        };
        solutions.is_sorted_by(|a, b| distance(a) <= distance(b) * (1.0 + 1e-9) + 1e-12)
    };
    sorted(1.0) || (subject.has_prismatic() && sorted(subject.reach))
}

/// Everything needed to look into a failure: joints, singular values, and each solution with its distance from `q` and
/// from the target.
pub fn describe<const N: usize>(subject: &Subject<N>, target: &Goal, q: &[f64; N], answer: &Answer<N>) -> String {
    use std::fmt::Write;
    let mut text = format!("q = {q:?}");
    if q.iter().all(|x| x.is_finite()) {
        let values = Svd::at(subject, q).values.map(|value| format!("{value:.1e}"));
        let _ = write!(text, "\n      singular values {}", values.join(" "));
    }
    let _ = write!(text, "\n      {target:?}\n      {answer}");
    for (index, solution) in answer.solutions.iter().enumerate() {
        let [position, orientation] = subject.miss(target, &solution.q);
        let _ = write!(
            text,
            "\n      solution {index}: {:.1e} from q, misses by {position:.1e} of reach, {orientation:.1e} rad",
            subject.distance(&solution.q, q, |_| true),
        );
    }
    text
}
