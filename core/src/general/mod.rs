//! Six joints of any structure: one polynomial of degree 8 in one joint.
//!
//! The ring of joints d, a, b, c, e, f is cut at d, and c is held. Of the 14 coordinates of d's axis seen from both
//! sides ([`line`](Elimination)) six combinations are free of a and b. With c held they are bilinear in e and f. Six of
//! the nine products go by elimination, and the determinant of what remains, times the square of the pivots, is a
//! trigonometric polynomial of degree 8 in c. Its real roots give c, the null vector of the remaining equations e and
//! f, the pseudo-inverse a and b, and the last frame d.
//!
//! One joint may be prismatic, but neither d nor c. Solutions that share c are told apart by a second cut, which holds
//! another joint; it runs where a root is doubtful.

mod constant_side;
mod elimination;
mod equations;
mod line;
mod search;

pub use constant_side::{EQUATIONS, SINGLES};
pub use elimination::Elimination;
pub use line::COORDINATES;

use crate::held_joint::Visitor;
use crate::{Chain, Outcome, Transform};

/// Where the ring of six joints is cut, and in which direction it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The joint whose axis gives the equations, 0 to 2, counted from the end where the reading begins.
    pub d: u8,
    /// The chain is read from its end to its base.
    pub is_backward: bool,
    /// Joint f is eliminated before e.
    pub is_swapped: bool,
}

impl Cut {
    /// All cuts.
    pub const ALL: [Self; 12] = {
        let mut all = [Self { d: 0, is_backward: false, is_swapped: false }; 12];
        let mut i = 0;
        while i < 12 {
            all[i] = Self { d: (i % 3) as u8, is_backward: i / 3 % 2 == 1, is_swapped: i >= 6 };
            i += 1;
        }
        all
    };

    /// The joints d, a, b, c, e, f as joints of the chain, 0 to 5.
    #[inline]
    pub fn order(&self) -> [usize; 6] {
        core::array::from_fn(|i| {
            let place = (usize::from(self.d) + i) % 6;
            if self.is_backward { 5 - place } else { place }
        })
    }

    /// The joint that is held: c.
    #[inline]
    pub fn held(&self) -> usize {
        let [_, _, _, held, ..] = self.order();
        held
    }
}

/// The constants of an arm's first and second cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct General {
    /// The cut that finds nearly all.
    pub first: Elimination,
    /// A cut that holds another joint, for targets with a doubtful root.
    pub second: Option<Elimination>,
}

/// A cut with the usual size of its polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaledCut {
    /// The cut.
    pub cut: Cut,
    /// See [`Elimination::scale`].
    pub scale: f64,
}

/// The two cuts of an arm, for one whose constants are known in the call only, as with a given joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuts {
    /// The cut that finds nearly all.
    pub first: ScaledCut,
    /// A cut that holds another joint.
    pub second: Option<ScaledCut>,
}

impl General {
    /// The constants of a chain along two cuts. None if the first has none for this chain, see [`Elimination::of`].
    pub fn of(chain: &Chain<f64>, cuts: &Cuts) -> Option<Self> {
        Some(Self { first: cuts.first.of(chain)?, second: cuts.second.and_then(|cut| cut.of(chain)) })
    }

    /// Visits the joint vectors that may bring the end to the target.
    ///
    /// `reference` has the value of a joint that may take any value. A target that is not finite has no candidates.
    pub fn search(&self, target: &Transform<f64>, reference: &[f64; 6], visit: &mut Visitor<'_, f64>) -> Outcome {
        let rest = self.first.search(target, reference, false, visit);
        match &self.second {
            Some(second) if rest.is_doubtful && !rest.is_ended => {
                rest.and(second.search(target, reference, true, visit))
            }
            _ => rest.outcome(),
        }
    }
}

impl ScaledCut {
    /// The constants of a chain along this cut.
    pub fn of(&self, chain: &Chain<f64>) -> Option<Elimination> {
        Elimination::of(chain, self.cut).map(|elimination| Elimination { scale: self.scale, ..elimination })
    }
}

impl Cuts {
    /// As [`General::search`], of a chain whose constants are known in the call only. Those of the second cut are
    /// computed where they are needed. Not complete if the first cut has no constants for this chain.
    pub fn search(
        &self,
        chain: &Chain<f64>,
        target: &Transform<f64>,
        reference: &[f64; 6],
        visit: &mut Visitor<'_, f64>,
    ) -> Outcome {
        let second = || self.second.and_then(|cut| cut.of(chain));
        let Some(first) = self.first.of(chain) else {
            return match second() {
                Some(second) => second.search(target, reference, false, visit).outcome(),
                None => Outcome { is_complete: false },
            };
        };
        let rest = first.search(target, reference, false, visit);
        if !rest.is_doubtful || rest.is_ended {
            return rest.outcome();
        }
        second().map_or(rest.outcome(), |second| rest.and(second.search(target, reference, true, visit)))
    }
}
