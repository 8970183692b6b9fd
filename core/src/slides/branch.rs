//! The two branches at one angle of the held joint, and their joints.

use core::ops::ControlFlow;

use super::Slides;
use crate::Transform;
use crate::branches::{Branch, Branches, COUNT, Stream};
use crate::math::{Scalar, atan2, sin_cos, wrap};
use crate::pair::Pair;
use crate::transform::{Vector, cross, dot};
use crate::wave::Wave;

/// A vector of pairs `even + odd w`.
type Pairs<T> = [Pair<T>; 3];

/// A vector that is constant between two turning joints of the ring.
#[derive(Clone, Copy, Debug)]
enum Arrow<T> {
    /// After x.
    AfterX(Vector<T>),
    /// After y.
    AfterY(Vector<T>),
    /// After z or after t, as seen from before x: a function of t.
    BeforeX(Wave<T>),
}

/// An arm with its target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Posed<'a, T> {
    pub slides: &'a Slides<T>,
    /// T0, T1, T2, T3.
    pub links: [Transform<T>; 4],
    /// `alpha cos y + beta sin y + constant = M_zz`
    alpha: T,
    beta: T,
    constant: T,
    /// n
    length2: T,
    /// The last column of M.
    column: Wave<T>,
    /// tau1, tau2, and what is constant before x.
    offsets: [Arrow<T>; 3],
    /// The directions of the slides.
    axes: [Arrow<T>; 2],
    /// 1 over the sum of the lengths of the links.
    unit: T,
}

/// All at one angle of the held joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parts<T> {
    /// `1 - M_zz^2`
    pub across2: T,
    w2: T,
    /// Cosine and sine of y.
    pub y: [Pair<T>; 2],
    /// Cosine and sine of x.
    x: [Pair<T>; 2],
    closure: Closure<T>,
}

/// The gap that is left of the position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closure<T> {
    gap: Pairs<T>,
    axes: [Pairs<T>; 2],
    /// g over the sum of the lengths of the links.
    pub miss: Pair<T>,
}

impl<'a, T: Scalar> Posed<'a, T> {
    /// `1 - M_zz^2` at an angle.
    pub fn across2(&self, t: T) -> T {
        let [x, y, _] = self.column.at(sin_cos(t));
        x * x + y * y
    }

    /// `None` for a target that is not finite.
    pub fn of(slides: &'a Slides<T>, target: &Transform<T>) -> Option<Self> {
        let [base, .., tip] = &slides.links;
        let closing = *tip * target.inverse() * *base;
        // Each link from a turning joint to the next one, and the axes of the slides in it.
        let mut links = [Transform::IDENTITY; 4];
        let mut directions = [(0, [T::ZERO; 3]); 2];
        let [held, ..] = slides.turning;
        let (mut segment, mut slide) = (0, 0);
        for step in 0..6 {
            let joint = (held + step) % 6;
            let link = slides.link(joint, &closing);
            let is_prismatic = slides.prismatic.contains(&joint);
            if step > 0 && !is_prismatic {
                segment += 1;
            }
            let current = links.get_mut(segment)?;
            if is_prismatic {
                *directions.get_mut(slide)? = (segment, current.z());
                slide += 1;
            }
            *current = *current * link;
        }
        let [t0, t1, t2, t3] = links;
        let (back, ahead) = (t0.inverse(), t3.inverse());
        let before_x = |vector: Vector<T>| Wave::of(ahead.turn(vector), &back);
        let zero = Wave::of([T::ZERO; 3], &back);
        let ([_, _, [ux, uy, uz]], [vx, vy, vz]) = (t1.rotation, t2.z());
        let (alpha, beta) = (ux * vx + uy * vy, uy * vx - ux * vy);
        let lengths = links.map(|link| dot(link.translation, link.translation).sqrt());
        let [a, b, c, d] = lengths;
        let posed = Self {
            slides,
            links,
            alpha,
            beta,
            constant: uz * vz,
            length2: alpha * alpha + beta * beta,
            column: before_x([T::ZERO, T::ZERO, T::ONE]),
            offsets: [
                Arrow::AfterX(t1.translation),
                Arrow::AfterY(t2.translation),
                Arrow::BeforeX(before_x(t3.translation).plus(back.turn(t0.translation))),
            ],
            axes: directions.map(|(segment, direction)| match segment {
                0 => Arrow::BeforeX(zero.plus(back.turn(direction))),
                1 => Arrow::AfterX(direction),
                2 => Arrow::AfterY(direction),
                _ => Arrow::BeforeX(before_x(direction)),
            }),
            unit: T::ONE / (a + b + c + d),
        };
        let [.., last] = &posed.offsets;
        let Arrow::BeforeX(last) = last else { return None };
        (posed.column.is_finite() && last.is_finite() && posed.length2.is_finite() && posed.unit.is_finite())
            .then_some(posed)
    }

    #[inline(always)]
    pub fn parts(&self, turn: (T, T)) -> Parts<T> {
        let [mx, my, mz] = self.column.at(turn);
        let level = mz - self.constant;
        let w2 = self.length2 - level * level;
        let over = T::ONE / self.length2;
        let y = [
            Pair::new(self.alpha * level, -self.beta).scaled(over),
            Pair::new(self.beta * level, self.alpha).scaled(over),
        ];
        // x turns the last column of A1 Rz(y) A2 to that of M.
        let [_, t1, t2, _] = &self.links;
        let [yx, yy, _] = after_y(t1, t2.z(), &y);
        let across2 = mx * mx + my * my;
        let over = T::ONE / across2;
        let x = [yx.scaled(mx).plus(yy.scaled(my)).scaled(over), yx.scaled(my).minus(yy.scaled(mx)).scaled(over)];
        Parts { across2, w2, y, x, closure: self.closure(turn, &x, &y, w2) }
    }

    /// The gap and the slides, of the cosines and sines of x and y.
    #[inline(always)]
    pub fn closure(&self, turn: (T, T), x: &[Pair<T>; 2], y: &[Pair<T>; 2], w2: T) -> Closure<T> {
        let [_, t1, ..] = &self.links;
        let seen = |arrow: &Arrow<T>| match arrow {
            Arrow::AfterX(vector) => vector.map(|entry| Pair::new(entry, T::ZERO)),
            Arrow::AfterY(vector) => after_y(t1, *vector, y),
            Arrow::BeforeX(wave) => {
                let ([vx, vy, vz], [cos, sin]) = (wave.at(turn), x);
                let (ahead, aside) = (cos.scaled(vx).plus(sin.scaled(vy)), cos.scaled(vy).minus(sin.scaled(vx)));
                [ahead, aside, Pair::new(vz, T::ZERO)]
            }
        };
        let [p, q, r] = self.offsets.each_ref().map(seen);
        let gap = sum(sum(p, q), r);
        let axes = self.axes.each_ref().map(seen);
        let [[ax, ay, az], [bx, by, bz]] = axes;
        let area = |p: Pair<T>, q: Pair<T>, r: Pair<T>, s: Pair<T>| p.times(s, w2).minus(q.times(r, w2));
        let [gx, gy, gz] = gap;
        let volume = gx
            .times(area(ay, az, by, bz), w2)
            .plus(gy.times(area(az, ax, bz, bx), w2))
            .plus(gz.times(area(ax, ay, bx, by), w2));
        Closure { gap, axes, miss: volume.scaled(self.unit) }
    }

    /// The joint vector of the angles t, x, y, z.
    pub fn in_chain_order(&self, angles: [T; 4], closure: &Closure<T>, w: T) -> [T; 6] {
        let at = |pair: Pair<T>| pair.at(w);
        // The displacements that leave the least gap.
        let (gap, [a, b]) = (closure.gap.map(at), closure.axes.map(|axis| axis.map(at)));
        let normal = cross(a, b);
        let area2 = dot(normal, normal);
        let slides = if area2 > T::EPSILON {
            [dot(cross(b, gap), normal) / area2, -dot(cross(a, gap), normal) / area2]
        } else {
            // Parallel slides share the displacement.
            [-dot(gap, a) * T::HALF, -dot(gap, b) * T::HALF]
        };
        let mut joints = [T::ZERO; 6];
        let turning = self.slides.turning.iter().zip(angles);
        for (at, value) in turning.chain(self.slides.prismatic.iter().zip(slides)) {
            if let Some(joint) = joints.get_mut(*at) {
                *joint = value;
            }
        }
        joints
    }

    /// The root w with its sign; 0 where it is imaginary.
    #[inline(always)]
    fn root(p: &Parts<T>, number: usize) -> T {
        let w = p.w2.max(T::ZERO).sqrt();
        if number & 1 == 0 { w } else { -w }
    }

    /// A branch, and the sine of the angle between the slides. The branch misses by the distance of the gap from the plane
    /// of the slides: g over that sine.
    #[inline(always)]
    fn signed(&self, p: &Parts<T>, number: usize) -> (Branch<T>, T) {
        let w = Self::root(p, number);
        let [a, b] = p.closure.axes.map(|axis| axis.map(|entry| entry.at(w)));
        let normal = cross(a, b);
        let sine = dot(normal, normal).sqrt();
        (Branch { miss: p.closure.miss.at(w) / sine, squares: [p.w2 / self.length2, T::ONE] }, sine)
    }
}

/// `A1 Rz(y) vector`
#[inline(always)]
fn after_y<T: Scalar>(t1: &Transform<T>, [vx, vy, vz]: Vector<T>, [cos, sin]: &[Pair<T>; 2]) -> Pairs<T> {
    let (ahead, aside) = (cos.scaled(vx).minus(sin.scaled(vy)), cos.scaled(vy).plus(sin.scaled(vx)));
    t1.rotation.map(|[a, b, c]| ahead.scaled(a).plus(aside.scaled(b)).plus_real(c * vz))
}

#[inline(always)]
fn sum<T: Scalar>([a, b, c]: Pairs<T>, [d, e, f]: Pairs<T>) -> Pairs<T> {
    [a.plus(d), b.plus(e), c.plus(f)]
}

impl<T: Scalar> Branches<T> for Posed<'_, T> {
    const NARROW: &'static [(usize, usize)] = &[(0, 0)];

    fn held(&self) -> usize {
        let [held, ..] = self.slides.turning;
        held
    }

    #[inline(always)]
    fn product(&self, turn: (T, T)) -> (T, T) {
        let p = self.parts(turn);
        (p.closure.miss.norm(p.w2) * p.across2, p.across2)
    }

    fn all_scaled(&self, turn: (T, T)) -> ([Branch<T>; COUNT], T) {
        let parts = self.parts(turn);
        let [(first, first_sine), (second, second_sine)] = [0, 1].map(|number| self.signed(&parts, number));
        ([first, second, Branch::NONE, Branch::NONE], parts.across2 * first_sine * second_sine)
    }

    fn partners(&self, number: usize) -> &'static [usize] {
        if number == 0 { &[1] } else { &[0] }
    }

    fn branch(&self, number: usize, t: T) -> Branch<T> {
        let (branch, _) = self.signed(&self.parts(sin_cos(t)), number);
        branch
    }

    fn joints(&self, number: usize, t: T) -> [T; 6] {
        let turn = sin_cos(t);
        let p = self.parts(turn);
        let w = Self::root(&p, number);
        let at = |pair: Pair<T>| pair.at(w);
        let ([cos_x, sin_x], [cos_y, sin_y]) = (p.x.map(at), p.y.map(at));
        // z turns the last row of M to that of A1 Rz(y) A2.
        let [t0, t1, t2, t3] = &self.links;
        let [_, _, [ux, uy, uz]] = t1.rotation;
        let [bx, by, _] = t2.inverse().turn([ux * cos_y + uy * sin_y, uy * cos_y - ux * sin_y, uz]);
        let ([rx, ry, rz], (sin, cos)) = (t0.z(), turn);
        let [mx, my, _] = t3.turn([rx * cos - ry * sin, ry * cos + rx * sin, rz]);
        let angles = [wrap(t), atan2(sin_x, cos_x), atan2(sin_y, cos_y), atan2(mx * by - my * bx, mx * bx + my * by)];
        self.in_chain_order(angles, &p.closure, w)
    }

    fn signs(_number: usize) -> Option<(bool, bool)> {
        None
    }

    fn is_singular(&self, t: T) -> bool {
        self.across2(t) <= T::EPSILON
    }

    fn singular(stream: &mut Stream<'_, '_, T, Self>, t: T, _turn: (T, T)) -> ControlFlow<(), Option<(T, bool)>> {
        super::singular::parallel(stream, t)
    }
}
