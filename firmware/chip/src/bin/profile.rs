//! Calls one function on random cases; `firmware/profile.sh` traces it.

#![no_std]
#![no_main]

use core::hint::black_box;

use firmware_board::output;
use firmware_cases::{Family, Maker};

firmware_board::report_panics!();

/// As `PROFILED` in `firmware-host`.
const CASES: usize = 100;

macro_rules! calls {
    ($arm:ident, $scalar:ident) => {{
        #[allow(unused_imports)]
        use firmware_arms::$arm::{Robot, call};
        let mut maker = Maker::new(1);
        for _ in 0..CASES {
            let case = maker.case::<Robot, $scalar, { Robot::DOF }>(&Robot, Family::Random);
            let case = black_box(&case);
            let _ = case;
            #[cfg(feature = "forward")]
            call::forward(case);
            #[cfg(feature = "forward_and_jacobian")]
            call::forward_and_jacobian(case);
            #[cfg(feature = "inverse")]
            call::inverse(case);
            #[cfg(feature = "inverse_near")]
            call::inverse_near(case);
            #[cfg(feature = "inverse_branch")]
            call::inverse_branch(case);
        }
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    firmware_chip::chosen!(calls);
    output::exit(true)
}
