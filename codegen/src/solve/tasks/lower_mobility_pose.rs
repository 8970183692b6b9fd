//! A pose for four or five joints: more equations than joints. The rest of them is compared.

use super::yaw::{PITCH, across_plane};
use crate::model::Angle;
use crate::model::geometry::{Triple, TripleKind};
use crate::solve::kernel::{OffsetOfTwo, Unit};
use crate::solve::loop_chain::LoopChain;
use crate::solve::loop_closure::LoopClosure;
use crate::solve::plan::{Branching, Plan, PlanStep};
use crate::solve::sides::Side;
use crate::solve::sinusoid::{Sinusoid, turned_back};
use crate::solve::task::{Goal, PlanTask};
use crate::solve::unsupported::Unsupported;
use crate::solve::{rank, triple};
use crate::symbolic::Expr;

/// A whole pose for a yaw joint, three pitch joints and perhaps a roll joint: more equations than joints.
pub fn yawing(chain: LoopChain) -> Result<Plan, Unsupported> {
    rank::check(&chain, rank::ToolMotion::Pose)?;
    let task = PlanTask::new(Goal::Pose, chain.given.clone());
    let rolls = chain.loop_joints.len() == 5;
    let triple = Triple { first: 1, kind: TripleKind::Parallel };
    let mut c = LoopClosure::new(chain, triple);
    let last = if rolls { 4 } else { 3 };
    let flange = c.link(last).back;
    let (link_a, link_b) = (c.link(1).forward, c.link(2).forward);
    let plane = link_a.then(&mut c.g, &link_b);
    let label = c.label(0);
    if rolls {
        let link = c.link(3).forward;
        let outer = plane.then(&mut c.g, &link);
        if c.vanish(&Side::plane(c.link(3).back.z()), Unit::Direction) {
            return Err(Unsupported::new("joints 4 and 5 turn about parallel axes: the arm cannot leave its plane"));
        }
        let (n, value) = across_plane(&mut c, PITCH, outer.p);
        let length = turned_back(&mut c.g, n, flange.p, Expr::ZERO);
        let direction = turned_back(&mut c.g, n, flange.z(), Expr::ZERO);
        let cosine = c.clean(Side::along(outer.z()), Unit::Direction);
        let row = |c: &mut LoopClosure, row: Sinusoid, value: Expr| [row.c, row.s, c.g.sub(value, row.k)];
        let kernel = OffsetOfTwo { length: row(&mut c, length, value), direction: row(&mut c, direction, cosine) };
        let meaning = format!("Joint {label}: axis 5 keeps its offset and its angle to the plane of the pitch joints.");
        c.stage(&[(0, Angle::ZERO)], Unit::Length, Branching::Shoulder, meaning, kernel);
        // The pitch axis as the flange sees it, and as the roll joint does.
        let seen = c.move_by(0, n);
        let seen = c.g.apply3(&flange.transposed(), seen);
        let sign = c.value(Side::along(plane.z())).map_or(1.0, f64::signum);
        let own = c.link(3).back.z().map(|e| if sign < 0.0 { c.g.neg(e) } else { e });
        let meaning = "Joint 5: turns the pitch axis from `[{from}]` to `[{to}]`.".to_string();
        c.align(4, Side::plane(seen), Side::plane(own), Unit::Direction, meaning);
    } else {
        // The tool has the pitch axis fixed in it.
        let sign = c.value(Side::along(plane.z())).map_or(1.0, f64::signum);
        let axis = flange.z().map(|e| if sign < 0.0 { c.g.neg(e) } else { e });
        let n = c.clean3(c.link(0).forward.z(), Unit::Direction);
        let meaning = format!("Joint {label}: turns the pitch axis from `[{{from}}]` to `[{{to}}]`.");
        c.align(0, Side::plane(n), Side::plane(axis), Unit::Direction, meaning);
        let miss = c.g.sub(Side::along(axis), Side::along(n));
        agreement(&mut c, "The pitch axis keeps its angle to the first axis.", Unit::Direction, vec![miss]);
        let (n, value) = across_plane(&mut c, PITCH, plane.p);
        let seen = c.move_back(0, flange.p);
        let offset = c.g.dot3(n, seen);
        let miss = c.g.sub(offset, value);
        agreement(&mut c, "The tool keeps its offset across the plane.", Unit::Length, vec![miss]);
    }
    triple::parallel(&mut c)?;
    Ok(c.finish(triple, PlanTask { overdetermined: true, ..task }))
}

/// A pose for three joints that move in a plane, and a prismatic one across it.
pub fn upright(chain: LoopChain) -> Result<Plan, Unsupported> {
    let chain = prismatic_last(chain)?;
    let task = PlanTask::new(Goal::Pose, chain.given.clone());
    let triple = Triple { first: 0, kind: TripleKind::Parallel };
    let mut c = LoopClosure::new(chain, triple);
    let flange = c.link(3).back;
    let (link_a, link_b, link_c) = (c.link(0).forward, c.link(1).forward, c.link(2).forward);
    let still = link_a.then(&mut c.g, &link_b).then(&mut c.g, &link_c);
    // The prismatic joint's direction in the frame of the first joint, which no joint turns.
    let own = c.clean3(still.z(), Unit::Direction);
    let (height, before) = (c.g.dot3(own, flange.p), c.g.dot3(own, still.p));
    let label = c.label(3);
    let meaning = format!("Joint {label}: the height of the tool.");
    let numerator = c.g.sub(height, before);
    c.slide_to(3, Expr::ONE, numerator, meaning);
    let misses = c.g.sub3(flange.z(), own).to_vec();
    agreement(&mut c, "The stroke is parallel to the joints' axes.", Unit::Direction, misses);
    triple::parallel(&mut c)?;
    Ok(c.finish(triple, PlanTask { overdetermined: true, ..task }))
}

/// A chain of joints that turn about one direction or slide along or across it. The prismatic joint along that direction
/// commutes with the others and is moved behind them.
fn prismatic_last(mut chain: LoopChain) -> Result<LoopChain, Unsupported> {
    let unsupported = || {
        Unsupported::new(
            "four joints have `pose` if all turn about and slide along or across one direction, or yaw and pitch thrice",
        )
    };
    let prismatic = chain.prismatic_along_revolute().ok_or_else(unsupported)?;
    rank::check(&chain, rank::ToolMotion::Pose)?;
    for i in prismatic..3 {
        chain = chain.prismatic_later(i).ok_or_else(unsupported)?;
    }
    Ok(chain)
}

/// Equations without a joint. They hold for poses that the arm can reach, and for no others.
fn agreement(c: &mut LoopClosure, meaning: &str, unit: Unit, misses: Vec<Expr>) {
    c.push(PlanStep::Agreement { meaning: meaning.into(), unit, misses });
}
