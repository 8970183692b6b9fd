//! The plan as data: a sequence of steps over one expression graph.

use super::kernel::{Kernel, Unit, Variables};
use super::loop_chain::LoopJoint;
use super::task::{Outline, PlanTask};
use crate::model::Angle;
use crate::model::geometry::{Triple, TripleKind};
use crate::symbolic::{Expr, Graph, Input, Label, Mat3, Part, Symbol, Unknown, Vec3};

/// A plan: the steps in order. A step may use the sines, cosines and values of the joints before it.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The arena of all expressions.
    pub graph: Graph,
    /// The steps; each stage but the first is solved for every root of those before it.
    pub steps: Vec<PlanStep>,
    /// How each joint follows from the unknowns of the stages, by joint.
    pub values: Vec<Value>,
    /// The joints of the closed chain, virtual ones too.
    pub loop_joints: Vec<LoopJoint>,
    /// The triple that makes it possible.
    pub triple: Triple,
    /// Task that the plan answers.
    pub task: PlanTask,
    /// Reach of the arm.
    pub reach: f64,
    /// Largest miss of the structure that the plan relies on, relative to reach and in rad, if it is more than
    /// rounding.
    pub missed: Option<f64>,
    /// Distance of the links of a measured arm from its table, relative to reach and in rad, if the equations are those of
    /// the table.
    pub off_table: Option<f64>,
}

impl Plan {
    /// Label of a joint of the closed chain.
    pub fn label(&self, slot: usize) -> Label {
        self.loop_joints.get(slot).map_or(Label::Virtual(0), |slot| slot.label)
    }

    /// Labels of the joints of a stage.
    pub fn labels(&self, stage: &Stage) -> Vec<Label> {
        stage.joints.iter().map(|slot| self.label(*slot)).collect()
    }

    /// The leaves that may stand for a part of a joint value: those of its stage, or of what is given.
    pub fn leaves(&self, joint: usize, part: Part) -> Vec<Symbol> {
        if self.task.given.holds(joint) {
            return vec![Input::given(joint, part).into()];
        }
        Unknown::both(Label::Arm(joint), part).map(Symbol::from).to_vec()
    }

    /// Angle added to the value of a joint of the closed chain to give its kernel's variable.
    pub fn shift(&self, slot: usize) -> Angle {
        self.values.get(slot).map_or(Angle::ZERO, |value| value.constant.neg())
    }

    /// The leaf that stands for the value of a joint of the arm, from 0.
    pub fn value(&self, joint: usize) -> Symbol {
        if self.task.given.holds(joint) {
            Input::Given(joint).into()
        } else {
            Unknown::of(Label::Arm(joint), Part::Value).into()
        }
    }

    /// The number of a joint of the closed chain among the arm's joints, from 0; `None` for a virtual joint.
    pub fn joint(&self, slot: usize) -> Option<usize> {
        self.loop_joints.get(slot).and_then(|slot| slot.label.arm())
    }

    /// The last of the arm's joints to be solved: it moves with every joint that is free.
    pub fn last_solved(&self) -> usize {
        let in_triple = (0..3).rev().find_map(|k| self.joint(self.triple.first + k));
        let solved = self.stages().flat_map(|stage| &stage.joints).filter_map(|slot| self.joint(*slot)).last();
        in_triple.or(solved).unwrap_or(0)
    }

    /// Returns true if a solved joint of the closed chain is no joint of the arm.
    pub fn has_virtual_joint(&self) -> bool {
        self.stages().flat_map(|stage| &stage.joints).any(|slot| self.joint(*slot).is_none())
    }

    /// Returns true if solutions are those of a chain with a virtual joint whose value has to be 0.
    pub fn lacks_a_turn(&self) -> bool {
        self.task.overdetermined && self.loop_joints.iter().any(|slot| slot.label.arm().is_none())
    }

    /// The joints a, b, c of the last step, where that is a spherical wrist with axes at right angles. Its roots differ by
    /// the flip `(a + pi, -b, c + pi)`, which leaves the tool where it is. `None` without such a wrist. An arm that misses
    /// the structure has no flip that is exact. A virtual joint has no value in a joint vector. A long stroke magnifies the
    /// rounding of the flip's own angles.
    pub fn flip(&self) -> Option<[usize; 3]> {
        let slides = self.loop_joints.iter().any(|slot| !slot.revolute)
            || self.task.given.joints().any(|(_, revolute)| !revolute);
        let meets = self.triple.kind == TripleKind::Intersecting && self.missed.is_none();
        let exact = meets && !slides && !self.has_virtual_joint();
        let Some(PlanStep::Stage(Stage { kernel: Kernel::Wrist(_), joints, .. })) = self.steps.last() else {
            return None;
        };
        let joints: Option<Vec<usize>> = joints.iter().map(|slot| self.joint(*slot)).collect();
        joints.filter(|_| exact)?.try_into().ok()
    }

    /// Task, joints, capacity and reach.
    pub fn outline(&self) -> Outline<'_> {
        Outline { task: &self.task, joints: self.joints(), capacity: self.max_solutions(), reach: self.reach }
    }

    /// The number of the arm's moving joints.
    pub fn joints(&self) -> usize {
        self.loop_joints.iter().filter(|slot| slot.label.arm().is_some()).count() + self.task.given.joints().count()
    }

    /// The stages, in order.
    pub fn stages(&self) -> impl Iterator<Item = &Stage> {
        self.steps.iter().filter_map(|step| match step {
            PlanStep::Stage(stage) => Some(stage),
            PlanStep::Angle { .. } | PlanStep::Agreement { .. } | PlanStep::Swivel { .. } => None,
        })
    }

    /// The largest number of solutions.
    pub fn max_solutions(&self) -> usize {
        self.stages().map(|stage| stage.kernel.form()).map(|form| form.roots + form.extra_roots).product()
    }

    /// Returns true if every stage after a free joint has its roots wherever that joint is.
    ///
    /// Three joints that follow one another bring a point to its place, one equation each, before a spherical wrist or
    /// nothing. A joint is free if the point lies on its axis; its value then moves nothing that a later equation reads.
    /// The spherical wrist has roots for every rotation. Axes may be apart: a wrist in the middle of the arm, a given joint,
    /// a virtual one. The angle between them depends on the target, and an equation may vanish for another reason.
    pub fn is_decoupled(&self) -> bool {
        let kernels: Vec<&Kernel> = self.stages().map(|stage| &stage.kernel).collect();
        let places = |kernel: &&Kernel| match kernel {
            Kernel::Offset(_) | Kernel::Align(_) => true,
            Kernel::Distance(distance) => distance.about.is_none(),
            _ => false,
        };
        let (position, rest) = kernels.split_at(kernels.len().min(3));
        let solved: Option<Vec<usize>> =
            self.stages().take(3).flat_map(|stage| &stage.joints).map(|slot| self.joint(*slot)).collect();
        let adjacent = solved.is_some_and(|mut joints| {
            joints.sort_unstable();
            joints.windows(2).all(|pair| matches!(pair, [a, b] if a + 1 == *b))
        });
        self.task.given.joints().next().is_none()
            && adjacent
            && self.stages().count() == self.steps.len()
            && position.len() == 3
            && position.iter().all(places)
            && matches!(rest, [] | [Kernel::Wrist(_)])
    }

    /// A rough cost, to choose among several triples: general pairs are dear, arithmetic breaks ties.
    pub fn effort(&self) -> usize {
        let stages: usize = self.stages().map(|stage| if stage.kernel.form().roots > 2 { 10_000 } else { 100 }).sum();
        stages + crate::symbolic::cost(&self.graph, &self.inputs()).arithmetic()
    }

    /// Every expression a step reads.
    pub fn inputs(&self) -> Vec<Expr> {
        self.steps.iter().flat_map(PlanStep::inputs).collect()
    }
}

/// One step.
#[derive(Debug, Clone, PartialEq)]
pub enum PlanStep {
    /// An equation for one or more joints.
    Stage(Stage),
    /// `name = atan2(y, x)`: an angle that several joints add up to.
    Angle {
        /// Its leaf.
        symbol: Symbol,
        /// Description of the angle.
        meaning: String,
        /// Sine times a positive factor.
        y: Expr,
        /// Cosine times the same factor.
        x: Expr,
    },
    /// Equations without a joint: the arm cannot reach the target unless they hold.
    Agreement {
        /// Description of the quantities that have to agree.
        meaning: String,
        /// Unit of the equations.
        unit: Unit,
        /// Residual of each equation.
        misses: Vec<Expr>,
    },
    /// The rotation of the upper arm from the arm angle: see the runtime's `swivel`.
    Swivel {
        /// The first two joints of the shoulder, as places in the closed chain.
        joints: [usize; 2],
        /// Its leaves, by rows.
        rotation: Mat3,
        /// Description of the rotation.
        meaning: String,
        /// From shoulder to wrist, where the wrist has to be.
        wrist: Vec3,
        /// From shoulder to wrist in the frame of the upper arm.
        moved: Vec3,
        /// The elbow's axis there.
        axis: Vec3,
        /// The elbow there.
        elbow: Vec3,
    },
}

impl PlanStep {
    /// The expressions it reads.
    pub fn inputs(&self) -> Vec<Expr> {
        match self {
            PlanStep::Stage(stage) => stage.kernel.inputs(),
            PlanStep::Angle { y, x, .. } => vec![*y, *x],
            PlanStep::Agreement { misses, .. } => misses.clone(),
            PlanStep::Swivel { wrist, moved, axis, elbow, .. } => [*wrist, *moved, *axis, *elbow].concat(),
        }
    }
}

/// One equation.
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    /// The joints it gives, as places in the closed chain, in the kernel's order.
    pub joints: Vec<usize>,
    /// Unknowns that the stage gives of each joint: value, sine, cosine.
    pub unknowns: Vec<[Unknown; 3]>,
    /// How to solve it.
    pub kernel: Kernel,
    /// Unit of the equation.
    pub unit: Unit,
    /// The equation in words and formula.
    pub meaning: String,
    /// Names of the two roots.
    pub branching: Branching,
    /// The derivative that tells its singularity, a length, where it is not the kernel's own.
    pub pivot: Option<Expr>,
}

impl Stage {
    /// The variables of its kernel.
    pub fn variables(&self) -> Variables<'_> {
        Variables { unknowns: &self.unknowns, unit: self.unit }
    }
}

/// Names of two roots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branching {
    /// No name.
    None,
    /// Shoulder right, left.
    Shoulder,
    /// Elbow up, down.
    Elbow,
    /// Wrist not flipped, flipped.
    Wrist,
    /// Numbered roots.
    Root,
}

/// How a joint value follows: a signed sum of symbols and a constant angle, brought into (-pi, pi].
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// `(symbol, negative)`.
    pub terms: Vec<(Symbol, bool)>,
    /// The constant part.
    pub constant: Angle,
}

impl Value {
    /// No angle.
    pub fn zero() -> Self {
        Value { terms: Vec::new(), constant: Angle::ZERO }
    }

    /// Adds another value, or takes it off.
    pub fn add(&mut self, other: &Value, negative: bool) {
        self.terms.extend(other.terms.iter().map(|(term, n)| (term.clone(), *n != negative)));
        self.constant = self.constant.add(if negative { other.constant.neg() } else { other.constant });
    }
}
