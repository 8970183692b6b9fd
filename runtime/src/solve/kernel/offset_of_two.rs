//! Two equations for one joint.

use super::offset::offset;
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::DefaultValue;

/// Solves `a cos(t) + b sin(t) = d` given twice, for lengths and for directions, where one of the two equations may
/// lose its amplitude. The equation of larger relative amplitude gives the roots, the other equation chooses among
/// them.
///
/// A root that misses the other equation by far is dropped; if both do, the better one stays, with its gap.
#[inline]
pub fn offset_of_two<T: Tolerances>(
    default: DefaultValue<T>,
    lengths: Measure<T>,
    length: [T; 3],
    direction: [T; 3],
) -> Roots<T, 1, 2> {
    let amplitude = |[a, b, _]: [T; 3], scale: T| (a * a + b * b).sqrt() / scale;
    let by_length = amplitude(length, lengths.scale) >= amplitude(direction, T::ONE);
    let ([a, b, d], measure, [e, f, g], other) = if by_length {
        (length, lengths, direction, Measure::DIRECTION)
    } else {
        (direction, Measure::DIRECTION, length, lengths)
    };
    // The uncertainty of the joint is what the other equation may be missed by.
    let mut stage = offset(default, measure, a, b, d).closing(false);
    let missed = |stage: &Roots<T, 1, 2>, root: usize| {
        stage.roots.get(root).map_or(T::INFINITY, |[t]| (e * t.cos + f * t.sin - g).abs() / other.scale)
    };
    let [first, second] = [missed(&stage, 0), missed(&stage, 1)];
    if stage.len == 2 && (first > T::WEAK) != (second > T::WEAK) || first.min(second) > T::WEAK {
        if second < first {
            stage.roots.swap(0, 1);
        }
        stage.len = 1;
        let left = first.min(second);
        if left > T::ROUNDING {
            let doubt = stage.doubted(measure);
            if left > T::WEAK && doubt.free.is_empty() {
                doubt.gap = doubt.gap.max(left * other.scale);
                doubt.angular = other.is_angular();
            }
        }
    } else if first.max(second) > T::ROUNDING {
        // Beyond rounding what is asked for may be beyond the arm: it is checked in full.
        stage.doubted(measure);
    }
    stage
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointMask;

    /// Near a double root one equation closes. Where a second equation is to hold, too, the roots are verified.
    #[test]
    fn a_second_equation_is_verified() {
        let default = DefaultValue::at(0.0, JointMask::single(0));
        let d = 1e-3_f64.cos();
        let one = offset(default, Measure::length(1.0), 1.0, 0.0, d);
        assert_eq!(one.doubt.map(|doubt| doubt.closes), Some(true));
        let two = offset_of_two(default, Measure::length(1.0), [1.0, 0.0, d], [0.1, 0.0, 0.1 * d]);
        assert_eq!((two.len, two.doubt.map(|doubt| doubt.closes)), (2, Some(false)));
    }
}
