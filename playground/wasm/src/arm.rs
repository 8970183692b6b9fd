//! An arm as the page has it: what moves while a slider or the target moves.

use denhart_codegen::lower::Goal;
use denhart_draw::{DecidingLines, View, apart};
use denhart_dynamic::{DynamicArm, DynamicSolutions, DynamicTarget};
use denhart_tools::closest::{Missed, closest, pose_of};
use serde_json::json;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::facts::facts;
use crate::follow::Following;
use crate::numbers::{self, figure, of_pose, target, thrown};

/// An arm of an arm file.
#[wasm_bindgen]
pub struct PageArm {
    pub(crate) arm: DynamicArm,
    solutions: DynamicSolutions,
    pub(crate) following: Option<Following>,
}

#[wasm_bindgen]
impl PageArm {
    /// Reads an arm file. Throws every mistake in it.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str) -> Result<PageArm, JsError> {
        let arm = DynamicArm::named(text, "arm.yaml").map_err(thrown)?;
        Ok(PageArm { arm, solutions: DynamicSolutions::default(), following: None })
    }

    /// Names, units, limits, task: JSON.
    pub fn facts(&self) -> String {
        facts(&self.arm).to_string()
    }

    /// Joint values at which the joints are seen apart.
    pub fn apart(&self) -> Vec<f64> {
        apart(&self.arm, View::of(&self.arm))
    }

    /// The arm in one posture, as [`numbers::figure`] lays it out.
    pub fn figure(&self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        figure(&self.arm, q).map_err(thrown)
    }

    /// Frames and lengths of the table, and the axes that decide the inverse, in one posture: JSON.
    pub fn table(&self, q: &[f64]) -> Result<String, JsError> {
        let skeleton = denhart_draw::Skeleton::of(&self.arm, q).map_err(thrown)?;
        let frames: Vec<_> = skeleton
            .frames
            .iter()
            .map(|frame| json!({"name": frame.name, "pose": of_pose(&frame.pose).collect::<Vec<f64>>()}))
            .collect();
        let measures: Vec<_> = skeleton
            .measures
            .iter()
            .map(
                |measure| json!({"name": measure.name, "value": measure.value, "from": measure.from, "to": measure.to}),
            )
            .collect();
        let axes: Vec<_> = DecidingLines::of(&self.arm, &skeleton)
            .iter()
            .map(|one| json!({"joints": one.joints, "lines": one.lines, "point": one.point, "words": one.words}))
            .collect();
        Ok(json!({"frames": frames, "measures": measures, "axes": axes, "far": skeleton.far}).to_string())
    }

    /// The tool's pose, then the six rows of the Jacobian in the base frame.
    pub fn jacobian(&self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        let (pose, rows) = self.arm.forward_and_jacobian(q).map_err(thrown)?;
        Ok(of_pose(&pose).chain(rows.iter().flat_map(|row| row.to_vec())).collect())
    }

    /// Margins of a joint vector: JSON, a list of names and values, `null` for a task without.
    pub fn margins(&self, q: &[f64]) -> Result<String, JsError> {
        let margins = self.arm.margins(q).map_err(thrown)?;
        let margins =
            margins.map(|all| all.iter().map(|one| json!({"name": one.name, "value": one.value})).collect::<Vec<_>>());
        let manipulability = self.arm.manipulability(q).map_err(thrown)?;
        Ok(json!({"margins": margins, "manipulability": manipulability}).to_string())
    }

    /// The angle of `position_angle` at a joint vector; not a number for other tasks.
    pub fn angle(&self, q: &[f64]) -> f64 {
        match self.arm.target_at(q) {
            Ok(DynamicTarget::PositionAngle(target)) => target.angle,
            _ => f64::NAN,
        }
    }

    /// The values that the inverse takes beside the target, at a joint vector.
    pub fn held(&self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        self.arm.held(q).map_err(thrown)
    }

    /// Every solution of a target, as [`numbers::solutions`] lays them out.
    pub fn solve(&mut self, pose: &[f64], angle: f64, given: &[f64]) -> Result<Vec<f64>, JsError> {
        let target = target(&self.arm, pose, angle).map_err(thrown)?;
        self.arm.inverse_into(&target, given, &mut self.solutions).map_err(thrown)?;
        numbers::solutions(&self.arm, &self.solutions).map_err(thrown)
    }

    /// The solution next to a joint vector: flags, free joints, the place of the first solution of its branch in the last answer
    /// (-1 if none is), joint values; empty without one.
    pub fn nearest(&self, pose: &[f64], angle: f64, q: &[f64]) -> Vec<f64> {
        let nearest = || {
            let target = target(&self.arm, pose, angle).ok()?;
            let solutions = self.arm.inverse_near(&target, q).ok()?;
            let solution = solutions.first()?;
            let same = |other: &denhart_dynamic::DynamicSolution| other.branch == solution.branch;
            let place = self.solutions.iter().position(same).map_or(-1.0, numbers::count);
            let head = [numbers::of_flags(solution.flags), numbers::of_mask(solution.free), place];
            Some(head.into_iter().chain(solution.q.iter().copied()).collect())
        };
        nearest().unwrap_or_default()
    }

    /// Branches of the solutions of the last call, a line each.
    pub fn branches(&self) -> String {
        let names = self.solutions.iter().map(|solution| solution.branch.to_string());
        names.collect::<Vec<String>>().join("\n")
    }

    /// Why a target has no solution; empty where that is not known.
    pub fn why(&self, pose: &[f64], angle: f64, given: &[f64]) -> String {
        let miss = target(&self.arm, pose, angle).and_then(|target| self.arm.why(&target, given));
        let Some(miss) = miss.ok().flatten() else { return String::new() };
        let unit = self.arm.model().length_unit.symbol();
        if miss.gap.is_some() && !miss.is_direction { format!("{miss} {unit}") } else { miss.to_string() }
    }

    /// The closest approach to a target out of reach from a joint vector: JSON, `null` where there is none.
    pub fn closest(&self, pose: &[f64], angle: f64, q: &[f64]) -> Result<String, JsError> {
        let target = target(&self.arm, pose, angle).map_err(thrown)?;
        let found = closest(&self.arm, &target, &pose_of(&self.arm, &target), q);
        let found = found.map(|found| {
            let (distance, direction) = match found.missed {
                Missed::Distance(distance) => (Some(distance), None),
                Missed::Direction(residual) => (None, Some(residual.orientation)),
            };
            json!({"distance": distance, "direction": direction, "q": found.q})
        });
        Ok(found.map_or_else(|| "null".to_owned(), |found| found.to_string()))
    }

    /// Pulse counts of the motors at joint values; empty where no motor counts them.
    pub fn pulses(&self, q: &[f64]) -> Vec<f64> {
        self.arm.to_pulses(q).map_or_else(|_| Vec::new(), |(counts, _)| counts.into_iter().map(f64::from).collect())
    }
}

impl PageArm {
    /// The axis of the tool that points, for `position_axis`.
    pub(crate) fn column(arm: &DynamicArm) -> Option<usize> {
        match arm.program().inverse.as_ref().ok()?.goal {
            Goal::PositionAxis { column } => Some(column),
            _ => None,
        }
    }
}
