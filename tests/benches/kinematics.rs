//! Forward kinematics, Jacobian and inverse of three arms, beside six bare `f64::sin_cos` and the plain chain.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use denhart::{Chain, Pose};
use denhart_tests::arms::{AbbIrb2400, Puma560, Ur5};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::subject::{Specified, reach};

/// More inputs than a branch predictor learns by heart; a power of two, so that the cycle costs one `and`.
const INPUTS: usize = 2048;

/// Random joint vectors of an arm.
fn joints<A: Specified<6>>() -> Vec<[f64; 6]> {
    let space = Space::new(&A::JOINT_KINDS, &A::LIMITS, reach(&A::TABLE, &A::LIMITS));
    let mut random = Random::named(A::NAME);
    (0..INPUTS).map(|_| space.random(&mut random)).collect()
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
        let name = <$Type as Specified<6>>::NAME;
        let inputs = $inputs;
        bench(&mut $group, name, &inputs, $call);
    )*};
}

fn yardsticks(group: &mut BenchmarkGroup<'_, WallTime>) {
    bench(group, "six f64::sin_cos", &joints::<Ur5>(), |q| q.map(f64::sin_cos));
}

fn forward(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("forward");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| joints::<Puma560>(), |q| arm.forward(q);
        Ur5: |arm| joints::<Ur5>(), |q| arm.forward(q);
        AbbIrb2400: |arm| joints::<AbbIrb2400>(), |q| arm.forward(q);
    }
    let chain = Chain::from(Ur5::DH);
    bench(&mut group, "ur5, Chain", &joints::<Ur5>(), |q| chain.forward(q));
}

fn forward_and_jacobian(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("forward_and_jacobian");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| joints::<Puma560>(), |q| arm.forward_and_jacobian(q);
        Ur5: |arm| joints::<Ur5>(), |q| arm.forward_and_jacobian(q);
        AbbIrb2400: |arm| joints::<AbbIrb2400>(), |q| arm.forward_and_jacobian(q);
    }
    let chain = Chain::from(Ur5::DH);
    bench(&mut group, "ur5, Chain", &joints::<Ur5>(), |q| (chain.forward(q), chain.jacobian(q)));
}

/// Poses of random joint vectors.
fn poses<A: Specified<6>>() -> Vec<Pose<f64>> {
    joints::<A>().iter().map(|q| A::default().forward(q)).collect()
}

fn inverse(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("inverse");
    yardsticks(&mut group);
    bench_arms! { group,
        Puma560: |arm| poses::<Puma560>(), |target| arm.inverse(target);
        Ur5: |arm| poses::<Ur5>(), |target| arm.inverse(target);
        AbbIrb2400: |arm| poses::<AbbIrb2400>(), |target| arm.inverse(target);
    }
}

criterion_group!(benches, forward, forward_and_jacobian, inverse);
criterion_main!(benches);
