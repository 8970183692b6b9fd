//! Joint values over time.

use denhart::{Branch, Residual};

/// Joint values at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The time, s.
    pub t: f64,
    /// Joint values, rad or length unit.
    pub q: Vec<f64>,
    /// Their rates, 1/s.
    pub velocity: Vec<f64>,
    /// The path's parameter: a time, s, or the length of the path.
    pub at: f64,
    /// The branch as text; empty where it has no name.
    pub branch: String,
    /// `kept` of a row on the path within the tolerance; else `exact`, or the reason why it is not.
    pub tracking: &'static str,
    /// The difference of the tool from the path, length unit and rad.
    pub off: Residual<f64>,
}

/// The place where no continuous path goes on, or where the arm is when the time is over.
#[derive(Debug, Clone, PartialEq)]
pub struct Obstacle {
    /// The path's parameter.
    pub at: f64,
    /// The branch there, as of a [`Row`].
    pub branch: String,
    /// The reason, in words.
    pub reason: String,
}

/// A motion along a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Joint values in the order of time; none where no motion brings the tool along the path.
    pub rows: Vec<Row>,
    /// Why the tool does not come to the end of the path.
    pub obstacle: Option<Obstacle>,
}

impl Motion {
    /// Changes of the branch: the time of the first row on the new one, and both.
    pub fn changes(&self) -> impl Iterator<Item = (f64, &str, &str)> {
        let pairs = self.rows.iter().zip(self.rows.iter().skip(1));
        pairs.filter(|(a, b)| a.branch != b.branch).map(|(a, b)| (b.t, a.branch.as_str(), b.branch.as_str()))
    }

    /// Rows whose tool is off the path: neither exact nor kept.
    pub fn away(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| !matches!(row.tracking, "exact" | "kept"))
    }
}

/// An obstacle without rows.
impl From<Obstacle> for Motion {
    fn from(obstacle: Obstacle) -> Self {
        Motion { rows: Vec::new(), obstacle: Some(obstacle) }
    }
}

/// The name of a branch; empty where it has none.
pub fn name(branch: Branch) -> String {
    if branch == Branch::NONE { String::new() } else { branch.to_string() }
}
