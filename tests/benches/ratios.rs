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

/// Arms that hold a joint: name and file.
macro_rules! holding_a_joint {
    ($($Type:ident $file:literal;)*) => {$(
        #[derive(Arm)]
        #[arm(spec = $file)]
        struct $Type;
    )*};
}

holding_a_joint! {
    FanucCrx10ial "../specs/fanuc_crx10ial.yaml";
    UfactoryXarm6 "../specs/ufactory_xarm6.yaml";
    KinovaJaco "../specs/kinova_jaco.yaml";
    KinovaGen3Lite "../specs/kinova_gen3_lite.yaml";
    Gen6rA "../specs/gen6r_a.yaml";
    TwoParallel6r "../specs/two_parallel_6r.yaml";
    ManseurDoty16 "../specs/manseur_doty_16.yaml";
    SlidesRprrpr "arms/held_joint/slides_rprrpr.yaml";
    SawyerQ3 "../specs/rethink_sawyer.yaml";
    Xarm7Q3 "../specs/ufactory_xarm7.yaml";
    BaxterLeft "../specs/baxter_left.yaml";
    MeasuredUr5 "arms/measured/real.yaml";
    CloselyMeasuredUr5 "arms/measured/close.yaml";
}

/// Beside a straight wrist, rad.
const BESIDE: f64 = 2e-3;

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

/// The inverse of an arm that holds a joint; the joint that is given, from 0.
macro_rules! held {
    ($Type:ident, $rounds:ident, $repeat:ident) => {{
        let q = joints(stringify!($Type));
        let targets: Vec<Pose<f64>> = q.iter().map(|q| $Type.forward(q)).collect();
        let cases = vec![
            Case::new("six f64::sin_cos", &q, $repeat, |q| q.map(f64::sin_cos)),
            Case::new("inverse, every solution", &targets, $repeat, |target| $Type.inverse(target)),
        ];
        println!("{}", compare(stringify!($Type), cases, $rounds));
    }};
    ($Type:ident, $rounds:ident, $repeat:ident, beside the wrist) => {{
        let q = joints(stringify!($Type));
        let beside = q.iter().map(|q| [q[0], q[1], q[2], q[3], q[4] / PI * BESIDE, q[5]]);
        let [targets, beside]: [Vec<Pose<f64>>; 2] =
            [q.iter().map(|q| $Type.forward(q)).collect(), beside.map(|q| $Type.forward(&q)).collect()];
        let cases = vec![
            Case::new("six f64::sin_cos", &q, $repeat, |q| q.map(f64::sin_cos)),
            Case::new("inverse, every solution", &targets, $repeat, |target| $Type.inverse(target)),
            Case::new("inverse beside the wrist", &beside, $repeat, |target| $Type.inverse(target)),
        ];
        println!("{}", compare(stringify!($Type), cases, $rounds));
    }};
    ($Type:ident, $rounds:ident, $repeat:ident, given $given:literal) => {{
        let q = joints(stringify!($Type));
        let whole = |q: &[f64; 6]| -> [f64; 7] { std::array::from_fn(|joint| q[joint % 6]) };
        let targets: Vec<(Pose<f64>, f64)> = q.iter().map(|q| ($Type.forward(&whole(q)), whole(q)[$given])).collect();
        let cases = vec![
            Case::new("six f64::sin_cos", &q, $repeat, |q| q.map(f64::sin_cos)),
            Case::new("inverse, every solution", &targets, $repeat, |(target, given)| $Type.inverse(target, *given)),
        ];
        println!("{}", compare(stringify!($Type), cases, $rounds));
    }};
}

fn main() {
    // `cargo test --benches` passes --test: one short round shows that it runs.
    let (rounds, repeat) = if std::env::args().any(|argument| argument == "--test") { (1, 1) } else { (51, 2) };
    table!(Puma560, rounds, repeat);
    table!(Ur5, rounds, repeat);
    table!(AbbIrb2400, rounds, repeat);
    let (rounds, repeat) = (rounds.min(9), 1);
    held!(FanucCrx10ial, rounds, repeat);
    held!(UfactoryXarm6, rounds, repeat);
    held!(KinovaJaco, rounds, repeat);
    held!(KinovaGen3Lite, rounds, repeat);
    held!(Gen6rA, rounds, repeat);
    held!(TwoParallel6r, rounds, repeat);
    held!(ManseurDoty16, rounds, repeat);
    held!(SlidesRprrpr, rounds, repeat);
    held!(SawyerQ3, rounds, repeat, given 2);
    held!(Xarm7Q3, rounds, repeat, given 2);
    held!(BaxterLeft, rounds, repeat, given 2);
    held!(MeasuredUr5, rounds, repeat, beside the wrist);
    held!(CloselyMeasuredUr5, rounds, repeat, beside the wrist);
}
