//! Numbers as they stand in a picture.

/// At most six significant digits, with a minus of the width of a plus, without trailing zeros.
pub fn short(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 || !magnitude.is_finite() {
        return if value.is_finite() { "0".to_owned() } else { value.to_string() };
    }
    let exponent = magnitude.log10().floor();
    let text = if (-5.0..7.0).contains(&exponent) {
        let digits = (5.0 - exponent).clamp(0.0, 10.0) as usize;
        let text = format!("{magnitude:.digits$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{magnitude:.2e}")
    };
    if value < 0.0 && text != "0" { format!("\u{2212}{text}") } else { text }
}

/// Three significant digits.
pub fn rough(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}

/// The value to one decimal, without a negative zero: coordinates in the file of a picture.
pub fn coordinate(value: f64) -> String {
    let tenths = (value * 10.0).round() / 10.0;
    let text = format!("{tenths:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_file() {
        for (value, text) in [
            (0.089159, "0.089159"),
            (335.0, "335"),
            (-295.0, "\u{2212}295"),
            (0.1 + 0.2, "0.3"),
            (1e-3, "0.001"),
            (1e9, "1.00e9"),
            (-0.0, "0"),
            (180.0_f64.to_radians().to_degrees(), "180"),
        ] {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn coordinates_are_rounded() {
        assert_eq!([1.04, -0.04, 12.25, -3.0].map(coordinate), ["1", "0", "12.3", "-3"]);
    }
}
