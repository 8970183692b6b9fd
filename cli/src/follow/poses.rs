//! The poses of a path, a line each.

use std::io::BufRead;
use std::path::Path;

use denhart_dynamic::DynamicArm;
use serde_json::{Map, Value};

use crate::Failure;
use crate::lines::{Lines, numbers};
use crate::numbers::Units;
use crate::target::{Target, check_columns, is_no_column, open, shown};

/// The name of times.
const TIME: &str = "t";

/// A pose and its line.
pub struct Pose {
    pub target: Target,
    pub number: usize,
}

/// The poses, and their times if they have any, s.
pub struct Poses {
    pub lines: Vec<Pose>,
    pub times: Option<Vec<f64>>,
    /// Columns that do not count.
    pub left_out: Vec<String>,
}

/// Where a line has its time.
enum Time {
    Nowhere,
    /// Before the other numbers.
    First,
    /// In the column of this number, from 0.
    Column(usize),
    Key,
}

impl Poses {
    /// Reads them.
    ///
    /// # Errors
    /// A file that cannot be read; the first line that is no pose, or has no time where the first one has.
    pub fn read(arm: &DynamicArm, file: &Path, units: Units) -> Result<Self, Failure> {
        let name = shown(file);
        let (mut form, mut lines, mut times) = (None, Vec::new(), Vec::new());
        for (index, line) in open(file)?.split(b'\n').enumerate() {
            let bytes = line.map_err(|error| Failure::Other(format!("cannot read {name}: {error}")))?;
            let line = String::from_utf8_lossy(&bytes);
            let line = line.trim_start_matches('\u{feff}').trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let number = index + 1;
            let at = |failure: Failure| failure.at(&format!("{name}:{number}"));
            let (lines_of, time) = match &form {
                Some(form) => form,
                None => {
                    let new = form_of(arm, line).map_err(at)?;
                    let has_names = matches!(new.0, Lines::Named(_));
                    let form = form.insert(new);
                    if has_names {
                        continue;
                    }
                    form
                }
            };
            let (time, rest) = time_of(lines_of, time, arm, line, units).map_err(at)?;
            times.extend(time);
            let target = lines_of.target(arm, rest, units).map_err(at)?;
            lines.push(Pose { target, number });
        }
        if lines.is_empty() {
            return Err(Failure::Usage(format!("{name}: no poses\nhelp: write one a line, as in --pose")));
        }
        let left_out = match &form {
            Some((Lines::Named(names), _)) => {
                names.iter().filter(|name| !name.eq_ignore_ascii_case(TIME) && is_no_column(name)).cloned().collect()
            }
            _ => Vec::new(),
        };
        let times = match form {
            Some((_, Time::Nowhere)) | None => None,
            Some(_) => Some(times),
        };
        Ok(Self { lines, times, left_out })
    }
}

/// The form of a file by its first line, and where its times are.
fn form_of(arm: &DynamicArm, line: &str) -> Result<(Lines, Time), Failure> {
    let lines = Lines::of(line);
    let time = match &lines {
        Lines::Json => {
            let value = object(line);
            let keys = || value.iter().filter_map(Value::as_object).flat_map(Map::keys);
            if keys().any(|key| key == TIME) {
                Time::Key
            } else {
                refuse_other_times(keys())?;
                Time::Nowhere
            }
        }
        Lines::Named(names) => {
            check_columns(names, arm.task()?)?;
            let is_time = |name: &String| name.eq_ignore_ascii_case(TIME);
            if names.iter().filter(|name| is_time(name)).count() > 1 {
                return Err(Failure::Usage(format!("the column {TIME} is there twice\nhelp: leave one of them out")));
            }
            let column = names.iter().position(is_time);
            if column.is_none() {
                refuse_other_times(names)?;
            }
            column.map_or(Time::Nowhere, Time::Column)
        }
        Lines::Numbers => {
            let counts: &[usize] = match arm.task()? {
                "position" | "planar_pose" => &[3, 6],
                "position_angle" => &[4, 6],
                "planar_position" => &[2, 6],
                _ => &[6],
            };
            let numbers = numbers(line);
            let found = numbers.split(separates).filter(|word| !word.is_empty()).count();
            let is_timed = !counts.contains(&found) && found.checked_sub(1).is_some_and(|rest| counts.contains(&rest));
            if is_timed { Time::First } else { Time::Nowhere }
        }
    };
    Ok((lines, time))
}

/// Refuses a column or a key that is left out, and means times: `time`, `t [s]`, `t_s`, `seconds`.
fn refuse_other_times<'n>(names: impl IntoIterator<Item = &'n String>) -> Result<(), Failure> {
    let means_time = |name: &&String| {
        let name = name.trim().to_ascii_lowercase();
        let unit_follows = |rest: &str| rest.starts_with(|c: char| !c.is_alphanumeric());
        name.starts_with("time") || name.starts_with("seconds") || name.strip_prefix(TIME).is_some_and(unit_follows)
    };
    match names.into_iter().find(means_time) {
        Some(name) => Err(Failure::Usage(format!(
            "`{name}`: the times of a path have another name\nhelp: call them {TIME}, in s"
        ))),
        None => Ok(()),
    }
}

/// The time of a line, and the text that has the target.
fn time_of<'l>(
    lines: &Lines,
    time: &Time,
    arm: &DynamicArm,
    line: &'l str,
    units: Units,
) -> Result<(Option<f64>, &'l str), Failure> {
    let read = |text: &str| match text.trim().parse::<f64>() {
        Ok(time) if time.is_finite() => Ok(Some(time)),
        _ => Err(Failure::Usage(format!("`{TIME}`: `{text}` is not a time\nhelp: write a number in s, such as 0.5"))),
    };
    match time {
        Time::Nowhere => Ok((None, line)),
        Time::First => {
            let (first, rest) = line.trim_start_matches('"').split_once(separates).unwrap_or((line, ""));
            Ok((read(first.trim_matches('"'))?, rest))
        }
        Time::Column(index) => {
            let entries = lines.entries(arm, line, units)?;
            Ok((read(entries.get(*index).copied().unwrap_or_default())?, line))
        }
        Time::Key => {
            let value = object(line).and_then(|object| object.get(TIME).cloned());
            let text = value.map_or_else(|| "nothing".to_owned(), |value| value.to_string());
            Ok((read(&text)?, line))
        }
    }
}

fn object(line: &str) -> Option<Value> {
    serde_json::from_str(line).ok()
}

fn separates(c: char) -> bool {
    c.is_whitespace() || matches!(c, ',' | ';')
}
