//! Which branches are followed.

use crate::{Branch, Elbow, Shoulder, Wrist};

/// Tells each stage which of its roots to follow, by index; `None` for all of them.
///
/// A type of its own for every branch and for one, so that each has its own code and the former asks nothing.
pub trait Select: Copy {
    /// Root of the stage whose roots are the sides of the shoulder.
    fn shoulder(self) -> Option<usize>;
    /// Root of the elbow's stage.
    fn elbow(self) -> Option<usize>;
    /// Root of the wrist's stage.
    fn wrist(self) -> Option<usize>;
    /// Root of a stage with numbered roots.
    fn root(self) -> Option<usize>;
}

/// Every branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Every;

impl Select for Every {
    #[inline]
    fn shoulder(self) -> Option<usize> {
        None
    }
    #[inline]
    fn elbow(self) -> Option<usize> {
        None
    }
    #[inline]
    fn wrist(self) -> Option<usize> {
        None
    }
    #[inline]
    fn root(self) -> Option<usize> {
        None
    }
}

/// The branches that have the parts named.
impl Select for Branch {
    #[inline]
    fn shoulder(self) -> Option<usize> {
        Branch::shoulder(self).map(|side| usize::from(side == Shoulder::Right))
    }
    #[inline]
    fn elbow(self) -> Option<usize> {
        Branch::elbow(self).map(|side| usize::from(side == Elbow::Down))
    }
    #[inline]
    fn wrist(self) -> Option<usize> {
        Branch::wrist(self).map(|side| usize::from(side == Wrist::Flip))
    }
    #[inline]
    fn root(self) -> Option<usize> {
        Branch::root(self).map(|number| usize::from(number.saturating_sub(1)))
    }
}
