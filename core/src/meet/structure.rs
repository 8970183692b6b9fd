//! Finds the ring of a chain.

use super::Meet;
use super::constants::SHORTEST;
use crate::Transform;
use crate::chain::Chain;
use crate::math::{Scalar, hypot};

/// Where a chain has its two axes that meet and its two parallel axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Structure {
    /// The joints x1, x2, x3, x4, u, v of the ring, numbered from 0 as in the chain. x1 is the held joint.
    pub joints: [usize; 6],
    /// True if the ring runs from the tip to the base: joint numbers fall.
    pub is_mirrored: bool,
    /// True if x3 and x4 point in opposite directions.
    pub is_antiparallel: bool,
    /// True if K1 is the only constant of the ring that is not known before the call: [`Meet`] is a constant of the arm
    /// then. Otherwise [`Structure::ring`] and [`Meet::of`] run in every call.
    pub is_constant: bool,
}

impl Structure {
    /// The ring of a chain; `None` if the chain has none.
    ///
    /// `known`: the links C0 to C6 of `chain` that are the same in every call. Links that are not are not read. A given
    /// joint leaves the link unknown into which it is drawn. The target is unknown always.
    ///
    /// The rings are tried in a fixed order: those with all that is unknown in K1 first, then with some of it in K6 or K4;
    /// each forward, then mirrored. The first one is taken whose links about x3 and x4 are longer than a hundredth of the
    /// reach, else the first one whose links are longer than 1e-4 of it. A link about x4 that is not known counts as longer.
    /// K2, K3 and K5 have to be known: they hold the angles between
    /// the axes. Axes are parallel within 1e-9 rad and meet within 1e-9 of the reach. The axes that meet, and those of x2
    /// and x3, are at an angle of at least 6 degrees: less is badly conditioned, and the chain is one for
    /// [`general`](crate::general).
    #[must_use]
    pub fn of(chain: &Chain<f64>, known: [bool; 7]) -> Option<Self> {
        let first = |least: f64| {
            Self::first(chain, known, &Transform::IDENTITY, |structure, ring, knows_k4| {
                let [_, _, k3, ..] = ring;
                let [x, y, _] = k3.translation;
                // K6 has no say in how long the links are. Of an unknown K4 the length is not known.
                let shorter = if knows_k4 { Meet::of(&structure, ring)?.shorter_link() } else { hypot(x, y) };
                (shorter > least * chain.reach).then_some(structure)
            })
        };
        first(LONG).or_else(|| first(SHORTEST))
    }

    /// The first result of `take` for a ring of the chain closed by the target. `take` is told, too, if K4 is known.
    fn first<R>(
        chain: &Chain<f64>,
        known: [bool; 7],
        target: &Transform<f64>,
        take: impl Fn(Self, &[Transform<f64>; 6], bool) -> Option<R>,
    ) -> Option<R> {
        if chain.is_prismatic.contains(&true) {
            return None;
        }
        // The link after joint i, counted from 0, is C(i+1). The last one closes the ring and has the target.
        let is_known = |link: usize| link < 5 && known.get(link + 1).is_some_and(|is_known| *is_known);
        let rings = || (0..6).flat_map(|start| [(start, false), (start, true)]).map(Self::order);
        let unknown = |joints: &[usize; 6], is_mirrored: bool| {
            joints.map(|joint| !is_known(if is_mirrored { (joint + 5) % 6 } else { joint }))
        };
        let is_possible = |(joints, is_mirrored): &([usize; 6], bool), constant: bool| {
            let [_, k2, k3, k4, k5, k6] = unknown(joints, *is_mirrored);
            !k2 && !k3 && !k5 && constant != (k4 || k6)
        };
        [true, false].into_iter().find_map(|is_constant| {
            rings().filter(|ring| is_possible(ring, is_constant)).find_map(|(joints, is_mirrored)| {
                let structure = Self { joints, is_mirrored, is_antiparallel: false, is_constant };
                let ring = structure.ring(&chain.links, target);
                let [_, k2, k3, _, k5, _] = &ring;
                let is_antiparallel = parallel(k3)?;
                let structure = Self { is_antiparallel, ..structure };
                if !meets(k5, chain.reach) || sine(k5) < LEAST_SINE || sine(k2) < LEAST_SINE {
                    return None;
                }
                let [.., k4, _, _] = unknown(&joints, is_mirrored);
                take(structure, &ring, !k4)
            })
        })
    }

    fn order((start, is_mirrored): (usize, bool)) -> ([usize; 6], bool) {
        // Forward from the last joint, mirrored from the first one: K1 holds the target for `start` 0.
        let joints = core::array::from_fn(|i| {
            let step = (start + i) % 6;
            if is_mirrored { (12 - step) % 6 } else { (5 + step) % 6 }
        });
        (joints, is_mirrored)
    }

    /// The constants K1 to K6 of the ring, of the links C0 to C6 of the chain and of the target.
    ///
    /// The mirrored ring is the inverse of the ring, each constant turned by Rx(pi) from both sides:
    /// `Rz(-q) = Rx(pi) Rz(q) Rx(pi)`, so the joints keep their signs.
    #[must_use]
    pub fn ring<T: Scalar>(&self, links: &[Transform<T>; 7], target: &Transform<T>) -> [Transform<T>; 6] {
        let [base, a, b, c, d, e, tip] = links;
        let closing = closing(base, target, tip);
        let after = [*a, *b, *c, *d, *e, closing];
        let link = |joint: usize| after.get(joint).copied().unwrap_or(closing);
        self.joints.map(
            |joint| {
                if self.is_mirrored { half_turned(&link((joint + 5) % 6).inverse()) } else { link(joint) }
            },
        )
    }

    /// The constant K1 of a ring whose other constants do not depend on the call, of the links C0 and C6 and of the target.
    #[must_use]
    pub fn first_of_ring<T: Scalar>(
        &self,
        base: &Transform<T>,
        target: &Transform<T>,
        tip: &Transform<T>,
    ) -> Transform<T> {
        let closing = closing(base, target, tip);
        if self.is_mirrored { half_turned(&closing.inverse()) } else { closing }
    }
}

/// From behind the last joint to before the first one, by way of the target.
fn closing<T: Scalar>(base: &Transform<T>, target: &Transform<T>, tip: &Transform<T>) -> Transform<T> {
    *tip * target.inverse() * *base
}

impl Meet<f64> {
    /// The constants of a chain whose links are all known, at one target, with K1; `None` if no ring has constants there.
    #[must_use]
    pub fn posed(chain: &Chain<f64>, target: &Transform<f64>) -> Option<(Self, Transform<f64>)> {
        Structure::first(chain, [true; 7], target, |structure, ring, _| {
            let [k1, ..] = ring;
            Some((Self::of(&structure, ring).filter(Self::has_long_links)?, *k1))
        })
    }
}

/// `Rx(pi) link Rx(pi)`
fn half_turned<T: Scalar>(link: &Transform<T>) -> Transform<T> {
    let [[a, b, c], [d, e, f], [g, h, i]] = link.rotation;
    let [x, y, z] = link.translation;
    Transform { rotation: [[a, -b, -c], [-d, e, f], [-g, h, i]], translation: [x, -y, -z] }
}

/// Lengths and angles below this are zero, rad and of the reach.
pub(super) const ZERO: f64 = 1e-9;

/// Rings whose links about x3 and x4 are longer than this part of the reach come first: the equation divides by the links.
const LONG: f64 = 0.01;

/// Axes at a lesser angle are too nearly parallel: the roots crowd into a part of the circle.
const LEAST_SINE: f64 = 0.1;

/// The sine of the angle between the z axes before and after the link.
fn sine(link: &Transform<f64>) -> f64 {
    let [x, y, _] = link.z();
    hypot(x, y)
}

/// True for opposite directions; `None` if the z axes before and after the link are not parallel.
fn parallel(link: &Transform<f64>) -> Option<bool> {
    let [x, y, z] = link.z();
    (x.abs() <= ZERO && y.abs() <= ZERO).then_some(z < 0.0)
}

/// The places of the common normal of the z axes before and after the link, along the one and along the other: where they
/// meet, if they do. `None` if they are parallel.
pub(super) fn normal<T: Scalar>(link: &Transform<T>) -> Option<(T, T)> {
    let ([dx, dy, dz], [ox, oy, oz]) = (link.z(), link.translation);
    let sine2 = dx * dx + dy * dy;
    // The point (0, 0, along_z) = o + along_d d, by its part across z.
    let along_d = -(ox * dx + oy * dy) / sine2;
    (sine2 >= T::from_f64(ZERO)).then_some((oz + along_d * dz, along_d))
}

/// Returns true if the z axes before and after the link meet.
fn meets(link: &Transform<f64>, reach: f64) -> bool {
    let ([dx, dy, _], [ox, oy, _]) = (link.z(), link.translation);
    // Along z x d = (-dy, dx, 0).
    normal(link).is_some() && (dx * oy - dy * ox).abs() <= ZERO * reach * sine(link)
}
