//! The claim of an import and its proof: the file as it will be read, against the URDF.

use super::couple::Drive;
use super::number::short_lengths;
use super::path::Path;
use super::proof::{Difference, compare, of_chain};
use super::table::Table;
use super::urdf::Robot;
use super::write;
use crate::arm;

/// The most by which the poses of file and URDF may differ, m and rad, apart from angles made exact.
pub const MOST: f64 = 1e-9;

/// A table, and the chains that it stands for.
pub struct Claim<'r> {
    /// The URDF as written.
    pub written: (&'r Robot, &'r Path<'r>),
    /// The URDF with its origins' angles made exact.
    pub exact: (&'r Robot, &'r Path<'r>),
    pub drive: &'r Drive,
    /// With angles of its own made exact.
    pub table: &'r Table,
    /// True where there are such angles. The table then is that of neither chain.
    pub changed: bool,
    /// The miss of the table before these changes against the exact chain.
    pub same: Difference,
    /// The most by which the file may miss the URDF as written: [`MOST`] and the motion that changed angles make.
    pub allowed: Difference,
}

/// A table that is proved.
pub struct Proved {
    pub table: Table,
    /// The change of each rounded length, m.
    pub lengths: Vec<f64>,
    /// The miss of the file against the URDF with the angles that were made exact.
    pub same: Difference,
    /// The miss of the file against the URDF as written.
    pub all: Difference,
}

impl Claim<'_> {
    /// The table with lengths rounded by at most `width`, m or relative to the size of a smaller arm.
    ///
    /// # Errors
    /// The message: no arm file can say the chain, or the file misses the URDF.
    pub fn prove(&self, width: f64) -> Result<Proved, String> {
        let (table, lengths) = short_lengths(self.table, width * self.table.size.min(1.0));
        let (robot, path) = self.written;
        let draft = write::file(&robot.name, &[], &table, self.drive)?;
        let arm::Arm { chain, .. } = arm::of_text(&draft, "the imported arm")
            .map_err(|errors| format!("no arm file can say this chain:\n{errors}"))?;
        let misses = |(robot, path)| compare(robot, path, self.drive, &|q| of_chain(&chain, q));
        let same = if self.changed { self.same } else { self.same.max(misses(self.exact)) };
        let all = misses((robot, path));
        let most = Difference { position: MOST, angle: MOST };
        let (missed, of, most) = if !same.is_within(most) {
            (same, "", most)
        } else if !all.is_within(self.allowed) {
            (all, " as written", self.allowed)
        } else {
            return Ok(Proved { table, lengths, same, all });
        };
        Err(format!(
            "the table misses the URDF{of} by {:.1e} m and {:.1e} rad: expected at most {:.1e} m and {:.1e} rad",
            missed.position, missed.angle, most.position, most.angle
        ))
    }
}
