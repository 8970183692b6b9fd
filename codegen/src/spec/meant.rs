//! What people write for a number or an angle where the file takes only the number.

use super::angle::WrittenAngle;

/// What to write for a text in the place of a number.
pub fn number(text: &str) -> Option<String> {
    let text = text.trim();
    typed(text).or_else(|| with_unit(text))
}

/// What to write for a text in the place of an angle.
pub fn angle(text: &str) -> Option<String> {
    let text = text.trim();
    typed(text).or_else(|| with_variable(text))
}

/// A number in other characters than the keyboard's.
fn typed(text: &str) -> Option<String> {
    with_ascii_minus(text).or_else(|| with_point(text))
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

/// A joint's variable with the constant that it is added to by itself: `q2 - 90`, `90 + q2`, `q2`.
fn with_variable(text: &str) -> Option<String> {
    let start = text.find(['q', 'Q'])?;
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
    use super::{angle, number};

    #[test]
    fn the_number_that_is_meant() {
        assert_eq!(number("-80,5").as_deref(), Some("write -80.5, with a decimal point"));
        assert!(number("365 mm").is_some_and(|help| help.contains("365 if that is mm")));
        assert!(number("\u{2212}445").is_some_and(|help| help.starts_with("write -445:")));
        for text in ["long", "l2 + 3", "1,2,3", "3 parsec", ""] {
            assert_eq!(number(text), None, "{text}");
        }
    }

    #[test]
    fn the_constant_that_is_meant() {
        for (text, constant) in
            [("q2 - 90", "-90"), ("90 + q2", "90"), ("q2+pi/2", "pi/2"), ("q1", "0"), ("q_2 - 90 deg", "-90deg")]
        {
            let help = angle(text);
            assert!(
                help.as_ref().is_some_and(|help| help.contains(&format!("alone, {constant}:"))),
                "{text}: {help:?}"
            );
        }
        for text in ["pie", "2*q1", "-q1", "quarter turn"] {
            assert_eq!(angle(text), None, "{text}");
        }
    }
}
