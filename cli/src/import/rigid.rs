//! Rotations and translations of the import, as matrices: a rotation by a right angle has no rounding.

use std::f64::consts::PI;

use denhart_codegen::model::Angle;
pub use denhart_codegen::model::numeric::{cross, dot, length, sub};

pub type V = [f64; 3];

/// A rigid transform `x -> r x + p`, `r[row][column]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid {
    pub r: [V; 3],
    pub p: V,
}

/// Sine and cosine; exact ones within `rounding` of a multiple of 15 degrees.
fn sin_cos(angle: f64) -> (f64, f64) {
    match exact_degrees(angle, ROUNDING) {
        Some(degrees) => (Angle::degrees(degrees).sin(), Angle::degrees(degrees).cos()),
        None => angle.sin_cos(),
    }
}

/// The rounding of this module's arithmetic, rad or relative to the arm's size.
pub const ROUNDING: f64 = 1e-13;

/// The multiple of 15 degrees that is at most `within` rad away.
pub fn exact_degrees(angle: f64, within: f64) -> Option<f64> {
    let twelfths = (angle * 12.0 / PI).round();
    ((angle - twelfths * PI / 12.0).abs() <= within && twelfths.abs() < 1e6).then_some(15.0 * twelfths)
}

impl Rigid {
    pub const IDENTITY: Self = Self { r: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], p: [0.0; 3] };

    pub fn shift(p: V) -> Self {
        Self { p, ..Self::IDENTITY }
    }

    /// `Rx(angle)`
    pub fn about_x(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self { r: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]], p: [0.0; 3] }
    }

    /// `Ry(angle)`
    pub fn about_y(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self { r: [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]], p: [0.0; 3] }
    }

    /// `Rz(angle)`
    pub fn about_z(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self { r: [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], p: [0.0; 3] }
    }

    /// A turn about a unit vector (Rodrigues): `c I + s [w] + (1 - c) w w^T`.
    pub fn about([x, y, z]: V, angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        let k = 1.0 - c;
        let r = [
            [c + k * x * x, k * x * y - s * z, k * x * z + s * y],
            [k * x * y + s * z, c + k * y * y, k * y * z - s * x],
            [k * x * z - s * y, k * y * z + s * x, c + k * z * z],
        ];
        Self { r, p: [0.0; 3] }
    }

    /// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, as URDF and the arm file have it.
    pub fn of_origin(xyz: V, [roll, pitch, yaw]: V) -> Self {
        Self::shift(xyz).then(&Self::about_z(yaw)).then(&Self::about_y(pitch)).then(&Self::about_x(roll))
    }

    /// The transform whose rotation has these columns.
    pub fn of_columns([x, y, z]: [V; 3], p: V) -> Self {
        let row = |i: usize| [x, y, z].map(|column| entry(column, i));
        Self { r: [row(0), row(1), row(2)], p }
    }

    /// `self` after `inner`.
    pub fn then(&self, inner: &Self) -> Self {
        let columns = [0, 1, 2].map(|column| self.turn(inner.column(column)));
        Self::of_columns(columns, self.at(inner.p))
    }

    pub fn inverse(&self) -> Self {
        let turned = Self { r: [self.column(0), self.column(1), self.column(2)], p: [0.0; 3] };
        Self { p: scale(turned.turn(self.p), -1.0), ..turned }
    }

    /// Column of the rotation.
    pub fn column(&self, column: usize) -> V {
        self.r.map(|row| entry(row, column))
    }

    /// `r v`
    pub fn turn(&self, v: V) -> V {
        self.r.map(|row| dot(row, v))
    }

    /// `r v + p`
    pub fn at(&self, v: V) -> V {
        add(self.turn(v), self.p)
    }

    /// Roll, pitch and yaw; at a pitch of +-90 degrees the yaw is 0.
    pub fn rpy(&self) -> V {
        let [[r00, r01, r02], [r10, r11, r12], [r20, ..]] = self.r;
        let level = r00.hypot(r10);
        let yaw = if level < ROUNDING { 0.0 } else { r10.atan2(r00) };
        let (s, c) = yaw.sin_cos();
        // Row 1 of Rz(-yaw) r is that of Rx(roll).
        let roll = (s * r02 - c * r12).atan2(c * r11 - s * r01);
        [roll, (-r20).atan2(level), yaw]
    }

    /// How far apart the origins are, and by what angle the axes differ, rad.
    pub fn difference(&self, other: &Self) -> (f64, f64) {
        // The rotation between two axes nearly alike: chord and angle agree to the third order.
        let chord = |column: usize| length(sub(self.column(column), other.column(column)));
        let squares: f64 = [0, 1, 2].map(chord).iter().map(|c| c * c).sum();
        (length(sub(self.p, other.p)), (squares / 2.0).sqrt())
    }
}

fn entry(v: V, index: usize) -> f64 {
    v.get(index).copied().unwrap_or(0.0)
}

pub fn add([a, b, c]: V, [d, e, f]: V) -> V {
    [a + d, b + e, c + f]
}

pub fn scale(v: V, k: f64) -> V {
    v.map(|x| k * x)
}

/// The unit vector of `v`; `None` where it has no direction.
pub fn unit(v: V) -> Option<V> {
    // Its largest entry is taken out first: squares of large ones have no end.
    let largest = v.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scaled = v.map(|x| x / largest);
    let size = length(scaled);
    (largest.is_finite() && largest * size > 1e-12).then(|| scaled.map(|x| x / size))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::approx_constant, reason = "rounded angles are what is tested")]
    use super::*;

    #[test]
    fn right_angles_have_no_rounding() {
        let turned = Rigid::of_origin([0.0; 3], [PI / 2.0, 0.0, -PI / 2.0]);
        assert_eq!(turned.r, [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|row: V| row.map(|x| x + 0.0)));
        assert_eq!(Rigid::about([0.0, 0.0, 1.0], PI / 2.0).turn([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn rpy_reads_back_even_where_roll_and_yaw_have_one_axis() {
        for rpy in [[0.3, -0.8, 2.0], [0.0, PI / 2.0, 0.0], [1.1, -PI / 2.0, 0.7], [PI, 0.0, 0.0], [0.4, 1.570796, 1.0]]
        {
            let rigid = Rigid::of_origin([1.0, 2.0, 3.0], rpy);
            let (position, angle) = Rigid::of_origin([1.0, 2.0, 3.0], rigid.rpy()).difference(&rigid);
            assert!(position < 1e-15 && angle < 2e-13, "{rpy:?}: {angle:e}");
        }
    }

    #[test]
    fn a_direction_of_any_length_is_a_unit_vector() {
        for size in [1e-6, 1.0, 1e200, f64::MAX] {
            assert_eq!(unit([0.0, size, 0.0]), Some([0.0, 1.0, 0.0]));
        }
        let [x, y, _] = unit([3e300, -4e300, 0.0]).unwrap_or_default();
        assert!((x - 0.6).abs() < 1e-15 && (y + 0.8).abs() < 1e-15);
        for none in [[0.0; 3], [1e-13, 0.0, 0.0], [f64::NAN, 1.0, 0.0], [f64::INFINITY, 0.0, 0.0]] {
            assert_eq!(unit(none), None);
        }
    }

    #[test]
    fn an_inverse_undoes() {
        let rigid = Rigid::of_origin([1.0, -2.0, 0.5], [0.3, -0.8, 2.0]);
        let (position, angle) = rigid.then(&rigid.inverse()).difference(&Rigid::IDENTITY);
        assert!(position < 1e-15 && angle < 1e-15);
        assert!((rigid.difference(&rigid.then(&Rigid::about_x(1e-7))).1 - 1e-7).abs() < 1e-14);
    }

    #[test]
    fn multiples_of_15_degrees_are_recognized() {
        assert_eq!(exact_degrees(1.570796, 1e-6), Some(90.0));
        assert_eq!(exact_degrees(1.5708, 1e-6), None);
        assert_eq!(exact_degrees(-PI / 12.0, 1e-15), Some(-15.0));
    }
}
