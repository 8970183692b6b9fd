//! Results of each stage, as text: for snapshots, so that a wrong stage shows where.

use crate::emit::Writer;
use crate::lower::Block;
use crate::model::chain::{Chain, Elementary};
use crate::model::geometry::Geometry;
use crate::model::{Angle, Length, Model};
use crate::solve::{InversePlan, Plan, PlanStep, Stage, Unsupported};
use crate::symbolic::{ConstantAngle, Dimension, Expr, Symbol};
use std::fmt::Write;

/// Model, factors of the chain, triples and plan; one item a line.
pub fn text(model: &Model, chain: &Chain, geometry: &Geometry, inverse: &Result<InversePlan, Unsupported>) -> String {
    let mut out = String::from("joints\n");
    for joint in &model.joints {
        let limits = joint.limits.map_or("without limits".into(), |[low, high]| format!("{low:?} to {high:?}"));
        line(&mut out, format!("{}: {:?} in row {}, {limits}", joint.name, joint.kind, joint.row + 1));
    }
    out += "chain\n";
    for step in &chain.transforms {
        line(&mut out, factor(step));
    }
    out += "triples\n";
    for triple in &geometry.triples {
        line(&mut out, format!("{}: {:?}", triple.first + 1, triple.kind));
    }
    match inverse {
        Ok(InversePlan::Stages(plan)) => solution(&mut out, plan),
        Ok(InversePlan::HeldJoint(plan)) => {
            out += "plan\n";
            plan.describe().into_iter().for_each(|text| line(&mut out, text));
        }
        Err(unsupported) => {
            out += "no plan\n";
            line(&mut out, unsupported.reason.clone());
        }
    }
    out
}

fn line(out: &mut String, text: String) {
    // Writing to a string does not fail.
    let _ = writeln!(out, "  {text}");
}

fn factor(step: &Elementary) -> String {
    match step {
        Elementary::RotateX { angle, row } => format!("Rx({} = {})", ConstantAngle::Alpha(*row), angle.text()),
        Elementary::RotateZ { angle, row } => format!("Rz({} = {})", ConstantAngle::Theta(*row), angle.text()),
        Elementary::ShiftX { length, row } => format!("Tx({} = {})", Dimension::LinkLength(*row), size(length)),
        Elementary::ShiftZ { length, row } => format!("Tz({} = {})", Dimension::LinkOffset(*row), size(length)),
        Elementary::Revolute { joint, offset } => format!("Rz(q{} + {})", joint + 1, offset.text()),
        Elementary::Prismatic { joint } => format!("Tz(q{})", joint + 1),
        Elementary::Frame { frame, end } => {
            let xyz = frame.xyz.each_ref().map(size).join(", ");
            format!("{end} xyz [{xyz}] rpy {:?}", frame.rpy.map(|angle| angle.text()))
        }
    }
}

fn size(length: &Length) -> String {
    match length {
        Length::Constant(value) => format!("{value:?}"),
        Length::Multiple { factor, parameter, .. } => format!("{factor:?} {parameter}"),
    }
}

/// Shared terms, then the equations, then the joints.
fn solution(out: &mut String, plan: &Plan) {
    let inputs = plan.inputs();
    let mut block = Block::new(&plan.graph, &inputs, []);
    let shared = block.bind(&inputs);
    let krate = proc_macro2::TokenStream::new();
    out.push_str("shared terms\n");
    let writer = Writer { graph: &plan.graph, bound: &block.bound, krate: &krate, lanes: false };
    for e in shared {
        line(out, writer.statement(e).to_string());
    }
    let list = |inputs: &[Expr]| inputs.iter().map(|e| writer.write(*e).to_string()).collect::<Vec<_>>().join(", ");
    out.push_str("plan\n");
    for step in &plan.steps {
        let inputs = list(&step.inputs());
        line(
            out,
            match step {
                PlanStep::Stage(stage) => {
                    let joints: Vec<String> = plan.labels(stage).iter().map(|label| format!("q{label}")).collect();
                    let (joints, kernel) = (joints.join(", "), stage.kernel.name());
                    let shifts: Vec<String> = stage.joints.iter().map(|slot| plan.shift(*slot).text()).collect();
                    let (shifts, Stage { unit, branching, .. }) = (shifts.join(", "), stage);
                    format!("{joints} by {kernel}({inputs}); {unit:?}, {branching:?}, shifts {shifts}")
                }
                PlanStep::Swivel { .. } => format!("upper arm = swivel({inputs})"),
                PlanStep::Agreement { .. } => format!("agree({inputs})"),
                PlanStep::Angle { symbol, .. } => format!("{} = atan2({inputs})", symbol.name()),
            },
        );
    }
    out.push_str("joints from the plan\n");
    for (slot, value) in plan.loop_joints.iter().zip(&plan.values) {
        line(out, format!("q{} = {}", slot.label, sum(&value.terms, value.constant)));
    }
}

/// A signed sum of named angles and a constant one.
fn sum(terms: &[(Symbol, bool)], constant: Angle) -> String {
    let mut text = String::new();
    for (symbol, negative) in terms {
        text += if *negative { "- " } else { "+ " };
        text += &symbol.name();
        text.push(' ');
    }
    text + "+ " + &constant.text()
}
