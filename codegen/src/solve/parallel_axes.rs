//! The outer joints x, y, z when the triple's axes are parallel, with common direction h.
//!
//! Seen from joint y over either side: `R_z(y) b(z) = a(x)` for the direction h, and equal distances along h between
//! the triple and joint y's axis. The components along y's axis and those distances are two equations in x and z.

use super::kernel::{Aim, Flip, Pair, Unit};
use super::loop_closure::LoopClosure;
use super::plan::Branching;
use super::sides::{self, Side, from_intersection};
use super::sinusoid::Sinusoid;
use super::unsupported::Unsupported;
use crate::model::Angle;
use crate::symbolic::{Expr, Label, Vec3};

const H: &str = "the direction of the parallel axes";

/// Adds the stages for x, z and y.
pub fn outer(c: &mut LoopClosure) -> Result<(), Unsupported> {
    let [first, second, third, _, y, z] = c.order;
    let (link_a, link_b) = (c.link(first), c.link(second));
    let (link_c, link_z) = (c.link(third), c.link(z));
    // h in the frames of joints a, b and c, from one of them that turns. Prismatic joints move across h.
    let upright = [Expr::ZERO, Expr::ZERO, Expr::ONE];
    let (h_a, h_c) = if c.is_revolute(first) {
        let h_b = c.g.apply3(&link_a.back.r, upright);
        (upright, c.g.apply3(&link_b.back.r, h_b))
    } else if c.is_revolute(second) {
        (link_a.forward.z(), c.g.apply3(&link_b.back.r, upright))
    } else {
        let h_b = link_b.forward.z();
        (c.g.apply3(&link_a.forward.r, h_b), upright)
    };
    let (h_a, h_c) = (c.clean3(h_a, Unit::Direction), c.clean3(h_c, Unit::Direction));
    let h = c.g.apply3(&link_c.back.r, h_c);
    // How far the origin of c is from that of a along h.
    let from_a = link_a.forward.point(&mut c.g, link_b.forward.p);
    let rise = c.g.dot3(h_a, from_a);
    let moved_b = c.g.apply3(&link_z.forward.r, h_a);
    let [a, b] = sides::both(c, [h, moved_b], Unit::Direction);
    let height_c = c.g.dot3(a.moved, link_c.back.p);
    let height_a = c.g.sub(height_c, rise);
    let height_b = c.g.dot3(b.moved, link_z.forward.p);
    let heights = [c.clean(height_a, Unit::Length), c.clean(height_b, Unit::Length)];
    if c.is_revolute(y) { turning(c, y, [a, b], heights) } else { sliding(c, y, [a, b], heights) }
}

/// `-origin . (turned h) + height`: the distance along h from y's origin to the triple. For a prismatic joint the slope
/// is in `c`.
fn distance_row(c: &mut LoopClosure, side: &Side, height: Expr) -> Sinusoid {
    let back = side.origin.map(|e| c.g.neg(e));
    if side.revolute {
        let row = side.row(c, back, height);
        return Sinusoid { c: c.clean(row.c, Unit::Length), s: c.clean(row.s, Unit::Length), k: row.k };
    }
    let dot = c.g.dot3(back, side.moved);
    let slope = Side::along(side.moved);
    let slope = if side.undone { c.g.neg(slope) } else { slope };
    Sinusoid { c: slope, s: Expr::ZERO, k: c.g.add(dot, height) }
}

fn direction_row(c: &mut LoopClosure, side: &Side) -> Sinusoid {
    if side.revolute {
        return side.row(c, side.axis, Expr::ZERO);
    }
    Sinusoid { c: Expr::ZERO, s: Expr::ZERO, k: c.g.dot3(side.axis, side.moved) }
}

/// h over one (solved) side, in the frame of joint y.
fn seen(c: &mut LoopClosure, side: &Side) -> Vec3 {
    let [_, _, _, x, y, _] = c.order;
    let direction = side.direction(c);
    let rigid = if side.undone { c.link(x).back } else { c.link(y).forward };
    let seen = c.g.apply3(&rigid.r, direction);
    c.g.name_each(&seen, &format!("h{}_", c.label(side.joint)));
    seen
}

/// Tells whether the joint of a side enters two quantities: the distance along h, and the component of h along y's
/// axis.
fn enters(c: &LoopClosure, side: &Side) -> (bool, bool) {
    let turned = side.revolute && !c.vanish(&Side::plane(side.moved), Unit::Direction);
    let distance = if side.revolute {
        turned && !c.vanish(&Side::plane(side.origin), Unit::Length)
    } else {
        !c.vanish(&[Side::along(side.moved)], Unit::Direction)
    };
    (distance, turned && !c.vanish(&Side::plane(side.axis), Unit::Direction))
}

fn turning(c: &mut LoopClosure, y: usize, sides: [Side; 2], heights: [Expr; 2]) -> Result<(), Unsupported> {
    let ny = c.label(y);
    for with_a in [true, false] {
        let sides = from_intersection(c, sides, with_a).unwrap_or(sides);
        let [a, b] = &sides;
        let (still, other) = if with_a { (a, b) } else { (b, a) };
        let (distance_still, direction_still) = enters(c, still);
        let (distance_other, _) = enters(c, other);
        if !distance_still && distance_other && direction_still {
            by_distance(c, other, (still, false), heights, ny);
            if !flipped(c, y, still, other) {
                by_direction(c, still, other, ny);
                aligned(c, y, a, b);
            }
            return Ok(());
        }
    }
    let [a, b] = &sides;
    let ((distance_a, direction_a), (distance_b, direction_b)) = (enters(c, a), enters(c, b));
    for (first, other, first_turns_h, other_turns_h, other_distance) in
        [(b, a, direction_b, direction_a, distance_a), (a, b, direction_a, direction_b, distance_b)]
    {
        if first_turns_h && !other_turns_h && other_distance {
            by_direction(c, first, other, ny);
            by_distance(c, other, (first, true), heights, ny);
            aligned(c, y, a, b);
            return Ok(());
        }
    }
    if !(a.revolute && b.revolute && direction_a && direction_b && (distance_a || distance_b)) {
        return Err(Unsupported::new(format!(
            "the arm is singular everywhere: joints {}, {ny} and {} leave {H} or its distance unchanged",
            c.label(a.joint),
            c.label(b.joint)
        )));
    }
    let rows = sides.map(|side| direction_row(c, &side).array());
    let mut heights = heights.into_iter();
    let distances = sides.map(|side| {
        let height = heights.next().unwrap_or(Expr::ZERO);
        distance_row(c, &side, height).array()
    });
    let ([p2, q2], [p1, q1]) = (rows, distances);
    let [_, _, _, x, y, _] = c.order;
    let links = [c.link(x).forward, c.link(y).back];
    let across = [(a, links[0]), (b, links[1])]
        .map(|(side, link)| [0, 1].map(|axis| side.row(c, link.axis(axis), Expr::ZERO).array()));
    let meaning = format!(
        "Joints {} and {} together: {H} has equal components along axis {ny}, and equal distances from it.",
        c.label(a.joint),
        c.label(b.joint)
    );
    let joints = [(a.joint, Angle::ZERO), (b.joint, Angle::ZERO)];
    let kernel = Pair { p: [p1, p2], q: [q1, q2], across: Some(across), power: 1 };
    c.stage(&joints, Unit::Length, Branching::Root, meaning, kernel);
    aligned(c, y, a, b);
    Ok(())
}

/// One joint from the distance along h. The other joint is solved already, or does not enter.
fn by_distance(c: &mut LoopClosure, side: &Side, (other, solved): (&Side, bool), heights: [Expr; 2], ny: Label) {
    let [height_a, height_b] = heights;
    let (own, others) = if side.undone { (height_a, height_b) } else { (height_b, height_a) };
    let row = distance_row(c, side, own);
    let value = if solved {
        let turned = other.direction(c);
        let dot = c.g.dot3(other.origin, turned);
        c.g.sub(others, dot)
    } else {
        distance_row(c, other, others).k
    };
    let value = c.clean(value, Unit::Length);
    let n = c.label(side.joint);
    if side.revolute {
        let meaning = format!("Joint {n}: axis {ny} keeps its offset along {H}, `{{a}} cos + {{b}} sin = {{d}}`.");
        side.offset(c, row, value, Branching::Shoulder, meaning);
    } else {
        let numerator = c.g.sub(value, row.k);
        c.slide_to(side.joint, row.c, numerator, format!("Joint {n}: axis {ny} keeps its offset along {H}."));
    }
}

/// One joint from the component of h along y's axis, the other side being known.
fn by_direction(c: &mut LoopClosure, side: &Side, known: &Side, ny: Label) {
    let seen = seen(c, known);
    let rho = c.g.norm(&Side::plane(seen));
    c.g.name(rho, format!("across{}", c.label(side.joint)));
    let meaning = format!("Joint {}: {H} has the component `{{d}}` along axis {ny}{{shift}}.", c.label(side.joint));
    side.cone(c, Side::along(seen), rho, Unit::Direction, Branching::Wrist, meaning);
}

/// Joint y turns h as z leaves it onto h as x needs it.
fn aligned(c: &mut LoopClosure, y: usize, a: &Side, b: &Side) {
    let (from, to) = (seen(c, b), seen(c, a));
    let meaning = format!("Joint {}: turns {H} from `[{{from}}]` to `[{{to}}]`.", c.label(y));
    c.align(y, Side::plane(from), Side::plane(to), Unit::Direction, meaning);
}

/// Both joints at once, if h is at right angles to the inner joint, and that one to joint y. The two roots are half a turn
/// apart in y.
fn flipped(c: &mut LoopClosure, y: usize, inner: &Side, known: &Side) -> bool {
    let right_angles = [Side::along(inner.moved), Side::along(inner.axis)];
    if !c.vanish(&right_angles, Unit::Direction) {
        return false;
    }
    let [_, _, _, x, _, _] = c.order;
    // The link between the inner joint and y, from the inner joint's frame to y's (undone side) or the other way.
    let link = if inner.undone { c.link(x).forward } else { c.link(y).forward };
    // See the runtime's `flip` for the form solved.
    let (Some([phi, psi]), Ok(eta)) = (c.right_angle(&link), c.direction(Side::plane(inner.moved))) else {
        return false;
    };
    let quarter = Angle::degrees(90.0);
    let seen = seen(c, known);
    let [hx, hy, hz] = seen;
    let (m, shift) = if inner.undone {
        // h = R_z(-y) R_z(psi - 90) R_y(eta - phi - x) e_z, mirrored so that both angles count forward.
        let turn = c.g.turn(psi.add(quarter));
        let mirrored = [hx, c.g.neg(hy), hz];
        (c.g.rotate_z(turn, mirrored), eta.add(phi.neg()))
    } else {
        // h = R_z(y) R_z(phi - 90) R_y(z + eta - psi) e_z
        let turn = c.g.turn(quarter.add(phi.neg()));
        (c.g.rotate_z(turn, seen), psi.add(eta.neg()))
    };
    let (n, ny) = (c.label(inner.joint), c.label(y));
    let meaning =
        format!("Joints {n} and {ny}: point {H}, `[{{m}}]` = `R_z(y) R_y(x) e_z`; with `x = 0` joint {ny} is free.");
    let joints = [(inner.joint, shift), (y, Angle::ZERO)];
    c.stage(&joints, Unit::Direction, Branching::Wrist, meaning, Flip { m });
    true
}

/// Joint y is prismatic: h itself is equal on both sides, and lies on a cone about either revolute axis. The displacement
/// closes the distance along h.
fn sliding(c: &mut LoopClosure, y: usize, sides: [Side; 2], heights: [Expr; 2]) -> Result<(), Unsupported> {
    let [a, b] = &sides;
    let ny = c.label(y);
    if !(a.revolute && b.revolute) {
        return Err(Unsupported::new(format!(
            "the arm is singular everywhere: with joints {ny} and {} sliding, {H} has too few joints to turn it",
            if a.revolute { c.label(b.joint) } else { c.label(a.joint) }
        )));
    }
    let [_, _, _, x, _, _] = c.order;
    let frames = [c.link(x).forward.r, c.link(y).back.r];
    let meaning = format!(
        "Joints {} and {} together: {H} is the same over either side of the sliding joint {ny}.",
        c.label(a.joint),
        c.label(b.joint)
    );
    let joints = [(a.joint, Angle::ZERO), (b.joint, Angle::ZERO)];
    let kernel = Aim { moved: [a.moved, b.moved], frames };
    c.stage(&joints, Unit::Direction, Branching::Shoulder, meaning, kernel);
    let (over_a, over_b) = (a.direction(c), b.direction(c));
    let [height_a, height_b] = heights;
    let left = {
        let dot = c.g.dot3(a.origin, over_a);
        c.g.sub(height_a, dot)
    };
    let right = {
        let dot = c.g.dot3(b.origin, over_b);
        c.g.sub(height_b, dot)
    };
    let numerator = c.g.sub(left, right);
    let denominator = c.g.dot3(a.axis, over_a);
    let meaning = format!("Joint {ny}: closes the distance along {H}.");
    c.slide_to(y, denominator, numerator, meaning);
    Ok(())
}
