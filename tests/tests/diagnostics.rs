//! Messages of the generator for arm files with mistakes: for each file of `bad/` the exact text, beside it.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::{Path, PathBuf};

use denhart_codegen::{Errors, Options, ScalarKind, generate};

fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|found| found == extension));
    files.sort();
    files
}

fn stem(file: &Path) -> String {
    file.file_stem().unwrap().to_string_lossy().into_owned()
}

/// The mistakes of a file under the name `file`; none if code comes out.
fn mistakes(text: &str, file: &str) -> Option<Errors> {
    generate(text, file, &Options::new("Arm")).err()
}

#[test]
fn every_mistake_has_its_text() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("bad");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in files("tests/bad", "yaml") {
        let name = stem(&path);
        let file = format!("bad/{name}.yaml");
        let errors = mistakes(&fs::read_to_string(&path).unwrap(), &file);
        let errors = errors.unwrap_or_else(|| unreachable!("{file} is accepted"));
        for error in &errors {
            assert!(error.at.is_some(), "{file}: no place in: {error}");
            let text = error.to_string();
            assert!(text.lines().all(|line| line.chars().count() <= 160), "{file}: a long line in: {text}");
        }
        settings.bind(|| insta::assert_snapshot!(name, errors.to_string()));
    }
}

/// Single precision has a range of its own, for the reach and for lengths that are no part of it.
#[test]
fn an_arm_beyond_single_precision_is_a_mistake_there() {
    let single = Options { scalar: ScalarKind::F32, ..Options::new("Arm") };
    let arm = |a: &str, home: &str| {
        format!(
            "convention: standard\nunits: {{length: m, angle: deg}}\njoints:\n  - {{type: prismatic, a: {a}, alpha: 0, d: 0, \
             theta: 0, actuator: {{pulses_per_unit: 1, home: {home}}}}}\n"
        )
    };
    for (a, home, found) in [
        ("1e9", "0", "4:26: the lengths add up to 1e9 m: expected an arm in single precision of 1e-4 to 1e8 m"),
        ("1e-5", "0", "4:26: the lengths add up to 1e-5 m: expected an arm in single precision of 1e-4 to 1e8 m"),
        ("1", "-1e39", "4:92: a length is -1e39 m: expected an arm in single precision of 1e-4 to 1e8 m"),
    ] {
        let text = arm(a, home);
        assert!(mistakes(&text, "arm.yaml").is_none(), "{text}");
        let errors = generate(&text, "arm.yaml", &single).unwrap_err().to_string();
        assert!(errors.starts_with(&format!("arm.yaml:{found}\n")), "{errors}");
        assert!(errors.contains("help: choose another unit of length, or generate the arm for `f64`"), "{errors}");
    }
    assert!(generate(&arm("1e3", "1"), "arm.yaml", &single).is_ok());
}

#[test]
fn every_text_has_its_mistake() {
    let yaml: Vec<_> = files("tests/bad", "yaml").iter().map(|file| stem(file)).collect();
    let texts: Vec<_> = files("tests/bad", "snap").iter().map(|file| stem(file)).collect();
    assert_eq!(yaml, texts);
}

/// A file cut off anywhere, or with a line lost, gives code or mistakes with their places.
#[test]
fn a_damaged_file_is_told_with_its_place() {
    for arm in ["cobra600_rrpr", "puma560", "kinova_gen3_lite"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../specs/{arm}.yaml"));
        let whole = fs::read_to_string(path).unwrap();
        let lines: Vec<_> = whole.lines().collect();
        let cut = (0..whole.len()).step_by(5).filter_map(|end| whole.get(..end)).map(str::to_owned);
        let lost = (0..lines.len()).map(|lost| {
            let kept = lines.iter().enumerate().filter(|(i, _)| *i != lost).map(|(_, line)| *line);
            kept.collect::<Vec<_>>().join("\n")
        });
        let mut refused = 0;
        for text in cut.chain(lost) {
            let Some(errors) = mistakes(&text, "damaged.yaml") else { continue };
            refused += 1;
            assert!(errors.into_iter().next().is_some(), "refused without a reason:\n{text}");
            for error in &errors {
                assert!(error.at.is_some(), "no place in: {error}\n{text}");
            }
        }
        assert!(refused > 20, "{arm}: only {refused} damaged files are refused");
    }
}
