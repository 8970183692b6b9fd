//! Harness of the whole-arm tests and benchmarks: the arms, families of joint vectors, and the rules that every pose
//! has to pass.
//!
//! Poses and residuals come from [`denhart::Chain`], which shares no code with the generator. Everything random is
//! seeded by the name of the arm, so that a failure comes back at every run.

pub mod arms;
pub mod bad_targets;
pub mod boundary;
pub mod branches;
pub mod effort;
pub mod evaluated;
pub mod follow;
pub mod inverse;
pub mod poses;
pub mod random;
pub mod recover;
pub mod reference;
pub mod report;
pub mod series;
pub mod singular;
pub mod subject;
pub mod suite;
pub mod sweep;
pub mod task;
pub mod timing;
