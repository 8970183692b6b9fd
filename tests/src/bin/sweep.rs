//! Random arms by the thousand: see [`denhart_tests::sweep`].

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io, panic};

use clap::Parser;
use denhart_tests::sweep::outcome::Outcome;
use denhart_tests::sweep::replay::replay;
use denhart_tests::sweep::run::Sweep;
use denhart_tests::sweep::{Kind, known};

/// Draws arms of every structure and holds their kinematics against the table and against the rules of the suites.
///
/// Exit code 0: every failure is one that `tests/data/sweep_known.json` explains. Exit code 1: another failure
/// occurred, or a listed failure of a drawn arm did not occur. Exit code 2: a file cannot be read or written. With
/// `--replay`, any failure gives exit code 1.
#[derive(Parser)]
struct Options {
    /// Which arms.
    #[arg(long, value_enum, default_value_t = Kind::Common)]
    kind: Kind,
    /// How many arms.
    #[arg(long, default_value_t = 300)]
    arms: usize,
    /// All numbers follow from it.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Index of the first arm.
    #[arg(long, default_value_t = 0)]
    from: usize,
    /// The result does not depend on it.
    #[arg(long, default_value_t = 2)]
    threads: usize,
    /// Where arms that fail are written.
    #[arg(long, default_value = "target/sweep")]
    failures: PathBuf,
    /// Examine this arm file instead, and the joint vectors in its comments.
    #[arg(long)]
    replay: Option<PathBuf>,
}

fn main() -> ExitCode {
    let options = Options::parse();
    // A panic is counted as a failure, with its text.
    panic::set_hook(Box::new(|_| {}));
    let failed = match &options.replay {
        Some(file) => again(file),
        None => sweep(&options),
    };
    match failed {
        Ok(false) => ExitCode::SUCCESS,
        Ok(true) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn again(file: &Path) -> io::Result<bool> {
    let text = fs::read_to_string(file)?;
    let outcome = replay(&text).map_err(io::Error::other)?;
    if let Ok(report) = denhart_codegen::check(&text, &file.display().to_string()) {
        println!("{report}");
    }
    show(&outcome);
    Ok(!outcome.failures.is_empty())
}

fn show(outcome: &Outcome) {
    let inverse = outcome.refused.as_ref().map_or_else(String::new, |reason| format!("; {reason}"));
    println!("{}: {} poses{inverse}", outcome.name, outcome.poses);
    for failure in &outcome.failures {
        println!("  {} x {}: {}", failure.count, failure.family, failure.rule);
        for (q, detail) in &failure.shown {
            println!("    at {q:?}\n      {detail}");
        }
    }
}

fn sweep(options: &Options) -> io::Result<bool> {
    let Options { kind, arms, seed, from, threads, failures, .. } = options;
    let known = known::list();
    let sweep = Sweep { kind: *kind, seed: *seed, from: *from, arms: *arms, threads: *threads };
    let mut written = Ok(());
    let found = sweep.run(&known, |outcome| {
        if !outcome.failures.is_empty() && written.is_ok() {
            let path = failures.join(format!("{}.yaml", outcome.name));
            written = fs::create_dir_all(failures).and_then(|()| fs::write(path, outcome.replay()));
        }
    });
    written?;
    print!("{}", found.tables());
    for outcome in &found.failed {
        for failure in &outcome.failures {
            let reason = known::reason(&known, outcome, failure).unwrap_or("NOT KNOWN");
            println!("{}: {} x {}: {}: {reason}", outcome.name, failure.count, failure.family, failure.rule);
        }
    }
    if !found.failed.is_empty() {
        println!("arm files with joint vectors: {}; see --replay", failures.display());
    }
    let mended = known::mended(&known, &sweep.names(), &found.failed);
    for known in &mended {
        println!("{}: {}: known, but does not fail: take it off the list", known.arm, known.rule);
    }
    Ok(found.unknown > 0 || !mended.is_empty())
}
