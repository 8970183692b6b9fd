//! Salman, Hamzah and Bakhy, an arm with three joints and stepper motors. The example prints positions, the four
//! solutions with their limits, and where whole pulses leave the tool.
//!
//! `cargo run --release --example salman`

use denhart::Arm;

#[derive(Arm)]
#[arm(spec = "examples/arms/salman_rrr.yaml")]
struct Salman;

/// Table 4, case 2: degrees; position by theory and by the steppers, mm.
const CASE_2: ([f64; 3], [f64; 3], [f64; 3]) =
    ([-30.0, 5.0, -5.0], [398.3923, -218.4649, 187.1697], [398.3570, -218.5304, 187.1793]);

/// Table 5: the paper's name of the branch, degrees. The target is (390, 80, 300).
const TABLE_5: [(&str, [f64; 3]); 4] = [
    ("left-up", [10.1529, 44.6560, -46.5354]),
    ("left-down", [10.1529, -8.4781, 46.5354]),
    ("right-up", [-166.9685, 135.3440, 46.5354]),
    ("right-down", [-166.9685, -171.5219, -46.5354]),
];

fn main() {
    let (degrees, theory, reached) = CASE_2;
    let end = Salman.quantized_error(&degrees.map(f64::to_radians));
    println!("Table 4, q = {degrees:?} degrees: x, y, z, mm");
    println!("  theory   paper {}", row(&theory));
    println!("           here  {}", row(&Salman.forward(&degrees.map(f64::to_radians)).translation));
    println!("  steppers paper {}", row(&reached));
    println!(
        "           here  {}   pulses {:?}, off by {:.4} mm",
        row(&end.pose.translation),
        end.pulses,
        end.residual.position
    );

    println!("\nTable 5, (390, 80, 300) mm: degrees");
    let solutions = Salman.inverse(&[390.0, 80.0, 300.0]);
    for (name, degrees) in TABLE_5 {
        println!("  {name:<10} paper {}", row(&degrees));
        // The branch that the row means: the one next to it.
        let near = Salman.inverse_near(&[390.0, 80.0, 300.0], &degrees.map(f64::to_radians));
        let Some(solution) = near.nearest() else { continue };
        let limits = if solution.is_within_limits() { "within the limits" } else { "beyond the limits" };
        let end = Salman.quantized_error(&solution.q);
        println!("             here  {}   {limits}, pulses {:?}", row(&solution.q.map(f64::to_degrees)), end.pulses);
    }
    println!("\n{} solutions, {}", solutions.len(), solutions.status());
    for solution in &solutions {
        println!("  {:.4}", solution.display_for(&Salman));
    }
}

fn row(numbers: &[f64; 3]) -> String {
    numbers.map(|number| format!("{number:>10.4}")).join(" ")
}
