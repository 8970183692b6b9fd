//! An arm computed from its table at run time: the plain product of its transforms.

mod motion;
mod numeric;
mod transform;

use core::fmt;
use std::vec::Vec;

use nalgebra::{Isometry3, IsometryMatrix3, Matrix6xX, Vector3};

use crate::dh::{Convention, DhFrame, DhRow, DhTable, JointKind};

/// A serial arm given by its Denavit-Hartenberg table, with nothing generated and nothing simplified.
///
/// Its forward kinematics and Jacobian have the meaning of the generated ones, by another way: one homogeneous
/// transform per row, multiplied from left to right. It is meant for checking, and for tables that are known only at
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
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    convention: Convention,
    rows: Vec<DhRow>,
    base: DhFrame,
    tool: DhFrame,
}

impl Chain {
    /// An arm from its rows, lengths in one unit and angles in rad, without base and tool.
    #[must_use]
    pub fn new(convention: Convention, rows: &[DhRow]) -> Self {
        Self { convention, rows: rows.to_vec(), base: DhFrame::IDENTITY, tool: DhFrame::IDENTITY }
    }

    /// An arm from plain numbers: for each row its kind and `[a, alpha, d, theta]`.
    #[must_use]
    pub fn from_rows(convention: Convention, rows: impl IntoIterator<Item = (JointKind, [f64; 4])>) -> Self {
        let rows = rows.into_iter().map(|(kind, [a, alpha, d, theta])| DhRow { kind, a, alpha, d, theta }).collect();
        Self { convention, rows, base: DhFrame::IDENTITY, tool: DhFrame::IDENTITY }
    }

    /// The same arm with a constant frame before the first row.
    #[must_use]
    pub fn with_base(self, base: DhFrame) -> Self {
        Self { base, ..self }
    }

    /// The same arm with a constant frame after the last row.
    #[must_use]
    pub fn with_tool(self, tool: DhFrame) -> Self {
        Self { tool, ..self }
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
        self.rows.iter().map(|row| row.kind).filter(|kind| *kind != JointKind::Fixed).collect()
    }

    /// Number of joints.
    #[must_use]
    pub fn dof(&self) -> usize {
        self.rows.iter().filter(|row| row.kind != JointKind::Fixed).count()
    }

    /// Pose of the tool in the base frame, through base, all rows and tool.
    ///
    /// `q`: one value per joint, rad or length unit.
    ///
    /// # Errors
    /// When `q` has not one value per joint.
    pub fn forward(&self, q: &[f64]) -> Result<Isometry3<f64>, ChainError> {
        Ok(quaternion_form(&self.walk(q)?.tool))
    }

    /// Poses of the links in the base frame, one per joint.
    ///
    /// Link i stands after the base, the rows up to and including joint i, and the fixed rows between joint i and the
    /// next joint. The last link is without the tool.
    ///
    /// # Errors
    /// When `q` has not one value per joint.
    pub fn link_poses(&self, q: &[f64]) -> Result<Vec<Isometry3<f64>>, ChainError> {
        Ok(self.walk(q)?.links.iter().map(quaternion_form).collect())
    }

    /// Geometric Jacobian `[6, dof]` in the base frame, at the tool point, rows `vx vy vz wx wy wz`.
    ///
    /// A revolute joint about the unit axis `z` through `o` gives the column `(z x (p - o), z)`, a prismatic joint
    /// `(z, 0)` (Whitney 1972).
    ///
    /// # Errors
    /// When `q` has not one value per joint.
    pub fn jacobian(&self, q: &[f64]) -> Result<Matrix6xX<f64>, ChainError> {
        let Walk { axes, tool, .. } = self.walk(q)?;
        let mut jacobian = Matrix6xX::zeros(axes.len());
        for (mut column, (kind, frame)) in jacobian.column_iter_mut().zip(self.kinds().into_iter().zip(&axes)) {
            let axis = frame.rotation * Vector3::z();
            let (linear, angular) = match kind {
                JointKind::Revolute => (axis.cross(&(tool.translation.vector - frame.translation.vector)), axis),
                JointKind::Prismatic | JointKind::Fixed => (axis, Vector3::zeros()),
            };
            column.fixed_rows_mut::<3>(0).copy_from(&linear);
            column.fixed_rows_mut::<3>(3).copy_from(&angular);
        }
        Ok(jacobian)
    }

    /// Goes once through the rows and notes every frame on the way.
    fn walk(&self, q: &[f64]) -> Result<Walk, ChainError> {
        let mismatch = ChainError::JointCount { expected: self.dof(), found: q.len() };
        if q.len() != self.dof() {
            return Err(mismatch);
        }
        let mut values = q.iter();
        let (mut axes, mut links) = (Vec::new(), Vec::new());
        let mut frame = transform::of_frame(&self.base);
        for row in &self.rows {
            let value = match row.kind {
                JointKind::Fixed => 0.0,
                JointKind::Revolute | JointKind::Prismatic => *values.next().ok_or(mismatch)?,
            };
            let [before, after] = transform::around_joint(self.convention, row);
            frame *= before;
            if row.kind != JointKind::Fixed {
                axes.push(frame);
                links.push(frame);
            }
            frame = frame * transform::of_joint(row.kind, value) * after;
            // A fixed row belongs to the link of the joint before it.
            if let Some(link) = links.last_mut() {
                *link = frame;
            }
        }
        Ok(Walk { axes, links, tool: frame * transform::of_frame(&self.tool) })
    }
}

/// The frames of one joint vector, in the base frame. Matrices: a quarter turn is exact in them.
struct Walk {
    /// Frame of every joint before it moves: its z axis is the joint axis.
    axes: Vec<IsometryMatrix3<f64>>,
    links: Vec<IsometryMatrix3<f64>>,
    tool: IsometryMatrix3<f64>,
}

fn quaternion_form(frame: &IsometryMatrix3<f64>) -> Isometry3<f64> {
    Isometry3::from_parts(frame.translation, frame.rotation.into())
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
    /// The joint vector has not one value per joint.
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
