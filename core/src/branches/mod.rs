//! Solvers whose equation is a product of branches.
//!
//! With one joint held at an angle t, the other joints follow in closed form, up to the signs of one or two square roots.
//! Each choice of signs is a branch. It closes the chain where a function of t, what it misses, is 0. The product of all
//! branches is a trigonometric polynomial without any square root. Its roots are where branches close.
//!
//! - `search`: from the roots of the polynomial to candidates, in `f64`.
//! - `beside`: the branches near a doubtful root of the polynomial.
//! - `scan`: the branches all around, for `f32` and for families of solutions.

mod beside;
mod scan;
mod search;

pub(crate) use beside::{crossing, nearest_to_zero};

use core::ops::ControlFlow;

use crate::held_joint::{Candidate, Visitor};
use crate::math::Scalar;

/// The most branches. Bit 0 of the number of a branch is set for the negative sign of its first root, bit 1 for that of
/// its second one.
pub(crate) const COUNT: usize = 4;

/// One branch at one angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Branch<T> {
    /// How far it is from closing: a length or the difference of two cosines, of the order of 1.
    pub miss: T,
    /// The squares of its two roots, of the order of 1. Where one of them is 0 the branch ends and meets its twin, which
    /// has the other sign of that root. Where it is negative, the branch is imaginary, and `miss` takes the root as 0.
    pub squares: [T; 2],
}

impl<T: Scalar> Branch<T> {
    /// A branch that is imaginary everywhere.
    pub const NONE: Self = Self { miss: T::MAX, squares: [T::NAN; 2] };

    /// Returns true if both roots are real and not 0.
    #[inline]
    pub fn is_real(&self) -> bool {
        let [first, second] = self.squares;
        first > T::ZERO && second > T::ZERO
    }

    /// Returns true if both roots are real or 0 to rounding.
    #[inline]
    fn is_nearly_real(&self) -> bool {
        let least = -T::EPSILON.sqrt() / T::from_f64(16.0);
        self.squares.iter().all(|square| *square >= least)
    }

    /// Returns true if a root is 0 that has the negative sign: the twin is the same branch here.
    #[inline]
    fn is_repeated(&self, number: usize) -> bool {
        let [first, second] = self.squares;
        (number & 1 != 0 && first <= T::ZERO) || (number & 2 != 0 && second <= T::ZERO)
    }
}

/// The branches of an arm for one target.
pub(crate) trait Branches<T: Scalar>: Sized {
    /// Branches and squares whose extremes near 0 may make branches narrow.
    const NARROW: &'static [(usize, usize)];

    /// The held joint, numbered from 0 in the chain.
    fn held(&self) -> usize;

    /// The product of the branches, cleared of its denominators, and the size of what clears them, of the sine and the
    /// cosine of the held joint.
    fn product(&self, turn: (T, T)) -> (T, T);

    /// All branches at an angle, of its sine and cosine, and what clears their denominators.
    fn all_scaled(&self, turn: (T, T)) -> ([Branch<T>; COUNT], T);

    /// All branches at an angle, of its sine and cosine.
    fn all(&self, turn: (T, T)) -> [Branch<T>; COUNT] {
        let (branches, _) = self.all_scaled(turn);
        branches
    }

    /// The branches whose product with the given one, and with what clears the denominators, is the polynomial.
    fn partners(&self, number: usize) -> &'static [usize];

    /// One branch at an angle.
    fn branch(&self, number: usize, t: T) -> Branch<T>;

    /// The joints of a branch at an angle, in the order of the chain, angles in (-pi, pi].
    fn joints(&self, number: usize, t: T) -> [T; 6];

    /// The signs that name a branch.
    fn signs(number: usize) -> Option<(bool, bool)>;

    /// Returns true if the closed form is singular at an angle, nearly to rounding.
    fn is_singular(&self, t: T) -> bool;

    /// Candidates near an angle where the closed form is singular.
    ///
    /// `turn`: the sine and the cosine of the angle `t`.
    ///
    /// Gives the angle where it is most so, if there is one, and true if all solutions at that angle are among the
    /// candidates and `t` is a root because of them.
    fn singular(stream: &mut Stream<'_, '_, T, Self>, t: T, turn: (T, T)) -> ControlFlow<(), Option<(T, bool)>>;
}

/// Offers that are remembered.
const REPEATS: usize = 24;
/// Neighborhoods that are remembered.
const CENTERS: usize = 8;
/// Offers of a branch at angles nearer than this are repeats, rad.
const REPEATED: f64 = 1e-13;

/// The candidates on their way to the visitor.
pub(crate) struct Stream<'a, 'v, T, B> {
    pub branches: &'a B,
    reference: &'a [T; 6],
    visit: &'a mut Visitor<'v, T>,
    /// The number of the held joint's root.
    root: u8,
    /// The last angles that were offered: the neighborhoods of several roots overlap.
    offered: [T; REPEATS],
    /// The branches at these angles.
    offered_branches: [u8; REPEATS],
    /// How many there were.
    count: usize,
    /// The last angles whose neighborhood was looked at, with the branches that have a root there.
    centers: [(T, [bool; COUNT]); CENTERS],
    /// How many there were.
    center_count: usize,
    /// The last angle at which the closed form was singular.
    place: T,
    /// True if all solutions are known at angles where the closed form is singular to rounding.
    is_covered: bool,
}

impl<'a, 'v, T: Scalar, B: Branches<T>> Stream<'a, 'v, T, B> {
    pub fn new(branches: &'a B, reference: &'a [T; 6], visit: &'a mut Visitor<'v, T>) -> Self {
        Self {
            branches,
            reference,
            visit,
            root: 0,
            offered: [T::NAN; REPEATS],
            offered_branches: [0; REPEATS],
            count: 0,
            centers: [(T::NAN, [false; COUNT]); CENTERS],
            center_count: 0,
            place: T::NAN,
            is_covered: false,
        }
    }

    /// A branch at an angle.
    fn offer(&mut self, t: T, number: usize, is_doubtful: bool) -> ControlFlow<()> {
        self.offer_once(t, number, is_doubtful, T::from_f64(REPEATED))
    }

    /// A branch at an angle that is known to `least`.
    fn offer_once(&mut self, t: T, number: usize, is_doubtful: bool, least: T) -> ControlFlow<()> {
        if self.is_covered && self.branches.is_singular(t) {
            return ControlFlow::Continue(());
        }
        let mut offered = self.offered.iter().zip(self.offered_branches);
        if offered.any(|(other, branch)| usize::from(branch) == number && (t - *other).abs() <= least) {
            return ControlFlow::Continue(());
        }
        let place = self.count % REPEATS;
        if let (Some(angle), Some(branch)) = (self.offered.get_mut(place), self.offered_branches.get_mut(place)) {
            // There are four branches.
            (*angle, *branch) = (t, (number % COUNT) as u8);
        }
        self.count += 1;
        self.offer_joints(self.branches.joints(number, t), number, 0, is_doubtful)
    }

    /// A joint vector of a branch, with the joints that are free as bits.
    pub fn offer_joints(&mut self, joints: [T; 6], number: usize, free: u8, is_doubtful: bool) -> ControlFlow<()> {
        let candidate = Candidate { joints, root: self.root, signs: B::signs(number), free, is_doubtful };
        if candidate.is_finite() { (self.visit)(&candidate) } else { ControlFlow::Continue(()) }
    }

    /// Returns true if this is not the last angle at which the closed form was singular, and keeps it.
    pub fn is_new_place(&mut self, t: T) -> bool {
        let is_last = (t - self.place).abs() <= T::EPSILON.sqrt();
        self.place = t;
        !is_last
    }

    /// The reference of a joint of the chain; 0 if it is not finite.
    pub fn reference_of(&self, joint: usize) -> T {
        self.reference.get(joint).copied().filter(|angle| angle.is_finite()).unwrap_or(T::ZERO)
    }
}

/// The bit of a joint of the chain.
pub(crate) fn bit(joint: usize) -> u8 {
    (0..6_u8).fold(0, |bits, other| if usize::from(other) == joint { bits | (1 << other) } else { bits })
}
