//! The inverse of an arm with `N` joints and at most `M` solutions that holds a joint.

use denhart::held_joint::meet::Meet;
use denhart::held_joint::slides::Slides;
use denhart::held_joint::{Outcome, Transform, Visitor};
use denhart::solve::{AllLocked, Goal, Pointing, Search, nearest_rotation};
use denhart::{Pose, Residual, Solutions, Status};
use denhart_codegen::lower::{Goal as Task, HeldJointPlan, Inverse, Method};

use crate::arm_constants::ArmConstants;
use crate::function::Straight;
use crate::margins::Factors;
use crate::nest::Nest;
use crate::run::Run;
use crate::solver::{Asked, Evaluator, Solve, entry, held};
use crate::{DynamicSolution, DynamicSolutions, DynamicTarget};

/// The solver of a plan. `STARTS`: that of a measured arm whose table gives starts, code that other sizes do without.
#[derive(Debug)]
pub struct HeldJointSolver<const N: usize, const M: usize, const STARTS: bool = false> {
    plan: HeldJointPlan,
    constants: ArmConstants<N>,
    both: Evaluator<N>,
    /// The margins of a measured arm's table, which name its branches.
    names: Option<Factors>,
    /// The stages of a measured arm's table, where they give starts.
    starts: Option<Nest>,
}

/// The search of an arm that holds a joint, of the same type as that of stages: both are compiled once. A measured arm starts from the
/// stages of its table.
type HeldJointSearch<'a, const N: usize, const M: usize> = Search<'a, f64, N, M, M>;

impl<const N: usize, const M: usize, const STARTS: bool> HeldJointSolver<N, M, STARTS> {
    /// The solver of a program; `None` if its arm has another number of joints.
    pub fn boxed(plan: &HeldJointPlan, program: &Inverse, both: &Straight) -> Option<Box<dyn Solve>> {
        let constants = ArmConstants::of(&program.constants)?;
        let starts = program.of_table.as_deref().map(Nest::new);
        let names = program.table_margins.as_ref().map(|margins| Factors::new(margins, plan.reach));
        Some(Box::new(Self { plan: plan.clone(), constants, both: Evaluator(both.clone()), names, starts }))
    }

    fn solutions(&self, asked: &Asked) -> Solutions<f64, N, M> {
        let mut solutions = Solutions::default();
        solutions.reset_near(Status::BadTarget, asked.keeps_place);
        // The arm has compared the tasks.
        match (asked.target, &self.plan.task.goal) {
            (DynamicTarget::Pose(target), _) => {
                let mut nearest = None;
                let goal = nearest_rotation(target, &mut nearest, &mut solutions);
                self.search_for(goal, goal, asked, &mut solutions);
            }
            (DynamicTarget::PositionAxis(target), Task::PositionAxis { column }) => {
                let goal = Pointing::new(target, *column);
                self.search_for(&goal, &goal.frame(), asked, &mut solutions);
            }
            _ => {}
        }
        solutions
    }

    /// Searches for a goal, with the given joint in its place; `frame` is where the chain of six joints has to end.
    fn search_for<G: Goal<f64, N>>(
        &self,
        goal: &G,
        frame: &Pose<f64>,
        asked: &Asked,
        solutions: &mut Solutions<f64, N, M>,
    ) {
        match held(&self.plan.task.given, N, asked.given).as_slice() {
            [] => self.search(goal, frame, asked, solutions),
            held => self.search(&AllLocked::new(goal, held), frame, asked, solutions),
        }
    }

    fn search(&self, goal: &dyn Goal<f64, N>, pose: &Pose<f64>, asked: &Asked, solutions: &mut Solutions<f64, N, M>) {
        let Ok(near) = asked.near.map(<&[f64; N]>::try_from).transpose() else { return };
        let constants = self.constants.get();
        match &self.starts {
            Some(nest) if STARTS => {
                let mut search = HeldJointSearch::<N, M>::new(&constants, &self.both, goal, near, solutions).in_doubt();
                if search.begins(near) {
                    let mut run = Run::new(nest, &[], &|input| entry(pose, input), None);
                    search.start_from_table(nest.program.off_table.unwrap_or(0.0), |search, start| {
                        run.cascade(search, start)
                    });
                    self.run(search, goal, pose, near, &constants);
                }
            }
            _ => {
                let mut search = HeldJointSearch::<N, M>::new(&constants, &self.both, goal, near, solutions);
                if search.begins(near) {
                    self.run(search, goal, pose, near, &constants);
                }
            }
        }
    }

    /// Solves what a search has begun.
    fn run(
        &self,
        mut search: HeldJointSearch<'_, N, M>,
        goal: &dyn Goal<f64, N>,
        pose: &Pose<f64>,
        near: Option<&[f64; N]>,
        constants: &denhart::solve::ArmConstants<'_, f64, N>,
    ) {
        let target = Transform { rotation: pose.rotation, translation: pose.translation };
        let solved = &self.plan.chain.solved;
        let defaults = search.defaults();
        // A virtual joint stays at 0.
        let mut reference = [0.0; 6];
        for (value, joint) in reference.iter_mut().zip(solved) {
            *value = defaults.get(*joint).copied().unwrap_or(f64::NAN);
        }
        let placed = goal.placed([f64::NAN; N]);
        let place = |six: [f64; 6]| {
            let mut q = placed;
            for (joint, value) in solved.iter().zip(six) {
                if let Some(place) = q.get_mut(*joint) {
                    *place = value;
                }
            }
            let [.., last] = six;
            (q, if self.plan.lacks_a_turn() { last } else { 0.0 })
        };
        let given = self.plan.chain.given_joints().map(|given| placed.get(given.joint).copied().unwrap_or(f64::NAN));
        let given: Vec<f64> = given.collect();
        let solve = |visit: &mut Visitor<'_, f64>| self.candidates(&given, &target, &reference, visit);
        match (&self.names, self.plan.off_table) {
            (Some(names), _) => search.run_named(constants, near, |six| place(six).0, |q| names.branch(q, pose), solve),
            (None, Some(off)) if solved.len() == 6 => {
                search.run_unfolded(constants, near, off, |six| place(six).0, solve);
            }
            _ => search.run_with_turn(constants, near, place, solve),
        }
    }

    fn candidates(
        &self,
        given: &[f64],
        target: &Transform<f64>,
        reference: &[f64; 6],
        visit: &mut Visitor<'_, f64>,
    ) -> Outcome {
        let chain = self.plan.chain.at(given);
        match &self.plan.method {
            Method::Meet { structure, constants } => {
                let [base, .., tip] = &chain.links;
                if let Some(meet) = constants {
                    return meet.search(&structure.first_of_ring(base, target, tip), reference, visit);
                }
                let ring = structure.ring(&chain.links, target);
                let [k1, ..] = &ring;
                match Meet::of(structure, &ring) {
                    Some(meet) => meet.search(k1, reference, visit),
                    None => Outcome { is_complete: false },
                }
            }
            Method::Slides { turning, prismatic } => {
                let slides = Slides { links: chain.links, turning: *turning, prismatic: *prismatic };
                slides.search(target, reference, visit)
            }
            Method::General { constants: Some(general), .. } => general.search(target, reference, visit),
            Method::General { cuts, constants: None } => cuts.search(&chain.gathered(), target, reference, visit),
        }
    }
}

impl<const N: usize, const M: usize, const STARTS: bool> Solve for HeldJointSolver<N, M, STARTS> {
    fn solve(&self, asked: &Asked, solutions: &mut DynamicSolutions) {
        solutions.set(&self.solutions(asked));
    }

    fn one(&self, asked: &Asked) -> Result<DynamicSolution, Status<f64>> {
        let solutions = self.solutions(asked);
        let one = match asked.branch {
            Some(branch) => solutions.named(branch, self.plan.reach),
            None => solutions.first_or_status(),
        };
        one.as_ref().map(DynamicSolution::from).map_err(|status| *status)
    }

    fn residual(&self, q: &[f64], target: &DynamicTarget, pose: &Pose<f64>) -> Residual<f64> {
        match (<&[f64; N]>::try_from(q), target, &self.plan.task.goal) {
            (Ok(q), DynamicTarget::Pose(target), _) => Goal::residual(target, q, pose),
            (Ok(q), DynamicTarget::PositionAxis(target), Task::PositionAxis { column }) => {
                Goal::residual(&Pointing::new(target, *column), q, pose)
            }
            _ => Residual { position: f64::NAN, orientation: f64::NAN },
        }
    }
}
