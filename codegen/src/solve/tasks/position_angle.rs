//! A point and the tool's angle in the plane that a joint yaws, for four joints.

use super::yaw;
use crate::model::Angle;
use crate::model::geometry::{Triple, TripleKind};
use crate::solve::kernel::{Offset, Unit};
use crate::solve::loop_chain::LoopChain;
use crate::solve::loop_closure::{Link, LoopClosure};
use crate::solve::plan::{Branching, Plan};
use crate::solve::sinusoid::turned_back;
use crate::solve::task::{GivenValues, Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::solve::{planar, rank};
use crate::symbolic::{Expr, Graph, Input, Pair, Rigid, transpose};

/// The yaw joint from the offset across the plane, then the loop in the plane.
///
/// # Errors
/// If a joint's value is given, no joint yaws, or the arm is singular everywhere.
pub fn plan(mut chain: LoopChain) -> Result<Plan, Unsupported> {
    if !chain.given.is_empty() {
        return Err(Unsupported::new(
            "the task `position_angle` takes no joint's value: the angle of the plane is the sum of all of them",
        ));
    }
    if !yaw::yaws_a_plane(&chain) {
        return Err(Unsupported::new(
            "the task `position_angle` needs a joint that yaws, and three that move in a plane which it turns",
        ));
    }
    rank::check(&chain, rank::ToolMotion::Pose)?;
    // The tool counts with the plane: only a point is given.
    let tool = chain.take_tool();
    chain.generic.angle([Input::Angle, Input::SinAngle, Input::CosAngle]);
    chain.target.r = Graph::identity();
    let offsets: Vec<Angle> = chain.loop_joints.iter().map(|slot| slot.offset).collect();
    let triple = Triple { first: 1, kind: TripleKind::Parallel };
    let mut c = LoopClosure::new(chain, triple);
    let (link_a, link_b) = (c.link(1).forward, c.link(2).forward);
    let plane = link_a.then(&mut c.g, &link_b);
    // The frame of the first pitch joint, in that of joint 1.
    let frames = [Rigid::identity(), link_a, plane].map(|frame| frame.r);
    let turns = [1, 2, 3].map(|joint| c.is_revolute(joint));
    let upright = frames.iter().zip(turns).find(|(_, turns)| *turns).map_or(Graph::identity(), |(frame, _)| *frame);
    let pitch = upright.map(|[_, _, z]| z);
    let end = plane.point(&mut c.g, tool.p);
    let point = c.link(3).back.p;
    let (n, value) = yaw::across_plane(&mut c, pitch, end);
    let row = turned_back(&mut c.g, n, point, Expr::ZERO);
    let label = c.label(0);
    let meaning =
        format!("Joint {label}: the tool point keeps its offset across the plane, `{{a}} cos + {{b}} sin = {{d}}`.");
    let d = c.g.sub(value, row.k);
    let kernel = Offset { a: row.c, b: row.s, d };
    c.stage(&[(0, Angle::ZERO)], Unit::Length, Branching::Shoulder, meaning, kernel);
    // Rotation of the plane: the angle about the pitch axis, and the constant turns of the links.
    let known = Pair { sin: c.g.symbol(Input::SinAngle), cos: c.g.symbol(Input::CosAngle) };
    let columns = transpose(&plane.r).map(|axis| {
        let axis = c.g.apply3(&transpose(&upright), axis);
        let axis = c.g.rotate_z(known, axis);
        c.g.apply3(&upright, axis)
    });
    let r = transpose(&columns);
    let seen = c.move_back(0, point);
    let seen = c.link(0).back.point(&mut c.g, seen);
    let arm = c.g.apply3(&r, tool.p);
    let back = Rigid { r, p: c.g.sub3(seen, arm) };
    let forward = back.inverse(&mut c.g);
    let rest = Link { forward, back, target: true };
    let links = [c.link(1), c.link(2), rest];
    planar::solve(&mut c, [1, 2, 3], links)?;
    let mut signs = vec![0.0];
    for (frame, turns) in frames.iter().zip(turns) {
        let along = c.g.dot3(pitch, frame.map(|[_, _, z]| z));
        signs.push(if turns { c.value(along).map_or(1.0, f64::signum) } else { 0.0 });
    }
    let constant = signs.iter().zip(&offsets).fold(Angle::ZERO, |sum, (sign, offset)| match *sign {
        0.0 => sum,
        sign if sign < 0.0 => sum.add(offset.neg()),
        _ => sum.add(*offset),
    });
    let task = PlanTask::new(Goal::PositionAngle { signs, offset: constant }, GivenValues::default());
    Ok(c.finish(triple, task))
}
