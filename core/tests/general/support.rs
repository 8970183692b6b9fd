//! Chains of tables, random numbers, and a solver that refines candidates as an arm does.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use core::ops::ControlFlow::{Break, Continue};

use denhart_core::choice::{choose, choose_given};
use denhart_core::general::{Cuts, General};
use denhart_core::math::{radians, sin_cos, wrap};
use denhart_core::{Candidate, Chain, Outcome, Transform, Visitor};

use crate::tables::{TABLES, Table};

/// Evaluations of one call.
pub const MOST_EVALUATIONS: usize = 300;
/// Evaluations of one candidate.
const STEPS: usize = 15;
/// A solution closes to this.
pub const EXACT: f64 = 1e-11;
/// Solutions that differ by less are one.
pub const SAME: f64 = 1e-6;
/// A candidate that closes to this is left as it is.
const CLOSES: f64 = 64.0 * f64::EPSILON;

/// A generator of random numbers (xorshift).
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
    pub fn angle(&mut self) -> f64 {
        self.within(-core::f64::consts::PI, core::f64::consts::PI)
    }
    pub fn joints(&mut self) -> [f64; 6] {
        core::array::from_fn(|_| self.angle())
    }
}

/// Rotation about x by degrees, quarter turns to the bit.
pub fn rx(degrees: f64) -> Transform<f64> {
    let quarter = degrees / 90.0;
    let (s, c) = if quarter == quarter.round() {
        [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][(quarter as i64).rem_euclid(4) as usize]
    } else {
        sin_cos(radians(degrees))
    };
    Transform { rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]], translation: [0.0; 3] }
}

pub fn shift(translation: [f64; 3]) -> Transform<f64> {
    Transform { translation, ..Transform::IDENTITY }
}

/// The constants of a table between its joints: base, links and tool.
pub fn links(table: &Table) -> Vec<Transform<f64>> {
    let mut links = vec![Transform::IDENTITY; table.rows.len() + 1];
    for (i, [a, alpha, d, theta]) in table.rows.iter().enumerate() {
        let turn = Transform::IDENTITY.then_turn(sin_cos(radians(*theta))).then_slide(*d);
        if table.is_modified {
            links[i] = links[i] * rx(*alpha) * shift([*a, 0.0, 0.0]);
            links[i + 1] = turn;
        } else {
            links[i + 1] = turn * shift([*a, 0.0, 0.0]) * rx(*alpha);
        }
    }
    links
}

/// The chain of a table of six rows; of seven with one joint at a value.
pub fn chain(table: &Table, given: usize, value: f64) -> Chain<f64> {
    let mut all = links(table);
    if all.len() == 8 {
        let behind = all.remove(given + 1);
        all[given] = all[given].then_turn(sin_cos(value)) * behind;
    }
    let links = core::array::from_fn(|i| all[i]);
    Chain::new(links, [false; 6])
}

pub fn table(name: &str) -> &'static Table {
    TABLES.iter().find(|table| table.name == name).unwrap()
}

/// An arm with its cuts.
pub struct Arm {
    pub chain: Chain<f64>,
    pub cuts: Cuts,
    /// None where the first cut is one of the target.
    pub general: Option<General>,
}

impl Arm {
    pub fn of(chain: &Chain<f64>) -> Option<Self> {
        let chain = chain.gathered();
        let cuts = choose(&chain)?;
        Some(Self { chain, cuts, general: General::of(&chain, &cuts) })
    }

    /// Of a table of seven rows with one joint given.
    pub fn given(table: &Table, joint: usize, value: f64) -> Option<Self> {
        let cuts = choose_given(&|random| chain(table, joint, random()))?;
        let chain = chain(table, joint, value).gathered();
        Some(Self { chain, cuts, general: General::of(&chain, &cuts) })
    }

    pub fn solve(&self, target: &Transform<f64>) -> Solutions {
        self.solve_at(target, &[0.0; 6])
    }

    pub fn solve_at(&self, target: &Transform<f64>, reference: &[f64; 6]) -> Solutions {
        solutions(&self.chain, target, &mut |visit| self.search(target, reference, visit).is_complete)
    }

    pub fn search(&self, target: &Transform<f64>, reference: &[f64; 6], visit: &mut Visitor<'_, f64>) -> Outcome {
        match &self.general {
            Some(general) => general.search(target, reference, visit),
            None => self.cuts.search(&self.chain, target, reference, visit),
        }
    }

    /// As with a given joint: the constants are computed in the call.
    pub fn solve_anew(&self, target: &Transform<f64>) -> Solutions {
        solutions(&self.chain, target, &mut |visit| self.cuts.search(&self.chain, target, &[0.0; 6], visit).is_complete)
    }
}

#[derive(Debug, Default)]
pub struct Solutions {
    pub list: Vec<[f64; 6]>,
    pub residuals: Vec<f64>,
    pub candidates: usize,
    pub evaluations: usize,
    pub is_complete: bool,
    pub is_doubtful: bool,
    /// Joints that some candidate calls free.
    pub free: u8,
    /// The greatest residual before refinement of those that became solutions.
    pub before: f64,
}

impl Solutions {
    pub fn distance(&self, chain: &Chain<f64>, joints: &[f64; 6]) -> f64 {
        self.list.iter().map(|found| apart(chain, found, joints)).fold(9.0, f64::min)
    }
}

/// The largest difference of two joint vectors.
pub fn apart(chain: &Chain<f64>, a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let mut most = 0.0_f64;
    for ((x, y), is_prismatic) in a.iter().zip(b).zip(chain.is_prismatic) {
        most = most.max(if is_prismatic { (x - y).abs() } else { wrap(x - y).abs() });
    }
    most
}

/// Runs a search and refines its candidates, with the bounds of an arm.
pub fn solutions(
    chain: &Chain<f64>,
    target: &Transform<f64>,
    search: &mut dyn FnMut(&mut Visitor<'_, f64>) -> bool,
) -> Solutions {
    let mut out = Solutions { list: Vec::with_capacity(24), residuals: Vec::with_capacity(24), ..Default::default() };
    out.is_complete = search(&mut |candidate: &Candidate<f64>| {
        out.candidates += 1;
        out.is_doubtful |= candidate.is_doubtful;
        out.free |= candidate.free;
        let before = chain.residual(&candidate.joints, target);
        let (mut joints, residual, evaluations) = if before < CLOSES {
            (candidate.joints, before, 1)
        } else {
            let refined = chain.refined(&candidate.joints, target, STEPS);
            (refined.joints, refined.residual, refined.evaluations)
        };
        out.evaluations += evaluations;
        if residual < EXACT {
            out.before = out.before.max(before);
            for (joint, is_prismatic) in joints.iter_mut().zip(chain.is_prismatic) {
                *joint = if is_prismatic { *joint } else { wrap(*joint) };
            }
            match out.list.iter().position(|other| apart(chain, other, &joints) < SAME) {
                None => {
                    out.list.push(joints);
                    out.residuals.push(residual);
                }
                Some(place) if residual < out.residuals[place] => {
                    (out.list[place], out.residuals[place]) = (joints, residual);
                }
                Some(_) => {}
            }
        }
        if out.evaluations >= MOST_EVALUATIONS { Break(()) } else { Continue(()) }
    });
    out
}

/// The smallest singular value of the Jacobian, by Jacobi's eigenvalues of the normal equations.
pub fn least_singular_value(chain: &Chain<f64>, joints: &[f64; 6]) -> f64 {
    let j = chain.miss(joints, &chain.pose(joints)).jacobian;
    let mut a: [[f64; 6]; 6] =
        core::array::from_fn(|i| core::array::from_fn(|k| (0..6).map(|m| j[m][i] * j[m][k]).sum::<f64>()));
    for _ in 0..30 {
        for p in 0..6 {
            for r in p + 1..6 {
                if a[p][r].abs() < 1e-300 {
                    continue;
                }
                let (s, c) = sin_cos(0.5 * denhart_core::math::atan2(2.0 * a[p][r], a[r][r] - a[p][p]));
                for k in 0..6 {
                    (a[k][p], a[k][r]) = (c * a[k][p] - s * a[k][r], s * a[k][p] + c * a[k][r]);
                }
                for k in 0..6 {
                    (a[p][k], a[r][k]) = (c * a[p][k] - s * a[r][k], s * a[p][k] + c * a[r][k]);
                }
            }
        }
    }
    (0..6).map(|i| a[i][i]).fold(9.0, f64::min).max(0.0).sqrt()
}
