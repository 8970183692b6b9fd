//! Plans along a path: a continuous joint path through all branches and turns, then times within the rates.
//!
//! A path is a function from its parameter, 0 to `end`, to a target of the arm. A plan looks at all of it before the arm
//! moves. [`JointPath::new`] finds the joint values, or the place where no continuous path goes on and why;
//! [`JointPath::timed`] finds how fast the arm may go.
//!
//! ```
//! use denhart::Residual;
//! use denhart_dynamic::plan::{JointPath, PlanSettings};
//! use denhart_dynamic::{DynamicArm, DynamicTarget, WholeTarget};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let arm = DynamicArm::from_yaml(
//!     "
//! name: elbow
//! convention: standard
//! units: {length: m, angle: deg}
//! joints:
//!   - {a: 0.3, alpha: 0, d: 0, theta: 0}
//!   - {a: 0.2, alpha: 0, d: 0, theta: 0}
//! ",
//! )?;
//! let arm = arm.view::<2>()?;
//! let line = |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([0.3, 0.2 * s - 0.1]));
//! let tolerance = Residual { position: 5e-6, orientation: 1e-5 };
//! let settings = PlanSettings { start: Some([-1.1, 1.5]), ..PlanSettings::new([2.0, 3.0], [20.0, 30.0], tolerance) };
//! let error = JointPath::new(&arm, &line, 1.0, &settings, &mut |_| {}).unwrap_err();
//! assert!(error.to_string().contains("start"));
//! let plan = JointPath::new(&arm, &line, 1.0, &PlanSettings { start: None, ..settings }, &mut |_| {})?;
//! let trajectory = plan.timed();
//! assert!(trajectory.duration() > 0.1 && trajectory.at(0.0).velocity == [0.0, 0.0]);
//! # Ok(())
//! # }
//! ```

mod curve;
mod error;
mod interpolation;
mod search;
mod times;

use denhart::follow::{product, slopes};
use denhart::{Branch, InverseKinematics, Residual};

use curve::Curve;
pub use error::{Obstacle, PlanError};
pub use interpolation::{PathError, TargetPath};
pub use times::{Trajectory, TrajectoryPoint};

/// The bounds of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanSettings<const N: usize> {
    /// Greatest velocity of each joint, or motor, rad/s or length unit/s; finite and above 0.
    pub velocity: [f64; N],
    /// Greatest acceleration of each joint, or motor, rad/s^2 or length unit/s^2; above 0, infinite for none.
    pub acceleration: [f64; N],
    /// Largest difference of the tool from the path, length unit and rad; finite and above 0. Their quotient is the length
    /// that counts as much as 1 rad.
    pub tolerance: Residual<f64>,
    /// Joint values at the start of the path; without them any solution of its first target within the limits.
    pub start: Option<[f64; N]>,
    /// The path's parameter is a time, s: the arm is never ahead of it. Without it the arm goes as fast as its joints can.
    pub is_timed: bool,
    /// Intervals of the path that the plan begins with; they are halved where needed.
    pub intervals: usize,
    /// The rates are those of motors that are linked, `motor = A q + b`: this is A. Without it they are those of the joints.
    pub motors: Option<[[f64; N]; N]>,
}

/// A velocity above this, rad/s or length unit/s, counts as this in the length of a curve: its knots stand closer then. The
/// motion keeps to the velocity itself.
const FASTEST: f64 = 1e3;
/// A velocity up to this is refused: the times of a motion would have no end.
const SLOWEST: f64 = 1e-12;

impl<const N: usize> PlanSettings<N> {
    /// Settings with these rates and this tolerance: no start, no times, 256 intervals.
    #[must_use]
    pub const fn new(velocity: [f64; N], acceleration: [f64; N], tolerance: Residual<f64>) -> Self {
        PlanSettings { velocity, acceleration, tolerance, start: None, is_timed: false, intervals: 256, motors: None }
    }

    /// The rates are those of motors that are linked, `motor = A q + b`: the arm's `to_motor`.
    #[must_use]
    pub fn linked(self, to_motor: impl Fn(&[f64; N]) -> [f64; N]) -> Self {
        PlanSettings { motors: Some(slopes(to_motor)), ..self }
    }

    /// The ways, or rates, of the motors at those of the joints.
    fn of_motors(&self, joints: [f64; N]) -> [f64; N] {
        self.motors.as_ref().map_or(joints, |matrix| product(matrix, &joints))
    }

    /// The velocities by which the length of a curve counts. One far beyond what a joint does would make it 0.
    fn paces(&self) -> [f64; N] {
        self.velocity.map(|velocity| velocity.min(FASTEST))
    }

    /// The ways of the motors between two joint vectors.
    fn way(&self, from: &[f64; N], to: &[f64; N]) -> [f64; N] {
        let mut way = *to;
        for (to, from) in way.iter_mut().zip(from) {
            *to -= from;
        }
        self.of_motors(way)
    }

    /// Returns true if a miss is within the tolerance; false for one that is not a number.
    fn allows(&self, missed: &Residual<f64>) -> bool {
        missed.position <= self.tolerance.position && missed.orientation <= self.tolerance.orientation
    }

    /// The length that counts as much as 1 rad.
    fn length(&self) -> f64 {
        self.tolerance.position / self.tolerance.orientation
    }

    /// The time of a way at full rate, s.
    fn time(&self, from: &[f64; N], to: &[f64; N]) -> f64 {
        let way = self.way(from, to);
        way.iter().zip(&self.velocity).fold(0.0, |most: f64, (way, velocity)| most.max(way.abs() / velocity))
    }
}

/// A place of the path with its joint values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSample<const N: usize> {
    /// The path's parameter.
    pub at: f64,
    /// Joint values, rad or length unit. Turns are counted: neighbors differ by less than half a turn.
    pub q: [f64; N],
    /// The branch of the solution; [`Branch::NONE`] between solutions.
    pub branch: Branch,
}

/// A continuous joint path whose tool keeps to a path of targets within a tolerance.
#[derive(Debug, Clone, PartialEq)]
pub struct JointPath<const N: usize> {
    settings: PlanSettings<N>,
    limits: [[f64; 2]; N],
    samples: Vec<JointSample<N>>,
    curve: Curve<N>,
}

impl<const N: usize> JointPath<N> {
    /// The fastest continuous joint path along `path`, from its parameter 0 to `end`.
    ///
    /// Dynamic programming over all branches and turns: the cost of a way is its time at full rate. Between two places a way
    /// stands if no joint moves by more than 0.05 rad and the tool at the joints' middle is within the tolerance of the path's
    /// middle; at quarters too where the branch changes. Else the interval is halved, 26 times at most. A joint without
    /// limits may turn without end. At the first place each joint without limits has one turn.
    ///
    /// `progress` is told the parameter that is reached, now and then.
    ///
    /// # Errors
    /// Settings that are none; a start outside the limits, or more than 1e-3 rad away from the path's first target; a target
    /// that is none; the place where no continuous path goes on.
    pub fn new<A: InverseKinematics<f64, N>>(
        arm: &A,
        path: &impl Fn(f64) -> A::Target,
        end: f64,
        settings: &PlanSettings<N>,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Self, PlanError> {
        check(end, settings)?;
        let samples = search::search(arm, path, end, settings, progress)?;
        let curve = Curve::through(&samples, arm, path, settings);
        Ok(JointPath { settings: *settings, limits: arm.limits(), samples, curve })
    }

    /// The places that the plan has looked at, in the order of the path.
    #[must_use]
    pub fn samples(&self) -> &[JointSample<N>] {
        &self.samples
    }

    /// The number of knots of its curve.
    #[must_use]
    pub fn knots(&self) -> usize {
        self.curve.knots.len()
    }

    /// Changes of the branch: the parameter behind each, with the branches before and after it.
    pub fn crossings(&self) -> impl Iterator<Item = (f64, Branch, Branch)> {
        let pairs = self.samples.iter().zip(self.samples.iter().skip(1));
        pairs.filter(|(a, b)| a.branch != b.branch).map(|(a, b)| (b.at, a.branch, b.branch))
    }

    /// The fastest motion along the joint path within velocities and accelerations, from rest to rest.
    ///
    /// The joint path is a curve of cubics, whose knots follow its curvature: between two knots its direction turns by a few
    /// degrees at most. The square of the speed along the curve is linear between knots; a pass backward finds the largest
    /// ones from which the end is reached, a pass forward takes them. Method: Pham and Pham 2018, "A new approach to
    /// time-optimal path parameterization based on reachability analysis". Both rates are bounded all along each
    /// stretch between knots. Without a finite acceleration the motion need not begin or end at rest.
    #[must_use]
    pub fn timed(&self) -> Trajectory<N> {
        Trajectory::new(&self.curve, &self.settings, self.limits)
    }
}

/// Refuses settings with which nothing can be planned.
fn check<const N: usize>(end: f64, settings: &PlanSettings<N>) -> Result<(), PlanError> {
    for (joint, (velocity, acceleration)) in settings.velocity.iter().zip(&settings.acceleration).enumerate() {
        if !(*velocity > SLOWEST && velocity.is_finite()) {
            return Err(PlanError::Velocity { joint, velocity: *velocity });
        }
        if acceleration.is_nan() || *acceleration <= 0.0 {
            return Err(PlanError::Acceleration { joint, acceleration: *acceleration });
        }
    }
    let Residual { position, orientation } = settings.tolerance;
    for tolerance in [position, orientation, settings.length()] {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(PlanError::Tolerance { position, orientation });
        }
    }
    if !(end > 0.0 && end.is_finite()) {
        return Err(PlanError::End { end });
    }
    Ok(())
}

#[cfg(test)]
mod tests;
