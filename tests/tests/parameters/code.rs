//! The generated code of arms with parameters.

use denhart_codegen::{Bound, Builder, Options, generate};
use std::fs;
use std::path::PathBuf;

const NAMED: &str = "\
name: planar
convention: standard
units: {length: m, angle: deg}
parameters: {l1: 0.5, Len2: 0.25}
joints:
  - {type: revolute, a: l1, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: -2*Len2, alpha: 0, d: l1, theta: 0}
tool: {xyz: [0, Len2/2, 0]}
";

/// The file with numbers in place of the names.
fn numbers() -> String {
    NAMED
        .replace("parameters: {l1: 0.5, Len2: 0.25}\n", "")
        .replace("-2*Len2", "-0.5")
        .replace("Len2/2", "0.125")
        .replace("l1", "0.5")
}

fn impls(text: &str, bound: Bound) -> String {
    generate(text, "f", &Options { bound, ..Options::new("Robot") }).unwrap().impls.to_string()
}

#[test]
fn without_fields_the_code_is_that_of_the_numbers() {
    assert_eq!(impls(NAMED, Bound::None), impls(&numbers(), Bound::None));
    assert_ne!(impls(NAMED, Bound::All), impls(&numbers(), Bound::None));
    // A parameter that is not bound is a number in the code of the others too.
    let half = impls(NAMED, Bound::Fields(vec!["l1".into()]));
    assert_eq!(
        half,
        impls(&NAMED.replace("-2*Len2", "-0.5").replace("Len2/2", "0.125"), Bound::Fields(vec!["l1".into()]))
    );
}

fn written(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("denhart-parameters-{name}-{}.yaml", std::process::id()));
    fs::write(&path, NAMED).unwrap();
    path
}

#[test]
fn a_written_struct_has_the_fields_when_asked() {
    let path = written("builder");
    let folded = Builder::new(&path).type_name("Robot").generate().unwrap();
    assert!(folded.contains("pub struct Robot;") && !folded.contains("self.l1"), "{folded}");
    let bound = Builder::new(&path).type_name("Robot").runtime_parameters(true).generate().unwrap();
    let structure = "\
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(non_snake_case, reason = \"the names of the arm file\")]
pub struct Robot {
    /// Parameter `l1`: `a` of row 1, `d` of row 2, m; 0.5 in the arm file.
    pub l1: f64,
    /// Parameter `Len2`: `a` of row 2 times -2, `y` of the tool times 0.5, m; 0.25 in the arm file.
    pub Len2: f64,
}
/// The arm with the parameters at the values of its file.
impl ::core::default::Default for Robot {
";
    assert!(bound.contains(structure), "{bound}");
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let file = path.to_str().unwrap();
    let status = denhart_cli::run(["denhart", "expand", file, "--type", "Robot", "--parameters"], &mut out, &mut err);
    assert_eq!((status, String::from_utf8(out).unwrap()), (0, bound));
    fs::remove_file(path).unwrap();
}
