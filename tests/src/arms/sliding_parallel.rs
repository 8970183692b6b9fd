//! Made-up arms with a prismatic joint beside three parallel axes.

/// Calls `$with!` with every arm of this page: test name, type, joints, `inverse`, attribute.
#[macro_export]
macro_rules! sliding_parallel_arms {
    ($with:ident) => {
        $with! {
            prrrrr_parallel_234 PrrrrrParallel234 6 inverse { yaml = "
# PRRRRR, axes 2, 3, 4 are parallel
name: prrrrr_parallel_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.089, alpha: -67.7, d: -0.096, theta: 73.4, limits: [-0.13, 0.54]}
  - {a: 0.137, alpha: 0, d: -0.329, theta: -39.8}
  - {a: 0.184, alpha: 0, d: -0.257, theta: 40}
  - {a: -0.3, alpha: -54.6, d: -0.162, theta: 146.6}
  - {a: 0.379, alpha: -78.8, d: -0.238, theta: 86.8}
  - {a: 0.249, alpha: -35, d: -0.35, theta: 25.7}
" };
            rrrrpr_parallel_234 RrrrprParallel234 6 inverse { yaml = "
# RRRRPR, axes 2, 3, 4 are parallel
name: rrrrpr_parallel_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.335, alpha: 108.7, d: -0.277, theta: 150.6}
  - {a: 0.341, alpha: 0, d: -0.094, theta: -91.5}
  - {a: -0.186, alpha: 0, d: -0.361, theta: 31}
  - {a: 0.168, alpha: 42.6, d: 0.151, theta: 97.3}
  - {type: prismatic, a: -0.427, alpha: 43.6, d: -0.211, theta: 8.4, limits: [-0.15, 0.75]}
  - {a: 0.186, alpha: 157.7, d: -0.347, theta: 141.1}
" };
            rrrrrp_parallel_234 RrrrrpParallel234 6 inverse { yaml = "
# RRRRRP, axes 2, 3, 4 are parallel
name: rrrrrp_parallel_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.159, alpha: 126.5, d: -0.377, theta: -56.3}
  - {a: -0.3, alpha: 0, d: -0.268, theta: -39.3}
  - {a: -0.123, alpha: 0, d: 0.32, theta: 161.6}
  - {a: -0.405, alpha: 45.3, d: 0.178, theta: -147.4}
  - {a: 0.365, alpha: -127.4, d: 0.279, theta: 99.1}
  - {type: prismatic, a: -0.332, alpha: -115.8, d: 0.182, theta: -120.8, limits: [-0.15, 0.89]}
" };
            rrrprr_parallel_123 RrrprrParallel123 6 inverse { yaml = "
# RRRPRR, axes 1, 2, 3 are parallel
name: rrrprr_parallel_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.449, alpha: 0, d: -0.299, theta: 168.7}
  - {a: 0.206, alpha: 0, d: 0.394, theta: 153.1}
  - {a: -0.418, alpha: 134.3, d: 0.339, theta: 38.6}
  - {type: prismatic, a: 0.123, alpha: -125, d: -0.295, theta: 16.6, limits: [-0.23, 0.69]}
  - {a: 0.125, alpha: 103.6, d: -0.277, theta: -156.7}
  - {a: -0.267, alpha: 61.4, d: -0.314, theta: -41.7}
" };
            rrrrpr_parallel_123 RrrrprParallel123 6 inverse { yaml = "
# RRRRPR, axes 1, 2, 3 are parallel
name: rrrrpr_parallel_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.374, alpha: 0, d: 0.282, theta: -63.8}
  - {a: 0.41, alpha: 0, d: -0.216, theta: -4.9}
  - {a: -0.224, alpha: 31, d: 0.353, theta: 3.2}
  - {a: 0.371, alpha: 97.5, d: -0.174, theta: -123.9}
  - {type: prismatic, a: 0.313, alpha: -44.7, d: -0.143, theta: 141, limits: [-0.39, 0.67]}
  - {a: -0.369, alpha: -141.8, d: -0.163, theta: 169.1}
" };
            rrrrrp_parallel_123 RrrrrpParallel123 6 inverse { yaml = "
# RRRRRP, axes 1, 2, 3 are parallel
name: rrrrrp_parallel_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.253, alpha: 0, d: 0.271, theta: -84.1}
  - {a: -0.373, alpha: 0, d: -0.328, theta: 38.7}
  - {a: 0.105, alpha: 24, d: 0.21, theta: -125.8}
  - {a: 0.129, alpha: -44.7, d: -0.226, theta: 157.8}
  - {a: -0.122, alpha: 107.1, d: -0.214, theta: -141.3}
  - {type: prismatic, a: -0.087, alpha: -38.3, d: -0.117, theta: -107.9, limits: [-0.01, 1.11]}
" };
            prrrrr_parallel_456 PrrrrrParallel456 6 inverse { yaml = "
# PRRRRR, axes 4, 5, 6 are parallel
name: prrrrr_parallel_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: -0.358, alpha: -27.2, d: 0.343, theta: 13.5, limits: [0.05, 1.13]}
  - {a: 0.378, alpha: 111.5, d: -0.162, theta: 127.2}
  - {a: -0.125, alpha: -107.6, d: -0.229, theta: 64.3}
  - {a: 0.105, alpha: 0, d: -0.312, theta: 65}
  - {a: 0.311, alpha: 0, d: -0.395, theta: 62.8}
  - {a: 0.21, alpha: -136.9, d: -0.084, theta: 47.2}
" };
            rprrrr_parallel_456 RprrrrParallel456 6 inverse { yaml = "
# RPRRRR, axes 4, 5, 6 are parallel
name: rprrrr_parallel_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.37, alpha: -97.8, d: -0.122, theta: -87.2}
  - {type: prismatic, a: -0.252, alpha: -100.2, d: -0.263, theta: -109.5, limits: [-0.06, 0.76]}
  - {a: 0.435, alpha: -28.3, d: -0.291, theta: 51.9}
  - {a: 0.357, alpha: 0, d: 0.169, theta: 115.7}
  - {a: -0.224, alpha: 0, d: 0.396, theta: 62.7}
  - {a: 0.32, alpha: 143.1, d: -0.164, theta: -40.7}
" };
            rrprrr_parallel_456 RrprrrParallel456 6 inverse { yaml = "
# RRPRRR, axes 4, 5, 6 are parallel
name: rrprrr_parallel_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.11, alpha: 77.4, d: 0.388, theta: 19.1}
  - {a: -0.388, alpha: 97.8, d: -0.359, theta: -24.1}
  - {type: prismatic, a: 0.378, alpha: 51.8, d: 0.174, theta: -155.6, limits: [-0.34, 0.36]}
  - {a: 0.411, alpha: 0, d: -0.215, theta: -101.3}
  - {a: 0.287, alpha: 0, d: -0.091, theta: -123.9}
  - {a: -0.216, alpha: 33.9, d: -0.398, theta: 35.5}
" };
            prrrrr_parallel_345 PrrrrrParallel345 6 inverse { yaml = "
# PRRRRR, axes 3, 4, 5 are parallel
name: prrrrr_parallel_345
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.324, alpha: -128.6, d: -0.313, theta: -19.6, limits: [-0.08, 0.88]}
  - {a: 0.1, alpha: -126.4, d: 0.127, theta: -148.2}
  - {a: -0.385, alpha: 0, d: -0.218, theta: 22.4}
  - {a: -0.199, alpha: 0, d: 0.131, theta: 59.4}
  - {a: -0.096, alpha: -55.6, d: 0.368, theta: 149.4}
  - {a: -0.097, alpha: 153.3, d: 0.332, theta: -10.2}
" };
            rprrrr_parallel_345 RprrrrParallel345 6 inverse { yaml = "
# RPRRRR, axes 3, 4, 5 are parallel
name: rprrrr_parallel_345
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.388, alpha: -154.3, d: -0.348, theta: 165.8}
  - {type: prismatic, a: 0.411, alpha: 52.4, d: 0.2, theta: -11, limits: [-0.05, 0.86]}
  - {a: 0.086, alpha: 0, d: 0.266, theta: 7.7}
  - {a: 0.41, alpha: 0, d: -0.296, theta: 55.5}
  - {a: -0.169, alpha: -138, d: -0.234, theta: 91.3}
  - {a: -0.159, alpha: -84.9, d: -0.207, theta: -149.7}
" };
            rrrrrp_parallel_345 RrrrrpParallel345 6 inverse { yaml = "
# RRRRRP, axes 3, 4, 5 are parallel
name: rrrrrp_parallel_345
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.181, alpha: 109.5, d: -0.153, theta: -56.5}
  - {a: 0.138, alpha: 47.5, d: 0.32, theta: -112.4}
  - {a: -0.347, alpha: 0, d: 0.265, theta: 27.7}
  - {a: 0.436, alpha: 0, d: -0.239, theta: 8.3}
  - {a: -0.13, alpha: 96.8, d: -0.109, theta: 109.3}
  - {type: prismatic, a: -0.256, alpha: 127.1, d: -0.217, theta: -97.5, limits: [-0.27, 0.82]}
" };
            ur_on_a_rail UrOnARail 6 inverse { yaml = "
# a slide along the parallel axes takes the place of the waist
name: ur_on_a_rail
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0.1, alpha: 0, d: 0, theta: 0, limits: [-1, 2]}
  - {a: 0.425, alpha: 0, d: 0.13, theta: 0}
  - {a: 0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0}
" };
            rrrrrp_parallel_123_square RrrrrpParallel123Square 6 inverse { yaml = "
# RRRRRP, axes 1, 2, 3 are parallel, and so is axis 5 where q4 = 0
name: rrrrrp_parallel_123_square
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.2, alpha: 0, d: 0.3, theta: 0}
  - {a: 0.2, alpha: 0, d: 0.1, theta: 90}
  - {a: 0.4, alpha: 90, d: 0.2, theta: 0}
  - {a: -0.2, alpha: -90, d: 0.2, theta: 90}
  - {type: prismatic, a: 0.4, alpha: 180, d: 0.3, theta: 180, limits: [0, 0.78]}
base: {xyz: [0.24, 0.125, 0.069], rpy: [90, 180, 90]}
tool: {xyz: [0.178, 0.188, -0.249], rpy: [-90, 180, 90]}
" };
            rrrrrp_parallel_234_square RrrrrpParallel234Square 6 inverse { yaml = "
# RRRRRP, axes 2, 3, 4 are parallel, axes 1 and 5 where the sum of q2, q3, q4 is 0
name: rrrrrp_parallel_234_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.4, alpha: 90, d: 0.1, theta: -90}
  - {a: 0.4, alpha: 0, d: 0, theta: 180}
  - {a: 0.3, alpha: 0, d: 0.4, theta: 0}
  - {a: 0.2, alpha: -90, d: 0.1, theta: 0}
  - {a: -0.2, alpha: 90, d: 0.1, theta: 90}
  - {type: prismatic, a: 0.1, alpha: 0, d: 0.3, theta: 180, limits: [0, 0.78]}
base: {xyz: [0.032, -0.155, 0.29], rpy: [45, 180, 180]}
tool: {xyz: [0.009, -0.21, 0.298], rpy: [0, 90, 0]}
" };
            rail_to_stretch RailToStretch 6 inverse { yaml = "
# PRRRRR, a rail whose stretched elbow leaves a free joint one place
name: rail_to_stretch
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 90, limits: [0, 0.893]}
  - {a: 0, alpha: 90, d: 0.31, theta: 0}
  - {a: 0.741, alpha: 0, d: 0, theta: 0}
  - {a: 0.688, alpha: 0, d: 0.1, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.128, theta: 0}
tool: {xyz: [-0.091, 0.041, 0.194], rpy: [0, 45, 0]}
" };
            slide_flip_123 SlideFlip123 6 inverse { yaml = "
# PRRRRR, a slide and two axes turned against each other, then a wrist with offsets
name: slide_flip_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: prismatic, a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.3, alpha: 180, d: 0, theta: 0}
  - {a: 0.1, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.1, alpha: -90, d: 0.3, theta: 0}
  - {a: 0, alpha: 90, d: 0.1, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            slide_flip_234 SlideFlip234 6 inverse { yaml = "
# RRRPRR, two axes turned against each other and a slide: a quartic
name: slide_flip_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 180, d: 0.1, theta: 0}
  - {a: 0.1, alpha: 90, d: 0, theta: 90}
  - {type: prismatic, a: 0.1, alpha: 60, d: 0.2, theta: 0}
  - {a: 0.1, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.05, alpha: 0, d: 0.1, theta: 0}
" };
            slide_flip_456 SlideFlip456 6 inverse { yaml = "
# RRRPRR, a slide and two axes turned against each other at the end
name: slide_flip_456
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.1, alpha: 60, d: 0.1, theta: 0}
  - {a: 0.1, alpha: 90, d: 0.1, theta: 0}
  - {type: prismatic, a: 0.1, alpha: 90, d: 0.1, theta: 90}
  - {a: 0.2, alpha: 180, d: 0.1, theta: 0}
  - {a: 0.05, alpha: 0, d: 0.1, theta: 0}
" };
        }
    };
}
