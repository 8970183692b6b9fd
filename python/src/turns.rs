//! Solutions on the turns within the limits of an arm.

use denhart::{Arm as _, Flags, InverseKinematics, Windings};
use denhart_codegen::model::MOST_JOINTS;
use denhart_dynamic::{DynamicArm, DynamicSolution, DynamicView, Joints};

/// Turns of all joints that are looked at, for the limits of sums of joints.
const MOST: usize = 4096;

/// The limits of an arm.
pub struct Turns<'a>(Option<DynamicView<'a, MOST_JOINTS>>);

impl<'a> Turns<'a> {
    /// Limits of this arm.
    pub fn of(arm: &'a DynamicArm) -> Self {
        Self(arm.padded_view().ok())
    }

    /// Turns joint values into the limits: each joint by the fewest whole turns. Returns false if that is impossible.
    pub fn turn(&self, q: &mut [f64]) -> bool {
        let Some(view) = &self.0 else { return false };
        let mut padded = [0.0; MOST_JOINTS];
        for (place, value) in padded.iter_mut().zip(&*q) {
            *place = *value;
        }
        let (limits, kinds) = (view.limits(), view.joint_kinds());
        let mut all = Windings::new(&padded, &limits, &kinds).take(MOST);
        let Some(turned) = all.find(|q| view.combined_limits().iter().all(|limit| limit.holds(q))) else {
            return false;
        };
        for (place, value) in q.iter_mut().zip(turned) {
            *place = value;
        }
        true
    }

    /// The solution on a turn within the limits, if there is one.
    pub fn within(&self, solution: &DynamicSolution) -> Option<DynamicSolution> {
        let mut turned = *solution;
        if solution.is_within_limits() {
            return Some(turned);
        }
        let mut q = Joints::new(solution.q.iter().copied());
        if !self.turn(&mut q) {
            return None;
        }
        turned.q = q;
        turned.flags.remove(Flags::OUT_OF_LIMITS);
        Some(turned)
    }
}
