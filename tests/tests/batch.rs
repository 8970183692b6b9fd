//! Batches beside single calls: every number has the same bits, on every instruction set of the machine.
#![allow(clippy::unwrap_used)]

use std::f64::consts::FRAC_PI_4;
use std::fs;
use std::path::{Path, PathBuf};

use denhart::batch::{self, BLOCK, BatchArm, BatchInverse, Found, InstructionSet, Lengths, Summary};
use denhart::{Arm, Flags, JointKind, Pose, Status};
use denhart_dynamic::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};
use denhart_tests::random::Random;

/// Targets of each kind: not a multiple of a block.
const TARGETS: usize = BLOCK + 13;

/// Targets of an arm without lanes, whose single calls take long.
const FEW: usize = 5;

/// Stands where nothing may be written.
const UNTOUCHED: f64 = -12345.678;

const KINDS: [Kind; 9] = [
    Kind::Random,
    Kind::Singular,
    Kind::BesideSingular,
    Kind::Edge,
    Kind::BeyondEdge,
    Kind::Far,
    Kind::Drifted,
    Kind::NotFinite,
    Kind::Mixed,
];

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Random,
    Singular,
    BesideSingular,
    Edge,
    BeyondEdge,
    Far,
    Drifted,
    NotFinite,
    /// One of the others for each target.
    Mixed,
}

fn files(folder: &str) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "yaml") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

/// A joint vector for a target of a kind.
fn joints(arm: &DynamicArm, kind: Kind, random: &mut Random) -> Vec<f64> {
    let joint = |(number, (kinds, [low, high])): (usize, (&JointKind, &[f64; 2]))| {
        let most = if *kinds == JointKind::Revolute { 3.1 } else { 1.0 };
        let value = random.uniform(low.max(-most), high.min(most));
        let grid = (value / FRAC_PI_4).round() * FRAC_PI_4;
        match kind {
            Kind::Singular => grid,
            Kind::BesideSingular => grid + random.uniform(-1.0, 1.0) * 10.0_f64.powi(-((random.below(12)) as i32)),
            // Stretched or folded beyond the first joint.
            Kind::Edge | Kind::BeyondEdge if number > 0 => (value / FRAC_PI_4 / 2.0).round() * FRAC_PI_4 * 2.0,
            _ => value,
        }
    };
    arm.joint_kinds().iter().zip(arm.limits()).enumerate().map(joint).collect()
}

/// The numbers of a target.
fn numbers(target: &DynamicTarget) -> Vec<f64> {
    match target {
        DynamicTarget::Pose(pose) => pose.rotation.iter().flatten().chain(&pose.translation).copied().collect(),
        DynamicTarget::Position(point) => point.to_vec(),
        DynamicTarget::PositionAxis(asked) => asked.point.iter().chain(&asked.axis).copied().collect(),
        DynamicTarget::PositionAngle(asked) => asked.point.into_iter().chain([asked.angle]).collect(),
        DynamicTarget::PlanarPose(asked) => vec![asked.x, asked.y, asked.phi],
        DynamicTarget::PlanarPosition(point) => point.to_vec(),
    }
}

/// The target of numbers.
fn target(like: &DynamicTarget, numbers: &[f64]) -> DynamicTarget {
    let mut target = *like;
    let mut numbers = numbers.iter().copied();
    let mut take = |place: &mut f64| *place = numbers.next().unwrap();
    match &mut target {
        DynamicTarget::Pose(pose) => {
            pose.rotation.iter_mut().flatten().chain(&mut pose.translation).for_each(&mut take)
        }
        DynamicTarget::Position(point) => point.iter_mut().for_each(&mut take),
        DynamicTarget::PositionAxis(asked) => asked.point.iter_mut().chain(&mut asked.axis).for_each(&mut take),
        DynamicTarget::PositionAngle(asked) => {
            asked.point.iter_mut().chain([&mut asked.angle]).for_each(&mut take);
        }
        DynamicTarget::PlanarPose(asked) => {
            [&mut asked.x, &mut asked.y, &mut asked.phi].into_iter().for_each(&mut take)
        }
        DynamicTarget::PlanarPosition(point) => point.iter_mut().for_each(&mut take),
    }
    target
}

/// Changes the numbers of a target as its kind has them.
fn changed(numbers: &mut [f64], is_pose: bool, kind: Kind, random: &mut Random) {
    let point = if is_pose { 9..12 } else { 0..numbers.len().min(3) };
    match kind {
        Kind::BeyondEdge => {
            let by = random.pick(&[1.0 + 1e-12, 1.0 + 1e-8, 1.0 + 1e-5, 1.01, 1.3]);
            numbers[point].iter_mut().for_each(|x| *x *= by);
        }
        Kind::Far => {
            let by = random.pick(&[3.0, 8.0, 50.0, 1e9, 1e200]);
            numbers[point].iter_mut().for_each(|x| *x *= by);
        }
        Kind::Drifted => {
            let step = random.pick(&[1e-4, 1e-5, 1e-7, 1e-9, 1e-12, 1e-14]);
            numbers.iter_mut().for_each(|x| *x = (*x / step).round() * step);
        }
        Kind::NotFinite => {
            let place = random.below(numbers.len());
            numbers[place] = random.pick(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300]);
        }
        _ => {}
    }
}

/// Targets, their rows, the values beside them and references.
struct Batch {
    targets: Vec<DynamicTarget>,
    rows: Vec<f64>,
    given: Vec<f64>,
    references: Vec<f64>,
}

impl Batch {
    fn new(arm: &DynamicArm, kind: Kind, count: usize, random: &mut Random) -> Self {
        let mut batch = Batch { targets: Vec::new(), rows: Vec::new(), given: Vec::new(), references: Vec::new() };
        for _ in 0..count {
            let kind = if kind == Kind::Mixed { random.pick(&KINDS) } else { kind };
            let q = joints(arm, kind, random);
            let at = arm.target_at(&q).unwrap();
            let mut row = numbers(&at);
            changed(&mut row, matches!(at, DynamicTarget::Pose(_)), kind, random);
            batch.targets.push(target(&at, &row));
            batch.rows.extend(row);
            let mut given = arm.held(&q).unwrap();
            if random.below(16) == 0 {
                given.iter_mut().for_each(|value| *value += 7.0);
            }
            batch.given.extend(given);
            let beside = |value: &f64| match random.below(40) {
                0 => value + 6.5,
                1 => random.pick(&[f64::NAN, 1e5, 3e8]),
                _ => value + random.uniform(-0.6, 0.6),
            };
            batch.references.extend(q.iter().map(beside));
        }
        batch
    }
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

/// Compares what is found for one target.
fn compare(case: &str, found: &Found, q: &[f64], (status, deviation): (Status<f64>, f64), listed: &[(&[f64], Flags)]) {
    assert_eq!(format!("{:?}", found.status), format!("{status:?}"), "{case}");
    assert!(same(found.deviation, deviation), "{case}: {} {deviation}", found.deviation);
    let flags: Vec<Flags> = listed.iter().map(|(_, flags)| *flags).collect();
    assert_eq!(found.flags(), flags, "{case}, scalar {}", found.scalar);
    assert!(found.flags[listed.len()..].iter().all(|flags| flags.is_empty()), "{case}");
    for (number, (solution, _)) in listed.iter().enumerate() {
        let row = &q[number * solution.len()..][..solution.len()];
        let equal = row.iter().zip(*solution).all(|(a, b)| same(*a, *b));
        assert!(equal, "{case}, solution {number}, scalar {}: {row:?}, expected {solution:?}", found.scalar);
    }
}

fn outcome(expected: &DynamicSolutions) -> (Status<f64>, f64) {
    (expected.status(), expected.deviation())
}

/// Compares every batch of an arm with single calls. Returns how many random targets there were, and took single calls.
fn check(name: &str, arm: &mut DynamicArm) -> (usize, usize) {
    let lanes = arm.inverse_has_lanes().unwrap();
    let (joints, most) = (arm.joints(), arm.max_solutions().unwrap());
    let mut random = Random::named(name);
    let count = if lanes { TARGETS } else { FEW };
    let (mut at_random, mut single) = (0, 0);
    for kind in KINDS {
        let Batch { targets, rows, given, references } = Batch::new(arm, kind, count, &mut random);
        let width = joints * most;
        let all: Vec<_> = (0..count)
            .map(|target| {
                let taken = given.len() / count;
                arm.inverse(&targets[target], &given[target * taken..][..taken]).unwrap()
            })
            .collect();
        let near: Vec<_> = targets
            .iter()
            .zip(references.chunks(joints))
            .map(|(target, reference)| arm.inverse_near(target, reference).unwrap())
            .collect();
        // Without lanes all sets do the same.
        for set in InstructionSet::available().into_iter().flatten().take(if lanes { 4 } else { 1 }) {
            arm.set_instruction_set(set);
            let case = |target: usize| format!("{name}, {kind:?}, {set}, target {target}: {:?}", targets[target]);
            let mut q = vec![UNTOUCHED; count * width];
            let mut found = vec![Found::NOTHING; count];
            let summary = arm.inverse_batch(&rows, &given, &mut q, &mut found).unwrap();
            let mut counted = Summary::default();
            for (target, (found, expected)) in found.iter().zip(&all).enumerate() {
                let listed: Vec<_> = expected.iter().map(|solution| (&*solution.q, solution.flags)).collect();
                compare(&case(target), found, &q[target * width..][..width], outcome(expected), &listed);
                counted.add(found);
            }
            assert_eq!(summary, counted, "{name}, {kind:?}, {set}");
            if kind == Kind::Random {
                at_random += count;
                single += summary.scalar;
            }
            let mut q = vec![UNTOUCHED; count * joints];
            arm.inverse_near_batch(&rows, &references, &mut q, &mut found).unwrap();
            for (target, (found, expected)) in found.iter().zip(&near).enumerate() {
                let nearest = expected.within_limits().next();
                let listed: Vec<_> = nearest.iter().map(|solution| (&*solution.q, solution.flags)).collect();
                let row = &q[target * joints..][..joints];
                compare(&format!("near, {}", case(target)), found, row, outcome(expected), &listed);
            }
        }
    }
    (at_random, single)
}

/// Poses and Jacobians of joint vectors, some of them huge or no numbers.
fn check_forward(name: &str, arm: &mut DynamicArm) {
    let mut random = Random::named(name);
    let n = arm.joints();
    let mut q: Vec<f64> = (0..TARGETS).flat_map(|_| joints(arm, Kind::Random, &mut random)).collect();
    for value in [1e4, 2.1e5, -1e9, f64::NAN, f64::INFINITY] {
        let place = random.below(q.len());
        q[place] = value;
    }
    for set in InstructionSet::available().into_iter().flatten() {
        arm.set_instruction_set(set);
        let (mut poses, mut with) = (vec![UNTOUCHED; 12 * TARGETS], vec![UNTOUCHED; 12 * TARGETS]);
        let (mut jacobians, mut alone_of) = (vec![UNTOUCHED; 6 * n * TARGETS], vec![UNTOUCHED; 6 * n * TARGETS]);
        arm.forward_batch(&q, &mut poses).unwrap();
        arm.forward_and_jacobian_batch(&q, &mut with, &mut jacobians).unwrap();
        arm.jacobian_batch(&q, &mut alone_of).unwrap();
        for (number, q) in q.chunks(n).enumerate() {
            let (pose, jacobian) = arm.forward_and_jacobian(q).unwrap();
            let expected = numbers(&DynamicTarget::Pose(pose));
            let equal = |row: &[f64], expected: &[f64]| row.iter().zip(expected).all(|(a, b)| same(*a, *b));
            let alone = numbers(&DynamicTarget::Pose(arm.forward(q).unwrap()));
            assert!(equal(&poses[12 * number..][..12], &alone), "{name}, {set}, {q:?}");
            assert!(equal(&with[12 * number..][..12], &expected), "{name}, {set}, {q:?}");
            let expected: Vec<f64> = jacobian.iter().flat_map(|row| row.iter().copied()).collect();
            assert!(equal(&jacobians[6 * n * number..][..6 * n], &expected), "{name}, {set}, {q:?}");
            let expected: Vec<f64> = arm.jacobian(q).unwrap().iter().flat_map(|row| row.iter().copied()).collect();
            assert!(equal(&alone_of[6 * n * number..][..6 * n], &expected), "{name}, {set}, {q:?}");
        }
    }
}

/// Checks the arms of a folder. Returns how many of them have an inverse, and lanes for it. Of `ordinary` arms most random
/// targets take lanes; there are made-up ones that are in doubt everywhere.
fn check_folder(folder: &str, ordinary: bool) -> (usize, usize) {
    let (mut inverses, mut lanes) = (0, 0);
    let (mut at_random, mut single) = (0, 0);
    for file in files(folder) {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let mut arm = DynamicArm::from_file(&file).unwrap();
        check_forward(&name, &mut arm);
        if arm.task().is_err() {
            continue;
        }
        inverses += 1;
        let (targets, scalar) = check(&name, &mut arm);
        if arm.inverse_has_lanes().unwrap() {
            lanes += 1;
            at_random += targets;
            single += scalar;
            assert!(
                !ordinary || scalar < targets / 2,
                "{name}: {scalar} of {targets} random targets took single calls"
            );
        }
    }
    assert!(!ordinary || single < at_random / 20, "{folder}: {single} of {at_random} random targets took single calls");
    (inverses, lanes)
}

#[test]
fn published_arms() {
    assert_eq!(check_folder("../specs", true), (56, 44));
}

#[test]
fn made_up_arms() {
    let (inverses, lanes) = check_folder("arms", false);
    assert!(inverses > 200 && lanes > inverses / 4, "{lanes} of {inverses}");
}

/// Five joints whose last equation but one has a second root at some poses only: a lane without it lists no solution of it,
/// whatever its neighbors have.
#[test]
fn a_lane_without_a_second_root_has_none() {
    let mut random = Random::named("second roots");
    let mut compared = 0;
    for case in 0..20 {
        let mut length = |zero: u32| if random.below(4) < zero as usize { 0.0 } else { random.uniform(0.05, 0.4) };
        let [d1, d2, d5] = [length(0), length(1), length(1)];
        let [a1, a2, a3, a4] = [length(2), length(0), length(0), length(1)];
        let mut arm = DynamicArm::from_yaml(&format!(
            "name: five\nconvention: standard\nunits: {{length: m, angle: deg}}\ninverse: {{task: pose}}\njoints:\n\
             \x20 - {{a: {a1}, alpha: 90, d: {d1}, theta: 0}}\n  - {{a: {a2}, alpha: 0, d: {d2}, theta: 0}}\n\
             \x20 - {{a: {a3}, alpha: 0, d: 0, theta: 0}}\n  - {{a: {a4}, alpha: 90, d: 0, theta: 0}}\n\
             \x20 - {{a: 0, alpha: 0, d: {d5}, theta: 0}}\n"
        ))
        .unwrap();
        if !arm.inverse_has_lanes().unwrap() {
            continue;
        }
        compared += 1;
        let rows: Vec<[f64; 12]> = (0..4 * BLOCK)
            .map(|target| {
                let q: [f64; 5] = std::array::from_fn(|_| random.uniform(-3.0, 3.0));
                let q = q.map(|value| if target % 3 == 0 && random.below(2) == 0 { 0.0 } else { value });
                numbers(&arm.target_at(&q).unwrap()).try_into().unwrap()
            })
            .collect();
        let expected: Vec<_> = rows
            .iter()
            .map(|row| arm.inverse(&target(&DynamicTarget::Pose(Pose::identity()), row), &[]).unwrap())
            .collect();
        for set in InstructionSet::available().into_iter().flatten() {
            arm.set_instruction_set(set);
            let width = 5 * arm.max_solutions().unwrap();
            let (mut q, mut found) = (vec![UNTOUCHED; width * rows.len()], vec![Found::NOTHING; rows.len()]);
            arm.inverse_batch(rows.as_flattened(), &[], &mut q, &mut found).unwrap();
            for (number, (found, expected)) in found.iter().zip(&expected).enumerate() {
                let listed: Vec<_> = expected.iter().map(|solution| (&*solution.q, solution.flags)).collect();
                let case = format!("arm {case}, {set}, target {number}");
                compare(&case, found, &q[number * width..][..width], outcome(expected), &listed);
            }
        }
    }
    assert!(compared >= 10, "{compared}");
}

fn ur5() -> DynamicArm {
    DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/ur5.yaml")).unwrap()
}

#[test]
fn slices_of_unlike_lengths_are_named_with_both_lengths() {
    let arm = ur5();
    let text = |error: Result<(), DynamicError>| error.unwrap_err().to_string();
    let mut short = [UNTOUCHED; 23];
    let message = text(arm.forward_batch(&[0.1; 12], &mut short));
    assert_eq!(message, "poses has 23 numbers, but q has 12, 2 rows of 6: expected 24 numbers, 12 a row");
    assert_eq!(short, [UNTOUCHED; 23]);
    assert_eq!(text(arm.forward_batch(&[0.1; 13], &mut short)), "q has 13 numbers, which are no rows of 6");
    let mut poses = [UNTOUCHED; 24];
    let message = text(arm.forward_and_jacobian_batch(&[0.1; 12], &mut poses, &mut [0.0; 71]));
    assert_eq!(message, "jacobians has 71 numbers, but q has 12, 2 rows of 6: expected 72 numbers, 36 a row");
    assert_eq!(poses, [UNTOUCHED; 24]);
    let message = text(arm.jacobian_batch(&[0.1; 12], &mut [0.0; 71]));
    assert_eq!(message, "jacobians has 71 numbers, but q has 12, 2 rows of 6: expected 72 numbers, 36 a row");
    let (mut q, mut found) = ([UNTOUCHED; 96], [Found::NOTHING; 2]);
    let message = text(arm.inverse_batch(&[0.0; 24], &[], &mut q[..95], &mut found).map(drop));
    assert_eq!(message, "q has 95 numbers, but targets has 24, 2 rows of 12: expected 96 numbers, 48 a row");
    let message = text(arm.inverse_batch(&[0.0; 24], &[], &mut q, &mut found[..1]).map(drop));
    assert_eq!(message, "found has 1 numbers, but targets has 24, 2 rows of 12: expected 2 numbers, 1 a row");
    let message = text(arm.inverse_batch(&[0.0; 24], &[1.0], &mut q, &mut found).map(drop));
    assert_eq!(message, "given has 1 numbers, but targets has 24, 2 rows of 12: expected 0 numbers, 0 a row");
    let message = text(arm.inverse_near_batch(&[0.0; 24], &[0.0; 6], &mut q[..12], &mut found).map(drop));
    assert_eq!(message, "q_ref has 6 numbers, but targets has 24, 2 rows of 12: expected 12 numbers, 6 a row");
    assert_eq!(q, [UNTOUCHED; 96]);
    assert_eq!(found, [Found::NOTHING; 2]);
}

#[test]
fn no_pose_is_no_error() {
    let arm = ur5();
    arm.forward_batch(&[], &mut []).unwrap();
    arm.forward_and_jacobian_batch(&[], &mut [], &mut []).unwrap();
    assert_eq!(arm.inverse_batch(&[], &[], &mut [], &mut []).unwrap(), Summary::default());
    assert_eq!(arm.inverse_near_batch(&[], &[], &mut [], &mut []).unwrap(), Summary::default());
}

/// Targets of which every one is in doubt take single calls for more and more blocks; those after them take lanes again.
#[test]
fn lanes_are_left_out_and_tried_again() {
    let arm = ur5();
    let ordinary = numbers(&arm.target_at(&[0.3, -1.1, 1.4, -0.7, 0.9, 0.2]).unwrap());
    let none = vec![f64::NAN; 12];
    let blocks = 40;
    let rows: Vec<f64> = (0..2 * blocks * BLOCK)
        .flat_map(|target| if target < blocks * BLOCK { &none } else { &ordinary })
        .copied()
        .collect();
    let targets = rows.len() / 12;
    let (mut q, mut found) = (vec![0.0; 48 * targets], vec![Found::NOTHING; targets]);
    let summary = arm.inverse_batch(&rows, &[], &mut q, &mut found).unwrap();
    let [first, second] = [&found[..blocks * BLOCK], &found[blocks * BLOCK..]]
        .map(|half| half.iter().filter(|found| found.scalar).count());
    assert_eq!(first, blocks * BLOCK);
    assert!(second < 32 * BLOCK && !found.last().unwrap().scalar, "{second}");
    assert_eq!((summary.scalar, summary.reached), (first + second, blocks * BLOCK));
    assert!(found[blocks * BLOCK..].iter().all(|found| found.count == 8));
}

/// Generated lanes beside the generated scalar functions: arms whose stages are all kernels with a lane form, and two whose
/// inverse has none.
macro_rules! generated {
    ($($name:ident $Type:ident $joints:literal $most:literal $file:literal;)*) => {
        mod generated {
            use super::*;

            $(
                #[derive(Arm)]
                #[arm(spec = $file, batch)]
                struct $Type;

                #[test]
                fn $name() {
                    check_generated::<$Type, $joints, $most>($file, &$Type);
                }
            )*
        }
    };
}

generated! {
    ur5 Ur5 6 8 "../specs/ur5.yaml";
    techman_tm5_700 TechmanTm5700 6 8 "../specs/techman_tm5_700.yaml";
    abb_irb2400 AbbIrb2400 6 8 "../specs/abb_irb2400.yaml";
    puma560 Puma560 6 8 "../specs/puma560.yaml";
    spherical_shoulder_6r SphericalShoulder6r 6 8 "../specs/spherical_shoulder_6r.yaml";
    stanford Stanford 6 8 "../specs/stanford.yaml";
    scara ScaraRrrp 4 2 "../specs/scara_rrrp_325_275.yaml";
    scorbot_er5 ScorbotEr5 5 4 "../specs/scorbot_er5.yaml";
    gen3r_sphwrist Gen3rSphwrist 6 8 "../specs/gen3r_sphwrist.yaml";
    ufactory_xarm6 UfactoryXarm6 6 16 "../specs/ufactory_xarm6.yaml";
}

fn check_generated<A: BatchArm<N> + BatchInverse<N, S>, const N: usize, const S: usize>(file: &str, arm: &A) {
    let dynamic = DynamicArm::from_file(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
    let mut random = Random::named(file);
    let mut q: Vec<[f64; N]> =
        (0..TARGETS).map(|_| joints(&dynamic, Kind::Random, &mut random).try_into().unwrap()).collect();
    for value in [1e4, 2.1e5, -1e9, f64::NAN, f64::INFINITY] {
        let place = random.below(q.len());
        q[place][random.below(N)] = value;
    }
    let all_same = |pose: &Pose<f64>, expected: &Pose<f64>| {
        let numbers = |pose: &Pose<f64>| numbers(&DynamicTarget::Pose(*pose));
        numbers(pose).iter().zip(&numbers(expected)).all(|(a, b)| same(*a, *b))
    };
    let mut poses = vec![Pose::identity(); TARGETS];
    for set in InstructionSet::available().into_iter().flatten() {
        batch::forward_with(set, arm, &q, &mut poses).unwrap();
        for (q, pose) in q.iter().zip(&poses) {
            assert!(all_same(pose, &arm.forward(q)), "{file}, {set}, {q:?}");
        }
    }
    let mut both = vec![arm.forward_and_jacobian(&[0.0; N]); TARGETS];
    batch::forward_and_jacobian(arm, &q, &mut both).unwrap();
    for (q, (pose, jacobian)) in q.iter().zip(&both) {
        let (expected, of_single) = arm.forward_and_jacobian(q);
        let rows = jacobian.rows.iter().flatten().zip(of_single.rows.iter().flatten());
        assert!(all_same(pose, &expected) && rows.into_iter().all(|(a, b)| same(*a, *b)), "{file}, {q:?}");
    }
    for kind in KINDS {
        let Batch { targets, references, .. } = Batch::new(&dynamic, kind, TARGETS, &mut random);
        let references: &[[f64; N]] = references.as_chunks().0;
        let targets: Vec<Pose<f64>> = targets
            .iter()
            .map(|target| match target {
                DynamicTarget::Pose(pose) => *pose,
                other => panic!("{other:?}"),
            })
            .collect();
        for set in InstructionSet::available().into_iter().flatten() {
            let (mut q, mut found) = (vec![[[UNTOUCHED; N]; S]; TARGETS], vec![Found::NOTHING; TARGETS]);
            let summary = batch::inverse_with(set, arm, &targets, &mut q, &mut found).unwrap();
            let mut counted = Summary::default();
            for (number, (target, (q, found))) in targets.iter().zip(q.iter().zip(&found)).enumerate() {
                let expected = arm.inverse(target);
                let listed: Vec<_> = expected.iter().map(|solution| (&solution.q[..], solution.flags)).collect();
                let case = format!("{file}, {kind:?}, {set}, target {number}: {target:?}");
                compare(&case, found, q.as_flattened(), (expected.status(), expected.deviation()), &listed);
                counted.add(found);
            }
            assert_eq!(summary, counted, "{file}, {kind:?}, {set}");
            let in_lanes = |most: usize| match dynamic.inverse_has_lanes().unwrap() {
                true => kind != Kind::Random || summary.scalar < most,
                false => summary.scalar == TARGETS,
            };
            assert!(in_lanes(TARGETS / 4), "{file}, {set}: {summary:?}");
            let mut q = vec![[UNTOUCHED; N]; TARGETS];
            let summary = batch::inverse_near_with(set, arm, &targets, references, &mut q, &mut found).unwrap();
            let mut counted = Summary::default();
            for (number, ((target, reference), (q, found))) in
                targets.iter().zip(references).zip(q.iter().zip(&found)).enumerate()
            {
                let expected = arm.inverse_near(target, reference);
                let nearest = expected.iter().find(|solution| solution.is_within_limits());
                let listed: Vec<_> = nearest.iter().map(|solution| (&solution.q[..], solution.flags)).collect();
                let case = format!("near, {file}, {kind:?}, {set}, target {number}: {target:?} {reference:?}");
                compare(&case, found, q, (expected.status(), expected.deviation()), &listed);
                counted.add(found);
            }
            assert_eq!(summary, counted, "near, {file}, {kind:?}, {set}");
            assert!(in_lanes(TARGETS / 2), "near, {file}, {set}: {summary:?}");
        }
    }
    let (mut q, mut found) = (vec![[[UNTOUCHED; N]; S]; 2], [Found::NOTHING; 2]);
    let unlike = batch::inverse(arm, &[Pose::identity(); 3], &mut q, &mut found);
    assert_eq!(unlike, Err(Lengths { read: 3, written: 2 }));
    assert!(q.as_flattened().iter().flatten().all(|number| *number == UNTOUCHED));
    assert_eq!(unlike.unwrap_err().to_string(), "slices of 3 and of 2 rows: a call takes slices of one length");
    assert_eq!(batch::inverse(arm, &[], &mut [], &mut []), Ok(Summary::default()));
    let mut nearest = [[UNTOUCHED; N]; 2];
    for (references, places) in [(3, 2), (1, 2), (2, 1)] {
        let places = nearest.get_mut(..places).unwrap();
        let unlike = batch::inverse_near(arm, &[Pose::identity(); 2], &vec![[0.0; N]; references], places, &mut found);
        let written = if references == 2 { 1 } else { references };
        assert_eq!(unlike, Err(Lengths { read: 2, written }));
    }
    assert_eq!(nearest, [[UNTOUCHED; N]; 2]);
    assert_eq!(batch::inverse_near(arm, &[], &[], &mut [], &mut []), Ok(Summary::default()));
}

/// A slide without weight whose way to the reference overflows: the distance is no number.
#[derive(Arm)]
#[arm(
    yaml = "
name: unweighted
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose, weights: {q3: 0}}
joints:
  - {type: revolute, a: 0, alpha: -90, d: 0.1, theta: 0, limits: [-170, 170]}
  - {type: revolute, a: 0, alpha: 90, d: 0.154, theta: 0, limits: [-170, 170]}
  - {type: prismatic, a: 0.0203, alpha: 0, d: 0, theta: -90, limits: [-0.3, 0.3]}
  - {type: revolute, a: 0, alpha: -90, d: 0, theta: 0, limits: [-170, 170]}
  - {type: revolute, a: 0, alpha: 90, d: 0, theta: 0, limits: [-90, 90]}
  - {type: revolute, a: 0, alpha: 0, d: 0, theta: 0, limits: [-170, 170]}
",
    batch
)]
struct Unweighted;

#[test]
fn a_distance_that_is_no_number_is_no_nearer() {
    let mut random = Random::named("unweighted");
    let q: Vec<[f64; 6]> = (0..64)
        .map(|_| std::array::from_fn(|joint| random.uniform(-1.0, 1.0) * if joint == 2 { 0.3 } else { 1.5 }))
        .collect();
    let targets: Vec<Pose<f64>> = q.iter().map(|q| Unweighted.forward(q)).collect();
    let references: Vec<[f64; 6]> = q.iter().map(|q| [q[0], q[1], -f64::MAX, q[3], q[4], q[5]]).collect();
    for set in InstructionSet::available().into_iter().flatten() {
        let (mut nearest, mut found) = (vec![[UNTOUCHED; 6]; 64], vec![Found::NOTHING; 64]);
        batch::inverse_near_with(set, &Unweighted, &targets, &references, &mut nearest, &mut found).unwrap();
        for ((target, reference), (nearest, found)) in targets.iter().zip(&references).zip(nearest.iter().zip(&found)) {
            let single = Unweighted.inverse_near(target, reference);
            let expected = single.within_limits().next().map(|solution| solution.q);
            assert_eq!((found.count > 0).then_some(*nearest), expected, "{set}: {target:?} {reference:?}");
        }
    }
}
