//! Instructions by symbol, from the emulator's trace.

use std::collections::HashMap;
use std::io::{BufRead, stdin};

use crate::Error;
use crate::elf::Program;

/// Calls that the program makes: `CASES` in `chip/src/bin/profile.rs`.
const PROFILED: u64 = 100;
/// The most symbols that are printed.
const LISTED: usize = 25;

/// Reads the trace, one line an instruction, and prints the instructions of `function` and all it calls, by symbol.
///
/// # Errors
/// The trace has no call of the function.
pub fn print(program: &Program, function: &str) -> Result<(), Error> {
    let entry = format!("::call::{function}");
    let mut counts: HashMap<&str, u64> = HashMap::new();
    let mut inside = false;
    for line in stdin().lock().lines() {
        let line = line?;
        // `Trace 0: 0x7f.. [cs_base/pc/flags/cflags] name`
        let Some(pc) = line.split('[').nth(1).and_then(|rest| rest.split('/').nth(1)) else { continue };
        let Some(symbol) = u64::from_str_radix(pc, 16).ok().and_then(|pc| program.symbol_at(pc)) else { continue };
        inside = if symbol.ends_with(&entry) { true } else { inside && !symbol.ends_with("__cortex_m_rt_main") };
        if inside {
            *counts.entry(symbol).or_default() += 1;
        }
    }
    let total: u64 = counts.values().sum();
    if total == 0 {
        return Err(format!("the trace has no call of {function}").into());
    }
    println!("{:7}  all", total / PROFILED);
    let mut counts: Vec<(&str, u64)> = counts.into_iter().collect();
    counts.sort_by_key(|&(name, count)| (std::cmp::Reverse(count), name));
    for (name, count) in counts.into_iter().take(LISTED) {
        println!("{:7}  {name}", count / PROFILED);
    }
    Ok(())
}
