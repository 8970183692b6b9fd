//! Arms of five joints that place the tool point and point one of the tool's axes.

arms! {
    meet_123_x 5 PositionAxis(X) { yaml = "
# 5R, axes 1, 2, 3 meet; the tool points with x
name: meet_123_x
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0, alpha: 109.5, d: 0.43, theta: 74.1}
  - {a: 0, alpha: 65, d: 0, theta: -155.2}
  - {a: -0.111, alpha: -107.9, d: 0.432, theta: 133.3}
  - {a: 0.212, alpha: -151.1, d: 0.316, theta: 164.2}
  - {a: -0.278, alpha: -151.8, d: -0.234, theta: 52.7}
" };
    meet_234_y 5 PositionAxis(Y) { yaml = "
# 5R, axes 2, 3, 4 meet; the tool points with y
name: meet_234_y
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
joints:
  - {a: 0.409, alpha: 103.4, d: 0.356, theta: 147.6}
  - {a: 0, alpha: 57.6, d: -0.225, theta: 41.1}
  - {a: 0, alpha: -141.6, d: 0, theta: 24.8}
  - {a: -0.338, alpha: -148.2, d: -0.312, theta: 156.3}
  - {a: -0.174, alpha: -53.5, d: 0.246, theta: 94.7}
" };
    meet_345_z 5 PositionAxis(Z) { yaml = "
# 5R, axes 3, 4, 5 meet; the tool points with z
name: meet_345_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0.224, alpha: 59.7, d: -0.354, theta: 9.5}
  - {a: 0.104, alpha: 142.5, d: -0.162, theta: -0.8}
  - {a: 0, alpha: 107.3, d: -0.423, theta: -164.8}
  - {a: 0, alpha: -64.7, d: 0, theta: -149.4}
  - {a: -0.251, alpha: 115.7, d: -0.352, theta: -45.8}
" };
    parallel_123_x 5 PositionAxis(X) { yaml = "
# 5R, axes 1, 2, 3 are parallel; the tool points with x
name: parallel_123_x
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: -0.313, alpha: 0, d: 0.443, theta: -92.3}
  - {a: -0.276, alpha: 180, d: 0.439, theta: 166.8}
  - {a: 0.29, alpha: 152.9, d: 0.196, theta: -161.3}
  - {a: 0.115, alpha: -104.1, d: 0.233, theta: -32.2}
  - {a: 0.358, alpha: -67.9, d: -0.247, theta: -120.5}
" };
    parallel_234_y 5 PositionAxis(Y) { yaml = "
# 5R, axes 2, 3, 4 are parallel; the tool points with y
name: parallel_234_y
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
joints:
  - {a: 0.278, alpha: 144, d: 0.213, theta: 62.6}
  - {a: 0.2, alpha: 180, d: 0.102, theta: 84.6}
  - {a: 0.159, alpha: 0, d: 0.135, theta: 173.4}
  - {a: -0.368, alpha: 89.8, d: 0.186, theta: -63.3}
  - {a: -0.157, alpha: -127.1, d: 0.392, theta: -126.3}
" };
    parallel_345_z 5 PositionAxis(Z) { yaml = "
# 5R, axes 3, 4, 5 are parallel; the tool points with z
name: parallel_345_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: -0.169, alpha: 32.6, d: 0.365, theta: -35.6}
  - {a: 0.143, alpha: 122, d: -0.27, theta: -172.8}
  - {a: -0.237, alpha: 0, d: 0.21, theta: 137.2}
  - {a: 0.443, alpha: 0, d: -0.131, theta: -8.1}
  - {a: 0.211, alpha: 124.2, d: -0.3, theta: 168.3}
" };
    meet_123_z 5 PositionAxis(Z) { yaml = "
# 5R, axes 1, 2, 3 meet; the tool points with z
name: meet_123_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: -29.6, d: -0.391, theta: -143}
  - {a: 0, alpha: 97.8, d: 0, theta: -1.7}
  - {a: -0.406, alpha: 101.3, d: 0.151, theta: -127.9}
  - {a: 0.283, alpha: 55.7, d: -0.396, theta: 157.1}
  - {a: -0.242, alpha: 26.7, d: 0.392, theta: 15}
" };
    parallel_234_z 5 PositionAxis(Z) { yaml = "
# 5R, axes 2, 3, 4 are parallel; the tool points with z
name: parallel_234_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0.284, alpha: -59.2, d: -0.159, theta: -85.6}
  - {a: 0.314, alpha: 0, d: 0.117, theta: 173.5}
  - {a: 0.226, alpha: 180, d: -0.101, theta: 58.6}
  - {a: -0.29, alpha: -33.5, d: 0.422, theta: -6.7}
  - {a: -0.379, alpha: 64.2, d: 0.438, theta: 123}
" };
    parallel_123_y 5 PositionAxis(Y) { yaml = "
# 5R, axes 1, 2, 3 are parallel; the tool points with y
name: parallel_123_y
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
joints:
  - {a: -0.435, alpha: 180, d: -0.12, theta: 155}
  - {a: -0.37, alpha: 180, d: 0.236, theta: -26.1}
  - {a: -0.312, alpha: 59.2, d: -0.411, theta: 6.4}
  - {a: -0.285, alpha: 92.7, d: -0.407, theta: -118.2}
  - {a: 0.197, alpha: -73, d: 0.102, theta: 105.1}
" };
    puma_without_flange_z 5 PositionAxis(Z) { yaml = "
# a Puma 560 without joint 6: axes 4, 5 and the tool axis meet at the tool point
name: puma_without_flange_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
" };
    puma_without_flange_x 5 PositionAxis(X) { yaml = "
# a Puma 560 without joint 6 that points with x, which turns about axis 5
name: puma_without_flange_x
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
" };
    puma_with_torch 5 PositionAxis(Z) { yaml = "
# a Puma 560 without joint 6, a torch in place of it
name: puma_with_torch
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}
" };
    puma_with_bent_torch 5 PositionAxis(X) { yaml = "
# a Puma 560 without joint 6, a torch at an angle
name: puma_with_bent_torch
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
base: {xyz: [0.1, -0.2, 0.5], rpy: [0, 0, 30]}
tool: {xyz: [0.1, 0, 0.1], rpy: [0, -45, 0]}
" };
    ur_without_flange_z 5 PositionAxis(Z) { yaml = "
# a UR5 without joint 6: axes 2, 3, 4 are parallel
name: ur_without_flange_z
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.0892, theta: 0}
  - {a: -0.425, alpha: 0, d: 0, theta: 0}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
" };
    ur_without_flange_mounted 5 PositionAxis(X) { yaml = "
# a UR5 without joint 6 that points with x, with base and tool
name: ur_without_flange_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.0892, theta: 0}
  - {a: -0.425, alpha: 0, d: 0, theta: 0}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
base: {xyz: [-0.041, 0.156, -0.142], rpy: [44.4, -46.8, -70]}
tool: {xyz: [0.302, -0.378, -0.299], rpy: [126.9, 49.3, 81.9]}
" };
    scorbot_x 5 PositionAxis(X) { yaml = "
# Scorbot ER-V (scorbot_er5), the tool points with x across its roll axis
name: scorbot_x
convention: standard
units: {length: mm, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 16, alpha: -90, d: 349, theta: 0}
  - {a: 221, alpha: 0, d: 0, theta: 0}
  - {a: 221, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: -90}
  - {a: 0, alpha: 0, d: 145, theta: 0}
" };
    scorbot_y_mounted 5 PositionAxis(Y) { yaml = "
# Scorbot ER-V that points with y, with base and tool in mm
name: scorbot_y_mounted
convention: standard
units: {length: mm, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
joints:
  - {a: 16, alpha: -90, d: 349, theta: 0}
  - {a: 221, alpha: 0, d: 0, theta: 0}
  - {a: 221, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: -90}
  - {a: 0, alpha: 0, d: 145, theta: 0}
base: {xyz: [100, -250, 80], rpy: [10, -35, 120]}
tool: {xyz: [15, -20, 30], rpy: [50, 20, -70]}
" };
    youbot_x 5 PositionAxis(X) { yaml = "
# KUKA youBot (kuka_youbot), the tool points with x across its roll axis
name: youbot_x
convention: modified
units: {length: mm, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0, alpha: 0, d: 115, theta: 0}
  - {a: 33, alpha: -90, d: 0, theta: -90}
  - {a: 155, alpha: 0, d: 0, theta: 0}
  - {a: 135, alpha: 0, d: 0, theta: -90}
  - {a: 0, alpha: -90, d: 113.6, theta: 180}
" };
    ur_without_flange_y 5 PositionAxis(Y) { yaml = "
# a UR5 without joint 6 that points with y
name: ur_without_flange_y
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.0892, theta: 0}
  - {a: -0.425, alpha: 0, d: 0, theta: 0}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
tool: {xyz: [0, 0, 0.08], rpy: [0, 0, 0]}
" };
    stanford_without_flange 5 PositionAxis(Z) { yaml = "
# a Stanford arm without joint 6
name: stanford_without_flange
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.412, theta: 0}
  - {a: 0, alpha: 90, d: 0.154, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: -90, limits: [0.3, 1.2]}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
" };
    stanford_with_torch 5 PositionAxis(Z) { yaml = "
# a Stanford arm without joint 6, a torch in place of it
name: stanford_with_torch
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.412, theta: 0}
  - {a: 0, alpha: 90, d: 0.154, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: -90, limits: [0.3, 1.2]}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
tool: {xyz: [0, 0, 0.12], rpy: [0, 0, 0]}
" };
    gantry_with_two_axes 5 PositionAxis(Z) { yaml = "
# PPPRR: a gantry with a two-axis head
name: gantry_with_two_axes
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0.3, theta: 0, limits: [0, 1]}
  - {type: prismatic, a: 0, alpha: -90, d: 0.2, theta: -90, limits: [0, 1]}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 1]}
  - {a: 0, alpha: -90, d: 0.1, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
tool: {xyz: [0.1, 0, 0.1], rpy: [0, 45, 0]}
" };
    pitches_and_offset_axis 5 PositionAxis(Z) { yaml = "
# yaw, three pitch joints and a roll whose tool stands beside its axis: a quartic; families of solutions cross where axis 5 is axis 1
name: pitches_and_offset_axis
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0.05, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 90}
  - {a: 0.25, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 90}
  - {a: 0, alpha: 90, d: 0.15, theta: 0}
base: {xyz: [0, 0, 0], rpy: [30, -45, 60]}
tool: {xyz: [0.1, 0, 0], rpy: [0, 0, 0]}
" };
    rail_and_four 5 PositionAxis(Z) { yaml = "
# a rail with yaw and three pitch joints: a stretched elbow leaves a free joint one place
name: rail_and_four
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 90, limits: [0, 0.893]}
  - {a: 0.05, alpha: 90, d: 0.31, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.25, alpha: 0, d: 0.05, theta: 0}
  - {a: 0.1, alpha: -90, d: 0, theta: 0}
" };
    flipped_rrprr 5 PositionAxis(X) { yaml = "
# RRPRR: two axes turned against each other, then a slide
name: flipped_rrprr
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: x, require: true}
joints:
  - {a: 0.25, alpha: 180, d: 0.2, theta: 0}
  - {a: 0.2, alpha: -90, d: 0, theta: 30}
  - {type: prismatic, a: -0.15, alpha: -90, d: 0.25, theta: 30}
  - {a: 0.1, alpha: -90, d: 0, theta: 30}
  - {a: 0, alpha: 180, d: 0.25, theta: -90}
" };
}
