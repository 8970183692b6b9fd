//! Every function of every arm in f64. This links only without a path to a panic.

#![no_std]
#![no_main]

use core::hint::black_box;

mod arms {
    include!(concat!(env!("OUT_DIR"), "/f64.rs"));
}

firmware_board::no_panic!();

#[firmware_board::entry]
fn main() -> ! {
    include!(concat!(env!("OUT_DIR"), "/f64_calls.rs"));
    loop {
        core::hint::spin_loop();
    }
}
