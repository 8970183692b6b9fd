//! Nasution, Alfaris and Siagian, inverse kinematics with Newton-Raphson: three links in a plane.
//!
//! The paper prints no table, its R code cannot run, and the matrix it takes for a rotation is none. So the task is
//! taken from the paper and not the numbers. The task has transforms from roll, pitch and yaw, the Jacobian, the pose
//! error, Newton's steps, and a motion from a start to a target. The paper asks at its end for the analytic Jacobian,
//! links of any length and more links, which are also here.

use denhart::numeric::{Method, NumericInverse, Task};
use denhart::{Arm, PlanarPose, Pose};
use nalgebra::{Matrix3, Vector3};

use crate::page;
use crate::tables::{apart, off, radians};

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/planar3r.yaml")]
struct Planar3r {
    l1: f64,
    l2: f64,
    l3: f64,
}

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/planar4r_redundant.yaml")]
struct FourLinks;

const IN_THE_PLANE: Task<f64> = Task::Components([true, true, false, false, false, true]);

fn newton() -> NumericInverse<f64> {
    NumericInverse::new().method(Method::NewtonRaphson).task(IN_THE_PLANE)
}

/// The target as the paper writes it: a position, and a rotation from roll, pitch and yaw.
fn target(x: f64, y: f64, yaw_deg: f64) -> Pose<f64> {
    Pose::from_xyz_rpy([x, y, 0.0], [0.0, 0.0, yaw_deg.to_radians()])
}

/// x, y, turn: the error of the tool, and the Jacobian, written out for three links.
fn written_out(arm: &Planar3r, q: &[f64; 3], target: &Pose<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let angles = [q[0], q[0] + q[1], q[0] + q[1] + q[2]];
    let tips = [arm.l1, arm.l2, arm.l3];
    let mut jacobian = Matrix3::repeat(1.0);
    let (mut x, mut y) = (0.0, 0.0);
    // From the tool back to the base, the way from each joint to the tool.
    for joint in (0..3).rev() {
        (x, y) = (x + tips[joint] * angles[joint].cos(), y + tips[joint] * angles[joint].sin());
        (jacobian[(0, joint)], jacobian[(1, joint)]) = (-y, x);
    }
    let (s, c) = (target.rotation[1][0], target.rotation[0][0]);
    let turn = (s * angles[2].cos() - c * angles[2].sin()).atan2(c * angles[2].cos() + s * angles[2].sin());
    (Vector3::new(target.translation[0] - x, target.translation[1] - y, turn), jacobian)
}

/// Printed: a matrix that is no rotation. True: `Rz(yaw) Ry(pitch) Rx(roll)`, which is one, and comes back as its angles.
#[test]
fn misprint_the_rotation_is_none() {
    let rpy = radians([20.0, -35.0, 110.0]);
    let pose = Pose::from_xyz_rpy([16.0, 13.0, 0.0], rpy);
    let matrix = Matrix3::from_fn(|row, column| pose.rotation[row][column]);
    assert!((matrix * matrix.transpose() - Matrix3::identity()).amax() < 1e-15);
    assert!((matrix.determinant() - 1.0).abs() < 1e-15);
    assert!(off(&pose.rpy().angles, &rpy) < 1e-15);
}

/// The convergence table, as the page has it: the error after each step, and the joint vector, which is that of Newton's steps written out.
#[test]
fn the_convergence_table() {
    let arm = Planar3r::nominal();
    let target = target(16.0, 13.0, 180.0);
    let start = radians([30.0, 40.0, 80.0]);
    let mut q = start;
    let mut errors = Vec::new();
    for steps in 0..=6 {
        let solution = newton().tolerance(0.0, 0.0).max_iterations(steps).solve(&arm, &target, &start);
        assert_eq!(solution.iterations, steps);
        let (error, jacobian) = written_out(&arm, &q, &target);
        // Rounding of a reach of 37 cm; the normal equations square the condition of the Jacobian, 50 here.
        assert!(apart(&solution.q, &q) < 1e-11, "{steps}: {:?} for {q:?}", solution.q);
        let left = f64::hypot(error[0], error[1]);
        assert!((left - solution.residual.position).abs() < 1e-9, "{steps}: {left:e} for {solution}");
        assert!((error[2].abs() - solution.residual.orientation).abs() < 1e-10, "{steps}: {solution}");
        if steps < 6 {
            let degrees = q.map(|joint| format!("{:.5}", joint.to_degrees()));
            page::has(&[&[steps.to_string()], &degrees[..]].concat());
        }
        errors.push((left / 37.0).max(error[2].abs()));
        let step = jacobian.lu().solve(&error).unwrap();
        q = std::array::from_fn(|joint| q[joint] + step[joint]);
    }
    for pair in errors.windows(2) {
        assert!(pair[1] < 10.0 * pair[0] * pair[0] + 1e-15, "quadratic: {errors:?}");
    }
    assert!(errors[0] > 0.1 && errors[6] < 1e-14, "{errors:?}");
}

/// A motion from a start to a target on a straight line. Each pose is solved from the one before, in a few steps. The
/// motion stays on the branch of the start all the way, which is the branch of the closed form.
#[test]
fn a_motion_from_a_start_to_a_target() {
    let arm = Planar3r::nominal();
    let from = arm.inverse(&PlanarPose::new(25.0, 5.0, 1.0));
    assert_eq!(from.exact().count(), 2);
    for start in from.iter().map(|solution| solution.q) {
        let (mut q, mut total) = (start, 0);
        for k in 1..=50 {
            let part = f64::from(k) / 50.0;
            let between = |from: f64, to: f64| from + part * (to - from);
            let [x, y, phi] = [between(25.0, 16.0), between(5.0, 13.0), between(1.0, 2.5)];
            let solution = newton().tolerance(1e-12, 1e-12).solve(&arm, &target(x, y, phi.to_degrees()), &q);
            assert!(solution.converged() && solution.iterations <= 4, "{k}: {solution}");
            let closed = arm.inverse_near(&PlanarPose::new(x, y, phi), &q);
            assert!(off(&solution.q, &closed.nearest().unwrap().q) < 1e-9, "{k}: {solution:?} {closed:?}");
            assert!(off(&solution.q, &q) < 0.1, "{k}: no jump to another branch");
            (q, total) = (solution.q, total + solution.iterations);
        }
        let [x, y, _] = arm.forward(&q).translation;
        assert!(off(&[x, y, q.iter().sum()], &[16.0, 13.0, 2.5]) < 1e-10 && total <= 200, "{total}");
    }
}

/// Asked for in the paper: the analytic Jacobian. In the plane the rate of yaw is that of the sum of the joints.
#[test]
fn the_analytic_jacobian() {
    let arm = Planar3r::nominal();
    let (q, rates) = ([0.3, 0.5, -0.4], [0.7, -0.2, 1.1]);
    let (pose, jacobian) = arm.forward_and_jacobian(&q);
    let (velocity, [roll, pitch, yaw]) = jacobian.analytic_rpy(pose.rpy().angles).mul(&rates);
    assert!(off(&[roll, pitch, yaw], &[0.0, 0.0, rates.iter().sum()]) < 1e-15);
    let (_, written) = written_out(&arm, &q, &pose);
    let expected = written * Vector3::from(rates);
    assert!(off(&velocity, &[expected[0], expected[1], 0.0]) < 1e-13);
}

/// Asked for in the paper: links of any length.
#[test]
fn links_of_any_length() {
    for lengths in [[20.0, 10.0, 7.0], [15.0, 10.0, 4.0], [10.0, 5.0, 2.0], [1.0, 1.5, 0.2]] {
        let [l1, l2, l3] = lengths;
        let arm = Planar3r { l1, l2, l3 };
        let goal = [0.4, 0.9, -0.5];
        let solution = newton().solve(&arm, &arm.forward(&goal), &[0.5, 0.7, -0.3]);
        assert!(solution.converged() && apart(&solution.q, &goal) < 1e-7, "{solution:?}");
    }
}

/// Asked for in the paper: more links. A fourth joint is left over, and stays as near to a posture as the target lets it.
#[test]
fn more_links() {
    let goal = [0.4, 0.9, -0.5, 0.3];
    let target = FourLinks.forward(&goal);
    let start = [0.2, 0.7, -0.3, 0.5];
    let solution = newton().solve(&FourLinks, &target, &start);
    assert!(solution.converged() && FourLinks.forward(&solution.q).residual(&target).position < 1e-9, "{solution:?}");
    // The posture is on the target itself, so the joints can be there.
    let towards = NumericInverse::new().task(IN_THE_PLANE).solve_towards(&FourLinks, &target, &start, &goal);
    assert!(towards.converged() && apart(&towards.q, &goal) < 1e-2, "{towards:?}");
    assert!(apart(&solution.q, &goal) > apart(&towards.q, &goal), "{solution:?}");
}
