//! Damped least squares on a chain: a plain one, for tests.

use denhart_core::chain::{Chain, Miss};
use denhart_core::transform::Transform;

const STEPS: usize = 14;
const CLOSES: f64 = 64.0 * f64::EPSILON;

fn length(error: &[f64; 6]) -> f64 {
    error.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Moves the joints towards the target. Gives the residual and the number of evaluations.
pub fn refine(chain: &Chain<f64>, joints: &mut [f64; 6], target: &Transform<f64>) -> (f64, usize) {
    descend(chain, joints, target, STEPS)
}

pub fn descend(chain: &Chain<f64>, joints: &mut [f64; 6], target: &Transform<f64>, steps: usize) -> (f64, usize) {
    let mut here = chain.miss(joints, target);
    if here.residual < CLOSES {
        return (here.residual, 1);
    }
    let (mut damp, mut stretch, mut evaluations) = (0.1, 1.0, 1);
    for _ in 0..steps {
        let best = length(&here.error);
        if best < 8.0 * f64::EPSILON {
            break;
        }
        let Some(step) = step(&here, damp * best * best) else { break };
        let longest = step.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let factor = if longest > 0.6 { 0.6 / longest } else { stretch };
        let next: [f64; 6] = core::array::from_fn(|i| joints[i] + factor * step[i]);
        let there = chain.miss(&next, target);
        evaluations += 1;
        let now = length(&there.error);
        if now < best {
            (*joints, here) = (next, there);
            damp *= 0.3;
            // Towards a double root every step leaves a quarter of the error.
            stretch = if stretch == 1.0 && now > 0.15 * best && now < 0.4 * best { 2.0 } else { 1.0 };
            if now > 0.9 * best {
                damp *= 10.0;
            }
        } else if stretch > 1.0 {
            stretch = 1.0;
        } else if best < 400.0 * f64::EPSILON {
            break;
        } else {
            damp = (damp * 30.0).max(1e-3);
        }
    }
    (here.residual, evaluations)
}

/// `(J^T J + damp) x = J^T e`, or `J x = e` itself where nothing is damped.
fn step(miss: &Miss<f64>, damp: f64) -> Option<[f64; 6]> {
    let (j, e) = (&miss.jacobian, &miss.error);
    if damp < 1e-12
        && let Some(x) = eliminated(*j, *e, 1e-6)
    {
        return Some(x);
    }
    let mut a = [[0.0; 6]; 6];
    let mut b = [0.0; 6];
    for i in 0..6 {
        b[i] = (0..6).map(|k| j[k][i] * e[k]).sum();
        for k in 0..6 {
            a[i][k] = (0..6).map(|m| j[m][i] * j[m][k]).sum();
        }
        a[i][i] += damp + 4.0 * f64::EPSILON;
    }
    eliminated(a, b, 0.0)
}

fn eliminated(mut a: [[f64; 6]; 6], mut b: [f64; 6], least: f64) -> Option<[f64; 6]> {
    for k in 0..6 {
        let pivot = (k..6).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
        if a[pivot][k].abs() <= least {
            return None;
        }
        a.swap(pivot, k);
        b.swap(pivot, k);
        for i in k + 1..6 {
            let factor = a[i][k] / a[k][k];
            let row = a[k];
            a[i].iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..6).rev() {
        let sum: f64 = (k + 1..6).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - sum) / a[k][k];
    }
    Some(b)
}

/// The least singular value of the Jacobian.
pub fn least_singular_value(chain: &Chain<f64>, joints: &[f64; 6]) -> f64 {
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
                for k in 0..6 {
                    (a[p][k], a[r][k]) = (c * a[p][k] - s * a[r][k], s * a[p][k] + c * a[r][k]);
                }
            }
        }
    }
    (0..6).map(|i| a[i][i]).fold(9.0, f64::min).max(0.0).sqrt()
}
