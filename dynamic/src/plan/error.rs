//! Why there is no plan.

use std::fmt;

use denhart::Branch;

/// The reason why no continuous joint path goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Obstacle {
    /// The joint of this number, from 0, comes to its limit.
    Limit(usize),
    /// A sum of joint values comes to its limit.
    CombinedLimit,
    /// The joint of this number, from 0, comes to its limit and would have to turn back by a whole turn.
    WholeTurn(usize),
    /// The branch does not reach the path any more.
    Reach,
    /// The joint of this number, from 0, would have to swing at once.
    Singularity(usize),
}

impl Obstacle {
    /// The obstacle in words, with the name of each joint.
    pub fn words(&self, name: impl Fn(usize) -> String) -> String {
        match self {
            Obstacle::Limit(joint) => format!("{} is at its limit", name(*joint)),
            Obstacle::CombinedLimit => "a sum of joints is at its limit".to_owned(),
            Obstacle::WholeTurn(joint) => format!("{} is at its limit and needs a whole turn", name(*joint)),
            Obstacle::Reach => "the path leaves the reach of the branch".to_owned(),
            Obstacle::Singularity(joint) => format!("{} has to swing at a singularity", name(*joint)),
        }
    }
}

/// As in `q3 is at its limit`.
impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words(|joint| format!("q{}", joint + 1)))
    }
}

/// Why there is no plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// A velocity that is not finite, or not above 0.
    #[error("the velocity of q{} is {velocity}, expected a finite one above 0", .joint + 1)]
    Velocity {
        /// The joint, from 0.
        joint: usize,
        /// The velocity.
        velocity: f64,
    },
    /// An acceleration that is not above 0.
    #[error("the acceleration of q{} is {acceleration}, expected one above 0, or infinity for none", .joint + 1)]
    Acceleration {
        /// The joint, from 0.
        joint: usize,
        /// The acceleration.
        acceleration: f64,
    },
    /// A tolerance that is not finite, or not above 0.
    #[error("the tolerances are {position} and {orientation} rad, expected finite ones above 0")]
    Tolerance {
        /// The tolerance of positions, length unit.
        position: f64,
        /// The tolerance of orientations, rad.
        orientation: f64,
    },
    /// A path without a length.
    #[error("the path ends at {end}, expected a finite end above 0")]
    End {
        /// The last parameter.
        end: f64,
    },
    /// A start with a joint outside its limits, or that is not a number.
    #[error("the start is outside the limits of q{}", .joint + 1)]
    StartOutside {
        /// The joint, from 0.
        joint: usize,
    },
    /// A start that is not at the first target of the path.
    #[error("the start is {distance:.3e} rad from the nearest solution of the first target")]
    StartAway {
        /// The largest difference of a joint, rad, or lengths over the length that counts as much as 1 rad.
        distance: f64,
        /// That solution.
        nearest: Vec<f64>,
    },
    /// A target that is not finite, or no rotation.
    #[error("the target at {at} is not finite, or no rotation")]
    Target {
        /// The parameter of the path.
        at: f64,
    },
    /// No continuous joint path goes on.
    #[error("no continuous joint path beyond {at}, on the branch {branch}: {obstacle}")]
    NoPath {
        /// The parameter that a joint path reaches.
        at: f64,
        /// The branch there.
        branch: Branch,
        /// The reason.
        obstacle: Obstacle,
    },
}
