//! `type:` of a row.

/// Kind of a row's joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowKind {
    /// `q` is added to `theta`.
    Revolute,
    /// `q` is added to `d`.
    Prismatic,
    /// Nothing moves.
    Fixed,
}

pub const KINDS: &[(&str, RowKind)] =
    &[("revolute", RowKind::Revolute), ("prismatic", RowKind::Prismatic), ("fixed", RowKind::Fixed)];
pub const KIND_SYNONYMS: &[(&str, &str)] = &[
    ("r", "revolute"),
    ("rotary", "revolute"),
    ("rotational", "revolute"),
    ("hinge", "revolute"),
    ("continuous", "revolute"),
    ("p", "prismatic"),
    ("linear", "prismatic"),
    ("sliding", "prismatic"),
    ("constant", "fixed"),
];
