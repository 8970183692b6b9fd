//! A candidate for the arm file's table, and its proof: the file as it will be read, against the URDF.

use super::mimic_coupling::MimicCoupling;
use super::number::short_lengths;
use super::path::Path;
use super::proof::{Difference, compare, of_chain};
use super::table::Table;
use super::urdf::Robot;
use super::write;
use crate::{Arm, Error};

/// The most by which the poses of file and URDF may differ, m and rad, apart from angles made exact.
pub const MAX_DIFFERENCE: f64 = 1e-9;

/// A table that may go into the arm file, and the chains that it stands for.
pub struct CandidateTable<'r> {
    /// The URDF as written.
    pub written: (&'r Robot, &'r Path<'r>),
    /// The URDF with its origins' angles made exact.
    pub exact: (&'r Robot, &'r Path<'r>),
    pub coupling: &'r MimicCoupling,
    /// With angles of its own made exact.
    pub table: &'r Table,
    /// True where there are such angles. The table then is that of neither chain.
    pub changed: bool,
    /// The miss of the table before these changes against the exact chain.
    pub exact_angles: Difference,
    /// The most by which the file may miss the URDF as written: [`MAX_DIFFERENCE`] and the motion that changed angles
    /// make.
    pub allowed: Difference,
}

/// A table that is proved.
pub struct ProvedTable {
    pub table: Table,
    /// The change of each rounded length, m.
    pub lengths: Vec<f64>,
    /// The miss of the file against the URDF with the angles that were made exact.
    pub exact_angles: Difference,
    /// The miss of the file against the URDF as written.
    pub as_written: Difference,
}

impl CandidateTable<'_> {
    /// The table with lengths rounded by at most `width`, m or relative to the size of a smaller arm.
    ///
    /// # Errors
    /// The message: no arm file can say the chain, or the file misses the URDF.
    pub fn prove(&self, width: f64) -> Result<ProvedTable, String> {
        let (table, lengths) = short_lengths(self.table, width * self.table.size.min(1.0));
        let (robot, path) = self.written;
        let draft = write::file(&robot.name, &[], &table, self.coupling)?;
        let Arm { chain, .. } = Arm::of_text(&draft, "the imported arm")
            .map_err(|mistakes| format!("no arm file can say this chain:\n{}", Error::from(mistakes)))?;
        let misses = |(robot, path)| compare(robot, path, self.coupling, &|q| of_chain(&chain, q));
        let exact_angles = if self.changed { self.exact_angles } else { self.exact_angles.max(misses(self.exact)) };
        let as_written = misses((robot, path));
        let most = Difference { position: MAX_DIFFERENCE, angle: MAX_DIFFERENCE };
        let (missed, of, most) = if !exact_angles.is_within(most) {
            (exact_angles, "", most)
        } else if !as_written.is_within(self.allowed) {
            (as_written, " as written", self.allowed)
        } else {
            return Ok(ProvedTable { table, lengths, exact_angles, as_written });
        };
        Err(format!(
            "the table misses the URDF{of} by {:.1e} m and {:.1e} rad: expected at most {:.1e} m and {:.1e} rad",
            missed.position, missed.angle, most.position, most.angle
        ))
    }
}
