//! The estimates of `denhart check --target cortex-m4f` beside what was measured, and the fit of their coefficients:
//!
//! ```sh
//! DENHART_FIT=1 cargo test -p denhart-cli --test cost     # writes cli/src/cost/cortex-m4f.txt
//! cargo test -p denhart-cli --test cost                   # the estimates with them
//! ```
//!
//! Measured are the arms of `firmware/measured.txt` and of `firmware/sheet.txt`. To some of the latter nothing is fitted.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

/// Arms that nothing is fitted to: an industrial arm, a SCARA, seven joints, another task.
const HELD_OUT: [&str; 4] = ["kuka_kr6_r700", "scara_rrrp_325_275", "kuka_lwr4", "al5d"];
/// How far an estimate may be off: of the arms of measured.txt, of others.
const OFF: [f64; 2] = [0.25, 0.35];

/// A function without an estimate: what `inverse` takes, less the list that it makes and copies.
const WITHOUT_LIST: &str = "inverse_into";

/// The counts that a quantity is a sum of, for functions of joint values and for those of the inverse.
const STRAIGHT: [&str; 4] = ["one", "joints", "sin_cos", "arithmetic"];
const INVERSE: [(&str, &[&str]); 3] = [
    ("instructions", &["one", "one_root", "two_roots", "wrists", "quartics", "angles", "arithmetic", "values"]),
    ("flash", &["one", "joints", "written", "pose", "coupled", "has_quartic", "agreements"]),
    ("stack", &["one", "joints", "list", "coupled", "has_quartic"]),
];

const HEAD: &str = "\
# A Cortex-M4F in f32, opt-level 3, feature `fpu`: each quantity is the sum of the counts of `denhart check --json --target cortex-m4f`
# times these coefficients. Instructions are the median of random targets. Fitted by `DENHART_FIT=1 cargo test -p denhart-cli --test cost`
# to firmware/measured.txt and firmware/sheet.txt: least squares of the relative errors, no coefficient below 0.
";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap()
}

/// A measured value.
struct Point {
    arm: String,
    function: String,
    quantity: &'static str,
    value: f64,
    /// True for a value of measured.txt.
    accepted: bool,
}

fn points() -> Vec<Point> {
    measured().into_iter().filter(|point| point.function != WITHOUT_LIST).collect()
}

fn measured() -> Vec<Point> {
    let mut points = Vec::new();
    let mut put = |arm: &str, function: &str, accepted, numbers: [Option<&str>; 3]| {
        for (quantity, number) in ["flash", "stack", "instructions"].into_iter().zip(numbers) {
            if let Some(value) = number.and_then(|number| number.parse().ok()) {
                points.push(Point { arm: arm.to_owned(), function: function.to_owned(), quantity, value, accepted });
            }
        }
    };
    for line in read("firmware/measured.txt").lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let ([arm, function, flash, _, stack, random, ..], true) = (words.as_slice(), !line.contains('+'))
            && let Some(arm) = arm.strip_suffix("_f32")
        {
            put(arm, function, true, [Some(flash), Some(stack), random.split('/').next()]);
        }
    }
    for line in read("firmware/sheet.txt").lines().filter(|line| !line.starts_with('#')).skip(1) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let [arm, function, flash, stack, median, _] = words.as_slice() {
            put(arm, function, false, [Some(flash), Some(stack), Some(median)]);
        }
    }
    points
}

/// The functions of an arm as `denhart check` prints them.
fn checked(arm: &str) -> Value {
    let file = root().join("specs").join(format!("{arm}.yaml"));
    let output = Command::new(env!("CARGO_BIN_EXE_denhart"))
        .args(["check", "--json", "--target", "cortex-m4f"])
        .arg(file)
        .output()
        .unwrap();
    let all: Value = serde_json::from_slice(&output.stdout).unwrap();
    all[0]["cortex_m4f"]["functions"].clone()
}

fn names(function: &str, quantity: &str) -> &'static [&'static str] {
    if function.starts_with("forward") {
        return &STRAIGHT;
    }
    INVERSE.iter().find(|(name, _)| *name == quantity).unwrap().1
}

/// The coefficients, none below 0, that make the sums of `rows` nearest to 1: by each in turn.
fn fit(rows: &[Vec<f64>]) -> Vec<f64> {
    let count = rows.first().map_or(0, Vec::len);
    let product = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
    let mut solution = vec![0.0; count];
    for _ in 0..20_000 {
        for i in (0..count).filter(|&i| product(i, i) > 0.0) {
            let others: f64 = (0..count).filter(|&j| j != i).map(|j| product(i, j) * solution[j]).sum();
            let wanted: f64 = rows.iter().map(|row| row[i]).sum();
            solution[i] = ((wanted - others) / product(i, i)).max(0.0);
        }
    }
    solution
}

fn coefficients(points: &[Point], arms: &BTreeMap<String, Value>) -> String {
    let mut quantities: Vec<(&str, &str)> = Vec::new();
    for point in points {
        let quantity = (point.function.as_str(), point.quantity);
        if !quantities.contains(&quantity) {
            quantities.push(quantity);
        }
    }
    let mut text = HEAD.to_owned();
    for (function, quantity) in quantities {
        let names = names(function, quantity);
        let of = |point: &&Point| point.function == function && point.quantity == quantity;
        let rows: Vec<Vec<f64>> = points
            .iter()
            .filter(of)
            .filter(|point| !HELD_OUT.contains(&point.arm.as_str()))
            .map(|point| {
                let counts = &arms[&point.arm][function]["counts"];
                names.iter().map(|name| counts[name].as_f64().unwrap() / point.value).collect()
            })
            .collect();
        let _ = write!(text, "{function}.{quantity}");
        for (name, coefficient) in names.iter().zip(fit(&rows)).filter(|(_, coefficient)| *coefficient > 1e-3) {
            let _ = write!(text, " {name} {coefficient:.4}");
        }
        text.push('\n');
    }
    text
}

/// The page's claim on the function without an estimate.
#[test]
fn a_list_that_is_kept_takes_less() {
    let measured = measured();
    let of = |arm: &str, function: &str, quantity: &str| {
        let found = measured.iter().find(|point| {
            point.accepted && point.arm == arm && point.function == function && point.quantity == quantity
        });
        found.unwrap_or_else(|| panic!("{arm} {function}: no {quantity}")).value
    };
    let arms: Vec<&str> = measured
        .iter()
        .filter(|point| point.accepted && point.function == "forward")
        .map(|point| &*point.arm)
        .collect();
    assert!(!arms.is_empty());
    for arm in arms {
        for quantity in ["instructions", "stack"] {
            let (kept, returned) = (of(arm, WITHOUT_LIST, quantity), of(arm, "inverse", quantity));
            assert!(kept < returned, "{arm}: {kept} {returned} {quantity}");
        }
    }
}

#[test]
fn estimates_are_near_what_was_measured() {
    let points = points();
    let arms: BTreeMap<String, Value> =
        points.iter().map(|point| point.arm.clone()).map(|arm| (arm.clone(), checked(&arm))).collect();
    if env::var_os("DENHART_FIT").is_some() {
        fs::write(root().join("cli/src/cost/cortex-m4f.txt"), coefficients(&points, &arms)).unwrap();
        println!("written: cli/src/cost/cortex-m4f.txt");
        return;
    }
    assert!(HELD_OUT.iter().all(|arm| arms.contains_key(*arm)), "firmware/sheet.txt lacks an arm");
    assert!(points.iter().filter(|point| point.accepted).count() >= 7 * 16);
    let mut wrong = Vec::new();
    let mut worst = [0.0_f64; 3];
    for point in &points {
        let Point { arm, function, quantity, value, accepted } = point;
        let Some(estimate) = arms[arm][function][quantity].as_f64() else {
            panic!("{arm} {function}: no estimate of {quantity}")
        };
        let off = estimate / value - 1.0;
        let (allowed, kind) = match (accepted, HELD_OUT.contains(&arm.as_str())) {
            (true, _) => (OFF[0], 0),
            (false, held_out) => (OFF[1], 1 + usize::from(held_out)),
        };
        worst[kind] = worst[kind].max(off.abs());
        if off.abs() > allowed {
            wrong.push(format!("{arm} {function} {quantity}: {estimate} for {value}, {:+.0} %", 100.0 * off));
        }
    }
    println!("largest error: measured.txt {:.2}, fitted {:.2}, held out {:.2}", worst[0], worst[1], worst[2]);
    assert!(wrong.is_empty(), "{}\nafter firmware/sheet.sh: DENHART_FIT=1 fits anew", wrong.join("\n"));
}

/// The fit finds what data were made from, and leaves out what would be negative.
#[test]
fn the_fit_finds_coefficients() {
    let data = [[1.0, 2.0, 5.0], [1.0, 4.0, 1.0], [1.0, 7.0, 3.0], [1.0, 1.0, 2.0]];
    let rows: Vec<Vec<f64>> = data.iter().map(|row| row.iter().map(|x| x / (3.0 + 0.5 * row[1])).collect()).collect();
    let found = fit(&rows);
    for (found, expected) in found.iter().zip([3.0, 0.5, 0.0]) {
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    }
}

#[test]
fn the_sheet_is_printed_for_people() {
    let output = Command::new(env!("CARGO_BIN_EXE_denhart"))
        .args(["check", "--target", "cortex-m4f"])
        .args(["ur5", "kinova_jaco"].map(|arm| root().join("specs").join(format!("{arm}.yaml"))))
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    for says in [
        "on a Cortex-M4F, in f32, opt-level 3, feature `fpu`:\n  inverse: at most 8 branches\n",
        "  calls of kernels for an ordinary target: align 8, distance 4, flip 2, offset 1\n",
        "  bound of any call: 12 cascades, 200 evaluations of forward_and_jacobian\n",
        "    inverse_branch: ",
        "    one program without inverse_branch: ",
    ] {
        assert!(text.contains(says), "{text}");
    }
    assert_eq!(text.matches("    forward: ").count(), 2, "{text}");
    assert_eq!(text.matches("    inverse: ").count(), 1, "{text}");
}
