//! Forward kinematics, Jacobian and inverse of three arms, beside six bare `f64::sin_cos` and the plain chain.
//!
//! `cargo bench -p denhart-tests --no-default-features --bench kinematics`

use std::f64::consts::PI;
use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use denhart::{Arm, Chain, Pose};
use denhart_tests::random::Random;

#[derive(Arm)]
#[arm(spec = "../specs/puma560.yaml")]
struct Puma560;

#[derive(Arm)]
#[arm(spec = "../specs/ur5.yaml")]
struct Ur5;

#[derive(Arm)]
#[arm(spec = "../specs/abb_irb2400.yaml")]
struct AbbIrb2400;

/// More inputs than a branch predictor learns by heart; a power of two, so that the cycle costs one `and`.
const INPUTS: usize = 2048;

/// Random joint vectors.
fn joints() -> Vec<[f64; 6]> {
    let mut random = Random::named("kinematics");
    (0..INPUTS).map(|_| std::array::from_fn(|_| random.uniform(-PI, PI))).collect()
}

/// One function over a cycle of inputs.
fn bench<I, O>(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, inputs: &[I], function: impl Fn(&I) -> O) {
    let mut index = 0;
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            index = (index + 1) % INPUTS;
            black_box(function(black_box(&inputs[index])))
        });
    });
}

macro_rules! bench_arms {
    ($group:ident, $($Type:ident: |$arm:ident| $inputs:expr, $call:expr;)*) => {$(
        let $arm = $Type;
        let name = stringify!($Type);
        let inputs = $inputs;
        bench(&mut $group, name, &inputs, $call);
    )*};
}

fn yardsticks(group: &mut BenchmarkGroup<'_, WallTime>) {
    bench(group, "six f64::sin_cos", &joints(), |q| q.map(f64::sin_cos));
}

fn forward(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("forward");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| joints(), |q| arm.forward(q);
        Ur5: |arm| joints(), |q| arm.forward(q);
        AbbIrb2400: |arm| joints(), |q| arm.forward(q);
    }
    let chain = Chain::from(Ur5::DH);
    bench(&mut group, "ur5, Chain", &joints(), |q| chain.forward(q));
}

fn forward_and_jacobian(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("forward_and_jacobian");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| joints(), |q| arm.forward_and_jacobian(q);
        Ur5: |arm| joints(), |q| arm.forward_and_jacobian(q);
        AbbIrb2400: |arm| joints(), |q| arm.forward_and_jacobian(q);
    }
    let chain = Chain::from(Ur5::DH);
    bench(&mut group, "ur5, Chain", &joints(), |q| (chain.forward(q), chain.jacobian(q)));
}

/// Poses of random joint vectors.
fn poses(arm: &impl Arm<f64, 6>) -> Vec<Pose<f64>> {
    joints().iter().map(|q| arm.forward(q)).collect()
}

fn inverse(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("inverse");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| poses(&arm), |target| arm.inverse(target);
        Ur5: |arm| poses(&arm), |target| arm.inverse(target);
        AbbIrb2400: |arm| poses(&arm), |target| arm.inverse(target);
    }
}

criterion_group!(benches, forward, forward_and_jacobian, inverse);
criterion_main!(benches);
