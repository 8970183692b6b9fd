//! A package that has `denhart` under another name has to say so: a macro cannot see what a dependency is called.

use std::fs;
use std::path::Path;

use proc_macro2::Span;
use syn::Error;

/// The name of `denhart` in the manifest of the package, where that is another one.
pub fn name(package: Option<&Path>) -> Option<String> {
    let package = package?;
    let manifest = fs::read_to_string(package.join("Cargo.toml")).ok()?;
    renamed(&manifest, || workspace(package, &manifest)).map(|name| name.replace('-', "_"))
}

/// The mistake of an attribute that does not name the crate, where it is called `name`.
pub fn mistake(name: &str) -> Error {
    let text = format!(
        "the Cargo.toml of this package calls the crate denhart `{name}`\nhelp: add `crate = \"::{name}\"` to #[arm(..)]"
    );
    Error::new(Span::call_site(), text)
}

/// The name of the dependency on the package `denhart`, if that is another one: `robot` of
/// `robot = { package = "denhart", .. }`. `workspace` gives the manifest that `robot.workspace = true` refers to.
fn renamed(manifest: &str, workspace: impl FnOnce() -> Option<String>) -> Option<String> {
    let entries = entries(manifest);
    let is_itself = |entry: &Entry| entry.path == ["package", "name"] && entry.value == "denhart";
    let used = || entries.iter().filter(|entry| !entry.is_of_workspace()).filter_map(Entry::of_dependency);
    if entries.iter().any(is_itself) || used().any(|(name, ..)| name == "denhart") {
        return None;
    }
    let named =
        |(name, key, value): (&str, &str, &str)| (key == "package" && value == "denhart").then(|| name.to_owned());
    if let Some(name) = used().find_map(named) {
        return Some(name);
    }
    let inherited: Vec<&str> =
        used().filter(|(_, key, value)| *key == "workspace" && *value == "true").map(|(name, ..)| name).collect();
    if inherited.is_empty() {
        return None;
    }
    let workspace = self::entries(&workspace()?);
    let shared = workspace.iter().filter(|entry| entry.is_of_workspace());
    shared.filter_map(Entry::of_dependency).filter_map(named).find(|name| inherited.contains(&name.as_str()))
}

/// The manifest of the workspace that a package is in: its own, the one it names, or the nearest above it.
fn workspace(package: &Path, manifest: &str) -> Option<String> {
    let is_workspace = |text: &String| entries(text).iter().any(Entry::is_of_workspace);
    let own = entries(manifest);
    let named = own.iter().find(|entry| entry.path == ["package", "workspace"]);
    if let Some(named) = named {
        return fs::read_to_string(package.join(&named.value).join("Cargo.toml")).ok();
    }
    let manifests = package.ancestors().filter_map(|folder| fs::read_to_string(folder.join("Cargo.toml")).ok());
    manifests.into_iter().find(is_workspace)
}

/// A key of a manifest, with the tables that it is in, and its value without quotes.
struct Entry {
    path: Vec<String>,
    value: String,
}

impl Entry {
    /// Returns true for an entry of the workspace, not of a package.
    fn is_of_workspace(&self) -> bool {
        self.path.first().is_some_and(|table| table == "workspace")
    }

    /// Name, key and value of a dependency of the code, not of its build script. A version alone has no key.
    fn of_dependency(&self) -> Option<(&str, &str, &str)> {
        let at = self.path.iter().position(|part| part == "dependencies" || part == "dev-dependencies")?;
        // In front: nothing, the platform of the dependency, or the workspace.
        let known = at == 0 || self.path.first().is_some_and(|table| table == "target" || table == "workspace");
        if !known {
            return None;
        }
        let key = self.path.get(at + 2).map_or("", String::as_str);
        Some((self.path.get(at + 1)?, key, &self.value))
    }
}

/// The keys of a manifest, also those of inline tables. It takes what dependencies are written with, not all of TOML: a
/// parser of TOML would be built with every derive, for one message.
fn entries(manifest: &str) -> Vec<Entry> {
    let mut table = Vec::new();
    let mut found = Vec::new();
    for line in manifest.lines() {
        let line = split(line, '#').into_iter().next().unwrap_or_default().trim();
        if let Some(header) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            table = path(header.trim_matches(['[', ']']));
        } else {
            entry(&table, line, &mut found);
        }
    }
    found
}

/// `key = value` in a table; the keys of an inline table are entries of their own.
fn entry(table: &[String], text: &str, found: &mut Vec<Entry>) {
    let parts = split(text, '=');
    let Some(key) = parts.first().filter(|_| parts.len() > 1) else { return };
    let path: Vec<String> = table.iter().cloned().chain(path(key)).collect();
    let value = text.get(key.len() + 1..).unwrap_or_default().trim();
    match value.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')) {
        Some(inner) => split(inner, ',').into_iter().for_each(|pair| entry(&path, pair, found)),
        None => found.push(Entry { path, value: unquoted(value) }),
    }
}

/// The parts of a dotted key.
fn path(key: &str) -> Vec<String> {
    split(key, '.').into_iter().map(unquoted).collect()
}

fn unquoted(text: &str) -> String {
    text.trim().trim_matches(['"', '\'']).to_owned()
}

/// The parts between the separators that are in no quotes and no brackets.
fn split(text: &str, separator: char) -> Vec<&str> {
    let (mut quote, mut depth, mut start) = (None, 0_usize, 0);
    let mut parts = Vec::new();
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, c) if c == separator && depth == 0 => {
                parts.extend(text.get(start..at));
                start = at + c.len_utf8();
            }
            (None, '{' | '[') => depth += 1,
            (None, '}' | ']') => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    parts.extend(text.get(start..));
    parts
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use std::path::PathBuf;

    use super::*;

    #[test]
    fn the_name_in_the_manifest() {
        for (manifest, name) in [
            ("[dependencies]\nrobot = { package = \"denhart\", path = \"..\" }\n", Some("robot")),
            (
                "[dependencies]\nrobot={path=\"a,b\",features=[\"libm\", \"fpu\"],package='denhart'} # ours\n",
                Some("robot"),
            ),
            ("[dependencies]\nrobot.package = \"denhart\"\nrobot.version = \"1\"\n", Some("robot")),
            ("[dependencies.my-arm]\nversion = \"1\"\npackage = \"denhart\"\n", Some("my-arm")),
            ("[target.'cfg(unix)'.dependencies]\nrobot = { package = \"denhart\" }\n", Some("robot")),
            ("[dev-dependencies]\n\"robot\" = { package = \"denhart\" }\n", Some("robot")),
            ("[dependencies]\ndenhart = \"0.1\"\n", None),
            ("[dependencies]\ndenhart.workspace = true\nold = { package = \"denhart\", version = \"0.0\" }\n", None),
            ("[dependencies.denhart]\npath = \"..\"\n", None),
            ("[dependencies]\nserde = \"1\"\n", None),
            ("[dependencies]\n# robot = { package = \"denhart\" }\n", None),
            ("[build-dependencies]\nrobot = { package = \"denhart\" }\n", None),
            ("[package]\nname = \"denhart\"\n", None),
            ("[package.metadata.tool.dependencies]\nrobot = { package = \"denhart\" }\n", None),
            (
                "[workspace.dependencies]\ndenhart = \"1\"\n[dependencies]\nrobot = { package = \"denhart\" }\n",
                Some("robot"),
            ),
        ] {
            assert_eq!(renamed(manifest, || None).as_deref(), name, "{manifest}");
        }
    }

    #[test]
    fn the_name_in_the_manifest_of_the_workspace() {
        let shared = "[workspace]\nmembers = [\"arm\"]\n[workspace.dependencies]\nrobot = { package = \"denhart\" }\n";
        for (manifest, name) in [
            ("[dependencies]\nrobot.workspace = true\n", Some("robot")),
            ("[dependencies]\nrobot = { workspace = true, features = [\"libm\"] }\n", Some("robot")),
            ("[dependencies.robot]\nworkspace = true\n", Some("robot")),
            ("[dependencies]\nserde.workspace = true\n", None),
            ("[dependencies]\nrobot = \"1\"\n", None),
        ] {
            assert_eq!(renamed(manifest, || Some(shared.to_owned())).as_deref(), name, "{manifest}");
        }
    }

    fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("denhart_renamed_{}_{name}", std::process::id()));
        for (path, text) in files {
            let path = folder.join(path).join("Cargo.toml");
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        folder
    }

    #[test]
    fn the_manifest_of_the_workspace_is_above_the_package_or_named() {
        let shared = "[workspace.dependencies]\nmy-robot.package = \"denhart\"\n";
        let member = "[package]\nname = \"arm\"\n[dependencies]\nmy-robot.workspace = true\n";
        let above = folder("above", &[(".", shared), ("crates/arm", member)]);
        assert_eq!(name(Some(&above.join("crates/arm"))).as_deref(), Some("my_robot"));
        let far = format!("[package]\nworkspace = \"../root\"\n{member}").replace("[package]\nname", "name");
        let named = folder("named", &[("root", shared), ("arm", &far)]);
        assert_eq!(name(Some(&named.join("arm"))).as_deref(), Some("my_robot"));
        for made in [above, named] {
            fs::remove_dir_all(made).unwrap();
        }
    }
}
