//! `denhart export c`: a program in C that calls the library of an arm prints the bits that Rust computes, for every task
//! and both scalars.
#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use denhart::{
    Arm, Flags, InverseKinematics, JointKind, PlanarPose, PointAngle, PointAxis, Pose, Scalar, Solution, Solutions,
    Status,
};
use denhart_tests::random::Random;

/// Cases of an arm.
const CASES: usize = 120;

/// The folder of this repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The command, which has to succeed unless `refused` is what it says.
fn denhart(arguments: &[&str], refused: Option<&str>) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let status = denhart_cli::run([&["denhart"], arguments].concat(), &mut out, &mut err);
    let err = String::from_utf8(err).unwrap();
    match refused {
        None => assert_eq!((status, err.as_str()), (0, "")),
        Some(says) => assert!(status != 0 && err.contains(says), "{status}: {err}"),
    }
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("export").join(name)
}

/// Exports the arm anew.
fn export(spec: &str, scalar: &str, name: &str) -> PathBuf {
    let folder = folder(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    let (output, spec) = (folder.to_str().unwrap(), root().join("tests").join(spec));
    let runtime = root().join("runtime");
    let place = ["--crate-path", runtime.to_str().unwrap()];
    denhart(&[&["export", "c", spec.to_str().unwrap(), "-o", output, "--scalar", scalar], &place[..]].concat(), None);
    // The versions of this repository: no newer ones are looked for.
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    folder
}

/// The compiler, if there is one.
fn cc() -> Option<Command> {
    let found = Command::new("cc").arg("--version").stdout(Stdio::null()).status().is_ok_and(|status| status.success());
    if !found {
        println!("skipped: there is no C compiler `cc`");
    }
    found.then(|| Command::new("cc"))
}

fn succeeds(command: &mut Command) {
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}:\n{said}");
}

/// Builds the library of an exported arm by a profile of cargo; returns it.
fn library(folder: &Path, prefix: &str, profile: &str) -> PathBuf {
    let target = self::folder("target");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--profile", profile]).current_dir(folder).env("CARGO_TARGET_DIR", &target);
    succeeds(cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS"));
    let built = if profile == "dev" { "debug" } else { profile };
    let library = target.join(built).join(format!("lib{prefix}_c.a"));
    // The next arm may have the same name.
    let kept = folder.join(format!("{profile}.a"));
    fs::copy(library, &kept).unwrap();
    kept
}

/// A number by its bits; one that is none is `nan`, since its bits are nobody's promise.
trait Real: Scalar {
    fn bits(self) -> u64;
    fn is_none(self) -> bool;
}

impl Real for f32 {
    fn is_none(self) -> bool {
        self.is_nan()
    }
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
}

impl Real for f64 {
    fn is_none(self) -> bool {
        self.is_nan()
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

fn shown<'a, T: Real>(numbers: impl IntoIterator<Item = &'a T>) -> String {
    let one = |x: &T| if x.is_none() { " nan".to_owned() } else { format!(" {:x}", x.bits()) };
    numbers.into_iter().map(one).collect()
}

fn pose<T: Real>(pose: &Pose<T>) -> String {
    shown(pose.rotation.iter().flatten().chain(&pose.translation))
}

fn solution<T: Real, const N: usize>(one: &Solution<T, N>) -> String {
    let flags = [Flags::EXACT, Flags::BOUNDARY, Flags::FREE, Flags::APPROXIMATE, Flags::OUT_OF_LIMITS];
    let flags: u16 = flags.iter().enumerate().map(|(place, flag)| u16::from(one.flags.contains(*flag)) << place).sum();
    let free: u16 = one.free.iter().map(|joint| 1 << joint).sum();
    let [shoulder, elbow, wrist, root] = parts(one.branch);
    let numbers = shown(one.q.iter().chain([&one.residual.position, &one.residual.orientation]));
    format!("{numbers} {flags} {free} {shoulder} {elbow} {wrist} {root}")
}

fn parts(branch: denhart::Branch) -> [u8; 4] {
    [
        branch.shoulder().map_or(0, |part| part as u8),
        branch.elbow().map_or(0, |part| part as u8),
        branch.wrist().map_or(0, |part| part as u8),
        branch.root().unwrap_or(0),
    ]
}

fn status<T: Real>(status: Status<T>) -> (i32, T) {
    match status {
        Status::Reachable => (0, T::ZERO),
        Status::Unreachable { residual } => (1, residual),
        Status::BadTarget => (2, T::ZERO),
    }
}

fn solutions<T: Real, const N: usize, const M: usize>(all: &Solutions<T, N, M>) -> String {
    let (code, gap) = status(all.status());
    let each: String = all.iter().map(solution).collect();
    format!(" | {code} {}{}{each}", all.len(), shown(&[gap, all.deviation()]))
}

/// What the test knows of an arm with targets `G` of `W` numbers.
struct Task<A, T, G, const N: usize, const W: usize> {
    arm: A,
    /// The target's numbers at joint values.
    aim: fn(&A, &[T; N]) -> [T; W],
    /// The target of its numbers and of what is given.
    target: fn([T; W], T) -> G,
    /// What is given at joint values.
    given: fn(&A, &[T; N]) -> T,
    /// Motors and the arm angle.
    extra: fn(&A, &[T; N]) -> String,
}

/// Input of the C program, and what Rust says to it.
fn cases<A, T, const N: usize, const M: usize, const W: usize>(task: &Task<A, T, A::Target, N, W>) -> [String; 2]
where
    A: InverseKinematics<T, N, Solutions = Solutions<T, N, M>>,
    T: Real,
{
    let Task { arm, .. } = task;
    let mut random = Random::new(7);
    let (mut input, mut expected) = (String::new(), String::new());
    let mut reached = 0;
    for number in 0..CASES {
        let mut q = [T::ZERO; N];
        for ((q, [low, high]), kind) in q.iter_mut().zip(A::LIMITS).zip(A::JOINT_KINDS) {
            let low = if low.is_finite() { low } else { -T::PI };
            let high = if high.is_finite() { high } else { T::PI };
            *q = low + (high - low) * T::from_f64(random.uniform(0.0, 1.0));
            if number % 4 == 1 && kind == JointKind::Revolute {
                *q = (*q / T::FRAC_PI_2).round_ties_even() * T::FRAC_PI_2;
            }
        }
        let mut words = (task.aim)(arm, &q);
        let mut q_ref = q.map(|x| x + T::from_f64(random.uniform(-0.5, 0.5)));
        let given = (task.given)(arm, &q);
        match number % 12 {
            2 => words = words.map(|x| x * T::from_f64(3.0)),
            6 => words[random.below(W)] = T::NAN,
            10 => q_ref[random.below(N)] = T::INFINITY,
            _ => {}
        }
        let target = (task.target)(words, given);
        let found = arm.inverse(&target);
        let some = found.get(random.below(8).min(found.len().saturating_sub(1))).or(found.first());
        let mut branch = some.map_or(denhart::Branch::NONE, |solution| solution.branch);
        if number % 5 == 0 {
            branch = denhart::Branch::NONE;
        }
        reached += usize::from(found.status().is_reachable());
        let [shoulder, elbow, wrist, root] = parts(branch);
        let bits = |numbers: &[T]| numbers.iter().map(|x| format!("{:x} ", x.bits())).collect::<String>();
        let numbers = [bits(&q), bits(&words), bits(&[given]), bits(&q_ref)].concat();
        writeln!(input, "{numbers}{shoulder} {elbow} {wrist} {root}").unwrap();

        let (tool, jacobian) = arm.forward_and_jacobian(&q);
        let columns = shown(jacobian.rows.iter().flatten());
        let alone = shown(arm.jacobian(&q).rows.iter().flatten());
        write!(expected, "0{} | 0{alone} | 0{}{columns}", pose(&arm.forward(&q)), pose(&tool)).unwrap();
        expected += &solutions(&found);
        expected += &solutions(&arm.inverse_near(&target, &q_ref));
        let nothing = format!("{} 0 0 0 0 0 0", shown(&vec![T::ZERO; N + 2]));
        let (one, (code, gap)) = match arm.inverse_branch(&target, branch) {
            Ok(one) => (solution(&one), (0, T::ZERO)),
            Err(outcome) => (nothing, status(outcome)),
        };
        writeln!(expected, " | {code}{}{one}{}", shown(&[gap]), (task.extra)(arm, &q)).unwrap();
    }
    // Else the comparison would be one of empty lists.
    assert!(reached > CASES / 2, "{reached} targets are reached");
    [input, expected]
}

/// The program in C for an exported arm, compiled.
fn program(cc: &mut Command, folder: &Path, prefix: &str, definitions: &[&str], library: &Path) -> PathBuf {
    let text = include_str!("export/main.c").replace("exported", prefix).replace("EXPORTED", &prefix.to_uppercase());
    fs::write(folder.join("main.c"), text).unwrap();
    let program = folder.join("program");
    cc.args(["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I"]).arg(folder.join("include"));
    succeeds(cc.args(definitions).arg(folder.join("main.c")).arg(library).arg("-o").arg(&program));
    program
}

/// Runs the program in C; `expected` follow the line of bad arguments.
fn prints(program: &Path, input: &str, expected: &str) {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success(), "{}", output.status);
    let text = String::from_utf8(output.stdout).unwrap();
    let (arguments, lines) = text.split_once('\n').unwrap();
    assert!(arguments.split(' ').skip(1).all(|status| status == "3"), "{arguments}");
    for (number, (c, rust)) in lines.lines().zip(expected.lines()).enumerate() {
        assert_eq!(c, rust, "case {number}");
    }
    assert_eq!(lines.lines().count(), expected.lines().count());
}

macro_rules! exported {
    ($(
        $name:ident: $spec:literal $type:ident $scalar:literal $prefix:literal [$($definition:literal)*]
        $words:literal |$arm:ident, $q:ident| $aim:expr, |$w:ident, $g:ident| $target:expr, $given:expr, $extra:expr;
    )*) => {$(
        #[test]
        fn $name() {
            #[derive(Default, Arm)]
            #[arm(spec = $spec, scalar = $scalar)]
            struct Robot;
            let Some(mut cc) = cc() else { return };
            let task: Task<Robot, $type, _, { Robot::DOF }, $words> = Task {
                arm: Robot,
                aim: |$arm, $q| $aim,
                target: |$w, $g| $target,
                given: $given,
                extra: $extra,
            };
            let [input, expected] = cases(&task);
            let folder = export($spec, $scalar, stringify!($name));
            let library = library(&folder, $prefix, "release");
            let words = concat!("-DWORDS=", stringify!($words));
            let program = program(&mut cc, &folder, $prefix, &[words, $($definition),*], &library);
            prints(&program, &input, &expected);
        }
    )*};
}

/// No motors, no arm angle.
fn nothing<A, T, const N: usize>(_: &A, _: &[T; N]) -> String {
    String::new()
}

fn zero<A, T: Scalar, const N: usize>(_: &A, _: &[T; N]) -> T {
    T::ZERO
}

fn words<T: Scalar>(pose: Pose<T>) -> [T; 12] {
    let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
    let [x, y, z] = pose.translation;
    [a, b, c, d, e, f, g, h, i, x, y, z]
}

fn of_words<T: Scalar>([a, b, c, d, e, f, g, h, i, x, y, z]: [T; 12]) -> Pose<T> {
    Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }
}

macro_rules! motor {
    () => {
        |arm, q| {
            let motor = arm.to_motor(q);
            format!(" | 0{}{}", shown(&motor), shown(&arm.from_motor(&motor)))
        }
    };
}

macro_rules! pulses {
    () => {
        |arm, q| {
            let (pulses, ends) = arm.to_pulses_checked(q);
            let counts: String = pulses.iter().map(|count| format!(" {count}")).collect();
            let saturated: u16 = ends.iter().map(|joint| 1 << joint).sum();
            format!(" | 0{counts} {saturated}{}", shown(&arm.from_pulses(&pulses)))
        }
    };
}

exported! {
    pose_f64: "../specs/puma560.yaml" f64 "f64" "puma560" ["-DGIVEN="]
        12 |arm, q| words(arm.forward(q)), |w, _given| of_words(w), zero, nothing;
    pose_f32_with_linked_motors: "../specs/fanuc_lrmate200id.yaml" f32 "f32" "fanuc_lrmate200id" ["-DGIVEN=" "-DHAS_MOTOR"]
        12 |arm, q| words(arm.forward(q)), |w, _given| of_words(w), zero, motor!();
    pose_with_a_joint_given: "../specs/kuka_iiwa7_r800.yaml" f32 "f32" "kuka_iiwa7_r800" ["-DGIVEN=given,"]
        12 |arm, q| words(arm.forward(q)), |w, given| (of_words(w), given), |_, q| q[2], nothing;
    pose_with_the_arm_angle_given: "tests/export/iiwa.yaml" f64 "f64" "arm_7_iiwa" ["-DGIVEN=given," "-DHAS_ARM_ANGLE"]
        12 |arm, q| words(arm.forward(q)), |w, given| (of_words(w), given), |arm, q| arm.arm_angle(q),
        |arm, q| format!(" | 0{}", shown(&[arm.arm_angle(q)]));
    position_f32_with_pulses: "../specs/salman_rrr.yaml" f32 "f32" "salman_rrr" ["-DGIVEN=" "-DHAS_PULSES"]
        3 |arm, q| arm.forward(q).translation, |w, _given| w, zero, pulses!();
    position_axis: "arms/position_axis/scorbot_x.yaml" f64 "f64" "scorbot_x" ["-DGIVEN="]
        6 |arm, q| {
            let Pose { rotation: [[u, ..], [v, ..], [w, ..]], translation: [x, y, z] } = arm.forward(q);
            [x, y, z, u, v, w]
        },
        |w, _given| PointAxis { point: [w[0], w[1], w[2]], axis: [w[3], w[4], w[5]] }, zero, nothing;
    position_angle: "../specs/jupiter.yaml" f32 "f32" "jupiter" ["-DGIVEN="]
        4 |arm, q| {
            let [x, y, z] = arm.forward(q).translation;
            [x, y, z, q[1] + q[2] + q[3]]
        },
        |w, _given| PointAngle { point: [w[0], w[1], w[2]], angle: w[3] }, zero, nothing;
    planar_pose_with_a_joint_given: "../specs/planar4r_redundant.yaml" f32 "f32" "planar4r_redundant" ["-DGIVEN=given,"]
        3 |arm, q| {
            let [x, y, _] = arm.forward(q).translation;
            [x, y, q.iter().sum()]
        },
        |w, given| (PlanarPose { x: w[0], y: w[1], phi: w[2] }, given), |_, q| q[0], nothing;
    planar_position: "../specs/planar2r.yaml" f64 "f64" "planar2r" ["-DGIVEN="]
        2 |arm, q| {
            let [x, y, _] = arm.forward(q).translation;
            [x, y]
        },
        |w, _given| w, zero, nothing;
}

/// An arm without inverse has the kinematics alone; a build without optimization, which is one with it, links too.
#[test]
fn an_arm_without_inverse() {
    #[derive(Default, Arm)]
    #[arm(spec = "../specs/kinova_jaco.yaml")]
    struct Jaco;
    let Some(mut cc) = cc() else { return };
    let folder = export("../specs/kinova_jaco.yaml", "f64", "without_inverse");
    let library = library(&folder, "kinova_jaco", "dev");
    let program = program(&mut cc, &folder, "kinova_jaco", &[], &library);
    let q = [0.1, -0.7, 1.3, 2.0, -1.1, 0.4];
    let input: String = q.iter().map(|x| format!("{:x} ", x.bits())).collect();
    let (tool, jacobian) = Jaco.forward_and_jacobian(&q);
    let alone = Jaco.jacobian(&q);
    let [alone, columns] = [alone, jacobian].map(|jacobian| shown(jacobian.rows.iter().flatten()));
    let expected = format!("0{} | 0{alone} | 0{}{columns}\n", pose(&Jaco.forward(&q)), pose(&tool));
    prints(&program, &input, &expected);
}

/// Two arms in one program do not get into each other's way; the header is one for C++ too.
#[test]
fn two_arms_in_one_program() {
    let Some(mut cc) = cc() else { return };
    let arms = [("salman_rrr", "f32"), ("planar2r", "f64")];
    let folders = arms.map(|(arm, scalar)| export(&format!("../specs/{arm}.yaml"), scalar, &format!("two_{arm}")));
    let [first, second] = &folders;
    let main = first.join("two.c");
    fs::write(
        &main,
        "#include \"salman_rrr.h\"\n#include \"planar2r.h\"\n\
         int main(void)\n{\n    float a[3] = {0};\n    double b[2] = {0};\n    salman_rrr_pose_t p;\n    planar2r_solutions_t s;\n\
         \x20   return salman_rrr_forward(a, &p) + (planar2r_inverse(b, &s) == PLANAR2R_BAD_TARGET);\n}\n",
    )
    .unwrap();
    let libraries = [library(first, "salman_rrr", "release"), library(second, "planar2r", "release")];
    let includes = folders.each_ref().map(|folder| format!("-I{}/include", folder.display()));
    let program = first.join("two");
    succeeds(cc.arg(&main).args(&includes).args(libraries).arg("-o").arg(&program));
    succeeds(&mut Command::new(&program));
    let cpp = Command::new("c++").arg("--version").stdout(Stdio::null()).status().is_ok_and(|status| status.success());
    if cpp {
        succeeds(
            Command::new("c++").args(["-x", "c++", "-fsyntax-only", "-Wall", "-Werror"]).args(&includes).arg(&main),
        );
    } else {
        println!("skipped: there is no C++ compiler `c++`");
    }
}

/// The files as they are: one with a redundant joint in single precision, one with pulses in double precision.
#[test]
fn the_files() {
    for (arm, scalar) in [("kuka_iiwa7_r800", "f32"), ("salman_rrr", "f64")] {
        let name = format!("files_{arm}");
        let folder = folder(&name);
        let spec = root().join("specs").join(format!("{arm}.yaml"));
        let _ = fs::remove_dir_all(&folder);
        let output = folder.to_str().unwrap();
        denhart(&["export", "c", spec.to_str().unwrap(), "--scalar", scalar, "-o", output], None);
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("snapshots/export");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let header = format!("include/{arm}.h");
        for (kind, file) in
            [("header", header.as_str()), ("lib", "src/lib.rs"), ("cargo", "Cargo.toml"), ("cmake", "CMakeLists.txt")]
        {
            let text = fs::read_to_string(folder.join(file)).unwrap();
            settings.bind(|| insta::assert_snapshot!(format!("{arm}_{kind}"), text));
        }
        // The code is what `expand` prints.
        let options = denhart_codegen::Builder::new(&spec).type_name("Robot").scalar(scalar);
        assert_eq!(fs::read_to_string(folder.join("src/arm.rs")).unwrap(), options.generate().unwrap());
    }
}

#[test]
fn what_is_there_is_not_overwritten() {
    let spec = root().join("specs/planar2r.yaml");
    let folder = folder("kept");
    let _ = fs::remove_dir_all(&folder);
    let command = ["export", "c", spec.to_str().unwrap(), "-o", folder.to_str().unwrap()];
    denhart(&command, None);
    // The same again is no change.
    denhart(&command, None);
    let library = folder.join("src/lib.rs");
    fs::write(&library, "mine").unwrap();
    denhart(&command, Some("lib.rs` is there already\nhelp: --force overwrites it"));
    assert_eq!(fs::read_to_string(&library).unwrap(), "mine");
    denhart(&[&command[..], &["--force"]].concat(), None);
    assert!(fs::read_to_string(&library).unwrap().contains("planar2r_forward"));
}

#[test]
fn wrong_arguments_are_named() {
    let spec = root().join("specs/planar2r.yaml");
    let folder = folder("refused");
    let command = ["export", "c", spec.to_str().unwrap(), "-o", folder.to_str().unwrap()];
    let with = |more: &[&str], says| denhart(&[&command[..], more].concat(), Some(says));
    with(&["--prefix", "2R-arm"], "`2R-arm` cannot begin a name in C\nhelp: write `arm_2r_arm`");
    with(&["--crate-path", "/no/such/folder"], "--crate-path: cannot read `/no/such/folder/Cargo.toml`");
    let wrong = root().join("codegen");
    with(&["--crate-path", wrong.to_str().unwrap()], "is not the crate denhart");
    with(&["--scalar", "f16"], "invalid value 'f16'");
    assert!(!folder.exists());
}
