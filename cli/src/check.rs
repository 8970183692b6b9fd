//! `denhart check`: findings of the generator in arm files, or the mistakes in them.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use denhart::{JointKind, Pose};
use denhart_codegen::model::Convention;
use denhart_codegen::model::geometry::Line;
use denhart_codegen::{Choice, Diagnostic, Report, Severity};
use denhart_tools::Arm;
use serde_json::{Value, json};

use crate::arm;
use crate::cost::{Cost, Target};
use crate::numbers::Units;
use crate::zero_configuration::{ZeroConfiguration, zero_configuration};

/// Arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm files, YAML; `-` reads the standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Warnings count as mistakes: exit status 1
    #[arg(long)]
    strict: bool,
    /// Print an array with an object for each file: what was found, and all messages with their places
    #[arg(long)]
    json: bool,
    /// Unit of the angles of the arm at its zero, and of the limits with --json
    #[arg(long, value_name = "UNIT", default_value = "deg")]
    units: Units,
    /// Print also kernels and bound of the inverse, and what the code of a similar arm takes on this processor
    #[arg(long, value_name = "PROCESSOR")]
    target: Option<Target>,
}

/// Findings for one file.
struct Checked {
    file: String,
    /// None where there are mistakes.
    found: Option<Box<Found>>,
    /// Mistakes and warnings.
    messages: Vec<Diagnostic>,
    /// Why the file could not be read.
    unread: Option<Unread>,
}

struct Found {
    report: Report,
    arm: Arm,
    zero: Option<ZeroConfiguration>,
    cost: Option<Cost>,
}

/// Why a file could not be read, and what to do.
struct Unread {
    message: String,
    help: Option<String>,
}

impl Unread {
    /// From a message that may end with a help line.
    fn new(text: String) -> Self {
        match text.split_once("\nhelp: ") {
            Some((message, help)) => Self { message: message.to_owned(), help: Some(help.to_owned()) },
            None => Self { message: text, help: None },
        }
    }

    fn text(&self) -> String {
        let help = self.help.as_ref().map_or_else(String::new, |help| format!("\nhelp: {help}"));
        format!("error: {}{help}", self.message)
    }

    fn json(&self) -> Value {
        let mut value = json!({"severity": "error", "message": self.message});
        if let (Some(object), Some(help)) = (value.as_object_mut(), &self.help) {
            object.insert("help".to_owned(), json!(help));
        }
        value
    }
}

/// Checks all files, and returns true if nothing was wrong.
///
/// # Errors
/// No way to print.
pub fn run(options: &Options, out: &mut dyn Write, err: &mut dyn Write) -> std::io::Result<bool> {
    let checked: Vec<Checked> = options.files.iter().map(|file| check(file, options.target)).collect();
    let failed = |checked: &Checked| {
        let counts = |message: &Diagnostic| options.strict || message.severity == Severity::Error;
        checked.unread.is_some() || checked.messages.iter().any(counts)
    };
    if options.json {
        let all: Vec<Value> = checked.iter().map(|checked| checked.json(options.units)).collect();
        serde_json::to_writer_pretty(&mut *out, &all)?;
        writeln!(out)?;
    } else {
        for (index, checked) in checked.iter().enumerate() {
            let text = checked.text(options.units);
            let text = text.trim_end();
            if index > 0 {
                writeln!(out)?;
            }
            // Whoever reads a pipe that is closed has gone away; the messages still count.
            if failed(checked) { writeln!(err, "{text}")? } else { writeln!(out, "{text}")? }
        }
        let warned: usize = checked.iter().map(|checked| checked.messages.len()).sum();
        let only_warned = checked.iter().all(|checked| checked.found.is_some()) && options.strict && warned > 0;
        if only_warned {
            let warnings = if warned == 1 { "1 warning" } else { &format!("{warned} warnings") };
            writeln!(err, "\nerror: {warnings}, with --strict a mistake")?;
        }
    }
    out.flush()?;
    Ok(!checked.iter().any(failed))
}

fn check(file: &Path, target: Option<Target>) -> Checked {
    let name = file.display().to_string();
    let (text, name) = match arm::text(file) {
        Ok(read) => read,
        Err(message) => {
            let unread = Some(Unread::new(message));
            return Checked { file: name, found: None, messages: Vec::new(), unread };
        }
    };
    match denhart_codegen::check(&text, &name) {
        Err(errors) => Checked { file: name, found: None, messages: errors.iter().cloned().collect(), unread: None },
        Ok(report) => {
            let messages = report.warnings.iter().chain(&report.lacking).cloned().collect();
            let found = Arm::of_text(&text, &name).ok().map(|arm| {
                let zero = zero_configuration(&arm);
                // An arm that lacks a required inverse has no programs; the report says so.
                let program = target.and_then(|target| Some((denhart_codegen::program(&text, &name).ok()?, target)));
                let cost = program.map(|(program, target)| Cost::new(&program, target));
                Box::new(Found { report, arm, zero, cost })
            });
            Checked { file: name, found, messages, unread: None }
        }
    }
}

impl Checked {
    fn text(&self, units: Units) -> String {
        let found = self.found.iter().map(|found| {
            let cost = found.cost.as_ref().map_or_else(String::new, |cost| format!("\n{}", cost.text()));
            format!("{}\n{}{cost}", found.report.to_string().trim_end(), found.zero_text(units))
        });
        let messages = self.messages.iter().map(|message| match message.severity {
            Severity::Error => format!("error: {message}"),
            Severity::Warning => message.to_string(),
        });
        found.chain(messages).chain(self.unread.as_ref().map(Unread::text)).collect::<Vec<String>>().join("\n\n")
    }

    fn json(&self, units: Units) -> Value {
        let mut messages: Vec<Value> = self.messages.iter().map(message).collect();
        messages.extend(self.unread.iter().map(Unread::json));
        let mut value = json!({"file": self.file, "messages": messages});
        if let (Some(found), Some(object)) = (&self.found, value.as_object_mut()) {
            object.extend(found.json(units));
        }
        value
    }
}

fn message(message: &Diagnostic) -> Value {
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
