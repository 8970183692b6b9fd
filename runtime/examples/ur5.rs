//! A UR5 from its table: the pose of the tool, the Jacobian, and every inverse solution. The example covers an ordinary
//! pose, the wrist singularity, a target beyond reach, and a target that is no pose.
//!
//! `cargo run --release --example ur5`

use denhart::{Arm, Pose};

#[derive(Arm)]
#[arm(spec = "examples/arms/ur5.yaml")]
struct Ur5;

fn main() {
    println!("UR5: {} joints, lengths in {}, angles printed in degrees", Ur5::DOF, Ur5::LENGTH_UNIT);

    show("An ordinary pose", [30.0, -70.0, 80.0, -40.0, 60.0, 15.0]);
    show("At the wrist singularity, q5 = 0: joint 6 is free", [30.0, -70.0, 80.0, -40.0, 0.0, 15.0]);
    near_a_reference();
    beyond_reach();
    no_pose();
}

/// Prints the pose and the Jacobian at a configuration (degrees) and every joint vector that reaches this pose.
fn show(title: &str, degrees: [f64; 6]) {
    heading(title);
    let q = degrees.map(f64::to_radians);
    let (pose, jacobian) = Ur5.forward_and_jacobian(&q);
    println!("q = {degrees:?}\n");
    println!("pose of the tool:\n{pose}\n");
    println!("Jacobian, rows vx vy vz wx wy wz:\n{jacobian:.4}\n");
    print_solutions(&pose);
}

/// Prints every solution, and how far it is from the target when recomputed by forward kinematics.
fn print_solutions(target: &Pose<f64>) {
    let solutions = Ur5.inverse(target);
    println!("inverse: {} ({} solutions)", solutions.status(), solutions.len());
    for (number, (solution, residual)) in (1..).zip(solutions.iter().zip(solutions.verify(&Ur5, target))) {
        println!("{number}  {:.2}\n   off by: {residual}", solution.display_for(&Ur5));
    }
}

/// The query of a controller: the solution nearest to the current joints, also joints more than half a turn away.
fn near_a_reference() {
    heading("Nearest to a reference, with q6 one turn further and the wrist singular");
    let q = [30.0, -70.0, 80.0, -40.0, 0.0, 375.0].map(f64::to_radians);
    let solutions = Ur5.inverse_near(&Ur5.forward(&q), &q);
    match solutions.nearest() {
        Some(nearest) => println!("{:.2}", nearest.display_for(&Ur5)),
        None => println!("{}", solutions.status()),
    }
}

fn beyond_reach() {
    heading("Beyond reach");
    let mut target = Ur5.forward(&[0.0, -1.2, 1.4, -0.7, 1.0, 0.3]);
    target.translation = [1.5, 0.0, 0.3];
    print_solutions(&target);
}

fn no_pose() {
    heading("A target whose rotation is none");
    let mut target = Ur5.forward(&[0.0, -1.2, 1.4, -0.7, 1.0, 0.3]);
    target.rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
    print_solutions(&target);
}

fn heading(title: &str) {
    println!("\n{title}\n{}", "-".repeat(title.len()));
}
