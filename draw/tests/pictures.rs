//! Pictures of all arms: readable, the same at each run, and of any arm that a file may hold.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use denhart_draw::{DrawError, Picture, Scene, Shape, Style, Text, Theme, View, apart, section};
use denhart_dynamic::DynamicArm;

const VIEWS: [View; 4] = [View::Front, View::Side, View::Top, View::Iso];

fn arms() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let mut files: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(files.len() > 50);
    files
}

/// An arm of rows in the standard convention.
fn arm(rows: &str) -> DynamicArm {
    let text = format!("name: a\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n{rows}");
    DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{error}"))
}

/// No text lies on another one, and none reaches out of the picture.
fn readable(picture: &Picture, of: &str) {
    let text = |shape: &Shape| if let Shape::Text(text) = shape { Some(text.clone()) } else { None };
    let texts: Vec<Text> = picture.shapes.iter().filter_map(text).collect();
    assert!(!texts.is_empty(), "{of}");
    let [width, height] = picture.size;
    for (index, a) in texts.iter().enumerate() {
        let ([x, y], size) = (a.at, a.size);
        let inside = x >= 0.0 && x + a.width <= width && y - 0.8 * size >= 0.0 && y <= height;
        assert!(inside, "{of}: `{}` is cut off at {x:.0}, {y:.0}", a.text);
        for b in texts.iter().skip(index + 1) {
            let apart = x + a.width <= b.at[0] || b.at[0] + b.width <= x;
            let above = |a: &Text, b: &Text| a.at[1] + 0.2 * a.size <= b.at[1] - 0.7 * b.size;
            assert!(apart || above(a, b) || above(b, a), "{of}: `{}` lies on `{}`", a.text, b.text);
        }
    }
}

#[test]
fn no_text_lies_on_another_one() {
    for path in arms() {
        let arm = DynamicArm::from_file(&path).unwrap();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        for q in [vec![0.0; arm.joints()], apart(&arm, View::of(&arm))] {
            let scene = Scene::of(&arm, &q).unwrap();
            for (kind, scene) in [
                ("plain", scene.clone()),
                ("frames", scene.clone().with_frames()),
                ("dimensions", scene.clone().with_dimensions()),
                ("axes", scene.clone().with_axes(&arm)),
                ("both", scene.clone().with_frames().with_dimensions().with_axes(&arm)),
            ] {
                for view in VIEWS {
                    let of = format!("{name}, {}, {kind}", view.name());
                    readable(&scene.picture(&Style::of(view)), &of);
                    readable(&scene.picture(&Style::of(view).with_size(300.0, 230.0)), &format!("{of}, small"));
                }
            }
        }
    }
}

#[test]
fn every_solution_is_in_the_legend() {
    for path in arms() {
        let arm = DynamicArm::from_file(&path).unwrap();
        if arm.task().is_err() {
            continue;
        }
        let view = View::of(&arm);
        let q = apart(&arm, view);
        let solutions = arm.inverse(&arm.target_at(&q).unwrap(), &arm.held(&q).unwrap()).unwrap();
        let scene = Scene::of_solutions(&arm, arm.forward(&q).unwrap(), &solutions).unwrap();
        let picture = scene.picture(&Style::of(view));
        let of = path.display().to_string();
        readable(&picture, &of);
        let written = |start: &str| {
            picture.shapes.iter().any(|shape| matches!(shape, Shape::Text(text) if text.text.starts_with(start)))
        };
        for (number, solution) in (1..).zip(solutions.iter()) {
            let branch = solution.branch.to_string();
            let words = if branch == "-" { number.to_string() } else { format!("{number} {branch}") };
            assert!(written(&words), "{of}: {words}");
        }
        assert_eq!(
            scene.svg(&Style::of(view)).contains("out of limits"),
            solutions.within_limits().count() < solutions.len()
        );
    }
}

#[test]
fn a_dimension_has_the_number_of_the_table() {
    let arm = DynamicArm::from_yaml(include_str!("../../specs/denso_vs6556.yaml")).unwrap();
    let svg = Scene::of(&arm, &[0.0; 6]).unwrap().with_dimensions().svg(&Style::of(View::Side));
    for text in ["d1 335 mm", "a1 75 mm", "a2 270 mm", "a3 90 mm", "d4 \u{2212}295 mm", "d6 \u{2212}80 mm"] {
        assert!(svg.contains(text), "{text}");
    }
}

/// A wrong sign in a table is seen: axes turn over, and links lead elsewhere.
#[test]
fn a_wrong_sign_changes_the_picture() {
    let text = include_str!("../../specs/denso_vs6556.yaml");
    let style = Style::of(View::Side);
    let of = |text: &str| {
        let arm = DynamicArm::from_yaml(text).unwrap();
        Scene::of(&arm, &[0.0; 6]).unwrap().picture(&style).shapes
    };
    let right = of(text);
    for (sign, other) in
        [("alpha: -90, d: 335", "alpha: 90, d: 335"), ("d: -295", "d: 295"), ("theta: -90", "theta: 90")]
    {
        assert!(text.contains(sign));
        let wrong = of(&text.replacen(sign, other, 1));
        let changed = wrong.iter().filter(|shape| !right.contains(shape)).count();
        assert!(changed > 5, "{sign}: {changed} shapes");
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let arm = DynamicArm::from_yaml(include_str!("../../specs/ur5.yaml")).unwrap();
    let q = [0.3, -1.0, 1.2, 0.4, 1.1, 0.2];
    let draw = || {
        let section = section(&arm, &q, View::Side).unwrap();
        Scene::of(&arm, &q).unwrap().with_frames().with_dimensions().with_section(section)
    };
    let style = Style::of(View::Side).with_theme(Theme::Dark);
    assert_eq!(draw().svg(&style), draw().svg(&style));
    #[cfg(feature = "png")]
    assert_eq!(draw().png(&style, 600).unwrap(), draw().png(&style, 600).unwrap());
}

#[test]
fn lengths_of_any_size_are_drawn() {
    let ten = "  - {a: 0.2, alpha: 90, d: 0.1, theta: 0}\n".repeat(10);
    for (rows, note) in [
        ("  - {a: 0, alpha: 90, d: 0, theta: 0}\n  - {a: 0, alpha: 0, d: 0, theta: 0}\n", ""),
        ("  - {a: 1000, alpha: 0, d: 0, theta: 0}\n  - {a: 0.001, alpha: 0, d: 0, theta: 0}\n", "a2 0.001 m"),
        ("  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0}\n", ""),
        (ten.as_str(), ""),
    ] {
        let arm = arm(rows);
        let q = vec![0.0; arm.joints()];
        for view in VIEWS {
            let scene = Scene::of(&arm, &q).unwrap().with_frames().with_dimensions();
            let scene = scene.with_section(section(&arm, &q, view).unwrap());
            readable(&scene.picture(&Style::of(view)), rows);
            let svg = scene.svg(&Style::of(view));
            assert!(svg.contains(note) && !svg.contains("NaN") && !svg.contains("inf"), "{rows}");
        }
    }
}

/// A measured table: two axes are nearly parallel, and their common normal is far away.
#[test]
fn a_calibrated_arm_looks_like_its_nominal_one() {
    let rows = |alpha: &str, d: &str, back: &str| {
        format!(
            "  - {{a: 0, alpha: 90, d: 0.4, theta: 0}}\n  - {{a: 0.3, alpha: {alpha}, d: {d}, theta: 10}}\n  - {{a: 0.3, alpha: \
             90, d: {back}, theta: 20}}\n  - {{a: 0, alpha: 0, d: 0.1, theta: 0}}\n"
        )
    };
    let [nominal, calibrated] = [rows("0", "0", "0"), rows("0.01", "100", "-100")].map(|rows| arm(&rows));
    let q = [0.3, 0.4, 0.2, 0.4];
    let [a, b] = [nominal, calibrated].map(|arm| Scene::of(&arm, &q).unwrap().with_dimensions().with_frames());
    readable(&b.picture(&Style::of(View::Iso)), "calibrated");
    assert!(b.figures[0].skeleton.size() < 1.2 * a.figures[0].skeleton.size());
    assert!(b.svg(&Style::of(View::Iso)).contains("far outside the picture: frame 2, d2, a2, d3"));
}

#[test]
fn joint_values_that_are_none_are_told() {
    let arm = arm("  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n");
    assert!(matches!(Scene::of(&arm, &[f64::NAN]), Err(DrawError::NotFinite { joint: 1, .. })));
    assert!(matches!(Scene::of(&arm, &[0.0, 1.0]), Err(DrawError::Arm(_))));
    let names = "name: <a>&\"b\"\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n  - {name: q1, a: 1, alpha: 0, d: 0, theta: 0}\n";
    if let Ok(arm) = DynamicArm::from_yaml(names) {
        let svg = Scene::of(&arm, &[0.0]).unwrap().svg(&Style::of(View::Top));
        assert!(svg.contains("&lt;a&gt;&amp;"), "{svg}");
    }
}
