//! Reaction of cargo where an arm file changes or is missing: a new build, or one error at the attribute. The messages
//! of rustc for each mistake are in `macros/tests/ui/`.
#![allow(clippy::unwrap_used)]

mod user_crate;

use user_crate::UserCrate;

const LEVER: &str = "\
name: lever
convention: standard
units: {length: m, angle: deg}
joints:
  - {type: revolute, a: 0.5, alpha: 0, d: 0, theta: 0}
";

const DEPENDENCY: &str = r#"
[dependencies]
denhart = { path = "$ROOT/runtime", default-features = false, features = ["std", "derive"] }
"#;

const MAIN: &str = r#"
use denhart::Arm;

#[derive(Arm)]
#[arm(spec = "arms/lever.yaml")]
struct Lever;

fn main() {
    println!("{:?}", Lever.forward(&[0.0]).translation);
}
"#;

/// The file is read again when it changes: to other numbers, to a mistake, and back.
#[test]
fn editing_the_file_rebuilds() {
    let user = UserCrate::new("edited_file", DEPENDENCY);
    user.write("src/main.rs", MAIN);
    user.write("arms/lever.yaml", LEVER);
    assert_eq!(user.succeeds(&["run"]), "[0.5, 0.0, 0.0]\n");

    user.write("arms/lever.yaml", &LEVER.replace("0.5", "0.75"));
    assert_eq!(user.succeeds(&["run"]), "[0.75, 0.0, 0.0]\n");

    user.write("arms/lever.yaml", &LEVER.replace("alpha", "alfa"));
    let errors = user.fails(&["run"]);
    assert!(errors.starts_with("error: arms/lever.yaml:5:"), "{errors}");
    assert!(errors.contains(" --> src/main.rs:5:14\n"), "{errors}");
    assert_one(&errors);

    user.write("arms/lever.yaml", LEVER);
    assert_eq!(user.succeeds(&["run"]), "[0.5, 0.0, 0.0]\n");
}

#[test]
fn a_missing_file_is_one_error() {
    let user = UserCrate::new("missing_file", DEPENDENCY);
    user.write("src/main.rs", MAIN);
    user.write("arms/laver.yaml", LEVER);
    let errors = user.fails(&["check"]);
    let expected = "\
error: no arm file at `$CRATE/arms/lever.yaml`
       help: did you mean `arms/laver.yaml`?
 --> src/main.rs:5:14
  |
5 | #[arm(spec = \"arms/lever.yaml\")]
  |              ^^^^^^^^^^^^^^^^^
";
    assert!(errors.starts_with(expected), "{errors}");
    assert_one(&errors);
}

#[test]
fn advice_is_a_warning_when_asked_for() {
    let user = UserCrate::new("advice", DEPENDENCY);
    user.write("src/main.rs", &MAIN.replace("yaml\")", "yaml\", warn)"));
    user.write("arms/lever.yaml", &LEVER.replace("alpha: 0", "alpha: 1.5708 rad"));
    let output = user.cargo(&["check"]);
    let shown = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{shown}");
    assert!(shown.starts_with("warning: use of deprecated constant"), "{shown}");
    assert!(shown.contains("arms/lever.yaml:5:"), "{shown}");
    assert!(shown.contains(" --> src/main.rs:5:14\n"), "{shown}");
}

/// Of rustc's errors and warnings there is one, besides the closing words of cargo.
fn assert_one(shown: &str) {
    let begins = |line: &&str| ["error", "warning"].iter().any(|word| line.starts_with(word));
    let count = shown.lines().filter(begins).filter(|line| !line.contains("could not compile")).count();
    assert_eq!(count, 1, "{shown}");
}
