//! The `inverse` of imported arms with joints to spare.

use denhart_codegen::check;

use crate::made_up::imported;
use crate::{import, urdf};

#[test]
fn seven_joints_get_an_inverse_that_works_and_the_others_in_a_comment() {
    for (name, arguments, chosen, others) in [
        ("kuka_iiwa7", &[][..], "inverse: {task: pose, redundant: iiwa_joint_3}", 6),
        ("franka_panda", &["--tool", "panda_hand_tcp"], "inverse: {task: pose, redundant: panda_joint7}", 3),
        ("fetch", &["--base", "torso_lift_link"], "inverse: {task: pose, redundant: upperarm_roll_joint}", 5),
    ] {
        let (file, said) = import(name, arguments);
        assert!(file.ends_with(&format!("\n{chosen}\n")), "{file}");
        assert!(
            said.contains(&format!("so one value is given with it: `{chosen}`; the file lists other requests")),
            "{said}"
        );
        let report = check(&file, name).unwrap();
        assert_eq!(report.max_solutions, Some(8), "{report}");
        assert!(report.warnings.is_empty(), "{:?}", report.warnings);
        // Each of the others works in its place.
        let (body, _) = file.split_once("# A pose takes six joints").unwrap();
        let requests: Vec<&str> = file.lines().filter_map(|line| line.strip_prefix("# inverse: ")).collect();
        assert_eq!(requests.len(), others, "{file}");
        for request in requests {
            let report = check(&format!("{body}inverse: {request}\n"), name).unwrap();
            assert!(report.max_solutions.is_some(), "{request}: {report}");
        }
    }
}

#[test]
fn a_chain_without_an_inverse_is_told_with_the_way_to_one() {
    // Its angles of 1.5708 rad miss every triple: a joint is held.
    let (file, said) = import("kinova_gen3", &[]);
    assert!(file.ends_with("\ninverse: {redundant: joint_3}\n"), "{file}");
    assert!(said.contains("one value is given with it: `inverse: {redundant: joint_3}`"), "{said}");
    // Six joints have an inverse without a request.
    let (file, said) = import("ur5", &[]);
    assert!(!file.contains("inverse:") && !said.contains("inverse"), "{said}\n{file}");
}

#[test]
fn eight_joints_get_a_list() {
    let (file, said) = import("fetch", &[]);
    let (_, request) = file.rsplit_once("\ninverse: ").unwrap();
    assert!(request.starts_with("{redundant: [") && request.contains(", "), "{file}");
    assert!(
        said.contains("a pose takes six joints, so two values are given with it: `inverse: {redundant: ["),
        "{said}"
    );
    assert_eq!(check(&file, "fetch").unwrap().max_solutions, Some(8));
}

#[test]
fn a_request_quotes_a_name_that_yaml_would_not_read() {
    let text = std::fs::read_to_string(urdf("kuka_iiwa7")).unwrap();
    let (file, _) = imported(&text.replace("\"iiwa_joint_", "\"arm, joint "), &[]);
    assert!(file.ends_with("\ninverse: {task: pose, redundant: \"arm, joint 3\"}\n"), "{file}");
    assert_eq!(check(&file, "quoted").unwrap().max_solutions, Some(8));
}
