//! Every mixture of joints that turn and joints that slide: an arm has its inverse, or is singular everywhere.
//!
//! A word such as RPRRR is the kinds of an arm's joints. Its links are random. The reference for "singular everywhere" is the
//! rank of the Jacobian at random joint vectors. Each inverse has to give back the joint vectors that targets were made from.
#![allow(clippy::unwrap_used)]

use denhart_dynamic::DynamicArm;
use denhart_tests::random::Random;
use nalgebra::DMatrix;

/// A task with the number of its equations.
struct Task {
    name: &'static str,
    equations: usize,
}

const POSITION: Task = Task { name: "position", equations: 3 };
const POINTING: Task = Task { name: "position_axis", equations: 5 };
const POSE: Task = Task { name: "pose", equations: 6 };

/// Joint vectors that each arm is asked for.
const POSES: usize = 5;

/// The arm file of a word, with the joints whose value is given.
fn file(word: &str, task: &Task, given: &[usize], random: &mut Random) -> String {
    let redundant = match given {
        [] => String::new(),
        [joint] => format!(", redundant: q{}", joint + 1),
        joints => {
            let names: Vec<String> = joints.iter().map(|joint| format!("q{}", joint + 1)).collect();
            format!(", redundant: [{}]", names.join(", "))
        }
    };
    let task = task.name;
    let mut text = format!("name: {}\nconvention: standard\nunits: {{length: m, angle: deg}}\n", word.to_lowercase());
    text += &format!("inverse: {{task: {task}{redundant}}}\njoints:\n");
    for kind in word.chars() {
        let [a, other] = [0, 1].map(|_| random.uniform(-0.4, 0.4));
        let [alpha, angle] = [0, 1].map(|_| random.uniform(-170.0, 170.0));
        text += &match kind {
            'P' => format!("  - {{type: prismatic, a: {a:.3}, alpha: {alpha:.1}, d: 0, theta: {angle:.1}}}\n"),
            _ => format!("  - {{type: revolute, a: {a:.3}, alpha: {alpha:.1}, d: {other:.3}, theta: 0}}\n"),
        };
    }
    text
}

/// The joint vector with uniform angles and strokes.
fn joints(word: &str, random: &mut Random) -> Vec<f64> {
    let value = |kind| if kind == 'P' { random.uniform(-0.6, 0.6) } else { random.uniform(-3.1, 3.1) };
    word.chars().map(value).collect()
}

/// The rank of the motion that the task asks for, over the joints that are not given.
fn rank(arm: &DynamicArm, task: &Task, given: &[usize], q: &[f64]) -> usize {
    let (pose, jacobian) = arm.forward_and_jacobian(q).unwrap();
    let solved: Vec<usize> = (0..q.len()).filter(|joint| !given.contains(joint)).collect();
    let axis = [0, 1, 2].map(|row| pose.rotation[row][2]);
    let columns = solved.iter().map(|joint| {
        let mut column: Vec<f64> = (0..6).map(|row| jacobian[row][*joint]).collect();
        if task.equations == 5 {
            let about: f64 = (0..3).map(|i| column[3 + i] * axis[i]).sum();
            (0..3).for_each(|i| column[3 + i] -= about * axis[i]);
        }
        column.truncate(if task.equations == 3 { 3 } else { 6 });
        column
    });
    let entries: Vec<f64> = columns.flatten().collect();
    let rows = entries.len() / solved.len();
    DMatrix::from_vec(rows, solved.len(), entries).rank(1e-7)
}

/// All words of a length, with links of their own each.
fn words(joints: usize, task: &Task, given: &[usize]) {
    let mut random = Random::named(&format!("{joints} {} {given:?}", task.name));
    let (mut solved, mut singular) = (0, 0);
    for bits in 0..1_u32 << joints {
        let word: String = (0..joints).map(|joint| if bits >> joint & 1 == 1 { 'P' } else { 'R' }).collect();
        let text = file(&word, task, given, &mut random);
        let arm = DynamicArm::from_yaml(&text).unwrap();
        let moving = joints - given.len();
        let ranks = (0..3).map(|_| rank(&arm, task, given, &self::joints(&word, &mut random)));
        if ranks.max().unwrap() < moving {
            let reason = arm.max_solutions().unwrap_err().to_string();
            assert!(reason.contains("singular everywhere"), "{text}{reason}");
            singular += 1;
            continue;
        }
        assert!(arm.max_solutions().is_ok(), "{text}{:?}", arm.max_solutions());
        solved += 1;
        for _ in 0..POSES {
            let q = self::joints(&word, &mut random);
            let target = arm.target_at(&q).unwrap();
            let found = arm.inverse(&target, &arm.held(&q).unwrap()).unwrap();
            let is_found = |solution: &[f64]| solution.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-6);
            assert!(found.iter().any(|solution| is_found(&solution.q)), "{text}{q:?}\n{found:?}");
        }
    }
    println!("{joints} joints, {}, {given:?} given: {solved} words solved, {singular} singular everywhere", task.name);
}

#[test]
fn three_joints_place_a_point() {
    words(3, &POSITION, &[]);
}

#[test]
fn four_joints_place_a_point_with_any_one_given() {
    (0..4).for_each(|given| words(4, &POSITION, &[given]));
}

#[test]
fn five_joints_place_a_point_and_an_axis() {
    words(5, &POINTING, &[]);
}

#[test]
fn five_joints_have_a_pose() {
    words(5, &POSE, &[]);
}

#[test]
fn six_joints_place_a_point_and_an_axis_with_one_given() {
    [0, 3, 5].into_iter().for_each(|given| words(6, &POINTING, &[given]));
}

#[test]
fn six_joints_have_a_pose() {
    words(6, &POSE, &[]);
}

#[test]
fn seven_joints_have_a_pose_with_one_given() {
    words(7, &POSE, &[2]);
}

#[test]
fn seven_joints_place_a_point_and_an_axis_with_two_given() {
    words(7, &POINTING, &[1, 4]);
}

#[test]
fn eight_joints_have_a_pose_with_two_given() {
    words(8, &POSE, &[0, 5]);
}
