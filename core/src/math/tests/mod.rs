//! Tests of the scalar functions against references of twice the precision.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::excessive_precision, clippy::approx_constant)]

mod angle_of_unit_vector;
mod angle_of_vector;
mod bits;
mod double_double;
mod hard_cases;
#[cfg(feature = "batch")]
mod lanes;
mod random;
mod roots_and_wrap;
mod sine_cosine;
