//! Real roots of a trigonometric polynomial of degree two.

use super::tolerances::Tolerances;
use super::turn::Turn;

/// `k0 + k1c cos t + k1s sin t + k2c cos 2t + k2s sin 2t`
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) struct Circle<T> {
    pub k0: T,
    pub k1: [T; 2],
    pub k2: [T; 2],
}

impl<T: Tolerances> Circle<T> {
    /// The largest coefficient.
    pub(in crate::solve) fn largest(&self) -> T {
        let Circle { k0, k1: [k1c, k1s], k2: [k2c, k2s] } = *self;
        k0.abs().max(k1c.abs()).max(k1s.abs()).max(k2c.abs()).max(k2s.abs())
    }
}

/// `normal . (x, y) + k = 0`
#[derive(Debug, Clone, Copy)]
struct Line<T> {
    normal: [T; 2],
    k: T,
}

/// Points found on the unit circle, as `[x, y]`.
struct Points<T> {
    found: [[T; 2]; 4],
    len: usize,
}

impl<T: Tolerances> Points<T> {
    const NONE: Self = Self { found: [[T::ONE, T::ZERO]; 4], len: 0 };

    /// Where a line meets the circle. One that nearly touches it does so twice at the nearest point.
    fn meet(&mut self, line: Line<T>, size: T) {
        let [nx, ny] = line.normal.map(|e| e / size);
        let d = -line.k / size;
        // On the circle z = exp(it) the two points of a line outside are at |log|z|| < 0.3.
        if !(d.abs() < T::from_f64(1.045)) {
            return;
        }
        let h = ((T::ONE - d) * (T::ONE + d)).max(T::ZERO).sqrt();
        let d = d.max(-T::ONE).min(T::ONE);
        for h in [h, -h] {
            if let Some(slot) = self.found.get_mut(self.len) {
                *slot = [d * nx - h * ny, d * ny + h * nx];
                self.len += 1;
            }
        }
    }
}

/// Up to four angles in (-pi, pi], each accurate as far as the coefficients are. A double root comes twice, also where
/// rounding has made it no root: a nearly real pair is two candidates.
///
/// With `x = cos t` and `y = sin t` the polynomial is a conic that the unit circle meets. The conics through the same
/// points are `conic + l (x^2 + y^2 - 1)`. At least one with `|l| <= |k2|` is a pair of real lines ([`lines`]).
pub(in crate::solve) fn angles<T: Tolerances>(circle: &Circle<T>) -> ([Turn<T>; 4], usize) {
    let largest = circle.largest();
    let mut points = Points::NONE;
    if largest > T::ZERO {
        let k = T::ONE / largest;
        let (k0, [k1c, k1s], [k2c, k2s]) = (circle.k0 * k, circle.k1.map(|e| e * k), circle.k2.map(|e| e * k));
        let r = (k2c * k2c + k2s * k2s).sqrt();
        if r > T::ROUNDING {
            // The axes of the conic: x = (u, v), y = (-v, u), where it has no x y.
            let half = ((r + k2c.abs()) / (T::TWO * r)).sqrt();
            let other = k2s / (T::TWO * r * half);
            let [u, v] = if k2c < T::ZERO { [other, half] } else { [half, other] };
            let axes = Conic { r, k0, k1: [k1c * u + k1s * v, k1s * u - k1c * v] };
            let size = (T::TWO * r).sqrt();
            // The other way round is the same conic with another sign, seen from its other axis.
            let (pair, [u, v]) =
                if axes.lower() { (axes.lines(size), [u, v]) } else { (axes.turned().lines(size), [-v, u]) };
            for line in pair {
                points.meet(line, size);
            }
            points.found = points.found.map(|[x, y]| [u * x - v * y, v * x + u * y]);
        } else {
            let size = (k1c * k1c + k1s * k1s).sqrt();
            points.meet(Line { normal: [k1c, k1s], k: k0 }, size);
        }
    }
    (Turn::array(points.found.map(|[_, y]| y), points.found.map(|[x, _]| x)), points.len)
}

/// `r (x^2 - y^2) + k1 . (x, y) + k0`
#[derive(Debug, Clone, Copy)]
struct Conic<T> {
    r: T,
    k0: T,
    k1: [T; 2],
}

impl<T: Tolerances> Conic<T> {
    /// Returns true if some `l <= 0`, the lower half of the range, gives a pair of lines.
    fn lower(&self) -> bool {
        let Self { r, k0, k1: [a, b] } = *self;
        T::TWO * T::TWO * r * k0 + b * b >= a * a
    }

    /// The conic with its sign changed, from axes a quarter turn further on.
    fn turned(&self) -> Self {
        let Self { r, k0, k1: [a, b] } = *self;
        Self { r, k0: -k0, k1: [-b, a] }
    }

    /// The pair of lines `(p x - q y + e) (p x + q y + f) = conic + l (x^2 + y^2 - 1)`, for `l` in `-r ..= 0`.
    ///
    /// There `p^2 = r + l` and `q^2 = r - l`. The others follow from `e + f = a/p`, `e - f = b/q` and `e f = k0 - l`.
    ///
    /// Both have normals of length `size`, the root of `2 r`. At an inexact `l`, the residual of `e f = k0 - l` is the
    /// cubic of `l` over `p^2 q^2`. So the lines are good wherever the cubic is small, at its double roots, too.
    fn lines(&self, size: T) -> [Line<T>; 2] {
        let Self { r, k0, k1: [a, b] } = *self;
        // What is far below rounding has no square.
        let a = a.when(a.abs() > T::EPSILON * T::EPSILON);
        let (p2, sum) = self.cubic(a);
        let (p, q) = (p2.sqrt(), (T::TWO * r - p2).sqrt());
        let sum = if p > T::ZERO { a / p } else { sum };
        let difference = b / q;
        let (mut e, mut f) = ((sum + difference) * T::HALF, (sum - difference) * T::HALF);
        // A line outside the circle is known well, relative to itself; the other one follows from the product.
        let product = k0 + r - p2;
        if e.abs() > size.max(f.abs()) {
            f = product / e;
        } else if f.abs() > size {
            e = product / f;
        }
        [Line { normal: [p, -q], k: e }, Line { normal: [p, q], k: f }]
    }

    /// A root in `0 ..= r` of the cubic of `p^2`, and `e + f` where it is zero.
    ///
    /// Newton's method from the end from which it is monotone: the cubic bends one way between there and the root.
    fn cubic(&self, a: T) -> (T, T) {
        let Self { r, k0, k1: [_, b] } = *self;
        let quarter = T::HALF * T::HALF;
        let (aa, bb) = (a * a * quarter, b * b * quarter);
        // ((x - k2) x + k1) x - k0
        let (k2, k1, k0) = (T::TWO * r + r + k0, T::TWO * r * (r + k0) + aa + bb, T::TWO * r * aa);
        if aa == T::ZERO && k1 >= T::ZERO {
            return (T::ZERO, (T::TWO * k1 / r).sqrt());
        }
        let value = |x: T| ((x - k2) * x + k1) * x - k0;
        let three = T::TWO + T::ONE;
        let inflection = k2 / three;
        let concave = k1 > T::ZERO && (inflection >= r || inflection > T::ZERO && value(inflection) >= T::ZERO);
        let mut x = if concave { T::ZERO } else { r };
        // The rounding of the cubic over x, and what is as good as none for the product of the lines.
        let noise = T::EPSILON * (r * r + k2.abs() * r + k1.abs() + r);
        for _ in 0..STEPS {
            let miss = value(x);
            if !(miss.abs() > noise * x + T::EPSILON * k0) {
                break;
            }
            // Not beyond an end that is a root to rounding.
            let next = (x - miss / ((three * x - T::TWO * k2) * x + k1)).max(T::ZERO).min(r);
            if next == x {
                break;
            }
            x = next;
        }
        (x, T::ZERO)
    }
}

/// Steps of Newton's method at most. Towards a triple root each step leaves 8/27 of the cubic. Towards a double root at
/// zero each step leaves half of the distance: 53 steps for as many bits.
const STEPS: usize = 64;

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};
    use std::vec::Vec;

    /// `h - cos(t - m)` as `[x, y, 1]`: the points at `m +- acos h`, or none.
    fn line(middle: f64, h: f64) -> [f64; 3] {
        let (s, c) = middle.sin_cos();
        [-c, -s, h]
    }

    /// The line through two points of the circle.
    fn through([t, u]: [f64; 2]) -> [f64; 3] {
        let (s, c) = ((t + u) / 2.0).sin_cos();
        [-c, -s, ((t - u) / 2.0).cos()]
    }

    fn product([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> Circle<f64> {
        Circle {
            k0: c * f + (a * d + b * e) / 2.0,
            k1: [a * f + c * d, b * f + c * e],
            k2: [(a * d - b * e) / 2.0, (a * e + b * d) / 2.0],
        }
    }

    fn single(Circle { k0, k1, k2 }: &Circle<f64>) -> Circle<f32> {
        Circle { k0: *k0 as f32, k1: k1.map(|e| e as f32), k2: k2.map(|e| e as f32) }
    }

    fn apart(t: f64, u: f64) -> f64 {
        ((t - u) / 2.0).sin().abs() * 2.0
    }

    /// Each of the roots has a candidate of its own, as near as coefficients that are off by `rounding` allow.
    fn assert_found(circle: &Circle<f64>, roots: &[f64], found: &[f64], factor: f64, rounding: f64) {
        // The polynomial is `factor` times half of the distances from the roots; how far a root moves.
        let radius = |t: f64| {
            let moved = |by: f64| roots.iter().fold(factor / circle.largest(), |g, u| g * by.max(apart(t, *u)) / 2.0);
            let (mut low, mut high) = (1e-40_f64, 4.0_f64);
            for _ in 0..20 {
                let middle = (low * high).sqrt();
                if moved(middle) < rounding { low = middle } else { high = middle }
            }
            4.0 * high
        };
        let radii: Vec<f64> = roots.iter().map(|t| radius(*t)).collect();
        let near = |(root, i): (usize, usize)| apart(roots[root], found[i]) < radii[root];
        assert!(matched(0, roots.len(), found.len(), 0, &near), "{circle:?}: {roots:?}, found {found:?}");
    }

    /// Returns true if each root from `root` on can have a candidate of its own that is not used.
    fn matched(root: usize, roots: usize, found: usize, used: u32, near: &dyn Fn((usize, usize)) -> bool) -> bool {
        root == roots
            || (0..found).any(|i| {
                used & (1 << i) == 0 && near((root, i)) && matched(root + 1, roots, found, used | (1 << i), near)
            })
    }

    fn check(circle: &Circle<f64>, roots: &[f64], factor: f64) {
        for sign in [1.0, -3.7e5, 2.1e-9] {
            let Circle { k0, k1, k2 } = *circle;
            let scaled = Circle { k0: k0 * sign, k1: k1.map(|e| e * sign), k2: k2.map(|e| e * sign) };
            let (found, len) = angles(&scaled);
            let found: Vec<f64> = found.iter().take(len).map(|turn| turn.value).collect();
            assert_found(&scaled, roots, &found, factor * sign.abs(), 64.0 * f64::EPSILON);
            let (found, len) = angles(&single(&scaled));
            let found: Vec<f64> = found.iter().take(len).map(|turn| f64::from(turn.value)).collect();
            assert_found(&scaled, roots, &found, factor * sign.abs(), 64.0 * f64::from(f32::EPSILON));
        }
    }

    fn four(roots: [f64; 4]) {
        let [a, b, c, d] = roots;
        // Each line is twice the product of two half distances.
        check(&product(through([a, b]), through([c, d])), &roots, 4.0);
    }

    /// Two roots beside a line that does not meet the circle, or not at all, `inverse` times as far away.
    fn two(roots: [f64; 2], middle: f64, inverse: f64) {
        let [x, y, _] = line(middle, 0.0);
        check(&product(through(roots), [x * inverse, y * inverse, 1.0]), &roots, 2.0 * (1.0 - inverse));
    }

    fn noise(k: u32) -> [f64; 6] {
        [1.399, 2.117, 3.441, 0.7, 4.3, 5.9].map(|step| (f64::from(k) * step).sin())
    }

    #[test]
    fn four_roots_anywhere() {
        for k in 0..5000 {
            let [a, b, c, d, ..] = noise(k);
            four([a * PI, b * PI, c * PI, d * PI]);
        }
    }

    #[test]
    fn roots_on_grids() {
        for parts in [2, 3, 4, 6, 8] {
            let n = 2 * parts;
            for k in 0..n * n * n {
                let angle = |k: i32| f64::from(k % n) * PI / f64::from(parts) - PI;
                four([angle(0), angle(k), angle(k / n), angle(k / n / n)]);
                four([angle(1), angle(k), angle(k / n), angle(k / n / n)]);
            }
        }
    }

    #[test]
    fn roots_that_nearly_meet() {
        for k in 0..150 {
            let [a, b, c, d, e, f] = noise(k);
            let a = if k % 3 == 0 { f64::from(k % 8) * PI / 4.0 - PI } else { a * PI };
            for digits in 0..18 {
                let by = 10.0_f64.powi(-digits) * (1.0 + 0.5 * e);
                four([a, a + by, b * PI, c * PI]);
                four([a, b * PI, a + by, c * PI]);
                four([a, a + by, a + d * by, c * PI]);
                four([a, a + by, a + d * by, a + f * by]);
                four([a, a + by, c * PI, c * PI + f * by]);
                four([a, c * PI, c * PI + f * by, a + by]);
                four([a, a + by, a + PI, a + PI + f * by]);
                four([a, a + by, a, a + by]);
                four([a, a, a + by, a + by]);
            }
        }
    }

    #[test]
    fn roots_in_symmetry() {
        for k in 0..2000 {
            let [a, b, c, ..] = noise(k);
            let axis = if k % 2 == 0 { f64::from(k % 16) * PI / 8.0 } else { c * PI };
            let (a, b) = (a * PI, b * PI);
            // Biquadratic: the same on either side of one axis, of both, and half a turn apart.
            four([axis + a, axis - a, axis + b, axis - b]);
            four([axis + a, axis - a, axis + PI + a, axis + PI - a]);
            four([axis, axis + FRAC_PI_2, axis + PI, axis - FRAC_PI_2]);
            four([axis, axis + a, axis + PI, axis + PI + a]);
            four([axis, axis, axis + PI, axis + PI]);
        }
    }

    #[test]
    fn a_second_harmonic_that_vanishes() {
        for k in 0..300 {
            let [a, b, c, d, ..] = noise(k);
            let a = if k % 3 == 0 { f64::from(k % 8) * PI / 4.0 - PI } else { a * PI };
            for digits in 0..20 {
                let by = if digits == 19 { 0.0 } else { 10.0_f64.powi(-digits) };
                two([a, b * PI], c * PI, 0.9 * by);
                two([a, a + PI], c * PI, 0.9 * by);
                two([a, a + 0.1 * d * by], c * PI, 0.9 * by);
                two([a, a + 1e-9 * d], c * PI, 0.9 * by);
                two([a, a + PI], a, 0.9 * by);
            }
        }
    }

    #[test]
    fn first_harmonics_of_every_size() {
        // Roots of cos(2 t) = -k0 - small, beside those of the second harmonic alone.
        for k in 0..500 {
            let [a, b, c, ..] = noise(k);
            for digits in 0..20 {
                let by = if digits == 19 { 0.0 } else { 10.0_f64.powi(-digits) };
                // Lines through points near both ends of two diameters.
                four([a, a + PI + by, b * PI, b * PI + PI - c * by]);
                four([a, b * PI, a + PI + by, b * PI + PI - c * by]);
                four([a, a + FRAC_PI_2 + by, a + PI, a - FRAC_PI_2 + c * by]);
            }
        }
    }

    #[test]
    fn a_double_root_that_rounding_has_lifted_comes_twice() {
        for k in 0..2000 {
            let [a, b, c, ..] = noise(k);
            for digits in 2..17 {
                let tangent = line(a * PI, 1.0 + 10.0_f64.powi(-digits));
                let circle = product(tangent, through([b * PI, c * PI]));
                let (found, len) = angles(&circle);
                let tolerance = 4.0 * 10.0_f64.powf(-0.5 * f64::from(digits)).max(1e-7);
                let near = found.iter().take(len).filter(|turn| apart(turn.value, a * PI) < tolerance).count();
                let alone = [b * PI, c * PI].iter().all(|t| apart(*t, a * PI) > 0.3);
                assert!(near >= 2 || !alone, "{a} {b} {c} {digits}: {found:?} {len}");
            }
        }
    }

    #[test]
    fn nothing_and_no_root() {
        let none = Circle { k0: 0.0, k1: [0.0; 2], k2: [0.0; 2] };
        assert_eq!(angles(&none).1, 0);
        assert_eq!(angles(&Circle { k0: 2.0, ..none }).1, 0);
        assert_eq!(angles(&Circle { k0: 2.0, k1: [0.3, 0.2], k2: [0.1, 0.4] }).1, 0);
        let (_, len) = angles(&Circle { k0: f64::NAN, k1: [1.0, 0.0], k2: [1.0, 0.0] });
        assert!(len <= 4);
    }
}
