//! A progress bar for work that takes long.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar appears after this long.
const LONG: Duration = Duration::from_secs(1);

/// A bar on the standard error, if that is a terminal, once the work takes long.
pub struct Progress {
    start: Instant,
    count: u64,
    template: &'static str,
    may_show: bool,
    bar: Option<ProgressBar>,
    /// Looks between two looks at the clock, and those since the last one.
    every: u64,
    looks: u64,
}

impl Progress {
    /// A bar of `count` steps, as the template of `indicatif` shows it, if `may_show`. The clock is read at each look out
    /// of `every`.
    pub fn new(count: u64, template: &'static str, every: u64, may_show: bool) -> Self {
        let may_show = may_show && io::stderr().is_terminal();
        Self { start: Instant::now(), count, template, may_show, bar: None, every, looks: 0 }
    }

    /// Shows the steps that are done.
    pub fn look(&mut self, done: u64) {
        self.looks += 1;
        if !self.may_show || !self.looks.is_multiple_of(self.every) {
            return;
        }
        if self.bar.is_none() && self.start.elapsed() > LONG {
            let bar = ProgressBar::new(self.count);
            if let Ok(style) = ProgressStyle::with_template(self.template) {
                bar.set_style(style);
            }
            self.bar = Some(bar);
        }
        if let Some(bar) = &self.bar {
            bar.set_position(done);
        }
    }

    /// Writes to the standard error, with the bar out of the way.
    pub fn aside<R>(&self, write: impl FnOnce() -> R) -> R {
        match &self.bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
