//! The expansion as tokens. What rustc makes of it is tested in the package denhart-tests.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::{Path, PathBuf};

use denhart_codegen::{Bound, Options, ScalarKind};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{File, Item, LitStr};

use crate::expand::expand;
use crate::fallback::Outline;

const PLANAR: &str = "\
name: planar
convention: standard
units: {length: m, angle: deg}
joints:
  - {type: revolute, a: 1, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 1, alpha: 0, d: 0, theta: 0}
";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().unwrap()
}

fn derive(input: TokenStream) -> File {
    syn::parse2(expand(&syn::parse2(input).unwrap(), Some(&root()))).unwrap()
}

/// The texts of the errors, in order.
fn errors(input: TokenStream) -> Vec<String> {
    let texts = derive(input).items.into_iter().filter_map(|item| match item {
        Item::Macro(item) if item.mac.path.segments.last().is_some_and(|name| name.ident == "compile_error") => {
            Some(item.mac.parse_body::<LitStr>().unwrap().value())
        }
        _ => None,
    });
    texts.map(|text| text.replace(&root().display().to_string(), "$ROOT")).collect()
}

#[test]
fn the_impls_are_those_of_the_generator() {
    for (scalar, kind) in [("f64", ScalarKind::F64), ("f32", ScalarKind::F32)] {
        for arm in ["ur5", "planar2r", "stanford"] {
            let file = format!("specs/{arm}.yaml");
            let input = quote!(
                #[arm(spec = #file, scalar = #scalar, crate = "crate::kinematics")]
                struct Robot;
            );
            let options = Options {
                type_name: "Robot".to_owned(),
                scalar: kind,
                crate_path: syn::parse_quote!(crate::kinematics),
                bound: Bound::None,
                batch: false,
            };
            let text = std::fs::read_to_string(root().join(&file)).unwrap();
            let impls = denhart_codegen::generate(&text, &file, &options).unwrap().impls;
            let rebuild = quote! {
                const _: &[::core::primitive::u8] =
                    ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #file));
            };
            let derived = expand(&syn::parse2(input).unwrap(), Some(&root()));
            assert_eq!(derived.to_string(), quote!(#rebuild #impls).to_string());
        }
    }
}

#[test]
fn an_inline_arm_needs_no_file() {
    let derived = expand(
        &syn::parse2(quote!(
            #[arm(yaml = #PLANAR)]
            struct Planar;
        ))
        .unwrap(),
        None,
    )
    .to_string();
    assert!(!derived.contains("compile_error") && !derived.contains("include_bytes"), "{derived}");
    assert!(derived.contains("impl Planar"), "{derived}");
}

#[test]
fn advice_is_shown_only_when_asked_for() {
    let bent = PLANAR.replacen("alpha: 0", "alpha: 1.5708 rad", 1);
    let silent = expand(
        &syn::parse2(quote!(
            #[arm(yaml = #bent)]
            struct Bent;
        ))
        .unwrap(),
        None,
    )
    .to_string();
    assert!(!silent.contains("deprecated"), "{silent}");
    let warned = expand(
        &syn::parse2(quote!(
            #[arm(yaml = #bent, warn)]
            struct Bent;
        ))
        .unwrap(),
        None,
    )
    .to_string();
    assert!(warned.contains("# [deprecated (note = \"<inline>:5:"), "{warned}");
}

#[test]
fn a_missing_file_is_named_and_the_nearest_suggested() {
    assert_eq!(
        errors(quote!(
            #[arm(spec = "specs/pumma560.yaml")]
            struct Puma;
        )),
        ["no arm file at `$ROOT/specs/pumma560.yaml`\nhelp: did you mean `specs/puma560.yaml`?"]
    );
}

#[test]
fn every_mistake_of_the_attribute_and_of_the_struct_is_told() {
    let inline = quote!(yaml = #PLANAR);
    for (input, expected) in [
        (
            quote!(
                struct A;
            ),
            &["#[derive(Arm)] needs to know the arm\nhelp: add #[arm(spec = \"specs/arm.yaml\")]"][..],
        ),
        (
            quote!(
                #[arm(scalar = "f32")]
                struct A;
            ),
            &["no arm file is named\nhelp: add `spec = \"specs/arm.yaml\"`, or `yaml = \"...\"` with its text"],
        ),
        (
            quote!(
                #[arm(file = "ur5.yaml", scalar = "f16")]
                struct A;
            ),
            &[
                "unknown key\nhelp: the keys of #[arm(..)] are `spec`, `yaml`, `scalar`, `crate`, `batch` and `warn`",
                "unknown scalar `f16`\nhelp: write `f64` or `f32`",
            ],
        ),
        (
            quote!(
                #[arm(#inline, batch = true)]
                struct A;
            ),
            &["`batch` takes no value\nhelp: write `batch` alone"],
        ),
        (
            quote!(
                #[arm(#inline, spec = "specs/ur5.yaml")]
                struct A;
            ),
            &["`yaml` beside `spec`: an arm has one of them"],
        ),
        (
            quote!(
                #[arm(#inline, #inline)]
                struct A;
            ),
            &["this key is given twice"],
        ),
        (
            quote!(
                #[arm(#inline)]
                #[arm(warn)]
                #[arm(warn)]
                struct A;
            ),
            &["`warn` is given twice"],
        ),
        (
            quote!(
                #[arm(#inline, crate = "den hart")]
                struct A;
            ),
            &["not a path to the crate denhart\nhelp: write a path, such as `crate = \"::denhart\"`"],
        ),
        (
            quote!(
                #[arm(spec = 5)]
                struct A;
            ),
            &["not a text\nhelp: write `spec = \"5\"`, in quotes"],
        ),
        (
            quote!(
                #[arm(#inline)]
                struct A {
                    x: f64,
                    y: f64,
                }
            ),
            &[
                "a field binds the run-time parameter of its name, and the arm file has no parameter `x`\nhelp: write `struct A;`",
                "a field binds the run-time parameter of its name, and the arm file has no parameter `y`\nhelp: write `struct A;`",
            ],
        ),
        (
            quote!(
                #[arm(#inline)]
                struct A(f64);
            ),
            &["a field binds the run-time parameter of its name, and this field has no name\nhelp: write `struct A;`"],
        ),
        (
            quote!(
                #[arm(#inline)]
                enum A {}
            ),
            &["an arm is a struct, not an enum\nhelp: write `struct A;`"],
        ),
        (quote!(#[arm(#inline)] union A { x: f64 }), &["an arm is a struct, not a union\nhelp: write `struct A;`"]),
        (
            quote!(
                #[arm(#inline)]
                struct A<'a>;
            ),
            &["an arm is one type: it has no parameters\nhelp: write `struct A;`"],
        ),
    ] {
        assert_eq!(errors(input.clone()), expected, "{input}");
    }
}

/// Two links whose lengths have names.
const NAMED: &str = "\
name: planar
convention: standard
units: {length: m, angle: deg}
parameters: {l2: 1, l3: 2}
joints:
  - {type: revolute, a: l2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l3, alpha: 0, d: 0, theta: 0}
";

#[test]
fn a_field_binds_the_parameter_of_its_name() {
    for (fields, bound) in [
        (quote!(;), Bound::None),
        (quote!({}), Bound::None),
        (quote!({ l3: f64 }), Bound::Fields(vec!["l3".into()])),
        (quote!({ pub l2: core::primitive::f64, l3: Length }), Bound::Fields(vec!["l2".into(), "l3".into()])),
    ] {
        let input = quote!(
            #[arm(yaml = #NAMED)]
            struct Robot #fields
        );
        let impls =
            denhart_codegen::generate(NAMED, "<inline>", &Options { bound, ..Options::new("Robot") }).unwrap().impls;
        assert_eq!(expand(&syn::parse2(input).unwrap(), None).to_string(), impls.to_string(), "{fields}");
    }
}

#[test]
fn a_field_that_binds_nothing_is_told() {
    let of = |fields: TokenStream| {
        errors(quote!(
            #[arm(yaml = #NAMED)]
            struct A #fields
        ))
    };
    let none = "a field binds the run-time parameter of its name, and the arm file has no parameter";
    assert_eq!(
        of(quote!({ l2: f64, length: f64, l4: f64 })),
        [
            format!("{none} `length`\nhelp: write `struct A {{ l2: f64, l3: f64 }}`, or fewer fields, or `struct A;`"),
            format!("{none} `l4`\nhelp: did you mean `l2`? the parameters are l2, l3"),
        ]
    );
    assert_eq!(
        of(quote!((f64);)),
        ["a field binds the run-time parameter of its name, and this field has no name\n\
          help: write `struct A { l2: f64, l3: f64 }`, or fewer fields, or `struct A;`"]
    );
    let scalar = "is of the arm's scalar type, f64\nhelp: write";
    assert_eq!(
        of(quote!({ l2: f32, l3: Option<f64> })),
        [
            format!("the parameter `l2` {scalar} `l2: f64`, or `scalar = \"f32\"` in #[arm(..)]"),
            format!("the parameter `l3` {scalar} `l3: f64`"),
        ]
    );
    assert_eq!(of(quote!({ l2: usize, l3: [f64; 1] })).len(), 2);
    // The calls of a struct with a wrong field still compile.
    let input = quote!(
        #[arm(yaml = #NAMED)]
        struct A {
            l2: f64,
            l4: f64,
        }
    );
    let derived = expand(&syn::parse2(input).unwrap(), None).to_string();
    assert!(derived.contains("fn forward") && !derived.contains("self . l"), "{derived}");
}

#[test]
fn mistakes_of_all_kinds_come_together() {
    let broken = PLANAR.replace("standard", "standrad");
    let texts = errors(quote!(
        #[arm(yaml = #broken, color = "red")]
        struct A {
            x: f64,
        }
    ));
    assert_eq!(texts.len(), 3, "{texts:?}");
    assert!(texts.iter().any(|text| text.starts_with("<inline>:2:13: ")), "{texts:?}");
}

#[test]
fn without_cargo_a_path_starts_nowhere() {
    let input = syn::parse2(quote!(
        #[arm(spec = "specs/ur5.yaml")]
        struct Ur5;
    ))
    .unwrap();
    assert!(expand(&input, None).to_string().contains("CARGO_MANIFEST_DIR is not set"));
}

#[test]
fn a_renamed_crate_is_the_only_mistake() {
    let package = std::env::temp_dir().join(format!("denhart_renamed_{}", std::process::id()));
    std::fs::create_dir_all(&package).unwrap();
    std::fs::write(package.join("Cargo.toml"), "[dependencies]\nmy-robot = { package = \"denhart\" }\n").unwrap();
    let derived = |arm: TokenStream| {
        let input = syn::parse2(quote!(
            #arm
            struct A;
        ));
        expand(&input.unwrap(), Some(&package)).to_string()
    };
    let broken = PLANAR.replace("standard", "standrad");
    for (text, mistakes) in [(PLANAR, 1), (broken.as_str(), 2)] {
        let found = derived(quote!(#[arm(yaml = #text)]));
        assert!(found.contains("add `crate = \\\"::my_robot\\\"` to #[arm(..)]"), "{found}");
        assert_eq!(found.matches("compile_error").count(), mistakes, "{found}");
        // No path to a crate that the package does not have.
        assert!(!found.contains(":: denhart ::") && found.contains(":: my_robot ::"), "{found}");
    }
    let named = derived(quote!(#[arm(yaml = #PLANAR, crate = "::my_robot")]));
    assert!(!named.contains("compile_error"), "{named}");
    std::fs::remove_dir_all(package).unwrap();
}

#[test]
fn the_outline_of_a_file_is_seen_without_a_reader_of_yaml() {
    let outline = |text: &str| Outline::of(text);
    let of = |joints: Option<usize>, task: Option<&str>| Outline {
        joints,
        task: task.map(str::to_owned),
        ..Outline::default()
    };
    assert_eq!(outline(PLANAR), of(Some(2), None));
    assert_eq!(outline(""), of(None, None));
    assert_eq!(outline("inverse: {task: position_axis, axis: z}\njoints: ]["), of(None, Some("position_axis")));
    let broken = "joints:\n  - a: 1\n    type: fixed\n  # - {a: 1}\n  - {a: 1, type: [}\n  - d: 1\n    limits:\n      - 1\n      - 2\n";
    assert_eq!(outline(broken), of(Some(2), None));
    let given = |text: &str| (outline(text).redundant, outline(text).is_list);
    assert_eq!(given("inverse: {redundant: q3}"), (true, false));
    assert_eq!(given("inverse: {redundant: [q1, q3]}"), (true, true));
    assert_eq!(given("inverse:\n  redundant:\n    - q1\n"), (true, true));
}
