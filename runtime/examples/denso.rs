//! Nguyen, Pham and Chi 2023, forward kinematics of the Denso VS-6556. The example prints the eleven positions of Table
//! 2 under the motion law (23), with the velocity and the acceleration of the tool.
//!
//! `cargo run --release --example denso`

use denhart::Arm;

#[derive(Arm)]
#[arm(spec = "examples/arms/denso_vs6556.yaml")]
struct Denso;

/// Table 2, recomputed with 50 digits and rounded to its seven decimals. The paper differs by up to 4 in the last one.
const TABLE_2: [[f64; 3]; 11] = [
    [450.0, 0.0, 695.0],
    [470.3039601, 24.4281612, 650.7919976],
    [484.0081441, 49.9923951, 605.5436959],
    [491.1267604, 75.8046943, 559.9382214],
    [491.8543019, 101.0114197, 514.6408594],
    [486.5521737, 124.8232337, 470.2847183],
    [475.7293598, 146.5413824, 427.4576496],
    [460.0181416, 165.5792546, 386.6908037],
    [440.1460986, 181.4784032, 348.4491403],
    [416.905757, 193.9185162, 313.124137],
    [391.1233197, 202.7211432, 281.0288568],
];

fn main() {
    println!("{:>4}{:>41}{:>41}{:>12}{:>12}", "t, s", "table: x, y, z, mm", "here", "|v|, mm/s", "|a|, mm/s^2");
    let (rates, rest) = ([3.0_f64.to_radians(); 6], [0.0; 6]);
    for (t, expected) in TABLE_2.iter().enumerate() {
        // Every joint turns by 3 degrees a second; joints 2 and 3 start at -90 and 90.
        let turned = 3.0 * t as f64;
        let q = [0.0, -90.0, 90.0, 0.0, 0.0, 0.0].map(|start: f64| (start + turned).to_radians());
        let velocity = Denso.velocity(&q, &rates).linear;
        let acceleration = Denso.acceleration(&q, &rates, &rest).linear;
        let tool = Denso.forward(&q).translation;
        println!("{t:>4} {} {}{:>12.5}{:>12.5}", row(expected), row(&tool), norm(&velocity), norm(&acceleration));
    }
}

fn norm(vector: &[f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn row(numbers: &[f64; 3]) -> String {
    // The sum makes a zero of what is negative by rounding.
    numbers.map(|number| format!("{:>13.7}", (number * 1e7).round() / 1e7 + 0.0)).join("")
}
