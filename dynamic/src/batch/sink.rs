//! Solutions of a block as rows.

use denhart::Flags;
use denhart::batch::{BLOCK, Found, Lanes, Row, step_lanes, within_lanes};
use denhart_codegen::model::MOST_JOINTS;

use super::plan::Plan;
use super::rows::{Rows, lanes_of, of_lane};
use super::run::Sink;
use crate::tape::Register;

/// Every solution of each target, in the order of the branches.
pub struct All<'a> {
    /// So many joint values a target.
    pub q: &'a mut [f64],
    pub width: usize,
    pub found: &'a mut [Found],
}

impl Sink for All<'_> {
    #[inline(always)]
    fn push<L: Lanes>(&mut self, set: L::Set, plan: &Plan, rows: &Rows, q: &[Register], alive: u32) -> u32 {
        let outside =
            outside::<L>(set, plan, |joint, at| rows.load(set, q.get(joint).copied().unwrap_or(Register::MAX), at));
        // With the number of joints known, their values are copied without a loop.
        match q.len() {
            2 => self.list::<2>(rows, q, alive, outside),
            3 => self.list::<3>(rows, q, alive, outside),
            4 => self.list::<4>(rows, q, alive, outside),
            5 => self.list::<5>(rows, q, alive, outside),
            6 => self.list::<6>(rows, q, alive, outside),
            7 => self.list::<7>(rows, q, alive, outside),
            8 => self.list::<8>(rows, q, alive, outside),
            9 => self.list::<9>(rows, q, alive, outside),
            10 => self.list::<10>(rows, q, alive, outside),
            // No inverse of an arm has another number of joints: what is not listed takes a single call.
            _ => return u32::MAX,
        }
        0
    }
}

impl All<'_> {
    /// Appends the joint vector of every lane of the mask.
    #[inline(always)]
    fn list<const N: usize>(&mut self, rows: &Rows, q: &[Register], alive: u32, outside: u32) {
        static NOTHING: Row = Row::all(f64::NAN);
        let mut values: [&Row; N] = [&NOTHING; N];
        for (value, register) in values.iter_mut().zip(q) {
            *value = rows.row(*register).unwrap_or(&NOTHING);
        }
        for lane in lanes_of(alive) {
            let Some(found) = self.found.get_mut(lane) else { continue };
            let number = usize::from(found.count);
            let place = self.q.get_mut(lane * self.width + number * N..).and_then(<[f64]>::first_chunk_mut::<N>);
            let (Some(place), Some(flags), true) = (place, found.flags.get_mut(number), (number + 1) * N <= self.width)
            else {
                continue;
            };
            *place = values.map(|row| of_lane(row, lane));
            *flags = if outside >> lane & 1 == 0 { Flags::EXACT } else { Flags::EXACT.union(Flags::OUT_OF_LIMITS) };
            found.count += 1;
        }
    }
}

/// The solution of each target that is nearest to its reference, within the limits.
pub struct Nearest<'a> {
    /// References, by joint.
    pub references: &'a [Row],
    /// Of each joint its weight, and of a prismatic one the reach, to which its steps are relative.
    pub weights: &'a [(f64, Option<f64>)],
    pub limits: &'a [[f64; 2]],
    /// The best so far, by joint, and how far it is.
    pub best: [Row; MOST_JOINTS],
    pub distance: Row,
    /// Lanes that have a solution, and lanes that have one within the limits.
    pub exists: u32,
    pub listed: u32,
}

impl Sink for Nearest<'_> {
    #[inline(always)]
    fn push<L: Lanes>(&mut self, set: L::Set, plan: &Plan, rows: &Rows, q: &[Register], alive: u32) -> u32 {
        let mut doubt = 0;
        let mut turned = [Row::all(0.0); MOST_JOINTS];
        let mut distance = Row::all(0.0);
        for at in 0..BLOCK / L::WIDTH {
            let mut sum = L::all(set, 0.0);
            let joints = q.iter().zip(self.references).zip(self.weights.iter().zip(self.limits)).zip(&mut turned);
            for (((register, reference), ((weight, reach), limits)), place) in joints {
                let (value, reference): (L, L) = (rows.load(set, *register, at), L::load(set, reference, at));
                let (value, step, unsure) = step_lanes(set, value, reference, *limits, *reach);
                value.store(place, at);
                doubt |= L::bits(unsure) << (at * L::WIDTH);
                sum = sum + sum.of(*weight) * step * step;
            }
            sum.store(&mut distance, at);
        }
        // A joint on another turn may be outside limits that its angle in (-pi, pi] is within.
        let mut outside = 0;
        for at in 0..BLOCK / L::WIDTH {
            let mut inside = L::mask(set, true);
            for (row, limits) in turned.iter().zip(self.limits) {
                let value = L::load(set, row, at);
                inside = L::both(inside, within_lanes(value, *limits, value.abs()));
            }
            outside |= L::bits(L::not(inside)) << (at * L::WIDTH);
        }
        outside |= beyond_sums::<L>(set, plan, |joint, at| {
            turned.get(joint).map_or(L::all(set, 0.0), |row| L::load(set, row, at))
        });
        self.exists |= alive;
        let known = self.listed;
        let candidates = alive & !outside & !doubt;
        for lane in lanes_of(candidates) {
            let (Some(new), Some(old)) = (distance.0.get(lane), self.distance.0.get_mut(lane)) else { continue };
            if known >> lane & 1 == 0 || *new < *old {
                *old = *new;
                for (best, row) in self.best.iter_mut().zip(&turned).take(q.len()) {
                    if let Some(place) = best.0.get_mut(lane) {
                        *place = of_lane(row, lane);
                    }
                }
            }
        }
        self.listed |= candidates;
        doubt
    }
}

/// Lanes whose joint vector is outside the limits. Joints whose limits are a whole turn or more are not looked at.
#[inline(always)]
fn outside<L: Lanes>(set: L::Set, plan: &Plan, value: impl Fn(usize, usize) -> L) -> u32 {
    let mut outside = 0;
    if !plan.limited.is_empty() {
        for at in 0..BLOCK / L::WIDTH {
            let mut inside = L::mask(set, true);
            for (joint, limits) in &plan.limited {
                let value = value(*joint, at);
                inside = L::both(inside, within_lanes(value, *limits, value.abs()));
            }
            outside |= L::bits(L::not(inside)) << (at * L::WIDTH);
        }
    }
    outside | beyond_sums::<L>(set, plan, value)
}

/// Lanes in which a sum of joint values is outside its limits.
#[inline(always)]
fn beyond_sums<L: Lanes>(set: L::Set, plan: &Plan, value: impl Fn(usize, usize) -> L) -> u32 {
    let mut outside = 0;
    for (factors, limits) in &plan.combined {
        for at in 0..BLOCK / L::WIDTH {
            let (mut sum, mut size) = (L::all(set, 0.0), L::all(set, 0.0));
            for (joint, factor) in factors {
                let term = sum.of(*factor) * value(*joint, at);
                sum = sum + term;
                size = size + term.abs();
            }
            outside |= L::bits(L::not(within_lanes(sum, *limits, size))) << (at * L::WIDTH);
        }
    }
    outside
}
