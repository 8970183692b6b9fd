//! The two sides of the loop as seen from joint y: what joint x moves, and what joint z moves.

use super::kernel::{Cone, ConeRange, Distance, ElbowRange, Offset, Slide, Unit};
use super::loop_closure::LoopClosure;
use super::plan::Branching;
use super::sinusoid::{Sinusoid, turned, turned_back};
use crate::model::Angle;
use crate::symbolic::{Dimension, Expr, Graph, Rigid, Vec3};

/// One side: joint `joint` moves the vector `moved`; joint y sees it from `origin`, along `axis`.
///
/// For x the motion is undone (`R_z(-x) moved`), for z it is applied (`R_z(z) moved`). Both are in the frame of the
/// joint, in which y's axis passes through `origin` with direction `axis`.
#[derive(Debug, Clone, Copy)]
pub struct Side {
    /// The joint.
    pub joint: usize,
    /// True if the motion is undone.
    pub undone: bool,
    /// True for a revolute joint.
    pub revolute: bool,
    /// The vector it moves.
    pub moved: Vec3,
    /// A point on y's axis.
    pub origin: Vec3,
    /// The direction of y's axis.
    pub axis: Vec3,
}

/// Both sides, of joint x and of joint z, with the vectors that these move.
pub fn both(c: &LoopClosure, moved: [Vec3; 2], unit: Unit) -> [Side; 2] {
    let [_, _, _, x, y, z] = c.order;
    let mut sides = [(x, true, c.link(x).forward), (z, false, c.link(y).back)].into_iter();
    moved.map(|moved| {
        let (joint, undone, frame) = sides.next().unwrap_or((x, true, Rigid::identity()));
        Side {
            joint,
            undone,
            revolute: c.is_revolute(joint),
            moved: c.clean3(moved, unit),
            origin: c.clean3(frame.p, Unit::Length),
            axis: c.clean3(frame.z(), Unit::Direction),
        }
    })
}

/// Both sides with the point as origin where y's axis and the axis of x (`with_x`) or z intersect, if they do.
pub fn from_intersection(c: &mut LoopClosure, [a, b]: [Side; 2], with_x: bool) -> Option<[Side; 2]> {
    let side = if with_x { a } else { b };
    let height = side.revolute.then(|| side.intersection_height(c)).flatten()?;
    let moved = [a, b].map(|side| side.at_height(c, height));
    let [a, b] = moved;
    let side = if with_x { a } else { b };
    c.vanish(&Side::plane(side.origin), Unit::Length).then_some(moved)
}

impl Side {
    /// `n . (motion of moved) + k` as a row in the joint's cosine and sine.
    pub fn row(&self, c: &mut LoopClosure, n: Vec3, k: Expr) -> Sinusoid {
        if self.undone { turned_back(&mut c.g, n, self.moved, k) } else { turned(&mut c.g, n, self.moved, k) }
    }

    /// The components of a vector in the plane of the joint.
    pub fn plane(v: Vec3) -> [Expr; 2] {
        let [x, y, _] = v;
        [x, y]
    }

    /// The component along the joint.
    pub fn along(v: Vec3) -> Expr {
        let [.., z] = v;
        z
    }

    /// Returns true if the joint moves the component of `moved` along `n` (a direction in the joint's frame).
    pub fn moves_along(&self, c: &LoopClosure, n: Vec3) -> bool {
        if self.revolute {
            !c.vanish(&Self::plane(n), Unit::Direction) && !c.vanish(&Self::plane(self.moved), Unit::Length)
        } else {
            !c.vanish(&[Self::along(n)], Unit::Direction)
        }
    }

    /// Distance stage: the joint brings `moved` to distance `rho` from `origin`, both at their heights (`flat`: only
    /// the parts in the joint's plane count).
    pub fn distance(&self, c: &mut LoopClosure, rho: Expr, flat: bool, meaning: String) {
        let (moved, origin) = (Self::plane(self.moved), Self::plane(self.origin));
        let height = if flat {
            Expr::ZERO
        } else {
            let difference = c.g.sub(Self::along(self.moved), Self::along(self.origin));
            c.clean(difference, Unit::Length)
        };
        let meaning =
            if height == Expr::ZERO { meaning.replace(" + h^2", "").replace(", `h = {h}`", "") } else { meaning };
        let range = ElbowRange { a: c.g.norm(&origin), b: c.g.norm(&moved), height };
        for link in [range.a, range.b] {
            c.g.name(link, "link");
        }
        // Stretched: the turned vector points away from the other. The angle turns one onto the other's opposite.
        let away = |c: &mut LoopClosure, v: [Expr; 2]| v.map(|e| c.g.neg(e));
        let (shift, about) = if self.undone {
            let from = away(c, origin);
            c.between(from, moved)
        } else {
            let to = away(c, origin);
            c.between(moved, to)
        };
        let kernel = Distance { rho, range, about };
        c.stage(&[(self.joint, shift)], Unit::Length, Branching::Elbow, meaning, kernel);
    }

    /// Stage of a prismatic joint that brings `moved` to distance `rho` from `origin`. With `flat` the displacement is
    /// across y's axis, and the parts along that axis do not count.
    pub fn slide(&self, c: &mut LoopClosure, rho: Expr, flat: bool, meaning: String) {
        let between = c.g.sub3(self.moved, self.origin);
        let [bx, by, bz] = between;
        let across = if flat {
            let e = c.g.cross2(Self::plane(self.axis), [bx, by]);
            c.g.norm(&[e])
        } else {
            c.g.norm(&[bx, by])
        };
        let middle = if self.undone { bz } else { c.g.neg(bz) };
        let kernel = Slide { rho, across, middle };
        c.stage(&[(self.joint, Angle::ZERO)], Unit::Length, Branching::Elbow, meaning, kernel);
    }

    /// Cone stage: the joint gives `moved` (seen from where y's axis and this joint's intersect) the component `d` along
    /// y's axis, `rho` across it.
    pub fn cone(&self, c: &mut LoopClosure, d: Expr, rho: Expr, unit: Unit, branching: Branching, meaning: String) {
        let along = match unit {
            Unit::Length => c.g.sub(Self::along(self.moved), Self::along(self.origin)),
            Unit::Direction => Self::along(self.moved),
        };
        let (moved, axis) = (Self::plane(self.moved), Self::plane(self.axis));
        let range = ConeRange {
            along: c.clean(along, unit),
            across: c.g.norm(&moved),
            cos: Self::along(self.axis),
            sin: c.g.norm(&axis),
        };
        let (shift, about) = if self.undone { c.between(axis, moved) } else { c.between(moved, axis) };
        c.g.name(range.across, format!("radius{}", c.label(self.joint)));
        let kernel = Cone { d, rho, range, about };
        c.stage(&[(self.joint, shift)], unit, branching, meaning, kernel);
    }

    /// Offset stage: `row = value`, lengths, for a revolute joint.
    pub fn offset(&self, c: &mut LoopClosure, row: Sinusoid, value: Expr, branching: Branching, meaning: String) {
        let d = c.g.sub(value, row.k);
        let kernel = Offset { a: row.c, b: row.s, d };
        c.stage(&[(self.joint, Angle::ZERO)], Unit::Length, branching, meaning, kernel);
    }

    /// `moved` after the (solved) motion, as a point.
    pub fn point(&self, c: &mut LoopClosure) -> Vec3 {
        if self.undone { c.move_back(self.joint, self.moved) } else { c.move_by(self.joint, self.moved) }
    }

    /// `moved` after the (solved) motion, as a direction.
    pub fn direction(&self, c: &mut LoopClosure) -> Vec3 {
        if self.revolute { self.point(c) } else { self.moved }
    }

    /// A point on y's axis that this joint does not move: where the axes intersect, if they do.
    fn intersection_height(&self, c: &mut LoopClosure) -> Option<Expr> {
        let [ox, oy, _] = self.origin.map(|e| c.value(e));
        let [ax, ay, _] = self.axis.map(|e| c.value(e));
        let (ax, ay) = (ax?, ay?);
        let size = ax * ax + ay * ay;
        if size <= 1e-20 {
            return None;
        }
        let (Some(ox), Some(oy)) = (ox, oy) else {
            let height = foot(c, self.origin, self.axis)?;
            return Some(c.g.name(height, Dimension::IntersectionOnY.to_string().to_lowercase()));
        };
        let height = -(ox * ax + oy * ay) / size;
        Some(if height.abs() <= 1e-12 * c.reach {
            Expr::ZERO
        } else {
            c.g.dimension(Dimension::IntersectionOnY, height)
        })
    }

    /// Returns the side with another point on y's axis as origin.
    fn at_height(&self, c: &mut LoopClosure, height: Expr) -> Side {
        let along = c.g.scale3(height, self.axis);
        let origin = c.g.add3(self.origin, along);
        Side { origin: c.clean3(origin, Unit::Length), ..*self }
    }
}

/// `t` at which the line `p + t h` is nearest to the z axis; `None` for a direction that is not constant, or along z.
pub fn foot(c: &mut LoopClosure, [px, py, pz]: Vec3, [hx, hy, _]: Vec3) -> Option<Expr> {
    let (hx, hy) = (c.value(hx)?, c.value(hy)?);
    let square = hx * hx + hy * hy;
    if square <= 1e-20 {
        return None;
    }
    let [px, py, _] = c.clean3([px, py, pz], Unit::Length);
    // A factor that vanishes is rounding of the direction.
    let share = |g: &mut Graph, x: f64| g.number(if x.abs() <= 1e-15 { 0.0 } else { -x / square });
    let (kx, ky) = (share(&mut c.g, hx), share(&mut c.g, hy));
    let (x, y) = (c.g.mul(kx, px), c.g.mul(ky, py));
    Some(c.g.add(x, y))
}
