//! W on the axis of x2 or of x3: a joint that turns W about itself follows from the axes that meet there.

use core::ops::ControlFlow;

use super::branch::{Parts, Posed, Signed};
use super::joints::turned_back;
use crate::branches::{Stream, bit, nearest_to_zero};
use crate::math::{Scalar, atan2, hypot, sin_cos};

/// W is looked for on an axis if it is nearer than this share of the reach.
const BESIDE: f64 = 1e-2;
/// W is on an axis if it is nearer than this share of the reach.
const ON: f64 = 1e-4;
/// W is on an axis to rounding if it is nearer than so many roundings of the reach.
const ROUNDINGS: f64 = 64.0;
/// An amplitude below this turns nothing: the joint is free.
const FREE: f64 = 1e-9;

/// The candidates of [`Meet`](super::Meet).
type Candidates<'a, 'v, 'm, T> = Stream<'a, 'v, T, Posed<'m, T>>;

/// The candidates near an angle where W is on the axis of x2 or of x3. There are none elsewhere.
///
/// On the axis of x2, v is 0 and n, the direction of v, has to be at the angle alpha to the direction d of u, which x2
/// turns: `n . Rz(x2) d = cos alpha`. On the axis of x3 the elbow is folded, and x3 turns the direction of u.
///
/// Gives the angle where W is nearest to the axis, and true if W is on it to rounding and nearly so at the root.
pub(super) fn on_axes<T: Scalar>(
    stream: &mut Candidates<'_, '_, '_, T>,
    t: T,
    turn: (T, T),
) -> ControlFlow<(), Option<(T, bool)>> {
    let posed = stream.branches;
    let square = |share: T| {
        let length = share * posed.meet.reach;
        length * length
    };
    let beside = square(T::from_f64(BESIDE));
    let parts = posed.parts(turn);
    let nearest2 = parts.rho2.min(from_axis_of_x3(&parts, 0)).min(from_axis_of_x3(&parts, 1));
    if nearest2 > beside {
        return ControlFlow::Continue(None);
    }
    let rounding = T::from_f64(ROUNDINGS) * T::EPSILON * posed.meet.reach;
    let (on, exact) = (square(T::from_f64(ON)), rounding * rounding);
    let mut nearest = None;
    let from_x2 = |t: T| posed.parts(sin_cos(t)).rho2;
    let at_root = from_x2(t);
    if at_root <= beside {
        // W crosses the axis, or comes to it and goes back: the distance is an absolute value or a parabola.
        let t = nearest_to_zero(&from_x2, &|t| from_x2(t).sqrt(), t);
        let parts = posed.parts(sin_cos(t));
        nearest = Some((t, parts.rho2 <= exact && at_root <= on));
        if parts.rho2 <= on && stream.is_new_place(t) {
            for number in [0, 2] {
                let signed = posed.signed(&parts, number);
                on_x2(stream, t, &parts, number, signed.w)?;
                // An elbow that is nearly straight may be straight: its root w has half of the digits.
                let [_, w2] = signed.branch.squares;
                if number == 0 && signed.w != T::ZERO && w2 <= T::EPSILON.sqrt() {
                    on_x2(stream, t, &parts, number, T::ZERO)?;
                }
            }
        }
    }
    for number in [0, 1] {
        let from_x3 = |t: T| from_axis_of_x3(&posed.parts(sin_cos(t)), number);
        if from_x3(t) <= beside {
            // W crosses the axis, or comes to it where v vanishes, beyond which v is imaginary: a parabola or a simple root.
            let t = nearest_to_zero(&from_x3, &|t| from_x3(t) * from_x3(t), t);
            nearest = nearest.or(Some((t, false)));
            if from_x3(t).abs() <= on {
                on_x3(stream, t, &posed.parts(sin_cos(t)), number)?;
            }
        }
    }
    ControlFlow::Continue(nearest)
}

/// Distance of W from the axis of x3, squared, for the sign of v of a branch.
#[inline(never)]
fn from_axis_of_x3<T: Scalar>(parts: &Parts<T>, number: usize) -> T {
    let v = parts.v2.max(T::ZERO).sqrt();
    parts.distance2.at(if number & 1 == 0 { v } else { -v })
}

/// Returns true if W is on the axis of x2, nearly to rounding.
pub(super) fn is_on_x2<T: Scalar>(posed: &Posed<'_, T>, t: T) -> bool {
    let near = T::EPSILON.sqrt() * posed.meet.reach;
    posed.parts(sin_cos(t)).rho2 <= near * near
}

fn on_x2<T: Scalar>(
    stream: &mut Candidates<'_, '_, '_, T>,
    t: T,
    p: &Parts<T>,
    number: usize,
    w: T,
) -> ControlFlow<()> {
    let posed = stream.branches;
    let (m, turn) = (posed.meet, sin_cos(t));
    let branch = &Signed { v: T::ZERO, w, ..posed.signed(p, number) };
    let [nx, ny, nz] = posed.normal.at(turn);
    // The direction of u after x2: E along ex and ey, and the tilt along h.
    let (vx, vy) = (-m.across_x, p.across_y);
    let distance2 = p.distance2.at(T::ZERO);
    let high = distance2 + m.lower * m.lower - m.upper * m.upper;
    let (qx, qy) = (m.ratio_x * vx - m.ratio_y * vy, m.ratio_y * vx + m.ratio_x * vy);
    let half = T::HALF / distance2;
    let (e_x, e_y) = ((qx * high - qy * branch.w) * half, (qy * high + qx * branch.w) * half);
    let ([hx, hy], across) = (m.h_xy, m.eta * m.tilt - m.h_z * e_y);
    let (dx, dy, dz) = (hx * across - hy * e_x, hy * across + hx * e_x, m.eta * e_y + m.h_z * m.tilt);
    let turns = level(nx * dx + ny * dy, ny * dx - nx * dy, m.cos_alpha - nz * dz);
    let [_, joint, ..] = m.joints;
    let (angles, free) = match turns {
        Some(turns) => (turns.map(Some), 0),
        None => ([Some(stream.reference_of(joint)), None], bit(joint)),
    };
    angles.into_iter().flatten().try_for_each(|x2| {
        let joints = posed.joints_about(t, turn, p, branch, x2);
        stream.offer_joints(joints, number, free, true)
    })
}

fn on_x3<T: Scalar>(stream: &mut Candidates<'_, '_, '_, T>, t: T, p: &Parts<T>, number: usize) -> ControlFlow<()> {
    let posed = stream.branches;
    let (m, turn) = (posed.meet, sin_cos(t));
    let branch = posed.signed(p, number);
    let x2 = posed.x2(turn, p, branch.v);
    let [n_x, n_y, n_h] = posed.in_plane(turned_back(posed.normal.at(turn), sin_cos(x2)));
    // The direction of u across h, turned from that of the lower link, which the elbow of pi turns from the upper one.
    let (qx, qy) = (-m.ratio_x * m.lower, -m.ratio_y * m.lower);
    let turns = level(n_x * qx + n_y * qy, n_y * qx - n_x * qy, m.cos_alpha - n_h * m.tilt);
    let [_, _, joint, ..] = m.joints;
    let (angles, free) = match turns {
        Some(turns) => (turns.map(Some), 0),
        None => ([Some(stream.reference_of(joint) + m.x3_offset), None], bit(joint)),
    };
    angles.into_iter().flatten().try_for_each(|upper| {
        let joints = posed.joints_of_elbow(t, turn, x2, upper, T::PI);
        stream.offer_joints(joints, number, free, true)
    })
}

/// The two angles x with `a cos x + b sin x = c`, the nearest ones where there are none; `None` if a and b are 0.
fn level<T: Scalar>(a: T, b: T, c: T) -> Option<[T; 2]> {
    let length = hypot(a, b);
    if length <= T::from_f64(FREE) {
        return None;
    }
    let across = (length * length - c * c).max(T::ZERO).sqrt();
    let (middle, half) = (atan2(b, a), atan2(across, c));
    Some([middle + half, middle - half])
}
