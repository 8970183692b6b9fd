//! Joint vectors and targets, and what Rust says to them.

use std::fmt::Write;

use denhart::{Branch, InverseBranch, InverseKinematics, JointKind, Solutions};
use denhart_tests::random::Random;

use crate::bits::{Real, parts, pose, shown, solution, solutions, status};

/// Cases of an arm.
const CASES: usize = 120;

/// Functions of an arm with targets `G` of `W` numbers.
pub struct Task<A, T, G, const N: usize, const W: usize> {
    pub arm: A,
    /// The numbers of a target.
    pub words: fn(&G) -> [T; W],
    /// The target of its numbers and the given value.
    pub target: fn([T; W], T) -> G,
    /// The given value at joint values.
    pub given: fn(&A, &[T; N]) -> T,
    /// Motors and the arm angle.
    pub extra: fn(&A, &[T; N]) -> String,
}

/// Input of the C program, and what Rust says to it.
pub fn cases<A, T, const N: usize, const M: usize, const W: usize>(task: &Task<A, T, A::Target, N, W>) -> [String; 2]
where
    A: InverseBranch<T, N> + InverseKinematics<T, N, Solutions = Solutions<T, N, M>>,
    T: Real,
{
    let Task { arm, .. } = task;
    let mut random = Random::new(7);
    let (mut input, mut expected) = (String::new(), String::new());
    let mut reachable = 0;
    for number in 0..CASES {
        let mut q = [T::ZERO; N];
        for ((q, [low, high]), kind) in q.iter_mut().zip(A::LIMITS).zip(A::JOINT_KINDS) {
            let low = if low.is_finite() { low } else { -T::PI };
            let high = if high.is_finite() { high } else { T::PI };
            *q = low + (high - low) * T::from_f64(random.uniform(0.0, 1.0));
            if number % 4 == 1 && kind == JointKind::Revolute {
                *q = (*q / T::FRAC_PI_2).round_ties_even() * T::FRAC_PI_2;
            }
        }
        let at = arm.target_at(&q);
        let missed = arm.residual(&q, &at);
        // The rounding of a sum of joint angles of a few turns.
        let rounding = T::EPSILON * T::from_f64(32.0);
        assert!(missed.position == T::ZERO && missed.orientation < rounding, "{missed:?} at {q:?}");
        let reached = (task.words)(&at);
        let mut words = reached;
        let mut q_ref = q.map(|x| x + T::from_f64(random.uniform(-0.5, 0.5)));
        let given = (task.given)(arm, &q);
        match number % 12 {
            2 => words = words.map(|x| x * T::from_f64(3.0)),
            6 => words[random.below(W)] = T::NAN,
            10 => q_ref[random.below(N)] = T::INFINITY,
            _ => {}
        }
        let target = (task.target)(words, given);
        let found = arm.inverse(&target);
        let some = found.get(random.below(8).min(found.len().saturating_sub(1))).or(found.first());
        let mut branch = some.map_or(Branch::NONE, |solution| solution.branch);
        if number % 5 == 0 {
            branch = Branch::NONE;
        }
        reachable += usize::from(found.status().is_reachable());
        let [shoulder, elbow, wrist, root] = parts(branch);
        let bits = |numbers: &[T]| numbers.iter().map(|x| format!("{:x} ", x.bits())).collect::<String>();
        let numbers = [bits(&q), bits(&words), bits(&[given]), bits(&q_ref)].concat();
        writeln!(input, "{numbers}{shoulder} {elbow} {wrist} {root}").unwrap();

        let (tool, jacobian) = arm.forward_and_jacobian(&q);
        let columns = shown(jacobian.rows.iter().flatten());
        let alone = shown(arm.jacobian(&q).rows.iter().flatten());
        write!(expected, "0{} | 0{alone} | 0{}{columns}", pose(&arm.forward(&q)), pose(&tool)).unwrap();
        expected += &solutions(&found);
        expected += &solutions(&arm.inverse_near(&target, &q_ref));
        let nothing = format!("{} 0 0 0 0 0 0", shown(&vec![T::ZERO; N + 2]));
        let (one, (code, gap)) = match arm.inverse_branch(&target, branch) {
            Ok(one) => (solution(&one), (0, T::ZERO)),
            Err(outcome) => (nothing, status(outcome)),
        };
        write!(expected, " | {code}{}{one} | 0{}", shown(&[gap]), shown(&reached)).unwrap();
        writeln!(expected, "{}", (task.extra)(arm, &q)).unwrap();
    }
    // Else the comparison would be one of empty lists.
    assert!(reachable > CASES / 2, "{reachable} targets are reached");
    [input, expected]
}
