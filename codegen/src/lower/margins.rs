//! The factors of the Jacobian's determinant, from a joint vector.

use super::{Slot, Straight};
use crate::model::Angle;
use crate::solve::{self, Factor, Goal, Plan};
use crate::symbolic::{Graph, Input, Label, Node, Part};

/// Sine and cosine of a kernel's variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variable {
    /// The joint, from 0.
    pub joint: usize,
    /// Joint value less the variable.
    pub constant: Angle,
    /// Where the sine goes, if it is read.
    pub sin: Option<Slot>,
    /// Where the cosine goes, if it is read.
    pub cos: Option<Slot>,
}

/// The angle of `position_angle`: the sum of the joints by their signs, plus the offset.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// One for each joint, 0 for those that do not count.
    pub signs: Vec<f64>,
    /// The angle at zero.
    pub offset: Angle,
    /// Where its sine goes.
    pub sin: Slot,
    /// Where its cosine goes.
    pub cos: Slot,
}

/// The factors as a program: entries of the tool's pose, sines and cosines of all variables in one call, the angle in
/// the plane, arithmetic. A factor is its value over the reach, as often as it has lengths.
#[derive(Debug, Clone)]
pub struct Margins {
    /// The arithmetic; its results are the values of the factors.
    pub straight: Straight,
    /// The factors.
    pub factors: Vec<Factor>,
    /// Parts of the tool's pose that are read.
    pub pose: Vec<(Slot, Input)>,
    /// Where the joint values go.
    pub joints: Vec<Slot>,
    /// The variables whose sine or cosine is read.
    pub variables: Vec<Variable>,
    /// The angle in the plane, if it is read.
    pub plane: Option<Plane>,
}

impl Margins {
    /// Returns true if the value of a joint is read.
    pub fn reads(&self, joint: usize) -> bool {
        let turns = self.variables.iter().any(|variable| variable.joint == joint);
        let pitches = self.plane.as_ref().and_then(|plane| plane.signs.get(joint)).is_some_and(|sign| *sign != 0.0);
        turns || pitches || self.joints.get(joint).is_some_and(|slot| self.straight.reads(*slot))
    }
}

/// The program; `None` for a task that has no margins.
pub fn margins(plan: &Plan) -> Option<Margins> {
    let (mut graph, factors) = solve::margins(plan);
    let roots: Vec<Slot> = factors.iter().map(|factor| factor.value).collect();
    if factors.is_empty() {
        return None;
    }
    let leaves: Vec<Slot> = graph.reachable(&roots).into_iter().filter(|e| is_leaf(&graph, *e)).collect();
    let mut joints = Vec::new();
    let mut variables = Vec::new();
    let mut known = Vec::new();
    for joint in 0..plan.joints() {
        let mut read = |part: Part| {
            let symbols: Vec<Slot> = plan.leaves(joint, part).into_iter().map(|leaf| graph.symbol(leaf)).collect();
            known.extend(&symbols);
            symbols.into_iter().find(|symbol| leaves.contains(symbol))
        };
        let (sin, cos) = (read(Part::Sin), read(Part::Cos));
        if sin.is_some() || cos.is_some() {
            variables.push(Variable { joint, constant: constant(plan, joint), sin, cos });
        }
        joints.push(graph.symbol(plan.value(joint)));
    }
    let plane = match &plan.task.goal {
        Goal::PositionAngle { signs, offset } => {
            let [sin, cos] = [Input::SinAngle, Input::CosAngle].map(|input| graph.symbol(input));
            known.extend([sin, cos]);
            Some(Plane { signs: signs.clone(), offset: *offset, sin, cos })
        }
        _ => None,
    };
    let plane = plane.filter(|plane| leaves.contains(&plane.sin) || leaves.contains(&plane.cos));
    let pose: Vec<(Slot, Input)> = Input::ROTATION
        .into_iter()
        .flatten()
        .chain(Input::POSITION)
        .map(|input| (graph.symbol(input), input))
        .filter(|(slot, _)| leaves.contains(slot))
        .collect();
    known.extend(joints.iter().chain(pose.iter().map(|(slot, _)| slot)));
    // What else the factors read is nothing that a joint vector tells.
    if leaves.iter().any(|leaf| !known.contains(leaf) && !graph.is_field(*leaf)) {
        return None;
    }
    let names: Vec<String> = leaves.iter().filter_map(|leaf| graph.leaf_name(*leaf)).collect();
    let reserved = names.into_iter().chain(["target", "q", "arm", "reach"].map(String::from));
    let straight = Straight::new(graph, roots, reserved);
    Some(Margins { straight, factors, pose, joints, variables, plane })
}

/// A leaf whose value is known at run time only.
fn is_leaf(graph: &Graph, e: Slot) -> bool {
    matches!(graph.node(e), Node::Symbol(_)) && graph.constant(e).is_none()
}

/// Joint value less the variable of its kernel.
pub fn constant(plan: &Plan, joint: usize) -> Angle {
    let slot = plan.loop_joints.iter().position(|slot| slot.label == Label::Arm(joint));
    slot.and_then(|slot| plan.values.get(slot)).map_or(Angle::ZERO, |value| value.constant)
}
