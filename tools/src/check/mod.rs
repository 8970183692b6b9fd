//! The findings of the generator in an arm file, or the mistakes in it.

mod cost;
mod zero_configuration;

use denhart::{JointKind, Pose};
use denhart_codegen::model::Convention;
use denhart_codegen::model::geometry::Line;
use denhart_codegen::{Choice, Diagnostic, Report, Severity};
use serde_json::{Value, json};

use crate::{Arm, Units};
use cost::Cost;
pub use cost::Processor;
use zero_configuration::{ZeroConfiguration, zero_configuration};

/// Findings for one arm file.
#[derive(Debug)]
pub struct Checked {
    file: String,
    /// None where there are mistakes.
    found: Option<Box<Found>>,
    /// Mistakes and warnings.
    messages: Vec<Diagnostic>,
}

#[derive(Debug)]
struct Found {
    report: Report,
    arm: Arm,
    zero: Option<ZeroConfiguration>,
    cost: Option<Cost>,
}

/// Checks the text of an arm file; `file` is its name for messages. With a processor the findings have kernels and bound of
/// the inverse, and what the code of a similar arm takes there.
///
/// ```
/// use denhart_tools::Units;
/// use denhart_tools::check::check;
///
/// let wrong = check("convention: standard\njoints:\n  - {a: 0.3, alfa: 90, d: 0, theta: 0}\n", "arm.yaml", None);
/// assert!(wrong.report().is_none() && wrong.text(Units::Deg).contains("arm.yaml:3:14: unknown key `alfa`"));
///
/// let right = check("convention: standard\nunits: {length: m, angle: deg}\njoints:\n  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n", "arm.yaml", None);
/// assert!(right.messages().is_empty());
/// assert_eq!(right.json(Units::Deg)["reach"], 0.3);
/// ```
#[must_use]
pub fn check(text: &str, file: &str, processor: Option<Processor>) -> Checked {
    let name = file.to_owned();
    match denhart_codegen::check(text, file) {
        Err(errors) => Checked { file: name, found: None, messages: errors.iter().cloned().collect() },
        Ok(report) => {
            let messages = report.warnings.iter().chain(&report.lacking).cloned().collect();
            let found = Arm::of_text(text, file).ok().map(|arm| {
                let zero = zero_configuration(&arm);
                // An arm that lacks a required inverse has no programs; the report says so.
                let program = processor.and_then(|at| Some((denhart_codegen::program(text, file).ok()?, at)));
                let cost = program.map(|(program, processor)| Cost::new(&program, processor));
                Box::new(Found { report, arm, zero, cost })
            });
            Checked { file: name, found, messages }
        }
    }
}

impl Checked {
    /// Mistakes and warnings, each with its place in the file.
    #[must_use]
    pub fn messages(&self) -> &[Diagnostic] {
        &self.messages
    }

    /// The findings of the generator; none where there are mistakes.
    #[must_use]
    pub fn report(&self) -> Option<&Report> {
        self.found.as_ref().map(|found| &found.report)
    }

    /// The findings for people, then the messages; angles in `units`.
    #[must_use]
    pub fn text(&self, units: Units) -> String {
        let found = self.found.iter().map(|found| {
            let cost = found.cost.as_ref().map_or_else(String::new, |cost| format!("\n{}", cost.text()));
            format!("{}\n{}{cost}", found.report.to_string().trim_end(), found.zero_text(units))
        });
        let messages = self.messages.iter().map(|message| match message.severity {
            Severity::Error => format!("error: {message}"),
            Severity::Warning => message.to_string(),
        });
        found.chain(messages).collect::<Vec<String>>().join("\n\n")
    }

    /// An object with the keys `file` and `messages`; without mistakes also the findings: `name`, `joints`, `inverse` and so on.
    /// Angles in `units`.
    #[must_use]
    pub fn json(&self, units: Units) -> Value {
        let messages: Vec<Value> = self.messages.iter().map(message).collect();
        let mut value = json!({"file": self.file, "messages": messages});
        if let (Some(found), Some(object)) = (&self.found, value.as_object_mut()) {
            object.extend(found.json(units));
        }
        value
    }
}

/// A mistake or a warning as an object: `severity`, `message`; where it has them `line`, `column`, `end_column` and `help`. Lines and
/// columns count from 1.
#[must_use]
pub fn message(message: &Diagnostic) -> Value {
    let severity = match message.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let mut value = json!({"severity": severity, "message": message.message});
    if let Some(object) = value.as_object_mut() {
        if let Some(at) = &message.at {
            object.insert("line".to_owned(), json!(at.line));
            object.insert("column".to_owned(), json!(at.column));
            object.insert("end_column".to_owned(), json!(at.column + at.width));
        }
        if let Some(help) = &message.help {
            object.insert("help".to_owned(), json!(help));
        }
    }
    value
}

/// Millionths of the arm's size and of a degree are below what a drawing shows.
fn shown(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{}", rounded + 0.0)
}

fn list(values: &[f64]) -> String {
    values.iter().map(|value| shown(*value)).collect::<Vec<_>>().join(", ")
}

impl Found {
    /// The lines on the arm at zero.
    fn zero_text(&self, units: Units) -> String {
        let Some(zero) = &self.zero else { return String::new() };
        let unit = self.arm.model.length_unit.symbol();
        let mut lines = vec![format!("at q = 0, in the base frame ({unit}, {}):", units.symbol())];
        let joints = || self.arm.model.joints.iter();
        for (joint, axis) in joints().zip(&zero.axes) {
            let (point, direction) = (list(&axis.point), list(&axis.direction));
            lines.push(format!("  axis of {}: through {point}, along {direction}", joint.name));
        }
        lines.push(format!("  frame origins ({}):", self.frames()));
        for (joint, origin) in joints().zip(&zero.frame_origins) {
            lines.push(format!("    {}: {}", joint.name, list(origin)));
        }
        lines.push(format!(
            "  tool: position {}, roll pitch yaw {}",
            list(&zero.tool.translation),
            list(&rpy(&zero.tool, units))
        ));
        if !zero.outside_limits.is_empty() {
            lines.push(format!("  the limits leave 0 out of {}", zero.outside_limits.join(", ")));
        }
        let sums = !self.arm.model.combined_limits.is_empty();
        let sums = if sums { ", without regard to `combined_limits`" } else { "" };
        match zero.max_reach {
            Some(reach) => {
                lines.push(format!("reach: the tool gets {} {unit} away from the base's origin{sums}", shown(reach)))
            }
            None => lines.push("reach: without end, a sliding joint has no limit".to_owned()),
        }
        lines.join("\n")
    }

    /// The place of the table's frames.
    fn frames(&self) -> String {
        let model = &self.arm.model;
        let place = match model.convention {
            Convention::Standard => "standard: frame i stands at the end of link i, on axis i+1",
            Convention::Modified => "modified: frame i stands on axis i",
        };
        let follows = model.rows.iter().skip_while(|row| row.joint.is_none()).any(|row| row.joint.is_none());
        format!("{place}{}", if follows { "; fixed rows move it on" } else { "" })
    }

    fn json(&self, units: Units) -> serde_json::Map<String, Value> {
        let Self { report, arm, zero, cost } = self;
        let model = &arm.model;
        let kind = |kind: &JointKind| if *kind == JointKind::Revolute { "revolute" } else { "prismatic" };
        let end = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
        let joints: Vec<Value> = model
            .joints
            .iter()
            .zip(arm.chain.kinds())
            .map(|(joint, its)| {
                let limits = joint.limits.map(|ends| ends.map(|value| end(units.of_joint(its, value))));
                json!({"name": joint.name, "type": kind(&its), "limits": limits})
            })
            .collect();
        let [forward, jacobian, both] = report.costs.map(|cost| {
            json!({"additions": cost.additions, "multiplications": cost.multiplications, "sin_cos": cost.sin_cos})
        });
        let mut object = serde_json::Map::new();
        let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
        put("name", json!(report.name));
        put("length_unit", json!(model.length_unit.symbol()));
        put("angle_unit", json!(units.symbol()));
        put("joints", json!(joints));
        put("operations", json!({"forward": forward, "jacobian": jacobian, "forward_and_jacobian": both}));
        put(
            "inverse",
            report
                .task
                .as_ref()
                .map_or(Value::Null, |task| json!({"task": task, "max_solutions": report.max_solutions})),
        );
        put("no_inverse", json!(report.unsupported));
        let calibration = model.calibration.as_ref().map(|calibration| {
            let delta = |(joint, [a, alpha, d, theta]): &(usize, [f64; 4])| {
                let name = model.joints.get(*joint).map(|joint| &joint.name);
                json!({"joint": name, "a": a, "alpha": units.of(*alpha), "d": d, "theta": units.of(*theta)})
            };
            let deltas: Vec<Value> = calibration.deltas.iter().map(delta).collect();
            json!({"displaced": calibration.displaced, "turned": units.of(calibration.turned), "deltas": deltas})
        });
        put("calibration", json!(calibration));
        let choice =
            |choice: &Choice| json!({"redundant": choice.names, "way": choice.way.name(), "words": choice.words});
        put("choices", report.choices.iter().map(choice).collect());
        if let Some(cost) = cost {
            put("cortex_m4f", cost.json());
        }
        if let Some(zero) = zero {
            let tool = json!({"position": zero.tool.translation, "rpy": rpy(&zero.tool, units), "rotation": zero.tool.rotation});
            let axis = |axis: &Line| json!({"point": axis.point, "direction": axis.direction});
            let axes: Vec<Value> = zero.axes.iter().map(axis).collect();
            let (origins, outside) = (&zero.frame_origins, &zero.outside_limits);
            put("home", json!({"tool": tool, "axes": axes, "frame_origins": origins, "outside_limits": outside}));
            put("reach", json!(zero.max_reach));
        }
        object
    }
}

fn rpy(pose: &Pose<f64>, units: Units) -> [f64; 3] {
    pose.rpy().angles.map(|angle| units.of(angle))
}
