//! One function, called a given number of times, for `valgrind --tool=callgrind`. See `instructions.sh`.
//!
//! `instructions CASE CALLS`; without arguments it lists the cases.

use std::hint::black_box;
use std::process::ExitCode;

use denhart::numeric::NumericInverse;
use denhart::{Arm, Pose};
use denhart_peers::arms::{Irb2400, KinovaJaco, Puma560, ThreeParallelBot, Ur5, joints, pose};
use denhart_peers::elimination;
use denhart_peers::opw;
use denhart_peers::product_of_exponentials::GeoArm;
use ik_geo::inverse_kinematics::{spherical_two_parallel, three_parallel, three_parallel_two_intersecting};
use ik_geo::nalgebra::{Matrix6, Vector6};
use rs_opw_kinematics::kinematic_traits::Kinematics;

/// Number of inputs, equal for every case; a multiple of it is called.
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

/// The numeric inverse of `arm` beside what an iteration consists of. `numeric_11` does ten iterations more than
/// `numeric_1`: with tolerances of 0 it never ends sooner.
fn numeric<A: Arm<f64, 6> + Copy + 'static>(arm: A, names: [&'static str; 5]) -> Vec<(&'static str, Run)> {
    let q = joints(names[0], INPUTS);
    let systems: Vec<([[f64; 6]; 6], [f64; 6])> = q.iter().map(|q| (arm.jacobian(q).rows, *q)).collect();
    let systems_of_nalgebra: Vec<(Matrix6<f64>, Vector6<f64>)> = systems
        .iter()
        .map(|(rows, right)| (Matrix6::from_fn(|row, column| rows[row][column]), Vector6::from(*right)))
        .collect();
    let targets: Vec<(Pose<f64>, [f64; 6])> =
        q.iter().map(|q| (arm.forward(q), q.map(|angle| 0.9 * angle + 0.05))).collect();
    let solver = NumericInverse::new().tolerance(0.0, 0.0).patience(usize::MAX);
    let solve = move |iterations: usize| {
        let solver = solver.max_iterations(iterations);
        move |(target, start): &(Pose<f64>, [f64; 6])| solver.solve(&arm, target, start)
    };
    let [evaluation, elimination, lu, one, eleven] = names;
    vec![
        (evaluation, cycle(q, move |q| arm.forward_and_jacobian(q))),
        (elimination, cycle(systems, |(rows, right)| elimination::solve(*rows, *right))),
        (lu, cycle(systems_of_nalgebra, |(matrix, right)| matrix.lu().solve(right))),
        (one, cycle(targets.clone(), solve(1))),
        (eleven, cycle(targets, solve(11))),
    ]
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
    let mut cases = vec![
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
    ];
    macro_rules! numeric {
        ($name:literal, $arm:expr) => {
            cases.extend(numeric(
                $arm,
                [
                    concat!($name, "_forward_and_jacobian_alone"),
                    concat!($name, "_bare_elimination"),
                    concat!($name, "_nalgebra_lu_solve"),
                    concat!($name, "_numeric_1"),
                    concat!($name, "_numeric_11"),
                ],
            ));
        };
    }
    numeric!("ur5", Ur5);
    numeric!("puma560", Puma560);
    numeric!("kinova_jaco", KinovaJaco);
    cases
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
