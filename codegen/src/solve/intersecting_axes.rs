//! The outer joints x, y, z when the axes of the triple intersect in a point W.
//!
//! `R_z(y) B(z) = A(x)`, where A and B are the point W seen from joint y over either side. The components along y's axis
//! are equal, and so are the distances from a point on it: two equations in x and z.

use super::kernel::{Pair, PairSliding, Quadratic, Unit};
use super::loop_closure::{LoopClosure, WRIST};
use super::plan::Branching;
use super::prismatic_pair::{one_slides, still_rows};
use super::sides::{self, Side, from_intersection};
use super::sinusoid::Sinusoid;
use super::unsupported::Unsupported;
use crate::model::Angle;
use crate::symbolic::{Expr, Label, Vec3};

/// Adds the stages for x, z and y.
pub fn outer(c: &mut LoopClosure) -> Result<(), Unsupported> {
    let [_, _, third, _, y, z] = c.order;
    let [a, b] = sides::both(c, [c.link(third).back.p, c.link(z).forward.p], Unit::Length);
    let center = if c.center() == WRIST { "wrist" } else { "tool" };
    for (e, axis) in a.moved.iter().chain(&b.moved).zip(["x", "y", "z"].iter().cycle()) {
        c.g.rename(*e, format!("{center}_{axis}"));
    }
    if c.is_revolute(y) { turning(c, y, a, b) } else { sliding(c, y, a, b) }
}

fn turning(c: &mut LoopClosure, y: usize, a: Side, b: Side) -> Result<(), Unsupported> {
    let w = c.center();
    let (moves_a, moves_b) = (a.moves_along(c, a.axis), b.moves_along(c, b.axis));
    let (nx, ny, nz) = (c.label(a.joint), c.label(y), c.label(b.joint));
    let (a, b) = if !moves_a && !moves_b {
        return Err(Unsupported::new(format!(
            "the arm is singular everywhere: joints {nx}, {ny} and {nz} all move {w} across one direction only"
        )));
    } else if !moves_b {
        first_by_component(c, &a, &b, ny);
        (a, b)
    } else if !moves_a {
        first_by_component(c, &b, &a, ny);
        (a, b)
    } else if let Some([a, b]) = from_intersection(c, [a, b], true) {
        second_by_distance(c, &a, &b, ny);
        (a, b)
    } else if let Some([a, b]) = from_intersection(c, [a, b], false) {
        second_by_distance(c, &b, &a, ny);
        (a, b)
    } else {
        together(c, &a, &b, ny)?;
        (a, b)
    };
    let (from, to) = (seen(c, &b), seen(c, &a));
    let meaning = format!(
        "Joint {ny}: turns {w} as seen over joint {nz}, `[{{from}}]`, onto where joint {nx} puts it, `[{{to}}]`."
    );
    c.align(y, Side::plane(from), Side::plane(to), Unit::Length, meaning);
    Ok(())
}

/// W in the frame of joint y, over one (solved) side.
fn seen(c: &mut LoopClosure, side: &Side) -> Vec3 {
    let [_, _, _, x, y, _] = c.order;
    let point = side.point(c);
    let rigid = if side.undone { c.link(x).back } else { c.link(y).forward };
    // The origin may have been moved along y's axis; components across it are the same.
    let seen = rigid.point(&mut c.g, point);
    let name = if side.undone { "over" } else { "reach" };
    c.g.name_each(&seen, &format!("{name}_"));
    seen
}

/// W over one solved side relative to the side's origin: components across y's axis, and along it.
fn relative(c: &mut LoopClosure, side: &Side) -> ([Expr; 2], Expr) {
    let [_, _, _, x, y, _] = c.order;
    let point = side.point(c);
    let from = c.g.sub3(point, side.origin);
    let rigid = if side.undone { c.link(x).back } else { c.link(y).forward };
    let seen = c.g.apply3(&rigid.r, from);
    let name = if side.undone { "over" } else { "reach" };
    c.g.name_each(&seen, &format!("{name}_"));
    (Side::plane(seen), Side::along(seen))
}

/// The component along y's axis as a row of the side's joint; for a prismatic joint the slope in `c`.
fn component(c: &mut LoopClosure, side: &Side) -> Sinusoid {
    let k = {
        let dot = c.g.dot3(side.axis, side.origin);
        c.g.neg(dot)
    };
    if side.revolute {
        let row = side.row(c, side.axis, k);
        return Sinusoid { c: row.c, s: row.s, k: c.clean(row.k, Unit::Length) };
    }
    let dot = c.g.dot3(side.axis, side.moved);
    let constant = c.g.add(dot, k);
    let slope = Side::along(side.axis);
    let slope = if side.undone { c.g.neg(slope) } else { slope };
    Sinusoid { c: slope, s: Expr::ZERO, k: c.clean(constant, Unit::Length) }
}

/// The component along y's axis does not depend on `other`: `first` follows from it, then `other` from the distance
/// to y's axis.
fn first_by_component(c: &mut LoopClosure, first: &Side, other: &Side, ny: Label) {
    let w = c.center();
    let row = component(c, first);
    let value = component(c, other).k;
    let n = c.label(first.joint);
    let meaning = format!("Joint {n}: {w} keeps its offset along axis {ny}, `{{a}} cos + {{b}} sin = {{d}}`.");
    if first.revolute {
        first.offset(c, row, value, Branching::Shoulder, meaning);
    } else {
        let numerator = c.g.sub(value, row.k);
        let meaning = format!("Joint {n}: {w} keeps its offset along axis {ny}.");
        c.slide_to(first.joint, row.c, numerator, meaning);
    }
    let (across, _) = relative(c, first);
    let rho = c.g.norm(&across);
    c.g.name(rho, format!("rho{}", c.label(other.joint)));
    let m = c.label(other.joint);
    if other.revolute {
        let meaning = format!(
            "Joint {m}: {w} is `{{rho}}` from axis {ny}, `{{rho}}^2 = a^2 + b^2 + 2 a b cos(t)` with \
             `a = {{a}}`, `b = {{b}}`{{shift}}."
        );
        other.distance(c, rho, true, meaning);
    } else {
        let meaning = format!("Joint {m}: slides until {w} is `{{rho}}` from axis {ny}.");
        other.slide(c, rho, true, meaning);
    }
}

/// The distance from the intersection does not depend on `still`: `other` follows from it, then `still` from the
/// component along y's axis.
fn second_by_distance(c: &mut LoopClosure, still: &Side, other: &Side, ny: Label) {
    let w = c.center();
    let from = c.g.sub3(still.moved, still.origin);
    let from = c.clean3(from, Unit::Length);
    let rho = c.g.norm(&from);
    c.g.name(rho, format!("rho{}", c.label(other.joint)));
    let (n, m) = (c.label(still.joint), c.label(other.joint));
    let place = format!("the point where axes {} and {} meet", n.min(ny), n.max(ny));
    if other.revolute {
        let meaning = format!(
            "Joint {m}: {w} is `{{rho}}` from {place}, \
             `{{rho}}^2 = a^2 + b^2 + h^2 + 2 a b cos(t)` with `a = {{a}}`, `b = {{b}}`, `h = {{h}}`{{shift}}."
        );
        other.distance(c, rho, false, meaning);
    } else {
        let meaning = format!("Joint {m}: slides until {w} is `{{rho}}` from {place}.");
        other.slide(c, rho, false, meaning);
    }
    let (across, d) = relative(c, other);
    let rho = c.g.norm(&across);
    c.g.name(rho, format!("across{n}"));
    let meaning = format!("Joint {n}: {w} has the component `{{d}}` along axis {ny}{{shift}}.");
    still.cone(c, d, rho, Unit::Length, Branching::Shoulder, meaning);
}

/// Neither equation separates: a pair.
fn together(c: &mut LoopClosure, a: &Side, b: &Side, ny: Label) -> Result<(), Unsupported> {
    let (rows_a, rows_b) = (component(c, a), component(c, b));
    let (n, m) = (c.label(a.joint), c.label(b.joint));
    let meaning = format!("Joints {n} and {m} together: equal components along axis {ny}, equal distances from it.");
    if a.revolute && b.revolute {
        let (square_a, square_b) = (square(c, a), square(c, b));
        let across = across_rows(c, [a, b]);
        let (p, q) = ([rows_a.array(), square_a.array()], [rows_b.array(), square_b.array()]);
        let kernel = Pair { p, q, across: Some(across), power: 3 };
        let joints = [(a.joint, Angle::ZERO), (b.joint, Angle::ZERO)];
        c.stage(&joints, Unit::Length, Branching::Root, meaning, kernel);
        return Ok(());
    }
    // Of two prismatic joints the one is eliminated whose slope vanishes at no target.
    let b_first = a.revolute || !b.revolute && c.g.constant(rows_a.c).is_none();
    let (slides, other, row, other_row) = if b_first { (b, a, rows_b, rows_a) } else { (a, b, rows_a, rows_b) };
    // slope s + k = other's component: s = (component - k) / slope
    let [m1, n1] = displacement_square(c, slides);
    if other.revolute {
        let square = square(c, other);
        let k = c.g.sub(other_row.k, row.k);
        let [across_a, across_b] = across(c);
        let (across_s, across_o) = if a.revolute { (across_b, across_a) } else { (across_a, across_b) };
        let sliding = across_s.map(|direction| {
            let from = c.g.sub3(slides.moved, slides.origin);
            let factor = Side::along(direction);
            [if slides.undone { c.g.neg(factor) } else { factor }, c.g.dot3(direction, from)]
        });
        let turning = still_rows(c, other, across_o, [Expr::ZERO; 2]);
        let kernel = PairSliding {
            line: [other_row.c, other_row.s, k],
            scale: row.c,
            square: [m1, n1],
            q: square.array(),
            sliding,
            turning,
        };
        let joints = [(slides.joint, Angle::ZERO), (other.joint, Angle::ZERO)];
        c.stage(&joints, Unit::Length, Branching::Root, meaning, kernel);
        return Ok(());
    }
    // Both are prismatic: u = slides, v = other; slope_u u + k_u = slope_v v + k_v, u^2 + m u + n = v^2 + m' v + n'.
    let [m2, n2] = displacement_square(c, other);
    let (su, sv) = (row.c, other_row.c);
    let k = c.g.sub(other_row.k, row.k);
    // u = (sv v + k) / su, multiplied through by su^2.
    let (su2, sv2) = (c.g.mul(su, su), c.g.mul(sv, sv));
    let quadratic = c.g.sub(sv2, su2);
    if c.vanish(&[quadratic, k], Unit::Direction) {
        return Err(Unsupported::new("the two sliding joints move in step: the arm is singular everywhere"));
    }
    // 2 sv k + m su sv - m' su^2, and k^2 + m su k + (n - n') su^2
    let svk = c.g.mul(sv, k);
    let twice = c.g.add(svk, svk);
    let msu = c.g.mul(m1, su);
    let linear = {
        let left = c.g.mul(msu, sv);
        let left = c.g.add(twice, left);
        let right = c.g.mul(m2, su2);
        c.g.sub(left, right)
    };
    let constant = {
        let difference = c.g.sub(n1, n2);
        let scaled = c.g.mul(difference, su2);
        let sum = c.g.dot2([k, msu], [k, k]);
        c.g.add(sum, scaled)
    };
    let meaning =
        format!("Joint {}: equal components along axis {ny} and equal distances from it.", c.label(other.joint));
    let kernel = Quadratic { coefficients: [c.clean(quadratic, Unit::Direction), linear, constant] };
    c.stage(&[(other.joint, Angle::ZERO)], Unit::Length, Branching::Root, meaning, kernel);
    let v = c.position(other.joint);
    // The quadratic was multiplied by su^2; of the two equations it comes from: sv (2 u + m) - su (2 v + m').
    let pivot = {
        let u = c.position(slides.joint);
        let slope = |c: &mut LoopClosure, factor: Expr, position: Expr, m: Expr| {
            let twice = c.g.add(position, position);
            let sum = c.g.add(twice, m);
            c.g.mul(factor, sum)
        };
        let (own, others) = (slope(c, sv, u, m1), slope(c, su, v, m2));
        c.g.sub(own, others)
    };
    c.pivot(pivot);
    let svv = c.g.mul(sv, v);
    let numerator = c.g.add(svv, k);
    c.slide_to(slides.joint, su, numerator, format!("Joint {}: follows from it.", c.label(slides.joint)));
    Ok(())
}

/// The two directions across y's axis, as the frames of joint x and of joint z see them.
fn across(c: &LoopClosure) -> [[Vec3; 2]; 2] {
    let [_, _, _, x, y, _] = c.order;
    [c.link(x).forward, c.link(y).back].map(|link| [link.axis(0), link.axis(1)])
}

/// The components of W across y's axis, from y's axis, as rows of either (revolute) side.
fn across_rows(c: &mut LoopClosure, sides: [&Side; 2]) -> [[[Expr; 3]; 2]; 2] {
    let mut directions = across(c).into_iter();
    sides.map(|side| {
        directions.next().unwrap_or([[Expr::ZERO; 3]; 2]).map(|direction| {
            let dot = c.g.dot3(direction, side.origin);
            let k = c.g.neg(dot);
            side.row(c, direction, k).array()
        })
    })
}

/// `|moved - origin|^2` as a row of the side's (revolute) joint.
fn square(c: &mut LoopClosure, side: &Side) -> Sinusoid {
    let (mm, oo) = (c.g.dot3(side.moved, side.moved), c.g.dot3(side.origin, side.origin));
    let k = c.g.add(mm, oo);
    let two = c.g.number(-2.0);
    let doubled = c.g.scale3(two, side.origin);
    side.row(c, doubled, k)
}

/// `|moved +- s e_z - origin|^2 = s^2 + m s + n` for a prismatic joint.
fn displacement_square(c: &mut LoopClosure, side: &Side) -> [Expr; 2] {
    let from = c.g.sub3(side.moved, side.origin);
    let two = c.g.number(if side.undone { -2.0 } else { 2.0 });
    [c.g.mul(two, Side::along(from)), c.g.dot3(from, from)]
}

/// Which of two equations has nothing of a joint in it, but something of the other.
fn row_of_one(c: &LoopClosure, rows: &[[Expr; 3]; 2], others: &[[Expr; 3]; 2]) -> Option<usize> {
    let moves = |[cos, sin, _]: &[Expr; 3]| !c.vanish(&[*cos, *sin], Unit::Length);
    rows.iter().zip(others).position(|(row, other)| !moves(row) && moves(other))
}

/// The first joint from the equation that is its own, the second from the other one.
fn one_after_the_other(
    c: &mut LoopClosure,
    [first, second]: [&Side; 2],
    [own, others]: [[[Expr; 3]; 2]; 2],
    alone: usize,
    ny: Label,
) {
    let w = c.center();
    let row = |rows: [[Expr; 3]; 2], i: usize| {
        let [cos, sin, k] = rows.into_iter().nth(i).unwrap_or([Expr::ZERO; 3]);
        Sinusoid { c: cos, s: sin, k }
    };
    let meaning =
        |n: Label| format!("Joint {n}: {w} keeps its offset from axis {ny}, `{{a}} cos + {{b}} sin = {{d}}`.");
    let text = meaning(c.label(first.joint));
    first.offset(c, row(own, alone), row(others, alone).k, Branching::Shoulder, text);
    let ([known, wanted], pair) = ([own, others].map(|rows| row(rows, 1 - alone)), c.pair(first.joint));
    let turned = c.g.dot2([known.c, known.s], [pair.cos, pair.sin]);
    let value = c.g.add(turned, known.k);
    let text = meaning(c.label(second.joint));
    second.offset(c, wanted, value, Branching::Elbow, text);
}

/// Joint y is prismatic: the components across its axis are equal, and its displacement is the difference along it.
fn sliding(c: &mut LoopClosure, y: usize, a: Side, b: Side) -> Result<(), Unsupported> {
    let w = c.center();
    let (n, m, ny) = (c.label(a.joint), c.label(b.joint), c.label(y));
    let [across_a, across_b] = across(c);
    let meaning = format!("Joints {n} and {m} together: {w} has equal components across axis {ny}.");
    if a.revolute && b.revolute {
        let [p, q] = across_rows(c, [&a, &b]);
        if let Some(alone) = row_of_one(c, &p, &q) {
            one_after_the_other(c, [&b, &a], [q, p], alone, ny);
        } else if let Some(alone) = row_of_one(c, &q, &p) {
            one_after_the_other(c, [&a, &b], [p, q], alone, ny);
        } else {
            let joints = [(a.joint, Angle::ZERO), (b.joint, Angle::ZERO)];
            c.stage(&joints, Unit::Length, Branching::Root, meaning, Pair { p, q, across: None, power: 2 });
        }
    } else {
        one_slides(c, [&a, &b], [across_a, across_b], ny);
    }
    let (from, to) = (seen(c, &b), seen(c, &a));
    let numerator = c.g.sub(Side::along(to), Side::along(from));
    let meaning = format!("Joint {ny}: the difference along its axis.");
    c.slide_to(y, Expr::ONE, numerator, meaning);
    Ok(())
}
