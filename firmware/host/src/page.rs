//! The short table of `docs/microcontroller.md`, made from the rows of the long one.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::Error;
use crate::rows::{FAMILIES, Row, arms};

const BEGIN: &str = "<!-- written by firmware/check.sh --accept -->\n";
const END: &str = "<!-- end -->\n";

/// Writes the short table into the page.
///
/// # Errors
/// The page cannot be read or written, or has no place for the table.
pub fn write(page: &Path, rows: &[Row]) -> Result<(), Error> {
    let text = fs::read_to_string(page).map_err(|error| format!("{}: {error}", page.display()))?;
    let (before, after) = place(&text).ok_or_else(|| format!("{}: no line `{}`", page.display(), BEGIN.trim()))?;
    fs::write(page, format!("{before}{BEGIN}{}{END}{after}", table(rows)))?;
    Ok(())
}

/// # Errors
/// The table of the page is another one than that of the committed `rows`.
pub fn check(page: &Path, rows: &[Row]) -> Result<(), Error> {
    let text = fs::read_to_string(page).map_err(|error| format!("{}: {error}", page.display()))?;
    if text.contains(&format!("{BEGIN}{}{END}", table(rows))) {
        return Ok(());
    }
    Err(format!("{}: its table is not that of measured.txt; `firmware/check.sh --accept` writes both", page.display())
        .into())
}

/// Text before and after the table.
fn place(text: &str) -> Option<(&str, &str)> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some((before, after))
}

/// One line an arm.
fn table(rows: &[Row]) -> String {
    let mut text = "| arm | `forward` | and Jacobian | `inverse` | `inverse_into` | `inverse_near` | `inverse_branch` | longest call | flash at 3 | flash at `s` | stack | stack, list kept |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    let number = |arm: &str, function: &str, column: usize| {
        let row = rows.iter().find(|row| row.key.0 == arm && row.key.1 == function)?;
        row.numbers.get(column).copied().flatten()
    };
    // Bytes, then median, 99th percentile and worst of each family, random first.
    let worst = |arm: &str| {
        let columns = (0..FAMILIES.len()).map(|family| 5 + 3 * family);
        let functions = ["inverse", "inverse_near", "inverse_branch"];
        columns.flat_map(|column| functions.map(|function| number(arm, function, column))).flatten().max()
    };
    let stack =
        |arm: &str| ["inverse", "inverse_near"].map(|function| number(arm, function, 2)).into_iter().flatten().max();
    let shown = |number: Option<u64>| number.map_or("-".to_owned(), thousands);
    for arm in arms() {
        let both =
            |function: &str| format!("{} / {}", shown(number(arm, function, 3)), shown(number(arm, function, 4)));
        let _ = writeln!(
            text,
            "| `{arm}` | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            shown(number(arm, "forward", 3)),
            shown(number(arm, "forward_and_jacobian", 3)),
            both("inverse"),
            both("inverse_into"),
            both("inverse_near"),
            both("inverse_branch"),
            shown(worst(arm)),
            shown(number(arm, "together", 0)),
            shown(number(arm, "together", 1)),
            shown(stack(arm)),
            shown(number(arm, "inverse_into", 2)),
        );
    }
    text
}

/// `12345` as `12,345`.
fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!([0, 999, 1000, 1_234_567].map(thousands), ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn the_table_has_a_place() {
        let page = format!("head\n{BEGIN}old\n{END}tail\n");
        assert_eq!(place(&page), Some(("head\n", "tail\n")));
        assert_eq!(place("head\n"), None);
    }
}
