//! Sets of facts and of joints.

use core::ops::{BitOr, BitOrAssign};
use core::{fmt, iter};

/// A set of facts about one solution: exact or approximate, singular, outside the limits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Flags(u8);

impl Flags {
    /// The empty set.
    pub const NONE: Self = Self(0);
    /// The solution reaches the target up to rounding; of a target whose rotation is slightly off, the pose with the
    /// nearest rotation.
    pub const EXACT: Self = Self(1);
    /// Two branches meet here: the target lies on the edge of what this branch reaches.
    pub const BOUNDARY: Self = Self(1 << 1);
    /// A singular pose: an equation leaves the joints of [`Solution::free`](crate::Solution::free) open. They could take
    /// other values, and the joints solved after them would move with them, unless a later equation needs these values.
    pub const FREE: Self = Self(1 << 2);
    /// The solution misses the target by its residual, which is more than rounding and within the tolerance of the
    /// arm's file.
    pub const APPROXIMATE: Self = Self(1 << 3);
    /// A joint value lies outside the arm's limits.
    pub const OUT_OF_LIMITS: Self = Self(1 << 4);

    const NAMES: [(Self, &'static str); 5] = [
        (Self::EXACT, "EXACT"),
        (Self::BOUNDARY, "BOUNDARY"),
        (Self::FREE, "FREE"),
        (Self::APPROXIMATE, "APPROXIMATE"),
        (Self::OUT_OF_LIMITS, "OUT_OF_LIMITS"),
    ];

    /// Returns true if every flag of `other` is set. Every set contains [`Flags::NONE`].
    #[inline]
    #[must_use]
    pub const fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// The flags that are in either set.
    #[inline]
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Sets the flags of `other`.
    #[inline]
    pub const fn insert(&mut self, other: Self) {
        self.0 |= other.0;
    }

    /// Clears the flags of `other`.
    #[inline]
    pub const fn remove(&mut self, other: Self) {
        self.0 &= !other.0;
    }

    /// Returns true if no flag is set.
    #[inline]
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

impl BitOr for Flags {
    type Output = Self;

    #[inline]
    fn bitor(self, rhs: Self) -> Self {
        self.union(rhs)
    }
}

impl BitOrAssign for Flags {
    #[inline]
    fn bitor_assign(&mut self, rhs: Self) {
        self.insert(rhs);
    }
}

/// The names, as in `EXACT | FREE`; `NONE` for the empty set.
impl fmt::Display for Flags {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("NONE");
        }
        let mut separator = "";
        for (flag, name) in Self::NAMES {
            if self.contains(flag) {
                write!(f, "{separator}{name}")?;
                separator = " | ";
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Flags {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// A set of joints, of an arm with at most 16.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct JointMask(u16);

impl JointMask {
    /// The empty set.
    pub const NONE: Self = Self(0);

    /// The set of one joint, counted from 0. Empty for a joint beyond the sixteenth.
    #[inline]
    #[must_use]
    pub const fn single(joint: usize) -> Self {
        if joint < u16::BITS as usize { Self(1 << joint) } else { Self::NONE }
    }

    /// Returns true if the joint, counted from 0, is in the set.
    #[inline]
    #[must_use]
    pub const fn contains(self, joint: usize) -> bool {
        self.0 & Self::single(joint).0 != 0
    }

    /// The joints that are in either set.
    #[inline]
    #[must_use]
    pub const fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Returns true if a joint is in both sets.
    #[inline]
    pub(crate) const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// The joints of the set but one, counted from 0.
    #[inline]
    #[must_use]
    pub const fn without(self, joint: usize) -> Self {
        Self(self.0 & !Self::single(joint).0)
    }

    /// Adds the joints of `other`.
    #[inline]
    pub const fn insert(&mut self, other: Self) {
        self.0 |= other.0;
    }

    /// Returns true if no joint is in the set.
    #[inline]
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Number of joints in the set.
    #[inline]
    #[must_use]
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The joints, counted from 0, in ascending order.
    #[inline]
    pub fn iter(self) -> impl Iterator<Item = usize> + Clone {
        let mut rest = self.0;
        iter::from_fn(move || {
            let joint = (rest != 0).then(|| rest.trailing_zeros() as usize)?;
            // Without the lowest bit.
            rest &= rest - 1;
            Some(joint)
        })
    }
}

impl BitOr for JointMask {
    type Output = Self;

    #[inline]
    fn bitor(self, rhs: Self) -> Self {
        self.union(rhs)
    }
}

impl BitOrAssign for JointMask {
    #[inline]
    fn bitor_assign(&mut self, rhs: Self) {
        self.insert(rhs);
    }
}

/// The joints by their default names, counted from 1: `{q4, q6}`.
impl fmt::Display for JointMask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{")?;
        let mut separator = "";
        for joint in self.iter() {
            write!(f, "{separator}q{}", joint + 1)?;
            separator = ", ";
        }
        f.write_str("}")
    }
}

impl fmt::Debug for JointMask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;
    use std::vec::Vec;

    #[test]
    fn flags_are_a_set() {
        let mut flags = Flags::EXACT | Flags::FREE;
        assert!(flags.contains(Flags::EXACT) && flags.contains(Flags::FREE) && flags.contains(Flags::NONE));
        assert!(!flags.contains(Flags::BOUNDARY) && !flags.contains(Flags::EXACT | Flags::BOUNDARY));
        assert_eq!(format!("{flags:?}"), "EXACT | FREE");
        flags.remove(Flags::EXACT | Flags::BOUNDARY);
        assert_eq!(flags, Flags::FREE);
        flags |= Flags::OUT_OF_LIMITS;
        flags.insert(Flags::APPROXIMATE);
        assert_eq!(format!("{flags}"), "FREE | APPROXIMATE | OUT_OF_LIMITS");
        assert!(Flags::NONE.is_empty() && !flags.is_empty());
        assert_eq!(format!("{}", Flags::default()), "NONE");
    }

    #[test]
    fn flags_are_distinct() {
        for (a, name) in Flags::NAMES {
            assert_eq!(Flags::NAMES.iter().filter(|(b, _)| a.contains(*b)).count(), 1, "{name}");
        }
    }

    #[test]
    fn joints_are_a_set() {
        let mut joints = JointMask::single(3) | JointMask::single(5);
        assert_eq!(format!("{joints} {joints:?} {}", JointMask::NONE), "{q4, q6} {q4, q6} {}");
        assert_eq!(joints.iter().collect::<Vec<_>>(), [3, 5]);
        assert!(joints.contains(3) && !joints.contains(4));
        joints |= JointMask::single(15);
        assert_eq!(joints.len(), 3);
        assert!(!joints.is_empty());
    }

    #[test]
    fn joints_beyond_the_last_are_never_in_the_set() {
        assert_eq!(JointMask::single(16), JointMask::NONE);
        assert_eq!(JointMask::single(usize::MAX), JointMask::NONE);
        assert!(!JointMask(u16::MAX).contains(16));
        assert_eq!(JointMask(u16::MAX).iter().count(), 16);
    }
}
