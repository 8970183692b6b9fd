//! An arm computed from its table at run time: the plain product of its transforms.

mod motion;
mod numeric;
mod transform;

use core::fmt;
use std::vec::Vec;

use nalgebra::{Isometry3, IsometryMatrix3, Matrix6xX, Vector3};
use transform::Constants;

use crate::dh::{Convention, DhFrame, DhRow, DhTable, JointKind};

/// A serial arm given by its Denavit-Hartenberg table, with nothing generated and nothing simplified.
///
/// Its forward kinematics and Jacobian have the meaning of the generated ones, computed independently: one
/// homogeneous transform per row, multiplied from left to right. It is meant for checking, and for tables that are known only at
/// run time.
///
/// ```
/// use denhart::{Chain, Convention, DhRow};
/// use std::f64::consts::FRAC_PI_2;
///
/// let arm = Chain::new(
///     Convention::Standard,
///     &[DhRow::revolute(0.5, 0.0, 0.2, 0.0), DhRow::revolute(0.3, 0.0, 0.0, 0.0)],
/// );
/// let pose = arm.forward(&[FRAC_PI_2, -FRAC_PI_2])?;
/// assert!((pose.translation.x - 0.3).abs() < 1e-15);
/// assert!((pose.translation.y - 0.5).abs() < 1e-15);
/// assert_eq!(pose.translation.z, 0.2);
/// # Ok::<(), denhart::ChainError>(())
/// ```
#[derive(Clone)]
pub struct Chain {
    convention: Convention,
    rows: Vec<DhRow>,
    base: DhFrame,
    tool: DhFrame,
    /// The transforms of the table that no joint value changes, worked out once.
    constants: Constants,
}

impl Chain {
    /// An arm from its rows, lengths in one unit and angles in rad, without base and tool.
    #[must_use]
    pub fn new(convention: Convention, rows: &[DhRow]) -> Self {
        Self::of(convention, rows.to_vec(), DhFrame::IDENTITY, DhFrame::IDENTITY)
    }

    /// An arm from plain numbers: for each row its kind and `[a, alpha, d, theta]`.
    #[must_use]
    pub fn from_rows(convention: Convention, rows: impl IntoIterator<Item = (JointKind, [f64; 4])>) -> Self {
        let rows = rows.into_iter().map(|(kind, [a, alpha, d, theta])| DhRow { kind, a, alpha, d, theta }).collect();
        Self::of(convention, rows, DhFrame::IDENTITY, DhFrame::IDENTITY)
    }

    fn of(convention: Convention, rows: Vec<DhRow>, base: DhFrame, tool: DhFrame) -> Self {
        let constants = Constants::of(convention, &rows, &base, &tool);
        Self { convention, rows, base, tool, constants }
    }

    /// Sets the base: a constant frame before the first row.
    #[must_use]
    pub fn with_base(self, base: DhFrame) -> Self {
        Self::of(self.convention, self.rows, base, self.tool)
    }

    /// Sets the tool: a constant frame after the last row.
    #[must_use]
    pub fn with_tool(self, tool: DhFrame) -> Self {
        Self::of(self.convention, self.rows, self.base, tool)
    }

    /// Convention of the rows.
    #[must_use]
    pub fn convention(&self) -> Convention {
        self.convention
    }

    /// The rows, fixed ones included.
    #[must_use]
    pub fn rows(&self) -> &[DhRow] {
        &self.rows
    }

    /// Kinds of the joints in order: revolute or prismatic.
    #[must_use]
    pub fn kinds(&self) -> Vec<JointKind> {
        self.joints().collect()
    }

    /// Number of joints.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.joints().count()
    }

    fn joints(&self) -> impl Iterator<Item = JointKind> {
        self.rows.iter().map(|row| row.kind).filter(|kind| *kind != JointKind::Fixed)
    }

    /// Pose of the tool in the base frame, through base, all rows and tool.
    ///
    /// `q`: one value per joint, rad or length unit.
    ///
    /// # Errors
    /// If the length of `q` is not the number of joints.
    pub fn forward(&self, q: &[f64]) -> Result<Isometry3<f64>, ChainError> {
        Ok(quaternion_form(&self.walk(q, |_, _| {})?))
    }

    /// Poses of the links in the base frame, one per joint.
    ///
    /// Link i stands after the base, the rows up to and including joint i, and the fixed rows between joint i and the
    /// next joint. The last link is without the tool.
    ///
    /// # Errors
    /// If the length of `q` is not the number of joints.
    pub fn link_poses(&self, q: &[f64]) -> Result<Vec<Isometry3<f64>>, ChainError> {
        Ok(self.links(q)?.0.iter().map(quaternion_form).collect())
    }

    /// Geometric Jacobian `[6, dof]` in the base frame, at the tool point, rows `vx vy vz wx wy wz`.
    ///
    /// A revolute joint about the unit axis `z` through `o` gives the column `(z x (p - o), z)`, a prismatic joint
    /// `(z, 0)` (Whitney 1972).
    ///
    /// # Errors
    /// If the length of `q` is not the number of joints.
    pub fn jacobian(&self, q: &[f64]) -> Result<Matrix6xX<f64>, ChainError> {
        let mut axes = Vec::with_capacity(q.len());
        let tool = self.walk(q, |place, frame| {
            if place == Place::BeforeJoint {
                axes.push((frame.rotation * Vector3::z(), frame.translation.vector));
            }
        })?;
        let mut jacobian = Matrix6xX::zeros(axes.len());
        for (mut column, (kind, (axis, origin))) in jacobian.column_iter_mut().zip(self.joints().zip(&axes)) {
            let (linear, angular) = match kind {
                JointKind::Revolute => (axis.cross(&(tool.translation.vector - origin)), *axis),
                JointKind::Prismatic | JointKind::Fixed => (*axis, Vector3::zeros()),
            };
            column.fixed_rows_mut::<3>(0).copy_from(&linear);
            column.fixed_rows_mut::<3>(3).copy_from(&angular);
        }
        Ok(jacobian)
    }

    /// Frames of the links, one per joint, and of the tool.
    fn links(&self, q: &[f64]) -> Result<(Vec<Frame>, Frame), ChainError> {
        let mut links: Vec<Frame> = Vec::with_capacity(q.len());
        let tool = self.walk(q, |place, frame| match place {
            Place::BeforeJoint => {}
            Place::AfterJoint => links.push(*frame),
            // A fixed row belongs to the link of the joint before it.
            Place::AfterFixed => {
                if let Some(link) = links.last_mut() {
                    *link = *frame;
                }
            }
        })?;
        Ok((links, tool))
    }

    /// Goes once through the rows. Hands every frame on the way to `visit`, and returns the tool's.
    fn walk(&self, q: &[f64], mut visit: impl FnMut(Place, &Frame)) -> Result<Frame, ChainError> {
        let mismatch = || ChainError::JointCount { expected: self.dof(), found: q.len() };
        let mut values = q.iter();
        let mut frame = self.constants.base;
        for (row, around) in self.rows.iter().zip(&self.constants.around) {
            if let Some(before) = &around.before {
                frame *= before;
            }
            if row.kind == JointKind::Fixed {
                frame *= around.after;
                visit(Place::AfterFixed, &frame);
            } else {
                let value = *values.next().ok_or_else(mismatch)?;
                visit(Place::BeforeJoint, &frame);
                frame = transform::moved(&frame, row.kind, value) * around.after;
                visit(Place::AfterJoint, &frame);
            }
        }
        if values.next().is_some() {
            return Err(mismatch());
        }
        Ok(frame * self.constants.tool)
    }
}

/// A frame in the base frame. A matrix: a quarter turn is exact in it.
type Frame = IsometryMatrix3<f64>;

/// Where a frame stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// At a joint before it moves: the frame's z axis is the joint axis.
    BeforeJoint,
    /// At the end of a joint's row.
    AfterJoint,
    /// At the end of a fixed row.
    AfterFixed,
}

fn quaternion_form(frame: &Frame) -> Isometry3<f64> {
    Isometry3::from_parts(frame.translation, frame.rotation.into())
}

impl Chain {
    /// Table of the chain: convention, rows, base and tool.
    fn parts(&self) -> (Convention, &[DhRow], &DhFrame, &DhFrame) {
        (self.convention, &self.rows, &self.base, &self.tool)
    }
}

/// Chains of equal tables are equal.
impl PartialEq for Chain {
    fn eq(&self, other: &Self) -> bool {
        self.parts() == other.parts()
    }
}

impl fmt::Debug for Chain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (convention, rows, base, tool) = self.parts();
        f.debug_struct("Chain")
            .field("convention", &convention)
            .field("rows", &rows)
            .field("base", base)
            .field("tool", tool)
            .finish()
    }
}

impl From<&DhTable> for Chain {
    fn from(table: &DhTable) -> Self {
        Self::new(table.convention, table.rows).with_base(table.base).with_tool(table.tool)
    }
}

impl From<DhTable> for Chain {
    fn from(table: DhTable) -> Self {
        Self::from(&table)
    }
}

/// Why a [`Chain`] could not compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChainError {
    /// The length of the joint vector is not the number of joints.
    JointCount {
        /// Number of joints of the chain.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
}

impl fmt::Display for ChainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::JointCount { expected, found } = self;
        write!(f, "the arm has {expected} joints, but {found} joint values were given")
    }
}

impl core::error::Error for ChainError {}

#[cfg(test)]
mod tests;
