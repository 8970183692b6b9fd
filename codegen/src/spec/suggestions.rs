//! Suggestions of the text to write instead: for a number, an angle, a list, a key or a mapping that the file does not
//! take.

use super::angle::{WrittenAngle, without_leading_zeros};
use super::yaml::Node;

/// Suggestion for a text in the place of a number.
pub fn number(text: &str) -> Option<String> {
    let text = text.trim();
    plain_spelling(text).or_else(|| with_unit(text)).or_else(|| arithmetic(text)).or_else(|| expression(text))
}

/// Suggestion for a text in the place of an angle.
pub fn angle(text: &str) -> Option<String> {
    let text = text.trim();
    let computed = || {
        has_operator(text).then(|| "write its value: an angle is not computed, but for pi/2 and the like".to_owned())
    };
    plain_spelling(text).or_else(|| with_variable(text)).or_else(|| arithmetic(text)).or_else(computed)
}

/// Suggestion for a length that is to be computed.
pub fn expression(text: &str) -> Option<String> {
    let help = "write its value, or give it a name: `parameters: {l5: 0.35}`. A name takes a sign or a factor, and \
                nothing is added to it: `-l5`, `2*l5`, `l5/2`";
    arithmetic(text).or_else(|| has_operator(text).then(|| help.to_owned()))
}

/// Returns true if a text has an operator between numbers or names.
fn has_operator(text: &str) -> bool {
    let is_operand = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '(' | ')');
    let between = |at: usize| {
        let operand = |text: Option<&str>, last: bool| {
            let text = text.unwrap_or_default().trim();
            let end = if last { text.chars().next_back() } else { text.chars().next() };
            end.is_some_and(is_operand)
        };
        operand(text.get(..at), true) && operand(text.get(at + 1..), false)
    };
    text.parse::<f64>().is_err()
        && text.char_indices().any(|(at, c)| matches!(c, '+' | '-' | '*' | '/' | '^') && between(at))
}

/// The key that another name stands for: a Greek letter, the tool's frame.
pub fn synonym(name: &str, known: &[&'static str]) -> Option<&'static str> {
    let key = match name.to_lowercase().as_str() {
        "\u{3b1}" => "alpha",
        "\u{3b8}" | "\u{3d1}" => "theta",
        "tcp" | "flange" | "ee" | "end_effector" | "endeffector" | "gripper" => "tool",
        "world" | "mount" => "base",
        _ => return None,
    };
    known.iter().copied().find(|word| *word == key)
}

/// Suggestion for a list of `found` entries in the place of a list of `wanted`: `[-60, 0,5]` as `[-60, 0.5]`.
pub fn decimal_commas(written: &str, found: usize, wanted: usize) -> Option<String> {
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let chars: Vec<char> = written.chars().collect();
    // A comma between two digits, without a space.
    let is_decimal = |at: usize| {
        chars.get(at) == Some(&',') && at > 0 && digit(chars.get(at - 1).copied()) && digit(chars.get(at + 1).copied())
    };
    let commas = (0..chars.len()).filter(|at| is_decimal(*at)).count();
    if commas == 0 || found != wanted + commas {
        return None;
    }
    let pointed: String = chars.iter().enumerate().map(|(at, c)| if is_decimal(at) { '.' } else { *c }).collect();
    Some(format!("write {pointed}, with a decimal point"))
}

/// Suggestion for a list of numbers without all of its commas in the place of `wanted` ones: `[-60 60]` as `[-60, 60]`.
pub fn commas(written: &str, wanted: usize) -> Option<String> {
    let inner = written.trim().strip_prefix('[')?.strip_suffix(']')?;
    let numbers: Vec<&str> =
        inner.split(|c: char| c == ',' || c.is_whitespace()).filter(|part| !part.is_empty()).collect();
    let reads = numbers.len() == wanted && numbers.iter().all(|number| number.parse::<f64>().is_ok());
    reads.then(|| format!("write [{}], with a comma between the numbers", numbers.join(", ")))
}

/// Suggestion for a key that other tools have.
pub fn foreign_key(name: &str, known: &[&str]) -> Option<String> {
    let row = known.contains(&"theta") && known.contains(&"alpha");
    let lower = name.to_lowercase();
    let help = match lower.as_str() {
        "offset" if row => {
            "write the offset as `theta` (of a sliding joint as `d`): the joint's own value is added to it"
        }
        "r" if row => "write the link length as `a`",
        "q" if row => "leave it out: the joint's own value is added to `theta`, of a sliding joint to `d`",
        "min" | "max" | "lower" | "upper" | "range" | "qlim" if row => "write `limits: [lowest, highest]`",
        "sigma" | "kind" | "jointtype" | "joint_type" if row => "write `type: revolute`, `prismatic` or `fixed`",
        "dh" | "links" | "rows" | "table" | "dh_parameters" if known.contains(&"joints") => {
            "write the rows of the table under `joints`"
        }
        "matrix" | "rotation" | "quaternion" if known.contains(&"rpy") => {
            "write the frame as `{xyz: [x, y, z], rpy: [roll, pitch, yaw]}`, R = Rz(yaw) Ry(pitch) Rx(roll)"
        }
        "position" | "translation" if known.contains(&"xyz") => "write it as `xyz`",
        "orientation" | "euler" if known.contains(&"rpy") => "write it as `rpy`, R = Rz(yaw) Ry(pitch) Rx(roll)",
        _ => return None,
    };
    Some(help.to_owned())
}

/// Suggestion for a key of an arm file that belongs to `inverse` or `units`: the whole line, with its value.
pub fn inner_key(name: &str, known: &[&str], value: &Node) -> Option<String> {
    let outer = match name {
        "task" | "redundant" | "require" | "axis" | "tolerance" | "weights" => "inverse",
        "length" | "angle" => "units",
        _ => return None,
    };
    let one = |node: &Node| match node {
        Node::Bool(value) => value.to_string(),
        Node::Number(value) => value.to_string(),
        Node::Text(text) => text.clone(),
        _ => "..".to_owned(),
    };
    let value = match value {
        Node::List(values) => format!("[{}]", values.iter().map(one).collect::<Vec<_>>().join(", ")),
        value => one(value),
    };
    known.contains(&outer).then(|| format!("`{name}` belongs to `{outer}`: write `{outer}: {{{name}: {value}}}`"))
}

/// Suggestion for the place of a mapping with `known` keys: for a row of a table, a matrix, a number, a unit. The
/// mapping belongs to `key`.
pub fn mapping(key: &str, written: &str, node: &Node, known: &[&str]) -> Option<String> {
    if known.contains(&"rpy") {
        return Some(
            "write the frame as `{xyz: [x, y, z], rpy: [roll, pitch, yaw]}`, R = Rz(yaw) Ry(pitch) Rx(roll)".to_owned(),
        );
    }
    // Of the rows' keys a calibration has no `type` and no `limits`.
    if known == ["a", "alpha", "d", "theta"] {
        return Some("name what is added to the row: `{a: 0.0003, alpha: -0.01}`".to_owned());
    }
    let row = "name each value: `{a: 0, alpha: 90, d: 0.4, theta: 0}`";
    let text = written.trim_matches(['"', '\'', ' ']);
    let help = match (key, node) {
        ("units", Node::Text(_)) if ["deg", "rad"].contains(&text) => {
            format!("write `units: {{length: m, angle: {text}}}`")
        }
        ("units", Node::Text(_)) if ["m", "cm", "mm", "in"].contains(&text) => {
            format!("write `units: {{length: {text}, angle: deg}}`")
        }
        ("units", _) => "write `units: {length: m, angle: deg}`".to_owned(),
        ("tolerance", Node::Number(_)) => {
            format!("write `tolerance: {{length: {written}}}`, in the file's unit; an `angle` may stand beside it")
        }
        ("tolerance", _) => "write `tolerance: {length: 0.001, angle: 0.01 deg}`, or one of them".to_owned(),
        ("inverse", _) => "write `inverse: {task: pose}`".to_owned(),
        ("actuator", _) => "write `actuator: {pulses_per_rev: 12800}`".to_owned(),
        (_, Node::List(entries)) if known.contains(&"theta") && entries.len() == 4 => {
            let inside = written.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or_default();
            let words: Vec<&str> = inside.split(',').map(str::trim).collect();
            match words[..] {
                [a, alpha, d, theta] => format!(
                    "name each value: `{{a: {a}, alpha: {alpha}, d: {d}, theta: {theta}}}` if they stand in this order"
                ),
                _ => row.to_owned(),
            }
        }
        _ if known.contains(&"theta") => row.to_owned(),
        _ => return None,
    };
    Some(help)
}

/// A sum, difference, product or quotient of two numbers: its value.
fn arithmetic(text: &str) -> Option<String> {
    let at = text.char_indices().skip(1).find(|(at, c)| {
        let before = text.get(..*at).and_then(|before| before.chars().next_back());
        matches!(c, '+' | '-' | '*' | '/') && !matches!(before, Some('e' | 'E'))
    });
    let (at, operator) = at?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
    let (a, b) = (number(text.get(..at)?)?, number(text.get(at + 1..)?)?);
    let value = match operator {
        '+' => a + b,
        '-' => a - b,
        '*' => a * b,
        _ => a / b,
    };
    // The decimals of the operands say where the rounding of the sum begins.
    let shown = format!("{value:.12}");
    let shown = shown.trim_end_matches('0').trim_end_matches('.');
    value.is_finite().then(|| format!("write {shown}: a number is not computed"))
}

/// A number in other characters than the keyboard's.
fn plain_spelling(text: &str) -> Option<String> {
    let plain = || without_leading_zeros(text).map(|plain| format!("write {plain}"));
    with_ascii_minus(text).or_else(|| with_point(text)).or_else(plain).or_else(|| with_digits(text))
}

/// A number with letters that look like its digits: `9O`, `1l`. Its first digit is one: a name may begin with such a letter.
fn with_digits(text: &str) -> Option<String> {
    let plain = text.replace(['O', 'o'], "0").replace(['l', 'I'], "1");
    let begins = text.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit());
    let reads = begins && plain != text && plain.parse::<f64>().is_ok();
    reads.then(|| format!("write {plain}: a letter stands for a digit here"))
}

/// A length with its unit.
fn with_unit(text: &str) -> Option<String> {
    let end = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E'))?;
    let (number, word) = text.split_at_checked(end)?;
    let (number, word) = (number.trim(), word.trim());
    let of_length = ["m", "cm", "mm", "in", "inch", "meter", "meters", "metre", "metres"].contains(&word);
    (of_length && number.parse::<f64>().is_ok_and(f64::is_finite)).then(|| {
        format!("write the number alone: all lengths are in the unit that `units` names, {number} if that is {word}")
    })
}

/// A joint's variable with the constant that it is added to by itself: `q2 - 90`, `90 + q2`, `theta1`.
fn with_variable(text: &str) -> Option<String> {
    let start = text.find("theta").or_else(|| text.find('\u{3b8}')).or_else(|| text.find(['q', 'Q']))?;
    let (before, joint) = text.split_at_checked(start)?;
    let end = joint.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(joint.len());
    let (_, after) = joint.split_at_checked(end)?;
    let constant: String = format!("{}{}", before.trim().trim_end_matches('+'), after).split_whitespace().collect();
    let constant = if constant.is_empty() { "0" } else { constant.trim_start_matches('+') };
    let reads = WrittenAngle::parse(constant).is_some() || constant.parse::<f64>().is_ok();
    reads.then(|| format!("write the constant alone, {constant}: the joint's own value is added to it"))
}

/// A number whose minus is a dash, as typeset tables have it.
fn with_ascii_minus(text: &str) -> Option<String> {
    let plain = text.replace(['\u{2212}', '\u{2013}', '\u{2014}', '\u{2010}', '\u{2011}'], "-");
    let reads = plain != text && (plain.parse::<f64>().is_ok() || WrittenAngle::parse(&plain).is_some());
    reads.then(|| format!("write {plain}: the minus here is a typeset dash, not the one of the keyboard"))
}

/// `80,5` as `80.5`.
fn with_point(text: &str) -> Option<String> {
    let (whole, part) = text.split_once(',')?;
    let digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    let sign = whole.strip_prefix(['-', '+']).unwrap_or(whole);
    (digits(sign) && digits(part)).then(|| format!("write {whole}.{part}, with a decimal point"))
}

#[cfg(test)]
mod tests {
    use super::super::yaml::Node;
    use super::{angle, decimal_commas, foreign_key, mapping, number, synonym};

    #[test]
    fn the_number_that_is_meant() {
        assert_eq!(number("-80,5").as_deref(), Some("write -80.5, with a decimal point"));
        assert!(number("365 mm").is_some_and(|help| help.contains("365 if that is mm")));
        assert!(number("\u{2212}445").is_some_and(|help| help.starts_with("write -445:")));
        assert_eq!(number("010").as_deref(), Some("write 10"));
        assert_eq!(angle("-007.5").as_deref(), Some("write -7.5"));
        for text in ["long", "1,2,3", "3 parsec", "", "0", "0.5", "00x"] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn sums_are_computed_for_the_reader() {
        for (text, value) in
            [("0.1+0.3", "0.4"), ("0.4 - 0.1", "0.3"), ("2*3", "6"), ("1/4", "0.25"), ("1e-3+1", "1.001")]
        {
            assert_eq!(number(text), Some(format!("write {value}: a number is not computed")), "{text}");
        }
        assert_eq!(angle("90+45").as_deref(), Some("write 135: a number is not computed"));
        for text in ["1/0", "a+b", "l2 + 5", "2*3 + 1", "(1 + 2)*3"] {
            assert!(number(text).is_some_and(|help| help.starts_with("write its value, or give it a name")), "{text}");
        }
        for text in ["-5", "1e-5", "upper-", "- 5"] {
            assert_eq!(number(text), None, "{text}");
        }
        for text in ["90 + 3*2", "2*q1"] {
            assert!(angle(text).is_some_and(|help| help.starts_with("write its value: an angle")), "{text}");
        }
    }

    #[test]
    fn decimal_commas_in_lists_are_points() {
        let point = |text: &str| Some(format!("write {text}, with a decimal point"));
        assert_eq!(decimal_commas("[-60, 0,5]", 3, 2), point("[-60, 0.5]"));
        assert_eq!(decimal_commas("[-1,5, 0,5]", 4, 2), point("[-1.5, 0.5]"));
        assert_eq!(decimal_commas("[1,2]", 2, 2), None);
        assert_eq!(decimal_commas("[1, 2, 3]", 3, 2), None);
    }

    #[test]
    fn keys_and_forms_of_other_tools() {
        let row = ["type", "name", "a", "alpha", "d", "theta", "limits", "actuator"];
        assert!(foreign_key("offset", &row).is_some_and(|help| help.contains("`theta`")));
        assert!(foreign_key("offset", &["matrix"]).is_none());
        assert!(foreign_key("matrix", &["xyz", "rpy"]).is_some_and(|help| help.contains("rpy: [roll")));
        let list = |n: usize| Node::List(vec![Node::Number(0.0); n]);
        let help = mapping("row 1", "[0, 90, 0.4, 0]", &list(4), &row);
        assert!(help.is_some_and(|help| help.contains("`{a: 0, alpha: 90, d: 0.4, theta: 0}`")));
        assert!(mapping("row 1", "[0, 1]", &list(2), &row).is_some_and(|help| help.starts_with("name each value")));
        let units = mapping("units", "mm", &Node::Text("mm".into()), &["length", "angle"]);
        assert_eq!(units.as_deref(), Some("write `units: {length: mm, angle: deg}`"));
        assert_eq!(synonym("\u{3b1}", &["a", "alpha"]), Some("alpha"));
        assert_eq!(synonym("tcp", &["xyz", "rpy"]), None);
        assert!(
            mapping("tool", "[[1]]", &list(4), &["xyz", "rpy"]).is_some_and(|help| help.contains("xyz: [x, y, z]"))
        );
    }

    #[test]
    fn the_constant_that_is_meant() {
        for (text, constant) in [
            ("q2 - 90", "-90"),
            ("90 + q2", "90"),
            ("q2+pi/2", "pi/2"),
            ("q1", "0"),
            ("theta1", "0"),
            ("theta2 - 90", "-90"),
            ("q_2 - 90 deg", "-90deg"),
        ] {
            let help = angle(text);
            assert!(
                help.as_ref().is_some_and(|help| help.contains(&format!("alone, {constant}:"))),
                "{text}: {help:?}"
            );
        }
        for text in ["pie", "-q1", "quarter turn"] {
            assert_eq!(angle(text), None, "{text}");
        }
    }
}
