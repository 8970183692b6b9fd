//! Lines of a file, each a target: numbers, numbers under names, or JSON.

use denhart_dynamic::DynamicArm;

use crate::Failure;
use crate::number_arguments::NumberList;
use crate::numbers::{Units, count};
use crate::target::{Target, of_columns, of_json_text, of_task};

/// The form of the lines.
pub enum Lines {
    /// The numbers of the task.
    Numbers,
    /// Numbers with these names.
    Named(Vec<String>),
    /// A JSON object a line.
    Json,
}

impl Lines {
    /// The form of a file by its first line that is not empty.
    pub fn of(first: &str) -> Self {
        if first.starts_with('{') {
            return Self::Json;
        }
        let mut names: Vec<String> = words(first).map(|word| word.trim_matches('"').to_owned()).collect();
        let is_name = |name: &String| name.starts_with(|c: char| c.is_alphabetic()) && name.parse::<f64>().is_err();
        if !names.iter().any(is_name) || !names.iter().all(|name| name.is_empty() || is_name(name)) {
            return Self::Numbers;
        }
        // Tables end their lines with a comma.
        while names.last().is_some_and(String::is_empty) {
            names.pop();
        }
        Self::Named(names)
    }

    /// The target of a line.
    ///
    /// # Errors
    /// A line that is none.
    pub fn target(&self, arm: &DynamicArm, line: &str, units: Units) -> Result<Target, Failure> {
        match self {
            Self::Json => of_json_text(arm, line, units),
            Self::Numbers => of_task(arm, "", &numbers(line), units),
            Self::Named(names) => of_columns(names, &self.entries(arm, line, units)?)?.target(arm, units),
        }
    }

    /// The entries of a line with names, as many as there are.
    ///
    /// # Errors
    /// Another number of entries.
    pub fn entries<'l>(&self, arm: &DynamicArm, line: &'l str, units: Units) -> Result<Vec<&'l str>, Failure> {
        let mut entries: Vec<&str> = words(line).map(|word| word.trim_matches('"')).collect();
        let Self::Named(names) = self else { return Ok(entries) };
        while entries.len() > names.len() && entries.last().is_some_and(|entry| entry.is_empty()) {
            entries.pop();
        }
        if entries.len() != names.len() {
            let (found, wanted) = (count(entries.len(), "number"), names.len());
            let text = numbers(line);
            let length = arm.length_unit();
            let list = NumberList { option: "", text: &text, angle: units, length, wanted: &[wanted] };
            let help = format!("write {}", names.join(", "));
            return Err(list.wrong_count(&format!("{found}, but {wanted} names"), &help));
        }
        Ok(entries)
    }
}

/// Entries of a line of CSV: between commas, semicolons or tabs, else between spaces.
pub fn words(line: &str) -> impl Iterator<Item = &str> {
    let separated = line.contains([',', ';', '\t']);
    let mark = move |c: char| if separated { matches!(c, ',' | ';' | '\t') } else { c.is_whitespace() };
    line.split(mark).map(str::trim).filter(move |word| separated || !word.is_empty())
}

/// Quotes do not count, and a tab separates. Semicolons do where no comma stands for a decimal point.
pub fn numbers(line: &str) -> String {
    let plain = line.replace('"', "").replace('\t', " ");
    if plain.contains(',') { plain } else { plain.replace(';', " ") }
}
