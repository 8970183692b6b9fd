//! Families of joint vectors: random ones, grids, and the awkward ones that random poses never meet.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::JointKind;

use crate::random::Random;
use crate::singular;
use crate::subject::Subject;

/// A named list of joint vectors.
pub struct Family<const N: usize> {
    pub name: &'static str,
    pub poses: Vec<[f64; N]>,
}

/// Distances from a special value: the value itself, and `+-1e-12 .. +-1e-3`.
pub fn offsets() -> impl Iterator<Item = f64> + Clone {
    std::iter::once(0.0).chain((3..=12).flat_map(|digits| {
        let size = 10.0_f64.powi(-digits);
        [size, -size]
    }))
}

/// The values that the joints of an arm may take.
#[derive(Debug, Clone)]
pub struct Space<const N: usize> {
    kinds: [JointKind; N],
    spans: [[f64; 2]; N],
    reach: f64,
}

impl<const N: usize> Space<N> {
    /// Full turns for revolute joints, whatever their limits; for prismatic ones the limits, or half the reach both
    /// ways where there are none.
    pub fn of(subject: &Subject<N>) -> Self {
        Self::new(&subject.kinds, &subject.limits, subject.reach)
    }

    /// The space of joints of these kinds and limits, for an arm of this reach.
    pub fn new(kinds: &[JointKind; N], limits: &[[f64; 2]; N], reach: f64) -> Self {
        let spans = std::array::from_fn(|joint| match (kinds[joint], limits[joint]) {
            (JointKind::Revolute, _) => [-PI, PI],
            (_, [low, high]) if low.is_finite() && high.is_finite() => [low, high],
            _ => [-0.5 * reach, 0.5 * reach],
        });
        Self { kinds: *kinds, spans, reach }
    }

    /// Range of the joint.
    pub fn span(&self, joint: usize) -> [f64; 2] {
        self.spans[joint]
    }

    /// A uniform joint vector.
    pub fn random(&self, random: &mut Random) -> [f64; N] {
        self.spans.map(|[low, high]| random.uniform(low, high))
    }

    /// `1` for a revolute joint, the reach for a prismatic one.
    fn unit(&self, joint: usize) -> f64 {
        if self.kinds[joint] == JointKind::Revolute { 1.0 } else { self.reach }
    }

    /// The joint's values on a grid of `steps` to a turn: `-180 < q <= 180` degrees, 0 among them; for a prismatic
    /// joint 0 and evenly spaced values of its range.
    fn grid_values(&self, joint: usize, steps: usize) -> Vec<f64> {
        let [low, high] = self.spans[joint];
        if self.kinds[joint] == JointKind::Revolute {
            let quarter = steps / 4;
            // Quarter turns exactly: k * (pi / 2) / quarter would round elsewhere.
            let value = |k: usize| match k % quarter {
                0 => FRAC_PI_2 * (k / quarter) as f64,
                _ => FRAC_PI_2 * k as f64 / quarter as f64,
            };
            (1..=steps).map(|k| if k <= steps / 2 { value(k) } else { value(k - steps / 2) - PI }).collect()
        } else {
            let even = |k: usize| low + (high - low) * k as f64 / (steps - 2) as f64;
            std::iter::once(0.0).chain((0..steps - 1).map(even)).collect()
        }
    }

    /// The values where an arm tends to be singular: 0, +-90 and 180 degrees; the ends and middle of a prismatic range.
    fn special_values(&self, joint: usize) -> [f64; 4] {
        let [low, high] = self.spans[joint];
        match self.kinds[joint] {
            JointKind::Revolute => [0.0, FRAC_PI_2, -FRAC_PI_2, PI],
            _ => [0.0, low, high, 0.5 * (low + high)],
        }
    }

    /// Every joint vector of a grid of `steps` (a multiple of 4) to a turn.
    pub fn grid(&self, steps: usize) -> impl ExactSizeIterator<Item = [f64; N]> + use<N> {
        let values: [Vec<f64>; N] = std::array::from_fn(|joint| self.grid_values(joint, steps));
        let count = values.iter().map(Vec::len).product();
        (0..count).map(move |index| {
            let mut rest: usize = index;
            std::array::from_fn(|joint| {
                let value = values[joint][rest % values[joint].len()];
                rest /= values[joint].len();
                value
            })
        })
    }

    /// `count` random joint vectors of a grid of `steps` to a turn.
    pub fn grid_samples(&self, steps: usize, count: usize, random: &mut Random) -> Vec<[f64; N]> {
        let values: [Vec<f64>; N] = std::array::from_fn(|joint| self.grid_values(joint, steps));
        (0..count).map(|_| std::array::from_fn(|joint| random.pick(&values[joint]))).collect()
    }

    /// Joint 1 at +-90 degrees, exactly and `1e-9 .. 1e-3` beside it; other joints random. A well-known generator
    /// squares through cos(q1) and finds nothing there.
    pub fn first_joint_square(&self, random: &mut Random) -> Family<N> {
        let mut poses = Vec::new();
        for value in [FRAC_PI_2, -FRAC_PI_2] {
            for offset in offsets().filter(|offset| *offset == 0.0 || offset.abs() > 0.5e-9) {
                for _ in 0..15 {
                    let mut q = self.random(random);
                    q[0] = value * self.unit(0) + offset * self.unit(0);
                    poses.push(q);
                }
            }
        }
        Family { name: "q1 at +-90 degrees", poses }
    }

    /// Every joint by itself at its special values and beside them; other joints random.
    pub fn one_special(&self, random: &mut Random) -> Family<N> {
        let mut poses = Vec::new();
        for joint in 0..N {
            for value in self.special_values(joint) {
                for offset in offsets() {
                    for _ in 0..4 {
                        let mut q = self.random(random);
                        q[joint] = value + offset * self.unit(joint);
                        poses.push(q);
                    }
                }
            }
        }
        Family { name: "one joint at 0, +-90, 180", poses }
    }

    /// Every two joints at their special values, exactly and beside them.
    pub fn two_special(&self, random: &mut Random) -> Family<N> {
        let offsets: Vec<f64> = offsets().collect();
        let mut poses = Vec::new();
        for (a, b) in (0..N).flat_map(|a| (a + 1..N).map(move |b| (a, b))) {
            for (x, y) in self.special_values(a).iter().flat_map(|x| self.special_values(b).map(|y| (*x, y))) {
                for exact in [true, true, false, false, false, false] {
                    let mut q = self.random(random);
                    q[a] = x + if exact { 0.0 } else { random.pick(&offsets) * self.unit(a) };
                    q[b] = y + if exact { 0.0 } else { random.pick(&offsets) * self.unit(b) };
                    poses.push(q);
                }
            }
        }
        Family { name: "two joints at 0, +-90, 180", poses }
    }

    /// Every three joints at special values, exactly and beside them; other joints random.
    pub fn three_special(&self, random: &mut Random) -> Family<N> {
        let offsets: Vec<f64> = offsets().collect();
        let mut poses = Vec::new();
        for first in 0..N {
            for (second, third) in (first + 1..N).flat_map(|b| (b + 1..N).map(move |c| (b, c))) {
                for exact in [true, true, false, false] {
                    let mut q = self.random(random);
                    for joint in [first, second, third] {
                        let offset = if exact { 0.0 } else { random.pick(&offsets) * self.unit(joint) };
                        q[joint] = random.pick(&self.special_values(joint)) + offset;
                    }
                    poses.push(q);
                }
            }
        }
        Family { name: "three joints at 0, +-90, 180", poses }
    }

    /// Every joint at a special value, a random half of them a little beside it.
    pub fn all_special(&self, random: &mut Random) -> Family<N> {
        let offsets: Vec<f64> = offsets().collect();
        let mut near = |joint: usize| {
            let value = random.pick(&self.special_values(joint));
            value + if random.below(2) == 0 { 0.0 } else { random.pick(&offsets) * self.unit(joint) }
        };
        Family { name: "beside a 90 degree grid", poses: (0..4000).map(|_| std::array::from_fn(&mut near)).collect() }
    }
}

/// How often the suites try to find a zero of the determinant.
pub const SURFACE: usize = 180;

/// Joint vectors on the singular surface of the arm and beside that surface: stretched elbows, wrist centers on axis 1,
/// folded wrists. The determinant of the Jacobian finds them in so many attempts.
pub fn singular_surface<const N: usize>(subject: &Subject<N>, attempts: usize, random: &mut Random) -> Family<N> {
    let mut poses = Vec::new();
    for (on, joint) in singular::surface(subject, random, attempts) {
        poses.extend(offsets().map(|offset| {
            let mut q = on;
            q[joint] += offset * subject.unit(joint);
            q
        }));
    }
    Family { name: "beside a zero of det J", poses }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space() -> Space<3> {
        let kinds = [JointKind::Revolute, JointKind::Prismatic, JointKind::Prismatic];
        Space::new(&kinds, &[[-1.0, 1.0], [0.3, 1.3], [f64::NEG_INFINITY, f64::INFINITY]], 2.0)
    }

    #[test]
    fn a_grid_is_complete_and_exact() {
        let grid: Vec<[f64; 3]> = space().grid(4).collect();
        assert_eq!(grid.len(), 64);
        for value in [FRAC_PI_2, PI, -FRAC_PI_2, 0.0] {
            assert_eq!(grid.iter().filter(|q| q[0] == value).count(), 16, "{value}");
        }
        for value in [0.0, 0.3, 0.8, 1.3] {
            assert_eq!(grid.iter().filter(|q| q[1] == value).count(), 16, "{value}");
        }
        assert!(space().grid(24).take(24).all(|q| -PI < q[0] && q[0] <= PI));
    }

    #[test]
    fn special_values_are_met_exactly_and_closely() {
        let poses = space().one_special(&mut Random::new(3)).poses;
        assert!(poses.iter().any(|q| q[0] == PI) && poses.iter().any(|q| q[0] == PI + 1e-12));
        assert!(poses.iter().any(|q| q[1] == 0.3 - 2e-6));
        assert_eq!(offsets().count(), 21);
    }
}
