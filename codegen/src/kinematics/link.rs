//! Elementary transforms of the chain over named dimensions, and what all sweeps over them share.

use crate::model::Frame;
use crate::model::chain::Elementary;
use crate::symbolic::{AngleSum, Angles, Cost, Expr, Graph, Label, Pair, Part, Rigid, Unknown, Vec3, cost, transpose};

/// A constant frame `T(xyz) R_z(yaw) R_y(pitch) R_x(roll)`.
pub fn frame(g: &mut Graph, frame: &Frame, name: &str) -> Rigid {
    let [roll, pitch, yaw] = frame.rpy;
    let [x, y, z] = &frame.xyz;
    let p = [g.length(format!("{name}_X"), x), g.length(format!("{name}_Y"), y), g.length(format!("{name}_Z"), z)];
    let turns = [roll, pitch, yaw].iter().filter(|a| a.quarter_turns().is_none()).count();
    let identity = Graph::identity();
    if turns <= 1 {
        // At most one angle that is not a quarter turn: products of exact zeros and ones stay exact.
        let (rx, ry, rz) = (
            g.constant_pair(roll, &format!("{name}_ROLL")),
            g.constant_pair(pitch, &format!("{name}_PITCH")),
            g.constant_pair(yaw, &format!("{name}_YAW")),
        );
        let columns = identity.map(|axis| {
            let v = g.rotate_x(rx, axis);
            let v = g.rotate_y(ry, v);
            g.rotate_z(rz, v)
        });
        return Rigid { r: transpose(&columns), p };
    }
    let (sr, cr) = (roll.sin(), roll.cos());
    let (sp, cp) = (pitch.sin(), pitch.cos());
    let (sy, cy) = (yaw.sin(), yaw.cos());
    let values = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ];
    let mut row = 0;
    let r = values.map(|entries| {
        row += 1;
        let mut column = 0;
        entries.map(|value| {
            column += 1;
            g.dimension(format!("{name}_R{row}{column}"), value)
        })
    });
    Rigid { r, p }
}

/// A constant elementary transform; the identity for a joint.
pub fn elementary(g: &mut Graph, transform: &Elementary) -> Rigid {
    let mut out = Rigid::identity();
    match transform {
        Elementary::ShiftX { length, name } => out.p = [g.length(name, length), Expr::ZERO, Expr::ZERO],
        Elementary::ShiftZ { length, name } => out.p = [Expr::ZERO, Expr::ZERO, g.length(name, length)],
        Elementary::RotateX { angle, name } => {
            let pair = g.constant_pair(*angle, name);
            out.r = transpose(&Graph::identity().map(|axis| g.rotate_x(pair, axis)));
        }
        Elementary::RotateZ { angle, name } => {
            let pair = g.constant_pair(*angle, name);
            out.r = transpose(&Graph::identity().map(|axis| g.rotate_z(pair, axis)));
        }
        Elementary::Frame { frame: constant, name } => out = frame(g, constant, name),
        Elementary::Revolute { .. } | Elementary::Prismatic { .. } => {}
    }
    out
}

/// Names the components of a vector that has just been expressed in frame `frame`, such as `p_1x`.
pub(super) fn name(g: &mut Graph, v: Vec3, what: &str, frame: usize) {
    g.name_each(&v, &format!("{what}_{frame}"));
}

/// Suggests names for the components of a vector on its way from one frame to the next.
pub(super) fn suggest(g: &mut Graph, v: Vec3, what: &str, frame: usize) {
    g.suggest_each(&v, &format!("{what}_{frame}"));
}

/// The displacement of a prismatic joint.
pub(super) fn displacement(g: &mut Graph, joint: usize) -> Expr {
    g.symbol(Unknown::of(Label::Arm(joint), Part::Value))
}

/// A run of revolute joints with parallel axes: the sum of the angles passed, and whether half turns about x have reversed
/// the axis.
#[derive(Debug, Clone)]
pub(super) struct Run {
    pub sum: AngleSum,
    pub reversed: bool,
}

impl Run {
    /// Before the first joint.
    pub fn start() -> Self {
        Run { sum: AngleSum::zero(), reversed: false }
    }

    /// Passes a transform that keeps the axes parallel.
    pub fn pass(&mut self, transform: &Elementary) {
        match transform {
            Elementary::Revolute { joint, offset } => self.sum.push(Some(*joint), *offset, self.reversed),
            Elementary::RotateZ { angle, .. } => self.sum.push(None, *angle, self.reversed),
            Elementary::RotateX { .. } => self.reversed = !self.reversed,
            _ => {}
        }
    }

    /// A vector behind the run, seen from before it.
    pub fn turn(&self, g: &mut Graph, pair: Pair, [x, y, z]: Vec3) -> Vec3 {
        let v = if self.reversed { [x, g.neg(y), g.neg(z)] } else { [x, y, z] };
        g.rotate_z(pair, v)
    }
}

/// The operations of a function with these results. Sines and cosines that none of them needs are left out.
pub(super) fn finish(g: &Graph, angles: &mut Angles, roots: &[Expr]) -> Cost {
    let used = g.reachable(roots);
    angles.bound.retain(|b| used.contains(&b.pair.sin) || used.contains(&b.pair.cos));
    Cost { sin_cos: angles.bound.len(), ..cost(g, roots) }
}
