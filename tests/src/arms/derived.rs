//! The arms of the lists, derived.

macro_rules! declare {
    ($($name:ident $Type:ident $dof:tt $kind:ident { $($attribute:tt)* };)*) => {$(
        #[doc = concat!("The arm `", stringify!($name), "`.")]
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm($($attribute)*)]
        pub struct $Type;

        impl crate::subject::Specified<$dof> for $Type {
            const NAME: &'static str = stringify!($name);
            const TABLE: denhart::DhTable = <$Type>::DH;
        }
    )*};
}

macro_rules! declare_single {
    ($($name:ident $Single:ident $Double:ident { $($attribute:tt)* };)*) => {$(
        #[doc = concat!("The arm `", stringify!($name), "` in single precision.")]
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm($($attribute)*, scalar = "f32")]
        pub struct $Single;
    )*};
}

crate::published_arms!(declare);
crate::mounted_arms!(declare);
crate::meeting_arms!(declare);
crate::parallel_arms!(declare);
crate::sliding_arms!(declare);
crate::sliding_parallel_arms!(declare);
crate::single_arms!(declare_single);
