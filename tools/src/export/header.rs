//! The C header.

use denhart_codegen::lower::{AngleSum, Goal};
use denhart_codegen::model::JointKind;

use super::arm::{Arm, Inverse, unit};

/// The text of the file.
pub fn text(arm: &Arm<'_>) -> String {
    let mut text = HEAD.replace("@joint_table@", &joint_table(arm)).replace("@source@", &source(arm));
    text += KINEMATICS;
    match &arm.inverse {
        Some(inverse) => {
            let reserved = match (inverse.holds_a_joint, arm.is_single()) {
                (true, _) => INCOMPLETE,
                (false, true) => "",
                (false, false) => RESERVED,
            };
            text += &self::inverse(inverse).replace("@reserved@", reserved);
            if inverse.takes_arm_angle() {
                text += ANGLE;
            }
        }
        None => text += NO_INVERSE,
    }
    if arm.model.coupling.is_some() {
        text += MOTORS;
    }
    if arm.model.actuators.is_some() {
        text += PULSES;
    }
    text += &sizes(arm);
    text += TAIL;
    arm.fill(&text)
}

/// One line a joint: kind, limits, name.
fn joint_table(arm: &Arm<'_>) -> String {
    let line = |(index, joint): (usize, &denhart_codegen::model::Joint)| {
        let (kind, unit) = match joint.kind {
            JointKind::Revolute => ("turns", "rad"),
            JointKind::Prismatic => ("slides", unit(joint.kind, arm.model)),
        };
        let end = |value: f64| if value.is_finite() { format!("{value:.6}") } else { "no limit".to_owned() };
        let range = joint.limits.map_or_else(
            || format!("{unit}, no limits"),
            |[low, high]| format!("{unit}, from {} to {}", end(low), end(high)),
        );
        let name =
            if joint.name == format!("q{}", index + 1) { String::new() } else { format!(", `{}`", plain(&joint.name)) };
        format!(" *   q[{index}]  {kind}, {range}{name}\n")
    };
    arm.model.joints.iter().enumerate().map(line).collect()
}

/// The comment lines of the arm file.
fn source(arm: &Arm<'_>) -> String {
    let lines = arm.model.source.iter().flat_map(|source| source.lines());
    lines.map(|line| format!(" * {}\n", plain(line.trim())).replace(" * \n", " *\n")).collect()
}

/// A text that neither ends a comment nor begins one.
fn plain(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *").replace('@', "(at)")
}

fn inverse(inverse: &Inverse) -> String {
    let (kind, target) = match &inverse.goal {
        Goal::Pose => ("", "@prefix@_pose_t *target"),
        Goal::Position => ("", "@prefix@_real_t target[3]"),
        Goal::PlanarPosition => ("", "@prefix@_real_t target[2]"),
        Goal::PositionAxis { .. } => (TARGET_AXIS, "@prefix@_target_t *target"),
        Goal::PositionAngle { .. } => (TARGET_ANGLE, "@prefix@_target_t *target"),
        Goal::PlanarPose => (TARGET_PLANAR, "@prefix@_target_t *target"),
    };
    let meaning = match &inverse.goal {
        Goal::Pose => {
            "where the tool is to be, base frame. A rotation that is off by at most 1e-3 stands for the\n *   nearest one".to_owned()
        }
        Goal::Position => "where the tool point is to be, base frame, @unit@".to_owned(),
        Goal::PlanarPosition => "where the tool point is to be in the base frame's xy plane, @unit@".to_owned(),
        Goal::PositionAxis { column } => format!(
            "where the tool point is to be and where the tool's {} axis is to point",
            ["x", "y", "z"].get(*column).copied().unwrap_or_default()
        ),
        goal @ Goal::PositionAngle { .. } => {
            format!("where the tool point is to be and the tool's angle in the plane, `{}`", angle_sum(goal))
        }
        Goal::PlanarPose => "where the tool is to be in the base frame's xy plane".to_owned(),
    };
    let number = inverse.given_number();
    let taken = match number {
        Some((name, _)) if name.starts_with('q') => format!("; `{name}` is that of q_ref"),
        Some(_) => "; the arm angle is that of q_ref".to_owned(),
        None if inverse.given_is_list => "; `given` is that of q_ref".to_owned(),
        None => String::new(),
    };
    let names: Vec<&str> = inverse.given.iter().map(|(name, _)| name.as_str()).collect();
    let beside = if names.is_empty() { String::new() } else { format!(", without the {} of q", names.join(", ")) };
    let (given, given_doc) = match number {
        Some((name, words)) => (format!(" @prefix@_real_t {name},"), format!(" * {name}: {words}.\n")),
        None if inverse.given_is_list => (GIVEN_LIST.to_owned(), given_doc(inverse)),
        None => (String::new(), String::new()),
    };
    let count = inverse.given.len();
    let count = if inverse.given_is_list { GIVEN_COUNT.replace("@count@", &count.to_string()) } else { String::new() };
    INVERSE
        .replace("@inverse_branch@", if inverse.has_names { INVERSE_BRANCH } else { "" })
        .replace("@target_type@", &kind.replace("@angle@", &angle_sum(&inverse.goal)))
        .replace("@target@", target)
        .replace("@given_count@", &count)
        .replace("@beside@", &beside)
        .replace("@meaning@", &meaning)
        .replace("@taken@", &taken)
        .replace("@given@", &given)
        .replace("@given_doc@", &given_doc)
}

/// The documentation of an array of given values, a line for each.
fn given_doc(inverse: &Inverse) -> String {
    let line = |(place, (_, words)): (usize, &(String, String))| format!(" *   given[{place}]: {words}.\n");
    let lines: String = inverse.given.iter().enumerate().map(line).collect();
    format!(" * given: values that the target leaves to choose.\n{lines}")
}

/// The angle of `position_angle` in C, rad: `q[1] - q[2] + q[3] + 1.5707963267948966`.
fn angle_sum(goal: &Goal) -> String {
    let Some(AngleSum { terms, constant }) = goal.angle_sum() else { return String::new() };
    let sign = |negative: bool| if negative { '-' } else { '+' };
    let terms = terms.iter().map(|(joint, negative)| format!("{} q[{joint}]", sign(*negative)));
    let constant = (!constant.is_zero()).then(|| format!("{} {}", sign(constant.rad() < 0.0), constant.rad().abs()));
    let sum = terms.chain(constant).collect::<Vec<_>>().join(" ");
    sum.strip_prefix("+ ").unwrap_or(&sum).to_owned()
}

/// Checks that C and Rust lay the types out alike.
fn sizes(arm: &Arm<'_>) -> String {
    let (joints, real) = (arm.joints(), if arm.is_single() { 4 } else { 8 });
    let mut sizes = vec![("pose", 12 * real), ("jacobian", 6 * joints * real)];
    if let Some(inverse) = &arm.inverse {
        let solution = joints * real + 2 * real + 8;
        // The count, with what stands behind it, takes whole places of the number type.
        let places = if inverse.holds_a_joint && arm.is_single() { 4 } else { 3 };
        sizes.extend([("branch", 4), ("solution", solution), ("solutions", places * real + inverse.most * solution)]);
    }
    let lines: String = sizes
        .iter()
        .map(|(name, size)| {
            format!("typedef char @prefix@_{name}_has_this_size[sizeof(@prefix@_{name}_t) == {size} ? 1 : -1];\n")
        })
        .collect();
    format!("\n/* The types as the library has them: another layout does not compile. */\n{lines}")
}

const HEAD: &str = r#"/*
 * Kinematics of the arm `@arm@`, exported by denhart @version@. Do not edit: change the arm file and export it again.
 *
@source@ *
 * Lengths are in @unit@, angles in rad. The base frame is that of the arm file. The joints, in the order of every joint vector:
@joint_table@ *
 * Every function returns a status. It allocates nothing, keeps nothing between calls and may be called from several threads
 * or interrupts. Numbers may have any bits; where they are not finite the status or the result says so. A pointer has to
 * be null, or aligned and to memory of its type that nothing else changes during the call; for null the status is
 * @PREFIX@_BAD_ARGUMENT. Then nothing is written; with any other status every output is. An output may be the same memory
 * as an input.
 */
#ifndef @PREFIX@_H
#define @PREFIX@_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The number type of all values. */
typedef @real@ @prefix@_real_t;

/** Number of joints. */
#define @PREFIX@_JOINTS @joints@

/** Status: done. Of an inverse: at least one solution is exact. */
#define @PREFIX@_OK 0
/** Status: no solution is exact; those that miss by no more than the tolerance are listed all the same. */
#define @PREFIX@_UNREACHABLE 1
/** Status: target or reference are not finite, or the target's rotation is none. No solution is listed. */
#define @PREFIX@_BAD_TARGET 2
/** Status: a pointer is null or not aligned, or a part of a branch has another number than below. */
#define @PREFIX@_BAD_ARGUMENT 3

/** A frame in the base frame: `p_base = rotation p + translation`. */
typedef struct {
    /** By rows, without a unit. */
    @prefix@_real_t rotation[3][3];
    /** @unit@. */
    @prefix@_real_t translation[3];
} @prefix@_pose_t;

/** Geometric Jacobian in the base frame at the tool point. */
typedef struct {
    /** Rows vx vy vz (@unit@ for a unit of the joint) and wx wy wz (rad for a unit of the joint), a column for each joint. */
    @prefix@_real_t rows[6][@PREFIX@_JOINTS];
} @prefix@_jacobian_t;
"#;

const KINEMATICS: &str = r"
/** Pose of the tool. q: joint values. */
int32_t @prefix@_forward(const @prefix@_real_t q[@PREFIX@_JOINTS], @prefix@_pose_t *pose);

/** Geometric Jacobian at the tool point. q: joint values. */
int32_t @prefix@_jacobian(const @prefix@_real_t q[@PREFIX@_JOINTS], @prefix@_jacobian_t *jacobian);

/** Both, for less than the two calls. */
int32_t @prefix@_forward_and_jacobian(const @prefix@_real_t q[@PREFIX@_JOINTS], @prefix@_pose_t *pose,
    @prefix@_jacobian_t *jacobian);
";

const TARGET_AXIS: &str = r"
/** A point and a direction. */
typedef struct {
    /** Of the tool point, base frame, @unit@. */
    @prefix@_real_t point[3];
    /** Of the tool's axis, base frame; of any length above 1e-12. */
    @prefix@_real_t axis[3];
} @prefix@_target_t;
";

const TARGET_ANGLE: &str = r"
/** A point and an angle. */
typedef struct {
    /** Of the tool point, base frame, @unit@. */
    @prefix@_real_t point[3];
    /** Of the tool in the plane of its links, rad: `@angle@` of the joint values q. */
    @prefix@_real_t angle;
} @prefix@_target_t;
";

const TARGET_PLANAR: &str = r"
/** A pose in the base frame's xy plane. */
typedef struct {
    /** Position, @unit@. */
    @prefix@_real_t x;
    /** Position, @unit@. */
    @prefix@_real_t y;
    /** Direction of the tool's x axis, from the base's x axis towards its y axis, rad. */
    @prefix@_real_t phi;
} @prefix@_target_t;
";

const NO_INVERSE: &str = r"
/* The arm has no inverse kinematics in closed form; `denhart check` says why. */
";

/// Fills the place that the next number begins at. On some processors it would begin earlier.
const RESERVED: &str = "
    /** 0. */
    int32_t reserved;";

/// In its place for an arm whose inverse holds a joint.
const INCOMPLETE: &str = "
    /** 1 if a bound of the call was reached, so that further solutions may exist; else 0. */
    int32_t incomplete;";

const INVERSE: &str = r"
/** Largest number of solutions of one target. */
#define @PREFIX@_MAX_SOLUTIONS @most@
@given_count@
/** Flag: reaches the target up to rounding. */
#define @PREFIX@_EXACT 1u
/** Flag: two branches meet here, the target is on the edge of what the branch reaches. */
#define @PREFIX@_BOUNDARY 2u
/** Flag: a singular pose; the joints of `free_joints` could have other values. */
#define @PREFIX@_FREE 4u
/** Flag: misses the target by more than rounding and no more than the tolerance of the arm file. */
#define @PREFIX@_APPROXIMATE 8u
/** Flag: a joint value is outside its limits. */
#define @PREFIX@_OUT_OF_LIMITS 16u

/** The name of a branch. A part is 0 where the arm has no such part, or to match any value. */
typedef struct {
    /** 1 left, 2 right. */
    uint8_t shoulder;
    /** 1 up, 2 down. */
    uint8_t elbow;
    /** 1 not flipped, 2 flipped. */
    uint8_t wrist;
    /** Number of the root, from 1; means a branch of one target only. */
    uint8_t root;
} @prefix@_branch_t;

/** One joint vector that answers a target. */
typedef struct {
    /** Joint values. */
    @prefix@_real_t q[@PREFIX@_JOINTS];
    /** What the tool point misses by, @unit@; 0 for an ordinary solution. */
    @prefix@_real_t position_residual;
    /** What the orientation misses by, rad; 0 for an ordinary solution. */
    @prefix@_real_t orientation_residual;
    /** The flags above, or-ed. */
    uint16_t flags;
    /** The joints that the target does not determine: bit i for q[i]. */
    uint16_t free_joints;
    @prefix@_branch_t branch;
} @prefix@_solution_t;

/** The solutions of one target. */
typedef struct {
    /** How many there are, 0 to @PREFIX@_MAX_SOLUTIONS. */
    int32_t count;@reserved@
    /** With @PREFIX@_UNREACHABLE the least gap of an equation, @unit@ or rad; not the distance to the workspace. Else 0. */
    @prefix@_real_t gap;
    /** By how much the target's rotation was off; the solutions reach the nearest rotation. */
    @prefix@_real_t deviation;
    /** The first `count` are solutions, the others zeros. */
    @prefix@_solution_t items[@PREFIX@_MAX_SOLUTIONS];
} @prefix@_solutions_t;
@target_type@
/**
 * Every joint vector that reaches a target, each branch once, in a fixed order. Limits only set a flag.
 *
 * target: @meaning@.
@given_doc@ * solutions: angles are in (-pi, pi].
 */
int32_t @prefix@_inverse(const @target@,@given@ @prefix@_solutions_t *solutions);

/**
 * The same solutions next to q_ref, the nearest first: each turning joint on the turn nearest to its reference, of those
 * within the limits if there are any. Joints that the target does not determine have the value of q_ref@taken@.
 */
int32_t @prefix@_inverse_near(const @target@, const @prefix@_real_t q_ref[@PREFIX@_JOINTS],
    @prefix@_solutions_t *solutions);

@inverse_branch@/** The target of the tool at joint values q@beside@. */
int32_t @prefix@_target_at(const @prefix@_real_t q[@PREFIX@_JOINTS], @target@);
";

/// The size of an array of given values.
const GIVEN_COUNT: &str = r"
/** Number of values that are given beside a target. */
#define @PREFIX@_GIVEN @count@
";

/// The argument for an array of given values.
const GIVEN_LIST: &str = " const @prefix@_real_t given[@PREFIX@_GIVEN],";

const INVERSE_BRANCH: &str = r"/**
 * The solution on one branch, without computing the others. Where two branches meet, either name gives the one solution,
 * flagged @PREFIX@_BOUNDARY.
 *
 * branch: a part that is 0 matches any value.
 * gap: as in @prefix@_solutions_t; may be null.
 */
int32_t @prefix@_inverse_branch(const @target@,@given@ const @prefix@_branch_t *branch,
    @prefix@_solution_t *solution, @prefix@_real_t *gap);

";

const ANGLE: &str = r"
/** The arm angle of joint values. */
int32_t @prefix@_arm_angle(const @prefix@_real_t q[@PREFIX@_JOINTS], @prefix@_real_t *arm_angle);
";

const MOTORS: &str = r"
/** Motor values (rad or @unit@) at joint values. */
int32_t @prefix@_to_motor(const @prefix@_real_t q[@PREFIX@_JOINTS], @prefix@_real_t motor[@PREFIX@_JOINTS]);

/** Joint values at motor values. */
int32_t @prefix@_from_motor(const @prefix@_real_t motor[@PREFIX@_JOINTS], @prefix@_real_t q[@PREFIX@_JOINTS]);
";

const PULSES: &str = r"
/**
 * Pulse counts of the motors at joint values, each from its home position, rounded to the nearest count.
 *
 * saturated: bit i for a motor whose count has stopped at the end of int32_t, or whose value is not a number; may be null.
 */
int32_t @prefix@_to_pulses(const @prefix@_real_t q[@PREFIX@_JOINTS], int32_t pulses[@PREFIX@_JOINTS],
    uint16_t *saturated);

/** Joint values at pulse counts. */
int32_t @prefix@_from_pulses(const int32_t pulses[@PREFIX@_JOINTS], @prefix@_real_t q[@PREFIX@_JOINTS]);
";

const TAIL: &str = r"
#ifdef __cplusplus
}
#endif

#endif
";
