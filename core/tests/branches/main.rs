//! The solvers of arms whose branches are known in closed form: `meet` and `slides`.
#![allow(clippy::unwrap_used)]

mod arms;
mod grids;
mod random;
mod rings;
mod single;
mod singular;
mod slides;
mod support;
mod truth;
