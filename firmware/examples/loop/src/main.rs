//! A control loop at 1 kHz: a path of the tool, followed within the rates of the motors, pulses of three steppers.
//!
//! The arm is the one of `specs/salman_rrr.yaml`, whose paper drives it by steppers from an Arduino. The path starts and
//! ends at home. It touches the cylinder about the first axis where the arm is singular, passes beside it, touches the
//! edge of the workspace, then leaves the workspace. The loop counts the ticks that are exact, and those that are not by
//! their reason.
//!
//! SysTick interrupts once in 80,000 instructions: 1 ms at 80 MHz, at one instruction a cycle.

#![no_std]
#![no_main]

mod moves;
mod path;
mod steppers;
mod tally;

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use cortex_m::{asm, interrupt};
use cortex_m_rt::exception;
use denhart::follow::{FollowSettings, Follower, Rates};
use denhart::{Arm, Solutions, Status};
use firmware_board::{output, ticks};

use moves::Receiver;
use path::Part;
use steppers::Steppers;
use tally::Tally;

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

/// Pulses that a driver makes in a second, at most: 10 in a tick.
const PULSES: i32 = 10_000;
const PULSES_OF_A_TICK: u32 = 10;

/// The rates of the motors, which reach full speed in an eighth of a second. The arm's file has none.
fn rates(home: &[f32; 3]) -> Rates<f32, 3> {
    let mut velocity = SalmanRrr.from_pulses(&[PULSES; 3]);
    for (velocity, home) in velocity.iter_mut().zip(home) {
        *velocity = (*velocity - home).abs();
    }
    Rates { velocity, acceleration: velocity.map(|velocity| 8.0 * velocity) }
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
    let settings = FollowSettings::new(1e-3, rates(&home));
    let mut follower = match Follower::new(&SalmanRrr, settings, &home) {
        Ok(follower) => follower,
        Err(error) => {
            output::line(format_args!("{error}"));
            output::exit(false)
        }
    };
    let mut found = Found::new(Status::BadTarget);
    let mut steppers = Steppers::new();
    let mut all = Tally::new();
    let mut worst_of_all = 0;
    let mut missed = 0;
    let mut as_it_should = true;
    start_timer();
    let mut last = BEGUN.load(Ordering::Relaxed);
    for part in Part::ALL {
        let mut tally = Tally::new();
        let mut worst = 0;
        for step in 1..=part.ticks() {
            let target = part.target(step);
            last = next_period(last);
            let step = follower.step(&SalmanRrr, &target, &mut found);
            steppers.go_to(SalmanRrr.to_pulses(&step.q));
            // From the beginning of the period, where the count is at its top, on; the interrupt is in it.
            let left = SYST::get_current();
            let late = BEGUN.load(Ordering::Relaxed).wrapping_sub(last);
            let elapsed = PERIOD.saturating_sub(left * ticks::TICK) + late * PERIOD;
            missed += u32::from(late > 0);
            worst = elapsed.max(worst);
            tally.note(&step);
        }
        output::line(format_args!("{:<50} worst {worst:>6} instructions, {tally}", part.name()));
        as_it_should &= part.expects(&tally);
        worst_of_all = worst.max(worst_of_all);
        all.add(&tally);
        last = BEGUN.load(Ordering::Relaxed);
    }
    let counts = steppers.counts();
    let most = steppers.most_in_a_tick();
    output::line(format_args!("in all: {all}"));
    output::line(format_args!("pulses at the end {counts:?}, most in a tick {most:?}"));
    output::line(format_args!(
        "worst tick {worst_of_all} of {PERIOD} instructions; missed deadlines at 80 MHz, one instruction a cycle: {missed}"
    ));
    // The counts of a tick are rounded, each by half a pulse at most.
    as_it_should &= most.iter().all(|most| *most <= PULSES_OF_A_TICK + 1);
    let mut receiver = Receiver::new();
    let mut moves = 0;
    for counts in LINES.iter().filter_map(|byte| receiver.take(*byte)) {
        steppers.go_to(counts);
        moves += 1;
    }
    output::line(format_args!("lines received: {moves} moves, of 3 lines"));
    output::exit(missed == 0 && moves == 2 && as_it_should && counts == [0; 3] && steppers.counts() == [0; 3])
}
