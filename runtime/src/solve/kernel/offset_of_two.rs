//! Two equations for one joint.

#[cfg(feature = "batch")]
use denhart_core::lanes::Lanes;

#[cfg(feature = "batch")]
use super::lanes::{LaneMeasure, LaneRoots, small_beside};
use super::offset::offset;
#[cfg(feature = "batch")]
use super::offset::{Circle, circle};
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::DefaultValue;
#[cfg(feature = "batch")]
use super::turn::Turn;

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

/// [`offset_of_two`] over lanes. At an edge of the first equation the lane is in doubt.
#[cfg(feature = "batch")]
#[inline(always)]
pub fn offset_of_two_lanes<L: Lanes>(
    set: L::Set,
    lengths: LaneMeasure,
    directions: LaneMeasure,
    length: [L; 3],
    direction: [L; 3],
) -> LaneRoots<L, 1, 2> {
    let [a, b, d] = length;
    let [e, f, g] = direction;
    let scale = a.of(lengths.scale);
    let by_length = (e * e + f * f).sqrt().at_most((a * a + b * b).sqrt() / scale);
    let pick = |length: L, direction: L| (length.where_or(by_length, direction), direction.where_or(by_length, length));
    let ((a, e), (b, f), (d, g)) = (pick(a, e), pick(b, f), pick(d, g));
    let (scale, other) = pick(scale, a.of(1.0));
    let (_, tolerance) = pick(a.of(lengths.tolerance), a.of(directions.tolerance));
    let Circle { r, h, edge, roots: [[one], [two]] } = circle(a, b, d);
    let missed = |root: Turn<L>| (e * root.cos + f * root.sin - g).abs() / other;
    let (first, second) = (missed(one), missed(two));
    let swap = second.less(first);
    let (least, most) = (second.where_or(swap, first), first.where_or(swap, second));
    let (weak, rounding) = (a.of(f64::WEAK), a.of(f64::ROUNDING));
    let (no_root, one_root) = (weak.less(least), weak.less(most));
    let unusual = L::either(edge, L::either(small_beside(h, r), small_beside(r, scale)));
    let gap = least * other;
    let ended = L::both(L::both(no_root, tolerance.less(gap)), L::not(unusual));
    // Of the roots that stay the worse one must hold to rounding.
    let worse = least.where_or(one_root, most);
    let unsure = L::either(unusual, L::not(worse.at_most(rounding)));
    let swapped = L::both(swap, one_root);
    let exchange = |a: Turn<L>, b: Turn<L>| Turn {
        value: b.value.where_or(swapped, a.value),
        sin: b.sin.where_or(swapped, a.sin),
        cos: b.cos.where_or(swapped, a.cos),
    };
    LaneRoots {
        roots: [[exchange(one, two)], [exchange(two, one)]],
        present: [L::mask(set, true), L::not(one_root)],
        ended,
        gap,
        doubt: L::both(unsure, L::not(ended)),
    }
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
