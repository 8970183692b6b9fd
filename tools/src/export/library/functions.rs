//! The functions for C.
//!
//! All are made alike: each pointer is checked before anything is computed, so that nothing is written where one is bad.

use denhart_codegen::lower::Goal;

use crate::export::arm::{Arm, Inverse};

/// An argument: its name, and the type in Rust that it points to.
type Argument = (&'static str, &'static str);

const Q: Argument = ("q", "[Real; JOINTS]");
const MOTOR: Argument = ("motor", "[Real; JOINTS]");
const PULSES: Argument = ("pulses", "[i32; JOINTS]");
const GIVEN: Argument = ("given", "[Real; GIVEN]");
const POSE: Argument = ("pose", "Pose");
const JACOBIAN: Argument = ("jacobian", "Jacobian");

/// A function for C, its arguments in the order of C.
struct Function {
    /// Its name behind the prefix.
    name: &'static str,
    /// Arguments that are read.
    inputs: Vec<Argument>,
    /// The name of a number behind the first input.
    given: Option<String>,
    /// Arguments that are written.
    outputs: Vec<Argument>,
    /// An argument that is written unless its pointer is null.
    optional: Option<Argument>,
    /// Lines over the arguments by their names. The last one is the status.
    body: String,
}

impl Function {
    fn new(name: &'static str, inputs: &[Argument], outputs: &[Argument], body: &str) -> Self {
        let (inputs, outputs) = (inputs.to_vec(), outputs.to_vec());
        Self { name, inputs, given: None, outputs, optional: None, body: body.to_owned() }
    }

    fn text(&self) -> String {
        let mut parameters: Vec<String> = Vec::new();
        for (place, (name, of)) in self.inputs.iter().enumerate() {
            parameters.push(format!("{name}: *const {of}"));
            if place == 0 {
                parameters.extend(self.given.iter().map(|given| format!("{given}: Real")));
            }
        }
        let written = || self.outputs.iter().chain(&self.optional);
        parameters.extend(written().map(|(name, of)| format!("{name}: *mut {of}")));
        let checked: Vec<String> = (self.inputs.iter().map(|(name, _)| format!("read({name})")))
            .chain(self.outputs.iter().map(|(name, _)| format!("Output::at({name})")))
            .chain(self.optional.iter().map(|(name, _)| format!("Output::unless_null({name})")))
            .collect();
        let names: Vec<&str> = self.inputs.iter().chain(written()).map(|(name, _)| *name).collect();
        let found: Vec<String> = names.iter().map(|name| format!("Some({name})")).collect();
        let body: String = self.body.lines().map(|line| format!("    {line}\n")).collect();
        FUNCTION
            .replace("@name@", self.name)
            .replace("@parameters@", &parameters.join(",\n    "))
            .replace("@names@", &names.join(", "))
            .replace("@checked@", &checked.join(", "))
            .replace("@found@", &found.join(", "))
            .replace("@body@", &body)
    }
}

const FUNCTION: &str = "
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern \"C\" fn @prefix@_@name@(
    @parameters@,
) -> i32 {
    // SAFETY: the caller keeps the rules of the header, which are those of `read` and `Output`.
    let (@names@) = unsafe { (@checked@) };
    let (@found@) = (@names@) else { return BAD_ARGUMENT };
@body@}
";

/// The text of all functions of an arm.
pub fn text(arm: &Arm<'_>) -> String {
    let mut functions = kinematics();
    if let Some(inverse) = &arm.inverse {
        functions.extend(self::inverse(inverse));
        if inverse.takes_arm_angle() {
            let body = "arm_angle.write(Robot.arm_angle(&q));\nOK";
            functions.push(Function::new("arm_angle", &[Q], &[("arm_angle", "Real")], body));
        }
    }
    if arm.model.coupling.is_some() {
        functions.push(Function::new("to_motor", &[Q], &[MOTOR], "motor.write(Robot.to_motor(&q));\nOK"));
        functions.push(Function::new("from_motor", &[MOTOR], &[Q], "q.write(Robot.from_motor(&motor));\nOK"));
    }
    if arm.model.actuators.is_some() {
        let to = Function::new("to_pulses", &[Q], &[PULSES], TO_PULSES);
        functions.push(Function { optional: Some(("saturated", "u16")), ..to });
        functions.push(Function::new("from_pulses", &[PULSES], &[Q], "q.write(Robot.from_pulses(&pulses));\nOK"));
    }
    let functions: String = functions.iter().map(Function::text).collect();
    let list = arm.inverse.as_ref().filter(|inverse| inverse.given_is_list);
    let count = list.map(|inverse| format!("\nconst GIVEN: usize = {};\n", inverse.given.len()));
    count.unwrap_or_default() + &functions
}

fn kinematics() -> Vec<Function> {
    let both = "let (tool, columns) = Robot.forward_and_jacobian(&q);\n\
                pose.write(Pose::of(tool));\n\
                jacobian.write(Jacobian::of(columns));\n\
                OK";
    vec![
        Function::new("forward", &[Q], &[POSE], "pose.write(Pose::of(Robot.forward(&q)));\nOK"),
        Function::new("jacobian", &[Q], &[JACOBIAN], "jacobian.write(Jacobian::of(Robot.jacobian(&q)));\nOK"),
        Function::new("forward_and_jacobian", &[Q], &[POSE, JACOBIAN], both),
    ]
}

fn inverse(inverse: &Inverse) -> Vec<Function> {
    // The types of a target in C and in Rust; both structs have the same fields.
    let (kind, rust, fields) = match inverse.goal {
        Goal::Pose => ("Pose", "denhart::Pose", &["rotation", "translation"][..]),
        Goal::Position => ("[Real; 3]", "", &[][..]),
        Goal::PlanarPosition => ("[Real; 2]", "", &[][..]),
        Goal::PositionAxis { .. } => ("Target", "denhart::PointAxis", &["point", "axis"][..]),
        Goal::PositionAngle { .. } => ("Target", "denhart::PointAngle", &["point", "angle"][..]),
        Goal::PlanarPose => ("Target", "denhart::PlanarPose", &["x", "y", "phi"][..]),
    };
    let made = |of: &str, from: &str| {
        let fields: Vec<String> = fields.iter().map(|field| format!("{field}: {from}.{field}")).collect();
        if fields.is_empty() { from.to_owned() } else { format!("{of} {{ {} }}", fields.join(", ")) }
    };
    let meant = &made(rust, "target");
    let target = ("target", kind);
    let given = inverse.given_number().map(|(name, _)| name.clone());
    let list = inverse.given_is_list.then_some(GIVEN);
    let beside = match (&given, list) {
        (Some(name), _) => format!(", {name}"),
        (None, Some((name, _))) => format!(", {name}"),
        (None, None) => String::new(),
    };
    let inputs =
        |behind: Option<Argument>| -> Vec<Argument> { [target].into_iter().chain(list).chain(behind).collect() };
    let listed = |call: &str| {
        format!("let found = Robot.{call};\nsolutions.write(Solutions::of(&found));\nstatus(found.status()).0")
    };
    let solutions = [("solutions", "Solutions")];
    let all = Function::new("inverse", &inputs(None), &solutions, &listed(&format!("inverse(&{meant}{beside})")));
    let near = listed(&format!("inverse_near(&{meant}, &q_ref)"));
    let near = Function::new("inverse_near", &[target, ("q_ref", Q.1)], &solutions, &near);
    let one = BRANCH.replace("@meant@", meant).replace("@beside@", &beside);
    let one = Function::new("inverse_branch", &inputs(Some(("branch", "Branch"))), &[("solution", "Solution")], &one);
    let at = format!("let at = Robot.target_at(&q);\ntarget.write({});\nOK", made(kind, "at"));
    let at = Function::new("target_at", &[Q], &[target], &at);
    let one = Function { given: given.clone(), optional: Some(("gap", "Real")), ..one };
    let one = inverse.has_names.then_some(one);
    [Function { given, ..all }, near].into_iter().chain(one).chain([at]).collect()
}

const BRANCH: &str = "let Some(branch) = branch.named() else { return BAD_ARGUMENT };
let (one, (status, missed)) = match Robot.inverse_branch(&@meant@@beside@, branch) {
    Ok(found) => (Solution::of(&found), (OK, 0.0)),
    Err(outcome) => (Solution::EMPTY, status(outcome)),
};
solution.write(one);
if let Some(gap) = gap {
    gap.write(missed);
}
status";

const TO_PULSES: &str = "let (counts, ends) = Robot.to_pulses_checked(&q);
pulses.write(counts);
if let Some(saturated) = saturated {
    saturated.write(bits(ends));
}
OK";
