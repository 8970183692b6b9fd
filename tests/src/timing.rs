//! Times of several functions side by side: interleaved rounds, medians, ratios.
//!
//! A machine drifts over seconds. So every round times each case once, and a ratio is formed within a round.

use std::fmt;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// One function under a name, run over a fixed set of inputs.
pub struct Case<'a> {
    name: String,
    calls: usize,
    pass: Box<dyn FnMut() + 'a>,
}

impl<'a> Case<'a> {
    /// `function` applied to every input, `repeat` times over.
    pub fn new<I, O>(name: &str, inputs: &'a [I], repeat: usize, function: impl Fn(&I) -> O + 'a) -> Self {
        let pass = move || {
            for _ in 0..repeat {
                for input in inputs {
                    black_box(function(black_box(input)));
                }
            }
        };
        Self { name: name.to_owned(), calls: repeat * inputs.len(), pass: Box::new(pass) }
    }
}

/// What was measured, one line a case, in the order of the cases.
#[derive(Debug)]
pub struct Table {
    title: String,
    lines: Vec<Line>,
}

/// One case: nanoseconds a call, and its time over that of the first case.
#[derive(Debug)]
pub struct Line {
    pub name: String,
    pub nanoseconds: Spread,
    pub ratio: Spread,
}

/// Tenth percentile, median and ninetieth percentile over the rounds.
#[derive(Debug, Clone, Copy)]
pub struct Spread {
    pub low: f64,
    pub median: f64,
    pub high: f64,
}

impl Spread {
    fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).round() as usize];
        Self { low: at(0.1), median: at(0.5), high: at(0.9) }
    }
}

/// Times the cases in `rounds` interleaved rounds, after one round to warm up. The first case is the yardstick.
pub fn compare(title: &str, mut cases: Vec<Case<'_>>, rounds: usize) -> Table {
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); cases.len()];
    for round in 0..=rounds {
        for (case, times) in cases.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (case.pass)();
            if round > 0 {
                times.push(nanoseconds(start.elapsed()) / case.calls as f64);
            }
        }
    }
    let yardstick = times.first().cloned().unwrap_or_default();
    let lines = cases.into_iter().zip(times).map(|(case, times)| {
        let ratios = times.iter().zip(&yardstick).map(|(time, unit)| time / unit).collect();
        Line { name: case.name, nanoseconds: Spread::of(times), ratio: Spread::of(ratios) }
    });
    Table { title: title.to_owned(), lines: lines.collect() }
}

fn nanoseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e9
}

impl Table {
    /// The line of a case.
    pub fn line(&self, name: &str) -> Option<&Line> {
        self.lines.iter().find(|line| line.name == name)
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:<44} {:>9} {:>19} {:>8} {:>15}", self.title, "ns/call", "10 to 90 %", "ratio", "10 to 90 %")?;
        for Line { name, nanoseconds: ns, ratio } in &self.lines {
            writeln!(
                f,
                "  {name:<42} {:>9.1} {:>8.1} to {:>7.1} {:>8.3} {:>6.3} to {:>5.3}",
                ns.median, ns.low, ns.high, ratio.median, ratio.low, ratio.high,
            )?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_of_twice_the_work_takes_longer() {
        let inputs = [1.0_f64; 64];
        let work = |n: usize| move |x: &f64| (0..n).fold(*x, |y, _| black_box(y).sin());
        let cases = vec![Case::new("one", &inputs, 10, work(20)), Case::new("four", &inputs, 10, work(80))];
        let table = compare("sines", cases, 5);
        let ratio = table.line("four").expect("timed").ratio.median;
        assert!((1.5..16.0).contains(&ratio), "{ratio}");
        assert_eq!(table.line("one").expect("timed").ratio.median, 1.0);
        assert_eq!(table.to_string().lines().count(), 3);
    }
}
