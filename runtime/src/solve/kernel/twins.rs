//! The roots of two equations in two joints made accurate, two that nearly meet included.

use super::curve::{Across, CurvePoint, Found, Moving, neighbors, newton};
use super::roots::Roots;
use super::tolerances::Tolerances;

/// Replaces every root of the rows by one that is accurate: two candidates for two close roots by one each. Returns
/// whether all of them are roots beyond doubt.
///
/// The second row says that `across` is of equal length over either joint. Where that vector nearly vanishes, the
/// second row knows two close roots to the root of rounding. Where two roots nearly meet elsewhere, Newton's method has
/// no direction between them; there, too, both are taken from the lengths.
pub(super) fn with_twins<T, X, Z>(stage: &mut Roots<T, 2, 4>, (p, q): (&[X; 2], &[Z; 2]), across: &Across<X, Z>) -> bool
where
    T: Tolerances,
    X: Moving<T>,
    Z: Moving<T>,
{
    let ([row_p, _], [row_q, _]) = (p, q);
    let rows = (row_p, row_q);
    let apart = |[x, z]: &CurvePoint<T>, [u, w]: &CurvePoint<T>| X::between(x, u).max(Z::between(z, w));
    let mut found = stage.roots;
    let mut done = 0;
    let mut sure = true;
    // Every pass is done with one root or two.
    for _ in 0..4 {
        let Some(&root) = found.get(done).filter(|_| done < stage.len) else { break };
        let Found { point: itself, closed, sure: known } = newton(p, q, root);
        let size = across.relative(&root);
        sure &= known && size >= T::DOUBTFUL;
        // Two candidates for two roots that are closer than the quartic tells apart, which is the fourth root of
        // rounding at worst: one each.
        let close = |other: &CurvePoint<T>| apart(other, &root) < T::COINCIDENT.sqrt();
        let twin = found.iter().take(stage.len).skip(done + 1).position(close);
        if let Some([next, later @ ..]) = found.get_mut(done + 1..)
            && let Some(other) = twin.and_then(|twin| later.get_mut(twin.checked_sub(1)?))
        {
            core::mem::swap(next, other);
        }
        let near = if size < T::DOUBTFUL {
            neighbors(rows, across, root)
        } else if !closed && twin.is_some() {
            // Steps that are not small lead to other roots.
            neighbors(rows, across, root).map(|found| found.filter(close))
        } else {
            [None; 2]
        };
        let pair = if let ([Some(first), Some(second)], Some(_)) = (near, twin) {
            [Some(first), Some(second)]
        } else {
            let nearest = near
                .into_iter()
                .flatten()
                .min_by(|a, b| apart(a, &root).partial_cmp(&apart(b, &root)).unwrap_or(core::cmp::Ordering::Equal));
            // One that is farther away belongs to another candidate, unless this one is no root itself. The lengths
            // tell more than the rows, which close anywhere beside a fourfold root.
            let least = size.min(T::DOUBTFUL) * T::HALF * T::HALF + T::COINCIDENT;
            let gap = across.gap(rows, &itself);
            let taken = |other: &CurvePoint<T>| {
                apart(other, &root) < least || gap > T::VANISHING || gap > T::ROUNDING && close(other)
            };
            [nearest.filter(taken).or(Some(itself)), None]
        };
        for value in pair.into_iter().flatten() {
            if let Some(slot) = stage.roots.get_mut(done) {
                *slot = value;
            }
            done += 1;
        }
    }
    sure && distinct::<T, X, Z>(stage)
}

/// Returns true if no two candidates have become one root.
pub(super) fn distinct<T, X, Z>(stage: &Roots<T, 2, 4>) -> bool
where
    T: Tolerances,
    X: Moving<T>,
    Z: Moving<T>,
{
    let roots = stage.roots.iter().take(stage.len);
    roots.clone().enumerate().all(|(i, [x, z])| {
        roots.clone().skip(i + 1).all(|[u, w]| X::between(x, u).max(Z::between(z, w)) > T::COINCIDENT)
    })
}
