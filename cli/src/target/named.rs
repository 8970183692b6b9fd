//! Targets whose numbers have names: the keys of JSON, the columns of a CSV file.

use denhart::{PlanarPose, PointAngle, Pose};
use denhart_codegen::spec::nearest;
use denhart_dynamic::{DynamicArm, DynamicTarget};

use super::Target;
use super::spelled::{of, of_matrix, of_quaternion, of_rpy, position_axis, rotation};
use crate::Failure;
use crate::hints;
use crate::numbers::{Units, count};

/// Entries of two rotations that differ by more than this are those of two orientations: more than printed digits leave.
const TWO_ORIENTATIONS: f64 = 1e-2;

/// The named parts of a target, angles in the unit that is read.
#[derive(Default)]
pub struct Parts {
    pub position: Option<Vec<f64>>,
    /// Row by row: 12 or 16 numbers, or 9 beside a position.
    pub matrix: Option<Vec<f64>>,
    /// Scalar part first.
    pub quaternion: Option<Vec<f64>>,
    /// Roll, pitch, yaw.
    pub rpy: Option<Vec<f64>>,
    pub axis: Option<Vec<f64>>,
    pub angle: Option<f64>,
    pub phi: Option<f64>,
}

impl Parts {
    /// The target of the arm's task: by the names of the task where all are there, else by a whole pose.
    ///
    /// # Errors
    /// Names that lack; a part of another length; no rotation.
    pub fn target(&self, arm: &DynamicArm, units: Units) -> Result<Target, Failure> {
        let task = arm.task()?;
        let angled = |target: Target, angle: f64| target.with(hints::of_angles("", &[angle], units));
        match (task, self.position.as_deref()) {
            ("position", Some(&[x, y, z])) => return Ok(of(arm, DynamicTarget::Position([x, y, z]))),
            ("position_axis", Some(&[x, y, z])) => {
                if let Some(&[u, v, w]) = self.axis.as_deref() {
                    let found = |found| Failure::Usage(format!("{found}\nhelp: write the direction as a unit vector"));
                    return position_axis(arm, [x, y, z], [u, v, w]).map_err(found);
                }
            }
            ("position_angle", Some(&[x, y, z])) => {
                if let Some(angle) = self.angle {
                    return Ok(angled(
                        of(arm, DynamicTarget::PositionAngle(PointAngle::new([x, y, z], units.rad(angle)))),
                        angle,
                    ));
                }
            }
            ("planar_pose", Some(&[x, y, ..])) => {
                if let Some(phi) = self.phi {
                    return Ok(angled(of(arm, DynamicTarget::PlanarPose(PlanarPose::new(x, y, units.rad(phi)))), phi));
                }
            }
            ("planar_position", Some(&[x, y, ..])) => return Ok(of(arm, DynamicTarget::PlanarPosition([x, y]))),
            _ => {}
        }
        self.whole(arm, units)?.ok_or_else(|| self.lacking(task))
    }

    /// Tells if the names of the task are there, or those of a whole pose.
    fn are_enough(&self, task: &str) -> bool {
        let at = |n: usize| self.position.as_ref().is_some_and(|position| position.len() >= n);
        let own = match task {
            "position" => at(3),
            "position_axis" => at(3) && self.axis.is_some(),
            "position_angle" => at(3) && self.angle.is_some(),
            "planar_pose" => at(2) && self.phi.is_some(),
            "planar_position" => at(2),
            _ => false,
        };
        own || (at(3) && (self.matrix.is_some() || self.quaternion.is_some() || self.rpy.is_some()))
    }

    /// The target of a whole pose; none where no names of a pose are there.
    fn whole(&self, arm: &DynamicArm, units: Units) -> Result<Option<Target>, Failure> {
        let wrong = |found: String| Failure::Usage(found + "\nhelp: " + POSE);
        let xyz = match self.position.as_deref() {
            Some(&[x, y, z]) => Some([x, y, z]),
            _ => None,
        };
        self.one_orientation(units).map_err(wrong)?;
        let pose = match (self.matrix.as_deref(), xyz, self.quaternion.as_deref(), self.rpy.as_deref()) {
            (Some(&[a, b, c, d, e, f, g, h, i]), Some(translation), ..) => {
                rotation(Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation })
            }
            (Some(values), ..) if values.len() != 9 => of_matrix(values),
            (_, Some(xyz), Some(&[w, x, y, z]), _) => of_quaternion(xyz, [w, x, y, z]),
            (_, Some(xyz), _, Some(&[roll, pitch, yaw])) => {
                return of_rpy(arm, "", xyz, [roll, pitch, yaw], units).map(Some);
            }
            _ => return Ok(None),
        };
        Target::of_pose(arm, pose.map_err(wrong)?, units).map(Some)
    }

    /// Refuses orientations that differ. `forward --json` prints one in three forms.
    fn one_orientation(&self, units: Units) -> Result<(), String> {
        let matrix = match self.matrix.as_deref() {
            Some(&[a, b, c, d, e, f, g, h, i]) => Some([[a, b, c], [d, e, f], [g, h, i]]),
            Some(values) => of_matrix(values).ok().map(|pose| pose.rotation),
            None => None,
        };
        let quaternion = match self.quaternion.as_deref() {
            Some(&[w, x, y, z]) => of_quaternion([0.0; 3], [w, x, y, z]).ok().map(|pose| pose.rotation),
            _ => None,
        };
        let rpy = match self.rpy.as_deref() {
            Some(&[roll, pitch, yaw]) => {
                Some(Pose::from_xyz_rpy([0.0; 3], [roll, pitch, yaw].map(|angle| units.rad(angle))).rotation)
            }
            _ => None,
        };
        let forms = [("matrix", matrix), ("quaternion", quaternion), ("rpy", rpy)];
        let mut known = forms.into_iter().filter_map(|(name, rotation)| Some((name, rotation?)));
        let Some((first, rotation)) = known.next() else { return Ok(()) };
        let differs = |other: &[[f64; 3]; 3]| {
            rotation.iter().flatten().zip(other.iter().flatten()).any(|(a, b)| (a - b).abs() > TWO_ORIENTATIONS)
        };
        match known.find(|(_, other)| differs(other)) {
            Some((other, _)) => Err(format!("`{first}` and `{other}` are two orientations: one is needed")),
            None => Ok(()),
        }
    }

    /// The names that lack.
    fn lacking(&self, task: &str) -> Failure {
        let (needed, own) = match task {
            "position" => ("`position`, 3 numbers", "write `position`, or a whole pose"),
            "position_axis" => ("`position` and `axis`, 3 numbers each", "write both, or a whole pose"),
            "position_angle" => ("`position`, 3 numbers, and `angle`", "write both, or a whole pose"),
            "planar_pose" => ("`position`, 2 numbers, and `phi`", "write both, or a whole pose"),
            "planar_position" => ("`position`, 2 numbers", "write `position`, or a whole pose"),
            _ => ("a whole pose", "write one"),
        };
        let lengths = [
            ("position", &self.position),
            ("matrix", &self.matrix),
            ("quaternion", &self.quaternion),
            ("rpy", &self.rpy),
            ("axis", &self.axis),
        ];
        let lists = lengths.into_iter().filter_map(|(name, values)| {
            values.as_ref().map(|values| format!("`{name}`, {}", count(values.len(), "number")))
        });
        let angles = [("angle", self.angle), ("phi", self.phi)];
        let angles = angles.into_iter().filter_map(|(name, value)| value.map(|_| format!("`{name}`")));
        let found: Vec<String> = lists.chain(angles).collect();
        let found =
            if found.is_empty() { "nothing of it is there".to_owned() } else { format!("found {}", found.join("; ")) };
        Failure::Usage(format!("the task `{task}` needs {needed}: {found}\nhelp: {own}: {POSE}"))
    }
}

/// A whole pose by its names.
const POSE: &str =
    "`matrix` (4 rows of 4), or `position` (x y z) with `quaternion` (w x y z) or `rpy` (roll pitch yaw)";

/// The names of columns, of each part in order.
const POSITION: [&str; 3] = ["x", "y", "z"];
const MATRIX: [&str; 9] = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];
const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
const RPY: [&str; 3] = ["roll", "pitch", "yaw"];
const AXIS: [&str; 3] = ["u", "v", "w"];

/// The parts from the columns of a CSV file by their names, as `denhart trace` prints them, and `u v w` of an axis. Other
/// columns do not count.
///
/// # Errors
/// An entry of these columns that is no number.
pub fn of_columns(names: &[String], entries: &[&str]) -> Result<Parts, Failure> {
    let one = |name: &str| -> Result<Option<f64>, Failure> {
        let Some(at) = names.iter().position(|found| found.eq_ignore_ascii_case(name)) else { return Ok(None) };
        let entry = entries.get(at).copied().unwrap_or_default();
        match entry.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Some(value)),
            _ => Err(Failure::Usage(format!("`{name}`: `{entry}` is not a number\nhelp: write a number such as 0.5"))),
        }
    };
    let all = |names: &[&str]| names.iter().map(|name| one(name)).collect::<Result<Option<Vec<f64>>, Failure>>();
    Ok(Parts {
        position: match all(&POSITION)? {
            Some(point) => Some(point),
            None => all(&POSITION[..2])?,
        },
        matrix: all(&MATRIX)?,
        quaternion: all(&QUATERNION)?,
        rpy: all(&RPY)?,
        axis: all(&AXIS)?,
        angle: one("angle")?,
        phi: one("phi")?,
    })
}

/// The columns that are read.
fn read() -> impl Iterator<Item = &'static str> {
    let forms = POSITION.iter().chain(&MATRIX).chain(&QUATERNION).chain(&RPY).chain(&AXIS);
    forms.copied().chain(["angle", "phi"])
}

/// Returns true for a column that no task reads.
pub fn is_no_column(name: &str) -> bool {
    !read().any(|read| read.eq_ignore_ascii_case(name))
}

/// Refuses names of columns that are no target of the task, or that occur twice.
///
/// # Errors
/// The names that the task needs.
pub fn check_columns(names: &[String], task: &str) -> Result<(), Failure> {
    for name in read() {
        if names.iter().filter(|found| found.eq_ignore_ascii_case(name)).count() > 1 {
            return Err(Failure::Usage(format!("the column {name} is there twice\nhelp: leave one of them out")));
        }
    }
    let zeros = vec!["0"; names.len()];
    if of_columns(names, &zeros)?.are_enough(task) {
        return Ok(());
    }
    let own = match task {
        "position" => "x, y, z",
        "position_axis" => "x, y, z, u, v, w, or those of a pose: x, y, z",
        "position_angle" => "x, y, z, angle, or those of a pose: x, y, z",
        "planar_pose" => "x, y, phi, or those of a pose: x, y, z",
        "planar_position" => "x, y, or those of a pose: x, y, z",
        _ => "x, y, z",
    };
    let turn = "with roll, pitch, yaw, or qw, qx, qy, qz, or r11 to r33";
    let turn = if task == "position" { String::new() } else { format!(" {turn}") };
    let found = names.join(", ");
    let unread = || names.iter().filter(|name| name.chars().count() > 1 && is_no_column(name));
    let lacking =
        || read().filter(|name| name.len() > 1 && !names.iter().any(|found| found.eq_ignore_ascii_case(name)));
    let meant = unread().find_map(|name| Some(format!("did you mean `{}` by `{name}`? ", nearest(name, lacking())?)));
    let meant = meant.unwrap_or_default();
    Err(Failure::Usage(format!(
        "the columns {found} are no target of the task `{task}`\nhelp: {meant}name them {own}{turn}"
    )))
}
