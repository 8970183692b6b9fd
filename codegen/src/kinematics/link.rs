//! Constant factors of the chain as rigid transforms over named dimensions.

use crate::model::Frame;
use crate::model::chain::Step;
use crate::symbolic::{Angles, Expr, Graph, Label, Part, Rigid, Unknown, Vec3, transpose};

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

/// One constant factor; the identity for a joint.
pub fn step(g: &mut Graph, step: &Step) -> Rigid {
    let mut out = Rigid::identity();
    match step {
        Step::ShiftX { length, name } => out.p = [g.length(name, length), Expr::ZERO, Expr::ZERO],
        Step::ShiftZ { length, name } => out.p = [Expr::ZERO, Expr::ZERO, g.length(name, length)],
        Step::RotateX { angle, name } => {
            let pair = g.constant_pair(*angle, name);
            out.r = transpose(&Graph::identity().map(|axis| g.rotate_x(pair, axis)));
        }
        Step::RotateZ { angle, name } => {
            let pair = g.constant_pair(*angle, name);
            out.r = transpose(&Graph::identity().map(|axis| g.rotate_z(pair, axis)));
        }
        Step::Frame { frame: constant, name } => out = frame(g, constant, name),
        Step::Revolute { .. } | Step::Prismatic { .. } => {}
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

/// The joint symbol of a prismatic joint.
pub(super) fn stroke(g: &mut Graph, joint: usize) -> Expr {
    g.symbol(Unknown::of(Label::Arm(joint), Part::Value))
}

/// The number of sine and cosine pairs bound.
pub(super) fn pairs(angles: &Angles) -> usize {
    angles.bound.len()
}
