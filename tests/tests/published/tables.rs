//! `tests/data/published_tables.json`: the tables of the papers, recomputed with 50 digits, and comparisons.

use serde::Deserialize;
use serde_json::Value;

/// Half of the last digit of a number printed with so many decimals.
pub fn half_digit(decimals: i32) -> f64 {
    0.5 * f64::powi(10.0, -decimals)
}

/// The rows of one table, each as `T`.
pub fn rows<T: for<'a> Deserialize<'a>>(table: &str) -> Vec<T> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/data/published_tables.json");
    let mut tables: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let rows = match tables[table].take() {
        Value::Array(rows) => rows,
        single => vec![single],
    };
    rows.into_iter().map(|row| serde_json::from_value(row).unwrap()).collect()
}

pub fn radians<const N: usize>(degrees: [f64; N]) -> [f64; N] {
    degrees.map(f64::to_radians)
}

/// Largest difference of two joint vectors, rad, whole turns not counted.
pub fn apart<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let turn = std::f64::consts::TAU;
    let difference = |(a, b): (&f64, &f64)| ((a - b) - turn * ((a - b) / turn).round()).abs();
    a.iter().zip(b).map(difference).fold(0.0, f64::max)
}

/// Largest difference of two points in any coordinate.
pub fn off<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Every joint vector expected is found, within `tolerance` rad, and none more.
pub fn same_solutions<const N: usize>(found: &[[f64; N]], expected: &[[f64; N]], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}\n{expected:?}");
    for q in expected {
        assert!(found.iter().any(|found| apart(found, q) < tolerance), "{q:?} is not in {found:?}");
    }
}
