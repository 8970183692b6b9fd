//! Groups of targets that take no lanes.

/// The groups that are left to single calls after one whose lanes were all in doubt: 1, then 2, 4 and so on.
pub struct LeftOut {
    groups: usize,
    next: usize,
    most: usize,
}

impl LeftOut {
    /// No group yet; up to `most` in a row.
    pub const fn up_to(most: usize) -> Self {
        Self { groups: 0, next: 1, most }
    }

    /// Returns true if the next group takes lanes; else that group counts as left out.
    #[inline(always)]
    pub fn takes_lanes(&mut self) -> bool {
        let takes_lanes = self.groups == 0;
        self.groups = self.groups.saturating_sub(1);
        takes_lanes
    }

    /// Notes a group that has taken lanes.
    #[inline(always)]
    pub fn note(&mut self, all_in_doubt: bool) {
        if all_in_doubt {
            self.groups = self.next;
            self.next = (self.next * 2).min(self.most);
        } else {
            self.next = 1;
        }
    }
}
