//! Every mistake of form: its place and the words that matter.

#![allow(clippy::unwrap_used, clippy::panic)]

use super::*;

/// An arm of one row in line 5, with more lines from line 6 on.
fn arm(row: &str, more: &str) -> String {
    format!("name: arm\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n  - {row}\n{more}")
}

const ROW: &str = "{a: 1, alpha: 0, d: 0, theta: 0}";

fn mistakes(text: &str) -> Vec<String> {
    match read(text, "f") {
        Ok((spec, _)) => spec.mistakes.iter().map(ToString::to_string).collect(),
        Err(errors) => errors.iter().map(ToString::to_string).collect(),
    }
}

fn warnings(text: &str) -> Vec<String> {
    let (spec, warnings) = read(text, "f").unwrap();
    assert_eq!(spec.mistakes, []);
    warnings.iter().map(ToString::to_string).collect()
}

/// Exactly one mistake, at `place`, with all the words.
#[track_caller]
fn only(found: &[String], place: &str, words: &[&str]) {
    let [mistake] = found else { panic!("expected one, found {found:#?}") };
    assert!(mistake.starts_with(&format!("f:{place}: ")), "{mistake}");
    for word in words {
        assert!(mistake.contains(word), "`{word}` is not in\n{mistake}");
    }
}

#[track_caller]
fn row_mistake(row: &str, place: &str, words: &[&str]) {
    only(&mistakes(&arm(row, "")), place, words);
}

#[track_caller]
fn more_mistake(more: &str, place: &str, words: &[&str]) {
    only(&mistakes(&arm(ROW, more)), place, words);
}

#[test]
fn a_whole_arm_is_read() {
    let row = "{name: slide, type: prismatic, a: 1, alpha: pi/2, d: 2.5, theta: -90 deg, limits: [null, 3]}";
    let more = "base: {xyz: [1, 2, 3]}\ntool: {rpy: [0, 0, 1 rad]}\n\
                inverse: {task: position, require: true, redundant: slide, tolerance: {length: 1e-3, angle: 0.1}}\n";
    let (spec, warnings) = read(&arm(row, more), "f").unwrap();
    assert_eq!((spec.mistakes.as_slice(), warnings.as_slice()), (&[][..], &[][..]));
    let row = spec.rows.first().unwrap();
    assert_eq!((row.kind, &row.a, &row.d), (RowKind::Prismatic, &Length::Constant(1.0), &Length::Constant(2.5)));
    assert_eq!((row.alpha, row.theta), (WrittenAngle::PiFraction(1, 2), WrittenAngle::Degrees(-90.0)));
    assert!(matches!(row.limits, Some((LimitsSpec::Lengths([None, Some(3.0)]), _))));
    assert_eq!((spec.base.xyz, spec.tool.rpy[2]), ([1.0, 2.0, 3.0].map(Length::Constant), WrittenAngle::Radians(1.0)));
    let inverse = spec.inverse;
    assert_eq!((inverse.task, inverse.require, inverse.axis), (Some(Task::Position), true, None));
    assert_eq!(inverse.tolerance_length, Some(1e-3));
    assert_eq!(inverse.tolerance_angle, Some(WrittenAngle::Degrees(0.1)));
}

#[test]
fn text_that_is_no_arm() {
    only(&mistakes(""), "1:1", &["the file is empty", "convention: standard"]);
    only(&mistakes("# only a comment\n\n"), "1:1", &["the file is empty"]);
    only(&mistakes("- 1\n"), "1:1", &["a mapping of keys and values"]);
    only(&mistakes("name: x\njoints:\n\t- 1\n"), "3:1", &["not YAML", "spaces"]);
    only(&mistakes("joints:\n  - {a: 1\n  - {a: 2}\n"), "3:5", &["not YAML", "expected ',' or '}'"]);
    only(&mistakes(&arm(ROW, "---\nname: y\n")), "6:1", &["a second document", "one document"]);
}

#[test]
fn keys() {
    row_mistake(
        "{a: 0, alfa: 90, d: 0, theta: 0}",
        "5:12",
        &["unknown key `alfa` in a joint row", "did you mean `alpha`?"],
    );
    row_mistake(
        "{a: 0, alpha: 9, d: 0, theta: 0, x: 1}",
        "5:38",
        &["unknown key `x`", "a joint row has type, name, a"],
    );
    row_mistake(
        "{a: 0, alpha: 9, d 0.4, theta: 0}",
        "5:22",
        &["unknown key `d 0.4`", "write `d: 0.4`, with a colon after"],
    );
    row_mistake("{a: 0, alpha: 9, d:0.4, theta: 0}", "5:22", &["unknown key `d:0.4`", "write `d: 0.4`"]);
    row_mistake("{a: 0, alpha: 9, d: 0, a: 1, theta: 0}", "5:28", &["`a` occurs twice", "line 5"]);
    row_mistake("{a: 0, alpha: 9, d: 0, theta: 0, 7: 1}", "5:38", &["expected a key", "the number 7"]);
    row_mistake("{a: 0}", "5:5", &["row 1 of `joints` has no `alpha`, `d`, `theta`", "write 0"]);
    more_mistake("colour: red\n", "6:1", &["unknown key `colour` in an arm file"]);
    more_mistake("name: again\n", "6:1", &["`name` occurs twice", "line 1"]);
    more_mistake("redundant: q3\n", "6:1", &["unknown key `redundant`", "write `inverse: {redundant: q3}`"]);
    more_mistake("redundant: [q1, q4]\n", "6:1", &["write `inverse: {redundant: [q1, q4]}`"]);
    more_mistake("angle: rad\n", "6:1", &["write `units: {angle: rad}`"]);
    more_mistake("tool: {xzy: [0, 0, 0]}\n", "6:8", &["unknown key `xzy` in `tool`", "did you mean `xyz`?"]);
    more_mistake("inverse: {taks: pose}\n", "6:11", &["unknown key `taks`", "did you mean `task`?"]);
}

#[test]
fn parameters() {
    let row = "{a: l2, alpha: 0, d: -l2/2, theta: 0}";
    let text = arm(row, "parameters: {l2: 3, l3: 0}\ntool: {xyz: [0, 2*l3, 1]}\n");
    let (spec, warnings) = read(&text, "f").unwrap();
    assert_eq!((spec.mistakes.as_slice(), warnings.as_slice()), (&[][..], &[][..]));
    let multiple = |factor, name: &str, default| Length::Multiple { factor, parameter: name.into(), default };
    let row = spec.rows.first().unwrap();
    assert_eq!((&row.a, &row.d), (&multiple(1.0, "l2", 3.0), &multiple(-0.5, "l2", -1.5)));
    assert_eq!(spec.tool.xyz, [Length::ZERO, multiple(2.0, "l3", 0.0), Length::Constant(1.0)]);
    let names: Vec<_> = spec.parameters.iter().map(|p| (p.name.as_str(), p.default)).collect();
    assert_eq!(names, [("l2", 3.0), ("l3", 0.0)]);
    let unused = warnings_of_more("parameters: {l2: 1}\n");
    only(&unused, "6:14", &["warning: the parameter `l2` is not used", "write its name for an `a`"]);
}

#[test]
fn a_unit_is_no_slip_of_another() {
    let of = |units: &str| mistakes(&arm(ROW, "").replace("{length: m, angle: deg}", units));
    for units in ["{length: km, angle: deg}", "{length: m, angle: grad}"] {
        let found = of(units).join("\n");
        assert!(found.contains("expected one of") && !found.contains("did you mean"), "{found}");
    }
    assert!(of("{length: MM, angle: degrees}").join("\n").contains("did you mean `mm`?"));
}

#[test]
fn mistakes_of_parameters() {
    let more = |row: &str, parameters: &str| mistakes(&arm(row, &format!("parameters: {parameters}\n")));
    let of_a = |a: &str| more(&format!("{{a: {a}, alpha: 0, d: 0, theta: 0}}"), "{l2: 1, l3: 2}");
    only(&of_a("l4"), "5:9", &["`a`: no parameter is named `l4`", "did you mean `l2`? the parameters are l2, l3"]);
    only(&of_a("elbow"), "5:9", &["no parameter is named `elbow`", "help: the parameters are l2, l3"]);
    only(&of_a("l2 + l3"), "5:9", &["`a`: expected a number, or one parameter with a sign or a numeric factor"]);
    only(&of_a("l2*l3"), "5:9", &["or one parameter: products of two are no length", "found `l2*l3`"]);
    only(&of_a("1/l2"), "5:9", &["or a parameter that is not divided by"]);
    only(&of_a("0*l2"), "5:9", &["or a factor that is finite and not zero"]);
    only(&of_a("'010'"), "5:9", &["found `010`", "write 10"]);
    let row = "{a: l2, alpha: 0, d: 0, theta: 0}";
    row_mistake(row, "5:9", &["`a`: expected a number", "found `l2`", "add `parameters: {l2: 0.5}` to the file"]);
    only(&more(row, "[l2]"), "6:13", &["`parameters`: expected a mapping of names and lengths, found a list"]);
    only(&more(row, "{l2: .inf}"), "6:18", &["`l2`: expected a finite number"]);
    only(&more(row, "{l2: long}"), "6:18", &["`l2`: expected a number in the file's length unit, found `long`"]);
    only(&more(row, "{l2: }"), "6:14", &["`l2`: expected a number", "found nothing"]);
    only(&more(row, "{l2: 1, l2: 2}"), "6:21", &["the parameter `l2` occurs twice", "in line 6"]);
    for (name, place) in [("2l", "6:21"), ("type", "6:21"), ("a-b", "6:21"), ("self", "6:21"), ("3", "6:21")] {
        let found = more(row, &format!("{{l2: 1, {name}: 1}}"));
        only(&found, place, &[&format!("`{name}` cannot be the name of a parameter"), "a field of a struct"]);
    }
    // Parameters are lengths.
    only(&more("{a: l2, alpha: l2, d: 0, theta: 0}", "{l2: 1}"), "5:20", &["`alpha`: expected an angle"]);
}

fn warnings_of_more(more: &str) -> Vec<String> {
    warnings(&arm(ROW, more))
}

#[test]
fn actuators() {
    let row = |actuator: &str| format!("{{a: 0, alpha: 0, d: 0, theta: 0, actuator: {actuator}}}");
    let slide = |actuator: &str| row(actuator).replace("{a", "{type: prismatic, a");
    row_mistake(&row("{home: 0}"), "5:48", &["`actuator` has no `pulses_per_rev`", "a whole turn"]);
    row_mistake(&slide("{pulses_per_rev: 9}"), "5:82", &["`pulses_per_rev` of a prismatic joint", "screw's lead"]);
    row_mistake(&row("{pulses_per_unit: 9}"), "5:66", &["`pulses_per_unit` of a revolute joint"]);
    row_mistake(&row("{pulses_per_rev: 0}"), "5:65", &["greater than zero", "`direction: -1`"]);
    row_mistake(&row("{pulses_per_rev: .inf}"), "5:65", &["a factor, a finite number"]);
    row_mistake(&row("{pulses_per_rev: 9, direction: 2}"), "5:79", &["expected 1 or -1"]);
    row_mistake(&row("{pulses_per_rev: 9, direction: left}"), "5:79", &["a finite number, found `left`"]);
    row_mistake(&row("{pulses_per_rev: 9, gear_ratio: -5}"), "5:80", &["greater than zero"]);
    row_mistake(&slide("{pulses_per_unit: 9, gear_ratio: 5}"), "5:98", &["`gear_ratio` of a prismatic joint"]);
    row_mistake(&slide("{pulses_per_unit: 9, home: 90 deg}"), "5:92", &["`home`: expected a number"]);
    row_mistake(&row("12800"), "5:48", &["a mapping with pulses_per_rev"]);
    row_mistake(&row("{pulses: 12800}"), "5:49", &["unknown key `pulses`", "pulses_per_rev"]);
    let fixed = row("{pulses_per_rev: 9}").replace("{a", "{type: fixed, a");
    row_mistake(&fixed, "5:61", &["`actuator` on a fixed row"]);

    let text = arm(&row("{pulses_per_rev: 200, gear_ratio: 50, home: pi/2, direction: -1}"), "");
    let (spec, _) = read(&text, "f").unwrap();
    assert_eq!(spec.mistakes, []);
    let actuator = spec.rows.first().and_then(|row| row.actuator.as_ref()).unwrap();
    assert_eq!((actuator.pulses, actuator.reversed), (10000.0, true));
    assert_eq!(actuator.home, HomeSpec::Angle(WrittenAngle::PiFraction(1, 2)));
}

#[test]
fn couplings_and_sums() {
    more_mistake("coupling: 5\n", "6:11", &["`coupling`: expected a mapping from joints", "{q2: 1, q3: 1}"]);
    more_mistake("coupling: {}\n", "6:11", &["`coupling` is empty", "matrix"]);
    more_mistake("coupling: {3: {q2: 1}}\n", "6:12", &["a joint's name in `coupling`", "did you mean `q3`?"]);
    more_mistake("coupling: {q1: 2}\n", "6:16", &["`q1`: expected a mapping from joints", "`q1: {q1: 1}`"]);
    more_mistake("coupling: {q1: {q1: 1}, q1: {q1: 2}}\n", "6:25", &["`q1` occurs twice"]);
    more_mistake("coupling: {q1: {q1: 1, q1: 2}}\n", "6:24", &["`q1` occurs twice in the motor of `q1`"]);
    more_mistake("coupling: {q1: {q1: x}}\n", "6:21", &["a factor, a number", "found `x`", "20 per rev"]);
    more_mistake("coupling: {q1: {q1: .nan}}\n", "6:21", &["a finite number"]);
    more_mistake("coupling: {q1: {q1: 1, offset: no}}\n", "6:32", &["`offset`: expected an angle"]);
    more_mistake("coupling: {offset: [1]}\n", "6:11", &["`coupling` has no `matrix`"]);
    more_mistake("coupling: {matrix: 1}\n", "6:20", &["`matrix`: expected a matrix, a list of rows"]);
    more_mistake("coupling: {matrix: [1]}\n", "6:21", &["a row of the matrix"]);
    more_mistake("coupling: {matrix: [[1]], offset: 1}\n", "6:35", &["`offset`: expected a list of offsets"]);
    more_mistake("coupling: {matrix: [[1]], offset: [1, 2]}\n", "6:35", &["expected 1 offsets", "found 2"]);
    more_mistake("coupling: {matrix: [[1]], ofset: [1]}\n", "6:27", &["did you mean `offset`?"]);
    more_mistake("combined_limits: {sum: [q1]}\n", "6:18", &["a list of sums with their limits"]);
    more_mistake("combined_limits: [{sum: [q1]}]\n", "6:19", &["entry 1` has no `limits`"]);
    more_mistake("combined_limits: [{limits: [0, 1]}]\n", "6:19", &["entry 1` has no `sum`"]);
    more_mistake("combined_limits: [{sum: {q1: a}, limits: [0, 1]}]\n", "6:30", &["a factor, a finite number"]);
    more_mistake("combined_limits: [{sum: [1], limits: [0, 1]}]\n", "6:26", &["expected a joint's name"]);
    more_mistake("combined_limits: [{sum: [q1], limits: [0]}]\n", "6:39", &["[lowest, highest]", "1 entry"]);
    more_mistake("combined_limits: [{sum: [q1], limits: [0, x]}]\n", "6:43", &["expected an angle"]);
}

#[test]
fn wrong_types() {
    row_mistake(
        "42",
        "5:5",
        &["`row 1`: expected a joint row, found the number 42", "{a: 0, alpha: 90, d: 0.4, theta: 0}"],
    );
    row_mistake("{a: [1], alpha: 0, d: 0, theta: 0}", "5:9", &["`a`: expected a number", "found a list"]);
    row_mistake("{a: \"0.4 m\", alpha: 0, d: 0, theta: 0}", "5:9", &["found `0.4 m`", "write the number alone"]);
    row_mistake("{a: , alpha: 0, d: 0, theta: 0}", "5:6", &["`a`: expected a number", "found nothing"]);
    row_mistake("{a: !len 1, alpha: 0, d: 0, theta: 0}", "5:9", &["the tag `len`"]);
    row_mistake("{a: 0, alpha: true, d: 0, theta: 0}", "5:19", &["`alpha`: expected an angle", "found `true`"]);
    row_mistake("{a: 0, alpha: '090', d: 0, theta: 0}", "5:19", &["found `090`", "write 90"]);
    row_mistake("{a: 0, alpha: -9O, d: 0, theta: 0}", "5:19", &["found `-9O`", "write -90: a letter"]);
    row_mistake("{a: 1l.5, alpha: 0, d: 0, theta: 0}", "5:9", &["found `1l.5`", "write 11.5: a letter"]);
    row_mistake("{a: 0, alpha: pie, d: 0, theta: 0}", "5:19", &["`alpha`: expected an angle", "pi/2", "found `pie`"]);
    row_mistake("{name: 3, a: 0, alpha: 0, d: 0, theta: 0}", "5:12", &["expected a name", "in quotes", "\"3\""]);
    row_mistake("{name: '', a: 0, alpha: 0, d: 0, theta: 0}", "5:12", &["expected a name", "an empty text"]);
}

#[test]
fn limits_without_brackets_get_them() {
    let told = mistakes(&arm("{a: 0, alpha: 0, d: 0, theta: 0, limits: -165, 165}", ""));
    let helps: Vec<String> = told.iter().map(ToString::to_string).collect();
    assert!(helps.iter().any(|told| told.contains("write limits: [-165, 165]")), "{helps:?}");
    assert!(!helps.iter().any(|told| told.contains("decimal point")), "{helps:?}");
}

#[test]
fn a_number_in_quotes_is_that_number() {
    let plain = "name: arm
convention: standard
units: {length: m, angle: deg}
parameters: {l2: 0.4}
base: {xyz: [0.1, 0, -2e-1], rpy: [0, 90, 0]}
tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}
inverse: {task: position, tolerance: {length: 1e-3, angle: 0.1}, weights: {q1: 2, q2: 0.5}}
joints:
  - {a: 0, alpha: 90, d: 0.3, theta: 0, limits: [-90, 120.5], actuator: {pulses_per_rev: 200, gear_ratio: 50, home: 10, direction: -1}}
  - {a: l2, alpha: 0, d: 0, theta: -30, actuator: {pulses_per_rev: 200}}
  - {type: prismatic, a: 0, alpha: -90, d: +.25, theta: 0, limits: [0, null], actuator: {pulses_per_unit: 80, home: 0.1}}
coupling: {matrix: [[1, 0, 0], [0.5, 1, 0], [0, 0, 1]], offset: [0, 15, 0]}
combined_limits: [{sum: {q1: 1, q2: -0.5}, limits: [-100, 100]}]
";
    let is_number = |word: &str| word.parse::<f64>().is_ok_and(f64::is_finite);
    let cut: Vec<&str> = plain.split_inclusive([' ', '[', ',', ']', '}']).collect();
    let quoted: String = cut
        .iter()
        .map(|piece| {
            let word = piece.trim_end_matches([' ', '[', ',', ']', '}']);
            let rest = piece.strip_prefix(word).unwrap();
            if is_number(word) { format!("\"{word}\"{rest}") } else { (*piece).to_owned() }
        })
        .collect();
    assert_eq!(
        quoted.matches('"').count(),
        2 * cut.iter().filter(|piece| is_number(piece.trim_end_matches([' ', '[', ',', ']', '}']))).count()
    );
    let options = crate::Options::new("Arm");
    let [plain, quoted] = [plain, &quoted].map(|text| crate::generate(text, "f", &options).unwrap());
    assert_eq!(quoted.impls.to_string(), plain.impls.to_string());
    assert_eq!(quoted.warnings.len(), plain.warnings.len());
    // A unit, a range and the signs of another unit are judged alike.
    row_mistake(
        "{a: 0, alpha: '1.5708', d: 0, theta: 0}",
        "5:19",
        &["looks like radians", "write 90, or \"1.5708 rad\""],
    );
    row_mistake("{a: '1e70', alpha: 0, d: 0, theta: 0}", "5:9", &["a length not beyond 1e60"]);
    row_mistake("{a: 'inf', alpha: 0, d: 0, theta: 0}", "5:9", &["a finite number"]);
    row_mistake("{a: 0, alpha: '', d: 0, theta: 0}", "5:19", &["an empty text"]);
    more_mistake("inverse: {weights: {q1: '-1'}}\n", "6:25", &["not negative"]);
}

#[test]
fn numbers_that_are_not_finite() {
    row_mistake("{a: .nan, alpha: 0, d: 0, theta: 0}", "5:9", &["`a`: expected a finite number", ".nan"]);
    row_mistake("{a: 0, alpha: -.inf, d: 0, theta: 0}", "5:19", &["`alpha`: expected a finite angle", "-.inf"]);
    more_mistake("tool: {xyz: [0, 0, .inf]}\n", "6:20", &["`xyz`: expected a finite number"]);
}

#[test]
fn words_from_a_list() {
    let words = ["expected one of revolute, prismatic, fixed", "found `linear`", "did you mean `prismatic`?"];
    row_mistake("{type: linear, a: 0, alpha: 0, d: 0, theta: 0, limits: [a]}", "5:12", &words);
    let text = |line: &str, with: &str| arm(ROW, "").replace(line, with);
    only(&mistakes(&text("standard", "craig")), "2:13", &["standard, modified", "did you mean `modified`?"]);
    only(&mistakes(&text("length: m", "length: miles")), "3:17", &["m, cm, mm, in", "found `miles`"]);
    only(&mistakes(&text("angle: deg", "angle: degrees")), "3:27", &["deg, rad", "did you mean `deg`?"]);
    only(&mistakes(&text("convention: standard\n", "")), "1:1", &["no `convention`", "standard", "(Craig)"]);
    more_mistake("inverse: {task: poze}\n", "6:17", &["position_angle", "did you mean `pose`?"]);
    more_mistake("inverse: {axis: w}\n", "6:17", &["x, y, z"]);
}

#[test]
fn joints_that_are_no_table() {
    let text = |joints: &str| format!("convention: standard\nunits: {{length: m, angle: deg}}\n{joints}");
    only(&mistakes(&text("")), "1:1", &["no `joints`"]);
    only(&mistakes(&text("joints: []\n")), "3:9", &["`joints` is empty"]);
    only(&mistakes(&text("joints:\n")), "3:1", &["`joints` is empty"]);
    only(&mistakes(&text("joints: 6\n")), "3:9", &["expected a list of rows", "the number 6"]);
    only(&mistakes(&text("joint: []\n")), "3:1", &["did you mean `joints`?"]);
}

#[test]
fn limits() {
    let row = |limits: &str| format!("{{a: 0, alpha: 0, d: 0, theta: 0, limits: {limits}}}");
    row_mistake(&row("[1, 2, 3]"), "5:46", &["null or [lowest, highest]", "a list of 3 entries"]);
    row_mistake(&row("5"), "5:46", &["null or [lowest, highest]", "the number 5"]);
    row_mistake(&row("[-170 170]"), "5:46", &["a list of 1 entry", "write [-170, 170], with a comma"]);
    row_mistake(&row("[1, x]"), "5:50", &["`limits`: expected an angle"]);
    let fixed = row("[1, 2]").replace("{a", "{type: fixed, a");
    row_mistake(&fixed, "5:59", &["`limits` on a fixed row", "remove `limits`"]);
    let prismatic = row("[1, 90 deg]").replace("{a", "{type: prismatic, a");
    row_mistake(&prismatic, "5:67", &["`limits`: expected a number in the file's length unit"]);
    assert_eq!(mistakes(&arm(&row("null"), "")), [""; 0]);
}

#[test]
fn frames_and_requests() {
    more_mistake("tool: {xyz: [0, 1]}\n", "6:13", &["`xyz`: expected three lengths", "a list of 2 entries"]);
    more_mistake("tool: {xyz: [0 1, 2]}\n", "6:13", &["a list of 2 entries", "write [0, 1, 2], with a comma"]);
    more_mistake("base: {rpy: 5}\n", "6:13", &["`rpy`: expected three angles"]);
    more_mistake("base: [1, 2, 3]\n", "6:7", &["expected a mapping with xyz, rpy"]);
    more_mistake("inverse: pose\n", "6:10", &["write `inverse: {task: pose}`"]);
    more_mistake("inverse: {redundant: 3}\n", "6:22", &["did you mean `q3`?"]);
    more_mistake("inverse: {redundant: [q1, 3]}\n", "6:27", &["did you mean `q3`?"]);
    more_mistake("inverse: {redundant: []}\n", "6:22", &["expected joints' names", "such as `redundant: q3`"]);
    more_mistake("inverse: {redundant: [[q1]]}\n", "6:23", &["expected a joint's name"]);
    more_mistake("inverse: {require: maybe}\n", "6:20", &["true or false"]);
    more_mistake("inverse: {tolerance: {length: 0}}\n", "6:31", &["greater than zero"]);
    more_mistake("inverse: {tolerance: {angle: -pi}}\n", "6:30", &["greater than zero"]);
    let warned = warnings(&arm(ROW, "inverse: {task: pose, axis: z}\n"));
    only(&warned, "6:29", &["warning: ", "`axis` has no effect"]);
}

#[test]
fn angles_in_the_wrong_unit() {
    let row = |angles: &str| format!("{{a: 0, d: 0, {angles}}}");
    row_mistake(&row("alpha: 1.5708, theta: 0"), "5:25", &["looks like radians", "write 90", "\"1.5708 rad\""]);
    row_mistake(&row("alpha: -0.7854, theta: 0"), "5:25", &["looks like radians", "write -45"]);
    only(&warnings(&arm(&row("alpha: 0, theta: 3.1416"), "")), "5:35", &["warning", "write 180"]);
    let radians = |angles: &str| arm(&row(angles), "").replace("angle: deg", "angle: rad");
    only(&mistakes(&radians("alpha: 90, theta: 0")), "5:25", &["more than two turns", "`angle: deg`", "`90 deg`"]);
    only(&mistakes(&radians("alpha: 0, theta: -180")), "5:35", &["`theta`", "more than two turns"]);
    let limits = radians("alpha: 0, theta: 0, limits: [-2, 170]");
    only(&warnings(&limits), "5:51", &["warning", "170 rad is more than two turns"]);
    assert_eq!(mistakes(&radians("alpha: 90 deg, theta: 12.5")), [""; 0]);
    // One degree is a twist that exists.
    assert_eq!(mistakes(&arm(&row("alpha: 1, theta: 0"), "")), [""; 0]);
}

#[test]
fn angles_that_are_nearly_exact() {
    let row = |angles: &str| format!("{{a: 0, d: 0, {angles}}}");
    only(&warnings(&arm(&row("alpha: 89.9999, theta: 0"), "")), "5:25", &["nearly 90", "write 90"]);
    let radians = |alpha: &str| arm(&row(&format!("alpha: {alpha}, theta: 0")), "").replace("angle: deg", "angle: rad");
    only(&warnings(&radians("-1.5708")), "5:25", &["-1.5708 is nearly -pi/2", "write -pi/2", "used as written"]);
    only(&warnings(&radians("1.57")), "5:25", &["1.57 is nearly pi/2", "write pi/2", "used as written"]);
    only(&warnings(&radians("1.571")), "5:25", &["1.571 is nearly pi/2"]);
    for exact in ["pi/2", "90 deg", "1.5707963267948966", "1.58", "0"] {
        assert_eq!(warnings(&radians(exact)), [""; 0], "{exact}");
    }
}

#[test]
fn what_is_left_out() {
    let text = arm(ROW, "").replace("units: {length: m, angle: deg}\n", "").replace("name: arm\n", "");
    only(&warnings(&text), "1:1", &["warning: no `units`", "m and angles as degrees"]);
    assert_eq!(read(&text, "specs/some_arm.yaml").unwrap().0.name, "some_arm");
    only(&warnings(&arm(ROW, "").replace(", angle: deg", "")), "3:8", &["no `angle` in `units`"]);
    only(&mistakes(&arm(ROW, "").replace("name: arm", "name: ''")), "1:7", &["the arm's name", "an empty text"]);
}

#[test]
fn mistakes_come_together() {
    let text =
        "nam: x\nconvention: new\nunits: {length: ft, angle: deg}\njoints:\n  - {a: x, alpha: 1.57, theta: 0}\n  - 1\n";
    let found = mistakes(text);
    let places = ["f:1:1: ", "f:2:13: ", "f:3:17: ", "f:5:5: ", "f:5:9: ", "f:5:19: ", "f:6:5: "];
    for place in places {
        assert!(found.iter().any(|mistake| mistake.starts_with(place)), "{place} {found:#?}");
    }
    assert_eq!(found.len(), places.len());
}

#[test]
fn rates_are_positive_and_stand_on_rows_that_move() {
    let row = "{a: 1, alpha: 0, d: 0, theta: 0, max_velocity: 180, max_acceleration: null}";
    let (spec, warnings) = read(&arm(row, ""), "f").unwrap();
    assert_eq!((spec.mistakes.as_slice(), warnings.as_slice()), (&[][..], &[][..]));
    let row = spec.rows.first().unwrap();
    let velocity = row.max_velocity.as_ref().map(|rate| rate.size);
    assert!(matches!(velocity, Some(RateSize::Angle(WrittenAngle::Degrees(180.0)))));
    assert!(row.max_acceleration.is_none());
    let rate =
        |kind: &str, value: &str| format!("{{type: {kind}, a: 1, alpha: 0, d: 0, theta: 0, max_velocity: {value}}}");
    row_mistake(&rate("revolute", "0"), "5:68", &["`max_velocity`", "greater than zero", "leave it out"]);
    row_mistake(&rate("prismatic", "-0.5"), "5:69", &["greater than zero"]);
    row_mistake(&rate("prismatic", "fast"), "5:69", &["expected a number"]);
    row_mistake(&rate("fixed", "90"), "5:65", &["`max_velocity` on a fixed row", "remove `max_velocity`"]);
}

#[test]
fn a_name_is_one_line_of_characters_that_are_shown() {
    only(
        &mistakes(&arm(ROW, "").replace("name: arm", "name: \"a\\nb\"")),
        "1:7",
        &["the arm's name in one line, found `a b`"],
    );
    row_mistake("{name: \"q\\a\", a: 1, alpha: 0, d: 0, theta: 0}", "5:12", &["a name in one line"]);
}

#[test]
fn of_many_warnings_the_first_are_shown() {
    let row = "  - {type: fixed, a: 1, alpha: 29.9999999, d: 0, theta: 0}\n";
    assert_eq!(warnings(&arm(ROW, &row.repeat(200))).len(), 50);
}

#[test]
fn of_many_mistakes_the_first_are_shown() {
    let keys: String = (0..2000).map(|i| format!("x{i}: {}\n", "y".repeat(100))).collect();
    let rows = "  - {type: revolute, b: 1, a: z}\n".repeat(2000);
    for text in [format!("name: x\n{keys}joints:\n{rows}"), format!("name: x\njoints:\n{rows}{keys}")] {
        let mistakes = read(&text, "x").unwrap_err();
        assert_eq!(mistakes.iter().count(), 51);
        let first = mistakes.iter().next().unwrap();
        assert!(first.at.is_none() && first.message.contains("the first 50 mistakes"), "{first}");
    }
}
