//! The chain to be closed: the arm's joints, less a locked one, and virtual joints for what the task leaves open.

use super::probe::{POSITION, Probe, ROTATION};
use crate::kinematics;
use crate::model::chain::{Chain, Step};
use crate::model::geometry::{Line, Triple, triples};
use crate::model::numeric::Transform;
use crate::model::{Angle, JointKind, Model};
use crate::symbolic::{Expr, Graph, Pair, Rigid, transpose};

/// A joint of the closed chain.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    /// The arm's joint, from 0; `None` for a virtual one.
    pub joint: Option<usize>,
    /// What its symbols are called: the joint's number, or `v1` for a virtual joint.
    pub label: String,
    /// Whether it turns.
    pub turns: bool,
    /// The row's theta.
    pub offset: Angle,
}

impl Slot {
    /// A virtual joint that turns.
    pub fn virtual_turn(number: usize) -> Slot {
        Slot { joint: None, label: format!("v{number}"), turns: true, offset: Angle::ZERO }
    }
}

/// A joint whose value is given.
#[derive(Debug, Clone, PartialEq)]
pub struct Locked {
    /// The joint, from 0.
    pub joint: usize,
    /// Whether it turns.
    pub turns: bool,
}

/// `links[0] joint_0 links[1] joint_1 ... links[n] = target`
#[derive(Debug, Clone)]
pub struct Problem {
    /// The arena.
    pub g: Graph,
    /// Decides what vanishes.
    pub probe: Probe,
    /// The joints in order.
    pub slots: Vec<Slot>,
    /// What stands before, between and after them: one more than joints.
    pub links: Vec<Rigid>,
    /// Where the last frame has to be.
    pub target: Rigid,
    /// The joint whose value is given.
    pub locked: Option<Locked>,
    /// Reach of the arm.
    pub reach: f64,
}

impl Problem {
    /// The arm as it is, with the joint `locked` moved into its link.
    pub fn new(model: &Model, chain: &Chain, reach: f64, locked: Option<usize>) -> Problem {
        let mut g = Graph::default();
        let links: Vec<Rigid> = chain
            .links()
            .iter()
            .map(|steps| {
                steps.iter().fold(Rigid::identity(), |sum, step| {
                    let factor = kinematics::step(&mut g, step);
                    sum.then(&mut g, &factor)
                })
            })
            .collect();
        let offsets = chain.steps.iter().filter_map(|step| match step {
            Step::Revolute { offset, .. } => Some(*offset),
            Step::Prismatic { .. } => Some(Angle::ZERO),
            _ => None,
        });
        let slots = model
            .joints
            .iter()
            .zip(offsets)
            .enumerate()
            .map(|(joint, (checked, offset))| Slot {
                joint: Some(joint),
                label: (joint + 1).to_string(),
                turns: checked.kind == JointKind::Revolute,
                offset,
            })
            .collect();
        let target =
            Rigid { r: ROTATION.map(|row| row.map(|name| g.symbol(name))), p: POSITION.map(|name| g.symbol(name)) };
        let mut problem = Problem { g, probe: Probe::new(reach), slots, links, target, locked: None, reach };
        if let Some(joint) = locked {
            problem.lock(joint);
        }
        problem
    }

    /// Link `i`: before joint `i`.
    pub fn link(&self, i: usize) -> Rigid {
        self.links.get(i).copied().unwrap_or_else(Rigid::identity)
    }

    /// The joint's motion becomes part of its link; its sine and cosine are symbols known beforehand.
    fn lock(&mut self, joint: usize) {
        let Some(slot) = self.slots.get(joint).cloned() else { return };
        let g = &mut self.g;
        let motion = if slot.turns {
            let raw = Pair { sin: g.symbol(format!("s{}", slot.label)), cos: g.symbol(format!("c{}", slot.label)) };
            let constant = g.constant_pair(slot.offset, &format!("THETA{}", slot.label));
            let pair = if slot.offset.is_zero() { raw } else { raw.plus(g, constant) };
            let columns = Graph::identity().map(|axis| g.rotate_z(pair, axis));
            Rigid { r: transpose(&columns), ..Rigid::identity() }
        } else {
            let stroke = g.symbol(format!("q{}", slot.label));
            Rigid { p: [Expr::ZERO, Expr::ZERO, stroke], ..Rigid::identity() }
        };
        let (before, after) = (self.link(joint), self.link(joint + 1));
        let before = before.then(&mut self.g, &motion);
        let merged = before.then(&mut self.g, &after);
        self.slots.remove(joint);
        self.links.remove(joint + 1);
        if let Some(link) = self.links.get_mut(joint) {
            *link = merged;
        }
        self.locked = Some(Locked { joint, turns: slot.turns });
        self.probe.given(&slot.label);
    }

    /// Adds a joint at the end: the last link goes before it, `after` behind it.
    pub fn append(&mut self, slot: Slot, before: Rigid, after: Rigid) {
        if let Some(last) = self.links.last_mut() {
            *last = last.then(&mut self.g, &before);
        }
        self.slots.push(slot);
        self.links.push(after);
    }

    /// The triples of consecutive joints, for every value of a locked joint.
    pub fn triples(&self) -> Vec<Triple> {
        let turns: Vec<bool> = self.slots.iter().map(|slot| slot.turns).collect();
        let mut samples = self.probe.samples().iter().map(|sample| triples(&self.axes(sample), &turns, self.reach).0);
        let first = samples.next().unwrap_or_default();
        samples.fold(first, |kept, found| kept.into_iter().filter(|triple| found.contains(triple)).collect())
    }

    /// The axes with every joint at a value that is special for no arm.
    fn axes(&self, sample: &super::probe::Sample) -> Vec<Line> {
        let mut current = self.numeric(0, sample);
        let mut axes = Vec::new();
        for (i, slot) in self.slots.iter().enumerate() {
            axes.push(Line { point: current.p, direction: current.axis(2) });
            let generic = 0.618_033_988_749_895 * (i as f64 + 1.0) + 0.271_828;
            let motion = if slot.turns {
                Transform::rotate_z(generic.sin(), generic.cos())
            } else {
                Transform::shift([0.0, 0.0, self.reach * (0.3 + 0.1 * generic.sin())])
            };
            current = current.then(&motion).then(&self.numeric(i + 1, sample));
        }
        axes
    }

    /// Link `i` as numbers.
    pub fn numeric(&self, i: usize, sample: &super::probe::Sample) -> Transform {
        let link = self.link(i);
        let row = |row: [Expr; 3]| {
            let values = self.g.evaluate(&row, sample);
            let mut out = [0.0; 3];
            out.iter_mut().zip(values).for_each(|(slot, value)| *slot = value);
            out
        };
        Transform { r: link.r.map(row), p: row(link.p) }
    }
}
