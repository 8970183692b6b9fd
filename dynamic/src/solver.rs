//! The inverse of an arm with `N` joints and at most `M` solutions.

use std::cell::RefCell;

use denhart::math;
use denhart::solve::{AllLocked, Evaluate, Goal, InPlane, MOST_DOUBTS, Pointing, Search, nearest_rotation};
use denhart::{Branch, Jacobian, Pose, Residual, Solutions, Status};
use denhart_codegen::lower::{self, Given, GivenValues, Input, Inverse};

use crate::arm_constants::ArmConstants;
use crate::branches::Branches;
use crate::function::Straight;
use crate::held_joint::HeldJointSolver;
use crate::margins::Factors;
use crate::nest::Nest;
use crate::run::Run;
use crate::trace::{Trace, Traced};
use crate::{DynamicError, DynamicSolution, DynamicSolutions, DynamicTarget};

/// Query to an inverse.
pub struct Asked<'a> {
    pub target: &'a DynamicTarget,
    /// The values beside the target, as many as the inverse takes.
    pub given: &'a [f64],
    /// The reference, with as many values as the arm has joints.
    pub near: Option<&'a [f64]>,
    /// The branch; none for all of them.
    pub branch: Option<Branch>,
    /// True if the member of a family of solutions to which the reference leads is wanted, however far.
    pub keeps_place: bool,
    /// Notes where branches end.
    pub trace: Option<&'a RefCell<Trace>>,
}

impl<'a> Asked<'a> {
    /// Every branch of a target.
    pub const fn all(target: &'a DynamicTarget, given: &'a [f64]) -> Self {
        Self { target, given, near: None, branch: None, keeps_place: true, trace: None }
    }
}

/// An inverse without the number of joints in its type.
pub trait Solve: std::fmt::Debug + Send + Sync {
    /// Every branch, or the one asked for; overwrites `solutions`.
    fn solve(&self, asked: &Asked, solutions: &mut DynamicSolutions);
    /// The solution of [`solve`](Self::solve), or its status.
    fn one(&self, asked: &Asked) -> Result<DynamicSolution, Status<f64>>;
    /// Residual of a joint vector, at which the tool has this pose.
    fn residual(&self, q: &[f64], target: &DynamicTarget, pose: &Pose<f64>) -> Residual<f64>;
}

/// The solver of a program, by its numbers of joints and solutions.
pub fn solver(program: &Inverse, both: &Straight) -> Result<Box<dyn Solve>, DynamicError> {
    let unsupported = || {
        let Inverse { joints, capacity, .. } = program;
        DynamicError::Unsupported(format!("an inverse of {joints} joints with up to {capacity} solutions"))
    };
    macro_rules! sizes {
        // `open` may name the capacity as `M`.
        ($open:expr; $($joints:literal: $($capacity:literal)*;)*) => {
            match (program.joints, program.capacity) {
                $($(($joints, $capacity) => {
                    const M: usize = $capacity;
                    Solver::<$joints, M, { $open }>::boxed(program, both)
                })*)*
                _ => None,
            }
        };
    }
    if let Some(plan) = &program.held_joint {
        let solver = match (program.joints, program.capacity) {
            (5, 8) => HeldJointSolver::<5, 8>::boxed(plan, program, both),
            (5, 16) => HeldJointSolver::<5, 16>::boxed(plan, program, both),
            (6, 8) => HeldJointSolver::<6, 8>::boxed(plan, program, both),
            (6, 16) if plan.off_table.is_some() => HeldJointSolver::<6, 16, true>::boxed(plan, program, both),
            (6, 16) => HeldJointSolver::<6, 16>::boxed(plan, program, both),
            (7, 8) => HeldJointSolver::<7, 8>::boxed(plan, program, both),
            (7, 16) => HeldJointSolver::<7, 16>::boxed(plan, program, both),
            (8, 8) => HeldJointSolver::<8, 8>::boxed(plan, program, both),
            (8, 16) => HeldJointSolver::<8, 16>::boxed(plan, program, both),
            (9, 8) => HeldJointSolver::<9, 8>::boxed(plan, program, both),
            (9, 16) => HeldJointSolver::<9, 16>::boxed(plan, program, both),
            // WebAssembly is downloaded: it has the code of arms of up to nine joints.
            #[cfg(not(target_family = "wasm"))]
            (10, 8) => HeldJointSolver::<10, 8>::boxed(plan, program, both),
            #[cfg(not(target_family = "wasm"))]
            (10, 16) => HeldJointSolver::<10, 16>::boxed(plan, program, both),
            _ => None,
        };
        return solver.ok_or_else(unsupported);
    }
    if program.most_doubts() > MOST_DOUBTS {
        return Err(unsupported());
    }
    let solver = match program.decoupled {
        true => sizes! { 0;
            3: 1 2 4;
            4: 2 4;
            5: 4 8;
            6: 4 8;
        },
        #[cfg(not(target_family = "wasm"))]
        false if program.joints > 9 => sizes! { M;
            10: 1 2 3 4 6 8 16;
        },
        false => sizes! { M;
            2: 1 2;
            3: 1 2 4;
            4: 1 2 4 8;
            5: 1 2 3 4 6 8;
            6: 1 2 3 4 6 8 16;
            7: 1 2 3 4 6 8 16;
            8: 1 2 3 4 6 8 16;
            9: 1 2 3 4 6 8 16;
        },
    };
    solver.ok_or_else(unsupported)
}

/// `S`: the most branches that the search remembers as missed; 0 for an arm that has none.
#[derive(Debug)]
struct Solver<const N: usize, const M: usize, const S: usize> {
    nest: Nest,
    constants: ArmConstants<N>,
    both: Evaluator<N>,
    /// The margins of a measured arm's table, which name its branches.
    names: Option<Factors>,
}

/// Pose and Jacobian for the verification of solutions.
#[derive(Debug)]
pub struct Evaluator<const N: usize>(pub Straight);

impl<const N: usize> Evaluate<f64, N> for Evaluator<N> {
    fn evaluate(&self, q: &[f64; N]) -> (Pose<f64>, Jacobian<f64, N>) {
        denhart::effort::evaluation();
        let (mut pose, mut jacobian) = (Pose::identity(), Jacobian::zero());
        let places = pose.rotation.iter_mut().flatten().chain(&mut pose.translation);
        let places = places.chain(jacobian.rows.iter_mut().flatten());
        self.0.run(q, places);
        (pose, jacobian)
    }
}

impl<const N: usize, const M: usize, const S: usize> Solver<N, M, S> {
    fn boxed(program: &Inverse, both: &Straight) -> Option<Box<dyn Solve>> {
        let constants = ArmConstants::of(&program.constants)?;
        let reach = program.constants.reach;
        let names = program.table_margins.as_ref().map(|margins| Factors::new(margins, reach));
        let both = Evaluator(both.clone());
        Some(Box::new(Self { nest: Nest::new(program), constants, both, names }))
    }

    fn solutions(&self, asked: &Asked) -> Solutions<f64, N, M> {
        let mut solutions = Solutions::default();
        solutions.reset_near(Status::BadTarget, asked.keeps_place);
        match (&self.nest.program.goal, asked.target) {
            (lower::Goal::Pose, DynamicTarget::Pose(target)) => {
                let mut nearest = None;
                let goal = nearest_rotation(target, &mut nearest, &mut solutions);
                self.search(goal, asked, |input| entry(goal, input), &mut solutions);
            }
            (lower::Goal::Position, DynamicTarget::Position(target)) => {
                self.search(target, asked, |input| component(target, input), &mut solutions);
            }
            (lower::Goal::PositionAxis { column }, DynamicTarget::PositionAxis(target)) => {
                let goal = Pointing::new(target, *column);
                let frame = goal.frame();
                self.search(&goal, asked, |input| entry(&frame, input), &mut solutions);
            }
            (lower::Goal::PositionAngle { .. }, DynamicTarget::PositionAngle(target)) => {
                let goal = self.in_plane(target);
                let angle = target.wrapped().angle;
                let (sin, cos) = math::sin_cos(angle);
                let number = |input| match input {
                    Input::Angle => angle,
                    Input::SinAngle => sin,
                    Input::CosAngle => cos,
                    other => component(&target.point, other),
                };
                self.search(&goal, asked, number, &mut solutions);
            }
            (lower::Goal::PlanarPose, DynamicTarget::PlanarPose(target)) => {
                let phi = target.wrapped().phi;
                let (sin, cos) = math::sin_cos(phi);
                let number = |input| match input {
                    Input::Phi => phi,
                    Input::SinPhi => sin,
                    Input::CosPhi => cos,
                    other => component(&[target.x, target.y], other),
                };
                self.search(target, asked, number, &mut solutions);
            }
            (lower::Goal::PlanarPosition, DynamicTarget::PlanarPosition(target)) => {
                self.search(target, asked, |input| component(target, input), &mut solutions);
            }
            // The arm has compared the tasks.
            _ => {}
        }
        solutions
    }

    fn in_plane(&self, target: &denhart::PointAngle<f64>) -> InPlane<f64, N> {
        in_plane(&self.nest.program.goal, target)
    }

    /// Searches for a goal whose numbers `number` gives.
    fn search<G: Goal<f64, N>>(
        &self,
        goal: &G,
        asked: &Asked,
        number: impl Fn(Input) -> f64,
        solutions: &mut Solutions<f64, N, M>,
    ) {
        match held(&self.nest.program.given, N, asked.given).as_slice() {
            [] => self.search_for(goal, asked, &number, solutions),
            held => self.search_for(&AllLocked::new(goal, held), asked, &number, solutions),
        }
    }

    /// Searches without the goal's type, so that the code is compiled once for all goals.
    fn search_for(
        &self,
        goal: &dyn Goal<f64, N>,
        asked: &Asked,
        number: &dyn Fn(Input) -> f64,
        solutions: &mut Solutions<f64, N, M>,
    ) {
        let Ok(near) = asked.near.map(<&[f64; N]>::try_from).transpose() else { return };
        let constants = self.constants.get();
        let search = Search::<f64, N, M, S>::new(&constants, &self.both, goal, near, solutions);
        let mut search = if self.nest.program.in_doubt { search.in_doubt() } else { search };
        if !search.begins(near) {
            return;
        }
        let mut run = Run::new(&self.nest, asked.given, number, asked.branch);
        let mut cascade = |search: &mut dyn Branches, start| match asked.trace {
            None => run.cascade(search, start),
            Some(trace) => run.cascade(&mut Traced { search, trace }, start),
        };
        if let Some(off) = self.nest.program.off_table {
            let rotation = [0, 1, 2].map(|row| [0, 1, 2].map(|column| number(Input::Rotation(row, column))));
            let goal = Pose { rotation, translation: [0, 1, 2].map(|component| number(Input::Position(component))) };
            let name = |q: &[f64; N], branch: &mut Branch| {
                if let Some(names) = &self.names {
                    *branch = names.branch(q, &goal);
                }
            };
            search.run_measured(&constants, near, off, name, |search, start| cascade(search, start));
        } else {
            search.run(&constants, near, |search, start| cascade(search, start));
        }
    }
}

impl<const N: usize, const M: usize, const S: usize> Solve for Solver<N, M, S> {
    fn solve(&self, asked: &Asked, solutions: &mut DynamicSolutions) {
        solutions.set(&self.solutions(asked));
    }

    fn one(&self, asked: &Asked) -> Result<DynamicSolution, Status<f64>> {
        let named = asked.branch.filter(|_| self.names.is_some());
        if let Some(branch) = named {
            let asked = Asked { branch: None, ..*asked };
            let one = self.solutions(&asked).named(branch, self.nest.program.constants.reach);
            return one.as_ref().map(DynamicSolution::from).map_err(|status| *status);
        }
        // Without a flip only the branch is followed.
        let branch = asked.branch.filter(|_| self.nest.program.constants.wrist.is_some());
        self.solutions(asked)
            .one_on(branch.unwrap_or(Branch::NONE))
            .as_ref()
            .map(DynamicSolution::from)
            .map_err(|status| *status)
    }

    fn residual(&self, q: &[f64], target: &DynamicTarget, pose: &Pose<f64>) -> Residual<f64> {
        let missed = Residual { position: f64::NAN, orientation: f64::NAN };
        let Ok(q) = <&[f64; N]>::try_from(q) else { return missed };
        match (&self.nest.program.goal, target) {
            (_, DynamicTarget::Pose(target)) => Goal::residual(target, q, pose),
            (_, DynamicTarget::Position(target)) => Goal::residual(target, q, pose),
            (lower::Goal::PositionAxis { column }, DynamicTarget::PositionAxis(target)) => {
                Goal::residual(&Pointing::new(target, *column), q, pose)
            }
            (_, DynamicTarget::PositionAngle(target)) => Goal::residual(&self.in_plane(target), q, pose),
            (_, DynamicTarget::PlanarPose(target)) => Goal::residual(target, q, pose),
            (_, DynamicTarget::PlanarPosition(target)) => Goal::residual(target, q, pose),
            _ => missed,
        }
    }
}

/// The goal of a target of the task `position_angle`.
pub fn in_plane<const N: usize>(goal: &lower::Goal, target: &denhart::PointAngle<f64>) -> InPlane<f64, N> {
    let mut all = [0.0; N];
    let mut at_zero = 0.0;
    if let lower::Goal::PositionAngle { signs, offset } = goal {
        at_zero = offset.rad();
        for (place, sign) in all.iter_mut().zip(signs) {
            *place = *sign;
        }
    }
    InPlane::new(target, all, at_zero)
}

/// The joints with given values, and those. The arm angle, which is no joint's, has the number after the last.
pub fn held(given: &GivenValues, joints: usize, values: &[f64]) -> Vec<(usize, f64)> {
    let joint = |kind: &Given| match *kind {
        Given::Joint { joint, .. } => joint,
        Given::ArmAngle => joints,
    };
    given.values.iter().map(joint).zip(values.iter().copied()).collect()
}

/// A number of a pose.
pub fn entry(pose: &Pose<f64>, input: Input) -> f64 {
    match input {
        Input::Rotation(row, column) => {
            pose.rotation.get(row).and_then(|row| row.get(column)).copied().unwrap_or(f64::NAN)
        }
        other => component(&pose.translation, other),
    }
}

/// A component of a point.
pub fn component(point: &[f64], input: Input) -> f64 {
    match input {
        Input::Position(index) => point.get(index).copied().unwrap_or(f64::NAN),
        _ => f64::NAN,
    }
}
