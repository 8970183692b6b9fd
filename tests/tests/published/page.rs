//! `docs/published-arms.md` has the numbers that the tests hold.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::tables::rows;

/// The cells of the page's tables, row by row, without formatting.
fn page() -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/published-arms.md");
    let text = fs::read_to_string(path).unwrap();
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    text.lines().filter(|line| line.starts_with('|')).map(cells).collect()
}

/// Some row of some table begins with these cells.
pub fn has(row: &[String]) {
    assert!(page().iter().any(|cells| cells.starts_with(row)), "{row:?} is not on the page");
}

/// Numbers with so many decimals, a comma between; a negative zero is 0.
fn list(numbers: &Value, decimals: usize) -> String {
    let scale = f64::powi(10.0, i32::try_from(decimals).unwrap());
    let number = |number: &Value| format!("{:.decimals$}", (number.as_f64().unwrap() * scale).round() / scale + 0.0);
    numbers.as_array().unwrap().iter().map(number).collect::<Vec<_>>().join(", ")
}

/// Joint vectors in parentheses.
fn vectors(solutions: &Value) -> String {
    solutions.as_array().unwrap().iter().map(|q| format!("({})", list(q, 6))).collect::<Vec<_>>().join(", ")
}

#[test]
fn the_page_has_the_numbers() {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    for row in rows::<Value>("denso_vs6556_trajectory") {
        let [x, y, z] = ["X", "Y", "Z"].map(|axis| list(&Value::from(vec![row[axis].clone()]), 7));
        has(&[row["t"].to_string(), x, y, z]);
    }
    for row in rows::<Value>("planar2r_inverse") {
        let printed = row["printed"].as_str().unwrap().replace("+-", "±").replace(' ', ", ");
        let printed = printed.replace("theta1=", "").replace("theta2=", "");
        let [x, y, l1, l2] = ["px", "py", "l1", "l2"].map(|key| text(&row[key]));
        has(&[format!("{x}, {y}"), format!("{l1}, {l2}"), printed, vectors(&row["solutions_deg"])]);
    }
    for row in rows::<Value>("planar3r_inverse") {
        let [x, y, phi] = ["x", "y", "phi"].map(|key| text(&row[key]));
        let links: Vec<_> = row["l"].as_array().unwrap().iter().map(text).collect();
        has(&[format!("{x}, {y}, {phi}"), links.join(", "), vectors(&row["solutions_deg"])]);
    }
    for row in rows::<Value>("salman_rrr_forward_pulses") {
        // Home is in whole numbers.
        let decimals = if row["q_deg"][0] == 0.0 { 0 } else { 4 };
        let [theory, reached] = ["theoretical", "actual"].map(|key| list(&row[key], decimals));
        has(&[list(&row["q_deg"], 0), theory, list(&row["pulses_from_home"], 0), reached]);
    }
    for row in rows::<Value>("salman_rrr_inverse") {
        let limits = if row["within_table3_limits"] == true { "within" } else { "beyond" };
        let ending = [list(&row["q_deg"], 4), list(&row["pulses_from_home"], 0), limits.to_owned()];
        let case = text(&row["case"]).replace(" elbow ", "-");
        assert!(page().iter().any(|cells| cells[0] == case && cells.ends_with(&ending)), "{case}: {ending:?}");
    }
    for angles in rows::<Value>("jupiter_validation")[0]["all_solutions_geometric_deg"].as_array().unwrap() {
        has(&list(angles, 0).split(", ").map(str::to_owned).collect::<Vec<_>>());
    }
}
