//! The rows of the table: what the programs of an arm take.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use firmware_cases::Followed;

use crate::Error;
use crate::elf::Program;

/// Functions that are measured, and by itself the program of a control loop: `forward`, `forward_and_jacobian`,
/// `inverse` and `inverse_near` together.
pub const FUNCTIONS: [&str; 7] =
    ["forward", "forward_and_jacobian", "inverse", "inverse_into", "inverse_near", "inverse_branch", "together"];

/// Families of cases, as the chip names them.
pub const FAMILIES: [&str; 6] = ["random", "grid", "singular", "out-of-reach", "drifted", "nan"];

/// The function of a follower's tick, and the families of its ticks.
pub const FOLLOWER: &str = "follower";
pub const TICKS: [&str; 2] = ["exact", "deviating"];

/// Names of the arms that are measured.
#[must_use]
pub fn arms() -> Vec<&'static str> {
    let mut names = Vec::new();
    macro_rules! each {
        ($arm:ident, $scalar:ident) => {
            names.push(stringify!($arm));
        };
    }
    firmware_arms::each_arm!(each);
    names
}

/// Arms whose followers are measured.
#[must_use]
pub fn followed() -> Vec<&'static str> {
    arms().into_iter().filter(|arm| Followed::of(arm).is_some()).collect()
}

/// One line of the table: bytes, then median, 99th percentile and worst instructions of each family.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// Arm and function.
    pub key: (String, String),
    /// Numbers by column; `None`: not measured.
    pub numbers: Vec<Option<u64>>,
}

/// Heads of the numbers.
#[must_use]
pub fn columns() -> Vec<String> {
    let mut heads = vec!["flash-3".to_owned(), "flash-s".to_owned(), "stack".to_owned()];
    for family in families() {
        heads.extend(["median", "p99", "worst"].map(|what| format!("{family}:{what}")));
    }
    heads
}

/// Families of cases, then those of a follower's ticks.
pub fn families() -> impl Iterator<Item = &'static str> {
    FAMILIES.into_iter().chain(TICKS)
}

/// The rows of what `check.sh` left in `folder`: `flash/ARM/FUNCTION.3` and `.s`, programs, with `empty` to take off;
/// `flash/two.together.3`, of two arms; `measured/ARM.txt`, lines of the chip.
///
/// # Errors
/// A program or a measurement is missing.
pub fn read(folder: &Path) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for arm in arms() {
        let measured = measured(&folder.join("measured").join(format!("{arm}.txt")))?;
        let flash = |function: &str, level: &str| -> Result<u64, Error> {
            let of = |name: &str| Program::read(&folder.join("flash").join(arm).join(format!("{name}.{level}")));
            Ok(of(function)?.flash.saturating_sub(of("empty")?.flash))
        };
        let followed = Followed::of(arm).map(|_| FOLLOWER);
        for function in FUNCTIONS.into_iter().chain(followed) {
            let mut numbers = vec![Some(flash(function, "3")?), Some(flash(function, "s")?)];
            let mut instructions = Vec::new();
            let mut stack = None;
            for family in families() {
                let asked = function != "together" && TICKS.contains(&family) == (function == FOLLOWER);
                let found = measured.get(&(function.to_owned(), family.to_owned()));
                match found.filter(|_| asked) {
                    Some(&[median, p99, worst, deepest]) => {
                        instructions.extend([Some(median), Some(p99), Some(worst)]);
                        stack = stack.max(Some(deepest));
                    }
                    None if asked => return Err(format!("{arm}: the chip did not measure {function}, {family}").into()),
                    None => instructions.extend([None; 3]),
                }
            }
            numbers.push(stack);
            numbers.extend(instructions);
            rows.push(Row { key: (arm.to_owned(), function.to_owned()), numbers });
        }
    }
    rows.push(second(folder)?);
    Ok(rows)
}

/// Flash that a second arm of the same structure adds to the program `together` of one arm.
fn second(folder: &Path) -> Result<Row, Error> {
    let flash = |name: &str| Program::read(&folder.join("flash").join(name)).map(|program| program.flash);
    let mut numbers = vec![None; columns().len()];
    for (number, level) in numbers.iter_mut().zip(["3", "s"]) {
        let both = flash(&format!("two.together.{level}"))?;
        *number = Some(both.saturating_sub(flash(&format!("puma560_f32/together.{level}"))?));
    }
    Ok(Row { key: ("puma560_f32+abb_irb2400_f32".to_owned(), "second".to_owned()), numbers })
}

/// By function and family: median, 99th percentile, worst, stack.
type Measured = BTreeMap<(String, String), [u64; 4]>;

fn measured(file: &Path) -> Result<Measured, Error> {
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let mut measured = Measured::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let &["MEASURED", function, family, ref numbers @ ..] = words.as_slice() else {
            return Err(format!("{}: {line}", file.display()).into());
        };
        let numbers = numbers.iter().map(|number| number.parse()).collect::<Result<Vec<u64>, _>>()?;
        let numbers = numbers.try_into().map_err(|_| format!("{}: {line}", file.display()))?;
        measured.insert((function.to_owned(), family.to_owned()), numbers);
    }
    Ok(measured)
}
