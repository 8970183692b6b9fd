//! Near a singularity the closed form stands if every stage closes its equation: nothing is evaluated.

use denhart::Flags;
use denhart::effort::effort_of;
use denhart_tests::arms::{AbbIrb2400, Puma560, Ur5};

/// Amplitudes below `DOUBTFUL`, 1.4e-3.
const SMALL: [f64; 4] = [1e-5, 1e-4, 5e-4, 1.3e-3];

/// The solutions of `$arm` at `$q` with a joint so far from its singular value. Each closes, and `$q` is one of them.
macro_rules! closes {
    ($arm:expr, $q:expr, $joint:literal) => {
        for (step, side) in SMALL.iter().flat_map(|step| [(*step, 1.0), (*step, -1.0)]) {
            let mut q: [f64; 6] = $q;
            q[$joint] += side * step;
            let target = $arm.forward(&q);
            let (solutions, effort) = effort_of(|| $arm.inverse(&target));
            assert_eq!((effort.cascades, effort.evaluations), (1, 0), "{q:?}");
            for (solution, off) in solutions.iter().zip(solutions.verify(&$arm, &target)) {
                assert!(!solution.flags.contains(Flags::FREE) && solution.free.is_empty(), "{solution:?}");
                assert!(solution.is_exact() && off.position < 1e-12 && off.orientation < 1e-12, "{solution:?} {off}");
            }
            let apart = |other: &[f64; 6]| q.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let nearest = solutions.exact().map(|solution| apart(&solution.q)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{q:?} {nearest}");
        }
    };
}

#[test]
fn a_wrist_nearly_in_line() {
    closes!(Puma560, [0.4, 0.7, -0.3, 1.1, 0.0, 0.6], 4);
    closes!(Ur5, [0.4, -0.7, 0.9, 1.1, 0.0, 0.6], 4);
    closes!(AbbIrb2400, [0.4, 0.7, -0.3, 1.1, 0.0, 0.6], 4);
}

#[test]
fn an_elbow_nearly_stretched() {
    closes!(Ur5, [0.4, -0.7, 0.0, 1.1, 0.8, 0.6], 2);
    closes!(AbbIrb2400, [0.4, 0.7, (0.135f64 / 0.755).atan() - std::f64::consts::FRAC_PI_2, 1.1, 0.8, 0.6], 2);
}
