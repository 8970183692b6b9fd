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

/// The eight arms, with numbers of one type.
macro_rules! all {
    ($options:expr; $Irb2400:ident $Ur5:ident $Puma560:ident $Kr210:ident $Iiwa:ident $Torch:ident $Anthro:ident $Jaco:ident) => {
        [
            one($options, &$Irb2400, &IRB2400, |pose, _| *pose, bad),
            one($options, &$Ur5, &UR5, |pose, _| *pose, bad),
            one($options, &$Puma560, &PUMA560, |pose, _| *pose, bad),
            one($options, &$Kr210, &KR210, |pose, _| *pose, bad),
            one($options, &$Iiwa, &IIWA, |pose, q| (*pose, q[2]), || (bad(), 0.0)),
            one($options, &$Torch, &TORCH, |pose, _| axis(pose), || axis(&bad())),
            one($options, &$Anthro, &ANTHRO, |pose, _| pose.translation, || bad().translation),
            one($options, &$Jaco, &JACO, |pose, _| *pose, bad),
        ]
    };
}

fn main() -> ExitCode {
    let options = Options::parse();
    let held = if options.f32 {
        all!(&options; Irb2400Single Ur5Single Puma560Single Kr210Single IiwaSingle TorchSingle AnthroSingle JacoSingle)
    } else {
        all!(&options; Irb2400 Ur5 Puma560 Kr210 Iiwa Torch Anthro Jaco)
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
    held && jumps.run.holds() && jumps.restless == 0
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
