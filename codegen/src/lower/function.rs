//! Pose, Jacobian and link poses as functions of the joint vector.

use super::{Slot, Straight};
use crate::kinematics::{Column, Kinematics, LinkPoses, Wanted, kinematics, link_poses};
use crate::model::chain::Chain;
use crate::symbolic::{Angles, BoundAngle, Cost, Graph, Label, Part, Rigid, Unknown};

/// A function of the joint vector. First all sines and cosines, in one call, then the arithmetic.
#[derive(Debug, Clone)]
pub struct Function {
    /// Where the joint values go, by joint.
    pub joints: Vec<Slot>,
    /// The sines and cosines.
    pub turned: Vec<BoundAngle>,
    /// The arithmetic. Its results are of a pose the rotation by rows, then the position; of a Jacobian the rows.
    pub straight: Straight,
    /// Operations.
    pub cost: Cost,
}

/// The kinematic functions of an arm.
#[derive(Debug, Clone)]
pub struct Functions {
    /// Pose of the tool: rotation by rows, position.
    pub forward: Function,
    /// The geometric Jacobian, by rows.
    pub jacobian: Function,
    /// Both, in this order.
    pub both: Function,
    /// The pose of every link.
    pub links: Function,
}

impl Functions {
    /// Functions of a chain, for this number of joints.
    pub fn of(chain: &Chain, joints: usize) -> Self {
        let [forward, jacobian, both] = [Wanted::Forward, Wanted::Jacobian, Wanted::Both]
            .map(|wanted| function(&kinematics(chain, wanted), wanted, joints));
        Functions { forward, jacobian, both, links: link_function(&link_poses(chain), joints) }
    }
}

impl Function {
    fn new(mut graph: Graph, angles: &Angles, roots: Vec<Slot>, joints: usize, cost: Cost) -> Self {
        let mut turned = angles.bound.clone();
        turned.sort_by_key(|bound| bound.sum.terms.clone());
        let joints: Vec<Slot> =
            (0..joints).map(|joint| graph.symbol(Unknown::of(Label::Arm(joint), Part::Value))).collect();
        let reserved = (1..=joints.len()).map(|i| format!("q{i}")).chain(["q".to_string()]);
        Function { straight: Straight::new(graph, roots, reserved), joints, turned, cost }
    }

    /// Returns true if the value of a joint is read, in an angle or as a displacement.
    pub fn reads(&self, joint: usize) -> bool {
        let in_angle = self.turned.iter().flat_map(|turned| &turned.sum.terms).any(|(term, _)| *term == joint);
        in_angle || self.joints.get(joint).is_some_and(|slot| self.straight.reads(*slot))
    }
}

/// Pose, Jacobian, or both in this order.
fn function(kinematics: &Kinematics, wanted: Wanted, joints: usize) -> Function {
    let tool = Rigid { r: kinematics.rotation, p: kinematics.translation };
    let roots = match wanted {
        Wanted::Forward => pose(&tool),
        Wanted::Jacobian => jacobian(&kinematics.columns),
        Wanted::Both => [pose(&tool), jacobian(&kinematics.columns)].concat(),
    };
    Function::new(kinematics.graph.clone(), &kinematics.angles, roots, joints, kinematics.cost)
}

/// The pose of every link.
fn link_function(poses: &LinkPoses, joints: usize) -> Function {
    let roots = poses.poses.iter().flat_map(pose).collect();
    Function::new(poses.graph.clone(), &poses.angles, roots, joints, poses.cost)
}

fn pose(pose: &Rigid) -> Vec<Slot> {
    pose.r.iter().flatten().chain(&pose.p).copied().collect()
}

fn jacobian(columns: &[Column]) -> Vec<Slot> {
    let of = |pick: fn(&Column) -> [Slot; 3]| {
        (0..3).flat_map(move |i| columns.iter().filter_map(move |c| pick(c).get(i).copied()))
    };
    of(|c| c.v).chain(of(|c| c.w)).collect()
}
