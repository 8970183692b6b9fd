//! Random poses: the joint vector that made the pose is found, and no start of a descent finds more.

use crate::arms;
use crate::support::{Arm, EXACT, Random, SAME};

const POSES: usize = 10_000;

#[test]
fn no_joint_vector_is_lost() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(777);
        let (mut lost, mut odd, mut most, mut incomplete, mut evaluations, mut sure) = (0, 0, 0, 0, 0, Vec::new());
        for _ in 0..POSES {
            let joints = random.joints();
            let found = arm.solve(&arm.chain.pose(&joints), &[0.0; 6]);
            lost += usize::from(found.distance(&arm.chain, &joints) > SAME);
            odd += found.list.len() % 2;
            most = most.max(found.evaluations);
            evaluations += found.evaluations;
            incomplete += usize::from(!found.is_complete);
            sure.push(found.sure);
            assert!(found.list.len() <= 16);
        }
        sure.sort_by(f64::total_cmp);
        println!(
            "{name}: lost {lost}, odd {odd}, incomplete {incomplete}, evaluations {:.1}, most {most}, \
             a sure candidate misses {:.0e} (median), {:.0e} (worst)",
            evaluations as f64 / POSES as f64,
            sure[POSES / 2],
            sure[POSES - 1]
        );
        assert_eq!((lost, odd, incomplete), (0, 0, 0), "{name}");
        assert!(sure[POSES / 2] < 2e-15 && sure[POSES - 1] < 1e-11, "{name}");
        assert!(most <= 250 && evaluations < 10 * POSES, "{name}");
    }
}

#[test]
fn many_starts_find_no_further_solution() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(4242);
        for _ in 0..8 {
            let target = arm.chain.pose(&random.joints());
            let found = arm.solve(&target, &[0.0; 6]);
            for _ in 0..300 {
                let end = arm.chain.refined(&random.joints(), &target, 40);
                let is_new = end.residual < EXACT && found.distance(&arm.chain, &end.joints) > 1e-4;
                assert!(!is_new, "{name}: {:?}", end.joints);
            }
        }
    }
}

#[test]
fn the_list_is_the_same_whatever_was_solved_before() {
    let arm = Arm::of(arms::named("jaco"));
    let mut random = Random(5);
    let targets: Vec<_> = (0..50).map(|_| arm.chain.pose(&random.joints())).collect();
    let lists = |targets: &mut dyn Iterator<Item = _>| -> Vec<_> {
        targets.map(|target| arm.solve(target, &[0.0; 6]).list).collect()
    };
    let (ahead, mut back) = (lists(&mut targets.iter()), lists(&mut targets.iter().rev()));
    back.reverse();
    assert_eq!(ahead, back);
}
