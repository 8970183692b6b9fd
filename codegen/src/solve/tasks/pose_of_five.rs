//! A whole pose for five joints: a virtual joint turns the tool, and its value has to be 0.
//!
//! `T = C0 M1 C1 .. M5 C5 V Rz(v) V^-1` has six joints. Of its solutions those with `v = 0` are solutions of the arm. Every
//! solution is verified by forward kinematics, which knows no `v`.

use crate::model::numeric::Transform;
use crate::model::{Model, Task};
use crate::solve::loop_chain::{LoopChain, LoopJoint};
use crate::solve::plan::Plan;
use crate::solve::structure;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::symbolic::Rigid;

/// A frame of which no axis is a special one of an arm: the rotation of the integers (2, 3, 6) / 7.
const OBLIQUE: [[f64; 3]; 3] =
    [[3.0 / 7.0, 6.0 / 7.0, 2.0 / 7.0], [-6.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0], [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]];

/// V in the tool frame of an arm: oblique, and half of the reach away from the tool point. An axis that met those of the arm
/// or were parallel to them at ordinary poses would leave both joints free there.
fn axis(reach: f64) -> Transform {
    let p = OBLIQUE.map(|[x, ..]| 0.5 * reach * x);
    Transform { r: OBLIQUE, p }
}

/// Adds the virtual joint behind the tool.
pub fn turn(chain: &mut LoopChain) {
    let axis = axis(chain.reach);
    let before = Rigid { r: axis.r.map(|row| row.map(|x| chain.g.number(x))), p: axis.p.map(|x| chain.g.number(x)) };
    chain.append(LoopJoint::virtual_turn(1), before);
    let after = before.inverse(&mut chain.g);
    if let Some(last) = chain.links.last_mut() {
        *last = after;
    }
}

/// Returns true if the file asks five joints for a pose: without a request most arms are better asked for a direction. A
/// joint of six whose value is given is one that the pose needs.
pub fn is_asked(model: &Model, chain: &LoopChain) -> bool {
    model.inverse.task == Some(Task::Pose) && chain.loop_joints.len() == 5 && chain.given.is_empty()
}

/// The task, which asks for more than the joints can choose.
pub fn task(chain: &LoopChain) -> PlanTask {
    PlanTask { overdetermined: true, ..PlanTask::new(Goal::Pose, chain.given.clone()) }
}

/// The plan of least effort.
///
/// # Errors
/// If the arm is singular everywhere, or no three consecutive joints make a closed form.
pub fn plan(mut chain: LoopChain) -> Result<Plan, Unsupported> {
    let task = task(&chain);
    turn(&mut chain);
    structure::cheapest(&chain, &task)?
        .ok_or_else(|| Unsupported::new("no three consecutive axes meet or are parallel, and no three joints slide"))
}
