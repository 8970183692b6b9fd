//! The chain to be closed: the arm's joints, less a locked one, and virtual joints for what the task leaves open.

use super::closure::constant_angle;
use super::probe::{POSITION, Probe, ROTATION};
use crate::kinematics;
use crate::model::chain::{Chain, Step};
use crate::model::geometry::{Line, TOLERANCE, Triple, triples};
use crate::model::numeric::{Transform, cross, dot, length};
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
        let mut g = Graph::default().with_owner("arm");
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
        let mut probe = Probe::new(reach);
        probe.parameters(&g, model);
        let mut problem = Problem { g, probe, slots, links, target, locked: None, reach };
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
        let names = ["q", "s", "c"].map(|letter| format!("{letter}{}", slot.label));
        let [q, s, c] = &names;
        if slot.turns { self.probe.angle([q, s, c]) } else { self.probe.position(q) }
    }

    /// Adds a joint at the end: the last link goes before it, `after` behind it.
    pub fn append(&mut self, slot: Slot, before: Rigid, after: Rigid) {
        if let Some(last) = self.links.last_mut() {
            *last = last.then(&mut self.g, &before);
        }
        self.slots.push(slot);
        self.links.push(after);
    }

    /// The last link, which is left out of the chain.
    pub fn take_tool(&mut self) -> Rigid {
        self.links.last_mut().map_or_else(Rigid::identity, |last| std::mem::replace(last, Rigid::identity()))
    }

    /// Whether link `i` keeps the z axis parallel or anti-parallel, for every value of a locked joint: its sign.
    pub fn keeps_axis(&self, i: usize) -> Option<f64> {
        let mut cosines = self.probe.samples().iter().map(|sample| {
            let [.., [_, _, z]] = self.numeric(i, sample).r;
            z
        });
        let first = cosines.next()?;
        let parallel = |z: f64| z.abs() >= 1.0 - 0.5 * TOLERANCE * TOLERANCE && z * first > 0.0;
        (parallel(first) && cosines.all(parallel)).then(|| first.signum())
    }

    /// Whether two axes are parallel at a generic configuration.
    pub fn are_parallel(&self, i: usize, j: usize) -> bool {
        let axes = self.probe.samples().first().map(|sample| self.axes(sample)).unwrap_or_default();
        let pair = axes.get(i).zip(axes.get(j));
        pair.is_some_and(|(a, b)| length(cross(a.direction, b.direction)) <= TOLERANCE)
    }

    /// The joint that slides along the direction about which all joints turn that do; the others slide across it.
    pub fn stroke_along_turns(&self) -> Option<usize> {
        let samples = self.probe.samples().iter();
        let mut strokes = samples.map(|sample| {
            let axes = self.axes(sample);
            let turning = axes.iter().zip(&self.slots).find(|(_, slot)| slot.turns)?.0.direction;
            let along = |line: &Line| length(cross(line.direction, turning)) <= TOLERANCE;
            let across = |line: &Line| dot(line.direction, turning).abs() <= TOLERANCE;
            let mut upright =
                axes.iter().zip(&self.slots).all(|(line, slot)| along(line) || !slot.turns && across(line));
            let mut strokes =
                axes.iter().zip(&self.slots).enumerate().filter(|(_, (line, slot))| !slot.turns && along(line));
            let stroke = strokes.next().map(|(i, _)| i);
            upright &= strokes.next().is_none();
            stroke.filter(|_| upright)
        });
        let first = strokes.next()??;
        strokes.all(|stroke| stroke == Some(first)).then_some(first)
    }

    /// The chain with the sliding joint `i` moved past the joint after it: one that slides too, or one that turns about
    /// a parallel axis, `T_z(d) C R_z(t) = C R_z(t) T_z(+-d)`.
    pub fn slide_later(&self, i: usize) -> Option<Problem> {
        let (slides, next) = (self.slots.get(i)?, self.slots.get(i + 1)?);
        if slides.turns {
            return None;
        }
        if !next.turns {
            return Some(self.slides_swapped(i));
        }
        let sign = self.keeps_axis(i + 1)?;
        let mut moved = self.clone();
        let g = &mut moved.g;
        let before = self.link(i).then(g, &self.link(i + 1));
        let (there, back) = flip(g, sign);
        let after = back.then(g, &self.link(i + 2));
        moved.slots.swap(i, i + 1);
        for (place, link) in moved.links.iter_mut().skip(i).zip([before, there, after]) {
            *place = link;
        }
        Some(moved)
    }

    /// The chain with the sliding joints `i` and `i + 1` in the other order.
    fn slides_swapped(&self, i: usize) -> Problem {
        let mut moved = self.clone();
        let g = &mut moved.g;
        let between = self.link(i + 1);
        let before = self.link(i).then(g, &between);
        let after = between.then(g, &self.link(i + 2));
        let back = between.inverse(g);
        moved.slots.swap(i, i + 1);
        for (place, link) in moved.links.iter_mut().skip(i).zip([before, back, after]) {
            *place = link;
        }
        moved
    }

    /// The chain with the sliding joint `i` moved before the turning joint before it.
    pub fn slide_earlier(&self, i: usize) -> Option<Problem> {
        let (turns, slides) = (self.slots.get(i.checked_sub(1)?)?, self.slots.get(i)?);
        if slides.turns || !turns.turns {
            return None;
        }
        let sign = self.keeps_axis(i)?;
        let mut moved = self.clone();
        let g = &mut moved.g;
        let (there, back) = flip(g, sign);
        let before = self.link(i - 1).then(g, &there);
        let after = self.link(i).then(g, &self.link(i + 1));
        moved.slots.swap(i - 1, i);
        for (place, link) in moved.links.iter_mut().skip(i - 1).zip([before, back, after]) {
            *place = link;
        }
        Some(moved)
    }

    /// Whether every joint moves in the base frame's xy plane.
    pub fn is_planar(&self) -> bool {
        self.probe.samples().iter().all(|sample| {
            self.axes(sample).iter().zip(&self.slots).all(|(line, slot)| {
                let [x, y, z] = line.direction;
                if slot.turns { x.hypot(y) <= TOLERANCE } else { z.abs() <= TOLERANCE }
            })
        })
    }

    /// For an arm in the plane: the turn about the tool's x axis that takes an upright frame to the tool's; `None` if
    /// that axis leaves the plane.
    pub fn tool_twist(&self) -> Option<Angle> {
        let [_, _, [x, y, z]] = self.tool()?.r;
        (x.abs() <= TOLERANCE).then(|| constant_angle(y, z))
    }

    /// The pose of the tool at a generic configuration.
    fn tool(&self) -> Option<Transform> {
        Some(self.axes_and_tool(self.probe.samples().first()?, 0).1)
    }

    /// Adds a virtual joint at the tool point whose axis is upright.
    pub fn append_upright(&mut self) {
        let Some(Transform { r: [_, _, [x, y, z]], .. }) = self.tool() else { return };
        let (azimuth, polar) = (constant_angle(y, x), constant_angle(x.hypot(y), z));
        let upright = x.hypot(y) <= TOLERANCE;
        let before = if upright {
            Rigid::identity()
        } else {
            let (polar, azimuth) =
                (self.g.constant_pair(polar, "TOOL_POLAR"), self.g.constant_pair(azimuth, "TOOL_AZIMUTH"));
            let columns = Graph::identity().map(|axis| {
                let axis = self.g.rotate_y(polar, axis);
                self.g.rotate_z(azimuth, axis)
            });
            Rigid { r: transpose(&columns), ..Rigid::identity() }
        };
        self.append(Slot::virtual_turn(1), before, Rigid::identity());
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
        self.axes_and_tool(sample, 0).0
    }

    /// The axes and the pose of the tool; every seed gives other joint values.
    pub fn axes_and_tool(&self, sample: &super::probe::Sample, seed: usize) -> (Vec<Line>, Transform) {
        let mut current = self.numeric(0, sample);
        let mut axes = Vec::new();
        for (i, slot) in self.slots.iter().enumerate() {
            axes.push(Line { point: current.p, direction: current.axis(2) });
            let motion = generic_motion(i + 17 * seed, slot.turns, self.reach);
            current = current.then(&motion).then(&self.numeric(i + 1, sample));
        }
        (axes, current)
    }

    /// The pose of the link after joint `i` at the generic configuration, as `link_poses` counts links.
    pub fn body(&self, chain: &Chain, i: usize) -> Transform {
        let end = chain.link_ends.get(i).copied().unwrap_or(0);
        chain.steps.iter().take(end).fold(Transform::IDENTITY, |sum, step| {
            let factor = match step {
                Step::Revolute { joint, .. } => generic_motion(*joint, true, self.reach),
                Step::Prismatic { joint } => generic_motion(*joint, false, self.reach),
                _ => Transform::of(step),
            };
            sum.then(&factor)
        })
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

/// Joint `i` at a value that is special for no arm.
fn generic_motion(i: usize, turns: bool, reach: f64) -> Transform {
    let generic = 0.618_033_988_749_895 * (i as f64 + 1.0) + 0.271_828;
    if turns {
        Transform::rotate_z(generic.sin(), generic.cos())
    } else {
        Transform::shift([0.0, 0.0, reach * (0.3 + 0.1 * generic.sin())])
    }
}

/// A half turn about x and its inverse if the sign is negative.
fn flip(g: &mut Graph, sign: f64) -> (Rigid, Rigid) {
    if sign > 0.0 {
        return (Rigid::identity(), Rigid::identity());
    }
    let half = g.constant_pair(Angle::degrees(180.0), "FLIP");
    let columns = Graph::identity().map(|axis| g.rotate_x(half, axis));
    let there = Rigid { r: transpose(&columns), ..Rigid::identity() };
    (there, there)
}
