//! The inverse as a program: its statements and loops.

use super::{ArmConstants, Call, Margins, Names, Slot};
use crate::model::Angle;
use crate::solve::kernel::{ConeRange, ElbowRange, Phase};
use crate::solve::{Branching, GivenValues, Goal, HeldJointPlan, SwivelConstants, Unit};
use crate::symbolic::{Graph, Input, Part};

/// The inverse as a program.
#[derive(Debug, Clone)]
pub struct Inverse {
    /// The arena.
    pub graph: Graph,
    /// The names of the shared expressions.
    pub names: Names,
    /// The arm constants.
    pub constants: ArmConstants,
    /// The task, with its numbers.
    pub goal: Goal,
    /// Values given beside the target.
    pub given: GivenValues,
    /// Constants for the arm angle of a joint vector, where the arm angle is given.
    pub swivel: Option<SwivelConstants>,
    /// Numbers read of the target and of the given values.
    pub inputs: Vec<(Slot, Input)>,
    /// Statements and loops: the first level stands before every loop, each other one is the body of a loop in the level
    /// before.
    pub levels: Vec<NestLevel>,
    /// The number of stages.
    pub stages: usize,
    /// The number of comparisons.
    pub agreements: usize,
    /// The number of the arm's joints.
    pub joints: usize,
    /// The largest number of solutions.
    pub capacity: usize,
    /// True if every stage after a free joint has its roots wherever that joint is. The search then looks for other
    /// values of two free joints only.
    pub decoupled: bool,
    /// True if every branch is verified, because the arm misses the structure by more than rounding.
    pub in_doubt: bool,
    /// Distance of the links of a measured arm from its table, relative to reach and in rad, if the equations are those of
    /// the table.
    pub off_table: Option<f64>,
    /// The margins of that table, if their signs name the arm's branches.
    pub table_margins: Option<Margins>,
    /// The solver of an arm without stages: it holds a joint, and there are no statements.
    pub held_joint: Option<HeldJointPlan>,
    /// The stages of a measured arm's table, which give starts before a joint is held.
    pub of_table: Option<Box<Inverse>>,
}

impl Inverse {
    /// Returns true if a number of the target is read.
    pub fn reads(&self, input: Input) -> bool {
        self.inputs.iter().any(|(_, read)| *read == input)
    }

    /// Returns true if one branch can be followed without the others. A solution of a measured arm has its name from where it
    /// is, not from the branch of the table that leads to it.
    pub fn follows_single_branches(&self) -> bool {
        self.held_joint.is_none() && self.table_margins.is_none()
    }

    /// The most doubts on one branch: how many statements may leave a state of their own, each stage one.
    pub fn most_doubts(&self) -> usize {
        let statements = self.levels.iter().flat_map(|level| &level.body);
        statements.filter(|statement| matches!(statement, Statement::Follow { .. } | Statement::Swivel { .. })).count()
    }
}

/// The body of a loop.
#[derive(Debug, Clone, Default)]
pub struct NestLevel {
    /// The loop; none around the first level.
    pub each: Option<Each>,
    /// Its statements; the next level's loop follows them.
    pub body: Vec<Statement>,
}

/// A loop over the roots of a stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Each {
    /// The stage.
    pub stage: usize,
    /// The state that says whether the branch goes on.
    pub state: BranchState,
    /// Parts in use of each root, by the stage's joints.
    pub roots: Vec<Root>,
    /// Names of the roots.
    pub branching: Branching,
    /// True if the roots differ by a wrist flip, see `Plan::flip`.
    pub flips: bool,
}

/// Parts in use of a root, for one joint.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Root(pub Vec<(Part, Slot)>);

/// The state of a branch, by the step that it has passed last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BranchState {
    /// None.
    Start,
    /// A stage.
    Stage(usize),
    /// Equations that have to agree, counted from 0.
    Agreed(usize),
    /// The swing of the upper arm.
    Swung,
}

/// A statement.
#[derive(Debug, Clone, PartialEq)]
pub enum Statement {
    /// Works out a shared expression.
    Let(Slot),
    /// The direction from which the angle of a stage is counted.
    Phase {
        /// The stage.
        stage: usize,
        /// The direction.
        phase: Phase,
    },
    /// The range of a stage's distance.
    Elbow {
        /// The stage.
        stage: usize,
        /// The range.
        range: ElbowRange,
        /// For links along one line the product whose sign tells stretched from folded.
        line: Option<Slot>,
    },
    /// The range of a stage's component.
    Cone {
        /// The stage.
        stage: usize,
        /// The range.
        range: ConeRange,
    },
    /// Solves a stage.
    Solve(Call),
    /// The branch state after a stage.
    Follow {
        /// The stage.
        stage: usize,
        /// The branch state before.
        before: BranchState,
    },
    /// Takes the root of a stage that has just one.
    Only {
        /// The stage.
        stage: usize,
        /// Parts in use of the root.
        roots: Vec<Root>,
    },
    /// `symbol = atan2(y, x)`
    Angle {
        /// Where it goes.
        symbol: Slot,
        /// Sine times a positive factor.
        y: Slot,
        /// Cosine times the same factor.
        x: Slot,
        /// Description of the angle.
        meaning: String,
    },
    /// Compares equations without a joint.
    Agree {
        /// The place of this comparison among them.
        index: usize,
        /// The branch state before.
        before: BranchState,
        /// Unit of the equations.
        unit: Unit,
        /// Residual of each equation.
        misses: Vec<Slot>,
        /// Description of the quantities that have to agree.
        meaning: String,
    },
    /// The rotation of the upper arm from the arm angle, then the branch state after it.
    Swivel {
        /// The first two joints of the shoulder.
        joints: [usize; 2],
        /// Where the rotation goes, by rows.
        symbols: [[Slot; 3]; 3],
        /// Wrist where it has to be, wrist, elbow's axis and elbow in the frame of the upper arm.
        vectors: [[Slot; 3]; 4],
        /// The branch state before.
        before: BranchState,
        /// Description of the rotation.
        meaning: String,
    },
    /// A joint value from what the stages give: a signed sum and a constant, brought into (-pi, pi].
    Value {
        /// Where it goes.
        symbol: Slot,
        /// `(term, negative)`
        terms: Vec<(Slot, bool)>,
        /// The constant.
        constant: Angle,
    },
    /// Adds a solution.
    Push {
        /// The state of its branch.
        state: BranchState,
        /// The joint values.
        q: Vec<Slot>,
    },
}

impl Statement {
    /// Slots that the statement reads.
    pub fn reads(&self) -> Vec<Slot> {
        match self {
            Statement::Let(slot) => vec![*slot],
            Statement::Phase { phase: Phase { y, x }, .. } | Statement::Angle { y, x, .. } => vec![*y, *x],
            Statement::Elbow { range, line, .. } => range.inputs().into_iter().chain(*line).collect(),
            Statement::Cone { range, .. } => range.inputs().to_vec(),
            Statement::Solve(call) => call.kernel.inputs(),
            Statement::Agree { misses, .. } => misses.clone(),
            Statement::Swivel { vectors, .. } => vectors.concat(),
            Statement::Value { terms, .. } => terms.iter().map(|(term, _)| *term).collect(),
            Statement::Push { q, .. } => q.clone(),
            Statement::Follow { .. } | Statement::Only { .. } => Vec::new(),
        }
    }
}
