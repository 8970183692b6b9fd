//! The calls of an arm with a list of given joints.

use denhart::{Arm, Branch, Flags, InverseKinematics, Pose, Status, Target};

/// An iiwa on a rail.
#[derive(Default, Arm)]
#[arm(spec = "arms/given/iiwa_on_a_rail.yaml")]
struct OnARail;

const Q: [f64; 8] = [350.0, 0.2, 0.6, -0.3, -1.2, 0.4, 0.9, 0.1];

fn contains(solutions: &denhart::Solutions<f64, 8, 8>, q: &[f64; 8]) -> bool {
    solutions.iter().any(|solution| solution.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-9 * (1.0 + b.abs())))
}

#[test]
fn the_values_stand_in_the_order_of_the_list() {
    let pose = OnARail.forward(&Q);
    let given = [Q[0], Q[3]];
    let solutions = OnARail.inverse(&pose, given);
    assert!(contains(&solutions, &Q), "{solutions:?}");
    assert!(solutions.iter().all(|solution| solution.q[0] == given[0] && solution.q[3] == given[1]));
    let mut list = OnARail.inverse(&pose, [0.0, 0.0]);
    OnARail.inverse_into(&pose, given, &mut list);
    assert_eq!(list, solutions);
    // A turn more of a given angle is the same angle.
    assert_eq!(OnARail.inverse(&pose, [given[0], given[1] + 2.0 * std::f64::consts::TAU]).len(), solutions.len());
    for solution in &solutions {
        assert_eq!(OnARail.inverse_branch(&pose, given, solution.branch), Ok(*solution));
    }
    assert_eq!(OnARail.inverse_branch(&pose, given, Branch::NONE).ok(), solutions.first().copied());
}

#[test]
fn a_reference_gives_all_of_them() {
    let pose = OnARail.forward(&Q);
    let near = OnARail.inverse_near(&pose, &Q);
    assert!(near.nearest().is_some_and(|solution| solution.q.iter().zip(Q).all(|(a, b)| (a - b).abs() < 1e-9)));
    let mut list = OnARail.inverse(&pose, [0.0, 0.0]);
    OnARail.inverse_near_into(&pose, &Q, &mut list);
    assert_eq!(list, near);
}

#[test]
fn the_trait_takes_an_array() {
    fn solve<A: InverseKinematics<f64, 8, Target = (Pose<f64>, [f64; 2])>>(arm: &A) -> usize {
        let target = arm.target_at(&Q);
        assert_eq!(target.1, [Q[0], Q[3]]);
        assert_eq!(arm.residual(&Q, &target).position, 0.0);
        arm.inverse(&target).as_ref().len()
    }
    assert_eq!(solve(&OnARail), OnARail.inverse(&OnARail.forward(&Q), [Q[0], Q[3]]).len());
    let missed = (OnARail.forward(&Q), [0.0; 2]).missed_by(&OnARail, &Q);
    assert_eq!(missed.position, 0.0);
}

#[test]
fn a_value_out_of_limits_is_flagged_and_one_that_is_no_number_is_a_bad_target() {
    let q = [1600.0, Q[1], Q[2], Q[3], Q[4], Q[5], Q[6], Q[7]];
    let pose = OnARail.forward(&q);
    let solutions = OnARail.inverse(&pose, [q[0], q[3]]);
    assert!(contains(&solutions, &q));
    assert!(solutions.iter().all(|solution| solution.flags.contains(Flags::OUT_OF_LIMITS)), "{solutions:?}");
    assert_eq!(solutions.within_limits().count(), 0);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for given in [[bad, 0.1], [0.1, bad]] {
            let solutions = OnARail.inverse(&pose, given);
            assert_eq!((solutions.status(), solutions.len()), (Status::BadTarget, 0));
        }
        let mut reference = q;
        reference[3] = bad;
        assert_eq!(OnARail.inverse_near(&pose, &reference).status(), Status::BadTarget);
    }
}

#[test]
fn a_grid_of_values_is_walked() {
    let pose = OnARail.forward(&Q);
    let walked: Vec<_> = OnARail.sample_redundancy(&pose, [3, 4]).collect();
    assert_eq!(walked.len(), 12);
    let rails: Vec<f64> = walked.iter().map(|(given, _)| given[0]).collect();
    assert_eq!([rails[0], rails[4], rails[8]], [-1000.0, 0.0, 1000.0]);
    for (given, solutions) in &walked {
        assert_eq!(*solutions, OnARail.inverse(&pose, *given));
    }
    assert!(walked.iter().any(|(_, solutions)| !solutions.is_empty()));
}
