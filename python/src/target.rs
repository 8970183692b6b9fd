//! Targets of an inverse.

use denhart::{PlanarPose, PointAngle, PointAxis, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple, PyType};

use crate::array::{self, Numbers, shown};
use crate::error;

/// The last row of a pose may differ from 0 0 0 1 by this much: the rounding of a product of matrices.
const LAST_ROW: f64 = 1e-9;

/// A target for the inverse of an arm, made by one of the named constructors.
///
/// `Arm.inverse` takes the numbers as well; the names say which is which. Angles are rad where the name does not say
/// degrees, lengths are in the arm's `length_unit`.
#[pyclass(frozen, module = "denhart", eq)]
#[derive(Debug, Clone, PartialEq)]
pub struct Target(pub DynamicTarget);

#[pymethods]
impl Target {
    /// Task pose: a 4 x 4 array, a SciPy RigidTransform, or (rotation, point).
    #[staticmethod]
    fn pose(pose: &Bound<'_, PyAny>) -> PyResult<Self> {
        self::pose(pose).map(|pose| Self(DynamicTarget::Pose(pose)))
    }

    /// Task pose: a point (3,), and roll, pitch, yaw (3,) in rad about the fixed axes x, y, z, in that order.
    #[staticmethod]
    fn xyz_rpy(xyz: [f64; 3], rpy: [f64; 3]) -> Self {
        Self(DynamicTarget::Pose(Pose::from_xyz_rpy(xyz, rpy)))
    }

    /// Task pose: a point (3,), and roll, pitch, yaw (3,) in degrees about the fixed axes x, y, z, in that order.
    #[staticmethod]
    fn xyz_rpy_degrees(xyz: [f64; 3], rpy: [f64; 3]) -> Self {
        Self(DynamicTarget::Pose(Pose::from_xyz_rpy_degrees(xyz, rpy)))
    }

    /// Task position: the place of the tool point.
    #[staticmethod]
    fn position(point: [f64; 3]) -> Self {
        Self(DynamicTarget::Position(point))
    }

    /// Task position_axis: the place of the tool point, and the direction of the tool's axis, of any length.
    #[staticmethod]
    fn position_axis(point: [f64; 3], axis: [f64; 3]) -> Self {
        Self(DynamicTarget::PositionAxis(PointAxis::new(point, axis)))
    }

    /// Task position_angle: the place of the tool point, and the tool's angle in the arm's own plane, rad.
    #[staticmethod]
    fn position_angle(point: [f64; 3], angle: f64) -> Self {
        Self(DynamicTarget::PositionAngle(PointAngle::new(point, angle)))
    }

    /// Task position_angle: the place of the tool point, and the tool's angle in the arm's own plane, degrees.
    #[staticmethod]
    fn position_angle_degrees(point: [f64; 3], angle: f64) -> Self {
        Self(DynamicTarget::PositionAngle(PointAngle::from_degrees(point, angle)))
    }

    /// Task planar_pose: the place of the tool point in the base's xy plane, and the tool's turn about z, rad.
    #[staticmethod]
    fn planar_pose(x: f64, y: f64, phi: f64) -> Self {
        Self(DynamicTarget::PlanarPose(PlanarPose::new(x, y, phi)))
    }

    /// Task planar_pose: the place of the tool point in the base's xy plane, and the tool's turn about z, degrees.
    #[staticmethod]
    fn planar_pose_degrees(x: f64, y: f64, phi: f64) -> Self {
        Self(DynamicTarget::PlanarPose(PlanarPose::from_degrees(x, y, phi)))
    }

    /// Task planar_position: the place of the tool point in the base's xy plane.
    #[staticmethod]
    fn planar_position(x: f64, y: f64) -> Self {
        Self(DynamicTarget::PlanarPosition([x, y]))
    }

    fn __hash__(&self) -> u64 {
        array::hash(numbers(&self.0))
    }

    /// The task that the target belongs to, as an arm file names it.
    #[getter]
    fn task(&self) -> &'static str {
        self.0.task()
    }

    /// The numbers: (4, 4) for a pose, else (k,): the point, then the axis or the angle in rad.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match &self.0 {
            DynamicTarget::Pose(pose) => array::filled(py, &[4, 4], matrix(pose)),
            other => {
                let numbers = numbers(other);
                array::filled(py, &[numbers.len()], numbers)
            }
        }
    }

    fn __repr__(&self) -> String {
        let list = |values: &[f64]| format!("[{}]", values.iter().map(f64::to_string).collect::<Vec<_>>().join(", "));
        match &self.0 {
            DynamicTarget::Pose(pose) => {
                let angles = pose.rpy().angles;
                format!("Target.xyz_rpy({}, {})", list(&pose.translation), list(&angles))
            }
            DynamicTarget::Position(point) => format!("Target.position({})", list(point)),
            DynamicTarget::PositionAxis(PointAxis { point, axis, .. }) => {
                format!("Target.position_axis({}, {})", list(point), list(axis))
            }
            DynamicTarget::PositionAngle(PointAngle { point, angle, .. }) => {
                format!("Target.position_angle({}, {angle})", list(point))
            }
            DynamicTarget::PlanarPose(PlanarPose { x, y, phi, .. }) => format!("Target.planar_pose({x}, {y}, {phi})"),
            DynamicTarget::PlanarPosition([x, y]) => format!("Target.planar_position({x}, {y})"),
        }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let make = PyType::new::<Self>(py).getattr(self.0.task())?;
        let arguments = match &self.0 {
            DynamicTarget::Pose(_) => (self.values(py)?,).into_pyobject(py)?,
            DynamicTarget::Position(point) => (*point,).into_pyobject(py)?,
            DynamicTarget::PositionAxis(asked) => (asked.point, asked.axis).into_pyobject(py)?,
            DynamicTarget::PositionAngle(asked) => (asked.point, asked.angle).into_pyobject(py)?,
            DynamicTarget::PlanarPose(asked) => (asked.x, asked.y, asked.phi).into_pyobject(py)?,
            DynamicTarget::PlanarPosition([x, y]) => (*x, *y).into_pyobject(py)?,
        };
        Ok((make, arguments))
    }
}

/// The numbers of a pose as a 4 x 4 matrix, row by row.
pub fn matrix(pose: &Pose<f64>) -> [f64; 16] {
    let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
    let [x, y, z] = pose.translation;
    [a, b, c, x, d, e, f, y, g, h, i, z, 0.0, 0.0, 0.0, 1.0]
}

/// The numbers of a target that is no pose.
pub fn numbers(target: &DynamicTarget) -> Vec<f64> {
    match target {
        DynamicTarget::Pose(pose) => matrix(pose).to_vec(),
        DynamicTarget::Position(point) => point.to_vec(),
        DynamicTarget::PositionAxis(asked) => [asked.point, asked.axis].concat(),
        DynamicTarget::PositionAngle(asked) => asked.point.into_iter().chain([asked.angle]).collect(),
        DynamicTarget::PlanarPose(asked) => vec![asked.x, asked.y, asked.phi],
        DynamicTarget::PlanarPosition(point) => point.to_vec(),
    }
}

/// The numbers of a task in words, and how many they are.
pub fn words(task: &str) -> (&'static str, usize) {
    match task {
        "position" => ("x, y, z", 3),
        "position_axis" => ("x, y, z and a direction u, v, w", 6),
        "position_angle" => ("x, y, z and an angle in rad", 4),
        "planar_pose" => ("x, y and phi in rad", 3),
        "planar_position" => ("x, y", 2),
        _ => ("a 4 x 4 matrix", 16),
    }
}

/// The target of these numbers; `None` if they are too many or too few, or the task is `pose`.
pub fn of_numbers(task: &str, numbers: &[f64]) -> Option<DynamicTarget> {
    Some(match (task, numbers) {
        ("position", &[x, y, z]) => DynamicTarget::Position([x, y, z]),
        ("position_axis", &[x, y, z, u, v, w]) => DynamicTarget::PositionAxis(PointAxis::new([x, y, z], [u, v, w])),
        ("position_angle", &[x, y, z, angle]) => DynamicTarget::PositionAngle(PointAngle::new([x, y, z], angle)),
        ("planar_pose", &[x, y, phi]) => DynamicTarget::PlanarPose(PlanarPose::new(x, y, phi)),
        ("planar_position", &[x, y]) => DynamicTarget::PlanarPosition([x, y]),
        _ => return None,
    })
}

/// The pose of a 4 x 4 matrix, row by row. Numbers of the last row that are not finite make the pose a bad target.
///
/// # Errors
/// The message, if the last row is not 0 0 0 1.
pub fn of_matrix(numbers: &[f64]) -> Result<Pose<f64>, String> {
    let &[a, b, c, x, d, e, f, y, g, h, i, z, s, t, u, v] = numbers else {
        return Err("expected a 4 x 4 matrix".to_owned());
    };
    let mut translation = [x, y, z];
    if ![s, t, u, v].iter().all(|number| number.is_finite()) {
        translation = [f64::NAN; 3];
    } else if [s, t, u, v - 1.0].iter().any(|number| number.abs() > LAST_ROW) {
        let hint =
            if [x, y, z, v] == [0.0, 0.0, 0.0, 1.0] { "; the matrix seems to be transposed: write T.T" } else { "" };
        return Err(format!("the last row of a pose is [0, 0, 0, 1], found [{s}, {t}, {u}, {v}]{hint}"));
    }
    Ok(Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation })
}

/// The pose that an object is: a 4 x 4 array, an object with `as_matrix()`, or a pair of a rotation and a point. `None`
/// if it is none of them.
fn pose_of(object: &Bound<'_, PyAny>) -> PyResult<Option<Pose<f64>>> {
    let py = object.py();
    if let Ok(target) = object.cast::<Target>()
        && let DynamicTarget::Pose(pose) = target.get().0
    {
        return Ok(Some(pose));
    }
    let as_matrix = pyo3::intern!(py, "as_matrix");
    if let Ok((rotation, point)) = object.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>()
        && object.is_instance_of::<PyTuple>()
    {
        let is_rotation = rotation.hasattr(as_matrix)?;
        let rotation = if is_rotation { rotation.call_method0(as_matrix)? } else { rotation };
        let (rotation, point) = (Numbers::read("target", &rotation)?, Numbers::read("target", &point)?);
        if let (&[a, b, c, d, e, f, g, h, i], &[x, y, z], [3, 3]) =
            (rotation.values()?, point.values()?, rotation.shape())
        {
            return Ok(Some(Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }));
        }
        return Ok(None);
    }
    // An array has no such method, so nothing is looked up for it but in its class.
    let numbers = if object.hasattr(as_matrix)? {
        Numbers::read("target", &object.call_method0(as_matrix)?)?
    } else {
        Numbers::read("target", object)?
    };
    match numbers.shape() {
        [4, 4] => of_matrix(numbers.values()?).map(Some).map_err(|message| error::value(format!("target: {message}"))),
        _ => Ok(None),
    }
}

/// The pose that an object is.
///
/// # Errors
/// An object that is none.
pub fn pose(object: &Bound<'_, PyAny>) -> PyResult<Pose<f64>> {
    let object = &pair(object);
    match pose_of(object)? {
        Some(pose) => Ok(pose),
        None => Err(not_a_pose("pose", object)?),
    }
}

/// A list of two parts that are no numbers as a tuple, which a pair of a rotation and a point is; else the object itself.
fn pair<'py>(object: &Bound<'py, PyAny>) -> Bound<'py, PyAny> {
    match object.cast::<PyList>() {
        Ok(list) if list.len() == 2 && list.iter().all(|part| part.extract::<f64>().is_err()) => {
            list.to_tuple().into_any()
        }
        _ => object.clone(),
    }
}

fn not_a_pose(name: &str, object: &Bound<'_, PyAny>) -> PyResult<PyErr> {
    Ok(error::value(format!(
        "{name}: expected a pose: a 4 x 4 array, a SciPy RigidTransform, or (rotation, point), found {}",
        found(object)?
    )))
}

/// The shape of an object, for messages.
fn found(object: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(pair) = object.cast::<PyTuple>()
        && !pair.iter().all(|part| part.extract::<f64>().is_ok())
    {
        return Ok(format!("a tuple of {}", pair.len()));
    }
    Ok(match Numbers::read("target", object) {
        Ok(numbers) => format!("an array of shape {}", shown(numbers.shape())),
        Err(_) => object.get_type().name()?.to_string(),
    })
}

/// The target of an arm's task that an object is.
///
/// # Errors
/// Numbers that are no target, and what was expected; a target of another task; an arm without inverse.
pub fn read(arm: &DynamicArm, object: &Bound<'_, PyAny>) -> PyResult<DynamicTarget> {
    let py = object.py();
    if let Ok(target) = object.cast::<Target>() {
        return match target.get().0 {
            DynamicTarget::Pose(pose) => of_pose(arm, py, &pose),
            other => Ok(other),
        };
    }
    // The case of most calls.
    if let Ok(numbers) = Numbers::read("target", object)
        && *numbers.shape() == [4, 4]
    {
        let pose = of_matrix(numbers.values()?).map_err(|message| error::value(format!("target: {message}")))?;
        return of_pose(arm, py, &pose);
    }
    let object = &pair(object);
    let task = arm.task().map_err(|error| error::dynamic(py, &error))?;
    if task != "pose" {
        let parts = if let Ok(parts) = object.cast::<PyTuple>() {
            // A point, and beside it an axis or an angle. A tuple with a part that is no number may be a pose.
            let parts: PyResult<Vec<_>> = parts.iter().map(|part| Numbers::read("target", &part)).collect();
            parts.unwrap_or_default()
        } else if object.hasattr(pyo3::intern!(py, "as_matrix"))? {
            Vec::new()
        } else {
            vec![Numbers::read("target", object)?]
        };
        let mut all = Vec::new();
        if parts.iter().all(|part| part.shape().len() <= 1) {
            for part in &parts {
                all.extend_from_slice(part.values()?);
            }
        }
        if let Some(target) = of_numbers(task, &all) {
            return Ok(target);
        }
    }
    if let Some(pose) = pose_of(object)? {
        return of_pose(arm, py, &pose);
    }
    if task == "pose" {
        return Err(not_a_pose("target", object)?);
    }
    let (words, count) = words(task);
    let or = if task == "position_angle" { "" } else { ", or a pose (4 x 4)" };
    Err(error::value(format!(
        "target: the task of this arm is {task}: expected {count} numbers, {words}{or}, found {}",
        found(object)?
    )))
}

/// The target of the arm's task that a pose meets.
fn of_pose(arm: &DynamicArm, py: Python<'_>, pose: &Pose<f64>) -> PyResult<DynamicTarget> {
    arm.target_of(pose).map_err(|error| error::dynamic(py, &error))?.ok_or_else(|| {
        error::value(
            "target: the task of this arm is position_angle, and a pose does not tell its angle: write (point, angle) or \
             arm.target_at(q)",
        )
    })
}
