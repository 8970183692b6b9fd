//! Hints, limits, the closest approach and the sweep.

use crate::shell::{close, denhart, file, json, said, shown};

#[test]
fn radians_among_degrees_have_a_hint_and_small_degrees_none() {
    let ur5 = "specs/ur5.yaml";
    let text = shown(&["inverse", ur5, "--pose", "-0.4 -0.2 0.4 1.5708 0 0"]);
    assert!(text.contains("hint: --pose: 1.5708 looks like radians and is read as degrees; write 90, or"), "{text}");
    let answer = json(&["inverse", ur5, "--pose", "-0.4 -0.2 0.4 1.5708 0 0", "--json"]);
    assert_eq!(answer["hints"].as_array().unwrap().len(), 1);
    let text = shown(&["inverse", ur5, "--pose", "-0.4 -0.2 0.4 90 0 0", "--near", "0 -1.5708 1.5708 0 0.5236 0"]);
    assert!(text.contains("hint: --near: -1.5708 looks like radians"), "{text}");
    let text = shown(&["inverse", ur5, "--q", "0 -1.57 1.57 0 0.5 0"]);
    assert!(text.contains("hint: --q: -1.57 looks like radians"), "{text}");
    let given = ["inverse", "specs/kuka_iiwa7_r800.yaml", "--pose", "400 100 500 180 0 0", "--given", "0.7854"];
    assert!(shown(&given).contains("hint: --given: 0.7854 looks like radians"));
    let text = shown(&["forward", ur5, "--q", "0 -1.5708 1.5708 0 0 0"]);
    assert!(text.contains("hint: --q: -1.5708 looks like radians"), "{text}");
    let forward = json(&["forward", ur5, "--q", "0 -1.5708 1.5708 0 0 0", "--json"]);
    assert_eq!(forward["hints"].as_array().unwrap().len(), 1);
    let text = shown(&["inverse", ur5, "--pose", "-0.4 -0.2 0.4 90 0 0", "--units", "rad"]);
    assert!(text.contains("hint: --pose: 90 looks like degrees"), "{text}");
    for pose in ["-0.4 -0.2 0.4 1 0.5 0", "-0.4 -0.2 0.4 90 1.5708 0", "-0.4 -0.2 0.4 3 0.3 2.5"] {
        assert!(!shown(&["inverse", ur5, "--pose", pose]).contains("hint:"), "{pose}");
    }
    // A slide of 1.5708 mm is a length.
    let slide = ["forward", "specs/scara_rrrp_325_275.yaml", "--q", "0 0 0 -1.5708"];
    assert!(!shown(&slide).contains("hint:"));
}

#[test]
fn solutions_outside_the_limits_are_left_out_on_request() {
    let asked = ["inverse", "specs/puma560.yaml", "--q", "10 20 30 40 50 60"];
    let all = shown(&asked);
    assert!(all.ends_with("\n3 of 8 within limits\n"), "{all}");
    let kept = shown(&[&asked[..], &["--within-limits"]].concat());
    assert_eq!(kept.lines().filter(|line| line.contains("EXACT")).count(), 3, "{kept}");
    assert!(!kept.contains("broken") && kept.ends_with("\n3 of 8 within limits\n"), "{kept}");
    let answer = json(&[&asked[..], &["--within-limits", "--json"]].concat());
    assert_eq!((answer["found"].as_u64(), answer["found_within_limits"].as_u64()), (Some(8), Some(3)));
    let solutions = answer["solutions"].as_array().unwrap();
    assert!(solutions.len() == 3 && solutions.iter().all(|solution| solution["within_limits"] == true));
    // A target that is reached outside the limits alone has no solution to list.
    let outside = ["inverse", "specs/scara_rrrp_325_275.yaml", "--q", "0 0 0 -500"];
    assert_eq!(denhart(&outside).status.code(), Some(0));
    let none = denhart(&[&outside[..], &["--within-limits"]].concat());
    assert_eq!(none.status.code(), Some(3), "{none:?}");
    assert!(said(&none.stdout).contains("0 of "), "{none:?}");
}

/// A branch by the words that are printed; parts that are left out match any.
#[test]
fn solutions_of_a_branch_alone() {
    let asked = ["inverse", "specs/ur5.yaml", "--q", "0, -90, 90, 0, 30, 0"];
    let answer = json(&[&asked[..], &["--branch", "elbow up, shoulder left", "--json"]].concat());
    let solutions = answer["solutions"].as_array().unwrap();
    let is_wanted = |branch: &str| branch.starts_with("shoulder left, elbow up, wrist ");
    assert!(solutions.len() == 2 && solutions.iter().all(|one| is_wanted(one["branch"].as_str().unwrap())), "{answer}");
    assert_eq!(answer["found"], 8);
    // Of four solutions none is the sixteenth.
    let none = denhart(&[&["inverse", "specs/gen6r_a.yaml"], &asked[2..], &["--branch", "root 16"]].concat());
    assert_eq!(none.status.code(), Some(3), "{none:?}");
    assert!(said(&none.stdout).contains("none of them on the branch root 16"), "{none:?}");
    // Without numbers each is the first of its name.
    assert_eq!(denhart(&[&asked[..], &["--branch", "root 2"]].concat()).status.code(), Some(3));
    let wrong = denhart(&[&asked[..], &["--branch", "elbow top"]].concat());
    assert!(wrong.status.code() == Some(2) && said(&wrong.stderr).contains("elbow up or down"), "{wrong:?}");
}

#[test]
fn the_closest_approach_has_its_joint_values() {
    let asked = ["inverse", "specs/ur5.yaml", "--pose", "2 0 0 0 0 0"];
    let text = said(&denhart(&asked).stdout);
    assert!(text.contains("\njoint values of the closest approach: "), "{text}");
    assert!(!text.contains("hint:"), "{text}");
    let answer = json(&[&asked[..], &["--json"]].concat());
    let q: Vec<String> = answer["closest"].as_array().unwrap().iter().map(ToString::to_string).collect();
    let there = json(&["forward", "specs/ur5.yaml", "--q", &q.join(" "), "--json"]);
    let place = there["pose"]["position"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap());
    let distance = place.zip([2.0, 0.0, 0.0]).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
    assert!((distance - answer["missed"]["position"].as_f64().unwrap()).abs() < 1e-6, "{answer}");
    // The nearest angle of a tool that pitches.
    let answer = json(&["inverse", "specs/al5d.yaml", "--pose", "0.35 -0.15 0.1 60", "--json"]);
    let q: Vec<String> = answer["closest"].as_array().unwrap().iter().map(ToString::to_string).collect();
    let there = json(&["inverse", "specs/al5d.yaml", "--q", &q.join(" "), "--json"]);
    close(&there["target"]["position"], &[0.35, -0.15, 0.1]);
    let off = (there["target"]["angle"].as_f64().unwrap() - 60.0).abs();
    assert!((off - answer["missed"]["orientation"].as_f64().unwrap()).abs() < 1e-6, "{answer} {there}");
    assert!(json(&["inverse", "specs/ur5.yaml", "--q", "0 -90 90 0 30 0", "--json"])["closest"].is_null());
}

#[test]
fn lengths_in_another_unit_have_a_hint_where_the_point_is_out_of_reach() {
    let text = said(&denhart(&["inverse", "specs/ur5.yaml", "--pose", "-400 -200 400 90 0 0"]).stdout);
    assert!(text.contains("if it is in mm, write -0.4, -0.2, 0.4\n"), "{text}");
    let arm = "specs/scara_rrrp_325_275.yaml";
    let text = said(&denhart(&["inverse", arm, "--pose", "0.4 0.1 -0.05 0 0 0"]).stdout);
    assert!(text.contains("if it is in m, write 400, 100, -50\n"), "{text}");
}

#[test]
fn a_sweep_walks_the_redundant_joint() {
    let iiwa = "specs/kuka_iiwa7_r800.yaml";
    let asked = ["inverse", iiwa, "--pose", "400 100 500 180 0 0", "--sweep", "6"];
    let answer = json(&[&asked[..], &["--json"]].concat());
    let values = answer["values"].as_array().unwrap();
    assert_eq!((values.len(), answer["swept"].as_str()), (6, Some("q3")));
    for (index, value) in (0..).zip(values) {
        let given = value["given"].as_f64().unwrap();
        let expected = 180.0 * ((f64::from(index) + 0.5) / 3.0 - 1.0);
        assert!((given - expected).abs() < 1e-9, "{given}, not {expected}");
        // Each value has the solutions of a call with that value.
        let one = ["inverse", iiwa, "--pose", "400 100 500 180 0 0", "--given", &given.to_string(), "--json"];
        let one = json(&one);
        assert_eq!(value["solutions"].as_array().unwrap().len(), one["solutions"].as_array().unwrap().len());
        assert_eq!(value["found_within_limits"], one["found_within_limits"]);
    }
    let within: Vec<f64> =
        values.iter().filter(|v| v["found_within_limits"] != 0).map(|v| v["given"].as_f64().unwrap()).collect();
    close(&answer["values_within_limits"], &within);
    let text = shown(&asked);
    assert!(text.contains(&format!("\n{} of 6 values with solutions within limits", within.len())), "{text}");
    let rows = text.lines().filter(|line| line.contains("EXACT")).count();
    let found: u64 = values.iter().map(|value| value["found"].as_u64().unwrap()).sum();
    assert_eq!(rows as u64, found, "{text}");
}

#[test]
fn a_sweep_walks_the_arm_angle_too_and_needs_something_to_spare() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/kuka_iiwa7_r800.yaml");
    let text = std::fs::read_to_string(root).unwrap();
    let swung = file("targets_swung.yaml", &text.replace("redundant: q3", "redundant: arm_angle"));
    let answer = json(&["inverse", &swung, "--q", "10 20 30 40 50 60 70", "--sweep", "4", "--json"]);
    assert_eq!(answer["swept"], "the arm angle");
    let given: Vec<f64> = answer["values"].as_array().unwrap().iter().map(|v| v["given"].as_f64().unwrap()).collect();
    assert_eq!(given, [-135.0, -45.0, 45.0, 135.0]);
    let output = denhart(&["inverse", "specs/ur5.yaml", "--q", "0 0 0 0 0 0", "--sweep", "4"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output.stderr).contains("--sweep: this arm's inverse takes no value"), "{output:?}");
    let far = ["inverse", "specs/kuka_iiwa7_r800.yaml", "--pose", "4000 0 0 0 0 0", "--sweep", "3"];
    let far = denhart(&far);
    assert_eq!(far.status.code(), Some(3));
    assert!(said(&far.stdout).contains("\n3 of 3 values without solution"), "{far:?}");
}

/// The wrist is straight, and the free joint at 0 puts joint 6 out of its limits.
#[test]
fn a_free_joint_that_breaks_the_limits_is_told() {
    let puma = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/puma560.yaml")).unwrap();
    let narrow = puma.replace("limits: [-266, 266]", "limits: [-90, 90]");
    assert_ne!(puma, narrow);
    let path = file("narrow.yaml", &narrow);
    let q = "10 -20 30 60 0 60";
    let output = denhart(&["inverse", &path, "--q", q, "--within-limits"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    assert!(
        said(&output.stdout).contains("hint: a free joint stands at its default value here (q4); --near puts it"),
        "{output:?}"
    );
    let near = denhart(&["inverse", &path, "--q", q, "--near", q, "--within-limits"]);
    assert_eq!(near.status.code(), Some(0), "{near:?}");
    assert!(!said(&near.stdout).contains("hint:"), "{near:?}");
}
