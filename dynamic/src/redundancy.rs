//! The solutions of one target at many values of what the inverse takes beside it.

use std::f64::consts::PI;

use denhart::solve::steps;
use denhart_codegen::lower::Given;

use crate::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};

/// The steps of one value.
#[derive(Debug, Clone, Copy)]
struct Steps {
    low: f64,
    high: f64,
    /// Stands for an end that is infinite.
    whole: f64,
    n: usize,
}

impl Steps {
    /// The middle of a step.
    fn value(&self, k: usize) -> f64 {
        steps(self.low, self.high, self.whole, self.n).nth(k).unwrap_or(0.0)
    }
}

impl DynamicArm {
    /// Walks the values that the inverse takes beside the target through a grid, and solves for each of its points: the values,
    /// in the order of [`given`](Self::given), and their solutions.
    ///
    /// Each value goes through the limits of its joint in as many equal steps as `n` says, and is the middle of its step; the
    /// last value goes fastest. Without limits a turn takes a whole turn, a displacement minus to plus the reach; the arm angle
    /// takes a whole turn. At most `i32::MAX` steps count.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse); another number of step counts than the inverse takes values.
    pub fn sample_redundancy(
        &self,
        target: &DynamicTarget,
        n: &[usize],
    ) -> Result<impl Iterator<Item = (Vec<f64>, DynamicSolutions)>, DynamicError> {
        self.solver(target)?;
        let program = self.inverse_program()?;
        if program.given.values.len() != n.len() {
            return Err(DynamicError::Given { expected: self.given()?, found: n.len() });
        }
        let steps = |(given, n): (&Given, &usize)| {
            let ([low, high], whole) = match *given {
                Given::ArmAngle => ([-PI, PI], PI),
                Given::Joint { joint, revolute } => {
                    let limits = self.limits().get(joint).copied().unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                    (limits, if revolute { PI } else { program.constants.reach })
                }
            };
            Steps { low, high, whole, n: (*n).min(i32::MAX as usize) }
        };
        let grid: Vec<Steps> = program.given.values.iter().zip(n).map(steps).collect();
        let points = grid.iter().fold(1, |product: usize, steps| product.saturating_mul(steps.n));
        let target = *target;
        Ok((0..points).filter_map(move |mut point| {
            let mut values = vec![0.0; grid.len()];
            for (value, steps) in values.iter_mut().zip(&grid).rev() {
                *value = steps.value(point.checked_rem(steps.n).unwrap_or(0));
                point = point.checked_div(steps.n).unwrap_or(0);
            }
            let solutions = self.inverse(&target, &values).ok()?;
            Some((values, solutions))
        }))
    }
}
