//! The axes of x and z parallel: the rotation gives the sum of both alone.

use core::ops::ControlFlow;

use super::branch::Posed;
use crate::branches::{Stream, bit, crossing, nearest_to_zero};
use crate::math::{Scalar, atan2, sin_cos, wrap};
use crate::pair::Pair;

/// The axes may be parallel near here: the sine of their angle.
const BESIDE: f64 = 1e-2;
/// They are parallel if the sine is less.
const ON: f64 = 1e-4;
/// They are parallel to rounding if the sine is less than so many roundings.
const ROUNDINGS: f64 = 64.0;
/// Angles of x at which the gap is looked at: it has harmonics up to the third.
const PLACES: u8 = 24;
/// The first of them, rad: no round one.
const FIRST: f64 = 0.2718;
/// A gap of so many roundings at all angles leaves x free.
const FREE_ROUNDINGS: f64 = 4096.0;

/// The candidates near an angle t where the axes of x and z are parallel. x follows from the gap: its component g out of
/// the plane of the slides is a function of x, with y at 0 or pi as the level tells, and z as the rotation.
///
/// Gives the angle where the axes are nearest to parallel, and true if they are so to rounding and nearly so at the root.
pub(super) fn parallel<T: Scalar>(
    stream: &mut Stream<'_, '_, T, Posed<'_, T>>,
    t: T,
) -> ControlFlow<(), Option<(T, bool)>> {
    let posed = stream.branches;
    let square = |sine: f64| T::from_f64(sine) * T::from_f64(sine);
    let across2 = |t: T| posed.across2(t);
    let at_root = across2(t);
    if at_root > square(BESIDE) {
        return ControlFlow::Continue(None);
    }
    let t = nearest_to_zero(&across2, &|t| across2(t).sqrt(), t);
    let nearest = across2(t);
    let rounding = T::from_f64(ROUNDINGS) * T::EPSILON;
    let is_complete = nearest <= rounding * rounding && at_root <= square(ON);
    if nearest > square(ON) || !stream.is_new_place(t) {
        return ControlFlow::Continue(Some((t, is_complete)));
    }
    let turn = sin_cos(t);
    // The root w of y is 0.
    let [cos_y, sin_y] = posed.parts(turn).y.map(|pair| pair.even);
    let y = atan2(sin_y, cos_y);
    let (sin_y, cos_y) = sin_cos(y);
    let real = |value: T| Pair::new(value, T::ZERO);
    let closure = |x: T| {
        let (sin, cos) = sin_cos(x);
        posed.closure(turn, &[real(cos), real(sin)], &[real(cos_y), real(sin_y)], T::ZERO)
    };
    let joints = |x: T| {
        let [t0, t1, t2, t3] = &posed.links;
        // z turns the first column of A2^-1 Rz(-y) A1^-1 Rz(-x) M.
        let (sin_x, cos_x) = sin_cos(x);
        let column = t0.inverse().turn(turned(t3.inverse().turn([T::ONE, T::ZERO, T::ZERO]), (-turn.0, turn.1)));
        let column = t1.inverse().turn(turned(column, (-sin_x, cos_x)));
        let [ahead, aside, _] = t2.inverse().turn(turned(column, (-sin_y, cos_y)));
        posed.in_chain_order([t, x, y, atan2(aside, ahead)].map(wrap), &closure(x), T::ZERO)
    };
    let miss = |x: T| closure(x).miss.even;
    let step = T::TAU / T::from_i32(i32::from(PLACES));
    let angle = |place: u8| T::from_f64(FIRST) + step * T::from_i32(i32::from(place));
    let greatest = (0..PLACES).fold(T::ZERO, |greatest, place| greatest.max(miss(angle(place)).abs()));
    if greatest <= T::from_f64(FREE_ROUNDINGS) * T::EPSILON {
        let [_, joint, ..] = posed.slides.turning;
        stream.offer_joints(joints(stream.reference_of(joint)), 0, bit(joint), true)?;
        return ControlFlow::Continue(Some((t, is_complete)));
    }
    for place in 0..PLACES {
        let [last, next] = [angle(place), angle(place + 1)].map(|x| (x, miss(x)));
        if last.1 * next.1 <= T::ZERO {
            stream.offer_joints(joints(crossing(&miss, last, next)), 0, 0, true)?;
        }
    }
    ControlFlow::Continue(Some((t, is_complete)))
}

/// `Rz(angle) vector`
fn turned<T: Scalar>([x, y, z]: [T; 3], (sin, cos): (T, T)) -> [T; 3] {
    [x * cos - y * sin, x * sin + y * cos, z]
}
