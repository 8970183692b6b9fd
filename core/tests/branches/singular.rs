//! Folds, families of solutions, and targets that are none.

use denhart_core::math::{sin_cos, wrap};
use denhart_core::transform::{Vector, cross, dot};
use denhart_core::{Chain, Transform};

use crate::arms;
use crate::support::{Arm, Joints, Random, apart};

/// The determinant of the Jacobian.
fn determinant(chain: &Chain<f64>, joints: &Joints) -> f64 {
    let mut a = chain.miss(joints, &chain.pose(joints)).jacobian;
    let mut product = 1.0;
    for k in 0..6 {
        let pivot = (k..6).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs())).unwrap();
        if pivot != k {
            a.swap(pivot, k);
            product = -product;
        }
        product *= a[k][k];
        if product == 0.0 {
            return 0.0;
        }
        let row = a[k];
        for lower in &mut a[k + 1..] {
            let factor = lower[k] / row[k];
            lower.iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
        }
    }
    product
}

/// Joint vectors at which the Jacobian is singular, between random ones.
fn folds(chain: &Chain<f64>, random: &mut Random, count: usize) -> Vec<Joints> {
    let mut folds = Vec::new();
    while folds.len() < count {
        let (a, b) = (random.joints(), random.joints());
        let at = |share: f64| -> Joints { core::array::from_fn(|i| a[i] + share * (b[i] - a[i])) };
        let sign = |share: f64| determinant(chain, &at(share));
        if sign(0.0) * sign(1.0) > 0.0 {
            continue;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if sign(middle) * sign(0.0) > 0.0 { low = middle } else { high = middle }
        }
        folds.push(at(low).map(wrap));
    }
    folds
}

/// The direction in which no joint moves the end: three lengths over reach and three angles.
fn blocked(chain: &Chain<f64>, joints: &Joints) -> [f64; 6] {
    let jacobian = chain.miss(joints, &chain.pose(joints)).jacobian;
    let mut direction = [0.4, -0.3, 0.5, 0.41, 0.33, -0.47];
    // Inverse iteration on J J^T.
    for _ in 0..4 {
        let mut a: [[f64; 7]; 6] = core::array::from_fn(|i| {
            core::array::from_fn(|k| match jacobian.get(k) {
                Some(row) => dot6(&jacobian[i], row) + if i == k { 1e-13 } else { 0.0 },
                None => direction[i],
            })
        });
        for k in 0..6 {
            let row = a[k];
            for (i, other) in a.iter_mut().enumerate() {
                if i != k {
                    let factor = other[k] / row[k];
                    other.iter_mut().zip(row).for_each(|(x, y)| *x -= factor * y);
                }
            }
        }
        let solution: [f64; 6] = core::array::from_fn(|i| a[i][6] / a[i][i]);
        let length = dot6(&solution, &solution).sqrt();
        direction = solution.map(|x| x / length);
    }
    direction
}

fn dot6(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// A pose moved by three lengths over reach and turned by three angles.
fn pushed(pose: &Transform<f64>, [x, y, z, a, b, c]: [f64; 6], reach: f64) -> Transform<f64> {
    let [px, py, pz] = pose.translation;
    let translation = [px + x * reach, py + y * reach, pz + z * reach];
    let angle = dot([a, b, c], [a, b, c]).sqrt();
    let ((sin, cos), axis) = (sin_cos(angle), [a / angle, b / angle, c / angle]);
    let turned = |vector: Vector<f64>| -> Vector<f64> {
        let (across, along) = (cross(axis, vector), dot(axis, vector) * (1.0 - cos));
        core::array::from_fn(|i| cos * vector[i] + sin * across[i] + along * axis[i])
    };
    let columns = pose.axes().map(turned);
    Transform { rotation: Transform { rotation: columns, ..*pose }.axes(), translation }
}

#[test]
fn folds_are_found_and_part_into_two_solutions_on_one_side() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let folds = folds(&arm.chain, &mut Random(8), 60);
        let found = |joints: &Joints| arm.solve(&arm.chain.pose(joints), &[0.0; 6]).distance(&arm.chain, joints) < 1e-2;
        let at = folds.iter().filter(|joints| found(joints)).count();
        println!("{name}: {at} of 60 folds");
        assert!(at >= 59, "{name}: {at}");
        for push in [1e-10, 1e-7, 1e-5] {
            let (mut two, mut missed, mut far) = (0, 0, 0);
            for joints in &folds {
                let (pose, direction) = (arm.chain.pose(joints), blocked(&arm.chain, joints));
                let counts = [push, -push].map(|push| {
                    let target = pushed(&pose, direction.map(|x| x * push), arm.chain.reach);
                    let found = arm.solve(&target, &[0.0; 6]);
                    far += usize::from(found.nearest > 10.0 * f64::abs(push) + 1e-9);
                    let near = 0.3 + 6.0 * f64::abs(push).sqrt();
                    found.list.iter().filter(|other| apart(&arm.chain, other, joints) < near).count()
                });
                two += usize::from(counts.iter().any(|count| *count >= 2));
                missed += usize::from(counts == [0, 0]);
            }
            println!("{name}, pushed by {push:.0e}: two on one side {two}, none on both {missed}, far {far}");
            // Far off, the two solutions may have left the neighborhood of a flat fold.
            let least = if push < 1e-6 { 57 } else { 53 };
            assert!(two >= least && missed == 0, "{name} {push:.0e}: {two} {missed}");
            assert!(far <= if push < 1e-6 { 1 } else { 8 }, "{name} {push:.0e}: {far}");
        }
    }
}

/// Axis 6 on axis 1: joints 1 and 6 turn the same axis, and joint 6 is free.
#[test]
fn the_held_joint_is_free_where_its_axis_is_another_one() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(3);
        let mut count = 0;
        // Joints 2 to 5 bring axis 6 onto axis 1, up to a displacement and a turn along it.
        let [_, after_first, b, c, d, after_fifth, _] = arm.chain.links;
        let links = [Transform::IDENTITY, Transform::IDENTITY, after_first, b, c, d, after_fifth];
        let between = Chain::new(links, [true, false, false, false, false, false]);
        for _ in 0..4000 {
            let start = random.joints();
            let coaxial = between.refined(&start, &Transform::IDENTITY, 40);
            if coaxial.residual > 1e-13 || count == 60 {
                continue;
            }
            count += 1;
            let [_, _, q2, q3, q4, q5] = coaxial.joints;
            let joints = [start[0], q2, q3, q4, q5, start[1]].map(wrap);
            let found = arm.solve(&arm.chain.pose(&joints), &joints);
            assert!(found.is_free, "{name}: {joints:?}");
            let distance = found.distance(&arm.chain, &joints);
            assert!(distance < 1e-6, "{name}: {joints:?} {distance:.0e}");
        }
        println!("{name}: {count} poses");
        assert!(count >= 20, "{name}");
    }
}

/// A CRX stretched upwards: W is on axis 1, and joint 1 is free with joint 4.
#[test]
fn joint_1_is_free_where_it_turns_the_wrist_about_itself() {
    for name in ["crx10", "crx5"] {
        let arm = Arm::of(arms::named(name));
        let mut random = Random(12);
        for _ in 0..200 {
            let quarter = core::f64::consts::FRAC_PI_2;
            let mut joints = random.joints();
            joints[1] = 0.0;
            joints[2] = if random.unit() < 0.5 { quarter } else { -quarter };
            let found = arm.solve(&arm.chain.pose(&joints), &joints);
            let distance = found.distance(&arm.chain, &joints);
            assert!(found.is_free && distance < 1e-6, "{name}: {joints:?} {distance:.0e}");
        }
    }
}

#[test]
fn targets_that_are_no_rotation_or_out_of_reach_give_no_solution() {
    for (name, chain) in arms::meet() {
        let arm = Arm::of(chain);
        let mut random = Random(6);
        for _ in 0..50 {
            let pose = arm.chain.pose(&random.joints());
            let mirrored = Transform { rotation: pose.rotation.map(|row| row.map(|x| -x)), ..pose };
            let scaled = Transform { rotation: pose.rotation.map(|row| row.map(|x| 1.1 * x)), ..pose };
            let flat = Transform { rotation: [[0.0; 3]; 3], ..pose };
            let far = Transform { translation: pose.translation.map(|x| 50.0 * x + 20.0), ..pose };
            for target in [mirrored, scaled, flat, far] {
                assert!(arm.solve(&target, &[0.0; 6]).list.is_empty(), "{name}");
            }
            for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
                let mut target = pose;
                target.translation[1] = bad;
                assert!(arm.solve(&target, &[0.0; 6]).list.is_empty(), "{name}");
                let mut target = pose;
                target.rotation[2][0] = bad;
                assert!(arm.solve(&target, &[0.0; 6]).list.is_empty(), "{name}");
            }
        }
    }
}
