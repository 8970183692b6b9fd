//! Three revolute and three prismatic joints (decoupled): the revolute ones alone turn the tool.
//!
//! `T = C0 M1 C1 .. M6 C6`. Displacements do not turn: `Rz(a) A Rz(b) B Rz(c)` is what the constants leave of the target's
//! rotation, with A and B the links between the revolute joints multiplied. Then the tool's place is linear in the three
//! displacements. Source: Pieper 1968, the decoupled case.

use super::kernel::Unit;
use super::loop_chain::LoopChain;
use super::loop_closure::LoopClosure;
use super::plan::Plan;
use super::task::PlanTask;
use super::triple;
use super::unsupported::Unsupported;
use crate::model::geometry::{Triple, TripleKind};
use crate::symbolic::{Expr, Rigid, Vec3};

/// The plan for three revolute joints and three prismatic ones, wherever the axes are; `None` for other arms.
pub fn plan(chain: &LoopChain, task: &PlanTask) -> Option<Result<Plan, Unsupported>> {
    let turning: Vec<usize> =
        (0..chain.loop_joints.len()).filter(|i| chain.loop_joints.get(*i).is_some_and(|s| s.revolute)).collect();
    let [first, second, third] = *turning.as_slice() else { return None };
    if chain.loop_joints.len() != 6 {
        return None;
    }
    let triple = Triple { first, kind: TripleKind::Turning };
    if third == first + 2 {
        let mut c = LoopClosure::new(chain.clone(), triple);
        triple::intersecting(&mut c);
        return Some(displacements(&mut c).map(|()| c.finish(triple, task.clone())));
    }
    let before = 0..first;
    let sliding = (first..6).filter(|joint| !turning.contains(joint));
    let order: Vec<usize> = before.chain([first, second, third]).chain(sliding).collect();
    let mut c = LoopClosure::new(turned_in_a_row(chain, &order, [first, second, third]), triple);
    triple::intersecting(&mut c);
    Some(scattered(&mut c, chain, &order).map(|()| c.finish(triple, task.clone())))
}

/// The chain with its joints in the given order, the revolute ones in a row. Its links inside have no length: they turn as
/// the links that they stand for.
fn turned_in_a_row(chain: &LoopChain, order: &[usize], [first, second, third]: [usize; 3]) -> LoopChain {
    let mut moved = chain.clone();
    moved.loop_joints = order.iter().filter_map(|joint| chain.loop_joints.get(*joint).cloned()).collect();
    // The rotation of the links after joint `from` up to joint `to`.
    let mut between = |from: usize, to: usize| {
        (from + 1..=to).fold(Rigid::identity(), |sum, i| {
            let turn = Rigid { r: chain.link(i).r, ..Rigid::identity() };
            sum.then(&mut moved.g, &turn)
        })
    };
    let mut links = vec![chain.link(0)];
    links.extend((0..first).map(|joint| between(joint, joint + 1)));
    links.extend([between(first, second), between(second, third), between(third, 5)]);
    links.resize(6, Rigid::identity());
    links.push(chain.link(6));
    moved.links = links;
    moved
}

/// Displacements among the revolute joints, in the frame of the base: where the flange is without them, and the direction of
/// each. `order` has the joints of the chain as the closed loop has them.
fn scattered(c: &mut LoopClosure, chain: &LoopChain, order: &[usize]) -> Result<(), Unsupported> {
    let mut still = [Expr::ZERO; 3];
    let mut sliding: Vec<(usize, Vec3)> = Vec::new();
    // From the flange to the base: each joint, and the link before it, move what is behind them.
    for joint in (0..6).rev() {
        let slot = order.iter().position(|other| *other == joint).unwrap_or(joint);
        if c.is_revolute(slot) {
            let pair = c.pair(slot);
            still = c.g.rotate_z(pair, still);
            for (_, axis) in &mut sliding {
                *axis = c.g.rotate_z(pair, *axis);
            }
        } else {
            sliding.push((slot, [Expr::ZERO, Expr::ZERO, Expr::ONE]));
        }
        if joint > 0 {
            let link = chain.link(joint);
            still = link.point(&mut c.g, still);
            for (_, axis) in &mut sliding {
                *axis = c.g.apply3(&link.r, *axis);
            }
        }
    }
    let left = c.g.sub3(c.link(5).back.p, still);
    let (slots, axes): (Vec<usize>, Vec<Vec3>) = sliding.into_iter().rev().unzip();
    match (<[usize; 3]>::try_from(slots), <[Vec3; 3]>::try_from(axes)) {
        (Ok(slots), Ok(axes)) => cramer(c, slots, axes, left),
        _ => Err(Unsupported::new("three joints have to slide")),
    }
}

/// `d_x e_z + R_x d_y e_z + R_x R_y d_z e_z` is what the known rest of the loop leaves.
fn displacements(c: &mut LoopClosure) -> Result<(), Unsupported> {
    let [first, second, third, x, y, z] = c.order;
    let (link_x, link_y) = (c.link(x).forward, c.link(y).forward);
    let mut end = c.link(z).back.p;
    for joint in [first, second, third] {
        let moved = c.move_back(joint, end);
        end = c.link(joint).back.point(&mut c.g, moved);
    }
    let still = link_x.point(&mut c.g, link_y.p);
    let left = c.g.sub3(end, still);
    let link_xy = link_x.then(&mut c.g, &link_y);
    cramer(c, [x, y, z], [[Expr::ZERO, Expr::ZERO, Expr::ONE], link_x.z(), link_xy.z()], left)
}

/// Three linear equations for the displacements along three axes (Cramer).
fn cramer(c: &mut LoopClosure, joints: [usize; 3], axes: [Vec3; 3], left: Vec3) -> Result<(), Unsupported> {
    let axes = axes.map(|axis| c.clean3(axis, Unit::Direction));
    let denominator = determinant(c, axes);
    if c.vanish(&[denominator], Unit::Direction) {
        return Err(Unsupported::new(
            "the arm is singular everywhere: its three sliding joints move the tool in a plane only",
        ));
    }
    for (place, joint) in joints.into_iter().enumerate() {
        let mut columns = axes;
        if let Some(column) = columns.get_mut(place) {
            *column = left;
        }
        let meaning = format!("Joint {}: slides by what is left of the tool's place.", c.label(joint));
        let numerator = determinant(c, columns);
        c.slide_to(joint, denominator, numerator, meaning);
    }
    Ok(())
}

fn determinant(c: &mut LoopClosure, [a, b, d]: [Vec3; 3]) -> Expr {
    let across = c.g.cross3(b, d);
    c.g.dot3(a, across)
}
