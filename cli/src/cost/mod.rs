//! `denhart check --target cortex-m4f`: what the generator knows of the code of an arm before it is flashed, and what it
//! will take there.
//!
//! An estimate is a sum of counts times coefficients, which are fitted to measurements on the emulated chip. The file of
//! the coefficients says how; `cli/tests/cost.rs` holds them beside the measurements and makes the fit.

mod counts;

use clap::ValueEnum;
use denhart::effort::{MOST_CASCADES, MOST_EVALUATIONS};
use denhart_codegen::Program;
use serde_json::{Map, Value, json};

use counts::{Counts, TOGETHER, counts};

/// A processor.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Target {
    /// Arm Cortex-M4 with its single-precision unit
    #[value(name = "cortex-m4f")]
    CortexM4f,
}

/// A line for each function and quantity: `forward.instructions sin_cos 40 arithmetic 2`.
const CORTEX_M4F: &str = include_str!("cortex-m4f.txt");

/// Estimated quantities of a function, as the table of coefficients names them.
const QUANTITIES: [&str; 3] = ["instructions", "flash", "stack"];

/// Instructions, flash and stack of an arm on a processor.
pub struct Cost {
    sheet: counts::Sheet,
    coefficients: &'static str,
}

impl Cost {
    /// Of an arm.
    pub fn new(program: &Program, target: Target) -> Self {
        let coefficients = match target {
            Target::CortexM4f => CORTEX_M4F,
        };
        Self { sheet: counts(program), coefficients }
    }

    /// The lines for people.
    pub fn text(&self) -> String {
        let Self { sheet, .. } = self;
        let mut lines = vec!["on a Cortex-M4F, in f32, opt-level 3, feature `fpu`:".to_owned()];
        if sheet.branches > 0 {
            let plural = if sheet.branches == 1 { "" } else { "es" };
            lines.push(format!("  inverse: at most {} branch{plural}", sheet.branches));
            let kernels: Vec<String> = sheet.kernels.iter().map(|(name, calls)| format!("{name} {calls}")).collect();
            lines.push(format!("  calls of kernels for an ordinary target: {}", kernels.join(", ")));
            lines.push(format!(
                "  bound of any call: {MOST_CASCADES} cascades, {MOST_EVALUATIONS} evaluations of forward_and_jacobian"
            ));
        }
        lines.push(
            "  estimated: instructions of an ordinary call, bytes of flash of the function alone, bytes of stack"
                .into(),
        );
        for (function, counts) in &sheet.functions {
            let said = QUANTITIES.map(|quantity| {
                self.estimate(function, quantity, counts).map(|value| format!("{} {quantity}", round(value)))
            });
            let said: Vec<String> = said.into_iter().flatten().collect();
            // A program of all but `inverse_branch`: what they share is in it once.
            let name = if *function == TOGETHER { "one program without inverse_branch" } else { function };
            lines.push(format!("    {name}: {}", said.join(", ")));
        }
        lines.join("\n")
    }

    /// The estimates as JSON, with the counts that they are made from.
    pub fn json(&self) -> Value {
        let functions: Map<String, Value> = self
            .sheet
            .functions
            .iter()
            .map(|(function, counts)| {
                let mut object = Map::new();
                for quantity in QUANTITIES {
                    if let Some(value) = self.estimate(function, quantity, counts) {
                        object.insert(quantity.to_owned(), json!(value.round()));
                    }
                }
                let counts: Map<String, Value> =
                    counts.iter().map(|(name, count)| ((*name).to_owned(), json!(count))).collect();
                object.insert("counts".to_owned(), Value::Object(counts));
                ((*function).to_owned(), Value::Object(object))
            })
            .collect();
        json!({
            "branches": self.sheet.branches,
            "kernels": self.sheet.kernels,
            "bound": {"cascades": MOST_CASCADES, "evaluations": MOST_EVALUATIONS},
            "functions": functions,
        })
    }

    /// The sum of counts times coefficients; `None` where the file has no such line.
    fn estimate(&self, function: &str, quantity: &str, counts: &Counts) -> Option<f64> {
        let name = format!("{function}.{quantity}");
        let line = self.coefficients.lines().find(|line| line.split_whitespace().next() == Some(&name))?;
        let words: Vec<&str> = line.split_whitespace().skip(1).collect();
        let terms = words.chunks_exact(2).filter_map(|pair| {
            let [count, coefficient] = pair else { return None };
            let (_, count) = counts.iter().find(|(name, _)| name == count)?;
            Some(*count as f64 * coefficient.parse::<f64>().ok()?)
        });
        Some(terms.sum())
    }
}

/// To two digits: an estimate is not better.
fn round(value: f64) -> f64 {
    let step = 10_f64.powf((value.abs().max(1.0).log10() - 1.0).floor());
    (value / step).round() * step
}

#[cfg(test)]
mod tests {
    use super::round;

    #[test]
    fn two_digits() {
        assert_eq!([0.0, 7.4, 488.0, 4880.0, 33_324.0].map(round), [0.0, 7.4, 490.0, 4900.0, 33_000.0]);
    }
}
