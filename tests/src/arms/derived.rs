//! The arms of the lists, derived.

use crate::task::{Kind, Task};

macro_rules! declare {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(crate::arm!($name $Type $dof $file Task::new(Kind::Pose));)*
    };
}

macro_rules! declare_single {
    ($($name:ident $Single:ident $Double:ident $file:literal;)*) => {$(
        #[doc = concat!("The arm `", stringify!($name), "` in single precision.")]
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm(spec = $file, scalar = "f32")]
        pub struct $Single;
    )*};
}

crate::published_arms!(declare);
crate::made_up_arms!(declare);
crate::single_arms!(declare_single);
