//! Writing files without losing any.

use std::fs;
use std::path::Path;

/// Returns true if two paths name one file, whether it is there or not.
pub fn are_one(a: &Path, b: &Path) -> bool {
    match (fs::canonicalize(a), fs::canonicalize(b)) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b && a.as_os_str() != "-",
    }
}

/// Writes all files, or none. A file that is there with another content is overwritten only if `force` says so.
///
/// # Errors
/// The message: what is there already, or cannot be written.
pub fn write(files: &[(&Path, &str)], force: bool) -> Result<(), String> {
    let differs =
        |path: &Path, text: &str| path.exists() && !fs::read(path).is_ok_and(|present| present == text.as_bytes());
    let there: Vec<String> = files
        .iter()
        .filter(|(path, text)| differs(path, text))
        .map(|(path, _)| format!("`{}`", path.display()))
        .collect();
    if !force && !there.is_empty() {
        let (are, them) = if there.len() == 1 { ("is", "it") } else { ("are", "them") };
        let there = there.join(", ");
        return Err(format!(
            "{there} {are} there already\nhelp: --force overwrites {them}, or name another place with -o"
        ));
    }
    for (path, text) in files {
        let cannot = |error| format!("cannot write `{}`: {error}", path.display());
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(cannot)?;
        }
        fs::write(path, text).map_err(cannot)?;
    }
    Ok(())
}
