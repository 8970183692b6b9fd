//! Made-up arms of seven joints, one of them given.

arms! {
    ur_on_a_rail 7 Pose given 1 { yaml = "
# a UR5 on a rail
name: ur_on_a_rail
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 0, limits: [0, 3]}
  - {a: 0, alpha: 90, d: 0.0892, theta: 0}
  - {a: -0.425, alpha: 0, d: 0, theta: 0}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0}
base: {xyz: [0, 0, 0.5], rpy: [-90, 0, 0]}
" };
    puma_on_a_rail 7 Pose given 1 { yaml = "
# a Puma 560 on a rail, with base and tool
name: puma_on_a_rail
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0.1, theta: 0, limits: [0, 3]}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.056, theta: 0}
base: {xyz: [-0.013, 0.245, 0.361], rpy: [-13.6, -9.9, 101.6]}
tool: {xyz: [0.021, 0.028, 0.232], rpy: [-138.6, -29.1, 44.4]}
" };
    puma_on_a_turntable 7 Pose given 1 { yaml = "
# a Puma 560 on a turntable at an angle, with base and tool
name: puma_on_a_turntable
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q1, require: true}
joints:
  - {a: 0.3, alpha: 35, d: 0.2, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.056, theta: 0}
base: {xyz: [0.028, 0.012, -0.297], rpy: [-26.3, -23.4, -79]}
tool: {xyz: [0.249, 0.248, 0.243], rpy: [163, -58.5, -130.3]}
" };
    skew_meet_567_q2 7 Pose given 2 { yaml = "
# 7R, axes 5, 6, 7 meet, nothing else, joint 2 given
name: skew_meet_567_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q2, require: true}
joints:
  - {a: 0.102, alpha: 41.9, d: -0.102, theta: 49.4}
  - {a: 0.352, alpha: 110.6, d: 0.253, theta: 69.2}
  - {a: 0.127, alpha: -72.5, d: 0.357, theta: -170.8}
  - {a: -0.258, alpha: 78.4, d: -0.207, theta: 104.5}
  - {a: 0, alpha: -59.2, d: 0.418, theta: 39.3}
  - {a: 0, alpha: -29.9, d: 0, theta: -19.7}
  - {a: 0.248, alpha: -72.8, d: -0.105, theta: -139.4}
" };
    skew_parallel_234_q6 7 Pose given 6 { yaml = "
# 7R, axes 2, 3, 4 are parallel, joint 6 given
name: skew_parallel_234_q6
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q6, require: true}
joints:
  - {a: -0.153, alpha: -99.2, d: 0.264, theta: 4.3}
  - {a: -0.227, alpha: 0, d: -0.408, theta: 145.3}
  - {a: -0.424, alpha: 0, d: -0.202, theta: -122.2}
  - {a: -0.119, alpha: -111.5, d: 0.401, theta: 115.7}
  - {a: -0.393, alpha: -36.7, d: 0.435, theta: -120.2}
  - {a: 0.382, alpha: -56.9, d: 0.448, theta: -126}
  - {a: -0.27, alpha: -108.8, d: -0.114, theta: 14.6}
" };
    slide_given_between 7 Pose given 3 { yaml = "
# RRPRRRR, axes 5, 6, 7 meet, the slide given
name: slide_given_between
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q3, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 90, d: 0.1, theta: 90}
  - {type: prismatic, a: 0, alpha: 0, d: 0.2, theta: 0, limits: [0, 0.5]}
  - {a: 0.05, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
}
