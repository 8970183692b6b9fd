//! One function, called a given number of times, for `valgrind --tool=callgrind`. See `instructions.sh`.
//!
//! `instructions CASE CALLS`; without arguments it lists the cases.

use std::hint::black_box;
use std::process::ExitCode;

use denhart::Pose;
use denhart_peers::arms::{Irb2400, ThreeParallelBot, Ur5, joints, pose};
use denhart_peers::opw;
use denhart_peers::product_of_exponentials::GeoArm;
use ik_geo::inverse_kinematics::{spherical_two_parallel, three_parallel, three_parallel_two_intersecting};
use rs_opw_kinematics::kinematic_traits::Kinematics;

/// The same set of inputs for every case; a multiple of it is called.
const INPUTS: usize = 100;

type Run = Box<dyn Fn(usize)>;

/// `function` on every input in turn, `calls` times in all.
fn cycle<I: 'static, O>(inputs: Vec<I>, function: impl Fn(&I) -> O + 'static) -> Run {
    Box::new(move |calls| {
        for input in inputs.iter().cycle().take(calls) {
            black_box(function(black_box(input)));
        }
    })
}

fn cases() -> Vec<(&'static str, Run)> {
    let irb_joints = joints("irb2400", INPUTS);
    let ur_joints = joints("ur5", INPUTS);
    let irb: Vec<Pose<f64>> = irb_joints.iter().map(|q| pose(&Irb2400::DH, q)).collect();
    let ur: Vec<Pose<f64>> = ur_joints.iter().map(|q| pose(&Ur5::DH, q)).collect();
    let opw = opw::irb2400();
    let wrist = GeoArm::new(&Irb2400::DH, [0, 1, 2, 4, 4, 4]);
    let bot: Vec<Pose<f64>> = ur_joints.iter().map(|q| pose(&ThreeParallelBot::DH, q)).collect();
    let bot_geo = GeoArm::new(&ThreeParallelBot::DH, [0, 1, 2, 3, 4, 5]);
    let bot_targets = bot.iter().map(|target| bot_geo.target(target)).collect();
    let parallel = GeoArm::new(&Ur5::DH, [0, 1, 2, 3, 4, 5]);
    let meeting = GeoArm::new(&Ur5::DH, [0, 1, 2, 3, 5, 5]);
    let wrist_targets = irb.iter().map(|target| wrist.target(target)).collect();
    let parallel_targets = ur.iter().map(|target| parallel.target(target)).collect();
    let meeting_targets = ur.iter().map(|target| meeting.target(target)).collect();
    vec![
        ("empty_loop", cycle(ur_joints.clone(), |_| ())),
        ("six_sin_cos", cycle(ur_joints.clone(), |q| q.map(f64::sin_cos))),
        ("irb2400_forward", cycle(irb_joints.clone(), |q| Irb2400.forward(q))),
        ("irb2400_forward_and_jacobian", cycle(irb_joints.clone(), |q| Irb2400.forward_and_jacobian(q))),
        ("irb2400_inverse", cycle(irb.clone(), |target| Irb2400.inverse(target))),
        ("irb2400_opw_forward", cycle(irb_joints, move |q| opw.forward(q))),
        ("irb2400_opw_inverse", cycle(irb.iter().map(opw::target).collect(), move |target| opw.inverse(target))),
        (
            "irb2400_ik_geo_spherical_two_parallel",
            cycle(wrist_targets, move |target| wrist.inverse(spherical_two_parallel, target)),
        ),
        ("ur5_forward", cycle(ur_joints.clone(), |q| Ur5.forward(q))),
        ("ur5_forward_and_jacobian", cycle(ur_joints, |q| Ur5.forward_and_jacobian(q))),
        ("ur5_inverse", cycle(ur, |target| Ur5.inverse(target))),
        ("ur5_ik_geo_three_parallel", cycle(parallel_targets, move |target| parallel.inverse(three_parallel, target))),
        (
            "ur5_ik_geo_three_parallel_two_intersecting",
            cycle(meeting_targets, move |target| meeting.inverse(three_parallel_two_intersecting, target)),
        ),
        ("three_parallel_bot_inverse", cycle(bot, |target| ThreeParallelBot.inverse(target))),
        (
            "three_parallel_bot_ik_geo_three_parallel",
            cycle(bot_targets, move |target| bot_geo.inverse(three_parallel, target)),
        ),
    ]
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let cases = cases();
    let chosen = match arguments.as_slice() {
        [case, calls] => cases.iter().find(|(name, _)| name == case).zip(calls.parse::<usize>().ok()),
        _ => None,
    };
    if let Some(((_, run), calls)) = chosen {
        run(calls);
        return ExitCode::SUCCESS;
    }
    for (name, _) in &cases {
        println!("{name}");
    }
    if arguments.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
