//! One direction seen from two joints with a sliding joint between them.

use super::doubt::Doubt;
use super::offset::offset;
use super::roots::{Measure, Roots};
use super::tolerances::Tolerances;
use super::turn::{DefaultValue, Turn};
use crate::vector::{cross, dot, norm, scale};

/// A vector that a joint turns about its z axis, and the frame in which the vector has to be seen. The rows of the
/// frame take the frame of the sliding joint to that of the turning joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight<T> {
    /// The unit vector the joint turns.
    pub moved: [T; 3],
    /// Rotation from the sliding joint's frame to this joint's.
    pub frame: [[T; 3]; 3],
}

impl<T: Tolerances> Sight<T> {
    /// The component of the vector across the joint's axis.
    #[inline]
    fn across(&self) -> T {
        let [x, y, _] = self.moved;
        (x * x + y * y).sqrt()
    }
}

/// Finds the unit vector `h` with `frame_x h = R_z(-x) moved_x` and `frame_z h = R_z(z) moved_z`, and from it `(x, z)`.
///
/// Both turning axes are fixed in the frame of the sliding joint, so `h` lies on two cones about them:
/// `h = a (n_x + n_z) + b (n_x - n_z) +- c n_x x n_z`. Sum and difference of the axes are at right angles. So `h` is
/// accurate to the rounding of the axes, also where the axes are nearly parallel. Two roots; one where the cones touch
/// or do not meet, then with the gap.
///
/// A joint whose axis `h` lies along is free. With parallel axes x is free. The roots are then x at its default, and up
/// to two where `h` is at right angles to the slide. Those two are roots because the slide does nothing there for the
/// distance along `h`.
#[inline]
pub fn aim<T: Tolerances>(defaults: [DefaultValue<T>; 2], x: Sight<T>, z: Sight<T>) -> Roots<T, 2, 3> {
    let measure = Measure::DIRECTION;
    let [default_x, default_z] = defaults;
    let ([_, _, nx], [_, _, nz]) = (x.frame, z.frame);
    let ([_, _, kx], [_, _, kz]) = (x.moved, z.moved);
    let (sx, sz) = (x.across(), z.across());
    let normal = cross(nx, nz);
    let square = dot(normal, normal);
    let least = square.sqrt().min(sx).min(sz);
    if !(least > default_x.free_below().max(default_z.free_below())) {
        return undetermined(defaults, &x, &z);
    }
    let (sum, difference) = (plus(nx, nz, T::ONE), plus(nx, nz, -T::ONE));
    let (sum2, difference2) = (dot(sum, sum), dot(difference, difference));
    let (along_sum, along_difference, step) = (kx + kz, kx - kz, sx - sz);
    // The cones touch where the axes are as far apart (or as far from opposite) as the angles of the cones differ.
    let (apart, opposite) = (difference2.sqrt(), sum2.sqrt());
    let (apart_least, opposite_least) =
        ((along_difference * along_difference + step * step).sqrt(), (along_sum * along_sum + step * step).sqrt());
    let (inner, outer) = (apart - apart_least, opposite - opposite_least);
    let middle = plus(scale(along_sum / sum2, sum), difference, along_difference / difference2);
    let close = T::EPSILON * T::TWO;
    let stage = if inner > close && outer > close {
        // The volume spanned by both axes and h.
        let height = T::HALF * (inner * (apart + apart_least) * outer * (opposite + opposite_least)).sqrt();
        let c = height / square;
        let [first, second] = [c, -c].map(|c| angles(&x, &z, plus(middle, normal, c)));
        let roots = [first, second, second];
        Roots { len: 2, ..Roots::determined(roots, measure, height.min(square), default_x.joint) }
    } else {
        let gap = (-inner).max(-outer).max(T::ZERO);
        Roots::edge(angles(&x, &z, unit(middle)), gap, measure)
    };
    if least < T::DOUBTFUL { of_weak_amplitude(stage, defaults, [sx, sz], square.sqrt()) } else { stage }
}

/// The roots where a joint is nearly free: its axis all but along h, or the axes all but parallel.
#[cold]
#[inline(never)]
fn of_weak_amplitude<T: Tolerances>(
    mut stage: Roots<T, 2, 3>,
    defaults: [DefaultValue<T>; 2],
    across: [T; 2],
    between: T,
) -> Roots<T, 2, 3> {
    // About axes that are nearly parallel, z follows x.
    let ([default_x, default_z], [across_x, across_z]) = (defaults, across);
    stage = stage.nearly_free(default_x, Measure::DIRECTION, across_x.min(between));
    if across_z < between { stage.nearly_free(default_z, Measure::DIRECTION, across_z) } else { stage }
}

/// The cases in which a joint is free.
#[cold]
#[inline(never)]
fn undetermined<T: Tolerances>(defaults: [DefaultValue<T>; 2], x: &Sight<T>, z: &Sight<T>) -> Roots<T, 2, 3> {
    let [default_x, default_z] = defaults;
    let below = default_x.free_below().max(default_z.free_below());
    let lies_along = |sight: &Sight<T>| !(sight.across() > below);
    match [x, z].map(lies_along) {
        [false, false] => in_line(defaults, x, z),
        free => known(defaults, x, z, free),
    }
}

/// The vector lies along the axis of one joint or of both, which are free; the other sees it there.
fn known<T: Tolerances>(
    defaults: [DefaultValue<T>; 2],
    x: &Sight<T>,
    z: &Sight<T>,
    mut free: [bool; 2],
) -> Roots<T, 2, 3> {
    let [(along, seen), (other, wanted)] = {
        let ([.., nx], [.., nz]) = (x.frame, z.frame);
        let ([.., kx], [.., kz]) = (x.moved, z.moved);
        let (of_x, of_z) = ((nx, kx), (nz, kz));
        let [_, free_z] = free;
        if free_z { [of_z, of_x] } else { [of_x, of_z] }
    };
    let h = scale(seen, along);
    let (cosine, normal) = (dot(other, h), cross(other, h));
    let sine = norm(normal);
    if !(sine > T::VANISHING) {
        free = [true; 2];
    }
    let across = (T::ONE - wanted * wanted).max(T::ZERO).sqrt();
    let gap = (sine * wanted - cosine * across).abs();
    let mut root = angles(x, z, h);
    let mut doubt = Doubt { gap: beyond_free(gap), angular: true, ..Doubt::NOTHING };
    for ((turn, default), free) in root.iter_mut().zip(defaults).zip(free) {
        if free {
            *turn = Turn::at(default.value);
            doubt.free |= default.joint;
        }
    }
    Roots { len: 1, doubt: Some(doubt), ..Roots::solved([root; 3]) }
}

/// Both joints turn about the same direction: z follows x.
fn in_line<T: Tolerances>([default, _]: [DefaultValue<T>; 2], x: &Sight<T>, z: &Sight<T>) -> Roots<T, 2, 3> {
    let ([row1, row2, nx], [.., nz]) = (x.frame, z.frame);
    let ([ax, ay, kx], [.., kz]) = (x.moved, z.moved);
    let follow = |turn: Turn<T>| {
        let (h1, h2) = (ax * turn.cos + ay * turn.sin, ay * turn.cos - ax * turn.sin);
        let [_, turn_z] = angles(x, z, plus(plus(scale(h1, row1), row2, h2), nx, kx));
        [turn, turn_z]
    };
    // The slide is along the third axis of its own frame.
    let ([.., c1], [.., c2], [.., c3]) = (row1, row2, nx);
    let across = offset(default, Measure::DIRECTION, c1 * ax + c2 * ay, c1 * ay - c2 * ax, -(c3 * kx));
    let [[first], [second]] = across.roots;
    let more =
        if across.doubt.is_none_or(|doubt| doubt.free.is_empty() && doubt.gap <= T::ROUNDING) { across.len } else { 0 };
    let stay = follow(Turn::at(default.value));
    let gap = beyond_free((kx * dot(nx, nz) - kz).abs());
    let stage = Roots::<T, 2, 3>::left_free(stay, default, gap, Measure::DIRECTION);
    Roots { roots: [stay, follow(first), follow(second)], len: 1 + more, ..stage }
}

/// Zero for what a joint that is free may be off by.
fn beyond_free<T: Tolerances>(gap: T) -> T {
    (gap - T::VANISHING).max(T::ZERO)
}

/// The joint angles at which both see the vector.
fn angles<T: Tolerances>(x: &Sight<T>, z: &Sight<T>, h: [T; 3]) -> [Turn<T>; 2] {
    let (seen_x, seen_z) = (x.frame.map(|row| dot(row, h)), z.frame.map(|row| dot(row, h)));
    [turn(seen_x, x.moved), turn(z.moved, seen_z)]
}

fn turn<T: Tolerances>([ux, uy, _]: [T; 3], [vx, vy, _]: [T; 3]) -> Turn<T> {
    let (sin, cos) = (ux * vy - uy * vx, ux * vx + uy * vy);
    if sin == T::ZERO && cos == T::ZERO { Turn::ZERO } else { Turn::towards(sin, cos) }
}

/// `u + k v`
fn plus<T: Tolerances>([a, b, c]: [T; 3], [d, e, f]: [T; 3], k: T) -> [T; 3] {
    [a + k * d, b + k * e, c + k * f]
}

/// A vector of length 1, if there is a direction.
fn unit<T: Tolerances>(u: [T; 3]) -> [T; 3] {
    let square = dot(u, u);
    if square > T::ZERO { scale(T::ONE / square.sqrt(), u) } else { u }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::JointMask;
    use crate::math::wrap;
    use std::vec::Vec;

    fn defaults() -> [DefaultValue<f64>; 2] {
        [(0, 0.3), (1, -0.8)].map(|(joint, value)| DefaultValue::at(value, JointMask::single(joint)))
    }

    /// Axes at the angle `between` to each other and a slide askew to both, and what joints at `(x, z)` move onto `h`.
    fn sights(between: f64, h: [f64; 3], [x, z]: [f64; 2]) -> [Sight<f64>; 2] {
        let (s, c) = between.sin_cos();
        let frame_x = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];
        // Turned about the first axis of x.
        let turned = |v: [f64; 3], w: [f64; 3], c: f64, s: f64| plus(scale(c, v), w, s);
        let [e1, e2, e3] = frame_x;
        let frame_z = [e1, turned(e2, e3, c, s), turned(e3, e2, c, -s)];
        let seen = |frame: [[f64; 3]; 3], turn: f64| {
            let [u, v, w] = frame.map(|row| dot(row, h));
            [u * turn.cos() - v * turn.sin(), v * turn.cos() + u * turn.sin(), w]
        };
        [Sight { moved: seen(frame_x, x), frame: frame_x }, Sight { moved: seen(frame_z, -z), frame: frame_z }]
    }

    fn found(stage: &Roots<f64, 2, 3>, wanted: [f64; 2]) -> f64 {
        let roots: Vec<_> = stage.roots.iter().take(stage.len).collect();
        let apart = |root: &[Turn<f64>; 2]| {
            root.iter().zip(wanted).map(|(turn, wanted)| wrap(turn.value - wanted).abs()).fold(0.0, f64::max)
        };
        roots.into_iter().map(apart).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn what_both_see_comes_back_at_every_angle_between_the_axes() {
        for (between, accuracy) in
            [(1.1, 1e-14), (3.0, 1e-13), (1e-3, 1e-11), (1e-6, 1e-8), (core::f64::consts::PI - 1e-6, 1e-8)]
        {
            for k in 0..100 {
                let [a, b, x, z] = [0.7, 1.9, 2.3, 3.1].map(|step| f64::from(k) * step);
                let h = [a.cos() * b.sin(), a.sin() * b.sin(), b.cos()];
                let (x, z) = (wrap(x), wrap(z));
                let [over_x, over_z] = sights(between, h, [x, z]);
                let stage = aim(defaults(), over_x, over_z);
                // Where the cones touch, two roots are as far apart as the root of rounding.
                let accuracy = accuracy / stage.doubt.unwrap_or(Doubt::NOTHING).amplitude.clamp(1e-8, 1.0);
                assert!(found(&stage, [x, z]) < accuracy.max(1e-13), "{between} {k}: {stage:?}");
            }
        }
    }

    #[test]
    fn a_joint_whose_axis_the_vector_lies_along_is_free() {
        let [over_x, over_z] = sights(0.9, [0.64, -0.48, 0.6], [0.0, 0.4]);
        let stage = aim(defaults(), over_x, over_z);
        assert_eq!(
            (stage.len, stage.doubt),
            (1, Some(Doubt { angular: true, free: JointMask::single(0), ..Doubt::NOTHING }))
        );
        assert!(found(&stage, [0.3, 0.4]) < 1e-15);
    }

    #[test]
    fn parallel_axes_leave_the_first_joint_free_and_offer_what_the_slide_does_not_move() {
        let [over_x, over_z] = sights(0.0, [1.0, 0.0, 0.0], [0.9, 0.4]);
        let stage = aim(defaults(), over_x, over_z);
        assert_eq!(
            (stage.len, stage.doubt),
            (3, Some(Doubt { angular: true, free: JointMask::single(0), ..Doubt::NOTHING }))
        );
        // h is at right angles to the slide, the third axis, at x = 0.9.
        assert!(found(&stage, [0.9, 0.4]) < 1e-15 && found(&stage, [0.3, 1.0]) < 1e-15, "{stage:?}");
    }
}
