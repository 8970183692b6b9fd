//! A table of ratios: batches of generated code and of `denhart-dynamic` on every instruction set of the machine, over the
//! generated scalar functions, in interleaved rounds of one run.
//!
//! `cargo bench -p denhart-tests --no-default-features --bench batch`

use std::cell::RefCell;
use std::f64::consts::PI;
use std::hint::black_box;
use std::path::Path;
use std::sync::mpsc;
use std::thread;

use denhart::batch::{self, BatchArm, BatchInverse, Found, InstructionSet};
use denhart::{Arm, Jacobian, Pose};
use denhart_dynamic::DynamicArm;
use denhart_tests::random::Random;
use denhart_tests::timing::{Case, compare};

#[derive(Arm)]
#[arm(spec = "../specs/ur5.yaml", batch)]
struct Ur5;

#[derive(Arm)]
#[arm(spec = "../specs/abb_irb2400.yaml", batch)]
struct AbbIrb2400;

/// Poses that stay in the cache, and as many as do not.
const SIZES: [(&str, usize); 2] = [("in cache", 2048), ("in memory", 1_000_000)];

/// Slices for the results of a batch, which are kept.
struct Kept {
    poses: Vec<f64>,
    jacobians: Vec<f64>,
    q: Vec<f64>,
    nearest: Vec<f64>,
    found: Vec<Found>,
}

impl Kept {
    fn new(n: usize) -> Self {
        Kept {
            poses: vec![0.0; 12 * n],
            jacobians: vec![0.0; 36 * n],
            q: vec![0.0; 48 * n],
            nearest: vec![0.0; 6 * n],
            found: vec![Found::NOTHING; n],
        }
    }
}

fn arm(file: &str, set: InstructionSet) -> DynamicArm {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let mut arm = DynamicArm::from_file(path).unwrap_or_else(|error| panic!("{file}: {error}"));
    arm.set_instruction_set(set);
    arm
}

fn table<A>(file: &str, generated: &A, size: (&str, usize), rounds: usize)
where
    A: BatchArm<6> + BatchInverse<6, 8>,
{
    let (size, n) = size;
    let mut random = Random::named(file);
    let q: Vec<[f64; 6]> = (0..n).map(|_| std::array::from_fn(|_| random.uniform(-PI, PI))).collect();
    let poses: Vec<Pose<f64>> = q.iter().map(|q| generated.forward(q)).collect();
    let targets: Vec<f64> =
        poses.iter().flat_map(|pose| pose.rotation.into_iter().flatten().chain(pose.translation)).collect();
    let targets = targets.as_slice();
    let joints: Vec<f64> = q.iter().flatten().copied().collect();
    let sets: Vec<_> = InstructionSet::available().into_iter().flatten().map(|set| (set, arm(file, set))).collect();

    // One memory for all cases: a million poses of every kind take 1.5 GB.
    let kept = RefCell::new(Kept::new(n));
    let kept = &kept;
    let title = format!("{file}, {size}");

    let out = RefCell::new(vec![Pose::identity(); n]);
    let mut cases = vec![Case::of_many("forward, single calls, generated", n, || {
        for (q, pose) in q.iter().zip(&mut *out.borrow_mut()) {
            *pose = generated.forward(q);
        }
        black_box(&out);
    })];
    for (set, arm) in &sets {
        cases.push(Case::of_many(&format!("forward, generated, {set}"), n, || {
            batch::forward_with(*set, generated, &q, &mut out.borrow_mut()).unwrap();
            black_box(&out);
        }));
        cases.push(Case::of_many(&format!("forward, dynamic, {set}"), n, || {
            arm.forward_batch(&joints, &mut kept.borrow_mut().poses).unwrap();
            black_box(kept);
        }));
    }
    println!("{}", compare(&title, cases, rounds));
    drop(out);

    let out = RefCell::new(vec![(Pose::identity(), Jacobian::zero()); n]);
    let mut cases = vec![Case::of_many("forward_and_jacobian, single calls, generated", n, || {
        for (q, both) in q.iter().zip(&mut *out.borrow_mut()) {
            *both = generated.forward_and_jacobian(q);
        }
        black_box(&out);
    })];
    for (set, arm) in &sets {
        cases.push(Case::of_many(&format!("forward_and_jacobian, dynamic, {set}"), n, || {
            let Kept { poses, jacobians, .. } = &mut *kept.borrow_mut();
            arm.forward_and_jacobian_batch(&joints, poses, jacobians).unwrap();
            black_box(poses);
        }));
    }
    println!("{}", compare(&title, cases, rounds));
    drop(out);

    let out = RefCell::new(vec![[[0.0; 6]; 8]; n]);
    thread::scope(|scope| {
        let mut cases = vec![Case::of_many("inverse, single calls, generated", n, || {
            for target in &poses {
                black_box(generated.inverse(target));
            }
        })];
        for (set, arm) in &sets {
            cases.push(Case::of_many(&format!("inverse, generated, {set}"), n, || {
                let found = &mut kept.borrow_mut().found;
                batch::inverse_with(*set, generated, &poses, &mut out.borrow_mut(), found).unwrap();
                black_box(&out);
            }));
            cases.push(Case::of_many(&format!("inverse, dynamic, {set}"), n, || {
                let Kept { q, found, .. } = &mut *kept.borrow_mut();
                arm.inverse_batch(targets, &[], q, found).unwrap();
                black_box(q);
            }));
        }
        if let Some((set, arm)) = sets.last() {
            // Two threads, each with its half and its memory: the second one waits for its next pass, as in a pool.
            let (first, second) = targets.split_at(12 * (n / 2));
            let (pass, passes) = mpsc::channel();
            let (done, results) = mpsc::channel();
            scope.spawn(move || {
                let rows = second.len() / 12;
                let (mut q, mut found) = (vec![0.0; 48 * rows], vec![Found::NOTHING; rows]);
                for () in passes {
                    arm.inverse_batch(second, &[], &mut q, &mut found).unwrap();
                    done.send(black_box(&q).len()).unwrap();
                }
            });
            cases.push(Case::of_many(&format!("inverse, dynamic, {set}, two threads"), n, move || {
                let Kept { q, found, .. } = &mut *kept.borrow_mut();
                let rows = first.len() / 12;
                pass.send(()).unwrap();
                arm.inverse_batch(first, &[], &mut q[..48 * rows], &mut found[..rows]).unwrap();
                results.recv().unwrap();
            }));
            // Each pass has new memory, as a function that returns an array has.
            cases.push(Case::of_many(&format!("inverse, dynamic, {set}, new memory"), n, || {
                let (mut q, mut found) = (vec![0.0; 48 * n], vec![Found::NOTHING; n]);
                arm.inverse_batch(targets, &[], &mut q, &mut found).unwrap();
                black_box(&mut q);
            }));
        }
        println!("{}", compare(&title, cases, rounds));
    });
    drop(out);

    let mut cases = vec![Case::of_many("inverse_near, single calls, generated", n, || {
        for (target, q) in poses.iter().zip(&q) {
            black_box(generated.inverse_near(target, q).within_limits().next());
        }
    })];
    for (set, arm) in &sets {
        cases.push(Case::of_many(&format!("inverse_near, dynamic, {set}"), n, || {
            let Kept { nearest, found, .. } = &mut *kept.borrow_mut();
            arm.inverse_near_batch(targets, &joints, nearest, found).unwrap();
            black_box(nearest);
        }));
    }
    println!("{}", compare(&title, cases, rounds));
}

fn main() {
    // `cargo test --benches` passes --test: one short round shows that it runs.
    let test = std::env::args().any(|argument| argument == "--test");
    for (size, n) in SIZES {
        let (n, rounds) = match (test, n) {
            (true, _) => (64, 1),
            (false, 1_000_000) => (n, 11),
            (false, _) => (n, 51),
        };
        table("../specs/ur5.yaml", &Ur5, (size, n), rounds);
        table("../specs/abb_irb2400.yaml", &AbbIrb2400, (size, n), rounds);
    }
}
