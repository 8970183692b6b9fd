//! Arms that were measured: their axes miss the structure of the table by 1e-3 to 1e-8, and nothing is lost.
//!
//! Each arm of `specs/` gets a `calibration` of random deltas up to `s`, in its length unit over m and in rad.
#![allow(clippy::unwrap_used)]

use std::fmt::Write;

use denhart::{Arm, Branch, Elbow, Flags, InverseBranch, InverseKinematics, Pose, Shoulder, Solution, Status, Wrist};
use denhart_dynamic::DynamicArm;
use denhart_tests::evaluated::{Generated, compare};
use denhart_tests::margins_of;
use denhart_tests::random::Random;

/// Arms of every kind of wrist and elbow.
const ARMS: [(&str, f64); 4] = [("ur5", 1.0), ("ur10", 1.0), ("puma560", 1.0), ("kinova_jaco", 1.0)];

fn spec(arm: &str) -> String {
    std::fs::read_to_string(format!("{}/../specs/{arm}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// The file of an arm with a calibration of random deltas.
fn calibrated(arm: &str, meter: f64, s: f64) -> String {
    let mut random = Random::named(&format!("{arm} {s:e}"));
    let mut text = spec(arm);
    text += "\ncalibration:\n";
    for joint in 1..=6 {
        let [a, d, alpha, theta] = [meter, meter, 1.0, 1.0].map(|unit| unit * random.uniform(-s, s));
        let _ = writeln!(text, "  q{joint}: {{a: {a:e}, alpha: {alpha:e} rad, d: {d:e}, theta: {theta:e} rad}}");
    }
    text
}

fn loses(arm: &DynamicArm, q: &[f64]) -> bool {
    let target = arm.target_at(q).unwrap();
    let found = arm.inverse(&target, &[]).unwrap();
    for solution in found.iter().filter(|solution| solution.is_exact()) {
        let residual = arm.residual(&solution.q, &target).unwrap();
        assert!(residual.position < 1e-11 && residual.orientation < 1e-11, "{q:?} {solution:?} {residual:?}");
    }
    let is_q = |solution: &[f64]| solution.iter().zip(q).all(|(a, b)| denhart::math::wrap(a - b).abs() < 1e-6);
    !found.iter().any(|solution| solution.is_exact() && is_q(&solution.q))
}

/// Of joint vectors beside the singularities of the table so many of a thousand may be lost, as docs/known-gaps.md says.
const MOST_BESIDE: u32 = 4;

/// Where the elbow of a Puma is folded, its wrist is half a millimeter from axis 2, which is nearly free then.
const MOST_BESIDE_FOLD: u32 = 15;

/// Random joint vectors, and those beside the singularities of the table: q5 and q3 within 2e-3 of 0.
#[test]
fn nothing_is_lost() {
    let mut lines = String::new();
    let mut is_good = true;
    for (arm, meter) in ARMS {
        for s in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            let built = DynamicArm::from_yaml(&calibrated(arm, meter, s)).unwrap();
            let mut random = Random::named(&format!("poses of {arm} {s:e}"));
            let mut lost = [0; 3];
            for (family, lost) in lost.iter_mut().enumerate() {
                for _ in 0..1000 {
                    let mut q: Vec<f64> = (0..6).map(|_| random.uniform(-3.1, 3.1)).collect();
                    match family {
                        1 => q[4] = random.uniform(-2e-3, 2e-3),
                        2 => q[2] = random.uniform(-2e-3, 2e-3),
                        _ => {}
                    }
                    *lost += u32::from(loses(&built, &q));
                }
            }
            let [anywhere, wrist, elbow] = lost;
            is_good &= anywhere == 0 && wrist.max(elbow) <= MOST_BESIDE;
            let _ = writeln!(lines, "{arm} {s:e}: lost {lost:?} of 1000 each");
        }
    }
    assert!(is_good, "{lines}");
}

/// A Puma's elbow is straight or folded elsewhere: where the forearm, which is d4 and a3, lies along the upper arm or on it.
#[test]
fn little_is_lost_beside_the_elbow_of_a_puma() {
    let forearm = 0.4318_f64.atan2(0.0203);
    for s in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
        let built = DynamicArm::from_yaml(&calibrated("puma560", 1.0, s)).unwrap();
        let mut random = Random::named(&format!("elbow of puma560 {s:e}"));
        for (elbow, most) in [(-forearm, MOST_BESIDE), (std::f64::consts::PI - forearm, MOST_BESIDE_FOLD)] {
            let mut lost = 0;
            for _ in 0..1000 {
                let mut q: Vec<f64> = (0..6).map(|_| random.uniform(-3.1, 3.1)).collect();
                q[2] = elbow + random.uniform(-2e-3, 2e-3);
                lost += u32::from(loses(&built, &q));
            }
            assert!(lost <= most, "{s:e} beside {elbow}: {lost}");
        }
    }
}

/// The controller's calibration of a UR3 that somebody has published (MyRobotLab/pyrobotlab, issue 145). Its parallel axes have
/// their common normals far away and elsewhere: three thetas that cancel are half a radian, one of them with a whole turn
/// more, and lengths are tens of meters. The arm is off its table by millimeters.
#[test]
fn common_normals_may_be_far_and_turned() {
    let conf = [
        [-0.0002437889919995178, 9.225352853908797e-5, 0.0011561574658940366, 9.143617649837177e-8],
        [0.003811654186423513, 12.062000375761157, 0.0035851898103369975, 0.1784610251230016],
        [0.034503078453104935, 17.67190256417353, 0.003921323365865746, 6.682833498198056],
        [0.00010769461289675805, -29.733996036954487, 0.00040666888810636515, -0.5781169826097925],
        [-0.00019873663320566314, -2.8164617795367608e-5, -0.0020117039600915376, 6.112998183059604e-6],
        [0.0, 0.00021742047108209983, 0.0, -5.039262128553323e-7],
    ];
    let mut text = spec("ur3");
    text += "\ncalibration:\n";
    for (joint, [a, d, alpha, theta]) in (1..).zip(conf) {
        let _ = writeln!(text, "  q{joint}: {{a: {a}, alpha: {alpha} rad, d: {d}, theta: {theta} rad}}");
    }
    let arm = DynamicArm::from_yaml(&text).unwrap();
    let table = DynamicArm::from_yaml(&spec("ur3")).unwrap();
    let mut random = Random::named("published calibration");
    let mut numbered = 0;
    for pose in 0..600 {
        let mut q: Vec<f64> = (0..6).map(|_| random.uniform(-3.1, 3.1)).collect();
        // Beside a straight wrist names are shared.
        if pose % 6 == 0 {
            q[4] = random.uniform(-2e-3, 2e-3);
        }
        assert!(!loses(&arm, &q), "{q:?}");
        let (own, other) = (arm.forward(&q).unwrap(), table.forward(&q).unwrap());
        let apart = own.residual(&other);
        assert!(apart.position < 4e-3 && apart.orientation < 0.02, "{q:?} {apart:?}");
        // Names are those of the table.
        let found = arm.inverse(&arm.target_at(&q).unwrap(), &[]).unwrap();
        assert!(found.iter().all(|found| found.branch.elbow().is_some() && found.branch.shoulder().is_some()));
        for found in found.iter() {
            let one = arm.inverse_branch(&arm.target_at(&q).unwrap(), &[], found.branch).unwrap().unwrap();
            assert_eq!((&one.q, one.branch), (&found.q, found.branch), "{q:?}");
            numbered += u32::from(found.branch.root().is_some());
        }
    }
    assert!(numbered > 50, "{numbered}");
}

/// A measured arm has the branches of its table, with their names. At an ordinary pose each name is there once, and
/// `inverse_branch` gives its solution.
#[test]
fn branches_have_the_names_of_the_table() {
    for (arm, meter) in [("ur5", 1.0), ("puma560", 1.0), ("stanford", 1.0)] {
        let table = DynamicArm::from_yaml(&spec(arm)).unwrap();
        for s in [1e-3, 1e-4, 1e-5, 1e-7, 1e-8] {
            let built = DynamicArm::from_yaml(&calibrated(arm, meter, s)).unwrap();
            let mut random = Random::named(&format!("names of {arm} {s:e}"));
            let mut poses = 0;
            for _ in 0..300 {
                let q: Vec<f64> = (0..6).map(|_| random.uniform(-3.1, 3.1)).collect();
                let target = built.target_at(&q).unwrap();
                let own = built.inverse(&target, &[]).unwrap();
                let other = table.inverse(&table.target_at(&q).unwrap(), &[]).unwrap();
                let near = |a: &[f64], b: &[f64]| {
                    a.iter().zip(b).all(|(a, b)| denhart::math::wrap(a - b).abs() < f64::max(1e-4, 200.0 * s))
                };
                // Beside a singularity the solutions of the two arms lie apart.
                let is_ordinary = |q: &[f64]| {
                    table.margins(q).unwrap().is_some_and(|all| all.iter().all(|margin| margin.value.abs() > 300.0 * s))
                };
                let has_match = |q: &[f64]| other.iter().any(|other| near(q, &other.q));
                if own.len() != other.len()
                    || !other.iter().all(|other| is_ordinary(&other.q))
                    || !own.iter().all(|own| has_match(&own.q))
                {
                    continue;
                }
                poses += 1;
                for own in own.iter() {
                    let named = other.iter().find(|other| near(&own.q, &other.q)).unwrap();
                    assert_eq!(own.branch, named.branch, "{arm} {s:e} {q:?}");
                    let one = built.inverse_branch(&target, &[], own.branch).unwrap().unwrap();
                    assert_eq!((&one.q[..], one.branch), (&own.q[..], own.branch), "{arm} {s:e} {q:?}");
                }
                // A name that no solution has.
                for elbow in [Elbow::Up, Elbow::Down] {
                    for wrist in [Wrist::Flip, Wrist::NoFlip] {
                        let name = Branch::NONE.with_shoulder(Shoulder::Left).with_elbow(elbow).with_wrist(wrist);
                        let one = built.inverse_branch(&target, &[], name).unwrap();
                        let is_there = own.iter().any(|own| own.branch == name);
                        assert!(is_there == one.is_ok(), "{arm} {s:e} {q:?} {name} {one:?}");
                        assert!(is_there || matches!(one, Err(Status::Unreachable { .. })), "{one:?}");
                    }
                }
            }
            // At 1e-3 margins of an ordinary pose are above 0.3, which few poses have.
            let least = if s == 1e-3 { 40 } else { 200 };
            assert!(poses > least, "{arm} {s:e}: {poses}");
        }
    }
}

/// Lengths with names are those of the table, too.
#[test]
fn a_table_with_parameters_may_be_measured() {
    let calibration = "\ncalibration: {q1: {a: 1e-4}, q4: {d: 1e-4, alpha: 1e-4 rad}}\n";
    let text = spec("ur5").replace("-0.425", "-upper").replace("-0.39225", "-fore");
    let text = text.replace("joints:", "parameters: {upper: 0.425, fore: 0.39225}\njoints:") + calibration;
    let (named, plain) =
        (DynamicArm::from_yaml(&text).unwrap(), DynamicArm::from_yaml(&(spec("ur5") + calibration)).unwrap());
    let target = plain.target_at(&[0.3, -0.7, 1.1, 0.4, -0.9, 0.2]).unwrap();
    let [named, plain] = [named, plain].map(|arm| arm.inverse(&target, &[]).unwrap());
    assert!(named.len() == 8 && named.iter().zip(plain.iter()).all(|(a, b)| a.q == b.q), "{named:?} {plain:?}");
}

/// A measured arm has the task of its table, or none.
#[test]
fn a_calibration_adds_no_task() {
    let planar = "name: arm\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n".to_owned()
        + &"  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n".repeat(3);
    let task = |calibration: &str| {
        let arm = DynamicArm::from_yaml(&(planar.clone() + calibration)).unwrap();
        arm.task().map(str::to_owned).map_err(|error| error.to_string())
    };
    assert_eq!(task("calibration: {q2: {a: 1e-4, d: 1e-4, theta: 0.01}}").as_deref(), Ok("planar_pose"));
    let tilted = task("calibration: {q2: {alpha: 0.01}}").unwrap_err();
    assert!(tilted.contains("`planar_pose` needs axes parallel"), "{tilted}");
    let point = task("inverse: {task: position}\ncalibration: {q2: {alpha: 0.01}}").unwrap_err();
    assert!(point.contains("without `calibration` the arm is singular everywhere"), "{point}");
}

/// Along joint paths through the singularities of the table, from the joint vector of one tick `inverse_near` gives that of
/// the next one, or a solution that is nearer still.
#[test]
fn the_nearest_solution_leads_through_singularities() {
    for (arm, meter) in [("ur5", 1.0), ("puma560", 1.0)] {
        for s in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
            let built = DynamicArm::from_yaml(&calibrated(arm, meter, s)).unwrap();
            let mut random = Random::named(&format!("paths of {arm} {s:e}"));
            for (place, straight) in [&[4][..], &[2], &[2, 4]].into_iter().enumerate() {
                let (mut lost, mut ticks) = (0, 0);
                for _ in 0..4 {
                    let middle: Vec<f64> = (0..6).map(|_| random.uniform(-3.0, 3.0)).collect();
                    let rate: Vec<f64> = (0..6).map(|_| random.uniform(-1.0, 1.0)).collect();
                    // The wrist or the elbow is straight in the middle of the path, or both are.
                    let at = |time: f64| -> Vec<f64> {
                        let moved = |joint: usize| if straight.contains(&joint) { 0.0 } else { middle[joint] };
                        (0..6).map(|joint| moved(joint) + time * rate[joint]).collect()
                    };
                    for tick in -20..20 {
                        let (before, wanted) = (at(f64::from(tick) * 1e-3), at(f64::from(tick + 1) * 1e-3));
                        let found = built.inverse_near(&built.target_at(&wanted).unwrap(), &before).unwrap();
                        let way = |q: &[f64]| q.iter().zip(&before).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                        let nearest = found.iter().filter(|found| found.is_exact()).map(|found| way(&found.q));
                        // Beside a singularity an exact solution is known to some 1e-6 rad along the joints' own motion.
                        lost += u32::from(nearest.fold(f64::INFINITY, f64::min) > way(&wanted) + 1e-6);
                        ticks += 1;
                    }
                }
                // Where wrist and elbow are straight at once, 5 %: docs/known-gaps.md.
                let most = if place == 2 && s <= 1e-6 { ticks / 20 } else { 0 };
                assert!(lost <= most, "{arm} {s:e} {straight:?}: {lost} of {ticks}");
            }
        }
    }
}

macro_rules! measured {
    ($Type:ident $Single:ident $text:ident $file:literal) => {
        #[derive(Default, Arm)]
        #[arm(spec = $file)]
        struct $Type;

        #[derive(Default, Arm)]
        #[arm(spec = $file, scalar = "f32")]
        struct $Single;

        const $text: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $file));
    };
}

measured! { Measured Single MEASURED "arms/measured/measured.yaml" }
measured! { Nearest NearestSingle NEAREST "arms/measured/nearest.yaml" }
measured! { Real RealSingle REAL "arms/measured/real.yaml" }
measured! { Close CloseSingle CLOSE "arms/measured/close.yaml" }
measured! { Bent BentSingle BENT "arms/measured/bent.yaml" }

#[test]
fn generated_code_gives_what_is_evaluated() {
    let arm = DynamicArm::from_yaml(NEAREST).unwrap();
    assert!(arm.program().inverse.as_ref().is_ok_and(|inverse| inverse.off_table.is_some()));
    let one_branch = denhart_tests::branch_of!(Nearest);
    compare("nearest", &arm, &Generated::with_inverse::<Nearest, 6>(&arm, margins_of!(Nearest), one_branch));
    let pose = Nearest.forward(&[0.3, -0.7, 1.1, 0.4, -0.9, 0.2]);
    assert!(NearestSingle.inverse(&NearestSingle.forward(&[0.3, -0.7, 1.1, 0.4, -0.9, 0.2])).status().is_reachable());
    assert_eq!(Nearest.inverse(&pose).len(), 8);
    let arm = DynamicArm::from_yaml(MEASURED).unwrap();
    assert!(arm.program().inverse.as_ref().is_ok_and(|inverse| inverse.of_table.is_some()));
    let one_branch = denhart_tests::branch_of!(Measured);
    compare("measured", &arm, &Generated::with_inverse::<Measured, 6>(&arm, margins_of!(Measured), one_branch));
    let arm = DynamicArm::from_yaml(REAL).unwrap();
    assert!(arm.program().inverse.as_ref().is_ok_and(|inverse| inverse.held_joint.is_some()));
    let one_branch = denhart_tests::branch_of!(Real);
    compare("real", &arm, &Generated::with_inverse::<Real, 6>(&arm, margins_of!(Real), one_branch));
    let arm = DynamicArm::from_yaml(CLOSE).unwrap();
    assert!(arm.program().inverse.as_ref().is_ok_and(|inverse| inverse.of_table.is_some()));
    let one_branch = denhart_tests::branch_of!(Close);
    compare("close", &arm, &Generated::with_inverse::<Close, 6>(&arm, margins_of!(Close), one_branch));
    // In single precision it compiles, and reaches where it stands.
    assert!(BentSingle.inverse(&BentSingle.forward(&[0.3, -0.7, 1.1, 0.4, -0.9, 0.2])).status().is_reachable());
    let arm = DynamicArm::from_yaml(BENT).unwrap();
    let one_branch = denhart_tests::branch_of!(Bent);
    compare("bent", &arm, &Generated::with_inverse::<Bent, 6>(&arm, margins_of!(Bent), one_branch));
}

/// In single precision an exact solution stands beside each of double precision, under its name; of the arm far from its
/// table beside 99.5 % of them.
#[test]
fn single_precision_has_the_same_branches() {
    let (found, all, others) = share("near", &Measured, |pose| Single.inverse(pose).iter().copied().collect());
    assert!(all > 3000 && found == all && others == 0, "{found} of {all}, and {others}");
    let (found, all, _) = share("far", &Real, |pose| RealSingle.inverse(pose).iter().copied().collect());
    assert!(all > 3000 && found * 1000 >= all * 995, "{found} of {all}");
}

/// In single precision, too, a solution has the name of the table's branch on whose side it lies, beside a straight wrist as
/// elsewhere, and `inverse_branch` gives the solution of each name.
#[test]
fn single_precision_names_by_the_side() {
    names_by_the_side("near", MEASURED, &Single);
    names_by_the_side("nearest", NEAREST, &NearestSingle);
    names_by_the_side("far", REAL, &RealSingle);
}

fn names_by_the_side<A>(name: &str, text: &str, arm: &A)
where
    A: InverseBranch<f32, 6> + InverseKinematics<f32, 6, Target = Pose<f32>>,
{
    let table = text.split_once("\ncalibration:").map_or(text, |(table, _)| table);
    let table = DynamicArm::from_yaml(table).unwrap();
    let mut random = Random::named(&format!("names in single precision, {name}"));
    let (mut beside, mut all) = (0, 0);
    for pose in 0..2000 {
        let mut q: [f32; 6] = std::array::from_fn(|_| random.uniform(-3.1, 3.1) as f32);
        if pose % 2 == 0 {
            q[4] = random.uniform(-0.05, 0.05) as f32;
        }
        let target = arm.forward(&q);
        let found = arm.inverse(&target);
        for solution in found.as_ref().iter().filter(|solution| solution.is_exact()) {
            // The shoulder's margin is taken at the pose of the table here, which lies 1e-3 beside that of the arm. The others
            // are of the joints alone.
            for margin in table.margins(&solution.q.map(f64::from)).unwrap().unwrap() {
                let (is_named, unclear) = match margin.name.as_str() {
                    "shoulder" => (solution.branch.shoulder() == Some(Shoulder::of_margin(margin.value)), 0.01),
                    "elbow" => (solution.branch.elbow() == Some(Elbow::of_margin(margin.value)), 1e-6),
                    _ => (solution.branch.wrist() == Some(Wrist::of_margin(margin.value)), 1e-6),
                };
                assert!(is_named || margin.value.abs() < unclear, "{name} {q:?} {solution:?} {margin:?}");
                beside += u32::from(margin.name == "wrist" && margin.value.abs() < 0.05);
            }
            all += 1;
            let one = arm.inverse_branch(&target, solution.branch);
            assert!(
                one.is_ok_and(|one| one.q == solution.q && one.branch == solution.branch),
                "{name} {q:?} {solution:?}"
            );
        }
    }
    assert!(all > 8000 && beside > 2000, "{name}: {beside} of {all}");
}

/// How many of the solutions of an arm at regular poses single precision finds, their number, and how many others it lists.
fn share<A>(name: &str, arm: &A, singles: impl Fn(&Pose<f32>) -> Vec<Solution<f32, 6>>) -> (usize, usize, usize)
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let mut random = Random::named(&format!("measured in single precision, {name}"));
    let (mut found, mut all, mut others, mut boundaries) = (0, 0, 0, 0);
    for _ in 0..1000 {
        let q: [f64; 6] = std::array::from_fn(|_| random.uniform(-3.1, 3.1));
        // At a regular pose rounding decides nothing.
        let pose = arm.forward(&q);
        let doubles = arm.inverse(&pose);
        if doubles.as_ref().iter().any(|solution| arm.manipulability(&solution.q) < 1e-3) {
            continue;
        }
        let single = |row: [f64; 3]| row.map(|x| x as f32);
        let singles = singles(&Pose { rotation: pose.rotation.map(single), translation: single(pose.translation) });
        for single in singles.iter().filter(|single| single.is_exact()) {
            boundaries += usize::from(single.flags.contains(Flags::BOUNDARY));
            let q = single.q.map(f64::from);
            let residual = arm.forward(&q).residual(&pose);
            // Exact in single precision is up to 2.2e-5 rad, or parts of the reach of 1.1 m.
            assert!(residual.position < 2.6e-5 && residual.orientation < 2.4e-5, "{q:?} {residual:?}");
        }
        others += singles.len().saturating_sub(doubles.as_ref().len());
        for solution in doubles.as_ref() {
            let is_near = |other: &[f32; 6]| {
                solution.q.iter().zip(other).all(|(a, b)| denhart::math::wrap(a - f64::from(*b)).abs() < 2e-3)
            };
            let other = singles.iter().find(|other| other.branch == solution.branch && is_near(&other.q));
            found += usize::from(other.is_some_and(Solution::is_exact));
            all += 1;
        }
    }
    // Regular poses have no fold within rounding; where links are off by a millimeter, a pair of the table may merge.
    assert!(boundaries * 1000 <= all, "{name}: {boundaries} of {all}");
    (found, all, others)
}
