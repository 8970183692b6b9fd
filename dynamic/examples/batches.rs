//! A planner's loop: for every edge of a roadmap the joint vector at its end, on all processors. Then the same targets
//! through lanes of generated code.
//!
//! `cargo run --release -p denhart-dynamic --features batch --example batches`

use std::panic::resume_unwind;
use std::thread;

use denhart::batch::{self, Found};
use denhart::{Arm, Pose};
use denhart_dynamic::{DynamicArm, DynamicError};

/// Of each target the joint vector within the limits that is nearest to its start, where `found` has one.
fn ends(
    arm: &DynamicArm,
    targets: &[f64],
    starts: &[f64],
    q: &mut [f64],
    found: &mut [Found],
) -> Result<(), DynamicError> {
    let (n, rows) = (arm.joints(), found.len());
    if [targets.len(), starts.len(), q.len()] != [12 * rows, n * rows, n * rows] {
        // One call tells which slice has another length.
        return arm.inverse_near_batch(targets, starts, q, found).map(drop);
    }
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let chunk = rows.div_ceil(threads).max(1);
    thread::scope(|scope| {
        let parts = targets.chunks(12 * chunk).zip(starts.chunks(n * chunk));
        let parts = parts.zip(q.chunks_mut(n * chunk)).zip(found.chunks_mut(chunk));
        let solve =
            |(((targets, starts), q), found)| scope.spawn(move || arm.inverse_near_batch(targets, starts, q, found));
        let running: Vec<_> = parts.map(solve).collect();
        running.into_iter().try_for_each(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)).map(drop))
    })
}

#[derive(Arm)]
#[arm(spec = "../specs/ur5.yaml", batch)]
struct Ur5;

/// Every solution of each target; how many targets have one.
fn solve(targets: &[Pose<f64>], q: &mut [[[f64; 6]; 8]], found: &mut [Found]) -> Result<usize, batch::Lengths> {
    Ok(batch::inverse(&Ur5, targets, q, found)?.reached)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arm = DynamicArm::from_file(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/ur5.yaml"))?;
    let edges = 10_000;
    let starts: Vec<f64> = (0..6 * edges).map(|number| 3.0 * f64::sin(number as f64)).collect();
    let goals: Vec<f64> = starts.iter().map(|angle| angle + 0.1).collect();
    // Kept from one round to the next: new memory costs as much as the mathematics.
    let mut targets = vec![0.0; 12 * edges];
    let mut q = vec![0.0; 6 * edges];
    let mut found = vec![Found::NOTHING; edges];
    arm.forward_batch(&goals, &mut targets)?;
    ends(&arm, &targets, &starts, &mut q, &mut found)?;
    println!("{} of {edges} edges have an end", found.iter().filter(|found| found.count > 0).count());

    let poses: Vec<Pose<f64>> = goals.as_chunks().0.iter().map(|q| Ur5.forward(q)).collect();
    let mut all = vec![[[0.0; 6]; 8]; edges];
    println!("{} of {edges} targets are reached", solve(&poses, &mut all, &mut found)?);
    Ok(())
}
