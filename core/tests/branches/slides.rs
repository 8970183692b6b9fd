//! Two prismatic joints at every place.

use denhart_core::slides::Slides;
use denhart_core::{Chain, Transform};

use crate::arms;
use crate::support::{EXACT, Random, SAME, Solutions, least_singular_value, solutions};

fn places() -> impl Iterator<Item = [usize; 2]> {
    (0..6).flat_map(|first| (first + 1..6).map(move |second| [first, second]))
}

/// A chain with random links.
fn chain(random: &mut Random, place: [usize; 2]) -> Chain<f64> {
    let mut chain = arms::random(random);
    for joint in place {
        chain.is_prismatic[joint] = true;
    }
    chain.gathered()
}

fn solve(slides: &Slides<f64>, chain: &Chain<f64>, target: &Transform<f64>) -> Solutions {
    solutions(chain, target, |visit| slides.search(target, &[0.0; 6], visit))
}

#[test]
fn no_joint_vector_is_lost_and_no_start_finds_more() {
    let mut random = Random(4);
    for place in places() {
        for _ in 0..20 {
            let chain = chain(&mut random, place);
            let slides = Slides::of(&chain).unwrap();
            for pose in 0..40 {
                let joints = random.joints();
                let target = chain.pose(&joints);
                let found = solve(&slides, &chain, &target);
                let distance = found.distance(&chain, &joints);
                assert!(distance < 1e-5, "{place:?}: {joints:?} {distance:.0e}");
                assert!(found.list.len() <= 8 && found.list.len().is_multiple_of(2) && found.is_complete, "{place:?}");
                assert!(found.sure < 1e-9, "{place:?} {:.0e}", found.sure);
                for _ in 0..if pose < 2 { 20 } else { 0 } {
                    let end = chain.refined(&random.joints(), &target, 40);
                    let is_new = end.residual < EXACT && found.distance(&chain, &end.joints) > 1e-4;
                    assert!(!is_new, "{place:?}: {:?}", end.joints);
                }
            }
        }
    }
}

/// Whichever turning joint is held, the list is the same.
#[test]
fn every_turning_joint_may_be_held() {
    let mut random = Random(9);
    for place in places() {
        let chain = chain(&mut random, place);
        for _ in 0..20 {
            let joints = random.joints();
            let target = chain.pose(&joints);
            for held in 0..6 {
                let slides = Slides::holding(&chain, held);
                assert_eq!(slides.is_none(), chain.is_prismatic[held]);
                let Some(slides) = slides else { continue };
                let distance = solve(&slides, &chain, &target).distance(&chain, &joints);
                assert!(distance < 1e-5, "{place:?}, held {held}: {joints:?} {distance:.0e}");
            }
        }
    }
}

/// Neighboring turning joints that are parallel: another joint is held.
#[test]
fn parallel_axes_choose_the_held_joint() {
    let mut random = Random(10);
    for place in places() {
        for first in 0..5 {
            // The turning joints at the ends of a run of joints whose axes are parallel.
            let mut chain = chain(&mut random, place);
            let second = (first + 1..6).find(|joint| !chain.is_prismatic[*joint]);
            let (false, Some(second)) = (chain.is_prismatic[first], second) else { continue };
            let between = chain.links[first + 1..second].iter().fold(Transform::IDENTITY, |all, link| all * *link);
            let turn = Transform::IDENTITY.then_turn((0.6, 0.8));
            chain.links[second].rotation = (between.inverse() * turn).rotation;
            let slides = Slides::of(&chain).unwrap();
            for _ in 0..20 {
                let joints = random.joints();
                let found = solve(&slides, &chain, &chain.pose(&joints));
                let distance = found.distance(&chain, &joints);
                assert!(distance < 1e-5, "{place:?}, parallel {first} {second}: {joints:?} {distance:.0e}");
            }
        }
    }
}

#[test]
fn chains_without_two_prismatic_joints_are_refused() {
    let mut random = Random(11);
    let mut chain = chain(&mut random, [1, 4]);
    for is_prismatic in [[false; 6], [true; 6], [true, true, true, false, false, false]] {
        chain.is_prismatic = is_prismatic;
        assert_eq!(Slides::of(&chain), None);
    }
}

#[test]
fn targets_that_are_not_finite_have_no_candidates() {
    let mut random = Random(12);
    let chain = chain(&mut random, [0, 3]);
    let slides = Slides::of(&chain).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut target = chain.pose(&random.joints());
        target.translation[0] = bad;
        assert!(solve(&slides, &chain, &target).list.is_empty());
        let mut target = chain.pose(&random.joints());
        target.rotation[1][1] = bad;
        assert!(solve(&slides, &chain, &target).list.is_empty());
    }
}

#[test]
fn single_precision_loses_at_most_four_percent() {
    let mut random = Random(13);
    let (mut lost, mut count) = (0, 0);
    for place in places() {
        for _ in 0..10 {
            let double = chain(&mut random, place);
            let single = |link: &Transform<f64>| Transform {
                rotation: link.rotation.map(|row| row.map(|x| x as f32)),
                translation: link.translation.map(|x| x as f32),
            };
            let links = double.links.each_ref().map(single);
            let chain = Chain { links, is_prismatic: double.is_prismatic, reach: double.reach as f32 };
            let slides = Slides::of(&double).unwrap();
            let slides = Slides { links, turning: slides.turning, prismatic: slides.prismatic };
            for _ in 0..20 {
                let joints = random.joints().map(|joint| joint as f32);
                let target = chain.pose(&joints);
                let found = solutions(&chain, &target, |visit| slides.search(&target, &[0.0; 6], visit));
                count += 1;
                lost += usize::from(found.distance(&chain, &joints) > 2e-2);
            }
        }
    }
    println!("lost {:.1} percent", 100.0 * lost as f64 / count as f64);
    assert!(lost * 25 <= count, "{lost} of {count}");
}

/// Round angles and displacements: many poses are singular, or have axes of turning joints that are parallel.
#[test]
fn no_joint_vector_of_a_grid_is_lost() {
    let mut random = Random(77);
    for place in places() {
        for _ in 0..6 {
            let chain = chain(&mut random, place);
            let slides = Slides::of(&chain).unwrap();
            for step in [30.0, 45.0, 90.0] {
                for _ in 0..40 {
                    let mut joints = random.grid(step);
                    for slide in place {
                        joints[slide] = random.within(-4.0, 4.0).round() * 0.5;
                    }
                    let target = chain.pose(&joints);
                    let found = solutions(&chain, &target, |visit| slides.search(&target, &joints, visit));
                    let sigma = least_singular_value(&chain, &joints);
                    let tolerance = if sigma > 1e-6 { (1e-14 / sigma).max(SAME) } else { 1e-2 };
                    let distance = found.distance(&chain, &joints);
                    assert!(distance <= tolerance, "{place:?}, {step}: {joints:?} {distance:.0e}");
                }
            }
        }
    }
}
