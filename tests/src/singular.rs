//! Singular poses: how singular a pose is, which joints its null space moves, and how to find more of them.

use nalgebra::DMatrix;

use crate::random::Random;
use crate::subject::Subject;
use crate::task::{EQUATIONS, Goal};

/// Below this a singular value of the scaled Jacobian counts as zero.
pub const ZERO: f64 = 1e-9;

/// Below this the least singular value is one of a pose on a self-motion, found by iteration.
const SELF_MOTION: f64 = 1e-7;

/// Below this the least singular value but one means that another self-motion is near.
const CROSSING: f64 = 1e-5;

/// Singular values of a matrix with `N` columns and at least as many rows, and the right singular vectors that belong to them.
#[derive(Debug, Clone)]
pub struct Svd<const N: usize> {
    /// In falling order.
    pub values: [f64; N],
    /// `vectors[k]` belongs to `values[k]`.
    pub vectors: [[f64; N]; N],
}

impl<const N: usize> Svd<N> {
    /// One-sided Jacobi rotations (Hestenes 1958): small singular values to full relative precision of their columns,
    /// which a threshold of 1e-9 asks for.
    ///
    /// `columns[j]` is column j of the matrix.
    pub fn new<const R: usize>(mut columns: [[f64; R]; N]) -> Self {
        let mut vectors: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        for _sweep in 0..40 {
            let mut rotated = false;
            for i in 0..N {
                for j in i + 1..N {
                    let (a, b) = (columns[i], columns[j]);
                    let (aa, bb, ab) = (dot(&a, &a), dot(&b, &b), dot(&a, &b));
                    // The second term ends the sweeps where a column is nothing but rounding.
                    if ab.abs() <= f64::EPSILON * ((aa * bb).sqrt() + 1e-3 * aa.max(bb)) {
                        continue;
                    }
                    rotated = true;
                    let zeta = (bb - aa) / (2.0 * ab);
                    let t = 1.0_f64.copysign(zeta) / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
                    let c = 1.0 / (1.0 + t * t).sqrt();
                    let s = c * t;
                    rotate(&mut columns, i, j, c, s);
                    rotate(&mut vectors, i, j, c, s);
                }
            }
            if !rotated {
                break;
            }
        }
        let norms = columns.map(|column| dot(&column, &column).sqrt());
        let mut order: [usize; N] = std::array::from_fn(|k| k);
        order.sort_by(|&i, &j| norms[j].total_cmp(&norms[i]));
        Self { values: order.map(|k| norms[k]), vectors: order.map(|k| vectors[k]) }
    }

    /// The decomposition of the task's scaled Jacobian at `q`.
    pub fn at(subject: &Subject<N>, q: &[f64; N]) -> Self {
        Self::new(subject.columns(q))
    }

    /// Smallest singular value.
    pub fn least(&self) -> f64 {
        self.values[N - 1]
    }

    /// Number of singular values below a bound.
    pub fn below(&self, bound: f64) -> usize {
        self.values.iter().filter(|&&value| value < bound).count()
    }

    /// Number of singular values that are not zero.
    pub fn rank(&self) -> usize {
        self.values.iter().filter(|&&value| value >= ZERO).count()
    }

    /// Smallest singular value that is not zero.
    pub fn least_nonzero(&self) -> f64 {
        self.values.iter().copied().filter(|&value| value >= ZERO).fold(f64::INFINITY, f64::min)
    }

    /// The joints that the null space moves; none where the matrix is regular.
    ///
    /// Near a pose of one rank less, where two self-motions all but cross, one turns into the other within a short way.
    /// There the joints of both self-motions count.
    pub fn moved(&self) -> [bool; N] {
        let null = |k: usize| self.least() < SELF_MOTION && self.values[k] < CROSSING;
        // A joint that moves less than this changes by less than the tolerance over a turn.
        std::array::from_fn(|joint| (0..N).any(|k| null(k) && self.vectors[k][joint].abs() > 1e-7))
    }

    /// The joint motion that is orthogonal to the null space and brings about `twist`, in the least squares sense.
    /// Singular values below `cut` count as zero.
    pub fn solve(&self, columns: &[[f64; EQUATIONS]; N], twist: &[f64; EQUATIONS], cut: f64) -> [f64; N] {
        let mut motion = [0.0; N];
        for (value, vector) in self.values.iter().zip(&self.vectors).filter(|(value, _)| **value > cut) {
            // J v = sigma u, so that the share along v is u . twist / sigma.
            let along: [f64; EQUATIONS] =
                std::array::from_fn(|row| (0..N).map(|joint| columns[joint][row] * vector[joint]).sum());
            let share = dot(&along, twist) / (value * value);
            for (m, v) in motion.iter_mut().zip(vector) {
                *m += share * v;
            }
        }
        motion
    }
}

fn rotate<const M: usize>(columns: &mut [[f64; M]], i: usize, j: usize, c: f64, s: f64) {
    let (a, b) = (columns[i], columns[j]);
    columns[i] = std::array::from_fn(|row| c * a[row] - s * b[row]);
    columns[j] = std::array::from_fn(|row| s * a[row] + c * b[row]);
}

fn dot<const M: usize>(a: &[f64; M], b: &[f64; M]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Returns true if `accepts` holds for the joints that move along the self-motion through `q`, which is followed over
/// up to 4 rad both ways. `start` is the decomposition at `q`, of rank `N - 1`.
///
/// The null space at `q` alone may show a joint at rest only because it turns back just there. Where another
/// self-motion crosses this one, the joints that it moves count too: the same pose lies on both. Where no motion keeps
/// the pose (a stretched elbow) only the joints of the null space itself count.
pub fn accepts_moved<const N: usize>(
    subject: &Subject<N>,
    q: &[f64; N],
    start: &Svd<N>,
    accepts: impl Fn(&[bool; N]) -> bool,
) -> bool {
    let mut moved = start.moved();
    if accepts(&moved) {
        return true;
    }
    let mut merge = |also: [bool; N]| {
        let before = moved;
        moved = std::array::from_fn(|joint| before[joint] || also[joint]);
        moved != before && accepts(&moved)
    };
    let target = subject.goal(q);
    for sign in [1.0, -1.0] {
        let first = Step { q: *q, heading: start.vectors[N - 1].map(|v| sign * v), clearance: start.values[N - 2] };
        let [mut before, mut here] = [first, first];
        for _ in 0..40 {
            let Some((next, also)) = here.ahead(subject, &target, STRIDE) else { break };
            if merge(also) {
                return true;
            }
            if here.clearance <= before.clearance.min(next.clearance) && merge(crossing(subject, &target, &before)) {
                return true;
            }
            (before, here) = (here, next);
        }
    }
    false
}

/// Returns true if a self-motion passes through `q`: joints that move without moving the tool, not a fold only. `start`
/// is the decomposition at `q`, of rank `N - 1`.
pub fn self_motion<const N: usize>(subject: &Subject<N>, q: &[f64; N], start: &Svd<N>) -> bool {
    let target = subject.goal(q);
    [1.0, -1.0].into_iter().any(|sign| {
        let heading = start.vectors[N - 1].map(|v| sign * v);
        Step { q: *q, heading, clearance: start.values[N - 2] }.ahead(subject, &target, STRIDE).is_some()
    })
}

/// How far a step along a self-motion goes, in rad and reaches.
const STRIDE: f64 = 0.1;

/// A place on a self-motion.
#[derive(Debug, Clone, Copy)]
struct Step<const N: usize> {
    q: [f64; N],
    /// Unit null vector.
    heading: [f64; N],
    /// The least singular value but one: zero where another self-motion crosses.
    clearance: f64,
}

impl<const N: usize> Step<N> {
    /// The place `stride` further on, and the joints that the null space moves there.
    fn ahead(&self, subject: &Subject<N>, target: &Goal, stride: f64) -> Option<(Self, [bool; N])> {
        let guess = |joint: usize| self.q[joint] + stride * subject.unit(joint) * self.heading[joint];
        let q = back_onto(subject, target, std::array::from_fn(guess))?;
        let svd = Svd::at(subject, &q);
        let vector = svd.vectors[N - 1];
        let walked = std::array::from_fn(|joint| (q[joint] - self.q[joint]) / subject.unit(joint));
        if svd.least() > SELF_MOTION || dot(&self.heading, &walked) < 0.2 * stride {
            return None;
        }
        let turn = 1.0_f64.copysign(dot(&self.heading, &vector));
        Some((Self { q, heading: vector.map(|v| turn * v), clearance: svd.values[N - 2] }, svd.moved()))
    }
}

/// The joints that move where the clearance is least within two strides after `before`, by a golden section search.
/// Where nothing crosses, no joints besides those of the one self-motion move.
fn crossing<const N: usize>(subject: &Subject<N>, target: &Goal, before: &Step<N>) -> [bool; N] {
    let look = |stride: f64| before.ahead(subject, target, stride);
    let clearance = |stride: f64| look(stride).map_or(f64::INFINITY, |(step, _)| step.clearance);
    look(minimum(clearance, 45, [1e-3 * STRIDE, 2.0 * STRIDE])).map_or([false; N], |(_, moved)| moved)
}

/// The joint vector near `q` that reaches `target`, by Gauss-Newton steps across the null space.
fn back_onto<const N: usize>(subject: &Subject<N>, target: &Goal, mut q: [f64; N]) -> Option<[f64; N]> {
    for _ in 0..12 {
        let error = subject.error(target, &q);
        if dot(&error, &error) < 1e-24 {
            return Some(q);
        }
        let columns = subject.columns(&q);
        let motion = Svd::new(columns).solve(&columns, &error, 1e-4);
        for (joint, m) in motion.iter().enumerate() {
            q[joint] += m * subject.unit(joint);
        }
    }
    None
}

/// A joint vector on the singular surface, to the last place of one joint. In a random vector, joint `joint` is moved
/// to a change of sign of the Jacobian's determinant, if there is one.
///
/// Where the task has a different number of equations than the arm has joints, there is no determinant. Then the joint
/// is moved to a zero of the least singular value.
pub fn on_surface<const N: usize>(
    subject: &Subject<N>,
    q: &[f64; N],
    joint: usize,
    [low, high]: [f64; 2],
) -> Option<[f64; N]> {
    const STEPS: usize = 24;
    let moved = |value: f64| -> [f64; N] { std::array::from_fn(|j| if j == joint { value } else { q[j] }) };
    let at = |k: usize| low + (high - low) * k as f64 / STEPS as f64;
    if subject.task.equations() != N {
        let least = |value: f64| Svd::at(subject, &moved(value)).least();
        let k = (1..STEPS).find(|&k| least(at(k)) < least(at(k - 1)).min(least(at(k + 1))))?;
        return Some(minimum(least, 75, [at(k - 1), at(k + 1)])).filter(|value| least(*value) < ZERO).map(moved);
    }
    let determinant = |value: f64| {
        let columns = subject.columns(&moved(value));
        DMatrix::from_fn(N, N, |row, column| columns[column][row]).determinant()
    };
    let (mut left, mut right) =
        (0..STEPS).map(|k| (at(k), at(k + 1))).find(|&(left, right)| determinant(left) * determinant(right) < 0.0)?;
    let sign = determinant(left).signum();
    loop {
        let middle = 0.5 * (left + right);
        if middle <= left || middle >= right {
            return Some(moved(left));
        }
        if determinant(middle) * sign > 0.0 { left = middle } else { right = middle }
    }
}

/// Where a function with one minimum is least, by a golden section search. A least singular value has a kink at its
/// zero, so that it is found to the last place.
fn minimum(f: impl Fn(f64) -> f64, steps: usize, [mut low, mut high]: [f64; 2]) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    for _ in 0..steps {
        let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if f(left) < f(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}

/// Random joint vectors on the singular surface: stretched elbows, wrist centers on axis 1, folded wrists, and
/// whatever else makes this arm singular. Each with the joint that was moved there.
pub fn surface<const N: usize>(subject: &Subject<N>, random: &mut Random, count: usize) -> Vec<([f64; N], usize)> {
    let space = crate::poses::Space::of(subject);
    let mut found = Vec::new();
    // An arm whose determinant is exactly zero where it is sampled (a gantry at q5 = 0) needs samples beside that
    // place. A column whose slide starts on its axis is singular at the end of the range. The samples must therefore go
    // beyond that end.
    for aside in [|_| 0.0, |_| 0.1, |[low, high]: [f64; 2]| 0.9 * (low - high)] {
        for attempt in 0..count {
            let joint = attempt % N;
            let q = space.random(random);
            let [low, high] = space.span(joint);
            found.extend(on_surface(subject, &q, joint, [low + aside([low, high]), high]).map(|q| (q, joint)));
        }
        if !found.is_empty() {
            break;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix6;

    #[test]
    fn singular_values_are_those_of_nalgebra() {
        let mut random = Random::new(1);
        for _ in 0..200 {
            let columns: [[f64; 6]; 6] = std::array::from_fn(|_| std::array::from_fn(|_| random.uniform(-1.0, 1.0)));
            let svd = Svd::new(columns);
            let matrix = Matrix6::from_fn(|row, column| columns[column][row]);
            let expected = matrix.svd(false, false).singular_values;
            for k in 0..6 {
                assert!((svd.values[k] - expected[k]).abs() < 1e-13, "{:?} {expected}", svd.values);
                let image = matrix * nalgebra::Vector6::from(svd.vectors[k]);
                assert!((image.norm() - svd.values[k]).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_small_singular_value_keeps_its_digits() {
        // Two columns 1e-10 apart: the smallest singular value is 1e-10 / sqrt(2) to first order.
        let mut columns: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        columns[5] = [1.0, 0.0, 0.0, 0.0, 0.0, 1e-10];
        let svd = Svd::new(columns);
        assert!((svd.least() / (1e-10 / 2.0_f64.sqrt()) - 1.0).abs() < 1e-6, "{:?}", svd.values);
        assert_eq!(svd.rank(), 5);
        assert_eq!(svd.moved(), [true, false, false, false, false, true]);
        assert!((svd.least_nonzero() - 1.0).abs() < 1e-9);
    }
}
