//! Arms with named lengths, each as a struct of fields and as a unit struct, from one text.

use denhart::{Arm, Chain, DhFrame, DhRow, DhTable};

/// Calls `$with!` with `($more)` and every arm: type, joints, name.
macro_rules! arms {
    ($with:ident $($more:tt)*) => {
        $with! {
            ($($more)*)
            Puma560 6 "puma560";
            Ur5 6 "ur5";
            Askew 6 "askew";
            Tilted 6 "tilted";
            Reacher 3 "reacher";
            Planar2r 2 "planar2r";
            Planar3r 3 "planar3r";
            Jupiter 4 "jupiter";
            FiveJoints 5 "five_joints";
            SkewPoint 3 "skew_point";
            SlideBetween 3 "slide_between";
            Telescope 3 "telescope";
            RailFirst 3 "rail_first";
            TwoSlides 3 "two_slides";
            RailAndFour 5 "rail_and_four";
            SlidesOutside 6 "slides_outside";
        }
    };
}

/// Calls a function of an arm for every arm: `arms!(check function)`.
macro_rules! check {
    (($function:ident) $($Arm:ident $joints:literal $name:literal;)*) => {
        $($function::<$Arm, $joints>($name);)*
    };
}

/// What the tests need of a struct of parameters.
pub trait Parametric<const N: usize>: Arm<f64, N> + Copy + Send + Sync {
    /// The arm whose lengths are constants.
    type Folded: Arm<f64, N> + Default;
    /// Its table.
    const TABLE: DhTable;
    /// Its file.
    const YAML: &'static str;
    /// How many parameters there are.
    const COUNT: usize;

    /// The arm with these parameters, `[COUNT]`.
    fn with(values: &[f64]) -> Self;
    /// The parameters of the arm.
    fn values(&self) -> Vec<f64>;
    /// The arm of the file.
    fn file() -> Self;
    /// The rows, the base and the tool as bound.
    fn bound(&self) -> (Vec<DhRow>, DhFrame, DhFrame);

    /// The chain that judges the arm.
    fn chain(&self) -> Chain {
        let (rows, base, tool) = self.bound();
        Chain::new(Self::TABLE.convention, &rows).with_base(base).with_tool(tool)
    }
}

macro_rules! parametric {
    ($(#[$doc:meta])* $name:ident, $folded:ident, $joints:literal, [$($field:ident),+], $yaml:literal) => {
        $(#[$doc])*
        #[derive(denhart::Arm, Debug, Clone, Copy, PartialEq)]
        #[arm(yaml = $yaml)]
        pub struct $name {
            $(pub $field: f64),+
        }

        /// The same with its lengths folded in.
        #[derive(denhart::Arm, Debug, Clone, Copy, Default)]
        #[arm(yaml = $yaml)]
        pub struct $folded;

        impl Parametric<$joints> for $name {
            type Folded = $folded;
            const TABLE: DhTable = $folded::DH;
            const YAML: &'static str = $yaml;
            const COUNT: usize = [$(stringify!($field)),+].len();

            fn with(values: &[f64]) -> Self {
                let mut values = values.iter().copied();
                $(let $field = values.next().unwrap();)+
                Self { $($field),+ }
            }

            fn values(&self) -> Vec<f64> {
                vec![$(self.$field),+]
            }

            fn file() -> Self {
                Self::nominal()
            }

            fn bound(&self) -> (Vec<DhRow>, DhFrame, DhFrame) {
                (self.dh_rows().to_vec(), self.dh_base(), self.dh_tool())
            }
        }
    };
}

parametric!(
    /// Two links in a plane.
    Planar2r,
    FoldedPlanar2r,
    2,
    [l1, l2],
    "
name: planar2r
convention: standard
units: {length: cm, angle: deg}
parameters: {l1: 10, l2: 20}
inverse: {task: planar_position}
joints:
  - {type: revolute, a: l1, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l2, alpha: 0, d: 0, theta: 0}
"
);

parametric!(
    /// Three links in a plane.
    Planar3r,
    FoldedPlanar3r,
    3,
    [l1, l2, l3],
    "
name: planar3r
convention: standard
units: {length: cm, angle: deg}
parameters: {l1: 20, l2: 10, l3: 7}
inverse: {task: planar_pose}
joints:
  - {type: revolute, a: l1, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l3, alpha: 0, d: 0, theta: 0}
"
);

parametric!(
    /// The Jupiter arm, its last link, which the paper leaves open, half of `l4` in two places, one as a tool.
    Jupiter,
    FoldedJupiter,
    4,
    [a0, l2, l3, l4],
    "
name: jupiter
convention: modified
units: {length: cm, angle: deg}
parameters: {a0: 4, l2: 10, l3: 10, l4: 6}
inverse: {task: position_angle}
joints:
  - {type: revolute, a: 0, alpha: 0, d: a0, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0}
  - {type: revolute, a: l2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l3, alpha: 0, d: 0, theta: 0}
  - {type: fixed, a: l4/2, alpha: 0, d: 0, theta: 0}
tool: {xyz: [0.5 * l4, 0, 0]}
"
);

parametric!(
    /// The Puma 560 with all its lengths, on a base of its own height, with a tool.
    Puma560,
    FoldedPuma560,
    6,
    [height, d1, a2, a3, d3, d4, tip],
    "
name: puma560
convention: standard
units: {length: m, angle: deg}
parameters: {height: 0.5, d1: 0.67183, a2: 0.4318, a3: 0.0203, d3: 0.15005, d4: 0.4318, tip: 0.1}
joints:
  - {type: revolute, a: 0, alpha: 90, d: d1, theta: 0, limits: [-160, 160]}
  - {type: revolute, a: a2, alpha: 0, d: 0, theta: 0, limits: [-45, 225]}
  - {type: revolute, a: a3, alpha: -90, d: d3, theta: 0, limits: [-225, 45]}
  - {type: revolute, a: 0, alpha: 90, d: d4, theta: 0, limits: [-110, 170]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-100, 100]}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0, limits: [-266, 266]}
base: {xyz: [0, -height, 2 * height], rpy: [0, 30, 0]}
tool: {xyz: [0, 0, tip]}
"
);

parametric!(
    /// Three parallel axes as on a UR5, lengths named like locals of generated code.
    Ur5,
    FoldedUr5,
    6,
    [d1, s2, c3, q, px, d6],
    "
name: ur5
convention: standard
units: {length: m, angle: deg}
parameters: {d1: 0.089159, s2: 0.425, c3: 0.39225, q: 0.10915, px: 0.09465, d6: 0.0823}
joints:
  - {type: revolute, a: 0, alpha: 90, d: d1, theta: 0}
  - {type: revolute, a: -s2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: -c3, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: q, theta: 0}
  - {type: revolute, a: 0, alpha: -90, d: px, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: d6, theta: 0}
"
);

parametric!(
    /// Shoulder axes that meet in a point where the lengths put it, askew; then an elbow out of line, two parallel axes and
    /// a wrist of one more: the triple is the shoulder, and its meeting point depends on two parameters.
    Askew,
    FoldedAskew,
    6,
    [rise, off, upper, fore],
    "
name: askew
convention: standard
units: {length: m, angle: deg}
parameters: {rise: 0.3, off: 0.1, upper: 0.5, fore: 0.4}
joints:
  - {type: revolute, a: 0, alpha: 90, d: rise, theta: 0}
  - {type: revolute, a: 0, alpha: 60, d: 0, theta: 0}
  - {type: revolute, a: off, alpha: -90, d: upper, theta: 0}
  - {type: revolute, a: fore, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 2*off, alpha: 90, d: 0, theta: 30}
  - {type: revolute, a: 0, alpha: 0, d: -rise, theta: 0}
"
);

parametric!(
    /// A spherical wrist whose axes meet at the far end of two offsets along tilted axes.
    Tilted,
    FoldedTilted,
    6,
    [d1, a2, d4, slip],
    "
name: tilted
convention: standard
units: {length: m, angle: deg}
parameters: {d1: 0.4, a2: 0.6, d4: 0.5, slip: 0.2}
joints:
  - {type: revolute, a: 0.1, alpha: 90, d: d1, theta: 0}
  - {type: revolute, a: a2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0}
  - {type: revolute, a: 0, alpha: 60, d: d4, theta: 0}
  - {type: fixed, a: 0, alpha: 0, d: slip, theta: 0}
  - {type: revolute, a: 0, alpha: -60, d: -slip, theta: 0}
  - {type: revolute, a: 0, alpha: 0, d: 0.1, theta: 0}
"
);

parametric!(
    /// A point with an arm of three links.
    Reacher,
    FoldedReacher,
    3,
    [d1, side, upper, fore],
    "
name: reacher
convention: standard
units: {length: mm, angle: deg}
parameters: {d1: 170, side: -10, upper: 197, fore: 258}
inverse: {task: position}
joints:
  - {type: revolute, a: 0, alpha: 90, d: d1, theta: 0}
  - {type: revolute, a: upper, alpha: 0, d: side, theta: 0}
  - {type: revolute, a: fore, alpha: 0, d: 0, theta: 0}
"
);
