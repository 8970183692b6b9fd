//! `docs/command.md` names every key of the JSON that is printed, and no other.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn json(arguments: &str) -> Value {
    let words = arguments.split(' ').map(|word| word.replace('_', " "));
    let words = words.map(|word| if word.ends_with("yaml") { word.replace(' ', "_") } else { word });
    let output = Command::new(env!("CARGO_BIN_EXE_denhart")).args(words).current_dir(root()).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{arguments}: {output:?}"))
}

/// All keys, of inner objects too.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        Value::Object(object) => {
            for (key, value) in object {
                found.insert(key.clone());
                match key.as_str() {
                    // The keys in them are names of functions, of kernels and of what is counted.
                    "kernels" | "counts" => {}
                    "functions" => value.as_object().unwrap().values().for_each(|function| keys(function, found)),
                    _ => keys(value, found),
                }
            }
        }
        _ => {}
    }
}

/// The rows of the table behind the line that begins with `start`: the words in backticks of each column.
fn table(start: &str) -> Vec<[Vec<String>; 2]> {
    let page = fs::read_to_string(root().join("docs/command.md")).unwrap();
    let from = page.find(&format!("\n{start}")).unwrap_or_else(|| panic!("no line `{start}`"));
    let rows = page[from..].lines().skip(1).skip_while(|line| !line.starts_with('|'));
    let words = |text: &str| text.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    rows.take_while(|line| line.starts_with('|'))
        .skip(2)
        .map(|row| {
            let (first, rest) = row.trim_start_matches('|').split_once('|').unwrap();
            [words(first), words(rest)]
        })
        .collect()
}

#[test]
fn every_key_of_the_json_is_documented() {
    for (start, elsewhere, runs) in [
        (
            "`forward --json`",
            &[][..],
            &[
                "forward specs/ur5.yaml --q 0_0_0_0_0_0 --json --links",
                "forward specs/puma560.yaml --q 9_9_999_9_9_9 --json",
            ][..],
        ),
        (
            "`inverse --json`",
            &["`forward --json`"],
            &[
                "inverse specs/puma560.yaml --q 0_0_0_0_0_0 --json",
                "inverse specs/ur5.yaml --pose 2_0_0_0_0_0 --json",
                "inverse specs/scara_rrrp_325_275.yaml --pose 400_100_0_90_0_0 --json",
                "inverse specs/al5d.yaml --pose 0.35_-0.15_0.1_30 --json",
                "inverse specs/planar3r.yaml --q 10_20_30 --json",
                "inverse specs/kuka_iiwa7_r800.yaml --q 0_20_30_40_50_60_70 --json --within-limits",
            ],
        ),
        (
            "With `--sweep`, `inverse --json`",
            &["`inverse --json`", "`forward --json`"],
            &["inverse specs/kuka_iiwa7_r800.yaml --q 0_20_30_40_50_60_70 --sweep 3 --json"],
        ),
        (
            "With `--json` each line",
            &["`inverse --json`", "`forward --json`"],
            &[
                "inverse specs/planar2r.yaml --batch cli/tests/targets/good.csv --json",
                "inverse specs/planar2r.yaml --batch cli/tests/targets/wrong.csv --json",
            ],
        ),
        (
            "`--json` prints an array",
            &[],
            &[
                "check --json specs/ur5.yaml --target cortex-m4f",
                "check --json tests/arms/measured/real.yaml",
                "check --json README.md",
            ],
        ),
        (
            "`follow --json`",
            &[],
            &[
                "follow specs/planar2r.yaml --path cli/tests/targets/path.csv --max-velocity 90_90 --json",
                "follow specs/planar2r.yaml --path cli/tests/targets/out.csv --max-velocity 90_90 --json",
                "follow specs/planar3r.yaml --path cli/tests/targets/turn.csv --max-velocity 90_90_90 --json",
            ],
        ),
        ("`arms --json`", &[], &["arms --json"]),
        ("`--json` prints an object", &[], &["import cli/tests/urdf/ur5.urdf --json"]),
    ] {
        let rows = table(start);
        let first: BTreeSet<String> = rows.iter().flat_map(|[first, _]| first.clone()).collect();
        let mut documented: BTreeSet<String> = rows.into_iter().flatten().flatten().collect();
        documented.extend(elsewhere.iter().flat_map(|start| table(start)).flatten().flatten());
        let (mut top, mut all) = (BTreeSet::new(), BTreeSet::new());
        for run in runs {
            let value = json(run);
            let objects = value.as_array().cloned().unwrap_or_else(|| vec![value.clone()]);
            top.extend(objects.iter().flat_map(|object| object.as_object().unwrap().keys().cloned()));
            keys(&value, &mut all);
        }
        let lacking: Vec<&String> = all.difference(&documented).collect();
        assert!(lacking.is_empty(), "{start} says nothing of {lacking:?}");
        let never: Vec<&String> = first.difference(&top).collect();
        assert!(never.is_empty(), "{start} has {never:?}, which is not printed");
    }
}

#[test]
fn the_keys_of_a_trace_are_documented() {
    let page = fs::read_to_string(root().join("docs/command.md")).unwrap();
    let part = page.split("## Motion laws").nth(1).unwrap().split("\n## ").next().unwrap().to_owned();
    let value = json("trace specs/planar2r.yaml --json --to 1 --step 1 --law t,t");
    for key in value.as_object().unwrap().keys() {
        assert!(part.contains(&format!("`{key}`")), "{key}");
    }
}
