//! The target of `denhart inverse`: its spellings, and the reading of each by the arm's task.

mod json;
mod named;
mod plane;
mod spelled;
mod words;

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use clap::Args;
use denhart::Pose;
use denhart_codegen::lower::Goal;
use denhart_dynamic::{DynamicArm, DynamicTarget};

use crate::Failure;
use crate::hints;
use crate::number_arguments::joint_vector;
use crate::numbers::Units;

pub use json::of_text as of_json_text;
pub use named::{check_columns, is_no_column, of_columns};
pub use spelled::{listed, of_task};

/// The change of the cosine between the tool's z axis and that of the base, beyond which a pose tilts the tool. Printed
/// digits stay below.
const TILTED: f64 = 1e-6;

/// The spellings of one target.
#[derive(Args)]
pub struct Spelling {
    /// Where the tool is to be, base frame, in the numbers of the arm's task: "x y z roll pitch yaw" for a pose
    ///
    /// position_axis takes "x y z u v w", a point and the unit vector along which the tool's axis points. position takes
    /// "x y z", position_angle "x y z angle", planar_pose "x y phi", planar_position "x y". These four also take the six
    /// numbers of a whole pose.
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pose: Option<String>,
    /// A whole pose for any task: "x y z roll pitch yaw"; the task reads its part of the pose
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    whole_pose: Option<String>,
    /// A whole pose with a quaternion, scalar part first: "x y z qw qx qy qz"
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    quat: Option<String>,
    /// A whole pose as a matrix, row by row: 12 numbers (3 rows of 4) or 16; brackets and line ends do not count
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    matrix: Option<String>,
    /// A target in JSON, from a file or `-`, the standard input: what `forward --json` or `inverse --json` prints
    #[arg(long, value_name = "FILE")]
    json_target: Option<PathBuf>,
    /// Where the tool is at these joint values: "0, -90, 90, 0, 0, 0"
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    q: Option<String>,
}

/// The options that name a target, for a group of which one is required.
pub const SPELLINGS: [&str; 6] = ["pose", "whole_pose", "quat", "matrix", "json_target", "q"];

/// A target of the arm's task.
#[derive(Debug, Clone)]
pub struct Target {
    pub target: DynamicTarget,
    /// A whole pose that meets the target, for the closest approach.
    pub pose: Pose<f64>,
    /// The joint values that the target was typed as.
    pub q: Option<Vec<f64>>,
    /// The values that stand beside the target in its own text, in rad and lengths; none where it has none.
    pub given: Vec<f64>,
    /// Remarks on numbers that look like another unit, or on a pose that is slightly off.
    pub hints: Vec<String>,
}

impl Target {
    /// The part of a whole pose that the arm's task asks for.
    ///
    /// # Errors
    /// A pose in which the tool does not stand in the plane of a `position_angle` arm.
    pub fn of_pose(arm: &DynamicArm, pose: Pose<f64>, units: Units) -> Result<Self, Failure> {
        match arm.target_of(&pose)? {
            Some(target) => {
                let hint = tilt(arm, &target, &pose)?;
                Ok(Self { target, pose, q: None, given: Vec::new(), hints: hint.into_iter().collect() })
            }
            None => plane::target(arm, pose, units),
        }
    }

    /// Adds a hint to the target, if there is one.
    fn with(mut self, hint: Option<String>) -> Self {
        self.hints.extend(hint);
        self
    }

    /// A hint for a target out of reach whose point would be within reach in another unit of length.
    pub fn hint_of_unit(&self, arm: &DynamicArm) -> Option<String> {
        let reach = arm.program().inverse.as_ref().ok()?.constants.reach;
        let point = match &self.target {
            DynamicTarget::PlanarPose(asked) => &[asked.x, asked.y][..],
            DynamicTarget::PlanarPosition(point) => point,
            _ => &self.pose.translation,
        };
        hints::of_point(point, arm.length_unit(), reach)
    }

    /// The target in words and units.
    pub fn words(&self, arm: &DynamicArm, units: Units) -> Result<String, Failure> {
        words::words(&self.target, arm, units)
    }
}

impl Spelling {
    /// Tells if the target comes from the standard input.
    pub fn reads_standard_input(&self) -> bool {
        self.json_target.as_deref().is_some_and(is_standard_input)
    }

    /// Tells if a target is typed.
    #[cfg(feature = "draw")]
    pub fn is_given(&self) -> bool {
        let texts = [&self.pose, &self.whole_pose, &self.quat, &self.matrix, &self.q];
        texts.into_iter().any(Option::is_some) || self.json_target.is_some()
    }

    /// The joint values as typed, where the target is typed so.
    #[cfg(feature = "draw")]
    pub fn joint_values(&self) -> Option<&str> {
        self.q.as_deref()
    }

    /// The target as typed.
    ///
    /// # Errors
    /// Numbers that are no target of the arm; a file that cannot be read.
    pub fn read(&self, arm: &DynamicArm, units: Units) -> Result<Target, Failure> {
        if let Some(text) = &self.whole_pose {
            return spelled::whole(arm, "--whole-pose", text, units);
        }
        if let Some(text) = &self.quat {
            return spelled::quaternion(arm, text, units);
        }
        if let Some(text) = &self.matrix {
            return spelled::matrix(arm, text, units);
        }
        if let Some(file) = &self.json_target {
            let text = io::read_to_string(open(file)?);
            let text = text.map_err(|error| Failure::Other(format!("cannot read {}: {error}", shown(file))))?;
            return json::of_text(arm, &text, units).map_err(|failure| failure.at(&shown(file)));
        }
        if let Some(text) = &self.q {
            let q = joint_vector("--q", text, arm, units)?;
            let hint = hints::of_joints("--q", arm, &q, units);
            let (target, pose) = (arm.target_at(&q)?, arm.forward(&q)?);
            return Ok(Target { target, pose, q: Some(q), given: Vec::new(), hints: hint.into_iter().collect() });
        }
        spelled::of_task(arm, "--pose", self.pose.as_deref().unwrap_or_default(), units)
    }
}

/// A hint where a pose tilts the tool of a `planar_pose` arm, which turns about z alone.
fn tilt(arm: &DynamicArm, target: &DynamicTarget, pose: &Pose<f64>) -> Result<Option<String>, Failure> {
    let DynamicTarget::PlanarPose(_) = target else { return Ok(None) };
    let along = |pose: &Pose<f64>| pose.rotation[2][2];
    let own = along(&arm.forward(&vec![0.0; arm.joints()])?);
    let tilted = (along(pose) - own).abs() > TILTED;
    Ok(tilted
        .then(|| "the arm turns its tool about z alone: the pose tilts the tool, and the tilt is left out".to_owned()))
}

/// Tells if a path stands for the standard input.
pub fn is_standard_input(file: &Path) -> bool {
    file.as_os_str() == "-"
}

/// A file, or the standard input, line by line.
///
/// # Errors
/// A file that cannot be opened.
pub fn open(file: &Path) -> Result<Box<dyn BufRead>, Failure> {
    if is_standard_input(file) {
        return Ok(Box::new(io::stdin().lock()));
    }
    let opened = File::open(file);
    let opened = opened.map_err(|error| Failure::Other(format!("cannot read `{}`: {error}", file.display())))?;
    Ok(Box::new(BufReader::new(opened)))
}

/// A file in messages.
pub fn shown(file: &Path) -> String {
    if is_standard_input(file) { "<stdin>".to_owned() } else { file.display().to_string() }
}

/// The column of the tool's axis that points, for `position_axis`.
fn axis_column(arm: &DynamicArm) -> usize {
    match arm.program().inverse.as_ref().map(|inverse| &inverse.goal) {
        Ok(Goal::PositionAxis { column }) => *column,
        _ => 2,
    }
}
