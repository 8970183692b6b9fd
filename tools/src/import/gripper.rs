//! Where on a chain a gripper or a hand begins: told by names, by mimic joints and by the shape of the tree.

use std::collections::{HashMap, HashSet};

use super::urdf::{Joint, Robot};
use super::walk::{Passed, between, leaves, moves, moving};

/// Parts of the names of a gripper's joints and links.
const FINGERS: [&str; 4] = ["finger", "jaw", "knuckle", "thumb"];

/// Parts of the name of a joint that turns a whole gripper, such as `gripper_roll` or `link5_to_gripper`.
const TURNS_GRIPPER: [&str; 7] = ["wrist", "roll", "rot", "yaw", "pitch", "tilt", "to_gripper"];

/// A body with three or more limbs is a palm if at least so many joints lead to it, and more than each limb has.
const BEFORE_PALM: usize = 3;

/// The grippers of a robot.
pub struct Grippers<'r> {
    robot: &'r Robot,
    /// Names of the joints that hang fingers on a palm.
    in_palms: HashSet<&'r str>,
}

impl<'r> Grippers<'r> {
    pub fn of(robot: &'r Robot) -> Self {
        // Of each body, named after the joint that moves it: the joints before, and of each limb its joints.
        let mut bodies: HashMap<&str, (usize, HashMap<&str, usize>)> = HashMap::new();
        for leaf in leaves(robot) {
            let way: Vec<&str> = between(robot, &robot.root, leaf).iter().filter(|p| moves(p)).map(name).collect();
            for (index, pair) in way.windows(2).enumerate() {
                let [body, limb] = pair else { continue };
                let limbs = &mut bodies.entry(body).or_insert_with(|| (index + 1, HashMap::new())).1;
                let height = limbs.entry(limb).or_insert(0);
                *height = (*height).max(way.len() - index - 1);
            }
        }
        let is_palm = |(before, limbs): &&(usize, HashMap<&str, usize>)| {
            *before >= BEFORE_PALM && limbs.len() >= 3 && limbs.values().all(|height| height < before)
        };
        let in_palms = bodies.values().filter(is_palm).flat_map(|(_, limbs)| limbs.keys().copied()).collect();
        Self { robot, in_palms }
    }

    /// The joint on the way from which on a gripper moves.
    pub fn on(&self, way: &[Passed<'r>]) -> Option<&'r Joint> {
        let moving: Vec<&'r Joint> = way.iter().filter(|passed| moves(passed)).map(|passed| passed.joint).collect();
        let begins = |(index, joint): &(usize, &&'r Joint)| {
            let later = moving.get(index + 1..).unwrap_or(&[]);
            let is_last = later.iter().all(|joint| joint.mimic.is_some() || is_named(joint));
            // A gripper has fewer joints than the arm that carries it.
            let is_small = later.len() < *index || is_last;
            is_named(joint) && is_small
                || self.in_palms.contains(joint.name.as_str())
                || is_last && self.shares_motor(joint, way)
        };
        moving.iter().enumerate().find(begins).map(|(_, joint)| *joint)
    }

    /// The way up to a gripper on it, where joints move before.
    pub fn without(&self, way: &[Passed<'r>]) -> Option<(Vec<Passed<'r>>, &'r Joint)> {
        let joint = self.on(way)?;
        let before: Vec<Passed> = way.iter().take_while(|passed| passed.joint.name != joint.name).copied().collect();
        (moving(&before) > 0).then_some((before, joint))
    }

    /// True for a joint that shares its motor with a joint beside the way.
    fn shares_motor(&self, joint: &Joint, way: &[Passed]) -> bool {
        let on_way = |name: &str| way.iter().any(|passed| passed.joint.name == name);
        let follows = joint.mimic.as_ref().is_some_and(|mimic| !on_way(&mimic.joint));
        let leads = |other: &Joint| !on_way(&other.name) && other.mimic.as_ref().is_some_and(|m| m.joint == joint.name);
        follows || self.robot.joints.iter().any(leads)
    }
}

fn name<'r>(passed: &Passed<'r>) -> &'r str {
    passed.joint.name.as_str()
}

/// True for a joint that is named after a gripper or a finger.
fn is_named(joint: &Joint) -> bool {
    let (name, child) = (joint.name.to_lowercase(), joint.child.to_lowercase());
    let finger = FINGERS.iter().any(|part| name.contains(part) || child.contains(part));
    finger || name.contains("gripper") && !TURNS_GRIPPER.iter().any(|part| name.contains(part))
}
