//! The types for C and what they are made of.

use denhart_codegen::lower::Goal;

use crate::export::arm::Arm;

/// Types, constants and conversions of an arm.
pub fn text(arm: &Arm<'_>) -> String {
    let mut text = HEAD.to_owned();
    if arm.has_optional_results() {
        // Both come with sets of joints.
        text += BITS;
    }
    if let Some(inverse) = &arm.inverse {
        let (field, value) = match (inverse.holds_a_joint, arm.is_single()) {
            (true, _) => ("\n    incomplete: i32,", ", incomplete: i32::from(!found.is_complete())"),
            (false, true) => ("", ""),
            (false, false) => ("\n    reserved: i32,", ", reserved: 0"),
        };
        text += &SOLUTIONS
            .replace("@reserved@", field)
            .replace("@reserved_value@", value)
            .replace("@named@", if inverse.has_names { NAMED } else { "" });
        text += &match &inverse.goal {
            Goal::Pose | Goal::Position | Goal::PlanarPosition => String::new(),
            Goal::PositionAxis { .. } => target("point: [Real; 3], axis: [Real; 3]"),
            Goal::PositionAngle { .. } => target("point: [Real; 3], angle: Real"),
            Goal::PlanarPose => target("x: Real, y: Real, phi: Real"),
        };
    }
    text
}

fn target(fields: &str) -> String {
    let fields: String = fields.split(", ").map(|field| format!("    {field},\n")).collect();
    format!("\n/// `@prefix@_target_t`.\n#[repr(C)]\n#[derive(Clone, Copy)]\npub struct Target {{\n{fields}}}\n")
}

const HEAD: &str = r#"//! The arm `@arm@` for C, exported by denhart @version@: `include/@prefix@.h` has the functions and their documentation.
//!
//! `arm.rs` is the generated code, without `unsafe`. This file reads arguments of C and writes results; `read` and `Output`
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

impl Jacobian {
    fn of(jacobian: denhart::Jacobian<Real, JOINTS>) -> Self {
        Self { rows: jacobian.rows }
    }
}
"#;

const BITS: &str = r#"
/// The joints of a set, joint 1 the lowest bit.
fn bits(joints: denhart::JointMask) -> u16 {
    joints.iter().map(|joint| 1 << joint).sum()
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

impl Branch {
    fn of(branch: denhart::Branch) -> Self {
        Self {
            shoulder: branch.shoulder().map_or(0, |part| part as u8),
            elbow: branch.elbow().map_or(0, |part| part as u8),
            wrist: branch.wrist().map_or(0, |part| part as u8),
            root: branch.root().unwrap_or(0),
        }
    }
@named@}

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
    count: i32,@reserved@
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
        Self { count@reserved_value@, gap: status(found.status()).1, deviation: found.deviation(), items }
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

/// A branch that is asked for.
const NAMED: &str = r#"
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
"#;
