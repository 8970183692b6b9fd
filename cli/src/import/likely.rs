//! Which links of a URDF are likely to be the tool: advice where the end of the chain is not plain.

use super::urdf::{Joint, Kind, Robot};
use super::walk::{Passed, between, links, moving};

/// The usual names of the frame at the flange.
pub const USUAL: [&str; 5] = ["tool0", "tcp", "tool", "flange", "ee_link"];

/// Parts of the names of a gripper's joints and links.
const FINGERS: [&str; 3] = ["finger", "jaw", "knuckle"];

/// The joint on the way from which on a gripper moves. Such a joint shares a motor with a joint beside the way, or its
/// name says so.
pub fn gripper<'r>(robot: &'r Robot, joints: &[Passed<'r>]) -> Option<&'r Joint> {
    let on_way = |name: &str| joints.iter().any(|passed| passed.joint.name == name);
    let beside = |joint: &Joint| {
        let follows = joint.mimic.as_ref().is_some_and(|mimic| !on_way(&mimic.joint));
        let leads = |other: &Joint| !on_way(&other.name) && other.mimic.as_ref().is_some_and(|m| m.joint == joint.name);
        follows || robot.joints.iter().any(leads)
    };
    let named = |joint: &Joint| {
        let text = format!("{} {}", joint.name, joint.child).to_lowercase();
        FINGERS.iter().any(|part| text.contains(part))
    };
    let moves = |joint: &Joint| matches!(joint.kind, Kind::Turning | Kind::Sliding);
    joints.iter().map(|passed| passed.joint).find(|joint| moves(joint) && (beside(joint) || named(joint)))
}

/// The help for a chain whose end has to be named. The links with a usual name come first, then `before`, then the other
/// `ends`. `before` is the last link before what is in doubt.
pub fn advice(robot: &Robot, base: &str, before: Option<(&str, &str)>, ends: &[&str]) -> String {
    let is_serial = |link: &str| {
        let joints = between(robot, base, link);
        let whole = joints.iter().all(|passed| !matches!(passed.joint.kind, Kind::Other(_)));
        whole && moving(&joints) > 0 && gripper(robot, &joints).is_none()
    };
    let usual: Vec<&str> = USUAL
        .iter()
        .flat_map(|name| links(robot).filter(move |link| link.ends_with(name)))
        .filter(|l| is_serial(l))
        .collect();
    let mut likely: Vec<String> = Vec::new();
    for link in &usual {
        let told = format!("--tool {link}");
        if !likely.contains(&told) {
            likely.push(told);
        }
    }
    if let Some((link, why)) = before.filter(|(link, _)| is_serial(link) && !usual.contains(link)) {
        likely.push(format!("--tool {link} ({why})"));
    }
    let ends = ends.join(", ");
    match likely.join(", or ") {
        none if none.is_empty() => format!("name the last link with --tool: {ends}"),
        likely if ends.is_empty() => likely,
        likely => format!("{likely}; the ends are {ends}"),
    }
}

/// The last link that all ways from `base` have in common.
pub fn shared<'r>(base: &'r str, ways: &[&[Passed<'r>]]) -> &'r str {
    let Some((first, others)) = ways.split_first() else { return base };
    let common = |(index, passed): &(usize, &Passed<'r>)| {
        others.iter().all(|way| way.get(*index).is_some_and(|other| other.joint.name == passed.joint.name))
    };
    let last = first.iter().enumerate().take_while(common).last();
    last.map_or(base, |(_, passed)| if passed.backward { &passed.joint.parent } else { &passed.joint.child })
}
