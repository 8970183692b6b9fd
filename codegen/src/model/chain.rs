//! The chain as a product of elementary transforms, the same for both conventions.

use std::collections::HashMap;
use std::fmt;

use super::angle::Angle;
use super::arm::{Frame, Model};
use crate::spec::{Convention, Length, RowKind};

/// Which end of the arm a constant frame stands at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum End {
    /// Before the first row.
    Base,
    /// After the last row.
    Tool,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            End::Base => "BASE",
            End::Tool => "TOOL",
        })
    }
}

/// A factor of `T = base . rows . tool`. Rows and joints count from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Elementary {
    /// `R_x(angle)`
    RotateX {
        /// The twist.
        angle: Angle,
        /// The row that it belongs to.
        row: usize,
    },
    /// `R_z(angle)`, constant.
    RotateZ {
        /// The angle.
        angle: Angle,
        /// The row that it belongs to.
        row: usize,
    },
    /// `T_x(length)`
    ShiftX {
        /// In the file's unit.
        length: Length,
        /// The row that it belongs to.
        row: usize,
    },
    /// `T_z(length)`
    ShiftZ {
        /// In the file's unit.
        length: Length,
        /// The row that it belongs to.
        row: usize,
    },
    /// `R_z(q + offset)`
    Revolute {
        /// Which joint.
        joint: usize,
        /// The row's theta.
        offset: Angle,
    },
    /// `T_z(q)`
    Prismatic {
        /// Which joint.
        joint: usize,
    },
    /// A general constant frame: base or tool.
    Frame {
        /// The frame.
        frame: Frame,
        /// Which of the two.
        end: End,
    },
}

impl Elementary {
    /// The moving joint, if the step is one.
    pub fn joint(&self) -> Option<usize> {
        match self {
            Elementary::Revolute { joint, .. } | Elementary::Prismatic { joint } => Some(*joint),
            _ => None,
        }
    }
}

/// The elementary transforms in order, without those that change nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// The transforms, left to right.
    pub transforms: Vec<Elementary>,
    /// For every joint the number of transforms up to the end of its link: the row of the joint and the fixed rows after.
    pub link_ends: Vec<usize>,
}

impl Chain {
    /// The chain of a checked model.
    pub fn of(model: &Model) -> Chain {
        let mut steps = Vec::new();
        let mut link_ends = Vec::new();
        push_frame(&mut steps, &model.base, End::Base);
        for (index, row) in model.rows.iter().enumerate() {
            let mut twist = Vec::new();
            if !row.a.is_zero() {
                twist.push(Elementary::ShiftX { length: row.a.clone(), row: index });
            }
            if !row.alpha.is_zero() {
                twist.push(Elementary::RotateX { angle: row.alpha, row: index });
            }
            let mut motion = Vec::new();
            match (row.kind, row.joint) {
                (RowKind::Revolute, Some(joint)) => motion.push(Elementary::Revolute { joint, offset: row.theta }),
                _ if !row.theta.is_zero() => motion.push(Elementary::RotateZ { angle: row.theta, row: index }),
                _ => {}
            }
            if let (RowKind::Prismatic, Some(joint)) = (row.kind, row.joint) {
                motion.push(Elementary::Prismatic { joint });
            }
            if !row.d.is_zero() {
                motion.push(Elementary::ShiftZ { length: row.d.clone(), row: index });
            }
            match model.convention {
                Convention::Standard => steps.extend(motion.into_iter().chain(twist)),
                Convention::Modified => steps.extend(twist.into_iter().chain(motion)),
            }
            match row.joint {
                Some(_) => link_ends.push(steps.len()),
                None => {
                    if let Some(end) = link_ends.last_mut() {
                        *end = steps.len();
                    }
                }
            }
        }
        push_frame(&mut steps, &model.tool, End::Tool);
        Chain { transforms: steps, link_ends }
    }

    /// Returns the chain with its parameters at the given values, all lengths numbers.
    pub fn at(&self, values: &HashMap<String, f64>) -> Chain {
        let number = |length: &Length| Length::Constant(length.at(values));
        let step = |step: &Elementary| match step.clone() {
            Elementary::ShiftX { length, row } => Elementary::ShiftX { length: number(&length), row },
            Elementary::ShiftZ { length, row } => Elementary::ShiftZ { length: number(&length), row },
            Elementary::Frame { frame, end } => {
                let xyz = frame.xyz.each_ref().map(number);
                Elementary::Frame { frame: Frame { xyz, ..frame }, end }
            }
            other => other,
        };
        Chain { transforms: self.transforms.iter().map(step).collect(), link_ends: self.link_ends.clone() }
    }

    /// The constant transforms before, between and after the joints: one more list than joints.
    pub fn links(&self) -> Vec<Vec<Elementary>> {
        let mut links = vec![Vec::new()];
        for step in &self.transforms {
            match (step.joint(), links.last_mut()) {
                (None, Some(link)) => link.push(step.clone()),
                _ => links.push(Vec::new()),
            }
        }
        links
    }
}

fn push_frame(steps: &mut Vec<Elementary>, frame: &Frame, end: End) {
    let moves = frame.xyz.iter().any(|x| !x.is_zero()) || frame.rpy.iter().any(|a| !a.is_zero());
    if moves {
        steps.push(Elementary::Frame { frame: frame.clone(), end });
    }
}
