//! Inverse kinematics by iteration, for any arm with any number of joints.
//!
//! [`NumericInverse`] walks from a start to one joint vector that reaches the target, by way of the arm's
//! `forward_and_jacobian`. The iteration serves where there is no closed form, and where the arm has more or fewer than
//! six joints. It also serves where limits are to be kept on the way. Where there is a closed form, that finds every
//! branch, and faster.
//!
//! # Method
//! The error `e` of the tool is a twist in the base frame ([`Pose::error_to`](crate::Pose::error_to)). Lengths
//! in it are divided by the [`length`](NumericInverse::length) of the arm. A step `dq` minimizes `|J dq - e|^2 + lambda |dq|^2`: damped least
//! squares (Nakamura and Hanafusa 1986, "Inverse kinematic solutions with singularity robustness", J. Dyn. Syst. Meas.
//! Control 108; Wampler 1986, IEEE Trans. SMC 16). `lambda` is in proportion to the squared error (Chan and Lawrence
//! 1988, "General inverse kinematics with the error damped pseudoinverse", ICRA; Sugihara 2011,
//! "Solvability-unconcerned inverse kinematics by the Levenberg-Marquardt method", IEEE Trans. Robotics 27(5)). Far
//! from the target the steps are then bounded, also for targets out of reach; close to it they converge like Newton's.
//! As in those papers a step is taken even if it increases the error for a while. That escapes more local minima than a descent in
//! every step does.
//!
//! Where the error stays above the least one seen, damping fades by a factor of ten a step. It fades until Newton's
//! steps, of which the cap bounds the length, leave the local minimum (the Jacobian is singular there). Then it starts
//! anew. If in the end nothing converged, the iterations that are left descend from the closest iterate (Marquardt
//! 1963, J. SIAM 11(2)).
//!
//! [`Method::NewtonRaphson`] has only the damping that rounding requires: the pseudoinverse (Whitney 1969; for six joints
//! the inverse), with capped steps.
//!
//! For up to six joints the step solves the normal equations `(J^T J + lambda I) dq = J^T e`. For more joints it solves
//! `(J J^T + lambda I) y = e, dq = J^T y`. Either system is symmetric, of at most 6 x 6. Both square the singular values:
//! those below 1e-8 of the largest (f32: 3e-4) count as zero. Damping never falls below rounding, so that no step
//! divides by zero.
//!
//! # Targets out of reach
//! The closed form says that a target is out of reach, and by how much one of its equations is missed at least. The
//! distance, and where the arm comes closest, are found by iteration from the joint values where the arm is:
//!
//! ```
//! use denhart::numeric::NumericInverse;
//! use denhart::{Arm, Pose, Residual};
//!
//! /// Where the arm comes closest to a target out of reach, and what is left in position and orientation.
//! fn closest<A: Arm<f64, N>, const N: usize>(arm: &A, target: &Pose<f64>, q: &[f64; N]) -> ([f64; N], Residual<f64>) {
//!     let closest = NumericInverse::new().max_iterations(300).solve(arm, target, q);
//!     (closest.q, closest.residual)
//! }
//! ```
//!
//! The closest configuration is a local minimum of the error, lengths over the [`length`](NumericInverse::length), within
//! the limits. There the iteration ends as [`Stop::Stalled`]. After [`Stop::IterationBound`] more iterations may come
//! closer. Other starts may lead to other minima. With [`NumericInverse::task`] only a position, or a
//! position and one axis, counts.
//!
//! # Limits
//! Joints stay within the arm's limits at every iterate. A joint at its limit that the error pushes outward is held for
//! the step. The others solve the rest (Bertsekas 1982, "Projected Newton methods", SIAM J. Control Optim. 20(2)). A
//! revolute joint that leaves its range comes back in by a whole turn if the range has room for one. Limits of sums of
//! joints are not kept.
//!
//! # Redundancy
//! [`NumericInverse::solve_towards`] moves along the null space towards a preferred posture,
//! `dq = J# e + (I - J# J) gain (posture - q)` (Liegeois 1977, IEEE Trans. SMC 7).

mod descent;
mod limits;
mod linear;
pub(crate) mod model;
mod report;
mod settings;
mod starts;
mod step;
mod task;

pub use report::{NumericSolution, Stop};
pub use settings::{Method, NumericInverse};
pub use task::Task;
#[cfg(all(feature = "nalgebra", feature = "std"))]
pub(crate) use {descent::run, model::Model};

#[cfg(test)]
mod tests;
