//! The plan as data: a sequence of steps over one expression graph.

use super::asked::PlanTask;
use super::problem::Slot;
use crate::model::Angle;
use crate::model::geometry::Triple;
use crate::symbolic::{Expr, Graph, Vec3};

/// A plan: the steps in order. A step may use the sines, cosines and values of the joints before it.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The arena of all expressions.
    pub graph: Graph,
    /// The steps; each stage but the first is solved for every root of those before it.
    pub steps: Vec<PlanStep>,
    /// How each joint follows from the symbols of the stages, by joint.
    pub values: Vec<Value>,
    /// The joints of the closed chain, virtual ones too.
    pub slots: Vec<Slot>,
    /// The triple that makes it possible.
    pub triple: Triple,
    /// What is asked for.
    pub task: PlanTask,
    /// Reach of the arm.
    pub reach: f64,
}

impl Plan {
    /// What a joint of the closed chain is called.
    pub fn label(&self, slot: usize) -> String {
        self.slots.get(slot).map(|slot| slot.label.clone()).unwrap_or_default()
    }

    /// The number of a joint of the closed chain among the arm's joints, from 0; `None` for a virtual joint.
    pub fn joint(&self, slot: usize) -> Option<usize> {
        self.slots.get(slot).and_then(|slot| slot.joint)
    }

    /// The last of the arm's joints to be solved: it moves with every joint that is free.
    pub fn last_solved(&self) -> usize {
        let in_triple = (0..3).rev().find_map(|k| self.joint(self.triple.first + k));
        let solved = self.stages().flat_map(|stage| &stage.joints).filter_map(|slot| self.joint(*slot)).last();
        in_triple.or(solved).unwrap_or(0)
    }

    /// The number of the arm's moving joints.
    pub fn joints(&self) -> usize {
        self.slots.iter().filter(|slot| slot.joint.is_some()).count() + usize::from(self.task.locked.is_some())
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
        self.stages().map(|stage| stage.kernel.most_roots()).product()
    }

    /// Whether every stage after a free joint has its roots wherever that joint is.
    ///
    /// So it is where three equations of one joint each bring a point to its place, before a spherical wrist or nothing: a
    /// joint is free if the point lies on its axis, and then its place moves nothing that a later equation sees. The
    /// spherical wrist has roots for every rotation. The three joints follow one another. Between axes that are apart (a
    /// wrist in the middle of the arm, a joint that is given, a virtual one) the angle depends on the target: there an
    /// equation may vanish for another reason.
    pub fn is_decoupled(&self) -> bool {
        let kernels: Vec<&Kernel> = self.stages().map(|stage| &stage.kernel).collect();
        let places = |kernel: &&Kernel| {
            matches!(kernel, Kernel::Offset { .. } | Kernel::Distance { about: None, .. } | Kernel::Align { .. })
        };
        let (position, rest) = kernels.split_at(kernels.len().min(3));
        let solved: Option<Vec<usize>> =
            self.stages().take(3).flat_map(|stage| &stage.joints).map(|slot| self.joint(*slot)).collect();
        let adjacent = solved.is_some_and(|mut joints| {
            joints.sort_unstable();
            joints.windows(2).all(|pair| matches!(pair, [a, b] if a + 1 == *b))
        });
        self.task.locked.is_none()
            && adjacent
            && self.stages().count() == self.steps.len()
            && position.len() == 3
            && position.iter().all(places)
            && matches!(rest, [] | [Kernel::Wrist { .. }])
    }

    /// A rough cost, to choose among several triples: general pairs are dear, arithmetic breaks ties.
    pub fn effort(&self) -> usize {
        let stages: usize = self.stages().map(|stage| if stage.kernel.roots() > 2 { 10_000 } else { 100 }).sum();
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
        /// Its symbol.
        name: String,
        /// What it is.
        meaning: String,
        /// Sine times a positive factor.
        y: Expr,
        /// Cosine times the same factor.
        x: Expr,
    },
    /// Equations without a joint to meet them: what is asked for is beyond the arm unless they hold.
    Agreement {
        /// What has to agree.
        meaning: String,
        /// What is compared.
        unit: Unit,
        /// By how much each is missed.
        misses: Vec<Expr>,
    },
    /// The rotation of the upper arm from the arm angle: see the runtime's `swivel`.
    Swivel {
        /// Its symbols, by rows.
        names: [[String; 3]; 3],
        /// What it is.
        meaning: String,
        /// From shoulder to wrist, where it has to be.
        wrist: Vec3,
        /// The same in the frame of the upper arm.
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
    /// The joints it gives, from 0, in the kernel's order.
    pub joints: Vec<usize>,
    /// How to solve it.
    pub kernel: Kernel,
    /// What is compared.
    pub unit: Unit,
    /// The equation in words and formula.
    pub meaning: String,
    /// What its two roots are called.
    pub branching: Branching,
    /// The derivative that tells its singularity, a length, where it is not the kernel's own.
    pub pivot: Option<Expr>,
    /// What is added to the free joint's value to give its kernel's variable.
    pub home: Angle,
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

/// What an equation's numbers measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Lengths.
    Length,
    /// Components of unit vectors.
    Direction,
}

/// The range of a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElbowRange {
    /// Distance of the first point from the axis.
    pub a: Expr,
    /// Distance of the second.
    pub b: Expr,
    /// How far apart they are along the axis.
    pub height: Expr,
}

/// The range of a component: see the runtime's `Cone`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Component of the vector along the turning axis.
    pub along: Expr,
    /// Component across it.
    pub across: Expr,
    /// Cosine of the other axis to the turning axis.
    pub cos: Expr,
    /// Sine of it, not negative.
    pub sin: Expr,
}

/// A run-time direction that an angle is counted from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// Sine times a positive factor.
    pub y: Expr,
    /// Cosine times the same factor.
    pub x: Expr,
}

/// The equations there are; each is one kernel of the runtime.
#[derive(Debug, Clone, PartialEq)]
pub enum Kernel {
    /// `a cos + b sin = d`
    Offset {
        /// Of the cosine.
        a: Expr,
        /// Of the sine.
        b: Expr,
        /// Right side.
        d: Expr,
    },
    /// The same twice: lengths, then directions; `[a, b, d]` each.
    OffsetOfTwo {
        /// Of lengths.
        length: [Expr; 3],
        /// Of directions.
        direction: [Expr; 3],
    },
    /// Two points at a given distance.
    Distance {
        /// The distance.
        rho: Expr,
        /// Its range.
        range: ElbowRange,
        /// Where the angle is counted from, if only known at run time.
        about: Option<Phase>,
    },
    /// A component along another axis.
    Cone {
        /// The component.
        d: Expr,
        /// The component across.
        rho: Expr,
        /// The range.
        range: Range,
        /// Where the angle is counted from, if only known at run time.
        about: Option<Phase>,
    },
    /// Turn a plane vector onto another.
    Align {
        /// The vector turned.
        from: [Expr; 2],
        /// The direction it takes.
        to: [Expr; 2],
    },
    /// Two orthogonal axes point a direction: inner joint, outer joint.
    Flip {
        /// The direction.
        m: [Expr; 3],
    },
    /// Three orthogonal axes give a rotation.
    Wrist {
        /// The rotation, by rows.
        m: [[Expr; 3]; 3],
    },
    /// A sliding joint at a given distance.
    Slide {
        /// The distance.
        rho: Expr,
        /// Distance of the line.
        across: Expr,
        /// The position nearest.
        middle: Expr,
    },
    /// `denominator x = numerator`, sliding.
    SlideTo {
        /// Left factor.
        denominator: Expr,
        /// Right side.
        numerator: Expr,
    },
    /// A turning and a sliding joint: two components across a third one, which slides.
    SlideTurning {
        /// The stroke's direction there.
        stroke: [Expr; 2],
        /// Rows of the turning joint: of the cosine, of the sine, constant.
        rows: [[Expr; 3]; 2],
    },
    /// One direction seen from two joints over a sliding one: for each joint the vector it turns, and the rotation from
    /// the sliding joint's frame to its own.
    Aim {
        /// The vectors.
        moved: [[Expr; 3]; 2],
        /// The rotations, by rows.
        frames: [[[Expr; 3]; 3]; 2],
    },
    /// Two equations in two revolute joints.
    Pair {
        /// Rows of the first joint: of the cosine, of the sine, constant.
        p: [[Expr; 3]; 2],
        /// Rows of the second.
        q: [[Expr; 3]; 2],
        /// Where the joint between the two turns: rows of the vector's components across its axis, as the first joint
        /// moves it and as the second does. The second row of `p` and `q` is then the one that compares lengths.
        across: Option<[[[Expr; 3]; 2]; 2]>,
    },
    /// `x = line`, `x^2 + m x + n = q`: a sliding and a revolute joint.
    PairSliding {
        /// Of the cosine, of the sine, constant; over `scale`.
        line: [Expr; 3],
        /// Common denominator of the line, a constant.
        scale: Expr,
        /// `m` and `n`.
        square: [Expr; 2],
        /// Of the cosine, of the sine, constant.
        q: [Expr; 3],
        /// The vector's components across the axis of the joint between the two, as the sliding joint moves it: factor and
        /// constant.
        sliding: [[Expr; 2]; 2],
        /// The same as the turning joint moves it, as rows.
        turning: [[Expr; 3]; 2],
    },
    /// `a x^2 + b x + c = 0`, sliding.
    Quadratic {
        /// `a`, `b` and `c`.
        coefficients: [Expr; 3],
    },
}

impl Kernel {
    /// The largest number of roots of regular targets.
    pub fn roots(&self) -> usize {
        match self {
            Kernel::Align { .. } | Kernel::SlideTo { .. } => 1,
            Kernel::Pair { .. } | Kernel::PairSliding { .. } => 4,
            _ => 2,
        }
    }

    /// The same with the roots that there are besides where a joint is free.
    pub fn most_roots(&self) -> usize {
        if matches!(self, Kernel::Aim { .. }) { 3 } else { self.roots() }
    }

    /// The expressions it reads.
    pub fn inputs(&self) -> Vec<Expr> {
        let phase = |about: &Option<Phase>| about.iter().flat_map(|p| [p.y, p.x]).collect::<Vec<_>>();
        match self {
            Kernel::Offset { a, b, d } => vec![*a, *b, *d],
            Kernel::OffsetOfTwo { length, direction } => [*length, *direction].concat(),
            Kernel::Distance { rho, range, about } => {
                [vec![*rho, range.a, range.b, range.height], phase(about)].concat()
            }
            Kernel::Cone { d, rho, range, about } => {
                [vec![*d, *rho, range.along, range.across, range.cos, range.sin], phase(about)].concat()
            }
            Kernel::Align { from, to } => [*from, *to].concat(),
            Kernel::Flip { m } => m.to_vec(),
            Kernel::Wrist { m } => m.concat(),
            Kernel::Slide { rho, across, middle } => vec![*rho, *across, *middle],
            Kernel::SlideTo { denominator, numerator } => vec![*denominator, *numerator],
            Kernel::SlideTurning { stroke, rows } => [stroke.to_vec(), rows.concat()].concat(),
            Kernel::Aim { moved, frames } => [moved.concat(), frames.concat().concat()].concat(),
            Kernel::Pair { p, q, across } => {
                let across = across.iter().flatten().flatten().flatten().copied().collect();
                [p.concat(), q.concat(), across].concat()
            }
            Kernel::PairSliding { line, scale, square, q, sliding, turning } => {
                let across = [sliding.concat(), turning.concat()].concat();
                [line.to_vec(), vec![*scale], square.to_vec(), q.to_vec(), across].concat()
            }
            Kernel::Quadratic { coefficients } => coefficients.to_vec(),
        }
    }
}

/// How a joint value follows: a signed sum of symbols and a constant angle, brought into (-pi, pi].
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// `(symbol, negative)`.
    pub terms: Vec<(String, bool)>,
    /// The constant part.
    pub constant: Angle,
    /// A sliding joint: the symbol as it is.
    pub sliding: bool,
}
