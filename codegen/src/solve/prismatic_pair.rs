//! The outer joints when the middle one and another one are prismatic: the equations are those in the plane across the
//! middle one.

use super::kernel::{SlideTurning, Unit};
use super::loop_closure::LoopClosure;
use super::plan::Branching;
use super::sides::Side;
use crate::model::Angle;
use crate::symbolic::{Expr, Label, Vec3};

/// The components across y's axis over a turning side, less those of the still part over the other.
pub fn still_rows(c: &mut LoopClosure, other: &Side, across: [Vec3; 2], still: [Expr; 2]) -> [[Expr; 3]; 2] {
    let mut still = still.into_iter();
    across.map(|direction| {
        let dot = c.g.dot3(direction, other.origin);
        let sum = c.g.add(dot, still.next().unwrap_or(Expr::ZERO));
        let k = c.g.neg(sum);
        other.row(c, direction, k).array()
    })
}

/// With y and one more joint prismatic, the direction across both gives the third joint. With all three prismatic both
/// components are linear.
pub fn one_slides(c: &mut LoopClosure, sides: [&Side; 2], across: [[Vec3; 2]; 2], ny: Label) {
    let w = c.center();
    let [a, b] = sides;
    let [across_a, across_b] = across;
    let (slides, other, across_s, across_o) =
        if a.revolute { (b, a, across_b, across_a) } else { (a, b, across_a, across_b) };
    // The displacement in the plane across y's axis, and the still parts of both sides.
    let signed = |c: &mut LoopClosure, side: &Side, e: Expr| if side.undone { c.g.neg(e) } else { e };
    let direction = across_s.map(|axis| signed(c, slides, Side::along(axis)));
    let still = |c: &mut LoopClosure, side: &Side, directions: [Vec3; 2]| {
        let from = c.g.sub3(side.moved, side.origin);
        directions.map(|direction| c.g.dot3(direction, from))
    };
    let still_s = still(c, slides, across_s);
    if other.revolute && direction.iter().any(|e| c.g.constant(*e).is_none()) {
        let rows = still_rows(c, other, across_o, still_s);
        let (m, n) = (c.label(other.joint), c.label(slides.joint));
        let meaning = format!("Joints {m} and {n} together: {w} has equal components across axis {ny}.");
        let joints = [(other.joint, Angle::ZERO), (slides.joint, Angle::ZERO)];
        let kernel = SlideTurning { direction, rows };
        c.stage(&joints, Unit::Length, Branching::Shoulder, meaning, kernel);
        return;
    }
    let [sx, sy] = direction;
    // n is across the displacement: n . (plane part) does not depend on it.
    let normal = [c.g.neg(sy), sx];
    let value = c.g.dot2(normal, still_s);
    let (m, n) = (c.label(other.joint), c.label(slides.joint));
    let meaning = format!("Joint {m}: {w} has equal components across axes {ny} and {n}.");
    let plane_of_other = if other.revolute {
        let direction = {
            let [first, second] = across_o;
            let [nx, ny] = normal;
            let (p, q) = (c.g.scale3(nx, first), c.g.scale3(ny, second));
            c.g.add3(p, q)
        };
        let dot = c.g.dot3(direction, other.origin);
        let k = c.g.neg(dot);
        let row = other.row(c, direction, k);
        other.offset(c, row, value, Branching::Shoulder, meaning);
        let point = other.point(c);
        let from = c.g.sub3(point, other.origin);
        across_o.map(|direction| c.g.dot3(direction, from))
    } else {
        let still_o = still(c, other, across_o);
        let direction_o = across_o.map(|direction| signed(c, other, Side::along(direction)));
        let slope = c.g.dot2(normal, direction_o);
        let constant = c.g.dot2(normal, still_o);
        let numerator = c.g.sub(value, constant);
        c.slide_to(other.joint, slope, numerator, meaning);
        let position = c.position(other.joint);
        let [ox, oy] = direction_o;
        let moved = [c.g.mul(ox, position), c.g.mul(oy, position)];
        let ([px, py], [qx, qy]) = (still_o, moved);
        [c.g.add(px, qx), c.g.add(py, qy)]
    };
    let ([px, py], [qx, qy]) = (plane_of_other, still_s);
    let difference = [c.g.sub(px, qx), c.g.sub(py, qy)];
    let numerator = c.g.dot2(direction, difference);
    let denominator = c.g.dot2(direction, direction);
    let meaning = format!("Joint {n}: the difference along its stroke.");
    c.slide_to(slides.joint, denominator, numerator, meaning);
}
