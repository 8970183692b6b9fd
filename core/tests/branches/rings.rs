//! A ring cut open elsewhere, and run through backwards.

use denhart_core::math::sin_cos;
use denhart_core::meet::Structure;
use denhart_core::{Chain, Transform};

use crate::arms;
use crate::support::{Arm, Joints, Random, apart, solutions};

/// A transform without any structure.
fn any(random: &mut Random) -> Transform<f64> {
    let tilt = sin_cos(random.within(-3.0, 3.0));
    let translation = core::array::from_fn(|_| random.within(-1.0, 1.0));
    let tilt = Transform { rotation: [[1.0, 0.0, 0.0], [0.0, tilt.1, -tilt.0], [0.0, tilt.0, tilt.1]], translation };
    Transform::IDENTITY.then_turn(sin_cos(random.within(-3.0, 3.0))) * tilt.then_turn(sin_cos(random.within(-3.0, 3.0)))
}

/// `Rx(pi) link^-1 Rx(pi)`
fn reversed(link: &Transform<f64>) -> Transform<f64> {
    let half = Transform { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], translation: [0.0; 3] };
    half * link.inverse() * half
}

/// The chain from tip to base: its joints are those of the chain in reverse order.
fn backwards(chain: &Chain<f64>) -> Chain<f64> {
    let mut links = chain.links;
    links.reverse();
    Chain::new(links.map(|link| reversed(&link)), [false; 6])
}

fn same_lists(a: &[Joints], b: &[Joints], chain: &Chain<f64>) -> bool {
    a.len() == b.len() && a.iter().all(|joints| b.iter().any(|other| apart(chain, joints, other) < 1e-6))
}

#[test]
fn the_mirrored_ring_gives_the_same_list() {
    for (name, chain) in arms::meet() {
        let (arm, mirrored) = (Arm::of(chain), Arm::of(backwards(&chain)));
        assert!(!arm.structure.is_mirrored && mirrored.structure.is_mirrored && mirrored.structure.is_constant);
        let mut random = Random(21);
        for _ in 0..300 {
            let target = arm.chain.pose(&random.joints());
            let ahead = arm.solve(&target, &[0.0; 6]).list;
            let mut back = mirrored.solve(&reversed(&target), &[0.0; 6]).list;
            back.iter_mut().for_each(|joints| joints.reverse());
            assert!(same_lists(&ahead, &back, &arm.chain), "{name}");
        }
    }
}

/// The ring of an arm and a target, cut open at each of its links. The target is then what was a link.
#[test]
fn the_ring_cut_elsewhere_gives_the_same_list() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(22);
        for cut in 0..6 {
            for _ in 0..50 {
                let target = arm.chain.pose(&random.joints());
                let list = arm.solve(&target, &[0.0; 6]).list;
                // The link after each joint; the one after joint `cut` becomes the target.
                let [base, a, b, c, d, e, tip] = arm.chain.links;
                let after = [a, b, c, d, e, tip * target.inverse() * base];
                let mut links = [Transform::IDENTITY; 7];
                (0..5).for_each(|i| links[i + 1] = after[(cut + 1 + i) % 6]);
                let turned = Chain::new(links, [false; 6]);
                let target = after[cut].inverse();
                // The links K2, K3 and K5 have to be known.
                let structure = Structure::of(&turned, [true; 7]);
                assert_eq!(structure.is_none(), [0, 1, 3].contains(&cut), "{name} {cut}");
                let Some(structure) = structure else { continue };
                assert_eq!(structure.is_constant, cut == 5, "{name} {cut}");
                let other = Arm { chain: turned, structure, meet: arm.meet };
                let other = Arm { meet: if cut == 5 { Arm::of(turned).meet } else { other.meet }, ..other };
                let mut found = other.solve(&target, &[0.0; 6]).list;
                found.iter_mut().for_each(|joints| joints.rotate_right(cut + 1));
                assert!(same_lists(&list, &found, &arm.chain), "{name} {cut}: {} {}", list.len(), found.len());
            }
        }
    }
}

/// Made-up rings at all places of the target and in both directions: links that are not parallel or at right angles.
#[test]
fn made_up_rings_lose_nothing() {
    let mut random = Random(23);
    let mut refused = 0;
    for arm in 0..240 {
        let mut ring: [Transform<f64>; 6] = core::array::from_fn(|_| any(&mut random));
        let turn = Transform::IDENTITY.then_turn(sin_cos(random.within(-3.0, 3.0)));
        let flip = Transform { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], translation: [0.0; 3] };
        let parallel = if arm % 2 == 0 { turn } else { turn * flip };
        ring[2] = Transform { translation: ring[2].translation, ..parallel };
        let (wu, wv, z) = (random.within(-1.0, 1.0), random.within(-1.0, 1.0), ring[4].z());
        ring[4].translation = [-wv * z[0], -wv * z[1], wu - wv * z[2]];
        let start = arm % 6;
        let mut links = [Transform::IDENTITY; 7];
        (0..5).for_each(|i| links[i + 1] = ring[(start + i) % 6]);
        let mut chain = Chain::new(links, [false; 6]);
        if arm % 4 >= 2 {
            chain = backwards(&chain);
        }
        let Some(structure) = Structure::of(&chain, [true; 7]) else {
            refused += 1;
            continue;
        };
        for _ in 0..20 {
            let joints = random.joints();
            let target = chain.pose(&joints);
            let ring = structure.ring(&chain.links, &target);
            let meet = denhart_core::meet::Meet::of(&structure, &ring).unwrap();
            let [k1, ..] = ring;
            let found = solutions(&chain, &target, |visit| meet.search(&k1, &[0.0; 6], visit));
            let distance = found.distance(&chain, &joints);
            assert!(distance < 1e-6 && found.list.len().is_multiple_of(2), "{arm}: {joints:?} {distance:.0e}");
        }
    }
    // Three of six places leave K2, K3 or K5 to the target.
    println!("{refused} of 240 refused");
    assert!((120..140).contains(&refused));
}

#[test]
fn links_that_are_not_known_are_not_read() {
    let chain = arms::named("xarm6");
    let structure = |unknown: usize| Structure::of(&chain, core::array::from_fn(|link| link != unknown));
    let at = |unknown| structure(unknown).map(|structure| structure.is_constant);
    assert_eq!([at(0), at(6)], [Some(true); 2]);
    // C1 is K2, C2 is K3, C3 is K4, C4 is K5, C5 is K6.
    assert_eq!([at(3), at(5)], [Some(false); 2]);
    assert_eq!([at(1), at(2), at(4)], [None; 3]);
    let prismatic = Chain { is_prismatic: [false, true, false, false, false, false], ..chain };
    assert_eq!(Structure::of(&prismatic, [true; 7]), None);
}
