//! Constants of an arm, as the search needs them.

use denhart::solve;
use denhart::{CombinedLimit, JointMask, Residual};
use denhart_codegen::lower;

/// Numbers that the runtime's [`ArmConstants`](solve::ArmConstants) refer to, of an arm with `N` joints.
#[derive(Debug)]
pub struct ArmConstants<const N: usize> {
    limits: [[f64; 2]; N],
    weights: [f64; N],
    combined: Vec<CombinedLimit<f64, N>>,
    limited: bool,
    prismatic: JointMask,
    stands_for: JointMask,
    wrist: Option<[usize; 3]>,
    reach: f64,
    tolerance: Residual<f64>,
}

impl<const N: usize> ArmConstants<N> {
    /// Arm constants of a program; `None` if its arm has another number of joints.
    pub fn of(constants: &lower::ArmConstants) -> Option<Self> {
        let combined = constants.combined.iter().map(|(factors, limits)| {
            let factors = <[f64; N]>::try_from(factors.as_slice()).ok()?;
            Some(CombinedLimit { factors, limits: *limits })
        });
        let single = |joint: &usize| JointMask::single(*joint);
        Some(ArmConstants {
            limits: constants.limits.as_slice().try_into().ok()?,
            weights: constants.weights.as_slice().try_into().ok()?,
            combined: combined.collect::<Option<_>>()?,
            limited: constants.limited,
            prismatic: constants.prismatic.iter().map(single).fold(JointMask::NONE, JointMask::union),
            stands_for: constants.stands_for.as_ref().map_or(JointMask::NONE, single),
            wrist: constants.wrist,
            reach: constants.reach,
            tolerance: Residual { position: constants.length, orientation: constants.angle },
        })
    }

    /// Arm constants for one call, by reference.
    pub fn get(&self) -> solve::ArmConstants<'_, f64, N> {
        let ArmConstants { limits, weights, combined, limited, prismatic, stands_for, wrist, reach, tolerance } = self;
        solve::ArmConstants {
            limits,
            combined,
            weights,
            limited: *limited,
            prismatic: *prismatic,
            stands_for: *stands_for,
            wrist: *wrist,
            reach: *reach,
            tolerance: *tolerance,
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn numbers_of_another_arm_are_none() {
        let two = lower::ArmConstants {
            limits: vec![[-1.0, 1.0]; 2],
            limited: true,
            combined: vec![(vec![1.0, 1.0], [-2.0, 2.0])],
            weights: vec![1.0; 2],
            prismatic: vec![1],
            stands_for: None,
            wrist: None,
            reach: 1.0,
            length: 1e-6,
            angle: 1e-6,
        };
        let constants = ArmConstants::<2>::of(&two).unwrap();
        let constants = constants.get();
        assert_eq!((constants.limits, constants.combined.len()), (&[[-1.0, 1.0]; 2], 1));
        assert!(constants.prismatic.contains(1) && !constants.prismatic.contains(0));
        assert!(ArmConstants::<3>::of(&two).is_none());
    }
}
