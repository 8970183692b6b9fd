//! Made-up arms with three consecutive axes that meet in a point.

/// Calls `$with!` with every arm of this page: test name, type, joints, `inverse`, attribute.
#[macro_export]
macro_rules! meeting_arms {
    ($with:ident) => {
        $with! {
            meet_123_a Meet123A 6 inverse { yaml = "
# axes 1, 2, 3 meet, everything else is skew
name: meet_123_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 153.6, d: 0.113, theta: -143.2}
  - {a: 0, alpha: 76.1, d: 0, theta: 93.6}
  - {a: -0.13, alpha: 58.8, d: 0.166, theta: -17.9}
  - {a: 0.132, alpha: -64.8, d: 0.263, theta: 67.6}
  - {a: -0.159, alpha: -47.2, d: 0.186, theta: -49.8}
  - {a: -0.163, alpha: -76, d: -0.095, theta: 44.7}
" };
            meet_123_b Meet123B 6 inverse { yaml = "
# axes 1, 2, 3 meet, everything else is skew
name: meet_123_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 153.7, d: -0.101, theta: -93.3}
  - {a: 0, alpha: 150.1, d: 0, theta: -15}
  - {a: -0.372, alpha: -57.7, d: -0.194, theta: -66.7}
  - {a: 0.297, alpha: 144.3, d: -0.094, theta: -84.6}
  - {a: -0.096, alpha: -158.7, d: 0.232, theta: 128.5}
  - {a: -0.219, alpha: 99.4, d: 0.175, theta: -155}
" };
            meet_234_a Meet234A 6 inverse { yaml = "
# axes 2, 3, 4 meet, everything else is skew
name: meet_234_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.146, alpha: 113.2, d: 0.397, theta: -148.9}
  - {a: 0, alpha: -101.4, d: -0.114, theta: -158.9}
  - {a: 0, alpha: 137.7, d: 0, theta: 44.3}
  - {a: -0.384, alpha: -67.1, d: -0.259, theta: -121.5}
  - {a: -0.437, alpha: 101.2, d: -0.122, theta: -133.6}
  - {a: -0.264, alpha: 140.7, d: -0.113, theta: 90}
" };
            meet_234_b Meet234B 6 inverse { yaml = "
# axes 2, 3, 4 meet, everything else is skew
name: meet_234_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.356, alpha: -150.7, d: 0.144, theta: 90}
  - {a: 0, alpha: 25.7, d: -0.396, theta: 6.5}
  - {a: 0, alpha: 108.3, d: 0, theta: 33}
  - {a: 0.291, alpha: -111.7, d: -0.343, theta: 70.3}
  - {a: 0.164, alpha: -157.2, d: 0.127, theta: 21}
  - {a: -0.096, alpha: -75.1, d: -0.299, theta: 82.4}
" };
            meet_345_a Meet345A 6 inverse { yaml = "
# axes 3, 4, 5 meet, everything else is skew
name: meet_345_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.103, alpha: 53, d: 0.243, theta: 162.8}
  - {a: 0.355, alpha: -105.8, d: 0.109, theta: 30.9}
  - {a: 0, alpha: 99.8, d: -0.099, theta: -163.5}
  - {a: 0, alpha: 144, d: 0, theta: -17.6}
  - {a: 0.134, alpha: 63.7, d: -0.336, theta: 169.4}
  - {a: 0.419, alpha: -43.8, d: -0.157, theta: 35.1}
" };
            meet_345_b Meet345B 6 inverse { yaml = "
# axes 3, 4, 5 meet, everything else is skew
name: meet_345_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.338, alpha: 53.7, d: 0.133, theta: 154.1}
  - {a: -0.231, alpha: -146.7, d: -0.341, theta: -68.6}
  - {a: 0, alpha: -59.9, d: 0.245, theta: 167.8}
  - {a: 0, alpha: 53, d: 0, theta: 96.8}
  - {a: -0.259, alpha: -147.5, d: -0.303, theta: -55.8}
  - {a: 0.172, alpha: 135.2, d: 0.197, theta: 56.9}
" };
            meet_456_a Meet456A 6 inverse { yaml = "
# axes 4, 5, 6 meet, everything else is skew
name: meet_456_a
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: -0.295, alpha: -24.2, d: 0.289, theta: -96.2}
  - {a: 0.296, alpha: -84.8, d: -0.248, theta: -22.8}
  - {a: -0.208, alpha: -158.1, d: 0.177, theta: 142.7}
  - {a: 0, alpha: 21, d: 0.316, theta: 82.5}
  - {a: 0, alpha: 136.3, d: 0, theta: 118.3}
  - {a: -0.131, alpha: -81.3, d: -0.202, theta: 138.4}
" };
            meet_456_b Meet456B 6 inverse { yaml = "
# axes 4, 5, 6 meet, everything else is skew
name: meet_456_b
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.435, alpha: -71, d: 0.293, theta: -36.5}
  - {a: -0.405, alpha: -62.8, d: 0.282, theta: -107.4}
  - {a: -0.13, alpha: 45.5, d: 0.292, theta: -136}
  - {a: 0, alpha: -36.4, d: 0.12, theta: 131.1}
  - {a: 0, alpha: -27.7, d: 0, theta: 140.8}
  - {a: -0.232, alpha: -108.4, d: 0.198, theta: 99.7}
" };
            meet_123_square Meet123Square 6 inverse { yaml = "
# a wrist at the base, right angles
name: meet_123_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.2, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0.3, alpha: 90, d: 0.15, theta: 0}
  - {a: 0.05, alpha: -90, d: 0.12, theta: 0}
  - {a: 0.25, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            meet_234_square Meet234Square 6 inverse { yaml = "
# axes 2, 3, 4 meet, right angles
name: meet_234_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.2, alpha: 90, d: 0.35, theta: 0}
  - {a: 0, alpha: 90, d: 0.1, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0.3, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.1, alpha: -90, d: 0.12, theta: 0}
  - {a: 0, alpha: 0, d: 0.08, theta: 0}
" };
            meet_345_square Meet345Square 6 inverse { yaml = "
# axes 3, 4, 5 meet, right angles
name: meet_345_square
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: -90, d: 0.4, theta: 0}
  - {a: 0.4, alpha: 90, d: 0.12, theta: 0}
  - {a: 0, alpha: -90, d: 0.2, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.15, alpha: -90, d: 0.3, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            wrist_60_60 Wrist6060 6 inverse { yaml = "
# wrist with twists of 60 degrees
name: wrist_60_60
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.05, alpha: 90, d: 0.3, theta: 0}
  - {a: 0.4, alpha: 0, d: 0.02, theta: 0}
  - {a: 0.04, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 60, d: 0.35, theta: 0}
  - {a: 0, alpha: 60, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            wrist_45_70 Wrist4570 6 inverse { yaml = "
# wrist with unequal twists: some directions are out of its reach
name: wrist_45_70
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: -90, d: 0.3, theta: 0}
  - {a: 0.38, alpha: 0, d: 0.1, theta: -90}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 45, d: 0.33, theta: 0}
  - {a: 0, alpha: -70, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.09, theta: 0}
" };
            wrist_110_30 Wrist11030 6 inverse { yaml = "
# wrist with an obtuse twist, joint zeros anywhere
name: wrist_110_30
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: 90, d: 0.4, theta: 10}
  - {a: 0.5, alpha: 0, d: 0, theta: -35}
  - {a: 0.1, alpha: -90, d: 0.05, theta: 20}
  - {a: 0, alpha: 110, d: 0.4, theta: 0}
  - {a: 0, alpha: 30, d: 0, theta: 45}
  - {a: 0.05, alpha: 15, d: 0.12, theta: -77.7}
" };
            equal_links EqualLinks 6 inverse { yaml = "
# upper arm and forearm equal: a2 = hypot(a3, d4)
name: equal_links
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0.1, alpha: -90, d: 0.4, theta: 0}
  - {a: 0.5, alpha: 0, d: 0, theta: 0}
  - {a: 0.3, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0.4, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.1, theta: 0}
" };
            equal_links_on_axis EqualLinksOnAxis 6 inverse { yaml = "
# equal links on axis 1: the folded wrist center is the shoulder
name: equal_links_on_axis
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0.5, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0.5, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0, theta: 0}
" };
            no_offsets NoOffsets 6 inverse { yaml = "
# no offset anywhere: the wrist center can stand on axis 1
name: no_offsets
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.35, theta: 0}
  - {a: 0.45, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0.4, theta: 0}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.08, theta: 0}
" };
            odd_zeros OddZeros 6 inverse { yaml = "
# a Puma whose joint zeros are no multiples of 90 degrees
name: odd_zeros
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 90, d: 0.67183, theta: 12.5}
  - {a: 0.4318, alpha: 0, d: 0, theta: -33.3}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 77.7}
  - {a: 0, alpha: 90, d: 0.4318, theta: 101.1}
  - {a: 0, alpha: -90, d: 0, theta: -5.9}
  - {a: 0, alpha: 0, d: 0.0565, theta: 64.2}
" };
            modified_wrist ModifiedWrist 6 inverse { yaml = "
# modified convention, first three axes skew
name: modified_wrist
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 0, alpha: 0, d: 0.4, theta: 0}
  - {a: 0.12, alpha: -65, d: 0.1, theta: 25}
  - {a: 0.35, alpha: 40, d: -0.05, theta: 0}
  - {a: 0.07, alpha: -90, d: 0.33, theta: -10}
  - {a: 0, alpha: 90, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0.09, theta: 180}
" };
            fixed_rows_wrist FixedRowsWrist 6 inverse { yaml = "
# constant rows before, between and in the middle of the links
name: fixed_rows_wrist
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {type: fixed, a: 0, alpha: 0, d: 0.3, theta: 0}
  - {a: 0, alpha: 90, d: 0.37183, theta: 0}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: 0.2318, alpha: 0, d: 0.05, theta: 0}
  - {type: fixed, a: 0, alpha: -45, d: 0, theta: 0}
  - {a: 0.0203, alpha: -45, d: 0.10005, theta: 0}
  - {type: fixed, a: 0, alpha: 0, d: 0.2, theta: 0}
  - {a: 0, alpha: 90, d: 0.2318, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 0.0565, theta: 0}
" };
            inches Inches 6 inverse { yaml = "
# lengths in inches
name: inches
convention: standard
units: {length: in, angle: deg}
inverse: {task: pose, require: true}
joints:
  - {a: 6.5, alpha: -90, d: 26.5, theta: 0}
  - {a: 27.25, alpha: 0, d: 0, theta: -90}
  - {a: 4.75, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 90, d: 31.5, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: 0}
  - {a: 0, alpha: 0, d: 4.25, theta: 180}
" };
        }
    };
}
