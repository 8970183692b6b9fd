//! The triple itself, once the joints outside it are known.

use super::kernel::{Cone, ConeRange, Unit, Wrist};
use super::loop_closure::{Link, LoopClosure};
use super::plan::Branching;
use super::planar;
use super::sides::Side;
use super::unsupported::Unsupported;
use crate::model::Angle;
use crate::symbolic::{Expr, Graph, Mat3, Pair, Rigid, Vec3, transpose};

/// An element of `M = (links and joints from c to the triple)^-1`, left to right.
#[derive(Debug, Clone, Copy)]
enum Element {
    Link(usize),
    Joint(usize),
}

/// `M = R_z(a) C_a R_z(b) C_b R_z(c)` for axes that intersect in a point: only the rotation counts.
pub fn intersecting(c: &mut LoopClosure) {
    let m = triple_rotation(c);
    let [first, second, third, ..] = c.order;
    rotation(c, &m, [first, second, third], Branching::Wrist);
}

/// Three joints that give the rotation `m`; `sides` is what their two solutions are called.
pub fn rotation(c: &mut LoopClosure, m: &Mat3, [first, second, third]: [usize; 3], sides: Branching) {
    let (link_a, link_b) = (c.link(first).forward, c.link(second).forward);
    let (na, nb, nc) = (c.label(first), c.label(second), c.label(third));
    let cosines = [Side::along(link_a.z()), Side::along(link_b.z())];
    if c.vanish(&cosines, Unit::Direction)
        && let (Some([fa, ba]), Some([fb, bb])) = (c.right_angle(&link_a), c.right_angle(&link_b))
    {
        // Each link is R_z(f) X R_z(-b), X the half turn about x + z. So M is
        // R_z(a + fa - 90) R_y(b + fb - ba) R_z(c + 90 - bb). The constant turns outside go to the other side.
        let quarter = Angle::degrees(90.0);
        let left = c.g.turn(quarter.add(fa.neg()));
        let right = c.g.turn(bb.add(quarter.neg()));
        let columns = transpose(m).map(|column| c.g.rotate_z(left, column));
        // R_z(t) on the right turns the rows by -t.
        let right = right.opposite(&mut c.g);
        let m = transpose(&columns).map(|row| c.g.rotate_z(right, row));
        let joints = [(first, Angle::ZERO), (second, ba.add(fb.neg())), (third, Angle::ZERO)];
        let meaning = format!(
            "Joints {na}, {nb}, {nc}: three axes at right angles in a point, `R_z(a) R_y(b) R_z(c)` equals the \
             remaining rotation; with `b = 0` joint {na} is free."
        );
        c.stage(&joints, Unit::Direction, sides, meaning, Wrist { m });
        return;
    }
    oblique(c, m, [first, second, third], [link_a, link_b], sides);
}

/// Axes at other angles: the middle joint from the cosine between the outer axes, then the outer ones.
fn oblique(
    c: &mut LoopClosure,
    m: &Mat3,
    [first, second, third]: [usize; 3],
    [link_a, link_b]: [Rigid; 2],
    sides: Branching,
) {
    let (na, nb, nc) = (c.label(first), c.label(second), c.label(third));
    let approach = m.map(Side::along);
    let rho = c.g.norm(&Side::plane(approach));
    c.g.name(rho, format!("across{nb}"));
    // e_z . C_a R_z(b) C_b e_z
    let axis = transpose(&link_a.r).map(Side::along);
    let moved = link_b.z();
    let (moved_plane, axis_plane) = (Side::plane(moved), Side::plane(axis));
    let range = ConeRange {
        along: Side::along(moved),
        across: c.g.norm(&moved_plane),
        cos: Side::along(axis),
        sin: c.g.norm(&axis_plane),
    };
    let (shift, about) = c.between(moved_plane, axis_plane);
    let kernel = Cone { d: Side::along(approach), rho, range, about };
    let meaning = format!("Joint {nb}: axes {na} and {nc} have the cosine `{{d}}`{{shift}}.");
    c.stage(&[(second, shift)], Unit::Direction, sides, meaning, kernel);
    // G = C_a R_z(b) C_b
    let pair = c.pair(second);
    let columns = [0, 1, 2].map(|j| {
        let column = c.g.rotate_z(pair, link_b.axis(j));
        c.g.apply3(&link_a.r, column)
    });
    let [gx, gy, gz] = columns;
    let meaning = format!("Joint {na}: turns axis {nc} where it has to point.");
    c.align(first, Side::plane(gz), Side::plane(approach), Unit::Direction, meaning);
    // R_z(c) = G^T R_z(-a) M, first column.
    let back = c.pair(first).opposite(&mut c.g);
    let normal = c.g.rotate_z(back, m.map(|[x, _, _]| x));
    let (cos, sin) = (c.g.dot3(gx, normal), c.g.dot3(gy, normal));
    let meaning = format!("Joint {nc}: what remains of the rotation.");
    c.align(third, [Expr::ONE, Expr::ZERO], [cos, sin], Unit::Direction, meaning);
}

/// The rotation the triple has to make, with joint turns about parallel axes added up.
fn triple_rotation(c: &mut LoopClosure) -> Mat3 {
    let elements = elements(c);
    let (mut parts, mut target) = (Vec::new(), 0);
    let mut index = 0;
    while let Some(element) = elements.get(index) {
        index += 1;
        match element {
            Element::Link(joint) => {
                let link = c.link(*joint);
                if link.target {
                    target = parts.len();
                }
                parts.push(Part::link(link.back.r, [Expr::ZERO; 3]));
            }
            Element::Joint(joint) if c.is_revolute(*joint) => {
                let pair = c.pair(*joint);
                // R_z(-p) K R_z(-q) = R_z(-p -+ q) K for a link K that keeps the axis parallel.
                if let (Some(Element::Link(between)), Some(Element::Joint(next))) =
                    (elements.get(index), elements.get(index + 1))
                    && let Some(sign) = keeps_parallel(c, *between)
                    && c.is_revolute(*next)
                {
                    let other = c.pair(*next);
                    let other = if sign < 0.0 { other.opposite(&mut c.g) } else { other };
                    let sum = pair.plus(&mut c.g, other);
                    let (low, high) = (c.label(*joint.min(next)), c.label(*joint.max(next)));
                    c.g.name(sum.sin, format!("s{low}{high}"));
                    c.g.name(sum.cos, format!("c{low}{high}"));
                    parts.push(Part::turn(c, sum, *joint));
                    parts.push(Part::link(c.link(*between).back.r, [Expr::ZERO; 3]));
                    index += 2;
                } else {
                    parts.push(Part::turn(c, pair, *joint));
                }
            }
            Element::Joint(_) => {}
        }
    }
    outward(c, &parts, target).r
}

/// An element as a transform, with the joint it turns by.
struct Part {
    rigid: Rigid,
    joint: Option<usize>,
}

impl Part {
    fn link(r: Mat3, p: Vec3) -> Part {
        Part { rigid: Rigid { r, p }, joint: None }
    }

    /// `R_z(-t)`
    fn turn(c: &mut LoopClosure, pair: Pair, joint: usize) -> Part {
        let back = pair.opposite(&mut c.g);
        Part { rigid: Rigid { r: c.g.rotation_z(back), p: [Expr::ZERO; 3] }, joint: Some(joint) }
    }
}

/// The product, from the target outward: what stands to its right first, then what stands to its left. The columns
/// are named after the frame whose axes they are, the rows after the frame they are seen in.
fn outward(c: &mut LoopClosure, parts: &[Part], target: usize) -> Rigid {
    let mut product = parts.get(target).map_or_else(Rigid::identity, |part| part.rigid);
    let mut vectors = ["n", "o", "a", "p"].map(String::from);
    for part in parts.iter().skip(target + 1) {
        product = product.then(&mut c.g, &part.rigid);
        if let Some(joint) = part.joint {
            vectors = ["x", "y", "z", "o"].map(|vector| format!("{vector}{joint}"));
        }
        name(c, &product, &vectors, "", part.joint.is_some());
    }
    let mut frame = String::new();
    for part in parts.iter().take(target).rev() {
        product = part.rigid.then(&mut c.g, &product);
        if let Some(joint) = part.joint {
            frame = c.label(joint).to_string();
        }
        name(c, &product, &vectors, &frame, part.joint.is_some());
    }
    product
}

/// `n_1x`: x of the vector n seen in frame 1; `tn_1x`: the same behind the twist of link 1.
fn name(c: &mut LoopClosure, rigid: &Rigid, vectors: &[String; 4], frame: &str, turned: bool) {
    for (column, vector) in transpose(&rigid.r).iter().chain([&rigid.p]).zip(vectors) {
        if turned {
            c.g.name_each(column, &format!("{vector}_{frame}"));
        }
        c.g.suggest_each(column, &format!("t{vector}_{frame}"));
    }
}

/// 1 or -1 if a link without the target keeps the joint axis parallel or anti-parallel.
fn keeps_parallel(c: &LoopClosure, joint: usize) -> Option<f64> {
    let link = c.link(joint);
    if link.target {
        return None;
    }
    let axis = link.forward.z();
    // Not by the cosine, which is 1 but for rounding at angles up to 1e-8.
    let parallel = c.vanish(&Side::plane(axis), Unit::Direction);
    c.value(Side::along(axis)).filter(|_| parallel).map(f64::signum)
}

/// Elements between the triple's last joint and its first, going back.
fn elements(c: &LoopClosure) -> Vec<Element> {
    let [.., third, _, _, _] = c.order;
    let outside = c.outside();
    let joints = outside.iter().rev().flat_map(|joint| [Element::Link(*joint), Element::Joint(*joint)]);
    joints.chain([Element::Link(third)]).collect()
}

/// The triple as a loop in its plane, closed by everything else.
///
/// # Errors
/// If the joints do not reach the plane.
pub fn parallel(c: &mut LoopClosure) -> Result<(), Unsupported> {
    let back = triple_rigid(c);
    let [first, second, third, ..] = c.order;
    let forward = back.inverse(&mut c.g);
    let rest = Link { forward, back, target: true };
    planar::solve(c, [first, second, third], [c.link(first), c.link(second), rest])
}

/// `M` with its translation. Only its part in the plane counts, so any point of axis c may be tracked. Without the length
/// along that axis the least arithmetic is left.
fn triple_rigid(c: &mut LoopClosure) -> Rigid {
    let [_, _, third, ..] = c.order;
    let (mut parts, mut target) = (Vec::new(), 0);
    for element in elements(c) {
        match element {
            Element::Link(joint) => {
                let link = c.link(joint);
                let mut p = link.back.p;
                if link.target {
                    target = parts.len();
                } else if joint == third && c.is_revolute(third) {
                    let along = c.g.scale3(Side::along(link.forward.p), link.back.z());
                    let moved = c.g.add3(p, along);
                    p = c.clean3(moved, Unit::Length);
                }
                parts.push(Part::link(link.back.r, p));
            }
            Element::Joint(joint) if c.is_revolute(joint) => {
                let pair = c.pair(joint);
                parts.push(Part::turn(c, pair, joint));
            }
            Element::Joint(joint) => {
                let along = c.position(joint);
                let back = c.g.neg(along);
                parts.push(Part::link(Graph::identity(), [Expr::ZERO, Expr::ZERO, back]));
            }
        }
    }
    outward(c, &parts, target)
}
