//! Fuzz targets for any bytes. A target fails by panicking.
//!
//! `fuzz/run.sh` lets libFuzzer look for bytes that do; `cargo test` replays the corpus.

pub mod arm_file;
pub mod back_ends;
pub mod bytes;
pub mod inverse;
