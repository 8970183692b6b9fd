//! The Denavit-Hartenberg table of an arm, as data.

use core::fmt;

use crate::math::radians;

/// Which frame the parameters of a row belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Convention {
    /// `A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i)`: Denavit and Hartenberg 1955, Paul 1981.
    Standard,
    /// `A_i = Rx(alpha_{i-1}) Tx(a_{i-1}) Rz(theta_i) Tz(d_i)`: Craig 1986. Row i holds `a_{i-1}` and `alpha_{i-1}`.
    Modified,
}

/// How a row of the table moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// The joint value, rad, adds to `theta`.
    Revolute,
    /// The joint value, in the length unit, adds to `d`.
    Prismatic,
    /// A constant row, without a joint value.
    Fixed,
}

/// Unit of every length of an arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LengthUnit {
    /// Meter.
    Meter,
    /// Centimeter.
    Centimeter,
    /// Millimeter.
    Millimeter,
    /// Inch, 25.4 mm.
    Inch,
}

impl LengthUnit {
    /// Length of the unit in meters.
    #[must_use]
    pub const fn in_meters(self) -> f64 {
        match self {
            Self::Meter => 1.0,
            Self::Centimeter => 0.01,
            Self::Millimeter => 0.001,
            Self::Inch => 0.0254,
        }
    }
}

/// The symbol: `m`, `cm`, `mm`, `in`.
impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Meter => "m",
            Self::Centimeter => "cm",
            Self::Millimeter => "mm",
            Self::Inch => "in",
        })
    }
}

/// One row of the table. Lengths in the arm's unit, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DhRow {
    /// How the row moves.
    pub kind: JointKind,
    /// Link length, along x.
    pub a: f64,
    /// Link twist, about x, rad.
    pub alpha: f64,
    /// Link offset, along z. The value of a prismatic joint adds to it.
    pub d: f64,
    /// Joint angle, about z, rad. The value of a revolute joint adds to it.
    pub theta: f64,
}

impl DhRow {
    /// A revolute joint, `alpha` and `theta` in rad; `theta` is the offset of its angle. In degrees:
    /// [`from_degrees`](Self::from_degrees).
    #[must_use]
    pub const fn revolute(a: f64, alpha: f64, d: f64, theta: f64) -> Self {
        Self { kind: JointKind::Revolute, a, alpha, d, theta }
    }

    /// A prismatic joint, `alpha` and `theta` in rad; `d` is the offset of its position.
    #[must_use]
    pub const fn prismatic(a: f64, alpha: f64, d: f64, theta: f64) -> Self {
        Self { kind: JointKind::Prismatic, a, alpha, d, theta }
    }

    /// A constant row, `alpha` and `theta` in rad.
    #[must_use]
    pub const fn fixed(a: f64, alpha: f64, d: f64, theta: f64) -> Self {
        Self { kind: JointKind::Fixed, a, alpha, d, theta }
    }

    /// A row of any kind, `alpha` and `theta` in degrees.
    #[must_use]
    pub fn from_degrees(kind: JointKind, a: f64, alpha: f64, d: f64, theta: f64) -> Self {
        Self { kind, a, alpha: radians(alpha), d, theta: radians(theta) }
    }
}

/// A constant frame: `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DhFrame {
    /// Position in the arm's length unit.
    pub xyz: [f64; 3],
    /// Roll, pitch, yaw about the fixed x, y, z axes, rad.
    pub rpy: [f64; 3],
}

impl DhFrame {
    /// The frame itself: no translation, no rotation.
    pub const IDENTITY: Self = Self { xyz: [0.0; 3], rpy: [0.0; 3] };
}

impl Default for DhFrame {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// The table of an arm: `T = base * row_1 * .. * row_n * tool`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DhTable {
    /// Convention of the rows.
    pub convention: Convention,
    /// The rows in order, fixed ones included.
    pub rows: &'static [DhRow],
    /// Constant frame before the first row.
    pub base: DhFrame,
    /// Constant frame after the last row.
    pub tool: DhFrame,
}

impl DhTable {
    /// Number of joints: the rows that are not fixed.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.rows.iter().filter(|row| row.kind != JointKind::Fixed).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    #[test]
    fn units_have_a_symbol_and_a_length() {
        let units = [LengthUnit::Meter, LengthUnit::Centimeter, LengthUnit::Millimeter, LengthUnit::Inch];
        assert_eq!(units.map(|unit| format!("{unit}")), ["m", "cm", "mm", "in"]);
        assert_eq!(units.map(LengthUnit::in_meters), [1.0, 0.01, 0.001, 0.0254]);
    }

    #[test]
    fn rows_in_degrees() {
        use core::f64::consts::{FRAC_PI_2, PI};
        let row = DhRow::from_degrees(JointKind::Prismatic, 0.5, -90.0, 0.2, 180.0);
        assert_eq!(row, DhRow::prismatic(0.5, -FRAC_PI_2, 0.2, PI));
    }

    #[test]
    fn fixed_rows_are_no_joints() {
        const ROWS: &[DhRow] = &[
            DhRow::fixed(0.0, 0.0, 1.0, 0.0),
            DhRow::revolute(1.0, 0.0, 0.0, 0.0),
            DhRow::prismatic(0.0, 0.0, 0.0, 0.0),
        ];
        let table =
            DhTable { convention: Convention::Standard, rows: ROWS, base: DhFrame::IDENTITY, tool: DhFrame::default() };
        assert_eq!(table.dof(), 2);
        assert_eq!(table.base, table.tool);
    }
}
