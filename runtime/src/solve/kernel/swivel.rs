//! The arm angle of a seven-joint arm: how far its elbow is swung about the line from shoulder to wrist.

use super::tolerances::Tolerances;
use crate::Pose;
use crate::math::atan2;
use crate::vector::{cross, dot, norm};

type V<T> = [T; 3];

/// The direction of a vector; upwards for one without length.
fn unit<T: Tolerances>(v: V<T>) -> V<T> {
    let size = norm(v);
    if size > T::ZERO { v.map(|e| e / size) } else { [T::ZERO, T::ZERO, T::ONE] }
}

/// The direction of the line from shoulder to wrist; upwards for a wrist in the shoulder, beside the elbow's distance.
/// Any direction will do there, but always the same one.
fn line<T: Tolerances>(wrist: V<T>, elbow: V<T>) -> V<T> {
    let short = norm(wrist) < T::VANISHING * norm(elbow);
    unit(if short { [T::ZERO; 3] } else { wrist })
}

/// The part of `v` across the unit vector `along`, normalized. Where that part vanishes, the part of a
/// coordinate axis more than 45 degrees from `along`, so that the result is always a unit vector.
fn across<T: Tolerances>(along: V<T>, v: V<T>) -> V<T> {
    let part = |v: V<T>| {
        let k = dot(along, v);
        let ([a, b, c], [x, y, z]) = (along, v);
        [x - k * a, y - k * b, z - k * c]
    };
    let own = part(v);
    if dot(own, own) > T::COINCIDENT * T::COINCIDENT {
        // What is left of a vector nearly along has lost digits across: taken once more it is at right angles to
        // rounding.
        return unit(part(unit(own)));
    }
    let [x, y, _] = along.map(|e| e.abs());
    let (o, i) = (T::ZERO, T::ONE);
    unit(part(if x <= T::HALF {
        [i, o, o]
    } else if y <= T::HALF {
        [o, i, o]
    } else {
        [o, o, i]
    }))
}

/// Where the elbow lies off the line from shoulder to wrist, as a unit vector. This vector is at right angles to the
/// line and to the elbow's axis, on the elbow's side. An arm that is stretched out has the side of the axis turned by a
/// right angle. `distance`: from shoulder to wrist; the shorter, the less is known of the direction of the line.
fn side<T: Tolerances>(line: V<T>, distance: T, axis: V<T>, elbow: V<T>) -> V<T> {
    let normal = across(line, axis);
    let away = cross(normal, line);
    let size = norm(elbow);
    let rounding = T::ROUNDING * size * (T::ONE + size / distance);
    if dot(away, elbow) < -rounding { away.map(|e| -e) } else { away }
}

/// The rotation of the upper arm that puts the wrist where it has to be, with the elbow swung by the arm angle.
///
/// `wrist`: from shoulder to wrist where it has to be, base frame of the shoulder. `moved`, `axis`, `elbow`: the same
/// vector, the elbow's axis and the elbow in the frame of the upper arm. `(sin, cos)`: of the arm angle. The arm angle
/// is zero where the elbow lies on the side of the base's z axis (Kreutz-Delgado, Long, Seraji 1992). Where the wrist
/// lies on the base's z axis, the arm angle is zero with the elbow on the side of the base's x axis.
#[inline]
pub fn swivel<T: Tolerances>(wrist: V<T>, moved: V<T>, axis: V<T>, elbow: V<T>, (sin, cos): (T, T)) -> [[T; 3]; 3] {
    let a = line(wrist, elbow);
    let u = across(a, [T::ZERO, T::ZERO, T::ONE]);
    let [ux, uy, uz] = u;
    let [vx, vy, vz] = cross(a, u);
    let d = [cos * ux + sin * vx, cos * uy + sin * vy, cos * uz + sin * vz];
    let m = line(moved, elbow);
    let s = side(m, norm(moved), axis, elbow);
    let (to, from) = ([a, d, cross(a, d)], [m, s, cross(m, s)]);
    [0, 1, 2].map(|row| {
        [0, 1, 2].map(|column| {
            to.iter().zip(&from).fold(T::ZERO, |sum, (to, from)| {
                let at = |v: &V<T>, i: usize| v.get(i).copied().unwrap_or(T::ZERO);
                sum + at(to, row) * at(from, column)
            })
        })
    })
}

/// Constants from which the arm angle of a joint vector is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swivel<T> {
    /// The frame whose origin is the shoulder and whose z axis is the first joint's, in the base frame.
    pub shoulder: Pose<T>,
    /// The wrist in the frame of the link after the elbow.
    pub wrist: V<T>,
    /// The direction of the elbow's axis in that frame.
    pub axis: V<T>,
    /// A point of the elbow's axis in that frame.
    pub elbow: V<T>,
}

impl<T: Tolerances> Swivel<T> {
    /// The arm angle, rad, from the pose of the link after the elbow.
    pub fn angle(&self, link: &Pose<T>) -> T {
        let seen = self.shoulder.inverse() * *link;
        let [[a, b, c], [d, e, f], [g, h, i]] = seen.rotation;
        let [x, y, z] = self.axis;
        let axis = [a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z];
        let foot = {
            let point = seen.transform_point(&self.elbow);
            let along = dot(point, axis);
            let ([px, py, pz], [x, y, z]) = (point, axis);
            [px - along * x, py - along * y, pz - along * z]
        };
        let wrist = seen.transform_point(&self.wrist);
        let line = line(wrist, foot);
        let up = across(line, [T::ZERO, T::ZERO, T::ONE]);
        let side = side(line, norm(wrist), axis, foot);
        atan2(dot(cross(line, up), side), dot(up, side))
    }
}
