//! The class `Arm`.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

use denhart::JointKind;
use denhart::numeric::NumericInverse;
use denhart_codegen::{Builder, ScalarKind, check};
use denhart_draw::{Scene, Style, View};
use denhart_dynamic::{DynamicArm, DynamicSolution, DynamicTarget};
use denhart_tools::export::{self, COptions};
use denhart_tools::{chain, import, presets};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList, PyTuple, PyType};

use crate::follow::{Motion, Path as Followed};
use crate::follower::{Beginning, Follower};
use crate::inverse::{Asked, Batch, InverseBatch, branch};
use crate::picture::{Picture, theme, view};
use crate::solutions::{NumericSolution, Solutions, joints};
use crate::target::{self, Target};
use crate::{beyond, error, sweep, table};

/// A robot arm: its kinematics from a Denavit-Hartenberg table.
///
/// Angles are rad, lengths are in `length_unit`. n is the number of moving joints, N any number of joint vectors. An arm
/// never changes: any number of threads may use one at once.
///
///     >>> import denhart
///     >>> arm = denhart.Arm.preset("ur5")
///     >>> target = arm.forward([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
///     >>> for solution in arm.inverse(target):
///     ...     print(solution.q, solution.branch)
#[pyclass(frozen, module = "denhart")]
pub struct Arm {
    pub arm: DynamicArm,
    text: String,
    file: String,
}

impl Arm {
    fn new(py: Python<'_>, text: String, file: String) -> PyResult<Self> {
        let arm = py.detach(|| DynamicArm::named(&text, &file)).map_err(|error| error::dynamic(py, &error))?;
        Ok(Self { arm, text, file })
    }

    /// A solution in one line.
    pub fn text(&self, solution: &DynamicSolution) -> String {
        let mut text = format!("{}  {}", joints(&solution.q, self.arm.joint_kinds()), solution.flags);
        if !solution.free.is_empty() {
            text += &format!(" {}", solution.free);
        }
        if solution.branch != denhart::Branch::NONE {
            text += &format!("  {}", solution.branch);
        }
        text
    }
}

/// Iterations that `numeric` may take in all: no signal is seen meanwhile.
const MOST_ITERATIONS: usize = 1_000_000;

/// The text of a file, and its name.
fn read(py: Python<'_>, path: &Path) -> PyResult<(String, String)> {
    let name = path.display().to_string();
    // By Python's own file, which Ctrl+C ends where a pipe has nothing to read.
    let file = py.import("builtins")?.call_method1("open", (path, "rb"))?;
    let bytes = file.call_method0("read");
    file.call_method0("close")?;
    let bytes = bytes?.cast::<PyBytes>()?.as_bytes().to_vec();
    let text = denhart_codegen::decode(bytes, &name).map_err(|message| error::arm(py, message))?;
    Ok((text, name))
}

#[pymethods]
impl Arm {
    /// The arm of the text of an arm file. Messages call the file `name`.
    #[staticmethod]
    #[pyo3(signature = (text, name="arm.yaml"))]
    fn from_yaml(py: Python<'_>, text: String, name: &str) -> PyResult<Self> {
        Self::new(py, text, name.to_owned())
    }

    /// The arm of an arm file.
    #[staticmethod]
    #[allow(clippy::needless_pass_by_value)]
    fn from_file(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let (text, name) = read(py, &path)?;
        Self::new(py, text, name)
    }

    /// The arm of a chain of a URDF, from the link `base` to the link `tool`; by default from the root to the end of the
    /// chain with the most moving joints, before its gripper. Its lengths are in m, joint values are those of the URDF.
    ///
    /// The poses of the arm are compared with those of the URDF at 1000 configurations. `to_yaml()` gives the arm file,
    /// whose first lines say what was found, such as a gripper that was left out.
    #[staticmethod]
    #[pyo3(signature = (path, *, base=None, tool=None))]
    #[allow(clippy::needless_pass_by_value)]
    fn from_urdf(py: Python<'_>, path: PathBuf, base: Option<String>, tool: Option<String>) -> PyResult<Self> {
        let (text, name) = read(py, &path)?;
        let options = import::Options { from: name, base, tool, ..import::Options::default() };
        let imported = py.detach(|| import::urdf(&text, &options)).map_err(|error| error::tools(py, &error))?;
        Self::new(py, imported.arm_file, "arm.yaml".to_owned())
    }

    /// The arm of a table: a number for each row in `a`, `alpha`, `d` and `theta`.
    ///
    /// `convention` is "standard" or "modified" (Craig). `kinds` has "revolute" (or "R"), "prismatic" ("P") or "fixed"
    /// ("F") for each row, `limits` a pair or None. `angle` is the unit of alpha, theta and of the limits of revolute
    /// joints, "rad" or "deg"; `length_unit` is "m", "cm", "mm" or "in". An angle that is a multiple of 15 degrees to the
    /// last digits, such as np.pi / 2, is exactly that. `task` and `redundant` are those of an arm file: "pose", "q3".
    #[staticmethod]
    #[pyo3(signature = (*, a, alpha, d, theta=None, convention="standard", kinds=None, limits=None, angle="rad", length_unit="m", name="arm", task=None, redundant=None))]
    #[allow(clippy::too_many_arguments)]
    fn from_dh(
        py: Python<'_>,
        a: &Bound<'_, PyAny>,
        alpha: &Bound<'_, PyAny>,
        d: &Bound<'_, PyAny>,
        theta: Option<&Bound<'_, PyAny>>,
        convention: &str,
        kinds: Option<&Bound<'_, PyAny>>,
        limits: Option<&Bound<'_, PyAny>>,
        angle: &str,
        length_unit: &str,
        name: &str,
        task: Option<&str>,
        redundant: Option<&str>,
    ) -> PyResult<Self> {
        // "RRP" is a list of its letters.
        let kinds: Option<Vec<String>> = match kinds {
            None => None,
            Some(kinds) => Some(
                kinds.try_iter().and_then(|kinds| kinds.map(|kind| kind?.extract()).collect::<PyResult<_>>()).map_err(
                    |_| error::kind("kinds: expected a list such as [\"revolute\", \"prismatic\"], or \"RP\""),
                )?,
            ),
        };
        let inverse = [task, redundant];
        let table = table::Table { a, alpha, d, theta, convention, kinds, limits, angle, length_unit, name, inverse };
        Self::new(py, table.text()?, "arm.yaml".to_owned())
    }

    /// Names of the arms that come with the package.
    #[staticmethod]
    fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
        PyList::new(py, presets::presets().map(|preset| preset.name).collect::<Vec<_>>())
    }

    /// An arm that comes with the package, by its name.
    #[staticmethod]
    fn preset(py: Python<'_>, name: &str) -> PyResult<Self> {
        let preset = presets::preset(name).map_err(|error| error::tools(py, &error))?;
        Self::new(py, preset.arm_file.to_owned(), format!("{}.yaml", preset.name))
    }

    /// The text of the arm file.
    fn to_yaml(&self) -> &str {
        &self.text
    }

    /// Rust code of the arm's functions, as `denhart expand` prints it, for a type of this name.
    #[pyo3(signature = (type_name=None))]
    fn to_rust(&self, py: Python<'_>, type_name: Option<&str>) -> PyResult<String> {
        let mut builder = Builder::of_text(self.text.clone(), self.file.clone());
        if let Some(name) = type_name {
            builder = builder.type_name(name);
        }
        py.detach(|| builder.generate()).map_err(|error| error::arm(py, error))
    }

    /// The arm as a static library for C, as `denhart export c` writes it: a dict from the path of each file in the
    /// library's folder to its text. `scalar` is "f64" or "f32"; `prefix` begins the names in C, by default the arm's name.
    #[pyo3(signature = (*, scalar="f64", prefix=None))]
    fn to_c<'py>(&self, py: Python<'py>, scalar: &str, prefix: Option<String>) -> PyResult<Bound<'py, PyDict>> {
        let scalar = ScalarKind::try_from(scalar)
            .map_err(|_| error::value(format!("scalar: expected \"f64\" or \"f32\", found {scalar:?}")))?;
        let options = COptions { scalar, prefix, ..COptions::default() };
        let library =
            py.detach(|| export::c(&self.text, &self.file, &options)).map_err(|error| error::tools(py, &error))?;
        let files = PyDict::new(py);
        for file in library.files {
            files.set_item(file.path, file.text)?;
        }
        Ok(files)
    }

    /// Findings about the arm, as `denhart check` prints them: axes, operations, the plan of the inverse, advice.
    fn report(&self, py: Python<'_>) -> PyResult<String> {
        let report = py.detach(|| check(&self.text, &self.file)).map_err(|error| error::arm(py, error))?;
        Ok(report.to_string())
    }

    /// A picture of the arm at q, (n,), by default all zero, or of all `solutions` of a target. Jupyter shows it.
    ///
    /// `view` is "front", "side", "top" or "iso", by default the one that shows most; `theme` is "auto", "light" or
    /// "dark"; `size` is width and height in px, by default 720 by 440. `frames` shows the frames of the table,
    /// `dimensions` its lengths.
    #[pyo3(signature = (q=None, *, solutions=None, view=None, theme="auto", frames=false, dimensions=false, size=None))]
    #[allow(clippy::too_many_arguments)]
    fn draw(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        solutions: Option<&Bound<'_, Solutions>>,
        view: Option<&str>,
        theme: &str,
        frames: bool,
        dimensions: bool,
        size: Option<(f64, f64)>,
    ) -> PyResult<Picture> {
        let failed = |error: denhart_draw::DrawError| error::arm(py, error);
        let seen = match view {
            Some(name) => self::view(name)?,
            None => View::of(&self.arm),
        };
        let (width, height) = size.unwrap_or((720.0, 440.0));
        if ![width, height].iter().all(|length| (160.0..=4000.0).contains(length)) {
            return Err(error::value(format!(
                "size: expected width and height from 160 to 4000 px, found ({width}, {height})"
            )));
        }
        let style = Style::of(seen).with_theme(self::theme(theme)?).with_size(width, height);
        let posture = q.map(|q| self.joints("q", q)).transpose()?;
        let mut scene = match (solutions, posture) {
            (Some(_), Some(_)) => return Err(error::value("draw: expected q or solutions=, found both")),
            (None, posture) => {
                let q = posture.unwrap_or_else(|| vec![0.0; self.arm.joints()]);
                Scene::of(&self.arm, &q).map_err(failed)?
            }
            (Some(solutions), None) => {
                let solutions = solutions.get();
                let arm = solutions.arm.get();
                if arm.text != self.text {
                    return Err(error::value(format!(
                        "solutions: they are those of another arm, {}",
                        arm.arm.model().name
                    )));
                }
                let listed = solutions.found.list();
                match beyond::task(&self.arm, &solutions.asked.target) {
                    Some((pose, _)) => Scene::of_solutions(&self.arm, pose, listed).map_err(failed)?,
                    None => {
                        Scene::of(&self.arm, listed.first().map_or(&vec![0.0; self.arm.joints()][..], |first| &first.q))
                            .and_then(|scene| scene.with_solutions(&self.arm, listed))
                            .map_err(failed)?
                    }
                }
            }
        };
        if frames {
            scene = scene.with_frames();
        }
        if dimensions {
            scene = scene.with_dimensions();
        }
        let svg = py.detach(|| scene.svg(&style));
        Ok(Picture { svg, arm: self.arm.model().name.clone() })
    }

    /// Name of the arm.
    #[getter]
    fn name(&self) -> &str {
        &self.arm.model().name
    }

    /// The number of moving joints, n.
    #[getter]
    fn dof(&self) -> usize {
        self.arm.joints()
    }

    /// Names of the joints.
    #[getter]
    fn joint_names<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.arm.joint_names().collect::<Vec<_>>())
    }

    /// "revolute" or "prismatic" for each joint.
    #[getter]
    fn joint_kinds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let word = |kind: &JointKind| if *kind == JointKind::Prismatic { "prismatic" } else { "revolute" };
        PyTuple::new(py, self.arm.joint_kinds().iter().map(word).collect::<Vec<_>>())
    }

    /// Lower and upper limit of each joint, (n, 2) float64: rad or the length unit, infinite where the file has none.
    #[getter]
    fn limits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        crate::array::filled(py, &[self.arm.joints(), 2], self.arm.limits().iter().flatten().copied())
    }

    /// The largest rate of each joint, (n,) float64: rad/s or the length unit/s, infinite where the file has none.
    #[getter]
    fn max_velocity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        crate::array::filled(py, &[self.arm.joints()], self.arm.max_velocity())
    }

    /// The largest acceleration of each joint, (n,) float64: rad/s^2 or the length unit/s^2, infinite where the file has
    /// none.
    #[getter]
    fn max_acceleration<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        crate::array::filled(py, &[self.arm.joints()], self.arm.max_acceleration())
    }

    /// Unit of all lengths: "m", "cm", "mm" or "in".
    #[getter]
    fn length_unit(&self) -> String {
        self.arm.length_unit().to_string()
    }

    /// The task of the inverse, such as "pose"; None for an arm without inverse.
    #[getter]
    fn task(&self) -> Option<&'static str> {
        self.arm.task().ok()
    }

    /// Names of the values that the inverse takes as `given=`.
    #[getter]
    fn given<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.arm.given().unwrap_or_default())
    }

    /// The largest number of solutions of a target, S; 0 for an arm without inverse.
    #[getter]
    fn max_solutions(&self) -> usize {
        self.arm.max_solutions().unwrap_or(0)
    }

    /// Pose of the tool in the base frame, (4, 4), of q (n,); (N, 4, 4) of q (N, n).
    fn forward<'py>(&self, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.poses(q, None)
    }

    /// Poses of the tool in the base frame, (N, 4, 4), of q (N, n), with `threads` threads, by default one a processor.
    ///
    /// `out`: an array (N, 4, 4) to write to. No lock of Python is held; do not change `q` or `out` meanwhile.
    #[pyo3(signature = (q, *, threads=None, out=None))]
    fn forward_batch<'py>(
        &self,
        q: &Bound<'py, PyAny>,
        threads: Option<i64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.poses(q, Some((threads, out)))
    }

    /// Poses of the links in the base frame, (n, 4, 4), of q (n,). Each contains the base, the rows up to its joint, and
    /// the fixed rows behind it; the last one is without the tool.
    fn link_poses<'py>(&self, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = q.py();
        let q = self.joints("q", q)?;
        let links = self.arm.link_poses(&q).map_err(|error| error::dynamic(py, &error))?;
        crate::array::filled(py, &[links.len(), 4, 4], links.iter().flat_map(target::matrix))
    }

    /// Geometric Jacobian in the base frame, at the tool point, (6, n), of q (n,); (N, 6, n) of q (N, n). The rows are
    /// vx vy vz wx wy wz.
    fn jacobian<'py>(&self, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.jacobians(q, None)
    }

    /// Jacobians (N, 6, n) of q (N, n), with `threads` threads; `out` as of `forward_batch`.
    #[pyo3(signature = (q, *, threads=None, out=None))]
    fn jacobian_batch<'py>(
        &self,
        q: &Bound<'py, PyAny>,
        threads: Option<i64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.jacobians(q, Some((threads, out)))
    }

    /// Velocity of the tool in the base frame, vx vy vz wx wy wz, (6,) or (N, 6), at q with joint rates qd, of one shape:
    /// (n,) or (N, n). Length unit / s and rad / s.
    fn velocity<'py>(&self, q: &Bound<'py, PyAny>, qd: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.beside(q, [("qd", qd)], |q, [qd]| match self.arm.velocity(q, qd) {
            Ok(denhart::Twist { linear: [a, b, c], angular: [d, e, f] }) => [a, b, c, d, e, f],
            Err(_) => [f64::NAN; 6],
        })
    }

    /// Acceleration of the tool in the base frame, (6,) or (N, 6), at q with joint rates qd and their derivatives qdd, of
    /// one shape: (n,) or (N, n). First the second derivative of the tool point's position, then the derivative of the
    /// angular velocity.
    fn acceleration<'py>(
        &self,
        q: &Bound<'py, PyAny>,
        qd: &Bound<'py, PyAny>,
        qdd: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.beside(q, [("qd", qd), ("qdd", qdd)], |q, [qd, qdd]| match self.arm.acceleration(q, qd, qdd) {
            Ok(denhart::Acceleration { linear: [a, b, c], angular: [d, e, f] }) => [a, b, c, d, e, f],
            Err(_) => [f64::NAN; 6],
        })
    }

    /// Manipulability (Yoshikawa 1985) at q (n,): the product of the singular values of the Jacobian, 0 where the arm is
    /// singular. `counts`: six truth values, which of the rows vx vy vz wx wy wz count; by default the motion that the
    /// arm's task counts.
    #[pyo3(signature = (q, counts=None))]
    fn manipulability(&self, q: &Bound<'_, PyAny>, counts: Option<[bool; 6]>) -> PyResult<f64> {
        let py = q.py();
        let q = self.joints("q", q)?;
        let found = match counts {
            Some(counts) => self.arm.manipulability_of(&q, counts),
            None => self.arm.manipulability(&q),
        };
        found.map_err(|error| error::dynamic(py, &error))
    }

    /// Motor values (n,) at joint values q (n,), rad or the length unit, where the arm file links motors (`coupling`); the
    /// joint values themselves where it does not.
    fn to_motor<'py>(&self, q: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.linked("q", q, DynamicArm::to_motor)
    }

    /// Joint values (n,) at motor values (n,), rad or the length unit.
    #[allow(clippy::wrong_self_convention)]
    fn from_motor<'py>(&self, motor: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.linked("motor", motor, DynamicArm::from_motor)
    }

    /// Pulse counts of the motors at joint values q (n,), a list of n ints, for an arm file with `actuator`. A count beyond
    /// 32 bits, or of a value that is not finite, is a ValueError.
    fn to_pulses(&self, q: &Bound<'_, PyAny>) -> PyResult<Vec<i32>> {
        let py = q.py();
        let q = self.joints("q", q)?;
        let (pulses, saturated) = self.arm.to_pulses(&q).map_err(|error| error::dynamic(py, &error))?;
        if saturated.is_empty() {
            return Ok(pulses);
        }
        Err(error::value(format!("q: no pulse count of 32 bits reaches the value of {saturated}")))
    }

    /// Joint values (n,) at pulse counts of the motors.
    #[allow(clippy::needless_pass_by_value, clippy::wrong_self_convention)]
    fn from_pulses<'py>(&self, py: Python<'py>, pulses: Vec<i32>) -> PyResult<Bound<'py, PyAny>> {
        let q = self.arm.from_pulses(&pulses).map_err(|error| error::dynamic(py, &error))?;
        crate::array::filled(py, &[q.len()], q.iter().copied())
    }

    /// How far q (n,) is from each kind of singularity: a dict from "shoulder", "elbow", "wrist" or the joints "q1 q3" to
    /// a number without a unit, zero at that singularity and of opposite signs on the branches that meet there. None for
    /// an arm whose task has no margins.
    fn margins<'py>(&self, q: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let py = q.py();
        let q = self.joints("q", q)?;
        let Some(margins) = self.arm.margins(&q).map_err(|error| error::dynamic(py, &error))? else {
            return Ok(None);
        };
        let dict = PyDict::new(py);
        for margin in margins {
            dict.set_item(margin.name, margin.value)?;
        }
        Ok(Some(dict))
    }

    /// The target of the arm's task that q (n,) reaches.
    fn target_at(&self, q: &Bound<'_, PyAny>) -> PyResult<Target> {
        let py = q.py();
        let q = self.joints("q", q)?;
        self.arm.target_at(&q).map(Target).map_err(|error| error::dynamic(py, &error))
    }

    /// Every joint vector that reaches a target.
    ///
    /// `target` is a 4 x 4 array, a SciPy RigidTransform, (rotation, point), a `denhart.Target`, or the numbers of the
    /// arm's task: x y z; x y z u v w; x y z angle; x y phi; x y.
    ///
    /// `near` (n,): solutions have their joints on the turns next to it, and are sorted nearest first. `given`: the values
    /// of the redundant joints that `arm.given` names; `near` has them, too. `limits`: "mark" gives solutions outside the
    /// joint limits a flag; "drop" leaves them out, but for those that whole turns of joints bring inside.
    #[pyo3(signature = (target, near=None, given=None, limits="mark"))]
    fn inverse(
        slf: &Bound<'_, Self>,
        target: &Bound<'_, PyAny>,
        near: Option<&Bound<'_, PyAny>>,
        given: Option<&Bound<'_, PyAny>>,
        limits: &str,
    ) -> PyResult<Solutions> {
        Asked::read(slf.get(), target, near, given, limits)?.solve(slf.py(), slf.clone().unbind())
    }

    /// The solution on one branch, in words such as "shoulder left, elbow up, wrist flip", as `Solution.branch` has them.
    #[pyo3(signature = (target, branch, given=None, limits="mark"))]
    fn inverse_branch(
        slf: &Bound<'_, Self>,
        target: &Bound<'_, PyAny>,
        branch: &str,
        given: Option<&Bound<'_, PyAny>>,
        limits: &str,
    ) -> PyResult<Solutions> {
        self::branch(branch)?;
        let asked = Asked::read(slf.get(), target, None, given, limits)?;
        Asked { branch: Some(branch.to_owned()), ..asked }.solve(slf.py(), slf.clone().unbind())
    }

    /// Solutions for n values of the redundant joint, the middles of n equal steps over its limits, or over a turn: a list
    /// of pairs of the value and its `Solutions`.
    ///
    /// An arm that takes several values beside the target gets a tuple of as many counts: the pairs have a tuple of values.
    /// The steps are those of `denhart inverse --sweep`; a million values in all are the most.
    #[pyo3(signature = (target, n, limits="mark"))]
    fn sweep<'py>(
        slf: &Bound<'py, Self>,
        target: &Bound<'py, PyAny>,
        n: &Bound<'py, PyAny>,
        limits: &str,
    ) -> PyResult<Bound<'py, PyList>> {
        sweep::sweep(slf, target, n, limits)
    }

    /// Solutions of many targets, with `threads` threads, by default one a processor.
    ///
    /// `targets`: (N, 4, 4) poses, or (N, k) numbers of the arm's task. `near`: (n,), or (N, n), one for each target.
    /// `given`: values for all targets, or for each, (N,) or (N, k). `out`: an array (N, S, n) that `q` is written to. No
    /// lock of Python is held; do not change the arrays meanwhile. A target that is not finite has the status BAD_TARGET.
    /// With `limits="drop"` a target may be reachable and have no solution that is listed: ask `count`, not `status`.
    #[pyo3(signature = (targets, near=None, given=None, limits="mark", *, threads=None, out=None))]
    #[allow(clippy::too_many_arguments)]
    fn inverse_batch<'py>(
        &self,
        targets: &Bound<'py, PyAny>,
        near: Option<&Bound<'py, PyAny>>,
        given: Option<&Bound<'py, PyAny>>,
        limits: &str,
        threads: Option<i64>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<InverseBatch> {
        Batch { targets, near, given, limits, threads, out }.solve(targets.py(), self)
    }

    /// Joint values over time that bring the tool along a path through `targets`, within the rates of the joints: from rest
    /// at the first target to rest at the last one, a row each `dt` s.
    ///
    /// `targets`: (N, 4, 4) poses, or (N, k) numbers of the arm's task, N >= 2. Between them the path is smooth; where its
    /// direction turns by more than 30 degrees it has a corner. `times` (N,): the time of each target, s.
    ///
    /// `keep`: "path" gives the fastest motion whose tool stays within `tolerance` of the path, planned over all branches and
    /// turns, and never ahead of `times`; the last row is its end. "time" keeps `times`, and the tool leaves the path where
    /// the rates do not allow both. `start` (n,): joint values at the first target, by default the best of all solutions.
    /// `given`: values for all targets, or for each, (N,) or (N, k), by default those of `start`. `tolerance`: in the arm's
    /// length unit, by default 1e-5 of the reach; a turn counts as the way of a point at the reach. `max_velocity` and
    /// `max_acceleration` (n,), or one number for all joints: rad or the length unit per s and s^2, by default those of the
    /// arm file; np.inf is no limit of an acceleration. `motor_rates`: they are those of the motors, which the file's
    /// `coupling` links to the joints.
    ///
    /// No lock of Python is held, and Ctrl-C ends the call. The steps are those of `denhart follow`.
    #[pyo3(signature = (targets, dt=0.001, *, times=None, keep="path", start=None, given=None, tolerance=None, max_velocity=None, max_acceleration=None, motor_rates=false))]
    #[allow(clippy::too_many_arguments)]
    fn follow<'py>(
        &self,
        targets: &Bound<'py, PyAny>,
        dt: f64,
        times: Option<&Bound<'py, PyAny>>,
        keep: &str,
        start: Option<&Bound<'py, PyAny>>,
        given: Option<&Bound<'py, PyAny>>,
        tolerance: Option<f64>,
        max_velocity: Option<&Bound<'py, PyAny>>,
        max_acceleration: Option<&Bound<'py, PyAny>>,
        motor_rates: bool,
    ) -> PyResult<Motion> {
        let path =
            Followed { targets, dt, times, keep, start, given, tolerance, max_velocity, max_acceleration, motor_rates };
        path.follow(targets.py(), self)
    }

    /// A follower of a target that moves, at rest at `start` (n,): each `step(target)` is a tick of `dt` s, within the rates and
    /// the ranges of the joints, and on the target wherever these allow. For a path known before, `follow` is better.
    ///
    /// `max_velocity` and `max_acceleration` (n,), or one number for all joints: rad or the length unit per s and s^2, by
    /// default those of the arm file; np.inf is no limit of an acceleration. `given`: values of the redundant joints that
    /// `arm.given` names, for targets without, by default those of `start`. `length`, in the arm's length unit, weighs as much
    /// as 1 rad where the tool has to deviate: a small one keeps the position; by default about a tenth of the reach.
    /// `crossing`: singularities through which a deviation may lead, "exact" (none), "wrist" or "any". `motor_rates` as of `follow`.
    #[pyo3(signature = (start, dt=0.001, *, max_velocity=None, max_acceleration=None, given=None, length=None, crossing="wrist", motor_rates=false))]
    #[allow(clippy::too_many_arguments)]
    fn follower(
        slf: &Bound<'_, Self>,
        start: &Bound<'_, PyAny>,
        dt: f64,
        max_velocity: Option<&Bound<'_, PyAny>>,
        max_acceleration: Option<&Bound<'_, PyAny>>,
        given: Option<&Bound<'_, PyAny>>,
        length: Option<f64>,
        crossing: &str,
        motor_rates: bool,
    ) -> PyResult<Follower> {
        let beginning = Beginning { start, dt, max_velocity, max_acceleration, given, length, crossing, motor_rates };
        beginning.follower(slf.py(), slf.clone().unbind())
    }

    /// A joint vector by iteration from `start` (n,): for arms without a closed form, and for the closest approach to a
    /// target out of reach. Without an inverse the target is a pose. `limits` keeps joints within their limits. A million
    /// iterations in all, `(restarts + 1) * max_iterations`, are the most.
    #[pyo3(signature = (target, start, *, limits=true, restarts=10, max_iterations=300))]
    fn numeric(
        &self,
        target: &Bound<'_, PyAny>,
        start: &Bound<'_, PyAny>,
        limits: bool,
        restarts: usize,
        max_iterations: usize,
    ) -> PyResult<NumericSolution> {
        let py = target.py();
        let all = restarts.saturating_add(1).saturating_mul(max_iterations);
        if all > MOST_ITERATIONS {
            return Err(error::value(format!(
                "numeric: expected up to {MOST_ITERATIONS} iterations in all, (restarts + 1) * max_iterations, found {all}"
            )));
        }
        let start = self.joints("start", start)?;
        let target = match self.arm.task() {
            Ok(_) => target::read(&self.arm, target)?,
            Err(_) => DynamicTarget::Pose(target::pose(target)?),
        };
        let Some((goal, task)) = beyond::task(&self.arm, &target) else {
            return Err(error::value(
                "numeric: the iteration has no task position_angle; give arm.inverse such a target",
            ));
        };
        let chain = chain(self.arm.model());
        let numeric =
            NumericInverse::new().task(task).max_iterations(max_iterations).restarts(restarts).within_limits(limits);
        let within = limits.then(|| self.arm.limits());
        let found = py.detach(|| numeric.solve_chain(&chain, &goal.into(), &start, within));
        let found = found.map_err(|reason| error::arm(py, reason))?;
        Ok(NumericSolution {
            text: found.to_string(),
            converged: found.converged(),
            iterations: found.iterations,
            restarts: found.restarts,
            residual: (found.residual.position, found.residual.orientation),
            values: found.q,
            kinds: self.arm.joint_kinds().to_vec(),
        })
    }

    fn __repr__(&self) -> String {
        let kinds: String =
            self.arm.joint_kinds().iter().map(|kind| if *kind == JointKind::Prismatic { 'P' } else { 'R' }).collect();
        let inverse = match (self.arm.task(), self.arm.max_solutions()) {
            (Ok(task), Ok(most)) => {
                format!("inverse {task}, at most {most} solution{}", if most == 1 { "" } else { "s" })
            }
            _ => "no inverse: report() says why".to_owned(),
        };
        let given = self.arm.given().unwrap_or_default();
        let given = if given.is_empty() { String::new() } else { format!(", given {}", given.join(", ")) };
        format!("<Arm {}: {kinds}, lengths in {}, {inverse}{given}>", self.name(), self.length_unit())
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Arm>().is_ok_and(|other| other.get().text == self.text)
    }

    fn __hash__(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.text.hash(&mut hasher);
        hasher.finish()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (&str, &str))> {
        Ok((PyType::new::<Self>(py).getattr("from_yaml")?, (&self.text, &self.file)))
    }
}
