//! Made-up arms with prismatic joints beside three axes that meet.

/// Calls `$with!` with every arm of this page: test name, type, joints, `inverse`, attribute.
#[macro_export]
macro_rules! sliding_arms {
    ($with:ident) => {
        $with! {
            rrprrr_meet_456 RrprrrMeet456 6 inverse { yaml = "
# RRPRRR, axes 4, 5, 6 meet
name: rrprrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.151, alpha: 115.8, d: 0.351, theta: -6.3}
  - {a: -0.436, alpha: -77.2, d: -0.259, theta: 89.9}
  - {type: prismatic, a: -0.306, alpha: 106, d: -0.339, theta: 24.8, limits: [-0.18, 0.71]}
  - {a: 0, alpha: -129.9, d: 0.149, theta: 108.3}
  - {a: 0, alpha: -114.8, d: 0, theta: -20}
  - {a: 0.227, alpha: 146.4, d: 0.236, theta: -169.1}
" };
            rprrrr_meet_456 RprrrrMeet456 6 inverse { yaml = "
# RPRRRR, axes 4, 5, 6 meet
name: rprrrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.383, alpha: 143.1, d: 0.274, theta: 42.2}
  - {type: prismatic, a: -0.291, alpha: -137, d: -0.37, theta: -84.2, limits: [-0.11, 0.5]}
  - {a: -0.291, alpha: -25.7, d: 0.161, theta: 119.9}
  - {a: 0, alpha: -109.5, d: -0.396, theta: -142}
  - {a: 0, alpha: -144.3, d: 0, theta: 88.3}
  - {a: -0.242, alpha: 127.9, d: 0.346, theta: 43.5}
" };
            prrrrr_meet_456 PrrrrrMeet456 6 inverse { yaml = "
# PRRRRR, axes 4, 5, 6 meet
name: prrrrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: -0.096, alpha: -23.8, d: -0.33, theta: -6.8, limits: [-0.31, 0.47]}
  - {a: 0.324, alpha: -45.3, d: 0.39, theta: 167}
  - {a: 0.203, alpha: 53.7, d: -0.271, theta: -168.1}
  - {a: 0, alpha: 103.2, d: 0.204, theta: 109.2}
  - {a: 0, alpha: -71.5, d: 0, theta: 100.9}
  - {a: -0.183, alpha: -28.1, d: -0.119, theta: 104.5}
" };
            pprrrr_meet_456 PprrrrMeet456 6 inverse { yaml = "
# PPRRRR, axes 4, 5, 6 meet
name: pprrrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.174, alpha: -145.3, d: 0.252, theta: -126.4, limits: [-0.11, 1.01]}
  - {type: prismatic, a: 0.403, alpha: 116.5, d: -0.368, theta: -91.9, limits: [-0.21, 0.46]}
  - {a: -0.351, alpha: 30.2, d: -0.348, theta: 74.7}
  - {a: 0, alpha: 37.3, d: 0.092, theta: -126.4}
  - {a: 0, alpha: -41.3, d: 0, theta: 164.2}
  - {a: 0.337, alpha: 143.1, d: -0.313, theta: -111.5}
" };
            prprrr_meet_456 PrprrrMeet456 6 inverse { yaml = "
# PRPRRR, axes 4, 5, 6 meet
name: prprrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: -0.086, alpha: 116.9, d: -0.103, theta: 25.2, limits: [0.03, 0.76]}
  - {a: 0.102, alpha: 110.5, d: 0.332, theta: 95.2}
  - {type: prismatic, a: -0.178, alpha: 127.3, d: -0.139, theta: -53.1, limits: [0.04, 1.09]}
  - {a: 0, alpha: -132.4, d: 0.342, theta: -21.4}
  - {a: 0, alpha: 40.1, d: 0, theta: -9.6}
  - {a: -0.284, alpha: 34.5, d: 0.232, theta: -166}
" };
            rpprrr_meet_456 RpprrrMeet456 6 inverse { yaml = "
# RPPRRR, axes 4, 5, 6 meet
name: rpprrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.197, alpha: -79.8, d: -0.176, theta: 29.8}
  - {type: prismatic, a: 0.313, alpha: -83, d: 0.147, theta: -115.5, limits: [-0.27, 0.82]}
  - {type: prismatic, a: -0.254, alpha: -45.3, d: -0.367, theta: -25.5, limits: [-0.12, 0.92]}
  - {a: 0, alpha: -144.2, d: -0.214, theta: 53.8}
  - {a: 0, alpha: -97.9, d: 0, theta: 164.2}
  - {a: -0.448, alpha: 131.8, d: 0.381, theta: -149}
" };
            ppprrr_meet_456 PpprrrMeet456 6 inverse { yaml = "
# PPPRRR, axes 4, 5, 6 meet
name: ppprrr_meet_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: -0.216, alpha: 63.8, d: -0.318, theta: 54.2, limits: [-0.37, 0.26]}
  - {type: prismatic, a: -0.174, alpha: -137.1, d: 0.365, theta: -119.1, limits: [-0.33, 0.47]}
  - {type: prismatic, a: -0.373, alpha: 111.3, d: -0.136, theta: 1.9, limits: [-0.05, 0.96]}
  - {a: 0, alpha: 31.8, d: -0.206, theta: 138.1}
  - {a: 0, alpha: 149.8, d: 0, theta: -164.8}
  - {a: -0.442, alpha: -51.6, d: 0.283, theta: -155.9}
" };
            rrrprr_meet_123 RrrprrMeet123 6 inverse { yaml = "
# RRRPRR, axes 1, 2, 3 meet
name: rrrprr_meet_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 97.3, d: -0.304, theta: -19.9}
  - {a: 0, alpha: 63.6, d: 0, theta: 107.5}
  - {a: 0.142, alpha: 45.9, d: 0.171, theta: 31.9}
  - {type: prismatic, a: -0.194, alpha: -129.1, d: -0.29, theta: 128.4, limits: [0, 0.7]}
  - {a: 0.19, alpha: -64.2, d: 0.288, theta: 0.1}
  - {a: -0.145, alpha: 142.7, d: 0.339, theta: 30}
" };
            rrrrpr_meet_123 RrrrprMeet123 6 inverse { yaml = "
# RRRRPR, axes 1, 2, 3 meet
name: rrrrpr_meet_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 28.8, d: 0.364, theta: -66.7}
  - {a: 0, alpha: -153.3, d: 0, theta: 75.6}
  - {a: -0.174, alpha: -76.1, d: 0.354, theta: 12.1}
  - {a: 0.368, alpha: -22.1, d: -0.354, theta: -121}
  - {type: prismatic, a: 0.314, alpha: 52.2, d: 0.383, theta: 84.4, limits: [-0.33, 0.37]}
  - {a: -0.112, alpha: 21.5, d: -0.173, theta: -60.9}
" };
            rrrrrp_meet_123 RrrrrpMeet123 6 inverse { yaml = "
# RRRRRP, axes 1, 2, 3 meet
name: rrrrrp_meet_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 23.1, d: 0.308, theta: -129.3}
  - {a: 0, alpha: -158.3, d: 0, theta: 120.3}
  - {a: 0.285, alpha: -33.4, d: -0.302, theta: -39.5}
  - {a: -0.228, alpha: -59.6, d: 0.212, theta: -133.2}
  - {a: 0.387, alpha: 151.9, d: -0.212, theta: 134}
  - {type: prismatic, a: 0.26, alpha: 74, d: 0.289, theta: 103.2, limits: [0.01, 0.87]}
" };
            rrrppp_meet_123 RrrpppMeet123 6 inverse { yaml = "
# RRRPPP, axes 1, 2, 3 meet
name: rrrppp_meet_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 25.3, d: -0.359, theta: -99.7}
  - {a: 0, alpha: 53.5, d: 0, theta: 84.4}
  - {a: 0.181, alpha: 142.4, d: -0.089, theta: -142.2}
  - {type: prismatic, a: 0.362, alpha: 49.3, d: -0.287, theta: -98.8, limits: [0.01, 1.11]}
  - {type: prismatic, a: 0.426, alpha: -96.1, d: 0.173, theta: -150.5, limits: [-0.14, 0.93]}
  - {type: prismatic, a: -0.441, alpha: 153.9, d: -0.235, theta: 120.9, limits: [0.1, 0.98]}
" };
            prrrrr_meet_234 PrrrrrMeet234 6 inverse { yaml = "
# PRRRRR, axes 2, 3, 4 meet
name: prrrrr_meet_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.212, alpha: 73.3, d: 0.366, theta: 44.7, limits: [-0.4, 0.51]}
  - {a: 0, alpha: 23.4, d: -0.27, theta: 135.5}
  - {a: 0, alpha: -122, d: 0, theta: -33.8}
  - {a: 0.224, alpha: -99.9, d: -0.365, theta: 138.1}
  - {a: 0.175, alpha: -136.9, d: -0.187, theta: -133.7}
  - {a: -0.359, alpha: 82.5, d: -0.136, theta: 71.2}
" };
            rrrrpr_meet_234 RrrrprMeet234 6 inverse { yaml = "
# RRRRPR, axes 2, 3, 4 meet
name: rrrrpr_meet_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.385, alpha: -51.1, d: 0.235, theta: 22.7}
  - {a: 0, alpha: -79.6, d: -0.357, theta: 33.1}
  - {a: 0, alpha: -68.9, d: 0, theta: 15.7}
  - {a: -0.204, alpha: 114.9, d: 0.276, theta: -160.6}
  - {type: prismatic, a: -0.327, alpha: 26.8, d: -0.38, theta: 86.6, limits: [0.02, 0.96]}
  - {a: -0.281, alpha: -156.9, d: 0.308, theta: 161.9}
" };
            rrrrrp_meet_234 RrrrrpMeet234 6 inverse { yaml = "
# RRRRRP, axes 2, 3, 4 meet
name: rrrrrp_meet_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.112, alpha: -101.1, d: 0.35, theta: -50.8}
  - {a: 0, alpha: -115.8, d: 0.32, theta: 156.9}
  - {a: 0, alpha: 79.1, d: 0, theta: 64.4}
  - {a: -0.202, alpha: 51.4, d: -0.291, theta: 18.3}
  - {a: -0.161, alpha: -48.6, d: 0.191, theta: 94.6}
  - {type: prismatic, a: 0.358, alpha: -106.3, d: -0.199, theta: 145.8, limits: [-0.3, 0.8]}
" };
            rprrrp_meet_345 RprrrpMeet345 6 inverse { yaml = "
# RPRRRP, axes 3, 4, 5 meet
name: rprrrp_meet_345
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.334, alpha: 158.8, d: -0.254, theta: 122.8}
  - {type: prismatic, a: -0.365, alpha: 105, d: 0.158, theta: -37.9, limits: [-0.32, 0.51]}
  - {a: 0, alpha: -112.2, d: 0.174, theta: 151.9}
  - {a: 0, alpha: -31.7, d: 0, theta: 46.5}
  - {a: -0.11, alpha: -146.7, d: -0.366, theta: 124.8}
  - {type: prismatic, a: -0.091, alpha: 29.8, d: -0.215, theta: -34.6, limits: [-0.21, 0.42]}
" };
            gantry_wrist GantryWrist 6 inverse { yaml = "
# three slides at right angles and a wrist
name: gantry_wrist
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90, limits: [-0.2, 1.5]}
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90, limits: [-0.2, 1.5]}
  - {type: prismatic, a: 0, alpha: 90, d: 0.2, theta: 0, limits: [-0.2, 1.5]}
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            prrrrr_meet_456_steep PrrrrrMeet456Steep 6 inverse { yaml = "
# PRRRRR, axes 4, 5, 6 meet; axes 1 and 2 nearly at right angles, so that the slide hardly shows along axis 2
name: prrrrr_meet_456_steep
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.316, alpha: -103.8, d: 0.262, theta: 39.9, limits: [-0.3, 0.15]}
  - {a: 0.3, alpha: 91.2, d: -0.268, theta: -54.9}
  - {a: -0.201, alpha: -98.6, d: 0.377, theta: -164.7}
  - {a: 0.429, alpha: -98.6, d: 0.302, theta: -153.6}
  - {a: 0, alpha: 57.1, d: 0, theta: -163.7}
  - {a: 0, alpha: -76.9, d: 0.111, theta: -69.6}
base: {xyz: [-0.018, -0.085, -0.104], rpy: [91.4, 132, -49.2]}
tool: {xyz: [0.016, -0.104, -0.16], rpy: [-85.6, 92.6, -96]}
" };
            rrrrrp_meet_123_square RrrrrpMeet123Square 6 inverse { yaml = "
# RRRRRP, axes 1, 2, 3 meet; three roots of the quartic meet on the grid of 45 degrees
name: rrrrrp_meet_123_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: -90, d: 0, theta: 180}
  - {a: 0, alpha: 45, d: 0, theta: 0}
  - {a: 0.1, alpha: 0, d: 0.1, theta: 0}
  - {a: -0.2, alpha: 90, d: -0.2, theta: -90}
  - {a: 0, alpha: 45, d: 0.2, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 0, d: -0.2, theta: 0, limits: [-0.3, 0.68]}
" };
            gantry_offset_wrist GantryOffsetWrist 6 inverse { yaml = "
# PPPRRR: a gantry whose wrist has offsets everywhere
name: gantry_offset_wrist
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 90, limits: [0, 1.2]}
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 90, limits: [-0.4, 0.4]}
  - {type: prismatic, a: 0.05, alpha: 35, d: 0, theta: 0, limits: [0, 0.5]}
  - {a: 0.1, alpha: 60, d: 0.1, theta: 0}
  - {a: 0.08, alpha: -70, d: 0.05, theta: 0}
  - {a: 0.02, alpha: 0, d: 0.15, theta: 0}
tool: {xyz: [0.05, 0.02, 0.1], rpy: [20, 0, 40]}
" };
            turned_slides TurnedSlides 6 inverse { yaml = "
# RRRPPP: three axes with offsets turn three slides at odd angles
name: turned_slides
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.1, alpha: -90, d: 0.05, theta: 0}
  - {a: 0.05, alpha: 30, d: 0.1, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 80, d: 0.1, theta: 20, limits: [0, 0.4]}
  - {type: prismatic, a: 0, alpha: 90, d: 0.1, theta: 70, limits: [-0.3, 0.3]}
  - {type: prismatic, a: 0.02, alpha: 0, d: 0.1, theta: 0, limits: [0, 0.3]}
" };
            slides_on_either_side SlidesOnEitherSide 6 inverse { yaml = "
# PPRRRP: slides on either side of three axes with offsets
name: slides_on_either_side
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, 1]}
  - {type: prismatic, a: 0.1, alpha: 90, d: 0, theta: 30, limits: [-0.5, 0.5]}
  - {a: 0.1, alpha: 80, d: 0.1, theta: 0}
  - {a: 0.2, alpha: 90, d: 0.05, theta: 0}
  - {a: 0.1, alpha: -90, d: 0.1, theta: 0}
  - {type: prismatic, a: 0.05, alpha: 40, d: 0.1, theta: 0, limits: [0, 0.4]}
tool: {xyz: [0.05, 0.02, 0.1], rpy: [20, 0, 40]}
" };
            slide_across_wrist SlideAcrossWrist 6 inverse { yaml = "
# PRRRRR, axes 2, 3, 4 meet; axis 1 is at right angles to axis 6 at many poses, where the first equation has no q1
name: slide_across_wrist
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0.182, theta: 0}
  - {a: 0, alpha: -60, d: 0.5244, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.175, alpha: -90, d: 0.304, theta: 90}
  - {a: 0.3283, alpha: -21.754, d: 0.141, theta: 180}
  - {a: 0.294, alpha: -45, d: 0.183, theta: -90}
" };
        }
    };
}
