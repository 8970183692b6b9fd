//! Closed form and iteration agree to 1e-9 rad.

use std::f64::consts::PI;

use denhart::numeric::{NumericInverse, Task};
use denhart::{Arm, Pose};
use denhart_tests::random::Random;
use nalgebra::{DMatrix, Vector3};

use crate::tables::apart;

/// The pose is off by up to 1e-12 of the length both ways. A joint is off by that error over the least singular value:
/// by up to 6e-10 where that value is at least this.
const LEAST: f64 = 5e-3;

/// The Jacobian of what the task counts, lengths over `length`.
fn counted<A: Arm<f64, N>, const N: usize>(arm: &A, task: &Task<f64>, length: f64, q: &[f64; N]) -> DMatrix<f64> {
    let (pose, jacobian) = arm.forward_and_jacobian(q);
    let mut all = DMatrix::from_row_iterator(6, N, jacobian.rows.into_iter().flatten());
    all.rows_mut(0, 3).scale_mut(1.0 / length);
    match task {
        Task::Pose => all,
        Task::Components(asked) => all.select_rows((0..6).filter(|row| asked[*row]).collect::<Vec<_>>().iter()),
        // A direction turns by the cross product of the angular velocity with it.
        Task::PositionAxis(axis) => {
            let here = Vector3::from(Pose { translation: [0.0; 3], ..pose }.transform_point(axis));
            for mut column in all.column_iter_mut() {
                let turned = Vector3::new(column[3], column[4], column[5]).cross(&here);
                column.rows_mut(3, 3).copy_from(&turned);
            }
            all
        }
    }
}

/// An arm whose closed form answers `task`, and what its lengths are weighed with.
pub struct Both<A> {
    pub arm: A,
    pub task: Task<f64>,
    pub length: f64,
}

impl<A> Both<A> {
    /// Holds the iteration beside `closed`. Given a joint vector, `closed` gives all joint vectors at which the tool
    /// does the same, in what the task counts.
    ///
    /// From a start near a solution the iteration ends on it; from anywhere it ends on one of them.
    pub fn agree<const N: usize>(&self, name: &str, closed: impl Fn(&A, &[f64; N]) -> Vec<[f64; N]>)
    where
        A: Arm<f64, N>,
    {
        let Self { arm, task, length } = self;
        let solver = NumericInverse::new().task(*task).length(*length).tolerance(1e-12 * length, 1e-12);
        let least = |q: &[f64; N]| counted(arm, task, *length, q).singular_values().min();
        let mut random = Random::named(name);
        let (mut near, mut anywhere) = (0, 0);
        for _ in 0..100 {
            let mut draw = || -> [f64; N] {
                std::array::from_fn(|joint| {
                    let [low, high] = A::LIMITS[joint];
                    random.uniform(low.max(-PI), high.min(PI))
                })
            };
            let (goal, start) = (draw(), draw());
            let target = arm.forward(&goal);
            let solutions = closed(arm, &goal);
            assert!(solutions.iter().any(|q| least(&goal) < LEAST || apart(q, &goal) < 1e-9), "{name}: {goal:?}");
            for q in solutions.iter().filter(|q| least(q) >= LEAST) {
                // The second-order error of a step is then below a tenth of it: no other branch is nearer.
                let start = q.map(|q| q + 0.1 * LEAST * random.uniform(-1.0, 1.0));
                let numeric = solver.within_limits(false).solve(arm, &target, &start);
                assert!(numeric.converged() && apart(&numeric.q, q) < 1e-9, "{name}: {numeric:?} for {q:?}");
                near += 1;
            }
            let numeric = solver.restarts(100).solve(arm, &target, &start);
            assert!(numeric.converged(), "{name}: {numeric} at {goal:?}");
            if least(&numeric.q) >= LEAST {
                let found = solutions.iter().any(|q| apart(&numeric.q, q) < 1e-9);
                assert!(found, "{name}: {:?} is none of {solutions:?}", numeric.q);
                anywhere += 1;
            }
        }
        assert!(near >= 100 && anywhere >= 90, "{name}: {near}, {anywhere}");
    }
}
