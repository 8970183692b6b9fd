//! The six joints of a branch at one angle of the held joint.

use super::branch::{Parts, Posed, Signed};
use crate::math::{Scalar, atan2, sin_cos, wrap};
use crate::transform::{Vector, dot};

impl<T: Scalar> Posed<'_, T> {
    /// x2 turns (u, v) along (H, ex) to W.
    pub fn x2(&self, turn: (T, T), p: &Parts<T>, v: T) -> T {
        let ([px, py, _], [hx, hy]) = (self.point.at(turn), self.meet.h_xy);
        let (to_x, to_y) = (p.u * hx - v * hy, p.u * hy + v * hx);
        atan2(to_x * py - to_y * px, to_x * px + to_y * py)
    }

    /// The joints of a branch at an angle t, for an angle x2 that is known, in the order of the chain.
    pub fn joints_about(&self, t: T, turn: (T, T), p: &Parts<T>, branch: &Signed<T>, x2: T) -> [T; 6] {
        let (a, y) = (self.meet.upper, self.meet.lower);
        let (vx, vy) = (branch.v - self.meet.across_x, p.across_y);
        let psi = atan2(branch.w, p.distance2.at(branch.v) - a * a - y * y);
        let (sin, cos) = sin_cos(psi);
        // The direction of the upper link.
        let upper = atan2(vy, vx) - atan2(y * sin, a + y * cos);
        self.joints_of_elbow(t, turn, x2, upper, psi)
    }

    /// The joints, of x2, of the direction of the upper link from ex, and of the elbow angle psi between the links.
    pub fn joints_of_elbow(&self, t: T, turn: (T, T), x2: T, upper: T, psi: T) -> [T; 6] {
        let m = self.meet;
        let (n, side) = (self.normal.at(turn), self.side.at(turn));
        // From before x2 to before u: two turns, in the plane basis.
        let (about_x2, about_h) = (sin_cos(x2), sin_cos(upper + psi - m.lower_angle));
        let before_u = |vector: Vector<T>| {
            let [x, y, h] = self.in_plane(turned_back(vector, about_x2));
            columns(&m.k4, turned_back([x, y, h], about_h))
        };
        let ([ex, ey, _], [dx, dy, _]) = (before_u(n), m.k5.map(|[_, _, z]| z));
        let u = atan2(ey * dx - ex * dy, ex * dx + ey * dy);
        let [sx, sy, _] = columns(&m.k5, turned_back(before_u(side), sin_cos(u)));
        let x4 = psi - m.x4_offset;
        let x4 = if m.is_antiparallel { -x4 } else { x4 };
        self.in_chain_order([t, x2, upper - m.x3_offset, x4, u, atan2(sy, sx)].map(wrap))
    }

    /// A vector along ex, ey and h, of its coordinates after x2.
    pub fn in_plane(&self, [x, y, z]: Vector<T>) -> Vector<T> {
        let ([hx, hy], m) = (self.meet.h_xy, self.meet);
        let along = hx * x + hy * y;
        [hx * y - hy * x, m.eta * z - m.h_z * along, m.eta * along + m.h_z * z]
    }

    fn in_chain_order(&self, ring: [T; 6]) -> [T; 6] {
        let mut joints = [T::ZERO; 6];
        for (at, angle) in self.meet.joints.iter().zip(ring) {
            if let Some(joint) = joints.get_mut(*at) {
                *joint = angle;
            }
        }
        joints
    }
}

/// `Rz(-angle) vector`
pub(super) fn turned_back<T: Scalar>([x, y, z]: Vector<T>, (sin, cos): (T, T)) -> Vector<T> {
    [x * cos + y * sin, y * cos - x * sin, z]
}

/// `R^T vector`
fn columns<T: Scalar>([[a, b, c], [d, e, f], [g, h, i]]: &[Vector<T>; 3], vector: Vector<T>) -> Vector<T> {
    [dot([*a, *d, *g], vector), dot([*b, *e, *h], vector), dot([*c, *f, *i], vector)]
}
