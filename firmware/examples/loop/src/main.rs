//! A control loop at 1 kHz: a path of the tool, joint values next to where the arm is, pulses of three steppers.
//!
//! The arm is the one of `specs/salman_rrr.yaml`, whose paper drives it by steppers from an Arduino. The path starts and
//! ends at home. It touches the cylinder about the first axis where the arm is singular, then the edge of the workspace,
//! then it leaves the workspace. Out of reach the arm holds its place, and the loop counts it.
//!
//! SysTick interrupts once in 80,000 instructions: 1 ms at 80 MHz, at one instruction a cycle.

#![no_std]
#![no_main]

mod moves;
mod path;
mod steppers;

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use cortex_m::{asm, interrupt};
use cortex_m_rt::exception;
use denhart::{Arm, Branch, Flags, Solution, Solutions, Status};
use firmware_board::{output, ticks};

use moves::Receiver;
use path::Part;
use steppers::Steppers;

firmware_board::report_panics!();

/// The arm, from its file.
#[derive(Arm, Clone, Copy, Debug)]
#[arm(spec = "../../../specs/salman_rrr.yaml", scalar = "f32")]
pub struct SalmanRrr;

/// Lines as they come from a terminal or from the page of `denhart view`: out, a line that a wire has spoiled, and home.
const LINES: &[u8] = b"MOVE 1067 -240 3550*29\r\nMOVE 1067 -240 9550*29\r\nMOVE 0 0 0*01\r\n";

/// Instructions of a period: 1 ms at 80 MHz.
const PERIOD: u32 = 80_000;

/// Periods that have begun.
static BEGUN: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    // One writer, the interrupt: load and store need no lock.
    BEGUN.store(BEGUN.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
}

/// The list of solutions. The loop keeps one: a list that is returned would be copied in every tick.
type Found = Solutions<f32, 3, { SalmanRrr::MAX_SOLUTIONS }>;

/// Outcome of a tick.
enum Outcome {
    /// Followed the path.
    Moved,
    /// Held its place, and why.
    Held(Status<f32>),
}

/// One tick: the target to joint values to pulses, on one branch.
///
/// At the edge and above the first axis two branches meet. The nearest solution beyond may be that of the other branch,
/// which runs into a limit later.
fn tick(target: &[f32; 3], branch: Branch, q: &mut [f32; 3], found: &mut Found, steppers: &mut Steppers) -> Outcome {
    SalmanRrr.inverse_near_into(target, q, found);
    let on_branch = |solution: &&Solution<f32, 3>| {
        solution.is_exact() && (solution.branch == branch || solution.flags.contains(Flags::BOUNDARY))
    };
    let Some(next) = found.within_limits().find(on_branch) else {
        return Outcome::Held(found.status());
    };
    *q = next.q;
    steppers.go_to(SalmanRrr.to_pulses(q));
    Outcome::Moved
}

/// Starts the interrupt.
fn start_timer() {
    if let Some(peripherals) = Peripherals::take() {
        let mut timer = peripherals.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(PERIOD / ticks::TICK - 1);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
    }
}

/// Sleeps until the next period and returns its number.
fn next_period(last: u32) -> u32 {
    loop {
        // A pending interrupt wakes the processor, though it runs only afterwards: none is missed in between.
        interrupt::free(|_| {
            if BEGUN.load(Ordering::Relaxed) == last {
                asm::wfi();
            }
        });
        let begun = BEGUN.load(Ordering::Relaxed);
        if begun != last {
            return begun;
        }
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    // Where the motors count 0.
    let home = SalmanRrr.from_pulses(&[0; 3]);
    let mut q = home;
    let mut found = SalmanRrr.inverse_near(&SalmanRrr.forward(&home).translation, &home);
    let branch = found.first().map_or(Branch::NONE, |solution| solution.branch);
    let mut steppers = Steppers::new();
    let mut worst_of_all = 0;
    let mut missed = 0;
    let mut held_where_it_should = true;
    start_timer();
    let mut last = BEGUN.load(Ordering::Relaxed);
    for part in Part::ALL {
        let (mut worst, mut held, mut gap) = (0, 0_u32, 0.0_f32);
        for step in 1..=part.ticks() {
            let target = part.target(step);
            last = next_period(last);
            let outcome = tick(&target, branch, &mut q, &mut found, &mut steppers);
            // From the beginning of the period, where the count is at its top, on; the interrupt is in it.
            let left = SYST::get_current();
            let late = BEGUN.load(Ordering::Relaxed).wrapping_sub(last);
            let elapsed = PERIOD.saturating_sub(left * ticks::TICK) + late * PERIOD;
            missed += u32::from(late > 0);
            worst = elapsed.max(worst);
            if let Outcome::Held(status) = outcome {
                held += 1;
                if let Status::Unreachable { residual } = status {
                    gap = residual.max(gap);
                }
            }
        }
        output::line(format_args!(
            "{:<50} {:>4} ticks, worst {worst:>6} instructions, held {held:>3}",
            part.name(),
            part.ticks(),
        ));
        if held > 0 {
            output::line(format_args!(
                "  out of reach, by up to {gap:.3} mm as a stage counts: the motors stood still"
            ));
        }
        held_where_it_should &= (held > 0) == part.leaves_the_workspace();
        worst_of_all = worst.max(worst_of_all);
        last = BEGUN.load(Ordering::Relaxed);
    }
    let counts = steppers.counts();
    output::line(format_args!("pulses at the end {counts:?}, most in a tick {:?}", steppers.most_in_a_tick()));
    output::line(format_args!(
        "worst tick {worst_of_all} of {PERIOD} instructions; missed deadlines at 80 MHz, one instruction a cycle: {missed}"
    ));
    let mut receiver = Receiver::new();
    let mut moves = 0;
    for counts in LINES.iter().filter_map(|byte| receiver.take(*byte)) {
        steppers.go_to(counts);
        moves += 1;
    }
    output::line(format_args!("lines received: {moves} moves, of 3 lines"));
    output::exit(missed == 0 && moves == 2 && held_where_it_should && counts == [0; 3] && steppers.counts() == [0; 3])
}
