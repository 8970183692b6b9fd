//! A follower of a target that moves, tick by tick.

use std::sync::{Mutex, MutexGuard, PoisonError};

use denhart::follow::{self, Crossing, FollowSettings, Rates};
use denhart_dynamic::{DynamicError, DynamicView, ViewSolutions, WholeTarget};
use denhart_tools::follow::Refused;
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};

use crate::arm::Arm;
use crate::array::filled;
use crate::follow::{rates, refused};
use crate::inverse::given_values;
use crate::{error, target};

/// One follower serves all arms: joints beyond an arm's own stand still.
const MOST: usize = 8;

/// A follower of a target that moves: `Arm.follower` begins one, at rest.
///
/// Each call of `step` is a tick, `dt` s after the last one. Every joint stays within its rate, its acceleration and its
/// range; the tool is on the target wherever these allow, and each `Step` says whether it is. Any number of threads may use
/// one: calls wait for each other.
///
///     >>> follower = arm.follower(q, 0.001, max_velocity=np.full(6, 3.0), max_acceleration=np.full(6, 24.0))
///     >>> while running:
///     ...     step = follower.step(target())
///     ...     send(step.q)
#[pyclass(frozen, module = "denhart")]
pub struct Follower {
    arm: Py<Arm>,
    dt: f64,
    /// Values beside a target that comes without.
    given: Vec<f64>,
    state: Mutex<State>,
}

struct State {
    follower: follow::Follower<f64, MOST>,
    found: ViewSolutions<MOST>,
}

/// Arguments of `follower`.
pub struct Beginning<'a, 'py> {
    pub start: &'a Bound<'py, PyAny>,
    pub dt: f64,
    pub max_velocity: Option<&'a Bound<'py, PyAny>>,
    pub max_acceleration: Option<&'a Bound<'py, PyAny>>,
    pub given: Option<&'a Bound<'py, PyAny>>,
    pub length: Option<f64>,
    pub crossing: &'a str,
    pub motor_rates: bool,
}

impl Beginning<'_, '_> {
    /// The follower, at rest.
    pub fn follower(&self, py: Python<'_>, arm: Py<Arm>) -> PyResult<Follower> {
        let ours = arm.get();
        let solver = &ours.arm;
        let view = view(py, ours)?;
        let start = ours.start(self.start)?;
        let given = match self.given {
            Some(given) => given_values(solver, Some(given))?,
            None => solver.held(&start).map_err(|error| error::dynamic(py, &error))?.to_vec(),
        };
        if let Some(value) = given.iter().find(|value| !value.is_finite()) {
            return Err(error::value(format!("given: expected finite values, found {value}")));
        }
        let crossing = match self.crossing {
            "exact" => Crossing::Exact,
            "wrist" => Crossing::Wrist,
            "any" => Crossing::Any,
            other => {
                return Err(error::value(format!(
                    "crossing: expected \"exact\", \"wrist\" or \"any\", the singularities through which a deviation may \
                     lead, found {other:?}"
                )));
            }
        };
        if !(self.dt > 0.0 && self.dt.is_finite()) {
            return Err(refused(py, ours, &Refused::Period(self.dt)));
        }
        let velocity = rates(ours, "max_velocity", self.max_velocity)?;
        let velocity = velocity.unwrap_or_else(|| solver.max_velocity().collect());
        let acceleration = rates(ours, "max_acceleration", self.max_acceleration)?;
        let acceleration = acceleration.unwrap_or_else(|| solver.max_acceleration().collect());
        let lacking = solver.joint_names().zip(&velocity).filter(|(_, velocity)| !velocity.is_finite());
        let lacking: Vec<String> = lacking.map(|(name, _)| name.to_owned()).collect();
        if !lacking.is_empty() {
            return Err(refused(py, ours, &Refused::NoVelocity(lacking)));
        }
        // Joints beyond the arm's own have rates that any period allows.
        let beyond = 1.0 / self.dt;
        let rates = Rates { velocity: padded(&velocity, beyond), acceleration: padded(&acceleration, beyond) };
        let mut settings = FollowSettings::new(self.dt, rates).crossing(crossing);
        if let Some(length) = self.length {
            if !(length > 0.0 && length.is_finite()) {
                let unit = solver.length_unit();
                return Err(error::value(format!("length: expected a length above 0 in {unit}, found {length}")));
            }
            settings = settings.length(length);
        }
        if self.motor_rates {
            settings = settings.linked(|q| view.to_motor(q), |motor| view.from_motor(motor));
        }
        let follower = follow::Follower::new(&view, settings, &padded(&start, 0.0))
            .map_err(|error| refused(py, ours, &Refused::Follow(error)))?;
        let state = Mutex::new(State { follower, found: ViewSolutions::default() });
        Ok(Follower { arm, dt: self.dt, given, state })
    }
}

/// The arm as the follower takes it.
fn view<'a>(py: Python<'_>, arm: &'a Arm) -> PyResult<DynamicView<'a, MOST>> {
    arm.arm.padded_view().map_err(|reason| match reason {
        DynamicError::Joints { expected, .. } => refused(py, arm, &Refused::Joints(expected)),
        other => error::dynamic(py, &other),
    })
}

/// The values of the arm's joints, and of those beyond.
fn padded(values: &[f64], beyond: f64) -> [f64; MOST] {
    let mut padded = [beyond; MOST];
    for (place, value) in padded.iter_mut().zip(values) {
        *place = *value;
    }
    padded
}

impl Follower {
    /// The state; a call that failed half way has left one that is whole.
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn answer(&self, step: &follow::Step<f64, MOST>) -> Step {
        let joints = self.arm.get().arm.joints();
        let own = |values: &[f64]| values.iter().copied().take(joints).collect();
        let name = |branch: denhart::Branch| match branch {
            denhart::Branch::NONE => String::new(),
            branch => branch.to_string(),
        };
        Step {
            q: own(&step.q),
            velocity: own(&step.velocity),
            tracking: step.tracking.to_string(),
            deviation: step.deviation,
            branch: name(step.branch),
            crossed: step.crossed.map(name),
            held: step.held.iter().collect(),
            remaining: step.remaining,
        }
    }
}

#[pymethods]
impl Follower {
    /// A tick towards `target`, which is read as that of `Arm.inverse`. `given`: the values of the redundant joints that
    /// `arm.given` names, by default those with which the follower began.
    ///
    /// A target that is not finite, or whose matrix is no rotation, has the tracking "target": the arm brakes.
    #[pyo3(signature = (target, given=None))]
    fn step(&self, target: &Bound<'_, PyAny>, given: Option<&Bound<'_, PyAny>>) -> PyResult<Step> {
        let py = target.py();
        let arm = self.arm.get();
        let target = target::read(&arm.arm, target)?;
        let expected = arm.arm.task().map_err(|error| error::dynamic(py, &error))?;
        let found = target.task();
        if expected != found {
            return Err(error::dynamic(py, &DynamicError::Target { expected, found }));
        }
        let target = match given {
            Some(given) => WholeTarget::new(target, &given_values(&arm.arm, Some(given))?),
            None => WholeTarget::new(target, &self.given),
        };
        let view = view(py, arm)?;
        let mut state = self.state();
        let State { follower, found } = &mut *state;
        let step = follower.step(&view, &target, found);
        drop(state);
        Ok(self.answer(&step))
    }

    /// A tick without a target: every joint brakes.
    fn stop(&self, py: Python<'_>) -> PyResult<Step> {
        let view = view(py, self.arm.get())?;
        let step = self.state().follower.stop(&view);
        Ok(self.answer(&step))
    }

    /// Sends the arm to another branch, in words such as "wrist flip", as `Solution.branch` has them: from the next tick on
    /// the solution there is the goal, through whatever singularities lie between. Parts left out match any.
    fn go_to_branch(&self, py: Python<'_>, branch: &str) -> PyResult<()> {
        let branch = crate::inverse::branch(branch)?;
        let view = view(py, self.arm.get())?;
        self.state().follower.go_to_branch(&view, branch);
        Ok(())
    }

    /// Joint values now, (n,) float64: rad, the arm's length unit for prismatic joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let joints = self.arm.get().arm.joints();
        let q = *self.state().follower.q();
        filled(py, &[joints], q)
    }

    /// Time from one tick to the next, s.
    #[getter]
    const fn dt(&self) -> f64 {
        self.dt
    }

    /// The arm that follows.
    #[getter]
    fn arm(&self, py: Python<'_>) -> Py<Arm> {
        self.arm.clone_ref(py)
    }

    fn __repr__(&self) -> String {
        let arm = &self.arm.get().arm;
        let q = *self.state().follower.q();
        let q = crate::solutions::joints(q.get(..arm.joints()).unwrap_or(&q), arm.joint_kinds());
        format!("<Follower of {}: a tick each {} s, at {q}>", arm.model().name, self.dt)
    }
}

/// A tick of a `Follower`.
#[pyclass(frozen, module = "denhart")]
pub struct Step {
    q: Vec<f64>,
    velocity: Vec<f64>,
    tracking: String,
    deviation: [f64; 6],
    branch: String,
    crossed: Option<String>,
    held: Vec<usize>,
    remaining: f64,
}

/// The parts of a step.
type Parts = (Vec<f64>, Vec<f64>, String, [f64; 6], String, Option<String>, Vec<usize>, f64);

#[pymethods]
impl Step {
    /// Joint values at the end of the tick, (n,) float64: rad, the arm's length unit for prismatic joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        filled(py, &[self.q.len()], self.q.iter().copied())
    }

    /// The way to `q` over `dt`, (n,) float64: rad/s or the length unit/s.
    #[getter]
    fn velocity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        filled(py, &[self.velocity.len()], self.velocity.iter().copied())
    }

    /// How the step stands to its target: "exact" is on it. "rates": the branch reaches it, but not in this tick. "limits":
    /// the branch leaves the range of the joints in `held`. "reach": the branch does not reach it, the arm comes as near as it
    /// can. "target": there is none, or it is not finite or no rotation; the arm brakes.
    #[getter]
    fn tracking(&self) -> &str {
        &self.tracking
    }

    /// Twist from the tool to the target, (6,) float64, vx vy vz wx wy wz in the base frame, in the length unit and rad: 0 in
    /// rows that the task leaves open, in exact ticks and without a target.
    #[getter]
    fn deviation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        filled(py, &[6], self.deviation)
    }

    /// Sizes of `deviation`: a distance in the length unit, and an angle in rad.
    #[getter]
    fn residual(&self) -> (f64, f64) {
        let [x, y, z, u, v, w] = self.deviation;
        let size = |x: f64, y: f64, z: f64| x.hypot(y).hypot(z);
        (size(x, y, z), size(u, v, w))
    }

    /// The branch that `q` lies on, as `Solution.branch` has it; "" where it has no name.
    #[getter]
    fn branch(&self) -> &str {
        &self.branch
    }

    /// The branch that was left, in the tick of a crossing; else None.
    #[getter]
    fn crossed(&self) -> Option<&str> {
        self.crossed.as_deref()
    }

    /// Joints that keep the arm from the target, from 0: where `tracking` is "rates" those that cannot be there in this tick,
    /// where it is "limits" those that stand at the end of their range.
    #[getter]
    fn held<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.held)
    }

    /// The least time to the target at full rates, s: 0 in exact ticks, infinite where it cannot be reached.
    #[getter]
    const fn remaining(&self) -> f64 {
        self.remaining
    }

    /// True where `tracking` is "exact".
    #[getter]
    fn is_exact(&self) -> bool {
        self.tracking == "exact"
    }

    fn __repr__(&self) -> String {
        let on = if self.branch.is_empty() { String::new() } else { format!(", {}", self.branch) };
        let (distance, angle) = self.residual();
        format!("<Step {}{on}: off by {distance:.6} and {angle:.6} rad, {:.6} s to go>", self.tracking, self.remaining)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Parts,))> {
        let Self { q, velocity, tracking, deviation, branch, crossed, held, remaining } = self;
        let parts = (
            q.clone(),
            velocity.clone(),
            tracking.clone(),
            *deviation,
            branch.clone(),
            crossed.clone(),
            held.clone(),
            *remaining,
        );
        Ok((PyType::new::<Self>(py).getattr("_of")?, (parts,)))
    }

    /// The step of these parts, for pickles.
    #[staticmethod]
    fn _of(parts: Parts) -> Self {
        let (q, velocity, tracking, deviation, branch, crossed, held, remaining) = parts;
        Self { q, velocity, tracking, deviation, branch, crossed, held, remaining }
    }
}
