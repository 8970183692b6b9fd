//! Vectors over the joints of an arm, of a length known at run time.

use std::ops::{Deref, DerefMut};

use denhart_codegen::model::MOST_JOINTS;

/// One number for each joint, at most [`MOST_JOINTS`]; derefs to a slice.
#[derive(Clone, Copy)]
pub struct Joints {
    values: [f64; MOST_JOINTS],
    len: usize,
}

impl Joints {
    /// The first [`MOST_JOINTS`] of these numbers.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let mut joints = Joints { values: [0.0; MOST_JOINTS], len: 0 };
        for (place, value) in joints.values.iter_mut().zip(values) {
            *place = value;
            joints.len += 1;
        }
        joints
    }
}

impl Deref for Joints {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        self.values.get(..self.len).unwrap_or(&[])
    }
}

impl DerefMut for Joints {
    fn deref_mut(&mut self) -> &mut [f64] {
        self.values.get_mut(..self.len).unwrap_or(&mut [])
    }
}

impl PartialEq for Joints {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl std::fmt::Debug for Joints {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_long_as_what_it_is_made_from() {
        let three = Joints::new([1.0, 2.0, 3.0]);
        assert_eq!(*three, [1.0, 2.0, 3.0]);
        assert_eq!(format!("{three:?}"), "[1.0, 2.0, 3.0]");
        assert_eq!(Joints::new([0.5; MOST_JOINTS + 1]).len(), MOST_JOINTS);
        assert!(Joints::new([]).is_empty() && Joints::new([]) != three);
    }
}
