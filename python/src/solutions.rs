//! Solutions of one target.

use denhart::{Flags, JointKind, Status};
use denhart_dynamic::{DynamicSolution, DynamicSolutions};
use denhart_tools::closest::{Missed, closest, pose_of};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyIterator, PyList, PySlice, PyTuple, PyType};

use crate::arm::Arm;
use crate::array::{self, Results, filled};
use crate::error;
use crate::inverse::Asked;
use crate::target::Target;

static FLAGS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
static STATUS: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// The bits of flags, as `denhart.Flags` has them.
pub fn bits(flags: Flags) -> u8 {
    // The case of most solutions.
    if flags == Flags::EXACT {
        return 1;
    }
    let all = [
        (Flags::EXACT, 1),
        (Flags::BOUNDARY, 2),
        (Flags::FREE, 4),
        (Flags::APPROXIMATE, 8),
        (Flags::OUT_OF_LIMITS, 16),
    ];
    all.into_iter().filter(|(flag, _)| flags.contains(*flag)).map(|(_, bit)| bit).sum()
}

/// The number of a status, as `denhart.Status` has it.
pub fn number(status: &Status<f64>) -> u8 {
    match status {
        Status::Reachable => 0,
        Status::Unreachable { .. } => 1,
        Status::BadTarget => 2,
    }
}

/// Solutions as they were found, and those of them that are listed.
pub enum Found {
    /// All.
    All(DynamicSolutions),
    /// Some of all.
    Some(Vec<DynamicSolution>, Summary),
}

/// Facts about a call.
#[derive(Clone, Copy)]
pub struct Summary {
    pub status: Status<f64>,
    pub deviation: f64,
    pub complete: bool,
}

impl Found {
    /// The solutions that are listed.
    pub fn list(&self) -> &[DynamicSolution] {
        match self {
            Found::All(solutions) => solutions,
            Found::Some(solutions, _) => solutions,
        }
    }

    fn summary(&self) -> Summary {
        match self {
            Found::All(all) => {
                Summary { status: all.status(), deviation: all.deviation(), complete: all.is_complete() }
            }
            Found::Some(_, summary) => *summary,
        }
    }
}

/// Every joint vector that answers a target, as `Arm.inverse` gives them: a sequence of `Solution`.
///
/// `solutions.q` is all of them as one array (S, n). An empty sequence is false; `why()` then tells the reason.
#[pyclass(frozen, module = "denhart", sequence)]
pub struct Solutions {
    pub arm: Py<Arm>,
    pub asked: Asked,
    pub found: Found,
}

#[pymethods]
impl Solutions {
    /// Joint values, (S, n) float64: a row for each solution; rad, the arm's length unit for prismatic joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let list = self.found.list();
        let joints = self.arm.get().arm.joints();
        let results = Results::new(py, &[list.len(), joints])?;
        for (row, solution) in results.writable()?.values()?.chunks_exact_mut(joints.max(1)).zip(list) {
            row.copy_from_slice(&solution.q);
        }
        Ok(results.into_any())
    }

    /// Outcome: REACHABLE if a solution is exact, UNREACHABLE, or BAD_TARGET.
    #[getter]
    fn status<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        STATUS.import(py, "denhart._names", "Status")?.call1((number(&self.found.summary().status),))
    }

    /// How far the target's 3 x 3 matrix is from a rotation; 0 for a rotation. From 1e-3 on the target is bad, below the
    /// nearest rotation stands for it.
    #[getter]
    fn deviation(&self) -> f64 {
        self.found.summary().deviation
    }

    /// False if the bound of a call was reached, so that further solutions may exist.
    #[getter]
    fn is_complete(&self) -> bool {
        self.found.summary().complete
    }

    /// The target, as the solver took it.
    #[getter]
    fn target(&self) -> Target {
        Target(self.asked.target)
    }

    /// The arm that was asked.
    #[getter]
    fn arm(&self, py: Python<'_>) -> Py<Arm> {
        self.arm.clone_ref(py)
    }

    /// The outcome in words: the number of solutions, or why there is none. For a target out of reach an iteration looks
    /// for the closest approach, which takes milliseconds.
    fn why(&self) -> String {
        let list = self.found.list();
        let arm = self.arm.get();
        let unit = arm.arm.length_unit();
        match self.found.summary().status {
            Status::Reachable => {
                let outside = list.iter().filter(|solution| !solution.is_within_limits()).count();
                let listed = counted(list.len());
                match (list.len(), outside) {
                    (0, _) if self.asked.branch.is_some() => "reachable, but not on this branch".to_owned(),
                    (0, _) if self.asked.drop => "reachable, but every solution is outside the joint limits".to_owned(),
                    (_, 0) => format!("reachable: {listed}"),
                    (all, outside) if all == outside => {
                        format!("reachable: {listed}, outside the joint limits")
                    }
                    _ => format!("reachable: {listed}, {outside} of them outside the joint limits"),
                }
            }
            Status::BadTarget => "bad target: a number is not finite or far too large, a direction is zero, the 3 x 3 \
                                  matrix is off a rotation by more than 1e-3 or mirrors, or near= is many turns away"
                .to_owned(),
            Status::Unreachable { residual } => {
                let target = &self.asked.target;
                let start = self.asked.near.clone().unwrap_or_else(|| vec![0.0; arm.arm.joints()]);
                let closest = closest(&arm.arm, target, &pose_of(&arm.arm, target), &start);
                let more = match closest.map(|closest| closest.missed) {
                    Some(Missed::Distance(distance)) => {
                        format!(
                            "the point is out of reach; the closest that iteration finds is {distance:.3e} {unit} away"
                        )
                    }
                    Some(Missed::Direction(left)) => format!(
                        "the point can be reached, but not with this orientation; closest: {:.3e} {unit} and {:.3e} deg off",
                        left.position,
                        left.orientation.to_degrees()
                    ),
                    None => format!("the least gap of a branch is {residual:.1e} ({unit} or rad)"),
                };
                match list.len() {
                    0 => format!("unreachable: {more}"),
                    all => format!("no exact solution, {} within the arm's tolerance: {more}", counted(all)),
                }
            }
        }
    }

    /// Solves once more, for pickles.
    #[staticmethod]
    fn _again(
        py: Python<'_>,
        arm: Py<Arm>,
        target: &Bound<'_, Target>,
        near: Option<Vec<f64>>,
        given: Vec<f64>,
        branch: Option<String>,
        drop: bool,
    ) -> PyResult<Self> {
        Asked { target: target.get().0, near, given, branch, drop }.solve(py, arm)
    }

    fn __len__(&self) -> usize {
        self.found.list().len()
    }

    fn __getitem__<'py>(slf: &Bound<'py, Self>, index: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = slf.py();
        let len = slf.get().found.list().len();
        let at = |index: usize| Bound::new(py, Solution { of: slf.clone().unbind(), index });
        if let Ok(slice) = index.cast::<PySlice>() {
            let places = slice.indices(isize::try_from(len).unwrap_or(isize::MAX))?;
            let places =
                (0..places.slicelength).map(|step| places.start + places.step * isize::try_from(step).unwrap_or(0));
            let list = places.filter_map(|place| usize::try_from(place).ok()).map(at).collect::<PyResult<Vec<_>>>()?;
            return Ok(PyList::new(py, list)?.into_any());
        }
        let asked: isize = index.extract()?;
        let place = if asked < 0 { len.checked_sub(asked.unsigned_abs()) } else { Some(asked.unsigned_abs()) };
        match place.filter(|place| *place < len) {
            Some(place) => Ok(at(place)?.into_any()),
            None => Err(PyIndexError::new_err(format!("solution {asked} of {len}: {}", slf.get().why()))),
        }
    }

    fn __iter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyIterator>> {
        let solutions = (0..slf.get().found.list().len()).map(|index| Solution { of: slf.clone().unbind(), index });
        PyList::new(slf.py(), solutions.map(|solution| Bound::new(slf.py(), solution)).collect::<PyResult<Vec<_>>>()?)?
            .try_iter()
    }

    fn __eq__(slf: &Bound<'_, Self>, other: &Bound<'_, PyAny>) -> bool {
        let Ok(other) = other.cast::<Self>() else { return false };
        let (a, b) = (slf.get(), other.get());
        let (mine, others) = (a.found.list(), b.found.list());
        slf.is(other)
            || a.found.summary().status == b.found.summary().status
                && mine.len() == others.len()
                && mine.iter().zip(others).all(|(a, b)| is_same(a, b))
    }

    fn __hash__(&self) -> u64 {
        hash(self.found.list())
    }

    /// The place of a solution. ValueError: it is not here.
    #[pyo3(signature = (value, start=0, stop=None))]
    fn index(&self, value: &Bound<'_, PyAny>, start: isize, stop: Option<isize>) -> PyResult<usize> {
        let list = self.found.list();
        let place = |place: isize| match place {
            0.. => place.unsigned_abs().min(list.len()),
            _ => list.len().saturating_sub(place.unsigned_abs()),
        };
        let ends = place(start)..stop.map_or(list.len(), place);
        let found = ends.into_iter().find(|at| list.get(*at).is_some_and(|solution| is_equal(solution, value)));
        found.ok_or_else(|| error::value("index: this solution is not in the list"))
    }

    /// How often a solution is here.
    fn count(&self, value: &Bound<'_, PyAny>) -> usize {
        self.found.list().iter().filter(|solution| is_equal(solution, value)).count()
    }

    fn __contains__(&self, value: &Bound<'_, PyAny>) -> bool {
        self.count(value) > 0
    }

    fn __repr__(&self) -> String {
        let arm = self.arm.get();
        let name = &arm.arm.model().name;
        let list = self.found.list();
        let head = match self.found.summary().status {
            Status::Reachable => format!("{} of {name}", counted(list.len())),
            Status::BadTarget => format!("no solution of {name}: bad target"),
            Status::Unreachable { .. } if list.is_empty() => format!("no solution of {name}: unreachable"),
            Status::Unreachable { .. } => format!("{} of {name}, none exact", counted(list.len())),
        };
        let rows = list.iter().enumerate().map(|(index, solution)| format!("\n  {index}: {}", arm.text(solution)));
        format!("<{head}{}>", rows.collect::<String>())
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let py = slf.py();
        let Solutions { arm, asked, .. } = slf.get();
        Ok((slf.get_type().getattr("_again")?.into_any(), asked.arguments(py, arm)?))
    }
}

/// Returns true for solutions with the same joint values, branch and facts.
fn is_same(a: &DynamicSolution, b: &DynamicSolution) -> bool {
    a.q == b.q && a.branch == b.branch && a.flags == b.flags && a.free == b.free
}

/// Returns true if an object of Python is a solution with the same values.
fn is_equal(solution: &DynamicSolution, object: &Bound<'_, PyAny>) -> bool {
    object.cast::<Solution>().is_ok_and(|object| object.get().get().is_ok_and(|other| is_same(solution, other)))
}

/// A hash of the joint values of solutions.
fn hash(list: &[DynamicSolution]) -> u64 {
    array::hash(list.iter().flat_map(|solution| solution.q.iter().copied()))
}

/// `1 solution`, `8 solutions`.
fn counted(count: usize) -> String {
    match count {
        0 => "no solution".to_owned(),
        1 => "1 solution".to_owned(),
        many => format!("{many} solutions"),
    }
}

/// One joint vector that answers a target.
#[pyclass(frozen, module = "denhart")]
pub struct Solution {
    of: Py<Solutions>,
    index: usize,
}

impl Solution {
    fn get(&self) -> PyResult<&DynamicSolution> {
        self.of.get().found.list().get(self.index).ok_or_else(|| PyIndexError::new_err("no such solution"))
    }
}

#[pymethods]
impl Solution {
    /// Joint values, (n,) float64: rad, the arm's length unit for prismatic joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let q = &self.get()?.q;
        filled(py, &[q.len()], q.iter().copied())
    }

    /// The branch: "shoulder left, elbow up, wrist no-flip", or "root 2"; "-" where the arm has one only.
    #[getter]
    fn branch(&self) -> PyResult<String> {
        Ok(self.get()?.branch.to_string())
    }

    /// Facts about the solution, `denhart.Flags`.
    #[getter]
    fn flags<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        FLAGS.import(py, "denhart._names", "Flags")?.call1((bits(self.get()?.flags),))
    }

    /// Indices of the joints that could take other values at this singular pose.
    #[getter]
    fn free<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.get()?.free.iter().collect::<Vec<_>>())
    }

    /// Error against the target: a length in the arm's unit, and an angle in rad. (0.0, 0.0) for a solution that the
    /// closed form gives to rounding.
    #[getter]
    fn residual(&self) -> PyResult<(f64, f64)> {
        let residual = self.get()?.residual;
        Ok((residual.position, residual.orientation))
    }

    /// True if the solution reaches the target up to rounding.
    #[getter]
    fn is_exact(&self) -> PyResult<bool> {
        Ok(self.get()?.is_exact())
    }

    /// True if every joint is within the arm's limits.
    #[getter]
    fn is_within_limits(&self) -> PyResult<bool> {
        Ok(self.get()?.is_within_limits())
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> PyResult<bool> {
        Ok(is_equal(self.get()?, other))
    }

    fn __hash__(&self) -> PyResult<u64> {
        Ok(hash(std::slice::from_ref(self.get()?)))
    }

    fn __repr__(&self) -> PyResult<String> {
        Ok(format!("<Solution {}>", self.of.get().arm.get().text(self.get()?)))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let place = (self.of.clone_ref(py), self.index).into_pyobject(py)?;
        Ok((py.import("operator")?.getattr("getitem")?, place))
    }
}

/// The joint vector that an iteration found, as `Arm.numeric` gives it.
#[pyclass(frozen, module = "denhart")]
pub struct NumericSolution {
    pub values: Vec<f64>,
    pub kinds: Vec<JointKind>,
    /// True if the target is reached within the tolerances.
    #[pyo3(get)]
    pub converged: bool,
    /// Steps taken, from all starts.
    #[pyo3(get)]
    pub iterations: usize,
    /// Starts beside the first one.
    #[pyo3(get)]
    pub restarts: usize,
    /// Error that is left: a length in the arm's unit, and an angle in rad.
    #[pyo3(get)]
    pub residual: (f64, f64),
    pub text: String,
}

#[pymethods]
impl NumericSolution {
    /// Joint values, (n,) float64: rad, the arm's length unit for prismatic joints.
    #[getter]
    fn q<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        filled(py, &[self.values.len()], self.values.iter().copied())
    }

    fn __repr__(&self) -> String {
        format!("<NumericSolution {}  {}>", joints(&self.values, &self.kinds), self.text)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let slides: Vec<bool> = self.kinds.iter().map(|kind| *kind == JointKind::Prismatic).collect();
        let counts = (self.converged, self.iterations, self.restarts);
        let parts = (self.values.clone(), slides, counts, self.residual, &self.text).into_pyobject(py)?;
        Ok((py.get_type::<Self>().getattr("_of")?, parts))
    }

    /// The solution of these parts, for pickles.
    #[staticmethod]
    #[allow(clippy::needless_pass_by_value)]
    fn _of(
        values: Vec<f64>,
        slides: Vec<bool>,
        counts: (bool, usize, usize),
        residual: (f64, f64),
        text: String,
    ) -> Self {
        let kind = |slides| if slides { JointKind::Prismatic } else { JointKind::Revolute };
        let (converged, iterations, restarts) = counts;
        Self { values, kinds: slides.into_iter().map(kind).collect(), converged, iterations, restarts, residual, text }
    }
}

/// Joint values for people: `[17.189 deg, 0.250000]`.
pub fn joints(q: &[f64], kinds: &[JointKind]) -> String {
    let one = |(q, kind): (&f64, &JointKind)| match kind {
        JointKind::Revolute => (format!("{:.3}", q.to_degrees()), " deg"),
        JointKind::Prismatic | JointKind::Fixed => (format!("{q:.6}"), ""),
    };
    // A rounding below zero is no sign.
    let unsigned = |text: &str| match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
        _ => text.to_owned(),
    };
    let all = q.iter().zip(kinds).map(one).map(|(number, unit)| unsigned(&number) + unit);
    format!("[{}]", all.collect::<Vec<_>>().join(", "))
}
