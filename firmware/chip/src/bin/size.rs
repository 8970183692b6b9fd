//! A program that calls the chosen functions of the chosen arms and nothing else: its flash is that of the functions.
//! It has no path to a panic, or it does not link.

#![no_std]
#![no_main]

use core::hint::black_box;

firmware_board::no_panic!();

macro_rules! calls {
    ($arm:ident, $scalar:ident) => {{
        #[allow(unused_imports)]
        use firmware_arms::$arm::{Case, call};
        let case: &Case = black_box(&Case::BLANK);
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
    }};
}

#[firmware_board::entry]
fn main() -> ! {
    firmware_chip::chosen!(calls);
    loop {
        core::hint::spin_loop();
    }
}
