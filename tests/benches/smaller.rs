//! Tables of ratios, each of one time over another:
//!
//! - inverses of two to five joints over their own `atan2` and square roots, counted alone;
//! - seven joints with one given over the same arm with that joint fixed;
//! - lengths bound at run time over constants.
//!
//! `cargo bench -p denhart-tests --no-default-features --bench smaller`

use std::array;
use std::f64::consts::PI;
use std::hint::black_box;

use denhart::{Arm, PlanarPose, PointAngle, Pose};
use denhart_tests::random::Random;
use denhart_tests::timing::{Case, compare};

#[path = "../tests/parameters/arms.rs"]
#[allow(dead_code, unused_macros, unused_imports, reason = "the traits and macros are for the tests")]
mod arms;

/// More than a branch predictor learns by heart.
const INPUTS: usize = 2048;

fn joints<const N: usize>(name: &str) -> Vec<[f64; N]> {
    let mut random = Random::named(name);
    (0..INPUTS).map(|_| array::from_fn(|_| random.uniform(-PI, PI))).collect()
}

/// `angles` calls of `f64::atan2` and `roots` of `f64::sqrt`, none of which waits for another.
fn alone(inputs: &[f64; 16], angles: usize, roots: usize) -> f64 {
    let pairs = inputs.iter().zip(inputs.iter().rev()).cycle();
    let angles: f64 = pairs.take(angles).map(|(y, x)| black_box(*y).atan2(*x)).sum();
    let roots: f64 = inputs.iter().cycle().take(roots).map(|x| black_box(x.abs()).sqrt()).sum();
    angles + roots
}

macro_rules! arm {
    ($Type:ident, $spec:literal) => {
        #[derive(Arm)]
        #[arm(spec = $spec)]
        struct $Type;
    };
}

arm!(Anthro3r, "../specs/anthro3r.yaml");
arm!(Planar2r, "../specs/planar2r.yaml");
arm!(Planar3r, "../specs/planar3r.yaml");
arm!(Jupiter, "../specs/jupiter.yaml");
arm!(Al5d, "../specs/al5d.yaml");
arm!(Scara, "../specs/scara_rrrp_325_275.yaml");
arm!(Youbot, "../specs/kuka_youbot.yaml");
arm!(Cylindrical, "../specs/cylindrical_rpp.yaml");
arm!(KukaIiwa, "../specs/kuka_iiwa7_r800.yaml");
arm!(FrankaPanda, "../specs/franka_panda.yaml");

/// The iiwa with joint 3 fixed at [`HELD`].
#[derive(Arm)]
#[arm(yaml = "
name: six_of_iiwa
convention: modified
units: {length: mm, angle: deg}
joints:
  - {a: 0, alpha: 0, d: 340, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {type: fixed, a: 0, alpha: 90, d: 400, theta: 40}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 400, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 126, theta: 0}
")]
struct SixOfIiwa;

/// The Panda with joint 7 fixed at [`HELD`].
#[derive(Arm)]
#[arm(yaml = "
name: six_of_panda
convention: modified
units: {length: m, angle: deg}
joints:
  - {a: 0, alpha: 0, d: 0.333, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.316, theta: 0}
  - {a: 0.0825, alpha: 90, d: 0, theta: 0}
  - {a: -0.0825, alpha: -90, d: 0.384, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {type: fixed, a: 0.088, alpha: 90, d: 0.107, theta: 40}
  - {type: fixed, a: 0, alpha: 0, d: 0.103, theta: -45}
")]
struct SixOfPanda;

/// Where the joint is held whose value is given, rad.
const HELD: f64 = 40.0 * PI / 180.0;

macro_rules! smaller {
    ($options:ident, $Type:ident, $angles:literal, $roots:literal, |$pose:ident, $q:ident| $target:expr) => {{
        let (rounds, repeat) = $options;
        let target = |$q: &[f64; _]| {
            let $pose = $Type.forward($q);
            $target
        };
        let targets: Vec<_> = joints(stringify!($Type)).iter().map(target).collect();
        assert!(targets.iter().all(|target| $Type.inverse(target).status().is_reachable()));
        let numbers: Vec<[f64; 16]> = joints("numbers");
        let cases = vec![
            Case::new(concat!($angles, " atan2, ", $roots, " sqrt"), &numbers, repeat, |x| alone(x, $angles, $roots)),
            Case::new("inverse, every branch", &targets, repeat, |target| $Type.inverse(target)),
        ];
        println!("{}", compare(stringify!($Type), cases, rounds));
    }};
}

macro_rules! held {
    ($options:ident, $Six:ident, $Seven:ident) => {{
        let (rounds, repeat) = $options;
        let targets: Vec<_> = joints(stringify!($Seven)).iter().map(|q| $Six.forward(q)).collect();
        let cases = vec![
            Case::new("six joints", &targets, repeat, |target| $Six.inverse(target)),
            Case::new("seven, one given", &targets, repeat, |target| $Seven.inverse(target, black_box(HELD))),
        ];
        println!("{}", compare(stringify!($Seven), cases, rounds));
    }};
}

macro_rules! bound {
    ($options:ident, $Bound:ident, $Folded:ident, |$pose:ident, $q:ident| $target:expr) => {{
        let (rounds, repeat) = $options;
        let q = joints(stringify!($Bound));
        let target = |$q: &[f64; _]| {
            let $pose = arms::$Folded.forward($q);
            $target
        };
        let targets: Vec<_> = q.iter().map(target).collect();
        let bound = black_box(arms::$Bound::nominal());
        let forward = vec![
            Case::new("forward and Jacobian, constants", &q, repeat, |q| arms::$Folded.forward_and_jacobian(q)),
            Case::new("forward and Jacobian, bound", &q, repeat, |q| bound.forward_and_jacobian(q)),
        ];
        let inverse = vec![
            Case::new("inverse, constants", &targets, repeat, |target| arms::$Folded.inverse(target)),
            Case::new("inverse, bound", &targets, repeat, |target| bound.inverse(target)),
        ];
        println!("{}", compare(stringify!($Bound), forward, rounds));
        println!("{}", compare(stringify!($Bound), inverse, rounds));
    }};
}

fn planar(pose: &Pose<f64>, q: &[f64]) -> PlanarPose<f64> {
    let [x, y, _] = pose.translation;
    PlanarPose::new(x, y, q.iter().sum())
}

fn main() {
    // `cargo test --benches` passes --test: one short round shows that it runs.
    let options = if std::env::args().any(|argument| argument == "--test") { (1, 1) } else { (51, 2) };
    smaller!(options, Planar2r, 3, 4, |pose, _q| [pose.translation[0], pose.translation[1]]);
    smaller!(options, Planar3r, 3, 4, |pose, q| planar(&pose, q));
    smaller!(options, Anthro3r, 8, 10, |pose, _q| pose.translation);
    smaller!(options, Cylindrical, 2, 2, |pose, _q| pose.translation);
    smaller!(options, Jupiter, 8, 10, |pose, q| PointAngle::new(pose.translation, q[1] + q[2] + q[3]));
    // The axis of joint 3 is turned around, and the table's angles add up to a right one.
    smaller!(options, Al5d, 8, 10, |pose, q| PointAngle::new(pose.translation, q[1] - q[2] + q[3] + 0.5 * PI));
    smaller!(options, Scara, 4, 4, |pose, _q| pose);
    smaller!(options, Youbot, 12, 12, |pose, _q| pose);
    held!(options, SixOfIiwa, KukaIiwa);
    held!(options, SixOfPanda, FrankaPanda);
    bound!(options, Planar3r, FoldedPlanar3r, |pose, q| planar(&pose, q));
    bound!(options, Jupiter, FoldedJupiter, |pose, q| PointAngle::new(pose.translation, q[1] + q[2] + q[3]));
    bound!(options, Puma560, FoldedPuma560, |pose, _q| pose);
}
