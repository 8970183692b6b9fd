//! The digests of the program in C on the chip beside those of Rust on this machine.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use firmware_arms::salman_rrr_f32::Robot;
use firmware_cases::{Bits, Digest, Random};

use denhart::{Branch, Flags, Pose, Scalar, Solution, Solutions, Status};

use crate::Error;

/// `CASES` in `c/main.c`.
const CASES: usize = 2_000;
/// The most differences that are listed.
const LISTED: usize = 20;

/// Compares what the chip printed with what Rust computes here.
///
/// # Errors
/// A result differs, or lines are missing.
pub fn compare(file: &Path) -> Result<(), Error> {
    let chip = fs::read_to_string(file)?;
    let host = host();
    let pairs = host.lines().zip(chip.lines().chain(std::iter::repeat("nothing")));
    let mut differences: Vec<String> = pairs
        .enumerate()
        .filter(|(_, (host, chip))| host != chip)
        .map(|(case, (host, chip))| format!("case {case}: {chip}, in Rust {host}"))
        .collect();
    if chip.lines().count() > host.lines().count() {
        differences.push("the chip printed more lines".to_owned());
    }
    if differences.is_empty() {
        println!("salman_rrr_f32 in C: {CASES} cases of 7 functions, every bit equal to Rust");
        return Ok(());
    }
    let count = differences.len();
    differences.truncate(LISTED);
    Err(format!("{count} cases differ between C on the chip and Rust:\n{}", differences.join("\n")).into())
}

/// The words of a result, and their digest in the line.
struct Line(String);

impl Line {
    fn put(&mut self, words: &[&dyn Bits]) {
        let mut digest = Digest::new();
        for word in words {
            digest.add(*word);
        }
        let _ = write!(self.0, " {:08x}", digest.value());
    }
}

/// As in the header: status and gap.
fn status(status: Status<f32>) -> (i32, f32) {
    match status {
        Status::Reachable => (0, 0.0),
        Status::Unreachable { residual } => (1, residual),
        Status::BadTarget => (2, 0.0),
    }
}

/// Numbers one by one: a list of the digest has its length before it.
struct Each<'a, T>(&'a [T]);

impl<T: Bits> Bits for Each<'_, T> {
    fn add_to(&self, digest: &mut Digest) {
        self.0.iter().for_each(|number| digest.add(number));
    }
}

struct InC<'a>(&'a Solution<f32, 3>);

impl Bits for InC<'_> {
    fn add_to(&self, digest: &mut Digest) {
        let Solution { q, flags, free, branch, residual } = self.0;
        digest.add(&Each(q));
        digest.add(&Each(&[residual.position, residual.orientation]));
        let all = [Flags::EXACT, Flags::BOUNDARY, Flags::FREE, Flags::APPROXIMATE, Flags::OUT_OF_LIMITS];
        let bit = |(place, flag): (usize, &Flags)| i32::from(flags.contains(*flag)) << place;
        digest.add(&all.iter().enumerate().map(bit).sum::<i32>());
        digest.add(&free.iter().map(|joint| 1 << joint).sum::<i32>());
        let parts = [
            branch.shoulder().map_or(0, |part| part as u8),
            branch.elbow().map_or(0, |part| part as u8),
            branch.wrist().map_or(0, |part| part as u8),
            branch.root().unwrap_or(0),
        ];
        digest.add(&i32::from_le_bytes(parts));
    }
}

struct AllInC<'a>(&'a Solutions<f32, 3, 4>);

impl Bits for AllInC<'_> {
    fn add_to(&self, digest: &mut Digest) {
        let (code, gap) = status(self.0.status());
        digest.add(&code);
        digest.add(&self.0.len());
        digest.add(&Each(&[gap, self.0.deviation()]));
        self.0.iter().for_each(|solution| digest.add(&InC(solution)));
    }
}

struct PoseInC(Pose<f32>);

impl Bits for PoseInC {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&Each(self.0.rotation.as_flattened()));
        digest.add(&Each(&self.0.translation));
    }
}

/// Output of this machine for the cases that `c/main.c` makes.
fn host() -> String {
    const OK: i32 = 0;
    const BAD_ARGUMENT: i32 = 3;
    let mut random = Random::new(3);
    let mut text = String::new();
    for case in 0..CASES {
        let mut line = Line("C".to_owned());
        let (mut q, mut q_ref) = ([0.0; 3], [0.0; 3]);
        for (q, q_ref) in q.iter_mut().zip(&mut q_ref) {
            *q = random.between(-3.0, 3.0);
            if case % 5 == 1 {
                *q = f32::FRAC_PI_2 * ((random.bits() >> 60) as i32 - 8) as f32;
            }
            *q_ref = *q + random.between(-0.5, 0.5);
        }
        let pose = Robot.forward(&q);
        line.put(&[&OK, &PoseInC(pose)]);
        let mut target = pose.translation;
        for x in &mut target {
            let any = f32::from_bits((random.bits() >> 32) as u32);
            match case % 5 {
                2 => *x *= random.between(0.5, 4.0),
                3 => *x = any,
                _ => {}
            }
        }
        line.put(&[&OK, &Each(Robot.jacobian(&q).rows.as_flattened())]);
        let (pose, jacobian) = Robot.forward_and_jacobian(&q);
        line.put(&[&OK, &PoseInC(pose), &Each(jacobian.rows.as_flattened())]);
        line.put(&[&AllInC(&Robot.inverse_near(&target, &q_ref))]);
        let all = Robot.inverse(&target);
        line.put(&[&AllInC(&all)]);
        let branch = all.get(case % all.len().max(1)).map_or(Branch::NONE, |solution| solution.branch);
        match Robot.inverse_branch(&target, branch) {
            Ok(one) => line.put(&[&OK, &0.0_f32, &InC(&one)]),
            Err(outcome) => {
                let (code, gap) = status(outcome);
                // Zeros: three joint values, two residuals, then flags, joints and branch.
                line.put(&[&code, &gap, &Each(&[0.0_f32; 5]), &Each(&[0_i32; 3])]);
            }
        }
        let (pulses, saturated) = Robot.to_pulses_checked(&q);
        let ends: i32 = saturated.iter().map(|motor| 1 << motor).sum();
        line.put(&[&OK, &Each(&pulses), &ends, &Each(&Robot.from_pulses(&pulses))]);
        line.put(&[&BAD_ARGUMENT, &BAD_ARGUMENT]);
        text += &line.0;
        text.push('\n');
    }
    text
}
