//! One direction seen from two joints with a sliding joint between them.

use super::tolerances::Tolerances;
use super::{Home, Measure, Stage, Turn};
use crate::math::{atan2, sin_cos};
use crate::vector::{cross, dot};

/// A vector that a joint turns about its z axis, and the frame in which it has to be seen: rows that take the frame of
/// the sliding joint to that of the turning one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight<T> {
    /// The unit vector the joint turns.
    pub moved: [T; 3],
    /// Rotation from the sliding joint's frame to this joint's.
    pub frame: [[T; 3]; 3],
}

/// Finds the unit vector `h` with `frame_x h = R_z(-x) moved_x` and `frame_z h = R_z(z) moved_z`, and from it `(x, z)`.
///
/// Both turning axes are fixed in the frame of the sliding joint, so `h` lies on two cones about them:
/// `h = a n_x + b n_z +- c n_x x n_z`. Two roots; one where the cones touch or do not meet, then with the gap.
#[inline]
pub fn aim<T: Tolerances>(home: Home<T>, x: Sight<T>, z: Sight<T>) -> Stage<T, 2, 2> {
    let measure = Measure::DIRECTION;
    let ([_, _, nx], [_, _, nz]) = (x.frame, z.frame);
    let ([ax, ay, kx], [bx, by, kz]) = (x.moved, z.moved);
    let (sx, sz) = ((ax * ax + ay * ay).sqrt(), (bx * bx + by * by).sqrt());
    let normal = cross(nx, nz);
    let (cosine, square) = (dot(nx, nz), dot(normal, normal));
    if !(square > T::VANISHING * T::VANISHING) {
        let turn = Turn::at(home.value);
        let seen = [ax * turn.cos + ay * turn.sin, ay * turn.cos - ax * turn.sin, kx];
        let [row1, row2, row3] = x.frame;
        let h = [0, 1, 2].map(|j| {
            let at = |row: [T; 3]| row.get(j).copied().unwrap_or(T::ZERO);
            at(row1) * seen[0] + at(row2) * seen[1] + at(row3) * seen[2]
        });
        let [_, turn_z] = angles(&x, &z, h);
        let [inner, outer] = margins([kx, sx], [kz, sz], [cosine, square.sqrt()]);
        let gap = (-inner.left).max(-outer.left) - T::VANISHING;
        return Stage::free([turn, turn_z], home, gap.max(T::ZERO), measure);
    }
    let k = T::ONE / square;
    let (a, b) = ((kx - kz * cosine) * k, (kz - kx * cosine) * k);
    let middle = [0, 1, 2].map(|j| {
        let at = |v: [T; 3]| v.get(j).copied().unwrap_or(T::ZERO);
        a * at(nx) + b * at(nz)
    });
    // The squared sine between the planes of the cones, as a product of what is left to either end of the range.
    let (mut near, mut far) = (kx * kz + sx * sz - cosine, cosine - kx * kz + sx * sz);
    if !(near.min(far) > T::DOUBTFUL) {
        let [inner, outer] = margins([kx, sx], [kz, sz], [cosine, square.sqrt()]);
        // The rounding of the angles; roots farther apart are told apart.
        let close = T::EPSILON * (T::TWO + T::TWO);
        if !(inner.left > close) || !(outer.left > close) {
            let gap = (-inner.left).max(-outer.left).max(T::ZERO);
            return Stage::edge(angles(&x, &z, middle), gap, measure);
        }
        (near, far) = (inner.product, outer.product);
    }
    let c = (near * far).sqrt() * k;
    let along = |sign: T| {
        let ([mx, my, mz], [vx, vy, vz]) = (middle, normal);
        [mx + sign * c * vx, my + sign * c * vy, mz + sign * c * vz]
    };
    let roots = [angles(&x, &z, along(T::ONE)), angles(&x, &z, along(-T::ONE))];
    Stage::solved(roots, measure).with_weak(home, (near * far).sqrt().min(square.sqrt()))
}

/// How far two cones are from touching.
struct Margin<T> {
    /// The angle that is left, rad; negative where they do not meet.
    left: T,
    /// What that is as a difference of cosines.
    product: T,
}

/// Inside and outside, from `[cos, sin]` of the half angles of two cones and of the angle between their axes.
#[cold]
#[inline(never)]
fn margins<T: Tolerances>([kx, sx]: [T; 2], [kz, sz]: [T; 2], [cosine, sine]: [T; 2]) -> [Margin<T>; 2] {
    let (first, second, between) = (atan2(sx, kx), atan2(sz, kz), atan2(sine, cosine));
    let (sum, difference) = (first + second, (first - second).abs());
    let widest = sum.min(T::TWO * T::PI - sum);
    // cos small - cos large
    let margin = |large: T, small: T| {
        let (half_sum, half_left) = ((large + small) * T::HALF, (large - small) * T::HALF);
        Margin { left: large - small, product: T::TWO * sin_cos(half_sum).0 * sin_cos(half_left).0 }
    };
    [margin(between, difference), margin(widest, between)]
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
