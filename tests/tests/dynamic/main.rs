//! Arms evaluated at run time give what their generated code gives, to the bit.

mod bits;
mod compare;
mod generated;
mod more;

use denhart_dynamic::DynamicArm;
use std::path::Path;

/// The arm of a file, from the folder of this package.
fn evaluated(file: &str) -> DynamicArm {
    DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap()
}

macro_rules! equal {
    (@forward $Type:ident $dof:tt) => { generated::kinematics::<denhart_tests::arms::$Type, $dof>() };
    (@inverse $Type:ident $dof:tt) => { generated::inverse::<denhart_tests::arms::$Type, $dof>() };
    (@task $Type:ident $dof:tt) => { generated::inverse::<denhart_tests::arms::$Type, $dof>() };
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            let arm = evaluated($file);
            compare::compare(stringify!($name), &arm, &equal!(@$kind $Type $dof));
        }
    )*};
}

macro_rules! equal_with_branches {
    (@forward $Type:ident $dof:tt) => { generated::kinematics::<denhart_tests::arms::$Type, $dof>() };
    (@inverse $Type:ident $dof:tt) => { generated::branches::<denhart_tests::arms::$Type, $dof>() };
    (@task $Type:ident $dof:tt) => { generated::branches::<denhart_tests::arms::$Type, $dof>() };
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            let arm = evaluated($file);
            compare::compare(stringify!($name), &arm, &equal_with_branches!(@$kind $Type $dof));
        }
    )*};
}

denhart_tests::published_arms!(equal_with_branches);

mod made_up {
    use super::*;

    denhart_tests::made_up_arms!(equal);
}
