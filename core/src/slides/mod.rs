//! Six joints of which two are prismatic.
//!
//! # The equation
//! One of the four turning joints is held at an angle t. The ring of the chain and its target reads, from the held joint
//! on and with each prismatic joint drawn into the link in which it slides,
//! ```text
//! Rz(t) T0 Rz(x) T1 Rz(y) T2 Rz(z) T3 = 1      with T = (A, tau)
//! ```
//! Its rotation gives the three other turning joints: `Rz(x) A1 Rz(y) A2 Rz(z) = M(t) = A0^-1 Rz(-t) A3^-1`. The entry M_zz
//! fixes y up to the sign of a root w, the last column x and the last row z:
//! ```text
//! alpha cos y + beta sin y = level      n = alpha^2 + beta^2      w^2 = n - level^2
//! cos y = (alpha level - beta w) / n    sin y = (beta level + alpha w) / n
//! ```
//! Of the position a gap is left. It has to lie in the plane of the directions a and b of the two slides:
//! `g = gap . (a x b) = g0 + g1 w`. The product of both branches, `(g0^2 - g1^2 w^2) (1 - M_zz^2)`, is a trigonometric
//! polynomial of degree 4 in t, so there are at most 8 solutions. The displacements close the gap.
//!
//! Where the axes of x and z are parallel (M_zz = 1 or -1), the rotation gives the sum of x and z alone. Then x follows from
//! the gap, or is free.
//!
//! [`Slides`] holds the constants. [`Slides::search`] of `f64` takes the real roots of the polynomial; of `f32` it looks
//! for the roots of each branch by itself.

mod branch;
mod singular;
mod structure;
#[cfg(test)]
mod tests;

pub use structure::Slides;
