//! Targets of `denhart inverse`: their spellings, many at once, and the answer beside the solutions.
#![allow(clippy::unwrap_used)]

#[path = "../shell/mod.rs"]
mod shell;

mod answer;
mod batch;
mod spelling;

/// Five joints of which the tool's z axis points: the welder of docs/tasks.md.
fn welder() -> String {
    let page = include_str!("../../../docs/tasks.md");
    let from = page.find("name: welder").unwrap();
    let text = page.split_at(from).1.split("```").next().unwrap();
    shell::file("targets_welder.yaml", text)
}
