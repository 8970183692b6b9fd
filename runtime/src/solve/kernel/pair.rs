//! Two equations in two joints that do not separate.

use super::circle::{Circle, angles};
use super::curve::{Across, Found, Moving, Row, newton};
use super::doubt::Doubt;
use super::roots::{Measure, Roots};
use super::separated::{combined, separated};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use super::twins::{distinct, with_twins};

/// Solves the two rows `p (cos x, sin x, 1) = q (cos z, sin z, 1)` for `(x, z)`. One side is eliminated, which leaves a
/// trigonometric polynomial of degree two (a quartic), so at most four pairs. Each pair is polished by Newton's method
/// on the rows themselves. Where the rows lose rank (a point on a joint axis) they are combined so that one joint drops
/// out. The combined rows are solved one after the other. Where the polynomial vanishes for every angle, that joint is
/// free.
///
/// The roots are marked for a full check, unless each root closes both rows to rounding, and the rows determine the
/// root well. Near a double root a candidate may turn out not to be a solution.
pub fn pair<T: Tolerances>(
    defaults: [DefaultValue<T>; 2],
    measure: Measure<T>,
    p: [Row<T>; 2],
    q: [Row<T>; 2],
) -> Roots<T, 2, 4> {
    let (p, q) = normalized(measure, p, q);
    let mut stage = candidates(defaults, &p, &q, None);
    let mut sure = true;
    for root in stage.roots.iter_mut().take(stage.len) {
        let Found { point, sure: known, .. } = newton(&p, &q, *root);
        *root = point;
        sure &= known;
    }
    let sure = sure && distinct::<T, Row<T>, Row<T>>(&stage);
    finished(stage, sure, defaults, measure, [&p, &q])
}

/// Solves [`pair`] where a joint between the two turns one vector onto another, which both joints move. The last four
/// rows have the components of the vector across that joint's axis, two as x moves the vector and two as z does. Of the
/// rows of `p` and `q`, the second says that the vectors have the same length.
///
/// Where the vectors vanish, two roots meet, and the second row knows them to the root of rounding only. There the
/// roots follow from the lengths across, which are accurate, along the curve of the first row.
pub fn pair_turning<T: Tolerances>(
    defaults: [DefaultValue<T>; 2],
    measure: Measure<T>,
    p: [Row<T>; 2],
    q: [Row<T>; 2],
    [x1, x2, z1, z2]: [Row<T>; 4],
) -> Roots<T, 2, 4> {
    let across = Across { x: [x1, x2], z: [z1, z2] };
    let (p, q) = normalized(measure, p, q);
    let mut stage = candidates(defaults, &p, &q, Some(&across));
    let sure = with_twins(&mut stage, (&p, &q), &across);
    finished(stage, sure, defaults, measure, [&p, &q])
}

/// How far a joint moves its rows.
fn amplitude<T: Tolerances>(rows: &[Row<T>; 2]) -> T {
    rows.iter().fold(T::ZERO, |sum, [a, b, _]| sum + *a * *a + *b * *b).sqrt()
}

fn finished<T: Tolerances>(
    mut stage: Roots<T, 2, 4>,
    sure: bool,
    defaults: [DefaultValue<T>; 2],
    measure: Measure<T>,
    sides: [&[Row<T>; 2]; 2],
) -> Roots<T, 2, 4> {
    if sure && stage.len > 0 && stage.doubt.is_none_or(|doubt| doubt.free.is_empty() && doubt.weak.is_empty()) {
        return Roots { doubt: None, ..stage };
    }
    let doubt = stage.doubted(measure);
    (doubt.angular, doubt.gap) = (measure.is_angular(), T::ZERO);
    for (default, rows) in defaults.into_iter().zip(sides) {
        stage = stage.nearly_free(default, measure, amplitude(rows));
    }
    stage
}

/// Both rows scaled to unit length. One of rounding alone, whatever it measures (a direction, a length, its square),
/// says nothing and becomes zero.
fn normalized<T: Tolerances>(
    measure: Measure<T>,
    [p1, p2]: [Row<T>; 2],
    [q1, q2]: [Row<T>; 2],
) -> ([Row<T>; 2], [Row<T>; 2]) {
    let nothing = T::VANISHING * T::ONE.min(measure.scale).min(measure.scale * measure.scale);
    let unit = |p: Row<T>, q: Row<T>| {
        let size = p.iter().chain(&q).fold(T::ZERO, |sum, k| sum + *k * *k).sqrt();
        let k = if size > nothing { T::ONE / size } else { T::ZERO };
        (p.map(|e| e * k), q.map(|e| e * k))
    };
    let ((p1, q1), (p2, q2)) = (unit(p1, q1), unit(p2, q2));
    ([p1, p2], [q1, q2])
}

/// The roots as the quartic (or what takes its place) gives them.
fn candidates<T: Tolerances>(
    [default_x, default_z]: [DefaultValue<T>; 2],
    p: &[Row<T>; 2],
    q: &[Row<T>; 2],
    across: Option<&Across<Row<T>, Row<T>>>,
) -> Roots<T, 2, 4> {
    let (det_p, det_q) = (determinant(p), determinant(q));
    if det_p.abs().max(det_q.abs()) < T::COINCIDENT {
        separated([default_x, default_z], p, q)
    } else if det_p.abs() >= det_q.abs() {
        eliminated(default_z, p, det_p, q, across.map(|across| &across.z))
    } else {
        eliminated(default_x, q, det_q, p, across.map(|across| &across.x)).swapped()
    }
}

fn determinant<T: Tolerances>([a, b]: &[Row<T>; 2]) -> T {
    a[0] * b[1] - a[1] * b[0]
}

/// Eliminates the side `p`, whose determinant does not vanish: with `u = adj(P) (q - p3)`, `|u| = |det P|`.
///
/// Where every z is as good, it stays at its default. Other families of solutions cross this one where the vector
/// `across` (as z moves it) vanishes. There the joint between x and z is free, and those places are further roots.
fn eliminated<T: Tolerances>(
    default: DefaultValue<T>,
    p: &[Row<T>; 2],
    det: T,
    q: &[Row<T>; 2],
    across: Option<&[Row<T>; 2]>,
) -> Roots<T, 2, 4> {
    let [[a, b, e], [c, d, f]] = *p;
    let shifted = [[q[0][0], q[0][1], q[0][2] - e], [q[1][0], q[1][1], q[1][2] - f]];
    let (w1, w2) = (combined([d, -b], &shifted), combined([-c, a], &shifted));
    let (mut circle, size) = square(&[w1, w2]);
    circle.k0 -= det * det;
    let sign = if det < T::ZERO { -T::ONE } else { T::ONE };
    let paired = |z: [Turn<T>; 4]| {
        let directions = z.map(|z| {
            let (u1, u2) = (w1.at(&z) * sign, w2.at(&z) * sign);
            let size = u1 * u1 + u2 * u2;
            let k = T::ONE / size.sqrt();
            if size > T::ZERO { [u1 * k, u2 * k] } else { [T::ONE, T::ZERO] }
        });
        let [x1, x2, x3, x4] = Turn::array(directions.map(|[_, sin]| sin), directions.map(|[cos, _]| cos));
        let [z1, z2, z3, z4] = z;
        Roots::solved([[x1, z1], [x2, z2], [x3, z3], [x4, z4]])
    };
    // With coefficients of no more than rounding, or without any of z in the rows, every angle is as good. The
    // polynomial is the difference of the squares of two lengths, one of them `det`; a coefficient has up to eight
    // products and sums.
    let vanishing = (T::EPSILON * T::from_f64(8.0) * (size + det * det)).max(T::VANISHING * det.abs());
    let anywhere = || {
        let crossings = across.map_or([None; 2], zeros);
        let mut places = [Turn::at(crate::math::wrap(default.value)); 4];
        let mut len = 1;
        for (slot, z) in places.iter_mut().skip(1).zip(crossings.into_iter().flatten()) {
            *slot = z;
            len += 1;
        }
        Roots { len, ..paired(places) }
    };
    let vanishing = vanishing.max(default.free_below() * det.abs());
    if circle.largest() <= vanishing || amplitude(q) < default.free_below() {
        return Roots { doubt: Some(Doubt { free: default.joint, ..Doubt::NOTHING }), ..anywhere() };
    }
    let (roots, len) = angles(&circle);
    let amplitude = circle.largest() / det.abs();
    // Of small coefficients without a root: a target that is missed by little, wherever z is.
    if len == 0 && amplitude < T::WEAK {
        return Roots { doubt: Some(Doubt { weak: default.joint, ..Doubt::NOTHING }), ..anywhere() };
    }
    let mut stage = Roots { len, ..paired(roots) };
    // Of small coefficients with roots: these are known to the root of rounding over the coefficients.
    if amplitude < T::WEAK {
        stage.doubt = Some(Doubt { weak: default.joint, amplitude, ..Doubt::NOTHING });
    }
    stage
}

/// The squared length of a vector of two rows, as a trigonometric polynomial, and the sum of all squared coefficients.
pub(super) fn square<T: Tolerances>([[a, b, c], [d, e, f]]: &[Row<T>; 2]) -> (Circle<T>, T) {
    let (cos, sin, one) = (*a * *a + *d * *d, *b * *b + *e * *e, *c * *c + *f * *f);
    let circle = Circle {
        k0: (cos + sin) * T::HALF + one,
        k1: [T::TWO * (*a * *c + *d * *f), T::TWO * (*b * *c + *e * *f)],
        k2: [(cos - sin) * T::HALF, *a * *b + *d * *e],
    };
    (circle, cos + sin + one)
}

/// The angles, at most two, at which a vector of two rows vanishes: double roots of its squared length.
fn zeros<T: Tolerances>(rows: &[Row<T>; 2]) -> [Option<Turn<T>>; 2] {
    let (circle, size) = square(rows);
    let (found, len) = angles(&circle);
    let mut zeros = [None; 2];
    for mut turn in found.into_iter().take(len) {
        let [p, q] = rows;
        // A double root comes with half of the digits; the rows themselves have all.
        for _ in 0..2 {
            let (u, v, du, dv) = (p.at(&turn), q.at(&turn), p.slope(&turn), q.slope(&turn));
            turn = Turn::at(crate::math::wrap(turn.value - (u * du + v * dv) / (du * du + dv * dv)));
        }
        let (u, v) = (p.at(&turn), q.at(&turn));
        let vanishes = (u * u + v * v) < T::VANISHING * T::VANISHING * size;
        let known = |other: &Turn<T>| crate::math::wrap(other.value - turn.value).abs() < T::COINCIDENT;
        if vanishes
            && !zeros.iter().flatten().any(known)
            && let Some(slot) = zeros.iter_mut().find(|slot| slot.is_none())
        {
            *slot = Some(turn);
        }
    }
    zeros
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointMask;
    use std::vec::Vec;

    const LENGTH: Measure<f64> = Measure::length(1.0);

    fn defaults() -> [DefaultValue<f64>; 2] {
        [0, 1].map(|joint| DefaultValue::at(0.0, JointMask::single(joint)))
    }

    type Equations = ([Row<f64>; 2], [Row<f64>; 2], [Row<f64>; 4]);

    /// Three parallel axes seen from a joint y between x and z, all at right angles, for a target that `(x, y, z)`
    /// reaches. The equations are rows of the distance along their direction and of its component along y, and the
    /// components across y.
    fn three_parallel([x, y, z]: [f64; 3]) -> Equations {
        let (u, v, w) = (y.cos() * x.sin(), x.cos(), -y.sin() * x.sin());
        let (r1, r2) = (u * z.cos() + v * z.sin(), v * z.cos() - u * z.sin());
        let (a, b) = (0.2 * r1 - 0.15 * r2, -(0.15 * r1 + 0.2 * r2));
        let distance = -0.1 * x.sin() - a * z.cos() - b * z.sin();
        let p = [[0.0, -0.1, 0.0], [-1.0, 0.0, 0.0]];
        let q = [[a, b, distance], [-r2, -r1, 0.0]];
        (p, q, [[0.0, 1.0, 0.0], [0.0; 3], [r1, -r2, 0.0], [0.0, 0.0, w]])
    }

    fn roots(stage: &Roots<f64, 2, 4>) -> Vec<[f64; 2]> {
        stage.roots.iter().take(stage.len).map(|root| root.map(|turn| turn.value)).collect()
    }

    fn distance([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
        crate::math::wrap(a - c).abs().max(crate::math::wrap(b - d).abs())
    }

    #[test]
    fn what_made_the_rows_comes_back() {
        for k in 0..500 {
            let [x, y, z] = [2.399, 1.117, 4.441].map(|step| (f64::from(k) * step).sin() * 3.1);
            let (p, q, across) = three_parallel([x, y, z]);
            for stage in [pair(defaults(), LENGTH, p, q), pair_turning(defaults(), LENGTH, p, q, across)] {
                let nearest = roots(&stage).into_iter().map(|root| distance(root, [x, z])).fold(9.0, f64::min);
                assert!(nearest < 1e-10, "{x} {y} {z}: {nearest:e}");
            }
        }
    }

    #[test]
    fn two_roots_beside_a_vanishing_vector_are_both_accurate() {
        for digits in 3..=12 {
            for (sign, middle) in [(1.0, 0.0), (-1.0, 0.0), (1.0, core::f64::consts::PI), (-1.0, core::f64::consts::PI)]
            {
                let [x, y, z] = [middle + sign * 10.0_f64.powi(-digits), 0.7, -1.2];
                let (p, q, across) = three_parallel([x, y, z]);
                let found = roots(&pair_turning(defaults(), LENGTH, p, q, across));
                assert!(found.iter().any(|root| distance(*root, [x, z]) < 1e-13), "{x} {z}: {found:?}");
                // The twin is as far on the other side of where the vector vanishes.
                let beside = |root: &[f64; 2]| distance(*root, [x, z]) > 1e-13 && distance(*root, [x, z]) < 1e-2;
                assert!(found.iter().any(beside), "{x} {z}: {found:?}");
            }
        }
    }

    #[test]
    fn a_joint_that_moves_nothing_is_free() {
        // cos x = 0, sin x = 1, whatever z is.
        let p = [[0.0, 0.3, -0.3], [1.0, 0.0, 0.0]];
        let stage = pair(defaults(), LENGTH, p, [[0.0; 3]; 2]);
        assert_eq!(stage.free(), JointMask::single(1));
        assert_eq!(roots(&stage), [[core::f64::consts::FRAC_PI_2, 0.0]]);
        let stage = pair(defaults(), LENGTH, [[0.0; 3]; 2], p);
        assert_eq!(stage.free(), JointMask::single(0));
    }

    #[test]
    fn joints_that_move_together_leave_one_free() {
        // (cos x, sin x) = (cos z, sin z)
        let rows = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let [_, default_z] = defaults();
        let away = DefaultValue { value: 0.4, ..default_z };
        let stage = pair([defaults()[0], away], LENGTH, rows, rows);
        assert_eq!(stage.free(), JointMask::single(1));
        assert!(distance(roots(&stage)[0], [0.4, 0.4]) < 1e-15);
    }

    #[test]
    fn a_joint_that_moves_little_is_weak() {
        let p = [[0.0, 0.3, -0.3], [1.0, 0.0, 0.0]];
        let q = [[1e-9, 0.0, 0.0], [0.0, 1e-9, 0.0]];
        assert_eq!(pair(defaults(), LENGTH, p, q).doubt.map(|doubt| doubt.weak), Some(JointMask::single(1)));
    }
}
