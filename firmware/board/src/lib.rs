//! The emulated board: output, instructions counted, stack painted.
//!
//! QEMU's mps2-an386 with `-icount shift=0` executes one instruction in one nanosecond of its own time. SysTick runs at
//! 25 MHz there, so one tick is 40 instructions.

#![no_std]

pub mod output;
pub mod stack;
pub mod ticks;

pub use cortex_m_rt::entry;
pub use cortex_m_semihosting;

/// A panic handler that does not link: it calls a function which is defined nowhere. A program that links with it has no
/// path to a panic.
#[macro_export]
macro_rules! no_panic {
    () => {
        #[panic_handler]
        fn panic(_: &::core::panic::PanicInfo<'_>) -> ! {
            unsafe extern "C" {
                fn a_panic_path_is_left() -> !;
            }
            // SAFETY: no program with this call links.
            unsafe { a_panic_path_is_left() }
        }
    };
}

/// A panic handler that prints the message and ends the emulation with a failure: for programs that measure.
#[macro_export]
macro_rules! report_panics {
    () => {
        #[panic_handler]
        fn panic(info: &::core::panic::PanicInfo<'_>) -> ! {
            $crate::output::line(::core::format_args!("PANIC {info}"));
            $crate::output::exit(false)
        }
    };
}
