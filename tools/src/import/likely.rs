//! Links of a URDF that are likely to be the ends of an arm: advice where the end of the chain is not plain.

use super::gripper::Grippers;
use super::urdf::{Joint, Kind, Robot};
use super::walk::{Passed, between, end, last_moving, links, moving};

/// The usual names of the frame at the flange.
pub const USUAL: [&str; 7] = ["tool0", "tcp", "tool", "flange", "ee_link", "tool_link", "tool_frame"];

/// A way from the base up to a gripper or to a leaf.
pub struct Limb<'r> {
    pub way: Vec<Passed<'r>>,
    /// The first joint of the gripper that comes next.
    pub gripper: Option<&'r Joint>,
    leaf: &'r str,
}

impl<'r> Limb<'r> {
    pub fn of(grippers: &Grippers<'r>, leaf: &'r str, way: &[Passed<'r>]) -> Self {
        match grippers.without(way) {
            Some((way, joint)) => Self { way, gripper: Some(joint), leaf },
            None => Self { way: way.to_vec(), gripper: None, leaf },
        }
    }

    /// True where both end on one rigid body.
    pub fn is_on_body_of(&self, other: &Self) -> bool {
        last_moving(&self.way) == last_moving(&other.way)
    }

    /// The tool of this limb: a frame with a usual name on its last body, else the last link.
    pub fn tool(&self, robot: &'r Robot, base: &'r str) -> &'r str {
        let body = last_moving(&self.way);
        let on_body = |link: &&str| last_moving(&between(robot, base, link)) == body;
        let usual = USUAL.iter().find_map(|name| links(robot).filter(|link| link.ends_with(name)).find(on_body));
        let last = || if self.gripper.is_none() { self.leaf } else { self.way.last().map_or(base, end) };
        usual.unwrap_or_else(last)
    }
}

/// The help for a chain whose end has to be named. The links with a usual name come first, then `before`, then the other
/// `ends`. `before` is the last link before what is in doubt.
pub fn advice(robot: &Robot, base: &str, before: Option<(&str, &str)>, ends: &[&str]) -> String {
    let grippers = Grippers::of(robot);
    let is_serial = |link: &str| {
        let joints = between(robot, base, link);
        moving(&joints) > 0 && is_whole(&joints) && grippers.on(&joints).is_none()
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

/// The help where several limbs have the most moving joints. Limbs that part early are arms, each with its own --base
/// and --tool. Fingers part late: the chain ends before they do. `ends` are all ends in question.
pub fn which<'r>(robot: &'r Robot, base: &'r str, limbs: &[Limb<'r>], ends: &[&str]) -> String {
    let ways: Vec<&[Passed]> = limbs.iter().map(|limb| &limb.way[..]).collect();
    let parting = shared(base, &ways);
    let trunk = between(robot, base, parting);
    let after = |limb: &Limb| moving(&limb.way).saturating_sub(moving(&trunk));
    let mut arms: Vec<&Limb> = Vec::new();
    for limb in limbs {
        if !arms.iter().any(|arm| arm.is_on_body_of(limb)) {
            arms.push(limb);
        }
    }
    let fingers = arms.len() < 2 || moving(&trunk) >= 3 && arms.iter().all(|arm| after(arm) < moving(&trunk));
    if fingers {
        return advice(robot, base, Some((parting, "the last link before they part")), ends);
    }
    let told = arms.iter().map(|arm| {
        let (tool, joints) = (arm.tool(robot, base), after(arm));
        match moving(&trunk) {
            0 if is_whole(&trunk) => format!("--tool {tool} ({joints} moving joints)"),
            0 => format!("--base {parting} --tool {tool} ({joints} moving joints)"),
            more => {
                format!("--base {parting} --tool {tool} ({joints} moving joints; without --base {})", more + joints)
            }
        }
    });
    format!("name one arm: {}", told.collect::<Vec<_>>().join(", or "))
}

/// True without a joint of several degrees of freedom.
fn is_whole(joints: &[Passed]) -> bool {
    joints.iter().all(|passed| !matches!(passed.joint.kind, Kind::Other(_)))
}

/// The last link that all ways from `base` have in common.
fn shared<'r>(base: &'r str, ways: &[&[Passed<'r>]]) -> &'r str {
    let Some((first, others)) = ways.split_first() else { return base };
    let common = |(index, passed): &(usize, &Passed<'r>)| {
        others.iter().all(|way| way.get(*index).is_some_and(|other| other.joint.name == passed.joint.name))
    };
    first.iter().enumerate().take_while(common).last().map_or(base, |(_, passed)| end(passed))
}
