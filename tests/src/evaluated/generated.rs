//! A generated arm behind pointers, so that the comparison compiles once and not once an arm.

use std::fmt::Debug;

use denhart::{Arm, Branch, InverseKinematics, Jacobian, Margin, PlanarPose, PointAngle, PointAxis, Pose};
use denhart_dynamic::{DynamicArm, DynamicTarget};

use super::bits::{self, Answer, Bits};
use super::questions;
use crate::inverse::{self, Derived, OneBranch};
use crate::sweep::arm;
use crate::task;

type OfJoints<R> = Box<dyn Fn(&[f64]) -> R>;

/// The generated functions, their results as bits.
pub struct Generated {
    pub(super) forward: OfJoints<Vec<u64>>,
    pub(super) links: OfJoints<Vec<u64>>,
    pub(super) jacobian: OfJoints<Vec<u64>>,
    pub(super) both: OfJoints<Vec<u64>>,
    pub(super) motion: OfJoints<Vec<u64>>,
    pub(super) margins: OfJoints<Vec<(String, u64)>>,
    pub(super) inverse: Option<Box<dyn Inverse>>,
}

/// The generated inverse. `given`: the values beside the target.
pub(super) trait Inverse {
    fn all(&self, target: &DynamicTarget, given: &[f64]) -> Answer;
    fn near(&self, target: &DynamicTarget, given: &[f64], q_ref: &[f64]) -> Answer;
    /// `near` and `all` into one list, one after the other.
    fn kept(&self, target: &DynamicTarget, given: &[f64], q_ref: &[f64]) -> [Answer; 2];
    fn branch(&self, target: &DynamicTarget, given: &[f64], branch: Branch) -> Option<Result<Bits, (u8, u64)>>;
    fn residual(&self, target: &DynamicTarget, given: &[f64], q: &[f64]) -> [u64; 2];
    /// The numbers of the target at `q`, and of the target that is expected there.
    fn target_at(&self, target: &DynamicTarget, given: &[f64], q: &[f64]) -> [Vec<u64>; 2];
}

/// A target as a generated arm takes it.
pub trait Typed: Clone + Debug {
    /// Converts a target; `given`: the values beside it.
    fn typed(target: &DynamicTarget, given: &[f64]) -> Self;
    /// Its numbers.
    fn bits(&self) -> Vec<u64>;
}

macro_rules! typed {
    ($($Variant:ident($Target:ty), |$target:ident| $numbers:expr;)*) => {$(
        impl Typed for $Target {
            fn typed(target: &DynamicTarget, given: &[f64]) -> Self {
                match (target, given) {
                    (DynamicTarget::$Variant(target), []) => *target,
                    (other, given) => panic!("the evaluated arm asks for `{}` and {given:?}", other.task()),
                }
            }

            fn bits(&self) -> Vec<u64> {
                let $target = *self;
                bits::numbers($numbers)
            }
        }
    )*};
}

typed! {
    Pose(Pose<f64>), |pose| pose.rotation.into_iter().flatten().chain(pose.translation);
    Position([f64; 3]), |point| point;
    PositionAxis(PointAxis<f64>), |asked| asked.point.into_iter().chain(asked.axis);
    PositionAngle(PointAngle<f64>), |asked| asked.point.into_iter().chain([asked.angle]);
    PlanarPose(PlanarPose<f64>), |asked| [asked.x, asked.y, asked.phi];
    PlanarPosition([f64; 2]), |point| point;
}

impl<T: Typed> Typed for (T, f64) {
    fn typed(target: &DynamicTarget, given: &[f64]) -> Self {
        let [value] = given else { panic!("the evaluated arm takes one value beside the target") };
        (T::typed(target, &[]), *value)
    }

    fn bits(&self) -> Vec<u64> {
        [self.0.bits(), vec![bits::number(self.1)]].concat()
    }
}

impl<T: Typed, const K: usize> Typed for (T, [f64; K]) {
    fn typed(target: &DynamicTarget, given: &[f64]) -> Self {
        (T::typed(target, &[]), given.try_into().expect("as many values as the list has joints"))
    }

    fn bits(&self) -> Vec<u64> {
        [self.0.bits(), bits::numbers(self.1)].concat()
    }
}

fn array<const N: usize>(q: &[f64]) -> &[f64; N] {
    q.try_into().expect("as many values as joints")
}

fn of_joints<R: 'static, B: 'static, const N: usize>(call: fn(&[f64; N]) -> R, bits: fn(R) -> B) -> OfJoints<B> {
    Box::new(move |q| bits(call(array(q))))
}

/// The inverse of an arm with `N` joints and the target `T`.
struct OfSize<T, const N: usize>(Box<dyn inverse::Inverse<N, Target = T>>);

impl<T: Typed, const N: usize> Inverse for OfSize<T, N> {
    fn all(&self, target: &DynamicTarget, given: &[f64]) -> Answer {
        bits::answer(&self.0.all(&T::typed(target, given)))
    }

    fn near(&self, target: &DynamicTarget, given: &[f64], q_ref: &[f64]) -> Answer {
        bits::answer(&self.0.near(&T::typed(target, given), array(q_ref)))
    }

    fn kept(&self, target: &DynamicTarget, given: &[f64], q_ref: &[f64]) -> [Answer; 2] {
        self.0.kept(&T::typed(target, given), array(q_ref)).map(|answer| bits::answer(&answer))
    }

    fn branch(&self, target: &DynamicTarget, given: &[f64], branch: Branch) -> Option<Result<Bits, (u8, u64)>> {
        let one = self.0.branch(&T::typed(target, given), branch)?;
        Some(one.map(|solution| bits::solution(&solution)).map_err(bits::status))
    }

    fn residual(&self, target: &DynamicTarget, given: &[f64], q: &[f64]) -> [u64; 2] {
        bits::residual(&self.0.residual(&T::typed(target, given), array(q)))
    }

    fn target_at(&self, target: &DynamicTarget, given: &[f64], q: &[f64]) -> [Vec<u64>; 2] {
        [self.0.target_at(array(q)), T::typed(target, given)].map(|target| target.bits())
    }
}

impl Generated {
    /// Pose, links, Jacobian and margins of an arm; these are [`margins_of!`](crate::margins_of).
    pub fn kinematics<A: Arm<f64, N> + Default, const N: usize>(margins: fn(&[f64; N]) -> Vec<Margin<f64>>) -> Self {
        Self {
            forward: of_joints(|q: &[f64; N]| A::default().forward(q), |pose| bits::pose(&pose)),
            links: of_joints(|q: &[f64; N]| A::default().link_poses(q), |poses| bits::poses(&poses)),
            jacobian: of_joints(|q: &[f64; N]| A::default().jacobian(q), |jacobian| bits::jacobian(&jacobian)),
            both: of_joints(
                |q: &[f64; N]| A::default().forward_and_jacobian(q),
                |(pose, jacobian): (Pose<f64>, Jacobian<f64, N>)| {
                    [bits::pose(&pose), bits::jacobian(&jacobian)].concat()
                },
            ),
            motion: of_joints(
                |q: &[f64; N]| {
                    let arm = A::default();
                    let [qd, qdd] = questions::rates(q).map(|rates| *array::<N>(&rates));
                    let links = arm.link_velocities(q, &qd).map(|link| link.to_array());
                    let link_accelerations = arm.link_accelerations(q, &qd, &qdd).map(|link| link.to_array());
                    let tool = [arm.velocity(q, &qd).to_array(), arm.acceleration(q, &qd, &qdd).to_array()];
                    let motion = tool.into_iter().chain(links).chain(link_accelerations).flatten();
                    let jacobians = [bits::jacobian(&arm.jacobian_dot(q, &qd)), bits::jacobian(&arm.jacobian_tool(q))];
                    let manipulability = arm.manipulability(q);
                    [bits::numbers(motion.chain([manipulability])), jacobians.concat()].concat()
                },
                |bits| bits,
            ),
            margins: of_joints(margins, |margins| {
                margins.iter().map(|margin| (margin.name.to_owned(), bits::number(margin.value))).collect()
            }),
            inverse: None,
        }
    }

    /// Kinematics and inverse of `A`, with the task of `arm`.
    pub fn with_inverse<A, const N: usize>(
        arm: &DynamicArm,
        margins: fn(&[f64; N]) -> Vec<Margin<f64>>,
        one_branch: Option<OneBranch<A, N>>,
    ) -> Self
    where
        A: InverseKinematics<f64, N, Target: task::Asked + Typed> + Default + Send + Sync + 'static,
    {
        let kind = arm::kind(arm).expect("an arm with inverse");
        let inverse = OfSize::<A::Target, N>(Box::new(Derived { arm: A::default(), kind, one_branch }));
        Self { inverse: Some(Box::new(inverse)), ..Self::kinematics::<A, N>(margins) }
    }
}

/// `margins` of an arm that has none: the arm's own method is preferred to that of a trait.
pub trait NoMargins<const N: usize> {
    fn margins(&self, _q: &[f64; N]) -> [Margin<f64>; 0] {
        []
    }
}

impl<A: Arm<f64, N>, const N: usize> NoMargins<N> for A {}

/// The function `margins` of an arm by its type, which lists none where the arm has none.
#[macro_export]
macro_rules! margins_of {
    ($Type:ty) => {{
        #[allow(unused_imports)]
        use $crate::evaluated::NoMargins as _;
        |q| <$Type>::default().margins(q).to_vec()
    }};
}
