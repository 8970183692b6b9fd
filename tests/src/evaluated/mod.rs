//! An arm evaluated from its file beside its generated code: the same questions have the same answers, to the bit.

pub mod bits;
mod generated;
mod questions;

use std::path::Path;

use denhart::{Arm, Branch, Elbow, InverseKinematics, Margin};
use denhart_dynamic::{DynamicArm, DynamicSolutions, DynamicTarget};

pub use generated::{Generated, NoMargins, Typed};

use crate::inverse::OneBranch;
use crate::random::Random;
use crate::task::Asked;
use generated::Inverse;

/// Joint vectors of an arm.
const POSES: usize = 60;

/// How far a joint vector is from its own target, rad: the rounding of a sum of joint angles.
const AT_TARGET: f64 = 4e-15;

/// The arm of a file, from the folder of this package.
pub fn arm(file: &str) -> DynamicArm {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    DynamicArm::from_file(path).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// [`compare`] of an arm with inverse and its file.
pub fn inverse<A, const N: usize>(
    file: &str,
    margins: fn(&[f64; N]) -> Vec<Margin<f64>>,
    one_branch: Option<OneBranch<A, N>>,
) where
    A: InverseKinematics<f64, N, Target: Asked + Typed> + Default + Send + Sync + 'static,
{
    let arm = arm(file);
    compare(file, &arm, &Generated::with_inverse::<A, N>(&arm, margins, one_branch));
}

/// [`compare`] of an arm without inverse and its file.
pub fn kinematics<A: Arm<f64, N> + Default, const N: usize>(file: &str, margins: fn(&[f64; N]) -> Vec<Margin<f64>>) {
    compare(file, &arm(file), &Generated::kinematics::<A, N>(margins));
}

/// Compares every function at random joint vectors, at those of a grid, and at targets in and out of reach.
pub fn compare(name: &str, arm: &DynamicArm, generated: &Generated) {
    let mut random = Random::named(name);
    assert_eq!(generated.inverse.is_some(), arm.task().is_ok(), "{name}: {:?}", arm.task());
    let mut solutions = 0;
    for round in 0..POSES {
        let q = questions::joints(arm, round, &mut random);
        let at = || format!("{name} at {q:?}");
        assert_eq!(bits::pose(&arm.forward(&q).unwrap()), (generated.forward)(&q), "forward, {}", at());
        assert_eq!(bits::poses(&arm.link_poses(&q).unwrap()), (generated.links)(&q), "link poses, {}", at());
        assert_eq!(bits::rows(&arm.jacobian(&q).unwrap()), (generated.jacobian)(&q), "Jacobian, {}", at());
        let (pose, jacobian) = arm.forward_and_jacobian(&q).unwrap();
        assert_eq!([bits::pose(&pose), bits::rows(&jacobian)].concat(), (generated.both)(&q), "both, {}", at());
        assert_eq!(motion(arm, &q), (generated.motion)(&q), "motion, {}", at());
        let margins = arm.margins(&q).unwrap();
        // An arm without margins says so; generated code has no such method.
        assert!(margins.as_ref().is_none_or(|margins| !margins.is_empty()), "margins, {}", at());
        let margins: Vec<_> =
            margins.unwrap_or_default().into_iter().map(|margin| (margin.name, bits::number(margin.value))).collect();
        assert_eq!(margins, (generated.margins)(&q), "margins, {}", at());
        if let Some(inverse) = &generated.inverse {
            let target = arm.target_at(&q).unwrap();
            let [generated, expected] = inverse.target_at(&target, &arm.held(&q).unwrap(), &q);
            assert_eq!(generated, expected, "target, {}", at());
            let missed = arm.residual(&q, &target).unwrap();
            assert!(missed.position == 0.0 && missed.orientation < AT_TARGET, "{target:?} by {missed}, {}", at());
            for target in questions::targets(&target, round, &mut random) {
                let case = format!("{target:?} and {}", at());
                solutions += ask(&case, arm, inverse.as_ref(), &target, &q, &mut random);
            }
        }
    }
    assert!(generated.inverse.is_none() || solutions > POSES, "{name}: {solutions} solutions");
}

/// Velocities and accelerations of tool and links, the manipulability, and the forms of the Jacobian.
fn motion(arm: &DynamicArm, q: &[f64]) -> Vec<u64> {
    let [qd, qdd] = questions::rates(q);
    let tool = [arm.velocity(q, &qd).unwrap().to_array(), arm.acceleration(q, &qd, &qdd).unwrap().to_array()];
    let links = arm.link_velocities(q, &qd).unwrap().into_iter().map(|link| link.to_array());
    let link_accelerations = arm.link_accelerations(q, &qd, &qdd).unwrap().into_iter().map(|link| link.to_array());
    let motion = tool.into_iter().chain(links).chain(link_accelerations).flatten();
    let jacobians = [arm.jacobian_dot(q, &qd), arm.jacobian_tool(q)].map(|rows| bits::rows(&rows.unwrap()));
    [bits::numbers(motion.chain([arm.manipulability(q).unwrap()])), jacobians.concat()].concat()
}

/// Asks for one target; returns how many solutions it has.
fn ask(
    case: &str,
    arm: &DynamicArm,
    generated: &dyn Inverse,
    target: &DynamicTarget,
    q: &[f64],
    random: &mut Random,
) -> usize {
    let given = &arm.held(q).unwrap();
    let solutions = arm.inverse(target, given).unwrap();
    assert_eq!(bits::listed(&solutions), generated.all(target, given), "inverse, {case}");
    let beside: Vec<f64> = q.iter().map(|q| q + random.uniform(-0.3, 0.3)).collect();
    for reference in [q, &beside] {
        let near = bits::listed(&arm.inverse_near(target, reference).unwrap());
        let held = &arm.held(reference).unwrap();
        assert_eq!(near, generated.near(target, held, reference), "inverse_near, {case}");
        let kept = generated.kept(target, given, reference);
        assert_eq!(kept, [generated.near(target, given, reference), generated.all(target, given)], "one list, {case}");
        let mut list = DynamicSolutions::default();
        arm.inverse_near_into(target, reference, &mut list).unwrap();
        assert_eq!(bits::listed(&list), near, "inverse_near_into, {case}");
        arm.inverse_into(target, given, &mut list).unwrap();
        assert_eq!(list, solutions, "inverse_into, {case}");
        let residual = bits::residual(&arm.residual(reference, target).unwrap());
        assert_eq!(residual, generated.residual(target, given, reference), "residual, {case}");
    }
    // Every branch that has a solution, any branch, and some that have none.
    let others = [Branch::NONE, Branch::NONE.with_elbow(Elbow::Down), Branch::NONE.with_root(4)];
    for branch in solutions.iter().map(|solution| solution.branch).chain(others) {
        let one = arm.inverse_branch(target, given, branch).ok();
        let one = one.map(|one| one.map(|solution| bits::evaluated(&solution)).map_err(bits::status));
        assert_eq!(one, generated.branch(target, given, branch), "inverse_branch {branch}, {case}");
    }
    solutions.len()
}
