//! Every kernel is called with lengths bound at run time.

use super::arms::*;
use super::kernel_arms::*;
use denhart_codegen::{Bound, Options, generate, stages_text};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

macro_rules! texts {
    (() $($Arm:ident $joints:literal $name:literal;)*) => {
        [$(($name, <$Arm as Parametric<$joints>>::YAML)),*]
    };
}

fn source(file: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../codegen/src").join(file)).unwrap()
}

/// The words that follow `before`, up to anything that is no part of a name.
fn names_after(text: &str, before: &str) -> BTreeSet<String> {
    let name = |rest: &str| rest.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap().to_owned();
    text.split(before).skip(1).map(name).collect()
}

/// The variants of `Kernel` are in the plans of these arms: a new one needs an arm here, whose code the other tests
/// compile and compare with the chain.
#[test]
fn every_kernel_is_in_a_plan_with_bound_lengths() {
    let file = syn::parse_file(&source("solve/plan.rs")).unwrap();
    let variants = file.items.iter().find_map(|item| match item {
        syn::Item::Enum(found) if found.ident == "Kernel" => Some(&found.variants),
        _ => None,
    });
    let kernels: BTreeSet<String> = variants.unwrap().iter().map(|variant| variant.ident.to_string()).collect();
    let mut planned = BTreeSet::new();
    for (name, yaml) in arms!(texts) {
        planned.extend(names_after(&stages_text(yaml, name, &Bound::All).unwrap(), " by "));
    }
    assert_eq!(kernels, planned);
}

/// A kernel may have more than one function, such as `pair` and `pair_turning`.
#[test]
fn every_function_of_a_kernel_is_called_with_bound_lengths() {
    let functions = names_after(&source("emit/kernel.rs"), "quote!(#krate::solve::");
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
