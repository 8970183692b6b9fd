//! Numbers of the arm that are known when code is generated, by what they stand for.

use super::label::Label;
use crate::model::Angle;
use crate::model::chain::End;
use std::fmt;

/// A number of the arm that is a named constant of generated code. Rows, joints and motors count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// `a` of a row.
    LinkLength(usize),
    /// `d` of a row.
    LinkOffset(usize),
    /// A component of the origin of the base or the tool.
    Origin(End, usize),
    /// An entry of the rotation of the base or the tool: row, column.
    Rotation(End, usize, usize),
    /// The sine of a constant angle.
    Sin(ConstantAngle),
    /// The cosine of a constant angle.
    Cos(ConstantAngle),
    /// Where the axes before and after the link of a joint intersect, along the one before or (`true`) after.
    Intersection(Label, bool),
    /// Where the axis of joint y intersects that of x or z, along the former.
    IntersectionOnY,
    /// The value of a motor where all joints are 0.
    MotorOffset(usize),
}

/// A constant angle, of which expressions have the sine and the cosine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ConstantAngle {
    /// `alpha` of a row, from 0.
    Alpha(usize),
    /// `theta` of a row, from 0.
    Theta(usize),
    /// Roll, pitch or yaw of the base or the tool.
    RollPitchYaw(End, usize),
    /// The joint's theta less the variable of its kernel.
    Phase(Label),
    /// An angle that belongs to no single row: it is named by its value.
    Turn(Angle),
}

impl Dimension {
    /// The number of the row, the joint or the motor that it belongs to, from 0.
    pub fn number(self) -> Option<usize> {
        match self {
            Dimension::LinkLength(n) | Dimension::LinkOffset(n) | Dimension::MotorOffset(n) => Some(n),
            Dimension::Sin(angle) | Dimension::Cos(angle) => match angle {
                ConstantAngle::Alpha(row) | ConstantAngle::Theta(row) => Some(row),
                ConstantAngle::Phase(label) => label.arm(),
                ConstantAngle::RollPitchYaw(..) | ConstantAngle::Turn(_) => None,
            },
            _ => None,
        }
    }
}

/// The name in generated code.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Dimension::LinkLength(row) => write!(f, "A{}", row + 1),
            Dimension::LinkOffset(row) => write!(f, "D{}", row + 1),
            Dimension::Origin(end, component) => write!(f, "{end}_{}", pick(["X", "Y", "Z"], *component)),
            Dimension::Rotation(end, row, column) => write!(f, "{end}_R{}{}", row + 1, column + 1),
            Dimension::Sin(angle) => write!(f, "SIN_{angle}"),
            Dimension::Cos(angle) => write!(f, "COS_{angle}"),
            Dimension::Intersection(link, after) => write!(f, "MEET{link}{}", if *after { "B" } else { "A" }),
            Dimension::IntersectionOnY => f.write_str("MEET_Y"),
            Dimension::MotorOffset(motor) => write!(f, "OFFSET{}", motor + 1),
        }
    }
}

impl fmt::Display for ConstantAngle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ConstantAngle::Alpha(row) => write!(f, "ALPHA{}", row + 1),
            ConstantAngle::Theta(row) => write!(f, "THETA{}", row + 1),
            ConstantAngle::RollPitchYaw(end, which) => write!(f, "{end}_{}", pick(["ROLL", "PITCH", "YAW"], *which)),
            ConstantAngle::Phase(joint) => write!(f, "PHASE{joint}"),
            ConstantAngle::Turn(angle) => {
                write!(f, "TURN_{}", angle.text().replace('-', "M").replace(['.', ' '], "_").to_uppercase())
            }
        }
    }
}

fn pick(names: [&'static str; 3], index: usize) -> &'static str {
    names.get(index).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_of_no_row_is_named_by_its_value() {
        let name = |angle: Angle| Dimension::Sin(ConstantAngle::Turn(angle)).to_string();
        let angles = [Angle::degrees(30.0), Angle::degrees(-12.5), Angle::degrees(12.500_000_1), Angle::radians(0.1)];
        let names = ["SIN_TURN_30_DEG", "SIN_TURN_M12_5_DEG", "SIN_TURN_12_5000001_DEG", "SIN_TURN_0_1_RAD"];
        assert_eq!(angles.map(name), names);
    }
}
