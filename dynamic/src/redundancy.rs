//! The solutions of one target at many values of what the inverse takes beside it.

use std::f64::consts::PI;

use denhart::solve::steps;
use denhart_codegen::lower::Given;

use crate::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};

impl DynamicArm {
    /// Range of each value that the inverse takes beside the target, in the order of [`given`](Self::given), rad or length unit:
    /// the limits of its joint. Without limits a turn has a whole turn, a displacement minus to plus the reach; the arm angle
    /// has a whole turn.
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn given_ranges(&self) -> Result<Vec<[f64; 2]>, DynamicError> {
        let program = self.inverse_program()?;
        let range = |given: &Given| match *given {
            Given::ArmAngle => [-PI, PI],
            Given::Joint { joint, revolute } => {
                let whole = if revolute { PI } else { program.constants.reach };
                let [low, high] = self.limits().get(joint).copied().unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                [if low.is_finite() { low } else { -whole }, if high.is_finite() { high } else { whole }]
            }
        };
        Ok(program.given.values.iter().map(range).collect())
    }

    /// Walks the values that the inverse takes beside the target through a grid, and solves for each of its points: the values,
    /// in the order of [`given`](Self::given), and their solutions.
    ///
    /// Each value goes through its [range](Self::given_ranges) in as many equal steps as `n` says, and is the middle of its step;
    /// the last value goes fastest. At most `i32::MAX` steps count.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse); another number of step counts than the inverse takes values.
    pub fn sample_redundancy(
        &self,
        target: &DynamicTarget,
        n: &[usize],
    ) -> Result<impl Iterator<Item = (Vec<f64>, DynamicSolutions)>, DynamicError> {
        self.solver(target)?;
        let ranges = self.given_ranges()?;
        if ranges.len() != n.len() {
            return Err(DynamicError::Given { expected: self.given()?, found: n.len() });
        }
        let counts = n.iter().map(|n| (*n).min(i32::MAX as usize));
        let grid: Vec<([f64; 2], usize)> = ranges.into_iter().zip(counts).collect();
        let points = grid.iter().fold(1, |product: usize, (_, n)| product.saturating_mul(*n));
        let target = *target;
        Ok((0..points).filter_map(move |mut point| {
            let mut values = vec![0.0; grid.len()];
            for (value, ([low, high], n)) in values.iter_mut().zip(&grid).rev() {
                // Both ends are finite.
                let k = point.checked_rem(*n).unwrap_or(0);
                *value = steps(*low, *high, PI, *n).nth(k).unwrap_or(0.0);
                point = point.checked_div(*n).unwrap_or(0);
            }
            let solutions = self.inverse(&target, &values).ok()?;
            Some((values, solutions))
        }))
    }
}
