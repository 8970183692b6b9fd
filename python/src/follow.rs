//! Motions along a path of poses.

use std::time::Instant;

use denhart::Status;
use denhart::follow::FollowError;
use denhart_dynamic::plan::{PathError, PlanError};
use denhart_dynamic::{DynamicTarget, WholeTarget};
use denhart_tools::follow::{Asked, Keep, Refused, Row, follow};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arm::Arm;
use crate::array::{Numbers, filled, shown};
use crate::error;
use crate::inverse::{Beside, Targets};
use crate::share::SIGNALS;

/// The argument of `follow` that has the values of redundant joints too.
const START: &str = "start= with joint values at the first target";

/// Joint values over time that bring the tool along a path, as `Arm.follow` gives them: plain arrays.
///
/// M is the number of rows, in the order of time; 0 where no motion brings the tool along the path, and `obstacle` says why.
#[pyclass(frozen, module = "denhart", get_all)]
pub struct Motion {
    /// The side that was kept: "path" or "time".
    keep: String,
    /// Times, (M,) float64, s.
    t: Py<PyAny>,
    /// Joint values, (M, n) float64: rad, the arm's length unit for prismatic joints.
    q: Py<PyAny>,
    /// Their rates, (M, n) float64, 1/s.
    velocity: Py<PyAny>,
    /// Place on the path, (M,) float64: its time, s, or the length of the path in the arm's length unit.
    at: Py<PyAny>,
    /// Distance of the tool point from the path, (M,) float64, in the arm's length unit.
    off_position: Py<PyAny>,
    /// Angle of the tool to the path, (M,) float64, rad.
    off_orientation: Py<PyAny>,
    /// The branch of each row, a tuple of M texts, as `Solution.branch` has them; "" where it has no name.
    branch: Py<PyAny>,
    /// How each row stands to its target, a tuple of M texts: "kept" of a path that is kept; else "exact", or what holds the
    /// tool away: "rates", "limits", "reach".
    tracking: Py<PyAny>,
    /// Why the tool does not come to the end of the path, an `Obstacle`; None where it does.
    obstacle: Option<Py<Obstacle>>,
}

/// The place where no continuous path goes on, or where the arm is away from the path when the time is over.
#[pyclass(frozen, module = "denhart", get_all)]
pub struct Obstacle {
    /// Place on the path: its time, s, or the length of the path in the arm's length unit.
    at: f64,
    /// The branch there; "" where it has no name.
    branch: String,
    /// The reason, in words.
    reason: String,
}

#[pymethods]
impl Obstacle {
    fn __repr__(&self) -> String {
        let on = if self.branch.is_empty() { String::new() } else { format!(", {}", self.branch) };
        format!("<Obstacle at {:.6}{on}: {}>", self.at, self.reason)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let parts = (self.at, &self.branch, &self.reason).into_pyobject(py)?;
        Ok((py.get_type::<Self>().getattr("_of")?, parts))
    }

    /// The obstacle of these parts, for pickles.
    #[staticmethod]
    fn _of(at: f64, branch: String, reason: String) -> Self {
        Self { at, branch, reason }
    }
}

#[pymethods]
impl Motion {
    /// Time of the last row, s; 0 without rows.
    #[getter]
    fn duration(&self, py: Python<'_>) -> PyResult<f64> {
        match self.t.bind(py).len()? {
            0 => Ok(0.0),
            rows => self.t.bind(py).get_item(rows - 1)?.extract(),
        }
    }

    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.t.bind(py).len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let shape = self.q.bind(py).getattr("shape")?;
        let (keep, duration) = (&self.keep, self.duration(py)?);
        let obstacle = match &self.obstacle {
            Some(obstacle) => format!(", {}", obstacle.get().__repr__()),
            None => String::new(),
        };
        Ok(format!("<Motion keeps {keep}: q {shape}, {duration:.6} s{obstacle}>"))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let arrays = [&self.t, &self.q, &self.velocity, &self.at, &self.off_position, &self.off_orientation];
        let arrays = PyTuple::new(py, arrays.map(|part| part.clone_ref(py)))?;
        let obstacle = self.obstacle.as_ref().map(|obstacle| obstacle.clone_ref(py));
        let parts = (&self.keep, arrays, self.branch.clone_ref(py), self.tracking.clone_ref(py), obstacle);
        Ok((py.get_type::<Self>().getattr("_of")?, parts.into_pyobject(py)?))
    }

    /// The motion of these parts, for pickles.
    #[staticmethod]
    fn _of(
        keep: String,
        arrays: [Py<PyAny>; 6],
        branch: Py<PyAny>,
        tracking: Py<PyAny>,
        obstacle: Option<Py<Obstacle>>,
    ) -> Self {
        let [t, q, velocity, at, off_position, off_orientation] = arrays;
        Self { keep, t, q, velocity, at, off_position, off_orientation, branch, tracking, obstacle }
    }
}

impl Motion {
    fn new(py: Python<'_>, keep: &str, joints: usize, motion: denhart_tools::follow::Motion) -> PyResult<Self> {
        let rows = &motion.rows;
        let count = rows.len();
        let column = |of: fn(&Row) -> f64| filled(py, &[count], rows.iter().map(of)).map(Bound::unbind);
        let table = |of: fn(&Row) -> &[f64]| {
            filled(py, &[count, joints], rows.iter().flat_map(|row| of(row).iter().copied())).map(Bound::unbind)
        };
        let obstacle = motion.obstacle.as_ref().map(|obstacle| {
            let denhart_tools::follow::Obstacle { at, branch, reason } = obstacle.clone();
            Py::new(py, Obstacle { at, branch, reason })
        });
        Ok(Self {
            keep: keep.to_owned(),
            t: column(|row| row.t)?,
            q: table(|row| &row.q)?,
            velocity: table(|row| &row.velocity)?,
            at: column(|row| row.at)?,
            off_position: column(|row| row.off.position)?,
            off_orientation: column(|row| row.off.orientation)?,
            branch: PyTuple::new(py, rows.iter().map(|row| row.branch.as_str()))?.into_any().unbind(),
            tracking: PyTuple::new(py, rows.iter().map(|row| row.tracking))?.into_any().unbind(),
            obstacle: obstacle.transpose()?,
        })
    }
}

/// Arguments of `follow`.
pub struct Path<'a, 'py> {
    pub targets: &'a Bound<'py, PyAny>,
    pub dt: f64,
    pub times: Option<&'a Bound<'py, PyAny>>,
    pub keep: &'a str,
    pub start: Option<&'a Bound<'py, PyAny>>,
    pub given: Option<&'a Bound<'py, PyAny>>,
    pub tolerance: Option<f64>,
    pub max_velocity: Option<&'a Bound<'py, PyAny>>,
    pub max_acceleration: Option<&'a Bound<'py, PyAny>>,
    pub motor_rates: bool,
}

impl Path<'_, '_> {
    /// The motion along the path.
    pub fn follow(&self, py: Python<'_>, arm: &Arm) -> PyResult<Motion> {
        let solver = &arm.arm;
        let keep = match self.keep {
            "path" => Keep::Path,
            "time" => Keep::Time,
            other => {
                return Err(error::value(format!(
                    "keep: expected \"path\" (the tool keeps to the path and slows down) or \"time\" (it keeps the times of \
                     the targets and deviates), found {other:?}"
                )));
            }
        };
        let task = solver.task().map_err(|error| error::dynamic(py, &error))?;
        let numbers = Numbers::read("targets", self.targets)?;
        let targets = Targets::read("targets", task, &numbers)?;
        let rows = targets.len();
        let start = self.start.map(|start| arm.start(start)).transpose()?;
        let held = match (&start, self.given) {
            (Some(start), None) => Some(solver.held(start).map_err(|error| error::dynamic(py, &error))?),
            _ => None,
        };
        let given = self.given.map(|given| Numbers::read("given", given)).transpose()?;
        let beside = match &held {
            Some(_) => Beside::NOTHING,
            None => Beside::given(py, solver, given.as_ref(), rows, START)?,
        };
        let mut whole = Vec::with_capacity(rows);
        for (index, target) in targets.each(solver).enumerate() {
            let given = held.as_deref().unwrap_or_else(|| beside.of(index));
            // The inverse says whether a matrix is a rotation: a path would take the nearest one for any.
            let is_bad = |target: &DynamicTarget| {
                given.iter().all(|value| value.is_finite())
                    && solver.inverse(target, given).is_ok_and(|found| found.status() == Status::BadTarget)
            };
            match target {
                Some(target) if !is_bad(&target) => whole.push(WholeTarget::new(target, given)),
                _ => {
                    let rotation = if task == "pose" { ", and a 3 x 3 matrix that is a rotation to 1e-3" } else { "" };
                    return Err(error::value(format!("targets[{index}]: expected finite numbers{rotation}")));
                }
            }
        }
        let times = self.times.map(|times| Numbers::read("times", times)).transpose()?;
        let times = match &times {
            None => None,
            Some(times) if *times.shape() == [rows] => Some(times.values()?),
            Some(times) => {
                return Err(error::value(format!(
                    "times: expected shape ({rows},), one for each target, found {}",
                    shown(times.shape())
                )));
            }
        };
        let mut asked = Asked::new(solver, &whole, times).map_err(|error| refused_path(&error, times))?;
        asked.period = self.dt;
        asked.start = start;
        asked.motor_rates = self.motor_rates;
        if let Some(tolerance) = self.tolerance {
            asked.tolerance = tolerance;
        }
        if let Some(velocity) = rates(arm, "max_velocity", self.max_velocity)? {
            asked.rates.velocity = velocity;
        }
        if let Some(acceleration) = rates(arm, "max_acceleration", self.max_acceleration)? {
            asked.rates.acceleration = acceleration;
        }
        let mut looked = Instant::now();
        let mut raised = None;
        let motion = py.detach(|| {
            follow(&asked, keep, &mut |_| {
                if looked.elapsed() >= SIGNALS {
                    raised = Python::attach(|py| py.check_signals()).err();
                    looked = Instant::now();
                }
                raised.is_none()
            })
        });
        match (motion, raised) {
            (_, Some(error)) => Err(error),
            (Ok(motion), None) => Motion::new(py, self.keep, solver.joints(), motion),
            (Err(error), None) => Err(refused(py, arm, &error)),
        }
    }
}

/// Greatest rates of the joints.
pub fn rates(arm: &Arm, name: &str, rates: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Vec<f64>>> {
    let Some(rates) = rates else { return Ok(None) };
    let numbers = Numbers::read(name, rates)?;
    let rates = match numbers.values()? {
        [one] if numbers.shape().is_empty() => vec![*one; arm.arm.joints()],
        _ => arm.joints(name, rates)?,
    };
    let rate_of = |is_wrong: fn(f64) -> bool| arm.arm.joint_names().zip(&rates).find(|(_, rate)| is_wrong(**rate));
    if let Some((joint, rate)) = rate_of(|rate| rate.is_nan() || rate <= 0.0) {
        return Err(error::value(format!("{name}: expected a rate above 0 for each joint, found {rate} of {joint}")));
    }
    if let Some((joint, rate)) = rate_of(f64::is_infinite).filter(|_| name == "max_velocity") {
        return Err(error::value(format!("{name}: expected a finite rate for each joint, found {rate} of {joint}")));
    }
    Ok(Some(rates))
}

/// The exception of targets that are no path.
fn refused_path(error: &PathError, times: Option<&[f64]>) -> PyErr {
    let time = |index: usize| times.and_then(|times| times.get(index)).copied().unwrap_or(f64::NAN);
    error::value(match *error {
        PathError::TooShort => "targets: expected two targets at least that differ".to_owned(),
        PathError::Unsorted(index) => format!(
            "times[{index}]: expected finite times that rise, found {}{}",
            time(index),
            index.checked_sub(1).map_or_else(String::new, |before| format!(" after {}", time(before)))
        ),
        PathError::NotFinite(index) => format!("targets[{index}]: expected finite numbers, in given= too"),
        PathError::HalfTurn(index) => format!(
            "targets[{index}]: turned by half a turn from the one before it, so that its way is not determined: put a \
             target between them"
        ),
        ref other => format!("targets: {other}"),
    })
}

/// The exception of what is asked for and refused.
pub fn refused(py: Python<'_>, arm: &Arm, refused: &Refused) -> PyErr {
    error::value(match refused {
        Refused::Period(dt) => format!("dt: expected a finite time above 0 in s, found {dt}"),
        Refused::Rows { .. } => format!("dt: {refused}: expected a longer one"),
        Refused::Tolerance(found) => {
            format!("tolerance: expected a length above 0 in {}, found {found}", arm.arm.length_unit())
        }
        Refused::NoVelocity(joints) => format!(
            "max_velocity: the arm file has no velocity of {}: write max_velocity= with a finite rate above 0 for each joint",
            joints.join(", ")
        ),
        Refused::Untimed => "times: keep=\"time\" needs the time of each target in s, (N,)".to_owned(),
        Refused::Plan(PlanError::StartAway { nearest, .. }) => format!(
            "start: these joint values are not at the first target; the nearest solution there is {nearest:?}; leave \
             start= out for the best of all"
        ),
        Refused::Plan(PlanError::Velocity { .. }) => format!("max_velocity: {refused}"),
        Refused::Plan(PlanError::Acceleration { .. }) => format!("max_acceleration: {refused}"),
        Refused::Plan(PlanError::Target { .. }) => format!("targets: {refused}"),
        Refused::Plan(PlanError::StartOutside { .. }) => format!("start: {refused}"),
        Refused::Follow(FollowError::Start(_) | FollowError::Combined(_)) => format!("start: {refused}"),
        Refused::Follow(_) => format!("max_velocity: {refused}"),
        Refused::Arm(error) => return error::dynamic(py, error),
        other => return error::arm(py, other),
    })
}
