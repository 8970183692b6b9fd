//! Arms with named lengths, each as a struct of fields and as a unit struct, from one file of `tests/arms/parameters/`.

use denhart::{Arm, Chain, DhFrame, DhRow, DhTable, Margin};

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

/// A struct of parameters, as the tests need it.
pub trait Parametric<const N: usize>: Arm<f64, N> + Copy + Send + Sync {
    /// The arm whose lengths are constants.
    type Folded: Arm<f64, N> + Default + Send + Sync + 'static;
    /// Its table.
    const TABLE: DhTable;
    /// Its file, from the folder of this package, and the text of it.
    const FILE: &'static str;
    const YAML: &'static str;
    /// How many parameters there are.
    const COUNT: usize;

    /// The arm with these parameters, `[COUNT]`.
    fn with(values: &[f64]) -> Self;
    /// The parameters of the arm.
    fn values(&self) -> Vec<f64>;
    /// The arm of the file.
    fn file() -> Self;
    /// The margins of the arm whose lengths are constants.
    fn folded_margins(q: &[f64; N]) -> Vec<Margin<f64>>;
    /// The rows, the base and the tool as bound.
    fn bound(&self) -> (Vec<DhRow>, DhFrame, DhFrame);

    /// The chain that judges the arm.
    fn chain(&self) -> Chain {
        let (rows, base, tool) = self.bound();
        Chain::new(Self::TABLE.convention, &rows).with_base(base).with_tool(tool)
    }
}

macro_rules! parametric {
    ($(#[$doc:meta])* $name:ident, $folded:ident, $joints:literal, [$($field:ident),+], $file:literal) => {
        $(#[$doc])*
        #[derive(denhart::Arm, Debug, Clone, Copy, PartialEq)]
        #[arm(spec = $file)]
        pub struct $name {
            $(pub $field: f64),+
        }

        /// The arm with its lengths folded in.
        #[derive(denhart::Arm, Debug, Clone, Copy, Default)]
        #[arm(spec = $file)]
        pub struct $folded;

        impl Parametric<$joints> for $name {
            type Folded = $folded;
            const TABLE: DhTable = $folded::DH;
            const FILE: &'static str = $file;
            const YAML: &'static str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $file));
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

            fn folded_margins(q: &[f64; $joints]) -> Vec<Margin<f64>> {
                let margins: fn(&[f64; $joints]) -> Vec<Margin<f64>> = denhart_tests::margins_of!($folded);
                margins(q)
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
    "arms/parameters/planar2r.yaml"
);

parametric!(
    /// Three links in a plane.
    Planar3r,
    FoldedPlanar3r,
    3,
    [l1, l2, l3],
    "arms/parameters/planar3r.yaml"
);

parametric!(
    /// The Jupiter arm, its last link, which the paper leaves open, half of `l4` in two places, one as a tool.
    Jupiter,
    FoldedJupiter,
    4,
    [a0, l2, l3, l4],
    "arms/parameters/jupiter.yaml"
);

parametric!(
    /// The Puma 560 with all its lengths, on a base of its own height, with a tool.
    Puma560,
    FoldedPuma560,
    6,
    [height, d1, a2, a3, d3, d4, tip],
    "arms/parameters/puma560.yaml"
);

parametric!(
    /// Three parallel axes as on a UR5, lengths named like locals of generated code.
    Ur5,
    FoldedUr5,
    6,
    [d1, s2, c3, q, px, d6],
    "arms/parameters/ur5.yaml"
);

parametric!(
    /// Three shoulder axes meet, askew, in a point whose place depends on the lengths. Then come an elbow out of line,
    /// two parallel axes and a wrist of one more axis. The triple is the shoulder, and its meeting point depends on two
    /// parameters.
    Askew,
    FoldedAskew,
    6,
    [rise, off, upper, fore],
    "arms/parameters/askew.yaml"
);

parametric!(
    /// A spherical wrist whose axes meet at the far end of two offsets along tilted axes.
    Tilted,
    FoldedTilted,
    6,
    [d1, a2, d4, slip],
    "arms/parameters/tilted.yaml"
);

parametric!(
    /// A point with an arm of three links.
    Reacher,
    FoldedReacher,
    3,
    [d1, side, upper, fore],
    "arms/parameters/reacher.yaml"
);
