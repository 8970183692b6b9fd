//! Straight wrists on a 90 degree grid, each with the gaps that `data/straight_wrist.json` lists.
//!
//! A straight wrist leaves its two outer joints free. `inverse` names a free joint (`FREE`), or lists the joint vector that
//! the pose was made from. Where two roots of an equation before the wrist merge, some poses get neither. `inverse_near`
//! gives the joint vector at every pose.
//!
//! A set of poses fails if a pose that is not listed has its gap, or if a listed pose has it no longer.
#![allow(clippy::unwrap_used)]

use std::f64::consts::PI;
use std::fs;

use denhart::JointKind;
use denhart::solve::Tolerances;
use denhart_dynamic::{DynamicArm, DynamicSolution, DynamicTarget};
use denhart_tests::poses::Space;
use denhart_tests::recover::SAME;
use denhart_tests::subject::{largest, wrap};
use serde::Deserialize;

/// Poses of one arm, and those with a gap.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Set {
    /// The arm file, from the folder of this package.
    arm: String,
    /// The middle joint of three, counted from 1, whose axes meet in a point at right angles. It is at 0 or 180 degrees.
    straight: usize,
    /// The set has one pose of so many of the grid.
    every: usize,
    /// How far each coordinate of the target is off, in the arm's length unit.
    off: f64,
    gap: Gap,
    /// Which roots merge, and where the doubt is lost.
    reason: String,
    /// Joint vectors with the gap. The given joint's value is among the joints; the arm angle is that of the joints.
    at: Vec<Vec<f64>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
enum Gap {
    /// No `EXACT` solution of `inverse` is `FREE`, and none is the joint vector of the pose.
    #[serde(rename = "neither free nor listed")]
    NeitherFreeNorListed,
    /// No `EXACT` solution of `inverse_near` is its reference, which meets the target as well as `EXACT` asks.
    #[serde(rename = "inverse_near lacks the reference")]
    WithoutReference,
}

/// Every straight wrist on the grid of 90 degrees.
fn straight<const N: usize>(arm: &DynamicArm, middle: usize) -> Vec<Vec<f64>> {
    let kinds: [JointKind; N] = arm.joint_kinds().try_into().unwrap();
    let limits: [[f64; 2]; N] = arm.limits().try_into().unwrap();
    // Slides have limits, so that the reach does not count.
    let grid = Space::new(&kinds, &limits, f64::NAN).grid(4);
    grid.filter(|q| q[middle] == 0.0 || q[middle] == PI).map(Vec::from).collect()
}

/// The vectors of the list that have no gap or are no pose of the set, and those with a gap that are not listed.
fn compared<'v>(listed: &'v [Vec<f64>], found: &'v [Vec<f64>]) -> [Vec<&'v Vec<f64>>; 2] {
    let without = |these: &'v [Vec<f64>], those: &[Vec<f64>]| these.iter().filter(|q| !those.contains(q)).collect();
    [without(listed, found), without(found, listed)]
}

/// The poses of a set with its gap.
fn gaps(set: &Set) -> Vec<Vec<f64>> {
    let arm = DynamicArm::from_file(format!("{}/{}", env!("CARGO_MANIFEST_DIR"), set.arm)).unwrap();
    let middle = set.straight - 1;
    let poses = match arm.joints() {
        6 => straight::<6>(&arm, middle),
        7 => straight::<7>(&arm, middle),
        joints => panic!("{}: {joints} joints", set.arm),
    };
    let is = |solution: &DynamicSolution, q: &[f64]| {
        let joints = solution.q.iter().zip(q).zip(arm.joint_kinds());
        let apart = |((a, b), kind): ((&f64, &f64), &JointKind)| match kind {
            JointKind::Revolute => wrap(a - b),
            _ => a - b,
        };
        solution.is_exact() && largest(joints.map(apart)) <= SAME
    };
    let gap = |q: &Vec<f64>| {
        let DynamicTarget::Pose(mut pose) = arm.target_at(q).unwrap() else { panic!("{}: no task pose", set.arm) };
        pose.translation = pose.translation.map(|x| x + set.off);
        let target = DynamicTarget::Pose(pose);
        let near = arm.inverse_near(&target, q).unwrap();
        let held = near.iter().any(|solution| is(solution, q));
        match set.gap {
            Gap::NeitherFreeNorListed => {
                assert!(held, "{}: inverse_near lacks its reference {q:?}", set.arm);
                let solutions = arm.inverse(&target, &arm.held(q).unwrap()).unwrap();
                let free = |solution: &DynamicSolution| solution.is_exact() && !solution.free.is_empty();
                !solutions.iter().any(|solution| free(solution) || is(solution, q))
            }
            Gap::WithoutReference => {
                let missed = arm.residual(q, &target).unwrap();
                assert!(missed.position.max(missed.orientation) <= f64::EXACT, "{}: {missed} at {q:?}", set.arm);
                !held
            }
        }
    };
    poses.into_iter().step_by(set.every).filter(gap).collect()
}

#[test]
fn the_gaps_are_those_of_the_list() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/data/straight_wrist.json")).unwrap();
    let sets: Vec<Set> = serde_json::from_str(&text).unwrap();
    assert!(!sets.is_empty());
    let mut failed = String::new();
    for set in &sets {
        let found = gaps(set);
        let [mended, more] = compared(&set.at, &found);
        let lines = |of: &[&Vec<f64>]| of.iter().map(|q| format!("\n    {q:?},")).collect::<String>();
        if !mended.is_empty() {
            let reason = &set.reason;
            failed += &format!("\n{}: mended, to be taken off the list ({reason}):{}", set.arm, lines(&mended));
        }
        if !more.is_empty() {
            failed += &format!("\n{}: {:?}, not listed:{}", set.arm, set.gap, lines(&more));
        }
    }
    assert!(failed.is_empty(), "{failed}");
}

#[test]
fn a_list_differs_both_ways() {
    let [a, b, c] = [0.0, PI, -0.5 * PI].map(|value| vec![value; 6]);
    let (listed, found) = ([a.clone(), b.clone()], [b, c.clone()]);
    assert_eq!(compared(&listed, &found), [vec![&a], vec![&c]]);
    assert_eq!(compared(&listed, &listed), [vec![], vec![] as Vec<&Vec<f64>>]);
}
