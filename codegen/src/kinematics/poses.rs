//! The pose of every link, from the base outward.

use super::link;
use crate::model::chain::{Chain, Step};
use crate::symbolic::{AngleSum, Angles, Cost, Expr, Graph, Rigid, cost, transpose};

/// The link poses as expressions.
#[derive(Debug, Clone)]
pub struct LinkPoses {
    /// The arena.
    pub graph: Graph,
    /// The sines and cosines they need.
    pub angles: Angles,
    /// One pose per joint.
    pub poses: Vec<Rigid>,
    /// Operations.
    pub cost: Cost,
}

/// Products from the base outward. Within a run of parallel axes the rotation is the one at its start turned by the
/// sum of the joint angles.
pub fn link_poses(chain: &Chain) -> LinkPoses {
    let mut g = Graph::default();
    let mut angles = Angles::default();
    let mut poses = Vec::new();
    let mut current = Rigid::identity();
    // Orientation at the start of the run, the sum since, and whether half turns have reversed the axis.
    let (mut start, mut sum, mut reversed) = (current.r, AngleSum::zero(), false);
    let mut ends = chain.link_ends.iter().peekable();
    for index in 0..=chain.steps.len() {
        // On the way to the pose of a link: a point, and its axes behind the twist.
        link::suggest(&mut g, current.p, "w", poses.len() + 1);
        for (column, what) in transpose(&current.r).into_iter().zip(["tx", "ty", "tz"]) {
            link::suggest(&mut g, column, what, poses.len() + 1);
        }
        while ends.next_if(|end| **end == index).is_some() {
            poses.push(current);
            link::name(&mut g, current.p, "p", poses.len());
        }
        let Some(step) = chain.steps.get(index) else { break };
        let turn = match step {
            Step::Revolute { joint, offset } => Some((Some(*joint), *offset)),
            Step::RotateZ { angle, .. } => Some((None, *angle)),
            _ => None,
        };
        match step {
            Step::Prismatic { joint } => {
                let stroke = link::stroke(&mut g, *joint);
                let along = g.scale3(stroke, current.z());
                current.p = g.add3(current.p, along);
            }
            Step::RotateX { angle, .. } if angle.quarter_turns() == Some(2) => {
                reversed = !reversed;
                let factor = link::step(&mut g, step);
                current = current.then(&mut g, &factor);
            }
            _ => match turn {
                Some((joint, offset)) => {
                    sum.push(joint, offset, reversed);
                    let pair = angles.pair(&mut g, &sum);
                    let mut columns = Graph::identity().map(|axis| {
                        let [x, y, z] = axis;
                        let axis = if reversed { [x, g.neg(y), g.neg(z)] } else { axis };
                        let turned = g.rotate_z(pair, axis);
                        g.apply3(&start, turned)
                    });
                    for (column, what) in columns.iter_mut().zip(["x", "y", "z"]) {
                        link::name(&mut g, *column, what, joint.map_or(0, |j| j + 1));
                    }
                    current.r = transpose(&columns);
                }
                None => {
                    let factor = link::step(&mut g, step);
                    current = current.then(&mut g, &factor);
                    if factor.r != Graph::identity() {
                        (start, sum, reversed) = (current.r, AngleSum::zero(), false);
                    }
                }
            },
        }
    }
    let roots: Vec<Expr> = poses.iter().flat_map(|pose| pose.r.iter().flatten().chain(&pose.p)).copied().collect();
    let used = g.reachable(&roots);
    angles.bound.retain(|b| used.contains(&b.pair.sin) || used.contains(&b.pair.cos));
    let mut operations = cost(&g, &roots);
    operations.sin_cos = link::pairs(&angles);
    LinkPoses { graph: g, angles, poses, cost: operations }
}
