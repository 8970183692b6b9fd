//! Random paths and targets for followers by the thousand: see [`denhart_tests::follow::random`].

use std::process::ExitCode;

use clap::Parser;
use denhart::follow::Crossing;
use denhart::{Arm, InverseKinematics, PointAxis, Pose};
use denhart_tests::follow::arms::{
    ANTHRO, Anthro, Data, IIWA, IRB2400, Iiwa, Irb2400, JACO, Jaco, KR210, Kr210, PUMA560, Puma560, TORCH, Torch, UR5,
    Ur5,
};
use denhart_tests::follow::random::{jumps, splines};

/// Follows random splines, and targets that jump, on eight arms of different structure.
///
/// Exit code 0: every tick held the limits, every spline that has a continuous solution ended exact, and what is out of
/// reach came to rest. Else exit code 1.
#[derive(Parser)]
struct Options {
    /// How many splines, and how many jumps, on all arms together.
    #[arg(long, default_value_t = 304)]
    count: usize,
    /// All numbers follow from it.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    let options = Options::parse();
    let axis = |pose: &Pose<f64>| PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z));
    let bad = Pose { translation: [f64::NAN; 3], ..Pose::identity() };
    let held = [
        one(&options, &Irb2400, &IRB2400, |pose, _| *pose, || bad),
        one(&options, &Ur5, &UR5, |pose, _| *pose, || bad),
        one(&options, &Puma560, &PUMA560, |pose, _| *pose, || bad),
        one(&options, &Kr210, &KR210, |pose, _| *pose, || bad),
        one(&options, &Iiwa, &IIWA, |pose, q| (*pose, q[2]), || (bad, 0.0)),
        one(&options, &Torch, &TORCH, |pose, _| axis(pose), || axis(&bad)),
        one(&options, &Anthro, &ANTHRO, |pose, _| pose.translation, || [f64::NAN; 3]),
        one(&options, &Jaco, &JACO, |pose, _| *pose, || bad),
    ];
    if held.iter().all(|held| *held) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn one<A, const N: usize>(
    options: &Options,
    arm: &A,
    data: &Data<N>,
    target: impl Fn(&Pose<f64>, &[f64; N]) -> A::Target,
    bad: impl Fn() -> A::Target,
) -> bool
where
    A: InverseKinematics<f64, N> + Arm<f64, N>,
{
    let count = options.count.div_ceil(8);
    let mut held = true;
    for accelerations in [false, true] {
        let many = splines(arm, data, accelerations, count.div_ceil(2), options.seed, &target);
        println!("{:9} splines {many:?}", data.name);
        held &= many.lost == 0 && many.wrong == 0 && many.restless == 0;
    }
    let longer = |q: &[f64; N], factor: f64| {
        let mut pose = arm.forward(q);
        pose.translation = pose.translation.map(|x| x * factor);
        target(&pose, q)
    };
    let jumps = jumps(arm, data, Crossing::Wrist, count, options.seed, longer, bad);
    println!("{:9} jumps   {jumps:?}", data.name);
    held && jumps.run.holds(1e-6) && jumps.restless == 0
}
