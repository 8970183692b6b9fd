//! Made-up arms with three consecutive axes that are parallel.

/// Calls `$with!` with every arm of this page: test name, type, joints, `inverse`, attribute.
#[macro_export]
macro_rules! parallel_arms {
    ($with:ident) => {
        $with! {
            parallel_123_a Parallel123A 6 inverse { yaml = "
# axes 1, 2, 3 are parallel, everything else is skew
name: parallel_123_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.432, alpha: 0, d: -0.399, theta: 22.7}
  - {a: -0.424, alpha: 0, d: 0.337, theta: 37.1}
  - {a: -0.128, alpha: -134, d: 0.158, theta: 114.2}
  - {a: -0.297, alpha: -107.4, d: 0.2, theta: -38.3}
  - {a: 0.424, alpha: 143.3, d: 0.289, theta: -59.9}
  - {a: -0.38, alpha: -95.4, d: 0.154, theta: 70.3}
" };
            parallel_123_b Parallel123B 6 inverse { yaml = "
# axes 1, 2, 3 are parallel, everything else is skew
name: parallel_123_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.405, alpha: 0, d: 0.308, theta: -151.7}
  - {a: 0.386, alpha: 0, d: 0.11, theta: -158.9}
  - {a: 0.157, alpha: -22, d: -0.171, theta: 27.4}
  - {a: -0.296, alpha: 29.6, d: -0.196, theta: 74.3}
  - {a: 0.124, alpha: -48.1, d: 0.146, theta: 3.6}
  - {a: -0.116, alpha: -27.6, d: 0.314, theta: -160.8}
" };
            parallel_123_wall Parallel123Wall 6 inverse { yaml = "
# axes 1, 2, 3 are parallel, on a wall; the wrist's axes at right angles with offsets
name: parallel_123_wall
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
base: {xyz: [0, 0, 0.5], rpy: [0, 90, 0]}
joints:
  - {a: 0, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: 0, d: 0.1, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.1, alpha: 90, d: 0.2, theta: 0}
  - {a: 0.2, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.15, theta: 0}
" };
            parallel_234_a Parallel234A 6 inverse { yaml = "
# axes 2, 3, 4 are parallel, everything else is skew
name: parallel_234_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.339, alpha: 60.7, d: -0.312, theta: 125.8}
  - {a: 0.403, alpha: 0, d: 0.238, theta: -37.2}
  - {a: -0.407, alpha: 0, d: -0.371, theta: 119}
  - {a: -0.142, alpha: -152.1, d: -0.173, theta: 14.8}
  - {a: 0.204, alpha: 102.7, d: 0.189, theta: -43.7}
  - {a: -0.161, alpha: -145.6, d: -0.11, theta: 169.3}
" };
            parallel_234_b Parallel234B 6 inverse { yaml = "
# axes 2, 3, 4 are parallel, everything else is skew
name: parallel_234_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.28, alpha: -48.9, d: 0.281, theta: -101.3}
  - {a: 0.43, alpha: 0, d: -0.365, theta: -19.7}
  - {a: 0.438, alpha: 0, d: 0.141, theta: 113.6}
  - {a: -0.102, alpha: 79.4, d: 0.102, theta: 104.1}
  - {a: 0.31, alpha: -76.8, d: -0.251, theta: 92.1}
  - {a: 0.186, alpha: 104.4, d: -0.178, theta: 15.7}
" };
            parallel_345_a Parallel345A 6 inverse { yaml = "
# axes 3, 4, 5 are parallel, everything else is skew
name: parallel_345_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.393, alpha: -130.3, d: -0.167, theta: 110.3}
  - {a: 0.449, alpha: -41.7, d: -0.38, theta: -40.5}
  - {a: 0.167, alpha: 0, d: -0.145, theta: 1.8}
  - {a: -0.235, alpha: 0, d: -0.362, theta: 158.7}
  - {a: 0.433, alpha: 103.3, d: 0.15, theta: -74}
  - {a: -0.259, alpha: 68.8, d: 0.279, theta: -6}
" };
            parallel_345_b Parallel345B 6 inverse { yaml = "
# axes 3, 4, 5 are parallel, everything else is skew
name: parallel_345_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.328, alpha: 71.2, d: -0.322, theta: 95.1}
  - {a: -0.341, alpha: -30.7, d: 0.321, theta: 20.5}
  - {a: 0.269, alpha: 0, d: -0.346, theta: 39.7}
  - {a: 0.444, alpha: 0, d: -0.135, theta: -60.4}
  - {a: 0.35, alpha: 130.7, d: -0.151, theta: -125.5}
  - {a: -0.163, alpha: 112.3, d: -0.12, theta: 95.3}
" };
            parallel_456_a Parallel456A 6 inverse { yaml = "
# axes 4, 5, 6 are parallel, everything else is skew
name: parallel_456_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.435, alpha: -74.6, d: -0.326, theta: 17.4}
  - {a: 0.349, alpha: 40.6, d: 0.253, theta: 39.7}
  - {a: 0.278, alpha: -107.8, d: -0.308, theta: -121.7}
  - {a: -0.229, alpha: 0, d: -0.365, theta: 139.1}
  - {a: -0.103, alpha: 0, d: -0.123, theta: 137.5}
  - {a: -0.301, alpha: -99.9, d: 0.292, theta: -82.7}
" };
            parallel_456_b Parallel456B 6 inverse { yaml = "
# axes 4, 5, 6 are parallel, everything else is skew
name: parallel_456_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.395, alpha: 28.8, d: 0.327, theta: 93.9}
  - {a: 0.23, alpha: 129, d: -0.355, theta: 67.2}
  - {a: -0.198, alpha: -103.9, d: -0.354, theta: -159.5}
  - {a: -0.139, alpha: 0, d: -0.133, theta: 37.4}
  - {a: 0.288, alpha: 0, d: -0.288, theta: 114.8}
  - {a: -0.33, alpha: -145.2, d: 0.221, theta: -50.2}
" };
            parallel_123_square Parallel123Square 6 inverse { yaml = "
# axes 1, 2, 3 parallel, right angles
name: parallel_123_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.35, alpha: 0, d: 0.3, theta: 0}
  - {a: 0.3, alpha: 0, d: 0.1, theta: 0}
  - {a: 0.05, alpha: 90, d: 0.05, theta: 0}
  - {a: 0.1, alpha: 90, d: 0.2, theta: 0}
  - {a: 0.2, alpha: -90, d: 0.15, theta: 0}
  - {a: 0, alpha: 0, d: 0.08, theta: 0}
" };
            parallel_345_square Parallel345Square 6 inverse { yaml = "
# axes 3, 4, 5 parallel, right angles
name: parallel_345_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.05, alpha: 90, d: 0.2, theta: 0}
  - {a: 0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0.35, alpha: 0, d: 0.1, theta: 0}
  - {a: 0, alpha: 90, d: 0.12, theta: 0}
  - {a: 0, alpha: 0, d: 0.08, theta: 0}
" };
            parallel_456_square Parallel456Square 6 inverse { yaml = "
# axes 4, 5, 6 parallel, right angles
name: parallel_456_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.3, alpha: -90, d: 0.1, theta: 0}
  - {a: 0.05, alpha: 90, d: 0.2, theta: 0}
  - {a: 0.35, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: 0, d: 0.05, theta: 0}
  - {a: 0.04, alpha: 0, d: 0.1, theta: 0}
" };
            equal_links_parallel EqualLinksParallel 6 inverse { yaml = "
# a UR5 with equal links: the arm folds flat
name: equal_links_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.09, theta: 0}
  - {a: -0.4, alpha: 0, d: 0, theta: 0}
  - {a: -0.4, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.11, theta: 0}
  - {a: 0, alpha: -90, d: 0.095, theta: 0}
  - {a: 0, alpha: 0, d: 0.082, theta: 0}
" };
            flipped_234 Flipped234 6 inverse { yaml = "
# anti-parallel axes inside the run: twists of 180 degrees
name: flipped_234
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.1, theta: 0}
  - {a: 0.42, alpha: 180, d: 0.13, theta: 15}
  - {a: 0.38, alpha: 180, d: 0.02, theta: 0}
  - {a: 0, alpha: 90, d: 0.1, theta: -40}
  - {a: 0, alpha: -90, d: 0.095, theta: 0}
  - {a: 0.02, alpha: 0, d: 0.08, theta: 0}
" };
            flipped_123 Flipped123 6 inverse { yaml = "
# axes 1, 2, 3 parallel with twists of 180 degrees
name: flipped_123
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.4, alpha: 180, d: 0.2, theta: 0}
  - {a: 0.35, alpha: -180, d: 0.1, theta: 0}
  - {a: 0.1, alpha: 70, d: 0.3, theta: 0}
  - {a: 0.2, alpha: -55, d: -0.12, theta: 0}
  - {a: 0.1, alpha: 80, d: 0.2, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            modified_234 Modified234 6 inverse { yaml = "
# modified convention, axes 2, 3, 4 parallel
name: modified_234
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 0, d: 0.15, theta: 0}
  - {a: 0.05, alpha: 80, d: 0.02, theta: 30}
  - {a: 0.41, alpha: 0, d: 0, theta: -60}
  - {a: 0.36, alpha: 0, d: 0.12, theta: 0}
  - {a: 0.03, alpha: -75, d: 0.1, theta: 0}
  - {a: 0.02, alpha: 65, d: 0.09, theta: 45}
" };
            fixed_rows_parallel FixedRowsParallel 6 inverse { yaml = "
# constant rows inside the parallel run and in the wrist
name: fixed_rows_parallel
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.089159, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: 0.225, alpha: 0, d: 0.1, theta: 20}
  - {type: fixed, a: 0, alpha: 0, d: -0.1, theta: 0}
  - {a: 0.39225, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0}
  - {a: 0, alpha: -30, d: 0.09465, theta: 0}
  - {type: fixed, a: 0, alpha: -60, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0}
" };
            parallel_mm ParallelMm 6 inverse { yaml = "
# offsets along the parallel axes, lengths in mm
name: parallel_mm
convention: standard
units: {length: mm, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 89.159, theta: 0}
  - {a: -425.25, alpha: 0, d: 135.85, theta: -90}
  - {a: -392.5, alpha: 0, d: -119.7, theta: 0}
  - {a: 0, alpha: 90, d: 93, theta: -90}
  - {a: 0, alpha: -90, d: 94.65, theta: 0}
  - {a: 0, alpha: 0, d: 82.3, theta: 180}
" };
        }
    };
}
