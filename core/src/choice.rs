//! The choice of cuts at build time.

use core::ops::ControlFlow::Continue;

use crate::Chain;
use crate::general::{Cut, Cuts, Elimination, ScaledCut};
use crate::math::wrap;

/// Poses at which the cuts are compared.
const POSES: usize = 120;
/// A joint vector that differs by less, in rad or reaches, is found.
const SAME: f64 = 1e-6;
/// More candidates at one pose count as if none had been found: they cost too much.
const MOST: usize = 40;
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

/// What a cut does at the poses.
#[derive(Clone, Copy)]
struct Judgment {
    cut: Cut,
    /// Poses whose joint vector is not found, or for too much.
    missed: usize,
    /// Of the candidates before refinement.
    residuals: [f64; POSES],
    scales: [f64; POSES],
}

impl Judgment {
    /// The 90th percentile of the residuals.
    fn residual(&self) -> f64 {
        quantile(self.residuals, POSES * 9 / 10)
    }

    fn scaled(&self) -> ScaledCut {
        ScaledCut { cut: self.cut, scale: quantile(self.scales, POSES / 2) }
    }
}

fn quantile(mut values: [f64; POSES], place: usize) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[place]
}

/// Chooses the cuts of a chain. None if no cut serves.
pub fn choose(chain: &Chain<f64>) -> Option<Cuts> {
    choose_given(&|_| *chain)
}

/// As [`choose`] for a chain with given joints: `chain` makes it of their values, and takes each as an angle in rad from
/// its argument. Every other pose has round angles.
pub fn choose_given(chain: &dyn Fn(&mut dyn FnMut() -> f64) -> Chain<f64>) -> Option<Cuts> {
    let mut all =
        Cut::ALL.map(|cut| Judgment { cut, missed: usize::MAX, residuals: [0.0; POSES], scales: [0.0; POSES] });
    for judgment in &mut all {
        judge(judgment, chain);
    }
    all.sort_unstable_by(|a, b| a.missed.cmp(&b.missed).then(a.residual().total_cmp(&b.residual())));
    let [first, others @ ..] = all;
    if first.missed == usize::MAX {
        return None;
    }
    let second = others.iter().find(|x| x.cut.held() != first.cut.held() && x.missed <= first.missed + POSES / 10);
    Some(Cuts { first: first.scaled(), second: second.map(Judgment::scaled) })
}

fn judge(judgment: &mut Judgment, chain: &dyn Fn(&mut dyn FnMut() -> f64) -> Chain<f64>) -> Option<()> {
    let mut missed = 0;
    for pose in 0..POSES {
        let mut random = Random::of(pose);
        let chain = chain(&mut || random.angle()).gathered();
        let elimination = Elimination { scale: 0.0, ..Elimination::of(&chain, judgment.cut)? };
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
        let rest = elimination.search(&target, &joints, false, &mut |candidate| {
            count += 1;
            let near = distance(&candidate.joints);
            if near < least {
                (nearest, least) = (candidate.joints, near);
            }
            Continue(())
        });
        let before = chain.residual(&nearest, &target);
        let is_found = least < f64::INFINITY && distance(&chain.refined(&nearest, &target, EVALUATIONS).joints) < SAME;
        missed += usize::from(!is_found || !rest.is_complete || rest.wrong > 1e-5 || count > MOST);
        judgment.residuals[pose] = if is_found { before } else { f64::INFINITY };
        judgment.scales[pose] = rest.greatest;
    }
    judgment.missed = missed;
    Some(())
}
