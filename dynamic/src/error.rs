//! Why there is no arm, or no answer.

use denhart_codegen::{Errors, ReadError};

/// Why there is no arm, or no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DynamicError {
    /// The file cannot be read.
    #[error("{0}")]
    Read(ReadError),
    /// Mistakes in the file, each with its place.
    #[error("{0}")]
    Mistakes(Errors),
    /// The arm has no inverse in closed form: why.
    #[error("no inverse kinematics: {0}; denhart::numeric solves any arm by iteration")]
    NoInverse(String),
    /// A joint vector whose length is not the number of joints.
    #[error("{found} joint values, but the arm has {expected} joints")]
    Joints {
        /// The arm's joints.
        expected: usize,
        /// The values.
        found: usize,
    },
    /// A target of another task.
    #[error("the task of the arm's inverse is `{expected}`, not `{found}`")]
    Target {
        /// The task of the arm.
        expected: &'static str,
        /// The task that the target belongs to.
        found: &'static str,
    },
    /// Another number of values beside the target than the inverse takes.
    #[error("the inverse takes {} beside the target, not {found}", expected_values(.expected))]
    Given {
        /// The names of the values that it takes, in order.
        expected: Vec<String>,
        /// The values.
        found: usize,
    },
    /// A slice of a batch whose length does not go with that of another one.
    #[cfg(feature = "batch")]
    #[error(
        "{slice} has {found} numbers, but {beside} has {length}, {rows} rows of {of}: expected {} numbers, {width} a row",
        .rows.saturating_mul(*.width)
    )]
    Rows {
        /// The slice.
        slice: &'static str,
        /// Its length.
        found: usize,
        /// The numbers that it has a row.
        width: usize,
        /// The slice that says how many rows there are.
        beside: &'static str,
        /// The length of that one.
        length: usize,
        /// The rows of that one.
        rows: usize,
        /// The numbers that that one has a row.
        of: usize,
    },
    /// A slice of a batch that does not end with a row.
    #[cfg(feature = "batch")]
    #[error("{slice} has {found} numbers, which are no rows of {width}")]
    PartOfARow {
        /// The slice.
        slice: &'static str,
        /// Its length.
        found: usize,
        /// The numbers of a row.
        width: usize,
    },
    /// The arm angle is asked for, of an arm whose inverse does not take it.
    #[error("the inverse takes no arm angle")]
    NoArmAngle,
    /// Pulses are asked for, of an arm whose file has no `actuator`.
    #[error("no motor of the arm counts pulses: its file has no `actuator`")]
    NoActuators,
    /// A branch is asked for, of an arm whose inverse holds a joint.
    #[error("the solutions of this arm are numbered anew at every target: no branch can be asked for")]
    NoBranches,
    /// An arm that generated code supports and this crate cannot evaluate.
    #[error("not supported at run time: {0}; the generated code (`denhart expand`, `#[derive(Arm)]`) has it")]
    Unsupported(String),
}

/// `2 values (q1, q4)`, `no value`.
fn expected_values(names: &[String]) -> String {
    match names {
        [] => "no value".to_owned(),
        [one] => format!("1 value ({one})"),
        names => format!("{} values ({})", names.len(), names.join(", ")),
    }
}

impl From<ReadError> for DynamicError {
    fn from(error: ReadError) -> Self {
        DynamicError::Read(error)
    }
}

impl From<Errors> for DynamicError {
    fn from(errors: Errors) -> Self {
        DynamicError::Mistakes(errors)
    }
}
