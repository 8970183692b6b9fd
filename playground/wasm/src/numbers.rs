//! Numbers in a row, as the page reads them.

use denhart::{Flags, JointMask, Pose, Status};
use denhart_draw::{DrawError, Skeleton};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolutions};

/// The pose of twelve numbers: rotation by rows, then the point.
pub fn pose(numbers: &[f64]) -> Option<Pose<f64>> {
    let [a, b, c, d, e, f, g, h, i, x, y, z] = *numbers.first_chunk::<12>()?;
    Some(Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] })
}

/// Twelve numbers of a pose.
pub fn of_pose(pose: &Pose<f64>) -> impl Iterator<Item = f64> {
    pose.rotation.into_iter().flatten().chain(pose.translation)
}

/// Joints as a number with a bit for each.
pub fn of_mask(joints: JointMask) -> f64 {
    joints.iter().map(|joint| f64::from(1_u32 << joint.min(31))).sum()
}

/// Flags as a number: 1 exact, 2 boundary, 4 free, 8 approximate, 16 out of limits.
pub fn of_flags(flags: Flags) -> f64 {
    let all = [Flags::EXACT, Flags::BOUNDARY, Flags::FREE, Flags::APPROXIMATE, Flags::OUT_OF_LIMITS];
    let bits = all.iter().zip([1.0, 2.0, 4.0, 8.0, 16.0]);
    bits.filter(|(flag, _)| flags.contains(**flag)).map(|(_, bit)| bit).sum()
}

/// The least margin of a joint vector, of any singularity; not a number where the arm has no margins.
pub fn least_margin(arm: &DynamicArm, q: &[f64]) -> f64 {
    let margins = arm.margins(q).ok().flatten().unwrap_or_default();
    margins.iter().map(|margin| margin.value.abs()).fold(f64::NAN, f64::min)
}

/// The joints outside their limits, a bit for each.
fn outside(arm: &DynamicArm, q: &[f64]) -> f64 {
    let slack = |end: f64| 1e-12 * (1.0 + end.abs());
    let mut joints = JointMask::NONE;
    for (joint, (value, [low, high])) in q.iter().zip(arm.limits()).enumerate() {
        if *value < low - slack(*low) || *value > high + slack(*high) {
            joints.insert(JointMask::single(joint));
        }
    }
    of_mask(joints)
}

/// An arm in one posture: the tool's pose, the joints outside their limits, the least margin; of each joint its point and axis; of
/// each link how many corners it has, and those.
///
/// # Errors
/// As of [`Skeleton::of`].
pub fn figure(arm: &DynamicArm, q: &[f64]) -> Result<Vec<f64>, DrawError> {
    let skeleton = Skeleton::of(arm, q)?;
    let mut numbers: Vec<f64> = of_pose(&skeleton.tool).collect();
    numbers.extend([outside(arm, q), least_margin(arm, q)]);
    for joint in &skeleton.joints {
        numbers.extend(joint.point);
        numbers.extend(joint.axis);
    }
    for link in &skeleton.links {
        numbers.push(count(link.len()));
        numbers.extend(link.iter().flatten());
    }
    Ok(numbers)
}

/// The answer to a target: status (0 reached, 1 not reached, 2 no target), gap, deviation, 1 if complete, the number of solutions;
/// then of each solution its flags, free joints, residual (two numbers), joint values, and the length of its figure, and that.
///
/// # Errors
/// A figure whose points are not finite.
pub fn solutions(arm: &DynamicArm, solutions: &DynamicSolutions) -> Result<Vec<f64>, DrawError> {
    let (status, gap) = match solutions.status() {
        Status::Reachable => (0.0, 0.0),
        Status::Unreachable { residual } => (1.0, residual),
        Status::BadTarget => (2.0, f64::NAN),
    };
    let complete = if solutions.is_complete() { 1.0 } else { 0.0 };
    let mut numbers = vec![status, gap, solutions.deviation(), complete, count(solutions.len())];
    for solution in solutions.iter() {
        let flags = of_flags(solution.flags);
        numbers.extend([flags, of_mask(solution.free), solution.residual.position, solution.residual.orientation]);
        numbers.extend(solution.q.iter());
        let figure = figure(arm, &solution.q)?;
        numbers.push(count(figure.len()));
        numbers.extend(figure);
    }
    Ok(numbers)
}

/// A small number of things.
#[allow(clippy::cast_precision_loss)]
pub fn count(things: usize) -> f64 {
    things as f64
}

/// An error with its message, as JavaScript throws it.
pub fn thrown(error: impl std::fmt::Display) -> wasm_bindgen::JsError {
    wasm_bindgen::JsError::new(&error.to_string())
}

/// The target of an arm's task at a pose of the tool; `angle` is that of a `position_angle`, which no pose tells.
///
/// # Errors
/// An arm without inverse, numbers that are no pose.
pub fn target(arm: &DynamicArm, numbers: &[f64], angle: f64) -> Result<denhart_dynamic::DynamicTarget, DynamicError> {
    let pose = pose(numbers).unwrap_or(Pose { rotation: [[f64::NAN; 3]; 3], translation: [f64::NAN; 3] });
    let by_angle = || denhart_dynamic::DynamicTarget::PositionAngle(denhart::PointAngle::new(pose.translation, angle));
    Ok(arm.target_of(&pose)?.unwrap_or_else(by_angle))
}
