//! Arm files to start from, for the usual structures.
//!
//! One table serves both conventions. A modified row has `a` and `alpha` of the standard row before it, and the last
//! standard row has none.

use clap::ValueEnum;

use crate::table::aligned;

/// The convention of the table.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Convention {
    /// Row i: Rz(theta) Tz(d) Tx(a) Rx(alpha)
    Standard,
    /// Craig, row i: Rx(alpha) Tx(a) Rz(theta) Tz(d), with a and alpha of the link before
    Modified,
}

/// A row of the standard convention. A joint without `limits` turns freely. The comment has a part of the joint, which
/// includes `d` and `theta`, and a part of the link behind it.
struct Row {
    a: &'static str,
    alpha: &'static str,
    d: &'static str,
    theta: &'static str,
    slides: bool,
    limits: &'static str,
    joint: &'static str,
    link: &'static str,
}

/// An arm to start from.
pub struct Template {
    /// The arm's structure, and the target of its inverse.
    about: &'static str,
    rows: &'static [Row],
    tool: &'static str,
    tool_comment: &'static str,
    /// Comment and request for the inverse.
    inverse: &'static str,
}

const fn turn(numbers: [&'static str; 4], limits: &'static str, [joint, link]: [&'static str; 2]) -> Row {
    let [a, alpha, d, theta] = numbers;
    Row { a, alpha, d, theta, slides: false, limits, joint, link }
}

const fn slide(numbers: [&'static str; 4], limits: &'static str, comments: [&'static str; 2]) -> Row {
    Row { slides: true, ..turn(numbers, limits, comments) }
}

/// The template for so many joints.
pub fn of_joints(joints: u8) -> Option<&'static Template> {
    match joints {
        3 => Some(&THREE),
        4 => Some(&FOUR),
        5 => Some(&FIVE),
        6 => Some(&SIX),
        7 => Some(&SEVEN),
        _ => None,
    }
}

const THREE: Template = Template {
    about: "Three joints: the base turns, shoulder and elbow lift. A point is reached, its orientation follows.",
    rows: &[
        turn(["0", "90", "0.3", "0"], "[-170, 170]", ["base; d: height of the shoulder", ""]),
        turn(["0.4", "0", "0", "0"], "[-30, 190]", ["shoulder", "a: length of the upper arm"]),
        turn(["0", "0", "0", "0"], "[-150, 150]", ["elbow; the forearm is in the tool", ""]),
    ],
    tool: "[0.35, 0, 0]",
    tool_comment: "length of the forearm",
    inverse: "\
# The inverse is asked for a point: x, y, z of the tool.
inverse: {task: position, require: true}
",
};

const FOUR: Template = Template {
    about: "Four joints: the base turns, shoulder, elbow and wrist lift in one plane, as most desktop arms do.",
    rows: &[
        turn(["0", "90", "0.1", "0"], "[-170, 170]", ["base; d: height of the shoulder", ""]),
        turn(["0.12", "0", "0", "0"], "[0, 180]", ["shoulder", "a: length of the upper arm"]),
        turn(["0.12", "0", "0", "0"], "[-150, 150]", ["elbow", "a: length of the forearm"]),
        turn(["0", "0", "0", "0"], "[-100, 100]", ["wrist; the hand is in the tool", ""]),
    ],
    tool: "[0.07, 0, 0]",
    tool_comment: "from the wrist to the tip",
    inverse: "\
# The inverse is asked for a point and the hand's angle to the horizon, the sum of joints 2, 3 and 4.
# For a point alone, with joint 4 held: `inverse: {task: position, redundant: q4}`.
inverse: {task: position_angle, require: true}
",
};

const FIVE: Template = Template {
    about: "Five joints: the base turns, shoulder, elbow and wrist lift in one plane, the hand rolls.",
    rows: &[
        turn(["0", "90", "0.3", "0"], "[-170, 170]", ["base; d: height of the shoulder", ""]),
        turn(["0.25", "0", "0", "0"], "[-30, 190]", ["shoulder", "a: length of the upper arm"]),
        turn(["0.2", "0", "0", "0"], "[-150, 150]", ["elbow", "a: length of the forearm"]),
        turn(["0", "90", "0", "90"], "[-120, 120]", ["wrist; theta: the hand is straight at 0", ""]),
        turn(["0", "0", "0.1", "0"], "", ["roll; d: from the wrist to the flange", ""]),
    ],
    tool: "[0, 0, 0.05]",
    tool_comment: "from the flange to the tip",
    inverse: "\
# The inverse is asked for a pose. Five joints reach only poses whose hand points along the plane of the arm.
inverse: {task: pose, require: true}
",
};

const SIX: Template = Template {
    about: "Six joints: shoulder and elbow, and a wrist whose three axes meet. Every pose within reach, in 8 ways at most.",
    rows: &[
        turn(["0", "90", "0.4", "0"], "[-170, 170]", ["base; d: height of the shoulder", ""]),
        turn(["0.5", "0", "0", "0"], "[-60, 200]", ["shoulder", "a: length of the upper arm"]),
        turn(["0", "90", "0", "90"], "[-150, 150]", ["elbow; theta: the forearm is straight at 0", ""]),
        turn(["0", "-90", "0.5", "0"], "", ["roll of the forearm; d: its length", ""]),
        turn(["0", "90", "0", "0"], "[-120, 120]", ["bend of the wrist", ""]),
        turn(["0", "0", "0.1", "0"], "", ["roll of the flange; d: from the wrist to it", ""]),
    ],
    tool: "[0, 0, 0.15]",
    tool_comment: "from the flange to the tip",
    inverse: "\
# The inverse is asked for a pose: where the tool is, and how it is turned.
inverse: {task: pose, require: true}
",
};

const SEVEN: Template = Template {
    about: "Seven joints: shoulder and wrist of three axes that meet, and an elbow. One joint is left to choose.",
    rows: &[
        turn(["0", "-90", "0.34", "0"], "[-170, 170]", ["base; d: height of the shoulder", ""]),
        turn(["0", "90", "0", "0"], "[-120, 120]", ["bend of the shoulder", ""]),
        turn(["0", "90", "0.4", "0"], "[-170, 170]", ["roll of the upper arm; d: its length", ""]),
        turn(["0", "-90", "0", "0"], "[-120, 120]", ["elbow", ""]),
        turn(["0", "-90", "0.4", "0"], "[-170, 170]", ["roll of the forearm; d: its length", ""]),
        turn(["0", "90", "0", "0"], "[-120, 120]", ["bend of the wrist", ""]),
        turn(["0", "0", "0.126", "0"], "[-175, 175]", ["roll of the flange; d: from the wrist to it", ""]),
    ],
    tool: "[0, 0, 0.15]",
    tool_comment: "from the flange to the tip",
    inverse: "\
# The inverse is asked for a pose and a value of joint 3. To say instead how far the elbow is swung about the line
# from shoulder to wrist: `inverse: {task: pose, redundant: arm_angle}`.
inverse: {task: pose, redundant: q3, require: true}
",
};

/// A SCARA.
pub const SCARA: Template = Template {
    about: "SCARA: two links that turn in a horizontal plane, a quill that slides down and turns.",
    rows: &[
        turn(
            ["0.325", "0", "0.4", "0"],
            "[-130, 130]",
            ["shoulder; d: height of the links", "a: length of the first link"],
        ),
        turn(["0.275", "180", "0", "0"], "[-145, 145]", ["elbow", "a: length of the second link; alpha turns z down"]),
        slide(["0", "0", "0", "0"], "[0, 0.2]", ["quill, slides down; its value is added to d", ""]),
        turn(["0", "0", "0", "0"], "", ["quill, turns", ""]),
    ],
    tool: "[0, 0, 0.05]",
    tool_comment: "from the quill to the tip; z points down",
    inverse: "\
# The inverse is asked for a pose. The tool points down in all poses that a SCARA reaches.
inverse: {task: pose, require: true}
",
};

impl Template {
    /// The text of the arm file.
    pub fn text(&self, name: &str, convention: Convention) -> String {
        let (word, frame) = match convention {
            Convention::Standard => {
                ("standard", "row i is Rz(theta) Tz(d) Tx(a) Rx(alpha), from joint i's axis to the next one's")
            }
            Convention::Modified => (
                "modified",
                "Craig: row i is Rx(alpha) Tx(a) Rz(theta) Tz(d), a and alpha from the axis before to joint i's",
            ),
        };
        let Self { about, tool, tool_comment, inverse, .. } = self;
        let rows = self.rows(convention);
        format!(
            "\
# {name}. Write here where the numbers come from: drawing, data sheet, page.
# {about}
name: {name}
# {word}: {frame}.
convention: {word}
units: {{length: m, angle: deg}}   # m, cm, mm or in; deg or rad

# One row a joint, from the base to the tool. The joint's value is added to theta, or to d of a sliding joint.
# Angles are exact where people mean exact: 90, pi/2, 45 deg. Limits are optional, null is none on that side.
# Also for a row: `type: prismatic` (slides) or `type: fixed` (a constant row), `name: shoulder`.
joints:
{rows}
# Constant frames before the first row and after the last one; rotation Rz(yaw) Ry(pitch) Rx(roll).
# base: {{xyz: [0, 0, 0], rpy: [0, 0, 0]}}
tool: {{xyz: {tool}, rpy: [0, 0, 0]}}   # {tool_comment}

{inverse}"
        )
    }

    /// The lines of the table, in columns.
    fn rows(&self, convention: Convention) -> String {
        let links = self.rows.iter().map(|row| [row.a, row.alpha, row.link]);
        let before = [["0", "0", ""]].into_iter().chain(links.clone());
        let links: Vec<[&str; 3]> = if convention == Convention::Standard { links.collect() } else { before.collect() };
        let cells = self.rows.iter().zip(links).map(|(row, [a, alpha, link])| {
            let kind = if row.slides { ", type: prismatic" } else { "" };
            let limits = if row.limits.is_empty() { String::new() } else { format!(", limits: {}", row.limits) };
            let rest = format!("theta: {}{kind}{limits}}}", row.theta);
            let comment = format!("# {}{}{link}", row.joint, if link.is_empty() { "" } else { "; " });
            vec![format!("  - {{a: {a},"), format!("alpha: {alpha},"), format!("d: {},", row.d), rest, comment]
        });
        aligned(&cells.collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use denhart_dynamic::DynamicArm;

    /// No warning, the inverse of its task, and in both conventions the same arm.
    #[test]
    fn each_template_is_an_arm_with_an_inverse_in_both_conventions() {
        let of = |joints| of_joints(joints).unwrap();
        for (template, task, most) in [
            (of(3), "position", 4),
            (of(4), "position_angle", 4),
            (of(5), "pose", 4),
            (of(6), "pose", 8),
            (of(7), "pose, q3 given", 8),
            (&SCARA, "pose", 2),
        ] {
            let [standard, modified] = [Convention::Standard, Convention::Modified].map(|convention| {
                let text = template.text("first", convention);
                let report = denhart_codegen::check(&text, "first.yaml").unwrap();
                assert!(report.warnings.is_empty(), "{text}\n{:?}", report.warnings);
                assert_eq!(
                    (report.task.as_deref(), report.max_solutions),
                    (Some(task), Some(most)),
                    "{text}\n{report}"
                );
                DynamicArm::from_yaml(&text).unwrap()
            });
            let q = &[0.3, 0.8, 0.1, 0.5, 0.9, -0.4, 0.7][..standard.joints()];
            let [a, b] = [&standard, &modified].map(|arm| arm.forward(q).unwrap());
            let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart(a.rotation.as_flattened(), b.rotation.as_flattened()) < 1e-15, "{a} {b}");
            assert!(apart(&a.translation, &b.translation) < 1e-15, "{a} {b}");
            for arm in [&standard, &modified] {
                let found = arm.inverse_near(&arm.target_at(q).unwrap(), q).unwrap();
                assert!(found.iter().any(|solution| apart(&solution.q, q) < 1e-9 && solution.is_within_limits()));
            }
        }
        assert!(of_joints(2).is_none() && of_joints(8).is_none());
    }

    #[test]
    fn each_request_in_a_comment_works() {
        let mut requests = 0;
        for template in (3..=7).filter_map(of_joints).chain([&SCARA]) {
            let text = template.text("first", Convention::Standard);
            let asked = text.lines().position(|line| line.starts_with("inverse:")).unwrap();
            for other in text.split('`').filter(|part| part.starts_with("inverse:")) {
                let lines = text.lines().enumerate().map(|(index, line)| if index == asked { other } else { line });
                let report = denhart_codegen::check(&lines.collect::<Vec<_>>().join("\n"), "first.yaml").unwrap();
                assert!(report.task.is_some() && report.warnings.is_empty(), "{other}: {report}");
                requests += 1;
            }
        }
        assert_eq!(requests, 2);
    }

    #[test]
    fn the_last_standard_row_has_nothing_behind_it() {
        let all = (3..=7).filter_map(of_joints).chain([&SCARA]);
        for row in all.filter_map(|template| template.rows.last()) {
            assert_eq!((row.a, row.alpha), ("0", "0"));
        }
    }
}
