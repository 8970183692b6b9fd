//! Joint limits during the iteration.

use super::model::Model;
use crate::math::{Scalar, wrap};

/// The value within the limits. A revolute joint comes back by a whole turn where the range has room for one. Otherwise
/// the joint stops at the limit.
#[inline(always)]
pub(super) fn bring_in<T: Scalar>(value: T, [low, high]: [T; 2], prismatic: bool) -> T {
    if value > high {
        let back = value - T::TAU;
        if !prismatic && back >= low && back <= high { back } else { high }
    } else if value < low {
        let back = value + T::TAU;
        if !prismatic && back >= low && back <= high { back } else { low }
    } else {
        value
    }
}

/// Returns true if a joint at a limit is pushed beyond it: the error falls in the direction of `push`.
#[inline(always)]
pub(super) fn is_held<T: Scalar>(value: T, [low, high]: [T; 2], push: impl FnOnce() -> T) -> bool {
    if value >= high {
        push() >= T::ZERO
    } else if value <= low {
        push() <= T::ZERO
    } else {
        false
    }
}

/// Turns every revolute joint by whole turns to within half a turn of `near`, if its limits allow.
pub(super) fn unwind<T: Scalar, M: Model<T>>(model: &M, within: bool, q: &mut M::Joints, near: &M::Joints) {
    for (joint, (value, near)) in q.as_mut().iter_mut().zip(near.as_ref()).enumerate() {
        let distance = *value - *near;
        if model.is_prismatic(joint) || distance.abs() <= T::PI {
            continue;
        }
        let unwound = *near + wrap(distance);
        let [low, high] = model.limits(joint);
        if !within || (unwound >= low && unwound <= high) {
            *value = unwound;
        }
    }
}
