//! Arm files from tables of numbers.

use std::f64::consts::PI;
use std::fmt::Write;

use pyo3::prelude::*;

use crate::array::Numbers;
use crate::error;

/// Arguments of `from_dh`.
pub struct Table<'a, 'py> {
    pub a: &'a Bound<'py, PyAny>,
    pub alpha: &'a Bound<'py, PyAny>,
    pub d: &'a Bound<'py, PyAny>,
    pub theta: Option<&'a Bound<'py, PyAny>>,
    pub convention: &'a str,
    pub kinds: Option<Vec<String>>,
    pub limits: Option<&'a Bound<'py, PyAny>>,
    pub angle: &'a str,
    pub length_unit: &'a str,
    pub name: &'a str,
    pub inverse: [Option<&'a str>; 2],
}

impl Table<'_, '_> {
    /// The arm file.
    pub fn text(&self) -> PyResult<String> {
        let turn = match self.angle {
            "rad" => 2.0 * PI,
            "deg" => 360.0,
            other => return Err(error::value(format!("angle: expected \"rad\" or \"deg\", found {other:?}"))),
        };
        if !matches!(self.convention, "standard" | "modified") {
            return Err(error::value(format!(
                "convention: expected \"standard\" or \"modified\" (Craig: row i has a and alpha of the link before), \
                 found {:?}",
                self.convention
            )));
        }
        if !matches!(self.length_unit, "m" | "cm" | "mm" | "in") {
            return Err(error::value(format!(
                "length_unit: expected \"m\", \"cm\", \"mm\" or \"in\", found {:?}",
                self.length_unit
            )));
        }
        let a = column("a", self.a, None)?;
        let joints = a.len();
        let alpha = column("alpha", self.alpha, Some(joints))?;
        let d = column("d", self.d, Some(joints))?;
        let theta = match self.theta {
            Some(theta) => column("theta", theta, Some(joints))?,
            None => vec![0.0; joints],
        };
        let counted = |name: &str, found: usize| {
            if found == joints {
                Ok(())
            } else {
                Err(error::value(format!("{name}: expected {joints} entries as in a, found {found}")))
            }
        };
        if let Some(kinds) = &self.kinds {
            counted("kinds", kinds.len())?;
        }
        let limits = self.limits.map(pairs).transpose()?;
        if let Some(limits) = &limits {
            counted("limits", limits.len())?;
        }
        let mut text = format!(
            "name: {}\nconvention: {}\nunits: {{length: {}, angle: {}}}\n",
            quoted(self.name),
            self.convention,
            self.length_unit,
            self.angle
        );
        if self.name.contains(char::is_control) {
            return Err(error::value(format!("name: expected characters of one line, found {:?}", self.name)));
        }
        for (key, value) in [("task", self.inverse[0]), ("redundant", self.inverse[1])] {
            if let Some(value) = value.filter(|value| value.contains([':', '#', '{', '}', '\n', '\r'])) {
                return Err(error::value(format!(
                    "{key}: expected a word, or a list such as \"[q1, q4]\", found {value:?}"
                )));
            }
        }
        let inverse = [("task", self.inverse[0]), ("redundant", self.inverse[1])];
        let inverse: Vec<String> =
            inverse.into_iter().filter_map(|(key, value)| Some(format!("{key}: {}", value?))).collect();
        if !inverse.is_empty() {
            text += &format!("inverse: {{{}}}\n", inverse.join(", "));
        }
        text += "joints:\n";
        let numbers = a.iter().zip(&alpha).zip(&d).zip(&theta).enumerate();
        for (joint, (((a, alpha), d), theta)) in numbers {
            let kind = match self.kinds.as_ref().and_then(|kinds| kinds.get(joint)).map(String::as_str) {
                None | Some("revolute" | "R") => "revolute",
                Some("prismatic" | "P") => "prismatic",
                Some("fixed" | "F") => "fixed",
                Some(other) => {
                    return Err(error::value(format!(
                        "kinds[{joint}]: expected \"revolute\", \"prismatic\" or \"fixed\", found {other:?}"
                    )));
                }
            };
            let angle = |value: f64| angle(value, turn);
            let _ = write!(
                text,
                "  - {{type: {kind}, a: {a:?}, alpha: {}, d: {d:?}, theta: {}",
                angle(*alpha),
                angle(*theta)
            );
            if let Some(Some([low, high])) = limits.as_ref().and_then(|limits| limits.get(joint)) {
                if low.is_nan() || high.is_nan() {
                    return Err(error::value(format!("limits[{joint}]: expected two numbers, found ({low}, {high})")));
                }
                if low.is_finite() || high.is_finite() {
                    let limit = |value: f64| {
                        if value.is_infinite() {
                            "null".to_owned()
                        } else if kind == "revolute" {
                            angle(value)
                        } else {
                            format!("{value:?}")
                        }
                    };
                    let _ = write!(text, ", limits: [{}, {}]", limit(*low), limit(*high));
                }
            }
            text += "}\n";
        }
        Ok(text)
    }
}

/// The limits of each row.
fn pairs(limits: &Bound<'_, PyAny>) -> PyResult<Vec<Option<[f64; 2]>>> {
    limits.extract().map_err(|_| {
        let found = limits.repr().map_or_else(|_| "another object".to_owned(), |text| text.to_string());
        error::kind(format!(
            "limits: expected a pair (low, high) or None for each row, such as [(-3, 3), None], found {found}"
        ))
    })
}

/// The numbers of a column.
fn column(name: &str, object: &Bound<'_, PyAny>, joints: Option<usize>) -> PyResult<Vec<f64>> {
    let numbers = Numbers::read(name, object)?;
    let values = numbers.values()?.to_vec();
    let shape = crate::array::shown(numbers.shape());
    if numbers.shape().len() != 1 || joints.is_some_and(|joints| joints != values.len()) {
        let expected =
            joints.map_or("one number for each row".to_owned(), |joints| format!("{joints} numbers as in a"));
        return Err(error::value(format!("{name}: expected {expected}, found shape {shape}")));
    }
    if let Some(at) = values.iter().position(|value| !value.is_finite()) {
        return Err(error::value(format!(
            "{name}[{at}]: expected a finite number, found {}",
            values.get(at).copied().unwrap_or(f64::NAN)
        )));
    }
    Ok(values)
}

/// An angle as an arm file has it. A double next to a multiple of 15 degrees means that multiple: `np.pi / 2` is
/// `90 deg`.
fn angle(value: f64, turn: f64) -> String {
    let step = turn / 24.0;
    let multiple = (value / step).round();
    if multiple.abs() <= 48.0 && (value - multiple * step).abs() <= 8.0 * f64::EPSILON * value.abs() {
        return format!("{} deg", 15.0 * multiple);
    }
    format!("{value:?}")
}

/// A name as YAML has it whatever its characters are.
fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('\\', "\\\\").replace('"', "\\\""))
}
