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
}
