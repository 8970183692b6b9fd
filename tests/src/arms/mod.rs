//! Every arm that is tested: lists of them, to make one test an arm, and the arms themselves.
//!
//! Some hundred arms take a while to compile. The benchmarks do without them, see the feature `arms`, and so do the
//! unit tests of this library.

mod made_up;
mod published;
mod single;

#[cfg(all(feature = "arms", not(test)))]
mod derived;
#[cfg(all(feature = "arms", not(test)))]
pub use derived::*;

/// Derives an arm from its file, and implements what the suites need for a test of the arm. The arguments are test
/// name, type, number of joints, file from the folder of this package, [`Task`](crate::task::Task).
#[macro_export]
macro_rules! arm {
    ($name:ident $Type:ident $dof:tt $file:literal $task:expr) => {
        #[doc = concat!("The arm `", stringify!($name), "`.")]
        #[derive(Debug, Clone, Copy, Default, ::denhart::Arm)]
        #[arm(spec = $file)]
        pub struct $Type;

        impl $crate::subject::Specified<$dof> for $Type {
            const NAME: &'static str = stringify!($name);
            const TABLE: ::denhart::DhTable = $Type::DH;
            const TASK: $crate::task::Task = $task;
        }
    };
}
