//! Messages to the user about a wrong arm file.
//!
//! A [`Diagnostic`] is one mistake (or one warning) with its place; [`Errors`] are all the mistakes of one file,
//! in the order of the file. Both display as plain text with the source line and a caret line under the place.

use std::fmt;

/// A place in an arm file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The file as the user named it.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// The column in characters, counted from 1.
    pub column: usize,
    /// The text of that line, for the excerpt.
    pub source_line: String,
    /// How many characters from `column` on are meant, at least 1.
    pub width: usize,
}

/// Characters of the longest line that an excerpt shows whole.
const LONGEST_LINE: usize = 240;

/// Characters before the place in the excerpt of a longer line.
const BEFORE: usize = 60;

impl Location {
    /// The line, or the part of a long one about the place; the place in it, from 0, and the number of carets.
    fn excerpt(&self) -> (String, usize, usize) {
        // A tab counts as one character in `column`, so it must also be one wide in the excerpt.
        let line = self.source_line.replace('\t', " ");
        let (column, width) = (self.column.saturating_sub(1), self.width.max(1));
        if line.chars().nth(LONGEST_LINE).is_none() {
            return (line, column, width);
        }
        let first = column.saturating_sub(BEFORE);
        let part: String = line.chars().skip(first).take(LONGEST_LINE).collect();
        let (before, after) = (
            if first > 0 { "..." } else { "" },
            if line.chars().nth(first + LONGEST_LINE).is_some() { "..." } else { "" },
        );
        (format!("{before}{part}{after}"), before.len() + column - first, width.min(LONGEST_LINE - BEFORE))
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// Severity of a diagnostic: tells whether it stops the generation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// Nothing is generated.
    Error,
    /// The file is used as it stands.
    Warning,
}

/// One mistake or one warning: what was found, where, what was expected, and the fix where it is plain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Message: the value found and the value expected, without the place.
    pub message: String,
    /// The place, where there is one.
    pub at: Option<Location>,
    /// A few words beside the caret, or nothing.
    pub label: String,
    /// Advice: the text to write instead.
    pub help: Option<String>,
    /// Error or warning.
    pub severity: Severity,
}

impl Diagnostic {
    /// A mistake without a place.
    pub fn error(message: impl Into<String>) -> Self {
        Self { message: message.into(), at: None, label: String::new(), help: None, severity: Severity::Error }
    }

    /// A warning without a place.
    pub fn warning(message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(message) }
    }

    /// Adds the place.
    pub fn at(self, at: impl Into<Option<Location>>) -> Self {
        Self { at: at.into(), ..self }
    }

    /// Adds a few words beside the caret.
    pub fn label(self, label: impl Into<String>) -> Self {
        Self { label: label.into(), ..self }
    }

    /// Adds advice.
    pub fn help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(at) = &self.at {
            write!(f, "{at}: ")?;
        }
        if self.severity == Severity::Warning {
            f.write_str("warning: ")?;
        }
        f.write_str(&self.message)?;
        let number = self.at.as_ref().map(|at| at.line.to_string()).unwrap_or_default();
        let gutter = " ".repeat(number.len());
        if let Some(at) = &self.at {
            let (line, column, width) = at.excerpt();
            let (indent, caret) = (" ".repeat(column), "^".repeat(width));
            write!(f, "\n {gutter} |\n {number} | {}\n {gutter} | {indent}{caret}", line.trim_end())?;
            if !self.label.is_empty() {
                write!(f, " {}", self.label)?;
            }
        }
        if let Some(help) = &self.help {
            let continued = format!("\n {gutter}   {}", " ".repeat("help: ".len()));
            write!(f, "\n {gutter} = help: {}", help.replace('\n', &continued))?;
        }
        Ok(())
    }
}

/// All mistakes of one file, in the order of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Errors(Vec<Diagnostic>);

impl Errors {
    /// The mistakes, sorted by their places; those without a place come first. A mistake said twice is kept once.
    pub fn new(mut mistakes: Vec<Diagnostic>) -> Self {
        mistakes.sort_by_key(|mistake| mistake.at.as_ref().map(|at| (at.line, at.column)));
        mistakes.dedup();
        Self(mistakes)
    }

    /// The mistakes one by one.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.0.iter()
    }
}

impl From<Diagnostic> for Errors {
    fn from(mistake: Diagnostic) -> Self {
        Self(vec![mistake])
    }
}

impl<'a> IntoIterator for &'a Errors {
    type Item = &'a Diagnostic;
    type IntoIter = std::slice::Iter<'a, Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, mistake) in self.0.iter().enumerate() {
            let gap = if i == 0 { "" } else { "\n\n" };
            write!(f, "{gap}{mistake}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Errors {}

#[cfg(test)]
mod tests {
    #![allow(clippy::panic)]
    use super::*;

    fn place(line: usize, column: usize) -> Location {
        let source_line = "  - {type: revolute, a: 0, alfa: 90, d: 0, theta: 0}".to_owned();
        Location { file: "specs/bad.yaml".to_owned(), line, column, source_line, width: 4 }
    }

    #[test]
    fn shows_the_source_line_with_a_caret() {
        let shown = Diagnostic::error("unknown key `alfa` in a joint row")
            .at(place(7, 28))
            .help("did you mean `alpha`?\nsecond line")
            .to_string();
        let expected = "\
specs/bad.yaml:7:28: unknown key `alfa` in a joint row
   |
 7 |   - {type: revolute, a: 0, alfa: 90, d: 0, theta: 0}
   |                            ^^^^
   = help: did you mean `alpha`?
           second line";
        assert_eq!(shown, expected);
    }

    #[test]
    fn a_long_line_is_shown_about_the_place() {
        let line = format!("{}bad: [{}]", "x: 1, ".repeat(1000), "0, ".repeat(1000));
        let at = |column, width| Location { column, width, source_line: line.clone(), ..place(1, 1) };
        let shown = Diagnostic::error("wrong").at(at(6001, 3)).to_string();
        let [_, _, excerpt, caret] = &shown.lines().collect::<Vec<_>>()[..] else { panic!("{shown}") };
        assert!(excerpt.len() < 260 && excerpt.ends_with("..."), "{excerpt}");
        assert_eq!(excerpt.find("bad"), caret.find('^'), "{shown}");
        let whole = Diagnostic::error("wrong").at(at(1, 9000)).to_string();
        assert!(whole.lines().all(|line| line.len() < 260) && whole.contains("| x: 1, x"), "{whole}");
    }

    #[test]
    fn sorts_by_place_and_separates_by_a_blank_line() {
        let errors = Errors::new(vec![
            Diagnostic::error("second").at(place(12, 1)).label("here"),
            Diagnostic::error("first").at(place(7, 3)),
            Diagnostic::error("no place"),
        ]);
        let shown = errors.to_string();
        let order: Vec<_> = ["no place\n\n", "first", "\n\nspecs/bad.yaml:12:1: second", "^^^^ here"]
            .iter()
            .map(|part| shown.find(part).unwrap_or_else(|| panic!("{part} in {shown}")))
            .collect();
        assert!(order.is_sorted(), "{shown}");
        assert_eq!(errors.iter().count(), 3);
    }

    #[test]
    fn a_warning_says_so() {
        assert_eq!(Diagnostic::warning("mind this").to_string(), "warning: mind this");
    }
}
