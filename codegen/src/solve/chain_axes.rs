//! How the axes of a chain lie, decided at generic values of all its joints.

use super::generic_samples::Sample;
use super::loop_chain::{LoopChain, LoopJoint};
use crate::model::Angle;
use crate::model::chain::{Chain, Elementary};
use crate::model::geometry::{Line, Triple, generic_motion, triples};
use crate::model::numeric::{Transform, cross, dot, length};
use crate::symbolic::{Expr, Graph, Rigid, transpose};

impl LoopChain {
    /// Sign of the z axis after link `i`, if the link keeps that axis parallel or anti-parallel for every value of a
    /// given joint.
    pub fn keeps_axis(&self, i: usize) -> Option<f64> {
        let mut axes = self.generic.samples().iter().map(|sample| self.numeric(i, sample).axis(2));
        let first = axes.next()?;
        let [.., sign] = first.map(f64::signum);
        let parallel = |[x, y, z]: [f64; 3]| self.generic.decisions.vanishes(x.hypot(y)) && z * sign > 0.0;
        (parallel(first) && axes.all(parallel)).then_some(sign)
    }

    /// Returns true if two axes are parallel at a generic configuration.
    pub fn are_parallel(&self, i: usize, j: usize) -> bool {
        let axes = self.generic.samples().first().map(|sample| self.axes(sample)).unwrap_or_default();
        let pair = axes.get(i).zip(axes.get(j));
        pair.is_some_and(|(a, b)| self.generic.decisions.vanishes(length(cross(a.direction, b.direction))))
    }

    /// The prismatic joint along the common direction of all revolute axes, where the other prismatic ones are across it.
    pub fn prismatic_along_revolute(&self) -> Option<usize> {
        let samples = self.generic.samples().iter();
        let mut joints = samples.map(|sample| {
            let axes = self.axes(sample);
            let turning = axes.iter().zip(&self.loop_joints).find(|(_, slot)| slot.revolute)?.0.direction;
            let along = |line: &Line| self.generic.decisions.vanishes(length(cross(line.direction, turning)));
            let across = |line: &Line| self.generic.decisions.vanishes(dot(line.direction, turning));
            let mut upright =
                axes.iter().zip(&self.loop_joints).all(|(line, slot)| along(line) || !slot.revolute && across(line));
            let mut parallel = axes
                .iter()
                .zip(&self.loop_joints)
                .enumerate()
                .filter(|(_, (line, slot))| !slot.revolute && along(line));
            let joint = parallel.next().map(|(i, _)| i);
            upright &= parallel.next().is_none();
            joint.filter(|_| upright)
        });
        let first = joints.next()??;
        joints.all(|joint| joint == Some(first)).then_some(first)
    }

    /// Returns true if every joint moves in the base frame's xy plane.
    pub fn is_planar(&self) -> bool {
        self.generic.samples().iter().all(|sample| {
            self.axes(sample).iter().zip(&self.loop_joints).all(|(line, slot)| {
                let [x, y, z] = line.direction;
                self.generic.decisions.vanishes(if slot.revolute { x.hypot(y) } else { z })
            })
        })
    }

    /// The normal of the plane that every joint moves in, in the base frame. `None` without such a plane, or where no joint
    /// turns.
    pub fn plane_normal(&self) -> Option<[f64; 3]> {
        let sample = self.generic.samples().first()?;
        let axes = self.axes(sample);
        let normal = axes.iter().zip(&self.loop_joints).find(|(_, slot)| slot.revolute)?.0.direction;
        let in_plane = self.generic.samples().iter().all(|sample| {
            self.axes(sample).iter().zip(&self.loop_joints).all(|(line, slot)| {
                let u = line.direction;
                self.generic.decisions.vanishes(if slot.revolute { length(cross(u, normal)) } else { dot(u, normal) })
            })
        });
        in_plane.then_some(normal)
    }

    /// For an arm in the plane: the turn about the tool's x axis that takes an upright frame to the tool's. `None` if
    /// that axis leaves the plane.
    pub fn tool_twist(&self) -> Option<Angle> {
        let [_, _, [x, y, z]] = self.tool()?.r;
        self.generic.decisions.vanishes(x).then(|| Angle::of_vector(y, z))
    }

    /// The pose of the tool at a generic configuration.
    fn tool(&self) -> Option<Transform> {
        Some(self.axes_and_tool(self.generic.samples().first()?, 0).1)
    }

    /// Adds a virtual joint at the tool point whose axis is upright.
    pub fn append_upright(&mut self) {
        let Some(Transform { r: [_, _, [x, y, z]], .. }) = self.tool() else { return };
        let (azimuth, polar) = (Angle::of_vector(y, x), Angle::of_vector(x.hypot(y), z));
        let upright = self.generic.decisions.vanishes(x.hypot(y));
        let before = if upright {
            Rigid::identity()
        } else {
            let (polar, azimuth) = (self.g.turn(polar), self.g.turn(azimuth));
            let columns = Graph::identity().map(|axis| {
                let axis = self.g.rotate_y(polar, axis);
                self.g.rotate_z(azimuth, axis)
            });
            Rigid { r: transpose(&columns), ..Rigid::identity() }
        };
        self.append(LoopJoint::virtual_turn(1), before);
    }

    /// The triples of consecutive joints, for every value of a given joint.
    pub fn triples(&self) -> Vec<Triple> {
        let turns: Vec<bool> = self.loop_joints.iter().map(|slot| slot.revolute).collect();
        let found = |sample: &Sample| triples(&self.axes(sample), &turns, self.reach, &self.generic.decisions).0;
        let mut samples = self.generic.samples().iter().map(found);
        let first = samples.next().unwrap_or_default();
        samples.fold(first, |kept, found| kept.into_iter().filter(|triple| found.contains(triple)).collect())
    }

    /// The axes with every joint at a value that is special for no arm.
    fn axes(&self, sample: &Sample) -> Vec<Line> {
        self.axes_and_tool(sample, 0).0
    }

    /// The axes and the pose of the tool; every seed gives other joint values.
    pub fn axes_and_tool(&self, sample: &Sample, seed: usize) -> (Vec<Line>, Transform) {
        let mut current = self.numeric(0, sample);
        let mut axes = Vec::new();
        for (i, slot) in self.loop_joints.iter().enumerate() {
            axes.push(Line { point: current.p, direction: current.axis(2) });
            let motion = generic_motion(i + 17 * seed, slot.revolute, self.reach);
            current = current.then(&motion).then(&self.numeric(i + 1, sample));
        }
        (axes, current)
    }

    /// The frame that joint `i` turns or slides, at the generic configuration.
    pub fn frame_before(&self, i: usize, sample: &Sample) -> Transform {
        (0..i).zip(&self.loop_joints).fold(self.numeric(0, sample), |frame, (i, slot)| {
            frame.then(&generic_motion(i, slot.revolute, self.reach)).then(&self.numeric(i + 1, sample))
        })
    }

    /// The pose of the link after joint `i` at the generic configuration, as `link_poses` counts links.
    pub fn body(&self, chain: &Chain, i: usize) -> Transform {
        let end = chain.link_ends.get(i).copied().unwrap_or(0);
        chain.transforms.iter().take(end).fold(Transform::IDENTITY, |sum, step| {
            let factor = match step {
                Elementary::Revolute { joint, .. } => generic_motion(*joint, true, self.reach),
                Elementary::Prismatic { joint } => generic_motion(*joint, false, self.reach),
                _ => Transform::of(step),
            };
            sum.then(&factor)
        })
    }

    /// Link `i` as numbers.
    pub fn numeric(&self, i: usize, sample: &Sample) -> Transform {
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
