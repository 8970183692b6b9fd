//! The constants of an arm for [`Meet`], from its ring.

use super::Structure;
use super::structure::{ZERO, normal};
use crate::Transform;
use crate::math::{Scalar, atan2, hypot};
use crate::transform::{Vector, cross, dot};

/// A ring is looked for elsewhere if a link about x3 or x4 is no longer than this part of the reach. The equation divides by
/// the links. With shorter ones [`general`](crate::general) finds more.
pub(super) const SHORTEST: f64 = 1e-4;

/// Constants of the ring `Rz(x1) K1 Rz(x2) K2 Rz(x3) K3 Rz(x4) K4 Rz(u) K5 Rz(v) K6 = 1`: see [`meet`](crate::meet).
///
/// Lengths are in the arm's unit of length, angles in rad. K1 is not part of the constants. Vectors of the plane across
/// the parallel axes are given along `ex` and `ey`, with `K2 = (R, o)` and
/// ```text
/// h = R z     eta = |h_xy|     H = h_xy / eta     ex = (-H_y, H_x, 0)     ey = h x ex
/// ```
/// If x3 and x4 are antiparallel, `Rx(pi)` stands after K3 and before K4, and x4 changes its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meet<T> {
    /// The joints x1, x2, x3, x4, u, v, numbered from 0 in the order of the chain.
    pub joints: [usize; 6],
    /// True if x4 is the negative of the chain's joint: x3 and x4 are antiparallel.
    pub is_antiparallel: bool,
    /// True if the branches (v, w) and (-v, -w) have the same roots: the polynomial is a square, and its root of degree 4
    /// takes its place. Holds if `h_z`, `across_x`, `across_y`, `height`, `ratio_y` and `tilt` are 0.
    pub has_equal_pairs: bool,
    /// The sum of the lengths of K2 to K6: thresholds of length are relative to it.
    pub reach: T,
    /// W as seen after v: `K6^-1 (0, 0, wv)`.
    pub point: Vector<T>,
    /// The direction of v as seen after v: `K6^-1 z`.
    pub normal: Vector<T>,
    /// A direction across v that turns with it: `K6^-1 x`.
    pub side: Vector<T>,
    /// Component of the parallel axes along the axis of x2: h_z.
    pub h_z: T,
    /// Component of the parallel axes across the axis of x2: eta = |h_xy|.
    pub eta: T,
    /// Direction of the parallel axes across the axis of x2: H = h_xy / eta.
    pub h_xy: [T; 2],
    /// Place of the axis of x3: ex . o.
    pub across_x: T,
    /// Place of the axis of x3: ey . o.
    pub across_y: T,
    /// Height of W along h: h . o, the height of K3's translation, and that of `K4 (0, 0, wu)`.
    pub height: T,
    /// Length a of the link from x3 to x4, across h.
    pub upper: T,
    /// Length y of the link from x4 to W, across h.
    pub lower: T,
    /// Real part of `Q = D conj(Y) / y^2`, of D, the direction of u (`K4 z`), and Y, the vector `K4 (0, 0, wu)`, both
    /// across h as complex numbers: how the direction of u follows the vector of the lower link.
    pub ratio_x: T,
    /// Imaginary part of Q.
    pub ratio_y: T,
    /// Component of the direction of u along h.
    pub tilt: T,
    /// Cosine of the angle between the axes of u and v: K5_zz.
    pub cos_alpha: T,
    /// The angle from R x to ex, which is x3 less the direction of its link: `atan2(-ex . R y, ex . R x) + arg A`.
    pub x3_offset: T,
    /// The angle of the elbow at x4 = 0: `arg Y + angle of K3 - arg A`.
    pub x4_offset: T,
    /// The direction of the lower link: arg Y.
    pub lower_angle: T,
    /// Rotation of K4.
    pub k4: [Vector<T>; 3],
    /// Rotation of K5.
    pub k5: [Vector<T>; 3],
}

impl<T: Scalar> Meet<T> {
    /// The constants, of the structure and of the ring K1 to K6 that [`Structure::ring`] gives. K1 is not read.
    ///
    /// `None` where the ring degenerates: u and v are parallel, all three of x2, x3 and x4 are, or one of the two links has no
    /// length. Exact to rounding if the structure is that of the ring; few digits are left where a link is short, see
    /// [`has_long_links`](Self::has_long_links).
    #[must_use]
    pub fn of(structure: &Structure, ring: &[Transform<T>; 6]) -> Option<Self> {
        let [k1, k2, k3, k4, k5, k6] = ring;
        let _ = k1;
        let half = Transform {
            rotation: [[T::ONE, T::ZERO, T::ZERO], [T::ZERO, -T::ONE, T::ZERO], [T::ZERO, T::ZERO, -T::ONE]],
            translation: [T::ZERO; 3],
        };
        let (k3, k4) = if structure.is_antiparallel { (*k3 * half, half * *k4) } else { (*k3, *k4) };
        let length = |link: &Transform<T>| dot(link.translation, link.translation).sqrt();
        let reach = length(k2) + length(&k3) + length(&k4) + length(k5) + length(k6);
        let (wu, wv) = normal(k5)?;

        let [ax, ay, a_height] = k3.translation;
        let [yx, yy, y_height] = k4.map([T::ZERO, T::ZERO, wu]);
        let [dx, dy, tilt] = k4.z();
        let (upper, lower) = (hypot(ax, ay), hypot(yx, yy));
        let h = k2.z();
        let [hx, hy, h_z] = h;
        let eta = hypot(hx, hy);
        let zero = T::from_f64(ZERO);
        if !(eta > zero && upper > zero * reach && lower > zero * reach) {
            return None;
        }
        let h_xy = [hx / eta, hy / eta];
        let ex = [-hy / eta, hx / eta, T::ZERO];
        let ey = cross(h, ex);
        let [rx, ry, _] = k2.axes();
        let ([[k3_cos, ..], [k3_sin, ..], _], y2) = (k3.rotation, yx * yx + yy * yy);
        let back = k6.inverse();
        let (arg_a, arg_y) = (atan2(ay, ax), atan2(yy, yx));
        let mut meet = Self {
            joints: structure.joints,
            is_antiparallel: structure.is_antiparallel,
            has_equal_pairs: false,
            reach,
            point: back.map([T::ZERO, T::ZERO, wv]),
            normal: back.z(),
            side: back.turn([T::ONE, T::ZERO, T::ZERO]),
            h_z,
            eta,
            h_xy,
            across_x: dot(ex, k2.translation),
            across_y: dot(ey, k2.translation),
            height: dot(h, k2.translation) + a_height + y_height,
            upper,
            lower,
            ratio_x: (dx * yx + dy * yy) / y2,
            ratio_y: (dy * yx - dx * yy) / y2,
            tilt,
            cos_alpha: dot(k5.z(), [T::ZERO, T::ZERO, T::ONE]),
            x3_offset: atan2(-dot(ex, ry), dot(ex, rx)) + arg_a,
            x4_offset: arg_y + atan2(k3_sin, k3_cos) - arg_a,
            lower_angle: arg_y,
            k4: k4.rotation,
            k5: k5.rotation,
        };
        meet.has_equal_pairs = meet.pairs_are_equal();
        Some(meet)
    }

    /// The length of the shorter one of the links about x3 and x4.
    pub(super) fn shorter_link(&self) -> T {
        self.upper.min(self.lower)
    }

    /// Returns true if the links about x3 and x4 are longer than 1e-4 of the reach.
    #[must_use]
    pub fn has_long_links(&self) -> bool {
        self.shorter_link() > T::from_f64(SHORTEST) * self.reach
    }

    /// Turning x2 by half a turn, with the elbow to the other side, leaves everything where it is.
    fn pairs_are_equal(&self) -> bool {
        let small = T::from_f64(4096.0) * T::EPSILON;
        let lengths = [self.height, self.across_x, self.across_y];
        let numbers = [self.h_z, self.tilt, self.ratio_y * self.lower];
        lengths.iter().all(|length| length.abs() <= small * (self.upper + self.lower))
            && numbers.iter().all(|number| number.abs() <= small)
    }
}
