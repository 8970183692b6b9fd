//! Six turning joints of which two neighboring axes meet and two neighboring axes are parallel.
//!
//! # The ring
//! A chain with its target closes to a ring. For these arms the ring reads, with the joints in cyclic order,
//! ```text
//! Rz(x1) K1 Rz(x2) K2 Rz(x3) K3 Rz(x4) K4 Rz(u) K5 Rz(v) K6 = 1      x3 parallel to x4, u meets v in W
//! ```
//! Commercial six-joint arms with an offset wrist are of this kind. Their joints 6, 1, 2, 3, 4, 5 are x1 to v, and K1
//! holds the target. [`Structure`] finds the ring of a chain.
//!
//! # The equation
//! Joint x1 is held at an angle t. Then W is known as seen from before x2. Its component along the parallel axes fixes
//! x2 up to the sign of a root v, its distance from the axis of x3 fixes x4 up to the sign of a root w. Each of the four
//! branches misses the angle between the axes of u and v by g(t). The product of the four g, cleared of its
//! denominators, is a trigonometric polynomial of degree 8 in t. It has no roots v and w any more, so it is a polynomial
//! where branches are imaginary, too.
//!
//! [`Meet`] holds the constants. [`Meet::search`] of `f64` samples the polynomial, takes its real roots and streams a
//! candidate for each branch that closes there. [`Meet::search`] of `f32` looks for the roots of each branch by itself:
//! a product of four has too few digits in `f32`.
//!
//! For one t, with the constants as [`Meet`] names them:
//! ```text
//! p = K1^-1 Rz(-t) point                   W as seen from before x2
//! n = K1^-1 Rz(-t) normal                  direction of v as seen from before x2
//! rho2 = p_x^2 + p_y^2
//! u = (height - h_z p_z) / eta             component of W, turned by x2, along H
//! v^2 = rho2 - u^2                         the same along ex
//! V = (v - across_x, eta p_z - h_z u - across_y)               W from the axis of x3, along ex and ey
//! S = |V|^2     w^2 = (2 a y)^2 - (S - a^2 - y^2)^2            a = upper, y = lower
//! E = Q (V_x + i V_y) (S + y^2 - a^2 + i w) / (2 S)            direction of u across h, Q = ratio_x + i ratio_y
//! N_1 = (l v + m u) / rho2     N_2 = (l u - m v) / rho2        direction of v, turned by x2, along ex and H
//! l = n_x p_x + n_y p_y        m = p_x n_y - p_y n_x
//! g = E_x N_1 + E_y (eta n_z - h_z N_2) + tilt (eta N_2 + h_z n_z) - cos_alpha
//! ```
//! `rho2 S g = first + w second`, each a number `even + odd v`. The product over both signs of w and then of v has no
//! root any more; divided by `rho2^2 S(v) S(-v)` it has degree 8.
//!
//! # Special targets
//! - All four branches meet where v and w vanish. Such roots are of order two to eight, and the polynomial knows them
//!   badly. Their neighborhood is looked at branch by branch.
//! - W on the axis of x2: x2 follows from the angle between u and v, or is free. W on the axis of x3: the same for x3.
//! - A polynomial that is zero everywhere: the held joint is free. Joint 6 on the axis of joint 1 is an example.

mod axis;
mod branch;
mod constants;
mod joints;
mod search;
mod structure;
#[cfg(test)]
mod tests;

pub use constants::Meet;
pub use structure::Structure;
