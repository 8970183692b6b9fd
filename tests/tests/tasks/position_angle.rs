//! Arms that yaw and pitch three times.

arms! {
    al5d 4 PositionAngle { spec = "../specs/al5d.yaml" };
    jupiter 4 PositionAngle { spec = "../specs/jupiter.yaml" };
    jupiter_l4_6cm 4 PositionAngle { spec = "../specs/jupiter_l4_6cm.yaml" };
    yaw_pitch_offsets 4 PositionAngle { yaml = "
# yaw and three pitches, offsets everywhere
name: yaw_pitch_offsets
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.05, alpha: 90, d: 0.3, theta: 15}
  - {a: 0.3, alpha: 0, d: 0.04, theta: -20}
  - {a: 0.25, alpha: 0, d: -0.07, theta: 35}
  - {a: 0.15, alpha: 0, d: 0.02, theta: -50}
" };
    yaw_pitch_turned 4 PositionAngle { yaml = "
# yaw and three pitches, the middle axis turned around
name: yaw_pitch_turned
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.05, alpha: -90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 180, d: 0.04, theta: 0}
  - {a: 0.25, alpha: 180, d: 0, theta: 0}
  - {a: 0.15, alpha: 90, d: 0.02, theta: 90}
" };
    yaw_pitch_all_turned 4 PositionAngle { yaml = "
# yaw and three pitches, every other axis turned around
name: yaw_pitch_all_turned
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 180, d: 0, theta: 90}
  - {a: 0.25, alpha: 180, d: 0, theta: 0}
  - {a: 0.15, alpha: 0, d: 0, theta: 0}
" };
    yaw_pitch_mounted 4 PositionAngle { yaml = "
# yaw and three pitches with base and tool
name: yaw_pitch_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.05, alpha: 90, d: 0.3, theta: 15}
  - {a: 0.3, alpha: 0, d: 0.04, theta: -20}
  - {a: 0.25, alpha: 180, d: -0.07, theta: 35}
  - {a: 0.15, alpha: 0, d: 0.02, theta: -50}
base: {xyz: [0.181, 0.316, 0.048], rpy: [20.1, -77.3, -99]}
tool: {xyz: [0.024, -0.376, 0.371], rpy: [-151.2, -48.7, 140.9]}
" };
    yaw_pitch_skew_yaw 4 PositionAngle { yaml = "
# yaw and three pitches, a tool at an angle
name: yaw_pitch_skew_yaw
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 15}
  - {a: 0.3, alpha: 0, d: 0.04, theta: -20}
  - {a: 0.25, alpha: 0, d: -0.07, theta: 35}
  - {a: 0.15, alpha: 40, d: 0.02, theta: -50}
tool: {xyz: [0.02, 0.1, 0.05], rpy: [30, 10, 0]}
" };
    crane_rrpr 4 PositionAngle { yaml = "
# RRPR: a crane, whose boom lifts and slides out, with a wrist
name: crane_rrpr
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.5, theta: 0}
  - {a: 0, alpha: 90, d: 0.02, theta: 90}
  - {type: prismatic, a: 0.05, alpha: -90, d: 0.3, theta: 0, limits: [0, 0.8]}
  - {a: 0.2, alpha: 0, d: 0.1, theta: -60}
base: {xyz: [0.2, 0, 0.1], rpy: [15, -70, 40]}
tool: {xyz: [0.05, 0.1, -0.04], rpy: [10, 20, 30]}
" };
    digger_rrrp 4 PositionAngle { yaml = "
# RRRP: yaw, two pitches and a stroke at the end, at an angle
name: digger_rrrp
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.1, alpha: -90, d: 0.4, theta: 0}
  - {a: 0.35, alpha: 180, d: 0, theta: 20}
  - {a: 0.05, alpha: 90, d: 0.03, theta: 65}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.4]}
tool: {xyz: [0.03, 0, 0.1], rpy: [0, 40, 0]}
" };
    beam_rprr 4 PositionAngle { yaml = "
# RPRR: yaw, a beam that slides out, and two pitches
name: beam_rprr
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.06, alpha: 90, d: 0.4, theta: 0}
  - {type: prismatic, a: 0.1, alpha: -90, d: 0.2, theta: 30, limits: [0, 0.5]}
  - {a: 0.3, alpha: 0, d: 0.05, theta: 0}
  - {a: 0.2, alpha: 180, d: 0, theta: -45}
" };
    polar_rppr 4 PositionAngle { yaml = "
# RPPR: yaw, a lift and a beam, and one pitch
name: polar_rppr
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_angle, require: true}
joints:
  - {a: 0.05, alpha: 0, d: 0.3, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 90, d: 0.2, theta: 10, limits: [0, 0.9]}
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 90, limits: [0, 0.6]}
  - {a: 0.15, alpha: 0, d: 0.04, theta: 0}
" };
}
