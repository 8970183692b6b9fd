//! The table, printed and compared with the committed one.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::Error;
use crate::page;
use crate::rows::{Row, columns, families, read};

/// Growth that is let pass, in percent.
const GROWTH: u64 = 3;

const HEAD: &str = "\
# A Cortex-M4F (armv7em, single-precision unit), emulated: one instruction counts one. Written by `firmware/check.sh --accept`.
# flash: bytes of a program that calls this function alone, less the empty program, at opt-level 3 and \"s\".
# `together` calls forward, forward_and_jacobian, inverse and inverse_near; `second` is what the same of another arm of like
# structure adds. stack: bytes, painted, the most of all cases.
# Then instructions at opt-level 3 by family of targets: median/p99/worst. `follower` is a tick of `Follower::step`, by whether
# it is exact; its flash is that of a program that begins to follow and makes a step.
";

/// Prints the table of the measurements in `folder` and compares it with the `committed` file; `accept`: writes it there, and its short form into the `page`.
///
/// # Errors
/// A number grew by more than 3 %, or a row or column is not in both.
pub fn check(folder: &Path, committed: &Path, page: &Path, accept: bool) -> Result<(), Error> {
    let rows = read(folder)?;
    let compiler = format!("# compiler: {}\n", fs::read_to_string(folder.join("compiler"))?.trim());
    let text = format!("{HEAD}{compiler}{}", print(&rows));
    print!("{text}");
    if accept {
        fs::write(committed, text)?;
        page::write(page, &rows)?;
        println!("written: {}, {}", committed.display(), page.display());
        return Ok(());
    }
    let before = fs::read_to_string(committed).map_err(|error| format!("{}: {error}", committed.display()))?;
    let committed_rows = parse(&before)?;
    page::check(page, &committed_rows)?;
    let (grown, shrunk) = compare(&committed_rows, &rows);
    for line in &shrunk {
        println!("less: {line}");
    }
    if !shrunk.is_empty() {
        println!("`firmware/check.sh --accept` writes the lesser numbers");
    }
    if grown.is_empty() {
        return Ok(());
    }
    if !before.contains(&compiler) {
        println!(
            "the committed table is of another compiler than {}",
            compiler.trim_start_matches("# compiler: ").trim()
        );
    }
    Err(format!("more than {GROWTH} % above {}:\n{}", committed.display(), grown.join("\n")).into())
}

fn print(rows: &[Row]) -> String {
    let mut lines = vec![["arm", "function", "flash-3", "flash-s", "stack"].map(str::to_owned).to_vec()];
    if let Some(head) = lines.first_mut() {
        head.extend(families().map(str::to_owned));
    }
    for Row { key, numbers } in rows {
        let mut cells = vec![key.0.clone(), key.1.clone()];
        let text = |number: &Option<u64>| number.map_or("-".to_owned(), |number| number.to_string());
        let (bytes, instructions) = numbers.split_at(3.min(numbers.len()));
        cells.extend(bytes.iter().map(text));
        cells.extend(instructions.chunks(3).map(|three| three.iter().map(text).collect::<Vec<_>>().join("/")));
        lines.push(cells);
    }
    let width = |column: usize| lines.iter().filter_map(|line| line.get(column)).map(String::len).max().unwrap_or(0);
    let mut out = String::new();
    for line in &lines {
        let cells: Vec<String> =
            line.iter().enumerate().map(|(column, cell)| format!("{cell:<0$}", width(column))).collect();
        let _ = writeln!(out, "{}", cells.join("  ").trim_end());
    }
    out
}

/// The rows of a printed table.
fn parse(text: &str) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let cells: Vec<&str> = line.split_whitespace().collect();
        let [arm, function, numbers @ ..] = cells.as_slice() else {
            return Err(format!("no row of the table: {line}").into());
        };
        let number = |text: &str| if text == "-" { Ok(None) } else { text.parse().map(Some) };
        let numbers =
            numbers.iter().flat_map(|cell| cell.split('/')).map(number).collect::<Result<Vec<Option<u64>>, _>>()?;
        rows.push(Row { key: ((*arm).to_owned(), (*function).to_owned()), numbers });
    }
    Ok(rows)
}

/// Rows that grew, or are in one table only; and rows that shrank by more than the allowed growth.
fn compare(before: &[Row], now: &[Row]) -> (Vec<String>, Vec<String>) {
    let (mut grown, mut shrunk) = (Vec::new(), Vec::new());
    let name = |row: &Row| format!("{} {}", row.key.0, row.key.1);
    for row in before.iter().filter(|row| !now.iter().any(|other| other.key == row.key)) {
        grown.push(format!("{}: no longer measured", name(row)));
    }
    for row in now {
        let Some(old) = before.iter().find(|old| old.key == row.key) else {
            grown.push(format!("{}: not in the committed table", name(row)));
            continue;
        };
        if old.numbers.len() != row.numbers.len() {
            grown.push(format!("{}: other columns", name(row)));
        }
        for (column, (old, new)) in columns().iter().zip(old.numbers.iter().zip(&row.numbers)) {
            let line = || {
                let text = |number: &Option<u64>| number.map_or("-".to_owned(), |number| number.to_string());
                format!("{} {column}: {} -> {}", name(row), text(old), text(new))
            };
            match (*old, *new) {
                (Some(old), Some(new)) if new * 100 > old * (100 + GROWTH) => grown.push(line()),
                (Some(old), Some(new)) if new * (100 + GROWTH) < old * 100 => shrunk.push(line()),
                (Some(_), Some(_)) | (None, None) => {}
                _ => grown.push(line()),
            }
        }
    }
    (grown, shrunk)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn rows(stack: u64) -> Vec<Row> {
        let mut numbers = vec![Some(1000), Some(500), Some(stack)];
        numbers.resize(columns().len(), Some(10_000));
        vec![Row { key: ("puma560_f32".to_owned(), "inverse".to_owned()), numbers }]
    }

    #[test]
    fn a_printed_table_is_read_back() {
        let mut rows = rows(100);
        rows[0].numbers[5] = None;
        assert_eq!(parse(&print(&rows)).unwrap(), rows);
    }

    #[test]
    fn the_committed_table_is_as_it_is_printed() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let text = fs::read_to_string(here.join("../measured.txt")).unwrap();
        let rows = parse(&text).unwrap();
        let (head, rest) = text.split_at(HEAD.len().min(text.len()));
        let (compiler, printed) = rest.split_once('\n').unwrap();
        assert!(head == HEAD && compiler.starts_with("# compiler: "), "{head}{compiler}");
        assert!(printed == print(&rows), "firmware/measured.txt");
        assert!(rows.iter().all(|row| row.numbers.len() == columns().len()));
        page::check(&here.join("../../docs/microcontroller.md"), &rows).unwrap();
    }

    #[test]
    fn growth_beyond_three_percent_is_named() {
        assert_eq!(compare(&rows(100), &rows(103)), (vec![], vec![]));
        assert_eq!(compare(&rows(100), &rows(104)).0, ["puma560_f32 inverse stack: 100 -> 104"]);
        assert_eq!(compare(&rows(104), &rows(100)), (vec![], vec!["puma560_f32 inverse stack: 104 -> 100".to_owned()]));
    }

    #[test]
    fn rows_are_in_both() {
        assert_eq!(compare(&rows(1), &[]).0, ["puma560_f32 inverse: no longer measured"]);
        assert_eq!(compare(&[], &rows(1)).0, ["puma560_f32 inverse: not in the committed table"]);
    }
}
