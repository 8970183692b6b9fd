//! The search in `f32`: nothing but `f32`, and a stated share of joint vectors is lost.

use denhart_core::meet::Meet;
use denhart_core::{Chain, Transform};

use crate::arms;
use crate::support::{Arm, Random, solutions};

fn single(transform: &Transform<f64>) -> Transform<f32> {
    Transform {
        rotation: transform.rotation.map(|row| row.map(|x| x as f32)),
        translation: transform.translation.map(|x| x as f32),
    }
}

const POSES: usize = 4000;

#[test]
fn at_most_one_joint_vector_in_a_hundred_is_lost() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let chain = Chain { links: arm.chain.links.map(|link| single(&link)), is_prismatic: [false; 6], reach: 1.0 };
        let meet = Meet::of(&arm.structure, &arm.structure.ring(&chain.links, &Transform::IDENTITY)).unwrap();
        assert_eq!(meet.has_equal_pairs, arm.meet.has_equal_pairs);
        let mut random = Random(777);
        let (mut lost, mut most) = (0, 0);
        for _ in 0..POSES {
            let joints = random.joints().map(|angle| angle as f32);
            let target = chain.pose(&joints);
            let [k1, ..] = arm.structure.ring(&chain.links, &target);
            let found = solutions(&chain, &target, |visit| meet.search(&k1, &[0.0; 6], visit));
            lost += usize::from(found.distance(&chain, &joints) > 5e-3);
            most = most.max(found.evaluations);
            assert!(found.is_complete);
        }
        println!("{name}: lost {:.2} percent, at most {most} evaluations", 100.0 * lost as f64 / POSES as f64);
        assert!(lost <= POSES / 100, "{name}: {lost}");
    }
}
