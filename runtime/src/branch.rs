//! Names of the branches of an inverse.

use core::fmt;
use core::str::FromStr;

use crate::math::Scalar;

/// Side on which the arm stands, of the two that its shoulder allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Shoulder {
    /// The first root of the shoulder's equation.
    Left = 1,
    /// The second root.
    Right = 2,
}

impl Shoulder {
    /// The name of a stage's root: the first one or any other.
    #[inline]
    #[must_use]
    pub const fn of_root(index: usize) -> Self {
        if index == 0 { Self::Left } else { Self::Right }
    }

    /// The side on which the margin `shoulder` of an arm of six joints has this sign.
    #[inline]
    #[must_use]
    pub fn of_margin<T: Scalar>(margin: T) -> Self {
        if margin < T::ZERO { Self::Left } else { Self::Right }
    }
}

/// Side to which the elbow bends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Elbow {
    /// The first root: the elbow turns forward, by a positive angle, from the stretched arm. Which side of the line from
    /// shoulder to wrist that is depends on the arm's table and on the shoulder.
    Up = 1,
    /// The second root: the elbow turns backward.
    Down = 2,
}

impl Elbow {
    /// The name of a stage's root: the first one or any other.
    #[inline]
    #[must_use]
    pub const fn of_root(index: usize) -> Self {
        if index == 0 { Self::Up } else { Self::Down }
    }

    /// The side on which the margin `elbow` has this sign.
    #[inline]
    #[must_use]
    pub fn of_margin<T: Scalar>(margin: T) -> Self {
        if margin < T::ZERO { Self::Down } else { Self::Up }
    }
}

/// Which of the two wrist solutions: they differ by half a turn of the first and the last wrist joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Wrist {
    /// The first solution of the wrist.
    NoFlip = 1,
    /// The second solution of the wrist.
    Flip = 2,
}

impl Wrist {
    /// The name of a stage's root: the first one or any other.
    #[inline]
    #[must_use]
    pub const fn of_root(index: usize) -> Self {
        if index == 0 { Self::NoFlip } else { Self::Flip }
    }

    /// The solution at which the margin `wrist` has this sign.
    #[inline]
    #[must_use]
    pub fn of_margin<T: Scalar>(margin: T) -> Self {
        if margin < T::ZERO { Self::Flip } else { Self::NoFlip }
    }
}

/// Name of the branch that a solution lies on; each part only where it means something for the arm.
// Packed, with all bits zero for `NONE`: an empty array of solutions is then plain zeros.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Branch {
    /// Two bits each, from the lowest: shoulder, elbow, wrist. 0 is none.
    labels: u8,
    root: u8,
}

impl Branch {
    /// A branch without a name.
    pub const NONE: Self = Self { labels: 0, root: 0 };

    /// Returns the branch with the number of a root, given its index from 0 to 15; without one beyond.
    #[inline]
    #[must_use]
    pub const fn with_root_index(self, index: usize) -> Self {
        self.with_root(if index < 16 { index as u8 + 1 } else { 0 })
    }

    const ELBOW: u8 = 2;
    const WRIST: u8 = 4;

    /// Returns the branch with this side of the shoulder.
    #[inline]
    #[must_use]
    pub const fn with_shoulder(self, shoulder: Shoulder) -> Self {
        self.with(0, shoulder as u8)
    }

    /// Returns the branch with this side of the elbow.
    #[inline]
    #[must_use]
    pub const fn with_elbow(self, elbow: Elbow) -> Self {
        self.with(Self::ELBOW, elbow as u8)
    }

    /// Returns the branch with this solution of the wrist.
    #[inline]
    #[must_use]
    pub const fn with_wrist(self, wrist: Wrist) -> Self {
        self.with(Self::WRIST, wrist as u8)
    }

    /// Returns the branch beyond the singularity of the wrist, if a solution of the wrist is named.
    pub(crate) const fn with_other_wrist(self) -> Option<Self> {
        match self.wrist() {
            Some(Wrist::NoFlip) => Some(self.with_wrist(Wrist::Flip)),
            Some(Wrist::Flip) => Some(self.with_wrist(Wrist::NoFlip)),
            None => None,
        }
    }

    /// Returns the branch with either solution of the wrist.
    #[inline]
    #[must_use]
    pub(crate) const fn with_any_wrist(self) -> Self {
        Self { labels: self.labels & !(3 << Self::WRIST), ..self }
    }

    /// Returns the branch with the number of the polynomial's root, counted from 1; 0 for none.
    #[inline]
    #[must_use]
    pub const fn with_root(self, root: u8) -> Self {
        Self { root, ..self }
    }

    /// Side of the shoulder, where the arm has one.
    #[inline]
    #[must_use]
    pub const fn shoulder(self) -> Option<Shoulder> {
        match self.get(0) {
            1 => Some(Shoulder::Left),
            2 => Some(Shoulder::Right),
            _ => None,
        }
    }

    /// Side of the elbow, where the arm has one.
    #[inline]
    #[must_use]
    pub const fn elbow(self) -> Option<Elbow> {
        match self.get(Self::ELBOW) {
            1 => Some(Elbow::Up),
            2 => Some(Elbow::Down),
            _ => None,
        }
    }

    /// Solution of the wrist, where the arm has one.
    #[inline]
    #[must_use]
    pub const fn wrist(self) -> Option<Wrist> {
        match self.get(Self::WRIST) {
            1 => Some(Wrist::NoFlip),
            2 => Some(Wrist::Flip),
            _ => None,
        }
    }

    /// Number of the root, counted from 1, where the branches are the roots of a polynomial.
    #[inline]
    #[must_use]
    pub const fn root(self) -> Option<u8> {
        if self.root == 0 { None } else { Some(self.root) }
    }

    /// Returns true if this name asks for the branch of a solution: they agree in every part that both name. A solution
    /// without a number is the first of its name.
    #[inline]
    #[must_use]
    pub const fn asks_for(self, solution: Self) -> bool {
        let number = if solution.root == 0 { 1 } else { solution.root };
        self.agrees_with(solution) && (self.root == 0 || self.root == number)
    }

    /// Returns true if two branches agree in every part that both name.
    #[inline]
    pub(crate) const fn agrees_with(self, other: Self) -> bool {
        let labels = (self.labels ^ other.labels) & self.named() & other.named();
        labels == 0 && (self.root == 0 || other.root == 0 || self.root == other.root)
    }

    /// The parts that this branch names, as `wanted` has them where it names them too.
    #[inline]
    pub(crate) const fn called(self, wanted: Self) -> Self {
        let both = self.named() & wanted.named();
        let root = if self.root == 0 || wanted.root == 0 { self.root } else { wanted.root };
        Self { labels: self.labels & !both | wanted.labels & both, root }
    }

    /// The parts that this branch names, and of the others those that `other` names.
    pub(crate) const fn or(self, other: Self) -> Self {
        Self {
            labels: self.labels | other.labels & !self.named(),
            root: if self.root == 0 { other.root } else { self.root },
        }
    }

    /// The bits of the labels that are not 0.
    #[inline]
    const fn named(self) -> u8 {
        let named = (self.labels | self.labels >> 1) & 0b01_0101;
        named | named << 1
    }

    #[inline]
    const fn with(self, shift: u8, label: u8) -> Self {
        Self { labels: self.labels & !(3 << shift) | label << shift, ..self }
    }

    #[inline]
    const fn get(self, shift: u8) -> u8 {
        self.labels >> shift & 3
    }
}

/// The parts that have a meaning, as in `shoulder left, elbow up, wrist no-flip` or `root 2`; `-` where none has.
impl fmt::Display for Branch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shoulder = self.shoulder().map(|shoulder| match shoulder {
            Shoulder::Left => "shoulder left",
            Shoulder::Right => "shoulder right",
        });
        let elbow = self.elbow().map(|elbow| match elbow {
            Elbow::Up => "elbow up",
            Elbow::Down => "elbow down",
        });
        let wrist = self.wrist().map(|wrist| match wrist {
            Wrist::NoFlip => "wrist no-flip",
            Wrist::Flip => "wrist flip",
        });
        if *self == Self::NONE {
            return f.write_str("-");
        }
        let mut separator = "";
        for part in [shoulder, elbow, wrist].into_iter().flatten() {
            write!(f, "{separator}{part}")?;
            separator = ", ";
        }
        match self.root() {
            Some(root) => write!(f, "{separator}root {root}"),
            None => Ok(()),
        }
    }
}

impl fmt::Debug for Branch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Branch({self})")
    }
}

/// A text is no branch: the error of `str::parse`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParseBranchError {
    part: usize,
}

impl ParseBranchError {
    /// The number of the part between commas that is wrong, from 0.
    #[must_use]
    pub const fn part(&self) -> usize {
        self.part
    }
}

impl fmt::Display for ParseBranchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(
            "expected the parts of a branch, such as \"shoulder left, elbow up, wrist flip\": shoulder left or right, elbow up \
             or down, wrist flip or no-flip, root 1 to 16",
        )
    }
}

impl core::error::Error for ParseBranchError {}

/// Reads what [`Display`](fmt::Display) writes: parts in any order, each at most once.
impl FromStr for Branch {
    type Err = ParseBranchError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut branch = Self::NONE;
        if text.trim() == "-" {
            return Ok(branch);
        }
        for (part, text) in text.split(',').enumerate() {
            let wrong = Err(ParseBranchError { part });
            let mut words = text.split_ascii_whitespace();
            let (Some(name), Some(value), None) = (words.next(), words.next(), words.next()) else {
                return wrong;
            };
            let (named, with) = match (name, value) {
                ("shoulder", "left") => (branch.shoulder().is_some(), branch.with_shoulder(Shoulder::Left)),
                ("shoulder", "right") => (branch.shoulder().is_some(), branch.with_shoulder(Shoulder::Right)),
                ("elbow", "up") => (branch.elbow().is_some(), branch.with_elbow(Elbow::Up)),
                ("elbow", "down") => (branch.elbow().is_some(), branch.with_elbow(Elbow::Down)),
                ("wrist", "flip") => (branch.wrist().is_some(), branch.with_wrist(Wrist::Flip)),
                ("wrist", "no-flip") => (branch.wrist().is_some(), branch.with_wrist(Wrist::NoFlip)),
                ("root", number) => match number.parse() {
                    Ok(root @ 1..=16) => (branch.root().is_some(), branch.with_root(root)),
                    _ => return wrong,
                },
                _ => return wrong,
            };
            if named {
                return wrong;
            }
            branch = with;
        }
        Ok(branch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    #[test]
    fn a_branch_reads_what_it_writes() {
        let full = Branch::NONE.with_shoulder(Shoulder::Right).with_elbow(Elbow::Down).with_wrist(Wrist::NoFlip);
        for branch in [Branch::NONE, full, full.with_root(16), Branch::NONE.with_root(2)] {
            assert_eq!(format!("{branch}").parse(), Ok(branch));
        }
        assert_eq!("  wrist   flip,elbow up ".parse(), Ok(Branch::NONE.with_elbow(Elbow::Up).with_wrist(Wrist::Flip)));
        for text in ["", "elbow", "root 0", "root 17", "root -", "Elbow up", "up", "-,"] {
            assert_eq!(text.parse::<Branch>(), Err(ParseBranchError { part: 0 }), "{text:?}");
        }
        for text in ["elbow up,", "elbow up, elbow down", "elbow up, wrist"] {
            assert_eq!(text.parse::<Branch>(), Err(ParseBranchError { part: 1 }), "{text:?}");
        }
    }

    #[test]
    fn every_name_is_kept() {
        for shoulder in [Shoulder::Left, Shoulder::Right] {
            for elbow in [Elbow::Up, Elbow::Down] {
                for wrist in [Wrist::NoFlip, Wrist::Flip] {
                    let branch = Branch::NONE.with_wrist(wrist).with_shoulder(shoulder).with_elbow(elbow).with_root(7);
                    assert_eq!(branch.shoulder(), Some(shoulder));
                    assert_eq!(branch.elbow(), Some(elbow));
                    assert_eq!(branch.wrist(), Some(wrist));
                    assert_eq!(branch.root(), Some(7));
                }
            }
        }
    }

    #[test]
    fn the_last_label_counts() {
        let branch = Branch::NONE.with_elbow(Elbow::Down).with_elbow(Elbow::Up);
        assert_eq!(branch, Branch::NONE.with_elbow(Elbow::Up));
        assert_eq!(branch.with_root(3).with_root(0), branch);
        assert_eq!((branch.shoulder(), branch.wrist(), branch.root()), (None, None, None));
    }

    #[test]
    fn only_parts_that_both_branches_name_are_compared() {
        let branch = Branch::NONE.with_elbow(Elbow::Up).with_wrist(Wrist::Flip);
        let full = branch.with_shoulder(Shoulder::Right).with_root(2);
        for (one, other) in [(Branch::NONE, full), (branch, full), (full, full)] {
            assert!(one.agrees_with(other) && other.agrees_with(one), "{one} {other}");
        }
        for other in [full.with_elbow(Elbow::Down), full.with_wrist(Wrist::NoFlip)] {
            assert!(!branch.agrees_with(other) && !other.agrees_with(branch), "{other}");
        }
        assert!(!full.agrees_with(full.with_root(1)) && !full.agrees_with(full.with_shoulder(Shoulder::Left)));
    }

    #[test]
    fn a_solution_without_a_number_is_the_first_of_its_name() {
        let up = Branch::NONE.with_elbow(Elbow::Up);
        assert!(up.asks_for(up) && up.asks_for(up.with_root(2)) && up.with_root(1).asks_for(up));
        assert!(!up.with_root(2).asks_for(up) && up.with_root(2).asks_for(up.with_root(2)));
        assert!(!up.asks_for(Branch::NONE.with_elbow(Elbow::Down)));
    }

    #[test]
    fn a_branch_takes_the_parts_that_it_names() {
        let flip = Branch::NONE.with_elbow(Elbow::Up).with_wrist(Wrist::Flip);
        let other = flip.with_wrist(Wrist::NoFlip).with_shoulder(Shoulder::Left).with_root(2);
        assert_eq!(other.called(flip), other.with_wrist(Wrist::Flip));
        // Parts that it does not have stay away.
        assert_eq!(flip.called(other), flip.with_wrist(Wrist::NoFlip));
        assert_eq!((other.called(Branch::NONE), Branch::NONE.called(other)), (other, Branch::NONE));
        assert_eq!(other.called(flip.with_root(5)).root(), Some(5));
    }

    #[test]
    fn display_names_what_there_is() {
        let branch = Branch::NONE.with_shoulder(Shoulder::Left).with_elbow(Elbow::Up).with_wrist(Wrist::NoFlip);
        assert_eq!(format!("{branch}"), "shoulder left, elbow up, wrist no-flip");
        assert_eq!(format!("{}", Branch::NONE.with_root(2)), "root 2");
        assert_eq!(format!("{}", Branch::NONE.with_wrist(Wrist::Flip).with_root(1)), "wrist flip, root 1");
        assert_eq!(format!("{} {:?}", Branch::NONE, Branch::default()), "- Branch(-)");
    }
}
