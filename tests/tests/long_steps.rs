//! Beside a wrist singularity the nearest solution may be far away, exact and without another flag. The control loop of
//! `docs/results.md` sees that by its bound on a step and by the margin of the wrist, and stays within the bound.
#![allow(clippy::unwrap_used, clippy::panic)]

use denhart::{Arm, Flags, InverseKinematics, Pose};

/// The most that a joint moves in a tick, rad.
const MOST: f64 = 0.05;
/// The wrist is beside its singularity where its margin is smaller.
const BESIDE: f64 = 0.05;
/// Both arms are in meters.
const MILLIMETER: f64 = 1e-3;
/// A path of this many ticks either side of its middle.
const TICKS: i32 = 20;

/// The greatest step of a joint.
fn step(from: &[f64; 6], to: &[f64; 6]) -> f64 {
    from.iter().zip(to).fold(0.0, |most, (from, to)| most.max((to - from).abs()))
}

/// The target of a tick. The line has 1 mm a tick, at right angles to the arm; in its middle it is 1 um away from the
/// pose in which the wrist is straight.
fn line(straight: &Pose<f64>, tick: i32) -> Pose<f64> {
    Pose::from_xyz_rpy([1e-3 * MILLIMETER, MILLIMETER * f64::from(tick), 0.0], [0.0; 3]) * *straight
}

/// Walks the line with and without the loop's check. `bent`: joint values with a straight wrist; `margins`: shoulder, elbow, wrist.
fn check<A>(arm: &A, bent: [f64; 6], margins: impl Fn(&[f64; 6]) -> [f64; 3])
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let straight = arm.forward(&bent);
    let at = |tick: i32| line(&straight, tick);
    let nearest = |target: &Pose<f64>, q: &[f64; 6]| *arm.inverse_near(target, q).as_ref().first().unwrap();

    // Without a check: two ticks ask for a right angle, and say nothing of it but by their length and by the margin.
    let mut q = nearest(&at(-TICKS), &bent).q;
    let mut long = Vec::new();
    for tick in -TICKS..=TICKS {
        let next = nearest(&at(tick), &q);
        assert_eq!(next.flags, Flags::EXACT, "{tick}: {next:?}");
        if step(&q, &next.q) > MOST {
            let [shoulder, elbow, wrist] = margins(&next.q).map(f64::abs);
            assert!(wrist < BESIDE && shoulder > BESIDE && elbow > BESIDE, "{tick}: {:?}", margins(&next.q));
            long.push((tick, step(&q, &next.q)));
        }
        q = next.q;
    }
    let [(0, to), (1, from)] = long[..] else { panic!("the long steps are {long:?}") };
    assert!(to > 1.5 && from > 1.5, "{long:?}");

    // With it no joint moves by more, the tool is behind by no more than a tick's way, and every target is met.
    let mut q = nearest(&at(-TICKS), &bent).q;
    let mut slow = 0;
    for tick in -TICKS..=TICKS {
        loop {
            let (last, next) = (q, nearest(&at(tick), &q));
            let long = step(&q, &next.q);
            if long <= MOST {
                q = next.q;
                break;
            }
            slow += 1;
            q = std::array::from_fn(|joint| q[joint] + (next.q[joint] - q[joint]) * MOST / long);
            assert!(step(&last, &q) <= MOST * (1.0 + 1e-12));
            let behind = at(tick).residual(&arm.forward(&q));
            assert!(behind.position < 1.1 * MILLIMETER && behind.orientation < 5e-3, "{tick}: {behind}");
        }
        assert!(arm.residual(&q, &at(tick)).position < 1e-9, "{tick}");
    }
    // Two right angles in steps of `MOST`.
    assert!((58..=64).contains(&slow), "{slow} slow ticks");
}

#[test]
fn the_loop_sees_a_long_step_beside_a_singularity() {
    #[derive(Default, Arm)]
    #[arm(spec = "../specs/kuka_kr6_r700.yaml")]
    struct Kr6;
    #[derive(Default, Arm)]
    #[arm(spec = "../specs/abb_irb140.yaml")]
    struct Irb140;
    check(&Kr6, [0.0, -0.9, 1.2, 0.2, 0.0, -0.4], |q| Kr6.margins(q).map(|margin| margin.value));
    check(&Irb140, [0.0, 0.3, -0.4, 0.2, 0.0, -0.4], |q| Irb140.margins(q).map(|margin| margin.value));
}
