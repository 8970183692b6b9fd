//! Results as bits, so that equal means equal.

use denhart::{Branch, Flags, Jacobian, JointMask, Pose, Residual, Solution, Status};
use denhart_dynamic::{DynamicJacobian, DynamicSolution, DynamicSolutions};

use crate::inverse;

/// A solution: joint values, flags, free joints, branch, residual.
pub type Bits = (Vec<u64>, Flags, JointMask, Branch, [u64; 2]);

/// All solutions and the status.
#[derive(Debug, PartialEq, Eq)]
pub struct Answer {
    pub solutions: Vec<Bits>,
    pub status: (u8, u64),
}

pub fn residual(residual: &Residual<f64>) -> [u64; 2] {
    [residual.position, residual.orientation].map(number)
}

/// Every value that is not a number is the same.
pub fn number(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

pub fn numbers(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
    values.into_iter().map(number).collect()
}

pub fn status(status: Status<f64>) -> (u8, u64) {
    match status {
        Status::Reachable => (0, 0),
        Status::Unreachable { residual } => (1, number(residual)),
        Status::BadTarget => (2, 0),
    }
}

pub fn pose(pose: &Pose<f64>) -> Vec<u64> {
    numbers(pose.rotation.into_iter().flatten().chain(pose.translation))
}

pub fn poses(poses: &[Pose<f64>]) -> Vec<u64> {
    poses.iter().flat_map(pose).collect()
}

pub fn jacobian<const N: usize>(jacobian: &Jacobian<f64, N>) -> Vec<u64> {
    numbers(jacobian.rows.into_iter().flatten())
}

pub fn rows(jacobian: &DynamicJacobian) -> Vec<u64> {
    numbers(jacobian.iter().flat_map(|row| row.to_vec()))
}

pub fn solution<const N: usize>(solution: &Solution<f64, N>) -> Bits {
    let Solution { q, flags, free, branch, residual: missed } = solution;
    (numbers(*q), *flags, *free, *branch, residual(missed))
}

pub fn evaluated(solution: &DynamicSolution) -> Bits {
    let DynamicSolution { q, flags, free, branch, residual: missed } = solution;
    (numbers(q.to_vec()), *flags, *free, *branch, residual(missed))
}

pub fn answer<const N: usize>(answer: &inverse::Answer<N>) -> Answer {
    Answer { solutions: answer.solutions.iter().map(solution).collect(), status: status(answer.status) }
}

pub fn listed(solutions: &DynamicSolutions) -> Answer {
    Answer { solutions: solutions.iter().map(evaluated).collect(), status: status(solutions.status()) }
}
