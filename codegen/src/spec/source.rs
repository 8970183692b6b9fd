//! The text of an arm file, and the way from a node back to its line and column.

use super::place::{Place, Step};
use super::yaml;
use crate::error::{Diagnostic, Location};
use std::path::Path;

/// The text of an arm file with the name the user gave it.
#[derive(Debug, Clone)]
pub struct Source {
    file: String,
    text: String,
}

impl Source {
    /// The text of the file of that name.
    pub fn new(file: &str, text: &str) -> Self {
        // A byte order mark is no part of the text.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self { file: file.to_owned(), text: text.to_owned() }
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The file's name without folder and extension, the name of an arm that has none.
    pub fn stem(&self) -> String {
        let stem = Path::new(&self.file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        stem.filter(|stem| !stem.trim().is_empty()).unwrap_or_else(|| "arm".to_owned())
    }

    /// The leading comment lines without `#`, one paragraph break for each blank line between them.
    pub fn leading_comment(&self) -> Option<String> {
        let lines: Vec<&str> = self
            .text
            .lines()
            .map(str::trim)
            .take_while(|line| line.is_empty() || line.starts_with('#') || *line == "---")
            .filter(|line| *line != "---")
            .map(|line| line.trim_start_matches('#').trim())
            .collect();
        let comment = lines.join("\n").trim().to_owned();
        (!comment.is_empty()).then_some(comment)
    }

    /// Line, column and excerpt of the node at `place`.
    pub fn location(&self, place: &Place) -> Location {
        let (line, column) = yaml::locate(&self.text, place).unwrap_or((1, 1));
        self.location_at(line, column)
    }

    /// The excerpt at a line and column, both from 1.
    pub fn location_at(&self, line: usize, column: usize) -> Location {
        // An error at the end of the text is shown behind the last character there is.
        let lines = self.text.lines().count().max(1);
        let (line, column) = if line > lines { (lines, usize::MAX) } else { (line, column) };
        let source_line = self.text.lines().nth(line.saturating_sub(1)).unwrap_or_default().to_owned();
        let column = column.min(source_line.trim_end().chars().count() + 1).max(1);
        let width = token(&source_line, column).chars().count().max(1);
        Location { file: self.file.clone(), line, column, source_line, width }
    }

    /// The scalar, list or mapping at `place` as it is written, as far as it goes on its line.
    pub fn written(&self, place: &Place) -> String {
        let at = self.location(place);
        token(&at.source_line, at.column).to_owned()
    }

    /// The two entries of the list at `place` as they are written.
    pub fn written_ends(&self, place: &Place) -> [String; 2] {
        [0, 1].map(|index| self.written(&place.to(Step::Item(index))))
    }

    /// A mistake at a node.
    pub fn mistake(&self, place: &Place, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(message).at(self.location(place))
    }

    /// A warning at a node.
    pub fn warning(&self, place: &Place, message: impl Into<String>) -> Diagnostic {
        Diagnostic::warning(message).at(self.location(place))
    }
}

/// The piece of `line` that begins at `column` (from 1). It is a quoted text, a bracketed list or mapping, or a plain
/// scalar up to the sign that ends it. It ends with the line.
fn token(line: &str, column: usize) -> &str {
    let start = line.char_indices().nth(column.saturating_sub(1)).map_or(line.len(), |(at, _)| at);
    let rest = line.get(start..).unwrap_or_default();
    let end = match rest.chars().next() {
        Some(quote @ ('"' | '\'')) => rest.char_indices().skip(1).find(|&(_, c)| c == quote).map(|(at, _)| at + 1),
        Some('[' | '{') => closing_bracket(rest),
        _ => plain_end(rest),
    };
    rest.get(..end.unwrap_or(rest.len())).unwrap_or(rest).trim_end()
}

/// The byte behind the bracket that closes the first one.
fn closing_bracket(rest: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, c) in rest.char_indices() {
        match c {
            '[' | '{' => depth += 1,
            ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return Some(at + 1);
        }
    }
    None
}

/// The byte at which a plain scalar ends.
fn plain_end(rest: &str) -> Option<usize> {
    let follow = rest.char_indices().skip(1).map(|(at, _)| at).chain([rest.len()]);
    rest.char_indices().zip(follow).find_map(|((at, c), next)| {
        let next = rest.get(next..).and_then(|more| more.chars().next()).unwrap_or(' ');
        let ends = matches!(c, ',' | ']' | '}') || (c == ':' && next == ' ') || (c == ' ' && next == '#');
        ends.then_some(at)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_token_ends_where_it_is_written_to_end() {
        let line = "  - {a: -pi/2, alpha: 'x y', b: [1, [2]], c: 90 deg} # {";
        assert_eq!(token(line, 5), "{a: -pi/2, alpha: 'x y', b: [1, [2]], c: 90 deg}");
        assert_eq!(token(line, 6), "a");
        assert_eq!(token(line, 9), "-pi/2");
        assert_eq!(token(line, 23), "'x y'");
        assert_eq!(token(line, 33), "[1, [2]]");
        assert_eq!(token(line, 46), "90 deg");
        assert_eq!(token("name: x # y", 7), "x");
        assert_eq!(token("short", 99), "");
    }

    #[test]
    fn the_leading_comment_is_kept_without_its_signs() {
        let source = Source::new("specs/ur5.yaml", "# One.\n#   Two.\n\nname: x\n# no\n");
        assert_eq!(source.leading_comment().as_deref(), Some("One.\nTwo."));
        assert_eq!(Source::new("x", "name: x").leading_comment(), None);
        assert_eq!(source.stem(), "ur5");
        assert_eq!(Source::new("", "").stem(), "arm");
    }

    #[test]
    fn a_place_behind_the_text_is_shown_at_its_end() {
        let at = Source::new("x", "joints: [1,\n").location_at(2, 1);
        assert_eq!((at.line, at.column, at.width), (1, 12, 1));
        let empty = Source::new("x", "").location_at(1, 1);
        assert_eq!((empty.line, empty.column, empty.width), (1, 1, 1));
    }
}
