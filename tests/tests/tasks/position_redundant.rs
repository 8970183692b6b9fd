//! Arms of four joints that place the tool point, and of six that also point it, one joint given.

arms! {
    rrrr_skew_q1 4 Position given 1 { yaml = "
# RRRR, nothing parallel, joint 1 given
name: rrrr_skew_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q1, require: true}
joints:
  - {a: -0.206, alpha: 99.9, d: 0.317, theta: -152.8}
  - {a: 0.159, alpha: 90, d: -0.401, theta: 48.9}
  - {a: 0.264, alpha: 59.8, d: -0.383, theta: 60.9}
  - {a: -0.261, alpha: 57.2, d: 0.346, theta: -2.3}
" };
    rrrr_skew_q2 4 Position given 2 { yaml = "
# RRRR, nothing parallel, joint 2 given
name: rrrr_skew_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q2, require: true}
joints:
  - {a: 0.118, alpha: 27.4, d: 0.307, theta: 130.6}
  - {a: -0.218, alpha: 26, d: -0.357, theta: -145.9}
  - {a: -0.121, alpha: -31, d: 0.109, theta: 109.8}
  - {a: 0.328, alpha: 133.7, d: 0.329, theta: -116.7}
" };
    rrrr_skew_q3 4 Position given 3 { yaml = "
# RRRR, nothing parallel, joint 3 given
name: rrrr_skew_q3
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q3, require: true}
joints:
  - {a: -0.303, alpha: -65.4, d: 0.169, theta: -59.4}
  - {a: -0.139, alpha: -128.8, d: -0.445, theta: 99.4}
  - {a: -0.242, alpha: -100.7, d: -0.27, theta: -33.8}
  - {a: -0.38, alpha: 27.7, d: 0.205, theta: 72.4}
" };
    rrrr_skew_q4 4 Position given 4 { yaml = "
# RRRR, nothing parallel, joint 4 given
name: rrrr_skew_q4
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q4, require: true}
joints:
  - {a: -0.286, alpha: 65.5, d: 0.187, theta: 14.5}
  - {a: -0.103, alpha: 139.9, d: 0.141, theta: 84.1}
  - {a: 0.191, alpha: -109.6, d: -0.147, theta: 116.7}
  - {a: -0.348, alpha: 92.2, d: 0.447, theta: -78.2}
" };
    prrr_q1 4 Position given 1 { yaml = "
# an elbow arm on a rail, the rail given
name: prrr_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q1, require: true}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0.1, theta: 0, limits: [0, 2]}
  - {a: 0, alpha: 90, d: 0.35, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.25, alpha: 0, d: 0, theta: 0}
" };
    rrrp_q4 4 Position given 4 { yaml = "
# an elbow arm with a sliding tool, the slide given
name: rrrp_q4
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q4, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.35, theta: 0}
  - {a: 0.3, alpha: 0, d: 0.1, theta: 0}
  - {a: 0.05, alpha: 90, d: 0, theta: 90}
  - {type: prismatic, a: 0, alpha: 0, d: 0.2, theta: 0, limits: [-0.1, 0.3]}
" };
    rrrr_mounted_q3 4 Position given 3 { yaml = "
# a shoulder with a turn of the upper arm given, with base and tool
name: rrrr_mounted_q3
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, redundant: q3, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.35, theta: 0}
  - {a: 0, alpha: -90, d: 0.05, theta: 0}
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.25, alpha: 0, d: 0, theta: 0}
base: {xyz: [-0.034, 0.059, -0.178], rpy: [-67.7, -2.3, -70.6]}
tool: {xyz: [0.053, -0.337, -0.034], rpy: [67.1, 66.9, -98.5]}
" };
    ur_pointing_q6 6 PositionAxis(Z) given 6 { yaml = "
# a UR5 with a symmetric tool: joint 6 may be anywhere
name: ur_pointing_q6
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, redundant: q6, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.089159, theta: 0}
  - {a: -0.425, alpha: 0, d: 0, theta: 0}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0}
" };
    puma_welding_q2 6 PositionAxis(X) given 2 { yaml = "
# a Puma 560 with a torch, joint 2 given
name: puma_welding_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, redundant: q2, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.67183, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0, theta: 0}
tool: {xyz: [0.05, 0, 0.2], rpy: [0, 30, 0]}
" };
    puma_welding_q1 6 PositionAxis(Z) given 1 { yaml = "
# a Puma 560 with a torch, joint 1 given
name: puma_welding_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, redundant: q1, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.67183, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0, theta: 0}
tool: {xyz: [0.05, 0, 0.2], rpy: [0, 30, 0]}
" };
}
