//! Tasks: the components of the target pose that count.

use super::model::Joints;
use crate::math::{self, Scalar};
use crate::pose::Pose;
use crate::vector::{cross, dot, norm};

/// The components of the target pose that count. The other components are free, and part of the null space.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Task<T> {
    /// Position and orientation.
    #[default]
    Pose,
    /// Some components of the error in the base frame, in the order x, y, z, turn about x, y, z. `[true, true, false,
    /// false, false, true]` is a pose in the plane.
    Components([bool; 6]),
    /// The position and the direction of one axis of the tool, given in the tool frame (of any length): the turn about
    /// it is free.
    PositionAxis([T; 3]),
}

impl<T> Task<T> {
    /// The position alone.
    pub const POSITION: Self = Self::Components([true, true, true, false, false, false]);
}

impl<T: Scalar> Task<T> {
    /// Returns true if the task is well defined: its axis has a direction.
    pub(super) fn is_meant(&self) -> bool {
        match self {
            Self::Pose | Self::Components(_) => true,
            Self::PositionAxis(axis) => {
                let length = norm(*axis);
                length > T::ZERO && length.is_finite()
            }
        }
    }

    /// Sets the components that do not count to zero, in the error and in the rows of the Jacobian.
    #[inline]
    pub(super) fn reduce<Q: Joints<T>>(&self, pose: &Pose<T>, target: &Pose<T>, error: &mut [T; 6], rows: &mut [Q; 6]) {
        match self {
            Self::Pose => {}
            Self::Components(asked) => {
                for ((asked, error), row) in asked.iter().zip(error).zip(rows) {
                    if !asked {
                        *error = T::ZERO;
                        row.as_mut().fill(T::ZERO);
                    }
                }
            }
            Self::PositionAxis(axis) => reduce_to_axis(axis, pose, target, error, rows),
        }
    }
}

/// Reduces the orientation error to the turn that brings the axis onto its target the short way. The tool's rate of
/// turning is reduced to the part across the axis.
fn reduce_to_axis<T: Scalar, Q: Joints<T>>(
    axis: &[T; 3],
    pose: &Pose<T>,
    target: &Pose<T>,
    [_, _, _, wx, wy, wz]: &mut [T; 6],
    [_, _, _, rx, ry, rz]: &mut [Q; 6],
) {
    let length = norm(*axis);
    let axis = axis.map(|part| part / length);
    let turn = |pose: &Pose<T>| pose.rotation.map(|row| dot(row, axis));
    let (here, there) = (turn(pose), turn(target));
    let [x, y, z] = cross(here, there);
    let (sin, cos) = (norm([x, y, z]), dot(here, there));
    [*wx, *wy, *wz] = if sin > T::EPSILON || cos > T::ZERO {
        // For a vanishing angle the cross product is the turn.
        let factor = if sin > T::ZERO { math::atan2(sin, cos) / sin } else { T::ONE };
        [x * factor, y * factor, z * factor]
    } else {
        // Opposite: half a turn about any axis across.
        let [hx, hy, hz] = here;
        let across = if hx.abs() < T::HALF { [T::ZERO, hz, -hy] } else { [-hz, T::ZERO, hx] };
        let length = norm(across);
        across.map(|part| part / length * T::PI)
    };
    let [ax, ay, az] = here;
    for ((x, y), z) in rx.as_mut().iter_mut().zip(ry.as_mut()).zip(rz.as_mut()) {
        let along = *x * ax + *y * ay + *z * az;
        (*x, *y, *z) = (*x - along * ax, *y - along * ay, *z - along * az);
    }
}
