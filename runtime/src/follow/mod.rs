//! Following a path: every tick within the motors' limits, exact wherever they allow, and saying so where not.
//!
//! [`InverseKinematics::inverse_near`](crate::InverseKinematics::inverse_near) gives the exact joint values of each tick.
//! Beside a singular pose they swing faster than motors can. A follower keeps every joint within its velocity, its
//! acceleration and its range. There are two, for two jobs that no one method serves:
//!
//! | | keeps | gives up, where the limits ask for it |
//! |---|---|---|
//! | [`Follower`] | the time | the target: it deviates, and says by how much |
//! | [`PathFollower`] | the path | the time: it slows down |
//!
//! Neither allocates. Where a [`Follower`] is exact, a call takes the inverse of one branch. [`Follower::step`] states the
//! longest call.
//!
//! ```
//! # fn main() {}
//! use denhart::InverseKinematics;
//! use denhart::follow::{FollowError, FollowSettings, Follower, Rates};
//!
//! /// One second of a control loop of 1 kHz.
//! fn follow<A: InverseKinematics<f64, 6>>(
//!     arm: &A,
//!     q: &[f64; 6],
//!     target: impl Fn(f64) -> A::Target,
//!     send: impl Fn(&[f64; 6]),
//! ) -> Result<(), FollowError> {
//!     let rates = Rates { velocity: [3.0; 6], acceleration: [20.0; 6] };
//!     let mut follower = Follower::new(arm, FollowSettings::new(0.001, rates), q)?;
//!     let mut found = A::Solutions::default();
//!     for tick in 1..=1000 {
//!         // To a target that is none the step brakes.
//!         let step = follower.step(arm, &target(f64::from(tick) * 0.001), &mut found);
//!         send(&step.q);
//!     }
//!     Ok(())
//! }
//! ```

mod advance;
mod aspect;
mod bounds;
mod brake;
mod choice;
mod deviate;
mod follower;
mod least_squares;
mod linear;
mod path;
mod settings;
mod signs;
mod step;

pub use advance::{Advance, Progress};
pub use follower::Follower;
pub use linear::{product, slopes};
pub use path::PathFollower;
pub use settings::{Crossing, FollowError, FollowSettings, Rates};
pub use step::{Step, Tracking};
