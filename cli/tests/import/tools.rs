//! Which chain `denhart import` takes where a robot has grippers, hands, several arms, or nothing that moves.

use crate::made_up::imported;
use crate::{model, refused, text, urdf, written};

/// A URDF of joints: name, type, parent and child, and what else stands in the joint.
fn tree(joints: &[(String, &str, String, String, &str)]) -> String {
    let mut links: Vec<&String> = joints.iter().flat_map(|(_, _, parent, child, _)| [parent, child]).collect();
    links.sort();
    links.dedup();
    let links: String = links.iter().map(|link| format!("<link name=\"{link}\"/>\n")).collect();
    let text = |(index, (name, kind, parent, child, more)): (usize, &(String, &str, String, String, &str))| {
        let axis = ["0 0 1", "0 1 0", "1 0 0"][index % 3];
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"{axis}\"/>\
             <origin xyz=\"0.1 0 0.2\"/><limit lower=\"-1\" upper=\"1\"/>{more}</joint>\n"
        )
    };
    format!("<robot name=\"r\">\n{links}{}</robot>", joints.iter().enumerate().map(text).collect::<String>())
}

/// Joints in a row from a link on: `name_1` to `name_n`, with links of the same names and `_link`.
fn row(from: &str, name: &str, count: usize) -> Vec<(String, &'static str, String, String, &'static str)> {
    let link = |index: usize| if index == 0 { from.to_owned() } else { format!("{name}_{index}_link") };
    let joint = |index| (format!("{name}_{index}"), "revolute", link(index - 1), link(index), "");
    (1..=count).map(joint).collect()
}

fn one(
    name: &str,
    kind: &'static str,
    parent: &str,
    child: &str,
) -> (String, &'static str, String, String, &'static str) {
    (name.to_owned(), kind, parent.to_owned(), child.to_owned(), "")
}

#[test]
fn a_gripper_is_no_joint_of_the_arm() {
    let stator = one("gripperStator", "fixed", "joint_6_link", "gripperStator");
    let arm = [row("link00", "joint", 6), vec![stator]].concat();
    let z1 = tree(&[arm.clone(), vec![one("jointGripper", "revolute", "gripperStator", "gripperMover")]].concat());
    let (file, said) = imported(&z1, &[]);
    assert_eq!(model(&file).joints.len(), 6);
    assert!(said.contains("chain: `link00` to `gripperStator`"), "{said}");
    let remark = "the chain ends before joint `jointGripper`, which moves a gripper or a hand\nhelp: --tool gripperMover takes it in";
    assert!(said.contains(remark), "{said}");
    let (json, _) = imported(&z1, &["--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json["remarks"].as_array().unwrap().iter().any(|told| told == remark), "{json}");
    let (file, said) = imported(&z1, &["--tool", "gripperMover"]);
    assert!(model(&file).joints.len() == 7 && !said.contains("ends before"), "{said}");
    // A frame with a usual name on the same body is preferred to the last link.
    let frame = one("tcp_fixed", "fixed", "gripperStator", "z1_tcp");
    let (_, said) =
        imported(&tree(&[arm, vec![frame, one("gripper", "revolute", "gripperStator", "claw")]].concat()), &[]);
    assert!(said.contains("chain: `link00` to `z1_tcp`"), "{said}");
}

#[test]
fn a_gripper_has_fewer_joints_than_the_arm_before_it() {
    let base = one("gripper_base_joint", "revolute", "joint_2_link", "turret");
    let robot = tree(&[row("base", "joint", 2), vec![base], row("turret", "upper", 3)].concat());
    let (file, said) = imported(&robot, &[]);
    assert!(model(&file).joints.len() == 6 && !said.contains("ends before"), "{said}");
}

#[test]
fn a_joint_that_only_sounds_like_a_gripper_is_kept() {
    for (name, child) in
        [("gripper_roll", "gripper_link"), ("link5_to_gripper", "gripper"), ("wrist_rotate", "gripper_link")]
    {
        let robot = tree(&[row("base", "joint", 5), vec![one(name, "revolute", "joint_5_link", child)]].concat());
        let (file, said) = imported(&robot, &[]);
        assert!(model(&file).joints.len() == 6 && !said.contains("ends before"), "{said}");
    }
    // A rod beside the arm that is drawn by a mimic joint: joint 2 is no gripper.
    let rod = ("rod".to_owned(), "revolute", "joint_1_link".to_owned(), "rod".to_owned(), "<mimic joint=\"joint_2\"/>");
    let (file, _) = imported(&tree(&[row("base", "joint", 4), vec![rod]].concat()), &[]);
    assert_eq!(model(&file).joints.len(), 4);
}

#[test]
fn a_hand_without_a_name_is_no_part_of_the_arm() {
    // The middle finger has the most joints: the longest chain is plain, and ends in a finger.
    let hand: Vec<_> = [("thumb", 3), ("index", 3), ("middle", 4), ("little", 3)]
        .map(|(name, count)| row("arm_7_link", name.split_at(3).0, count))
        .concat();
    let (file, said) = imported(&tree(&[row("base", "arm", 7), hand].concat()), &[]);
    assert_eq!(model(&file).joints.len(), 7);
    assert!(said.contains("to `arm_7_link`") && said.contains("--tool mid_4_link takes it in"), "{said}");
}

#[test]
fn several_arms_are_proposed_with_base_and_tool() {
    let side = |side: &str, from: &str| {
        let palm = format!("{side}_palm");
        let mut arm = row(from, &format!("{side}_arm"), 7);
        arm.push(one(&format!("{side}_palm_joint"), "fixed", &format!("{side}_arm_7_link"), &palm));
        for finger in ["a", "b"] {
            arm.extend(row(&palm, &format!("{side}_{finger}_finger"), 2));
        }
        arm
    };
    let torso = |count: usize| row("base", "torso", count);
    // One torso joint, two arms with grippers of two fingers, a head, a wheel.
    let pr2 = [
        torso(1),
        side("l", "torso_1_link"),
        side("r", "torso_1_link"),
        row("torso_1_link", "head", 2),
        row("base", "wheel", 1),
    ];
    let said = refused(&tree(&pr2.concat()), &[]);
    let proposed = |arm: &str| format!("--base torso_1_link --tool {arm}_palm (7 moving joints; without --base 8)");
    assert!(said.contains("several chains have 10 moving joints\nhelp: name one arm: "), "{said}");
    assert!(said.contains(&format!("name one arm: {}, or {}\n", proposed("l"), proposed("r"))), "{said}");
    assert!(!said.contains("finger"), "{said}");
    let (file, _) = imported(&tree(&pr2.concat()), &["--base", "torso_1_link", "--tool", "l_palm"]);
    assert_eq!(model(&file).joints.len(), 7);
    // Arms from the root on.
    let said = refused(&tree(&[side("l", "base"), side("r", "base")].concat()), &[]);
    assert!(
        said.contains("name one arm: --tool l_palm (7 moving joints), or --tool r_palm (7 moving joints)"),
        "{said}"
    );
    // A torso of three joints, arms without fingers, legs.
    let icub = [torso(3), row("torso_3_link", "l", 7), row("torso_3_link", "r", 7), row("base", "leg", 6)].concat();
    let said = refused(&tree(&icub), &[]);
    assert!(said.contains("--base torso_3_link --tool l_7_link (7 moving joints; without --base 10), or "), "{said}");
    // Arms of which one is as long as the other with its gripper left out.
    let gripper = one("gripper", "revolute", "l_7_link", "claw");
    let said = refused(&tree(&[icub, vec![gripper]].concat()), &[]);
    assert!(said.contains("several chains have 10 moving joints before a gripper\nhelp: name one arm: "), "{said}");
    for tool in ["l_7_link", "r_7_link"] {
        assert!(said.contains(&format!("--base torso_3_link --tool {tool} (7 moving joints; ")), "{said}");
    }
}

#[test]
fn fingers_of_one_hand_end_the_chain_before_they_part() {
    // Two sliders that no name and no mimic joint tells.
    let hand =
        [one("left", "prismatic", "arm_7_link", "left_pad"), one("right", "prismatic", "arm_7_link", "right_pad")];
    let said = refused(&tree(&[row("base", "arm", 7), hand.to_vec()].concat()), &[]);
    assert!(
        said.contains("help: --tool arm_7_link (the last link before they part); the ends are left_pad, right_pad"),
        "{said}"
    );
}

#[test]
fn a_urdf_that_does_not_move_is_told_so() {
    let said = refused("<robot name=\"r\"/>", &[]);
    assert!(said.contains("`<robot>` is empty: it has no link and no joint\nhelp: a URDF has `<link>`"), "{said}");
    let said = refused("<robot name=\"r\"><link name=\"a\"/></robot>", &[]);
    assert!(said.contains("this URDF has no joints\nhelp: joints of an arm have the type revolute"), "{said}");
    let fixed = ["b", "c"].map(|child| one(child, "fixed", "a", child));
    let said = refused(&tree(&fixed), &[]);
    assert!(said.contains("no joint of this URDF moves: all are fixed\nhelp: joints of an arm have"), "{said}");
    let said = refused(&tree(&fixed), &["--tool", "b"]);
    assert!(said.contains("no joint moves between `a` and `b`\nhelp: joints of an arm have"), "{said}");
    // Ends between which nothing moves, in a robot that moves.
    let robot = tree(&[row("base", "arm", 3), vec![one("camera", "fixed", "base", "camera")]].concat());
    let said = refused(&robot, &["--tool", "camera"]);
    assert!(said.contains("help: --tool arm_3_link is the end of the chain with the most moving joints"), "{said}");
    let said = refused(&tree(&row("base", "arm", 3)), &["--base", "arm_3_link"]);
    assert!(said.contains("no joint moves beyond `arm_3_link`\nhelp: --tool base takes the chain"), "{said}");
}

#[test]
fn a_urdf_with_undeclared_prefixes_is_the_same_arm() {
    let plain = std::fs::read_to_string(urdf("ur5")).unwrap();
    let prefixed = plain
        .replacen("<link ", "<drake:declare_convex/>\n  <link drake:color=\"a:b\" ", 1)
        .replace("</joint>", "<drake:joint_limits drake:acceleration=\"9\"/></joint>");
    let (one, other) = (written(&plain, &[]), written(&prefixed, &[]));
    let table = |output: &std::process::Output| text(&output.stdout).split_once("name:").unwrap().1.to_owned();
    assert!(other.status.success(), "{}", text(&other.stderr));
    assert_eq!(table(&one), table(&other));
}
