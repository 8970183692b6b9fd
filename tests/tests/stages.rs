//! The generator is a pipeline: each stage imports only itself and the stages before it. Within a stage no files import
//! each other in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The stages in the order of the data.
const STAGES: [&str; 7] = ["spec", "model", "symbolic", "kinematics", "solve", "lower", "emit"];

/// Folders without a circle, and the module of the crate that each one is.
const FOLDERS: [(&str, &[&str]); 13] = [
    ("codegen/src/spec", &["spec"]),
    ("codegen/src/model", &["model"]),
    ("codegen/src/symbolic", &["symbolic"]),
    ("codegen/src/kinematics", &["kinematics"]),
    ("codegen/src/solve", &["solve"]),
    ("codegen/src/lower", &["lower"]),
    ("codegen/src/emit", &["emit"]),
    ("runtime/src/solve/kernel", &["solve", "kernel"]),
    ("macros/src", &[]),
    ("cli/src/trace", &["trace"]),
    ("draw/src", &[]),
    ("tools/src", &[]),
    ("tools/src/import", &["import"]),
];

/// Notes every line under `folder` that names one of the `later` stages, as `file:line: text`.
fn later_imports(folder: &Path, later: &[&str], found: &mut Vec<String>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            later_imports(&path, later, found);
            continue;
        }
        for (index, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            let mut words = line.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
            let names = |word: &str| later.iter().any(|stage| word.split("::").take(2).eq(["crate", stage]));
            // A grouped `use crate::{..}` would hide the stage on a line of its own.
            if !line.trim_start().starts_with("//") && (words.any(names) || line.contains("crate::{")) {
                found.push(format!("{}:{}: {}", path.display(), index + 1, line.trim()));
            }
        }
    }
}

#[test]
fn no_stage_imports_a_later_one() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../codegen/src");
    let mut found = Vec::new();
    for (index, stage) in STAGES.iter().enumerate() {
        later_imports(&source.join(stage), &STAGES[index + 1..], &mut found);
    }
    assert!(found.is_empty(), "a stage imports a later one:\n{}", found.join("\n"));
}

/// A module by its path from the folder; the folder itself has none.
type Module = Vec<String>;

/// The text of every module under `folder`, without files of tests.
fn modules(folder: &Path, at: &[String], found: &mut BTreeMap<Module, String>) {
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let mut module = at.to_vec();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if path.is_dir() {
            module.push(name);
            modules(&path, &module, found);
        } else if name != "tests" && path.extension().is_some_and(|extension| extension == "rs") {
            module.extend((!["mod", "lib"].contains(&name.as_str())).then_some(name));
            found.insert(module, fs::read_to_string(&path).unwrap());
        }
    }
}

/// Identifiers, `::` and single characters of some code, without comments, texts and the unit tests at its end.
fn tokens(code: &str) -> Vec<String> {
    let lines: Vec<&str> = code.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
    let tests = (0..lines.len()).find(|index| {
        let mut after = lines[index + 1..].iter().skip_while(|line| line.trim_start().starts_with("#["));
        lines[*index].trim() == "#[cfg(test)]" && after.next().is_some_and(|line| line.ends_with('{'))
    });
    let code = lines[..tests.unwrap_or(lines.len())].join("\n").replace("\\\"", "");
    let mut tokens: Vec<String> = Vec::new();
    for text in code.split('"').step_by(2) {
        let mut last = ' ';
        for c in text.chars() {
            let word = |c: char| c.is_alphanumeric() || c == '_';
            match tokens.last_mut() {
                Some(token) if (word(last) && word(c)) || (last == ':' && c == ':') => token.push(c),
                _ if c.is_whitespace() => {}
                _ => tokens.push(c.to_string()),
            }
            last = c;
        }
    }
    tokens
}

/// The paths in some code, each name of a group by itself, and whether it is re-exported.
fn paths(tokens: &[String]) -> Vec<(Vec<String>, bool)> {
    /// Adds the paths of the tree that begins at a token; gives the token after it.
    fn tree(tokens: &[String], mut at: usize, before: &[String], found: &mut Vec<Vec<String>>) -> usize {
        let mut path = before.to_vec();
        loop {
            let token = tokens.get(at).map_or("", String::as_str);
            if token == "{" {
                at += 1;
                while let Some(token) = tokens.get(at).filter(|token| *token != "}") {
                    at = match token.as_str() {
                        "," => at + 1,
                        "as" => at + 2,
                        _ => tree(tokens, at, &path, found).max(at + 1),
                    };
                }
                return at + 1;
            }
            if !token.starts_with(|c: char| c.is_alphabetic() || c == '_') {
                break;
            }
            path.push(token.to_string());
            at += 1;
            if tokens.get(at).is_none_or(|token| token != "::") {
                break;
            }
            at += 1;
        }
        found.push(path);
        at
    }
    let (mut all, mut at) = (Vec::new(), 0);
    while at < tokens.len() {
        let mut found = Vec::new();
        let before = &tokens[..at];
        let exported = before.ends_with(&["pub".into(), "use".into()]) || before.ends_with(&[")".into(), "use".into()]);
        let begins = tokens.get(at + 1).is_some_and(|token| token == "::");
        let after = if begins { tree(tokens, at, &[], &mut found) } else { at + 1 };
        all.extend(found.into_iter().map(|path| (path, exported)));
        at = after.max(at + 1);
    }
    all
}

/// Where a path of a module leads, from the folder on; `None` out of it. The folder is the module `root` of its crate.
fn target(modules: &BTreeMap<Module, String>, root: &[&str], module: &Module, path: &[String]) -> Option<Module> {
    let mut base = module.clone();
    let mut rest = path;
    match path.first()?.as_str() {
        "crate" => {
            let inside = path.get(1..=root.len())?.iter().eq(root.iter());
            return inside.then(|| path[root.len() + 1..].to_vec());
        }
        "self" => rest = &path[1..],
        "super" => {
            while rest.first().is_some_and(|name| name == "super") {
                base.pop()?;
                rest = &rest[1..];
            }
        }
        child => {
            base.push(child.to_string());
            modules.get(&base)?;
            rest = &path[1..];
        }
    }
    base.extend(rest.iter().cloned());
    Some(base)
}

/// Which module imports which. A name that a module passes on counts as imported from where it stands.
fn imports(modules: &BTreeMap<Module, String>, root: &[&str]) -> BTreeMap<Module, BTreeSet<Module>> {
    let mut passed_on: BTreeMap<Module, Module> = BTreeMap::new();
    let mut all = Vec::new();
    for (module, code) in modules {
        let tokens = tokens(code);
        for (path, exported) in paths(&tokens) {
            let (Some(target), Some(name)) = (target(modules, root, module, &path), path.last()) else { continue };
            // What a module passes on and uses itself, it imports. A module of the same name is another thing.
            let is_module = modules.contains_key(&[module.as_slice(), std::slice::from_ref(name)].concat());
            let stands = |at: &usize| {
                let around =
                    |at: Option<usize>, sign: &str| at.and_then(|at| tokens.get(at)).is_some_and(|x| x == sign);
                let names_module = around(at.checked_sub(1), "mod") || is_module && around(Some(at + 1), "::");
                tokens[*at] == *name && !names_module
            };
            let used = (0..tokens.len()).filter(stands).count() > 1;
            if exported {
                passed_on.insert([module.as_slice(), std::slice::from_ref(name)].concat(), target.clone());
            }
            if !exported || used {
                all.push((module.clone(), target));
            }
        }
    }
    let mut edges: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
    for (module, mut target) in all {
        // The module that the path leads into; from there on where the name comes from that it passes on.
        loop {
            let end = (0..=target.len()).rev().find(|end| modules.contains_key(&target[..*end])).unwrap_or(0);
            match target.get(..=end).and_then(|name| passed_on.get(name)) {
                Some(origin) if !origin.starts_with(&target) => {
                    target = [origin.as_slice(), &target[end + 1..]].concat();
                }
                _ => {
                    target.truncate(end);
                    break;
                }
            }
        }
        if target != module {
            edges.entry(module).or_default().insert(target);
        }
    }
    edges
}

/// A circle of imports, if there is one: its modules in order, the first one again at its end.
fn circle(edges: &BTreeMap<Module, BTreeSet<Module>>) -> Option<Vec<Module>> {
    fn visit(
        edges: &BTreeMap<Module, BTreeSet<Module>>,
        module: &Module,
        way: &mut Vec<Module>,
        done: &mut BTreeSet<Module>,
    ) -> Option<Vec<Module>> {
        if let Some(start) = way.iter().position(|before| before == module) {
            return Some([&way[start..], std::slice::from_ref(module)].concat());
        }
        if done.contains(module) {
            return None;
        }
        way.push(module.clone());
        let found = edges.get(module).into_iter().flatten().find_map(|next| visit(edges, next, way, done));
        way.pop();
        done.insert(module.clone());
        found
    }
    let mut done = BTreeSet::new();
    edges.keys().find_map(|module| visit(edges, module, &mut Vec::new(), &mut done))
}

fn written(circle: &[Module]) -> String {
    circle.iter().map(|module| format!("{}.rs", module.join("/"))).collect::<Vec<_>>().join(" -> ")
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, root) in FOLDERS {
        let mut found = BTreeMap::new();
        modules(&repository.join(folder), &[], &mut found);
        let edges = imports(&found, root);
        assert!(found.len() < 3 || edges.len() > 1, "{folder}: no imports seen");
        let circle = circle(&edges).map(|circle| written(&circle));
        assert_eq!(circle, None, "{folder}");
    }
}

/// The circle among made-up files of the module `crate::plan`, each by its name; `mod` is that of the folder.
fn planted(files: &[(&str, &str)]) -> Option<String> {
    let name = |name: &str| if name == "mod" { Vec::new() } else { vec![name.to_string()] };
    let modules = files.iter().map(|(file, code)| (name(file), code.to_string())).collect();
    circle(&imports(&modules, &["plan"])).map(|circle| written(&circle))
}

#[test]
fn a_planted_circle_is_found() {
    let head = ("mod", "mod a;\nmod b;\npub use a::{A, Other};\npub use b::B;");
    let a = ("a", "use super::b::{self, C};\npub struct A;");
    // Through a name that the folder passes on, in a path, and in a path from the crate.
    for b in ["use super::{A, B as Mine};", "fn f() { super::a::g() }", "use crate::plan::a::A;"] {
        assert_eq!(planted(&[head, a, ("b", b)]).as_deref(), Some("a.rs -> b.rs -> a.rs"), "{b}");
    }
    for b in [
        "// use super::A;",
        "fn f() -> &'static str { \"super::a::A\" }",
        "use crate::other::a::A;",
        "#[cfg(test)]\nmod tests {\n    use super::super::A;\n}",
    ] {
        assert_eq!(planted(&[head, a, ("b", b)]), None, "{b}");
    }
    // A folder that uses what it passes on imports it.
    for own in ["fn f(a: A) {}", "fn f() { A::new() }"] {
        let head = format!("mod a;\npub use a::A;\npub struct Shared;\n{own}");
        let planted = planted(&[("mod", &head), ("a", "use super::Shared;")]);
        assert_eq!(planted.as_deref(), Some(".rs -> a.rs -> .rs"), "{own}");
    }
}
