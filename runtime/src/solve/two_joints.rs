//! Where two free joints have to be, together, for a later stage to have roots.

use super::kernel::circle::Circle;
use super::kernel::level::Level;
use super::kernel::tolerances::Tolerances;
use super::place::{Sample, Samples, series, turn};
use super::second_level::highest;
use crate::math::sin_cos;

/// Places of either joint.
pub(super) const PLACES: usize = 3;
/// Runs of the cascade that sample the level: those with the second joint at its default have been before.
pub(super) const RUNS: usize = PLACES * (PLACES - 1);

/// The places of both joints in a run, rad from its default.
pub(super) fn places<T: Tolerances>(run: usize) -> [T; 2] {
    [turn(PLACES, run % PLACES), turn(PLACES, 1 + run / PLACES)]
}

/// The level of a stage with the second joint at two places off its default; the first one is at three places for
/// either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rows<T>([[T; PLACES]; PLACES - 1]);

impl<T: Tolerances> Rows<T> {
    /// Nothing is known.
    pub(super) const NONE: Self = Self([[T::NAN; PLACES]; PLACES - 1]);

    /// Keeps the level of a run, see [`Sample::keep`].
    pub(super) fn keep(&mut self, run: usize, level: &Level<T>, over: bool) {
        let Self(rows) = self;
        if let Some(slot) = rows.get_mut(run / PLACES).and_then(|row| row.get_mut(run % PLACES)) {
            let mut sample = Sample::of_degree_1(*slot);
            sample.keep(level, over);
            *slot = sample.value();
        }
    }

    /// The place of the second joint, rad from its default, from which the first one brings the level farthest into its
    /// range. `first`: the level with the second joint at its default, and afterwards that at this place.
    ///
    /// Two joints that turn move a squared distance, or a component, as `sum_jk M_jk phi_j(x) phi_k(y)` with `phi = (1,
    /// cos, sin)`. Three places of either joint determine it. For a fixed y the level is `a + b cos(x - phi)`, so that
    /// its range over x is `a +- |b|`. The place of y is searched round the whole turn. One joint after the other would
    /// end where neither alone comes nearer. `None` where a level is not known.
    #[inline(never)]
    pub(super) fn place(&self, first: &mut Samples<T>) -> Option<T> {
        let Self([second, third]) = self;
        let over_x = [first.series(PLACES, 0), series(second), series(third)];
        let (low, high, norms) = (first.low, first.high, norms());
        let inside = |y: T| {
            let (mut a, mut b, mut c) = (T::ZERO, T::ZERO, T::ZERO);
            for (weight, Circle { k0, k1: [k, l], .. }) in weights(y, norms).into_iter().zip(&over_x) {
                a += weight * *k0;
                b += weight * *k;
                c += weight * *l;
            }
            let most = (b * b + c * c).sqrt();
            (high - a + most).min(a + most - low)
        };
        let (y, _) = highest(&inside)?;
        let [p, q, r] = weights(y, norms);
        for ((sample, a), b) in first.iter_mut().zip(second).zip(third) {
            *sample = Sample::of_degree_1(sample.value() * p + *a * q + *b * r);
        }
        Some(y)
    }
}

/// The shares of the levels at the three places of the second joint in the level at y, rad from its default: Lagrange's
/// form `prod_{j != k} sin((y - y_j) / 2) / sin((y_k - y_j) / 2)`. The denominators are [`norms`].
#[inline(never)]
fn weights<T: Tolerances>(y: T, [of_p, of_q, of_r]: [T; PLACES]) -> [T; PLACES] {
    let [p, q, r] = chords(y);
    [q * r / of_p, r * p / of_q, p * q / of_r]
}

/// The denominators of [`weights`].
fn norms<T: Tolerances>() -> [T; PLACES] {
    let [[_, pq, pr], [qp, _, qr], [rp, rq, _]] = nodes::<T>().map(chords);
    [pq * pr, qr * qp, rp * rq]
}

/// The sines of half the angles from the places of the second joint to x.
#[inline(never)]
fn chords<T: Tolerances>(x: T) -> [T; PLACES] {
    nodes().map(|node: T| sin_cos((x - node) * T::HALF).0)
}

/// The places of the second joint: the default, and two of those at which the first joint is sampled.
fn nodes<T: Tolerances>() -> [T; PLACES] {
    [T::ZERO, turn(PLACES, 1), turn(PLACES, 2)]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used)]

    use super::super::kernel::level::{Behind, LevelOf};
    use super::*;

    /// The cosine of an elbow of two links of length 1, from (-2, 0.5) to the end of two links of 3 and 2. With either
    /// joint of these at its default the end is too far away.
    fn cosine([x, y]: [f64; 2]) -> f64 {
        let (end, height) = (3.0 * x.cos() + 2.0 * (x + y).cos(), 3.0 * x.sin() + 2.0 * (x + y).sin());
        let distance = (end + 2.0).powi(2) + (height - 0.5).powi(2);
        distance / 2.0 - 1.0
    }

    fn sampled() -> (Samples<f64>, Rows<f64>) {
        let level = |at: [f64; 2]| Level::from(LevelOf::Cosine(cosine(at)));
        let (mut first, mut rows) = (Samples::NONE, Rows::NONE);
        for place in 0..PLACES {
            first.keep(place, &Behind { level: level([turn(PLACES, place), 0.0]), slides: false }, true);
        }
        for run in 0..RUNS {
            rows.keep(run, &level(places(run)), true);
        }
        (first, rows)
    }

    #[test]
    fn the_elbow_bends_where_both_joints_have_moved() {
        let turns = || (0..360).map(|k| f64::from(k).to_radians());
        assert!(turns().all(|at| cosine([at, 0.0]) > 1.0 && cosine([0.0, at]) > 1.0));
        let (mut first, rows) = sampled();
        let y = rows.place(&mut first).expect("known levels");
        let place = first.turning(PLACES, 0.0, f64::INFINITY).expect("a level that depends on the joint");
        assert!(place.feasible, "{place:?}");
        let level = cosine([place.step * std::f64::consts::TAU, y]);
        assert!((-1.0..=1.0).contains(&level), "{level}");
        // No other place of the second joint brings the level lower.
        let least = |y: f64| turns().map(|x| cosine([x, y])).fold(f64::INFINITY, f64::min);
        assert!(turns().all(|other| least(other) > least(y) - 1e-3));
    }

    #[test]
    fn without_a_level_there_is_no_place() {
        let (mut first, _) = sampled();
        assert_eq!(Rows::NONE.place(&mut first), None);
    }
}
