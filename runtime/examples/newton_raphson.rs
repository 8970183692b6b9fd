//! Nasution, Alfaris and Siagian, inverse kinematics with Newton-Raphson: three links in a plane from a start to a target.
//! The paper prints no numbers. Shown are its task, the error after each step, and a motion along a line.
//!
//! `cargo run --release --example newton_raphson`

use denhart::numeric::{Method, NumericInverse, Task};
use denhart::{Arm, PlanarPose, Pose};

#[derive(Arm)]
#[arm(spec = "examples/arms/planar3r.yaml")]
struct Planar3r;

fn main() {
    // Position along x and y, and the turn about z.
    let in_the_plane = Task::Components([true, true, false, false, false, true]);
    let newton = NumericInverse::new().method(Method::NewtonRaphson).task(in_the_plane);

    println!("From (30, 40, 80) degrees to (16, 13) cm at 180 degrees\n");
    println!("{:>4}{:>11}{:>11}{:>11}{:>14}{:>14}", "step", "q1", "q2", "q3", "off by, cm", "turned, rad");
    let start = [30.0, 40.0, 80.0].map(f64::to_radians);
    let target = pose([16.0, 13.0, 180.0]);
    for steps in 0..=6 {
        let here = newton.tolerance(0.0, 0.0).max_iterations(steps).solve(&Planar3r, &target, &start);
        let [q1, q2, q3] = here.q.map(f64::to_degrees);
        let (far, turned) = (here.residual.position, here.residual.orientation);
        println!("{steps:>4}{q1:>11.5}{q2:>11.5}{q3:>11.5}{far:>14.2e}{turned:>14.2e}");
    }
    let exact = Planar3r.inverse_near(&PlanarPose::new(16.0, 13.0, 180.0_f64.to_radians()), &start);
    if let Some(exact) = exact.nearest() {
        println!("closed form: {:.5}", exact.display_for(&Planar3r));
    }

    println!("\nOn a line from (25, 5) at 57 degrees to (16, 13) at 143, each pose from the one before\n");
    let mut q = [30.0, -60.0, 90.0].map(f64::to_radians);
    for k in 0..=10 {
        let part = f64::from(k) / 10.0;
        let at = [25.0 - 9.0 * part, 5.0 + 8.0 * part, 57.0 + 86.0 * part];
        let solution = newton.solve(&Planar3r, &pose(at), &q);
        q = solution.q;
        let [q1, q2, q3] = q.map(f64::to_degrees);
        println!("({:>5.2}, {:>5.2}) at {:>5.1}: {q1:>9.4} {q2:>9.4} {q3:>9.4}   {solution}", at[0], at[1], at[2]);
    }
}

/// The target as the paper writes it: a position, cm, and a rotation from roll, pitch and yaw, of which yaw is not 0.
fn pose([x, y, yaw]: [f64; 3]) -> Pose<f64> {
    Pose::from_xyz_rpy([x, y, 0.0], [0.0, 0.0, yaw.to_radians()])
}
