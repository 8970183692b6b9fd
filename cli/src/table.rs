//! Tables of text.

use crate::style;

/// Four decimals, no negative zero.
pub fn fixed(value: f64) -> String {
    let text = format!("{value:.4}");
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}

/// Columns at the width of their widest entry: numbers to the right, words to the left. The column `flags` is colored.
pub fn aligned(table: &[Vec<String>]) -> String {
    let columns = table.first().map_or(0, Vec::len);
    let cell = |row: &[String], column: usize| row.get(column).cloned().unwrap_or_default();
    let widths: Vec<usize> = (0..columns)
        .map(|column| table.iter().map(|row| cell(row, column).chars().count()).max().unwrap_or(0))
        .collect();
    let is_number = |column: usize| table.iter().skip(1).all(|row| cell(row, column).parse::<f64>().is_ok());
    let is_flags = |column: usize| table.first().is_some_and(|names| cell(names, column) == "flags");
    let mut text = String::new();
    for (index, row) in table.iter().enumerate() {
        let cells = widths.iter().enumerate().map(|(column, width)| {
            let words = cell(row, column);
            let gap = " ".repeat(width.saturating_sub(words.chars().count()));
            match is_number(column) {
                true => gap + &words,
                false if index > 0 && is_flags(column) => style::flags(&words) + &gap,
                false => words + &gap,
            }
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text += "\n";
    }
    text
}
