//! Time and completeness of `general` on published and random arms.
//!
//! `cargo run --release -p denhart-core --features std --example general -- [poses] [arms]`

#[path = "../tests/general/support.rs"]
#[allow(dead_code)]
mod support;
#[path = "../tests/general/tables.rs"]
mod tables;

use std::hint::black_box;
use std::time::Instant;
use support::*;

fn at(v: &mut [f64], p: f64) -> f64 {
    v.sort_by(f64::total_cmp);
    v[((v.len() - 1) as f64 * p) as usize]
}

fn main() {
    let mut arguments = std::env::args().skip(1).map(|x| x.parse::<usize>().unwrap());
    let (poses, arms) = (arguments.next().unwrap_or(1000), arguments.next().unwrap_or(200));
    let mut units: Vec<f64> = (0..200)
        .map(|k| {
            let start = Instant::now();
            for i in 0..1000 {
                for j in 0..6 {
                    black_box(black_box((i * j + k) as f64 * 1e-3).sin_cos());
                }
            }
            start.elapsed().as_nanos() as f64 / 1000.0
        })
        .collect();
    let unit = at(&mut units, 0.5);
    println!("six sin_cos: {unit:.0} ns");
    for table in &tables::TABLES {
        let start = Instant::now();
        let is_given = table.rows.len() == 7;
        let Some(arm) = (if is_given { Arm::given(table, 2, 0.7) } else { Arm::of(&chain(table, 0, 0.0)) }) else {
            println!("{}: no cut", table.name);
            continue;
        };
        let choice = start.elapsed().as_secs_f64() * 1e3;
        let mut rng = Random(31);
        let (mut lost, mut found, mut times, mut before, mut search) = (0, 0, vec![], vec![], vec![]);
        let (mut evaluations, mut most, mut open, mut doubts) = (0, 0, 0, 0);
        for _ in 0..poses {
            let joints = rng.joints();
            let target = arm.chain.pose(&joints);
            let (mut best, mut least) = (f64::MAX, f64::MAX);
            let mut solutions = Solutions::default();
            for _ in 0..3 {
                let start = Instant::now();
                solutions = black_box(if is_given {
                    arm.solve_anew(black_box(&target))
                } else {
                    arm.solve(black_box(&target))
                });
                best = best.min(start.elapsed().as_nanos() as f64);
                let start = Instant::now();
                black_box(arm.general.search(black_box(&target), &[0.0; 6], &mut |c| {
                    black_box(c);
                    core::ops::ControlFlow::Continue(())
                }));
                least = least.min(start.elapsed().as_nanos() as f64);
            }
            times.push(best);
            search.push(least);
            found += solutions.list.len();
            before.push(solutions.before);
            evaluations += solutions.evaluations;
            most = most.max(solutions.evaluations);
            open += usize::from(!solutions.is_complete);
            doubts += usize::from(solutions.is_doubtful);
            lost += usize::from(solutions.distance(&arm.chain, &joints) > SAME);
        }
        println!(
            "{:20} choice {choice:.0} ms {:?}/{:?} lost {lost}/{poses} found {:.1} evals {:.0} most {most} open {open} doubts {doubts} before {:.0e} {:.0e} | us {:.1} p99 {:.0} max {:.0} search {:.1} | ratio {:.0} worst/median {:.0}",
            table.name,
            arm.cuts.first.cut.order(),
            arm.cuts.second.map(|x| x.cut.held()),
            found as f64 / poses as f64,
            evaluations as f64 / poses as f64,
            at(&mut before, 0.5),
            at(&mut before, 0.99),
            at(&mut times, 0.5) / 1e3,
            at(&mut times, 0.99) / 1e3,
            at(&mut times, 1.0) / 1e3,
            at(&mut search, 0.5) / 1e3,
            at(&mut times, 0.5) / unit,
            at(&mut times, 1.0) / at(&mut times, 0.5),
        );
    }
    let mut rng = Random(2024);
    let (mut lost, mut found, mut times, mut choices, mut worst) = (0, 0, vec![], vec![], 0.0_f64);
    for number in 0..arms {
        let rows: Vec<[f64; 4]> =
            (0..6).map(|_| [rng.within(-1.0, 1.0), rng.within(-180.0, 180.0), rng.within(-1.0, 1.0), 0.0]).collect();
        let table = tables::Table { name: "", is_modified: false, rows: Box::leak(rows.into_boxed_slice()) };
        let start = Instant::now();
        let Some(arm) = Arm::of(&chain(&table, 0, 0.0)) else {
            println!("arm {number}: no cut");
            continue;
        };
        choices.push(start.elapsed().as_secs_f64() * 1e3);
        for _ in 0..20 {
            let joints = rng.joints();
            let target = arm.chain.pose(&joints);
            let start = Instant::now();
            let solutions = black_box(arm.solve(black_box(&target)));
            times.push(start.elapsed().as_nanos() as f64);
            found += solutions.list.len();
            worst = solutions.residuals.iter().fold(worst, |a, b| a.max(*b));
            if solutions.distance(&arm.chain, &joints) > SAME {
                lost += 1;
                println!(
                    "arm {number} lost {:.0e} sigma {:.0e} {:?}",
                    solutions.distance(&arm.chain, &joints),
                    least_singular_value(&arm.chain, &joints),
                    arm.cuts
                );
            }
        }
    }
    println!(
        "{arms} arms x 20: lost {lost} found {found} residual {worst:.0e} us {:.1} p99 {:.0} max {:.0} choice ms {:.0} max {:.0}",
        at(&mut times, 0.5) / 1e3,
        at(&mut times, 0.99) / 1e3,
        at(&mut times, 1.0) / 1e3,
        at(&mut choices, 0.5),
        at(&mut choices, 1.0)
    );
}
