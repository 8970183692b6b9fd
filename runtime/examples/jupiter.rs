//! Shalash et al. 2024, position and orientation analysis of the Jupiter robot arm. The example prints the validation
//! point of the paper, and the four joint vectors that reach it, of which the paper has one.
//!
//! `cargo run --release --example jupiter`

use denhart::{Arm, PointAngle};

#[derive(Arm)]
#[arm(spec = "examples/arms/jupiter.yaml")]
struct Jupiter;

/// The paper's angles count upward: base, shoulder, elbow. In the table pitch joints count downward.
const PAPER: [f64; 3] = [0.0, 0.0, 90.0];
const POINT: [f64; 3] = [10.0, 0.0, 14.0];

fn main() {
    let [base, shoulder, elbow] = PAPER;
    let q = [base, -shoulder, -elbow, 0.0].map(f64::to_radians);
    println!("             x        y        z   cm");
    println!("paper  {}", row(&POINT));
    println!("here   {}   at base 0, shoulder 0, elbow 90 degrees", row(&Jupiter.forward(&q).translation));

    // The tool as it is there, pointing up.
    let target = PointAngle::new(POINT, -90.0_f64.to_radians());
    println!(
        "\n          base shoulder    elbow      wrist   degrees, as the paper counts; the wrist keeps the tool upright"
    );
    println!("paper  {}", row(&PAPER));
    for solution in &Jupiter.inverse(&target) {
        let [q1, q2, q3, q4] = solution.q.map(f64::to_degrees);
        println!("here   {} {:>10.4}   {}", row(&[q1, -q2, -q3]), -q4, solution.branch);
    }
}

fn row(numbers: &[f64; 3]) -> String {
    // The sum makes a zero of what is negative by rounding.
    numbers.map(|number| format!("{:>8.4}", (number * 1e4).round() / 1e4 + 0.0)).join(" ")
}
