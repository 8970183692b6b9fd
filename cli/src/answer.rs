//! The answer of `denhart inverse` to one target, as text and as JSON.

use denhart::{Branch, Residual, Status};
use denhart_dynamic::{DynamicArm, DynamicSolution, DynamicSolutions, DynamicTarget};
use denhart_tools::closest::{Closest, Missed, closest};
use serde_json::{Value, json};

use crate::Failure;
use crate::forward::pose_json;
use crate::numbers::{Units, count, outside, short};
use crate::table::{aligned, fixed};
use crate::target::{Target, listed};

/// The question: a target, and what stands beside it on the command line.
pub struct Asked {
    pub target: Target,
    /// The values of the redundant joints, or the arm angle, rad or length.
    pub given: Vec<f64>,
    pub near: Option<Vec<f64>>,
}

/// The form of an answer.
#[derive(Clone, Copy)]
pub struct Form {
    pub units: Units,
    /// Lists only solutions within the limits.
    pub within_limits: bool,
    /// Lists only solutions of branches that this name asks for.
    pub branch: Branch,
}

/// Solutions and their form.
pub struct Answer<'a> {
    arm: &'a DynamicArm,
    pub asked: Asked,
    pub solutions: DynamicSolutions,
    form: Form,
}

impl<'a> Answer<'a> {
    /// Solves for a target.
    ///
    /// # Errors
    /// A target that is none.
    pub fn new(arm: &'a DynamicArm, asked: Asked, form: Form) -> Result<Self, Failure> {
        let solutions = match &asked.near {
            Some(near) => arm.inverse_near(&asked.target.target, near)?,
            None => arm.inverse(&asked.target.target, &asked.given)?,
        };
        if solutions.status() == Status::BadTarget {
            return Err(Failure::Usage(
                "not a target: a number is too large, a direction is 0, a rotation is off by more than 1e-3, or --near is \
                 many turns away"
                    .to_owned(),
            ));
        }
        Ok(Self { arm, asked, solutions, form })
    }

    /// Tells if a solution of those that are listed is exact.
    pub fn is_exact(&self) -> bool {
        self.listed().any(|(_, solution)| solution.is_exact())
    }

    /// The solutions to list, each with its number.
    pub fn listed(&self) -> impl Iterator<Item = (usize, &DynamicSolution)> {
        let listed = |(_, solution): &(usize, &DynamicSolution)| {
            self.form.branch.asks_for(solution.branch) && (!self.form.within_limits || solution.is_within_limits())
        };
        (1..).zip(self.solutions.iter()).filter(listed)
    }

    /// How many solutions are within the limits.
    pub fn within_limits(&self) -> usize {
        self.solutions.within_limits().count()
    }

    fn length(&self) -> String {
        self.arm.length_unit().to_string()
    }

    /// The joint values in the units of the command.
    pub fn values(&self, q: &[f64]) -> Vec<f64> {
        self.arm.joint_kinds().iter().zip(q).map(|(kind, q)| self.form.units.of_joint(*kind, *q)).collect()
    }

    /// The difference of forward kinematics from the target, length unit and rad.
    pub fn residual(&self, solution: &DynamicSolution) -> Result<Residual<f64>, Failure> {
        Ok(self.arm.residual(&solution.q, &self.asked.target.target)?)
    }

    /// The limits that are broken.
    fn limits(&self, solution: &DynamicSolution) -> Vec<String> {
        let mut broken = outside(self.arm, &solution.q, self.form.units);
        if broken.is_empty() && !solution.is_within_limits() {
            broken.push("a sum of joints is outside its limits".to_owned());
        }
        broken
    }

    /// The values that the inverse took beside the target, in the units of the command.
    pub fn given(&self) -> Result<Vec<f64>, Failure> {
        let held = match &self.asked.near {
            Some(near) => self.arm.held(near)?,
            None => self.asked.given.clone(),
        };
        let each = held.into_iter().zip(self.arm.given_slides()?);
        Ok(each.map(|(value, slides)| if slides { value } else { self.form.units.of(value) }).collect())
    }

    /// The given values for JSON: a list where the arm file has one, else a number or null.
    fn given_json(&self) -> Result<Value, Failure> {
        let given = self.given()?;
        Ok(if self.arm.given_is_list()? { json!(given) } else { json!(given.first()) })
    }

    /// The closest approach where no solution is exact.
    pub fn closest(&self) -> Option<Closest> {
        if self.solutions.status().is_reachable() {
            return None;
        }
        let Target { target, pose, .. } = &self.asked.target;
        let start = self.asked.near.clone().unwrap_or_else(|| vec![0.0; self.arm.joints()]);
        closest(self.arm, target, pose, &start)
    }

    /// Hints on the numbers of the target, and on free joints where no solution is within limits.
    pub fn hints(&self) -> Vec<String> {
        let mut hints = self.asked.target.hints.clone();
        let chosen = self.asked.near.is_none() && self.within_limits() == 0;
        if let Some(free) =
            self.solutions.iter().find(|solution| chosen && solution.is_exact() && !solution.free.is_empty())
        {
            hints.push(format!(
                "a free joint stands at its default value here ({}); --near puts it next to joint values of yours, which \
                 may be within limits",
                self.free(free)
            ));
        }
        if !self.solutions.is_complete() {
            hints.push(
                "the bound of the call was reached, or its equation has too few digits here: further solutions may exist"
                    .to_owned(),
            );
        }
        if !self.solutions.status().is_reachable() {
            hints.extend(self.asked.target.hint_of_unit(self.arm));
            hints.extend(self.hint_of_given());
        }
        hints
    }

    /// A target out of reach with the values that are given may be in reach with others.
    fn hint_of_given(&self) -> Option<String> {
        let given = self.given().ok().filter(|given| !given.is_empty())?;
        let sweep = if given.len() == 1 { "--sweep tries some, " } else { "" };
        let given = given_words(self.arm, &given, self.form.units).ok()?;
        Some(format!(
            "this is with {given}; with other values the target may be in reach: --given takes them, {sweep}--near takes \
             those of a joint vector"
        ))
    }

    /// The lines above the table: count and units, the target as understood, hints, and the reason of no exact solution.
    pub fn head(&self, count: &str) -> Result<String, Failure> {
        let (length, angle) = (self.length(), self.form.units.symbol());
        let (name, task) = (&self.arm.model().name, self.arm.task()?);
        let mut text = format!("{count} of {name}, task {task}; angles in {angle}, lengths in {length}\n");
        text += &format!("target: {}\n", self.asked.target.words(self.arm, self.form.units)?);
        for hint in self.hints() {
            text += &format!("hint: {hint}\n");
        }
        if self.solutions.deviation() > 0.0 {
            text += &format!("the target's rotation is off by {:.1e}\n", self.solutions.deviation());
        }
        Ok(text)
    }

    /// The reason of no exact solution.
    fn reason(&self, closest: Option<&Closest>) -> String {
        let (length, angle) = (self.length(), self.form.units);
        let missed = match closest.map(|closest| closest.missed) {
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
        };
        let mut text = format!("no exact solution. Missed is the {missed}\n");
        if let Some(Closest { q, .. }) = closest {
            text += &format!("joint values of the closest approach: {}\n", listed(&self.values(q)));
            for broken in outside(self.arm, q, self.form.units) {
                text += &format!("outside the limits there: {broken}\n");
            }
        }
        text
    }

    /// The answer as text.
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn text(&self) -> Result<String, Failure> {
        let found = match self.solutions.len() {
            0 => "no solution".to_owned(),
            n => count(n, "solution"),
        };
        let mut text = self.head(&found)?;
        let given = self.given()?;
        if !given.is_empty() {
            text += &format!("given: {}\n", given_words(self.arm, &given, self.form.units)?);
        }
        if !self.solutions.status().is_reachable() {
            text += &self.reason(self.closest().as_ref());
        }
        let free = self.any_free();
        let mut table = vec![self.header(free)];
        for (number, solution) in self.listed() {
            table.push(self.row(number, solution, free)?);
        }
        if table.len() > 1 {
            text += "\n";
            text += &aligned(&table);
        }
        for (number, solution) in self.listed() {
            for broken in self.limits(solution) {
                text += &format!("\n{number}: {broken}");
            }
        }
        if !self.solutions.is_empty() {
            let all = self.solutions.len();
            text = format!("{}\n\n{} of {all} within limits", text.trim_end(), self.within_limits());
            if self.form.branch != Branch::NONE && self.listed().next().is_none() {
                text += &format!("\nnone of them on the branch {}", self.form.branch);
            }
        }
        Ok(text.trim_end().to_owned() + "\n")
    }

    /// The names of the columns.
    pub fn header(&self, any_free: bool) -> Vec<String> {
        let names = self.arm.joint_names().map(str::to_owned);
        let free = any_free.then(|| "free joints".to_owned());
        let rest =
            ["limits".to_owned(), format!("off by {}", self.length()), format!("off by {}", self.form.units.symbol())];
        let flags = ["branch", "flags"].map(str::to_owned);
        ["#".to_owned()].into_iter().chain(names).chain(flags).chain(free).chain(rest).collect()
    }

    /// A solution as a row of the table.
    pub fn row(&self, number: usize, solution: &DynamicSolution, any_free: bool) -> Result<Vec<String>, Failure> {
        let residual = self.residual(solution)?;
        let values = self.values(&solution.q).into_iter().map(fixed);
        let free = any_free.then(|| self.free(solution));
        let rest = [
            if solution.is_within_limits() { "kept" } else { "broken" }.to_owned(),
            format!("{:.1e}", residual.position),
            format!("{:.1e}", self.form.units.of(residual.orientation)),
        ];
        let flags = [solution.branch.to_string(), solution.flags.to_string()];
        Ok([number.to_string()].into_iter().chain(values).chain(flags).chain(free).chain(rest).collect())
    }

    /// Tells if a column for free joints has an entry.
    pub fn any_free(&self) -> bool {
        self.listed().any(|(_, solution)| !solution.free.is_empty())
    }

    /// The joints that could take other values, by name.
    fn free(&self, solution: &DynamicSolution) -> String {
        let free: Vec<usize> = solution.free.iter().collect();
        let named = self.arm.joint_names().enumerate().filter(|(joint, _)| free.contains(joint));
        let names: Vec<&str> = named.map(|(_, name)| name).collect();
        if names.is_empty() { "-".to_owned() } else { names.join(", ") }
    }

    /// The target in the keys of its task.
    fn target_json(&self) -> Value {
        let units = self.form.units;
        match &self.asked.target.target {
            DynamicTarget::Pose(pose) => pose_json(pose, units),
            DynamicTarget::Position(point) => json!({ "position": point }),
            DynamicTarget::PositionAxis(asked) => json!({ "position": asked.point, "axis": asked.axis }),
            DynamicTarget::PositionAngle(asked) => json!({ "position": asked.point, "angle": units.of(asked.angle) }),
            DynamicTarget::PlanarPose(asked) => json!({ "position": [asked.x, asked.y], "phi": units.of(asked.phi) }),
            DynamicTarget::PlanarPosition(point) => json!({ "position": point }),
        }
    }

    /// Arm, units and target: the keys that do not depend on the solutions.
    pub fn head_json(&self) -> Result<Value, Failure> {
        Ok(json!({
            "arm": self.arm.model().name,
            "task": self.arm.task()?,
            "length_unit": self.length(),
            "angle_unit": self.form.units.symbol(),
            "target": self.target_json(),
            "hints": self.hints(),
        }))
    }

    /// The keys that depend on the solutions.
    pub fn solutions_json(&self) -> Result<Value, Failure> {
        let mut solutions = Vec::new();
        for (_, solution) in self.listed() {
            let residual = self.residual(solution)?;
            solutions.push(json!({
                "q": self.values(&solution.q),
                "branch": solution.branch.to_string(),
                "flags": solution.flags.to_string().split(" | ").collect::<Vec<_>>(),
                "free": solution.free.iter().map(|joint| joint + 1).collect::<Vec<_>>(),
                "within_limits": solution.is_within_limits(),
                "outside_limits": self.limits(solution),
                "residual": { "position": residual.position, "orientation": self.form.units.of(residual.orientation) },
            }));
        }
        Ok(json!({
            "given": self.given_json()?,
            "status": self.status(),
            "complete": self.solutions.is_complete(),
            "found": self.solutions.len(),
            "found_within_limits": self.within_limits(),
            "solutions": solutions,
        }))
    }

    /// The status in one word.
    pub fn status(&self) -> &'static str {
        if self.solutions.status().is_reachable() { "reachable" } else { "unreachable" }
    }

    /// The answer as JSON.
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn json(&self) -> Result<Value, Failure> {
        let closest = self.closest();
        let missed = match closest.as_ref().map(|closest| closest.missed) {
            None => Value::Null,
            Some(Missed::Distance(distance)) => json!({ "what": "distance", "position": distance }),
            Some(Missed::Direction(left)) => json!({
                "what": "direction",
                "position": left.position,
                "orientation": self.form.units.of(left.orientation),
            }),
        };
        let closest = closest.map(|closest| self.values(&closest.q));
        let approach = json!({ "missed": missed, "closest": closest });
        Ok(merged([self.head_json()?, approach, self.solutions_json()?]))
    }
}

/// The values that stand beside the target, with names and units: `q1 = 0.5 m, q3 = 30 deg`.
pub fn given_words(arm: &DynamicArm, values: &[f64], units: Units) -> Result<String, Failure> {
    let each = arm.given()?.into_iter().zip(given_units(arm, units)?).zip(values);
    let words: Vec<String> = each.map(|((name, unit), value)| format!("{name} = {} {unit}", short(*value))).collect();
    Ok(words.join(", "))
}

/// The units of the values that stand beside the target.
pub fn given_units(arm: &DynamicArm, units: Units) -> Result<Vec<String>, Failure> {
    let unit = |slides: bool| if slides { arm.length_unit().to_string() } else { units.symbol().to_owned() };
    Ok(arm.given_slides()?.into_iter().map(unit).collect())
}

/// One object with the keys of all.
pub fn merged<const N: usize>(objects: [Value; N]) -> Value {
    let pairs = objects.into_iter().filter_map(|value| match value {
        Value::Object(object) => Some(object),
        _ => None,
    });
    Value::Object(pairs.flatten().collect())
}
