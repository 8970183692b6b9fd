//! Instructions and stack of a follower's ticks, as `measure` prints them: `MEASURED follower family median p99 worst stack`,
//! with the families `exact` and `deviating`.
//!
//! Exact ticks are those of a line along which all are exact; deviating ones those of the other lines that are not.

#![no_std]
#![no_main]

use core::hint::black_box;

use firmware_board::{output, stack, ticks};
use firmware_cases::{Followed, Line};

firmware_board::report_panics!();

/// The most ticks of a family that are kept.
const MOST: usize = 4000;

/// Instructions of the ticks of a family.
struct Ticks {
    list: [u32; MOST],
    count: usize,
    deepest: usize,
}

impl Ticks {
    const fn new() -> Self {
        Self { list: [0; MOST], count: 0, deepest: 0 }
    }

    fn note(&mut self, instructions: u32, stack: usize) {
        if let Some(place) = self.list.get_mut(self.count) {
            *place = instructions;
            self.count += 1;
        }
        self.deepest = self.deepest.max(stack);
    }

    /// Prints the line of the family; false if there are too few ticks for a 99th percentile, or too many.
    fn print(&mut self, family: &str) -> bool {
        let list = self.list.get_mut(..self.count).unwrap_or_default();
        list.sort_unstable();
        let at = |of_hundred: usize| {
            list.get((list.len() * of_hundred / 100).min(list.len().saturating_sub(1))).copied().unwrap_or(0)
        };
        let (median, most, worst) = (at(50), at(99), at(100));
        output::line(format_args!("MEASURED follower {family} {median} {most} {worst} {}", self.deepest));
        self.count >= 100 && self.count < MOST
    }
}

macro_rules! follow {
    ($arm:ident, $scalar:ident) => {{
        use denhart::follow::Tracking;
        use firmware_arms::$arm::{Robot, call};
        use firmware_cases::Subject;

        const DOF: usize = Robot::DOF;
        let name = <Robot as Subject<$scalar, DOF>>::NAME;
        let Some(followed) = Followed::of(name) else {
            output::line(format_args!("{name} has no lines"));
            output::exit(false)
        };
        let mut kept = call::kept();
        let mut run = |line: &Line, note: &mut dyn FnMut(Tracking, u32, usize)| {
            let settings: call::FollowSettings = followed.settings(line);
            let start: [$scalar; DOF] = line.start(&Robot);
            let Ok(mut follower) = call::Follower::new(&Robot, settings, &start) else {
                output::line(format_args!("{name} does not start"));
                output::exit(false)
            };
            for tick in 1..=line.ticks() {
                let target = line.target(&Robot, f64::from(tick) / f64::from(line.ticks()));
                let mut tracking = Tracking::Target;
                // The stack of a copy's tick: painting takes instructions.
                let mut copy = follower;
                let idle = stack::of(black_box(&mut || {
                    black_box(&target);
                }));
                let depth = stack::of(black_box(&mut || {
                    call::follower_step(&mut copy, &target, &mut kept);
                }));
                let idle_ticks = ticks::of(black_box(&mut || {
                    black_box(&target);
                }));
                let taken =
                    ticks::of(black_box(&mut || tracking = call::follower_step(&mut follower, &target, &mut kept)));
                note(tracking, taken.saturating_sub(idle_ticks) * ticks::TICK, depth.saturating_sub(idle));
            }
        };
        let mut well = true;
        let mut family = Ticks::new();
        run(&followed.exact, &mut |tracking, instructions, stack| {
            family.note(instructions, stack);
            well &= tracking.is_exact();
        });
        well &= family.print("exact");
        let mut family = Ticks::new();
        for line in followed.past {
            run(line, &mut |tracking, instructions, stack| {
                if !tracking.is_exact() {
                    family.note(instructions, stack);
                }
            });
        }
        well &= family.print("deviating");
        output::exit(well)
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    ticks::start();
    firmware_chip::chosen!(follow);
    #[allow(unreachable_code, reason = "without an arm")]
    output::exit(true)
}
