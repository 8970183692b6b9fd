//! The closed chain around the target, and what is known while it is being solved.

use super::generic_samples::GenericSamples;
use super::kernel::{Align, Kernel, Phase, SlideTo, Unit};
use super::loop_chain::{LoopChain, LoopJoint};
use super::plan::{Branching, Plan, PlanStep, Stage, Value};
use super::task::PlanTask;
use crate::model::Angle;
use crate::model::geometry::Triple;
use crate::symbolic::{ConstantAngle, Expr, Graph, Label, Pair, Part, Rigid, Symbol, Unknown, Vec3};

/// The point in which the axes of a triple intersect.
pub const WRIST: &str = "the wrist center";

/// A constant link (or the target), both ways.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// From the frame after it to the frame before it.
    pub forward: Rigid,
    /// The inverse.
    pub back: Rigid,
    /// True if the target is part of the link.
    pub target: bool,
}

/// The joints in cyclic order: the triple a, b, c, then x, y, z. Link `i` follows joint `i`; the target's inverse is
/// part of the link after the last joint.
pub struct LoopClosure {
    /// The arena.
    pub g: Graph,
    /// Decides what vanishes.
    pub generic: GenericSamples,
    /// The six joints in cyclic order from the triple's first.
    pub order: [usize; 6],
    /// The link after each joint, by joint.
    pub(super) links: Vec<Link>,
    loop_joints: Vec<LoopJoint>,
    /// Sine and cosine of each solved joint's angle (its DH theta, offset included).
    pairs: Vec<Option<Pair>>,
    values: Vec<Option<Value>>,
    steps: Vec<PlanStep>,
    /// Reach of the arm.
    pub reach: f64,
}

impl LoopClosure {
    /// A chain closed around its target.
    pub fn new(chain: LoopChain, triple: Triple) -> LoopClosure {
        let LoopChain { mut g, generic, loop_joints, links: constants, target, reach, .. } = chain;
        let constant = |i: usize| constants.get(i).copied().unwrap_or_else(Rigid::identity);
        // The target without base and tool: where the frame of the last joint has to be, in the first joint's frame.
        let count = loop_joints.len();
        let base = constant(0).inverse(&mut g);
        let tool = constant(count).inverse(&mut g);
        let flange = target.then(&mut g, &tool);
        let flange = base.then(&mut g, &flange);
        name_target(&mut g, &flange);
        let mut links: Vec<Link> = (1..count)
            .map(|i| {
                let forward = constant(i);
                Link { forward, back: forward.inverse(&mut g), target: false }
            })
            .collect();
        links.push(Link { forward: flange.inverse(&mut g), back: flange, target: true });
        // The last one is the joint before the triple.
        let order = [0, 1, 2, 3, 4, count.saturating_sub(1)].map(|k| (triple.first + k) % count.max(1));
        let (pairs, values) = (vec![None; count], vec![None; count]);
        LoopClosure { g, generic, order, links, loop_joints, pairs, values, steps: Vec::new(), reach }
    }

    /// The link after a joint.
    pub fn link(&self, joint: usize) -> Link {
        let identity = Link { forward: Rigid::identity(), back: Rigid::identity(), target: false };
        self.links.get(joint).copied().unwrap_or(identity)
    }

    /// Returns true for a revolute joint.
    pub fn is_revolute(&self, joint: usize) -> bool {
        self.loop_joints.get(joint).is_none_or(|slot| slot.revolute)
    }

    /// Returns true if none of a triple's joints is the arm's own.
    pub fn is_virtual(&self, triple: Triple) -> bool {
        !(triple.first..triple.first + 3).any(|slot| self.is_own(slot))
    }

    /// Returns true if a joint is the arm's own.
    pub fn is_own(&self, slot: usize) -> bool {
        self.loop_joints.get(slot).is_some_and(|slot| slot.label.arm().is_some())
    }

    /// The joints outside the triple in cyclic order.
    pub fn outside(&self) -> Vec<usize> {
        let [first, ..] = self.order;
        let count = self.loop_joints.len();
        (3..count).map(|k| (first + k) % count).collect()
    }

    /// Gives a joint's sine and cosine as expressions.
    pub fn known(&mut self, joint: usize, cos: Expr, sin: Expr) {
        if let Some(slot) = self.pairs.get_mut(joint) {
            *slot = Some(Pair { sin, cos });
        }
    }

    /// The angle of a vector as a known angle, its sign, and a constant, if it is that.
    pub fn known_angle(&self, y: Expr, x: Expr) -> Option<(Symbol, bool, Angle)> {
        if !self.generic.decides(&self.g, &[y, x]) {
            return None;
        }
        self.generic.angles().iter().find_map(|symbol| {
            [false, true].into_iter().find_map(|negative| {
                let constants: Vec<[f64; 2]> = self
                    .generic
                    .samples()
                    .iter()
                    .filter_map(|sample| {
                        let values = self.g.evaluate(&[y, x], sample);
                        let [y, x] = *values.as_slice() else { return None };
                        let known = *sample.get(symbol)?;
                        let (s, c) = if negative { known.sin_cos() } else { (-known).sin_cos() };
                        Some([y * c + x * s, x * c - y * s])
                    })
                    .collect();
                let first = *constants.first()?;
                let same = constants.iter().flatten().zip(first.iter().cycle()).all(|(a, b)| (a - b).abs() <= 1e-12);
                let [sin, cos] = first;
                (same && constants.len() == self.generic.samples().len())
                    .then(|| (symbol.clone(), negative, Angle::of_vector(sin, cos)))
            })
        })
    }

    /// Name of the point in which the axes of the triple intersect.
    pub fn center(&self) -> &'static str {
        let [a, b, c, ..] = self.order;
        if [a, b, c].into_iter().any(|slot| self.is_own(slot)) { WRIST } else { "the tool point" }
    }

    /// Label of a joint.
    pub fn label(&self, joint: usize) -> Label {
        self.loop_joints.get(joint).map_or(Label::Virtual(0), |slot| slot.label)
    }

    /// The value of an expression that does not depend on the target.
    pub fn value(&self, e: Expr) -> Option<f64> {
        self.g.constant(e).or_else(|| self.generic.value(&self.g, e))
    }

    /// Returns true if the expressions vanish for every target.
    pub fn vanish(&self, expressions: &[Expr], unit: Unit) -> bool {
        self.generic.vanish(&self.g, expressions, unit)
    }

    /// Zero if an expression vanishes for every target, else the expression.
    pub fn clean(&self, e: Expr, unit: Unit) -> Expr {
        if self.vanish(&[e], unit) { Expr::ZERO } else { e }
    }

    /// A vector with its vanishing components exactly zero.
    pub fn clean3(&self, v: Vec3, unit: Unit) -> Vec3 {
        v.map(|e| self.clean(e, unit))
    }

    /// The sine and cosine of a solved joint.
    pub fn pair(&self, joint: usize) -> Pair {
        self.pairs.get(joint).copied().flatten().unwrap_or(Pair { sin: Expr::ZERO, cos: Expr::ONE })
    }

    /// The displacement of a prismatic joint.
    pub fn position(&mut self, joint: usize) -> Expr {
        let label = self.label(joint);
        self.g.symbol(Unknown::of(label, Part::Value))
    }

    /// Joint `joint`'s motion applied to a vector (to a point if it is prismatic).
    pub fn move_by(&mut self, joint: usize, v: Vec3) -> Vec3 {
        if self.is_revolute(joint) {
            let pair = self.pair(joint);
            return self.g.rotate_z(pair, v);
        }
        let along = self.position(joint);
        self.g.add3(v, [Expr::ZERO, Expr::ZERO, along])
    }

    /// The inverse motion.
    pub fn move_back(&mut self, joint: usize, v: Vec3) -> Vec3 {
        if self.is_revolute(joint) {
            let pair = self.pair(joint).opposite(&mut self.g);
            return self.g.rotate_z(pair, v);
        }
        let along = self.position(joint);
        self.g.sub3(v, [Expr::ZERO, Expr::ZERO, along])
    }

    /// Adds a stage. Its kernel's variable for joint `i` is the joint's angle minus `shift`.
    pub fn stage(
        &mut self,
        joints: &[(usize, Angle)],
        unit: Unit,
        branching: Branching,
        meaning: String,
        kernel: impl Into<Kernel>,
    ) {
        let unknowns = joints.iter().map(|(joint, shift)| self.bind(*joint, *shift)).collect();
        let joints = joints.iter().map(|(joint, _)| *joint).collect();
        let stage = Stage { joints, unknowns, kernel: kernel.into(), unit, meaning, branching, pivot: None };
        self.steps.push(PlanStep::Stage(stage));
    }

    /// Adds the stage of a joint that turns one plane vector onto another.
    pub fn align(&mut self, joint: usize, from: [Expr; 2], to: [Expr; 2], unit: Unit, meaning: String) {
        self.stage(&[(joint, Angle::ZERO)], unit, Branching::None, meaning, Align { from, to });
    }

    /// Adds the stage of a prismatic joint with `denominator x = numerator`.
    pub fn slide_to(&mut self, joint: usize, denominator: Expr, numerator: Expr, meaning: String) {
        let kernel = SlideTo { denominator, numerator };
        self.stage(&[(joint, Angle::ZERO)], Unit::Length, Branching::None, meaning, kernel);
    }

    /// The derivative that tells the singularity of the last stage, where it is not its kernel's own.
    pub fn pivot(&mut self, value: Expr) {
        if let Some(PlanStep::Stage(stage)) = self.steps.last_mut() {
            stage.pivot = Some(value);
        }
    }

    fn offset(&self, joint: usize) -> Angle {
        self.loop_joints.get(joint).map_or(Angle::ZERO, |slot| slot.offset)
    }

    /// The leaves of a joint's root: value, sine and cosine of the kernel's variable.
    fn bind(&mut self, joint: usize, shift: Angle) -> [Unknown; 3] {
        let label = self.label(joint);
        let prismatic = !self.is_revolute(joint);
        let constant = if prismatic { Angle::ZERO } else { shift.add(self.offset(joint).neg()) };
        // A quarter turn is folded into the sine and cosine of the joint value.
        let of_variable = !shift.is_zero() && shift.quarter_turns().is_none();
        let value = Unknown { joint: label, part: Part::Value, shifted: !constant.is_zero() };
        let [sin, cos] = [Part::Sin, Part::Cos].map(|part| Unknown { joint: label, part, shifted: of_variable });
        if let Some(slot) = self.values.get_mut(joint) {
            *slot = Some(Value { terms: vec![(value.into(), false)], constant });
        }
        if prismatic {
            return [value, sin, cos];
        }
        let raw = Pair { sin: self.g.symbol(sin), cos: self.g.symbol(cos) };
        let constant = self.g.constant_pair(shift, ConstantAngle::Phase(label));
        let pair = if shift.is_zero() { raw } else { raw.plus(&mut self.g, constant) };
        self.g.name(pair.sin, format!("s{label}"));
        self.g.name(pair.cos, format!("c{label}"));
        if let Some(slot) = self.pairs.get_mut(joint) {
            *slot = Some(pair);
        }
        [value, sin, cos]
    }

    /// Adds a step.
    pub fn push(&mut self, step: PlanStep) {
        self.steps.push(step);
    }

    /// The angle of a joint (its DH theta) is this sum.
    pub fn sum(&mut self, joint: usize, mut theta: Value) {
        theta.constant = theta.constant.add(self.offset(joint).neg());
        if let Some(slot) = self.values.get_mut(joint) {
            *slot = Some(theta);
        }
    }

    /// The solved angle of a joint (its DH theta).
    pub fn solved(&self, joint: usize) -> Value {
        let Some(Some(value)) = self.values.get(joint) else { return Value::zero() };
        Value { constant: value.constant.add(self.offset(joint)), ..value.clone() }
    }

    /// `f` and `b` of a constant `link = R_z(f) X R_z(-b)` between axes at a right angle, X the half turn about x + z.
    pub fn right_angle(&self, link: &Rigid) -> Option<[Angle; 2]> {
        let ([fx, fy, _], [_, _, [bx, by, _]]) = (link.z(), link.r);
        let angle = |y: Expr, x: Expr| Some(Angle::of_vector(self.g.constant(y)?, self.g.constant(x)?));
        Some([angle(fy, fx)?, angle(by, bx)?])
    }

    /// The angle of a plane vector: a constant one, or a run-time phase.
    pub fn direction(&mut self, [x, y]: [Expr; 2]) -> Result<Angle, Phase> {
        match (self.g.constant(x), self.g.constant(y)) {
            (Some(x), Some(y)) => Ok(Angle::of_vector(y, x)),
            _ => Err(Phase { y, x }),
        }
    }

    /// Where an angle `from -> to` is counted from: a constant shift, or a run-time phase.
    pub fn between(&mut self, from: [Expr; 2], to: [Expr; 2]) -> (Angle, Option<Phase>) {
        match (self.direction(from), self.direction(to)) {
            (Ok(from), Ok(to)) => (to.add(from.neg()), None),
            _ => {
                let (x, y) = (self.g.dot2(from, to), self.g.cross2(from, to));
                (Angle::ZERO, Some(Phase { y, x }))
            }
        }
    }

    /// The plan. A last stage that gives a virtual joint alone is left out.
    pub fn finish(mut self, triple: Triple, task: PlanTask) -> Plan {
        while let Some(PlanStep::Stage(stage)) = self.steps.last()
            && stage.kernel.form().roots == 1
            && !stage.joints.iter().any(|slot| self.is_own(*slot))
        {
            self.steps.pop();
        }
        let values = self.values.into_iter().map(|value| value.unwrap_or_else(Value::zero));
        Plan {
            graph: self.g,
            steps: self.steps,
            values: values.collect(),
            loop_joints: self.loop_joints,
            triple,
            reach: self.reach,
            missed: self.generic.decisions.missed(),
            off_table: None,
            task,
        }
    }
}

fn name_target(g: &mut Graph, flange: &Rigid) {
    g.name_each(&flange.p, "flange_");
    for (row, i) in flange.r.iter().zip(1..) {
        for (e, j) in row.iter().zip(1..) {
            g.name(*e, format!("f{i}{j}"));
        }
    }
}
