//! The report on an import: as the head comment of the arm file, as remarks, and as JSON.

use std::f64::consts::PI;

use serde_json::{Value, json};

use super::axes::Change;
use super::mimic_coupling::MimicCoupling;
use super::path::{Gripper, Path};
use super::proof::{CONFIGURATIONS, Difference};
use super::rigid::exact_degrees;

/// An angle this near to a multiple of 15 degrees, rad, that is not made exact is remarked.
const LOOKS_ROUNDED: f64 = 1e-4;

/// No arm is as long as this, m.
const LONGEST: f64 = 50.0;

/// An angle that is nearly a multiple of 15 degrees and was left as it is.
struct Nearly<'s> {
    /// Which one of the joint's origin.
    what: &'static str,
    joint: &'s str,
    /// As it is written, rad.
    angle: f64,
    /// From the multiple, rad.
    off: f64,
}

/// The findings of an import.
pub struct Report<'s> {
    /// The name of the URDF.
    pub from: &'s str,
    pub path: &'s Path<'s>,
    pub changes: &'s [Change],
    /// The change of each rounded length, m.
    pub lengths: &'s [f64],
    pub coupling: &'s MimicCoupling,
    /// The longest the chain can be, m.
    pub reach: f64,
    /// The miss of the file against the URDF with the angles that were made exact.
    pub exact_angles: Difference,
    /// The miss of the file against the URDF as written.
    pub as_written: Difference,
    /// The kind of the file that was read.
    pub source: Source,
    /// The remark about the inverse.
    pub inverse: Option<String>,
}

/// The kind of a file that is imported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A description of a robot.
    Urdf,
    /// Links that were measured: an angle that is nearly a round number is not meant to be that.
    Calibration,
    /// The parameters of an orthogonal base and a spherical wrist.
    Opw,
}

impl Report<'_> {
    /// The kind of the file that was read.
    fn source(&self) -> &'static str {
        match self.source {
            Source::Urdf => "URDF",
            Source::Calibration => "calibration",
            Source::Opw => "OPW file",
        }
    }

    /// The head comment of the file.
    pub fn head(&self) -> Vec<String> {
        let Self { from, path, coupling, .. } = self;
        let version = env!("CARGO_PKG_VERSION");
        let mut lines = vec![
            format!("Imported from {from}, `{}` to `{}`, by denhart {version}.", path.base, path.tool),
            format!("Zero and direction of each joint are those of the {}.", self.source()),
        ];
        lines.extend(self.proof());
        lines.extend(self.renamed());
        lines.extend(self.endless());
        for (motor, sum) in coupling.motors.iter().zip(&coupling.sums) {
            let name = &motor.file_name;
            if let [_, _, ..] = sum[..] {
                lines.push(format!("Joint `{name}` of this file is the sum of the URDF's {}.", sum.join(", ")));
            }
        }
        lines
    }

    fn proof(&self) -> Vec<String> {
        let (Difference { position, angle }, source) = (self.exact_angles, self.source());
        let mut lines = vec![format!(
            "At {CONFIGURATIONS} random configurations the pose differs from the {source}'s by at most {position:.1e} m and {angle:.1e} rad."
        )];
        if let Some(largest) = self.changes.iter().map(Change::size).max_by(f64::total_cmp) {
            let (count, Difference { position, angle }) = (self.changes.len(), self.as_written);
            let were = if count == 1 { "angle was" } else { "angles were" };
            lines.push(format!(
                "{count} {were} made exact before that, by at most {largest:.1e} rad. From the {source} as written the pose differs by"
            ));
            lines.push(format!("at most {position:.1e} m and {angle:.1e} rad."));
        }
        if let Some(most) = self.lengths.iter().copied().max_by(f64::total_cmp) {
            let were = if self.lengths.len() == 1 { "length was" } else { "lengths were" };
            lines.push(format!("{} {were} rounded to a micrometer, by at most {most:.1e} m.", self.lengths.len()));
        }
        lines
    }

    /// The joints with another name in the file.
    fn renamed(&self) -> Vec<String> {
        let pairs = self.coupling.renamed();
        let pairs: Vec<String> = pairs.into_iter().map(|(name, new)| format!("`{name}` is `{new}`")).collect();
        let line = || format!("In an arm file `q1` means joint 1. So the URDF's joint {} here.", pairs.join(", "));
        (!pairs.is_empty()).then(line).into_iter().collect()
    }

    /// The joints of the chain with an end that is so far away that it is none: as a line each.
    fn endless(&self) -> Vec<String> {
        let joints = self.path.joints.iter().map(|passed| passed.joint);
        let told = joints.filter_map(|joint| {
            let [low, high] = joint.endless?;
            let shown = |end: f64| if end.abs() < 1e6 { end.to_string() } else { format!("{end:e}") };
            let (name, low, high) = (&joint.name, shown(low), shown(high));
            Some(format!("Joint `{name}` has the limits {low} to {high}: an end beyond 1e6 is taken as none."))
        });
        told.collect()
    }

    /// A chain longer than any arm is probably one in millimeters.
    fn in_millimeters(&self) -> Option<String> {
        let source = self.source();
        (self.reach > LONGEST).then(|| {
            format!(
                "the chain is {:.0} m long: is this {source} in millimeters?\nhelp: lengths of a {source} are m. Scale the {source}, \
                 or write `length: mm` under `units` in the arm file",
                self.reach
            )
        })
    }

    /// A gripper that is left out.
    fn gripper(&self) -> Option<String> {
        let Gripper { joint, end } = self.path.gripper.as_ref()?;
        let told = format!("the chain ends before joint `{joint}`, which moves a gripper or a hand");
        Some(format!("{told}\nhelp: --tool {end} takes it in"))
    }

    /// The remarks beside the file.
    pub fn remarks(&self, within: f64) -> Vec<String> {
        let Self { path, .. } = self;
        let mut lines = vec![format!("chain: `{}` to `{}`", path.base, path.tool)];
        lines.extend(self.changes.iter().map(|change| {
            format!(
                "made exact: {}, {} rad, is {} deg now ({:.1e} rad)",
                change.of,
                change.from,
                change.to,
                change.size()
            )
        }));
        lines.extend(self.nearly_line(within));
        lines.extend(self.proof());
        lines.extend(self.renamed());
        lines.extend(self.endless());
        lines.extend(self.in_millimeters());
        lines.extend(self.gripper());
        lines.extend(self.inverse.clone());
        lines
    }

    /// The findings as JSON: lengths in m, angles in the unit that the key names.
    pub fn json(&self, within: f64) -> Value {
        let difference = |of: Difference| json!({"position_m": of.position, "angle_rad": of.angle});
        let changes = self.changes.iter().map(|change| {
            json!({"angle": change.of, "from_rad": change.from, "to_deg": change.to, "changed_by_rad": change.size()})
        });
        let nearly = self.nearly(within).into_iter().map(|near| {
            let angle = format!("{} of joint `{}`", near.what, near.joint);
            json!({"angle": angle, "rad": near.angle, "off_by_rad": near.off})
        });
        let remarks = self.renamed().into_iter().chain(self.endless()).chain(self.in_millimeters());
        let remarks = remarks.chain(self.gripper()).chain(self.inverse.clone());
        json!({
            "chain": {"base": self.path.base, "tool": self.path.tool},
            "made_exact": changes.collect::<Vec<_>>(),
            "nearly_exact": nearly.collect::<Vec<_>>(),
            "rounded_lengths_by_m": self.lengths,
            "remarks": remarks.collect::<Vec<_>>(),
            "proof": {
                "configurations": CONFIGURATIONS,
                "exact_angles": difference(self.exact_angles),
                "as_written": difference(self.as_written),
            },
        })
    }

    /// The angles that are nearly multiples of 15 degrees and were left as they are.
    fn nearly(&self, within: f64) -> Vec<Nearly<'_>> {
        let angles = self.path.joints.iter().flat_map(|passed| {
            let named = ["roll", "pitch", "yaw"].into_iter().zip(passed.joint.rpy);
            named.map(|(what, angle)| (what, passed.joint.name.as_str(), angle))
        });
        angles
            .filter_map(|(what, joint, angle)| {
                let to = exact_degrees(angle, LOOKS_ROUNDED)?;
                Some(Nearly { what, joint, angle, off: (angle - to * PI / 180.0).abs() })
            })
            .filter(|near| near.off > within)
            .collect()
    }

    fn nearly_line(&self, within: f64) -> Option<String> {
        if self.source == Source::Calibration {
            return None;
        }
        let nearly = self.nearly(within);
        let Nearly { what, joint, angle, .. } = nearly.first()?;
        let most = nearly.iter().map(|near| near.off).fold(0.0, f64::max);
        let others = match nearly.len() - 1 {
            0 => " is nearly a multiple of 15 degrees and is".to_owned(),
            1 => " and 1 other angle are nearly multiples of 15 degrees and are".to_owned(),
            more => format!(" and {more} other angles are nearly multiples of 15 degrees and are"),
        };
        let wide = 10_f64.powi(most.log10().ceil() as i32);
        Some(format!(
            "used as written: {what} of joint `{joint}`, {angle} rad,{others} {most:.1e} rad off at most; \
             `--exact-within {wide:e}` makes that exact"
        ))
    }
}
