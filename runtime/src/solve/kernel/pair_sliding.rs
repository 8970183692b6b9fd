//! Two equations in a slide and an angle that do not separate.

use super::circle::{Circle, angles};
use super::curve::{Across, CurvePoint, Moving, Row, Stroke};
use super::pair::square;
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::Turn;
use super::twins::with_twins;

/// Solves `scale x = line (cos z, sin z, 1)` and `x^2 + m x + n = q (cos z, sin z, 1)` for `(x, z)`, `x` sliding.
///
/// Either of the two is eliminated, whichever the rows know better. With `scale = 0` the slide is at right angles to
/// the component that the first row measures. The first row then has nothing of `x`, and `z` is eliminated. Where both
/// know nothing, the rows come apart: the first gives `z`, the second `x`. So `scale` may be anything, as long as
/// `scale` and the first two of `line` do not vanish together.
///
/// A joint between the two turns one vector onto another. The components across that joint's axis are `sliding` as `x`
/// moves the vector, `[of x, constant]`, and `turning`, the rows of `z`. Their lengths are equal, and known to rounding
/// where the quartic knows two close roots to its root only.
pub fn pair_sliding<T: Tolerances>(
    measure: Measure<T>,
    line: Row<T>,
    scale: T,
    [m, n]: [T; 2],
    q: Row<T>,
    (sliding, turning): ([[T; 2]; 2], [Row<T>; 2]),
) -> Roots<T, 2, 4> {
    // In units of the reach, and both rows of unit length.
    let k = T::ONE / measure.scale;
    let unit = |x: [T; 3], z: Row<T>| {
        let size = (Stroke(x).square() + z.square()).sqrt();
        let k = if size > T::ZERO { T::ONE / size } else { T::ZERO };
        (Stroke(x.map(|e| e * k)), z.map(|e| e * k))
    };
    let (p1, q1) = unit([T::ZERO, scale, T::ZERO], line.map(|e| e * k));
    let (p2, q2) = unit([T::ONE, m * k, n * k * k], q.map(|e| e * k * k));
    let (p, q) = ([p1, p2], [q1, q2]);
    let across =
        Across { x: sliding.map(|[u, e]| Stroke([T::ZERO, u, e * k])), z: turning.map(|row| row.map(|e| e * k)) };
    let (roots, len) = candidates(&p, &q);
    let mut stage = Roots { len, ..Roots::solved(roots) };
    let sure = with_twins(&mut stage, (&p, &q), &across);
    if !sure || len == 0 {
        stage.doubted(measure);
    }
    for [x, _] in &mut stage.roots {
        *x = Turn::position(x.value * measure.scale);
    }
    stage
}

/// The roots as the quartic (or what takes its place) gives them.
fn candidates<T: Tolerances>(
    [Stroke([_, scale, _]), parabola]: &[Stroke<T>; 2],
    rows @ [[a, b, c], [d, e, f]]: &[Row<T>; 2],
) -> ([CurvePoint<T>; 4], usize) {
    let (scale, det) = (*scale, *a * *e - *b * *d);
    if scale.abs().max(det.abs()) < T::COINCIDENT {
        separated(parabola, rows)
    } else if scale.abs() >= det.abs() {
        let Stroke([square, m, n]) = *parabola;
        // x = line / scale in the second row, times the square of the scale.
        let s2 = scale * scale;
        let ms = m * scale;
        let circle = Circle {
            k0: ((*a * *a + *b * *b) * T::HALF + *c * *c) * square + *c * ms + (n - *f) * s2,
            k1: [*a * (T::TWO * *c * square + ms) - *d * s2, *b * (T::TWO * *c * square + ms) - *e * s2],
            k2: [(*a * *a - *b * *b) * T::HALF * square, *a * *b * square],
        };
        let (roots, len) = angles(&circle);
        let size = (*a * *a + *b * *b + *c * *c) * square.abs() + (n.abs() + f.abs()) * s2 + (*c * ms).abs();
        // Where z moves nothing, rounding is all that is left of the polynomial: every angle is as good.
        let anywhere = len == 0 && circle.largest() <= T::VANISHING * size;
        let (roots, len) = if anywhere { ([Turn::ZERO; 4], 1) } else { (roots, len) };
        let [line, _] = rows;
        (roots.map(|z| [Turn::position(line.at(&z) / scale), z]), len)
    } else {
        without_angle(scale, det, parabola, rows)
    }
}

/// Eliminates `z`. With `u = scale x - c` and `v = x^2 + m x + n - f` (the parabola less the constant of its row),
/// `det (cos z, sin z) = (e u - b v, a v - d u)`. Its length is `|det|`: a quartic in `x`. As `x = tan(t/2)`, every
/// polynomial of degree two over `1 + x^2` is a row of `t`. So `x` is on a circle, too, and is never too large.
fn without_angle<T: Tolerances>(
    scale: T,
    det: T,
    Stroke([square_x, m, n]): &Stroke<T>,
    [[a, b, c], [d, e, f]]: &[Row<T>; 2],
) -> ([CurvePoint<T>; 4], usize) {
    let (u, v) = ([T::ZERO, scale, -*c], [*square_x, *m, *n - *f]);
    let combined = |i: T, j: T| {
        let [k2, k1, k0] = [i * u[0] + j * v[0], i * u[1] + j * v[1], i * u[2] + j * v[2]];
        [(k0 - k2) * T::HALF, k1 * T::HALF, (k0 + k2) * T::HALF]
    };
    let (cos, sin) = (combined(*e, -*b), combined(-*d, *a));
    let (mut circle, _) = square(&[cos, sin]);
    // The determinant over 1 + x^2, squared.
    let (length, _) = square(&[[det * T::HALF, T::ZERO, det * T::HALF], [T::ZERO; 3]]);
    circle.k0 -= length.k0;
    for (k, l) in circle.k1.iter_mut().chain(&mut circle.k2).zip(length.k1.iter().chain(&length.k2)) {
        *k -= *l;
    }
    let (roots, len) = angles(&circle);
    let place = |t: Turn<T>| {
        let z = Turn::direction(sin.at(&t) * det, cos.at(&t) * det);
        [Turn::position(t.sin / (T::ONE + t.cos).max(T::EPSILON)), z]
    };
    (roots.map(place), len)
}

/// Where the first row has no `x`, and the second the same combination of the angle: `z` from the one, `x` from the
/// other.
fn separated<T: Tolerances>(
    Stroke([square, m, n]): &Stroke<T>,
    [[a, b, c], row]: &[Row<T>; 2],
) -> ([CurvePoint<T>; 4], usize) {
    let mut roots = [[Turn::ZERO; 2]; 4];
    let (found, len) = angles(&Circle { k0: *c, k1: [*a, *b], k2: [T::ZERO; 2] });
    for (pair, z) in roots.chunks_exact_mut(2).zip(found) {
        let (half, rest) = (*m * T::HALF, *n - row.at(&z));
        let root = (half * half - *square * rest).max(T::ZERO).sqrt();
        let larger = -(half + root.copysign(half));
        let smaller = if larger == T::ZERO { T::ZERO } else { rest / larger };
        for (place, x) in pair.iter_mut().zip([larger / *square, smaller]) {
            *place = [Turn::position(x), z];
        }
    }
    (roots, 2 * len)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    type V = [f64; 3];

    fn dot(a: V, b: V) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn rotated(v: V, (s, c): (f64, f64)) -> V {
        [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]]
    }

    /// A point slides along `direction`. On the other side of the axis y (the third), a point circles about an axis
    /// tilted by `tilt`. Returns the roots of the pair that `[x, y, z]` closes, and how well the equations know
    /// `(x, z)`.
    fn solve(direction: V, [x, y, z]: V, [radius, height]: [f64; 2], offset: V, tilt: f64) -> (Vec<[f64; 2]>, f64) {
        let (ts, tc) = tilt.sin_cos();
        // rows of z: the circle, then tilted about the first axis
        let turning = [
            [radius, 0.0, offset[0]],
            [0.0, radius * tc, offset[1] - height * ts],
            [0.0, radius * ts, offset[2] + height * tc],
        ];
        let at = |k: usize| turning[k].at(&Turn::at(z));
        let point = rotated([at(0), at(1), at(2)], y.sin_cos());
        let from = [point[0] - x * direction[0], point[1] - x * direction[1], point[2] - x * direction[2]];
        let square = turning.iter().fold([0.0; 3], |[a, b, k], r| {
            [a + 2.0 * r[0] * r[2], b + 2.0 * r[1] * r[2], k + r[2] * r[2] + radius * radius / 2.0]
        });
        // the squares of the circle's components sum to its radius
        let square = [square[0], square[1], square[2] - radius * radius / 2.0];
        let line = [turning[2][0], turning[2][1], turning[2][2] - from[2]];
        let (m, n) = (2.0 * dot(direction, from), dot(from, from));
        let sliding = [[direction[0], from[0]], [direction[1], from[1]]];
        let stage =
            pair_sliding(Measure::length(2.0), line, direction[2], [m, n], square, (sliding, [turning[0], turning[1]]));
        let turn = Turn::at(z);
        let det = direction[2] * square.slope(&turn) - line.slope(&turn) * (2.0 * x + m);
        (stage.roots.iter().take(stage.len).map(|root| root.map(|turn| turn.value)).collect(), det.abs())
    }

    /// Fails where the root is not found although the equations know it.
    fn assert_found(direction: V, joints: V, sizes: [f64; 2], offset: V, tilt: f64) {
        let (roots, det) = solve(direction, joints, sizes, offset, tilt);
        let [x, _, z] = joints;
        let miss = |[u, w]: &[f64; 2]| (u - x).abs().max(crate::math::wrap(w - z).abs());
        let nearest = roots.iter().map(miss).fold(9.0, f64::min);
        let known = 1e-6_f64.min(1e-14 / det).max(1e-13);
        assert!(
            det < 1e-7 || nearest < known,
            "{direction:?} {joints:?} {offset:?} {tilt}: {nearest:e} {det:e} {roots:?}"
        );
    }

    fn unit(third: f64, about: f64) -> V {
        let (s, c) = about.sin_cos();
        let across = (1.0 - third * third).sqrt();
        [across * c, across * s, third]
    }

    #[test]
    fn what_made_the_equations_comes_back() {
        let tilts = [1.1, 0.0, core::f64::consts::FRAC_PI_2, 1e-9];
        for k in 0..4000 {
            let [x, y, z, about, u, v] = [0.399, 1.117, 2.441, 3.7, 4.3, 5.9].map(|step| (f64::from(k) * step).sin());
            // The slide at right angles to axis y, nearly so, and anyhow.
            let third = match k % 4 {
                0 => 0.0,
                1 => 10.0_f64.powi(-(k / 4 % 18)) * 0.9,
                2 => -1.0,
                _ => u,
            };
            let tilt = tilts[(k / 7 % 4) as usize];
            if tilt > 1e-3 || third.abs() > 1e-3 {
                let offset = [0.3 * u, 0.4 * v, 0.2];
                assert_found(unit(third, 3.0 * about), [x, 3.1 * y, 3.1 * z], [0.4, 0.1 * v], offset, tilt);
            }
        }
    }

    #[test]
    fn special_angles_are_as_good_as_any() {
        let quarter = core::f64::consts::FRAC_PI_2;
        for k in 0_i32..4096 {
            let digit = |place: u32| f64::from(k / 4_i32.pow(place) % 4);
            let [y, z, about, tilt] = [0, 1, 2, 3].map(|place| digit(place) * quarter - quarter);
            let offset = [[0.0, 0.2, 0.0], [0.3, 0.0, 0.0], [0.0; 3], [0.1, 0.2, 0.3]][(k / 256 % 4) as usize];
            let third = [0.0, 1.0, 6.123e-17, 0.5][(k / 1024 % 4) as usize];
            if tilt.sin().abs() > 0.5 || third > 0.1 {
                assert_found(unit(third, about), [0.532925, y, z], [0.3283, 0.141], offset, tilt);
            }
        }
    }
}
