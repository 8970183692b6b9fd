//! Numbers in the arguments of the command line: read, or refused with the text to type instead.

use denhart::{JointKind, LengthUnit};
use denhart_codegen::spec::WrittenAngle;
use denhart_dynamic::DynamicArm;

use crate::Failure;
use crate::numbers::{Units, count};

/// A list of numbers as it was typed: the value of an option, or a line of a file.
#[derive(Clone, Copy)]
pub struct NumberList<'t> {
    /// The option, for messages: `--q`. Empty for a line of a file.
    pub option: &'t str,
    pub text: &'t str,
    /// Units of the numbers that are expected.
    pub angle: Units,
    pub length: LengthUnit,
    /// How many numbers there may be.
    pub wanted: &'t [usize],
}

/// Deviations of a text that is typed in another way, and how to type it.
#[derive(Default)]
struct Deviations {
    decimal_comma: bool,
    unit: bool,
    semicolon: bool,
    dash: bool,
}

impl NumberList<'_> {
    /// The numbers: separated by commas or spaces, in brackets or not.
    ///
    /// # Errors
    /// The first word that is no number, with the list to type instead where that is plain.
    pub fn parse(&self) -> Result<Vec<f64>, Failure> {
        let number = |word: &str| match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => {
                let help = self.correction().unwrap_or_else(|| self.expected_form());
                Err(self.failure(&format!("`{word}` is not a number"), &help))
            }
        };
        let values: Vec<f64> = words(without_brackets(self.text)).map(number).collect::<Result<_, _>>()?;
        match self.with_two_readings(values.len()) {
            Some(pointed) => Err(self.failure(
                "commas stand in numbers or between them",
                &format!(
                    "write {}\"{}\", with decimal points, or the numbers with spaces alone",
                    self.option_prefix(),
                    pointed
                ),
            )),
            None => Ok(values),
        }
    }

    /// The list with decimal points, where its commas may be decimal ones: it has spaces too, and its counts with and
    /// without them are both wanted. `count` is the one without.
    fn with_two_readings(&self, count: usize) -> Option<String> {
        let entries: Vec<&str> = without_brackets(self.text).split_whitespace().collect();
        let one_number = |entry: &&str| entry.replacen(',', ".", 1).parse::<f64>().is_ok_and(f64::is_finite);
        let pointed: Vec<String> = entries.iter().map(|entry| entry.replacen(',', ".", 1)).collect();
        let between = |entry: &&str| !entry.starts_with(',') && !entry.ends_with(',');
        let fits = entries.len() != count && self.wanted.contains(&entries.len()) && self.wanted.contains(&count);
        (fits && entries.iter().all(|entry| one_number(entry) && between(entry))).then(|| pointed.join(", "))
    }

    /// The failure of a list with another number of entries than wanted: `what` says how many. `help` follows where the
    /// text has no decimal commas.
    pub fn wrong_count(&self, what: &str, help: &str) -> Failure {
        let help = self.correction().unwrap_or_else(|| help.to_owned());
        self.failure(what, &help)
    }

    /// The failure `what`, with the option before it and `help` behind.
    pub fn failure(&self, what: &str, help: &str) -> Failure {
        let place = if self.option.is_empty() { String::new() } else { format!("{}: ", self.option) };
        Failure::Usage(format!("{place}{what}\nhelp: {help}"))
    }

    /// The option as it stands before its value; nothing in a line of a file.
    pub fn option_prefix(&self) -> String {
        if self.option.is_empty() { String::new() } else { format!("{} ", self.option) }
    }

    /// The advice for a text whose meaning is not known.
    fn expected_form(&self) -> String {
        match self.wanted {
            [1] => format!("write one number, such as {}0.5", self.option_prefix()),
            _ => format!(
                "write numbers with commas or spaces between them, such as {}\"0.5, -90\"",
                self.option_prefix()
            ),
        }
    }

    /// The list as it is to be typed, and why. None where that is not plain, or where the text is right already.
    fn correction(&self) -> Option<String> {
        let mut deviations = Deviations::default();
        let text = without_brackets(self.text);
        let pointed = text.replace(['\u{2212}', '\u{2013}', '\u{2014}'], "-");
        deviations.dash = pointed != text;
        let values = match self.values(&pointed.replace(';', ","), &mut deviations) {
            Some(values) if self.wanted.contains(&values.len()) && !pointed.contains(';') => values,
            _ => {
                // A comma between two digits stands for a point; what separates is a space or a semicolon.
                deviations.decimal_comma = with_decimal_points(&pointed) != pointed;
                deviations.semicolon = pointed.contains(';');
                let values = self.values(&with_decimal_points(&pointed).replace(';', ","), &mut deviations)?;
                if !self.wanted.contains(&values.len()) {
                    return None;
                }
                values
            }
        };
        let reasons: Vec<String> = [
            deviations.decimal_comma.then(|| "with a decimal point".to_owned()),
            deviations.semicolon.then(|| "with commas between the numbers".to_owned()),
            deviations.dash.then(|| "with the minus of the keyboard".to_owned()),
            deviations.unit.then(|| {
                let (angle, length) = (self.angle.symbol(), self.length);
                format!("as plain numbers: angles are in {angle} (--units), lengths in {length}, the unit of the file")
            }),
        ]
        .into_iter()
        .flatten()
        .collect();
        let quoted = if let [one] = &values[..] { one.clone() } else { format!("\"{}\"", values.join(", ")) };
        (!reasons.is_empty()).then(|| format!("write {}{quoted}, {}", self.option_prefix(), reasons.join(", and ")))
    }

    /// The numbers of the text without their units, as they are to be typed.
    fn values(&self, text: &str, deviations: &mut Deviations) -> Option<Vec<String>> {
        // `90 deg` is one value.
        let mut joined: Vec<String> = Vec::new();
        for word in words(text) {
            match joined.last_mut() {
                Some(last) if is_unit(word) => last.push_str(word),
                _ => joined.push(word.to_owned()),
            }
        }
        joined.iter().map(|word| self.value(word, deviations)).collect()
    }

    /// One number in the units of this command.
    fn value(&self, word: &str, deviations: &mut Deviations) -> Option<String> {
        if word.parse::<f64>().is_ok_and(f64::is_finite) {
            return Some(word.to_owned());
        }
        deviations.unit = true;
        let start = word.find(|c: char| c.is_alphabetic() || c == '\u{b0}').unwrap_or(word.len());
        let (number, unit) = word.split_at_checked(start)?;
        if let (Ok(number), Some(unit)) = (number.parse::<f64>(), length_unit(unit)) {
            let own = self.length;
            let converted = || Units::rounded(number * unit.in_meters() / own.in_meters());
            return Some(if own == unit { number.to_string() } else { converted().to_string() });
        }
        let degrees = number.parse::<f64>().ok().filter(|_| matches!(unit, "\u{b0}" | "degree" | "degrees"));
        let angle = degrees.map_or_else(|| WrittenAngle::parse(word), |value| Some(WrittenAngle::Degrees(value)))?;
        Some(match (angle, self.angle) {
            (WrittenAngle::Degrees(value), Units::Deg) | (WrittenAngle::Radians(value), Units::Rad) => {
                value.to_string()
            }
            (angle, units) => units.of(angle.rad()).to_string(),
        })
    }
}

/// A joint vector of an arm, in rad and lengths; `option` is where it comes from, for messages.
///
/// # Errors
/// A word that is no number; another number of values than joints.
pub fn joint_vector(option: &str, text: &str, arm: &DynamicArm, units: Units) -> Result<Vec<f64>, Failure> {
    let (kinds, length) = (arm.joint_kinds(), arm.length_unit());
    let wanted = [kinds.len()];
    let list = NumberList { option, text, angle: units, length, wanted: &wanted };
    let values = list.parse()?;
    if values.len() != kinds.len() {
        let (found, joints) = (count(values.len(), "value"), count(kinds.len(), "joint"));
        let unit = |kind: &JointKind| {
            if *kind == JointKind::Revolute { units.symbol().to_owned() } else { length.to_string() }
        };
        let named = arm.joint_names().zip(kinds).map(|(name, kind)| format!("{name} in {}", unit(kind)));
        let help = format!("write a value for each joint: {}", named.collect::<Vec<_>>().join(", "));
        return Err(list.wrong_count(&format!("{found}, but the arm has {joints}"), &help));
    }
    Ok(kinds.iter().zip(values).map(|(kind, value)| units.joint(*kind, value)).collect())
}

/// The text without the brackets around it.
pub fn without_brackets(text: &str) -> &str {
    let text = text.trim();
    let pairs = [('[', ']'), ('(', ')'), ('{', '}')];
    let within = |(open, close)| text.strip_prefix(open).and_then(|rest: &str| rest.strip_suffix(close));
    pairs.into_iter().find_map(within).unwrap_or(text)
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty())
}

/// Each comma that has a digit on either side as a point.
pub fn with_decimal_points(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let digit = |at: Option<usize>| at.and_then(|at| chars.get(at)).is_some_and(char::is_ascii_digit);
    let pointed = |(at, c): (usize, &char)| match c {
        ',' if digit(at.checked_sub(1)) && digit(Some(at + 1)) => '.',
        c => *c,
    };
    chars.iter().enumerate().map(pointed).collect()
}

fn is_unit(word: &str) -> bool {
    length_unit(word).is_some() || ["deg", "rad", "\u{b0}", "degree", "degrees"].contains(&word)
}

/// The unit of length with this symbol.
fn length_unit(symbol: &str) -> Option<LengthUnit> {
    let all = [LengthUnit::Meter, LengthUnit::Centimeter, LengthUnit::Millimeter, LengthUnit::Inch];
    all.into_iter().find(|unit| unit.to_string() == symbol)
}

/// One plain number, for options of clap.
///
/// # Errors
/// The message, with what to type instead.
pub fn single_number(text: &str) -> Result<f64, String> {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let pointed = with_decimal_points(text);
    match (number(text), number(&pointed)) {
        // What is not finite is refused with the name of the option, by the command.
        (Some(value), _) => Ok(value),
        (None, Some(_)) => Err(format!("not a number\nhelp: write {pointed}, with a decimal point")),
        (None, None) => {
            let digits = text.trim().trim_end_matches(|c: char| c.is_alphabetic()).trim_end();
            let help = number(digits).map(|_| format!("\nhelp: write {digits}, without a unit"));
            Err(format!("not a number{}", help.unwrap_or_default()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn correction(text: &str, angle: Units, wanted: &[usize]) -> Option<String> {
        NumberList { option: "--q", text, angle, length: LengthUnit::Meter, wanted }.correction()
    }

    #[test]
    fn what_is_typed_in_another_way_is_shown_as_it_is_to_be_typed() {
        for (text, count, list, reason) in [
            ("0,5 90 -1,25", 3, "\"0.5, 90, -1.25\"", "with a decimal point"),
            ("0,5, 90, 0", 3, "\"0.5, 90, 0\"", "with a decimal point"),
            ("0,5; 90; 0", 3, "\"0.5, 90, 0\"", "decimal point, and with commas"),
            ("[1; 2; 3]", 3, "\"1, 2, 3\"", "with commas between"),
            ("90deg, 1.5", 2, "\"90, 1.5\"", "as plain numbers: angles are in deg (--units), lengths in m"),
            ("90 deg -30\u{b0}", 2, "\"90, -30\"", "as plain numbers"),
            ("200mm 20 cm, 1in, 0.1 m", 4, "\"0.2, 0.2, 0.0254, 0.1\"", "as plain numbers"),
            ("pi/2, 1 rad", 2, "\"90, 57.2957795130823\"", "as plain numbers"),
            ("0,5 deg", 1, "0.5", "with a decimal point, and as plain"),
            ("\u{2212}90, 0", 2, "\"-90, 0\"", "the minus of the keyboard"),
        ] {
            let help = correction(text, Units::Deg, &[count]);
            let expected = format!("write --q {list}, ");
            assert!(
                help.as_ref().is_some_and(|help| help.starts_with(&expected) && help.contains(reason)),
                "{text}: {help:?}"
            );
        }
        assert!(
            correction("90deg", Units::Rad, &[1])
                .is_some_and(|help| help.starts_with("write --q 1.5707963267948966, "))
        );
        for (text, count) in [("1, 2, x", 3), ("1,2,3", 2), ("0,5,90,0", 3), ("1 2 3", 2), ("", 1), ("5 kg", 1)] {
            assert_eq!(correction(text, Units::Deg, &[count]), None, "{text}");
        }
    }

    #[test]
    fn numbers_stand_in_brackets_or_not() {
        let read = |text| {
            NumberList { option: "--q", text, angle: Units::Deg, length: LengthUnit::Meter, wanted: &[4] }.parse().ok()
        };
        for text in ["0, -90 ,90  1e-1", "[0, -90, 90, 0.1]", "(0 -90 90 0.1)", " { 0,-90,90,.1 } "] {
            assert_eq!(read(text), Some(vec![0.0, -90.0, 90.0, 0.1]), "{text}");
        }
        for text in ["0, x", "inf", "[1, 2", "nan"] {
            assert_eq!(read(text), None, "{text}");
        }
    }

    #[test]
    fn a_plain_number_has_help() {
        assert_eq!(single_number("1e-3"), Ok(1e-3));
        for (text, part) in [("0,5", "write 0.5, with"), ("10s", "write 10, without a unit"), ("x", "not a number")] {
            assert!(single_number(text).is_err_and(|message| message.contains(part)), "{text}");
        }
    }
}
