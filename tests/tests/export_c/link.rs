//! Compiling, linking, and the symbols that a library shows.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use denhart::{Arm, Jacobian, Pose};

use crate::bits::{Real, pose, shown};
use crate::tools::{cc, command, export, library, prints, program, succeeds};

/// Input and output of the program in C for an arm without inverse: pose, Jacobian, both, and the text `more`.
fn kinematics<const N: usize>(
    q: &[f64; N],
    alone: (Pose<f64>, Jacobian<f64, N>),
    both: (Pose<f64>, Jacobian<f64, N>),
    more: &str,
) -> [String; 2] {
    let input = q.iter().map(|x| format!("{:x} ", x.bits())).collect();
    let [one, two] = [alone, both].map(|(tool, columns)| (pose(&tool), shown(columns.rows.iter().flatten())));
    [input, format!("0{} | 0{} | 0{}{}{more}\n", one.0, one.1, two.0, two.1)]
}

/// An arm without inverse has the kinematics alone; a build without optimization, which is one with it, links too.
#[test]
fn an_arm_without_inverse() {
    #[derive(Default, Arm)]
    #[arm(spec = "../specs/singular_6r.yaml")]
    struct Singular;
    let Some(mut cc) = cc() else { return };
    let folder = export("../specs/singular_6r.yaml", "f64", "without_inverse");
    let library = library(&folder, "singular_6r", "dev");
    let program = program(&mut cc, &folder, "singular_6r", &[], &library);
    let q = [0.1, -0.7, 1.3, 2.0, -1.1, 0.4];
    let [input, expected] =
        kinematics(&q, (Singular.forward(&q), Singular.jacobian(&q)), Singular.forward_and_jacobian(&q), "");
    prints(&program, &input, &expected);
}

/// An arm without inverse that counts pulses; its comments and names are those of C, and its name is one of CMake's.
#[test]
fn an_arm_with_pulses_alone() {
    #[derive(Default, Arm)]
    #[arm(spec = "tests/export_c/test.yaml")]
    struct Pulses;
    let Some(mut cc) = cc() else { return };
    let folder = export("tests/export_c/test.yaml", "f64", "pulses_alone");
    let library = library(&folder, "arm_test", "release");
    let program = program(&mut cc, &folder, "arm_test", &["-DHAS_PULSES"], &library);
    let q = [0.1, -0.7, 1.3, 2.0, -1.1, 1e9];
    let pulses = Pulses.to_pulses(&q);
    let counts: String = pulses.iter().map(|count| format!(" {count}")).collect();
    // The last joint is at the end of what a pulse counter holds.
    let more = format!(" | 0{counts} {}{}", 1 << 5, shown(&Pulses.from_pulses(&pulses)));
    let [input, expected] =
        kinematics(&q, (Pulses.forward(&q), Pulses.jacobian(&q)), Pulses.forward_and_jacobian(&q), &more);
    prints(&program, &input, &expected);
    header_is_clean(&folder, "arm_test");
}

/// The header alone compiles without a warning: as C of several years, for 32 bits, and as C++.
fn header_is_clean(folder: &Path, prefix: &str) {
    let header = folder.join(format!("include/{prefix}.h"));
    let include = folder.join("only_header.c");
    fs::write(&include, format!("#include \"{}\"\nint main(void) {{ return 0; }}\n", header.display())).unwrap();
    let warnings = ["-Wall", "-Wextra", "-Wundef", "-pedantic", "-Werror", "-fsyntax-only"];
    let mut kinds = vec![("cc", vec!["-xc", "-std=c99"]), ("cc", vec!["-xc", "-std=c11", "-Wpadded"])];
    kinds.extend([("c++", vec!["-xc++", "-std=c++11"]), ("c++", vec!["-xc++", "-std=c++20", "-Wpadded"])]);
    if cfg!(target_arch = "x86_64") {
        // `double` is aligned to 4 bytes there.
        kinds.push(("cc", vec!["-xc", "-std=c99", "-m32", "-ffreestanding", "-Wpadded"]));
    }
    for (compiler, arguments) in kinds {
        if let Some(mut command) = command(compiler) {
            succeeds(command.args(arguments).args(warnings).arg(&include));
        }
    }
}

/// The header declares what the library defines, and no other symbol of the library can meet a name of another library.
fn defines_what_it_declares(folder: &Path, prefix: &str, library: &Path) {
    let header = fs::read_to_string(folder.join(format!("include/{prefix}.h"))).unwrap();
    let declared = header.lines().filter_map(|line| line.strip_prefix("int32_t ")?.split('(').next());
    let Some(mut nm) = command("nm") else { return };
    let listed = nm.args(["--extern-only", "--defined-only"]).arg(library).output().unwrap().stdout;
    let listed = String::from_utf8(listed).unwrap();
    let defined = listed.lines().filter_map(|line| match line.split_whitespace().collect::<Vec<_>>()[..] {
        // Weak, or of the routines that compilers share: a linker takes the first.
        [_, "W" | "V" | "w" | "v", _] => None,
        [_, _, name] if name.starts_with("__") => None,
        [_, _, name] => Some(name),
        _ => None,
    });
    assert_eq!(declared.collect::<BTreeSet<_>>(), defined.collect::<BTreeSet<_>>());
}

/// Two arms in one program do not get into each other's way: targets of one in single, of the other in double precision.
#[test]
fn two_arms_in_one_program() {
    let arms = [("anthro3r", "f32"), ("abb_irb140", "f64")];
    let folders = arms.map(|(arm, scalar)| export(&format!("../specs/{arm}.yaml"), scalar, &format!("two_{arm}")));
    let [first, second] = &folders;
    let Some(mut cc) = cc() else { return };
    let main = first.join("two.c");
    fs::write(&main, include_str!("two.c")).unwrap();
    let libraries = [library(first, "anthro3r", "release"), library(second, "abb_irb140", "release")];
    let includes = folders.each_ref().map(|folder| format!("-I{}/include", folder.display()));
    let program = first.join("two");
    succeeds(cc.arg(&main).args(&includes).args(&libraries).arg("-o").arg(&program));
    succeeds(&mut Command::new(&program));
    if let Some(mut cpp) = command("c++") {
        // As C++ the names are those of C.
        let program = first.join("two_cpp");
        cpp.args(["-xc++", "-Wall", "-Werror"]).arg(&main).args(["-xnone"]).args(&includes).args(&libraries);
        succeeds(cpp.arg("-o").arg(&program));
        succeeds(&mut Command::new(&program));
    }
    for ((folder, library), (arm, _)) in folders.iter().zip(&libraries).zip(arms) {
        header_is_clean(folder, arm);
        defines_what_it_declares(folder, arm, library);
    }
}
