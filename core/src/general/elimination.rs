//! The constants of one cut, the equations at a target, and all joints from three of them.

use super::Cut;
use super::constant_side::{ConstantSide, EQUATIONS, SINGLES};
use super::equations::{Equations, Position};
use super::line::{COORDINATES, Move, line, moved_twice, vectors};
use crate::math::{angle, sin_cos, wrap};
use crate::{Chain, Transform};

/// One cut of a ring of six joints, with all that does not depend on the target.
///
/// The chain and its target close a ring, `M_d K0 M_a K1 M_b K2 M_c K3 M_e K4 M_f K5 = 1`, where M is a joint and K a
/// constant. M_d does not move its own axis. So the line along this axis, with the origin marked on it, is the same
/// seen from both sides of c, and its 14 [`COORDINATES`] give 14 equations. Joints a and b take part in eight products
/// only, with constant coefficients: six equations are free of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elimination {
    /// How the ring is cut.
    pub cut: Cut,
    /// K0 to K5, lengths in `unit`. The one with the target, K(5 - d), is not read, but for a cut of the target.
    pub ring: [Transform<f64>; 6],
    /// Constants before and behind the target in its own: `K = before T^-1 behind`, or `before T behind` where
    /// the chain is cut backwards. Lengths in `unit`.
    pub before: Transform<f64>,
    /// See `before`.
    pub behind: Transform<f64>,
    /// Prismatic joints, in the order d, a, b, c, e, f. Neither d nor c is one.
    pub is_prismatic: [bool; 6],
    /// The unit of length of all constants here, in the arm's: half of its reach.
    pub unit: f64,
    /// Six orthonormal rows n that annihilate the coefficients of the products of a and b: `n (w - constant) = 0` for
    /// the line coordinates w of the other side.
    pub null: [[f64; COORDINATES]; EQUATIONS],
    /// `null constant`.
    pub null_level: [f64; EQUATIONS],
    /// Rows of the pseudo-inverse: `cos b, sin b, cos a, sin a = pseudo w - pseudo_level`. For a prismatic joint its
    /// square and itself, in `unit`.
    pub pseudo: [[f64; COORDINATES]; SINGLES],
    /// `pseudo constant`.
    pub pseudo_level: [f64; SINGLES],
}

/// The ring closed by one target.
pub(super) struct Closed<'a> {
    pub(super) elimination: &'a Elimination,
    pub(super) equations: Equations,
    ring: [Transform<f64>; 6],
}

impl Elimination {
    /// The constants of a cut that is not [of the target](Cut::is_of_target). None for one that is, if joint d or c is
    /// prismatic, or if the lines on the side of a and b are too special: the coefficients of the eight products depend on
    /// each other.
    ///
    /// The frames of the chain should be [gathered](Chain::gathered). The result depends on nothing but its arguments:
    /// the same bits on every processor.
    pub fn of(chain: &Chain<f64>, cut: Cut) -> Option<Self> {
        if cut.is_of_target() { None } else { Self::cut_at(chain, cut)?.eliminated() }
    }

    /// As [`Elimination::of`], of any cut. Those of the target are for this target alone.
    pub(crate) fn at(chain: &Chain<f64>, cut: Cut, target: &Transform<f64>) -> Option<Self> {
        let mut out = Self::cut_at(chain, cut)?;
        if cut.is_of_target() {
            let mut ring = out.ring;
            out.close(&mut ring, target);
            out.ring = ring;
        }
        out.eliminated()
    }

    /// The ring without the target, before elimination.
    fn cut_at(chain: &Chain<f64>, cut: Cut) -> Option<Self> {
        let unit = 0.5 * chain.reach;
        let inverse = 1.0 / unit;
        let links = chain.links.map(|link| scaled(&link, inverse));
        let links = if cut.is_backward {
            let [a, b, c, d, e, f, g] = links.map(|link| link.inverse());
            [g, f, e, d, c, b, a]
        } else {
            links
        };
        let [behind, inner @ .., before] = links.map(|link| cleaned(&link));
        let d = usize::from(cut.d);
        // Five constants between the joints of the chain; after the last joint stands the one with the target.
        let ring = core::array::from_fn(|i| inner.get((d + i) % 6).copied().unwrap_or(Transform::IDENTITY));
        let is_prismatic = cut.order().map(|joint| chain.is_prismatic.get(joint).copied().unwrap_or(false));
        let [slides_d, _, _, slides_c, ..] = is_prismatic;
        if slides_d || slides_c {
            return None;
        }
        let (null, pseudo) = ([[0.0; COORDINATES]; EQUATIONS], [[0.0; COORDINATES]; SINGLES]);
        let (null_level, pseudo_level) = ([0.0; EQUATIONS], [0.0; SINGLES]);
        Some(Self { cut, ring, before, behind, is_prismatic, unit, null, null_level, pseudo, pseudo_level })
    }

    /// The chain of which this is a cut.
    pub(super) fn chain(&self) -> Chain<f64> {
        let d = usize::from(self.cut.d);
        let at = |place: usize| (place + 6 - d) % 6;
        let mut links = core::array::from_fn(|i| match i {
            0 => self.behind,
            6 => self.before,
            _ => self.ring.get(at(i - 1)).copied().unwrap_or(Transform::IDENTITY),
        });
        let mut is_prismatic = core::array::from_fn(|i| self.is_prismatic.get(at(i)).copied().unwrap_or(false));
        if self.cut.is_backward {
            links.reverse();
            links = links.map(|link| link.inverse());
            is_prismatic.reverse();
        }
        Chain { links: links.map(|link| scaled(&link, self.unit)), is_prismatic, reach: 2.0 * self.unit }
    }

    /// Sets the constant with the target in a ring.
    fn close(&self, ring: &mut [Transform<f64>; 6], target: &Transform<f64>) {
        let target = scaled(target, 1.0 / self.unit);
        let target = if self.cut.is_backward { target } else { target.inverse() };
        if let Some(place) = ring.get_mut(5_usize.saturating_sub(self.cut.d.into())) {
            *place = self.before * target * self.behind;
        }
    }

    /// With null space and pseudo-inverse of the ring's constants.
    fn eliminated(mut self) -> Option<Self> {
        let [k0, k1, k2, ..] = &self.ring;
        let [_, slides_a, slides_b, ..] = self.is_prismatic;
        let [a, b] = [slides_a, slides_b].map(|is_prismatic| Move { is_prismatic, sign: -1.0 });
        let sums = moved_twice(&k0.inverse(), a, &k1.inverse(), b, &k2.inverse());
        let ConstantSide { null, pseudo } = ConstantSide::of(&sums)?;
        let mut constant = [0.0; COORDINATES];
        for (entry, [.., last]) in constant.iter_mut().zip(sums) {
            *entry = last;
        }
        for (level, row) in self.null_level.iter_mut().zip(&null) {
            *level = product(row, &constant);
        }
        for (level, row) in self.pseudo_level.iter_mut().zip(&pseudo) {
            *level = product(row, &constant);
        }
        (self.null, self.pseudo) = (null, pseudo);
        Some(self)
    }

    /// This cut of a ring whose constants differ by about `distance`, in rad and in `unit`. At a target or a given joint where axes fall together
    /// the polynomial of the ring itself may be zero. That of its neighbor is not, and its solutions are near.
    pub(super) fn moved(&self, distance: f64) -> Option<Self> {
        let mut out = *self;
        for (i, link) in out.ring.iter_mut().chain([&mut out.before]).enumerate() {
            let step = distance * (1.0 + 0.37 * i as f64);
            let (sin, cos) = sin_cos(-0.61 * step);
            let rotation = [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]];
            let translation = [0.83 * step, -0.57 * step, 0.71 * step];
            *link = link.then_turn(sin_cos(step)) * Transform { rotation, translation };
        }
        out.eliminated()
    }

    /// The equations at a target.
    #[inline]
    pub(super) fn closed(&self, target: &Transform<f64>) -> Closed<'_> {
        let mut ring = self.ring;
        if !self.cut.is_of_target() {
            self.close(&mut ring, target);
        }
        let [_, _, _, k3, k4, k5] = &ring;
        let [.., slides_e, slides_f] = self.is_prismatic;
        let [e, f] = [slides_e, slides_f].map(|is_prismatic| Move { is_prismatic, sign: 1.0 });
        let sums = moved_twice(k5, f, k4, e, k3);
        let [mut cos, mut sin, mut one] = [[[0.0; 9]; 6]; 3];
        for (((cos, sin), one), (n, level)) in
            cos.iter_mut().zip(&mut sin).zip(&mut one).zip(self.null.iter().zip(self.null_level))
        {
            for ([nx, ny, nz], [x, y, z]) in vectors(n).into_iter().zip(vectors(&sums)) {
                for m in 0..9 {
                    let (x, y, z) = (x[m], y[m], z[m]);
                    cos[m] += nx * x + ny * y;
                    sin[m] += ny * x - nx * y;
                    one[m] += nz * z;
                }
            }
            for m in 0..9 {
                one[m] += n[6] * sums[6][m] + n[7] * sums[7][m];
            }
            one[8] -= level;
        }
        let mut equations = Equations { cos, sin, one, is_prismatic: [slides_e, slides_f] };
        equations.normalize();
        if self.cut.is_swapped {
            equations = equations.swapped();
        }
        Closed { elimination: self, equations, ring }
    }
}

impl Closed<'_> {
    /// All joints in the order of the chain, from c, e and f.
    pub(super) fn joints(&self, held: (f64, f64), e: Position, f: Position) -> [f64; 6] {
        let Elimination { cut, is_prismatic, unit, pseudo, pseudo_level, .. } = self.elimination;
        let [k0, k1, k2, k3, k4, k5] = &self.ring;
        // Of the frame M_c K3 M_e K4 M_f K5: its origin, its z and its x axis.
        let [x_axis, _, z_axis] = k5.axes();
        let moved = |is_point: bool, v: [f64; 3]| {
            let apply = |link: &Transform<f64>, v| if is_point { link.map(v) } else { link.turn(v) };
            turned(held, apply(k3, e.apply(is_point, apply(k4, f.apply(is_point, v)))))
        };
        let w = line(moved(true, k5.translation), moved(false, z_axis));
        let mut singles = [0.0; SINGLES];
        for ((value, row), level) in singles.iter_mut().zip(pseudo).zip(pseudo_level) {
            *value = product(row, &w) - level;
        }
        let [_, slides_a, slides_b, ..] = *is_prismatic;
        let [cos_b, sin_b, cos_a, sin_a] = singles;
        let position = |is_prismatic, sin, cos| {
            if is_prismatic { Position::Slide(sin) } else { Position::direction(sin, cos) }
        };
        let (a, b) = (position(slides_a, sin_a, cos_a), position(slides_b, sin_b, cos_b));
        // M_d undoes what the rest turns the x axis by.
        let x = b.apply(false, k2.turn(moved(false, x_axis)));
        let [x, y, _] = k0.turn(a.apply(false, k1.turn(x)));
        let d = Position::direction(-y, x);
        let (sin, cos) = held;
        let mut joints = [0.0; 6];
        let positions = [d, a, b, Position::Turn(sin, cos), e, f];
        for (joint, position) in cut.order().into_iter().zip(positions) {
            let value = match position {
                Position::Turn(sin, cos) => angle(sin, cos),
                Position::Slide(q) => q * unit,
            };
            if let Some(place) = joints.get_mut(joint) {
                *place = if cut.is_backward { -value } else { value };
            }
        }
        if cut.is_backward {
            for (joint, place) in cut.order().into_iter().zip(is_prismatic) {
                if let Some(value) = joints.get_mut(joint)
                    && !place
                {
                    *value = wrap(*value);
                }
            }
        }
        joints
    }
}

impl Closed<'_> {
    /// The greatest entry by which the ring misses to close, lengths in `unit`.
    pub(super) fn residual(&self, joints: &[f64; 6]) -> f64 {
        let Elimination { cut, is_prismatic, unit, .. } = self.elimination;
        let mut ring = Transform::IDENTITY;
        for ((joint, link), is_prismatic) in cut.order().into_iter().zip(&self.ring).zip(*is_prismatic) {
            let value = joints.get(joint).copied().unwrap_or(0.0);
            let value = if is_prismatic { value / unit } else { value };
            ring = ring.then_move(is_prismatic, if cut.is_backward { -value } else { value }) * *link;
        }
        let rotation = ring.rotation.iter().flatten().zip(Transform::IDENTITY.rotation.iter().flatten());
        let entries = rotation.map(|(x, y): (&f64, &f64)| x - y).chain(ring.translation);
        entries.fold(0.0, |most, x| if x.abs() <= most { most } else { x.abs() })
    }
}

impl Position {
    /// The image of a direction or a point under the joint's motion.
    #[inline(always)]
    fn apply(self, is_point: bool, v: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Turn(sin, cos) => turned((sin, cos), v),
            Self::Slide(q) => {
                let [x, y, z] = v;
                [x, y, if is_point { z + q } else { z }]
            }
        }
    }
}

#[inline(always)]
fn turned((sin, cos): (f64, f64), [x, y, z]: [f64; 3]) -> [f64; 3] {
    [x * cos - y * sin, x * sin + y * cos, z]
}

/// Lengths multiplied by `factor`.
fn scaled(transform: &Transform<f64>, factor: f64) -> Transform<f64> {
    Transform { rotation: transform.rotation, translation: transform.translation.map(|x| x * factor) }
}

/// Without the rounding of zeros: generated code has these numbers.
fn cleaned(link: &Transform<f64>) -> Transform<f64> {
    let clean = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
    Transform { rotation: link.rotation.map(|row| row.map(clean)), translation: link.translation.map(clean) }
}

#[inline(always)]
fn product(row: &[f64; COORDINATES], w: &[f64; COORDINATES]) -> f64 {
    row.iter().zip(w).fold(0.0, |sum, (x, y)| sum + x * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::tests::tilted;

    #[test]
    fn a_cut_has_the_chain() {
        let links = [0.3, -1.0, 0.7, 1.5, -0.4, 0.9, 2.0].map(|x| tilted(x, [0.2 * x, 0.1, 0.3 - x]));
        for slide in [None, Some(1), Some(5)] {
            let chain = Chain::new(links, core::array::from_fn(|joint| Some(joint) == slide)).gathered();
            let cuts = Cut::OF_ARM.into_iter().filter_map(|cut| Elimination::of(&chain, cut));
            let mut count = 0;
            for again in cuts.map(|elimination| elimination.chain()) {
                count += 1;
                assert_eq!((again.is_prismatic, again.reach), (chain.is_prismatic, chain.reach));
                for (one, other) in again.links.iter().zip(&chain.links) {
                    let entries = |link: &Transform<f64>| {
                        link.rotation.iter().flatten().chain(&link.translation).copied().collect::<std::vec::Vec<f64>>()
                    };
                    assert!(entries(one).iter().zip(entries(other)).all(|(x, y)| (x - y).abs() < 1e-15 * chain.reach));
                }
            }
            assert!(count >= 4, "{count}");
        }
    }
}
