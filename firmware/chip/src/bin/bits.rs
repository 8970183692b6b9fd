//! Prints digests of the results of every function of every arm: see `firmware_host::bits`, which prints the same.

#![no_std]
#![no_main]

use core::fmt::Write;

use firmware_board::output::{self, Output};
use firmware_cases::digests;

firmware_board::report_panics!();

#[firmware_board::entry]
fn main() -> ! {
    let mut output = Output::new();
    macro_rules! print {
        ($arm:ident, $scalar:ident) => {
            digests::<firmware_arms::$arm::Robot, $scalar, { firmware_arms::$arm::Robot::DOF }>(&mut |text| {
                let _ = output.write_fmt(text);
            });
        };
    }
    firmware_chip::chosen!(print);
    output.flush();
    output::exit(true)
}
