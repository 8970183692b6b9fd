//! Tables of text.

/// Four decimals, no negative zero.
pub fn fixed(value: f64) -> String {
    let text = format!("{value:.4}");
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}

/// Columns at the width of their widest entry: numbers to the right, words to the left.
pub fn aligned(table: &[Vec<String>]) -> String {
    let columns = table.first().map_or(0, Vec::len);
    let cell = |row: &[String], column: usize| row.get(column).cloned().unwrap_or_default();
    let widths: Vec<usize> = (0..columns)
        .map(|column| table.iter().map(|row| cell(row, column).chars().count()).max().unwrap_or(0))
        .collect();
    let is_number = |column: usize| table.iter().skip(1).all(|row| cell(row, column).parse::<f64>().is_ok());
    let mut text = String::new();
    for row in table {
        let cells = widths.iter().enumerate().map(|(column, width)| match is_number(column) {
            true => format!("{:>width$}", cell(row, column)),
            false => format!("{:<width$}", cell(row, column)),
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text += "\n";
    }
    text
}
