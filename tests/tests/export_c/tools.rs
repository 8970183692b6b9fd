//! The command, cargo, the C compiler, and the program in C.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The folder of this repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The command: its status, its output, its errors.
pub fn said(arguments: &[&str]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = denhart_cli::run([&["denhart"], arguments].concat(), &mut out, &mut err);
    (status, String::from_utf8(out).unwrap(), String::from_utf8(err).unwrap())
}

/// The command, which has to succeed unless `refused` is in its errors. Beside success stands nothing, or the one warning
/// of an arm without inverse.
pub fn denhart(arguments: &[&str], refused: Option<&str>) {
    let (status, _, err) = said(arguments);
    let warned = |lines: &[&str]| {
        matches!(lines, [warning, help] if warning.starts_with("warning: ")
            && warning.contains(": the library has no inverse kinematics: ") && help.starts_with("help: "))
    };
    match refused {
        None => {
            let lines: Vec<&str> = err.lines().collect();
            assert!(status == 0 && (lines.is_empty() || warned(&lines)), "{status}: {err}");
        }
        Some(says) => assert!(status != 0 && err.contains(says), "{status}: {err}"),
    }
}

pub fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("export").join(name)
}

/// Exports the arm anew.
pub fn export(spec: &str, scalar: &str, name: &str) -> PathBuf {
    let folder = folder(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    let (output, spec) = (folder.to_str().unwrap(), root().join("tests").join(spec));
    let runtime = root().join("runtime");
    let place = ["--crate-path", runtime.to_str().unwrap()];
    denhart(&[&["export", "c", spec.to_str().unwrap(), "-o", output, "--scalar", scalar], &place[..]].concat(), None);
    // The versions of this repository: no newer ones are looked for.
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    folder
}

/// A command of this machine, if there is one.
pub fn command(name: &str) -> Option<Command> {
    let found = Command::new(name).arg("--version").stdout(Stdio::null()).status().is_ok_and(|status| status.success());
    if !found {
        println!("skipped: there is no `{name}`");
    }
    found.then(|| Command::new(name))
}

/// The C compiler, if there is one.
pub fn cc() -> Option<Command> {
    command("cc")
}

pub fn succeeds(command: &mut Command) {
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}:\n{said}");
}

/// Builds the library of an exported arm by a profile of cargo; returns it.
pub fn library(folder: &Path, prefix: &str, profile: &str) -> PathBuf {
    let target = self::folder("target");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--profile", profile]).current_dir(folder).env("CARGO_TARGET_DIR", &target);
    succeeds(cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS"));
    let built = if profile == "dev" { "debug" } else { profile };
    let library = target.join(built).join(format!("lib{prefix}_c.a"));
    // The next arm may have the same name.
    let kept = folder.join(format!("{profile}.a"));
    fs::copy(library, &kept).unwrap();
    kept
}

/// The program in C for an exported arm, compiled.
pub fn program(cc: &mut Command, folder: &Path, prefix: &str, definitions: &[&str], library: &Path) -> PathBuf {
    let text = include_str!("main.c").replace("exported", prefix).replace("EXPORTED", &prefix.to_uppercase());
    fs::write(folder.join("main.c"), text).unwrap();
    let program = folder.join("program");
    cc.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I"]).arg(folder.join("include"));
    succeeds(cc.args(definitions).arg(folder.join("main.c")).arg(library).arg("-o").arg(&program));
    program
}

/// Runs the program in C; `expected` follow the line of bad arguments.
pub fn prints(program: &Path, input: &str, expected: &str) {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success(), "{}", output.status);
    let text = String::from_utf8(output.stdout).unwrap();
    let (arguments, lines) = text.split_once('\n').unwrap();
    assert!(arguments.split(' ').skip(1).all(|status| status == "3"), "{arguments}");
    for (number, (c, rust)) in lines.lines().zip(expected.lines()).enumerate() {
        assert_eq!(c, rust, "case {number}");
    }
    assert_eq!(lines.lines().count(), expected.lines().count());
}
