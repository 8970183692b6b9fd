//! Report that `denhart check` prints.

use crate::error::Diagnostic;
use crate::model::geometry::{Geometry, Relation};
use crate::model::{Axis, JointKind, Model, Parameter, joint_sum};
use crate::settings::{self, short};
use crate::solve::{Choice, Goal, InversePlan, PlanTask, Unsupported, describe};
use crate::symbolic::Cost;
use std::fmt;

/// Findings of the generator about an arm.
#[derive(Debug, Clone)]
pub struct Report {
    /// Name of the arm.
    pub name: String,
    /// Number of moving joints.
    pub dof: usize,
    /// The task of the inverse with what belongs to it, if there is an inverse.
    pub task: Option<String>,
    /// The largest number of inverse solutions, if there is an inverse.
    pub max_solutions: Option<usize>,
    /// Why there is no inverse, if there is none.
    pub unsupported: Option<String>,
    /// Advice on an entry of the file that is probably meant otherwise, if there is no inverse.
    pub hint: Option<String>,
    /// Without an inverse: the requests for which there is one, as the file writes them. `inverse: {task: position}` is one.
    pub instead: Vec<String>,
    /// The joints whose values could be given, the cheapest first; none for an arm whose task needs all of its joints. Only
    /// [`check`](crate::check) looks for them.
    pub choices: Vec<Choice>,
    /// Operations of forward, jacobian, and both together.
    pub costs: [Cost; 3],
    /// The mistake of a file that requires an inverse where there is none.
    pub lacking: Option<Diagnostic>,
    /// Advice about the file.
    pub warnings: Vec<Diagnostic>,
    lines: Vec<String>,
}

impl Report {
    pub(crate) fn new(
        model: &Model,
        parameters: &[Parameter],
        geometry: &Geometry,
        costs: [Cost; 3],
        inverse: &Result<InversePlan, Unsupported>,
        warnings: Vec<Diagnostic>,
    ) -> Report {
        let mut lines = vec![summary(model)];
        lines.extend(settings::describe(model, parameters));
        lines.push("axes:".into());
        lines.extend(relations(geometry, model.length_unit.symbol()).map(|line| format!("  {line}")));
        for triple in &geometry.triples {
            let first = triple.first + 1;
            let slides = model.joints.iter().skip(triple.first).take(3).any(|j| j.kind == JointKind::Prismatic);
            let what = triple.kind.words(slides);
            lines.push(format!("  {}, {}, {} {what}", first, first + 1, first + 2));
        }
        lines.push("operations:".into());
        for (name, cost) in ["forward", "jacobian", "forward_and_jacobian"].iter().zip(&costs) {
            lines.push(format!("  {name}: {cost}"));
        }
        match inverse {
            Ok(plan) => {
                let outline = plan.outline();
                let (most, task) = (outline.capacity, outline.task);
                let plural = if most == 1 { "" } else { "s" };
                lines.push(format!("inverse (task {}): at most {most} solution{plural}", task.name()));
                lines.extend(chosen(model, task).map(|why| format!("  {why}")));
                lines.extend(angle(task).map(|angle| format!("  the angle asked for is {angle}")));
                let described = match plan {
                    InversePlan::Stages(plan) => describe(plan),
                    InversePlan::HeldJoint(plan) => plan.describe(),
                };
                lines.extend(described.into_iter().map(|line| format!("  {line}")));
            }
            Err(unsupported) => {
                lines.push(format!("no inverse: {}", unsupported.reason));
                lines.extend(unsupported.hint.iter().map(|hint| format!("  {hint}")));
                lines.push("  `denhart::numeric` solves any arm by iteration, one joint vector at a time".into());
            }
        }
        Report {
            name: model.name.clone(),
            dof: model.joints.len(),
            task: inverse.as_ref().ok().map(|plan| plan.outline().task.name()),
            max_solutions: inverse.as_ref().ok().map(|plan| plan.outline().capacity),
            unsupported: inverse.as_ref().err().map(|unsupported| unsupported.reason.clone()),
            hint: inverse.as_ref().err().and_then(|unsupported| unsupported.hint.clone()),
            instead: inverse.as_ref().err().map(|unsupported| unsupported.instead.clone()).unwrap_or_default(),
            choices: Vec::new(),
            costs,
            lacking: None,
            warnings,
            lines,
        }
    }
}

/// The most lines of choices.
const MOST_CHOICES: usize = 12;

impl Report {
    /// Adds the joints whose values could be given.
    pub(crate) fn with_choices(mut self, choices: Vec<Choice>) -> Report {
        // Choices that are alike share a line.
        let groups: Vec<&[Choice]> = choices.chunk_by(|one, next| one.words == next.words).collect();
        if !choices.is_empty() {
            let order = if groups.len() > 1 { ", the cheapest first" } else { "" };
            self.lines.push(format!("values that may be given (`redundant`){order}:"));
        }
        for (place, group) in groups.iter().take(MOST_CHOICES).enumerate() {
            let names: Vec<&str> = group.iter().map(|choice| choice.names.as_str()).collect();
            let words = group.first().map_or("", |choice| choice.words.as_str());
            let cheapest = if place == 0 && groups.len() > 1 { " (cheapest)" } else { "" };
            self.lines.push(format!("  {}: {words}{cheapest}", names.join(", ")));
        }
        let more: usize = groups.iter().skip(MOST_CHOICES).map(|group| group.len()).sum();
        if more > 0 {
            self.lines.push(format!("  and {more} more"));
        }
        self.choices = choices;
        self
    }
}

/// Why this is the task of an arm with four or five joints whose file names none, and this the axis that points.
fn chosen(model: &Model, asked: &PlanTask) -> Option<String> {
    let task = asked.goal.task().name();
    match (model.inverse.task, &asked.passed_over) {
        (_, Some(passed_over)) => Some(passed_over.clone()),
        (None, None)
            if model.joints.len() == 5
                && let Goal::PositionAxis { column } = asked.goal =>
        {
            Some(format!(
                "the file names no task: `{task}` along the tool's {} axis, because these five joints have no `pose`",
                Axis::letter(column)
            ))
        }
        (None, None) if matches!(model.joints.len(), 4 | 5) => {
            Some(format!("the file names no task: `{task}` is the most specific one that the arm can do"))
        }
        _ => None,
    }
}

/// The angle of `position_angle`, as a sum of joints.
fn angle(task: &PlanTask) -> Option<String> {
    let Goal::PositionAngle { signs, offset: constant } = &task.goal else { return None };
    let constant = (!constant.is_zero()).then(|| format!("{} deg", short(constant.rad().to_degrees())));
    Some(joint_sum(signs, constant, short))
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for line in &self.lines {
            writeln!(f, "{line}")?;
        }
        Ok(())
    }
}

fn summary(model: &Model) -> String {
    let kinds: String = model.joints.iter().map(|j| if j.kind == JointKind::Revolute { 'R' } else { 'P' }).collect();
    let plural = if model.joints.len() == 1 { "" } else { "s" };
    let (name, unit) = (&model.name, model.length_unit.symbol());
    format!("{name}: {} moving joint{plural} ({kinds}), lengths in {unit}", model.joints.len())
}

fn relations<'a>(geometry: &'a Geometry, unit: &'a str) -> impl Iterator<Item = String> + 'a {
    geometry.relations.iter().enumerate().map(move |(index, relation)| {
        let pair = format!("{} and {}", index + 1, index + 2);
        match relation {
            Relation::Coincident => format!("{pair} are the same line"),
            Relation::Parallel { distance } => format!("{pair} are parallel, {} {unit} apart", short(*distance)),
            Relation::Intersecting { angle } => format!("{pair} meet at {} deg", short(angle.to_degrees())),
            Relation::Skew { distance, angle } => {
                format!("{pair} are skew: {} {unit} apart, at {} deg", short(*distance), short(angle.to_degrees()))
            }
        }
    })
}
