//! For every arm of `specs/` the report of `denhart check` with a digest of the generated code, and the output of the
//! stages before code; for some arms the code in full (`IN_FULL`). Each is compared with its form when last reviewed.
//! The rules that hold for the code of every arm are also checked.
//!
//! `INSTA_UPDATE=always cargo test -p denhart-tests --test snapshot` accepts what changed: read the difference first.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use denhart_codegen::lower::{Given, Statement};
use denhart_codegen::{Errors, Options, Report};
use denhart_tests::random::digest;

/// Arms whose code is kept in full, each with the part of a plan that it is kept for. Together with `OTHER_TASKS` they
/// have every convention, task, kernel and kind of step that occurs in `specs/`: a test compares them.
const IN_FULL: [&str; 14] = [
    // A spherical wrist: separate equations, the search without levels.
    "puma560",
    // A spherical wrist behind two equations that do not separate.
    "gen3r_sphwrist",
    // Parallel axes.
    "ur5",
    // A given joint, cones, modified rows.
    "kuka_iiwa7_r800",
    // Pose of four joints, one of them prismatic: equations without a joint.
    "scara_rrrp_325_275",
    // Pose of five joints: the better conditioned of two equations.
    "kuka_youbot",
    // `position_angle`.
    "jupiter",
    // `position`, with a prismatic joint.
    "polar_rrp",
    // `planar_pose`, with a given joint.
    "planar4r_redundant",
    // `planar_position`.
    "planar2r",
    // A held joint: two axes meet, two are parallel; any structure; a joint given.
    "kinova_gen3_lite",
    "two_parallel_6r",
    "baxter_left",
    // No inverse.
    "singular_6r",
];

/// Bounds on the source of one arm: it is meant to be read. An arm that holds a joint has constants of up to three cuts.
/// The longest one, a Panda, had 985 lines before followers of a path asked a redundant arm for three more functions, of 27.
const MOST_LINES: usize = 1015;
const MOST_LINES_OF_A_HELD_JOINT: usize = 1600;
const LONGEST_LINE: usize = 200;
/// No dimension and no tolerance of an arm is below this: such a number is the rounding of something exact.
const SMALLEST_NUMBER: f64 = 1e-12;

/// Multiplications and additions of forward, jacobian, and both together: the best that is known, or better.
const BARS: [(&str, [[usize; 2]; 3]); 2] =
    [("puma560", [[48, 24], [34, 16], [60, 32]]), ("ur5", [[39, 22], [39, 23], [59, 34]])];

fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs")
}

/// Result of `of` on the arm file.
fn made<T>(name: &str, of: impl Fn(&str, &str) -> Result<T, Errors>) -> T {
    let path = specs().join(format!("{name}.yaml"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    of(&text, &format!("specs/{name}.yaml")).unwrap_or_else(|errors| panic!("{errors}"))
}

fn code(name: &str, type_name: &str) -> String {
    made(name, |text, file| denhart_codegen::generate(text, file, &Options::new(type_name))?.to_file())
}

/// The text with another request for an inverse.
fn asking(inverse: &str, text: &str) -> String {
    let lines = text.lines().map(|line| if line.starts_with("inverse:") { inverse } else { line });
    lines.collect::<Vec<_>>().join("\n")
}

/// Keeps `text` in `snapshots/<folder>/<name>.snap`.
fn keep(folder: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new("snapshots").join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Parts that make up the plan of an arm, with another request for an inverse if there is one.
fn parts(name: &str, inverse: Option<&str>) -> BTreeSet<String> {
    let program = made(name, |text, file| {
        denhart_codegen::program(&inverse.map_or_else(|| text.to_owned(), |inverse| asking(inverse, text)), file)
    });
    let mut parts = BTreeSet::from([format!("{:?}", program.model.convention)]);
    let Ok(inverse) = &program.inverse else {
        parts.insert("no inverse".to_owned());
        return parts;
    };
    parts.insert(inverse.goal.task().name().to_owned());
    parts.extend(inverse.levels.iter().flat_map(|level| &level.body).filter_map(|statement| match statement {
        Statement::Solve(call) => Some(call.kernel.name().to_owned()),
        Statement::Angle { .. } => Some("a sum of joints".to_owned()),
        Statement::Agree { .. } => Some("an equation without a joint".to_owned()),
        _ => None,
    }));
    parts.extend(inverse.given.values.iter().map(|given| match given {
        Given::Joint { .. } => "a given joint".to_owned(),
        Given::ArmAngle => "the arm angle".to_owned(),
    }));
    let conditions = [(inverse.decoupled, "decoupled"), (inverse.in_doubt, "structure missed")];
    parts.extend(conditions.into_iter().filter(|(holds, _)| *holds).map(|(_, part)| part.to_owned()));
    parts
}

/// Short enough to read, the same at every run, and without arithmetic that does nothing.
fn check_code(name: &str, code: &str, again: &str) {
    assert!(code == again, "{name}: two runs give different code");
    let lines = code.lines().count();
    let most = if code.contains("HeldJointSearch") { MOST_LINES_OF_A_HELD_JOINT } else { MOST_LINES };
    assert!(lines <= most, "{name}: {lines} lines");
    for (index, line) in code.lines().enumerate() {
        assert!(line.chars().count() <= LONGEST_LINE, "{name}: line {} is too long:\n{line}", index + 1);
    }
    let statements: Vec<&str> = code.lines().map(str::trim).filter(|line| !line.starts_with("//")).collect();
    let statements = statements.join(" ");
    for number in numbers(&statements) {
        let value: f64 = number.parse().unwrap_or_else(|error| panic!("{name}: {number}: {error}"));
        assert!(value == 0.0 || value >= SMALLEST_NUMBER, "{name}: {number} stands for zero");
    }
    for idle in ["* 1.0", "/ 1.0", "+ 0.0", "- 0.0", "* 0.0", "1.0 *", "0.0 *", "0.0 +", "0.0 -", "- -", "+ -"] {
        assert!(!occurs(&statements, idle), "{name}: `{idle}` in the code");
    }
}

/// The number literals of some code.
fn numbers(code: &str) -> impl Iterator<Item = &str> {
    let words = code.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'));
    words.flat_map(|word| word.split("..")).filter(|word| word.starts_with(|c: char| c.is_ascii_digit()))
}

/// Returns true if `part` occurs and is not a piece of longer numbers, as `* 1.0` is in `* 1.05`.
fn occurs(code: &str, part: &str) -> bool {
    let in_number = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    code.match_indices(part).any(|(at, _)| {
        let (before, after) = (&code[..at], &code[at + part.len()..]);
        let cut_before = part.starts_with(in_number) && before.ends_with(in_number);
        !(cut_before || part.ends_with(in_number) && after.starts_with(in_number))
    })
}

fn check_report(name: &str, report: &Report, has_inverse: bool) {
    assert_eq!(report.max_solutions.is_some(), has_inverse, "{name}: {report}");
    assert_ne!(report.unsupported.is_some(), has_inverse, "{name}: {report}");
}

#[test]
fn operation_counts_reach_the_bars() {
    for (name, bars) in BARS {
        let report = made(name, denhart_codegen::check);
        for (cost, [multiplications, additions]) in report.costs.iter().zip(bars) {
            let within = cost.multiplications <= multiplications && cost.additions <= additions;
            assert!(within, "{name}: {cost:?}, the bar is {multiplications} and {additions}");
        }
    }
}

/// The counts in the doc comments are those of the report.
#[test]
fn operation_counts_are_printed() {
    for (name, _) in BARS {
        let code = code(name, "Robot");
        for cost in made(name, denhart_codegen::check).costs {
            let (additions, multiplications, sin_cos) = (cost.additions, cost.multiplications, cost.sin_cos);
            let text = format!("/// {additions} additions, {multiplications} multiplications, {sin_cos} sin_cos.\n");
            assert!(code.contains(&text), "{name}: no line {text}");
        }
    }
}

macro_rules! snapshot_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        mod code {
            $(#[test]
            fn $name() {
                let [first, again] = [(); 2].map(|()| super::code(stringify!($name), stringify!($Type)));
                super::check_code(stringify!($name), &first, &again);
                if super::IN_FULL.contains(&stringify!($name)) {
                    super::keep("code", stringify!($name), &first);
                }
            })*
        }

        mod report {
            $(#[test]
            fn $name() {
                let report = super::made(stringify!($name), denhart_codegen::check);
                super::check_report(stringify!($name), &report, stringify!($kind) != "forward");
                let code = super::code(stringify!($name), stringify!($Type));
                let (lines, digest) = (code.lines().count(), super::digest(&code));
                let text = format!("{report}code: {lines} lines, digest {digest:016x}");
                super::keep("report", stringify!($name), &text);
            })*
        }

        mod stages {
            use denhart_codegen::Bound;

            $(#[test]
            fn $name() {
                let stages = |text: &str, file: &str| denhart_codegen::stages_text(text, file, &Bound::None);
                super::keep("stages", stringify!($name), &super::made(stringify!($name), stages));
            })*
        }

        /// Code in full shows all that there is: see `IN_FULL`.
        #[test]
        fn code_in_full_has_every_part_of_a_plan() {
            let all = BTreeSet::from_iter([$(stringify!($name)),*].into_iter().flat_map(|name| parts(name, None)));
            let kept = IN_FULL.into_iter().flat_map(|name| parts(name, None));
            let kept = kept.chain(OTHER_TASKS.into_iter().flat_map(|(_, arm, inverse)| parts(arm, Some(inverse))));
            let kept = BTreeSet::from_iter(kept);
            let missing: Vec<&String> = all.difference(&kept).collect();
            assert!(missing.is_empty(), "in no code in full: {missing:?}");
        }

        /// The list of arms is the folder `specs/`.
        #[test]
        fn every_file_is_listed() {
            let listed = BTreeSet::from([$(stringify!($name).to_owned()),*]);
            let files = std::fs::read_dir(specs()).expect("specs/ can be read");
            let stems = files.map(|file| file.expect("specs/ can be read").path());
            let found: BTreeSet<String> = stems
                .filter(|path| path.extension().is_some_and(|extension| extension == "yaml"))
                .map(|path| path.file_stem().expect("a file has a name").to_string_lossy().into_owned())
                .collect();
            assert_eq!(listed, found);
        }
    };
}

denhart_tests::published_arms!(snapshot_tests);

/// Tasks that no file of `specs/` asks for.
const OTHER_TASKS: [(&str, &str, &str); 2] = [
    ("arm_angle", "kuka_iiwa7_r800", "inverse: {task: pose, redundant: arm_angle}"),
    ("position_axis", "scorbot_er5", "inverse: {task: position_axis, axis: x}"),
];

#[test]
fn other_tasks() {
    for (name, arm, inverse) in OTHER_TASKS {
        let generate = |text: &str, file: &str| {
            let text = asking(inverse, text);
            let report = denhart_codegen::check(&text, file)?;
            assert!(report.unsupported.is_none(), "{name}: {report}");
            denhart_codegen::generate(&text, file, &Options::new("Robot"))?.to_file()
        };
        let code = made(arm, generate);
        check_code(name, &code, &made(arm, generate));
        keep("code", name, &code);
    }
}

#[test]
fn numbers_and_parts_are_found() {
    let found: Vec<&str> = numbers("let x1 = -0.5 * D4 + [2.0; 3] - f64::sin(0..7)").collect();
    assert_eq!(found, ["0.5", "2.0", "3", "0", "7"]);
    assert!(occurs("a * 1.0;", "* 1.0") && !occurs("a * 1.05;", "* 1.0") && !occurs("a * 1.0e3;", "* 1.0"));
    assert!(occurs("(1.0 * a", "1.0 *") && !occurs("21.0 * a", "1.0 *"));
}
