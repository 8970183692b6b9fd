//! An arm known at run time.

use std::env;
use std::path::{Path, PathBuf};

use denhart::{JointKind, LengthUnit, Pose};
use denhart_codegen::model::{self, Model};
use denhart_codegen::{Program, program, read_file};

use crate::function::Straight;
use crate::margins::Factors;
use crate::solver::{Solve, solver};
use crate::{DynamicError, DynamicMargin, Joints};

/// Rows `vx vy vz wx wy wz` of a geometric Jacobian in the base frame, at the tool point; a number for each joint.
pub type DynamicJacobian = [Joints; 6];

/// An arm whose file is read at run time.
///
/// It evaluates the expressions and the plan that code would be generated from, with the same kernels. Its results are
/// those of the generated code in `f64`, to the bit. Angles are rad, lengths in [`length_unit`](Self::length_unit).
#[derive(Debug)]
pub struct DynamicArm {
    pub(crate) program: Program,
    pub(crate) forward: Straight,
    pub(crate) jacobian: Straight,
    pub(crate) both: Straight,
    links: Straight,
    motors: Option<Motors>,
    margins: Option<Factors>,
    /// The inverse, or why there is none.
    pub(crate) solver: Result<Box<dyn Solve>, DynamicError>,
    limits: Vec<[f64; 2]>,
    kinds: Vec<JointKind>,
    #[cfg(feature = "batch")]
    pub(crate) lanes: crate::batch::ForLanes,
}

#[derive(Debug)]
struct Motors {
    to: Straight,
    from: Straight,
    row: Straight,
}

impl DynamicArm {
    /// The arm of the text of an arm file.
    ///
    /// # Errors
    /// Every mistake in the text, with its place.
    pub fn from_yaml(text: &str) -> Result<Self, DynamicError> {
        Self::named(text, "arm.yaml")
    }

    /// The arm of a file.
    ///
    /// # Errors
    /// A file that cannot be read; every mistake in it, with its place.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, DynamicError> {
        let path = path.as_ref();
        let here = env::current_dir().unwrap_or_else(|_| PathBuf::new());
        Self::named(&read_file(&here, path)?, &path.display().to_string())
    }

    /// The arm of the text of an arm file, which messages call `file`.
    ///
    /// # Errors
    /// Every mistake in the text, with its place.
    pub fn named(text: &str, file: &str) -> Result<Self, DynamicError> {
        let program = program(text, file)?;
        let both = Straight::new(&program.functions.both);
        let reach = program.inverse.as_ref().map_or(1.0, |inverse| inverse.constants.reach);
        let solver = match &program.inverse {
            Ok(inverse) => solver(inverse, &both),
            Err(reason) => Err(DynamicError::NoInverse(reason.clone())),
        };
        let kind = |joint: &model::Joint| match joint.kind {
            model::JointKind::Revolute => JointKind::Revolute,
            model::JointKind::Prismatic => JointKind::Prismatic,
        };
        Ok(DynamicArm {
            forward: Straight::new(&program.functions.forward),
            jacobian: Straight::new(&program.functions.jacobian),
            both,
            links: Straight::new(&program.functions.links),
            motors: program.linked.as_ref().map(|linked| Motors {
                to: Straight::linear(&linked.to_motor),
                from: Straight::linear(&linked.from_motor),
                row: Straight::linear(&linked.row),
            }),
            margins: program.margins.as_ref().map(|margins| Factors::new(margins, reach)),
            solver,
            limits: denhart_codegen::lower::limits(&program.model),
            #[cfg(feature = "batch")]
            lanes: crate::batch::ForLanes::default(),
            kinds: program.model.joints.iter().map(kind).collect(),
            program,
        })
    }

    /// The checked arm file.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.program.model
    }

    /// The programs that are evaluated.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// The number of moving joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.kinds.len()
    }

    /// Kind of each joint: revolute or prismatic.
    #[must_use]
    pub fn joint_kinds(&self) -> &[JointKind] {
        &self.kinds
    }

    /// Names of the joints.
    pub fn joint_names(&self) -> impl Iterator<Item = &str> {
        self.program.model.joints.iter().map(|joint| joint.name.as_str())
    }

    /// Lower and upper limit of every joint, rad or length unit; infinite where the file has none.
    #[must_use]
    pub fn limits(&self) -> &[[f64; 2]] {
        &self.limits
    }

    /// Greatest velocity of every joint, rad/s or length unit/s; infinite where the file has none.
    pub fn max_velocity(&self) -> impl Iterator<Item = f64> {
        self.program.model.joints.iter().map(|joint| joint.max_velocity)
    }

    /// Greatest acceleration of every joint, rad/s^2 or length unit/s^2; infinite where the file has none.
    pub fn max_acceleration(&self) -> impl Iterator<Item = f64> {
        self.program.model.joints.iter().map(|joint| joint.max_acceleration)
    }

    /// Unit of all lengths.
    #[must_use]
    pub fn length_unit(&self) -> LengthUnit {
        match self.program.model.length_unit {
            model::LengthUnit::Meter => LengthUnit::Meter,
            model::LengthUnit::Centimeter => LengthUnit::Centimeter,
            model::LengthUnit::Millimeter => LengthUnit::Millimeter,
            model::LengthUnit::Inch => LengthUnit::Inch,
        }
    }

    pub(crate) fn counted(&self, values: &[f64]) -> Result<(), DynamicError> {
        let (expected, found) = (self.joints(), values.len());
        if expected == found { Ok(()) } else { Err(DynamicError::Joints { expected, found }) }
    }

    /// Pose of the tool in the base frame.
    ///
    /// # Errors
    /// If the length of `q` is not the number of joints. So for all functions of `q`.
    pub fn forward(&self, q: &[f64]) -> Result<Pose<f64>, DynamicError> {
        self.counted(q)?;
        Ok(self.pose(q))
    }

    pub(crate) fn pose(&self, q: &[f64]) -> Pose<f64> {
        let mut pose = Pose::identity();
        self.forward.run(q, pose.rotation.iter_mut().flatten().chain(&mut pose.translation));
        pose
    }

    /// Poses of the links in the base frame, one for each joint. The pose of a joint's link contains the base, the rows
    /// up to and including the joint, and the fixed rows behind it. The last link is without the tool.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn link_poses(&self, q: &[f64]) -> Result<Vec<Pose<f64>>, DynamicError> {
        self.counted(q)?;
        let mut poses = vec![Pose::identity(); self.joints()];
        let places = poses.iter_mut().flat_map(|pose| pose.rotation.iter_mut().flatten().chain(&mut pose.translation));
        self.links.run(q, places);
        Ok(poses)
    }

    /// Geometric Jacobian in the base frame, at the tool point.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn jacobian(&self, q: &[f64]) -> Result<DynamicJacobian, DynamicError> {
        self.counted(q)?;
        let mut rows = self.rows();
        self.jacobian.run(q, rows.iter_mut().flat_map(|row| row.iter_mut()));
        Ok(rows)
    }

    fn rows(&self) -> DynamicJacobian {
        [Joints::new(self.kinds.iter().map(|_| 0.0)); 6]
    }

    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian), sharing their terms.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn forward_and_jacobian(&self, q: &[f64]) -> Result<(Pose<f64>, DynamicJacobian), DynamicError> {
        self.counted(q)?;
        let (mut pose, mut rows) = (Pose::identity(), self.rows());
        let places = pose.rotation.iter_mut().flatten().chain(&mut pose.translation);
        let places = places.chain(rows.iter_mut().flat_map(|row| row.iter_mut()));
        self.both.run(q, places);
        Ok((pose, rows))
    }

    /// How far `q` is from each kind of singularity; `None` for a task that has no margins.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn margins(&self, q: &[f64]) -> Result<Option<Vec<DynamicMargin>>, DynamicError> {
        self.counted(q)?;
        Ok(self.margins.as_ref().map(|margins| margins.at(q, &self.pose(q))))
    }

    /// The place among the [`margins`](Self::margins) of the one named `wrist`.
    pub(crate) fn wrist_factor(&self) -> Option<usize> {
        self.margins.as_ref().and_then(Factors::wrist)
    }

    /// Motor values at joint values; the joint values themselves where motors are not linked.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn to_motor(&self, q: &[f64]) -> Result<Joints, DynamicError> {
        self.product(self.motors.as_ref().map(|motors| &motors.to), q)
    }

    /// Joint values at motor values.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn from_motor(&self, motor: &[f64]) -> Result<Joints, DynamicError> {
        self.product(self.motors.as_ref().map(|motors| &motors.from), motor)
    }

    /// Geometric Jacobian with respect to the motors.
    ///
    /// # Errors
    /// As of [`forward`](Self::forward).
    pub fn motor_jacobian(&self, q: &[f64]) -> Result<DynamicJacobian, DynamicError> {
        let mut rows = self.jacobian(q)?;
        for row in &mut rows {
            *row = self.product(self.motors.as_ref().map(|motors| &motors.row), row)?;
        }
        Ok(rows)
    }

    fn product(&self, function: Option<&Straight>, values: &[f64]) -> Result<Joints, DynamicError> {
        self.counted(values)?;
        let mut product = Joints::new(values.iter().copied());
        if let Some(function) = function {
            function.run(values, product.iter_mut());
        }
        Ok(product)
    }
}
