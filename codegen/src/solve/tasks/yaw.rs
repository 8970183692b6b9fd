//! A joint that yaws a plane, and the joints that move in it.

use crate::model::geometry::{Triple, TripleKind};
use crate::solve::kernel::Unit;
use crate::solve::loop_chain::LoopChain;
use crate::solve::loop_closure::LoopClosure;
use crate::symbolic::{Expr, Vec3};

/// A yaw joint, three parallel pitch joints across it, and nothing that slides behind them.
pub fn yaws_and_pitches(chain: &LoopChain) -> bool {
    let turns = chain.loop_joints.iter().all(|slot| slot.revolute);
    let parallel = chain.triples().contains(&Triple { first: 1, kind: TripleKind::Parallel });
    turns && chain.loop_joints.len() >= 4 && parallel && chain.keeps_axis(1).is_none()
}

/// A yaw joint and three that move in a plane which it turns: parallel axes, or some of the joints prismatic across them.
pub fn yaws_a_plane(chain: &LoopChain) -> bool {
    let yaws = chain.loop_joints.first().is_some_and(|slot| slot.revolute);
    let pitches = (1..4).find(|i| chain.loop_joints.get(*i).is_some_and(|slot| slot.revolute));
    let plane = chain.triples().contains(&Triple { first: 1, kind: TripleKind::Parallel });
    yaws && chain.loop_joints.len() == 4 && plane && pitches.is_some_and(|pitch| !chain.are_parallel(0, pitch))
}

/// `n`, the pitch axis seen from before the yaw joint, and how far along it the chain ends. `pitch` and `end` are both in
/// the frame behind that joint.
pub fn across_plane(c: &mut LoopClosure, pitch: Vec3, end: Vec3) -> (Vec3, Expr) {
    let yaw = c.link(0).forward;
    let n = c.g.apply3(&yaw.r, pitch);
    let n = c.clean3(n, Unit::Direction);
    let (offset, ends) = (c.g.dot3(n, yaw.p), c.g.dot3(pitch, end));
    let value = c.g.add(offset, ends);
    (n, c.clean(value, Unit::Length))
}

/// The pitch axis in the frame of joint 1.
pub const PITCH: Vec3 = [Expr::ZERO, Expr::ZERO, Expr::ONE];
