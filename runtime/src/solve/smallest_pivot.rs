//! How nearly the columns of a Jacobian depend on each other.

use super::arm_constants::ArmConstants;
use super::kernel::tolerances::Tolerances;
use crate::{Jacobian, JointMask};

/// The last pivot of a QR decomposition with column pivoting (Businger, Golub 1965), by modified Gram-Schmidt. It is 0
/// where the joints that are not `given` can move without moving the tool, and never less than the smallest singular value.
/// Lengths are relative to reach.
pub(super) fn smallest_pivot<T: Tolerances, const N: usize>(
    constants: &ArmConstants<'_, T, N>,
    given: JointMask,
    jacobian: &Jacobian<T, N>,
) -> T {
    let k = T::ONE / constants.reach;
    let mut columns = [[T::ZERO; 6]; N];
    let mut remaining = JointMask::NONE;
    for (joint, column) in columns.iter_mut().enumerate().filter(|(joint, _)| !given.contains(*joint)) {
        remaining |= JointMask::single(joint);
        let unit = constants.unit(joint);
        for (place, (entry, row)) in column.iter_mut().zip(&jacobian.rows).enumerate() {
            let scale = if place < 3 { k * unit } else { unit };
            *entry = row.get(joint).copied().unwrap_or(T::ZERO) * scale;
        }
    }
    let square = |column: &[T; 6]| column.iter().fold(T::ZERO, |sum, entry| sum + *entry * *entry);
    let mut smallest = T::ZERO;
    for _ in 0..N {
        let mut longest: Option<(usize, T)> = None;
        for joint in remaining.iter() {
            let length = columns.get(joint).map_or(T::ZERO, square);
            if longest.is_none_or(|(_, most)| length > most) {
                longest = Some((joint, length));
            }
        }
        let Some((pivot, length)) = longest else { break };
        remaining = remaining.without(pivot);
        smallest = length.sqrt();
        if !(length > T::ZERO) {
            break;
        }
        let Some(direction) = columns.get(pivot).copied() else { break };
        for joint in remaining.iter() {
            let Some(column) = columns.get_mut(joint) else { continue };
            let along = column.iter().zip(&direction).fold(T::ZERO, |sum, (a, b)| sum + *a * *b) / length;
            for (entry, part) in column.iter_mut().zip(&direction) {
                *entry -= along * *part;
            }
        }
    }
    smallest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Residual;

    const CONSTANTS: ArmConstants<'_, f64, 3> = ArmConstants {
        limits: &[[-1.0, 1.0]; 3],
        combined: &[],
        weights: &[1.0; 3],
        limited: false,
        prismatic: JointMask::NONE,
        stands_for: JointMask::NONE,
        wrist: None,
        reach: 2.0,
        tolerance: Residual { position: 1e-6, orientation: 1e-6 },
    };

    fn of(columns: [[f64; 6]; 3], given: JointMask) -> f64 {
        let rows = core::array::from_fn(|row| columns.map(|column| column[row]));
        smallest_pivot(&CONSTANTS, given, &Jacobian { rows })
    }

    #[test]
    fn the_shortest_of_columns_at_right_angles_counts() {
        let columns = [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.7, 0.0]];
        assert_eq!(of(columns, JointMask::NONE), 0.25);
        assert!((of(columns, JointMask::single(1)) - 0.7).abs() < 1e-15);
    }

    #[test]
    fn columns_that_depend_on_each_other_have_none() {
        let columns = [[1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0, 1.0, 0.0], [1.0, 2.0, 0.0, 1.0, 1.0, 0.0]];
        assert!(of(columns, JointMask::NONE) < 1e-15);
        assert_eq!(of([[0.0; 6]; 3], JointMask::NONE), 0.0);
    }
}
