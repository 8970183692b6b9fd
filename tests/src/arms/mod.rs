//! Every arm that is tested: lists of them, to make one test an arm, and the arms themselves.
//!
//! Some hundred arms take a while to compile. The benchmarks do without them, see the feature `arms`.

mod meeting;
mod mounted;
mod parallel;
mod published;
mod single;
mod sliding;
mod sliding_parallel;

#[cfg(feature = "arms")]
mod derived;
#[cfg(feature = "arms")]
pub use derived::*;
