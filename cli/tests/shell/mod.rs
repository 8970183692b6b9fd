//! The command as it is run from a shell.
#![allow(dead_code, clippy::unwrap_used)]

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

pub fn command(arguments: &[&str]) -> Command {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut command = Command::new(env!("CARGO_BIN_EXE_denhart"));
    command.args(arguments).current_dir(root);
    command
}

pub fn denhart(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

pub fn said(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub fn shown(arguments: &[&str]) -> String {
    let output = denhart(arguments);
    assert!(output.status.success(), "{output:?}");
    said(&output.stdout)
}

pub fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&said(&denhart(arguments).stdout)).unwrap()
}

pub fn close(value: &Value, expected: &[f64]) {
    let values: Vec<f64> = value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert_eq!(values.len(), expected.len());
    assert!(values.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-9), "{values:?}, not {expected:?}");
}

/// Runs with a text on the standard input. A command that is refused may end before it reads.
pub fn fed(arguments: &[&str], input: &str) -> Output {
    let mut child = command(arguments);
    child.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = child.spawn().unwrap();
    match child.stdin.take().unwrap().write_all(input.as_bytes()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => {}
        written => written.unwrap(),
    }
    child.wait_with_output().unwrap()
}

/// A file with this text in the folder of the tests.
///
/// The text is written beside the file, which is then replaced: tests that run at the same time may write and read one file.
pub fn file(name: &str, text: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (path, beside) = (folder.join(name), folder.join(format!("{name}.{:?}", std::thread::current().id())));
    std::fs::write(&beside, text).unwrap();
    std::fs::rename(&beside, &path).unwrap();
    path.to_str().unwrap().to_owned()
}
