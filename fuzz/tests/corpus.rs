//! Every file of the corpus passes its target.

use std::path::Path;

fn replay(target: &str, run: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(target);
    let files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    assert!(files.len() >= 20, "{target}: only {} files", files.len());
    for file in files {
        println!("{}", file.display());
        run(&std::fs::read(&file).unwrap());
    }
}

#[test]
fn arm_file() {
    replay("arm_file", denhart_fuzz::arm_file::run);
}

#[test]
fn back_ends() {
    replay("back_ends", denhart_fuzz::back_ends::run);
}

#[test]
fn inverse() {
    replay("inverse", denhart_fuzz::inverse::run);
}
