//! A turning and a sliding joint, seen along a third one that slides.

use super::doubt::Doubt;
use super::offset::offset;
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};

/// Solves `[a1, a2] cos + [b1, b2] sin + [k1, k2] = s stroke`, rows `[a, b, k]`, for the angle and the position `s`.
/// The component at right angles to the stroke gives the angle, as in [`offset`]. The component along the stroke gives
/// the position.
///
/// Two roots; one where they meet or where there is none, then with the gap. With the stroke (dimensionless) vanishing
/// the sliding joint is free, and both rows give the angle.
#[inline]
pub fn slide_turning<T: Tolerances>(
    defaults: [DefaultValue<T>; 2],
    measure: Measure<T>,
    stroke: [T; 2],
    rows: [[T; 3]; 2],
) -> Roots<T, 2, 2> {
    let ([default, default_s], [u, v]) = (defaults, stroke);
    let length = (u * u + v * v).sqrt();
    if default_s.is_free(length, T::ONE) {
        return standing(defaults, measure, rows);
    }
    let k = T::ONE / length;
    let (u, v) = (u * k, v * k);
    let [[a1, b1, k1], [a2, b2, k2]] = rows;
    let angle = offset(default, measure, u * a2 - v * a1, u * b2 - v * b1, v * k1 - u * k2);
    let [a, b, c] = [u * a1 + v * a2, u * b1 + v * b2, u * k1 + v * k2].map(|e| e * k);
    let roots = angle.roots.map(|[turn]| [turn, Turn::position(a * turn.cos + b * turn.sin + c)]);
    let Roots { len, doubt, .. } = angle;
    let stage = Roots { roots, len, doubt };
    if length < T::DOUBTFUL { stage.nearly_free(default_s, measure, length) } else { stage }
}

/// The sliding joint moves nothing across the third one: two equations for the angle alone.
#[cold]
#[inline(never)]
fn standing<T: Tolerances>(
    [default, slide]: [DefaultValue<T>; 2],
    measure: Measure<T>,
    [[a1, b1, k1], [a2, b2, k2]]: [[T; 3]; 2],
) -> Roots<T, 2, 2> {
    let there = Turn::position(slide.value);
    let determinant = a1 * b2 - a2 * b1;
    let (first, second) = (a1 * a1 + b1 * b1, a2 * a2 + b2 * b2);
    let size = first.max(second);
    if determinant.abs() > T::DOUBTFUL * size && size > measure.vanishing() * measure.vanishing() {
        // The rows are an ellipse: both give the sine and the cosine.
        let (x, y) = ((b1 * k2 - b2 * k1) / determinant, (a2 * k1 - a1 * k2) / determinant);
        let length = (x * x + y * y).sqrt();
        let gap = (length - T::ONE).abs() * determinant.abs() / size.sqrt();
        let gap = if gap > measure.rounding() { gap } else { T::ZERO };
        let doubt = Doubt { gap, angular: measure.is_angular(), free: slide.joint, ..Doubt::NOTHING };
        return Roots { len: 1, doubt: Some(doubt), ..Roots::solved([[Turn::direction(y, x), there]; 2]) };
    }
    // Seen edge-on: along its longer axis it has both roots.
    let (p, q) = if first >= second { ([a1, b1, k1], [a2, b2, k2]) } else { ([a2, b2, k2], [a1, b1, k1]) };
    let angle = offset(default, measure, p[0], p[1], -p[2]);
    let roots = angle.roots.map(|[turn]| [turn, there]);
    let miss = |turn: &Turn<T>| (q[0] * turn.cos + q[1] * turn.sin + q[2]).abs();
    let least = roots.iter().take(angle.len).fold(T::INFINITY, |least, [turn, _]| miss(turn).min(least));
    let least = if least > measure.rounding() { least } else { T::ZERO };
    let Doubt { gap, boundary, free, .. } = angle.doubt.unwrap_or(Doubt::NOTHING);
    let (gap, free, angular) = (gap + least, free | slide.joint, measure.is_angular());
    let doubt = Doubt { gap, angular, boundary, free, ..Doubt::NOTHING };
    Roots { len: angle.len, doubt: Some(doubt), ..Roots::solved(roots) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointMask;

    fn solve(stroke: [f64; 2], rows: [[f64; 2]; 2], [angle, s]: [f64; 2]) -> Roots<f64, 2, 2> {
        let defaults = [(0, 0.0), (1, 0.25)].map(|(joint, value)| DefaultValue::at(value, JointMask::single(joint)));
        let (sin, cos) = angle.sin_cos();
        let [first, second] = [0, 1].map(|i| {
            let [a, b] = rows[i];
            [a, b, s * stroke[i] - a * cos - b * sin]
        });
        slide_turning(defaults, Measure::length(1.0), stroke, [first, second])
    }

    fn found(stage: &Roots<f64, 2, 2>, [angle, s]: [f64; 2], accuracy: f64) -> bool {
        let is = |root: &[Turn<f64>; 2]| (root[0].value - angle).abs() + (root[1].value - s).abs() < accuracy;
        stage.roots.iter().take(stage.len).any(is)
    }

    #[test]
    fn what_made_the_rows_comes_back() {
        for k in -30..30 {
            let at = [0.1 * f64::from(k) + 0.05, 0.4 - 0.01 * f64::from(k)];
            let stage = solve([0.5, -0.7], [[0.3, 0.2], [-0.4, 0.1]], at);
            assert!(found(&stage, at, 1e-13), "{at:?} {stage:?}");
        }
    }

    #[test]
    fn a_stroke_that_moves_nothing_leaves_its_joint_free_and_the_angle_not() {
        // A circle seen from the front and, with its two roots, seen edge-on.
        for rows in [[[0.3, 0.2], [-0.4, 0.1]], [[0.3, 0.2], [0.6, 0.4]], [[0.0, 0.0], [0.3, 0.4]]] {
            for angle in [-2.9, -0.7, 0.2, 1.6] {
                let stage = solve([0.0, 0.0], rows, [angle, 7.0]);
                assert_eq!(
                    stage.doubt.map(|doubt| (doubt.free, doubt.gap)),
                    Some((JointMask::single(1), 0.0)),
                    "{stage:?}"
                );
                assert!(found(&stage, [angle, 0.25], 1e-14), "{angle} {stage:?}");
            }
        }
    }
}
