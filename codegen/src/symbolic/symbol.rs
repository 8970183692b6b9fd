//! The leaves of expressions by what they stand for. The names that they have in generated code follow from that.

use super::dimension::Dimension;
use super::label::Label;
use std::fmt;

/// A leaf.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// A dimension of the arm, and the bits of its value, which is known when the code is generated.
    Dimension(Dimension, u64),
    /// A parameter that is bound at run time: a field of the arm, which the function calls `owner`.
    Parameter {
        /// Name of the arm in the function.
        owner: &'static str,
        /// The field.
        field: String,
    },
    /// A number of the target, or of what is given beside it.
    Input(Input),
    /// Unknown that the stage of a joint gives.
    Unknown(Unknown),
    /// A run-time value that only the expression which made it refers to.
    Named(String),
}

impl Symbol {
    /// The value, if it is known when the code is generated.
    pub fn value(&self) -> Option<f64> {
        match self {
            Symbol::Dimension(_, bits) => Some(f64::from_bits(*bits)),
            _ => None,
        }
    }

    /// The name in generated code, of a field without its owner.
    pub fn name(&self) -> String {
        match self {
            Symbol::Dimension(dimension, _) => dimension.to_string(),
            Symbol::Named(name) | Symbol::Parameter { field: name, .. } => name.clone(),
            Symbol::Input(input) => input.name(),
            Symbol::Unknown(unknown) => unknown.to_string(),
        }
    }
}

impl From<&str> for Symbol {
    fn from(name: &str) -> Self {
        Symbol::Named(name.to_string())
    }
}

impl From<String> for Symbol {
    fn from(name: String) -> Self {
        Symbol::Named(name)
    }
}

impl From<Input> for Symbol {
    fn from(input: Input) -> Self {
        Symbol::Input(input)
    }
}

impl From<Unknown> for Symbol {
    fn from(unknown: Unknown) -> Self {
        Symbol::Unknown(unknown)
    }
}

/// A part of a joint value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The angle, or the displacement of a prismatic joint.
    Value,
    /// The sine.
    Sin,
    /// The cosine.
    Cos,
}

/// Unknown that the stage of a joint gives: `q3`, `s3`, `c3`. Where the variable of its kernel differs from the joint
/// value by a constant: `t3`, `sin_t3`, `cos_t3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Unknown {
    /// The joint.
    pub joint: Label,
    /// Which part.
    pub part: Part,
    /// True for the kernel's variable, where that is not the joint value.
    pub shifted: bool,
}

impl Unknown {
    /// A part of the joint value itself.
    pub fn of(joint: Label, part: Part) -> Self {
        Unknown { joint, part, shifted: false }
    }

    /// Both that there are of one part.
    pub fn both(joint: Label, part: Part) -> [Self; 2] {
        [false, true].map(|shifted| Unknown { joint, part, shifted })
    }
}

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = match (self.part, self.shifted) {
            (Part::Value, false) => "q",
            (Part::Value, true) => "t",
            (Part::Sin, false) => "s",
            (Part::Sin, true) => "sin_t",
            (Part::Cos, false) => "c",
            (Part::Cos, true) => "cos_t",
        };
        write!(f, "{letter}{}", self.joint)
    }
}

/// A number of the target, or of what is given beside it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Input {
    /// Entry of the rotation: row, column, from 0.
    Rotation(usize, usize),
    /// Component of the position.
    Position(usize),
    /// The angle in the arm's plane, rad.
    Angle,
    /// Its sine.
    SinAngle,
    /// Its cosine.
    CosAngle,
    /// The direction in the base's plane, rad.
    Phi,
    /// Its sine.
    SinPhi,
    /// Its cosine.
    CosPhi,
    /// The value of the given joint, from 0.
    Given(usize),
    /// Its sine.
    SinGiven(usize),
    /// Its cosine.
    CosGiven(usize),
}

impl Input {
    /// The rotation, by rows.
    pub const ROTATION: [[Input; 3]; 3] = [
        [Input::Rotation(0, 0), Input::Rotation(0, 1), Input::Rotation(0, 2)],
        [Input::Rotation(1, 0), Input::Rotation(1, 1), Input::Rotation(1, 2)],
        [Input::Rotation(2, 0), Input::Rotation(2, 1), Input::Rotation(2, 2)],
    ];
    /// The position.
    pub const POSITION: [Input; 3] = [Input::Position(0), Input::Position(1), Input::Position(2)];

    /// A part of the given joint's value.
    pub fn given(joint: usize, part: Part) -> Input {
        match part {
            Part::Value => Input::Given(joint),
            Part::Sin => Input::SinGiven(joint),
            Part::Cos => Input::CosGiven(joint),
        }
    }

    /// The name in generated code.
    pub fn name(self) -> String {
        match self {
            Input::Rotation(row, column) => format!("r{}{}", row + 1, column + 1),
            Input::Position(component) => ["px", "py", "pz"].get(component).copied().unwrap_or_default().to_string(),
            Input::Angle => "angle".into(),
            Input::SinAngle => "sin_angle".into(),
            Input::CosAngle => "cos_angle".into(),
            Input::Phi => "phi".into(),
            Input::SinPhi => "sin_phi".into(),
            Input::CosPhi => "cos_phi".into(),
            Input::Given(joint) => format!("q{}", joint + 1),
            Input::SinGiven(joint) => format!("s{}", joint + 1),
            Input::CosGiven(joint) => format!("c{}", joint + 1),
        }
    }
}
