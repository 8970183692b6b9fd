//! The inverse: one target, and a batch of them.

use std::sync::Mutex;

use denhart::batch::Found as Outcome;
use denhart::{Branch, Flags, ParseBranchError, Pose, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::arm::Arm;
use crate::array::{Numbers, Results, empty, shown};
use crate::error;
use crate::share::{self, ROWS, share, threads, told};
use crate::solutions::{Found, Solutions, Summary, bits, number};
use crate::target::{self, Target};
use crate::turns::Turns;

/// A question to the inverse of an arm.
#[derive(Clone)]
pub struct Asked {
    pub target: DynamicTarget,
    pub near: Option<Vec<f64>>,
    pub given: Vec<f64>,
    /// One branch, as text.
    pub branch: Option<String>,
    /// Lists only solutions within the limits.
    pub drop: bool,
}

impl Asked {
    /// Reads the arguments of `inverse`.
    pub fn read(
        arm: &Arm,
        target: &Bound<'_, PyAny>,
        near: Option<&Bound<'_, PyAny>>,
        given: Option<&Bound<'_, PyAny>>,
        limits: &str,
    ) -> PyResult<Self> {
        let target = target::read(&arm.arm, target)?;
        let near = near.map(|near| arm.joints("near", near)).transpose()?;
        let given = match (&near, given) {
            (Some(_), Some(_)) => return Err(twice()),
            (Some(_), None) => Vec::new(),
            (None, given) => given_values(&arm.arm, given)?,
        };
        Ok(Self { target, near, given, branch: None, drop: drop(limits)? })
    }

    /// Solves it.
    pub fn solve(self, py: Python<'_>, arm: Py<Arm>) -> PyResult<Solutions> {
        let solver = &arm.get().arm;
        let found = match &self.branch {
            Some(text) => self.on_branch(solver, text),
            None => answer(solver, &self.target, self.near.as_deref(), &self.given).map(|all| self.kept(solver, all)),
        };
        let found = found.map_err(|error| error::dynamic(py, &error))?;
        Ok(Solutions { arm, asked: self, found })
    }

    /// The question with the solutions of its target.
    pub fn answered(self, arm: Py<Arm>, all: DynamicSolutions) -> Solutions {
        let found = self.kept(&arm.get().arm, all);
        Solutions { arm, asked: self, found }
    }

    /// The solutions that are listed.
    fn kept(&self, arm: &DynamicArm, all: DynamicSolutions) -> Found {
        if !self.drop {
            return Found::All(all);
        }
        let turns = Turns::of(arm, true);
        Found::Some(all.iter().filter_map(|solution| turns.kept(solution)).collect(), summary(&all))
    }

    fn on_branch(&self, arm: &DynamicArm, text: &str) -> Result<Found, DynamicError> {
        let branch = branch(text).unwrap_or(Branch::NONE);
        let one = arm.inverse_branch(&self.target, &self.given, branch)?;
        let (list, status) = match one {
            Ok(solution) if solution.is_exact() => (vec![solution], Status::Reachable),
            Ok(solution) => {
                let residual = solution.residual.position.max(solution.residual.orientation);
                (vec![solution], Status::Unreachable { residual })
            }
            Err(status) => (Vec::new(), status),
        };
        let turns = Turns::of(arm, self.drop);
        let kept = list.iter().filter_map(|solution| turns.kept(solution)).collect();
        let deviation = arm.inverse(&self.target, &self.given)?.deviation();
        Ok(Found::Some(kept, Summary { status, deviation, complete: true }))
    }

    /// The arguments of `Solutions._again`.
    pub fn arguments<'py>(&self, py: Python<'py>, arm: &Py<Arm>) -> PyResult<Bound<'py, PyTuple>> {
        let Self { target, near, given, branch, drop } = self;
        (arm.clone_ref(py), Target(*target), near.clone(), given.clone(), branch.clone(), *drop).into_pyobject(py)
    }
}

/// The solutions of a target.
pub fn answer(
    arm: &DynamicArm,
    target: &DynamicTarget,
    near: Option<&[f64]>,
    given: &[f64],
) -> Result<DynamicSolutions, DynamicError> {
    match near {
        Some(near) => arm.inverse_near(target, near),
        None => arm.inverse(target, given),
    }
}

fn summary(all: &DynamicSolutions) -> Summary {
    Summary { status: all.status(), deviation: all.deviation(), complete: all.is_complete() }
}

/// The argument of an inverse that has the values of redundant joints too.
const NEAR: &str = "near= with joint values to be next to";

/// Values for a redundant joint beside `near=`, which has them.
fn twice() -> PyErr {
    error::value("given: near= has these values already: leave one of them out")
}

/// The values beside the target.
pub fn given_values(arm: &DynamicArm, given: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<f64>> {
    let values = match given {
        Some(given) => Numbers::read("given", given)?.values()?.to_vec(),
        None => Vec::new(),
    };
    if given.is_none()
        && let Ok(program) = &arm.program().inverse
        && program.given.values.is_empty()
    {
        return Ok(values);
    }
    let Ok(names) = arm.given() else { return Ok(values) };
    if names.len() == values.len() {
        return Ok(values);
    }
    Err(error::value(expected(&names, &format!("{} of them", values.len()), given.is_some(), NEAR)))
}

/// The message of wrong values beside the target.
fn expected(names: &[String], found: &str, is_given: bool, or: &str) -> String {
    let list = names.join(", ");
    match (names, is_given) {
        ([], _) => "given: this arm's inverse takes no value beside the target: leave given= out".to_owned(),
        ([_], false) => format!(
            "given: the target leaves {list} to choose: write given= with its value (rad or the length unit), or {or}"
        ),
        (_, false) => format!(
            "given: the target leaves {list} to choose: write given= with their values in this order (rad or the length \
             unit), or {or}"
        ),
        (_, true) => format!("given: expected the values of {list}, found {found}"),
    }
}

/// Reads `limits=`.
pub fn drop(limits: &str) -> PyResult<bool> {
    match limits {
        "mark" => Ok(false),
        "drop" => Ok(true),
        _ => Err(error::value(format!(
            "limits: expected \"mark\" (solutions outside the joint limits have a flag) or \"drop\" (they are left out), \
             found {limits:?}"
        ))),
    }
}

/// A branch by its words.
pub fn branch(text: &str) -> PyResult<Branch> {
    if text.trim().is_empty() {
        return Ok(Branch::NONE);
    }
    text.parse().map_err(|wrong: ParseBranchError| {
        let part = text.split(',').nth(wrong.part()).unwrap_or(text).trim();
        error::value(format!("branch: {part:?} is no part of a branch: {wrong}; solution.branch has these words"))
    })
}

/// Solutions of many targets, as `Arm.inverse_batch` gives them: plain arrays.
///
/// S is the arm's `max_solutions`; of target i the first `count[i]` rows of `q[i]` are solutions, the others are NaN.
#[pyclass(frozen, module = "denhart", get_all)]
pub struct InverseBatch {
    /// Joint values, (N, S, n) float64: rad, the arm's length unit for prismatic joints. NaN beyond `count`.
    q: Py<PyAny>,
    /// The number of solutions, (N,) int64.
    count: Py<PyAny>,
    /// Facts about each solution, (N, S) uint8: bits of `denhart.Flags`; 0 beyond `count`.
    flags: Py<PyAny>,
    /// Outcome of each target, (N,) uint8: numbers of `denhart.Status`, 0 where a solution is exact.
    status: Py<PyAny>,
    /// How far the 3 x 3 matrix of each target is from a rotation, (N,) float64, as `Solutions.deviation` says.
    deviation: Py<PyAny>,
}

#[pymethods]
impl InverseBatch {
    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.count.bind(py).len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let shape = self.q.bind(py).getattr("shape")?;
        let (targets, _, _): (usize, usize, usize) = shape.extract()?;
        let status = self.status.bind(py).cast::<PyArrayDyn<u8>>()?.try_readonly();
        let reached = match &status {
            Ok(status) => status.as_slice().unwrap_or(&[]).iter().filter(|status| **status == 0).count(),
            Err(_) => 0,
        };
        Ok(format!(
            "<InverseBatch: q {shape}, {reached} of {targets} targets reached; count, flags, status, deviation>"
        ))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let parts = [&self.q, &self.count, &self.flags, &self.status, &self.deviation].map(|part| part.clone_ref(py));
        Ok((py.get_type::<Self>().getattr("_of")?, PyTuple::new(py, parts)?))
    }

    /// The batch of these arrays, for pickles.
    #[staticmethod]
    fn _of(q: Py<PyAny>, count: Py<PyAny>, flags: Py<PyAny>, status: Py<PyAny>, deviation: Py<PyAny>) -> Self {
        Self { q, count, flags, status, deviation }
    }
}

/// Targets of a batch: their numbers, so many for each.
pub struct Targets<'a> {
    numbers: &'a [f64],
    width: usize,
    task: &'static str,
    /// The targets are matrices.
    poses: bool,
}

impl<'a> Targets<'a> {
    /// Targets of a task from an argument, which messages call `name`.
    pub fn read(name: &str, task: &'static str, array: &'a Numbers<'_>) -> PyResult<Self> {
        let numbers = array.values()?;
        let (words, width) = target::words(task);
        let (width, poses) = match *array.shape() {
            [_, 4, 4] if task != "position_angle" => (16, true),
            [_, found] if task != "pose" && found == width => (width, false),
            _ => {
                let numbers = if task == "pose" { String::new() } else { format!("(N, {width}): {words}") };
                let poses = if task == "position_angle" { "" } else { "(N, 4, 4)" };
                let or = if numbers.is_empty() || poses.is_empty() { "" } else { ", or " };
                return Err(error::value(format!(
                    "{name}: the task of this arm is {task}: expected shape {poses}{or}{numbers}, found {}",
                    shown(array.shape())
                )));
            }
        };
        if poses {
            let is_exact = |matrix: &&[f64]| matches!(matrix, [.., 0.0, 0.0, 0.0, 1.0]);
            let matrices = numbers.chunks_exact(width).enumerate();
            for (index, matrix) in matrices.filter(|(_, matrix)| !is_exact(matrix)) {
                target::of_matrix(matrix).map_err(|message| {
                    let message = message.replace("write T.T", &format!("write {name}.transpose(0, 2, 1) if all are"));
                    error::value(format!("{name}[{index}]: {message}"))
                })?;
            }
        }
        Ok(Targets { numbers, width, task, poses })
    }

    /// The number of targets.
    pub const fn len(&self) -> usize {
        self.numbers.len() / self.width
    }

    /// Each of them; `None` for one that is none.
    pub fn each(&self, arm: &DynamicArm) -> impl Iterator<Item = Option<DynamicTarget>> {
        self.numbers.chunks_exact(self.width).map(|numbers| self.of(arm, numbers))
    }

    fn of(&self, arm: &DynamicArm, numbers: &[f64]) -> Option<DynamicTarget> {
        if !self.poses {
            return target::of_numbers(self.task, numbers);
        }
        let pose = target::of_matrix(numbers).ok()?;
        if self.task == "pose" { Some(DynamicTarget::Pose(pose)) } else { arm.target_of(&pose).ok().flatten() }
    }

    /// Appends the numbers of a target as lanes take them, so many.
    fn append(&self, arm: &DynamicArm, numbers: &[f64], width: usize, to: &mut Vec<f64>) {
        if !self.poses {
            return to.extend_from_slice(numbers);
        }
        if self.task == "pose" {
            // The last row of most is exact.
            if let &[a, b, c, x, d, e, f, y, g, h, i, z, 0.0, 0.0, 0.0, 1.0] = numbers {
                return to.extend_from_slice(&[a, b, c, d, e, f, g, h, i, x, y, z]);
            }
            if let Ok(Pose { rotation, translation }) = target::of_matrix(numbers) {
                return to.extend(rotation.into_iter().flatten().chain(translation));
            }
        }
        match self.of(arm, numbers) {
            Some(target) => to.extend(target::numbers(&target)),
            None => to.extend(std::iter::repeat_n(f64::NAN, width)),
        }
    }
}

/// Values for every target of a batch, or the same for all.
pub struct Beside<'a> {
    numbers: &'a [f64],
    width: usize,
    each: bool,
}

impl<'a> Beside<'a> {
    /// No values.
    pub const NOTHING: Self = Beside { numbers: &[], width: 0, each: false };

    /// The values `given` for so many targets. `or` is the argument that has them too.
    pub fn given(
        py: Python<'_>,
        arm: &DynamicArm,
        given: Option<&'a Numbers<'_>>,
        rows: usize,
        or: &str,
    ) -> PyResult<Self> {
        let names = arm.given().map_err(|error| error::dynamic(py, &error))?;
        let taken = names.len();
        let Some(given) = given else {
            return if taken == 0 { Ok(Self::NOTHING) } else { Err(error::value(expected(&names, "", false, or))) };
        };
        let numbers = given.values()?;
        let each = match *given.shape() {
            [found, width] if found == rows && width == taken => true,
            [found] if taken == 1 && found == rows && rows != 1 => true,
            [] | [_] if numbers.len() == taken => false,
            _ => {
                let shape = shown(given.shape());
                let each = match taken {
                    1 => format!(" or one for each target, ({rows},)"),
                    _ => format!(" or ({rows}, {taken})"),
                };
                let text = expected(&names, &format!("shape {shape}"), true, or);
                return Err(error::value(match taken {
                    0 => text,
                    _ => text + "; expected (" + &taken.to_string() + ",)" + &each,
                }));
            }
        };
        Ok(Beside { numbers, width: taken, each })
    }

    /// The values of a target.
    pub fn of(&self, target: usize) -> &[f64] {
        let from = if self.each { target * self.width } else { 0 };
        self.numbers.get(from..from + self.width).unwrap_or(&[])
    }
}

/// Results of some targets, to be written, the first of which has this number.
struct Job<'a> {
    first: usize,
    targets: &'a [f64],
    q: &'a mut [f64],
    count: &'a mut [i64],
    flags: &'a mut [u8],
    status: &'a mut [u8],
    deviation: &'a mut [f64],
}

/// Arguments of `inverse_batch`.
pub struct Batch<'a, 'py> {
    pub targets: &'a Bound<'py, PyAny>,
    pub near: Option<&'a Bound<'py, PyAny>>,
    pub given: Option<&'a Bound<'py, PyAny>>,
    pub limits: &'a str,
    pub threads: Option<i64>,
    pub out: Option<&'a Bound<'py, PyAny>>,
}

impl Batch<'_, '_> {
    /// Solves for every target.
    pub fn solve(&self, py: Python<'_>, arm: &Arm) -> PyResult<InverseBatch> {
        let solver = &arm.arm;
        let refused = |error: DynamicError| error::dynamic(py, &error);
        let (task, capacity, joints) =
            (solver.task().map_err(refused)?, solver.max_solutions().map_err(refused)?, solver.joints());
        let drop = drop(self.limits)?;
        // Poses of scipy, as of one target.
        let as_matrix = pyo3::intern!(py, "as_matrix");
        let matrices = self.targets.hasattr(as_matrix)?.then(|| self.targets.call_method0(as_matrix)).transpose()?;
        let numbers = Numbers::read("targets", matrices.as_ref().unwrap_or(self.targets))?;
        let targets = Targets::read("targets", task, &numbers)?;
        let (rows, width) = (targets.len(), targets.width);
        let near_numbers = self.near.map(|near| Numbers::read("near", near)).transpose()?;
        let near = match &near_numbers {
            None => None,
            Some(near) => Some(match *near.shape() {
                [found] if found == joints => Beside { numbers: near.values()?, width: joints, each: false },
                [found, width] if found == rows && width == joints => {
                    Beside { numbers: near.values()?, width: joints, each: true }
                }
                _ => return Err(arm.wrong_shape("near", near.shape(), Some(rows))),
            }),
        };
        if near.is_some() && self.given.is_some() {
            return Err(twice());
        }
        let given_numbers = self.given.map(|given| Numbers::read("given", given)).transpose()?;
        let given = match &given_numbers {
            None if near.is_some() => Beside::NOTHING,
            given => Beside::given(py, solver, given.as_ref(), rows, NEAR)?,
        };
        // Beside a reference every solution is listed, each on the turns next to it: lanes give the nearest one alone.
        let in_lanes = near.is_none() && solver.inverse_has_lanes().map_err(refused)?;
        let each = if in_lanes { share::in_lanes(self.threads, rows)? } else { ROWS };
        let threads = threads(self.threads, rows.div_ceil(each))?;
        let results = Results::given(py, self.out, &[rows, capacity, joints])?;
        let counts = empty(py, &[rows], Some("int64"))?;
        let flags = empty(py, &[rows, capacity], Some("uint8"))?;
        let status = empty(py, &[rows], Some("uint8"))?;
        let deviation = Results::new(py, &[rows])?;
        {
            let mut q = results.writable()?;
            let mut counts = counts.cast::<PyArrayDyn<i64>>()?.readwrite();
            let mut flags = flags.cast::<PyArrayDyn<u8>>()?.readwrite();
            let mut status = status.cast::<PyArrayDyn<u8>>()?.readwrite();
            let mut deviation = deviation.writable()?;
            let unexpected = |error: numpy::AsSliceError| error::value(error.to_string());
            let jobs = targets
                .numbers
                .chunks(each * width)
                .zip(q.values()?.chunks_mut(each * capacity * joints))
                .zip(counts.as_slice_mut().map_err(unexpected)?.chunks_mut(each))
                .zip(flags.as_slice_mut().map_err(unexpected)?.chunks_mut(each * capacity))
                .zip(status.as_slice_mut().map_err(unexpected)?.chunks_mut(each))
                .zip(deviation.values()?.chunks_mut(each))
                .enumerate()
                .map(|(block, (((((targets, q), count), flags), status), deviation))| Job {
                    first: block * each,
                    targets,
                    q,
                    count,
                    flags,
                    status,
                    deviation,
                });
            let failed = Mutex::new(None);
            let work = |memory: &mut Memory, job: Job<'_>| {
                let done = match in_lanes {
                    true => memory.rows_of(solver, &targets, &given, drop, job),
                    false => rows_of(solver, &targets, near.as_ref(), &given, drop, job),
                };
                if let Err(error) = done
                    && let Ok(mut failed) = failed.lock()
                {
                    *failed = Some(error);
                }
            };
            share(py, jobs, threads, work).map_err(|error| told(py, error, self.out.is_some()))?;
            if let Ok(Some(error)) = failed.into_inner() {
                return Err(told(py, refused(error), self.out.is_some()));
            }
        }
        Ok(InverseBatch {
            q: results.into_any().unbind(),
            count: counts.unbind(),
            flags: flags.unbind(),
            status: status.unbind(),
            deviation: deviation.into_any().unbind(),
        })
    }
}

/// Memory of a thread whose targets run in lanes: their numbers, the values beside them, and their outcomes.
#[derive(Default)]
struct Memory {
    targets: Vec<f64>,
    given: Vec<f64>,
    found: Vec<Outcome>,
}

impl Memory {
    /// Solves for the targets of a job in lanes, to the bits of single calls.
    fn rows_of(
        &mut self,
        arm: &DynamicArm,
        targets: &Targets<'_>,
        given: &Beside<'_>,
        drop: bool,
        job: Job<'_>,
    ) -> Result<(), DynamicError> {
        let Job { first, targets: numbers, q, count, flags, status, deviation } = job;
        let width = arm.target_width()?;
        self.targets.clear();
        for numbers in numbers.chunks_exact(targets.width) {
            targets.append(arm, numbers, width, &mut self.targets);
        }
        self.given.clear();
        for index in first..first + count.len() {
            self.given.extend_from_slice(given.of(index));
        }
        self.found.resize(count.len(), Outcome::NOTHING);
        arm.inverse_batch(&self.targets, &self.given, q, &mut self.found)?;
        let joints = arm.joints().max(1);
        let row = q.len() / count.len().max(1);
        let places = q.chunks_exact_mut(row.max(1)).zip(flags.chunks_exact_mut((row / joints).max(1)));
        let turns = Turns::of(arm, drop);
        let outcomes = count.iter_mut().zip(status).zip(deviation);
        for ((found, (q, flags)), ((count, status), deviation)) in self.found.iter().zip(places).zip(outcomes) {
            let listed = match turns.drop() {
                true => within_limits(&turns, found, q, flags, joints),
                false => {
                    for (place, facts) in flags.iter_mut().zip(found.flags()) {
                        *place = bits(*facts);
                    }
                    found.flags().len()
                }
            };
            q.iter_mut().skip(listed * joints).for_each(|place| *place = f64::NAN);
            flags.iter_mut().skip(listed).for_each(|place| *place = 0);
            *count = i64::try_from(listed).unwrap_or(i64::MAX);
            *status = number(&found.status);
            *deviation = found.deviation;
        }
        Ok(())
    }
}

/// Keeps the solutions within the limits, on the turns that are inside. Returns their number.
fn within_limits(turns: &Turns<'_>, found: &Outcome, q: &mut [f64], flags: &mut [u8], joints: usize) -> usize {
    let mut listed = 0;
    for (number, facts) in found.flags().iter().enumerate() {
        let mut facts = *facts;
        if facts.contains(Flags::OUT_OF_LIMITS) {
            if !q.get_mut(number * joints..(number + 1) * joints).is_some_and(|q| turns.turn(q)) {
                continue;
            }
            facts.remove(Flags::OUT_OF_LIMITS);
        }
        if number != listed {
            moved(q, number * joints, listed * joints, joints);
        }
        if let Some(place) = flags.get_mut(listed) {
            *place = bits(facts);
        }
        listed += 1;
    }
    listed
}

/// Copies some numbers to an earlier place.
fn moved(numbers: &mut [f64], from: usize, to: usize, length: usize) {
    for index in 0..length {
        if let Some(value) = numbers.get(from + index).copied()
            && let Some(place) = numbers.get_mut(to + index)
        {
            *place = value;
        }
    }
}

/// Solves for the targets of a job, one by one.
fn rows_of(
    arm: &DynamicArm,
    targets: &Targets<'_>,
    near: Option<&Beside<'_>>,
    given: &Beside<'_>,
    drop: bool,
    job: Job<'_>,
) -> Result<(), DynamicError> {
    let joints = arm.joints();
    let row = job.q.len() / job.count.len().max(1);
    let capacity = row / joints.max(1);
    let places = job.q.chunks_exact_mut(row.max(1)).zip(job.count).zip(job.flags.chunks_exact_mut(capacity.max(1)));
    let targets_of_job = job.targets.chunks_exact(targets.width);
    let turns = Turns::of(arm, drop);
    let outcomes = job.status.iter_mut().zip(job.deviation);
    for (index, ((numbers, ((q, count), flags)), (status, deviation))) in
        targets_of_job.zip(places).zip(outcomes).enumerate()
    {
        let index = job.first + index;
        let mut listed = 0;
        (*status, *deviation) = (number(&Status::BadTarget), f64::NAN);
        let (mut q, mut flags) = (q.chunks_exact_mut(joints.max(1)), flags.iter_mut());
        if let Some(target) = targets.of(arm, numbers) {
            let all = answer(arm, &target, near.map(|near| near.of(index)), given.of(index))?;
            (*status, *deviation) = (number(&all.status()), all.deviation());
            let kept = all.iter().filter_map(|solution| turns.kept(solution));
            for ((solution, place), flag) in kept.zip(q.by_ref()).zip(flags.by_ref()) {
                place.copy_from_slice(&solution.q);
                *flag = bits(solution.flags);
                listed += 1;
            }
        }
        q.for_each(|row| row.fill(f64::NAN));
        flags.for_each(|flag| *flag = 0);
        *count = listed;
    }
    Ok(())
}
