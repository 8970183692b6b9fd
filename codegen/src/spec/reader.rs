//! Reads nodes as what they should be and collects what is wrong instead of stopping at the first mistake.

use super::nearest::nearest;
use super::place::{Place, Step};
use super::range::{self, Range};
use super::source::Source;
use super::suggestions;
use super::yaml::Node;
use crate::error::{Diagnostic, Errors};
use std::borrow::Cow;

/// For a length or an angle without a value.
pub const NOTHING: &str = "write 0 where there is none";

/// A node and where it stands.
#[derive(Debug, Clone)]
pub struct Field<'n> {
    pub node: &'n Node,
    pub place: Place,
    /// Its key as written, to name it in messages.
    pub key: String,
}

/// The mistakes and warnings found so far, and the text they are found in.
pub struct Reader<'s> {
    pub source: &'s Source,
    pub mistakes: Vec<Diagnostic>,
    pub warnings: Vec<Diagnostic>,
    /// Every length that was read, with its place.
    pub lengths: Vec<(f64, Place)>,
}

/// The longest list of keys in a message.
const LONGEST_LIST: usize = 72;

/// The most mistakes of form that are shown, and the most warnings. The text is read again for the place of each.
const MOST_MISTAKES: usize = 50;

/// Characters of a text that a message quotes.
const LONGEST_QUOTE: usize = 80;

impl<'n> Field<'n> {
    /// The entries of its list `nodes`, each with the key of the list.
    pub fn items(&self, nodes: &'n [Node]) -> Vec<Self> {
        let item = |(index, node)| Field { node, place: self.place.to(Step::Item(index)), key: self.key.clone() };
        nodes.iter().enumerate().map(item).collect()
    }
}

/// The entries of a mapping with known keys.
pub struct Fields<'n> {
    entries: Vec<Field<'n>>,
    /// Known keys that an unknown key was probably meant to be; they are not reported as missing too.
    meant: Vec<&'static str>,
    pub place: Place,
}

impl<'n> Fields<'n> {
    pub fn get(&self, key: &str) -> Option<Field<'n>> {
        self.entries.iter().find(|field| field.key == key).cloned()
    }

    /// Returns true if the key is there, or a misspelling of it.
    pub fn has(&self, key: &str) -> bool {
        self.meant.contains(&key) || self.entries.iter().any(|field| field.key == key)
    }
}

impl<'s> Reader<'s> {
    pub fn new(source: &'s Source) -> Self {
        Self { source, mistakes: Vec::new(), warnings: Vec::new(), lengths: Vec::new() }
    }

    /// Returns true if no more mistakes are looked for.
    pub fn is_full(&self) -> bool {
        self.mistakes.len() >= MOST_MISTAKES
    }

    /// Returns true if a warning more is shown.
    pub fn may_warn(&self) -> bool {
        self.warnings.len() < MOST_MISTAKES
    }

    /// The mistakes of a reader that is full, and the remark that there may be more.
    pub fn into_most(self) -> Errors {
        let more = format!("the first {MOST_MISTAKES} mistakes are shown: what follows them was not read");
        let mut mistakes = self.mistakes;
        mistakes.truncate(MOST_MISTAKES);
        mistakes.push(Diagnostic::error(more));
        Errors::new(mistakes)
    }

    /// Records that `field` is not what was expected.
    pub fn unexpected(&mut self, field: &Field<'_>, expected: &str, help: Option<String>) {
        if self.is_full() {
            return;
        }
        let found = describe(field.node, &self.source.written(&field.place));
        let message = format!("`{}`: expected {expected}, found {found}", field.key);
        let mistake = self.source.mistake(&field.place, message);
        self.mistakes.push(Diagnostic { help, ..mistake });
    }

    /// A mapping whose keys are all among `known`. `what` names it in messages ("a joint row").
    pub fn mapping<'n>(&mut self, field: &Field<'n>, what: &str, known: &[&'static str]) -> Option<Fields<'n>> {
        if self.is_full() {
            return None;
        }
        let Node::Mapping(entries) = field.node else {
            let help = suggestions::mapping(&field.key, &self.source.written(&field.place), field.node, known);
            // A list that is no line any more is left to the example of the help.
            let keys = known.join(", ");
            let is_told = keys.len() <= LONGEST_LIST || help.is_none();
            let expected = if is_told { format!("a mapping with {keys}") } else { what.to_owned() };
            self.unexpected(field, &expected, help);
            return None;
        };
        let mut fields = Fields { entries: Vec::new(), meant: Vec::new(), place: field.place.clone() };
        for (index, (key, node)) in entries.iter().enumerate() {
            if self.is_full() {
                break;
            }
            let at_key = field.place.to(Step::Key(index));
            let Node::Text(name) = key else {
                let found = describe(key, &self.source.written(&at_key));
                let message = format!("expected a key of {what}, found {found}");
                let mistake = self.source.mistake(&at_key, message);
                // `{a: 80,5}` is a mapping with the key 5, `{limits: -90, 90}` one with the key 90.
                let before = index.checked_sub(1).and_then(|before| entries.get(before));
                let help = match (key, before) {
                    (Node::Number(_), Some((Node::Text(list), Node::Number(_)))) if list == "limits" => {
                        let low = self.source.written(&field.place.to(Step::Value(index - 1)));
                        format!("write limits: [{low}, {}]", self.source.written(&at_key))
                    }
                    (Node::Number(part), Some((_, Node::Number(whole))))
                        if whole.fract() == 0.0 && part.fract() == 0.0 && *part >= 0.0 =>
                    {
                        let whole = self.source.written(&field.place.to(Step::Value(index - 1)));
                        format!("write {whole}.{}, with a decimal point", self.source.written(&at_key))
                    }
                    _ => format!("{what} has {}", known.join(", ")),
                };
                self.mistakes.push(mistake.help(help));
                continue;
            };
            // An empty value has no text to point at.
            let place = if *node == Node::Null { at_key.clone() } else { field.place.to(Step::Value(index)) };
            let entry = Field { node, place, key: name.clone() };
            if let Some(first) = entries.iter().take(index).position(|(earlier, _)| earlier == key) {
                let line = self.source.location(&field.place.to(Step::Key(first))).line;
                let mistake =
                    self.source.mistake(&at_key, format!("the key `{}` occurs twice in {what}", quoted(name)));
                self.mistakes.push(mistake.help(format!("the first one is in line {line}: remove one of them")));
            } else if known.contains(&name.as_str()) {
                fields.entries.push(entry);
            } else {
                // `a:1` is one word in YAML, and so is `a 1`.
                let end = |c: char| c == ':' || c.is_whitespace();
                let (word, rest) =
                    name.split_once(end).map_or((name.as_str(), None), |(word, rest)| (word, Some(rest)));
                let meant = suggestions::synonym(word, known).or_else(|| nearest(word, known.iter().copied()));
                let hint = if meant.is_none() {
                    suggestions::inner_key(name, known, node).or_else(|| suggestions::foreign_key(name, known))
                } else {
                    None
                };
                if let Some(hint) = hint {
                    let mistake = self.source.mistake(&at_key, format!("unknown key `{}` in {what}", quoted(name)));
                    self.mistakes.push(mistake.help(hint));
                    continue;
                }
                let advice = match (meant, rest) {
                    (Some(word), None) => format!("did you mean `{word}`? "),
                    (Some(word), Some(rest)) => {
                        let lacks =
                            if name.contains(':') { "a space after the colon" } else { "a colon after the key" };
                        format!("write `{word}: {}`, with {lacks}; ", rest.trim())
                    }
                    (None, _) => String::new(),
                };
                let mistake = self.source.mistake(&at_key, format!("unknown key `{}` in {what}", quoted(name)));
                self.mistakes.push(mistake.help(format!("{advice}{what} has {}", known.join(", "))));
                fields.meant.extend(known.iter().copied().filter(|word| Some(*word) == meant));
            }
        }
        Some(fields)
    }

    /// Text, trimmed and not empty.
    pub fn text(&mut self, field: &Field<'_>, expected: &str, help: &str) -> Option<String> {
        match field.node {
            Node::Text(text) if text.trim().contains(char::is_control) => {
                self.unexpected(field, &format!("{expected} in one line"), Some(help.to_owned()));
                None
            }
            Node::Text(text) if !text.trim().is_empty() => Some(text.trim().to_owned()),
            Node::Number(_) | Node::Bool(_) => {
                let written = self.source.written(&field.place);
                self.unexpected(
                    field,
                    expected,
                    Some(format!("write it in quotes if it is meant as text: \"{written}\"")),
                );
                None
            }
            _ => {
                self.unexpected(field, expected, Some(help.to_owned()));
                None
            }
        }
    }

    /// One of a few words. `synonyms` are what people write for them instead.
    pub fn choice<T: Copy>(
        &mut self,
        field: &Field<'_>,
        choices: &[(&str, T)],
        synonyms: &[(&str, &str)],
    ) -> Option<T> {
        let words: Vec<&str> = choices.iter().map(|&(word, _)| word).collect();
        let expected = format!("one of {}", words.join(", "));
        let Node::Text(text) = field.node else {
            self.unexpected(field, &expected, None);
            return None;
        };
        let found = choices.iter().find(|(word, _)| *word == text.trim()).map(|&(_, value)| value);
        if found.is_none() {
            let lower = text.trim().to_lowercase();
            let synonym = synonyms.iter().find(|(other, _)| *other == lower).map(|&(_, word)| word);
            // Of two letters one is half the word: `km` is not `mm`. Nor is `grad` a slip of `rad`.
            let near = nearest(&lower, words).filter(|word| *word == lower || (lower.len() > 2 && lower != "grad"));
            let meant = synonym.or(near);
            self.unexpected(field, &expected, meant.map(|word| format!("did you mean `{word}`?")));
        }
        found
    }

    /// Help for the last mistake, where it has none.
    pub fn advise(&mut self, help: &str) {
        if let Some(mistake) = self.mistakes.last_mut() {
            mistake.help.get_or_insert_with(|| help.to_owned());
        }
    }

    pub fn boolean(&mut self, field: &Field<'_>) -> Option<bool> {
        if let Node::Bool(value) = *field.node {
            return Some(value);
        }
        self.unexpected(field, "true or false", None);
        None
    }

    /// A finite number in the file's length unit.
    pub fn number(&mut self, field: &Field<'_>) -> Option<f64> {
        self.displacement(field, "lengths are in the unit that `units` names; write 0 where there is none")
    }

    /// A finite number in the file's length unit, with advice of its own for a number that is too large or too small.
    pub fn displacement(&mut self, field: &Field<'_>, help: &str) -> Option<f64> {
        if let Some(value) = field.node.number() {
            let value = self.within(range::LENGTH, field, value, help)?;
            self.lengths.push((value, field.place.clone()));
            return Some(value);
        }
        match field.node {
            Node::Number(_) => self.unexpected(field, "a finite number", None),
            Node::Text(text) => match text.trim().parse::<f64>() {
                Ok(value) if !value.is_finite() => self.unexpected(field, "a finite number", None),
                _ => self.unexpected(field, "a number in the file's length unit", suggestions::number(text)),
            },
            Node::Null => self.unexpected(field, "a number in the file's length unit", Some(NOTHING.to_owned())),
            _ => self.unexpected(field, "a number in the file's length unit", None),
        }
        None
    }

    /// The value, unless it is beyond the range; `help` says what to write instead.
    pub fn within(&mut self, range: Range, field: &Field<'_>, value: f64, help: &str) -> Option<f64> {
        match range.missed(value) {
            None => Some(value),
            Some(expected) => {
                self.unexpected(field, &expected, Some(help.to_owned()));
                None
            }
        }
    }

    /// A list of exactly `N` entries, each with the key of the list.
    pub fn list<'n, const N: usize>(
        &mut self,
        field: &Field<'n>,
        expected: &str,
        help: &str,
    ) -> Option<[Field<'n>; N]> {
        let Node::List(nodes) = field.node else {
            self.unexpected(field, expected, Some(help.to_owned()));
            return None;
        };
        let entries = field.items(nodes);
        let found = entries.len();
        let entries = entries.try_into().ok();
        if entries.is_none() {
            let entries = if found == 1 { "entry" } else { "entries" };
            let message = format!("`{}`: expected {expected}, found a list of {found} {entries}", field.key);
            let written = self.source.written(&field.place);
            let spelled = suggestions::decimal_commas(&written, found, N).or_else(|| suggestions::commas(&written, N));
            let help = spelled.unwrap_or_else(|| help.to_owned());
            self.mistakes.push(self.source.mistake(&field.place, message).help(help));
        }
        entries
    }
}

/// A text as a message quotes it.
fn quoted(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST_QUOTE) {
        Some((end, _)) => Cow::Owned(format!("{}...", text.get(..end).unwrap_or_default())),
        None => Cow::Borrowed(text),
    }
}

/// Description of a node, in the words of a message.
fn describe(node: &Node, written: &str) -> String {
    match node {
        Node::Null => "nothing".to_owned(),
        Node::Bool(value) => format!("`{value}`"),
        Node::Number(_) => format!("the number {}", quoted(written)),
        Node::Text(text) if text.trim().is_empty() => "an empty text".to_owned(),
        // A line break, a bell or a tab as it may be written.
        Node::Text(text) => format!("`{}`", quoted(&text.replace(char::is_control, " "))),
        Node::List(_) => "a list".to_owned(),
        Node::Mapping(_) => "a mapping".to_owned(),
        Node::Tagged(tag) => format!("the tag `{tag}`, and tags mean nothing here"),
    }
}
