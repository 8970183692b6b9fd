//! The equations there are. Each is solved by one function of the runtime, its kernel, and has one file here. The file
//! has its inputs, the call, the number of roots, its line in a report, and its derivative for the margins.
//!
//! Sources: the subproblems of Paden and Kahan, and those of IK-Geo. Both books are named in
//! `docs/design/glossary.md`.

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
pub use equation::{Equation, Form};
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

use crate::symbolic::{Expr, Graph};

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
            /// Its name.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Kernel::$name(_) => stringify!($name),)*
                }
            }

            fn equation(&self) -> &dyn Equation {
                match self {
                    $(Kernel::$name(kernel) => kernel,)*
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
    /// Form of its equation.
    pub fn form(&self) -> Form {
        self.equation().form()
    }

    /// The expressions it reads.
    pub fn inputs(&self) -> Vec<Expr> {
        self.form().inputs()
    }

    /// The derivative of its equation by its joints' variables.
    pub fn pivot(&self, g: &mut Graph, variables: &Variables) -> Pivot {
        self.equation().pivot(g, variables)
    }
}
