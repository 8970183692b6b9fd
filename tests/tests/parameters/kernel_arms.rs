//! Arms with named lengths for the kernels that the arms of `arms.rs` do not need.

use super::arms::Parametric;
use denhart::{DhFrame, DhRow, DhTable, Margin};

parametric!(
    /// Yaw, three pitch joints and roll, asked for a pose: the yaw joint has two equations (`offset_of_two`).
    FiveJoints,
    FoldedFiveJoints,
    5,
    [rise, off, upper, fore, hand],
    "arms/parameters/five_joints.yaml"
);

parametric!(
    /// A point with three skew axes (`pair_turning`).
    SkewPoint,
    FoldedSkewPoint,
    3,
    [first, second, third],
    "arms/parameters/skew_point.yaml"
);

parametric!(
    /// A point with a slide between two skew axes (`pair`, `slide_to`).
    SlideBetween,
    FoldedSlideBetween,
    3,
    [side, upper, fore],
    "arms/parameters/slide_between.yaml"
);

parametric!(
    /// A point with yaw, pitch and a stroke beside the tool (`slide`).
    Telescope,
    FoldedTelescope,
    3,
    [height, side, slip],
    "arms/parameters/telescope.yaml"
);

parametric!(
    /// A point with a rail before two skew axes (`pair_sliding`).
    RailFirst,
    FoldedRailFirst,
    3,
    [first, second, third],
    "arms/parameters/rail_first.yaml"
);

parametric!(
    /// A point with a slide on either side of an axis (`quadratic`).
    TwoSlides,
    FoldedTwoSlides,
    3,
    [first, second, third],
    "arms/parameters/two_slides.yaml"
);

parametric!(
    /// A point and a direction with a rail, yaw and three pitch joints (`aim`).
    RailAndFour,
    FoldedRailAndFour,
    5,
    [side, rise, upper, fore, hand],
    "arms/parameters/rail_and_four.yaml"
);

parametric!(
    /// A pose with a slide at either end, whose directions the target relates (`slide_turning`).
    SlidesOutside,
    FoldedSlidesOutside,
    6,
    [first, second, third],
    "arms/parameters/slides_outside.yaml"
);
