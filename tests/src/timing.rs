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

    /// A function that does so many calls at a time.
    pub fn of_many(name: &str, calls: usize, pass: impl FnMut() + 'a) -> Self {
        Self { name: name.to_owned(), calls, pass: Box::new(pass) }
    }
}

/// Measurements, one line a case, in the order of the cases.
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
    /// The least time of all rounds over the least one of the first case: other work on the machine adds nothing to it.
    pub least: f64,
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
    let least = |times: &[f64]| times.iter().copied().fold(f64::INFINITY, f64::min);
    let lines = cases.into_iter().zip(times).map(|(case, times)| {
        let ratios = times.iter().zip(&yardstick).map(|(time, unit)| time / unit).collect();
        let least = least(&times) / least(&yardstick);
        Line { name: case.name, nanoseconds: Spread::of(times), ratio: Spread::of(ratios), least }
    });
    Table { title: title.to_owned(), lines: lines.collect() }
}

/// Time of one call for each input, ns. The time is the least of several passes over all inputs, so that an interrupt
/// of the machine does not count as a slow call.
///
/// A pass repeats each call until it has taken `steady`, far longer than reading the clock takes.
pub fn least<I, O>(inputs: &[I], passes: usize, steady: Duration, function: impl Fn(&I) -> O) -> Vec<f64> {
    let timed = |input: &I, calls: u32| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(function(black_box(input)));
        }
        nanoseconds(start.elapsed()) / f64::from(calls)
    };
    let calls = |input: &I| (nanoseconds(steady) / timed(input, 2)).ceil().max(1.0) as u32;
    let calls: Vec<u32> = inputs.iter().map(calls).collect();
    let mut times = vec![f64::INFINITY; inputs.len()];
    for _ in 0..passes {
        for ((input, calls), time) in inputs.iter().zip(&calls).zip(&mut times) {
            *time = time.min(timed(input, *calls));
        }
    }
    times
}

/// Median, and what 1 %, 0.1 % and none of the values exceed.
#[derive(Debug, Clone, Copy)]
pub struct Tail {
    pub median: f64,
    pub hundredth: f64,
    pub thousandth: f64,
    pub worst: f64,
}

impl Tail {
    /// Of one value or more.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values[((values.len() - 1) as f64 * share).ceil() as usize];
        Self { median: at(0.5), hundredth: at(0.99), thousandth: at(0.999), worst: at(1.0) }
    }
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
        writeln!(
            f,
            "{:<44} {:>9} {:>19} {:>8} {:>15} {:>9}",
            self.title, "ns/call", "10 to 90 %", "ratio", "10 to 90 %", "of least"
        )?;
        for Line { name, nanoseconds: ns, ratio, least } in &self.lines {
            writeln!(
                f,
                "  {name:<42} {:>9.1} {:>8.1} to {:>7.1} {:>8.3} {:>6.3} to {:>5.3} {least:>9.3}",
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
    fn the_worst_call_is_the_one_of_most_work() {
        let work = |n: &usize| (0..*n).fold(1.0_f64, |y, _| black_box(y).sin());
        let times = least(&[20, 20, 400, 20], 5, Duration::from_micros(2), work);
        let Tail { median, worst, .. } = Tail::of(times.iter().copied());
        assert_eq!(worst, times[2], "{times:?}");
        assert!(worst > 4.0 * median, "{times:?}");
        let Tail { median, hundredth, thousandth, worst } = Tail::of((0..=1000).rev().map(f64::from));
        assert_eq!([median, hundredth, thousandth, worst], [500.0, 990.0, 999.0, 1000.0]);
    }

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
