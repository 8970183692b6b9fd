//! Why there is no picture.

use denhart_dynamic::DynamicError;

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawError {
    /// The arm does not answer: another number of joint values, or no inverse.
    #[error("{0}")]
    Arm(#[from] DynamicError),
    /// A joint value that is no number.
    #[error("joint {joint} has the value {value}; a picture takes finite joint values")]
    NotFinite {
        /// Number of the joint, from 1.
        joint: usize,
        /// The value.
        value: f64,
    },
    /// Joint values or lengths so large that a point of the arm has no finite place.
    #[error("the arm leaves the range of numbers at these joint values; values of slides below 1e6 can be drawn")]
    TooLarge,
    /// The rendering of a PNG failed: why.
    #[error("no PNG: {0}")]
    Png(String),
}
