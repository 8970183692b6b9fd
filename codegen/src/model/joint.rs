//! The moving joints of an arm.

/// What a moving joint does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// `q` is added to `theta`, rad.
    Revolute,
    /// `q` is added to `d`, length.
    Prismatic,
}

/// A moving joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The name in the file, or `q1`, `q2`, ... Unique among the joints.
    pub name: String,
    /// The index of its row in the table.
    pub row: usize,
    /// Revolute or prismatic.
    pub kind: JointKind,
    /// Lowest and highest value, rad or length; infinite on a side without an end. `None` without limits.
    pub limits: Option<[f64; 2]>,
}
