//! A table of ratios: every function of three arms over six bare `f64::sin_cos`, in interleaved rounds.
//!
//! `cargo bench -p denhart-tests --no-default-features --bench ratios`

use std::f64::consts::PI;

use denhart::{Arm, Chain, Pose};
use denhart_tests::random::Random;
use denhart_tests::timing::{Case, compare};

#[derive(Arm)]
#[arm(spec = "../specs/puma560.yaml")]
struct Puma560;

#[derive(Arm)]
#[arm(spec = "../specs/ur5.yaml")]
struct Ur5;

#[derive(Arm)]
#[arm(spec = "../specs/abb_irb2400.yaml")]
struct AbbIrb2400;

/// More than a branch predictor learns by heart.
const INPUTS: usize = 2048;

/// Joint rates, and their derivatives.
const RATES: [f64; 6] = [0.3, -0.1, 0.2, 0.7, -0.5, 0.9];

fn joints(name: &str) -> Vec<[f64; 6]> {
    let mut random = Random::named(name);
    (0..INPUTS).map(|_| std::array::from_fn(|_| random.uniform(-PI, PI))).collect()
}

macro_rules! table {
    ($Type:ident, $rounds:ident, $repeat:ident) => {{
        let arm = $Type;
        let name = stringify!($Type);
        let q = joints(name);
        let targets: Vec<Pose<f64>> = q.iter().map(|q| arm.forward(q)).collect();
        let chain = Chain::from($Type::DH);
        let cases = vec![
            Case::new("six f64::sin_cos", &q, $repeat, |q| q.map(f64::sin_cos)),
            Case::new("forward", &q, $repeat, |q| arm.forward(q)),
            Case::new("link_poses", &q, $repeat, |q| arm.link_poses(q)),
            Case::new("jacobian", &q, $repeat, |q| arm.jacobian(q)),
            Case::new("forward_and_jacobian", &q, $repeat, |q| arm.forward_and_jacobian(q)),
            Case::new("velocity", &q, $repeat, |q| arm.velocity(q, &RATES)),
            Case::new("acceleration", &q, $repeat, |q| arm.acceleration(q, &RATES, &RATES)),
            Case::new("inverse, every branch", &targets, $repeat, |target| arm.inverse(target)),
            Case::new("Chain forward", &q, $repeat, |q| chain.forward(q)),
        ];
        println!("{}", compare(name, cases, $rounds));
    }};
}

fn main() {
    // `cargo test --benches` passes --test: one short round shows that it runs.
    let (rounds, repeat) = if std::env::args().any(|argument| argument == "--test") { (1, 1) } else { (51, 2) };
    table!(Puma560, rounds, repeat);
    table!(Ur5, rounds, repeat);
    table!(AbbIrb2400, rounds, repeat);
}
