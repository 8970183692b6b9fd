//! Commuted chains: the prismatic joints stand in other places.
//!
//! A prismatic joint commutes with a prismatic one, and with a revolute one about a parallel axis.

use super::loop_chain::LoopChain;
use crate::model::Angle;
use crate::symbolic::{Graph, Rigid};

/// The chain itself, and every chain that comes of moving prismatic joints past others.
pub fn commuted(chain: &LoopChain) -> Vec<LoopChain> {
    let mut found = vec![chain.clone()];
    let mut next = 0;
    while let Some(current) = found.get(next).cloned() {
        next += 1;
        let moved =
            (0..current.loop_joints.len()).flat_map(|i| [current.prismatic_later(i), current.prismatic_earlier(i)]);
        for moved in moved.flatten().collect::<Vec<_>>() {
            if !found.iter().any(|known| known.loop_joints == moved.loop_joints) {
                found.push(moved);
            }
        }
    }
    found
}

impl LoopChain {
    /// The chain with the prismatic joint `i` moved past the joint after it. The joint after it is prismatic, or
    /// revolute about a parallel axis: `T_z(d) C R_z(t) = C R_z(t) T_z(+-d)`.
    pub fn prismatic_later(&self, i: usize) -> Option<LoopChain> {
        let (slides, next) = (self.loop_joints.get(i)?, self.loop_joints.get(i + 1)?);
        if slides.revolute {
            return None;
        }
        if !next.revolute {
            return Some(self.prismatic_swapped(i));
        }
        let sign = self.keeps_axis(i + 1)?;
        let mut moved = self.clone();
        let g = &mut moved.g;
        let before = self.link(i).then(g, &self.link(i + 1));
        let (there, back) = flip(g, sign);
        let after = back.then(g, &self.link(i + 2));
        Some(moved.exchanged(i, [before, there, after]))
    }

    /// The chain with the prismatic joints `i` and `i + 1` in the other order.
    fn prismatic_swapped(&self, i: usize) -> LoopChain {
        let mut moved = self.clone();
        let g = &mut moved.g;
        let between = self.link(i + 1);
        let before = self.link(i).then(g, &between);
        let after = between.then(g, &self.link(i + 2));
        let back = between.inverse(g);
        moved.exchanged(i, [before, back, after])
    }

    /// The chain with joints `i` and `i + 1` in the other order, and the links around them in place of those there are.
    fn exchanged(mut self, i: usize, links: [Rigid; 3]) -> LoopChain {
        self.loop_joints.swap(i, i + 1);
        for (place, link) in self.links.iter_mut().skip(i).zip(links) {
            *place = link;
        }
        self
    }

    /// The chain with the prismatic joint `i` moved before the revolute joint before it.
    pub fn prismatic_earlier(&self, i: usize) -> Option<LoopChain> {
        let (turns, slides) = (self.loop_joints.get(i.checked_sub(1)?)?, self.loop_joints.get(i)?);
        if slides.revolute || !turns.revolute {
            return None;
        }
        let sign = self.keeps_axis(i)?;
        let mut moved = self.clone();
        let g = &mut moved.g;
        let (there, back) = flip(g, sign);
        let before = self.link(i - 1).then(g, &there);
        let after = self.link(i).then(g, &self.link(i + 1));
        Some(moved.exchanged(i - 1, [before, back, after]))
    }
}

/// A half turn about x and its inverse if the sign is negative.
fn flip(g: &mut Graph, sign: f64) -> (Rigid, Rigid) {
    if sign > 0.0 {
        return (Rigid::identity(), Rigid::identity());
    }
    let half = g.turn(Angle::degrees(180.0));
    let there = Rigid { r: g.rotation_x(half), ..Rigid::identity() };
    (there, there)
}
