//! Arms evaluated at run time give what their generated code gives, to the bit.

mod bits;
mod compare;
mod generated;
mod more;

use denhart_dynamic::DynamicArm;
use std::path::Path;

/// The arm of a list, evaluated.
macro_rules! evaluated {
    ({ spec = $path:literal }) => {
        DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join($path))
    };
    ({ yaml = $text:literal }) => {
        DynamicArm::from_yaml($text)
    };
}

macro_rules! equal {
    (@forward $Type:ident $dof:tt) => { generated::kinematics::<denhart_tests::arms::$Type, $dof>() };
    (@inverse $Type:ident $dof:tt) => { generated::inverse::<denhart_tests::arms::$Type, $dof>() };
    (@task $Type:ident $dof:tt) => { generated::inverse::<denhart_tests::arms::$Type, $dof>() };
    ($($name:ident $Type:ident $dof:tt $kind:ident $attribute:tt;)*) => {$(
        #[test]
        fn $name() {
            let arm = evaluated!($attribute).unwrap();
            compare::compare(stringify!($name), &arm, &equal!(@$kind $Type $dof));
        }
    )*};
}

macro_rules! equal_with_branches {
    (@forward $Type:ident $dof:tt) => { generated::kinematics::<denhart_tests::arms::$Type, $dof>() };
    (@inverse $Type:ident $dof:tt) => { generated::branches::<denhart_tests::arms::$Type, $dof>() };
    (@task $Type:ident $dof:tt) => { generated::branches::<denhart_tests::arms::$Type, $dof>() };
    ($($name:ident $Type:ident $dof:tt $kind:ident $attribute:tt;)*) => {$(
        #[test]
        fn $name() {
            let arm = evaluated!($attribute).unwrap();
            compare::compare(stringify!($name), &arm, &equal_with_branches!(@$kind $Type $dof));
        }
    )*};
}

denhart_tests::published_arms!(equal_with_branches);

mod made_up {
    use super::*;

    denhart_tests::mounted_arms!(equal);
    denhart_tests::meeting_arms!(equal);
    denhart_tests::parallel_arms!(equal);
    denhart_tests::sliding_arms!(equal);
    denhart_tests::sliding_parallel_arms!(equal);
}
