//! Text in, text or JSON out: what the worker calls.

use denhart_codegen::Builder;
use denhart_tools::export::{self, COptions};
use denhart_tools::import::{self, Options};
use denhart_tools::presets::{self, presets};
use denhart_tools::{Units, check, schema};
use serde_json::{Value, json};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::numbers::thrown;

/// The name of the file in the editor.
const FILE: &str = "arm.yaml";

/// Version of the generator.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// JSON schema of arm files.
#[wasm_bindgen(js_name = schemaText)]
pub fn schema_text() -> String {
    schema::schema().to_string()
}

/// Mistakes and warnings, each with its place: JSON, a list.
#[wasm_bindgen]
pub fn messages(text: &str) -> String {
    let list = match denhart_codegen::program(text, FILE) {
        Ok(program) => program.warnings.iter().map(check::message).collect(),
        Err(errors) => errors.iter().map(check::message).collect::<Vec<Value>>(),
    };
    Value::from(list).to_string()
}

/// The report of `denhart check`, as text and as JSON: two strings.
#[wasm_bindgen]
pub fn report(text: &str) -> Vec<String> {
    let checked = check::check(text, FILE, None);
    let units = Units::Deg;
    vec![checked.text(units), format!("{:#}", checked.json(units))]
}

/// The generated Rust, as `denhart expand` prints it.
#[wasm_bindgen]
pub fn code(text: &str) -> Result<String, JsError> {
    Builder::of_text(text, FILE).warnings(false).generate().map_err(thrown)
}

/// The header of the library for C.
#[wasm_bindgen]
pub fn header(text: &str) -> Result<String, JsError> {
    let library = export::c(text, FILE, &COptions::default()).map_err(thrown)?;
    let header = library.files.into_iter().find(|file| file.path.starts_with("include/"));
    let header = header.map(|file| file.text).unwrap_or_default();
    let remark = library.without_inverse.map(|remark| format!("/* {remark} */\n\n")).unwrap_or_default();
    Ok(remark + &header)
}

/// The arm file of a URDF, of a calibration of a UR arm, or of OPW parameters: JSON with the arm file and remarks. A controller's
/// `calibration.conf` is added to the arm file of the editor. `base` and `tool` are the ends of the chain of a URDF; empty for
/// those that the file tells.
#[wasm_bindgen(js_name = importText)]
pub fn import_text(text: &str, from: &str, editor: &str, base: &str, tool: &str) -> Result<String, JsError> {
    if text.contains("delta_theta") {
        let arm_file = import::calibrated(text, editor, FILE).map_err(thrown)?;
        return Ok(json!({"armFile": arm_file, "remarks": Vec::<String>::new()}).to_string());
    }
    let link = |name: &str| Some(name.to_owned()).filter(|name| !name.is_empty());
    let options = Options { from: from.to_owned(), base: link(base), tool: link(tool), ..Options::default() };
    let imported = match text {
        text if text.contains("opw_kinematics_geometric_parameters") => import::opw(text, &options),
        text if text.trim_start().starts_with('<') => import::urdf(text, &options),
        text => import::ur_calibration(text, &options),
    };
    let imported = imported.map_err(thrown)?;
    Ok(json!({"armFile": imported.arm_file, "remarks": imported.remarks}).to_string())
}

/// The known arms, by name: JSON, name and source of each.
#[wasm_bindgen(js_name = presetList)]
pub fn preset_list() -> String {
    let list: Vec<Value> = presets()
        .map(|preset| json!({"name": preset.name, "source": preset.source(), "joints": preset.joints().ok()}))
        .collect();
    Value::from(list).to_string()
}

/// The file of a known arm.
#[wasm_bindgen(js_name = presetFile)]
pub fn preset_file(name: &str) -> Result<String, JsError> {
    Ok(presets::preset(name).map_err(thrown)?.arm_file.to_owned())
}
