//! Instructions and stack of the functions of one arm, by family of cases, one line a function and family:
//! `MEASURED function family median p99 worst stack`.

#![no_std]
#![no_main]

use core::hint::black_box;

use firmware_board::{output, stack, ticks};
use firmware_cases::{Family, Maker};

firmware_board::report_panics!();

/// Cases of a family.
const CASES: [(Family, usize); 6] = [
    (Family::Random, 300),
    (Family::Grid, 150),
    (Family::Singular, 200),
    (Family::OutOfReach, 60),
    (Family::Drifted, 60),
    (Family::Absurd, 150),
];
/// Calls that are timed as one, where one takes few ticks.
const TOGETHER: u32 = 20;
const FEW: u32 = 250;

/// Instructions of a call: a tick is 40, so short calls are made several times.
fn instructions(call: &mut dyn FnMut()) -> u32 {
    let once = ticks::of(call);
    if once > FEW {
        return once * ticks::TICK;
    }
    ticks::of(&mut || {
        for _ in 0..TOGETHER {
            call();
        }
    }) * ticks::TICK
        / TOGETHER
}

/// Sorted instructions at a share of the list, `of` 100.
fn at(sorted: &[u32], of_hundred: usize) -> u32 {
    sorted.get((sorted.len() * of_hundred / 100).min(sorted.len().saturating_sub(1))).copied().unwrap_or(0)
}

/// A call that does nothing: what it takes is taken off the others.
#[inline(never)]
fn nothing<C>(case: &C) {
    black_box(case);
}

macro_rules! measure {
    ($arm:ident, $scalar:ident) => {{
        use firmware_arms::$arm::{Case, Robot, call};
        let mut kept = call::kept();
        let mut into = |case: &Case| call::inverse_into(case, &mut kept);
        let functions: [(&str, &mut dyn FnMut(&Case)); 6] = [
            ("forward", &mut |case| call::forward(case)),
            ("forward_and_jacobian", &mut |case| call::forward_and_jacobian(case)),
            ("inverse", &mut |case| call::inverse(case)),
            ("inverse_into", &mut into),
            ("inverse_near", &mut |case| call::inverse_near(case)),
            ("inverse_branch", &mut |case| call::inverse_branch(case)),
        ];
        for (name, function) in functions {
            // The cases are made anew for each function: only one function's numbers are in memory.
            let mut maker = Maker::new(1);
            for (family, count) in CASES {
                let mut list = [0; 300];
                let mut deepest = 0;
                for place in list.iter_mut().take(count) {
                    let case = maker.case::<Robot, $scalar, { Robot::DOF }>(&Robot, family);
                    let empty: &mut dyn FnMut(&Case) = &mut |case| nothing(case);
                    let (case, function, empty) = (black_box(&case), black_box(&mut *function), black_box(empty));
                    let idle = instructions(&mut || empty(case));
                    *place = instructions(&mut || function(case)).saturating_sub(idle);
                    let idle = stack::of(&mut || empty(case));
                    deepest = deepest.max(stack::of(&mut || function(case)).saturating_sub(idle));
                }
                let list = list.get_mut(..count).unwrap_or_default();
                list.sort_unstable();
                let (median, most, worst) = (at(list, 50), at(list, 99), at(list, 100));
                output::line(format_args!("MEASURED {name} {} {median} {most} {worst} {deepest}", family.name()));
            }
        }
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    ticks::start();
    firmware_chip::chosen!(measure);
    output::exit(true)
}
