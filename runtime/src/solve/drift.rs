//! Targets whose rotation is slightly off: printed with few digits, drifted, or computed in single precision.

use super::kernel::tolerances::Tolerances;
use crate::{Pose, Solutions};

/// A rotation that is off by more than this is none.
const NOT_A_ROTATION: f64 = 1e-3;

/// The target, or the pose that the search uses in place of a target whose rotation is off by more than rounding. That
/// pose, kept in `nearest`, is the target with the nearest rotation (polar factor, [`Pose::orthonormalized`]). The
/// solutions keep by how much the target is off. A target that is off by more than 1e-3, or is not finite, becomes a
/// pose that is no number.
#[inline(always)]
pub fn nearest_rotation<'a, T: Tolerances, const N: usize, const M: usize>(
    target: &'a Pose<T>,
    nearest: &'a mut Option<Pose<T>>,
    solutions: &mut Solutions<T, N, M>,
) -> &'a Pose<T> {
    let square = target.squared_deviation();
    if square <= T::ROUNDING * T::ROUNDING {
        return target;
    }
    let deviation = square.sqrt();
    solutions.set_deviation(deviation);
    kept(target, nearest, deviation)
}

#[cold]
#[inline(never)]
fn kept<'a, T: Tolerances>(target: &Pose<T>, nearest: &'a mut Option<Pose<T>>, deviation: T) -> &'a Pose<T> {
    nearest.insert(drifted(target, deviation))
}

fn drifted<T: Tolerances>(target: &Pose<T>, deviation: T) -> Pose<T> {
    if deviation <= T::from_f64(NOT_A_ROTATION) {
        return target.orthonormalized();
    }
    Pose { rotation: [[T::NAN; 3]; 3], ..*target }
}

/// The target with the nearest rotation, for code without a list of solutions. `None` if the target is no pose.
pub(crate) fn as_rotation<T: Tolerances>(target: &Pose<T>) -> Option<Pose<T>> {
    let deviation = target.deviation();
    let nearest = if deviation <= T::ROUNDING { *target } else { drifted(target, deviation) };
    nearest.is_finite().then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_deviation_is_the_distance_of_a_rotation() {
        let exact = Pose::<f64>::from_xyz_rpy([0.0; 3], [0.4, -1.1, 2.3]);
        let deviation = |pose: &Pose<f64>| pose.deviation();
        assert!(deviation(&exact) < 1e-15);
        for entry in 0..9 {
            let mut off = exact;
            off.rotation[entry / 3][entry % 3] += 5e-7;
            assert!((4e-7..8e-7).contains(&deviation(&off)), "entry {entry}: {:e}", deviation(&off));
        }
        let longer = Pose { rotation: exact.rotation.map(|row| row.map(|x| x * (1.0 + 1e-6))), ..exact };
        assert!((deviation(&longer) - 1e-6 * 3.0_f64.sqrt()).abs() < 1e-11);
    }
}
