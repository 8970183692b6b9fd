//! `denhart trace`: a motion law for every joint, sampled to the pose, velocity and acceleration of the tool, as CSV or
//! JSON.

mod advice;
mod jet;
mod law;
mod limits;
#[cfg(feature = "draw")]
pub mod plot;
mod samples;
mod token;

use std::fs::File;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::PathBuf;

use crate::Failure;
use crate::arm;
use crate::files;
use crate::number_arguments::single_number;
use crate::numbers::{Units, count};
use crate::progress::Progress;
use clap::{Args, ValueEnum};
use denhart::{Chain, JointKind, Pose};
use denhart_tools::Arm;
use denhart_tools::times::Times;
use jet::Jet;
use law::Law;
use limits::Limits;
use samples::{Samples, Top};
use token::LawError;

/// How many samples pass between two looks at the clock.
const BETWEEN_LOOKS: u64 = 512;
/// The fewest steps of a curve.
#[cfg(feature = "draw")]
const PLOTTED: u32 = 160;
/// The most steps of a curve.
#[cfg(feature = "draw")]
const MOST_PLOTTED: u32 = 20_000;
/// The progress bar.
const BAR: &str = "{wide_bar} {human_pos}/{human_len} samples, {eta} left";

/// The arguments of the command.
#[derive(Args)]
pub struct Options {
    /// The arm file, YAML; `-` reads the standard input
    file: PathBuf,
    /// The value of every joint as an expression in the time t (s), separated by commas: "3t, -90 + 3t, 20 sin(pi t)"
    ///
    /// Numbers, t, pi, e, + - * / ^, parentheses, and products without a sign (3t). The functions: sin cos tan asin acos
    /// atan sinh cosh tanh exp ln sqrt abs. Arguments of sin and the like are rad always.
    #[arg(long, value_name = "LAWS", allow_hyphen_values = true)]
    law: String,
    /// First time, s
    #[arg(long, value_name = "T", default_value_t = 0.0, allow_hyphen_values = true, value_parser = single_number)]
    from: f64,
    /// Last time, s; a sample if the range is a whole number of steps
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = single_number)]
    to: f64,
    /// Time between two samples, s
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = single_number)]
    step: f64,
    /// Unit of angles, in the laws of turning joints and in the output
    #[arg(long, value_name = "UNIT", default_value = "deg", value_parser = crate::numbers::units())]
    units: Units,
    /// How the orientation of the tool is printed
    #[arg(long, value_name = "FORM", default_value = "rpy")]
    orientation: Orientation,
    /// End before the first sample with a joint beyond its limits, with exit status 1
    #[arg(long)]
    stop_at_limits: bool,
    /// Print JSON: an object with the units, and one for each sample
    #[arg(long)]
    json: bool,
    /// Write to this file instead of the standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draw the curves too: joints with their limits, position, velocities and accelerations of the tool over time, as SVG
    #[cfg(feature = "draw")]
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Orientation {
    /// Roll, pitch, yaw: R = Rz(yaw) Ry(pitch) Rx(roll); roll is 0 where the pitch is +-90 degrees
    Rpy,
    /// Unit quaternion, scalar part first
    Quaternion,
    /// Rotation matrix, row by row
    Matrix,
}

impl Orientation {
    fn header(self) -> &'static [&'static str] {
        match self {
            Self::Rpy => &["roll", "pitch", "yaw"],
            Self::Quaternion => &["qw", "qx", "qy", "qz"],
            Self::Matrix => &["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"],
        }
    }

    fn of(self, pose: &Pose<f64>, angle: Units) -> Vec<f64> {
        match self {
            Self::Rpy => pose.rpy().angles.map(|x| angle.of(x)).to_vec(),
            Self::Quaternion => pose.quaternion().to_vec(),
            Self::Matrix => pose.rotation.as_flattened().to_vec(),
        }
    }
}

/// Writes the trace to `out`, or to the file named in the options.
pub fn run(options: &Options, out: &mut dyn Write) -> Result<(), Failure> {
    let times = Times::new(options.from, options.to, options.step).map_err(Failure::Usage)?;
    let text = &options.law;
    let wrong = |error: &LawError, wanted: Option<usize>| {
        let help = advice::advice(text, wanted).map_or_else(String::new, |help| format!("\nhelp: {help}"));
        Failure::Usage(pointed(text, error) + &help)
    };
    let laws = law::parse(text).map_err(|error| wrong(&error, None))?;
    let Arm { chain, model } = arm::read(&options.file).map_err(Failure::Other)?;
    let names: Vec<String> = model.joints.iter().map(|joint| joint.name.clone()).collect();
    match_up(text, &laws, &names).map_err(|error| wrong(&error, Some(names.len())))?;
    let trace = Trace {
        kinds: chain.kinds(),
        limits: Limits::of(&model, options.units),
        top: options.json.then(|| Top::of(&model, options.units)),
        stops: options.stop_at_limits,
        chain,
        laws,
        times,
        angle: options.units,
        form: options.orientation,
    };
    // Without a first sample there is no table. JSON says why there is none.
    if trace.top.is_none() {
        trace.first()?;
    }
    apart(options)?;
    #[cfg(feature = "draw")]
    if let Some(path) = &options.plot {
        trace.plot(&model, path)?;
    }
    match &options.output {
        None => trace.write(out, !io::stdout().is_terminal()),
        Some(path) => {
            let cannot = |error: io::Error| Failure::Other(format!("cannot write `{}`: {error}", path.display()));
            let mut file = BufWriter::new(File::create(path).map_err(cannot)?);
            trace.write(&mut file, true)
        }
    }
}

/// No two of arm file, table and picture are one file.
fn apart(options: &Options) -> Result<(), Failure> {
    let mut places = vec![("the arm file", options.file.as_path())];
    places.extend(options.output.as_deref().map(|path| ("-o", path)));
    #[cfg(feature = "draw")]
    places.extend(options.plot.as_deref().map(|path| ("--plot", path)));
    for (number, (name, path)) in places.iter().enumerate() {
        if let Some((other, _)) = places.iter().take(number).find(|(_, other)| files::are_one(other, path)) {
            let path = path.display();
            return Err(Failure::Usage(format!("{name}: `{path}` is {other} too\nhelp: name another file")));
        }
    }
    Ok(())
}

/// One law for every joint.
fn match_up(text: &str, laws: &[Law], names: &[String]) -> Result<(), LawError> {
    let at = laws.get(names.len()).map_or(text.len(), |surplus| surplus.at);
    if laws.len() == names.len() {
        return Ok(());
    }
    let (laws, joints) = (count(laws.len(), "law"), count(names.len(), "joint"));
    let names = names.join(", ");
    Err(LawError { at, message: format!("{laws} for {joints}; one for each is needed: {names}") })
}

/// The message, and the text with a mark under the place. A long text is cut around it.
fn pointed(text: &str, error: &LawError) -> String {
    const AROUND: usize = 50;
    let LawError { at, message } = error;
    let before: Vec<char> = text.get(..*at).unwrap_or_default().chars().collect();
    let after: Vec<char> = text.get(*at..).unwrap_or_default().chars().take(AROUND).collect();
    let cut = before.len().saturating_sub(AROUND);
    let shown: String =
        before.iter().skip(cut).chain(&after).map(|c| if c.is_whitespace() { ' ' } else { *c }).collect();
    let mark = " ".repeat(before.len() - cut);
    format!("--law, character {}: {message}\n  {shown}\n  {mark}^", before.len() + 1)
}

struct Trace {
    chain: Chain,
    kinds: Vec<JointKind>,
    limits: Limits,
    /// The trace ends where a limit is broken.
    stops: bool,
    laws: Vec<Law>,
    times: Times,
    /// The keys of JSON beside the samples; none of CSV.
    top: Option<Top>,
    angle: Units,
    form: Orientation,
}

impl Trace {
    /// All samples; a progress bar if `may_show` and it takes long.
    fn write(&self, out: &mut dyn Write, may_show: bool) -> Result<(), Failure> {
        let joints = (1..=self.kinds.len()).map(|joint| format!("q{joint}"));
        let pose = ["x", "y", "z"].iter().chain(self.form.header());
        let motion = ["vx", "vy", "vz", "wx", "wy", "wz", "ax", "ay", "az", "dwx", "dwy", "dwz", "out_of_limits"];
        let names = pose.chain(&motion).map(|name| (*name).to_owned());
        let names: Vec<String> = ["t".to_owned()].into_iter().chain(joints).chain(names).collect();
        let mut samples = Samples::begin(out, &names, self.top.as_ref())?;
        let ended = self.samples(&mut samples, may_show);
        let stopped = match &ended {
            Err(Failure::Other(message)) => Some(message.as_str()),
            _ => None,
        };
        samples.end(stopped)?;
        ended
    }

    /// Writes the curves, up to the first time without a sample.
    #[cfg(feature = "draw")]
    fn plot(&self, model: &denhart_codegen::model::Model, path: &std::path::Path) -> Result<(), Failure> {
        use plot::{Curve, Panel};
        if path.extension().is_none_or(|kind| !kind.eq_ignore_ascii_case("svg")) {
            let given = path.display();
            return Err(Failure::Usage(format!("--plot: `{given}` is no SVG\nhelp: write a name that ends in .svg")));
        }
        let count = self.times.count();
        let (first, last) = (self.times.at(0), self.times.at(count.saturating_sub(1)));
        let (mut times, mut rows) = (Vec::new(), Vec::new());
        // The samples of the table, where they are neither too few for a smooth curve nor too many.
        let is_table = (u64::from(PLOTTED)..=u64::from(MOST_PLOTTED)).contains(&count);
        let parts = if count > u64::from(PLOTTED) { MOST_PLOTTED } else { PLOTTED };
        let at = |index: u32| match is_table {
            true => self.times.at(u64::from(index)),
            false => first + (last - first) * f64::from(index) / f64::from(parts),
        };
        let title = match count > u64::from(MOST_PLOTTED) {
            true => format!("{}: {MOST_PLOTTED} of {count} samples", model.name),
            false => model.name.clone(),
        };
        let most = if is_table { u32::try_from(count).unwrap_or(MOST_PLOTTED).saturating_sub(1) } else { parts };
        for t in (0..=most).map(at) {
            match self.sample(t) {
                Ok(Sample { values, broken: None }) => rows.push(values),
                _ => break,
            }
            times.push(t);
        }
        if rows.is_empty() {
            return Err(Failure::Other(format!("--plot: no sample at t = {first}, so there is no curve")));
        }
        let column = |index: usize| rows.iter().filter_map(|row| row.get(index).copied()).collect::<Vec<f64>>();
        let (length, angle) = (model.length_unit.symbol(), self.angle.symbol());
        let joints = |kind: JointKind, unit: f64| -> Vec<Curve> {
            let own = (1..).zip(&model.joints).zip(&self.kinds).filter(|(_, other)| **other == kind);
            own.map(|((number, joint), _)| Curve {
                name: joint.name.clone(),
                values: column(number),
                limits: joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]).map(|limit| limit / unit),
            })
            .collect()
        };
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        // Behind the time, the joints and the position stands the orientation.
        let position = 1 + self.kinds.len();
        let rates = position + 3 + self.form.header().len();
        let three = |title: &str, unit: String, start: usize, names: [&str; 3]| {
            let curves = (start..).zip(names).map(|(index, name)| Curve {
                name: name.to_owned(),
                values: column(index),
                limits: free,
            });
            Panel { title: title.to_owned(), unit, curves: curves.collect() }
        };
        let panels = [
            Panel {
                title: "joints".to_owned(),
                unit: angle.to_owned(),
                curves: joints(JointKind::Revolute, self.angle.in_rad()),
            },
            Panel { title: "slides".to_owned(), unit: length.to_owned(), curves: joints(JointKind::Prismatic, 1.0) },
            three("position of the tool", length.to_owned(), position, ["x", "y", "z"]),
            three("velocity", format!("{length}/s"), rates, ["vx", "vy", "vz"]),
            three("angular velocity", format!("{angle}/s"), rates + 3, ["wx", "wy", "wz"]),
            three("acceleration", format!("{length}/s\u{b2}"), rates + 6, ["ax", "ay", "az"]),
            three("angular acceleration", format!("{angle}/s\u{b2}"), rates + 9, ["dwx", "dwy", "dwz"]),
        ];
        let panels: Vec<Panel> = panels.into_iter().filter(|panel| !panel.curves.is_empty()).collect();
        let text = plot::svg(&title, &times, &panels).map_err(Failure::Other)?;
        let cannot = |error: io::Error| Failure::Other(format!("cannot write `{}`: {error}", path.display()));
        std::fs::write(path, text).map_err(cannot)
    }

    /// Fails without a first sample.
    fn first(&self) -> Result<(), Failure> {
        match self.sample(self.times.at(0))?.broken {
            Some(message) => Err(Failure::Other(message)),
            None => Ok(()),
        }
    }

    /// The samples up to the last, or to the first that is none.
    fn samples(&self, samples: &mut Samples, may_show: bool) -> Result<(), Failure> {
        let mut progress = Progress::new(self.times.count(), BAR, BETWEEN_LOOKS, may_show);
        for index in 0..self.times.count() {
            let row = self.sample(self.times.at(index))?;
            if let Some(message) = row.broken {
                return Err(Failure::Other(message));
            }
            samples.push(&row.values)?;
            progress.look(index);
        }
        Ok(())
    }

    /// One row.
    fn sample(&self, t: f64) -> Result<Sample, Failure> {
        let mut values = Vec::with_capacity(self.laws.len());
        for (law, kind) in self.laws.iter().zip(&self.kinds) {
            let jet = law.at(t);
            if !jet.is_finite() {
                return Err(Failure::Other(undefined(law, jet, t)));
            }
            values.push((jet, if *kind == JointKind::Revolute { self.angle.in_rad() } else { 1.0 }));
        }
        let q: Vec<f64> = values.iter().map(|(jet, unit)| unit * jet.value).collect();
        let qd: Vec<f64> = values.iter().map(|(jet, unit)| unit * jet.first).collect();
        let qdd: Vec<f64> = values.iter().map(|(jet, unit)| unit * jet.second).collect();
        let other = |error: denhart::ChainError| Failure::Other(error.to_string());
        let pose = Pose::from(self.chain.forward(&q).map_err(other)?);
        let velocity = self.chain.velocity(&q, &qd).map_err(other)?;
        let acceleration = self.chain.acceleration(&q, &qd, &qdd).map_err(other)?;

        let mut row = vec![t];
        row.extend(values.iter().map(|(jet, _)| jet.value));
        row.extend(pose.translation);
        row.extend(self.form.of(&pose, self.angle));
        row.extend(velocity.linear);
        row.extend(velocity.angular.map(|w| self.angle.of(w)));
        row.extend(acceleration.linear);
        row.extend(acceleration.angular.map(|w| self.angle.of(w)));
        row.push(self.limits.broken(&q));
        let broken = self.limits.first(&q).filter(|_| self.stops);
        let broken = broken.map(|broken| format!("at t = {t} {broken}"));
        Ok(Sample { values: row, broken })
    }
}

/// A row of the output.
struct Sample {
    values: Vec<f64>,
    /// Which limit is broken, where the trace is to end there.
    broken: Option<String>,
}

/// Which of value, rate and its derivative is missing.
fn undefined(law: &Law, jet: Jet, t: f64) -> String {
    let (what, value) = if !jet.value.is_finite() {
        ("value", jet.value)
    } else if !jet.first.is_finite() {
        ("rate", jet.first)
    } else {
        ("acceleration", jet.second)
    };
    format!("the law `{law}` has no finite {what} at t = {t}: {value}")
}
