//! The `inverse` of an arm with joints to spare: the request that works, with the others in a comment.

use denhart_codegen::model::{RedundantValue, in_words};
use denhart_codegen::{Choice, Report};

use super::mimic_coupling::MimicCoupling;
use super::path::Path;
use super::walk::{end, moves};
use super::write::quoted;

/// The joints of a pose.
const POSE: usize = 6;
/// The most lists of joints that a file names, the cheapest first.
const MOST_LISTS: usize = 6;

/// The end of the arm file, and what is told about it.
pub struct Inverse {
    pub lines: String,
    pub remark: String,
}

/// The request for the arm file `text` of seven joints or more, of which all but six are given; none where fewer joints move.
pub fn of(text: &str, path: &Path, coupling: &MimicCoupling) -> Option<Inverse> {
    let spare = coupling.motors.len().checked_sub(POSE + 1)?;
    let report = denhart_codegen::check(text, "the imported arm").ok()?;
    let reason = report.unsupported.as_ref()?;
    let names: Vec<&str> = coupling.motors.iter().map(|motor| motor.file_name.as_str()).collect();
    let mut requests: Vec<String> = match spare {
        0 => report.instead.iter().map(|request| with_quotes(request, &names)).collect(),
        _ => lists(&report, &names),
    };
    let works = |request: &str| {
        let report = denhart_codegen::check(&format!("{text}{request}\n"), "the imported arm");
        report.is_ok_and(|report| report.max_solutions.is_some())
    };
    requests.retain(|request| works(request));
    if spare == 0 {
        requests.sort_by_key(|request| rank(request, &names));
    }
    if requests.is_empty() {
        let first = spare.checked_sub(1).filter(|_| coupling.is_identity());
        let help = match first.and_then(|first| path.joints.iter().filter(|passed| moves(passed)).nth(first)) {
            Some(passed) => format!("--base {} leaves the last {} joints", end(passed), POSE + 1),
            None => report.hint.unwrap_or_else(|| "`denhart::numeric` solves any arm by iteration".to_owned()),
        };
        return Some(Inverse { lines: String::new(), remark: format!("no inverse: {reason}\nhelp: {help}") });
    }
    let chosen = requests.remove(0);
    let values = match spare {
        0 => "one value is".to_owned(),
        more => format!("{} values are", in_words(more + 1)),
    };
    let mut lines = format!("# A pose takes six joints, so {values} given with it.");
    let mut remark = format!("a pose takes six joints, so {values} given with it: `{chosen}`");
    if !requests.is_empty() {
        lines += " Other requests that work:";
        remark += "; the file lists other requests";
    }
    lines.push('\n');
    for request in requests {
        lines += &format!("# {request}\n");
    }
    lines += &format!("{chosen}\n");
    Some(Inverse { lines, remark })
}

/// The requests with lists of joints, the cheapest first.
fn lists(report: &Report, names: &[&str]) -> Vec<String> {
    let name = |value: &RedundantValue| match value {
        RedundantValue::Joint(joint) => names.get(*joint).map_or_else(String::new, |name| quoted(name)),
        RedundantValue::ArmAngle => "arm_angle".to_owned(),
    };
    let request = |choice: &Choice| {
        let names: Vec<String> = choice.given.values.iter().map(name).collect();
        format!("inverse: {{redundant: [{}]}}", names.join(", "))
    };
    report.choices.iter().take(MOST_LISTS).map(request).collect()
}

/// The order in which requests are proposed: joint 3, which swings the elbow of most arms of seven joints, then the
/// last one, which turns the tool, then as they come.
fn rank(request: &str, names: &[&str]) -> usize {
    let gives = |name: Option<&&str>| name.is_some_and(|name| request.ends_with(&given(&quoted(name))));
    match request {
        _ if gives(names.get(2)) => 0,
        _ if gives(names.last()) => 1,
        _ => 2,
    }
}

/// The end of a request that gives the value of a joint.
fn given(name: &str) -> String {
    format!("redundant: {name}}}")
}

/// A request with the name of its joint as YAML.
fn with_quotes(request: &str, names: &[&str]) -> String {
    let quote = |name: &&str| Some(format!("{}{}", request.strip_suffix(&given(name))?, given(&quoted(name))));
    names.iter().find_map(quote).unwrap_or_else(|| request.to_owned())
}
