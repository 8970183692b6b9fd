//! The chain to be closed: the arm's joints, less those that are given, and virtual joints for what the task leaves open.

use super::generic_samples::GenericSamples;
use super::task::GivenValues;
use crate::kinematics;
use crate::model::chain::{Chain, Elementary};
use crate::model::{Angle, JointKind, Model, Redundant};
use crate::symbolic::{ConstantAngle, Expr, Graph, Input, Label, Pair, Part, Rigid};

/// A joint of the closed chain.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopJoint {
    /// Which one it is, and what its unknowns are called.
    pub label: Label,
    /// True for a revolute joint.
    pub revolute: bool,
    /// The row's theta.
    pub offset: Angle,
}

impl LoopJoint {
    /// A virtual joint that turns.
    pub fn virtual_turn(number: usize) -> LoopJoint {
        LoopJoint { label: Label::Virtual(number), revolute: true, offset: Angle::ZERO }
    }
}

/// `links[0] joint_0 links[1] joint_1 ... links[n] = target`
#[derive(Debug, Clone)]
pub struct LoopChain {
    /// The arena.
    pub g: Graph,
    /// Decides what vanishes.
    pub generic: GenericSamples,
    /// The joints in order.
    pub loop_joints: Vec<LoopJoint>,
    /// Constant transforms before, between and after the joints: one more than joints.
    pub links: Vec<Rigid>,
    /// Where the last frame has to be.
    pub target: Rigid,
    /// Values given beside the target.
    pub given: GivenValues,
    /// Reach of the arm.
    pub reach: f64,
}

impl LoopChain {
    /// The arm as it is, with the joints whose values are given moved into their links.
    pub fn new(model: &Model, chain: &Chain, reach: f64, redundant: &Redundant) -> LoopChain {
        let mut g = Graph::default().with_owner("arm");
        let links: Vec<Rigid> = chain
            .links()
            .iter()
            .map(|steps| {
                steps.iter().fold(Rigid::identity(), |sum, step| {
                    let factor = kinematics::elementary(&mut g, step);
                    sum.then(&mut g, &factor)
                })
            })
            .collect();
        let offsets = chain.transforms.iter().filter_map(|step| match step {
            Elementary::Revolute { offset, .. } => Some(*offset),
            Elementary::Prismatic { .. } => Some(Angle::ZERO),
            _ => None,
        });
        let loop_joints = model
            .joints
            .iter()
            .zip(offsets)
            .enumerate()
            .map(|(joint, (checked, offset))| LoopJoint {
                label: Label::Arm(joint),
                revolute: checked.kind == JointKind::Revolute,
                offset,
            })
            .collect();
        let target = Rigid {
            r: Input::ROTATION.map(|row| row.map(|entry| g.symbol(entry))),
            p: Input::POSITION.map(|component| g.symbol(component)),
        };
        let mut generic = GenericSamples::new(reach);
        generic.parameters(&g, model);
        let given = GivenValues::of(redundant, &model.joints);
        let mut chain = LoopChain { g, generic, loop_joints, links, target, given, reach };
        // From the last one, so that the places before it are those of the arm.
        for (joint, checked) in model.joints.iter().enumerate().rev().filter(|(joint, _)| redundant.holds(*joint)) {
            chain.give(joint, checked.row);
        }
        chain
    }

    /// Link `i`: before joint `i`.
    pub fn link(&self, i: usize) -> Rigid {
        self.links.get(i).copied().unwrap_or_else(Rigid::identity)
    }

    /// The motion of a joint, which stands in `row`, becomes part of its link; its sine and cosine are inputs.
    fn give(&mut self, joint: usize, row: usize) {
        let Some(slot) = self.loop_joints.get(joint).cloned() else { return };
        let g = &mut self.g;
        let [value, sin, cos] = [Part::Value, Part::Sin, Part::Cos].map(|part| Input::given(joint, part));
        let motion = if slot.revolute {
            let raw = Pair { sin: g.symbol(sin), cos: g.symbol(cos) };
            let constant = g.constant_pair(slot.offset, ConstantAngle::Theta(row));
            let pair = if slot.offset.is_zero() { raw } else { raw.plus(g, constant) };
            Rigid { r: g.rotation_z(pair), ..Rigid::identity() }
        } else {
            Rigid { p: [Expr::ZERO, Expr::ZERO, g.symbol(value)], ..Rigid::identity() }
        };
        let (before, after) = (self.link(joint), self.link(joint + 1));
        let before = before.then(&mut self.g, &motion);
        let merged = before.then(&mut self.g, &after);
        self.loop_joints.remove(joint);
        self.links.remove(joint + 1);
        if let Some(link) = self.links.get_mut(joint) {
            *link = merged;
        }
        if slot.revolute { self.generic.angle([value, sin, cos]) } else { self.generic.position(value) }
    }

    /// Adds a joint at the end, behind the last link and `before`.
    pub fn append(&mut self, slot: LoopJoint, before: Rigid) {
        if let Some(last) = self.links.last_mut() {
            *last = last.then(&mut self.g, &before);
        }
        self.loop_joints.push(slot);
        self.links.push(Rigid::identity());
    }

    /// The last link, which is left out of the chain.
    pub fn take_tool(&mut self) -> Rigid {
        self.links.last_mut().map_or_else(Rigid::identity, |last| std::mem::replace(last, Rigid::identity()))
    }
}
