//! Numbers of solutions, and complete sets of them, that are known from elsewhere.

use denhart_tests::reference;
use denhart_tests::subject::{Answer, Subject};

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

/// Every solution of `inverse_truth.json`, one by one.
fn check_truths(subject: &Subject<6>) -> usize {
    let truths: Vec<_> = reference::truths().into_iter().filter(|truth| truth.arm == subject.name).collect();
    for truth in &truths {
        let answer: Answer<6> = subject.inverse(&reference::isometry(&truth.pose).into());
        let exact = answer.exact().count();
        assert_eq!((answer.solutions.len(), exact), (truth.real_solution_count, truth.real_solution_count), "{answer}");
        for solution in &truth.solutions {
            let expected: [f64; 6] = solution.as_slice().try_into().expect("six joints");
            // The truth is given to rounding; these poses are well away from singularities.
            let found = answer.exact().any(|s| subject.distance(&s.q, &expected, |_| true) < 1e-9);
            assert!(found, "{expected:?} is missing among\n{answer}");
        }
    }
    truths.len()
}

macro_rules! count_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(count_tests! { @$kind $name $Type })*

        /// Every arm of `inverse_truth.json` with an inverse is met.
        #[test]
        fn every_truth() {
            let mut checked = 0;
            $(count_tests! { @add $kind checked $Type })*
            assert_eq!(checked, 6);
        }
    };
    (@forward $name:ident $Type:ident) => {};
    (@task $name:ident $Type:ident) => {};
    (@inverse $name:ident $Type:ident) => {
        #[test]
        fn $name() {
            check_counts(&Subject::new::<denhart_tests::arms::$Type>());
        }
    };
    (@add forward $checked:ident $Type:ident) => {};
    (@add task $checked:ident $Type:ident) => {};
    (@add inverse $checked:ident $Type:ident) => {
        $checked += check_truths(&Subject::new::<denhart_tests::arms::$Type>());
    };
}

denhart_tests::published_arms!(count_tests);
