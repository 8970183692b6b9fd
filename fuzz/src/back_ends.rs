//! An arm to both back ends: tokens that are a Rust file, and a program that is evaluated. They agree on what there is.

use std::fmt::Write;

use denhart_codegen::{Bound, Options, generate, takes_a_choice};
use denhart_dynamic::DynamicArm;

use crate::bytes::Bytes;

/// Bytes as a table, most often one that is an arm.
pub fn run(data: &[u8]) {
    let text = text(&mut Bytes::new(data));
    if takes_a_choice(&text, "fuzz.yaml", &Bound::None) {
        return;
    }
    let generated = generate(&text, "fuzz.yaml", &Options::new("Fuzzed"));
    let evaluated = DynamicArm::from_yaml(&text);
    match (generated, evaluated) {
        (Ok(generated), Ok(arm)) => {
            let code = generated.to_file().unwrap_or_else(|errors| panic!("{errors}\n{text}"));
            assert!(code.contains("struct Fuzzed"), "{text}");
            let has_inverse = generated.report.unsupported.is_none();
            let evaluates = arm.task().map(|_| ()).map_err(|error| error.to_string());
            assert_eq!(has_inverse, evaluates.is_ok(), "{evaluates:?}\n{text}");
            let q = vec![0.5; arm.joints()];
            let pose = arm.forward(&q).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert!(
                pose.rotation.as_flattened().iter().chain(&pose.translation).all(|x| x.is_finite()),
                "{pose:?}\n{text}"
            );
            if has_inverse {
                let target = arm.target_at(&q).unwrap_or_else(|error| panic!("{error}\n{text}"));
                let near = arm.inverse_near(&target, &q).unwrap_or_else(|error| panic!("{error}\n{text}"));
                assert!(near.iter().all(|s| s.q.iter().all(|x| x.is_finite())), "{near:?}\n{text}");
            }
        }
        (Err(_), Err(_)) => {}
        (generated, evaluated) => {
            panic!("one back end refuses: {:?}, {:?}\n{text}", generated.err(), evaluated.err());
        }
    }
}

/// The arm file that bytes stand for.
pub fn text(bytes: &mut Bytes) -> String {
    let convention = ["standard", "modified"][bytes.below(2)];
    let unit = ["m", "mm", "cm", "in"][bytes.below(4)];
    let mut text = format!("name: fuzzed\nconvention: {convention}\nunits: {{length: {unit}, angle: deg}}\n");
    // Writing to a string cannot fail.
    if let Some(inverse) = inverse(bytes) {
        let _ = writeln!(text, "inverse: {{{inverse}}}");
    }
    for frame in ["base", "tool"] {
        if bytes.below(4) == 1 {
            let xyz: [f64; 3] = std::array::from_fn(|_| length(bytes));
            let rpy: [f64; 3] = std::array::from_fn(|_| angle(bytes));
            let _ = writeln!(text, "{frame}: {{xyz: {xyz:?}, rpy: {rpy:?}}}");
        }
    }
    text.push_str("joints:\n");
    for _ in 0..1 + bytes.below(11) {
        let kind = ["", "", "", "type: prismatic, ", "type: fixed, "][bytes.below(5)];
        let (a, alpha) = (length(bytes), angle(bytes));
        let (d, theta) = (length(bytes), angle(bytes));
        let limits = match bytes.below(4) {
            1 if kind != "type: fixed, " => {
                let (low, high) = (100.0 * bytes.fraction(), 100.0 * bytes.fraction());
                format!(", limits: [{:?}, {:?}]", low.min(high), low.max(high))
            }
            _ => String::new(),
        };
        let _ = writeln!(text, "  - {{{kind}a: {a:?}, alpha: {alpha:?}, d: {d:?}, theta: {theta:?}{limits}}}");
        if bytes.is_empty() {
            break;
        }
    }
    text
}

fn inverse(bytes: &mut Bytes) -> Option<String> {
    let task = match bytes.below(10) {
        0..=3 => None,
        4 => Some("task: pose"),
        5 => Some("task: position"),
        6 => Some("task: position_axis"),
        7 => Some("task: position_angle"),
        8 => Some("task: planar_pose"),
        _ => Some("task: planar_position"),
    };
    let given = match bytes.below(14) {
        joint @ 1..=10 => Some(format!("redundant: q{joint}")),
        11 => Some("redundant: arm_angle".to_owned()),
        12 | 13 => {
            let name = |number: usize| if number > 10 { "arm_angle".to_owned() } else { format!("q{number}") };
            let names: Vec<String> = (0..=bytes.below(4)).map(|_| name(1 + bytes.below(11))).collect();
            Some(format!("redundant: [{}]", names.join(", ")))
        }
        _ => None,
    };
    let parts: Vec<String> = task.map(str::to_owned).into_iter().chain(given).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// Often zero or simple, at times very large or small.
fn length(bytes: &mut Bytes) -> f64 {
    match bytes.below(8) {
        0..=2 => 0.0,
        3 => [0.1, 0.25, -0.1, 1.0][bytes.below(4)],
        4 | 5 => bytes.fraction(),
        6 => 1000.0 * bytes.fraction(),
        _ => bytes.fraction() * 10.0_f64.powi(bytes.below(140) as i32 - 70),
    }
}

/// Often a multiple of 90 degrees.
fn angle(bytes: &mut Bytes) -> f64 {
    match bytes.below(8) {
        0..=4 => 90.0 * (bytes.below(4) as f64 - 1.0),
        5 => 15.0 * (bytes.below(48) as f64 - 24.0),
        6 => 180.0 * bytes.fraction(),
        _ => 90.0 + bytes.fraction() * 10.0_f64.powi(-(bytes.below(16) as i32)),
    }
}
