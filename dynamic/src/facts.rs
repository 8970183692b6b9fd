//! What the search needs to know about an arm.

use denhart::solve;
use denhart::{CombinedLimit, JointMask, Residual};
use denhart_codegen::lower;

/// What the runtime's [`Facts`](solve::Facts) refer to, of an arm with `N` joints.
#[derive(Debug)]
pub struct Facts<const N: usize> {
    limits: [[f64; 2]; N],
    weights: [f64; N],
    combined: Vec<CombinedLimit<f64, N>>,
    limited: bool,
    prismatic: JointMask,
    stands_for: JointMask,
    reach: f64,
    tolerance: Residual<f64>,
}

impl<const N: usize> Facts<N> {
    /// Those of a program; `None` if its arm has another number of joints.
    pub fn of(facts: &lower::Facts) -> Option<Self> {
        let combined = facts.combined.iter().map(|(factors, limits)| {
            let factors = <[f64; N]>::try_from(factors.as_slice()).ok()?;
            Some(CombinedLimit { factors, limits: *limits })
        });
        let single = |joint: &usize| JointMask::single(*joint);
        Some(Facts {
            limits: facts.limits.as_slice().try_into().ok()?,
            weights: facts.weights.as_slice().try_into().ok()?,
            combined: combined.collect::<Option<_>>()?,
            limited: facts.limited,
            prismatic: facts.prismatic.iter().map(single).fold(JointMask::NONE, JointMask::union),
            stands_for: facts.stands_for.as_ref().map_or(JointMask::NONE, single),
            reach: facts.reach,
            tolerance: Residual { position: facts.length, orientation: facts.angle },
        })
    }

    /// The same for one call.
    pub fn get(&self) -> solve::Facts<'_, f64, N> {
        let Facts { limits, weights, combined, limited, prismatic, stands_for, reach, tolerance } = self;
        solve::Facts {
            limits,
            combined,
            weights,
            limited: *limited,
            prismatic: *prismatic,
            stands_for: *stands_for,
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
        let two = lower::Facts {
            limits: vec![[-1.0, 1.0]; 2],
            limited: true,
            combined: vec![(vec![1.0, 1.0], [-2.0, 2.0])],
            weights: vec![1.0; 2],
            prismatic: vec![1],
            stands_for: None,
            reach: 1.0,
            length: 1e-6,
            angle: 1e-6,
        };
        let facts = Facts::<2>::of(&two).unwrap();
        let facts = facts.get();
        assert_eq!((facts.limits, facts.combined.len()), (&[[-1.0, 1.0]; 2], 1));
        assert!(facts.prismatic.contains(1) && !facts.prismatic.contains(0));
        assert!(Facts::<3>::of(&two).is_none());
    }
}
