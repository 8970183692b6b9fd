//! The best part of a step.

use super::damped_step::dot_out_of_line;
use super::kernel::tolerances::Tolerances;

/// A step has so many parts. From the one of least error Newton steps lead to the minimum.
const PARTS: i32 = 8;
const POLISH: i32 = 4;

/// The part t of a step, up to 1, at which the squared error is least, and that squared error. To second order the
/// error along the step is `before + slope t + bend t^2`, `bend = after - before - slope`. Between two roots of a fold
/// whole steps would go from one side of a root to the other without end.
#[inline(never)]
pub(super) fn best_part<T: Tolerances>(before: &[T; 6], slope: &[T; 6], after: &[T; 6]) -> (T, T) {
    let mut bend = *after;
    for ((bend, before), slope) in bend.iter_mut().zip(before).zip(slope) {
        *bend -= *before + *slope;
    }
    // The squared error is a quartic in t.
    let quartic = [
        dot_out_of_line(before, before),
        dot_out_of_line(before, slope) * T::TWO,
        dot_out_of_line(slope, slope) + dot_out_of_line(before, &bend) * T::TWO,
        dot_out_of_line(slope, &bend) * T::TWO,
        dot_out_of_line(&bend, &bend),
    ];
    let better = |(part, least): (T, T), t: T| {
        let error = quartic_at(&quartic, t);
        if error < least { (t, error) } else { (part, least) }
    };
    let whole = (T::ONE, quartic_at(&quartic, T::ONE));
    let (part, least) = (1..PARTS).fold(whole, |best, k| better(best, T::from_i32(k) / T::from_i32(PARTS)));
    let t = (0..POLISH).fold(part, |t, _| towards_extremum(&quartic, t));
    better((part, least), t.min(T::ONE))
}

/// The value of a quartic, from its coefficients in ascending order.
#[inline(never)]
fn quartic_at<T: Tolerances>([k0, k1, k2, k3, k4]: &[T; 5], t: T) -> T {
    *k0 + t * (*k1 + t * (*k2 + t * (*k3 + t * *k4)))
}

/// A Newton step from `t` towards an extremum of a quartic.
#[inline(never)]
fn towards_extremum<T: Tolerances>([_, k1, k2, k3, k4]: &[T; 5], t: T) -> T {
    let slope = *k1 + t * (*k2 * T::TWO + t * (*k3 * T::from_i32(3) + t * *k4 * T::from_i32(4)));
    let bend = *k2 * T::TWO + t * (*k3 * T::from_i32(6) + t * *k4 * T::from_i32(12));
    t - slope / bend
}

#[cfg(test)]
mod tests {
    use super::best_part;

    /// The error along a step from `1` whose linear model closes, in one direction each of two that differ.
    fn of(after: f64) -> (f64, f64) {
        let along = |size: f64| [size * 0.6, 0.0, size * -0.8, 0.0, 0.0, 0.0];
        best_part(&along(1.0), &along(-1.0), &along(after))
    }

    /// `(1 - 2 t)(1 + t)`: the whole step lies beyond the root at one half.
    #[test]
    fn a_step_beyond_a_root_goes_back_to_it() {
        let (part, least) = of(-2.0);
        assert!((part - 0.5).abs() < 1e-9 && least < 1e-18, "{part} {least}");
    }

    /// `1 - t + k t^2` is least at `1 / 2 k`, and for k above one quarter never vanishes.
    #[test]
    fn where_there_is_no_root_the_least_error_is_told() {
        for k in [1.0, 3.0] {
            let (part, least) = of(k);
            let expected: f64 = 1.0 - 0.25 / k;
            assert!((part - 0.5 / k).abs() < 1e-6 && (least - expected * expected).abs() < 1e-9, "{k}: {part} {least}");
        }
    }

    /// `1 - t - k t^2` has its root off the parts, for a large k before the first one.
    #[test]
    fn a_root_between_parts_is_found() {
        for (after, root, known) in [(-3.0, 0.434_258_545_910_664_9, 1e-6), (-200.0, 0.068_254_858_490_424_52, 1e-3)] {
            let (part, least) = of(after);
            assert!((part - root).abs() < known && least < 1e-4, "{after}: {part} {least}");
        }
    }

    /// `(1 - t / 2)^2` has its root beyond the step.
    #[test]
    fn a_step_that_leads_towards_a_root_is_whole() {
        for after in [1e-9, 0.25] {
            let (part, least) = of(after);
            assert!((part - 1.0).abs() < 1e-6 && (least - after * after).abs() < 1e-9, "{after}: {part} {least}");
        }
    }

    #[test]
    fn errors_that_are_not_finite_give_no_part_that_is_better() {
        for after in [f64::NAN, f64::INFINITY] {
            let (_, least) = of(after);
            assert!(!(least < 1.0), "{after}: {least}");
        }
    }
}
