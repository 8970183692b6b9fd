//! A program that calls the chosen functions of the chosen arms and nothing else: its flash is that of the functions.
//! It has no path to a panic, or it does not link.

#![no_std]
#![no_main]

use core::hint::black_box;

firmware_board::no_panic!();

macro_rules! size {
    ($arm:ident, $scalar:ident) => {{
        use firmware_arms::$arm::Case;
        let case: &Case = black_box(&Case::BLANK);
        firmware_chip::calls!(firmware_arms::$arm::call, case);
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    firmware_chip::chosen!(size);
    loop {
        core::hint::spin_loop();
    }
}
