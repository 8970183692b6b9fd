//! The state of a branch, which generated code hands from stage to stage.

/// State of a branch, 0 without doubts: the number of doubts that belong to it, which the search keeps, and two marks. One
/// mark says that the solution is to be verified whatever the doubts are, the other that the branch has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BranchState(u32);

impl BranchState {
    const VERIFY: u32 = 0x100;
    const ENDED: u32 = 0x200;

    /// The start of every branch.
    #[inline]
    pub(in crate::solve) fn start(verify: bool) -> Self {
        Self(if verify { Self::VERIFY } else { 0 })
    }

    /// Returns true if a stage is in doubt, or the solution is to be verified.
    #[inline]
    pub(in crate::solve) fn doubt(self) -> bool {
        self.0 != 0
    }

    /// Returns true if the solution is to be verified whatever the doubts are.
    pub(in crate::solve) fn verify(self) -> bool {
        self.0 & Self::VERIFY != 0
    }

    /// Returns true if the branch leads nowhere: a stage has no root near it, and no joint before it may move.
    #[inline]
    pub fn ended(self) -> bool {
        self.0 & Self::ENDED != 0
    }

    /// The root of a wrist to follow, if one is wanted. In doubt both are followed: the solution of the second one follows
    /// from that of the first.
    #[inline]
    pub fn flips(self, wanted: Option<usize>) -> Option<usize> {
        wanted.filter(|_| !self.doubt())
    }

    /// The number of doubts that belong to the branch.
    pub(in crate::solve) fn depth(self) -> usize {
        (self.0 & (Self::VERIFY - 1)) as usize
    }

    /// Marks the branch to be verified if `verify` is set.
    #[inline]
    pub(in crate::solve) fn doubted(self, verify: bool) -> Self {
        Self(self.0 | Self::start(verify).0)
    }

    /// Adds one more state to the branch.
    pub(in crate::solve) fn deeper(self, ended: bool) -> Self {
        Self((self.0 + 1) | if ended { Self::ENDED } else { 0 })
    }
}
