//! An order of functions in which each stands next to those that it is like: gzip looks back over 32 kB.

use std::collections::{BTreeSet, HashMap};

/// Length of the pieces of code that functions are compared by, bytes.
const PIECE: usize = 6;
/// One piece of so many counts.
const SAMPLED: u64 = 16;
/// Pieces that are in more functions than this tell nothing.
const COMMON: usize = 400;
/// Weights of the functions placed last, the last one first.
const WEIGHTS: [u32; 4] = [4, 1, 1, 1];
/// Added to a function's number of pieces: a short one is like many by chance.
const SHORT: f64 = 8.0;

/// Places of functions: after each comes the one that shares most of its pieces with the last ones, in parts of all of its
/// own. The largest function is first, and the largest that is left follows one that is like no other.
pub fn side_by_side(functions: &[&[u8]]) -> Vec<usize> {
    let pieces: Vec<Vec<u64>> = functions.iter().map(|code| sampled(code)).collect();
    let mut having: HashMap<u64, Vec<usize>> = HashMap::new();
    for (function, own) in pieces.iter().enumerate() {
        for piece in own {
            having.entry(*piece).or_default().push(function);
        }
    }
    having.retain(|_, functions| (2..COMMON).contains(&functions.len()));
    let mut left: BTreeSet<(std::cmp::Reverse<usize>, usize)> =
        functions.iter().enumerate().map(|(function, code)| (std::cmp::Reverse(code.len()), function)).collect();
    let mut placed = vec![false; functions.len()];
    let mut order: Vec<usize> = Vec::with_capacity(functions.len());
    while let Some((_, largest)) = left.first().copied() {
        let mut shared: HashMap<usize, u32> = HashMap::new();
        for (last, weight) in order.iter().rev().zip(WEIGHTS) {
            for piece in pieces.get(*last).into_iter().flatten() {
                for other in having.get(piece).into_iter().flatten() {
                    if placed.get(*other) == Some(&false) {
                        *shared.entry(*other).or_default() += weight;
                    }
                }
            }
        }
        let own = |function: usize| pieces.get(function).map_or(0, Vec::len);
        let likeness =
            |(function, shared): (usize, u32)| (f64::from(shared) / (own(function) as f64 + SHORT), function);
        let most = |a: (f64, usize), b: (f64, usize)| if a.0 > b.0 || (a.0 == b.0 && a.1 < b.1) { a } else { b };
        let next = shared.into_iter().map(likeness).reduce(most).map_or(largest, |(_, function)| function);
        if let Some(placed) = placed.get_mut(next) {
            *placed = true;
        }
        left.remove(&(std::cmp::Reverse(functions.get(next).map_or(0, |code| code.len())), next));
        order.push(next);
    }
    order
}

/// Some pieces of a function, by the hash FNV-1a, each once.
fn sampled(code: &[u8]) -> Vec<u64> {
    let hash = |piece: &[u8]| {
        piece
            .iter()
            .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
    };
    let mut pieces: Vec<u64> = code.windows(PIECE).map(hash).filter(|hash| (hash >> 20) % SAMPLED == 0).collect();
    pieces.sort_unstable();
    pieces.dedup();
    pieces
}
