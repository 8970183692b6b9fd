//! Random paths and targets for followers by the thousand: see [`denhart_tests::follow::random`].

use std::process::ExitCode;

use clap::Parser;
use denhart::follow::{Crossing, Step};
use denhart::{InverseKinematics, PointAxis, Pose, Scalar};
use denhart_tests::follow::arms::{
    ANTHRO, Anthro, AnthroSingle, Data, IIWA, IRB2400, Iiwa, IiwaSingle, Irb2400, Irb2400Single, JACO, Jaco,
    JacoSingle, KR210, Kr210, Kr210Single, PUMA560, Puma560, Puma560Single, TORCH, Torch, TorchSingle, UR5, Ur5,
    Ur5Single,
};
use denhart_tests::follow::random::{Splines, jumps};

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
    /// In single precision.
    #[arg(long)]
    f32: bool,
    /// Only the arm of this name.
    #[arg(long)]
    arm: Option<String>,
    /// Only the spline of this number, as a failure names it; prints each of its ticks. No jumps.
    #[arg(long)]
    spline: Option<usize>,
}

fn main() -> ExitCode {
    let options = Options::parse();
    let held = if options.f32 {
        [
            one(&options, &Irb2400Single, &IRB2400, |pose, _| *pose, bad),
            one(&options, &Ur5Single, &UR5, |pose, _| *pose, bad),
            one(&options, &Puma560Single, &PUMA560, |pose, _| *pose, bad),
            one(&options, &Kr210Single, &KR210, |pose, _| *pose, bad),
            one(&options, &IiwaSingle, &IIWA, |pose, q| (*pose, q[2]), || (bad(), 0.0)),
            one(&options, &TorchSingle, &TORCH, |pose, _| axis(pose), || axis(&bad())),
            one(&options, &AnthroSingle, &ANTHRO, |pose, _| pose.translation, || [f32::NAN; 3]),
            one(&options, &JacoSingle, &JACO, |pose, _| *pose, bad),
        ]
    } else {
        [
            one(&options, &Irb2400, &IRB2400, |pose, _| *pose, bad),
            one(&options, &Ur5, &UR5, |pose, _| *pose, bad),
            one(&options, &Puma560, &PUMA560, |pose, _| *pose, bad),
            one(&options, &Kr210, &KR210, |pose, _| *pose, bad),
            one(&options, &Iiwa, &IIWA, |pose, q| (*pose, q[2]), || (bad(), 0.0)),
            one(&options, &Torch, &TORCH, |pose, _| axis(pose), || axis(&bad())),
            one(&options, &Anthro, &ANTHRO, |pose, _| pose.translation, || [f64::NAN; 3]),
            one(&options, &Jaco, &JACO, |pose, _| *pose, bad),
        ]
    };
    if held.iter().all(|held| *held) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn axis<T: Scalar>(pose: &Pose<T>) -> PointAxis<T> {
    PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z))
}

/// A target that is none.
fn bad<T: Scalar>() -> Pose<T> {
    Pose { translation: [T::NAN; 3], ..Pose::identity() }
}

fn one<A, T: Scalar, const N: usize>(
    options: &Options,
    arm: &A,
    data: &Data<N>,
    target: impl Fn(&Pose<T>, &[T; N]) -> A::Target,
    bad: impl Fn() -> A::Target,
) -> bool
where
    A: InverseKinematics<T, N>,
{
    if options.arm.as_ref().is_some_and(|name| name != data.name) {
        return true;
    }
    let count = options.count.div_ceil(8);
    let mut held = true;
    for accelerations in [false, true] {
        let splines = Splines { accelerations, count: count.div_ceil(2), seed: options.seed, only: options.spline };
        let many = splines.follow(arm, data, &target, |t, _, step| {
            if options.spline.is_some() {
                print(t, step);
            }
        });
        println!("{:9} splines {many:?}", data.name);
        held &= many.holds();
    }
    if options.spline.is_some() {
        return held;
    }
    let longer = |q: &[T; N], factor: T| {
        let mut pose = arm.forward(q);
        pose.translation = pose.translation.map(|x| x * factor);
        target(&pose, q)
    };
    let jumps = jumps(arm, data, Crossing::Wrist, count, options.seed, longer, bad);
    println!("{:9} jumps   {jumps:?}", data.name);
    // In f32 an acceleration is the difference of two velocities over the period, each of them rounded.
    held && jumps.run.holds(if options.f32 { 5e-4 } else { 1e-6 }) && jumps.restless == 0
}

/// A tick, in a line.
fn print<T: Scalar, const N: usize>(t: f64, step: &Step<T, N>) {
    let Step { q, velocity, tracking, residual, branch, crossed, held, remaining, .. } = step;
    let [position, orientation] = [residual.position, residual.orientation];
    println!(
        "{t:.3} {tracking} q {q:.5?} velocity {velocity:.4?} off {position:.6} {orientation:.6} \
         branch {branch:?} crossed {crossed:?} held {held:?} remaining {remaining:.3}"
    );
}
