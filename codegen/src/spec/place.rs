//! Where a node stands in the tree of the file.

/// One step down the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// Into a list, index from 0.
    Item(usize),
    /// To the key of an entry of a mapping, index from 0.
    Key(usize),
    /// To the value of an entry of a mapping, index from 0.
    Value(usize),
}

/// The steps from the root to a node. Entries of mappings go by position, so a key may occur twice.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place(Vec<Step>);

impl Place {
    /// The place one step further down.
    pub fn to(&self, step: Step) -> Self {
        self.0.iter().copied().chain([step]).collect()
    }

    /// From the root down.
    pub fn steps(&self) -> &[Step] {
        &self.0
    }
}

impl FromIterator<Step> for Place {
    fn from_iter<I: IntoIterator<Item = Step>>(steps: I) -> Self {
        Self(steps.into_iter().collect())
    }
}
