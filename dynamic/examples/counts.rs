//! Inverses of a UR5 for `valgrind --tool=callgrind`, see `tests/batch.sh`: `counts WAY SET COUNT`. The ways are `single`,
//! single calls of the generated code, `generated`, its lanes, and `dynamic`.

use std::f64::consts::PI;
use std::hint::black_box;
use std::path::Path;
use std::process::ExitCode;

use denhart::batch::{self, Found, InstructionSet};
use denhart::{Arm, Pose};
use denhart_dynamic::DynamicArm;

#[derive(Arm)]
#[arm(spec = "../specs/ur5.yaml", batch)]
struct Ur5;

/// The most targets.
const TARGETS: usize = 5120;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, way, wanted, count] = arguments.as_slice() else {
        eprintln!("counts WAY SET COUNT: single, generated or dynamic; sets of this machine:");
        for set in InstructionSet::available().into_iter().flatten() {
            println!("{set}");
        }
        return ExitCode::SUCCESS;
    };
    let count: usize = count.parse().unwrap_or(0);
    // Multiples of the golden ratio and other irrational numbers fill the joint space evenly.
    let angle = |index: usize, joint: usize| {
        let step =
            [0.618_033_988_7, 0.414_213_562_3, 0.732_050_807_5, 0.236_067_977_4, 0.645_751_311_0, 0.316_624_790_3];
        PI * (2.0 * (index as f64 * step[joint] + 0.1).fract() - 1.0)
    };
    // As many whatever the count: to make them is no part of the difference.
    let targets: Vec<Pose<f64>> =
        (0..TARGETS).map(|index| Ur5.forward(&std::array::from_fn(|joint| angle(index, joint)))).collect();
    let targets = targets.get(..count).unwrap_or(&targets);
    if way == "single" {
        for target in targets {
            black_box(Ur5.inverse(black_box(target)));
        }
        return ExitCode::SUCCESS;
    }
    let set = InstructionSet::available().into_iter().flatten().find(|set| set.to_string() == *wanted);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml");
    let (Some(set), Ok(mut arm)) = (set, DynamicArm::from_file(file)) else {
        eprintln!("no {wanted} here");
        return ExitCode::FAILURE;
    };
    if way == "generated" {
        let (mut q, mut found) = (vec![[[0.0; 6]; 8]; count], vec![Found::NOTHING; count]);
        let done = batch::inverse_with(set, &Ur5, targets, &mut q, &mut found);
        black_box((&mut q, &mut found));
        return if done.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE };
    }
    arm.set_instruction_set(set);
    let rows: Vec<f64> =
        targets.iter().flat_map(|pose| pose.rotation.into_iter().flatten().chain(pose.translation)).collect();
    let (mut q, mut found) = (vec![0.0; 48 * count], vec![Found::NOTHING; count]);
    let done = arm.inverse_batch(&rows, &[], &mut q, &mut found);
    black_box((&mut q, &mut found));
    match done {
        Ok(_) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
