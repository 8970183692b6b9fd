//! Every kernel is called with lengths bound at run time.

use super::arms::*;
use super::kernel_arms::*;
use denhart_codegen::{Bound, Options, generate, stages_text};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

macro_rules! texts {
    (() $($Arm:ident $joints:literal $name:literal;)*) => {
        [$(($name, <$Arm as Parametric<$joints>>::YAML)),*]
    };
}

fn source(file: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file)).unwrap()
}

/// All files of a folder and of those in it, one after the other.
fn sources(folder: &str) -> String {
    let files = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder)).unwrap();
    let text = |path: PathBuf| {
        if path.is_dir() {
            sources(&format!("{folder}/{}", path.file_name().unwrap().display()))
        } else {
            fs::read_to_string(path).unwrap()
        }
    };
    files.map(|file| text(file.unwrap().path())).collect()
}

/// The words that follow `before`, up to anything that is no part of a name.
fn names_after(text: &str, before: &str) -> BTreeSet<String> {
    let name = |rest: &str| rest.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap().to_owned();
    text.split(before).skip(1).map(name).collect()
}

/// The variants of `Kernel` are in the plans of these arms. A new variant needs an arm here, whose code the other tests
/// compile and compare with the chain.
#[test]
fn every_kernel_is_in_a_plan_with_bound_lengths() {
    let list = source("codegen/src/solve/kernel/mod.rs");
    let list = list.split("\nkernels!(").nth(1).and_then(|rest| rest.split(')').next()).unwrap();
    let names = list.split(',').map(|name| name.trim().to_owned());
    let kernels: BTreeSet<String> = names.filter(|name| !name.is_empty()).collect();
    assert!(kernels.len() >= 14, "{kernels:?}");
    let mut planned = BTreeSet::new();
    for (name, yaml) in arms!(texts) {
        planned.extend(names_after(&stages_text(yaml, name, &Bound::All).unwrap(), " by "));
    }
    assert_eq!(kernels, planned);
}

/// A kernel may have more than one function, such as `pair` and `pair_turning`.
#[test]
fn every_function_of_a_kernel_is_called_with_bound_lengths() {
    // What of the runtime a kernel's file names, and what the code around their calls names.
    let runtime = sources("runtime/src/solve");
    let known = &names_after(&runtime, "\npub fn ") | &names_after(&runtime, "\npub struct ");
    let kernels = sources("codegen/src/solve/kernel");
    let texts = kernels.split('"').skip(1).step_by(2).map(str::to_owned);
    let mut functions: BTreeSet<String> = texts.filter(|text| known.contains(text)).collect();
    functions.extend(names_after(&source("codegen/src/emit/kernel.rs"), "#krate::solve::"));
    functions.remove("");
    assert!(functions.contains("pair_turning") && functions.len() >= 15, "{functions:?}");
    let mut called = BTreeSet::new();
    for (name, yaml) in arms!(texts) {
        let options = Options { bound: Bound::All, ..Options::new("Robot") };
        let code = generate(yaml, name, &options).unwrap().to_file().unwrap();
        called.extend(names_after(&code, "solve::"));
        // A type is imported, because the code has it.
        let imported = code.split("use ::denhart::solve::").nth(1).and_then(|rest| rest.split(';').next());
        let names = imported.unwrap_or_default().split(|c: char| !(c.is_alphanumeric() || c == '_'));
        called.extend(names.map(str::to_owned));
    }
    let missing: Vec<&String> = functions.difference(&called).collect();
    assert!(missing.is_empty(), "no arm calls {missing:?}");
}
