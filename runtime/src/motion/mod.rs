//! Motion from the geometric Jacobian alone: velocities, accelerations and the Jacobian's derivative.
//!
//! Column `j` of the Jacobian is `(v_j, w_j)`. `w_j` is the axis of joint `j` (zero for a prismatic joint). `v_j` is
//! the velocity that joint `j` gives the tool point (the axis itself for a prismatic joint). Joint `j` moves everything
//! behind it as one rigid body, with the angular velocity `w_j` (none if prismatic) per unit rate. So, for every kind
//! of joint,
//!
//! ```text
//! d v_i / d q_j = w_j x v_i    d w_i / d q_j = w_j x w_i    j <= i   axis i and the tool point are both behind joint j
//! d v_i / d q_j = w_i x v_j    d w_i / d q_j = 0            j >  i   the tool point alone is
//! ```
//!
//! For revolute joints these derivatives are the Hessians of Haviland and Corke 2020, section IV. Source: "A systematic
//! approach to computing the manipulator Jacobian and Hessian using the elementary transform sequence". A prismatic
//! joint needs no case of its own: its `w` is zero, and its `v` turns with the joints before it. Multiplied by the
//! joint rates and summed over `j`, the products collect in two running sums. So the cost grows with `N` and not with
//! its square.

mod link;
mod methods;
mod tool;
mod twist;

#[cfg(all(feature = "nalgebra", feature = "std"))]
pub(crate) use tool::{Joint, acceleration, derivative, velocity};
pub use twist::{Acceleration, Twist};
#[cfg(test)]
mod tests;
