//! The elementary transforms of a table.

use core::f64::consts::FRAC_PI_2;
use std::vec::Vec;

use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3};

use crate::dh::{Convention, DhFrame, DhRow, JointKind};

/// The constant transforms of a chain.
#[derive(Clone)]
pub(super) struct Constants {
    pub(super) base: IsometryMatrix3<f64>,
    /// One for each row.
    pub(super) around: Vec<Around>,
    pub(super) tool: IsometryMatrix3<f64>,
}

/// Constant transforms before and after the motion of a row's joint.
///
/// The motion commutes with `Rz(theta) Tz(d)`, so these are constants. In the standard convention nothing stands before
/// it and `Rz Tz Tx Rx` after it, in the modified one `Rx Tx` before and `Rz Tz` after.
#[derive(Clone, Copy)]
pub(super) struct Around {
    pub(super) before: Option<IsometryMatrix3<f64>>,
    pub(super) after: IsometryMatrix3<f64>,
}

impl Constants {
    /// Constants of a table.
    pub(super) fn of(convention: Convention, rows: &[DhRow], base: &DhFrame, tool: &DhFrame) -> Self {
        let around = rows.iter().map(|row| Around::of(convention, row)).collect();
        Self { base: of_frame(base), around, tool: of_frame(tool) }
    }
}

impl Around {
    fn of(convention: Convention, row: &DhRow) -> Self {
        let along_z = rotation_z(sin_cos_of_constant(row.theta)) * translation(0.0, 0.0, row.d);
        let twist = rotation_x(sin_cos_of_constant(row.alpha));
        match convention {
            Convention::Standard => Self { before: None, after: along_z * translation(row.a, 0.0, 0.0) * twist },
            Convention::Modified => Self { before: Some(twist * translation(row.a, 0.0, 0.0)), after: along_z },
        }
    }
}

/// A frame moved by the joint at its z axis, whose value is rad or a length.
pub(super) fn moved(frame: &IsometryMatrix3<f64>, kind: JointKind, value: f64) -> IsometryMatrix3<f64> {
    let (rotation, origin) = (frame.rotation.matrix(), frame.translation.vector);
    match kind {
        JointKind::Revolute => {
            let (s, c) = value.sin_cos();
            let (x, y) = (rotation.column(0), rotation.column(1));
            let turned = Matrix3::from_columns(&[x * c + y * s, y * c - x * s, rotation.column(2).into()]);
            IsometryMatrix3::from_parts(frame.translation, Rotation3::from_matrix_unchecked(turned))
        }
        JointKind::Prismatic => {
            IsometryMatrix3::from_parts((origin + rotation.column(2) * value).into(), frame.rotation)
        }
        JointKind::Fixed => *frame,
    }
}

/// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`.
fn of_frame(frame: &DhFrame) -> IsometryMatrix3<f64> {
    let [x, y, z] = frame.xyz;
    let [roll, pitch, yaw] = frame.rpy.map(sin_cos_of_constant);
    translation(x, y, z) * rotation_z(yaw) * rotation_y(pitch) * rotation_x(roll)
}

fn translation(x: f64, y: f64, z: f64) -> IsometryMatrix3<f64> {
    IsometryMatrix3::from_parts(Translation3::new(x, y, z), Rotation3::identity())
}

fn rotation_x((s, c): (f64, f64)) -> IsometryMatrix3<f64> {
    rotation(Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c))
}

fn rotation_y((s, c): (f64, f64)) -> IsometryMatrix3<f64> {
    rotation(Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c))
}

fn rotation_z((s, c): (f64, f64)) -> IsometryMatrix3<f64> {
    rotation(Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0))
}

fn rotation(matrix: Matrix3<f64>) -> IsometryMatrix3<f64> {
    IsometryMatrix3::from_parts(Translation3::identity(), Rotation3::from_matrix_unchecked(matrix))
}

/// Sine and cosine of a constant of the table; exact where it stands for a multiple of a quarter turn.
///
/// Of a quarter turn `f64` holds only a neighbor, with a cosine of 6e-17. An angle within a rounding of it, up to two
/// turns, is read as meant; a larger one is no constant that anyone writes.
fn sin_cos_of_constant(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round();
    let is_meant = quarters.abs() <= 8.0 && (angle - quarters * FRAC_PI_2).abs() <= f64::EPSILON * angle.abs();
    match (is_meant, quarters.rem_euclid(4.0)) {
        (true, 0.0) => (0.0, 1.0),
        (true, 1.0) => (1.0, 0.0),
        (true, 2.0) => (0.0, -1.0),
        (true, 3.0) => (-1.0, 0.0),
        _ => angle.sin_cos(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let exact = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
        for turns in -8_i32..=8 {
            let expected = exact.iter().copied().cycle().nth(turns.rem_euclid(4) as usize);
            assert_eq!(Some(sin_cos_of_constant(f64::from(turns) * FRAC_PI_2)), expected, "{turns}");
            assert_eq!(Some(sin_cos_of_constant(f64::from(90 * turns).to_radians())), expected, "{turns}");
        }
    }

    #[test]
    fn other_angles_are_not_snapped() {
        for angle in [1.57_f64, FRAC_PI_2 + 1e-15, 1e-300, 0.3, 45_f64.to_radians(), 1e6 * FRAC_PI_2, 1e22] {
            assert_eq!(sin_cos_of_constant(angle), angle.sin_cos(), "{angle}");
        }
        assert!(sin_cos_of_constant(f64::NAN).0.is_nan() && sin_cos_of_constant(f64::INFINITY).1.is_nan());
    }
}
