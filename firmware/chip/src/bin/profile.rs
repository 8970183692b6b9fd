//! Calls one function on random cases; `firmware/profile.sh` traces it.

#![no_std]
#![no_main]

use core::hint::black_box;

use firmware_board::output;
use firmware_cases::{Family, Maker};

firmware_board::report_panics!();

/// As `PROFILED` in `firmware-host`.
const CASES: usize = 100;

macro_rules! profile {
    ($arm:ident, $scalar:ident) => {{
        use firmware_arms::$arm::Robot;
        let mut maker = Maker::new(1);
        for _ in 0..CASES {
            let case = maker.case::<Robot, $scalar, { Robot::DOF }>(&Robot, Family::Random);
            firmware_chip::calls!(firmware_arms::$arm::call, black_box(&case));
        }
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    firmware_chip::chosen!(profile);
    output::exit(true)
}
