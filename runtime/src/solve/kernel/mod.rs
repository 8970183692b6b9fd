//! Kernels: one scalar equation, or two equations in two joints, solved in closed form.
//!
//! A kernel returns the [`Roots`](roots::Roots) of its equation with the doubt in them. No file here knows the search.

pub(super) mod aim;
pub(super) mod align;
pub(super) mod branch_state;
pub(super) mod circle;
pub(super) mod cone;
pub(super) mod curve;
pub(super) mod distance;
pub(super) mod doubt;
#[cfg(feature = "batch")]
pub(super) mod lanes;
pub(super) mod offset;
pub(super) mod offset_of_two;
pub(super) mod pair;
pub(super) mod pair_sliding;
pub(super) mod roots;
pub(super) mod separated;
pub(super) mod slide;
pub(super) mod slide_turning;
pub(super) mod steps;
pub(super) mod swivel;
pub(super) mod tolerances;
pub(super) mod turn;
pub(super) mod twins;
pub(super) mod wrist;
