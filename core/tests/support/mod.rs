//! Arms, random numbers, and the list of solutions that a search with a plain refinement gives.
#![allow(dead_code, clippy::unwrap_used, clippy::panic)]

pub mod arms;
pub mod refine;

use core::ops::ControlFlow;

use denhart_core::chain::Chain;
use denhart_core::held_joint::{Candidate, Outcome};
use denhart_core::math::wrap;
use denhart_core::transform::Transform;

pub type Joints = [f64; 6];

/// A small generator of random numbers (xorshift).
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn joints(&mut self) -> Joints {
        core::array::from_fn(|_| self.within(-core::f64::consts::PI, core::f64::consts::PI))
    }

    /// Angles that are multiples of a step, in degrees.
    pub fn grid(&mut self, step: f64) -> Joints {
        let count = (360.0 / step).round();
        core::array::from_fn(|_| wrap(((self.unit() * count).floor() * step).to_radians()))
    }
}

/// Solutions, refined and without repeats.
#[derive(Clone, Debug, Default)]
pub struct Solutions {
    pub list: Vec<Joints>,
    pub candidates: Vec<Candidate<f64>>,
    pub evaluations: usize,
    pub is_complete: bool,
    pub is_free: bool,
    /// The least residual of all candidates.
    pub nearest: f64,
    /// The greatest residual of a sure candidate before it is refined.
    pub sure: f64,
}

pub const EXACT: f64 = 1e-11;
pub const SAME: f64 = 1e-6;
const EVALUATIONS: usize = 300;

/// All solutions that a search gives. `search` gets the visitor.
pub fn solutions(
    chain: &Chain<f64>,
    target: &Transform<f64>,
    search: impl FnOnce(&mut dyn FnMut(&Candidate<f64>) -> ControlFlow<()>) -> Outcome,
) -> Solutions {
    let mut found = Solutions { nearest: f64::INFINITY, ..Solutions::default() };
    let outcome = search(&mut |candidate| {
        if found.evaluations >= EVALUATIONS {
            return ControlFlow::Break(());
        }
        let mut joints = candidate.joints;
        assert!(joints.iter().all(|joint| joint.is_finite()));
        let before = chain.residual(&joints, target);
        if !candidate.is_doubtful {
            found.sure = found.sure.max(before);
        }
        let (residual, evaluations) = refine::refine(chain, &mut joints, target);
        found.evaluations += evaluations;
        found.nearest = found.nearest.min(residual);
        if residual <= EXACT {
            for (joint, is_prismatic) in joints.iter_mut().zip(chain.is_prismatic) {
                *joint = if is_prismatic { *joint } else { wrap(*joint) };
            }
            found.is_free |= candidate.free != 0;
            if found.list.iter().all(|other| apart(chain, other, &joints) > SAME) {
                found.list.push(joints);
                found.candidates.push(*candidate);
            }
        }
        ControlFlow::Continue(())
    });
    found.is_complete = outcome.is_complete;
    found
}

/// The greatest difference of two joint vectors.
pub fn apart(chain: &Chain<f64>, a: &Joints, b: &Joints) -> f64 {
    let differences = a.iter().zip(b).zip(chain.is_prismatic);
    differences.fold(0.0, |most, ((a, b), is_prismatic)| {
        most.max(if is_prismatic { (a - b).abs() } else { wrap(a - b).abs() })
    })
}

impl Solutions {
    /// The distance of the nearest solution.
    pub fn distance(&self, chain: &Chain<f64>, joints: &Joints) -> f64 {
        self.list.iter().map(|found| apart(chain, found, joints)).fold(f64::INFINITY, f64::min)
    }
}
