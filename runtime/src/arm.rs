//! Traits of generated arms, for code that is generic over the arm.

use crate::branch::Branch;
use crate::combined_limit::CombinedLimit;
use crate::deviation::Deviation;
use crate::dh::JointKind;
use crate::jacobian::Jacobian;
use crate::math::{Scalar, radians};
use crate::motion::{Acceleration, Twist};
use crate::pose::Pose;
use crate::solution::{OneSolution, Residual, Solution, Status};

/// Forward kinematics of an arm with `N` joints in scalar `T`.
///
/// The functions are the arm's own of the same names. They never panic; a joint value that is not finite gives a result
/// that is not finite.
///
/// ```
/// use denhart::{Arm, Pose};
/// # use denhart::{Jacobian, JointKind, math};
/// #
/// # /// One revolute joint about z and a link of 0.5 m along x.
/// # struct Lever;
/// #
/// # impl Arm<f64, 1> for Lever {
/// #     const LIMITS: [[f64; 2]; 1] = [[-1.0, 1.0]];
/// #     const JOINT_NAMES: [&'static str; 1] = ["q1"];
/// #     const JOINT_KINDS: [JointKind; 1] = [JointKind::Revolute];
/// #     fn forward(&self, &[q1]: &[f64; 1]) -> Pose<f64> {
/// #         let (s1, c1) = math::sin_cos(q1);
/// #         Pose {
/// #             rotation: [[c1, -s1, 0.0], [s1, c1, 0.0], [0.0, 0.0, 1.0]],
/// #             translation: [0.5 * c1, 0.5 * s1, 0.0],
/// #         }
/// #     }
/// #     fn link_poses(&self, q: &[f64; 1]) -> [Pose<f64>; 1] {
/// #         [self.forward(q)]
/// #     }
/// #     fn jacobian(&self, &[q1]: &[f64; 1]) -> Jacobian<f64, 1> {
/// #         let (s1, c1) = math::sin_cos(q1);
/// #         Jacobian { rows: [[-0.5 * s1], [0.5 * c1], [0.0], [0.0], [0.0], [1.0]] }
/// #     }
/// #     fn forward_and_jacobian(&self, q: &[f64; 1]) -> (Pose<f64>, Jacobian<f64, 1>) {
/// #         (self.forward(q), self.jacobian(q))
/// #     }
/// # }
///
/// /// Velocity of the tool point for given joint rates.
/// fn tool_velocity<A: Arm<f64, N>, const N: usize>(arm: &A, q: &[f64; N], rates: &[f64; N]) -> [f64; 3] {
///     let [vx, vy, vz, ..] = arm.jacobian(q).mul(rates);
///     [vx, vy, vz]
/// }
///
/// assert_eq!(tool_velocity(&Lever, &[0.0], &[2.0]), [0.0, 1.0, 0.0]);
/// let Pose { translation, .. } = Lever.forward(&[0.0]);
/// assert_eq!(translation, [0.5, 0.0, 0.0]);
/// assert_eq!(Lever::joints_from_degrees([90.0]), [core::f64::consts::FRAC_PI_2]);
/// ```
pub trait Arm<T, const N: usize> {
    /// Lowest and highest value of every joint, rad or length unit; infinite where the arm's file has none.
    const LIMITS: [[T; 2]; N];

    /// Names of the joints in order.
    const JOINT_NAMES: [&'static str; N];

    /// Kinds of the joints in order, revolute or prismatic.
    const JOINT_KINDS: [JointKind; N];

    /// Lowest and highest value of every joint of this arm, rad or length unit: [`LIMITS`](Self::LIMITS). A type of
    /// many arms, such as a view of one that is read at run time, has the limits of each here alone.
    #[inline(always)]
    #[must_use]
    fn limits(&self) -> [[T; 2]; N] {
        Self::LIMITS
    }

    /// Kinds of the joints of this arm: [`JOINT_KINDS`](Self::JOINT_KINDS), but for a type of many arms.
    #[inline(always)]
    #[must_use]
    fn joint_kinds(&self) -> [JointKind; N] {
        Self::JOINT_KINDS
    }

    /// Joint values from angles typed in degrees `[N]`: those of revolute joints in rad, strokes as they are.
    ///
    /// Every other function takes `q` in rad: `arm.to_pulses(&Robot::joints_from_degrees([90.0, 45.0, 0.0]))`.
    #[must_use]
    fn joints_from_degrees(mut q: [T; N]) -> [T; N]
    where
        T: Scalar,
    {
        for (value, kind) in q.iter_mut().zip(Self::JOINT_KINDS) {
            if kind == JointKind::Revolute {
                *value = radians(*value);
            }
        }
        q
    }

    /// Pose of the tool in the base frame, through base, all rows and tool.
    ///
    /// `q`: joint values `[N]`, rad or length unit.
    #[must_use]
    fn forward(&self, q: &[T; N]) -> Pose<T>;

    /// Poses of the links in the base frame, `[N]`.
    ///
    /// Link i stands after the base, the rows up to and including joint i, and the fixed rows between joint i and the
    /// next joint. The last link is without the tool.
    #[must_use]
    fn link_poses(&self, q: &[T; N]) -> [Pose<T>; N];

    /// Geometric Jacobian `[6, N]` in the base frame, at the tool point.
    #[must_use]
    fn jacobian(&self, q: &[T; N]) -> Jacobian<T, N>;

    /// [`forward`](Self::forward) and [`jacobian`](Self::jacobian), sharing their terms.
    #[must_use]
    fn forward_and_jacobian(&self, q: &[T; N]) -> (Pose<T>, Jacobian<T, N>);

    /// Velocity of the tool in the base frame, for joint rates `qd` `[N]`, rad/s or length unit / s.
    #[must_use]
    fn velocity(&self, q: &[T; N], qd: &[T; N]) -> Twist<T>
    where
        T: Scalar,
    {
        self.jacobian(q).velocity(qd)
    }

    /// Acceleration of the tool in the base frame, for joint rates `qd` `[N]` and their derivatives `qdd` `[N]`. Its
    /// parts are the second derivative of the position of the tool point and the derivative of the angular velocity.
    #[must_use]
    fn acceleration(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> Acceleration<T>
    where
        T: Scalar,
    {
        self.jacobian(q).acceleration(qd, qdd)
    }

    /// Time derivative of [`jacobian`](Self::jacobian), for joint rates `qd` `[N]`.
    #[must_use]
    fn jacobian_dot(&self, q: &[T; N], qd: &[T; N]) -> Jacobian<T, N>
    where
        T: Scalar,
    {
        self.jacobian(q).derivative(qd)
    }

    /// Geometric Jacobian of the tool point in the axes of the tool.
    #[must_use]
    fn jacobian_tool(&self, q: &[T; N]) -> Jacobian<T, N>
    where
        T: Scalar,
    {
        let (tool, jacobian) = self.forward_and_jacobian(q);
        jacobian.in_frame(&tool.rotation)
    }

    /// Velocities of the link frames `[N]` in the base frame, each at its own origin; the frames are those of
    /// [`link_poses`](Self::link_poses).
    #[must_use]
    fn link_velocities(&self, q: &[T; N], qd: &[T; N]) -> [Twist<T>; N]
    where
        T: Scalar,
    {
        let (tool, jacobian) = self.forward_and_jacobian(q);
        jacobian.link_velocities(&tool, &self.link_poses(q), qd)
    }

    /// Accelerations of the link frames `[N]` in the base frame, each at its own origin.
    #[must_use]
    fn link_accelerations(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> [Acceleration<T>; N]
    where
        T: Scalar,
    {
        let (tool, jacobian) = self.forward_and_jacobian(q);
        jacobian.link_accelerations(&tool, &self.link_poses(q), qd, qdd)
    }

    /// Manipulability of Yoshikawa 1985 over all six rows of the Jacobian, lengths not scaled; see
    /// [`Jacobian::manipulability`]. An arm whose file names a task that counts fewer rows has it over those.
    #[must_use]
    fn manipulability(&self, q: &[T; N]) -> T
    where
        T: Scalar,
    {
        self.jacobian(q).manipulability()
    }
}

/// Inverse kinematics in closed form of an arm with `N` joints in scalar `T`.
///
/// # The longest call
/// A call of [`inverse`](Self::inverse), [`inverse_near`](Self::inverse_near) or
/// [`inverse_branch`](InverseBranch::inverse_branch) takes at most 12 cascades and 200 evaluations of
/// [`forward_and_jacobian`](Arm::forward_and_jacobian). That holds for arguments of any bits. A cascade is one run of the
/// closed form through all branches. An ordinary target takes one cascade and no evaluation. An arm without three
/// consecutive axes that meet or are parallel holds a joint instead, and takes at most 300 evaluations. See
/// [`effort`](crate::effort).
///
/// # Targets
/// A target that is not finite gives [`Status::BadTarget`]. A rotation that is off by more than rounding and by at most
/// 1e-3 is replaced by the nearest rotation. Solutions, flags and residuals refer to that rotation, and
/// [`Solutions::deviation`](crate::Solutions::deviation) says how far off the target was. A rotation further off is a
/// bad target; [`Pose::orthonormalized`] gives the nearest rotation for it too.
///
/// A target out of reach gives [`Status::Unreachable`] with the least gap of a stage. The distance, and where the arm
/// comes closest, are found by [`numeric`](crate::numeric#targets-out-of-reach).
///
/// # Example
/// ```
/// use denhart::{InverseKinematics, Solution, Status};
///
/// /// The joint vector nearest to `q` that reaches the target within the limits.
/// fn next<A, const N: usize>(arm: &A, target: &A::Target, q: &[f64; N]) -> Option<[f64; N]>
/// where
///     A: InverseKinematics<f64, N>,
/// {
///     let solutions = arm.inverse_near(target, q);
///     let reachable = A::status(&solutions) == Status::Reachable;
///     let usable = |s: &&Solution<f64, N>| s.is_exact() && s.is_within_limits();
///     solutions.as_ref().iter().find(usable).map(|s| s.q).filter(|_| reachable)
/// }
/// ```
pub trait InverseKinematics<T, const N: usize>: Arm<T, N> {
    /// Target of an inverse: a [`Pose`], or less where the arm has fewer degrees of freedom.
    type Target;

    /// The list of solutions; its default is an empty one, for the calls that overwrite a list.
    type Solutions: AsRef<[Solution<T, N>]> + Default;

    /// Largest number of solutions of one target.
    const MAX_SOLUTIONS: usize;

    /// True if values come with the target: those of redundant joints, or the arm angle.
    const TAKES_VALUES: bool = false;

    /// Every branch that reaches the target, each once, in the arm's documented order.
    ///
    /// Angles are in `(-pi, pi]`, prismatic values in the length unit.
    #[must_use]
    fn inverse(&self, target: &Self::Target) -> Self::Solutions;

    /// Like [`inverse`](Self::inverse), but overwrites `solutions` and saves a copy.
    ///
    /// A returned list is filled anew in each call, and may be copied. On a Cortex-M4F that takes about 450 instructions
    /// and 700 bytes of stack for six joints in `f32`.
    fn inverse_into(&self, target: &Self::Target, solutions: &mut Self::Solutions) {
        *solutions = self.inverse(target);
    }

    /// Every solution of the target with its joints next to `q_ref`, sorted nearest first.
    ///
    /// Each revolute joint is on the turn nearest to its reference, among turns inside its limits if there are any. A
    /// joint whose reference is outside the limits stays within half a turn of that reference. The distance is
    /// Euclidean. Strokes count relative to the reach, and joints by the weights of the arm's file if it has any.
    ///
    /// Joints that the target does not determine take their value from `q_ref`. A `q_ref` that is not finite gives
    /// [`Status::BadTarget`].
    #[must_use]
    fn inverse_near(&self, target: &Self::Target, q_ref: &[T; N]) -> Self::Solutions;

    /// Like [`inverse_near`](Self::inverse_near), but overwrites `solutions`, see [`inverse_into`](Self::inverse_into).
    fn inverse_near_into(&self, target: &Self::Target, q_ref: &[T; N], solutions: &mut Self::Solutions) {
        *solutions = self.inverse_near(target, q_ref);
    }

    /// Residual of `q` for the target, by the arm's own `forward`. Only the components that the target gives count.
    #[must_use]
    fn residual(&self, q: &[T; N], target: &Self::Target) -> Residual<T>;

    /// The target of the arm's task at joint values `q` `[N]`: where the tool is, as far as the task asks for it.
    ///
    /// With the value of a redundant joint, or the arm angle, that target includes the one of `q`. Away from
    /// singularities [`inverse`](Self::inverse) of the target lists `q`, its angles brought into `(-pi, pi]`.
    #[must_use]
    fn target_at(&self, q: &[T; N]) -> Self::Target;

    /// Twist from the tool at `q` to the target, and its derivative by the joints: as far as the task asks for it. `at`: what
    /// [`forward_and_jacobian`](Arm::forward_and_jacobian) gives at `q`.
    #[must_use]
    fn deviation(&self, q: &[T; N], target: &Self::Target, at: &(Pose<T>, Jacobian<T, N>)) -> Deviation<T, N>;

    /// Like [`inverse_near_into`](Self::inverse_near_into), but values that come with the target, of redundant joints or of
    /// the arm angle, are the target's and not those of `q_ref`.
    fn inverse_given_near_into(&self, target: &Self::Target, q_ref: &[T; N], solutions: &mut Self::Solutions) {
        self.inverse_branch_near_into(target, Branch::NONE, q_ref, true, solutions);
    }

    /// Like [`inverse_given_near_into`](Self::inverse_given_near_into), without computing the branches that differ from
    /// `branch`. Components unset in it match any. The other solution of a spherical wrist, which comes from the first, is
    /// listed too. An arm without [`InverseBranch`] lists every branch.
    ///
    /// Beside a singularity a solution may go by another name than in the whole list: where the branch has none that is of
    /// use, ask for all.
    ///
    /// `keeps_place`: beside a singularity the member of a family of solutions to which `q_ref` leads is listed, as in every list
    /// next to a reference. False: only if it seems to be less than half as far from `q_ref` as the others that are listed. That
    /// saves up to 16 evaluations where `q_ref` is far from every solution.
    ///
    /// The default is for an arm whose target comes without values, and keeps the place.
    fn inverse_branch_near_into(
        &self,
        target: &Self::Target,
        branch: Branch,
        q_ref: &[T; N],
        keeps_place: bool,
        solutions: &mut Self::Solutions,
    ) {
        let _ = (branch, keeps_place);
        self.inverse_near_into(target, q_ref, solutions);
    }

    /// Writes the factors of the determinant of the Jacobian at `q`, as the arm's `margins` have them, and gives their
    /// number; what has no room is left out. A factor is 0 at a singularity of its kind, with opposite signs beside it.
    ///
    /// An arm that has no `margins` gives 0.
    fn factors(&self, _q: &[T; N], _factors: &mut [T]) -> usize {
        0
    }

    /// The place among the [`factors`](Self::factors) of the one that is 0 where the wrist is singular, if there is one.
    #[must_use]
    fn wrist_factor(&self) -> Option<usize> {
        None
    }

    /// Limits of sums of joint values; none where the arm's file has none.
    #[must_use]
    fn combined_limits(&self) -> &[CombinedLimit<T, N>] {
        &[]
    }

    /// Outcome of the call that gave `solutions`.
    #[must_use]
    fn status(solutions: &Self::Solutions) -> Status<T>;

    /// Returns false if a bound of the call that gave `solutions` was reached: further solutions may exist. See
    /// [`Solutions::is_complete`](crate::Solutions::is_complete).
    #[must_use]
    fn is_complete(_solutions: &Self::Solutions) -> bool {
        true
    }
}

/// The inverse on one branch, of an arm whose branches have names that mean the same at the next target.
///
/// Arms with three consecutive axes that meet or are parallel have it. An arm whose inverse holds a joint numbers its
/// solutions anew at each target, and has none.
pub trait InverseBranch<T, const N: usize>: InverseKinematics<T, N> {
    /// The solution of [`inverse`](InverseKinematics::inverse) on one branch, without computing the others, also at singular poses.
    /// The method is meant for control loops that stay on a branch. [`Solution::next_to`] puts the solution on the turn
    /// next to where the arm is.
    ///
    /// Where two branches meet they are one solution, flagged [`BOUNDARY`](crate::Flags::BOUNDARY): the answer to
    /// either. Components unset in `branch` match any value. The first such solution is returned, an exact one if there
    /// is one. Components that the arm does not have are ignored. The number of a root
    /// ([`Branch::root`](crate::Branch::root)) means a branch at one target only: roots are numbered anew at the next.
    ///
    /// # Errors
    /// [`Status::BadTarget`], or [`Status::Unreachable`] with the gap at which the branch ends; the reach of the arm where
    /// the target has no such branch.
    fn inverse_branch(&self, target: &Self::Target, branch: Branch) -> OneSolution<T, N>;
}
