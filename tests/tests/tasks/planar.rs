//! Arms in the plane.

arms! {
    planar2r 2 PlanarPosition { spec = "../specs/planar2r.yaml" };
    planar2r_unit 2 PlanarPosition { spec = "../specs/planar2r_unit.yaml" };
    planar3r 3 PlanarPose { spec = "../specs/planar3r.yaml" };
    planar4r_redundant 4 PlanarPose given 1 { spec = "../specs/planar4r_redundant.yaml" };
    planar4r_q2 4 PlanarPose given 2 { yaml = "
# planar4r_redundant with joint 2 given
name: planar4r_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, redundant: q2, require: true}
joints:
  - {a: 0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
    planar4r_q3 4 PlanarPose given 3 { yaml = "
# planar4r_redundant with joint 3 given
name: planar4r_q3
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, redundant: q3, require: true}
joints:
  - {a: 0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
    planar4r_q4 4 PlanarPose given 4 { yaml = "
# planar4r_redundant with joint 4 given
name: planar4r_q4
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, redundant: q4, require: true}
joints:
  - {a: 0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
    planar3r_mounted 3 PlanarPose { yaml = "
# planar 3R with base and tool
name: planar3r_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0.1, theta: 10}
  - {a: 0.15, alpha: 0, d: 0, theta: -20}
  - {a: 0.1, alpha: 0, d: -0.05, theta: 30}
base: {xyz: [0.3, -0.2, 0.4], rpy: [0, 0, 40]}
tool: {xyz: [0.1, 0.05, 0.02], rpy: [0, 0, -25]}
" };
    planar3r_upside_down 3 PlanarPose { yaml = "
# planar 3R hanging from the ceiling
name: planar3r_upside_down
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0.1, theta: 10}
  - {a: 0.15, alpha: 0, d: 0, theta: -20}
  - {a: 0.1, alpha: 0, d: -0.05, theta: 30}
base: {xyz: [0.3, -0.2, 0.4], rpy: [180, 0, 40]}
tool: {xyz: [0.1, 0.05, 0.02], rpy: [0, 0, -25]}
" };
    planar3r_antiparallel 3 PlanarPose { yaml = "
# planar 3R, the middle axis turned around
name: planar3r_antiparallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {a: 0.2, alpha: 180, d: 0, theta: 0}
  - {a: 0.15, alpha: 180, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
    planar2r_mounted 2 PlanarPosition { yaml = "
# planar 2R with base and tool
name: planar2r_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0.1, theta: 10}
  - {a: 0.15, alpha: 180, d: 0, theta: -20}
base: {xyz: [0.3, -0.2, 0.4], rpy: [0, 0, 40]}
tool: {xyz: [0.1, 0.05, 0.02], rpy: [0, 0, -25]}
" };
    planar2r_upside_down 2 PlanarPosition { yaml = "
# planar 2R hanging from the ceiling
name: planar2r_upside_down
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0.1, theta: 10}
  - {a: 0.15, alpha: 0, d: 0, theta: -20}
base: {xyz: [0.3, -0.2, 0.4], rpy: [180, 0, 40]}
tool: {xyz: [0.1, 0.05, 0.02], rpy: [0, 0, -25]}
" };
    planar_rpr 3 PlanarPose { yaml = "
# planar RPR
name: planar_rpr
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: -90, d: 0.2, theta: 0, limits: [0, 0.5]}
  - {a: 0.15, alpha: 0, d: 0, theta: 0}
" };
    planar_rrp 3 PlanarPose { yaml = "
# planar RRP
name: planar_rrp
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: -90, d: 0, theta: 20}
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 0, limits: [-0.1, 0.5]}
" };
    planar_prr 3 PlanarPose { yaml = "
# planar PRR
name: planar_prr
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 0, limits: [0, 1]}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
base: {xyz: [0, 0, 0], rpy: [-90, 0, 0]}
" };
    planar_rp 2 PlanarPosition { yaml = "
# planar RP
name: planar_rp
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: -90, d: 0.2, theta: 0, limits: [0, 0.5]}
" };
    planar_pr 2 PlanarPosition { yaml = "
# planar PR
name: planar_pr
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 0, limits: [0, 1]}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
base: {xyz: [0, 0, 0], rpy: [-90, 0, 0]}
" };
    planar3r_position_q1 3 PlanarPosition given 1 { yaml = "
# planar 3R that places a point, joint 1 given
name: planar3r_position_q1
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, redundant: q1, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {a: 0.15, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
    planar3r_position_q2 3 PlanarPosition given 2 { yaml = "
# planar 3R that places a point, joint 2 given
name: planar3r_position_q2
convention: standard
units: {length: m, angle: deg}
inverse: {task: planar_position, redundant: q2, require: true}
joints:
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {a: 0.15, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
" };
}
