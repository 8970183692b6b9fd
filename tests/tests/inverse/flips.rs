//! Of two solutions that differ by a wrist flip only the first one is verified: its steps tell the other one.

use std::f64::consts::FRAC_PI_2;

use denhart::effort::effort_of;
use denhart::{Flags, Pose, Wrist};
use denhart_tests::arms::AbbIrb2400;

/// The elbow is stretched: its two roots are one, which is verified.
fn stretched(wrist: [f64; 3]) -> Pose<f64> {
    let [q4, q5, q6] = wrist;
    AbbIrb2400.forward(&[0.4, 0.7, (0.135f64 / 0.755).atan() - FRAC_PI_2, q4, q5, q6])
}

#[test]
fn the_flip_of_a_verified_solution_is_not_evaluated() {
    let (solutions, effort) = effort_of(|| AbbIrb2400.inverse(&stretched([1.1, 0.8, 0.6])));
    assert_eq!((solutions.len(), effort.evaluations), (2, 1), "{solutions:?}");
}

/// Steps are taken where the target is moved, outwards too.
#[test]
fn a_flip_is_as_good_as_the_solution_that_tells_it() {
    for wrist in [[1.1, 0.8, 0.6], [-3.0, 1.4, 3.1], [FRAC_PI_2, -FRAC_PI_2, 0.0]] {
        for push in [-1e-6, -1e-9, -1e-12, 1e-13, 1e-11, 1e-9, 1e-7] {
            let mut target = stretched(wrist);
            target.translation = target.translation.map(|x| x * (1.0 + push));
            let solutions = AbbIrb2400.inverse(&target);
            assert!(solutions.iter().all(|s| s.is_exact() || s.flags.contains(Flags::APPROXIMATE)), "{solutions:?}");
            for pair in solutions.chunks(2) {
                let [one, flip] = pair else {
                    panic!("{wrist:?} {push:e}: a solution without its flip: {solutions:?}")
                };
                assert_eq!([one.branch.wrist(), flip.branch.wrist()], [Some(Wrist::NoFlip), Some(Wrist::Flip)]);
                assert_eq!(
                    (one.q[..3].to_vec(), one.residual, one.flags),
                    (flip.q[..3].to_vec(), flip.residual, flip.flags)
                );
                let [off, flip_off] = [one, flip].map(|s| AbbIrb2400.residual(&s.q, &target));
                let apart =
                    (off.position - flip_off.position).abs().max((off.orientation - flip_off.orientation).abs());
                assert!(apart < 1e-14, "{wrist:?} {push:e}: {off} {flip_off}");
                assert!(flip.q.iter().all(|q| -std::f64::consts::PI < *q && *q <= std::f64::consts::PI), "{flip:?}");
            }
        }
    }
}

#[test]
fn a_wrist_in_line_has_no_flip() {
    let solutions = AbbIrb2400.inverse(&stretched([1.1, 0.0, 0.6]));
    assert_eq!(solutions.len(), 1, "{solutions:?}");
    assert!(solutions.iter().all(|s| s.is_exact() && s.free.contains(3)), "{solutions:?}");
}
