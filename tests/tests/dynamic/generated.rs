//! A generated arm behind pointers, so that the comparison compiles once and not once an arm.

use denhart::{Arm, Branch, InverseKinematics, PlanarPose, PointAngle, PointAxis, Pose, Status};
use denhart_dynamic::DynamicTarget;

use crate::bits::{self, Answer, Bits};

type OfJoints = Box<dyn Fn(&[f64]) -> Vec<u64>>;
type OfTarget<R> = Box<dyn Fn(&DynamicTarget, f64) -> R>;
type OfTargetAndJoints<R> = Box<dyn Fn(&DynamicTarget, f64, &[f64]) -> R>;
type OfTargetAndBranch = Box<dyn Fn(&DynamicTarget, f64, Branch) -> Result<Bits, (u8, u64)>>;

/// The generated functions.
pub struct Generated {
    pub forward: OfJoints,
    pub links: OfJoints,
    pub jacobian: OfJoints,
    pub both: OfJoints,
    pub inverse: Option<Inverse>,
}

/// The generated inverse.
pub struct Inverse {
    pub all: OfTarget<Answer>,
    pub near: OfTargetAndJoints<Answer>,
    pub residual: OfTargetAndJoints<[u64; 2]>,
    /// Of the arms of `specs/`: it is compiled where it is called.
    pub branch: Option<OfTargetAndBranch>,
}

/// A target as a generated arm takes it.
pub trait Asked {
    fn of(target: &DynamicTarget, given: f64) -> Self;
}

macro_rules! asked {
    ($($Variant:ident($Target:ty);)*) => {$(
        impl Asked for $Target {
            fn of(target: &DynamicTarget, _: f64) -> Self {
                match target {
                    DynamicTarget::$Variant(target) => *target,
                    other => panic!("the evaluated arm asks for `{}`", other.task()),
                }
            }
        }
    )*};
}

asked! {
    Pose(Pose<f64>);
    Position([f64; 3]);
    PositionAxis(PointAxis<f64>);
    PositionAngle(PointAngle<f64>);
    PlanarPose(PlanarPose<f64>);
    PlanarPosition([f64; 2]);
}

impl<A: Asked> Asked for (A, f64) {
    fn of(target: &DynamicTarget, given: f64) -> Self {
        (A::of(target, given), given)
    }
}

fn array<const N: usize>(q: &[f64]) -> &[f64; N] {
    q.try_into().expect("as many values as joints")
}

/// Pose, links and Jacobian of an arm.
pub fn kinematics<A: Arm<f64, N> + Default + 'static, const N: usize>() -> Generated {
    Generated {
        forward: Box::new(|q| bits::pose(&A::default().forward(array(q)))),
        links: Box::new(|q| bits::poses(&A::default().link_poses(array(q)))),
        jacobian: Box::new(|q| bits::jacobian(&A::default().jacobian(array(q)))),
        both: Box::new(|q| {
            let (pose, jacobian) = A::default().forward_and_jacobian(array(q));
            [bits::pose(&pose), bits::jacobian(&jacobian)].concat()
        }),
        inverse: None,
    }
}

/// The same with the inverse.
pub fn inverse<A, const N: usize>() -> Generated
where
    A: InverseKinematics<f64, N, Target: Asked> + Default + 'static,
{
    fn answer<A: InverseKinematics<f64, N>, const N: usize>(solutions: &A::Solutions) -> Answer {
        let listed = solutions.as_ref().iter().map(bits::generated).collect();
        Answer { solutions: listed, status: bits::status(A::status(solutions)) }
    }
    let inverse = Inverse {
        all: Box::new(|target, given| answer::<A, N>(&A::default().inverse(&A::Target::of(target, given)))),
        near: Box::new(|target, given, q| {
            answer::<A, N>(&A::default().inverse_near(&A::Target::of(target, given), array(q)))
        }),
        residual: Box::new(|target, given, q| {
            let residual = A::default().residual(array(q), &A::Target::of(target, given));
            [residual.position, residual.orientation].map(bits::number)
        }),
        branch: None,
    };
    Generated { inverse: Some(inverse), ..kinematics::<A, N>() }
}

/// The same with the inverse of one branch.
pub fn branches<A, const N: usize>() -> Generated
where
    A: InverseKinematics<f64, N, Target: Asked> + Default + 'static,
{
    let mut generated = inverse::<A, N>();
    if let Some(inverse) = &mut generated.inverse {
        inverse.branch = Some(Box::new(|target, given, branch| {
            let one = A::default().inverse_branch(&A::Target::of(target, given), branch);
            one.map(|solution| bits::generated(&solution)).map_err(|status: Status<f64>| bits::status(status))
        }));
    }
    generated
}
