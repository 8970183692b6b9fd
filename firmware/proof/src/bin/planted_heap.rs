//! A planted allocation: this must not build.

#![no_std]
#![no_main]

extern crate alloc;

use core::hint::black_box;

firmware_board::no_panic!();

#[firmware_board::entry]
fn main() -> ! {
    black_box(alloc::boxed::Box::new(black_box(1.0_f32)));
    loop {
        core::hint::spin_loop();
    }
}
