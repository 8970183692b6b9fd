//! Instructions, counted by the SysTick timer.

use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};

/// Instructions of a tick.
pub const TICK: u32 = 40;

/// Starts the timer. The second call does nothing.
pub fn start() {
    if let Some(peripherals) = Peripherals::take() {
        let mut timer = peripherals.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0xff_ffff);
        timer.clear_current();
        timer.enable_counter();
    }
}

/// Ticks that `work` takes, at most 2^24 (671,088,640 instructions).
#[inline(never)]
pub fn of(work: &mut dyn FnMut()) -> u32 {
    let start = SYST::get_current();
    work();
    let end = SYST::get_current();
    start.wrapping_sub(end) & 0xff_ffff
}
