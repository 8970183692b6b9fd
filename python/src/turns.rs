//! Solutions on the turns within the limits of an arm.

use denhart::{Arm as _, Flags, InverseKinematics, Windings};
use denhart_codegen::model::MOST_JOINTS;
use denhart_dynamic::{DynamicArm, DynamicSolution, DynamicView, Joints};

/// Turns of all joints that are looked at, for the limits of sums of joints.
const MOST: usize = 4096;

/// The arm whose limits count, if any do.
pub struct Turns<'a>(Option<DynamicView<'a, MOST_JOINTS>>);

impl<'a> Turns<'a> {
    /// The limits of this arm, if solutions outside are dropped.
    pub fn of(arm: &'a DynamicArm, drop: bool) -> Self {
        Self(if drop { arm.padded_view().ok() } else { None })
    }

    /// Returns true if solutions outside the limits are dropped.
    pub const fn drop(&self) -> bool {
        self.0.is_some()
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

    /// The solution on a turn within the limits, if there is one; as it is where the limits do not count.
    pub fn kept(&self, solution: &DynamicSolution) -> Option<DynamicSolution> {
        let mut turned = *solution;
        if !self.drop() || solution.is_within_limits() {
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
