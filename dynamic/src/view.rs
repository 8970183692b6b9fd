//! An arm known at run time, as code that is generic over arms takes it.

use denhart::solve::{AllLocked, Goal, Pointing};
use denhart::{
    Arm, Branch, CombinedLimit, Deviation, InverseBranch, InverseKinematics, Jacobian, JointKind, JointMask,
    OneSolution, Pose, Residual, Solution, Status,
};
use denhart_codegen::lower::{self, Inverse};
use denhart_codegen::model::MOST_JOINTS;

use crate::solver::{held, in_plane};
use crate::{DynamicArm, DynamicError, DynamicSolution, DynamicSolutions, DynamicTarget, Joints};

/// A view of an arm with `N` joints and an inverse, by [`DynamicArm::view`].
///
/// The view implements the traits of generated arms. Each function gives what [`DynamicArm`]'s own of its name gives, to the
/// bit. The constants of the traits cannot depend on the file: [`LIMITS`](Arm::LIMITS) is infinite,
/// [`JOINT_KINDS`](Arm::JOINT_KINDS) says that all joints turn, [`JOINT_NAMES`](Arm::JOINT_NAMES) numbers them. Limits, kinds
/// and names of the file are those of [`limits`](Arm::limits), [`joint_kinds`](Arm::joint_kinds) and
/// [`DynamicArm::joint_names`].
///
/// A view by [`DynamicArm::padded_view`] may have more joints than the arm. Those beyond the arm's own move nothing, and their
/// limits hold them at 0.
///
/// ```
/// use denhart::{Arm, InverseKinematics, Solution};
/// use denhart_dynamic::{DynamicArm, DynamicError};
///
/// /// The joint vector nearest to `q` that reaches the tool's place at `goal`.
/// fn next<A: InverseKinematics<f64, N>, const N: usize>(arm: &A, goal: &[f64; N], q: &[f64; N]) -> Option<[f64; N]> {
///     arm.inverse_near(&arm.target_at(goal), q).as_ref().first().map(|solution| solution.q)
/// }
///
/// # fn main() -> Result<(), DynamicError> {
/// let arm = DynamicArm::from_yaml(
///     "
/// name: elbow
/// convention: standard
/// units: {length: m, angle: deg}
/// joints:
///   - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-90, 90]}
///   - {a: 0.2, alpha: 0, d: 0, theta: 0}
/// ",
/// )?;
/// let view = arm.view::<2>()?;
/// assert!(view.limits()[0][1] < 1.6);
/// assert!(next(&view, &[0.4, -1.1], &[0.5, -1.0]).is_some_and(|[q1, _]| (q1 - 0.4).abs() < 1e-12));
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct DynamicView<'a, const N: usize> {
    arm: &'a DynamicArm,
    limits: [[f64; 2]; N],
    kinds: [JointKind; N],
    combined_limits: Vec<CombinedLimit<f64, N>>,
}

impl DynamicArm {
    /// A view for code that is generic over arms with `N` joints.
    ///
    /// # Errors
    /// [`DynamicError::Joints`] if `N` is not the number of joints; an arm without inverse.
    pub fn view<const N: usize>(&self) -> Result<DynamicView<'_, N>, DynamicError> {
        if self.joints() != N {
            return Err(DynamicError::Joints { expected: self.joints(), found: N });
        }
        self.padded_view()
    }

    /// A view with `N` joints of an arm that has as many or fewer: one instance of generic code for arms of any number of
    /// joints. Joints beyond the arm's own move nothing, and their limits hold them at 0.
    ///
    /// # Errors
    /// [`DynamicError::Joints`] if the arm has more than `N` joints; an arm without inverse.
    pub fn padded_view<const N: usize>(&self) -> Result<DynamicView<'_, N>, DynamicError> {
        self.task()?;
        if self.joints() > N {
            return Err(DynamicError::Joints { expected: self.joints(), found: N });
        }
        let (mut limits, mut kinds) = ([[0.0; 2]; N], [JointKind::Revolute; N]);
        for (place, own) in limits.iter_mut().zip(self.limits()) {
            *place = *own;
        }
        for (place, own) in kinds.iter_mut().zip(self.joint_kinds()) {
            *place = *own;
        }
        let combined = |limit: &denhart_codegen::model::CombinedLimit| CombinedLimit {
            factors: array(&limit.factors),
            limits: limit.limits,
        };
        let combined_limits = self.program.model.combined_limits.iter().map(combined).collect();
        Ok(DynamicView { arm: self, limits, kinds, combined_limits })
    }
}

/// A target, with the values that the inverse takes beside it, in the order of [`DynamicArm::given`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WholeTarget {
    /// Where the tool is to be.
    pub target: DynamicTarget,
    /// The values of the redundant joints, or the arm angle; none for most arms.
    pub given: Joints,
}

impl WholeTarget {
    /// A target with these values beside it.
    #[must_use]
    pub fn new(target: DynamicTarget, given: &[f64]) -> Self {
        WholeTarget { target, given: Joints::new(given.iter().copied()) }
    }
}

/// The target of an arm whose inverse takes no value beside it.
impl From<DynamicTarget> for WholeTarget {
    fn from(target: DynamicTarget) -> Self {
        WholeTarget::new(target, &[])
    }
}

/// The solutions of one call to a [`DynamicView`]. An empty list is the answer to no target.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ViewSolutions<const N: usize> {
    found: DynamicSolutions,
    solutions: Vec<Solution<f64, N>>,
}

impl<const N: usize> ViewSolutions<N> {
    /// The outcome of the call with the number of joints taken off.
    #[must_use]
    pub const fn untyped(&self) -> &DynamicSolutions {
        &self.found
    }

    /// Fills the list by a call. A call that fails leaves it empty: to a target of another task there is no answer.
    fn fill(&mut self, call: impl FnOnce(&mut DynamicSolutions) -> Result<(), DynamicError>) {
        if call(&mut self.found).is_err() {
            self.found = DynamicSolutions::default();
        }
        self.solutions.clear();
        self.solutions.extend(self.found.iter().map(typed));
    }

    fn of(call: impl FnOnce(&mut DynamicSolutions) -> Result<(), DynamicError>) -> Self {
        let mut solutions = Self::default();
        solutions.fill(call);
        solutions
    }
}

impl<const N: usize> AsRef<[Solution<f64, N>]> for ViewSolutions<N> {
    fn as_ref(&self) -> &[Solution<f64, N>] {
        &self.solutions
    }
}

fn typed<const N: usize>(solution: &DynamicSolution) -> Solution<f64, N> {
    let DynamicSolution { q, flags, free, branch, residual } = *solution;
    Solution { q: array(&q), flags, free, branch, residual }
}

/// Values of the arm's joints, and 0 of those beyond.
fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    let mut array = [0.0; N];
    for (place, value) in array.iter_mut().zip(values) {
        *place = *value;
    }
    array
}

/// `q1`, `q2` and so on.
const NAMES: [&str; MOST_JOINTS] = ["q1", "q2", "q3", "q4", "q5", "q6", "q7", "q8", "q9", "q10"];

impl<const N: usize> DynamicView<'_, N> {
    fn deviation_from(
        &self,
        program: &Inverse,
        goal: &impl Goal<f64, N>,
        given: &[f64],
        (q, here): (&[f64; N], &(Pose<f64>, Jacobian<f64, N>)),
    ) -> Deviation<f64, N> {
        let mut deviation = match held(&program.given, N, given).as_slice() {
            [] => Deviation::new(goal, q, here),
            held => Deviation::new(&AllLocked::new(goal, held), q, here),
        };
        for beyond in self.arm.joints()..N {
            deviation.given.insert(JointMask::single(beyond));
        }
        deviation
    }

    /// The values of the arm's own joints.
    fn own<'q>(&self, q: &'q [f64; N]) -> &'q [f64] {
        q.get(..self.arm.joints()).unwrap_or(q)
    }

    /// Motor values at joint values, as of [`DynamicArm::to_motor`]; joints beyond the arm's own stay.
    #[must_use]
    pub fn to_motor(&self, q: &[f64; N]) -> [f64; N] {
        self.linked(q, DynamicArm::to_motor)
    }

    /// Joint values at motor values.
    #[must_use]
    pub fn from_motor(&self, motor: &[f64; N]) -> [f64; N] {
        self.linked(motor, DynamicArm::from_motor)
    }

    fn linked(&self, values: &[f64; N], function: fn(&DynamicArm, &[f64]) -> Result<Joints, DynamicError>) -> [f64; N] {
        let mut all = *values;
        let own = function(self.arm, self.own(values)).ok();
        for (place, value) in all.iter_mut().zip(own.iter().flat_map(|own| own.iter())) {
            *place = *value;
        }
        all
    }

    /// The arm that is viewed.
    #[must_use]
    pub const fn arm(&self) -> &DynamicArm {
        self.arm
    }

    const NAMES: [&'static str; N] = {
        let mut names = [""; N];
        let mut joint = 0;
        while joint < N && joint < MOST_JOINTS {
            names[joint] = NAMES[joint];
            joint += 1;
        }
        names
    };
}

const NO_POSE: Pose<f64> = Pose { rotation: [[f64::NAN; 3]; 3], translation: [f64::NAN; 3] };

const fn no_jacobian<const N: usize>() -> Jacobian<f64, N> {
    Jacobian { rows: [[f64::NAN; N]; 6] }
}

/// The arm gets the values of as many joints as it has, so no function of joint values fails.
impl<const N: usize> Arm<f64, N> for DynamicView<'_, N> {
    const LIMITS: [[f64; 2]; N] = [[f64::NEG_INFINITY, f64::INFINITY]; N];
    const JOINT_NAMES: [&'static str; N] = Self::NAMES;
    const JOINT_KINDS: [JointKind; N] = [JointKind::Revolute; N];

    fn limits(&self) -> [[f64; 2]; N] {
        self.limits
    }

    fn joint_kinds(&self) -> [JointKind; N] {
        self.kinds
    }

    fn forward(&self, q: &[f64; N]) -> Pose<f64> {
        self.arm.pose(self.own(q))
    }

    fn link_poses(&self, q: &[f64; N]) -> [Pose<f64>; N] {
        let own = self.arm.link_poses(self.own(q)).unwrap_or_default();
        let mut links = [own.last().copied().unwrap_or(NO_POSE); N];
        for (place, link) in links.iter_mut().zip(own) {
            *place = link;
        }
        links
    }

    fn jacobian(&self, q: &[f64; N]) -> Jacobian<f64, N> {
        self.arm.jacobian(self.own(q)).map_or(no_jacobian(), |rows| Jacobian { rows: rows.map(|row| array(&row)) })
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose<f64>, Jacobian<f64, N>) {
        let typed = |(pose, rows): (_, crate::DynamicJacobian)| (pose, Jacobian { rows: rows.map(|row| array(&row)) });
        self.arm.forward_and_jacobian(self.own(q)).map_or((NO_POSE, no_jacobian()), typed)
    }
}

impl<const N: usize> InverseKinematics<f64, N> for DynamicView<'_, N> {
    type Target = WholeTarget;
    type Solutions = ViewSolutions<N>;

    /// That of any arm; [`DynamicArm::max_solutions`] has the arm's own.
    const MAX_SOLUTIONS: usize = 16;

    const TAKES_VALUES: bool = true;

    fn inverse(&self, target: &WholeTarget) -> ViewSolutions<N> {
        ViewSolutions::of(|found| self.arm.inverse_into(&target.target, &target.given, found))
    }

    fn inverse_into(&self, target: &WholeTarget, solutions: &mut ViewSolutions<N>) {
        solutions.fill(|found| self.arm.inverse_into(&target.target, &target.given, found));
    }

    fn inverse_near(&self, target: &WholeTarget, q_ref: &[f64; N]) -> ViewSolutions<N> {
        ViewSolutions::of(|found| self.arm.inverse_near_into(&target.target, self.own(q_ref), found))
    }

    fn inverse_near_into(&self, target: &WholeTarget, q_ref: &[f64; N], solutions: &mut ViewSolutions<N>) {
        solutions.fill(|found| self.arm.inverse_near_into(&target.target, self.own(q_ref), found));
    }

    fn residual(&self, q: &[f64; N], target: &WholeTarget) -> Residual<f64> {
        let missed = Residual { position: f64::NAN, orientation: f64::NAN };
        self.arm.residual(self.own(q), &target.target).unwrap_or(missed)
    }

    fn target_at(&self, q: &[f64; N]) -> WholeTarget {
        let target = self.arm.target_at(self.own(q)).unwrap_or(DynamicTarget::Pose(NO_POSE));
        WholeTarget::new(target, &self.arm.held(self.own(q)).unwrap_or_default())
    }

    fn deviation(&self, q: &[f64; N], target: &WholeTarget, here: &(Pose<f64>, Jacobian<f64, N>)) -> Deviation<f64, N> {
        let none = Deviation { twist: [f64::NAN; 6], jacobian: no_jacobian(), given: JointMask::NONE };
        let Ok(program) = self.arm.inverse_program() else { return none };
        let given = &target.given;
        match (&program.goal, &target.target) {
            (_, DynamicTarget::Pose(goal)) => self.deviation_from(program, goal, given, (q, here)),
            (_, DynamicTarget::Position(goal)) => self.deviation_from(program, goal, given, (q, here)),
            (lower::Goal::PositionAxis { column }, DynamicTarget::PositionAxis(target)) => {
                self.deviation_from(program, &Pointing::new(target, *column), given, (q, here))
            }
            (goal, DynamicTarget::PositionAngle(target)) => {
                self.deviation_from(program, &in_plane(goal, target), given, (q, here))
            }
            (_, DynamicTarget::PlanarPose(goal)) => self.deviation_from(program, goal, given, (q, here)),
            (_, DynamicTarget::PlanarPosition(goal)) => self.deviation_from(program, goal, given, (q, here)),
            _ => none,
        }
    }

    fn inverse_branch_near_into(
        &self,
        target: &WholeTarget,
        branch: Branch,
        q_ref: &[f64; N],
        keeps_place: bool,
        solutions: &mut ViewSolutions<N>,
    ) {
        let WholeTarget { target, given, .. } = target;
        solutions.fill(|found| {
            self.arm.inverse_branch_near_into(target, given, branch, self.own(q_ref), keeps_place, found)
        });
    }

    fn factors(&self, q: &[f64; N], factors: &mut [f64]) -> usize {
        let margins = self.arm.margins(self.own(q)).ok().flatten().unwrap_or_default();
        for (factor, margin) in factors.iter_mut().zip(&margins) {
            *factor = margin.value;
        }
        margins.len()
    }

    fn wrist_factor(&self) -> Option<usize> {
        self.arm.wrist_factor()
    }

    fn combined_limits(&self) -> &[CombinedLimit<f64, N>] {
        &self.combined_limits
    }

    fn status(solutions: &ViewSolutions<N>) -> Status<f64> {
        solutions.found.status()
    }

    fn is_complete(solutions: &ViewSolutions<N>) -> bool {
        solutions.found.is_complete()
    }
}

/// An arm whose inverse holds a joint has no branches: its answer is [`Status::BadTarget`] always.
impl<const N: usize> InverseBranch<f64, N> for DynamicView<'_, N> {
    fn inverse_branch(&self, target: &WholeTarget, branch: Branch) -> OneSolution<f64, N> {
        let answer = self.arm.inverse_branch(&target.target, &target.given, branch);
        answer.unwrap_or(Err(Status::BadTarget)).as_ref().map(typed).map_err(|status| *status)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn spec(name: &str) -> DynamicArm {
        DynamicArm::from_file(format!("{}/../specs/{name}.yaml", env!("CARGO_MANIFEST_DIR"))).unwrap()
    }

    /// Debug prints every bit but those of numbers that are none.
    fn same(left: impl std::fmt::Debug, right: impl std::fmt::Debug) {
        let right = format!("{right:?}").replace("DynamicSolution {", "Solution {");
        assert_eq!(format!("{left:?}"), right);
    }

    /// The calls of generic code, and the arm's own.
    fn check<const N: usize>(name: &str) {
        let arm = spec(name);
        let view = arm.view::<N>().unwrap();
        assert_eq!((view.limits().as_slice(), view.joint_kinds().as_slice()), (arm.limits(), arm.joint_kinds()));
        let (mut kept, mut untyped) = (ViewSolutions::<N>::default(), DynamicSolutions::default());
        let mut exact = 0;
        for round in 0..40 {
            let value = |joint: usize, of: f64| ((round * (joint + 2)) as f64 * of % 1.0 - 0.5) * 4.0;
            let q: [f64; N] = std::array::from_fn(|joint| value(joint, 0.618));
            let near: [f64; N] = std::array::from_fn(|joint| value(joint, 0.414));
            same(view.forward(&q), arm.forward(&q).unwrap());
            same(view.link_poses(&q), arm.link_poses(&q).unwrap());
            let (pose, rows) = arm.forward_and_jacobian(&q).unwrap();
            same((pose, rows), {
                let (pose, jacobian) = view.forward_and_jacobian(&q);
                (pose, jacobian.rows)
            });
            same(view.jacobian(&q).rows, arm.jacobian(&q).unwrap());
            let target = view.target_at(&q);
            same((target.target, &*target.given), (arm.target_at(&q).unwrap(), arm.held(&q).unwrap()));
            view.inverse_into(&target, &mut kept);
            arm.inverse_into(&target.target, &target.given, &mut untyped).unwrap();
            assert_eq!(kept, view.inverse(&target));
            same(kept.as_ref(), &*untyped);
            exact += kept.as_ref().iter().filter(|solution| solution.is_exact()).count();
            same(DynamicView::<N>::status(&kept), untyped.status());
            for solution in kept.as_ref() {
                let one = view.inverse_branch(&target, solution.branch);
                same(one, arm.inverse_branch(&target.target, &target.given, solution.branch).unwrap());
                same(view.residual(&solution.q, &target), arm.residual(&solution.q, &target.target).unwrap());
            }
            view.inverse_near_into(&target, &near, &mut kept);
            same(kept.as_ref(), &*arm.inverse_near(&target.target, &near).unwrap());
            assert_eq!(kept, view.inverse_near(&target, &near));
        }
        assert!(exact >= 40, "{name}: {exact}");
    }

    #[test]
    fn a_view_gives_what_the_arm_gives() {
        check::<2>("planar2r");
        check::<3>("planar3r");
        check::<4>("scara_rrrp_325_275");
        check::<5>("scorbot_er5");
        check::<6>("ur5");
        check::<7>("kuka_iiwa7_r800");
    }

    #[test]
    fn a_prismatic_joint_is_one_in_generic_code() {
        let arm = spec("scara_rrrp_325_275");
        let view = arm.view::<4>().unwrap();
        assert_eq!(view.joint_kinds()[3], JointKind::Prismatic);
        let solution =
            Solution { q: [0.1, 0.2, 0.3, 0.05], ..view.inverse(&view.target_at(&[0.0, 1.0, 0.0, 0.05])).as_ref()[0] };
        assert!(solution.display_for(&view).to_string().contains("0.050000"), "{}", solution.display_for(&view));
        assert!(solution.windings(&view).all(|q| q[3] == 0.05));
        // A stroke is not turned towards its reference.
        assert_eq!(solution.next_to(&view, &[0.0, 0.0, 0.0, 9.0]).q[3], 0.05);
    }

    #[test]
    fn a_view_of_another_number_of_joints_is_refused() {
        let arm = spec("ur5");
        assert_eq!(arm.view::<5>().unwrap_err(), DynamicError::Joints { expected: 6, found: 5 });
        let view = arm.view::<6>().unwrap();
        assert_eq!(DynamicView::<6>::JOINT_NAMES, ["q1", "q2", "q3", "q4", "q5", "q6"]);
        let other = WholeTarget::from(DynamicTarget::Position([0.1; 3]));
        assert_eq!(DynamicView::<6>::status(&view.inverse(&other)), Status::BadTarget);
        assert!(view.inverse(&other).as_ref().is_empty() && view.residual(&[0.0; 6], &other).position.is_nan());
    }

    /// A follower of an arm with joints beyond its own takes the same steps.
    fn follows_alike<const N: usize>(name: &str, start: [f64; N]) {
        use denhart::follow::{FollowSettings, Follower, Rates};
        let arm = spec(name);
        let (own, padded) = (arm.view::<N>().unwrap(), arm.padded_view::<8>().unwrap());
        let settings = FollowSettings::new(1e-3, Rates { velocity: [2.0; N], acceleration: [16.0; N] });
        let mut follower = Follower::new(&own, settings, &start).unwrap();
        let settings = FollowSettings::new(1e-3, Rates { velocity: [2.0; 8], acceleration: [16.0; 8] });
        let wide: [f64; 8] = array(&start);
        let mut other = Follower::new(&padded, settings, &wide).unwrap();
        let (mut found, mut list) = (ViewSolutions::default(), ViewSolutions::default());
        let mut exact = 0;
        for tick in 0..400 {
            let mut q = start;
            for (joint, q) in q.iter_mut().enumerate() {
                *q += 0.4 * (0.01 * f64::from(tick) * (1.0 + joint as f64)).sin() * f64::from(tick / 100 % 2);
            }
            let target = own.target_at(&q);
            let [left, right] =
                [follower.step(&own, &target, &mut found).residual, other.step(&padded, &target, &mut list).residual];
            let apart = follower.q().iter().zip(other.q()).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(apart < 1e-9 && (left.position - right.position).abs() < 1e-9, "{name} tick {tick}: {apart}");
            assert!(other.q()[N..].iter().all(|q| *q == 0.0));
            exact += usize::from(left.position == 0.0);
        }
        assert!((100..400).contains(&exact), "{name}: {exact}");
    }

    #[test]
    fn joints_beyond_the_arm_change_no_step() {
        follows_alike("ur5", [0.3, -1.2, 1.4, -0.5, 0.9, 0.2]);
        follows_alike("planar3r", [0.3, 0.8, -0.6]);
        follows_alike("scara_rrrp_325_275", [0.3, 0.8, -0.6, 0.05]);
        follows_alike("kuka_iiwa7_r800", [0.3, 0.5, 0.2, -1.1, 0.3, 0.8, 0.1]);
        assert_eq!(spec("ur5").padded_view::<5>().unwrap_err(), DynamicError::Joints { expected: 6, found: 5 });
    }

    #[derive(denhart::Arm, Default)]
    #[arm(spec = "../specs/ur5.yaml")]
    struct Ur5;

    #[derive(denhart::Arm, Default)]
    #[arm(spec = "../specs/planar4r_redundant.yaml")]
    struct Planar4r;

    /// Compares the methods that followers call.
    fn followed<A, const N: usize>(name: &str, generated: &A, whole: impl Fn(&WholeTarget) -> A::Target)
    where
        A: InverseKinematics<f64, N>,
    {
        let arm = spec(name);
        let view = arm.view::<N>().unwrap();
        let mut lists = (view.inverse(&view.target_at(&[0.1; N])), generated.inverse(&generated.target_at(&[0.1; N])));
        for round in 0..20 {
            let value = |joint: usize, of: f64| ((round * (joint + 2)) as f64 * of % 1.0 - 0.5) * 4.0;
            let q: [f64; N] = std::array::from_fn(|joint| value(joint, 0.618));
            let near: [f64; N] = std::array::from_fn(|joint| value(joint, 0.414));
            let target = view.target_at(&q);
            let here = view.forward_and_jacobian(&near);
            same(view.deviation(&near, &target, &here), generated.deviation(&near, &whole(&target), &here));
            let (mut ours, mut theirs) = ([0.0; 4], [0.0; 4]);
            assert_eq!(view.factors(&q, &mut ours), generated.factors(&q, &mut theirs));
            assert_eq!(ours, theirs);
            assert_eq!(view.wrist_factor(), generated.wrist_factor());
            view.inverse_given_near_into(&target, &near, &mut lists.0);
            generated.inverse_given_near_into(&whole(&target), &near, &mut lists.1);
            same(lists.0.as_ref(), lists.1.as_ref());
            let branch = lists.1.as_ref().first().map_or(Branch::NONE, |solution| solution.branch);
            for keeps_place in [true, false] {
                view.inverse_branch_near_into(&target, branch, &near, keeps_place, &mut lists.0);
                generated.inverse_branch_near_into(&whole(&target), branch, &near, keeps_place, &mut lists.1);
                same(lists.0.as_ref(), lists.1.as_ref());
            }
        }
        assert!(view.factors(&[0.3; N], &mut [0.0; 4]) > 0);
    }

    #[test]
    fn followers_see_in_a_view_what_they_see_in_generated_code() {
        followed::<Ur5, 6>("ur5", &Ur5, |target| match target.target {
            DynamicTarget::Pose(pose) => pose,
            _ => NO_POSE,
        });
        followed::<Planar4r, 4>("planar4r_redundant", &Planar4r, |target| match target.target {
            DynamicTarget::PlanarPose(pose) => (pose, target.given[0]),
            _ => (denhart::PlanarPose::new(f64::NAN, 0.0, 0.0), 0.0),
        });
    }
}
