//! A package that has `denhart` under another name has to say so: a macro cannot see what a dependency is called.

use std::fs;
use std::path::Path;

use proc_macro2::Span;
use syn::Error;

/// The mistake of a package whose manifest renames `denhart`, where the attribute does not name the crate.
pub fn mistake(package: Option<&Path>) -> Option<Error> {
    let manifest = fs::read_to_string(package?.join("Cargo.toml")).ok()?;
    let name = renamed(&manifest)?.replace('-', "_");
    let text = format!(
        "the Cargo.toml of this package calls the crate denhart `{name}`\nhelp: add `crate = \"::{name}\"` to #[arm(..)]"
    );
    Some(Error::new(Span::call_site(), text))
}

/// The name of the dependency on the package `denhart`, if that is another one: `robot` of
/// `robot = { package = "denhart", .. }`.
fn renamed(manifest: &str) -> Option<String> {
    let plain: Vec<String> = manifest.lines().map(|line| line.split_whitespace().collect()).collect();
    let own = |line: &String| {
        ["denhart=", "denhart.", "[dependencies.denhart]", "[dev-dependencies.denhart]"]
            .iter()
            .any(|start| line.starts_with(start))
            || line == "name=\"denhart\""
    };
    if plain.iter().any(own) {
        return None;
    }
    let at = plain.iter().position(|line| line.contains("package=\"denhart\""))?;
    let line = plain.get(at)?;
    if !line.starts_with("package=") {
        return line.split_once("={").map(|(name, _)| name.trim_matches('"').to_owned());
    }
    // A table of its own: [dependencies.robot]
    let header = plain.iter().take(at).rev().find(|line| line.starts_with('['))?;
    header.trim_matches(['[', ']']).rsplit_once('.').map(|(_, name)| name.trim_matches('"').to_owned())
}

#[cfg(test)]
mod tests {
    use super::renamed;

    #[test]
    fn the_name_in_the_manifest() {
        for (manifest, name) in [
            ("[dependencies]\nrobot = { package = \"denhart\", path = \"..\" }\n", Some("robot")),
            ("[dependencies.my-arm]\nversion = \"1\"\npackage = \"denhart\"\n", Some("my-arm")),
            ("[dependencies]\ndenhart = \"0.1\"\n", None),
            ("[dependencies]\ndenhart.workspace = true\nold = { package = \"denhart\", version = \"0.0\" }\n", None),
            ("[dependencies]\nserde = \"1\"\n", None),
            ("[package]\nname = \"denhart\"\n", None),
        ] {
            assert_eq!(renamed(manifest).as_deref(), name, "{manifest}");
        }
    }
}
