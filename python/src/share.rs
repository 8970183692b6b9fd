//! Rows of a batch, shared among threads.
//!
//! The threads belong to the call. A kept pool would be dead in a process that Python's `multiprocessing` forks, and a
//! call would wait for it forever.

use std::hint::black_box;
use std::num::NonZero;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

use crate::error;

/// Rows that a thread takes at once: a tenth of a millisecond of work, so that no thread waits long for the last one.
pub const ROWS: usize = 64;
/// The fewest and the most rows that a thread takes at once where they run in lanes: a row takes less time there, and each
/// call of a batch makes its registers first, which are as long to make as some tens of rows.
const IN_LANES: [usize; 2] = [512, 2048];
/// Jobs that each thread has of a batch in lanes at least, where the rows are enough.
const JOBS: usize = 8;
/// How often the calling thread looks for Ctrl-C.
pub const SIGNALS: Duration = Duration::from_millis(20);

/// Memory that the calling thread may need beside the arrays, generously.
const ROOM: usize = 8 << 20;
/// Addresses for a thread more: its stack, and the heap that the C library reserves for it. Most of them are never touched.
const ROOM_OF_THREAD: usize = 256 << 20;

/// Returns true if there is memory for a thread's work: where it is short, an allocation of Rust would end the process.
fn has_room(room_of: usize) -> bool {
    let mut room: Vec<u8> = Vec::new();
    let is_there = room.try_reserve_exact(room_of).is_ok();
    // An allocation that nothing looks at may be left out.
    black_box(&room);
    is_there
}

/// The number of threads for so many jobs: as many as asked for, else one for each processor.
pub fn threads(asked: Option<i64>, jobs: usize) -> PyResult<usize> {
    let most = jobs.max(1);
    match asked {
        None => Ok(thread::available_parallelism().map_or(1, NonZero::get).min(most)),
        Some(asked) => match usize::try_from(asked) {
            Ok(asked) if asked > 0 => Ok(asked.min(most)),
            _ => Err(error::value(format!(
                "threads: expected a number from 1, or None for one thread a processor, found {asked}"
            ))),
        },
    }
}

/// Rows of a job in lanes, of so many rows.
pub fn in_lanes(asked: Option<i64>, rows: usize) -> PyResult<usize> {
    let [fewest, most] = IN_LANES;
    Ok((rows / (JOBS * threads(asked, rows.div_ceil(fewest))?)).clamp(fewest, most))
}

/// Does every job, on so many threads, without holding up other threads of Python. Each thread has memory of its own, which
/// its jobs use one after the other.
///
/// # Errors
/// An exception that a signal raises, such as `KeyboardInterrupt`; some jobs are then not done. `MemoryError`, with no job
/// done.
pub fn share<J: Send, M: Default>(
    py: Python<'_>,
    jobs: impl Iterator<Item = J> + Send,
    threads: usize,
    work: impl Fn(&mut M, J) + Sync,
) -> PyResult<()> {
    if !has_room(ROOM) {
        return Err(PyMemoryError::new_err("no memory for the work beside the arrays"));
    }
    let jobs = Mutex::new(jobs);
    let stopped = AtomicBool::new(false);
    let next = || {
        if stopped.load(Ordering::Relaxed) { None } else { jobs.lock().unwrap_or_else(PoisonError::into_inner).next() }
    };
    let help = || {
        let mut memory = M::default();
        while let Some(job) = next() {
            work(&mut memory, job)
        }
    };
    py.detach(|| {
        thread::scope(|scope| {
            for _ in 1..threads {
                // With fewer threads the work takes longer, and is done.
                if !has_room(ROOM_OF_THREAD) || thread::Builder::new().spawn_scoped(scope, help).is_err() {
                    break;
                }
            }
            let mut memory = M::default();
            let mut looked = Instant::now();
            while let Some(job) = next() {
                work(&mut memory, job);
                if looked.elapsed() >= SIGNALS {
                    if let Err(error) = Python::attach(|py| py.check_signals()) {
                        stopped.store(true, Ordering::Relaxed);
                        return Err(error);
                    }
                    looked = Instant::now();
                }
            }
            Ok(())
        })
    })
}

/// Tells in the exception that an array of the user is partly written.
pub fn told(py: Python<'_>, error: PyErr, out: bool) -> PyErr {
    if out {
        // Where a note cannot be added the exception stays as it is.
        let _ = error.value(py).call_method1("add_note", ("some rows of out= are written, others are not",));
    }
    error
}
