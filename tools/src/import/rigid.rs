//! Rotations of the import: about any axis, and by right angles without rounding.

use std::f64::consts::PI;

use denhart_codegen::model::Angle;
pub use denhart_codegen::model::numeric::{Transform, cross, dot, length, sub};

pub type V = [f64; 3];

/// The angle; an exact one within `ROUNDING` of a multiple of 15 degrees.
pub fn rounded(angle: f64) -> Angle {
    exact_degrees(angle, ROUNDING).map_or_else(|| Angle::radians(angle), Angle::degrees)
}

/// The rounding of this module's arithmetic, rad or relative to the arm's size.
pub const ROUNDING: f64 = 1e-13;

/// The multiple of 15 degrees that is at most `within` rad away.
pub fn exact_degrees(angle: f64, within: f64) -> Option<f64> {
    let twelfths = (angle * 12.0 / PI).round();
    ((angle - twelfths * PI / 12.0).abs() <= within && twelfths.abs() < 1e6).then_some(15.0 * twelfths)
}

/// A turn about a unit vector (Rodrigues): `c I + s [w] + (1 - c) w w^T`.
pub fn about([x, y, z]: V, angle: f64) -> Transform {
    let angle = rounded(angle);
    let (s, c) = (angle.sin(), angle.cos());
    let k = 1.0 - c;
    let r = [
        [c + k * x * x, k * x * y - s * z, k * x * z + s * y],
        [k * x * y + s * z, c + k * y * y, k * y * z - s * x],
        [k * x * z - s * y, k * y * z + s * x, c + k * z * z],
    ];
    Transform { r, p: [0.0; 3] }
}

/// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, as URDF and the arm file have it.
pub fn of_origin(xyz: V, rpy: V) -> Transform {
    Transform::of_origin(xyz, rpy.map(rounded))
}

/// Roll, pitch and yaw; at a pitch of +-90 degrees the yaw is 0.
pub fn rpy(transform: &Transform) -> V {
    let [[r00, r01, r02], [r10, r11, r12], [r20, ..]] = transform.r;
    let level = r00.hypot(r10);
    let yaw = if level < ROUNDING { 0.0 } else { r10.atan2(r00) };
    let (s, c) = yaw.sin_cos();
    // Row 1 of Rz(-yaw) r is that of Rx(roll).
    let roll = (s * r02 - c * r12).atan2(c * r11 - s * r01);
    [roll, (-r20).atan2(level), yaw]
}

/// How far apart the origins are, and by what angle the axes differ, rad.
pub fn difference(one: &Transform, other: &Transform) -> (f64, f64) {
    // The rotation between two axes nearly alike: chord and angle agree to the third order.
    let chord = |column: usize| length(sub(one.axis(column), other.axis(column)));
    let squares: f64 = [0, 1, 2].map(chord).iter().map(|c| c * c).sum();
    (length(sub(one.p, other.p)), (squares / 2.0).sqrt())
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
        let turned = of_origin([0.0; 3], [PI / 2.0, 0.0, -PI / 2.0]);
        assert_eq!(turned.r, [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|row: V| row.map(|x| x + 0.0)));
        assert_eq!(about([0.0, 0.0, 1.0], PI / 2.0).turn([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn rpy_reads_back_even_where_roll_and_yaw_have_one_axis() {
        for angles in
            [[0.3, -0.8, 2.0], [0.0, PI / 2.0, 0.0], [1.1, -PI / 2.0, 0.7], [PI, 0.0, 0.0], [0.4, 1.570796, 1.0]]
        {
            let rigid = of_origin([1.0, 2.0, 3.0], angles);
            let (position, angle) = difference(&of_origin([1.0, 2.0, 3.0], rpy(&rigid)), &rigid);
            assert!(position < 1e-15 && angle < 2e-13, "{angles:?}: {angle:e}");
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
        let rigid = of_origin([1.0, -2.0, 0.5], [0.3, -0.8, 2.0]);
        let (position, angle) = difference(&rigid.then(&rigid.inverse()), &Transform::IDENTITY);
        assert!(position < 1e-15 && angle < 1e-15);
        assert!((difference(&rigid, &rigid.then(&about([1.0, 0.0, 0.0], 1e-7))).1 - 1e-7).abs() < 1e-14);
    }

    #[test]
    fn multiples_of_15_degrees_are_recognized() {
        assert_eq!(exact_degrees(1.570796, 1e-6), Some(90.0));
        assert_eq!(exact_degrees(1.5708, 1e-6), None);
        assert_eq!(exact_degrees(-PI / 12.0, 1e-15), Some(-15.0));
    }
}
