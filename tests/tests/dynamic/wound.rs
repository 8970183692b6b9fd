//! An angle that is asked for loses nothing to its turns. The angle of (-pi, pi] that differs by whole turns stands for
//! it.

use denhart::solve::wrap;
use denhart::{PlanarPose, PointAngle};
use denhart_dynamic::{DynamicArm, DynamicTarget};
use denhart_tests::arms::{Al5d, Planar3r, Planar4rRedundant};

const WOUND: [f64; 9] = [-9.5, 2049.0, 1e6, 62831856.213, -6283185307182.728, 6.28e14, 1e17, -3e200, 1e308];

fn spec(name: &str) -> DynamicArm {
    DynamicArm::from_file(format!("{}/../specs/{name}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

#[test]
fn the_direction_in_the_plane() {
    let evaluated = spec("planar3r");
    for angle in WOUND {
        let at = |phi: f64| PlanarPose::new(20.0, 10.0, phi);
        let [wound, plain] = [angle, wrap(angle)].map(|angle| Planar3r.inverse(&at(angle)));
        assert_eq!(wound, plain, "{angle}");
        assert!(
            plain.status().is_reachable()
                && plain.iter().all(|one| Planar3r.residual(&one.q, &at(angle)).orientation < 1e-12)
        );
        let [wound, plain] =
            [angle, wrap(angle)].map(|angle| evaluated.inverse(&DynamicTarget::PlanarPose(at(angle)), &[]).unwrap());
        assert_eq!(format!("{wound:?}"), format!("{plain:?}"), "{angle}");
    }
}

#[test]
fn the_angle_of_a_tool_that_pitches() {
    let evaluated = spec("al5d");
    let mut reachable = 0;
    for angle in WOUND {
        let at = |angle: f64| PointAngle::new([0.1, -0.15, 0.1], angle);
        let [wound, plain] = [angle, wrap(angle)].map(|angle| Al5d.inverse(&at(angle)));
        assert_eq!(wound, plain, "{angle}");
        reachable += usize::from(plain.status().is_reachable());
        assert!(plain.exact().all(|one| Al5d.residual(&one.q, &at(angle)).orientation < 1e-12), "{angle}");
        let [wound, plain] =
            [angle, wrap(angle)].map(|angle| evaluated.inverse(&DynamicTarget::PositionAngle(at(angle)), &[]).unwrap());
        assert_eq!(format!("{wound:?}"), format!("{plain:?}"), "{angle}");
    }
    assert!(reachable > 0);
}

#[test]
fn the_value_of_a_redundant_joint() {
    let evaluated = spec("planar4r_redundant");
    let target = PlanarPose::new(0.35, 0.4, 0.9);
    let mut reachable = 0;
    for angle in WOUND {
        let [wound, plain] = [angle, wrap(angle)].map(|given| Planar4rRedundant.inverse(&target, given));
        assert_eq!(wound, plain, "{angle}");
        reachable += usize::from(plain.status().is_reachable());
        for solution in &plain {
            assert!(solution.q[0] == wrap(angle), "{angle}: {:?}", solution.q);
            let branch = |given| Planar4rRedundant.inverse_branch(&target, given, solution.branch);
            assert_eq!(branch(angle), branch(wrap(angle)), "{angle}");
        }
        let [wound, plain] =
            [angle, wrap(angle)].map(|given| evaluated.inverse(&DynamicTarget::PlanarPose(target), &[given]).unwrap());
        assert_eq!(format!("{wound:?}"), format!("{plain:?}"), "{angle}");
    }
    assert!(reachable > 0);
}
