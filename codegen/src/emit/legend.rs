//! The legend at the head of a written file: comments that explain the names in generated code.

use std::collections::BTreeSet;

/// Patterns of names, and what they stand for. In a pattern `#` stands for joints (`23`, `2m3`), `?` for x, y or z, and `*`
/// for anything.
type Entry = (&'static [&'static str], &'static str);

const ENTRIES: [Entry; 19] = [
    (
        &["s#", "c#"],
        "s2, c2: sine and cosine of q2, the table's quarter turns taken out; s23: of q2 + q3; s2m3: of q2 - q3",
    ),
    (
        &["n_#?", "o_#?", "a_#?"],
        "n_4x, o_4x, a_4x: x of the tool's axes (normal, orientation, approach) in the axes of frame 4",
    ),
    (
        &["p_#?"],
        "p_4x: x of the tool point from the origin of frame 4, in its axes; in `link_poses` of the origin of link 4",
    ),
    (
        &["v#_#?", "z#_#?"],
        "v5_3x, z5_3x: x of joint 5's column of the Jacobian, linear and angular, in the axes of frame 3",
    ),
    (&["r#_#?"], "r5_3x: x of the vector from axis 5 to the tool point, in the axes of frame 3"),
    (
        &["x_#?", "y_#?", "z_#?"],
        "x_4y: in `link_poses` y of the x axis of link 4 in the base frame, before the twist of its row",
    ),
    (&["w_#?"], "w_4x: x of a point between the origins of links 3 and 4 in the base frame"),
    (&["t*_#?"], "tn_4x: a `t` before a name: the same vector on the other side of the twist of link 4"),
    (
        &["t#"],
        "t3: the angle in the equation of joint 3 where q3 differs from it by a constant; t234: the sum of three",
    ),
    (&["rho#"], "rho3: the distance that joint 3 has to bring about"),
    (&["flange_?", "f#"], "flange_x, f13: position and rotation of the last link: the target without the tool"),
    (&["wrist_?"], "wrist_x: x of the point where the axes of the wrist meet, or of its first axis"),
    (&["over_?"], "over_x: x of the vector that the target asks for"),
    (&["reach_?"], "reach_x: x of the vector that has to be turned there"),
    (&["h#_?"], "h1_x: x of the direction of the parallel axes, seen over joint 1"),
    (&["roots#"], "roots3, state3: the roots of the equation of joint 3, and what is known of a branch after it"),
    (&["far"], "of(D6): a number in every lane; far: the lanes whose angles are too large for the sines over lanes"),
    (&["go_on"], "branches.go_on(state3): true if a lane of the state is not in doubt"),
    (&["minus_*", "*_part"], "minus_s23: -s23; p_1x_part: a partial sum of p_1x"),
];

/// The legend for the names that occur in some code, one comment a line, and an empty line.
pub fn legend(code: &str) -> String {
    let lines = code.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let names: BTreeSet<&str> =
        lines.flat_map(|line| line.split(|c: char| !(c.is_alphanumeric() || c == '_'))).collect();
    let occurs = |patterns: &[&str]| names.iter().any(|name| patterns.iter().any(|pattern| matches(pattern, name)));
    let entries = ENTRIES.iter().filter(|(patterns, _)| occurs(patterns));
    let lines: String = entries.map(|(_, meaning)| format!("// - {meaning}\n")).collect();
    let head = if lines.is_empty() { "" } else { "// Names:\n" };
    format!("{head}{lines}\n")
}

/// True if a name is of a pattern.
fn matches(pattern: &str, name: &str) -> bool {
    let Some(first) = pattern.chars().next() else { return name.is_empty() };
    let rest = pattern.get(first.len_utf8()..).unwrap_or_default();
    let ends = |of: &dyn Fn(char) -> bool| {
        let length = name.chars().take_while(|c| of(*c)).map(char::len_utf8).sum();
        (1..=length).any(|end| name.get(end..).is_some_and(|left| matches(rest, left)))
    };
    match first {
        '#' => name.starts_with(|c: char| c.is_ascii_digit()) && ends(&|c| c.is_ascii_digit() || c == 'm'),
        '?' => name.starts_with(['x', 'y', 'z']) && name.get(1..).is_some_and(|left| matches(rest, left)),
        '*' => ends(&|_| true),
        _ => name.strip_prefix(first).is_some_and(|left| matches(rest, left)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_of_their_patterns() {
        for (pattern, name) in
            [("s#", "s2m3"), ("v#_#?", "v5_1x"), ("t*_#?", "tv5_1z"), ("*_part", "p_1x_part"), ("t#", "t234")]
        {
            assert!(matches(pattern, name), "{name}");
        }
        for (pattern, name) in [("s#", "search"), ("s#", "sm3"), ("p_#?", "p_1xy"), ("t*_#?", "t_1x"), ("t#", "target")]
        {
            assert!(!matches(pattern, name), "{name}");
        }
    }

    #[test]
    fn only_names_that_occur_are_explained() {
        let legend = legend("// p_1x\nlet s23 = 1.0;");
        assert!(legend.contains("s2m3") && !legend.contains("p_4x"), "{legend}");
        assert_eq!(super::legend("let x = 1.0;"), "\n");
    }
}
