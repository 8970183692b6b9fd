//! Colors of messages. The palette is that of clap, whose messages stand beside them.

use std::io::{self, Write};

use anstream::adapter::StripBytes;
use clap::builder::Styles;
use clap::builder::styling::Style;

const STYLES: Styles = Styles::styled();

/// The text between the escape sequences of a style.
fn painted(style: &Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}

/// The flags of a solution: green if exact and nothing else, yellow if there is something to look at.
pub fn flags(names: &str) -> String {
    painted(if names == "EXACT" { STYLES.get_valid() } else { STYLES.get_invalid() }, names)
}

/// A line of a message with its label in color: `error:`, `warning:`, `help:` or `hint:`. The label stands first,
/// behind the place in a file, or behind the ` = ` of an excerpt.
fn labeled(line: &str) -> String {
    let labels = [
        ("error:", STYLES.get_error()),
        ("warning:", STYLES.get_invalid()),
        ("help:", STYLES.get_valid()),
        ("hint:", STYLES.get_valid()),
    ];
    let styled = |(label, style): (&str, &Style)| {
        let at = line.find(label)?;
        let (before, rest) = (line.get(..at)?, line.get(at + label.len()..)?);
        let starts = before.is_empty() || before.trim() == "=" || is_place(before);
        starts.then(|| format!("{before}{}{rest}", painted(&style.bold(), label)))
    };
    labels.into_iter().find_map(styled).unwrap_or_else(|| line.to_owned())
}

/// True for `file:line:column: `.
fn is_place(text: &str) -> bool {
    let mut parts = text.strip_suffix(": ").unwrap_or_default().rsplit(':');
    let mut number = || parts.next().is_some_and(|part| part.parse::<usize>().is_ok());
    number() && number()
}

/// A writer of messages that colors their labels. A line is written when it is whole, the last one at a flush.
pub struct Labels<'w> {
    inner: &'w mut dyn Write,
    line: Vec<u8>,
}

impl<'w> Labels<'w> {
    /// In front of another writer.
    pub fn new(inner: &'w mut dyn Write) -> Self {
        Self { inner, line: Vec::new() }
    }

    fn end_line(&mut self) -> io::Result<()> {
        let line = std::mem::take(&mut self.line);
        match std::str::from_utf8(&line) {
            Ok(text) => self.inner.write_all(labeled(text).as_bytes()),
            Err(_) => self.inner.write_all(&line),
        }
    }
}

impl Write for Labels<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for piece in bytes.split_inclusive(|byte| *byte == b'\n') {
            self.line.extend_from_slice(piece);
            if piece.ends_with(b"\n") {
                self.end_line()?;
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if !self.line.is_empty() {
            self.end_line()?;
        }
        self.inner.flush()
    }
}

/// A writer that takes escape sequences out.
pub struct Plain<'w> {
    inner: &'w mut dyn Write,
    state: StripBytes,
}

impl<'w> Plain<'w> {
    /// In front of another writer.
    pub fn new(inner: &'w mut dyn Write) -> Self {
        Self { inner, state: StripBytes::new() }
    }
}

impl Write for Plain<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for piece in self.state.strip_next(bytes) {
            self.inner.write_all(piece)?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.inner.flush()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn a_label_is_colored_where_it_begins_a_message() {
        for (before, label, rest) in [
            ("", "error:", " no arm file"),
            ("", "help:", " write error: at the start"),
            ("   ", "= help:", " did you mean `alpha`?"),
            ("arm.yaml:5:12: ", "warning:", " 1.5708 rad is nearly 90"),
            (r"C:\arm.yaml:5:12: ", "warning:", " of another system"),
        ] {
            let line = format!("{before}{label}{rest}");
            let (start, word) = label.split_once(' ').map_or(("", label), |(start, word)| (start, word));
            let colored = labeled(&line);
            assert!(colored.contains('\u{1b}'), "{line}");
            let plain = anstream::adapter::strip_str(&colored).to_string();
            assert_eq!(plain, line);
            let until = format!("{before}{start}");
            assert!(colored.trim_start_matches(&until).trim_start().starts_with('\u{1b}'), "{colored:?}");
            assert!(colored.contains(&format!("m{word}\u{1b}")), "{colored:?}");
        }
        for line in ["", "no error: here", "errors", "name: x", "12: warning: of one number"] {
            assert_eq!(labeled(line), line);
        }
    }

    #[test]
    fn labels_are_found_in_pieces_of_lines() {
        let mut written = Vec::new();
        let mut labels = Labels::new(&mut written);
        for piece in ["er", "ror", ": a\nhe", "lp: b\nc", "\u{e4}"] {
            labels.write_all(piece.as_bytes()).unwrap();
        }
        labels.write_all(b"\xff").unwrap();
        labels.flush().unwrap();
        let bytes = labeled("error: a\n") + &labeled("help: b\n") + "c\u{e4}";
        assert_eq!(written, [bytes.as_bytes(), b"\xff"].concat());
    }
}
