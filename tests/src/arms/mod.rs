//! Every arm that is tested, derived, and lists of them to make one test an arm.


/// Derives the arms of a list.
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

pub use meeting::*;
pub use mounted::*;
pub use parallel::*;
pub use published::*;
pub use single::*;
pub use sliding::*;
pub use sliding_parallel::*;

