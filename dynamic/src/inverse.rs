//! The inverse of an arm known at run time.

use denhart::solve::Swivel;
use denhart::solve::wrap;
use denhart::{Branch, PlanarPose, PointAngle, PointAxis, Pose, Residual, Status, math};
use denhart_codegen::lower::{Given, Goal, Inverse};

use crate::function::Sum;
use crate::solver::{Asked, Solve};
use crate::{DynamicArm, DynamicError, DynamicSolution, DynamicSolutions, DynamicTarget};

impl DynamicArm {
    /// The task of the inverse, as an arm file names it.
    ///
    /// # Errors
    /// Why there is no inverse; the same for all functions of the inverse.
    pub fn task(&self) -> Result<&'static str, DynamicError> {
        Ok(task(&self.inverse_program()?.goal))
    }

    /// Name of the value that the inverse takes beside the target: `q3`, or `the arm angle`.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn given(&self) -> Result<Option<String>, DynamicError> {
        Ok(self.inverse_program()?.given.map(|given| match given {
            Given::Joint { joint, .. } => format!("q{}", joint + 1),
            Given::ArmAngle => "the arm angle".to_owned(),
        }))
    }

    /// Returns true if the value that the inverse takes beside the target is a length: the displacement of a prismatic
    /// joint.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn given_slides(&self) -> Result<bool, DynamicError> {
        Ok(matches!(self.inverse_program()?.given, Some(Given::Joint { revolute: false, .. })))
    }

    /// The largest number of solutions of a target.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn max_solutions(&self) -> Result<usize, DynamicError> {
        Ok(self.inverse_program()?.capacity)
    }

    fn inverse_program(&self) -> Result<&Inverse, DynamicError> {
        self.solver.as_ref().map_err(Clone::clone)?;
        self.program.inverse.as_ref().map_err(|reason| DynamicError::NoInverse(reason.clone()))
    }

    fn solver(&self, target: &DynamicTarget) -> Result<&dyn Solve, DynamicError> {
        let (expected, found) = (self.task()?, target.task());
        if expected != found {
            return Err(DynamicError::Target { expected, found });
        }
        self.solver.as_ref().map(AsRef::as_ref).map_err(Clone::clone)
    }

    /// Every joint vector that reaches `target`, in the order of the generated `inverse`.
    ///
    /// `given`: the value of the redundant joint, or the arm angle, where [`given`](Self::given) names one.
    ///
    /// # Errors
    /// An arm without inverse; a target of another task; a given value too many, or none where one is needed.
    pub fn inverse(&self, target: &DynamicTarget, given: Option<f64>) -> Result<DynamicSolutions, DynamicError> {
        let given = self.beside(given)?;
        Ok(self.solver(target)?.solve(&Asked { target, given, near: None, branch: None }))
    }

    /// Solutions of [`inverse`](Self::inverse) with their joints next to `q_ref`, sorted nearest first. Free joints,
    /// and the value that the inverse takes beside the target, stay at their values in `q_ref`.
    ///
    /// # Errors
    /// An arm without inverse; a target of another task; a joint vector whose length is not the number of joints.
    pub fn inverse_near(&self, target: &DynamicTarget, q_ref: &[f64]) -> Result<DynamicSolutions, DynamicError> {
        self.counted(q_ref)?;
        let solver = self.solver(target)?;
        let given = self.held(q_ref)?.unwrap_or(f64::NAN);
        Ok(solver.solve(&Asked { target, given, near: Some(q_ref), branch: None }))
    }

    /// The solution of [`inverse`](Self::inverse) on one branch, or the status that says why there is none.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse).
    pub fn inverse_branch(
        &self,
        target: &DynamicTarget,
        given: Option<f64>,
        branch: Branch,
    ) -> Result<Result<DynamicSolution, Status<f64>>, DynamicError> {
        if self.inverse_program()?.held_joint.is_some() {
            return Err(DynamicError::NoBranches);
        }
        let given = self.beside(given)?;
        Ok(self.solver(target)?.one(&Asked { target, given, near: None, branch: Some(branch) }))
    }

    fn beside(&self, given: Option<f64>) -> Result<f64, DynamicError> {
        match (self.given()?, given) {
            (None, None) => Ok(f64::NAN),
            (Some(_), Some(value)) => {
                // Sums with a given angle lose no digits to its turns.
                let turns = matches!(self.inverse_program()?.given, Some(Given::Joint { revolute: true, .. }));
                Ok(if turns { wrap(value) } else { value })
            }
            (Some(name), None) => Err(DynamicError::Given(format!("the value of {name}"))),
            (None, Some(_)) => Err(DynamicError::NothingGiven),
        }
    }

    /// Value that the inverse takes beside the target, at a joint vector; `None` if it takes no such value.
    ///
    /// # Errors
    /// An arm without inverse; a joint vector whose length is not the number of joints.
    pub fn held(&self, q: &[f64]) -> Result<Option<f64>, DynamicError> {
        match self.inverse_program()?.given {
            None => Ok(None),
            Some(Given::Joint { joint, .. }) => {
                self.counted(q)?;
                Ok(q.get(joint).copied())
            }
            Some(Given::ArmAngle) => self.arm_angle(q).map(Some),
        }
    }

    /// The arm angle of a joint vector, rad in (-pi, pi]: how far the elbow is swung about the line from shoulder to
    /// wrist.
    ///
    /// # Errors
    /// An arm whose inverse does not take an arm angle; a joint vector whose length is not the number of joints.
    pub fn arm_angle(&self, q: &[f64]) -> Result<f64, DynamicError> {
        let constants = self.inverse_program()?.swivel.as_ref().ok_or(DynamicError::NothingGiven)?;
        let shoulder = Pose { rotation: constants.shoulder.r, translation: constants.shoulder.p };
        let swivel = Swivel { shoulder, wrist: constants.wrist, axis: constants.axis, elbow: constants.elbow };
        let links = self.link_poses(q)?;
        Ok(links.get(3).map_or(f64::NAN, |link| swivel.angle(link)))
    }

    /// Residual of `q` for the target.
    ///
    /// # Errors
    /// As of [`inverse_near`](Self::inverse_near).
    pub fn residual(&self, q: &[f64], target: &DynamicTarget) -> Result<Residual<f64>, DynamicError> {
        self.counted(q)?;
        Ok(self.solver(target)?.residual(q, target, &self.pose(q)))
    }

    /// The target of the arm's task that a joint vector reaches.
    ///
    /// # Errors
    /// An arm without inverse; a joint vector whose length is not the number of joints.
    pub fn target_at(&self, q: &[f64]) -> Result<DynamicTarget, DynamicError> {
        self.counted(q)?;
        let goal = &self.inverse_program()?.goal;
        Ok(target_of(goal, &self.pose(q), q))
    }

    /// The target of the arm's task that the tool meets in a pose; `None` for `position_angle`, whose angle no pose tells.
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn target_of(&self, pose: &Pose<f64>) -> Result<Option<DynamicTarget>, DynamicError> {
        Ok(match &self.inverse_program()?.goal {
            Goal::PositionAngle { .. } => None,
            goal => Some(target_of(goal, pose, &[])),
        })
    }
}

/// A task by its name in an arm file.
fn task(goal: &Goal) -> &'static str {
    match goal {
        Goal::Pose => "pose",
        Goal::Position => "position",
        Goal::PositionAxis { .. } => "position_axis",
        Goal::PositionAngle { .. } => "position_angle",
        Goal::PlanarPose => "planar_pose",
        Goal::PlanarPosition => "planar_position",
    }
}

/// The target that a pose and a joint vector reach, by the task of `goal`.
fn target_of(goal: &Goal, pose: &Pose<f64>, q: &[f64]) -> DynamicTarget {
    let (point, rotation) = (pose.translation, pose.rotation);
    let ([x, y, _], [[cos, ..], [sin, ..], _]) = (point, rotation);
    match goal {
        Goal::Pose => DynamicTarget::Pose(*pose),
        Goal::Position => DynamicTarget::Position(point),
        Goal::PositionAxis { column } => {
            let axis = rotation.map(|row| row.get(*column).copied().unwrap_or(f64::NAN));
            DynamicTarget::PositionAxis(PointAxis::new(point, axis))
        }
        Goal::PositionAngle { .. } => {
            let angle = goal.angle_sum().map_or(f64::NAN, |sum| Sum::new(&sum).value(q));
            DynamicTarget::PositionAngle(PointAngle::new(point, math::wrap(angle)))
        }
        Goal::PlanarPose => DynamicTarget::PlanarPose(PlanarPose::new(x, y, math::atan2(sin, cos))),
        Goal::PlanarPosition => DynamicTarget::PlanarPosition([x, y]),
    }
}
