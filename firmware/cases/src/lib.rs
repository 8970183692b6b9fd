//! Arguments for the functions of generated arms, the same on the microcontroller and on the host, and digests of
//! results.

#![no_std]

mod aim;
mod compare;
mod digest;
mod family;
mod follow;
mod library;
mod random;

pub use aim::Aim;
pub use compare::{CASES, digests};
pub use digest::{Bits, Digest};
pub use family::{Family, Maker};
pub use follow::{FOLLOWED, Followed, Line, followers};
pub use library::{numeric, poses, solutions};
pub use random::Random;

use denhart::{Branch, InverseKinematics, Pose, Scalar};

/// The arguments of every function of an arm with `N` joints and targets `G`.
#[derive(Debug, Clone, Copy)]
pub struct Case<T, G, const N: usize> {
    /// Joint values, rad or length unit.
    pub q: [T; N],
    /// Their rates.
    pub qd: [T; N],
    /// Rates of the rates.
    pub qdd: [T; N],
    /// Of an inverse; where a joint's value comes with the target, both.
    pub target: G,
    /// Of the library's functions.
    pub pose: Pose<T>,
    /// Where the arm is.
    pub q_ref: [T; N],
    /// Of `inverse_branch`.
    pub branch: Branch,
    /// How many values of a redundant joint are tried.
    pub samples: usize,
    /// Counts of motors.
    pub pulses: [i32; N],
    /// Motor values, where motors are linked.
    pub motor: [T; N],
}

impl<T: Scalar, G: Aim<T>, const N: usize> Case<T, G, N> {
    /// All zeros: for programs whose calls are made but not looked at.
    pub const BLANK: Self = Self {
        q: [T::ZERO; N],
        qd: [T::ZERO; N],
        qdd: [T::ZERO; N],
        target: G::BLANK,
        pose: Pose { rotation: [[T::ZERO; 3]; 3], translation: [T::ZERO; 3] },
        q_ref: [T::ZERO; N],
        branch: Branch::NONE,
        samples: 1,
        pulses: [0; N],
        motor: [T::ZERO; N],
    };
}

/// Callback for each function: the case, the function's name, and the call that digests its result.
pub type Each<'a, C> = &'a mut dyn FnMut(&C, &'static str, &dyn Fn(&C, &mut Digest));

/// The case of a subject.
pub type CaseOf<S, T, const N: usize> = Case<T, <S as InverseKinematics<T, N>>::Target, N>;

/// An arm whose functions are compared and measured.
pub trait Subject<T: Scalar, const N: usize>: InverseKinematics<T, N> + Copy + Default {
    /// Arm file and scalar, such as `puma560_f32`.
    const NAME: &'static str;
    /// The joint, from 0, whose value comes with the target, if one does.
    const GIVEN: usize;
    /// Hands each function of the arm to `each`, always in the same order.
    fn each_function(case: &CaseOf<Self, T, N>, each: Each<'_, CaseOf<Self, T, N>>);
}
