//! The only file that knows the YAML library.
//!
//! The text becomes a tree of [`Node`]s that keeps everything, also keys that occur twice. So one reading finds all
//! mistakes. The library gives a place only with an error, so a node is located when a mistake needs it.
//! The text is read again up to that node, where the reader fails on purpose: the error has the place.

use super::angle::{decimal, without_leading_zeros};
use super::nesting::too_deep;
use super::place::{Place, Step};
use serde::Deserialize;
use serde::de::{self, Deserializer, EnumAccess, IgnoredAny, MapAccess, SeqAccess, VariantAccess, Visitor};
use std::fmt;

/// A YAML value.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Node>),
    /// The entries in the order of the file, a key may occur twice.
    Mapping(Vec<(Node, Node)>),
    /// A value with a tag such as `!length`.
    Tagged(String),
}

impl Node {
    /// The value of a finite number, in quotes or not. No text with leading zeros is one: `010` is 8 to other readers.
    pub fn number(&self) -> Option<f64> {
        match self {
            Node::Number(value) => Some(*value).filter(|value| value.is_finite()),
            Node::Text(text) if without_leading_zeros(text).is_none() => decimal(text.trim()),
            _ => None,
        }
    }
}

/// Text that is not YAML.
#[derive(Debug)]
pub struct Broken {
    pub message: String,
    /// Line and column, from 1.
    pub at: Option<(usize, usize)>,
}

/// Reads a text of one YAML document.
pub fn parse(text: &str) -> Result<Node, Broken> {
    if let Some(at) = too_deep(text) {
        return Err(Broken { message: "brackets nest more than 1000 deep".to_owned(), at: Some(at) });
    }
    serde_yaml::from_str::<Node>(text).map_err(|error| {
        // The library's only mistake without a place.
        if position(&error).is_none()
            && let Some(at) = second_document(text)
        {
            return Broken { message: "a second document begins here".to_owned(), at: Some(at) };
        }
        let at = position(&error);
        let mut message = error.to_string();
        if let Some((line, column)) = at {
            // The place is shown in front of the message; a second place in the text ("while parsing ... at") stays.
            message = message.replacen(&format!(" at line {line} column {column}"), "", 1);
        }
        Broken { message, at }
    })
}

/// Where a second document begins, for which the library has an error without a place.
fn second_document(text: &str) -> Option<(usize, usize)> {
    let lines = text.lines().map(str::trim_end).enumerate();
    let mut after_content =
        lines.skip_while(|(_, line)| line.is_empty() || line.starts_with(['#', '%']) || *line == "---");
    after_content.find(|(_, line)| line.starts_with("---")).map(|(index, _)| (index + 1, 1))
}

/// Line and column, from 1, of the node at `place`.
pub fn locate(text: &str, place: &Place) -> Option<(usize, usize)> {
    let walk = Walk { steps: place.steps() };
    position(&de::DeserializeSeed::deserialize(walk, serde_yaml::Deserializer::from_str(text)).err()?)
}

fn position(error: &serde_yaml::Error) -> Option<(usize, usize)> {
    error.location().map(|at| (at.line(), at.column()))
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Build)
    }
}

/// The visitor's functions for scalars: each begins with the visitor's `scalar`, and gives the value.
macro_rules! scalars {
    ($($visit:ident($($value:tt: $type:ty)?) => $result:expr,)*) => {
        $(fn $visit<E: de::Error>(self $(, $value: $type)?) -> Result<Self::Value, E> {
            self.scalar()?;
            Ok($result)
        })*
    };
}

/// Builds a node from whatever stands there.
struct Build;

impl Build {
    fn scalar<E>(self) -> Result<(), E> {
        Ok(())
    }
}

impl<'de> Visitor<'de> for Build {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a YAML value")
    }

    scalars! {
        visit_unit() => Node::Null,
        visit_none() => Node::Null,
        visit_bool(value: bool) => Node::Bool(value),
        visit_i64(value: i64) => Node::Number(value as f64),
        visit_u64(value: u64) => Node::Number(value as f64),
        visit_i128(value: i128) => Node::Number(value as f64),
        visit_u128(value: u128) => Node::Number(value as f64),
        visit_f64(value: f64) => Node::Number(value),
        visit_str(value: &str) => Node::Text(value.to_owned()),
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(node) = access.next_element()? {
            list.push(node);
        }
        Ok(Node::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = access.next_entry()? {
            entries.push(entry);
        }
        Ok(Node::Mapping(entries))
    }

    fn visit_enum<A: EnumAccess<'de>>(self, access: A) -> Result<Node, A::Error> {
        let (tag, content) = access.variant::<String>()?;
        content.newtype_variant::<IgnoredAny>()?;
        Ok(Node::Tagged(tag))
    }
}

/// Follows the steps and fails at the node at their end.
#[derive(Clone, Copy)]
struct Walk<'p> {
    steps: &'p [Step],
}

impl Walk<'_> {
    fn scalar<E: de::Error>(self) -> Result<(), E> {
        if self.steps.is_empty() { Err(E::custom("here")) } else { Ok(()) }
    }
}

impl<'de> de::DeserializeSeed<'de> for Walk<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Walk<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the node looked for")
    }

    scalars! {
        visit_unit() => (),
        visit_none() => (),
        visit_bool(_: bool) => (),
        visit_i64(_: i64) => (),
        visit_u64(_: u64) => (),
        visit_i128(_: i128) => (),
        visit_u128(_: u128) => (),
        visit_f64(_: f64) => (),
        visit_str(_: &str) => (),
    }

    fn visit_enum<A: EnumAccess<'de>>(self, access: A) -> Result<(), A::Error> {
        self.scalar()?;
        let (_, content) = access.variant::<IgnoredAny>()?;
        content.newtype_variant::<IgnoredAny>().map(drop)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<(), A::Error> {
        let Some((first, rest)) = self.steps.split_first() else { return self.scalar() };
        let mut index = 0;
        if let Step::Item(wanted) = *first {
            while index < wanted && access.next_element::<IgnoredAny>()?.is_some() {
                index += 1;
            }
            access.next_element_seed(Walk { steps: rest })?;
        }
        while access.next_element::<IgnoredAny>()?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<(), A::Error> {
        let Some((first, rest)) = self.steps.split_first() else { return self.scalar() };
        let mut index = 0;
        if let Step::Key(wanted) | Step::Value(wanted) = *first {
            while index < wanted && access.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {
                index += 1;
            }
            if matches!(first, Step::Key(_)) {
                access.next_key_seed(Walk { steps: &[] })?;
            } else if access.next_key::<IgnoredAny>()?.is_some() {
                access.next_value_seed(Walk { steps: rest })?;
            }
        }
        while access.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;

    const TEXT: &str =
        "# an arm\nname: x\njoints:\n  - {a: 1, b: [2, pi/2, !t 3], 'c': }\n  - a: .inf\n    d: {e: null}\n";

    fn at(steps: &[Step]) -> Option<(usize, usize)> {
        locate(TEXT, &steps.iter().copied().collect())
    }

    #[test]
    fn keeps_every_entry() {
        let Node::Mapping(entries) = parse("{a: 1, a: x, b: [true, null, -2.5e1]}").unwrap() else { panic!("mapping") };
        let text = |t: &str| Node::Text(t.to_owned());
        let list = Node::List(vec![Node::Bool(true), Node::Null, Node::Number(-25.0)]);
        assert_eq!(entries, [(text("a"), Node::Number(1.0)), (text("a"), text("x")), (text("b"), list)]);
        assert_eq!(parse("!t 3").unwrap(), Node::Tagged("t".to_owned()));
    }

    #[test]
    fn a_number_in_quotes_is_a_number() {
        for (text, value) in [("2.5", 2.5), ("'0'", 0.0), ("\"-1e-3\"", -1e-3), ("' +90 '", 90.0), ("'0.5'", 0.5)] {
            assert_eq!(parse(text).unwrap().number(), Some(value), "{text}");
        }
        for text in ["010", "'-007'", "'1.57 rad'", "'inf'", "'nan'", "'1e400'", "''", "'-'", "'e'", ".inf", "true"] {
            assert_eq!(parse(text).unwrap().number(), None, "{text}");
        }
    }

    #[test]
    fn locates_every_kind_of_node() {
        assert_eq!(at(&[]), Some((2, 1)));
        assert_eq!(at(&[Step::Key(1)]), Some((3, 1)));
        assert_eq!(at(&[Step::Value(0)]), Some((2, 7)));
        let row = [Step::Value(1), Step::Item(0)];
        assert_eq!(at(&row), Some((4, 5)));
        let in_row = |more: &[Step]| at(&[&row, more].concat());
        assert_eq!(in_row(&[Step::Value(0)]), Some((4, 9)));
        assert_eq!(in_row(&[Step::Key(1)]), Some((4, 12)));
        assert_eq!(in_row(&[Step::Value(1), Step::Item(1)]), Some((4, 19)));
        assert_eq!(in_row(&[Step::Value(1), Step::Item(2)]), Some((4, 25)));
        assert_eq!(in_row(&[Step::Key(2)]), Some((4, 32)));
        let second = [Step::Value(1), Step::Item(1), Step::Value(1)];
        assert_eq!(at(&second), Some((6, 8)));
        assert_eq!(at(&[&second[..], &[Step::Value(0)]].concat()), Some((6, 12)));
        assert_eq!(at(&[Step::Value(7)]), None);
    }

    #[test]
    fn broken_text_has_a_place_and_says_it_once() {
        let broken = parse("joints:\n  - {a: 1\n  - {a: 2}\n").unwrap_err();
        assert_eq!(broken.at, Some((3, 5)));
        assert!(!broken.message.contains("line 3 column 5"), "{}", broken.message);
        assert_eq!(parse("# x\n---\na: 1\n---\nb: 2\n").unwrap_err().at, Some((4, 1)));
    }
}
