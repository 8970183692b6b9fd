//! Advice for laws that are typed in another way.

use super::law::parse;
use crate::number_arguments::{with_decimal_points, without_brackets};

/// The laws as they are to be typed, where only signs and units differ and they then are laws; `wanted` of them if that
/// is known.
pub fn advice(text: &str, wanted: Option<usize>) -> Option<String> {
    let is_list = |text: &str| parse(text).is_ok_and(|laws| wanted.is_none_or(|wanted| wanted == laws.len()));
    let plain = without_units(&without_brackets(text).replace(['\u{2212}', '\u{2013}'], "-"));
    // Laws between semicolons have commas for points.
    let semicolons = with_decimal_points(&plain).replace(';', ",");
    let found = [plain, semicolons].into_iter().find(|other| other != text && is_list(other))?;
    let separated: Vec<&str> = found.split(',').map(str::trim).collect();
    let units = if has_unit(text) { "; numbers have no unit, angles are as --units says" } else { "" };
    Some(format!("write --law \"{}\"{units}", separated.join(", ")))
}

const UNITS: [&str; 7] = ["deg", "rad", "mm", "cm", "m", "in", "s"];

/// A text without the units that follow its numbers.
fn without_units(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if first.is_alphabetic() {
            rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = rest.split_at_checked(length).unwrap_or((rest, ""));
        let behind_number = kept.trim_end().ends_with(|c: char| c.is_ascii_digit());
        if behind_number && (UNITS.contains(&word) || word == "\u{b0}") {
            kept.truncate(kept.trim_end().len());
        } else {
            kept.push_str(word);
        }
        rest = after;
    }
    kept
}

fn has_unit(text: &str) -> bool {
    without_units(text) != text
}

#[cfg(test)]
mod tests {
    use super::advice;

    #[test]
    fn laws_typed_in_another_way_are_shown_as_they_are_to_be_typed() {
        for (text, wanted, expected) in [
            ("0,5 t, 0", Some(2), "write --law \"0.5 t, 0\""),
            ("0,5t; 90", None, "write --law \"0.5t, 90\""),
            ("[t, 2t]", None, "write --law \"t, 2t\""),
            ("90deg, 3\u{b0} + t", None, "write --law \"90, 3 + t\"; numbers have no unit, angles are as --units says"),
            ("\u{2212}t", Some(1), "write --law \"-t\""),
        ] {
            assert_eq!(advice(text, wanted).as_deref(), Some(expected), "{text}");
        }
        for (text, wanted) in [("t, t", Some(3)), ("3x", None), ("0,5,1", Some(2)), ("", None)] {
            assert_eq!(advice(text, wanted), None, "{text}");
        }
    }
}
