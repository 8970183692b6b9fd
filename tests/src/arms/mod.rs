//! Every arm that is tested, derived, and lists of them to make one test an arm.
//!
//! Some hundred arms take a while to compile. The benchmarks do without them, see the feature `arms`.

/// Derives the arms of a list.
#[cfg(feature = "arms")]
macro_rules! declare {
    ($($name:ident $Type:ident $dof:tt $kind:ident { $($attribute:tt)* };)*) => {$(
        #[doc = concat!("The arm `", stringify!($name), "`.")]
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm($($attribute)*)]
        pub struct $Type;

        impl $crate::subject::Specified<$dof> for $Type {
            const NAME: &'static str = stringify!($name);
            const TABLE: denhart::DhTable = <$Type>::DH;
        }
    )*};
}

mod meeting;
mod mounted;
mod parallel;
mod published;
mod single;
mod sliding;
mod sliding_parallel;

#[cfg(feature = "arms")]
pub use meeting::*;
#[cfg(feature = "arms")]
pub use mounted::*;
#[cfg(feature = "arms")]
pub use parallel::*;
#[cfg(feature = "arms")]
pub use published::*;
#[cfg(feature = "arms")]
pub use single::*;
#[cfg(feature = "arms")]
pub use sliding::*;
#[cfg(feature = "arms")]
pub use sliding_parallel::*;
