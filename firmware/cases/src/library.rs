//! Functions of the library that work with what an arm gives.

use denhart::numeric::NumericInverse;
use denhart::solve::Tolerances;
use denhart::{Arm, EulerOrder, InverseKinematics, Pose, Scalar, Solution};

use crate::aim::Aim;
use crate::{Bits, Case, Digest, Subject};

/// Digests the solutions of a case and the results of their methods. For each solution these are the turn next to where
/// the arm is, up to four windings within the limits, and the residual. The status of all solutions comes last.
pub fn solutions<S, T, const N: usize>(arm: &S, case: &Case<T, S::Target, N>, digest: &mut Digest)
where
    S: Subject<T, N>,
    S::Target: Aim<T>,
    T: Scalar + Bits,
{
    let solutions = InverseKinematics::inverse(arm, &case.target);
    let each: &[Solution<T, N>] = solutions.as_ref();
    for solution in each {
        digest.add(&solution.next_to(arm, &case.q_ref));
        // Few are enough: an arm with six joints that turn five times has 15,625.
        for winding in solution.windings(arm).take(4) {
            digest.add(&winding);
        }
        digest.add(&arm.residual(&solution.q, &case.target));
    }
    digest.add(&S::status(&solutions));
}

/// The inverse by iteration.
pub fn numeric<A, T, G, const N: usize>(arm: &A, case: &Case<T, G, N>, digest: &mut Digest)
where
    A: Arm<T, N>,
    T: Tolerances + Bits,
{
    // Few steps: in double precision each takes 100,000 instructions without a double-precision unit.
    digest.add(&NumericInverse::new().max_iterations(8).patience(8).solve(arm, &case.pose, &case.q_ref));
}

/// Digests the conversions of a pose, and the poses made from them.
pub fn poses<T: Scalar + Bits, G, const N: usize>(case: &Case<T, G, N>, digest: &mut Digest) {
    each_of_a_pose(&case.pose, &mut |value| digest.add(value));
}

fn each_of_a_pose<T: Scalar + Bits>(pose: &Pose<T>, sink: &mut dyn FnMut(&dyn Bits)) {
    let xyz = pose.translation;
    let nearest = pose.orthonormalized();
    sink(&nearest);
    sink(&pose.inverse());
    sink(&pose.compose(&nearest));
    sink(&pose.residual(&nearest));
    sink(&pose.error_to(&nearest));
    let rpy = pose.rpy();
    sink(&rpy);
    sink(&Pose::from_xyz_rpy(xyz, rpy.angles));
    for order in [EulerOrder::Zyz, EulerOrder::Xyz] {
        let euler = pose.euler(order);
        sink(&euler);
        sink(&Pose::from_xyz_euler(xyz, order, euler.angles));
    }
    let quaternion = pose.quaternion();
    sink(&quaternion);
    sink(&Pose::from_xyz_quaternion(xyz, quaternion));
    let vector = pose.rotation_vector();
    sink(&vector);
    sink(&Pose::from_xyz_rotation_vector(xyz, vector));
    let turn = pose.axis_angle();
    sink(&turn);
    sink(&Pose::from_xyz_axis_angle(xyz, turn.axis, turn.angle));
}
