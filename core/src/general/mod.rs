//! Six joints of any structure: one polynomial of degree 8 in one joint.
//!
//! The ring of joints d, a, b, c, e, f is cut at d, and c is held. Of the 14 coordinates of d's axis seen from both
//! sides ([`line`](Elimination)) six combinations are free of a and b. With c held they are bilinear in e and f. Six of
//! the nine products go by elimination, and the determinant of what remains, times the square of the pivots, is a
//! trigonometric polynomial of degree 8 in c. Its real roots give c, the null vector of the remaining equations e and
//! f, the pseudo-inverse a and b, and the last frame d. At a root that is doubtful, or at which the elimination fails, e and
//! f follow without it (`held.rs`).
//!
//! One joint may be prismatic, but neither d nor c. Where a root is doubtful a second cut runs, which holds another joint.
//!
//! The link that closes the ring has the target. It stands on the side of joints e and f, and the six combinations are
//! constants of the arm; or on the side of a and b, and they are constants of the target. Where links of the arm have no
//! length, or axes fall together at a target, the polynomials of the first kind may be zero everywhere, while those of the
//! second kind are not.

mod constant_side;
mod elimination;
mod equations;
mod held;
mod lanes;
mod line;
mod search;

pub use constant_side::{EQUATIONS, SINGLES};
pub use elimination::Elimination;
pub use line::{COORDINATES, row};

use crate::held_joint::Visitor;
use crate::meet::Meet;
use crate::{Chain, Outcome, Transform};
pub(crate) use search::{Part, Rest};

/// Where the ring of six joints is cut, and in which direction it is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The joint whose axis gives the equations, 0 to 5, counted from the end where the reading begins. From 3 on the link
    /// with the target is on the side of joints a and b.
    pub d: u8,
    /// The chain is read from its end to its base.
    pub is_backward: bool,
    /// Joint f is eliminated before e.
    pub is_swapped: bool,
}

impl Cut {
    /// The cuts whose constants are those of the arm.
    pub const OF_ARM: [Self; 12] = Self::from(0);
    /// The cuts whose constants depend on the target.
    pub const OF_TARGET: [Self; 12] = Self::from(3);

    const fn from(least: u8) -> [Self; 12] {
        let mut all = [Self { d: 0, is_backward: false, is_swapped: false }; 12];
        let mut i = 0;
        while i < 12 {
            all[i] = Self { d: least + (i % 3) as u8, is_backward: i / 3 % 2 == 1, is_swapped: i >= 6 };
            i += 1;
        }
        all
    }

    /// Returns true for one of [`Cut::OF_TARGET`].
    #[inline]
    pub fn is_of_target(&self) -> bool {
        self.d > 2
    }

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

/// The constants of an arm's cuts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct General {
    /// The cut that finds nearly all.
    pub first: Elimination,
    /// A cut that holds another joint, for targets with a doubtful root.
    pub second: Option<Elimination>,
    /// A cut that holds a third joint, for targets at which the second one tells nothing.
    pub third: Option<Elimination>,
}

/// The cuts of an arm, for one whose constants are known in the call only, as with a given joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cuts {
    /// See [`General::first`].
    pub first: Cut,
    /// See [`General::second`].
    pub second: Option<Cut>,
    /// See [`General::third`].
    pub third: Option<Cut>,
}

impl General {
    /// The constants of a chain along its cuts. None if the first has none for this chain, see [`Elimination::of`].
    pub fn of(chain: &Chain<f64>, cuts: &Cuts) -> Option<Self> {
        let [second, third] = [cuts.second, cuts.third].map(|cut| Elimination::of(chain, cut?));
        Some(Self { first: Elimination::of(chain, cuts.first)?, second, third })
    }

    /// Visits the joint vectors that may bring the end to the target.
    ///
    /// `reference` has the value of a joint that may take any value. A target that is not finite has no candidates.
    pub fn search(&self, target: &Transform<f64>, reference: &[f64; 6], visit: &mut Visitor<'_, f64>) -> Outcome {
        let own = [Some(&self.first), self.second.as_ref(), self.third.as_ref()];
        let [second, third] = [&self.second, &self.third].map(|own| own.as_ref().map(|own| own.cut));
        let cuts = Cuts { first: self.first.cut, second, third };
        along(|part| {
            if let Some(own) = own.get(part.number) {
                return Some((*own)?.search(target, reference, part, visit));
            }
            let cut = cuts.numbered(part.number)?;
            Some(Elimination::at(&self.first.chain(), cut, target)?.search(target, reference, part, visit))
        })
    }
}

impl Cuts {
    /// As [`General::search`], of a chain whose constants are known in the call only. Those of further cuts are computed
    /// where they are needed. Not complete if no cut has constants for this chain.
    ///
    /// A given joint may have a value at which two neighboring axes meet and two are parallel. [`Meet`] solves that chain:
    /// structured arms lose some of the roots of the determinant. Where a link of it is short, as if a third axis passes
    /// through the point in which two meet, the cuts are searched.
    pub fn search(
        &self,
        chain: &Chain<f64>,
        target: &Transform<f64>,
        reference: &[f64; 6],
        visit: &mut Visitor<'_, f64>,
    ) -> Outcome {
        if let Some((meet, k1)) = Meet::posed(chain, target) {
            return meet.search(&k1, reference, visit);
        }
        along(|part| {
            let cut = self.numbered(part.number)?;
            Some(Elimination::at(chain, cut, target)?.search(target, reference, part, visit))
        })
    }

    /// The cut that is asked at this place in the order of a search: the arm's own cuts, then those of the target. None at the
    /// place of an own cut that is missing, or of one that stands before.
    fn numbered(&self, number: usize) -> Option<Cut> {
        let own = [Some(self.first), self.second, self.third];
        if let Some(cut) = own.get(number) {
            return *cut;
        }
        Cut::OF_TARGET.get(number - own.len()).copied().filter(|cut| !own.contains(&Some(*cut)))
    }
}

/// The most cuts of an arm.
const MOST_CUTS: usize = 3;
/// The places in the order of a search: the arm's own cuts, and those of the target.
const PLACES: usize = MOST_CUTS + Cut::OF_TARGET.len();

/// Rings beside the arm's own differ from it by about this, in rad and in half reaches.
const MOVED: f64 = 1e-5;
/// Where no cut has a polynomial beside the arm either, rings farther away are solved: the polynomial grows with a power of
/// the distance, its rounding does not.
const FAR: f64 = 1e-3;
/// The arm's own ring and those beside it, in pairs: of two solutions that meet, one side may have none.
const RINGS: [f64; 5] = [0.0, MOVED, -MOVED, FAR, -FAR];

/// Searches along the cuts until one serves and leaves no doubt, or two have served. Those of the target are asked where none
/// of the first three serves. Where no cut serves on the arm's own ring and no joint is free, rings beside it are
/// solved: the search is not complete then. A rough cut is searched, but does not serve; nor does one of which some root has
/// no joints that close the ring.
fn along(mut search: impl FnMut(Part) -> Option<Rest>) -> Outcome {
    let (mut is_complete, mut has_families) = (true, true);
    for moved in RINGS {
        let is_own = moved == 0.0;
        let (mut served, mut is_known, mut is_sound) = (0, false, false);
        for number in 0..PLACES {
            let is_enough = if is_own { is_sound } else { is_known };
            if number == MOST_CUTS && is_enough {
                break;
            }
            let Some(rest) = search(Part { number, has_families: has_families && is_own, moved }) else { continue };
            is_complete &= rest.is_complete && !rest.is_ended;
            has_families &= !rest.has_families;
            if rest.is_ended {
                return Outcome { is_complete };
            }
            is_known |= !rest.is_useless;
            let serves = !rest.is_useless && !rest.is_rough;
            served += usize::from(serves);
            is_sound |= serves && !rest.is_unsound;
            if (is_sound || !is_own) && (served > 1 || (served == 1 && !rest.is_doubtful)) {
                break;
            }
        }
        if is_own && (is_sound || !has_families) {
            return Outcome { is_complete };
        }
        if moved < 0.0 && is_known {
            break;
        }
    }
    Outcome { is_complete: false }
}
