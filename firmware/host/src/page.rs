//! The short tables of `docs/microcontroller.md`, made from the rows of the long one.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::Error;
use crate::rows::{FAMILIES, FOLLOWER, Row, arms, followed};

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

/// Both tables.
fn table(rows: &[Row]) -> String {
    format!("{}\n{}", functions(rows), followers(rows))
}

/// A number of a row, by column.
fn number(rows: &[Row], arm: &str, function: &str, column: usize) -> Option<u64> {
    let row = rows.iter().find(|row| row.key.0 == arm && row.key.1 == function)?;
    row.numbers.get(column).copied().flatten()
}

fn shown(number: Option<u64>) -> String {
    number.map_or("-".to_owned(), thousands)
}

/// Followers: one line an arm that is followed.
fn followers(rows: &[Row]) -> String {
    let mut text = "| arm | exact tick | times `inverse` | deviating tick | times `inverse` | at worst | times `inverse` | flash at 3 | flash at `s` | beside `inverse_near` | stack |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    let exact = 3 + 3 * FAMILIES.len();
    let deviating = exact + 3;
    for arm in followed() {
        let of = |function: &str, column: usize| number(rows, arm, function, column);
        let times = |column: usize| {
            let tick = of(FOLLOWER, column).zip(of("inverse", 3).filter(|inverse| *inverse > 0));
            // Tenths, rounded.
            let tenths = tick.map(|(tick, inverse)| (20 * tick + inverse) / (2 * inverse));
            tenths.map_or("-".to_owned(), |tenths| format!("{}.{}", tenths / 10, tenths % 10))
        };
        let both = |column: usize| format!("{} / {}", shown(of(FOLLOWER, column)), shown(of(FOLLOWER, column + 1)));
        let beside = |column: usize| shown(of("inverse_near", column));
        let _ = writeln!(
            text,
            "| `{arm}` | {} | {} | {} | {} | {} | {} | {} | {} | {} / {} | {} |",
            both(exact),
            times(exact),
            both(deviating),
            times(deviating),
            shown(of(FOLLOWER, deviating + 2)),
            times(deviating + 2),
            shown(of(FOLLOWER, 0)),
            shown(of(FOLLOWER, 1)),
            beside(0),
            beside(1),
            shown(of(FOLLOWER, 2)),
        );
    }
    text
}

/// Functions: one line an arm.
fn functions(rows: &[Row]) -> String {
    let mut text = "| arm | `forward` | and Jacobian | `inverse` | `inverse_into` | `inverse_near` | `inverse_branch` | longest call | flash at 3 | flash at `s` | stack | stack, list kept |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    let number = |arm: &str, function: &str, column: usize| number(rows, arm, function, column);
    // Bytes, then median, 99th percentile and worst of each family, random first.
    let worst = |arm: &str| {
        let columns = (0..FAMILIES.len()).map(|family| 5 + 3 * family);
        let functions = ["inverse", "inverse_near", "inverse_branch"];
        columns.flat_map(|column| functions.map(|function| number(arm, function, column))).flatten().max()
    };
    let stack =
        |arm: &str| ["inverse", "inverse_near"].map(|function| number(arm, function, 2)).into_iter().flatten().max();
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
    fn a_tick_is_told_in_times_of_the_inverse() {
        let arm = followed().first().map_or(String::new(), |arm| (*arm).to_owned());
        let row = |function: &str, value: u64| Row {
            key: (arm.clone(), function.to_owned()),
            numbers: vec![Some(value); 27],
        };
        let text = followers(&[row("inverse", 4000), row(FOLLOWER, 8610), row("inverse_near", 7000)]);
        let line = text.lines().nth(2).map_or("", |line| line);
        assert!(line.starts_with(&format!("| `{arm}` | 8,610 / 8,610 | 2.2 | 8,610 / 8,610 | 2.2 |")), "{text}");
        assert!(line.ends_with("| 8,610 | 8,610 | 7,000 / 7,000 | 8,610 |"), "{text}");
    }

    #[test]
    fn the_table_has_a_place() {
        let page = format!("head\n{BEGIN}old\n{END}tail\n");
        assert_eq!(place(&page), Some(("head\n", "tail\n")));
        assert_eq!(place("head\n"), None);
    }
}
