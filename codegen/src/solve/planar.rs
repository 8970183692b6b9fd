//! A closed loop in a plane: three joints, revolute about parallel axes or prismatic across them.
//!
//! `J_0 L_0 J_1 L_1 J_2 L_2 = 1`, read cyclically. The target is part of one of the links.

use super::kernel::Unit;
use super::loop_closure::{Link, LoopClosure};
use super::plan::{PlanStep, Value};
use super::sides::Side;
use super::unsupported::Unsupported;
use crate::model::Angle;
use crate::symbolic::{Expr, Label, Rigid, Symbol, transpose};

/// A turn in the plane, as a sum of known angles: `R_z(sum)`, then a half turn about x if `flipped`.
struct InPlane {
    sum: Value,
    flipped: bool,
}

/// Adds the stages of the three joints.
///
/// # Errors
/// If two prismatic joints are parallel, or none of the joints is revolute.
pub fn solve(c: &mut LoopClosure, slots: [usize; 3], links: [Link; 3]) -> Result<(), Unsupported> {
    let ([j0, j1, j2], [l0, l1, l2]) = (slots, links);
    let turns = slots.map(|slot| c.is_revolute(slot));
    // Read from another joint on, so that a prismatic joint stands in a fixed place.
    match turns {
        [true, true, true] => elbow(c, slots, links),
        [true, false, true] => prismatic_between(c, slots, links),
        [false, true, true] => prismatic_between(c, [j2, j0, j1], [l2, l0, l1]),
        [true, true, false] => prismatic_between(c, [j1, j2, j0], [l1, l2, l0]),
        [true, false, false] => return two_prismatic(c, slots, links),
        [false, true, false] => return two_prismatic(c, [j1, j2, j0], [l1, l2, l0]),
        [false, false, true] if !c.is_own(j2) => return two_prismatic_to_point(c, [j0, j1], [l0, l1], l2.back.p),
        [false, false, true] => return two_prismatic(c, [j2, j0, j1], [l2, l0, l1]),
        [false, false, false] => {
            return Err(Unsupported::new("no joint turns the tool in the plane"));
        }
    }
    Ok(())
}

/// Two links: the law of cosines, then the direction.
fn elbow(c: &mut LoopClosure, [first, second, third]: [usize; 3], [link_a, link_b, link_c]: [Link; 3]) {
    let m = link_c.back;
    let (na, nb, nc) = (c.label(first), c.label(second), c.label(third));
    let wrist = Side::plane(m.p);
    let place = if c.is_own(third) { format!("axis {nc}") } else { "the tool point".into() };
    let prefix = if c.is_own(third) { "wrist" } else { "tool" };
    for (e, axis) in wrist.iter().zip(["x", "y"]) {
        c.g.rename(*e, format!("{prefix}_{axis}"));
    }
    let rho = c.g.norm(&wrist);
    c.g.name(rho, format!("rho{nb}"));
    let meaning = format!(
        "Joint {nb}: {place} is `{{rho}}` from axis {na}, `{{rho}}^2 = a^2 + b^2 + 2 a b cos(t)` with \
         `a = {{a}}`, `b = {{b}}`{{shift}}."
    );
    let side = Side {
        joint: second,
        undone: false,
        revolute: true,
        moved: link_b.forward.p,
        origin: link_a.back.p,
        axis: link_a.back.z(),
    };
    side.distance(c, rho, true, meaning);
    let pair = c.pair(second);
    let turned = c.g.rotate_z(pair, link_b.forward.p);
    let reach = link_a.forward.point(&mut c.g, turned);
    c.g.name_each(&Side::plane(reach), "reach_");
    let meaning = format!("Joint {na}: turns {place} from `[{{from}}]` to `[{{to}}]`.");
    c.align(first, Side::plane(reach), wrist, Unit::Length, meaning);
    if !c.is_own(third) {
        return;
    }
    // a + ka + sa (b + kb + sb c) = total
    let name = format!("t{na}{nb}{nc}").into();
    let meaning = format!("Angles {na}, {nb} and {nc} together: the direction of frame {nc} in the plane.");
    let total = in_plane(c, &m, name, meaning);
    let part_a = in_plane(c, &link_a.forward, format!("turn{na}").into(), format!("The turn from joint {na} to {nb}."));
    let part_b = in_plane(c, &link_b.forward, format!("turn{nb}").into(), format!("The turn from joint {nb} to {nc}."));
    let negative_ab = part_a.flipped != part_b.flipped;
    // c = sb (sa (total - a - ka) - b - kb)
    let mut sum = Value::zero();
    sum.add(&total.sum, negative_ab);
    sum.add(&c.solved(first), !negative_ab);
    sum.add(&part_a.sum, !negative_ab);
    sum.add(&c.solved(second), !part_b.flipped);
    sum.add(&part_b.sum, !part_b.flipped);
    c.sum(third, sum);
}

/// A prismatic joint between two revolute ones: its displacement from the distance of their axes, then the direction.
fn prismatic_between(c: &mut LoopClosure, [first, slides, last]: [usize; 3], [link_a, link_b, link_c]: [Link; 3]) {
    let (na, nb, nc) = (c.label(first), c.label(slides), c.label(last));
    let to = Side::plane(link_c.back.p);
    let rho = c.g.norm(&to);
    c.g.name(rho, format!("rho{nb}"));
    let side = Side {
        joint: slides,
        undone: false,
        revolute: false,
        moved: c.clean3(link_b.forward.p, Unit::Length),
        origin: c.clean3(link_a.back.p, Unit::Length),
        axis: c.clean3(link_a.back.z(), Unit::Direction),
    };
    let place = |c: &LoopClosure, slot: usize, label: Label| {
        if c.is_own(slot) { format!("axis {label}") } else { "the tool point".into() }
    };
    let (place_a, place_c) = (place(c, first, na), place(c, last, nc));
    side.slide(c, rho, true, format!("Joint {nb}: slides until {place_c} is `{{rho}}` from {place_a}."));
    let along = c.position(slides);
    if c.is_own(first) {
        let [x, y, z] = link_b.forward.p;
        let moved = [x, y, c.g.add(z, along)];
        let from = link_a.forward.point(&mut c.g, moved);
        let meaning = format!("Joint {na}: turns {place_c} from `[{{from}}]` to `[{{to}}]`.");
        c.align(first, Side::plane(from), to, Unit::Length, meaning);
    }
    if !c.is_own(last) {
        return;
    }
    if !c.is_own(first) {
        let [x, y, z] = link_a.back.p;
        let moved = [x, y, c.g.sub(z, along)];
        let to = link_b.back.point(&mut c.g, moved);
        let meaning = format!("Joint {nc}: turns {place_a} from `[{{from}}]` to `[{{to}}]`.");
        c.align(last, Side::plane(link_c.forward.p), Side::plane(to), Unit::Length, meaning);
        return;
    }
    // a + k + s c = total
    let meaning = format!("Angles {na} and {nc} together: the direction of frame {nc} in the plane.");
    let total = in_plane(c, &link_c.back, format!("t{na}{nc}").into(), meaning);
    let between = link_a.forward.then(&mut c.g, &Rigid { p: [Expr::ZERO; 3], ..link_b.forward });
    let part = in_plane(c, &between, format!("turn{na}").into(), format!("The turn from joint {na} to {nc}."));
    // Both turn the axis around, or neither does. A constant link tells; the target tells only where it can be reached.
    let flipped = if link_c.target { part.flipped } else { total.flipped };
    let mut sum = Value::zero();
    sum.add(&total.sum, flipped);
    sum.add(&c.solved(first), !flipped);
    sum.add(&part.sum, !flipped);
    c.sum(last, sum);
}

/// Two prismatic joints: the revolute one gives the direction, and the displacements solve linear equations.
fn two_prismatic(
    c: &mut LoopClosure,
    [turns, j1, j2]: [usize; 3],
    [link_a, link_b, link_c]: [Link; 3],
) -> Result<(), Unsupported> {
    let (na, n1, n2) = (c.label(turns), c.label(j1), c.label(j2));
    let m = link_c.back;
    let still = link_a.forward.then(&mut c.g, &link_b.forward);
    if c.is_own(turns) {
        // R_z(a) (links) = M
        let alone = c.g.matmul(&m.r, &transpose(&still.r));
        let alone = Rigid { r: alone, p: [Expr::ZERO; 3] };
        let [[cos, ..], [sin, ..], _] = alone.r;
        let meaning = format!("Angle {na}: the direction of the tool in the plane.");
        let angle = in_plane(c, &alone, format!("t{na}").into(), meaning);
        c.known(turns, cos, sin);
        c.sum(turns, angle.sum);
    }
    if link_a.target {
        // Both stand before the revolute joint, which moves no point of its axis.
        return two_prismatic_to_point(c, [j1, j2], [link_b, link_c], link_a.back.p);
    }
    let at = c.move_back(turns, m.p);
    let left = c.g.sub3(at, still.p);
    let first = link_a.forward.z();
    let second = link_a.forward.then(&mut c.g, &link_b.forward).z();
    let [left, first, second] = [left, first, second].map(Side::plane);
    let denominator = c.g.cross2(first, second);
    if c.vanish(&[denominator], Unit::Direction) {
        return Err(Unsupported::new(format!(
            "the arm is singular everywhere: joints {n1} and {n2} slide along each other"
        )));
    }
    for (joint, label, numerator) in [(j1, n1, c.g.cross2(left, second)), (j2, n2, c.g.cross2(first, left))] {
        let meaning = format!("Joint {label}: slides by what is left in the plane.");
        c.slide_to(joint, denominator, numerator, meaning);
    }
    Ok(())
}

/// Two prismatic joints bring a point to its place: `d_0 e_z + L_0 (d_1 e_z + p_1) = point`, both along the plane.
fn two_prismatic_to_point(
    c: &mut LoopClosure,
    [j0, j1]: [usize; 2],
    [link_a, link_b]: [Link; 2],
    point: [Expr; 3],
) -> Result<(), Unsupported> {
    let (n0, n1) = (c.label(j0), c.label(j1));
    let still = link_a.forward.point(&mut c.g, link_b.forward.p);
    let left = c.g.sub3(point, still);
    let second = link_a.forward.z();
    let cosine = Side::along(second);
    let (along_first, along_second) = (Side::along(left), c.g.dot3(second, left));
    let squared = c.g.mul(cosine, cosine);
    let denominator = c.g.sub(Expr::ONE, squared);
    if c.vanish(&[denominator], Unit::Direction) {
        return Err(Unsupported::new(format!(
            "the arm is singular everywhere: joints {n0} and {n1} slide along each other"
        )));
    }
    for (joint, label, own, other) in [(j0, n0, along_first, along_second), (j1, n1, along_second, along_first)] {
        let across = c.g.mul(cosine, other);
        let numerator = c.g.sub(own, across);
        let meaning = format!("Joint {label}: slides by what is left in the plane.");
        c.slide_to(joint, denominator, numerator, meaning);
    }
    Ok(())
}

/// The turn that a link makes in the plane: constant, a known angle and a constant, or else measured.
fn in_plane(c: &mut LoopClosure, rigid: &Rigid, symbol: Symbol, meaning: String) -> InPlane {
    let [[x, ..], [y, ..], [.., z]] = rigid.r;
    let flipped = c.value(z).is_some_and(|z| z < 0.0);
    if let (Some(x), Some(y)) = (c.g.constant(x), c.g.constant(y)) {
        return InPlane { sum: Value { constant: Angle::of_vector(y, x), ..Value::zero() }, flipped };
    }
    if let Some((term, negative, constant)) = c.known_angle(y, x) {
        return InPlane { sum: Value { terms: vec![(term, negative)], constant }, flipped };
    }
    c.push(PlanStep::Angle { symbol: symbol.clone(), meaning, y, x });
    InPlane { sum: Value { terms: vec![(symbol, false)], constant: Angle::ZERO }, flipped }
}
