//! The way through the tree of a URDF from one link to another.

use super::urdf::{Joint, Kind, Robot};

/// A joint on the way from base to tool.
#[derive(Debug, Clone, Copy)]
pub struct Passed<'r> {
    pub joint: &'r Joint,
    /// From child to parent: its motion and its origin are undone.
    pub backward: bool,
}

/// All links, the root first.
pub fn links(robot: &Robot) -> impl Iterator<Item = &str> {
    [robot.root.as_str()].into_iter().chain(robot.joints.iter().map(|joint| joint.child.as_str()))
}

/// The links without a joint after them.
pub fn leaves(robot: &Robot) -> impl Iterator<Item = &str> {
    links(robot).filter(|link| !robot.joints.iter().any(|joint| joint.parent == *link))
}

/// The joints from the root to a link.
fn from_root<'r>(robot: &'r Robot, link: &str) -> Vec<&'r Joint> {
    let mut joints = Vec::new();
    let mut link = link;
    // A circle beside the tree has no end; no chain is longer than the list of joints.
    while let Some(joint) = robot.joints.iter().find(|joint| joint.child == link) {
        if joints.len() == robot.joints.len() {
            break;
        }
        joints.push(joint);
        link = &joint.parent;
    }
    joints.reverse();
    joints
}

/// The joints from `base` to `tool`: up to the link that both hang from, and down.
pub fn between<'r>(robot: &'r Robot, base: &str, tool: &str) -> Vec<Passed<'r>> {
    let (up, down) = (from_root(robot, base), from_root(robot, tool));
    let shared = up.iter().zip(&down).take_while(|(a, b)| a.name == b.name).count();
    let backward = up.iter().skip(shared).rev().map(|joint| Passed { joint, backward: true });
    backward.chain(down.iter().skip(shared).map(|joint| Passed { joint, backward: false })).collect()
}

/// The link to which a joint leads.
pub fn end<'r>(passed: &Passed<'r>) -> &'r str {
    if passed.backward { &passed.joint.parent } else { &passed.joint.child }
}

/// True for a joint that turns or slides.
pub fn moves(passed: &Passed) -> bool {
    matches!(passed.joint.kind, Kind::Turning | Kind::Sliding)
}

/// The number of joints that turn or slide.
pub fn moving(joints: &[Passed]) -> usize {
    joints.iter().filter(|passed| moves(passed)).count()
}

/// The name of the last joint that moves. Ways with the same one end on one rigid body.
pub fn last_moving<'r>(joints: &[Passed<'r>]) -> Option<&'r str> {
    joints.iter().rev().find(|passed| moves(passed)).map(|passed| passed.joint.name.as_str())
}
