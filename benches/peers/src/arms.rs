//! The arms, and random reachable poses of them.

use denhart::{Arm, Chain, DhTable, Pose};

use crate::random::Random;

/// ABB IRB 2400: a spherical wrist behind two parallel axes.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(spec = "../../specs/abb_irb2400.yaml")]
pub struct Irb2400;

/// Universal Robots UR5: three parallel axes.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(spec = "../../specs/ur5.yaml")]
pub struct Ur5;

/// Unimation Puma 560, with its limits.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(spec = "../../specs/puma560.yaml")]
pub struct Puma560;

/// Franka Panda: seven joints, with limits.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(spec = "../../specs/franka_panda.yaml")]
pub struct FrankaPanda;

/// Kinova Jaco: six joints, no three axes that meet or are parallel.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(spec = "../../specs/kinova_jaco.yaml")]
pub struct KinovaJaco;

/// The arm with three parallel axes that ik-geo tests itself on: every link 1 m, no two axes meet.
#[derive(Debug, Clone, Copy, Arm)]
#[arm(yaml = "
name: three_parallel_bot
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 1, alpha: 90, d: 1, theta: 90}
  - {a: 1, alpha: 0, d: 0, theta: 0}
  - {a: 1, alpha: 0, d: 0, theta: 0}
  - {a: 1, alpha: -90, d: 0, theta: 0}
  - {a: 1, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 2, theta: 0}
")]
pub struct ThreeParallelBot;

/// `count` joint vectors, uniform in `+-pi`.
pub fn joints(name: &str, count: usize) -> Vec<[f64; 6]> {
    let mut random = Random::named(name);
    let mut angle = || random.uniform(-std::f64::consts::PI, std::f64::consts::PI);
    (0..count).map(|_| std::array::from_fn(|_| angle())).collect()
}

/// Pose of the tool by the plain chain.
pub fn pose(table: &DhTable, q: &[f64; 6]) -> Pose<f64> {
    Pose::from(Chain::from(*table).forward(q).expect("six joints"))
}
