//! Three revolute and three prismatic joints (decoupled): the revolute ones alone turn the tool.

use super::kernel::Unit;
use super::loop_chain::LoopChain;
use super::loop_closure::LoopClosure;
use super::plan::Plan;
use super::task::PlanTask;
use super::triple;
use super::unsupported::Unsupported;
use crate::model::geometry::{Triple, TripleKind};
use crate::symbolic::{Expr, Vec3};

/// The plan for three revolute joints in a row and three prismatic ones, wherever the axes are; `None` for other arms.
pub fn plan(chain: &LoopChain, task: &PlanTask) -> Option<Result<Plan, Unsupported>> {
    let turning: Vec<usize> =
        (0..chain.loop_joints.len()).filter(|i| chain.loop_joints.get(*i).is_some_and(|s| s.revolute)).collect();
    let [first, second, third] = *turning.as_slice() else { return None };
    let in_a_row = second == first + 1 && third == second + 1 && chain.loop_joints.len() == 6;
    in_a_row.then(|| {
        let triple = Triple { first, kind: TripleKind::Turning };
        let mut c = LoopClosure::new(chain.clone(), triple);
        triple::intersecting(&mut c);
        displacements(&mut c)?;
        Ok(c.finish(triple, task.clone()))
    })
}

/// `d_x e_z + R_x d_y e_z + R_x R_y d_z e_z` is what the known rest of the loop leaves: three linear equations (Cramer).
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
    let axes = [[Expr::ZERO, Expr::ZERO, Expr::ONE], link_x.z(), link_xy.z()];
    let axes = axes.map(|axis| c.clean3(axis, Unit::Direction));
    let denominator = determinant(c, axes);
    if c.vanish(&[denominator], Unit::Direction) {
        return Err(Unsupported::new(
            "the arm is singular everywhere: its three sliding joints move the tool in a plane only",
        ));
    }
    for (place, joint) in [x, y, z].into_iter().enumerate() {
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
