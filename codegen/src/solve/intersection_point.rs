//! Frames of a triple moved to the point in which its axes intersect.

use super::loop_closure::{Link, LoopClosure};
use super::sides::{Side, foot};
use crate::symbolic::{Dimension, Expr, Graph, Rigid};

impl LoopClosure {
    /// Of a triple whose axes intersect, frames are moved along the outer axes of the triple so that both have the intersection
    /// as their origin.
    pub(super) fn move_to_intersection(&mut self) {
        let [a, b, c, .., z] = self.order;
        self.move_triple_to_intersection([z, a, b, c]);
    }

    /// Moves the frames of any triple, after the joint before it, to the intersection.
    pub fn move_triple_to_intersection(&mut self, [z, a, b, c]: [usize; 4]) {
        let (on_a, on_c) = (self.intersection(a, false), self.intersection(b, true));
        let shift = |g: &mut Graph, link: Link, before: Expr, after: Expr| {
            let along = |e: Expr| Rigid { p: [Expr::ZERO, Expr::ZERO, e], ..Rigid::identity() };
            let opposite = |g: &mut Graph, e: Expr| g.neg(e);
            let (b, a) = (along(before), along(after));
            let (b_back, a_back) = (along(opposite(g, before)), along(opposite(g, after)));
            let forward = link.forward.then(g, &a);
            let forward = b.then(g, &forward);
            let back = link.back.then(g, &b_back);
            let back = a_back.then(g, &back);
            Link { forward, back, target: link.target }
        };
        let (minus_a, minus_c) = (self.g.neg(on_a), self.g.neg(on_c));
        for (joint, before, after) in
            [(z, Expr::ZERO, on_a), (a, minus_a, Expr::ZERO), (b, Expr::ZERO, on_c), (c, minus_c, Expr::ZERO)]
        {
            let link = self.link(joint);
            let moved = shift(&mut self.g, link, before, after);
            if let Some(slot) = self.links.get_mut(joint) {
                *slot = moved;
            }
        }
        // The links inside the triple now only turn.
        for joint in [a, b] {
            if let Some(link) = self.links.get_mut(joint) {
                link.forward.p = [Expr::ZERO; 3];
                link.back.p = [Expr::ZERO; 3];
            }
        }
    }

    /// Where the axes before and after a link intersect: its place on the axis before (`far = false`) or after it.
    fn intersection(&mut self, joint: usize, far: bool) -> Expr {
        let link = self.link(joint);
        let rigid = if far { link.back } else { link.forward };
        // The other axis is p + t h; it intersects the z axis where x and y vanish.
        let (p, h) = (rigid.p, rigid.z());
        let heights: Vec<[f64; 2]> = self
            .generic
            .samples()
            .iter()
            .filter_map(|sample| {
                let values = self.g.evaluate(&[p, h].concat(), sample);
                let [px, py, pz, hx, hy, hz] = *values.as_slice() else { return None };
                let t = -(px * hx + py * hy) / (hx * hx + hy * hy);
                Some([pz + t * hz, pz])
            })
            .collect();
        let small = 1e-12 * self.reach;
        if heights.iter().all(|[height, along]| (height - along).abs() <= small) {
            return Side::along(p);
        }
        let place = Dimension::Intersection(self.label(joint), far);
        match heights.as_slice() {
            [[first, _], others @ ..] if others.iter().any(|[height, _]| (height - first).abs() > small) => {
                // It depends on run-time parameters: -(p . h) in the plane, as a share of h, on top of the height of p.
                let Some(foot) = foot(self, p, h) else { return Expr::ZERO };
                let rise = self.g.mul(foot, Side::along(h));
                let height = self.g.add(Side::along(p), rise);
                self.g.name(height, place.to_string().to_lowercase())
            }
            [[height, _], ..] if height.abs() > small => self.g.dimension(place, *height),
            _ => Expr::ZERO,
        }
    }
}
