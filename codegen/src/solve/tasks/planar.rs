//! A pose or a point in the base frame's xy plane.

use crate::model::geometry::{TOLERANCE, Triple, TripleKind};
use crate::model::numeric::Transform;
use crate::model::{Angle, Model};
use crate::solve::loop_chain::LoopChain;
use crate::solve::loop_closure::LoopClosure;
use crate::solve::plan::Plan;
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::solve::{planar, rank};
use crate::symbolic::{Expr, Graph, Input, Pair, transpose};

/// The loop of three joints in the plane; for a point alone the third one is virtual.
///
/// # Errors
/// If the joints do not move in the plane, or are singular everywhere.
pub fn plan(goal: Goal, model: &Model, mut chain: LoopChain) -> Result<Plan, Unsupported> {
    let is_pose = goal == Goal::PlanarPose;
    rank::check(&chain, if is_pose { rank::ToolMotion::Pose } else { rank::ToolMotion::Point })?;
    let twist = if is_pose { chain.tool_twist() } else { Some(Angle::ZERO) };
    let is_planar = chain.is_planar();
    if !is_planar && let Some(normal) = chain.plane_normal() {
        return Err(turned(goal.task().name(), model, normal));
    }
    let (true, Some(twist)) = (is_planar, twist) else {
        return Err(Unsupported::new(format!(
            "the task `{}` needs axes parallel to the base z axis (sliding joints across it){}",
            goal.task().name(),
            if is_pose { " and a tool whose x axis lies in the plane" } else { "" }
        )));
    };
    chain.target.p = [chain.g.symbol(Input::Position(0)), chain.g.symbol(Input::Position(1)), Expr::ZERO];
    if is_pose {
        chain.generic.angle([Input::Phi, Input::SinPhi, Input::CosPhi]);
        let phi = Pair { sin: chain.g.symbol(Input::SinPhi), cos: chain.g.symbol(Input::CosPhi) };
        let twist = chain.g.turn(twist);
        let columns = Graph::identity().map(|axis| {
            let axis = chain.g.rotate_x(twist, axis);
            chain.g.rotate_z(phi, axis)
        });
        chain.target.r = transpose(&columns);
    } else {
        // The tool point alone: its frame turns on a virtual joint about z of the base.
        chain.target.r = Graph::identity();
        chain.append_upright();
    }
    let triple = Triple { first: 0, kind: TripleKind::Parallel };
    let task = PlanTask::new(goal, chain.given.clone());
    let mut c = LoopClosure::new(chain, triple);
    let links = [c.link(0), c.link(1), c.link(2)];
    planar::solve(&mut c, [0, 1, 2], links)?;
    Ok(c.finish(triple, task))
}

/// Why an arm that moves in another plane than the base's xy plane lacks a task, with the base for which it has it:
/// `Ry(pitch) Rx(roll) n = z`, with n the plane's normal seen from the base.
fn turned(task: &str, model: &Model, normal: [f64; 3]) -> Unsupported {
    let [x, y, z] = Transform::frame(&model.base).turned_back(normal);
    let reason = |what: &str| format!("the task `{task}` needs axes parallel to the base z axis: {what} them away");
    if x.hypot(y) <= TOLERANCE {
        let hint = "remove `rpy` from `base`, or turn the base about z alone: `rpy: [0, 0, yaw]`";
        return Unsupported { hint: Some(hint.to_owned()), ..Unsupported::new(reason("`rpy` of `base` turns")) };
    }
    // Either direction of the normal: the one of the smaller turn.
    let sign = if z < 0.0 { -1.0 } else { 1.0 };
    let [x, y, z] = [x, y, z].map(|part| part * sign);
    let level = y.hypot(z);
    let roll = if level > TOLERANCE { Angle::of_vector(y, z) } else { Angle::ZERO };
    // Digits beyond these are rounding.
    let [roll, pitch] = [roll, Angle::of_vector(-x, level)].map(|a| (a.rad().to_degrees() * 1e12).round() / 1e12 + 0.0);
    let hint = format!("write `rpy: [{roll} deg, {pitch} deg, 0]` in `base`: targets are then in the arm's plane");
    Unsupported { hint: Some(hint), ..Unsupported::new(reason("the first rows turn")) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    fn arm(base: &str, first_row: &str) -> crate::Report {
        let rows = "  - {a: 0.5, alpha: 0, d: 0, theta: 0}\n".repeat(2);
        let text = format!(
            "name: arm\nconvention: standard\nunits: {{length: m, angle: rad}}\nbase: {{xyz: [0, 0, 1], rpy: {base}}}\n\
             joints:\n{first_row}{rows}"
        );
        crate::check(&text, "arm.yaml").unwrap()
    }

    #[test]
    fn the_proposed_base_lets_the_arm_move_in_its_plane() {
        let row =
            |alpha: &str, theta: &str| format!("  - {{type: fixed, a: 0, alpha: {alpha}, d: 0, theta: {theta}}}\n");
        for (alpha, theta) in [("pi/2", "0"), ("-pi/2", "30 deg"), ("130 deg", "-1.2"), ("0.3", "2"), ("1e-3", "0.5")] {
            let row = row(alpha, theta);
            for base in ["[0, 0, 0]", "[0, 0, 0.7]"] {
                let report = arm(base, &row);
                let reason = report.unsupported.unwrap();
                assert!(
                    reason.contains("`planar_position` needs axes parallel") && reason.contains("rows turn"),
                    "{reason}"
                );
                let hint = report.hint.unwrap();
                let proposed = hint.split('`').nth(1).unwrap().strip_prefix("rpy: ").unwrap();
                assert_eq!(arm(proposed, &row).task.as_deref(), Some("planar_position"), "{alpha} {theta}: {hint}");
            }
        }
        let report = arm("[0, 90 deg, 1]", "");
        assert!(report.unsupported.unwrap().contains("`rpy` of `base` turns"));
        assert!(report.hint.unwrap().starts_with("remove `rpy` from `base`"));
        assert_eq!(arm("[0, 0, 1]", "").task.as_deref(), Some("planar_position"));
    }
}
