//! Roots of two equations in two joints, from a point nearby.

use super::tolerances::Tolerances;
use super::turn::Turn;
use crate::math::wrap;

/// `a cos + b sin + k` as `[a, b, k]`.
pub type Row<T> = [T; 3];

/// A quantity as one joint moves it.
pub(super) trait Moving<T>: Copy {
    /// The joint after a step.
    fn step(turn: &Turn<T>, by: T) -> Turn<T>;
    /// How far one value of the joint is from another.
    fn between(turn: &Turn<T>, other: &Turn<T>) -> T;
    /// The quantity.
    fn at(&self, turn: &Turn<T>) -> T;
    /// Its derivative.
    fn slope(&self, turn: &Turn<T>) -> T;
    /// Its second derivative.
    fn curvature(&self, turn: &Turn<T>) -> T;
    /// The sum of its squared coefficients.
    fn square(&self) -> T;
}

impl<T: Tolerances> Moving<T> for Row<T> {
    fn step(turn: &Turn<T>, by: T) -> Turn<T> {
        let value = wrap(turn.value + by);
        let square = by * by;
        // The first terms of both series that are left out, of degrees 7 and 6, are below rounding.
        if !(square * square * square < T::EPSILON * T::from_f64(180.0)) {
            return Turn::at(value);
        }
        let (sixth, twelfth) = (square * T::from_f64(1.0 / 6.0), square * T::from_f64(1.0 / 12.0));
        let sin = by * (T::ONE - sixth * (T::ONE - square * T::from_f64(0.05)));
        let cos = T::ONE - square * T::HALF * (T::ONE - twelfth);
        Turn { value, sin: turn.sin * cos + turn.cos * sin, cos: turn.cos * cos - turn.sin * sin }
    }

    fn between(turn: &Turn<T>, other: &Turn<T>) -> T {
        wrap(turn.value - other.value).abs()
    }

    fn at(&self, turn: &Turn<T>) -> T {
        let [a, b, k] = *self;
        a * turn.cos + b * turn.sin + k
    }

    fn slope(&self, turn: &Turn<T>) -> T {
        let [a, b, _] = *self;
        b * turn.cos - a * turn.sin
    }

    fn curvature(&self, turn: &Turn<T>) -> T {
        let [a, b, _] = *self;
        -(a * turn.cos + b * turn.sin)
    }

    fn square(&self) -> T {
        self.iter().fold(T::ZERO, |sum, k| sum + *k * *k)
    }
}

/// `a x^2 + b x + k` as `[a, b, k]`, for a joint that slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke<T>(pub [T; 3]);

impl<T: Tolerances> Moving<T> for Stroke<T> {
    fn step(turn: &Turn<T>, by: T) -> Turn<T> {
        Turn::position(turn.value + by)
    }

    fn between(turn: &Turn<T>, other: &Turn<T>) -> T {
        (turn.value - other.value).abs()
    }

    fn at(&self, turn: &Turn<T>) -> T {
        let Self([a, b, k]) = *self;
        (a * turn.value + b) * turn.value + k
    }

    fn slope(&self, turn: &Turn<T>) -> T {
        let Self([a, b, _]) = *self;
        T::TWO * a * turn.value + b
    }

    fn curvature(&self, _: &Turn<T>) -> T {
        let Self([a, ..]) = *self;
        T::TWO * a
    }

    fn square(&self) -> T {
        self.0.iter().fold(T::ZERO, |sum, k| sum + *k * *k)
    }
}

/// The components of a vector across an axis, as either of two joints moves it: two rows for each joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Across<X, Z> {
    /// As joint x moves it.
    pub x: [X; 2],
    /// As joint z moves it.
    pub z: [Z; 2],
}

/// Values of both joints.
pub(super) type CurvePoint<T> = [Turn<T>; 2];

impl<X, Z> Across<X, Z> {
    /// Upper bound on the lengths across.
    fn scale<T: Tolerances>(&self) -> T
    where
        X: Moving<T>,
        Z: Moving<T>,
    {
        let ([x1, x2], [z1, z2]) = (&self.x, &self.z);
        (x1.square() + x2.square()).max(z1.square() + z2.square()).sqrt()
    }

    /// The lengths across, over either joint.
    fn lengths<T: Tolerances>(&self, [x, z]: &CurvePoint<T>) -> [T; 2]
    where
        X: Moving<T>,
        Z: Moving<T>,
    {
        let length = |u: T, v: T| (u * u + v * v).sqrt();
        let ([x1, x2], [z1, z2]) = (&self.x, &self.z);
        [length(x1.at(x), x2.at(x)), length(z1.at(z), z2.at(z))]
    }

    /// The larger of the lengths, relative to their upper bound.
    pub(super) fn relative<T: Tolerances>(&self, point: &CurvePoint<T>) -> T
    where
        X: Moving<T>,
        Z: Moving<T>,
    {
        let ([a, b], scale) = (self.lengths(point), self.scale());
        if scale > T::ZERO { a.max(b) / scale } else { T::ONE }
    }

    /// The larger of two residuals: the difference of the lengths relative to their upper bound, and the gap of the
    /// row.
    pub(super) fn gap<T: Tolerances>(&self, (p, q): (&X, &Z), point: &CurvePoint<T>) -> T
    where
        X: Moving<T>,
        Z: Moving<T>,
    {
        let ([a, b], [x, z]) = (self.lengths(point), point);
        ((a - b) / self.scale()).abs().max((p.at(x) - q.at(z)).abs())
    }
}

fn moved<T: Tolerances, X: Moving<T>, Z: Moving<T>>([x, z]: &CurvePoint<T>, [dx, dz]: [T; 2]) -> CurvePoint<T> {
    [X::step(x, dx), Z::step(z, dz)]
}

/// A root of two equations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found<T> {
    pub point: CurvePoint<T>,
    /// True if the equations close to rounding at `point`.
    pub closed: bool,
    /// True if the equations also determine the point well, so that it is a root beyond doubt.
    pub sure: bool,
}

/// A few steps of Newton's method on both rows, as long as they bring the root closer.
pub(super) fn newton<T, X, Z>(p: &[X; 2], q: &[Z; 2], root: CurvePoint<T>) -> Found<T>
where
    T: Tolerances,
    X: Moving<T>,
    Z: Moving<T>,
{
    let ([p1, p2], [q1, q2]) = (p, q);
    let miss = |[x, z]: &CurvePoint<T>| [p1.at(x) - q1.at(z), p2.at(x) - q2.at(z)];
    let square = |[u, v]: [T; 2]| u * u + v * v;
    let slopes = |[x, z]: &CurvePoint<T>| [p1.slope(x), -q1.slope(z), p2.slope(x), -q2.slope(z)];
    let mut point = root;
    let mut missed = miss(&point);
    let mut size = square(missed);
    // The rounding of the rows, which are of unit length: six products, five sums, and the sines and cosines.
    let floor = T::EPSILON * T::from_f64(8.0);
    let closed = |size: T| size <= floor * floor;
    for _ in 0..4 {
        if closed(size) {
            break;
        }
        let ([u, v], [a, b, c, d]) = (missed, slopes(&point));
        let k = T::ONE / (a * d - b * c);
        let (dx, dz) = ((b * v - d * u) * k, (c * u - a * v) * k);
        if !(dx.abs().max(dz.abs()) < T::HALF) {
            break;
        }
        let next = moved::<T, X, Z>(&point, [dx, dz]);
        let next_missed = miss(&next);
        let next_size = square(next_missed);
        if !(next_size < size) {
            break;
        }
        (point, missed, size) = (next, next_missed, next_size);
    }
    let ([a, b, c, d], closed) = (slopes(&point), closed(size));
    Found { point, closed, sure: closed && (a * d - b * c).abs() >= T::DOUBTFUL }
}

/// The two roots of `p = q` and of equal lengths across the axis that are nearest to a point where those lengths are
/// small. A root is `None` where the steps do not lead to one.
///
/// Along the curve of the row, the difference of the squared lengths is to second order a quadratic polynomial. This
/// difference is accurate to rounding where the lengths vanish.
pub(super) fn neighbors<T, X, Z>(
    row: (&X, &Z),
    across: &Across<X, Z>,
    point: CurvePoint<T>,
) -> [Option<CurvePoint<T>>; 2]
where
    T: Tolerances,
    X: Moving<T>,
    Z: Moving<T>,
{
    let Some(start) = Ahead::new(row, across, point) else { return [None; 2] };
    let square = |[dx, dz]: &[T; 2]| *dx * *dx + *dz * *dz;
    start.steps.map(|first| {
        let (mut point, mut step) = (start.point, first?);
        for _ in 0..16 {
            // A step of length s misses the curve by s^2, and the root along it by s^2 or less: here by rounding.
            if square(&step) < T::EPSILON {
                break;
            }
            let ahead = Ahead::new(row, across, moved::<T, X, Z>(&point, step))?;
            let [low, high] = ahead.steps;
            step = match (low, high) {
                (Some(low), Some(high)) => {
                    if square(&low) < square(&high) {
                        low
                    } else {
                        high
                    }
                }
                (low, high) => low.or(high)?,
            };
            point = ahead.point;
        }
        // Far below what tells two solutions apart.
        let still = T::COINCIDENT * T::from_f64(0.1);
        (square(&step) < still * still).then(|| moved::<T, X, Z>(&point, step))
    })
}

/// A point on the curve of a row, and the steps along the curve to where the lengths across are equal. A step is `None`
/// where the point of equal lengths is too far to say.
struct Ahead<T> {
    point: CurvePoint<T>,
    steps: [Option<[T; 2]>; 2],
}

impl<T: Tolerances> Ahead<T> {
    /// From a point near the curve. `None` if the row does not say which way it goes.
    fn new<X: Moving<T>, Z: Moving<T>>(
        (p, q): (&X, &Z),
        across: &Across<X, Z>,
        mut point: CurvePoint<T>,
    ) -> Option<Self> {
        let mut along = [T::ZERO; 2];
        for _ in 0..2 {
            let [x, z] = &point;
            let (miss, dx, dz) = (p.at(x) - q.at(z), p.slope(x), -q.slope(z));
            let square = dx * dx + dz * dz;
            if !(square > T::WEAK * T::WEAK) {
                return None;
            }
            let k = -miss / square;
            along = [-dz / square.sqrt(), dx / square.sqrt()];
            if miss * miss < T::EPSILON * T::EPSILON * square {
                break;
            }
            point = moved::<T, X, Z>(&point, [k * dx, k * dz]);
        }
        let ([x, z], [tx, tz]) = (&point, along);
        let ([a1, a2], [b1, b2]) = (second(&across.x, x, tx), second(&across.z, z, tz));
        // The difference of the squares as a product, so that it is as accurate as the lengths.
        let [a0, b0] = across.lengths(&point);
        let (a, half, c) = (a2 - b2, a1 - b1, (a0 - b0) * (a0 + b0));
        let root = (half * half - a * c).max(T::ZERO).sqrt();
        let larger = if half < T::ZERO { root - half } else { -half - root };
        let step = |n: T, d: T| {
            // Without any difference, here is as good as anywhere.
            let s = if n == T::ZERO { T::ZERO } else { n / d };
            (s.abs() < T::HALF).then_some([s * tx, s * tz])
        };
        Some(Self { point, steps: [step(larger, a), step(c, larger)] })
    }
}

/// The squared length of two components along a curve on which their joint moves by `t`: half its slope, and half its
/// curvature.
fn second<T: Tolerances, M: Moving<T>>(parts: &[M; 2], turn: &Turn<T>, t: T) -> [T; 2] {
    parts.iter().fold([T::ZERO; 2], |[n1, n2], part| {
        let (v, d, c) = (part.at(turn), part.slope(turn) * t, part.curvature(turn) * t * t);
        [n1 + v * d, n2 + d * d + v * c]
    })
}
