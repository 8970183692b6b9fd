//! The arm follows a target that is dragged, within the rates of its joints.

use denhart::JointKind;
use denhart::follow::{Crossing, FollowSettings, Follower, Rates};
use denhart_dynamic::{DynamicArm, ViewSolutions, WholeTarget};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::arm::PageArm;
use crate::numbers::{target, thrown};

/// One follower serves all arms: joints beyond an arm's own stand still.
const MOST: usize = 8;

/// From one tick to the next, s.
const PERIOD: f64 = 0.001;

/// Velocity of a joint whose file says nothing: rad/s, or reaches a second. Accelerations reach it in 1/8 s.
const VELOCITY: [f64; 2] = [3.0, 0.5];

/// A follower, and the list that its ticks overwrite.
pub struct Following {
    follower: Follower<f64, MOST>,
    found: ViewSolutions<MOST>,
}

fn rates(arm: &DynamicArm) -> Rates<f64, MOST> {
    let reach = arm.program().inverse.as_ref().map_or(1.0, |inverse| inverse.constants.reach);
    let usual = |kind: &JointKind| if *kind == JointKind::Revolute { VELOCITY[0] } else { VELOCITY[1] * reach };
    let (mut velocity, mut acceleration) = ([1.0; MOST], [8.0; MOST]);
    let given = arm.max_velocity().zip(arm.max_acceleration()).zip(arm.joint_kinds());
    for ((v, a), ((velocity_given, acceleration_given), kind)) in velocity.iter_mut().zip(&mut acceleration).zip(given)
    {
        *v = if velocity_given.is_finite() { velocity_given } else { usual(kind) };
        *a = acceleration_given.min(8.0 * *v);
    }
    Rates { velocity, acceleration }
}

#[wasm_bindgen]
impl PageArm {
    /// An arm at rest at joint values begins to follow. Throws where that cannot be: an arm without inverse, joints outside
    /// their limits.
    pub fn begin(&mut self, q: &[f64]) -> Result<(), JsError> {
        if self.arm.joints() > MOST {
            let words = format!("arms of up to {MOST} joints follow here, and this one has {}", self.arm.joints());
            return Err(JsError::new(&words));
        }
        let view = self.arm.padded_view::<MOST>().map_err(thrown)?;
        let settings = FollowSettings::new(PERIOD, rates(&self.arm)).crossing(Crossing::Any);
        let mut start = [0.0; MOST];
        for (place, q) in start.iter_mut().zip(q) {
            *place = *q;
        }
        let follower = Follower::new(&view, settings, &start).map_err(thrown)?;
        self.following = Some(Following { follower, found: ViewSolutions::default() });
        Ok(())
    }

    /// Ticks of 1 ms towards a target: how the last one stands to it (0 exact, 1 rates, 2 limits, 3 reach, 4 no target), the
    /// distance and the angle by which it is missed, the largest velocity, the joint values; nothing before `begin`.
    pub fn follow(&mut self, pose: &[f64], angle: f64, given: &[f64], ticks: u32) -> Result<Vec<f64>, JsError> {
        let Some(Following { follower, found }) = &mut self.following else { return Ok(Vec::new()) };
        let view = self.arm.padded_view::<MOST>().map_err(thrown)?;
        let target = WholeTarget::new(target(&self.arm, pose, angle).map_err(thrown)?, given);
        let mut last = None;
        for _ in 0..ticks.clamp(1, 100) {
            last = Some(follower.step(&view, &target, found));
        }
        let Some(step) = last else { return Ok(Vec::new()) };
        let fastest = step.velocity.iter().fold(0.0_f64, |most, velocity| most.max(velocity.abs()));
        let head = [f64::from(step.tracking as u8), step.residual.position, step.residual.orientation, fastest];
        Ok(head.into_iter().chain(step.q.into_iter().take(self.arm.joints())).collect())
    }
}
