//! The pose of every link, from the base outward.

use super::link::{self, Run};
use crate::model::chain::{Chain, Elementary};
use crate::symbolic::{Angles, Cost, Expr, Graph, Rigid, transpose};

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
    // Orientation at the start of the run, and what has been passed since.
    let (mut start, mut run) = (current.r, Run::start());
    let mut ends = chain.link_ends.iter().peekable();
    for index in 0..=chain.transforms.len() {
        // On the way to the pose of a link: a point, and its axes behind the twist.
        link::suggest(&mut g, current.p, "w", poses.len() + 1);
        for (column, what) in transpose(&current.r).into_iter().zip(["tx", "ty", "tz"]) {
            link::suggest(&mut g, column, what, poses.len() + 1);
        }
        while ends.next_if(|end| **end == index).is_some() {
            poses.push(current);
            link::name(&mut g, current.p, "p", poses.len());
        }
        let Some(step) = chain.transforms.get(index) else { break };
        match step {
            Elementary::Prismatic { joint } => {
                let displacement = link::displacement(&mut g, *joint);
                let along = g.scale3(displacement, current.z());
                current.p = g.add3(current.p, along);
            }
            Elementary::Revolute { .. } | Elementary::RotateZ { .. } => {
                run.pass(step);
                let pair = angles.pair(&mut g, &run.sum);
                let columns = Graph::identity().map(|axis| {
                    let turned = run.turn(&mut g, pair, axis);
                    g.apply3(&start, turned)
                });
                for (column, what) in columns.into_iter().zip(["x", "y", "z"]) {
                    link::name(&mut g, column, what, step.joint().map_or(0, |joint| joint + 1));
                }
                current.r = transpose(&columns);
            }
            _ => {
                let constant = link::elementary(&mut g, step);
                current = current.then(&mut g, &constant);
                if matches!(step, Elementary::RotateX { angle, .. } if angle.quarter_turns() == Some(2)) {
                    run.pass(step);
                } else if constant.r != Graph::identity() {
                    (start, run) = (current.r, Run::start());
                }
            }
        }
    }
    let roots: Vec<Expr> = poses.iter().flat_map(|pose| pose.r.iter().flatten().chain(&pose.p)).copied().collect();
    let cost = link::finish(&g, &mut angles, &roots);
    LinkPoses { graph: g, angles, poses, cost }
}
