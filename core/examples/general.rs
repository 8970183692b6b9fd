//! Time and completeness of `general` on published and random arms.
//!
//! With `SPECIAL=1` it gives each joint of the arms of seven special values instead.
//!
//! `cargo run --release -p denhart-core --features std --example general -- [poses] [random arms] [name]`

#![allow(clippy::unwrap_used)]

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
    v.get((v.len().saturating_sub(1) as f64 * p) as usize).copied().unwrap_or(f64::NAN)
}

const GENERAL: [&str; 6] = ["gen6r_a", "manseur_doty_16", "two_parallel_6r", "baxter_left", "sawyer", "ufactory_xarm7"];

fn main() {
    if std::env::var("SPECIAL").is_ok() {
        for name in ["sawyer", "baxter_left", "ufactory_xarm7"] {
            for given in 0..7 {
                for value in [0.0, 45.0, 90.0, 180.0, -90.0, 0.001, 1e-6] {
                    let arm = Arm::of(&chain(table(name), given, f64::to_radians(value)));
                    let general = Arm::given(table(name), given, 0.0);
                    let mut lost = [0; 2];
                    let mut rng = Random(3);
                    for _ in 0..200 {
                        let joints = rng.joints();
                        if let Some(arm) = &arm {
                            lost[0] +=
                                usize::from(arm.solve(&arm.chain.pose(&joints)).distance(&arm.chain, &joints) > SAME);
                        }
                        if let Some(general) = &general {
                            let arm =
                                Arm { chain: chain(table(name), given, f64::to_radians(value)).gathered(), ..*general };
                            let x = arm.solve_anew(&arm.chain.pose(&joints));
                            let is_lost = x.distance(&arm.chain, &joints) > SAME;
                            lost[1] += usize::from(is_lost);
                            if is_lost {
                                println!(
                                    "  lost found {} evals {} candidates {} sigma {:.1e}",
                                    x.list.len(),
                                    x.evaluations,
                                    x.candidates,
                                    least_singular_value(&arm.chain, &joints)
                                );
                            }
                        }
                    }
                    println!(
                        "{name} q{} = {value}: own {:?} lost {} general {:?} lost {}",
                        given + 1,
                        arm.as_ref().map(|x| x.cuts.first.held()),
                        lost[0],
                        general.as_ref().map(|x| x.cuts.first.held()),
                        lost[1]
                    );
                }
            }
        }
        return;
    }
    let names: Vec<String> = std::env::args().skip(3).collect();
    let mut arguments = std::env::args().skip(1).take(2).map(|x| x.parse::<usize>().unwrap());
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
    for table in tables::TABLES.iter().filter(|x| names.is_empty() || names.iter().any(|name| name == x.name)) {
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
                black_box(arm.search(black_box(&target), &[0.0; 6], &mut |c| {
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
            let distance = solutions.distance(&arm.chain, &joints);
            if distance > SAME {
                lost += 1;
                println!(
                    "lost {distance:.0e} sigma {:.0e} evals {} candidates {} {joints:?}",
                    least_singular_value(&arm.chain, &joints),
                    solutions.evaluations,
                    solutions.candidates
                );
            }
        }
        println!(
            "{:20} choice {choice:.0} ms {:?}/{:?} lost {lost}/{poses} found {:.1} evals {:.0} most {most} open {open} doubts {doubts} before {:.0e} {:.0e} | us {:.1} p99 {:.0} max {:.0} search {:.1} | ratio {:.0} worst/median {:.0}",
            table.name,
            arm.cuts.first.order(),
            [arm.cuts.second, arm.cuts.third].map(|x| x.map_or(9, |x| x.held())),
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
    for table in tables::TABLES
        .iter()
        .filter(|x| GENERAL.contains(&x.name) && (names.is_empty() || names.iter().any(|name| name == x.name)))
    {
        let is_given = table.rows.len() == 7;
        let Some(arm) = (if is_given { Arm::given(table, 2, 0.7) } else { Arm::of(&chain(table, 0, 0.0)) }) else {
            continue;
        };
        let (mut regular, mut lost, mut singular, mut none, mut away, mut times, mut most, mut open) =
            (0, 0, 0, 0, 0, vec![], 0, 0);
        let mut rng = Random(99);
        for degrees in [15.0, 30.0, 45.0, 90.0] {
            let step = denhart_core::math::radians::<f64>(degrees);
            for _ in 0..poses {
                let joints: [f64; 6] = rng.joints().map(|q| (q / step).round() * step);
                let target = arm.chain.pose(&joints);
                let start = Instant::now();
                let solutions = arm.solve(&target);
                times.push(start.elapsed().as_nanos() as f64);
                most = most.max(solutions.evaluations);
                open += usize::from(!solutions.is_complete);
                let (distance, sigma) =
                    (solutions.distance(&arm.chain, &joints), least_singular_value(&arm.chain, &joints));
                if sigma < 1e-6 {
                    singular += 1;
                    none += usize::from(solutions.list.is_empty());
                    away += usize::from(distance > 1e-2);
                } else {
                    regular += 1;
                    if distance > SAME {
                        lost += 1;
                        println!(
                            "grid {degrees} lost {distance:.0e} sigma {sigma:.0e} found {} evals {} {:?}",
                            solutions.list.len(),
                            solutions.evaluations,
                            joints.map(|q| (q.to_degrees()).round())
                        );
                    }
                }
            }
        }
        println!(
            "{:20} grid: lost {lost} of {regular} regular; none {none}, away {away} of {singular} singular; most {most} open {open} us {:.0} p99 {:.0} max {:.0}",
            table.name,
            at(&mut times, 0.5) / 1e3,
            at(&mut times, 0.99) / 1e3,
            at(&mut times, 1.0) / 1e3
        );
    }
    if arms == 0 {
        return;
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
    let mut seven = (0, 0, 0, vec![]);
    for number in 0..arms / 2 {
        let rows: Vec<[f64; 4]> =
            (0..7).map(|_| [rng.within(-1.0, 1.0), rng.within(-180.0, 180.0), rng.within(-1.0, 1.0), 0.0]).collect();
        let table = tables::Table { name: "", is_modified: false, rows: Box::leak(rows.into_boxed_slice()) };
        let given = (rng.unit() * 7.0) as usize;
        let Some(arm) = Arm::given(&table, given, 0.0) else {
            seven.0 += 1;
            continue;
        };
        for _ in 0..10 {
            let arm = Arm { chain: chain(&table, given, rng.angle()).gathered(), ..arm };
            let joints = rng.joints();
            let target = arm.chain.pose(&joints);
            let start = Instant::now();
            let solutions = black_box(arm.solve_anew(black_box(&target)));
            seven.3.push(start.elapsed().as_nanos() as f64);
            seven.2 += 1;
            if solutions.distance(&arm.chain, &joints) > SAME {
                seven.1 += 1;
                println!(
                    "seven {number} lost {:.0e} sigma {:.0e}",
                    solutions.distance(&arm.chain, &joints),
                    least_singular_value(&arm.chain, &joints)
                );
            }
        }
    }
    println!(
        "{} arms of seven: no cut {} lost {} of {} us {:.1} p99 {:.0} max {:.0}",
        arms / 2,
        seven.0,
        seven.1,
        seven.2,
        at(&mut seven.3, 0.5) / 1e3,
        at(&mut seven.3, 0.99) / 1e3,
        at(&mut seven.3, 1.0) / 1e3
    );
    println!(
        "{arms} arms x 20: lost {lost} found {found} residual {worst:.0e} us {:.1} p99 {:.0} max {:.0} choice ms {:.0} max {:.0}",
        at(&mut times, 0.5) / 1e3,
        at(&mut times, 0.99) / 1e3,
        at(&mut times, 1.0) / 1e3,
        at(&mut choices, 0.5),
        at(&mut choices, 1.0)
    );
}
