//! `denhart check --target cortex-m4f`: its table holds what the firmware measured, and an arm is compared with one of
//! its kind.
//!
//! ```sh
//! DENHART_ACCEPT=1 cargo test -p denhart-cli --test cost     # writes tools/src/check/cortex-m4f.txt
//! ```
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::{Value, json};

const TABLE: &str = "tools/src/check/cortex-m4f.txt";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The rows of a file without its comments, by words.
fn rows(file: &str) -> Vec<Vec<String>> {
    let text = fs::read_to_string(root().join(file)).unwrap();
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    rows.map(|row| row.split_whitespace().map(str::to_owned).collect()).collect()
}

/// The rows that the table has to have, of the arms of `specs/`: arm, function, flash, stack, instructions. A follower's ticks
/// have no random targets.
fn measured() -> Vec<Vec<String>> {
    let mut all = Vec::new();
    for row in rows("firmware/measured.txt") {
        let [arm, function, flash, _, stack, random, ..] = row.as_slice() else { panic!("{row:?}") };
        let is_listed = |arm: &&str| root().join(format!("specs/{arm}.yaml")).exists() && function != "follower";
        if let Some(arm) = arm.strip_suffix("_f32").filter(is_listed) {
            let median = random.split('/').next().unwrap();
            all.push([arm, function, flash, stack, median].map(str::to_owned).to_vec());
        }
    }
    all.extend(rows("firmware/sheet.txt").into_iter().skip(1).map(|row| row[..5].to_vec()));
    all
}

/// The output for some arms of `specs/`, or files by their path from there.
fn check(options: &[&str], arms: &[&str]) -> String {
    let files = arms.iter().map(|arm| root().join("specs").join(format!("{arm}.yaml")));
    let mut command = Command::new(env!("CARGO_BIN_EXE_denhart"));
    let output = command.args(["check", "--target", "cortex-m4f"]).args(options).args(files).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

fn json(arm: &str) -> Value {
    let all: Value = serde_json::from_str(&check(&["--json"], &[arm])).unwrap();
    all[0]["cortex_m4f"].clone()
}

#[test]
fn the_table_holds_what_was_measured() {
    let measured = measured();
    assert!(measured.len() > 100, "{}", measured.len());
    if env::var_os("DENHART_ACCEPT").is_some() {
        let text = fs::read_to_string(root().join(TABLE)).unwrap();
        let head = text.lines().filter(|line| line.starts_with('#')).map(str::to_owned);
        let lines: Vec<String> = head.chain(measured.iter().map(|row| row.join(" "))).collect();
        fs::write(root().join(TABLE), lines.join("\n") + "\n").unwrap();
    }
    assert!(rows(TABLE) == measured, "{TABLE} differs from firmware/: DENHART_ACCEPT=1 writes it");
}

/// The page's claim on the function that fills a list of the caller.
#[test]
fn a_list_that_is_kept_takes_less() {
    let measured = measured();
    let of = |arm: &str, function: &str, column: usize| {
        let row = measured.iter().find(|row| row[0] == arm && row[1] == function);
        row.unwrap_or_else(|| panic!("{arm} has no {function}"))[column].parse::<u64>().unwrap()
    };
    let arms: Vec<&str> = measured.iter().filter(|row| row[1] == "inverse_into").map(|row| &*row[0]).collect();
    assert!(!arms.is_empty());
    for arm in arms {
        for column in [3, 4] {
            let (kept, returned) = (of(arm, "inverse_into", column), of(arm, "inverse", column));
            assert!(kept < returned, "{arm}: {kept} {returned}");
        }
    }
}

/// A measured arm has its own row, or that of an arm whose code is as long.
#[test]
fn a_measured_arm_is_compared_with_itself() {
    let measured = measured();
    let arms: BTreeSet<&str> = measured.iter().map(|row| &*row[0]).collect();
    for arm in arms {
        let row = |name: &str| measured.iter().find(|row| row[0] == name && row[1] == "forward").unwrap()[2].clone();
        let found = json(arm)["measured"].clone();
        let name = found["arm"].as_str().unwrap();
        assert_eq!(row(name), row(arm), "{arm} is compared with {name}");
        assert!(found["functions"]["inverse"]["stack"].is_u64(), "{arm}: {found}");
    }
}

/// Other arms are compared with one of their kind, and with the functions of joint values alone where none is measured.
#[test]
fn an_arm_is_compared_with_one_of_its_kind() {
    for (arm, with) in [
        ("ur10", "ur5"),
        ("kinova_gen3_7dof", "franka_panda"),
        ("anthro3r", "salman_rrr"),
        ("kuka_youbot", "scorbot_er5"),
    ] {
        let (own, found) = (json(arm), json(with));
        assert_eq!(own["measured"]["arm"], with, "{arm}");
        assert_eq!(own["kernels"], found["kernels"], "{arm}");
        assert_eq!(own["measured"], found["measured"], "{arm}");
    }
    // The last one has the task and the kernels of salman_rrr, but links the search for places of free joints.
    for arm in ["polar_rrp", "kinova_jaco", "singular_6r", "../tests/arms/position/rrr_first_parallel"] {
        let functions = json(arm)["measured"]["functions"].clone();
        let names: Vec<&String> = functions.as_object().unwrap().keys().collect();
        assert_eq!(json!(names), json!(["forward", "forward_and_jacobian"]), "{arm}");
    }
}

#[test]
fn the_sheet_is_printed_for_people() {
    let text = check(&[], &["ur10", "singular_6r", "polar_rrp", "kinova_jaco"]);
    let forward = measured().into_iter().find(|row| row[..2] == ["ur5", "forward"]).unwrap();
    let [_, _, flash, stack, instructions] = forward.as_slice() else { panic!("{forward:?}") };
    let costs = format!("    forward: {instructions} instructions, {stack} bytes of stack, {flash} bytes of flash\n");
    for says in [
        "on a Cortex-M4F, in f32, opt-level 3, feature `fpu`:\n  inverse: at most 8 branches\n",
        "  calls of kernels for an ordinary target: align 8, distance 4, flip 2, offset 1\n",
        "  bound of any call: 12 cascades, 200 evaluations of forward_and_jacobian\n",
        "  measured for ur5, the nearest arm of the same kind of plan:\n",
        &costs,
        "    inverse_branch: ",
        "    one program without inverse_branch: ",
        ", the nearest arm by operations:\n",
        "  inverse: at most 16 solutions, a joint held\n",
        "  bound of any call: 300 evaluations of forward_and_jacobian; 57 places of a held joint for its polynomial\n",
        "; no arm of the same kind of plan is measured:\n",
    ] {
        assert!(text.contains(says), "{text}");
    }
    assert_eq!(text.matches("    forward: ").count(), 4, "{text}");
    assert_eq!(text.matches("    inverse: ").count(), 1, "{text}");
}
