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

    /// Names of the values that the inverse takes beside the target, in order: `q3`, or `the arm angle`.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn given(&self) -> Result<Vec<String>, DynamicError> {
        let name = |given: &Given| match given {
            Given::Joint { joint, .. } => format!("q{}", joint + 1),
            Given::ArmAngle => "the arm angle".to_owned(),
        };
        Ok(self.inverse_program()?.given.values.iter().map(name).collect())
    }

    /// Returns true if generated code takes the values beside the target as an array, because the file names them in a list.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn given_is_list(&self) -> Result<bool, DynamicError> {
        Ok(self.inverse_program()?.given.is_list)
    }

    /// Of each value that the inverse takes beside the target true if it is a length: the displacement of a prismatic
    /// joint.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn given_slides(&self) -> Result<Vec<bool>, DynamicError> {
        let slides = |given: &Given| matches!(given, Given::Joint { revolute: false, .. });
        Ok(self.inverse_program()?.given.values.iter().map(slides).collect())
    }

    /// The largest number of solutions of a target.
    ///
    /// # Errors
    /// As of [`task`](Self::task).
    pub fn max_solutions(&self) -> Result<usize, DynamicError> {
        Ok(self.inverse_program()?.capacity)
    }

    pub(crate) fn inverse_program(&self) -> Result<&Inverse, DynamicError> {
        self.solver.as_ref().map_err(Clone::clone)?;
        self.program.inverse.as_ref().map_err(|reason| DynamicError::NoInverse(reason.clone()))
    }

    pub(crate) fn solver(&self, target: &DynamicTarget) -> Result<&dyn Solve, DynamicError> {
        let (expected, found) = (self.task()?, target.task());
        if expected != found {
            return Err(DynamicError::Target { expected, found });
        }
        self.solver.as_ref().map(AsRef::as_ref).map_err(Clone::clone)
    }

    /// Every joint vector that reaches `target`, in the order of the generated `inverse`.
    ///
    /// `given`: the values of the redundant joints, or the arm angle, that [`given`](Self::given) names, in its order.
    ///
    /// # Errors
    /// An arm without inverse; a target of another task; another number of given values than the inverse takes.
    pub fn inverse(&self, target: &DynamicTarget, given: &[f64]) -> Result<DynamicSolutions, DynamicError> {
        let mut solutions = DynamicSolutions::default();
        self.inverse_into(target, given, &mut solutions)?;
        Ok(solutions)
    }

    /// Like [`inverse`](Self::inverse), but overwrites `solutions` and keeps their memory.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse); `solutions` stay as they are.
    pub fn inverse_into(
        &self,
        target: &DynamicTarget,
        given: &[f64],
        solutions: &mut DynamicSolutions,
    ) -> Result<(), DynamicError> {
        let given = &self.beside(given)?;
        self.solver(target)?.solve(&Asked::all(target, given), solutions);
        Ok(())
    }

    /// Solutions of [`inverse`](Self::inverse) with their joints next to `q_ref`, sorted nearest first. Free joints,
    /// and the values that the inverse takes beside the target, stay at their values in `q_ref`.
    ///
    /// # Errors
    /// An arm without inverse; a target of another task; a joint vector whose length is not the number of joints.
    pub fn inverse_near(&self, target: &DynamicTarget, q_ref: &[f64]) -> Result<DynamicSolutions, DynamicError> {
        let mut solutions = DynamicSolutions::default();
        self.inverse_near_into(target, q_ref, &mut solutions)?;
        Ok(solutions)
    }

    /// Like [`inverse_near`](Self::inverse_near), but overwrites `solutions` and keeps their memory.
    ///
    /// # Errors
    /// As of [`inverse_near`](Self::inverse_near); `solutions` stay as they are.
    pub fn inverse_near_into(
        &self,
        target: &DynamicTarget,
        q_ref: &[f64],
        solutions: &mut DynamicSolutions,
    ) -> Result<(), DynamicError> {
        self.counted(q_ref)?;
        let solver = self.solver(target)?;
        let given = &self.held(q_ref)?;
        solver.solve(&Asked { near: Some(q_ref), ..Asked::all(target, given) }, solutions);
        Ok(())
    }

    /// Like [`inverse_near_into`](Self::inverse_near_into), but the values that the inverse takes beside the target are
    /// `given`, and not those of `q_ref`.
    ///
    /// # Errors
    /// As of [`inverse_near`](Self::inverse_near), and for another number of given values; `solutions` stay as they are.
    pub fn inverse_given_near_into(
        &self,
        target: &DynamicTarget,
        given: &[f64],
        q_ref: &[f64],
        solutions: &mut DynamicSolutions,
    ) -> Result<(), DynamicError> {
        self.counted(q_ref)?;
        let given = &self.beside(given)?;
        self.solver(target)?.solve(&Asked { near: Some(q_ref), ..Asked::all(target, given) }, solutions);
        Ok(())
    }

    /// Like [`inverse_given_near_into`](Self::inverse_given_near_into), without computing the branches that differ from
    /// `branch`. Components unset in it match any. The other solution of a spherical wrist, which comes from the first, is
    /// listed too. An arm whose inverse holds a joint lists every branch. `keeps_place`: see
    /// [`InverseKinematics::inverse_branch_near_into`](denhart::InverseKinematics::inverse_branch_near_into).
    ///
    /// # Errors
    /// As of [`inverse_given_near_into`](Self::inverse_given_near_into).
    pub fn inverse_branch_near_into(
        &self,
        target: &DynamicTarget,
        given: &[f64],
        branch: Branch,
        q_ref: &[f64],
        keeps_place: bool,
        solutions: &mut DynamicSolutions,
    ) -> Result<(), DynamicError> {
        self.counted(q_ref)?;
        let given = &self.beside(given)?;
        let branch = self.inverse_program()?.follows_single_branches().then_some(branch);
        let asked = Asked { near: Some(q_ref), branch, keeps_place, ..Asked::all(target, given) };
        self.solver(target)?.solve(&asked, solutions);
        Ok(())
    }

    /// The solution of [`inverse`](Self::inverse) on one branch, or the status that says why there is none.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse).
    pub fn inverse_branch(
        &self,
        target: &DynamicTarget,
        given: &[f64],
        branch: Branch,
    ) -> Result<Result<DynamicSolution, Status<f64>>, DynamicError> {
        if self.inverse_program()?.held_joint.as_ref().is_some_and(|plan| plan.names.is_none()) {
            return Err(DynamicError::NoBranches);
        }
        let given = &self.beside(given)?;
        Ok(self.solver(target)?.one(&Asked { branch: Some(branch), ..Asked::all(target, given) }))
    }

    /// The values as the solver takes them.
    pub(crate) fn beside(&self, given: &[f64]) -> Result<Vec<f64>, DynamicError> {
        let kinds = &self.inverse_program()?.given.values;
        if kinds.len() != given.len() {
            return Err(DynamicError::Given { expected: self.given()?, found: given.len() });
        }
        // Sums with a given angle lose no digits to its turns.
        let wrapped = |(kind, value): (&Given, &f64)| match kind {
            Given::Joint { revolute: true, .. } => wrap(*value),
            _ => *value,
        };
        Ok(kinds.iter().zip(given).map(wrapped).collect())
    }

    /// Values that the inverse takes beside the target, at a joint vector.
    ///
    /// # Errors
    /// An arm without inverse; a joint vector whose length is not the number of joints.
    pub fn held(&self, q: &[f64]) -> Result<Vec<f64>, DynamicError> {
        let kinds = &self.inverse_program()?.given.values;
        self.counted(q)?;
        let value = |kind: &Given| match *kind {
            Given::Joint { joint, .. } => Ok(q.get(joint).copied().unwrap_or(f64::NAN)),
            Given::ArmAngle => self.arm_angle(q),
        };
        kinds.iter().map(value).collect()
    }

    /// The arm angle of a joint vector, rad in (-pi, pi]: how far the elbow is swung about the line from shoulder to
    /// wrist.
    ///
    /// # Errors
    /// An arm whose inverse does not take an arm angle; a joint vector whose length is not the number of joints.
    pub fn arm_angle(&self, q: &[f64]) -> Result<f64, DynamicError> {
        let constants = self.inverse_program()?.swivel.as_ref().ok_or(DynamicError::NoArmAngle)?;
        let links = self.link_poses(q)?;
        let shoulder = Pose { rotation: constants.shoulder.r, translation: constants.shoulder.p };
        // The shoulder may stand on a link.
        let carrier = constants.first.checked_sub(1).and_then(|carrier| links.get(carrier));
        let shoulder = carrier.map_or(shoulder, |carrier| *carrier * shoulder);
        let swivel = Swivel { shoulder, wrist: constants.wrist, axis: constants.axis, elbow: constants.elbow };
        Ok(links.get(constants.first + 3).map_or(f64::NAN, |link| swivel.angle(link)))
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
