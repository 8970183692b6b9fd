//! The polynomial and its four branches at one angle of the held joint.

use super::Meet;
use crate::Transform;
use crate::branches::Branch;
use crate::math::Scalar;
use crate::pair::Pair;
use crate::wave::Wave;

/// An arm with its target: W and v as seen from before x2, as functions of the held angle t.
#[derive(Clone, Copy, Debug)]
pub(super) struct Posed<'a, T> {
    pub meet: &'a Meet<T>,
    /// p: the point W.
    pub point: Wave<T>,
    /// n: the direction of v.
    pub normal: Wave<T>,
    /// A direction across v.
    pub side: Wave<T>,
}

/// A branch with its two roots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Signed<T> {
    /// It misses by g: the cosine of the angle between the axes of u and v, less cos alpha. Its squares are
    /// v^2 in units of a y, and w^2 in those of the square of a y.
    pub branch: Branch<T>,
    /// The root v with its sign; 0 where it is imaginary.
    pub v: T,
    /// The root w with its sign; 0 where it is imaginary.
    pub w: T,
}

/// All that the branches have in common at one angle; pairs are numbers `even + odd v`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts<T> {
    /// The distance of W from the axis of x2, squared.
    pub rho2: T,
    /// The component of W, turned by x2, along H.
    pub u: T,
    /// The component along ex, squared.
    pub v2: T,
    /// W - o along ey.
    pub across_y: T,
    /// Distance of W from the axis of x3, squared.
    pub distance2: Pair<T>,
    /// w^2, of `w = 2 a y sin psi` with the elbow angle psi.
    pub w2: Pair<T>,
    /// `rho2 distance2 g = first + w second`
    first: Pair<T>,
    second: Pair<T>,
}

impl<'a, T: Scalar> Posed<'a, T> {
    pub fn of(meet: &'a Meet<T>, k1: &Transform<T>) -> Self {
        let to = k1.inverse();
        let point = Wave::of(meet.point, &to).plus(to.translation);
        Self { meet, point, normal: Wave::of(meet.normal, &to), side: Wave::of(meet.side, &to) }
    }

    /// False for a target that is not finite.
    pub fn is_finite(&self) -> bool {
        self.point.is_finite() && self.normal.is_finite() && self.side.is_finite()
    }

    /// The equations of the module's page for one angle, of its sine and cosine. Out of line where size counts, see
    /// `math::ONE_COPY`.
    #[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
    #[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline(always))]
    pub fn parts(&self, turn: (T, T)) -> Parts<T> {
        let m = self.meet;
        let ([px, py, pz], [nx, ny, nz]) = (self.point.at(turn), self.normal.at(turn));
        let rho2 = px * px + py * py;
        let u = (m.height - m.h_z * pz) / m.eta;
        let v2 = rho2 - u * u;
        let across_y = m.eta * pz - m.h_z * u - m.across_y;
        let distance2 = Pair::new(v2 + m.across_x * m.across_x + across_y * across_y, -T::TWO * m.across_x);
        let (a2, y2) = (m.upper * m.upper, m.lower * m.lower);
        let elbow = distance2.plus_real(-(a2 + y2));
        let w2 = Pair::new(T::from_f64(4.0) * a2 * y2, T::ZERO).minus(elbow.times(elbow, v2));

        // The direction of v after x2, times rho2: along ex, ey and h.
        let (along, across) = (nx * px + ny * py, px * ny - py * nx);
        let n_x = Pair::new(across * u, along);
        let n_y = Pair::new(m.eta * nz * rho2 - m.h_z * along * u, m.h_z * across);
        let n_h = Pair::new(m.eta * along * u + m.h_z * nz * rho2, -m.eta * across);
        // Q V, and half of what the lower link adds along and across V.
        let q_x = Pair::new(-m.ratio_x * m.across_x - m.ratio_y * across_y, m.ratio_x);
        let q_y = Pair::new(m.ratio_x * across_y - m.ratio_y * m.across_x, m.ratio_y);
        let high = distance2.plus_real(y2 - a2).scaled(T::HALF);
        let level = n_h.scaled(m.tilt).plus_real(-(m.cos_alpha * rho2));
        let first = n_x.times(q_x, v2).plus(n_y.times(q_y, v2)).times(high, v2).plus(level.times(distance2, v2));
        let second = n_y.times(q_x, v2).minus(n_x.times(q_y, v2)).scaled(T::HALF);
        Parts { rho2, u, v2, across_y, distance2, w2, first, second }
    }

    /// The product of the four g, cleared of its denominators, and the size of what clears them.
    ///
    /// Degree 8 in t, or the square root of it, of degree 4, for equal pairs. Not finite where W is on the axis of x2 or
    /// of x3.
    #[inline(always)]
    pub fn product_at(&self, turn: (T, T)) -> (T, T) {
        let p = self.parts(turn);
        let squares = p.second.times(p.second, p.v2).times(p.w2, p.v2);
        let norm = p.first.times(p.first, p.v2).minus(squares);
        let size = self.cleared(&p);
        (if self.meet.has_equal_pairs { norm.even } else { norm.norm(p.v2) } / size, size.abs())
    }

    /// The factor that clears the denominators of the product of the branches: `rho2^2 distance2(v) distance2(-v)`, or its square
    /// root for equal pairs.
    #[inline(always)]
    pub fn cleared(&self, p: &Parts<T>) -> T {
        if self.meet.has_equal_pairs { p.rho2 * p.distance2.even } else { p.rho2 * p.rho2 * p.distance2.norm(p.v2) }
    }

    /// One branch, of what all have in common. Bit 0 of its number is set for a negative v and bit 1 for a negative w.
    #[inline]
    pub fn signed(&self, p: &Parts<T>, number: usize) -> Signed<T> {
        let signed = |root: T, bit: usize| if number & bit == 0 { root } else { -root };
        let v = signed(p.v2.max(T::ZERO).sqrt(), 1);
        let w2 = p.w2.at(v);
        let w = signed(w2.max(T::ZERO).sqrt(), 2);
        let miss = (p.first.at(v) + w * p.second.at(v)) / (p.rho2 * p.distance2.at(v));
        let unit = T::ONE / (self.meet.upper * self.meet.lower);
        Signed { branch: Branch { miss, squares: [p.v2 * unit, w2 * unit * unit] }, v, w }
    }
}
