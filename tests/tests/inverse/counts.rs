//! Numbers of solutions, and complete sets of them, that are known from elsewhere.

use denhart_tests::reference;
use denhart_tests::subject::Subject;
use denhart_tests::suite;

/// Every solution that is listed for the reference poses of an arm, by its number.
fn check_counts(subject: &Subject<6>) {
    let reference = reference::load(&subject.name);
    let counts = reference.counts.pose.expect("a six-joint arm has counts");
    assert_eq!(counts.len(), reference.samples.len());
    let found: Vec<usize> = reference
        .samples
        .iter()
        .map(|sample| subject.inverse(&reference::isometry(&sample.pose).into()).exact().count())
        .collect();
    assert_eq!(found, counts);
}

macro_rules! count_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(count_tests! { @$kind $name $Type })*

        /// Every arm of `inverse_truth.json` with a closed form is met.
        #[test]
        fn every_truth() {
            let mut checked = 0;
            $(count_tests! { @add $kind checked $Type })*
            assert_eq!(checked, 6);
        }
    };
    (@forward $name:ident $Type:ident) => {};
    (@task $name:ident $Type:ident) => {};
    (@held $name:ident $Type:ident) => {};
    (@inverse $name:ident $Type:ident) => {
        #[test]
        fn $name() {
            check_counts(&Subject::new::<denhart_tests::arms::$Type>());
        }
    };
    (@add forward $checked:ident $Type:ident) => {};
    (@add task $checked:ident $Type:ident) => {};
    (@add held $checked:ident $Type:ident) => {};
    (@add inverse $checked:ident $Type:ident) => {
        $checked += suite::truths(&Subject::new::<denhart_tests::arms::$Type>());
    };
}

denhart_tests::published_arms!(count_tests);
