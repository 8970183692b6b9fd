//! Reading an arm file, and saying what is near when it is not there: the same words for the derive, the Builder and
//! the command.

use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::spec::nearest;

/// How many of the arm files of a directory a message lists.
const LISTED: usize = 6;

/// Why an arm file could not be read; shown as the whole message, with a `help:` line where something is near.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    message: String,
    help: Option<String>,
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(f, "\nhelp: {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for ReadError {}

/// The text of the arm file `written`, a path relative to `root` (or absolute).
///
/// # Errors
/// A file that is missing, is a directory, cannot be opened or is not UTF-8. A missing file's message names the
/// absolute path looked for and the arm files nearby, as paths that can be put in place of `written`.
pub fn read(root: &Path, written: &Path) -> Result<String, ReadError> {
    let path = root.join(written);
    let failure = |message: String, help: Option<String>| ReadError { message, help };
    match fs::read(&path) {
        Ok(bytes) => decode(bytes, &format!("`{}`", path.display())),
        Err(_) if path.is_dir() => {
            let help = match listing(&arm_files(&path), written) {
                Some(list) => format!("name one of the arm files in it: {list}"),
                None => "name an arm file, such as `specs/ur5.yaml`".to_owned(),
            };
            Err(failure(format!("`{}` is a directory, not an arm file", path.display()), Some(help)))
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(failure(format!("no arm file at `{}`", path.display()), nearby(root, written)))
        }
        Err(error) => Err(failure(format!("cannot read `{}`: {error}", path.display()), None)),
    }
}

/// The text of a file's bytes; `what` names the file. A byte order mark before UTF-8 is no part of the text.
///
/// # Errors
/// Bytes that are not UTF-8: which encoding they look like, and to save as UTF-8.
pub fn decode(bytes: Vec<u8>, what: &str) -> Result<String, ReadError> {
    let save = |message: String| ReadError { message, help: Some("save the file as UTF-8".to_owned()) };
    // UTF-16 begins with its mark, or has a zero byte in each of its letters, which are of ASCII nearly all.
    let wide =
        bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || bytes.iter().take(64).any(|b| *b == 0);
    if wide {
        return Err(save(format!("{what} is UTF-16, not UTF-8")));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text)),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            let lines = error.as_bytes().iter().take(at).filter(|byte| **byte == b'\n').count();
            Err(save(format!("{what} is not UTF-8: byte {at}, in line {}; it may be Latin-1", lines + 1)))
        }
    }
}

/// Suggestion of a path, in place of one at which there is no file.
fn nearby(root: &Path, written: &Path) -> Option<String> {
    let above = ["..", "../.."].iter().map(|up| Path::new(up).join(written)).find(|path| root.join(path).is_file());
    if let Some(path) = above {
        return Some(format!("paths start at `{}`; did you mean `{}`?", root.display(), path.display()));
    }
    let name = written.file_name()?.to_string_lossy().into_owned();
    let written_directory = written.parent().unwrap_or(Path::new(""));
    let directory = root.join(written_directory);
    if !directory.is_dir() {
        let inside = names(root, Path::is_dir).into_iter().map(|sub| Path::new(&sub).join(&name));
        let found = [PathBuf::from(&name)].into_iter().chain(inside).find(|path| root.join(path).is_file());
        let missing = format!("there is no directory `{}`", directory.display());
        return Some(match found {
            Some(path) => format!("{missing}; did you mean `{}`?", path.display()),
            None => missing,
        });
    }
    let files = arm_files(&directory);
    // By the stem: the extension, the same in all of them, would make any short name look near.
    let near = nearest(stem(&name), files.iter().map(|file| stem(file)));
    match files.iter().find(|file| Some(stem(file)) == near) {
        Some(file) => Some(format!("did you mean `{}`?", written_directory.join(file).display())),
        None => match listing(&files, written_directory) {
            Some(list) => Some(format!("arm files there: {list}")),
            None => Some(format!("there is no .yaml file in `{}`", directory.display())),
        },
    }
}

/// The `.yaml` and `.yml` files of a directory, by name.
fn arm_files(directory: &Path) -> Vec<String> {
    names(directory, |path| path.is_file() && path.extension().is_some_and(|end| end == "yaml" || end == "yml"))
}

fn stem(file: &str) -> &str {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

fn names(directory: &Path, keep: impl Fn(&Path) -> bool) -> Vec<String> {
    let entries = fs::read_dir(directory).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .filter(|entry| keep(&entry.path()))
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// `a.yaml`, `b.yaml` and 3 more; None of no files.
fn listing(files: &[String], directory: &Path) -> Option<String> {
    let shown: Vec<String> =
        files.iter().take(LISTED).map(|file| format!("`{}`", directory.join(file).display())).collect();
    match files.len().saturating_sub(LISTED) {
        _ if shown.is_empty() => None,
        0 => Some(shown.join(", ")),
        more => Some(format!("{} and {more} more", shown.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn root() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap()
    }

    fn message(root: &Path, written: &str) -> String {
        read(root, Path::new(written)).unwrap_err().to_string().replace(&root.display().to_string(), "$ROOT")
    }

    #[test]
    fn a_mistyped_name_is_put_right() {
        assert_eq!(
            message(&root(), "specs/pumma560.yaml"),
            "no arm file at `$ROOT/specs/pumma560.yaml`\nhelp: did you mean `specs/puma560.yaml`?"
        );
    }

    #[test]
    fn a_name_like_no_other_gets_the_list() {
        let text = message(&root(), "specs/my_own_arm_of_today.yaml");
        assert!(
            text.starts_with(
                "no arm file at `$ROOT/specs/my_own_arm_of_today.yaml`\nhelp: arm files there: `specs/abb"
            ),
            "{text}"
        );
        assert!(text.ends_with(" more"), "{text}");
    }

    #[test]
    fn a_path_from_the_workspace_root_is_put_right() {
        let member = root().join("codegen");
        let text = message(&member, "specs/ur5.yaml");
        assert_eq!(
            text,
            "no arm file at `$ROOT/specs/ur5.yaml`\nhelp: paths start at `$ROOT`; did you mean `../specs/ur5.yaml`?"
        );
    }

    #[test]
    fn a_missing_directory_is_named() {
        let text = message(&root(), "arms/ur5.yaml");
        assert_eq!(
            text,
            "no arm file at `$ROOT/arms/ur5.yaml`\nhelp: there is no directory `$ROOT/arms`; did you mean `specs/ur5.yaml`?"
        );
    }

    #[test]
    fn other_encodings_are_named() {
        let utf16 = "name: x".encode_utf16().flat_map(u16::to_le_bytes);
        let marked: Vec<u8> = [0xff, 0xfe].into_iter().chain(utf16.clone()).collect();
        for bytes in [utf16.collect(), marked] {
            let said = decode(bytes, "`a.yaml`").unwrap_err().to_string();
            assert_eq!(said, "`a.yaml` is UTF-16, not UTF-8\nhelp: save the file as UTF-8");
        }
        let said = decode(b"# x\n# Gr\xf6\xdfe\n".to_vec(), "`a.yaml`").unwrap_err().to_string();
        assert_eq!(said, "`a.yaml` is not UTF-8: byte 8, in line 2; it may be Latin-1\nhelp: save the file as UTF-8");
        assert_eq!(decode("\u{feff}name: x".into(), "x").unwrap(), "name: x");
    }

    #[test]
    fn a_directory_is_not_an_arm_file() {
        let text = message(&root(), "specs");
        assert!(
            text.starts_with(
                "`$ROOT/specs` is a directory, not an arm file\nhelp: name one of the arm files in it: `specs/"
            ),
            "{text}"
        );
    }
}
