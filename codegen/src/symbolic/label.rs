//! How the joints of a closed chain are called.

use std::fmt;

/// A joint of a closed chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Label {
    /// A joint of the arm, from 0; written from 1.
    Arm(usize),
    /// A virtual joint, from 1.
    Virtual(usize),
}

impl Label {
    /// The joint of the arm, from 0; `None` for a virtual one.
    pub fn arm(self) -> Option<usize> {
        match self {
            Label::Arm(joint) => Some(joint),
            Label::Virtual(_) => None,
        }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Label::Arm(joint) => write!(f, "{}", joint + 1),
            Label::Virtual(number) => write!(f, "v{number}"),
        }
    }
}
