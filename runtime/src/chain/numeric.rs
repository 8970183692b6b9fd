//! Numeric inverse kinematics of a chain.

use std::vec::Vec;

use nalgebra::{Isometry3, Matrix6xX};

use super::{Chain, ChainError};
use crate::dh::JointKind;
use crate::numeric::{Model, NumericInverse, NumericSolution, run};
use crate::pose::Pose;

impl NumericInverse<f64> {
    /// A joint vector that brings the tool of `chain` to `target`, from `start` (rad or length unit).
    ///
    /// As [`solve`](Self::solve), for any number of joints. `limits`: lowest and highest value of every joint, infinite
    /// where there is none; `None` for an arm without limits.
    ///
    /// # Errors
    /// If the length of `start` or `limits` is not the number of joints.
    ///
    /// ```
    /// use denhart::numeric::NumericInverse;
    /// use denhart::{Chain, Convention, DhRow};
    ///
    /// let rows = [DhRow::revolute(0.5, 0.0, 0.2, 0.0), DhRow::revolute(0.3, 0.0, 0.0, 0.0)];
    /// let arm = Chain::new(Convention::Standard, &rows);
    /// let target = arm.forward(&[0.4, 0.9])?;
    /// let solution = NumericInverse::new().restarts(5).solve_chain(&arm, &target, &[0.0, 0.1], None)?;
    /// assert!(solution.converged() && (solution.q[1] - 0.9).abs() < 1e-8);
    /// # Ok::<(), denhart::ChainError>(())
    /// ```
    pub fn solve_chain(
        &self,
        chain: &Chain,
        target: &Isometry3<f64>,
        start: &[f64],
        limits: Option<&[[f64; 2]]>,
    ) -> Result<NumericSolution<f64, Vec<f64>>, ChainError> {
        let model = Tabled::new(chain, start, limits)?;
        Ok(run(self, &model, &Pose::from(*target), &start.to_vec(), None))
    }

    /// As [`solve_chain`](Self::solve_chain), and as near to `posture` as the target leaves free, see
    /// [`solve_towards`](Self::solve_towards).
    ///
    /// # Errors
    /// If the length of `start`, `posture` or `limits` is not the number of joints.
    pub fn solve_chain_towards(
        &self,
        chain: &Chain,
        target: &Isometry3<f64>,
        start: &[f64],
        posture: &[f64],
        limits: Option<&[[f64; 2]]>,
    ) -> Result<NumericSolution<f64, Vec<f64>>, ChainError> {
        let model = Tabled::new(chain, start, limits)?;
        model.chain.check_count(posture.len())?;
        Ok(run(self, &model, &Pose::from(*target), &start.to_vec(), Some(&posture.to_vec())))
    }
}

impl Chain {
    fn check_count(&self, found: usize) -> Result<(), ChainError> {
        let expected = self.dof();
        if found == expected { Ok(()) } else { Err(ChainError::JointCount { expected, found }) }
    }
}

/// A chain as the iteration sees it.
struct Tabled<'a> {
    chain: &'a Chain,
    kinds: Vec<JointKind>,
    limits: Option<&'a [[f64; 2]]>,
}

impl<'a> Tabled<'a> {
    fn new(chain: &'a Chain, start: &[f64], limits: Option<&'a [[f64; 2]]>) -> Result<Self, ChainError> {
        chain.check_count(start.len())?;
        chain.check_count(limits.map_or(start.len(), <[_]>::len))?;
        Ok(Self { chain, kinds: chain.kinds(), limits })
    }
}

impl Model<f64> for Tabled<'_> {
    type Joints = Vec<f64>;
    type Evaluation = (Pose<f64>, [Vec<f64>; 6]);

    fn evaluate(&self, q: &Vec<f64>) -> Self::Evaluation {
        // The iteration keeps the length of `start`, which was checked.
        let not_finite = Pose { rotation: [[f64::NAN; 3]; 3], translation: [f64::NAN; 3] };
        let pose = self.chain.forward(q).map_or(not_finite, Pose::from);
        let jacobian = self.chain.jacobian(q).unwrap_or_else(|_| Matrix6xX::zeros(q.len()));
        let mut rows: [Vec<f64>; 6] = core::array::from_fn(|_| Vec::with_capacity(q.len()));
        for column in jacobian.column_iter() {
            for (row, entry) in rows.iter_mut().zip(column.iter()) {
                row.push(*entry);
            }
        }
        (pose, rows)
    }

    fn parts((pose, rows): &mut Self::Evaluation) -> (&Pose<f64>, &mut [Vec<f64>; 6]) {
        (pose, rows)
    }

    fn limits(&self, joint: usize) -> [f64; 2] {
        let limits = self.limits.and_then(|limits| limits.get(joint));
        limits.copied().unwrap_or([f64::NEG_INFINITY, f64::INFINITY])
    }

    fn is_prismatic(&self, joint: usize) -> bool {
        self.kinds.get(joint) == Some(&JointKind::Prismatic)
    }

    fn visit_origins(&self, q: &Vec<f64>, mut visit: impl FnMut([f64; 3])) {
        if let Ok((links, tool)) = self.chain.links(q) {
            for frame in links.iter().chain([&tool]) {
                visit(frame.translation.vector.into());
            }
        }
    }
}
