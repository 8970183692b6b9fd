//! The arm as header and library see it.

use denhart_codegen::lower::{Given, Goal};
use denhart_codegen::model::{JointKind, Model};
use denhart_codegen::{Program, ScalarKind};

/// The struct in the generated code.
pub const TYPE: &str = "Robot";

/// Name of the arm angle where it is given.
pub const ARM_ANGLE: &str = "arm_angle";

/// An arm to export.
pub struct Arm<'p> {
    /// The checked file.
    pub model: &'p Model,
    /// Beginning of the names in C.
    pub prefix: String,
    /// Number type of the generated code.
    pub scalar: ScalarKind,
    /// The inverse, if there is one.
    pub inverse: Option<Inverse>,
}

/// The inverse as its callers see it.
pub struct Inverse {
    /// The task, with its numbers.
    pub goal: Goal,
    /// The names of the values given beside the target, and in words.
    pub given: Vec<(String, String)>,
    /// True where they are an array, also one of one.
    pub given_is_list: bool,
    /// The largest number of solutions.
    pub most: usize,
    /// True for an arm whose inverse holds a joint: its solutions may be incomplete, and its branches have no names that
    /// last.
    pub holds_a_joint: bool,
    /// A branch can be asked for by its name.
    pub has_names: bool,
}

impl Inverse {
    /// The value given beside the target as a number: its name and the words.
    pub fn given_number(&self) -> Option<&(String, String)> {
        self.given.first().filter(|_| !self.given_is_list)
    }

    /// True for an arm that takes the arm angle.
    pub fn takes_arm_angle(&self) -> bool {
        self.given.iter().any(|(name, _)| name == ARM_ANGLE)
    }
}

impl<'p> Arm<'p> {
    /// Of the programs of an arm.
    ///
    /// # Errors
    /// A prefix that is no name in C, or is taken.
    pub fn new(program: &'p Program, scalar: ScalarKind, prefix: Option<&str>) -> Result<Self, String> {
        let model = &program.model;
        let prefix = match prefix {
            Some(prefix) if identifier(prefix) == prefix => prefix.to_owned(),
            Some(prefix) => {
                let instead = identifier(prefix);
                return Err(format!("--prefix: `{prefix}` cannot name a library for C\nhelp: write `{instead}`"));
            }
            None => identifier(&model.name),
        };
        let inverse = program.inverse.as_ref().ok().map(|inverse| Inverse {
            goal: inverse.goal.clone(),
            given: inverse.given.values.iter().map(|given| self::given(*given, model)).collect(),
            given_is_list: inverse.given.is_list,
            most: inverse.capacity,
            holds_a_joint: inverse.held_joint.is_some(),
            has_names: inverse.held_joint.as_ref().is_none_or(|plan| plan.names.is_some()),
        });
        Ok(Self { model, prefix, scalar, inverse })
    }

    /// True if its numbers are `float` in C.
    pub fn is_single(&self) -> bool {
        self.scalar == ScalarKind::F32
    }

    /// True if a function has a result that may be null: `gap` of an inverse, `saturated` of pulses.
    pub fn has_optional_results(&self) -> bool {
        self.inverse.is_some() || self.model.actuators.is_some()
    }

    /// Number of joints.
    pub fn joints(&self) -> usize {
        self.model.joints.len()
    }

    /// The name of the arm as it may stand in a comment of C and of Rust.
    pub fn title(&self) -> String {
        self.model.name.chars().map(|c| if c.is_control() || "*/\\`\"".contains(c) { '_' } else { c }).collect()
    }

    /// A template of this arm: `@prefix@`, `@PREFIX@`, `@arm@`, `@unit@`, `@joints@`, `@most@`, `@version@`,
    /// and the number type in Rust and C as `@scalar@` and `@real@`.
    pub fn fill(&self, template: &str) -> String {
        let (scalar, real) = if self.is_single() { ("f32", "float") } else { ("f64", "double") };
        let most = self.inverse.as_ref().map_or(0, |inverse| inverse.most);
        template
            .replace("@prefix@", &self.prefix)
            .replace("@PREFIX@", &self.prefix.to_ascii_uppercase())
            .replace("@unit@", self.model.length_unit.symbol())
            .replace("@joints@", &self.joints().to_string())
            .replace("@most@", &most.to_string())
            .replace("@version@", env!("CARGO_PKG_VERSION"))
            .replace("@scalar@", scalar)
            .replace("@real@", real)
            .replace("@arm@", &self.title())
    }
}

fn given(given: Given, model: &Model) -> (String, String) {
    match given {
        Given::Joint { joint, .. } => {
            let name = format!("q{}", joint + 1);
            let unit = model.joints.get(joint).map_or("rad", |joint| unit(joint.kind, model));
            let words = format!("value of joint {}, {unit}", joint + 1);
            (name, words)
        }
        Given::ArmAngle => {
            (ARM_ANGLE.to_owned(), "how far the elbow is swung about the line from shoulder to wrist, rad".to_owned())
        }
    }
}

/// The unit of a joint's values.
pub fn unit(kind: JointKind, model: &Model) -> &'static str {
    match kind {
        JointKind::Revolute => "rad",
        JointKind::Prismatic => model.length_unit.symbol(),
    }
}

/// Libraries and headers of C, whose place the arm's would take, and names that CMake keeps for targets of its own.
const TAKEN: &str = "\
    c dl m pthread rt assert complex ctype errno fenv float inttypes iso646 limits locale math memory setjmp signal \
    stdalign stdarg stdatomic stdbit stdbool stdckdint stddef stdint stdio stdlib stdnoreturn string \
    strings tgmath threads time uchar unistd wchar wctype all clean edit_cache help install package \
    package_source preinstall rebuild_cache test";

/// A name in C, in lower case: letters, digits and `_`, a letter first; none of [`TAKEN`].
fn identifier(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = name.chars().map(plain).collect();
    let name = name.trim_matches('_');
    if name.starts_with(|c: char| c.is_ascii_lowercase()) && TAKEN.split(' ').all(|taken| taken != name) {
        name.to_owned()
    } else {
        format!("arm_{name}").trim_end_matches('_').to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::identifier;

    #[test]
    fn names_in_c() {
        for (name, in_c) in [
            ("ur5", "ur5"),
            ("KUKA KR6-R700", "kuka_kr6_r700"),
            ("2r planar", "arm_2r_planar"),
            ("_hidden", "hidden"),
            ("Arm \u{e9}", "arm"),
            ("\u{e9}", "arm"),
            ("math", "arm_math"),
            ("Test", "arm_test"),
        ] {
            assert_eq!(identifier(name), in_c, "{name}");
        }
    }
}
