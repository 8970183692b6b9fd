//! How long evaluation takes beside generated code, and how long it takes to build an arm from its file.
//!
//! `cargo run --release -p denhart-dynamic --example times`: medians over 400 joint vectors, each call repeated.
#![allow(clippy::unwrap_used)]

use std::hint::black_box;
use std::time::Instant;

use denhart::{Arm, InverseKinematics, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};

macro_rules! arms {
    ($($Type:ident $path:literal;)*) => {
        $(
            #[derive(Debug, Clone, Copy, Default, Arm)]
            #[arm(spec = $path)]
            struct $Type;
        )*

        fn main() {
            println!("{:28} {:>9} {:>9} {:>6} {:>9} {:>9} {:>6} {:>9}", "", "forward", "evaluated", "ratio", "inverse", "evaluated", "ratio", "build");
            println!("{:28} {:>9} {:>9} {:>6} {:>9} {:>9} {:>6} {:>9}", "", "ns", "ns", "", "ns", "ns", "", "ms");
            $(row::<$Type, { <$Type>::DOF }>($path);)*
            builds();
        }
    };
}

arms! {
    Ur5 "../specs/ur5.yaml";
    Puma560 "../specs/puma560.yaml";
    AbbIrb2400 "../specs/abb_irb2400.yaml";
    Stanford "../specs/stanford.yaml";
    IgusRebel "../specs/igus_rebel.yaml";
    SphericalShoulder6r "../specs/spherical_shoulder_6r.yaml";
    FanucLrmate200id "../specs/fanuc_lrmate200id.yaml";
}

/// Median time of a call, ns.
fn median<R>(mut call: impl FnMut(usize) -> R) -> f64 {
    const REPEATED: u32 = 20;
    let mut times: Vec<f64> = (0..400)
        .map(|index| {
            let start = Instant::now();
            for _ in 0..REPEATED {
                black_box(call(index));
            }
            start.elapsed().as_nanos() as f64 / f64::from(REPEATED)
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn row<A, const N: usize>(path: &str)
where
    A: InverseKinematics<f64, N, Target = Pose<f64>> + Default,
{
    let file = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(file).unwrap();
    let (arm, dynamic) = (A::default(), DynamicArm::from_yaml(&text).unwrap());
    let value = |index: usize, joint: usize| ((index * 7919 + joint * 104_729) % 6000) as f64 / 1000.0 - 3.0;
    let q: Vec<[f64; N]> = (0..400).map(|index| std::array::from_fn(|joint| value(index, joint))).collect();
    let targets: Vec<Pose<f64>> = q.iter().map(|q| arm.forward(q)).collect();
    let asked: Vec<DynamicTarget> = targets.iter().map(|pose| DynamicTarget::Pose(*pose)).collect();
    let forward = median(|i| arm.forward(black_box(&q[i])));
    let forward_evaluated = median(|i| dynamic.forward(black_box(&q[i])));
    let inverse = median(|i| arm.inverse(black_box(&targets[i])));
    let inverse_evaluated = median(|i| dynamic.inverse(black_box(&asked[i]), &[]));
    let build = build(&text);
    println!(
        "{path:28} {forward:9.0} {forward_evaluated:9.0} {:6.1} {inverse:9.0} {inverse_evaluated:9.0} {:6.1} {:9.2}",
        forward_evaluated / forward,
        inverse_evaluated / inverse,
        build,
    );
}

/// Median time to build an arm, ms.
fn build(text: &str) -> f64 {
    let mut builds: Vec<f64> = (0..9)
        .map(|_| {
            let start = Instant::now();
            black_box(DynamicArm::from_yaml(black_box(text)).is_ok());
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    builds.sort_by(f64::total_cmp);
    builds[builds.len() / 2]
}

/// The slowest arms of `specs/` to build.
fn builds() {
    let specs = std::fs::read_dir(format!("{}/../specs", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let mut all: Vec<(f64, String)> = specs
        .map(|entry| {
            let path = entry.unwrap().path();
            (build(&std::fs::read_to_string(&path).unwrap()), path.file_name().unwrap().to_string_lossy().into_owned())
        })
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let slowest = all.iter().take(6).map(|(build, name)| format!("{name} {build:.2} ms"));
    println!("slowest of {} to build: {}", all.len(), slowest.collect::<Vec<_>>().join(", "));
}
