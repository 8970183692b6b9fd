//! The serial chain between two links of a URDF.

use super::gripper::Grippers;
use super::likely::{self, Limb};
use super::urdf::{Joint, Kind, Robot};
pub use super::walk::Passed;
use super::walk::{between, last_moving, leaves, links, moving};

/// A chain and the links at its ends.
#[derive(Debug, Clone)]
pub struct Path<'r> {
    pub base: String,
    pub tool: String,
    pub joints: Vec<Passed<'r>>,
    /// A gripper that the chain would end in, had its end not been chosen.
    pub gripper: Option<Gripper>,
}

/// A gripper that is left out.
#[derive(Debug, Clone)]
pub struct Gripper {
    /// The first joint of it.
    pub joint: String,
    /// The end of the chain with the gripper.
    pub end: String,
}

/// The chain from `base` (else the root) to `tool` (else the one leaf with the most moving joints between, without its
/// gripper).
///
/// # Errors
/// A name that is no link's, or several leaves as good as each other. A chain without a moving joint, or with a joint of
/// more than one degree of freedom.
pub fn find<'r>(robot: &'r Robot, base: Option<&str>, tool: Option<&str>) -> Result<Path<'r>, String> {
    let base = named(robot, base.unwrap_or(&robot.root))?;
    let (tool, gripper) = match tool {
        Some(tool) => (named(robot, tool)?, None),
        None => farthest(robot, base)?,
    };
    let joints = between(robot, base, tool);
    if let Some(passed) = joints.iter().find(|passed| matches!(passed.joint.kind, Kind::Other(_))) {
        let Joint { name, kind, .. } = passed.joint;
        let kind: &str = if let Kind::Other(kind) = kind { kind } else { "" };
        if !matches!(kind, "floating" | "planar") {
            return Err(format!(
                "joint `{name}`: a URDF has no joints of type `{kind}`\nhelp: write revolute, continuous, prismatic or fixed"
            ));
        }
        return Err(format!(
            "joint `{name}` is {kind}, which is no joint of a serial arm\nhelp: {}",
            around(robot, base, &joints, passed)
        ));
    }
    if moving(&joints) == 0 {
        // The chain that would be taken, or the help for choosing one.
        let instead = match farthest(robot, base) {
            Ok((link, _)) => format!("--tool {link} is the end of the chain with the most moving joints"),
            Err(message) => message.split_once("\nhelp: ").map_or(String::new(), |(_, help)| help.to_owned()),
        };
        return Err(format!("no joint moves between `{base}` and `{tool}`\nhelp: {instead}"));
    }
    Ok(Path { base: base.to_owned(), tool: tool.to_owned(), joints, gripper })
}

/// How to leave a floating or planar joint out: the chain ends before it, or begins after it, where joints move there.
fn around(robot: &Robot, base: &str, joints: &[Passed], at: &Passed) -> String {
    let (first, second) = match at.backward {
        true => (&at.joint.child, &at.joint.parent),
        false => (&at.joint.parent, &at.joint.child),
    };
    let index = joints.iter().position(|passed| passed.joint.name == at.joint.name).unwrap_or(0);
    let (before, after) = joints.split_at(index);
    let end = (moving(before) > 0).then(|| {
        let why = "the last link before it";
        format!("end the chain before it: {}", likely::advice(robot, base, Some((first, why)), &[]))
    });
    let begin = (moving(after) > 0 || end.is_none()).then(|| format!("begin the chain after it: --base {second}"));
    end.into_iter().chain(begin).collect::<Vec<_>>().join("; or ")
}

fn named<'r>(robot: &'r Robot, name: &str) -> Result<&'r str, String> {
    links(robot).find(|link| *link == name).ok_or_else(|| {
        let list: Vec<&str> = links(robot).collect();
        format!("no link is named `{name}`\nhelp: the links are {}", list.join(", "))
    })
}

/// The leaf with the most moving joints on the way, or the last link before a gripper on it. Of leaves on one rigid
/// body, the one with a usual name.
fn farthest<'r>(robot: &'r Robot, base: &'r str) -> Result<(&'r str, Option<Gripper>), String> {
    let leaves: Vec<(&str, Vec<Passed>)> = leaves(robot).map(|link| (link, between(robot, base, link))).collect();
    let most = leaves.iter().map(|(_, joints)| moving(joints)).max().unwrap_or(0);
    if most == 0 {
        return Err(still(robot, base));
    }
    let best: Vec<&(&str, Vec<Passed>)> = leaves.iter().filter(|(_, joints)| moving(joints) == most).collect();
    let ends: Vec<&str> = best.iter().map(|(link, _)| *link).collect();
    // A usual name at the flange, else the only one.
    let usual = likely::USUAL.iter().find_map(|name| ends.iter().find(|link| link.ends_with(name)));
    let found = usual.or(if let [one] = &ends[..] { Some(one) } else { None }).copied();
    let grippers = Grippers::of(robot);
    let limbs = |of: &[&(&'r str, Vec<Passed<'r>>)]| -> Vec<Limb<'r>> {
        of.iter().map(|(link, way)| Limb::of(&grippers, link, way)).collect()
    };
    let one_body = best.windows(2).all(|pair| matches!(pair, [a, b] if last_moving(&a.1) == last_moving(&b.1)));
    if !one_body {
        let help = likely::which(robot, base, &limbs(&best), &ends);
        return Err(format!("several chains have {most} moving joints\nhelp: {help}"));
    }
    let limb = best.first().map(|(link, way)| Limb::of(&grippers, link, way));
    let Some((limb, joint)) = limb.and_then(|limb| limb.gripper.map(|joint| (limb, joint))) else {
        return found.map(|link| (link, None)).ok_or_else(|| {
            let help = format!("name one with --tool: {}", ends.join(", "));
            format!("several frames are on the last body\nhelp: {help}")
        });
    };
    // Without the gripper another chain may have as many joints.
    let most = moving(&limb.way);
    let mut rivals = limbs(&leaves.iter().collect::<Vec<_>>());
    rivals.retain(|other| moving(&other.way) >= most);
    if rivals.iter().any(|other| !other.is_on_body_of(&limb)) {
        let ends: Vec<&str> = rivals.iter().map(|limb| limb.tool(robot, base)).collect();
        let help = likely::which(robot, base, &rivals, &ends);
        return Err(format!("several chains have {most} moving joints before a gripper\nhelp: {help}"));
    }
    let end = found.or(ends.first().copied()).unwrap_or(base).to_owned();
    Ok((limb.tool(robot, base), Some(Gripper { joint: joint.name.clone(), end })))
}

/// The message for a URDF of which no joint moves, or none beyond the base.
fn still(robot: &Robot, base: &str) -> String {
    let kinds = || robot.joints.iter().map(|joint| &joint.kind);
    if kinds().any(|kind| matches!(kind, Kind::Turning | Kind::Sliding)) {
        let root = &robot.root;
        return format!("no joint moves beyond `{base}`\nhelp: --tool {root} takes the chain from there to the root");
    }
    let told = match robot.joints.len() {
        0 => "this URDF has no joints".to_owned(),
        _ if kinds().all(|kind| *kind == Kind::Fixed) => "no joint of this URDF moves: all are fixed".to_owned(),
        _ => "no joint of this URDF turns or slides".to_owned(),
    };
    format!("{told}\nhelp: joints of an arm have the type revolute, continuous or prismatic")
}
