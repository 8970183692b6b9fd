//! The functions that the page calls, in WebAssembly.
//!
//! Text goes in, text or JSON comes out; what is called while a slider or the target moves takes and gives numbers. The numbers of
//! a call are laid out by [`numbers`] and read by `page/src/numbers.ts`.
//!
//! Angles are rad, lengths in the unit of the arm file. Poses are twelve numbers: the rotation by rows, then the point.

mod arm;
mod facts;
mod follow;
mod numbers;
mod picture;
mod text;
