//! A small arm worked out by hand: what the iteration does at limits, at singular places and with bad input.

#![allow(clippy::unwrap_used)]

use super::*;
use crate::arm::Arm;
use crate::dh::JointKind;
use crate::jacobian::Jacobian;
use crate::pose::Pose;
use std::format;

/// Three links of length 1 in the plane, `q3` within +-2 rad, the others free.
struct Planar;

macro_rules! planar {
    ($float:ident) => {
        impl Arm<$float, 3> for Planar {
            const LIMITS: [[$float; 2]; 3] = {
                const FREE: [$float; 2] = [$float::NEG_INFINITY, $float::INFINITY];
                [FREE, FREE, [-2.0, 2.0]]
            };
            const JOINT_NAMES: [&'static str; 3] = ["q1", "q2", "q3"];
            const JOINT_KINDS: [JointKind; 3] = [JointKind::Revolute; 3];

            fn forward(&self, q: &[$float; 3]) -> Pose<$float> {
                self.forward_and_jacobian(q).0
            }
            fn link_poses(&self, q: &[$float; 3]) -> [Pose<$float>; 3] {
                let [one, two, three] = q.map(|q| {
                    let turn = Pose::from_xyz_rpy([0.0; 3], [0.0, 0.0, q]);
                    Pose { translation: turn.transform_point(&[1.0, 0.0, 0.0]), ..turn }
                });
                [one, one * two, one * two * three]
            }
            fn jacobian(&self, q: &[$float; 3]) -> Jacobian<$float, 3> {
                self.forward_and_jacobian(q).1
            }
            fn forward_and_jacobian(&self, q: &[$float; 3]) -> (Pose<$float>, Jacobian<$float, 3>) {
                let [one, two, tool] = self.link_poses(q);
                let [x, y, _] = tool.translation;
                let axes = [[0.0; 3], one.translation, two.translation];
                let rows = [axes.map(|[_, py, _]| py - y), axes.map(|[px, ..]| x - px), [0.0; 3], [0.0; 3], [0.0; 3]];
                let [vx, vy, vz, wx, wy] = rows;
                (tool, Jacobian { rows: [vx, vy, vz, wx, wy, [1.0; 3]] })
            }
        }
    };
}

planar!(f64);
planar!(f32);

const IN_PLANE: [bool; 6] = [true, true, false, false, false, false];

fn target(q: [f64; 3]) -> Pose<f64> {
    Planar.forward(&q)
}

#[test]
fn both_methods_converge_in_both_precisions() {
    let (start, goal) = ([0.5, 0.9, 0.2], [0.8, 0.7, -0.4]);
    for method in [Method::DampedLeastSquares, Method::NewtonRaphson] {
        let solution = NumericInverse::new().method(method).solve(&Planar, &target(goal), &start);
        assert!(solution.converged() && solution.iterations <= 10, "{solution}");
        for (value, expected) in solution.q.iter().zip(goal) {
            assert!((value - expected).abs() < 1e-8, "{solution:?}");
        }
        let (start, goal) = (start.map(|q| q as f32), goal.map(|q| q as f32));
        let solution = NumericInverse::new().method(method).solve(&Planar, &Planar.forward(&goal), &start);
        assert!(solution.converged() && solution.iterations <= 10, "{solution}");
        for (value, expected) in solution.q.iter().zip(goal) {
            assert!((value - expected).abs() < 1e-4, "{solution:?}");
        }
    }
}

#[test]
fn the_characteristic_length_is_the_way_along_the_links() {
    let length = model::characteristic_length::<f64, _>(&model::Generated::new(&Planar), &[0.3, 1.0, -2.0]);
    // From the origin of the first link, which is its far end, to the tool, which the last link ends at.
    assert!((length - 2.0).abs() < 1e-15, "{length}");
}

#[test]
fn a_start_the_jacobian_sees_nothing_from_is_left_by_a_restart() {
    // Stretched out towards a target on the line: no joint moves the tool nearer at first order.
    let goal = target([1.0, -2.0, 1.0]);
    for method in [Method::DampedLeastSquares, Method::NewtonRaphson] {
        let solver = NumericInverse::new().method(method).task(Task::POSITION);
        let [x, y, _] = goal.translation;
        let along = f64::atan2(y, x);
        let stuck = solver.solve(&Planar, &goal, &[along, 0.0, 0.0]);
        assert!(stuck.q.iter().all(|q| q.is_finite()), "{stuck:?}");
        let solution = solver.restarts(20).solve(&Planar, &goal, &[along, 0.0, 0.0]);
        assert!(solution.converged(), "{solution}");
        assert!(stuck.converged() || solution.restarts > 0);
    }
}

#[test]
fn out_of_reach_it_stretches_out_and_stops() {
    let mut far = target([0.7, 0.0, 0.0]);
    far.translation = far.translation.map(|x| x * 5.0 / 3.0);
    let solver = NumericInverse::new().task(Task::Components(IN_PLANE)).max_iterations(200);
    let solution = solver.solve(&Planar, &far, &[0.1, 0.4, 0.3]);
    assert_eq!(solution.stop, Stop::Stalled, "{solution}");
    assert!(solution.iterations <= 200);
    // Beyond the reach of 3 by 2.
    assert!((solution.residual.position - 2.0).abs() < 1e-6, "{solution}");
    assert!((solution.residual.position - far_from(&solution.q, &far)).abs() < 1e-12);
}

fn far_from(q: &[f64; 3], goal: &Pose<f64>) -> f64 {
    Planar.forward(q).residual(goal).position
}

#[test]
fn limits_hold_at_every_bound_and_only_if_asked_for() {
    // Of the two postures one has q3 = 2.5, the other one bends the elbow the other way.
    let goal = target([0.2, -0.9, 2.5]);
    let start = [0.2, -0.9, 1.9];
    for iterations in 0..30 {
        let solution = NumericInverse::new().max_iterations(iterations).solve(&Planar, &goal, &start);
        let [_, _, q3] = solution.q;
        assert!((-2.0..=2.0).contains(&q3), "{solution:?}");
    }
    let free = NumericInverse::new().within_limits(false).solve(&Planar, &goal, &start);
    assert!(free.converged() && (free.q[2] - 2.5).abs() < 1e-8, "{free:?}");
    let kept = NumericInverse::new().restarts(20).solve(&Planar, &goal, &start);
    let [_, q2, q3] = kept.q;
    assert!(kept.converged() && (q2 - 0.9).abs() < 1e-8 && q3.abs() <= 2.0, "{kept:?}");
    // A start beyond a limit is moved to it.
    let outside = NumericInverse::new().max_iterations(0).solve(&Planar, &goal, &[0.0, 0.0, 3.0]);
    assert_eq!((outside.q, outside.stop), ([0.0, 0.0, 2.0], Stop::IterationBound));
}

#[test]
fn a_free_joint_ends_within_half_a_turn_of_its_start() {
    let goal = target([0.8, 0.7, -0.4]);
    for turns in [-3.0, 0.0, 2.0] {
        let start = [0.5 + turns * core::f64::consts::TAU, 0.9, 0.2];
        let solution = NumericInverse::new().restarts(20).solve(&Planar, &goal, &start);
        assert!(solution.converged());
        assert!((solution.q[0] - start[0]).abs() <= core::f64::consts::PI + 1e-12, "{solution:?}");
    }
}

#[test]
fn the_null_space_brings_the_arm_towards_the_posture() {
    let goal = target([0.8, 0.7, -0.4]);
    let solver = NumericInverse::new().task(Task::POSITION);
    let (start, posture) = ([0.6, 0.5, 0.2], [0.0, 1.5, 0.3]);
    let plain = solver.solve(&Planar, &goal, &start);
    let near = solver.solve_towards(&Planar, &goal, &start, &posture);
    assert!(plain.converged() && near.converged(), "{plain} {near}");
    assert!(far_from(&near.q, &goal) < 1e-8);
    let wish = |q: [f64; 3]| [posture[0] - q[0], posture[1] - q[1], posture[2] - q[2]];
    let distance = |q| wish(q).iter().map(|x| x * x).sum::<f64>();
    assert!(distance(near.q) < distance(plain.q), "{near:?} {plain:?}");
    // The rest of the wish does not point along the null space of the two rows, their cross product. A last step was at
    // most 1e-3 in each of three joints, with a gain of 0.2.
    let [[a, b, c], [d, e, f], ..] = Planar.jacobian(&near.q).rows;
    let null = [b * f - c * e, c * d - a * f, a * e - b * d];
    let length = null.iter().map(|x: &f64| x * x).sum::<f64>().sqrt();
    let along = null.iter().zip(wish(near.q)).map(|(n, w)| n * w / length).sum::<f64>();
    assert!(along.abs() < 3.0_f64.sqrt() * 1e-3 / 0.2, "{along}");
    // Where nothing is free, it still converges.
    let bound = NumericInverse::new().solve_towards(&Planar, &goal, &start, &posture);
    assert!(bound.converged(), "{bound}");
}

#[test]
fn no_step_is_longer_than_the_cap_however_singular_the_arm() {
    let goal = target([0.8, 0.7, -0.4]);
    for bend in [0.0, 1e-300, 1e-160, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3] {
        for method in [Method::DampedLeastSquares, Method::NewtonRaphson] {
            for task in [Task::Pose, Task::POSITION, Task::PositionAxis([1.0, 0.0, 0.0])] {
                let start = [0.3, bend, -bend];
                let solver = NumericInverse::new().method(method).task(task).max_step(0.25).max_iterations(1);
                let solution = solver.solve(&Planar, &goal, &start);
                for (value, start) in solution.q.iter().zip(start) {
                    assert!((value - start).abs() <= 0.25 + 1e-15, "{bend} {solution:?}");
                }
                let end = solver.max_iterations(50).solve(&Planar, &goal, &start);
                assert!(end.q.iter().all(|q| q.is_finite()) && end.residual.position.is_finite(), "{end:?}");
            }
        }
    }
}

#[test]
fn bad_input_is_named() {
    let (good, start) = (target([0.8, 0.7, -0.4]), [0.5, 0.9, 0.2]);
    let solver = NumericInverse::new().restarts(3);
    for entry in [f64::NAN, f64::INFINITY] {
        let at = Pose { translation: [0.0, entry, 0.0], ..good };
        let turned = Pose { rotation: [[entry; 3]; 3], ..good };
        for bad in [at, turned] {
            let refused = solver.solve(&Planar, &bad, &start);
            assert_eq!((refused.stop, refused.q, refused.iterations), (Stop::BadTarget, start, 0));
            assert_eq!(refused.residual.position, f64::INFINITY);
        }
        assert_eq!(solver.solve(&Planar, &good, &[0.0, entry, 0.0]).stop, Stop::BadStart);
        assert_eq!(solver.solve_towards(&Planar, &good, &start, &[0.0, entry, 0.0]).stop, Stop::BadStart);
        let no_axis = solver.task(Task::PositionAxis([0.0, entry, 0.0])).solve(&Planar, &good, &start);
        assert_eq!(no_axis.stop, Stop::BadTarget);
    }
    let mirrored = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], ..good };
    assert_eq!(solver.solve(&Planar, &mirrored, &start).stop, Stop::BadTarget);
    assert_eq!(solver.task(Task::PositionAxis([0.0; 3])).solve(&Planar, &good, &start).stop, Stop::BadTarget);
    for settings in [solver.damping(f64::NAN), solver.length(0.0), solver.length(f64::NAN)] {
        let solution = settings.solve(&Planar, &good, &start);
        assert_eq!(solution.stop, Stop::NotFinite);
        assert!(solution.q.iter().all(|q| q.is_finite()), "{solution:?}");
    }
}

#[test]
fn the_same_seed_gives_the_same_answer() {
    // The start is stuck, as above.
    let goal = target([1.0, -2.0, 1.0]);
    let [x, y, _] = goal.translation;
    let start = [f64::atan2(y, x), 0.0, 0.0];
    let solve = |seed| NumericInverse::new().task(Task::POSITION).restarts(20).seed(seed).solve(&Planar, &goal, &start);
    assert!(solve(7).restarts > 0);
    assert_eq!(solve(7), solve(7));
    assert!((0..10).any(|seed| solve(seed).q != solve(7).q));
}

#[test]
fn opposite_axes_turn_half_a_turn() {
    // The tool's x axis is to point backwards; about z the arm can do it.
    let solver = NumericInverse::new().task(Task::PositionAxis([2.0, 0.0, 0.0])).restarts(20);
    let solution = solver.solve(&Planar, &target([0.1, 1.2, 1.9]), &[0.1 - core::f64::consts::PI, 1.2, 1.9]);
    assert!(solution.converged(), "{solution}");
    let [[x, ..], [y, ..], _] = Planar.forward(&solution.q).rotation;
    let (sin, cos) = 3.2_f64.sin_cos();
    assert!((x - cos).abs() < 1e-8 && (y - sin).abs() < 1e-8);
}

#[test]
fn the_report_reads_as_text() {
    let solution = NumericInverse::new().max_iterations(0).solve(&Planar, &target([0.1; 3]), &[0.1; 3]);
    assert_eq!(
        format!("{solution}"),
        "converged after 0 iterations, 0 restarts: position 0.0e0, orientation 0.0e0 rad"
    );
    assert_eq!(format!("{:>30}", Stop::BadStart).trim_start(), "bad start: not finite");
}

#[test]
fn a_definite_system_is_solved_and_an_indefinite_one_stays_finite() {
    let mut matrix = [[0.0_f64; 6]; 6];
    let vectors = [[1.0, 2.0, 0.5, -1.0, 0.0, 3.0], [0.0, 1.0, -2.0, 0.5, 1.0, 0.0], [2.0, 0.0, 1.0, 1.0, -1.0, 0.5]];
    for i in 0..6 {
        for j in 0..6 {
            matrix[i][j] = vectors.iter().map(|v| v[i] * v[j]).sum::<f64>() + if i == j { 0.25 } else { 0.0 };
        }
    }
    let expected = [1.0, -2.0, 3.0, 0.5, -0.25, 4.0];
    let right = matrix.map(|row| row.iter().zip(expected).map(|(a, x)| a * x).sum());
    let solution = linear::solve(matrix, right, f64::EPSILON);
    assert!(solution.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13), "{solution:?}");
    let singular = linear::solve([[1.0; 6]; 6], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], f64::EPSILON);
    assert!(singular.iter().all(|x| x.is_finite()));
}
