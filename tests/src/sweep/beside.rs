//! Forward kinematics, link poses and Jacobian of an evaluated arm beside a chain.

use denhart::{Chain, Pose};
use denhart_dynamic::DynamicArm;

use crate::report::Report;
use crate::subject::largest;

/// A product of twelve transforms rounds about sixty times, each time by at most 1.1e-16 of the value or of reach.
const ROUNDING: f64 = 1e-13;

/// Compares every function of `q`.
pub fn check(arm: &DynamicArm, chain: &Chain, reach: f64, family: &'static str, q: &[f64], report: &mut Report) {
    report.count(q);
    // One ulp of a joint value turns everything behind it by as much; a slide far out counts by its own length.
    let size = largest(arm.joint_kinds().iter().zip(q).map(|(kind, q)| match kind {
        denhart::JointKind::Revolute => *q,
        _ => q / reach,
    }));
    let tolerance = ROUNDING * size.max(1.0);
    let mut within = |rule: &'static str, error: f64| {
        // An error that is no number is one.
        if error.is_nan() || error >= tolerance {
            report.fail(family, rule, || format!("q = {q:?}: {error:e}"));
        }
    };
    let expected = Pose::from(chain.forward(q).expect("a value a joint"));
    let pose = arm.forward(q).expect("a value a joint");
    within("forward differs from the chain", pose_error(&pose, &expected, reach));

    let links = arm.link_poses(q).expect("a value a joint");
    let expected_links = chain.link_poses(q).expect("a value a joint");
    let errors =
        links.iter().zip(&expected_links).map(|(link, expected)| pose_error(link, &Pose::from(*expected), reach));
    within("link poses differ from the chain", largest(errors));

    let jacobian = arm.jacobian(q).expect("a value a joint");
    let expected = chain.jacobian(q).expect("a value a joint");
    let unit = |row: usize| if row < 3 { reach } else { 1.0 };
    let scaled = |joint: usize| match arm.joint_kinds().get(joint) {
        Some(denhart::JointKind::Revolute) => 1.0,
        _ => reach,
    };
    let entries = || (0..6).flat_map(|row| (0..q.len()).map(move |joint| (row, joint)));
    let error =
        entries().map(|(row, joint)| (jacobian[row][joint] - expected[(row, joint)]) * scaled(joint) / unit(row));
    within("Jacobian differs from the chain", largest(error));

    let (both_pose, both_jacobian) = arm.forward_and_jacobian(q).expect("a value a joint");
    within("forward_and_jacobian differs from forward", pose_error(&both_pose, &pose, reach));
    let error =
        entries().map(|(row, joint)| (both_jacobian[row][joint] - jacobian[row][joint]) * scaled(joint) / unit(row));
    within("forward_and_jacobian differs from jacobian", largest(error));
}

/// Largest difference of two poses, positions in reaches.
fn pose_error(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let positions = a.translation.iter().zip(&b.translation).map(|(x, y)| (x - y) / reach);
    let rotations = a.rotation.as_flattened().iter().zip(b.rotation.as_flattened()).map(|(x, y)| x - y);
    largest(positions.chain(rotations))
}
