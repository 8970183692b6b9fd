//! The crate's `src/lib.rs`: the generated functions for C.
//!
//! It is the only code with `unsafe`: what reads and writes through a pointer, and where that is called.

mod functions;
mod memory;
mod types;

use super::arm::Arm;

/// The text of the file.
pub fn text(arm: &Arm<'_>) -> String {
    arm.fill(&[types::text(arm), functions::text(arm), memory::text(arm)].concat())
}
