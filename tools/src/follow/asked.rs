//! The task of a motion, and why it is refused.

use denhart::Residual;
use denhart::follow::{self, FollowError};
use denhart_dynamic::plan::{PathError, PlanError, PlanSettings, TargetPath};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicView, WholeTarget};

use crate::times::Times;

/// The tolerance relative to the reach.
const TOLERANCE: f64 = 1e-5;
/// The most rows: a smaller period is more likely a mistake.
const MOST_ROWS: f64 = 1e7;
/// Intervals of the path that a plan begins with: so many between two poses, and over the whole path.
const BETWEEN_POSES: usize = 4;
const FEWEST: usize = 256;

/// The path or its times: one of them is kept where the rates of the joints do not allow both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Keep {
    /// The tool keeps to the path and slows down.
    Path,
    /// The tool keeps the times of the poses and deviates.
    Time,
}

/// Greatest velocities and accelerations, rad or length unit per s and s^2; accelerations may be infinite.
#[derive(Debug, Clone, PartialEq)]
pub struct Rates {
    /// Velocities, finite and above 0.
    pub velocity: Vec<f64>,
    /// Accelerations, above 0.
    pub acceleration: Vec<f64>,
}

impl Rates {
    /// The rates of the arm file; infinite where it has none.
    #[must_use]
    pub fn of_file(arm: &DynamicArm) -> Self {
        Rates { velocity: arm.max_velocity().collect(), acceleration: arm.max_acceleration().collect() }
    }

    /// The rates of an arm with so many joints.
    fn of<const N: usize>(&self) -> follow::Rates<f64, N> {
        let mut rates = follow::Rates::velocity([f64::INFINITY; N]);
        for (place, value) in rates.velocity.iter_mut().zip(&self.velocity) {
            *place = *value;
        }
        for (place, value) in rates.acceleration.iter_mut().zip(&self.acceleration) {
            *place = *value;
        }
        rates
    }
}

/// A path, and the bounds of a motion along it.
#[derive(Debug, Clone)]
pub struct Asked<'a> {
    /// The arm.
    pub arm: &'a DynamicArm,
    pub(super) path: TargetPath,
    pub(super) is_timed: bool,
    /// Joint values at the first pose; without them the best of all solutions.
    pub start: Option<Vec<f64>>,
    /// The rates of the joints.
    pub rates: Rates,
    /// Largest distance of the tool from the path that is kept, length unit. A turn counts as that of a point at the reach.
    pub tolerance: f64,
    /// Time between two rows, s.
    pub period: f64,
    /// The rates are those of the motors, which the arm file's `coupling` links to the joints.
    pub motor_rates: bool,
}

impl<'a> Asked<'a> {
    /// The path through targets, with the values that the inverse takes beside them, at these times, s: with the rates of the
    /// arm file, a tolerance of 1e-5 of the reach and rows of 1 ms.
    ///
    /// # Errors
    /// Targets and times that are no path.
    pub fn new(arm: &'a DynamicArm, targets: &[WholeTarget], times: Option<&[f64]>) -> Result<Self, PathError> {
        let path = TargetPath::new(targets, times, reach(arm))?;
        let (rates, tolerance) = (Rates::of_file(arm), TOLERANCE * reach(arm));
        let is_timed = times.is_some();
        Ok(Self { arm, path, is_timed, start: None, rates, tolerance, period: 0.001, motor_rates: false })
    }

    /// Returns true if the path's parameter is a time.
    #[must_use]
    pub const fn is_timed(&self) -> bool {
        self.is_timed
    }

    /// The path's last parameter.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.path.end()
    }

    /// The target at a parameter.
    pub(super) fn at(&self, at: f64) -> WholeTarget {
        self.path.at(at)
    }

    /// Refuses numbers that no motion keeps.
    pub(super) fn check(&self) -> Result<(), Refused> {
        let is_positive = |value: f64| value > 0.0 && value.is_finite();
        if !is_positive(self.period) {
            return Err(Refused::Period(self.period));
        }
        if !is_positive(self.tolerance) {
            return Err(Refused::Tolerance(self.tolerance));
        }
        let Rates { velocity, acceleration } = &self.rates;
        let lacking = self.arm.joint_names().zip(velocity).filter(|(_, velocity)| **velocity == f64::INFINITY);
        let lacking: Vec<String> = lacking.map(|(name, _)| name.to_owned()).collect();
        if !lacking.is_empty() {
            return Err(Refused::NoVelocity(lacking));
        }
        let joints = self.arm.joints();
        let start = self.start.as_ref().map_or(joints, Vec::len);
        for found in [velocity.len(), acceleration.len(), start] {
            if found != joints {
                return Err(DynamicError::Joints { expected: joints, found }.into());
            }
        }
        Ok(())
    }

    /// The rates of an arm with so many joints.
    pub(super) fn rates<const N: usize>(&self) -> follow::Rates<f64, N> {
        self.rates.of()
    }

    /// The settings of a plan.
    pub(super) fn settings<const N: usize>(&self, view: &DynamicView<'_, N>) -> Result<PlanSettings<N>, Refused> {
        let rates = self.rates::<N>();
        let tolerance = Residual { position: self.tolerance, orientation: self.tolerance / reach(self.arm) };
        let mut settings = PlanSettings::new(rates.velocity, rates.acceleration, tolerance);
        if self.motor_rates {
            settings = settings.linked(|q| view.to_motor(q));
        }
        let intervals = (BETWEEN_POSES * self.path.stretches()).max(FEWEST);
        Ok(PlanSettings { start: self.start()?, is_timed: self.is_timed, intervals, ..settings })
    }

    /// The times of rows: whole periods up to a time.
    pub(super) fn times(&self, duration: f64) -> Result<Times, Refused> {
        let rows = duration / self.period;
        let refused = Refused::Rows { period: self.period, duration, rows };
        if rows > MOST_ROWS {
            return Err(refused);
        }
        Times::new(0.0, duration, self.period).map_err(|_| refused)
    }

    /// The joint values of the start, for an arm with so many joints.
    pub(super) fn start<const N: usize>(&self) -> Result<Option<[f64; N]>, Refused> {
        let wrong = |_| DynamicError::Joints { expected: N, found: self.arm.joints() };
        Ok(self.start.as_deref().map(<[f64; N]>::try_from).transpose().map_err(wrong)?)
    }
}

/// The reach of an arm.
fn reach(arm: &DynamicArm) -> f64 {
    arm.program().inverse.as_ref().map_or(1.0, |inverse| inverse.constants.reach)
}

/// Why there is no motion.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// Another number of joints than 2 to 8.
    #[error("follow takes arms of 2 to 8 joints, and this one has {0}")]
    Joints(usize),
    /// A period that is no time.
    #[error("{0} is no time between rows")]
    Period(f64),
    /// More rows than a motion should have.
    #[error("{period} s gives {rows:.0} rows for {duration:.3} s")]
    Rows {
        /// The period, s.
        period: f64,
        /// The duration of the motion, s.
        duration: f64,
        /// The rows.
        rows: f64,
    },
    /// A tolerance that is no length.
    #[error("{0} is no distance from the path")]
    Tolerance(f64),
    /// Joints of these names have no greatest velocity.
    #[error("no velocity of {}", .0.join(", "))]
    NoVelocity(Vec<String>),
    /// The times of a path without times cannot be kept.
    #[error("the poses have no times")]
    Untimed,
    /// A plan that is refused for its settings.
    #[error("{0}")]
    Plan(PlanError),
    /// A follower that is refused for its settings.
    #[error("{0}")]
    Follow(#[from] FollowError),
    /// An arm without inverse; another number of values than of joints.
    #[error("{0}")]
    Arm(#[from] DynamicError),
    /// The call was ended.
    #[error("ended before its time")]
    Ended,
}
