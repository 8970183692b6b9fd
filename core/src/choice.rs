//! The choice of cuts at build time.

use core::cmp::Ordering;
use core::ops::ControlFlow::{Break, Continue};
use core::ops::Range;

use crate::Chain;
use crate::general::{Cut, Cuts, Elimination, Part, Rest};
use crate::math::wrap;

/// Poses at which the cuts are compared.
const POSES: usize = 120;
/// Rounds of poses. After the first one the useless cuts go, after the others the worse one of each joint.
const ROUNDS: [Range<usize>; 3] = [0..16, 16..40, 40..POSES];
/// The poses with random angles: every other one.
const RANDOM: u128 = u128::MAX / 3;
/// A joint vector that differs by less, in rad or reaches, is found.
const SAME: f64 = 1e-6;
/// More candidates at one pose cost too much.
const MOST: usize = 60;
/// Evaluations for the refinement of one candidate.
const EVALUATIONS: usize = 15;
/// Round angles are multiples of this.
const ROUND: f64 = core::f64::consts::FRAC_PI_4;

/// Deterministic numbers (xorshift), the same for every cut.
struct Random {
    state: u64,
    is_round: bool,
}

impl Random {
    fn of(pose: usize) -> Self {
        let mut random = Self { state: 0x9E37_79B9_7F4A_7C15 ^ (pose as u64 + 1) << 17, is_round: pose % 2 == 1 };
        (0..8).for_each(|_| {
            random.angle();
        });
        random
    }

    /// An angle, rad.
    fn angle(&mut self) -> f64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        let unit = (self.state >> 11) as f64 / (1_u64 << 53) as f64;
        let angle = (2.0 * unit - 1.0) * core::f64::consts::PI;
        if self.is_round { crate::Scalar::round_ties_even(angle / ROUND) * ROUND } else { angle }
    }
}

/// The record of a cut at the poses.
#[derive(Clone, Copy)]
struct Judgment {
    cut: Cut,
    /// False for a cut that has been given up.
    is_open: bool,
    /// The number of poses so far.
    poses: usize,
    /// Poses, as bits, whose joint vector is not found.
    lost: u128,
    /// Poses that are lost for good: nothing was in doubt, and no other cut follows.
    gone: u128,
    /// Of the candidate nearest to the joint vector, before refinement.
    residuals: [f64; POSES],
}

impl Judgment {
    /// The median of the residuals.
    fn residual(&self) -> f64 {
        median(self.residuals, self.poses)
    }

    /// Returns true for a cut that holds the first joint or the last one. With the last axis on the first, these are free,
    /// and other cuts tell nothing.
    fn holds_an_end(&self) -> bool {
        matches!(self.cut.held(), 0 | 5)
    }

    /// Returns false for a cut that loses too many random poses.
    fn serves(&self) -> bool {
        8 * (self.lost & RANDOM).count_ones() as usize <= self.poses
    }

    /// The exponent of the residual, to the base 2. Each random pose that is lost counts as a factor of 4.
    fn exponent(&self) -> i64 {
        let exponent = (self.residual().to_bits() >> 52) as i64;
        exponent + 2 * i64::from((self.lost & RANDOM).count_ones())
    }

    /// Better ones first: fewer poses lost for good, random ones before all; a lesser residual; fewer poses lost.
    ///
    /// Where a cut is in doubt others follow and find what it loses. So the digits that a cut leaves matter more than one
    /// pose or two. With the poses first, a Puma off by 1e-6 lost five times as many branches beside its folded elbow.
    fn compare(&self, other: &Self) -> Ordering {
        let rank = |x: &Self| {
            let gone = ((x.gone & RANDOM).count_ones(), x.gone.count_ones());
            (!x.is_open, gone, x.exponent(), x.lost.count_ones())
        };
        rank(self).cmp(&rank(other)).then_with(|| self.residual().total_cmp(&other.residual()))
    }
}

/// The median of the first `len` values.
fn median(mut values: [f64; POSES], len: usize) -> f64 {
    let values = values.get_mut(..len).unwrap_or(&mut []);
    values.sort_unstable_by(f64::total_cmp);
    values.get(len / 2).copied().unwrap_or(f64::INFINITY)
}

/// A chain, made of the angles of its given joints.
type Make<'a> = dyn Fn(&mut dyn FnMut() -> f64) -> Chain<f64> + 'a;

/// Chooses the cuts of a chain. None if no cut serves.
///
/// At 120 poses, half of them with round angles, each cut is asked for the joint vector that made the pose. The first
/// cut is the one that loses the fewest for good, of those that lose few random poses the one that leaves the least residual
/// before refinement. The second and the third one hold other joints, and find what those before them lose. A
/// cut is given up as soon as it loses a quarter of the random poses, and if another one that holds the same joint is
/// better. Cuts of the arm are taken if they serve, as their constants are known before the call; else cuts of the target.
pub fn choose(chain: &Chain<f64>) -> Option<Cuts> {
    choose_given(&|_| *chain)
}

/// As [`choose`] for a chain with given joints: `chain` makes it of their values, and takes each as an angle in rad from
/// its argument. Every other pose has round angles.
pub fn choose_given(chain: &Make) -> Option<Cuts> {
    match chosen(Cut::OF_ARM, chain) {
        Some((cuts, lost)) if lost == 0 || cuts.second.is_some() => Some(cuts),
        // What a cut without others loses, nothing finds.
        of_arm => {
            let all = of_arm.into_iter().chain(chosen(Cut::OF_TARGET, chain));
            all.min_by_key(|(_, lost)| *lost).map(|(cuts, _)| cuts)
        }
    }
}

/// The choice among some cuts, and how many random poses its first cut loses.
fn chosen(cuts: [Cut; 12], chain: &Make) -> Option<(Cuts, u32)> {
    let none = [f64::INFINITY; POSES];
    let mut all = cuts.map(|cut| Judgment { cut, is_open: true, poses: 0, lost: 0, gone: 0, residuals: none });
    for (round, poses) in ROUNDS.into_iter().enumerate() {
        for judgment in all.iter_mut().filter(|judgment| judgment.is_open) {
            judge(judgment, poses.clone(), chain);
            judgment.is_open = judgment.serves();
        }
        if round > 0 {
            keep_the_best_of_each_joint(&mut all);
        }
    }
    let open = || all.iter().filter(|x| x.is_open);
    let first = open().min_by(|a, b| a.compare(b))?;
    // Another cut for what is still lost.
    let next = |lost: u128, held: &[usize], is_at_end: bool| {
        let holds = |x: &&Judgment| !held.contains(&x.cut.held()) && (!is_at_end || x.holds_an_end());
        let others = open().filter(holds);
        others.min_by(|a, b| (a.lost & lost).count_ones().cmp(&(b.lost & lost).count_ones()).then_with(|| a.compare(b)))
    };
    let second = next(first.lost, &[first.cut.held()], false);
    let third = second.and_then(|x| {
        let (lost, held) = (first.lost & x.lost, [first.cut.held(), x.cut.held()]);
        let has_an_end = first.holds_an_end() || x.holds_an_end();
        let at_end = if has_an_end { None } else { next(lost, &held, true) };
        at_end.or_else(|| next(lost, &held, false))
    });
    let [second, third] = [second, third].map(|x| x.map(|x| x.cut));
    Some((Cuts { first: first.cut, second, third }, (first.lost & RANDOM).count_ones()))
}

/// Of two cuts that hold the same joint the worse one is given up.
fn keep_the_best_of_each_joint(all: &mut [Judgment; 12]) {
    let before = *all;
    for judgment in all {
        let is_better = |other: &Judgment| {
            other.is_open && other.cut.held() == judgment.cut.held() && other.compare(judgment) == Ordering::Less
        };
        judgment.is_open &= !before.iter().any(is_better);
    }
}

/// Asks a cut for the joint vectors of some poses. Those at which it has no constants are lost.
fn judge(judgment: &mut Judgment, poses: Range<usize>, chain: &Make) {
    // Each cut by itself.
    let part = Part { number: 0, has_families: true, moved: 0.0 };
    for pose in poses {
        let mut random = Random::of(pose);
        let chain = chain(&mut || random.angle()).gathered();
        let joints = chain
            .is_prismatic
            .map(|slides| random.angle() * if slides { 0.5 * chain.reach / core::f64::consts::PI } else { 1.0 });
        let distance = |other: &[f64; 6]| {
            let mut most = 0.0_f64;
            for ((x, y), slides) in joints.iter().zip(other).zip(chain.is_prismatic) {
                most = most.max(if slides { (x - y).abs() / chain.reach } else { wrap(x - y).abs() });
            }
            most
        };
        let target = chain.pose(&joints);
        let (mut nearest, mut least, mut count) = (joints, f64::INFINITY, 0);
        let rest = Elimination::at(&chain, judgment.cut, &target).map_or(Rest::USELESS, |elimination| {
            elimination.search(&target, &joints, part, &mut |candidate| {
                count += 1;
                let near = distance(&candidate.joints);
                if near < least {
                    (nearest, least) = (candidate.joints, near);
                }
                if count > MOST { Break(()) } else { Continue(()) }
            })
        });
        let is_near = least < f64::INFINITY;
        let is_found = is_near && distance(&chain.refined(&nearest, &target, EVALUATIONS).joints) < SAME;
        let is_lost = !is_found || !rest.is_complete || (!random.is_round && rest.is_useless);
        judgment.lost |= u128::from(is_lost) << pose;
        judgment.gone |= u128::from(is_lost && !rest.is_doubtful) << pose;
        if let Some(residual) = judgment.residuals.get_mut(judgment.poses) {
            *residual = if is_found { chain.residual(&nearest, &target) } else { f64::INFINITY };
            judgment.poses += 1;
        }
    }
}
