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
