//! Where an exported library takes the crate denhart from.

use std::fs;
use std::path::{Component, Path, PathBuf};

use denhart_tools::export::Dependency;

/// The crate denhart that this command was built beside. It is gone where a clone has been removed, and not there where
/// the command came from crates.io.
pub const BUILT_BESIDE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../runtime");

/// The crate at `named`, else the one at `beside`, else that of crates.io.
///
/// # Errors
/// The message: there is no such crate at `named`.
pub fn find(named: Option<&Path>, beside: &Path, folder: &Path) -> Result<Dependency, String> {
    match named {
        Some(path) => at(path, folder),
        None => Ok(at(beside, folder).unwrap_or(Dependency::Published)),
    }
}

/// The line that says where the crate comes from, before anything is written. crates.io may not have it.
pub fn remark(denhart: &Dependency, folder: &Path) -> String {
    let manifest = folder.join("Cargo.toml");
    let manifest = manifest.display();
    match denhart {
        Dependency::Folder(path) => format!("{manifest}: `denhart` is that of `{path}`"),
        Dependency::Published => format!(
            "warning: {manifest}: `denhart` {} is that of crates.io, which cargo finds only where it is published\n\
             help: --crate-path DIR, the folder `runtime` of a clone of denhart's repository",
            env!("CARGO_PKG_VERSION")
        ),
    }
}

/// The crate at `path`, for a library in `folder`, which need not be there yet.
///
/// # Errors
/// The message: there is no such crate.
fn at(path: &Path, folder: &Path) -> Result<Dependency, String> {
    let shown = path.display();
    let manifest = fs::read_to_string(path.join("Cargo.toml"))
        .map_err(|error| format!("--crate-path: cannot read `{shown}/Cargo.toml`: {error}"))?;
    if !manifest.lines().any(|line| line.replace(' ', "") == "name=\"denhart\"") {
        return Err(format!(
            "--crate-path: `{shown}` is not the crate denhart\nhelp: name the folder `runtime` of its repository"
        ));
    }
    let absolute = |path: &Path| std::path::absolute(path).map_err(|error| format!("`{}`: {error}", path.display()));
    // Where links lead: `..` of a link is not what it looks like.
    let to = path.canonicalize().map_err(|error| format!("--crate-path: `{shown}`: {error}"))?;
    let from = resolved(&absolute(folder)?);
    Ok(Dependency::Folder(relative(&from, &to).to_string_lossy().into_owned()))
}

/// An absolute path with the links resolved of what there is of it.
fn resolved(path: &Path) -> PathBuf {
    match (path.canonicalize(), path.parent(), path.file_name()) {
        (Err(_), Some(parent), Some(name)) => resolved(parent).join(name),
        (found, ..) => found.unwrap_or_else(|_| path.to_owned()),
    }
}

/// `to` as seen from `from`, both absolute; `to` itself where they have no beginning in common, as on two drives.
fn relative(from: &Path, to: &Path) -> PathBuf {
    let common = from.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    if !matches!(to.components().next(), Some(first) if from.components().next() == Some(first)) {
        return to.to_owned();
    }
    let up = from.components().skip(common).map(|_| Component::ParentDir);
    up.chain(to.components().skip(common)).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{BUILT_BESIDE, Dependency, find, relative, remark};

    #[test]
    fn a_crate_that_is_not_there_is_announced() {
        let folder = Path::new("/no/such/place");
        let published = find(None, folder, folder);
        let remark = published.map(|found| remark(&found, folder)).unwrap_or_default();
        assert!(
            remark.starts_with("warning: /no/such/place/Cargo.toml: `denhart` ") && remark.contains("--crate-path DIR")
        );
        // Seen from here, which is where the test runs.
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let beside = find(None, Path::new(BUILT_BESIDE), here);
        assert!(matches!(beside, Ok(Dependency::Folder(path)) if Path::new(&path).join("src/lib.rs").is_file()));
        assert!(find(Some(folder), Path::new(BUILT_BESIDE), folder).is_err());
    }

    #[test]
    fn a_folder_seen_from_another() {
        for (from, to, seen) in
            [("/a/b/c", "/a/d", "../../d"), ("/a", "/a/d/e", "d/e"), ("/a/b", "/a/b", ""), ("/a/b", "/c", "../../c")]
        {
            assert_eq!(relative(Path::new(from), Path::new(to)), Path::new(seen), "{from} {to}");
        }
    }
}
