//! Arms, random numbers, and the list of solutions that a search with a plain refinement gives.

use core::ops::ControlFlow;

use denhart_core::math::{Scalar, wrap};
use denhart_core::meet::{Meet, Structure};
use denhart_core::{Candidate, Chain, Outcome, Transform};

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

/// An arm with the constants of its ring.
pub struct Arm {
    pub chain: Chain<f64>,
    pub structure: Structure,
    pub meet: Meet<f64>,
}

impl Arm {
    pub fn of(chain: Chain<f64>) -> Self {
        let structure = Structure::of(&chain, [true; 7]).unwrap();
        let meet = Meet::of(&structure, &structure.ring(&chain.links, &Transform::IDENTITY)).unwrap();
        Self { chain, structure, meet }
    }

    /// All solutions, free joints at the reference.
    pub fn solve(&self, target: &Transform<f64>, reference: &Joints) -> Solutions {
        let ring = self.structure.ring(&self.chain.links, target);
        let late;
        let meet = if self.structure.is_constant {
            &self.meet
        } else {
            let Some(meet) = Meet::of(&self.structure, &ring) else { return Solutions::default() };
            late = meet;
            &late
        };
        let [k1, ..] = ring;
        solutions(&self.chain, target, |visit| meet.search(&k1, reference, visit))
    }
}

/// Solutions, refined and without repeats.
#[derive(Clone, Debug, Default)]
pub struct Solutions<T = f64> {
    pub list: Vec<[T; 6]>,
    pub evaluations: usize,
    pub is_complete: bool,
    pub is_free: bool,
    /// The least residual of all candidates.
    pub nearest: f64,
    /// The greatest residual of a sure candidate before it is refined.
    pub sure: f64,
}

/// A residual of solutions.
pub const EXACT: f64 = 1e-11;
/// Solutions nearer than this are the same.
pub const SAME: f64 = 1e-6;
const SINGLE_EXACT: f64 = 4e-5;
const SINGLE_SAME: f64 = 5e-3;
const EVALUATIONS: usize = 300;
const STEPS: usize = 15;

/// All solutions that a search gives. `search` gets the visitor.
pub fn solutions<T: Scalar>(
    chain: &Chain<T>,
    target: &Transform<T>,
    search: impl FnOnce(&mut dyn FnMut(&Candidate<T>) -> ControlFlow<()>) -> Outcome,
) -> Solutions<T> {
    let is_single = T::EPSILON.to_f64() > 1e-10;
    let (exact, same) = if is_single { (SINGLE_EXACT, SINGLE_SAME) } else { (EXACT, SAME) };
    let mut found = Solutions { nearest: f64::INFINITY, ..Solutions::default() };
    let outcome = search(&mut |candidate| {
        if found.evaluations >= EVALUATIONS {
            return ControlFlow::Break(());
        }
        assert!(candidate.is_finite());
        let before = chain.residual(&candidate.joints, target).to_f64();
        if !candidate.is_doubtful {
            found.sure = found.sure.max(before);
        }
        let (mut joints, residual) = if before < 64.0 * T::EPSILON.to_f64() {
            found.evaluations += 1;
            (candidate.joints, before)
        } else {
            let refined = chain.refined(&candidate.joints, target, STEPS);
            found.evaluations += refined.evaluations;
            (refined.joints, refined.residual.to_f64())
        };
        found.nearest = found.nearest.min(residual);
        if residual <= exact {
            for (joint, is_prismatic) in joints.iter_mut().zip(chain.is_prismatic) {
                *joint = if is_prismatic { *joint } else { wrap(*joint) };
            }
            found.is_free |= candidate.free != 0;
            if found.list.iter().all(|other| apart(chain, other, &joints) > same) {
                found.list.push(joints);
            }
        }
        ControlFlow::Continue(())
    });
    found.is_complete = outcome.is_complete;
    found
}

/// The greatest difference of two joint vectors.
pub fn apart<T: Scalar>(chain: &Chain<T>, a: &[T; 6], b: &[T; 6]) -> f64 {
    let differences = a.iter().zip(b).zip(chain.is_prismatic);
    differences.fold(0.0, |most, ((a, b), is_prismatic)| {
        let difference = *a - *b;
        most.max(if is_prismatic { difference } else { wrap(difference) }.to_f64().abs())
    })
}

impl<T: Scalar> Solutions<T> {
    /// The distance of the nearest solution.
    pub fn distance(&self, chain: &Chain<T>, joints: &[T; 6]) -> f64 {
        self.list.iter().map(|found| apart(chain, found, joints)).fold(f64::INFINITY, f64::min)
    }
}

/// The least singular value of the Jacobian, lengths over reach.
pub fn least_singular_value(chain: &Chain<f64>, joints: &Joints) -> f64 {
    let j = chain.miss(joints, &chain.pose(joints)).jacobian;
    let mut a: [[f64; 6]; 6] =
        core::array::from_fn(|i| core::array::from_fn(|k| (0..6).map(|m| j[m][i] * j[m][k]).sum()));
    // Jacobi's turns.
    for _ in 0..30 {
        for p in 0..6 {
            for r in p + 1..6 {
                if a[p][r].abs() < 1e-300 {
                    continue;
                }
                let (s, c) = (0.5 * (2.0 * a[p][r]).atan2(a[r][r] - a[p][p])).sin_cos();
                for row in &mut a {
                    (row[p], row[r]) = (c * row[p] - s * row[r], s * row[p] + c * row[r]);
                }
                let (x, y) = (a[p], a[r]);
                for k in 0..6 {
                    (a[p][k], a[r][k]) = (c * x[k] - s * y[k], s * x[k] + c * y[k]);
                }
            }
        }
    }
    (0..6).map(|i| a[i][i]).fold(9.0, f64::min).max(0.0).sqrt()
}
