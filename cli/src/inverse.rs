//! `denhart inverse`: every joint vector that brings the tool of an arm to a target.

use std::io::Write;
use std::path::PathBuf;

use clap::{ArgGroup, Args};
use denhart::{PlanarPose, PointAngle, Pose, Residual, Status};
use denhart_codegen::Report;
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolution, DynamicSolutions, DynamicTarget};
use serde_json::{Value, json};

use crate::Failure;
use crate::closest::{Missed, missed};
use crate::forward::pose_json;
use crate::numbers::{Units, count, outside, pose, short};
use crate::typed::{Typed, joints};

/// What the command takes.
#[derive(Args)]
#[command(group = ArgGroup::new("target").args(["pose", "q"]).required(true))]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// Where the tool is to be, base frame: "x y z roll pitch yaw"; what the arm's task does not ask for does not count
    ///
    /// Smaller tasks take fewer numbers. A position takes "x y z", position_angle "x y z angle". A planar_pose takes
    /// "x y phi", planar_position "x y".
    #[arg(long, value_name = "NUMBERS", allow_hyphen_values = true)]
    pose: Option<String>,
    /// Where the tool is at these joint values: "0, -90, 90, 0, 0, 0"
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    q: Option<String>,
    /// Joint values that the solutions are to be next to, the nearest first
    #[arg(long, value_name = "VALUES", allow_hyphen_values = true)]
    near: Option<String>,
    /// The value of the redundant joint, or the arm angle [default: that of --near, else of --q]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, conflicts_with = "near")]
    given: Option<String>,
    /// Unit of angles, given and printed
    #[arg(long, value_name = "UNIT", default_value = "deg")]
    units: Units,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// The numbers of a whole pose.
const WHOLE: &str = "x y z roll pitch yaw";

/// What is asked.
struct Asked {
    target: DynamicTarget,
    /// A whole pose that meets the target, for the closest approach.
    pose: Pose<f64>,
    given: Option<f64>,
    near: Option<Vec<f64>>,
}

/// Prints the solutions; whether one is exact.
///
/// # Errors
/// Wrong arguments, mistakes in the file, an arm without inverse, no way to print.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<bool, Failure> {
    let (text, name) = crate::arm::text(&options.file).map_err(Failure::Other)?;
    let arm = DynamicArm::named(&text, &name)?;
    if let Err(DynamicError::NoInverse(reason)) = arm.task() {
        let help =
            denhart_codegen::check(&text, &name).map_or_else(|_| BY_ITERATION.to_owned(), |report| instead(&report));
        return Err(Failure::Other(format!("no inverse kinematics: {reason}\nhelp: {help}")));
    }
    let asked = asked(&arm, options)?;
    let solutions = match &asked.near {
        Some(near) => arm.inverse_near(&asked.target, near)?,
        None => arm.inverse(&asked.target, asked.given)?,
    };
    let start = asked.near.clone().unwrap_or_else(|| vec![0.0; arm.joints()]);
    let missed = match solutions.status() {
        Status::Unreachable { .. } => missed(&arm, &asked.target, &asked.pose, &start),
        _ => None,
    };
    if solutions.status() == Status::BadTarget {
        return Err(Failure::Usage("not a target: a number is too large, or --near is many turns away".to_owned()));
    }
    let shown = Shown { arm: &arm, asked: &asked, solutions: &solutions, missed, units: options.units };
    if options.json {
        let text = serde_json::to_string_pretty(&shown.json()?).map_err(|error| Failure::Other(error.to_string()))?;
        writeln!(out, "{text}")?;
    } else {
        write!(out, "{}", shown.text()?)?;
    }
    out.flush()?;
    Ok(solutions.status().is_reachable())
}

/// What solves an arm without closed form.
const BY_ITERATION: &str = "`denhart::numeric` solves any arm by iteration";

/// What an arm file may ask for, where there is no inverse as it is.
fn instead(report: &Report) -> String {
    match (&report.hint, &report.instead[..]) {
        (Some(hint), _) => format!("{hint}; {BY_ITERATION}"),
        (None, []) => format!("this arm has a closed form for no task of docs/tasks.md; {BY_ITERATION}"),
        (None, [one]) => format!("write `{one}` in the file; {BY_ITERATION}"),
        (None, [one, others @ ..]) => {
            let others: Vec<String> = others.iter().map(|request| format!("`{request}`")).collect();
            format!("write `{one}` in the file, or {}; {BY_ITERATION}", others.join(", "))
        }
    }
}

fn asked(arm: &DynamicArm, options: &Options) -> Result<Asked, Failure> {
    let units = options.units;
    let joints = |option: &str, text: &Option<String>| {
        text.as_ref().map(|text| self::joints(option, text, arm, units)).transpose()
    };
    let (q, near) = (joints("--q", &options.q)?, joints("--near", &options.near)?);
    let (target, pose) = match (&q, &options.pose) {
        (Some(q), _) => (arm.target_at(q)?, arm.forward(q)?),
        (None, text) => from_numbers(arm, text.as_deref().unwrap_or_default(), units)?,
    };
    let given = match (&options.given, arm.given()?) {
        // A slide is a length; everything else that is given is an angle.
        (Some(text), Some(_)) => {
            let value = one("--given", text, arm, units)?;
            Some(if arm.given_slides()? { value } else { units.rad(value) })
        }
        (Some(_), None) => {
            return Err(Failure::Usage(
                "--given: this arm's inverse takes no such value\nhelp: leave --given out".to_owned(),
            ));
        }
        (None, Some(name)) if q.is_none() && near.is_none() => {
            let unit = if arm.given_slides()? { arm.model().length_unit.symbol() } else { units.symbol() };
            return Err(Failure::Usage(format!(
                "the target leaves {name} to choose\n\
                 help: add --given with its value in {unit}, or --near with the joint values to be next to"
            )));
        }
        (None, _) => q.as_deref().map(|q| arm.held(q)).transpose()?.flatten(),
    };
    Ok(Asked { target, pose, given, near })
}

/// One number.
fn one(option: &str, text: &str, arm: &DynamicArm, units: Units) -> Result<f64, Failure> {
    let typed = Typed { option, text, angle: units, length: arm.length_unit(), wanted: &[1] };
    match typed.numbers()?[..] {
        [value] => Ok(value),
        ref values => {
            let found = count(values.len(), "number");
            Err(typed.miscounted(&format!("{found}, but one is needed"), &format!("write one, such as {option} 0.5")))
        }
    }
}

/// The target of the arm's task from the numbers of `--pose`, and a pose that meets it.
fn from_numbers(arm: &DynamicArm, text: &str, units: Units) -> Result<(DynamicTarget, Pose<f64>), Failure> {
    let task = arm.task()?;
    let wanted = match task {
        "position" => "x y z",
        "position_angle" => "x y z angle",
        "planar_pose" => "x y phi",
        "planar_position" => "x y",
        _ => WHOLE,
    };
    let needed = wanted.split(' ').count();
    let length = arm.length_unit();
    let typed = Typed { option: "--pose", text, angle: units, length, wanted: &[needed, 6] };
    let values = &typed.numbers()?[..];
    if let [x, y, z, roll, pitch, yaw] = *values {
        let pose = pose([x, y, z, roll, pitch, yaw], units);
        if let Some(target) = arm.target_of(&pose)? {
            return Ok((target, pose));
        }
    }
    let at = |translation: [f64; 3], yaw: f64| Pose::from_xyz_rpy(translation, [0.0, 0.0, yaw]);
    match (task, values) {
        ("position", &[x, y, z]) => Ok((DynamicTarget::Position([x, y, z]), at([x, y, z], 0.0))),
        ("position_angle", &[x, y, z, angle]) => {
            let asked = PointAngle::new([x, y, z], units.rad(angle));
            Ok((DynamicTarget::PositionAngle(asked), at([x, y, z], 0.0)))
        }
        ("planar_pose", &[x, y, phi]) => {
            let phi = units.rad(phi);
            Ok((DynamicTarget::PlanarPose(PlanarPose::new(x, y, phi)), at([x, y, 0.0], phi)))
        }
        ("planar_position", &[x, y]) => Ok((DynamicTarget::PlanarPosition([x, y]), at([x, y, 0.0], 0.0))),
        _ => {
            let found = count(values.len(), "number");
            let what = format!("{found}, but the task `{task}` needs {needed}: \"{wanted}\"");
            let whole = if wanted == WHOLE { String::new() } else { format!(", or a whole pose, \"{WHOLE}\"") };
            let (angle, length) = (units.symbol(), length);
            let help = format!("write --pose \"{wanted}\"{whole}; lengths in {length}, angles in {angle}");
            Err(typed.miscounted(&what, &help))
        }
    }
}

/// What is printed.
struct Shown<'a> {
    arm: &'a DynamicArm,
    asked: &'a Asked,
    solutions: &'a DynamicSolutions,
    missed: Option<Missed>,
    units: Units,
}

impl Shown<'_> {
    fn length(&self) -> String {
        self.arm.length_unit().to_string()
    }

    fn values(&self, solution: &DynamicSolution) -> Vec<f64> {
        let joints = self.arm.joint_kinds().iter().zip(solution.q.iter());
        joints.map(|(kind, q)| self.units.of_joint(*kind, *q)).collect()
    }

    /// What forward kinematics misses the target by.
    fn residual(&self, solution: &DynamicSolution) -> Result<Residual<f64>, Failure> {
        Ok(self.arm.residual(&solution.q, &self.asked.target)?)
    }

    /// Which limits are broken.
    fn limits(&self, solution: &DynamicSolution) -> Vec<String> {
        let mut broken = outside(self.arm, &solution.q, self.units);
        if broken.is_empty() && !solution.is_within_limits() {
            broken.push("a sum of joints is outside its limits".to_owned());
        }
        broken
    }

    /// Why there is no exact solution.
    fn reason(&self) -> String {
        let (length, angle) = (self.length(), self.units);
        match self.missed {
            Some(Missed::Distance(distance)) => format!(
                "distance: the point is out of reach. The closest that iteration finds is {} {length} away",
                short(distance)
            ),
            Some(Missed::Direction(left)) => format!(
                "direction: the point can be reached, but not with this orientation. Closest: {} {length} and {} {} off",
                short(left.position),
                short(angle.of(left.orientation)),
                angle.symbol()
            ),
            None => "target: whether in distance or direction, iteration does not tell".to_owned(),
        }
    }

    fn text(&self) -> Result<String, Failure> {
        let (length, angle) = (self.length(), self.units.symbol());
        let count = match self.solutions.len() {
            0 => "no solution".to_owned(),
            n => count(n, "solution"),
        };
        let name = &self.arm.model().name;
        let mut text =
            format!("{count} of {name}, task {}; angles in {angle}, lengths in {length}\n", self.arm.task()?);
        if self.solutions.deviation() > 0.0 {
            text += &format!("the target's rotation is off by {:.1e}\n", self.solutions.deviation());
        }
        if !self.solutions.status().is_reachable() {
            text += &format!("no exact solution. Missed is the {}\n", self.reason());
        }
        let mut table = vec![self.header()];
        for (index, solution) in self.solutions.iter().enumerate() {
            table.push(self.row(index, solution)?);
        }
        if table.len() > 1 {
            text += "\n";
            text += &aligned(&table);
        }
        for (index, solution) in self.solutions.iter().enumerate() {
            for broken in self.limits(solution) {
                text += &format!("\n{}: {broken}", index + 1);
            }
        }
        Ok(text.trim_end().to_owned() + "\n")
    }

    fn header(&self) -> Vec<String> {
        let names = self.arm.joint_names().map(str::to_owned);
        let free = self.any_free().then(|| "free joints".to_owned());
        let rest =
            ["limits".to_owned(), format!("off by {}", self.length()), format!("off by {}", self.units.symbol())];
        let flags = ["branch", "flags"].map(str::to_owned);
        ["#".to_owned()].into_iter().chain(names).chain(flags).chain(free).chain(rest).collect()
    }

    fn row(&self, index: usize, solution: &DynamicSolution) -> Result<Vec<String>, Failure> {
        let residual = self.residual(solution)?;
        let values = self.values(solution).into_iter().map(fixed);
        let free = self.any_free().then(|| self.free(solution));
        let rest = [
            if solution.is_within_limits() { "kept" } else { "broken" }.to_owned(),
            format!("{:.1e}", residual.position),
            format!("{:.1e}", self.units.of(residual.orientation)),
        ];
        let flags = [solution.branch.to_string(), solution.flags.to_string()];
        Ok([(index + 1).to_string()].into_iter().chain(values).chain(flags).chain(free).chain(rest).collect())
    }

    /// Whether a column for free joints has an entry.
    fn any_free(&self) -> bool {
        self.solutions.iter().any(|solution| !solution.free.is_empty())
    }

    /// The joints that could take other values, by name.
    fn free(&self, solution: &DynamicSolution) -> String {
        let free: Vec<usize> = solution.free.iter().collect();
        let named = self.arm.joint_names().enumerate().filter(|(joint, _)| free.contains(joint));
        let names: Vec<&str> = named.map(|(_, name)| name).collect();
        if names.is_empty() { "-".to_owned() } else { names.join(", ") }
    }

    /// What is asked for: of the task alone.
    fn target(&self) -> Value {
        let units = self.units;
        match &self.asked.target {
            DynamicTarget::Pose(pose) => pose_json(pose, units),
            DynamicTarget::Position(point) => json!({ "position": point }),
            DynamicTarget::PositionAxis(asked) => json!({ "position": asked.point, "axis": asked.axis }),
            DynamicTarget::PositionAngle(asked) => json!({ "position": asked.point, "angle": units.of(asked.angle) }),
            DynamicTarget::PlanarPose(asked) => json!({ "position": [asked.x, asked.y], "phi": units.of(asked.phi) }),
            DynamicTarget::PlanarPosition(point) => json!({ "position": point }),
        }
    }

    fn json(&self) -> Result<Value, Failure> {
        let mut solutions = Vec::new();
        for solution in self.solutions.iter() {
            let residual = self.residual(solution)?;
            solutions.push(json!({
                "q": self.values(solution),
                "branch": solution.branch.to_string(),
                "flags": solution.flags.to_string().split(" | ").collect::<Vec<_>>(),
                "free": solution.free.iter().map(|joint| joint + 1).collect::<Vec<_>>(),
                "within_limits": solution.is_within_limits(),
                "outside_limits": self.limits(solution),
                "residual": { "position": residual.position, "orientation": self.units.of(residual.orientation) },
            }));
        }
        let missed = match self.missed {
            None => Value::Null,
            Some(Missed::Distance(distance)) => json!({ "what": "distance", "position": distance }),
            Some(Missed::Direction(left)) => json!({
                "what": "direction",
                "position": left.position,
                "orientation": self.units.of(left.orientation),
            }),
        };
        let reachable = self.solutions.status().is_reachable();
        Ok(json!({
            "arm": self.arm.model().name,
            "task": self.arm.task()?,
            "length_unit": self.length(),
            "angle_unit": self.units.symbol(),
            "target": self.target(),
            "status": if reachable { "reachable" } else { "unreachable" },
            "missed": missed,
            "solutions": solutions,
        }))
    }
}

/// Four decimals, no negative zero.
fn fixed(value: f64) -> String {
    let text = format!("{value:.4}");
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}

/// Columns at the width of their widest entry: numbers to the right, words to the left.
fn aligned(table: &[Vec<String>]) -> String {
    let columns = table.first().map_or(0, Vec::len);
    let cell = |row: &[String], column: usize| row.get(column).cloned().unwrap_or_default();
    let widths: Vec<usize> = (0..columns)
        .map(|column| table.iter().map(|row| cell(row, column).chars().count()).max().unwrap_or(0))
        .collect();
    let is_number = |column: usize| table.iter().skip(1).all(|row| cell(row, column).parse::<f64>().is_ok());
    let mut text = String::new();
    for row in table {
        let cells = widths.iter().enumerate().map(|(column, width)| match is_number(column) {
            true => format!("{:>width$}", cell(row, column)),
            false => format!("{:<width$}", cell(row, column)),
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text += "\n";
    }
    text
}
