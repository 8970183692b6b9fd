//! Arms of four and five joints that are asked for a whole pose.

arms! {
    cobra600_rrpr 4 Pose { spec = "../specs/cobra600_rrpr.yaml" };
    scara_rrrp_325_275 4 Pose { spec = "../specs/scara_rrrp_325_275.yaml" };
    kuka_youbot 5 Pose { spec = "../specs/kuka_youbot.yaml" };
    scorbot_er5 5 Pose { spec = "../specs/scorbot_er5.yaml" };
    scara_rrpr_mounted 4 Pose { yaml = "
# a SCARA with base and tool
name: scara_rrpr_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.325, alpha: 0, d: 0.387, theta: 0}
  - {a: 0.275, alpha: 180, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 0.21]}
  - {a: 0, alpha: 0, d: 0, theta: 0}
base: {xyz: [0.098, 0.389, 0.369], rpy: [123, -46.7, 2]}
tool: {xyz: [-0.283, 0.376, 0.227], rpy: [-87.5, -14.3, 61.7]}
" };
    scara_rrrp_mounted 4 Pose { yaml = "
# a SCARA, the slide last, with base and tool
name: scara_rrrp_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.325, alpha: 0, d: 0.1, theta: 0}
  - {a: 0.275, alpha: 0, d: 0, theta: 20}
  - {a: 0.04, alpha: 180, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.2]}
base: {xyz: [0.267, -0.226, 0.123], rpy: [-122.6, -66.5, 69.3]}
tool: {xyz: [0.281, -0.023, 0.079], rpy: [166.9, 11.9, 115.9]}
" };
    scara_prrr 4 Pose { yaml = "
# a SCARA, the slide first
name: scara_prrr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 1]}
  - {a: 0.325, alpha: 0, d: 0, theta: 0}
  - {a: 0.275, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 180, d: 0.1, theta: 0}
" };
    scara_rprr 4 Pose { yaml = "
# a SCARA, the slide second
name: scara_rprr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.325, alpha: 0, d: 0.2, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 0.5]}
  - {a: 0.275, alpha: 0, d: 0, theta: 0}
  - {a: 0.02, alpha: 0, d: 0.1, theta: 30}
" };
    youbot_mounted 5 Pose { yaml = "
# KUKA youBot with base and tool
name: youbot_mounted
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 0, d: 115, theta: 0}
  - {a: 33, alpha: -90, d: 0, theta: -90}
  - {a: 155, alpha: 0, d: 0, theta: 0}
  - {a: 135, alpha: 0, d: 0, theta: -90}
  - {a: 0, alpha: -90, d: 113.6, theta: 180}
base: {xyz: [100, -250, 80], rpy: [10, -35, 120]}
tool: {xyz: [15, -20, 30], rpy: [50, 20, -70]}
" };
    scorbot_offsets 5 Pose { yaml = "
# yaw, three pitches and roll, with offsets
name: scorbot_offsets
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.05, alpha: -90, d: 0.349, theta: 10}
  - {a: 0.221, alpha: 0, d: 0.03, theta: -15}
  - {a: 0.2, alpha: 180, d: 0, theta: 0}
  - {a: 0.02, alpha: 90, d: 0.01, theta: -90}
  - {a: 0, alpha: 0, d: 0.145, theta: 0}
" };
    gantry_pppr 4 Pose { yaml = "
# PPPR: a gantry with a tool that turns
name: gantry_pppr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90, limits: [0, 1.2]}
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 90, limits: [-0.4, 0.4]}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 0.3]}
  - {a: 0.05, alpha: 180, d: 0.1, theta: 30}
tool: {xyz: [0.1, -0.05, 0.08], rpy: [20, 50, -110]}
" };
    table_rppp 4 Pose { yaml = "
# RPPP: a turntable under a skewed gantry
name: table_rppp
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.2, theta: 0}
  - {type: prismatic, a: 0, alpha: 60, d: 0, theta: 90, limits: [-0.5, 0.5]}
  - {type: prismatic, a: 0.1, alpha: 90, d: 0.1, theta: 90, limits: [0, 0.6]}
  - {type: prismatic, a: 0.05, alpha: 0, d: 0, theta: 0, limits: [0.1, 0.4]}
base: {xyz: [0.2, 0.1, -0.3], rpy: [35, -20, 80]}
" };
    cylindrical_rppr 4 Pose { yaml = "
# RPPR: a column, a beam, and a tool that turns about the vertical
name: cylindrical_rppr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.04, alpha: 0, d: 0.3, theta: 0}
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 0, limits: [0, 0.8]}
  - {type: prismatic, a: 0.03, alpha: 90, d: 0.2, theta: 0, limits: [0, 0.5]}
  - {a: 0.06, alpha: 180, d: 0.1, theta: 0}
base: {xyz: [0.1, 0.2, 0.3], rpy: [10, 60, -35]}
" };
    rail_prpr 4 Pose { yaml = "
# PRPR: a rail, a turntable, a beam across it and a tool that turns; the beam lifts
name: rail_prpr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 0, limits: [-1, 1]}
  - {a: 0.2, alpha: 0, d: 0.1, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 20, limits: [0, 0.6]}
  - {a: 0.15, alpha: -90, d: 0.05, theta: 0}
" };
    rail_pprr 4 Pose { yaml = "
# PPRR: a rail that a lift stands on, and two links
name: rail_pprr
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90, limits: [0, 2]}
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 0, limits: [0, 0.5]}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.2, alpha: 180, d: 0.1, theta: 0}
tool: {xyz: [0.05, 0, 0.1], rpy: [0, 0, 45]}
" };
    hanging_rprp 4 Pose { yaml = "
# RPRP: a beam that turns, with an elbow and a stroke at its end
name: hanging_rprp
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.5, theta: 0}
  - {type: prismatic, a: 0, alpha: -90, d: 0.3, theta: 0, limits: [0, 0.7]}
  - {a: 0.2, alpha: 180, d: 0, theta: -40}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.2]}
" };
    flipped_prrp 4 Pose { yaml = "
# PRRP: the second turning axis against the first
name: flipped_prrp
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.2, alpha: 180, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0}
" };
    flipped_rrpp 4 Pose { yaml = "
# RRPP: the second turning axis against the first
name: flipped_rrpp
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.2, alpha: 180, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 0}
" };
}
