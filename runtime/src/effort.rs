//! Effort of a call of the inverse, counted for tests.
//!
//! A *cascade* is one run of an arm's nest of stages; an *evaluation* is one `forward_and_jacobian` that verifies a
//! solution. Every call of `inverse`, `inverse_near` and `inverse_branch` takes at most [`MOST_CASCADES`] and
//! [`MOST_EVALUATIONS`], for any arguments; with a joint held at most [`MOST_HELD_JOINT_EVALUATIONS`]. The feature
//! `count` counts them for each thread; without it counting costs nothing.

/// The most runs of the nest in one call.
pub const MOST_CASCADES: usize = 12;

/// The most evaluations of `forward_and_jacobian` in one call.
pub const MOST_EVALUATIONS: usize = 200;

/// The most places of a held joint at which its polynomial is sampled, and the most of its roots that are followed.
pub use denhart_core::held_joint::{MOST_CANDIDATES, MOST_PLACES};

/// The most evaluations of `forward_and_jacobian` in one call of an inverse that holds a joint, also where the stages of a
/// measured arm's table give starts.
pub const MOST_HELD_JOINT_EVALUATIONS: usize = 300;

#[cfg(feature = "count")]
mod counted {
    extern crate std;

    use core::cell::Cell;

    /// Number of cascades and evaluations of a call.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub struct Effort {
        /// Runs of the nest of stages.
        pub cascades: usize,
        /// Evaluations of `forward_and_jacobian`.
        pub evaluations: usize,
        /// True if a joint was held: the bound is [`MOST_HELD_JOINT_EVALUATIONS`](super::MOST_HELD_JOINT_EVALUATIONS).
        pub holds_a_joint: bool,
    }

    std::thread_local! {
        static EFFORT: Cell<Effort> = const { Cell::new(Effort { cascades: 0, evaluations: 0, holds_a_joint: false }) };
    }

    pub(crate) fn cascade() {
        EFFORT.with(|effort| effort.set(Effort { cascades: effort.get().cascades + 1, ..effort.get() }));
    }

    pub(crate) fn holding_a_joint() {
        EFFORT.with(|effort| effort.set(Effort { holds_a_joint: true, ..effort.get() }));
    }

    /// Counts an evaluation, for types that implement `Evaluate` themselves.
    pub fn evaluation() {
        EFFORT.with(|effort| effort.set(Effort { evaluations: effort.get().evaluations + 1, ..effort.get() }));
    }

    /// The result of `call`, and what the calls of inverse kinematics in it cost on this thread.
    pub fn effort_of<R>(call: impl FnOnce() -> R) -> (R, Effort) {
        EFFORT.set(Effort::default());
        let result = call();
        (result, EFFORT.get())
    }
}

#[cfg(feature = "count")]
#[doc(hidden)]
pub use counted::evaluation;
#[cfg(feature = "count")]
pub use counted::{Effort, effort_of};
#[cfg(feature = "count")]
pub(crate) use counted::{cascade, holding_a_joint};

#[cfg(not(feature = "count"))]
#[inline(always)]
pub(crate) fn cascade() {}

#[cfg(not(feature = "count"))]
#[inline(always)]
pub(crate) fn holding_a_joint() {}

#[cfg(not(feature = "count"))]
#[doc(hidden)]
#[inline(always)]
pub fn evaluation() {}
