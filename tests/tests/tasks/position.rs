//! Arms of three joints that place the tool point.

arms! {
    anthro3r 3 Position { spec = "../specs/anthro3r.yaml" };
    cartesian_ppp 3 Position { spec = "../specs/cartesian_ppp.yaml" };
    cylindrical_rpp 3 Position { spec = "../specs/cylindrical_rpp.yaml" };
    polar_rrp 3 Position { spec = "../specs/polar_rrp.yaml" };
    salman_rrr 3 Position { spec = "../specs/salman_rrr.yaml" };
    salman_rrr_table1 3 Position { spec = "../specs/salman_rrr_table1.yaml" };
    ppp_skew 3 Position { yaml = "
# PPP, nothing parallel, nothing meets
name: ppp_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: -0.429, alpha: -61.5, d: -0.218, theta: 161.2, limits: [-0.15, 0.48]}
  - {type: prismatic, a: 0.157, alpha: 76.2, d: -0.311, theta: -89.3, limits: [-0.38, 0.53]}
  - {type: prismatic, a: -0.215, alpha: -55, d: 0.23, theta: 7.3, limits: [-0.36, 0.62]}
" };
    rpp_skew 3 Position { yaml = "
# RPP, nothing parallel, nothing meets
name: rpp_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: -0.109, alpha: -137.8, d: 0.146, theta: 135.8}
  - {type: prismatic, a: 0.235, alpha: -81.1, d: -0.177, theta: 131.9, limits: [-0.31, 0.54]}
  - {type: prismatic, a: -0.269, alpha: 136.6, d: 0.306, theta: 108.2, limits: [-0.31, 0.5]}
" };
    prp_skew 3 Position { yaml = "
# PRP, nothing parallel, nothing meets
name: prp_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: 0.261, alpha: -153.5, d: 0.163, theta: 148.5, limits: [-0.18, 0.59]}
  - {a: 0.231, alpha: 65.8, d: -0.426, theta: -30.1}
  - {type: prismatic, a: -0.316, alpha: 92.4, d: 0.178, theta: -139.9, limits: [-0.33, 0.33]}
" };
    ppr_skew 3 Position { yaml = "
# PPR, nothing parallel, nothing meets
name: ppr_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: 0.207, alpha: -109.4, d: -0.449, theta: -115.3, limits: [-0.29, 0.74]}
  - {type: prismatic, a: 0.41, alpha: -140.6, d: 0.268, theta: 37.2, limits: [-0.31, 0.64]}
  - {a: 0.336, alpha: 33.1, d: -0.273, theta: -67.8}
" };
    rrp_skew 3 Position { yaml = "
# RRP, nothing parallel, nothing meets
name: rrp_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: -0.287, alpha: -115.7, d: -0.314, theta: -159.7}
  - {a: -0.17, alpha: -53.2, d: 0.204, theta: -79.5}
  - {type: prismatic, a: -0.441, alpha: -123.1, d: 0.435, theta: 164.3, limits: [-0.39, 0.74]}
" };
    rpr_skew 3 Position { yaml = "
# RPR, nothing parallel, nothing meets
name: rpr_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.173, alpha: -93.9, d: 0.375, theta: -27}
  - {type: prismatic, a: -0.406, alpha: -26.9, d: -0.383, theta: 104.2, limits: [-0.17, 0.46]}
  - {a: 0.172, alpha: -135.9, d: -0.299, theta: 5}
" };
    prr_skew 3 Position { yaml = "
# PRR, nothing parallel, nothing meets
name: prr_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: 0.367, alpha: 150.7, d: 0.332, theta: -40.5, limits: [-0.12, 0.7]}
  - {a: 0.224, alpha: -58.3, d: 0.313, theta: 65.6}
  - {a: 0.111, alpha: 145.7, d: -0.249, theta: -148.9}
" };
    rrr_skew 3 Position { yaml = "
# RRR, nothing parallel, nothing meets
name: rrr_skew
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.161, alpha: -43.8, d: -0.271, theta: 47.2}
  - {a: 0.282, alpha: 62.5, d: 0.139, theta: -72.9}
  - {a: -0.449, alpha: -71.3, d: 0.191, theta: -0.5}
" };
    prp_column 3 Position { yaml = "
# PRP, the column slides along the axis it turns about
name: prp_column
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: 0.1, alpha: 0, d: 0.2, theta: 0, limits: [0, 1]}
  - {a: 0.1, alpha: -90, d: 0.3, theta: 90}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.8]}
" };
    rpr_parallel 3 Position { yaml = "
# RPR, the slide along the first axis
name: rpr_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.3, alpha: 0, d: 0.2, theta: 0}
  - {type: prismatic, a: 0.25, alpha: 90, d: 0, theta: 0, limits: [-0.2, 0.4]}
  - {a: 0.35, alpha: 0, d: 0.1, theta: 0}
" };
    rrp_parallel 3 Position { yaml = "
# RRP, everything parallel: a SCARA without its wrist
name: rrp_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.3, alpha: 0, d: 0.4, theta: 0}
  - {a: 0.25, alpha: 180, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.4]}
" };
    prr_parallel 3 Position { yaml = "
# PRR, everything parallel
name: prr_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 0, limits: [0, 1]}
  - {a: 0.4, alpha: 0, d: 0.1, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
" };
    rpr_planar_arm 3 Position { yaml = "
# RPR at right angles
name: rpr_planar_arm
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.4, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 90, d: 0.2, theta: 90, limits: [0.1, 0.9]}
  - {a: 0.3, alpha: 0, d: 0.15, theta: 0}
" };
    rrr_first_meet 3 Position { yaml = "
# RRR, axes 1 and 2 meet
name: rrr_first_meet
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: 72.5, d: 0.3, theta: 10}
  - {a: 0.31, alpha: -48, d: 0, theta: 0}
  - {a: 0.27, alpha: 20, d: 0.11, theta: 35}
" };
    rrr_last_meet 3 Position { yaml = "
# RRR, axes 2 and 3 meet
name: rrr_last_meet
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.22, alpha: -64, d: 0.3, theta: 10}
  - {a: 0, alpha: 51, d: 0.2, theta: 0}
  - {a: 0.33, alpha: 0, d: 0.12, theta: 35}
" };
    rrr_first_parallel 3 Position { yaml = "
# RRR, axes 1 and 2 parallel
name: rrr_first_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.3, alpha: 0, d: 0.2, theta: 0}
  - {a: 0.25, alpha: 90, d: 0.1, theta: 20}
  - {a: 0.2, alpha: 0, d: -0.15, theta: 0}
" };
    rrr_orthogonal 3 Position { yaml = "
# RRR at right angles with offsets everywhere
name: rrr_orthogonal
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.2, theta: 0}
  - {a: 0.3, alpha: -90, d: 0.1, theta: 0}
  - {a: 0.25, alpha: 0, d: 0.05, theta: 0}
" };
    rrr_equal_links 3 Position { yaml = "
# RRR, the elbow folds the tool point onto the shoulder
name: rrr_equal_links
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: -90}
  - {a: 0.3, alpha: 0, d: 0, theta: 90}
" };
    rrr_antiparallel_mm 3 Position { yaml = "
# RRR, the forearm axis turned around; millimeters
name: rrr_antiparallel_mm
convention: standard
units: {length: mm, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: 90, d: 350, theta: 0}
  - {a: 300, alpha: 180, d: 40, theta: 0}
  - {a: 250, alpha: 0, d: -15, theta: 0}
" };
    rrr_modified 3 Position { yaml = "
# RRR in the modified convention
name: rrr_modified
convention: modified
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: 0, d: 0.3, theta: 0}
  - {a: 0.07, alpha: -90, d: 0.1, theta: -90}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
tool: {xyz: [0.25, 0.02, 0.04], rpy: [0, 90, 0]}
" };
    anthro3r_mounted 3 Position { yaml = "
# anthro3r with base and tool
name: anthro3r_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.35, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.25, alpha: 0, d: 0, theta: 0}
base: {xyz: [0.039, -0.245, -0.118], rpy: [-71.1, -0.2, 129.3]}
tool: {xyz: [-0.015, -0.049, 0.397], rpy: [-92.8, 80.3, 60.5]}
" };
    polar_rrp_mounted 3 Position { yaml = "
# polar_rrp with base and tool
name: polar_rrp_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.5, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0.1, theta: 0, limits: [0.2, 0.9]}
base: {xyz: [-0.161, -0.234, 0.265], rpy: [-17.4, -27.9, 77.8]}
tool: {xyz: [-0.28, -0.385, 0.028], rpy: [100.2, 2.4, 105.6]}
" };
    cylindrical_rpp_mounted 3 Position { yaml = "
# cylindrical_rpp with base and tool
name: cylindrical_rpp_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: 0, alpha: 0, d: 0.4, theta: 0}
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 0, limits: [0, 0.8]}
  - {type: prismatic, a: 0, alpha: 0, d: 0.2, theta: 0, limits: [0, 0.6]}
base: {xyz: [-0.196, 0.11, 0.032], rpy: [100.4, 60.8, 120.4]}
tool: {xyz: [-0.235, 0.172, -0.033], rpy: [-136.1, -76.8, -63.7]}
" };
    rrr_skew_mounted 3 Position { yaml = "
# RRR, nothing parallel, with base and tool
name: rrr_skew_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {a: -0.415, alpha: 87.7, d: -0.226, theta: 119.3}
  - {a: 0.357, alpha: -58.3, d: 0.235, theta: 142.5}
  - {a: 0.21, alpha: -91.4, d: -0.267, theta: 44.2}
base: {xyz: [0.342, -0.387, 0.332], rpy: [102.7, -16.8, -111.8]}
tool: {xyz: [-0.134, -0.368, 0.213], rpy: [13.9, -41.1, -17.4]}
" };
    ppp_skew_mounted 3 Position { yaml = "
# PPP with base and tool
name: ppp_skew_mounted
convention: standard
units: {length: m, angle: deg}
inverse: {task: position, require: true}
joints:
  - {type: prismatic, a: -0.161, alpha: 36.5, d: 0.34, theta: -31.4, limits: [-0.31, 0.45]}
  - {type: prismatic, a: -0.316, alpha: -134.4, d: 0.294, theta: -66.8, limits: [-0.16, 0.46]}
  - {type: prismatic, a: 0.243, alpha: -26, d: 0.113, theta: -38.5, limits: [-0.17, 0.75]}
base: {xyz: [0.197, -0.112, -0.078], rpy: [152.2, -43.8, 151.2]}
tool: {xyz: [-0.022, 0.348, 0.048], rpy: [-141.6, -41.2, -12.5]}
" };
}
