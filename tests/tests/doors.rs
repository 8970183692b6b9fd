//! Three doors, one generator: the derive, `Builder` and `denhart expand` give the same code, and a written file
//! compiles where it must.
//! (That the derive emits the generator's impls token for token is tested in the package denhart-macros.)
#![allow(clippy::unwrap_used)]

mod user_crate;

use std::fs;
use std::path::PathBuf;

use denhart_codegen::{Builder, Options, ScalarKind, generate};
use user_crate::{UserCrate, root};

fn specs() -> Vec<PathBuf> {
    let mut files: Vec<_> = fs::read_dir(root().join("specs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "yaml"));
    files.sort();
    assert!(files.len() >= 53, "{} arms", files.len());
    files
}

fn expand(arguments: &[&str]) -> String {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = denhart_cli::run([&["denhart", "expand"], arguments].concat(), &mut out, &mut err);
    assert_eq!((status, String::from_utf8(err).unwrap()), (0, String::new()));
    String::from_utf8(out).unwrap()
}

#[test]
fn the_builder_and_the_command_write_the_same() {
    for path in specs() {
        let file = path.to_str().unwrap();
        let written = Builder::new(file).type_name("Robot").generate().unwrap();
        assert_eq!(expand(&[file, "--type", "Robot"]), written, "{file}");
    }
    let ur5 = root().join("specs/ur5.yaml");
    let file = ur5.to_str().unwrap();
    assert_eq!(expand(&[file]), Builder::new(file).type_name("Ur5").generate().unwrap());
    assert_eq!(expand(&[file, "--scalar", "f32"]), Builder::new(file).scalar("f32").generate().unwrap());
}

/// The written file is the struct and then the impls that the derive emits, formatted.
#[test]
fn a_written_file_is_the_struct_and_the_impls_of_the_derive() {
    for path in specs() {
        let file = path.to_str().unwrap();
        for (scalar, kind) in [("f64", ScalarKind::F64), ("f32", ScalarKind::F32)] {
            let options = Options { scalar: kind, ..Options::new("Robot") };
            let impls = generate(&fs::read_to_string(&path).unwrap(), file, &options).unwrap().impls;
            let impls = prettyplease::unparse(&syn::parse2(impls).unwrap());
            let written = Builder::new(file).type_name("Robot").scalar(scalar).generate().unwrap();
            let mut written = syn::parse_file(&written).unwrap();
            assert!(written.attrs.is_empty(), "{file}: an inner attribute");
            let first = written.items.remove(0);
            assert!(matches!(first, syn::Item::Struct(robot) if robot.ident == "Robot"), "{file}");
            assert_eq!(prettyplease::unparse(&written), impls, "{file}");
        }
    }
}

/// A build script, a derive of a renamed dependency, and the code of both at work.
#[test]
fn a_build_script_and_a_derive_give_one_arm() {
    let user = UserCrate::new(
        "three_doors",
        r#"
[dependencies]
kinematics = { package = "denhart", path = "$ROOT/runtime", default-features = false, features = ["std", "derive"] }
[build-dependencies]
denhart-codegen = { path = "$ROOT/codegen" }
"#,
    );
    user.write("specs/ur5.yaml", &fs::read_to_string(root().join("specs/ur5.yaml")).unwrap());
    user.write(
        "build.rs",
        r#"
fn main() -> Result<(), denhart_codegen::BuildError> {
    denhart_codegen::Builder::new("specs/ur5.yaml")
        .type_name("Written")
        .crate_path("::kinematics")
        .write_to_out_dir("ur5.rs")
}
"#,
    );
    user.write(
        "src/main.rs",
        r#"
#![deny(warnings)]
mod written {
    include!(concat!(env!("OUT_DIR"), "/ur5.rs"));
}
use written::Written;

#[derive(kinematics::Arm)]
#[arm(spec = "specs/ur5.yaml", crate = "::kinematics")]
struct Derived;

fn main() {
    let q = [0.1, -0.7, 1.3, 0.4, -1.1, 2.9];
    let target = Derived.forward(&q);
    assert_eq!(target, Written.forward(&q));
    assert_eq!(Derived.forward_and_jacobian(&q), Written.forward_and_jacobian(&q));
    assert_eq!(Derived.inverse(&target), Written.inverse(&target));
    println!("{}", Derived.inverse(&target).len());
}
"#,
    );
    assert_eq!(user.succeeds(&["run"]), "8\n");

    // A mistake in the file fails the build script with the text of the mistake, as it is meant to be read.
    let text = fs::read_to_string(root().join("specs/ur5.yaml")).unwrap();
    user.write("specs/ur5.yaml", &text.replace("standard", "standrad"));
    let errors = user.fails(&["run"]);
    assert!(errors.contains("Error: specs/ur5.yaml:4:13: "), "{errors}");
    assert!(errors.contains("help: did you mean `standard`?"), "{errors}");
}

/// A package that renames the crate and does not say so is told that, and nothing else.
#[test]
fn a_renamed_crate_that_is_not_named_is_one_mistake() {
    let path = "path = \"$ROOT/runtime\"";
    for (name, dependencies) in [
        ("renamed_inline", format!("[dependencies]\nrobot = {{ package = \"denhart\", {path} }}\n")),
        ("renamed_dotted", format!("[dependencies]\nrobot.package = \"denhart\"\nrobot.{path}\n")),
        (
            "renamed_workspace",
            format!(
                "[dependencies]\nrobot.workspace = true\n[workspace.dependencies]\n\
                 robot = {{ package = \"denhart\", {path} }}\n"
            ),
        ),
    ] {
        let user = UserCrate::new(name, &dependencies);
        user.write("ur5.yaml", &fs::read_to_string(root().join("specs/ur5.yaml")).unwrap());
        let code = "use robot::Arm;\n#[derive(Arm)]\n#[arm(spec = \"ur5.yaml\")]\nstruct Ur5;\n\
                    fn main() {\n    println!(\"{}\", Ur5.inverse(&Ur5.forward(&[0.1; 6])).len());\n}\n";
        user.write("src/main.rs", code);
        let errors = user.fails(&["check"]);
        let said: Vec<&str> = errors.lines().filter(|line| line.starts_with("error")).collect();
        let expected = "error: the Cargo.toml of this package calls the crate denhart `robot`";
        assert!(matches!(said[..], [one, last] if one == expected && last.contains("could not compile")), "{errors}");
        assert!(errors.contains("help: add `crate = \"::robot\"` to #[arm(..)]"), "{errors}");
        user.write("src/main.rs", &code.replace("yaml\")", "yaml\", crate = \"::robot\")"));
        user.succeeds(&["check"]);
    }
}

const NO_STD: &str = "\
//! Arms, written by the generator.
#![no_std]
#![deny(warnings, missing_docs, clippy::all, clippy::unwrap_used, clippy::panic)]

// If anything linked `std`, this handler would be the second one.
#[panic_handler]
fn halt(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
";

/// Six joints, every kind of length a parameter, one of them not named as Rust would.
const NAMED: &str = "\
name: named
convention: standard
units: {length: m, angle: deg}
parameters: {d1: 0.67, a2: 0.43, Off3: 0.02, d4: 0.43, height: 0.5, tip: 0.1}
joints:
  - {type: revolute, a: 0, alpha: 90, d: d1, theta: 0}
  - {type: revolute, a: -a2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: Off3, alpha: -90, d: 2*Off3, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: d4, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0}
base: {xyz: [0, 0, height/2]}
tool: {xyz: [0, 0, tip]}
";

/// No `std`, no default feature, nothing but `denhart`; and nothing that rustc or clippy would warn of.
#[test]
fn written_files_compile_without_std() {
    let user = UserCrate::new(
        "without_std",
        r#"
[dependencies]
denhart = { path = "$ROOT/runtime", default-features = false }
[features]
libm = ["denhart/libm"]
[profile.dev]
panic = "abort"
"#,
    );
    let mut library = NO_STD.to_owned();
    for path in specs() {
        let arm = path.file_stem().unwrap().to_str().unwrap().to_owned();
        for scalar in ["f64", "f32"] {
            let module = format!("{arm}_{scalar}");
            user.write(&format!("src/{module}.rs"), &Builder::new(&path).scalar(scalar).generate().unwrap());
            library += &format!("/// The arm {arm}.\npub mod {module} {{\n    include!(\"{module}.rs\");\n}}\n");
        }
    }
    let named = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("named.yaml");
    fs::write(&named, NAMED).unwrap();
    for scalar in ["f64", "f32"] {
        let builder = Builder::new(&named).scalar(scalar).runtime_parameters(true);
        user.write(&format!("src/named_{scalar}.rs"), &builder.generate().unwrap());
        library += &format!(
            "/// Lengths bound at run time.\npub mod named_{scalar} {{\n    include!(\"named_{scalar}.rs\");\n}}\n"
        );
    }
    user.write("src/lib.rs", &library);
    user.succeeds(&["clippy"]);
    user.succeeds(&["clippy", "--features", "libm"]);
}
