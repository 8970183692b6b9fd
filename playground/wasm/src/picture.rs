//! Pictures as SVG: for the gallery, and in place of the view in space where the browser has no WebGL.

use denhart::Flags;
use denhart_draw::{Scene, Style, Theme, View, apart};
use denhart_dynamic::DynamicArm;
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::arm::PageArm;
use crate::numbers::{self, target, thrown};

fn theme(dark: bool) -> Theme {
    if dark { Theme::Dark } else { Theme::Light }
}

/// True for a solution that reaches its target, exactly or as near as the inverse promises.
fn reaches(flags: Flags) -> bool {
    flags.contains(Flags::EXACT) || flags.contains(Flags::APPROXIMATE)
}

#[wasm_bindgen]
impl PageArm {
    /// The arm at joint values, with every solution of a target unless `pose` is empty.
    #[allow(clippy::too_many_arguments)]
    pub fn svg(
        &self,
        q: &[f64],
        pose: &[f64],
        angle: f64,
        given: &[f64],
        frames: bool,
        dimensions: bool,
        axes: bool,
        dark: bool,
        width: f64,
        height: f64,
    ) -> Result<String, JsError> {
        let mut scene = Scene::of(&self.arm, q).map_err(thrown)?;
        if let (Some(at), Ok(target)) = (numbers::pose(pose), target(&self.arm, pose, angle)) {
            let solutions = self.arm.inverse(&target, given);
            if let Ok(solutions) = &solutions {
                scene = scene.with_solutions(&self.arm, solutions).map_err(thrown)?;
            }
            scene = scene.with_target(at);
            if solutions.is_ok_and(|solutions| solutions.iter().all(|solution| !reaches(solution.flags))) {
                scene = scene.with_miss();
            }
        }
        if frames {
            scene = scene.with_frames();
        }
        if dimensions {
            scene = scene.with_dimensions();
        }
        if axes {
            scene = scene.with_axes(&self.arm);
        }
        Ok(scene.svg(&Style::of(View::of(&self.arm)).with_theme(theme(dark)).with_size(width, height)))
    }
}

/// The small picture of an arm file, as `denhart draw --apart` makes it.
#[wasm_bindgen]
pub fn thumbnail(text: &str, dark: bool) -> Result<String, JsError> {
    let arm = DynamicArm::from_yaml(text).map_err(thrown)?;
    let view = View::of(&arm);
    let scene = Scene::of(&arm, &apart(&arm, view)).map_err(thrown)?;
    Ok(scene.svg(&Style::of(view).with_theme(theme(dark)).with_size(300.0, 230.0)))
}
