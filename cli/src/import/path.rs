//! The serial chain between two links of a URDF.

use super::likely;
use super::urdf::{Joint, Kind, Robot};
pub use super::walk::Passed;
use super::walk::{between, links, moving};

/// A chain and the links at its ends.
#[derive(Debug, Clone)]
pub struct Path<'r> {
    pub base: String,
    pub tool: String,
    pub joints: Vec<Passed<'r>>,
}

/// The chain from `base` (else the root) to `tool` (else the one leaf with the most moving joints between).
///
/// # Errors
/// A name that is no link's, or several leaves as good as each other. A chain without a moving joint, or with a joint of
/// more than one degree of freedom.
pub fn find<'r>(robot: &'r Robot, base: Option<&str>, tool: Option<&str>) -> Result<Path<'r>, String> {
    let base = named(robot, base.unwrap_or(&robot.root))?;
    let tool = match tool {
        Some(tool) => named(robot, tool)?,
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
        return Err(format!(
            "no joint moves between `{base}` and `{tool}`\nhelp: name other links with --base and --tool"
        ));
    }
    Ok(Path { base: base.to_owned(), tool: tool.to_owned(), joints })
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

/// The leaf with the most moving joints on the way. Of leaves on one rigid body, the first in the file that ends the
/// longest chain of links.
fn farthest<'r>(robot: &'r Robot, base: &str) -> Result<&'r str, String> {
    let is_leaf = |link: &str| !robot.joints.iter().any(|joint| joint.parent == link);
    let leaves: Vec<(&str, Vec<Passed>)> =
        links(robot).filter(|link| is_leaf(link)).map(|link| (link, between(robot, base, link))).collect();
    let most = leaves.iter().map(|(_, joints)| moving(joints)).max().unwrap_or(0);
    let best: Vec<&(&str, Vec<Passed>)> = leaves.iter().filter(|(_, joints)| moving(joints) == most).collect();
    // Leaves whose last moving joint is the same are frames of one body.
    let last = |joints: &[Passed]| {
        let moved = joints.iter().rev().find(|passed| matches!(passed.joint.kind, Kind::Turning | Kind::Sliding));
        moved.map(|passed| passed.joint.name.clone())
    };
    let one_body = best.windows(2).all(|pair| matches!(pair, [a, b] if last(&a.1) == last(&b.1)));
    let ends: Vec<&str> = best.iter().map(|(link, _)| *link).collect();
    if !one_body {
        let ways: Vec<&[Passed]> = best.iter().map(|(_, joints)| &joints[..]).collect();
        let before = (likely::shared(base, &ways), "the last link before they part");
        let help = likely::advice(robot, base, Some(before), &ends);
        return Err(format!("several chains have {most} moving joints\nhelp: {help}"));
    }
    if let Some((_, way)) = best.first()
        && let Some(joint) = likely::gripper(robot, way)
    {
        let before = (joint.parent.as_str(), "the last link before it");
        let help = likely::advice(robot, base, Some(before), &ends);
        return Err(format!("the longest chain ends in a gripper, which joint `{}` moves\nhelp: {help}", joint.name));
    }
    // A usual name at the flange, else the only one.
    let found = likely::USUAL.iter().find_map(|name| best.iter().find(|(link, _)| link.ends_with(name)));
    match (found, &best[..]) {
        (Some((link, _)), _) => Ok(link),
        (None, [(link, _)]) => Ok(link),
        (None, _) => {
            let help = format!("name one with --tool: {}", ends.join(", "));
            Err(format!("several frames are on the last body\nhelp: {help}"))
        }
    }
}
