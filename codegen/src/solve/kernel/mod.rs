//! The equations there are. Each is solved by one function of the runtime, its kernel, and has one file here: its inputs,
//! the call, the number of roots, its line in a report, and its derivative for the margins.
//!
//! Sources: the subproblems of Paden and Kahan (Murray, Li, Sastry, *A Mathematical Introduction to Robotic
//! Manipulation*, 1994, section 3.3), and those of IK-Geo (Elias, Wen, *IK-Geo: unified robot inverse kinematics using
//! subproblem decomposition*, 2022).

mod aim;
mod align;
mod argument;
mod cone;
mod distance;
mod equation;
mod flip;
mod offset;
mod offset_of_two;
mod pair;
mod pair_sliding;
mod pivot;
mod quadratic;
mod slide;
mod slide_to;
mod slide_turning;
mod wrist;

pub use aim::Aim;
pub use align::Align;
pub use argument::{Argument, Phase, Quantity};
pub use cone::{Cone, ConeRange};
pub use distance::{Distance, ElbowRange};
pub use equation::Equation;
pub use flip::Flip;
pub use offset::Offset;
pub use offset_of_two::OffsetOfTwo;
pub use pair::Pair;
pub use pair_sliding::PairSliding;
pub use pivot::{Pivot, Unit, Variables};
pub use quadratic::Quadratic;
pub use slide::Slide;
pub use slide_to::SlideTo;
pub use slide_turning::SlideTurning;
pub use wrist::Wrist;

use crate::symbolic::Expr;

/// The enumeration of all equations, and their common view.
macro_rules! kernels {
    ($($name:ident),* $(,)?) => {
        /// An equation, by the kernel that solves it.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Kernel {
            $(#[doc = concat!("See [`", stringify!($name), "`].")] $name($name),)*
        }

        $(
            impl From<$name> for Kernel {
                fn from(kernel: $name) -> Self {
                    Kernel::$name(kernel)
                }
            }
        )*

        impl Kernel {
            /// What all equations have.
            pub fn equation(&self) -> &dyn Equation {
                match self {
                    $(Kernel::$name(kernel) => kernel,)*
                }
            }

            /// Its name.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Kernel::$name(_) => stringify!($name),)*
                }
            }
        }
    };
}

kernels!(
    Offset,
    OffsetOfTwo,
    Distance,
    Cone,
    Align,
    Flip,
    Wrist,
    Slide,
    SlideTo,
    SlideTurning,
    Aim,
    Pair,
    PairSliding,
    Quadratic,
);

impl Kernel {
    /// The largest number of roots of regular targets.
    pub fn roots(&self) -> usize {
        self.equation().roots()
    }

    /// The expressions it reads.
    pub fn inputs(&self) -> Vec<Expr> {
        let equation = self.equation();
        let about = equation.about().into_iter().flat_map(|phase| [phase.y, phase.x]);
        equation.arguments().iter().flat_map(Argument::inputs).chain(about).collect()
    }
}
