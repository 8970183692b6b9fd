//! What an import claims, and its proof: the file as it will be read, against the URDF.

use super::couple::Drive;
use super::number::short_lengths;
use super::path::Path;
use super::proof::{Difference, compare, of_chain};
use super::table::Table;
use super::urdf::Robot;
use super::write;
use crate::arm;

/// What the poses of file and URDF may differ by, m and rad.
pub const MOST: f64 = 1e-9;

/// A table, and the chains that it stands for.
pub struct Claim<'r> {
    /// The URDF as written.
    pub written: (&'r Robot, &'r Path<'r>),
    /// The same with its origins' angles made exact.
    pub exact: (&'r Robot, &'r Path<'r>),
    pub drive: &'r Drive,
    /// With angles of its own made exact.
    pub table: &'r Table,
    /// Whether there are such angles. The table then is that of neither chain.
    pub changed: bool,
    /// By how much the table before these changes misses the exact chain.
    pub same: Difference,
    /// By how much the file may miss the URDF as written.
    pub allowed: Difference,
}

/// A table that is proved.
pub struct Proved {
    pub table: Table,
    /// By how much lengths were rounded, m.
    pub lengths: Vec<f64>,
    /// By how much the file misses the URDF with the angles that were made exact.
    pub same: Difference,
    /// By how much the file misses the URDF as written.
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
        if same.most() <= MOST && all.position <= self.allowed.position && all.angle <= self.allowed.angle {
            return Ok(Proved { table, lengths, same, all });
        }
        Err(format!(
            "the table misses the URDF by {:.1e} m and {:.1e} rad ({:.1e} m and {:.1e} rad as written): expected at most {MOST:e}",
            same.position, same.angle, all.position, all.angle
        ))
    }
}
