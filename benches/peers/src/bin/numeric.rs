//! Numeric inverse kinematics of denhart beside `k::JacobianIkSolver`. Success and time are measured on random
//! reachable poses from random starts. The runs are from one start and with up to 20 restarts.
//!
//! `cargo run --release --bin numeric [POSES]`

use std::time::{Duration, Instant};

use denhart::numeric::NumericInverse;
use denhart::{Arm, Chain, DhTable, Pose};
use denhart_peers::arms::{FrankaPanda, KinovaJaco, Puma560, Ur5};
use denhart_peers::k_chain;
use denhart_peers::random::Random;
use k::InverseKinematicsSolver as _;

/// Both sides: m and rad.
const TOLERANCE: f64 = 1e-6;
/// Both sides: steps from one start.
const ITERATIONS: usize = 100;
/// Both sides.
const RESTARTS: usize = 20;
/// k: the part of a Newton step that is taken. Its default; whole steps find fewer, save on the Puma 560.
const MULTIPLIER: f64 = 0.5;
/// Poses that one side solves before the other one does, so that a drift of the machine meets both.
const BLOCK: usize = 100;

/// Counts of one side.
#[derive(Default)]
struct Tally {
    converged: usize,
    wrong: usize,
    time: Duration,
}

/// The joint vectors of a run, and who judges them.
struct Problem<const N: usize> {
    chain: Chain,
    limits: [[f64; 2]; N],
    targets: Vec<Pose<f64>>,
    starts: Vec<[f64; N]>,
}

impl<const N: usize> Problem<N> {
    /// Targets are poses of joint vectors uniform within the limits (without limits within half a turn), starts are
    /// further such joint vectors.
    fn new<A: Arm<f64, N>>(name: &str, table: &DhTable, count: usize) -> Self {
        let mut random = Random::named(name);
        let limits = A::LIMITS;
        let mut draw = || draw(&limits, &mut random);
        let chain = Chain::from(*table);
        let targets = (0..count).map(|_| Pose::from(chain.forward(&draw()).expect("as many joints"))).collect();
        Self { chain, limits, targets, starts: (0..count).map(|_| draw()).collect() }
    }

    /// Adds an answer, and checks one that claims to converge by the chain. The two sides and the chain round
    /// differently, by far less than a hundredth of the tolerance.
    fn judge(&self, tally: &mut Tally, index: usize, answer: Option<[f64; N]>) {
        let Some(q) = answer else { return };
        let reached = Pose::from(self.chain.forward(&q).expect("as many joints"));
        let miss = self.targets[index].residual(&reached);
        let inside = q.iter().zip(&self.limits).all(|(q, [low, high])| (low..=high).contains(&q));
        let close = miss.position < 1.01 * TOLERANCE && miss.orientation < 1.01 * TOLERANCE;
        tally.converged += 1;
        tally.wrong += usize::from(!(inside && close));
    }
}

fn draw<const N: usize>(limits: &[[f64; 2]; N], random: &mut Random) -> [f64; N] {
    use std::f64::consts::PI;
    limits.map(|[low, high]| if low.is_finite() { random.uniform(low, high) } else { random.uniform(-PI, PI) })
}

/// Runs both sides on the same problem in turns.
fn compare<A: Arm<f64, N> + Copy, const N: usize>(name: &str, arm: A, table: &DhTable, count: usize) {
    let problem = Problem::<N>::new::<A>(name, table, count);
    for restarts in [0, RESTARTS] {
        let ours = NumericInverse::new().tolerance(TOLERANCE, TOLERANCE).max_iterations(ITERATIONS).restarts(restarts);
        let theirs = k::JacobianIkSolver::new(TOLERANCE, TOLERANCE, MULTIPLIER, ITERATIONS);
        let serial = k_chain::chain(table, &problem.limits);
        let their_targets: Vec<_> = problem.targets.iter().map(k_chain::target).collect();
        let mut random = Random::named("restarts of k");
        let [mut our_tally, mut their_tally] = [Tally::default(), Tally::default()];
        let indices: Vec<usize> = (0..count).collect();
        for block in indices.chunks(BLOCK) {
            let start = Instant::now();
            let answers: Vec<_> =
                block.iter().map(|&index| ours.solve(&arm, &problem.targets[index], &problem.starts[index])).collect();
            our_tally.time += start.elapsed();
            for (&index, answer) in block.iter().zip(&answers) {
                problem.judge(&mut our_tally, index, answer.converged().then_some(answer.q));
            }

            let start = Instant::now();
            let answers: Vec<_> = block
                .iter()
                .map(|&index| {
                    serial.set_joint_positions_clamped(&problem.starts[index]);
                    let mut converged = theirs.solve(&serial, &their_targets[index]).is_ok();
                    for _ in 0..restarts {
                        if converged {
                            break;
                        }
                        serial.set_joint_positions_clamped(&draw(&problem.limits, &mut random));
                        converged = theirs.solve(&serial, &their_targets[index]).is_ok();
                    }
                    converged.then(|| <[f64; N]>::try_from(serial.joint_positions()).expect("as many joints"))
                })
                .collect();
            their_tally.time += start.elapsed();
            for (&index, answer) in block.iter().zip(answers) {
                problem.judge(&mut their_tally, index, answer);
            }
        }
        print_line(name, restarts, "denhart", &our_tally, count, 1.0);
        let ratio = their_tally.time.as_secs_f64() / our_tally.time.as_secs_f64();
        print_line(name, restarts, "k", &their_tally, count, ratio);
    }
}

fn print_line(arm: &str, restarts: usize, side: &str, tally: &Tally, count: usize, ratio: f64) {
    let rate = 100.0 * tally.converged as f64 / count as f64;
    let missed = count - tally.converged;
    let micros = tally.time.as_secs_f64() * 1e6 / count as f64;
    let wrong = tally.wrong;
    println!("{arm:<14} {restarts:>8} {side:<8} {rate:>9.2} % {missed:>7} {wrong:>6} {micros:>12.1} {ratio:>9.1}");
}

fn main() {
    let count = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(10_000);
    println!("{count} poses; tolerance {TOLERANCE:.0e} m and rad; {ITERATIONS} iterations from a start");
    println!("wrong: converged by its own account, but not by the chain, or beyond a limit\n");
    println!(
        "{:<14} {:>8} {:<8} {:>11} {:>7} {:>6} {:>12} {:>9}",
        "arm", "restarts", "", "success", "missed", "wrong", "us/pose", "ratio"
    );
    compare("ur5", Ur5, &Ur5::DH, count);
    compare("puma560", Puma560, &Puma560::DH, count);
    compare("franka_panda", FrankaPanda, &FrankaPanda::DH, count);
    compare("kinova_jaco", KinovaJaco, &KinovaJaco::DH, count);
}
