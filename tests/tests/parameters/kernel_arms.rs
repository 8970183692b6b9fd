//! Arms with named lengths for the kernels that the arms of `arms.rs` do not need.

use super::arms::Parametric;
use denhart::{DhFrame, DhRow, DhTable};

parametric!(
    /// Yaw, three pitch joints and roll, asked for a pose: the yaw joint has two equations (`offset_of_two`).
    FiveJoints,
    FoldedFiveJoints,
    5,
    [rise, off, upper, fore, hand],
    "
name: five_joints
convention: standard
units: {length: m, angle: deg}
parameters: {rise: 0.15, off: 0.03, upper: 0.16, fore: 0.13, hand: 0.2}
inverse: {task: pose}
joints:
  - {type: revolute, a: off, alpha: 90, d: rise, theta: 0}
  - {type: revolute, a: upper, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: fore, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 90}
  - {type: revolute, a: 0, alpha: 0, d: hand, theta: 0}
"
);

parametric!(
    /// A point with three skew axes (`pair_turning`).
    SkewPoint,
    FoldedSkewPoint,
    3,
    [first, second, third],
    "
name: skew_point
convention: standard
units: {length: m, angle: deg}
parameters: {first: 0.2, second: 0.3, third: 0.15}
inverse: {task: position}
joints:
  - {type: revolute, a: first, alpha: 75, d: 0, theta: 0}
  - {type: revolute, a: second, alpha: -58.3, d: first, theta: 65.6}
  - {type: revolute, a: third, alpha: 145.7, d: first, theta: -148.9}
"
);

parametric!(
    /// A point with a slide between two skew axes (`pair`, `slide_to`).
    SlideBetween,
    FoldedSlideBetween,
    3,
    [side, upper, fore],
    "
name: slide_between
convention: standard
units: {length: m, angle: deg}
parameters: {side: 0.2, upper: 0.3, fore: 0.15}
inverse: {task: position}
joints:
  - {type: revolute, a: side, alpha: -93.9, d: 0, theta: -27}
  - {type: prismatic, a: -upper, alpha: -26.9, d: 0, theta: 104.2}
  - {type: revolute, a: fore, alpha: -135.9, d: -side, theta: 5}
"
);

parametric!(
    /// A point with yaw, pitch and a stroke beside the tool (`slide`).
    Telescope,
    FoldedTelescope,
    3,
    [height, side, slip],
    "
name: telescope
convention: standard
units: {length: mm, angle: deg}
parameters: {height: 200, side: 300, slip: 150}
inverse: {task: position}
joints:
  - {type: revolute, a: 0, alpha: -90, d: height, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: side, theta: 0}
  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0}
tool: {xyz: [slip, 0, 0]}
"
);

parametric!(
    /// A point with a rail before two skew axes (`pair_sliding`).
    RailFirst,
    FoldedRailFirst,
    3,
    [first, second, third],
    "
name: rail_first
convention: standard
units: {length: m, angle: deg}
parameters: {first: 0.2, second: 0.3, third: 0.15}
inverse: {task: position}
joints:
  - {type: prismatic, a: first, alpha: 150, d: 0, theta: -40.5}
  - {type: revolute, a: second, alpha: -58.3, d: 0, theta: 65.6}
  - {type: revolute, a: third, alpha: 145.7, d: first, theta: -148.9}
"
);

parametric!(
    /// A point with a slide on either side of an axis (`quadratic`).
    TwoSlides,
    FoldedTwoSlides,
    3,
    [first, second, third],
    "
name: two_slides
convention: standard
units: {length: m, angle: deg}
parameters: {first: 0.2, second: 0.3, third: 0.15}
inverse: {task: position}
joints:
  - {type: prismatic, a: first, alpha: -153.5, d: 0, theta: 148.5}
  - {type: revolute, a: second, alpha: 65.8, d: third, theta: -30.1}
  - {type: prismatic, a: -third, alpha: 92.4, d: 0, theta: -139.9}
"
);

parametric!(
    /// A point and a direction with a rail, yaw and three pitch joints (`aim`).
    RailAndFour,
    FoldedRailAndFour,
    5,
    [side, rise, upper, fore, hand],
    "
name: rail_and_four
convention: standard
units: {length: m, angle: deg}
parameters: {side: 0.05, rise: 0.31, upper: 0.3, fore: 0.25, hand: 0.1}
inverse: {task: position_axis, axis: z}
joints:
  - {type: prismatic, a: 0, alpha: -90, d: 0, theta: 90}
  - {type: revolute, a: side, alpha: 90, d: rise, theta: 0}
  - {type: revolute, a: upper, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: fore, alpha: 0, d: side, theta: 0}
  - {type: revolute, a: hand, alpha: -90, d: 0, theta: 0}
"
);

parametric!(
    /// A pose with a slide at either end, whose directions the target relates (`slide_turning`).
    SlidesOutside,
    FoldedSlidesOutside,
    6,
    [first, second, third],
    "
name: slides_outside
convention: standard
units: {length: m, angle: deg}
parameters: {first: 0.2, second: 0.3, third: 0.15}
joints:
  - {type: prismatic, a: first, alpha: 63, d: 0.1, theta: 20}
  - {type: revolute, a: 0, alpha: 90, d: second, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: second, alpha: 50, d: third, theta: 0}
  - {type: revolute, a: 0.2, alpha: -70, d: first, theta: 0}
  - {type: prismatic, a: third, alpha: 40, d: 0.1, theta: 30}
"
);
