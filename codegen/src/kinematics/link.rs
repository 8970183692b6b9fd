//! Elementary transforms of the chain over named dimensions, and what all sweeps over them share.

use crate::model::Frame;
use crate::model::chain::{Elementary, End};
use crate::symbolic::{
    AngleSum, Angles, ConstantAngle, Cost, Dimension, Expr, Graph, Label, Pair, Part, Rigid, Unknown, Vec3, cost,
    transpose,
};

/// A constant frame `T(xyz) R_z(yaw) R_y(pitch) R_x(roll)`.
fn frame(g: &mut Graph, Frame { xyz, rpy }: &Frame, end: End) -> Rigid {
    let mut component = 0..;
    let p = xyz.each_ref().map(|length| g.length(Dimension::Origin(end, component.next().unwrap_or(0)), length));
    if rpy.iter().filter(|a| a.quarter_turns().is_none()).count() <= 1 {
        // At most one angle that is not a quarter turn: products of exact zeros and ones stay exact.
        let mut which = 0..;
        let [rx, ry, rz] =
            rpy.map(|angle| g.constant_pair(angle, ConstantAngle::RollPitchYaw(end, which.next().unwrap_or(0))));
        let columns = Graph::identity().map(|axis| {
            let v = g.rotate_x(rx, axis);
            let v = g.rotate_y(ry, v);
            g.rotate_z(rz, v)
        });
        return Rigid { r: transpose(&columns), p };
    }
    let [(sr, cr), (sp, cp), (sy, cy)] = rpy.map(|angle| (angle.sin(), angle.cos()));
    let values = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ];
    let mut places = (0..3).flat_map(|row| (0..3).map(move |column| (row, column)));
    let r = values.map(|entries| {
        entries.map(|value| {
            let (row, column) = places.next().unwrap_or((0, 0));
            g.dimension(Dimension::Rotation(end, row, column), value)
        })
    });
    Rigid { r, p }
}

/// A constant elementary transform; the identity for a joint.
pub fn elementary(g: &mut Graph, transform: &Elementary) -> Rigid {
    let mut out = Rigid::identity();
    match transform {
        Elementary::ShiftX { length, row } => {
            out.p = [g.length(Dimension::LinkLength(*row), length), Expr::ZERO, Expr::ZERO]
        }
        Elementary::ShiftZ { length, row } => {
            out.p = [Expr::ZERO, Expr::ZERO, g.length(Dimension::LinkOffset(*row), length)]
        }
        Elementary::RotateX { angle, row } => {
            let pair = g.constant_pair(*angle, ConstantAngle::Alpha(*row));
            out.r = g.rotation_x(pair);
        }
        Elementary::RotateZ { angle, row } => {
            let pair = g.constant_pair(*angle, ConstantAngle::Theta(*row));
            out.r = g.rotation_z(pair);
        }
        Elementary::Frame { frame: constant, end } => out = frame(g, constant, *end),
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
