//! What the search needs to know about an arm, in memory that lives as long as the program.
//!
//! The runtime's [`Facts`] refer to constants. Those of an arm known at run time are kept once for each different set of
//! limits and weights, and never freed: some hundred bytes for each set.

use std::any::Any;
use std::collections::HashMap;
use std::sync::{Mutex, OnceLock, PoisonError};

use denhart::solve::Facts;
use denhart::{CombinedLimit, JointMask, Residual};
use denhart_codegen::lower;

struct Tables<const N: usize> {
    limits: [[f64; 2]; N],
    weights: [f64; N],
    combined: Vec<CombinedLimit<f64, N>>,
}

type Kept = Mutex<HashMap<Vec<u64>, &'static (dyn Any + Send + Sync)>>;

/// The facts of an arm with `N` joints; `None` if it has another number of joints.
pub fn facts<const N: usize>(facts: &lower::Facts) -> Option<Facts<f64, N>> {
    let tables = tables::<N>(facts)?;
    let single = |joint: &usize| JointMask::single(*joint);
    Some(Facts {
        limits: &tables.limits,
        combined: &tables.combined,
        weights: &tables.weights,
        limited: facts.limited,
        prismatic: facts.prismatic.iter().map(single).fold(JointMask::NONE, JointMask::union),
        stands_for: facts.stands_for.as_ref().map_or(JointMask::NONE, single),
        reach: facts.reach,
        tolerance: Residual { position: facts.length, orientation: facts.angle },
    })
}

fn tables<const N: usize>(facts: &lower::Facts) -> Option<&'static Tables<N>> {
    static KEPT: OnceLock<Kept> = OnceLock::new();
    let limits = <[[f64; 2]; N]>::try_from(facts.limits.as_slice()).ok()?;
    let weights = <[f64; N]>::try_from(facts.weights.as_slice()).ok()?;
    let combined = facts.combined.iter().map(|(factors, limits)| {
        let factors = <[f64; N]>::try_from(factors.as_slice()).ok()?;
        Some(CombinedLimit { factors, limits: *limits })
    });
    let combined: Vec<CombinedLimit<f64, N>> = combined.collect::<Option<_>>()?;
    let sums = combined.iter().flat_map(|sum| sum.factors.into_iter().chain(sum.limits));
    let numbers = limits.into_iter().flatten().chain(weights).chain(sums);
    let key: Vec<u64> = [N as u64].into_iter().chain(numbers.map(f64::to_bits)).collect();
    let mut kept = KEPT.get_or_init(Kept::default).lock().unwrap_or_else(PoisonError::into_inner);
    let tables = kept.entry(key).or_insert_with(|| Box::leak(Box::new(Tables { limits, weights, combined })));
    tables.downcast_ref()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn two(low: f64) -> lower::Facts {
        lower::Facts {
            limits: vec![[low, 1.0]; 2],
            limited: true,
            combined: vec![(vec![1.0, 1.0], [-2.0, 2.0])],
            weights: vec![1.0; 2],
            prismatic: vec![1],
            stands_for: None,
            reach: 1.0,
            length: 1e-6,
            angle: 1e-6,
        }
    }

    #[test]
    fn equal_tables_are_kept_once() {
        let [a, b, c] = [-1.0, -1.0, -2.0].map(|low| facts::<2>(&two(low)).unwrap());
        assert!(std::ptr::eq(a.limits, b.limits) && !std::ptr::eq(a.limits, c.limits));
        assert_eq!((a.limits, c.limits), (&[[-1.0, 1.0]; 2], &[[-2.0, 1.0]; 2]));
        assert!(a.prismatic.contains(1) && !a.prismatic.contains(0));
        assert!(facts::<3>(&two(0.0)).is_none());
    }
}
