//! The crate's `src/lib.rs`: the generated functions for C.
//!
//! It is the only code with `unsafe`. All of it stands in two functions, which read and write through a pointer, and in
//! their calls.

use denhart_codegen::lower::Goal;

use super::arm::{ARM_ANGLE, Arm};

/// The text of the file.
pub fn text(arm: &Arm<'_>) -> String {
    let mut text = HEAD.to_owned();
    if arm.inverse.is_some() {
        text += SOLUTIONS;
    }
    text += KINEMATICS;
    if let Some(inverse) = &arm.inverse {
        let (target_type, target) = match inverse.goal {
            Goal::Pose => (String::new(), "Pose"),
            Goal::Position => (String::new(), "[Real; 3]"),
            Goal::PlanarPosition => (String::new(), "[Real; 2]"),
            Goal::PositionAxis { .. } => (target("point: [Real; 3], axis: [Real; 3]"), "Target"),
            Goal::PositionAngle { .. } => (target("point: [Real; 3], angle: Real"), "Target"),
            Goal::PlanarPose => (target("x: Real, y: Real, phi: Real"), "Target"),
        };
        let of_c = match inverse.goal {
            Goal::Pose => "denhart::Pose { rotation: target.rotation, translation: target.translation }",
            Goal::Position | Goal::PlanarPosition => "target",
            Goal::PositionAxis { .. } => "denhart::PointAxis { point: target.point, axis: target.axis }",
            Goal::PositionAngle { .. } => "denhart::PointAngle { point: target.point, angle: target.angle }",
            Goal::PlanarPose => "denhart::PlanarPose { x: target.x, y: target.y, phi: target.phi }",
        };
        let given = inverse.given.as_ref();
        text += &target_type;
        text += &INVERSE
            .replace("@target@", target)
            .replace("@of_c@", of_c)
            .replace("@given_parameter@", &given.map_or_else(String::new, |(name, _)| format!("\n    {name}: Real,")))
            .replace("@given@", &given.map_or_else(String::new, |(name, _)| format!(", {name}")));
        if given.is_some_and(|(name, _)| name == ARM_ANGLE) {
            text += ANGLE;
        }
    }
    if arm.model.coupling.is_some() {
        text += MOTORS;
    }
    if arm.model.actuators.is_some() {
        text += PULSES;
    }
    text += MEMORY;
    arm.fill(&text)
}

fn target(fields: &str) -> String {
    let fields: String = fields.split(", ").map(|field| format!("    {field},\n")).collect();
    format!("\n/// `@prefix@_target_t`.\n#[repr(C)]\n#[derive(Clone, Copy)]\npub struct Target {{\n{fields}}}\n")
}

const HEAD: &str = r#"//! The arm `@arm@` for C, exported by denhart @version@: `include/@prefix@.h` has the functions and their documentation.
//!
//! `arm.rs` is the generated code, without `unsafe`. This file reads arguments of C and writes results; `read` and `write`
//! say what makes that sound.

#![no_std]
#![deny(unsafe_op_in_unsafe_fn)]

#[cfg(feature = "std")]
extern crate std;

mod arm;

use arm::Robot;

type Real = @scalar@;

const JOINTS: usize = @joints@;

const OK: i32 = 0;
const BAD_ARGUMENT: i32 = 3;

/// `@prefix@_pose_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Pose {
    rotation: [[Real; 3]; 3],
    translation: [Real; 3],
}

impl Pose {
    fn of(pose: denhart::Pose<Real>) -> Self {
        Self { rotation: pose.rotation, translation: pose.translation }
    }
}

/// `@prefix@_jacobian_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Jacobian {
    rows: [[Real; JOINTS]; 6],
}
"#;

const SOLUTIONS: &str = r#"
const MAX_SOLUTIONS: usize = @most@;

const UNREACHABLE: i32 = 1;
const BAD_TARGET: i32 = 2;

/// `@prefix@_branch_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Branch {
    shoulder: u8,
    elbow: u8,
    wrist: u8,
    root: u8,
}

/// The joints of a set, joint 1 the lowest bit.
fn bits(joints: denhart::JointMask) -> u16 {
    joints.iter().map(|joint| 1 << joint).sum()
}

impl Branch {
    fn of(branch: denhart::Branch) -> Self {
        Self {
            shoulder: branch.shoulder().map_or(0, |part| part as u8),
            elbow: branch.elbow().map_or(0, |part| part as u8),
            wrist: branch.wrist().map_or(0, |part| part as u8),
            root: branch.root().unwrap_or(0),
        }
    }

    /// `None` for a part that has no such number.
    fn named(self) -> Option<denhart::Branch> {
        use denhart::{Elbow, Shoulder, Wrist};
        let mut branch = denhart::Branch::NONE.with_root(self.root);
        match self.shoulder {
            0 => {}
            1 => branch = branch.with_shoulder(Shoulder::Left),
            2 => branch = branch.with_shoulder(Shoulder::Right),
            _ => return None,
        }
        match self.elbow {
            0 => {}
            1 => branch = branch.with_elbow(Elbow::Up),
            2 => branch = branch.with_elbow(Elbow::Down),
            _ => return None,
        }
        match self.wrist {
            0 => {}
            1 => branch = branch.with_wrist(Wrist::NoFlip),
            2 => branch = branch.with_wrist(Wrist::Flip),
            _ => return None,
        }
        Some(branch)
    }
}

/// `@prefix@_solution_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Solution {
    q: [Real; JOINTS],
    position_residual: Real,
    orientation_residual: Real,
    flags: u16,
    free_joints: u16,
    branch: Branch,
}

impl Solution {
    /// In unused places.
    const EMPTY: Self = Self {
        q: [0.0; JOINTS],
        position_residual: 0.0,
        orientation_residual: 0.0,
        flags: 0,
        free_joints: 0,
        branch: Branch { shoulder: 0, elbow: 0, wrist: 0, root: 0 },
    };

    fn of(solution: &denhart::Solution<Real, JOINTS>) -> Self {
        use denhart::Flags;
        let flags = [Flags::EXACT, Flags::BOUNDARY, Flags::FREE, Flags::APPROXIMATE, Flags::OUT_OF_LIMITS];
        let bit = |(place, flag)| u16::from(solution.flags.contains(flag)) << place;
        Self {
            q: solution.q,
            position_residual: solution.residual.position,
            orientation_residual: solution.residual.orientation,
            flags: flags.into_iter().enumerate().map(bit).sum(),
            free_joints: bits(solution.free),
            branch: Branch::of(solution.branch),
        }
    }
}

/// `@prefix@_solutions_t`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Solutions {
    count: i32,
    gap: Real,
    deviation: Real,
    items: [Solution; MAX_SOLUTIONS],
}

impl Solutions {
    fn of(found: &denhart::Solutions<Real, JOINTS, MAX_SOLUTIONS>) -> Self {
        let mut items = [Solution::EMPTY; MAX_SOLUTIONS];
        for (item, solution) in items.iter_mut().zip(found) {
            *item = Solution::of(solution);
        }
        // At most MAX_SOLUTIONS, a few.
        let count = found.len() as i32;
        Self { count, gap: status(found.status()).1, deviation: found.deviation(), items }
    }
}

/// The status and its gap.
fn status(of: denhart::Status<Real>) -> (i32, Real) {
    match of {
        denhart::Status::Reachable => (OK, 0.0),
        denhart::Status::Unreachable { residual } => (UNREACHABLE, residual),
        denhart::Status::BadTarget => (BAD_TARGET, 0.0),
    }
}
"#;

const KINEMATICS: &str = r#"
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_forward(q: *const [Real; JOINTS], pose: *mut Pose) -> i32 {
    // SAFETY: the caller keeps the rules of `read` and `write`, which are those of the header.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        write(pose, Pose::of(Robot.forward(&q)), OK)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_jacobian(q: *const [Real; JOINTS], jacobian: *mut Jacobian) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        write(jacobian, Jacobian { rows: Robot.jacobian(&q).rows }, OK)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_forward_and_jacobian(
    q: *const [Real; JOINTS],
    pose: *mut Pose,
    jacobian: *mut Jacobian,
) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        let (tool, columns) = Robot.forward_and_jacobian(&q);
        let status = write(jacobian, Jacobian { rows: columns.rows }, OK);
        write(pose, Pose::of(tool), status)
    }
}
"#;

const INVERSE: &str = r#"
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_inverse(
    target: *const @target@,@given_parameter@
    solutions: *mut Solutions,
) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(target) = read(target) else { return BAD_ARGUMENT };
        let found = Robot.inverse(&@of_c@@given@);
        write(solutions, Solutions::of(&found), status(found.status()).0)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_inverse_near(
    target: *const @target@,
    q_ref: *const [Real; JOINTS],
    solutions: *mut Solutions,
) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let (Some(target), Some(q_ref)) = (read(target), read(q_ref)) else { return BAD_ARGUMENT };
        let found = Robot.inverse_near(&@of_c@, &q_ref);
        write(solutions, Solutions::of(&found), status(found.status()).0)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_inverse_branch(
    target: *const @target@,@given_parameter@
    branch: *const Branch,
    solution: *mut Solution,
    gap: *mut Real,
) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let (Some(target), Some(branch)) = (read(target), read(branch)) else { return BAD_ARGUMENT };
        let Some(branch) = branch.named() else { return BAD_ARGUMENT };
        let (one, (status, missed)) = match Robot.inverse_branch(&@of_c@@given@, branch) {
            Ok(found) => (Solution::of(&found), (OK, 0.0)),
            Err(outcome) => (Solution::EMPTY, status(outcome)),
        };
        let status = if gap.is_null() { status } else { write(gap, missed, status) };
        write(solution, one, status)
    }
}
"#;

const ANGLE: &str = r#"
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_arm_angle(q: *const [Real; JOINTS], arm_angle: *mut Real) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        write(arm_angle, Robot.arm_angle(&q), OK)
    }
}
"#;

const MOTORS: &str = r#"
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_to_motor(q: *const [Real; JOINTS], motor: *mut [Real; JOINTS]) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        write(motor, Robot.to_motor(&q), OK)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_from_motor(motor: *const [Real; JOINTS], q: *mut [Real; JOINTS]) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(motor) = read(motor) else { return BAD_ARGUMENT };
        write(q, Robot.from_motor(&motor), OK)
    }
}
"#;

const PULSES: &str = r#"
/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_to_pulses(
    q: *const [Real; JOINTS],
    pulses: *mut [i32; JOINTS],
    saturated: *mut u16,
) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(q) = read(q) else { return BAD_ARGUMENT };
        let (counts, ends) = Robot.to_pulses_checked(&q);
        let status = if saturated.is_null() { OK } else { write(saturated, bits(ends), OK) };
        write(pulses, counts, status)
    }
}

/// # Safety
/// As the header says.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn @prefix@_from_pulses(pulses: *const [i32; JOINTS], q: *mut [Real; JOINTS]) -> i32 {
    // SAFETY: as in `@prefix@_forward`.
    unsafe {
        let Some(pulses) = read(pulses) else { return BAD_ARGUMENT };
        write(q, Robot.from_pulses(&pulses), OK)
    }
}
"#;

const MEMORY: &str = r#"
/// What is at `from`; `None` for a pointer that is null or not aligned.
///
/// # Safety
/// Any other pointer is to a `T` that nobody writes during the call.
unsafe fn read<T: Copy>(from: *const T) -> Option<T> {
    if from.is_null() || !from.is_aligned() {
        return None;
    }
    // SAFETY: neither null nor out of line, and to a `T` by the contract of this function. Each `T` here is made of
    // numbers alone, so any bits are one. The value is copied: no reference into the memory of C is made.
    Some(unsafe { from.read() })
}

/// Writes `value` and returns `status`, or `BAD_ARGUMENT` for a pointer that is null or not aligned.
///
/// # Safety
/// Any other pointer is to memory for a `T` that nobody reads or writes during the call; what it holds does not matter.
unsafe fn write<T: Copy>(to: *mut T, value: T, status: i32) -> i32 {
    if to.is_null() || !to.is_aligned() {
        return BAD_ARGUMENT;
    }
    // SAFETY: neither null nor out of line, and to memory for a `T` by the contract of this function. Arguments are
    // copied before, so it may be the memory of one of them.
    unsafe { to.write(value) };
    status
}

/// The generated code does not panic: in optimized builds nothing calls this.
#[cfg(not(feature = "std"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
"#;
