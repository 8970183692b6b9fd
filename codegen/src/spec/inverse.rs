//! `inverse:`, the task of the inverse kinematics.

use super::angle::{AngleUnit, WrittenAngle};
use super::angle_field::AngleRole;
use super::place::Place;
use super::reader::{Field, Fields, Reader};
use super::weights::WeightsSpec;
use super::yaml::Node;

/// Task of an inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// `pose`: the whole pose of the tool.
    Pose,
    /// `position_angle`: a point, and the tool's rotation in the arm's own plane.
    PositionAngle,
    /// `position_axis`: a point, and the direction of one axis of the tool.
    PositionAxis,
    /// `position`: a point.
    Position,
    /// `planar_pose`: x, y and an angle in the plane of the base.
    PlanarPose,
    /// `planar_position`: x and y in the plane of the base.
    PlanarPosition,
}

/// An axis of the tool frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// `x`
    X,
    /// `y`
    Y,
    /// `z`
    Z,
}

impl Axis {
    /// Its column in a rotation, from 0.
    pub fn column(self) -> usize {
        self as usize
    }

    /// The axis with a column.
    pub fn of_column(column: usize) -> Option<Self> {
        AXES.get(column).map(|(_, axis)| *axis)
    }

    /// The letter of the axis with a column.
    pub fn letter(column: usize) -> &'static str {
        AXES.get(column).map_or("", |(letter, _)| letter)
    }
}

/// The request as written.
#[derive(Debug, Clone, Default)]
pub struct InverseSpec {
    /// The task, where one is named.
    pub task: Option<Task>,
    /// True if an arm without an inverse is a mistake.
    pub require: bool,
    /// The values that are given beside the target.
    pub redundant: Option<RedundantSpec>,
    /// The tool's axis for [`Task::PositionAxis`].
    pub axis: Option<Axis>,
    /// Length unit of the file, positive.
    pub tolerance_length: Option<f64>,
    /// Positive.
    pub tolerance_angle: Option<WrittenAngle>,
    /// How much each joint counts in the distance from a reference.
    pub weights: Option<WeightsSpec>,
    /// Where the request stands: at `task`, or else at `inverse`. `None` where there is no request.
    pub place: Option<Place>,
}

/// `redundant` as written: a joint's name, `qK` or `arm_angle`, or a list of them.
#[derive(Debug, Clone)]
pub struct RedundantSpec {
    /// The names in order.
    pub names: Vec<(String, Place)>,
    /// True for a list, also of one name.
    pub is_list: bool,
    /// Where the name or the list stands.
    pub place: Place,
}

const KEYS: &[&str] = &["task", "require", "redundant", "axis", "tolerance", "weights"];
const TASKS: &[(&str, Task)] = &[
    ("pose", Task::Pose),
    ("position_angle", Task::PositionAngle),
    ("position_axis", Task::PositionAxis),
    ("position", Task::Position),
    ("planar_pose", Task::PlanarPose),
    ("planar_position", Task::PlanarPosition),
];
const TASK_SYNONYMS: &[(&str, &str)] =
    &[("pos", "position"), ("point", "position"), ("xyz", "position"), ("full", "pose"), ("6d", "pose")];
/// Advice for whoever has to choose a task.
const TASK_HELP: &str = "\
write `pose` for position and orientation, `position` for a point, `position_axis` for a point and the direction of an axis,
`position_angle` for a point and one angle, `planar_pose` for x, y and an angle, `planar_position` for x and y";

impl Task {
    /// As the file writes it.
    pub fn name(self) -> &'static str {
        TASKS.iter().find(|(_, task)| *task == self).map_or("pose", |(name, _)| name)
    }
}

const AXES: &[(&str, Axis)] = &[("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];

impl Reader<'_> {
    pub fn inverse(&mut self, root: &Fields<'_>, unit: Option<AngleUnit>) -> InverseSpec {
        let mut inverse = InverseSpec::default();
        let Some(field) = root.get("inverse") else { return inverse };
        inverse.place = Some(field.place.clone());
        if let Node::Text(word) = field.node {
            let task = TASKS.iter().find(|(task, _)| *task == word.trim());
            let help = task.map(|(task, _)| format!("write `inverse: {{task: {task}}}`"));
            self.unexpected(&field, &format!("a mapping with {}", KEYS.join(", ")), help);
            return inverse;
        }
        let Some(fields) = self.mapping(&field, "`inverse`", KEYS) else { return inverse };
        if let Some(field) = fields.get("task") {
            inverse.task = self.choice(&field, TASKS, TASK_SYNONYMS);
            if inverse.task.is_none() {
                self.advise(TASK_HELP);
            }
            inverse.place = Some(field.place);
        }
        inverse.require = fields.get("require").and_then(|field| self.boolean(&field)).unwrap_or(false);
        if let Some(field) = fields.get("redundant").filter(|field| *field.node != Node::Null) {
            inverse.redundant = self.redundant(&field);
        }
        if let Some(field) = fields.get("axis") {
            inverse.axis = self.choice(&field, AXES, &[]);
            if inverse.task.is_some_and(|task| task != Task::PositionAxis) {
                let warning =
                    self.source.warning(&field.place, "`axis` has no effect: it belongs to the task position_axis");
                self.warnings.push(warning);
            }
        }
        if let Some(field) = fields.get("tolerance") {
            self.tolerance(&field, unit, &mut inverse);
        }
        inverse.weights = fields.get("weights").and_then(|field| self.weights(&field));
        inverse
    }

    fn redundant(&mut self, field: &Field<'_>) -> Option<RedundantSpec> {
        let help = "name the joint whose value is given, such as `redundant: q3`, or several: `redundant: [q1, q4]`";
        let place = field.place.clone();
        let Node::List(nodes) = field.node else {
            let names = vec![self.joint_name(field, help)?];
            return Some(RedundantSpec { names, is_list: false, place });
        };
        if nodes.is_empty() {
            self.unexpected(field, "joints' names", Some(help.to_owned()));
        }
        let entries = field.items(nodes);
        let names: Vec<_> = entries.iter().filter_map(|entry| self.joint_name(entry, help)).collect();
        // A list that lacks an entry would leave too many joints: a second mistake that is none.
        (!names.is_empty() && names.len() == entries.len()).then_some(RedundantSpec { names, is_list: true, place })
    }

    /// A joint's name. A number is none.
    fn joint_name(&mut self, field: &Field<'_>, help: &str) -> Option<(String, Place)> {
        if matches!(field.node, Node::Number(_)) {
            let number = self.source.written(&field.place);
            self.unexpected(field, "a joint's name", Some(format!("did you mean `q{number}`?")));
            return None;
        }
        self.text(field, "a joint's name", help).map(|name| (name, field.place.clone()))
    }

    fn tolerance(&mut self, field: &Field<'_>, unit: Option<AngleUnit>, inverse: &mut InverseSpec) {
        let Some(fields) = self.mapping(field, "`tolerance`", &["length", "angle"]) else { return };
        if let Some(field) = fields.get("length") {
            inverse.tolerance_length = self.number(&field).filter(|&value| self.positive(&field, value));
        }
        if let Some(field) = fields.get("angle") {
            let angle = self.angle(&field, unit, AngleRole::Tolerance);
            inverse.tolerance_angle = angle.filter(|&angle| {
                let value = match angle {
                    WrittenAngle::Degrees(value) | WrittenAngle::Radians(value) => value,
                    WrittenAngle::PiFraction(numerator, _) => numerator as f64,
                };
                self.positive(&field, value)
            });
        }
    }

    fn positive(&mut self, field: &Field<'_>, value: f64) -> bool {
        if value <= 0.0 {
            self.unexpected(field, "a tolerance greater than zero", None);
        }
        value > 0.0
    }
}
