//! Reads the kinematics of a URDF: links, joints, and nothing else of it.

use std::collections::HashMap;

use roxmltree::{Document, Node};

use super::prefixes;
use super::rigid::{V, unit};

/// The links and joints of a URDF.
#[derive(Debug, Clone)]
pub struct Robot {
    pub name: String,
    pub joints: Vec<Joint>,
    /// The link that is no joint's child.
    pub root: String,
}

/// The motion of a joint's child.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    Fixed,
    Turning,
    Sliding,
    /// `floating`, `planar`: more than one joint of an arm file.
    Other(String),
}

/// A joint: the frame of the child in that of the parent is `origin motion(axis, q)`.
#[derive(Debug, Clone)]
pub struct Joint {
    pub name: String,
    pub kind: Kind,
    pub parent: String,
    pub child: String,
    pub xyz: V,
    pub rpy: V,
    /// A unit vector in the joint's frame.
    pub axis: V,
    /// Lowest and highest value, rad or m; infinite where there is no end on that side, and not on both.
    pub limits: Option<[f64; 2]>,
    /// The limits as written, where an end of them is so far away that it is none.
    pub endless: Option<[f64; 2]>,
    /// Greatest velocity, rad/s or m/s; none where the URDF has none, 0, or no finite number.
    pub velocity: Option<f64>,
    pub mimic: Option<Mimic>,
}

/// `q = multiplier * q(joint) + offset`
#[derive(Debug, Clone)]
pub struct Mimic {
    pub joint: String,
    pub multiplier: f64,
    pub offset: f64,
}

/// An end of a range beyond this, rad or m, is written by some exporters for none.
const MOST_LIMIT: f64 = 1e6;

/// Reads the text of a URDF.
///
/// # Errors
/// The first mistake with its line. Mistakes are: no XML, no robot, a joint without parent or child, text in the place
/// of a number, links that are no tree.
pub fn read(text: &str) -> Result<Robot, String> {
    let text = prefixes::declared(text);
    let document = Document::parse(&text).map_err(|error| {
        if !text.contains('<') && ["kinematics:", "delta_theta"].iter().any(|key| text.contains(key)) {
            "this is not a URDF but a UR arm's calibration: read it with `--ur-calibration FILE`".to_owned()
        } else {
            format!("this is not XML: {error}")
        }
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "robot" {
        return Err(format!("this is not a URDF: expected `<robot>`, found `<{}>`", root.tag_name().name()));
    }
    let xacro = root.descendants().find(|node| node.tag_name().namespace().is_some_and(|name| name.contains("xacro")));
    if let Some(node) = xacro {
        let line = line(&node);
        return Err(format!(
            "line {line}: `<xacro:{}>`: this file is a template\nhelp: expand it first: xacro robot.urdf.xacro > robot.urdf",
            node.tag_name().name()
        ));
    }
    let mut joints = Vec::new();
    let mut named = HashMap::new();
    for node in elements(&root, "joint") {
        let joint = joint(&node)?;
        // A line number is counted from the start of the text, so for a mistake alone.
        if let Some(first) = named.insert(joint.name.clone(), node) {
            let (first, second) = (line(&first), line(&node));
            return Err(format!("line {second}: a second joint `{}`, the first is in line {first}", joint.name));
        }
        joints.push(joint);
    }
    let root_link = tree(&joints, elements(&root, "link").filter_map(|link| link.attribute("name")))?;
    let name = root.attribute("name").unwrap_or("robot").to_owned();
    Ok(Robot { name, joints, root: root_link })
}

/// The children of this name without a prefix: `drake:joint` is no joint.
fn elements<'a, 'i: 'a>(node: &Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    let plain = |child: &Node| child.tag_name().namespace() == child.default_namespace();
    node.children().filter(move |child| child.is_element() && child.tag_name().name() == name && plain(child))
}

fn line(node: &Node) -> u32 {
    node.document().text_pos_at(node.range().start).row
}

fn joint(node: &Node) -> Result<Joint, String> {
    let at = |message: String| format!("line {}: {message}", line(node));
    let name = node.attribute("name").ok_or_else(|| at("a joint without a name".to_owned()))?.to_owned();
    let of = |message: String| at(format!("joint `{name}`: {message}"));
    let child = |tag: &'static str| elements(node, tag).next();
    let link = |tag: &'static str| {
        let link = child(tag).and_then(|node| node.attribute("link"));
        link.map(str::to_owned).ok_or_else(|| of(format!("no `<{tag} link=\"..\"/>`")))
    };
    let number = |tag: &'static str, key: &str| -> Result<Option<f64>, String> {
        let text = child(tag).and_then(|node| node.attribute(key));
        let refused = |text: &str| of(format!("`{key}=\"{text}\"`: expected a number{}", meant(text)));
        text.map(|text| real(text).ok_or_else(|| refused(text))).transpose()
    };
    let vector = |tag: &'static str, key: &str, default: V| -> Result<V, String> {
        let Some(text) = child(tag).and_then(|node| node.attribute(key)) else { return Ok(default) };
        let numbers: Vec<f64> = text.split_whitespace().map_while(real).collect();
        match numbers[..] {
            [x, y, z] if text.split_whitespace().count() == 3 => Ok([x, y, z]),
            _ => Err(of(format!("`{key}=\"{text}\"`: expected three numbers{}", meant(text)))),
        }
    };
    let written = node.attribute("type").ok_or_else(|| of("no `type`".to_owned()))?;
    let kind = match written {
        "fixed" => Kind::Fixed,
        "revolute" | "continuous" => Kind::Turning,
        "prismatic" => Kind::Sliding,
        other => Kind::Other(other.to_owned()),
    };
    let axis = vector("axis", "xyz", [1.0, 0.0, 0.0])?;
    let axis = match (unit(axis), &kind) {
        (Some(axis), _) => axis,
        (None, Kind::Turning | Kind::Sliding) => return Err(of(format!("axis {axis:?} has no direction"))),
        (None, _) => axis,
    };
    let end = |key: &str| -> Result<Option<f64>, String> {
        let text = child("limit").and_then(|node| node.attribute(key));
        // Some write an end without a limit as infinity.
        match text.and_then(|text| text.trim().parse::<f64>().ok()).filter(|value| value.is_infinite()) {
            Some(infinite) => Ok(Some(infinite)),
            None => number("limit", key),
        }
    };
    let written_limits = match (end("lower")?, end("upper")?) {
        _ if written == "continuous" => None,
        // Only effort and velocity.
        (None, None) => None,
        (low, high) => {
            let limits = [low.unwrap_or(0.0), high.unwrap_or(0.0)];
            if limits[0] > limits[1] {
                return Err(of(format!("the lower limit {} is above the upper one {}", limits[0], limits[1])));
            }
            Some(limits)
        }
    };
    let limits = written_limits.map(|[low, high]| {
        [if low < -MOST_LIMIT { f64::NEG_INFINITY } else { low }, if high > MOST_LIMIT { f64::INFINITY } else { high }]
    });
    let endless = limits != written_limits || limits.is_some_and(|ends| ends.iter().any(|end| end.is_infinite()));
    let limits = limits.filter(|ends| ends.iter().any(|end| end.is_finite()));
    // Exporters write 0 for a velocity that they do not know.
    let velocity = child("limit").and_then(|node| node.attribute("velocity")).and_then(real);
    let velocity = velocity.filter(|velocity| *velocity > 0.0 && *velocity <= MOST_LIMIT);
    let mimic = match child("mimic") {
        None => None,
        Some(mimic) => {
            let joint = mimic.attribute("joint").ok_or_else(|| of("`<mimic>` without a joint".to_owned()))?.to_owned();
            let multiplier = number("mimic", "multiplier")?.unwrap_or(1.0);
            Some(Mimic { joint, multiplier, offset: number("mimic", "offset")?.unwrap_or(0.0) })
        }
    };
    Ok(Joint {
        kind,
        parent: link("parent")?,
        child: link("child")?,
        xyz: vector("origin", "xyz", [0.0; 3])?,
        rpy: vector("origin", "rpy", [0.0; 3])?,
        axis,
        limits,
        endless: endless.then_some(written_limits).flatten(),
        velocity,
        mimic,
        name: name.clone(),
    })
}

/// A help line for a text that is no number.
fn meant(text: &str) -> &'static str {
    match text {
        text if text.contains("${") => "\nhelp: expand the template first: xacro robot.urdf.xacro > robot.urdf",
        text if text.contains(',') => "\nhelp: write a decimal point, and spaces between numbers",
        _ => "",
    }
}

fn real(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

/// The root of the tree of links, if they are one tree.
fn tree<'a>(joints: &'a [Joint], links: impl Iterator<Item = &'a str>) -> Result<String, String> {
    let mut parent_of: HashMap<&str, &Joint> = HashMap::new();
    for joint in joints {
        if let Some(other) = parent_of.insert(&joint.child, joint) {
            return Err(format!(
                "link `{}` is the child of two joints, `{}` and `{}`",
                joint.child, other.name, joint.name
            ));
        }
    }
    let declared: Vec<&str> = links.collect();
    let mut roots: Vec<&str> = Vec::new();
    for link in declared.iter().copied().chain(joints.iter().map(|joint| joint.parent.as_str())) {
        if !parent_of.contains_key(link) && !roots.contains(&link) {
            roots.push(link);
        }
    }
    match roots[..] {
        [root] => Ok(root.to_owned()),
        [] if joints.is_empty() => {
            Err("`<robot>` is empty: it has no link and no joint\nhelp: a URDF has `<link>` and \
                                        `<joint>` elements directly in `<robot>`; export it again"
                .to_owned())
        }
        [] => Err("no link is the root: the joints go round in a circle".to_owned()),
        _ => {
            let unknown = joints.iter().find(|joint| !declared.contains(&joint.parent.as_str()));
            let told = unknown.map_or_else(String::new, |joint| {
                format!(
                    "\nhelp: joint `{}` has the parent `{}`, and no `<link>` has this name",
                    joint.name, joint.parent
                )
            });
            Err(format!("the links are no tree: {} have no parent{told}", roots.join(", ")))
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn what_is_left_out_has_the_value_of_the_format() {
        let text = r#"<robot name="r"><link name="a"/><link name="b"/>
            <joint name="j" type="revolute"><parent link="a"/><child link="b"/><limit effort="1" velocity="1"/></joint></robot>"#;
        let robot = read(text).unwrap();
        let joint = &robot.joints[0];
        assert_eq!((joint.axis, joint.xyz, joint.rpy, joint.limits), ([1.0, 0.0, 0.0], [0.0; 3], [0.0; 3], None));
        assert_eq!((robot.root.as_str(), robot.name.as_str()), ("a", "r"));
        assert_eq!(joint.velocity, Some(1.0));
    }

    #[test]
    fn a_velocity_of_no_use_is_none() {
        for (velocity, expected) in
            [("2.5", Some(2.5)), ("0", None), ("-1", None), ("inf", None), ("nan", None), ("fast", None), ("1e9", None)]
        {
            let text = format!(
                r#"<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/>
                <child link="b"/><limit effort="1" velocity="{velocity}"/></joint></robot>"#
            );
            assert_eq!(read(&text).unwrap().joints[0].velocity, expected, "{velocity}");
        }
    }

    #[test]
    fn elements_and_attributes_with_a_prefix_are_not_of_the_format() {
        let text = r#"<!-- <robot> --><robot name="r" viz:name="no"><link name="a"/><link name="b" drake:name="no"/>
            <drake:link name="no"/><drake:joint name="no"/>
            <joint name="j" type="revolute"><drake:parent link="no"/><parent link="a"/><child link="b"/>
            <limit drake:acceleration="40" lower="-1" upper="1" drake:lower="no"/></joint></robot>"#;
        let robot = read(text).unwrap();
        assert_eq!((robot.root.as_str(), robot.name.as_str(), robot.joints.len()), ("a", "r", 1));
        assert_eq!((robot.joints[0].parent.as_str(), robot.joints[0].limits), ("a", Some([-1.0, 1.0])));
        // The prefix of another element is none of those that belong to the format.
        let spaced = text.replace("<robot ", "<robot xmlns=\"urn:robot\" xmlns:drake=\"urn:drake\" ");
        assert_eq!(read(&spaced).unwrap().joints.len(), 1);
    }

    #[test]
    fn mistakes_are_named_with_their_line() {
        let joint = |inside: &str| {
            format!(
                "<robot name=\"r\">\n<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"revolute\">{inside}</joint></robot>"
            )
        };
        let ends = "<parent link=\"a\"/><child link=\"b\"/>";
        for (text, said) in [
            (joint("<parent link=\"a\"/>"), "line 3: joint `j`: no `<child link=\"..\"/>`"),
            (joint(&format!("{ends}<axis xyz=\"0 0\"/>")), "line 3: joint `j`: `xyz=\"0 0\"`: expected three numbers"),
            (joint(&format!("{ends}<axis xyz=\"0 0 0\"/>")), "has no direction"),
            (joint(&format!("{ends}<limit lower=\"nan\" upper=\"1\"/>")), "`lower=\"nan\"`: expected a number"),
            (joint(&format!("{ends}<limit lower=\"2\" upper=\"1\"/>")), "the lower limit 2 is above the upper one 1"),
            (
                joint(&format!("{ends}<axis xyz=\"0, 0, 1\"/>")),
                "expected three numbers\nhelp: write a decimal point, and spaces",
            ),
            (
                joint(&format!("{ends}<limit lower=\"-${{pi}}\"/>")),
                "expected a number\nhelp: expand the template first",
            ),
            (
                joint("<parent link=\"base\"/><child link=\"b\"/>"),
                "a, base have no parent\nhelp: joint `j` has the parent `base`, and no `<link>` has this name",
            ),
            (
                format!(
                    "<robot>\n<joint name=\"j\" type=\"fixed\">{ends}</joint>\n<joint name=\"j\" type=\"fixed\">{ends}</joint></robot>"
                ),
                "line 3: a second joint `j`, the first is in line 2",
            ),
            ("<robot".to_owned(), "this is not XML"),
            ("kinematics:\n  shoulder: {x: 0}".to_owned(), "--ur-calibration FILE"),
            ("<sdf/>".to_owned(), "expected `<robot>`, found `<sdf>`"),
            (
                "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<xacro:include/></robot>".to_owned(),
                "line 2: `<xacro:include>`: this file is a template",
            ),
            (
                "<robot name=\"r\">\n\n<drake:a/><xacro:arm/></robot>".to_owned(),
                "line 3: `<xacro:arm>`: this file is a template",
            ),
            ("<robot name=\"r\">\n<drake:a/>\n<joint name=\"j\"/></robot>".to_owned(), "line 3: joint `j`: no `type`"),
            (
                "<robot><link name=\"a\"/><link name=\"b\"/></robot>".to_owned(),
                "the links are no tree: a, b have no parent",
            ),
        ] {
            let message = read(&text).unwrap_err();
            assert!(message.contains(said), "{message}");
        }
    }
}
