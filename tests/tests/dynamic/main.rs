//! Arms evaluated at run time give what their generated code gives, to the bit.
//!
//! An arm with inverse is compared in the suite that compiles its inverse for other tests: `inverse`, `tasks`, `parameters`
//! or `found`. Here are the others, and that none is left out.

macro_rules! arm {
    ($Type:ident $text:ident $yaml:literal) => {
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm(yaml = $yaml)]
        pub struct $Type;

        pub const $text: &str = $yaml;
    };
}

mod besides;
mod lists;
mod more;
mod wound;

use denhart_tests::{evaluated, margins_of};

macro_rules! equal {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(equal! { @$kind $name $Type $dof $file })*
    };
    (@forward $name:ident $Type:ident $dof:tt $file:literal) => {
        #[test]
        fn $name() {
            use denhart_tests::arms::$Type as Tested;
            evaluated::kinematics::<Tested, $dof>($file, margins_of!(Tested));
        }
    };
    (@task $name:ident $Type:ident $dof:tt $file:literal) => {
        #[test]
        fn $name() {
            use denhart_tests::arms::$Type as Tested;
            evaluated::inverse::<Tested, $dof>($file, margins_of!(Tested), denhart_tests::branch_of!(Tested));
        }
    };
    (@inverse $name:ident $Type:ident $dof:tt $file:literal) => {};
}

/// Of `specs/` those without inverse: the suite `tasks` has the tasks.
macro_rules! equal_forward {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(equal_forward! { @$kind $name $Type $dof $file })*
    };
    (@forward $name:ident $Type:ident $dof:tt $file:literal) => { equal! { @forward $name $Type $dof $file } };
    (@$kind:ident $name:ident $Type:ident $dof:tt $file:literal) => {};
}

mod published {
    use super::*;

    denhart_tests::published_arms!(equal_forward);
    equal! {
        kuka_lwr4 KukaLwr4 7 task "../specs/kuka_lwr4.yaml";
        yaskawa_sia10d YaskawaSia10d 7 task "../specs/yaskawa_sia10d.yaml";
    }
}

mod made_up {
    use super::*;

    denhart_tests::made_up_arms!(equal);
}
