//! Rows of four numbers, one of each lane, turned into vectors and back. All numbers move by shuffles of registers:
//! single copies through memory take longer than a pose.

use fearless_simd::{ExtractToken, Simd, SimdBase, f64x2, f64x4, f64x8};

use super::MOST_LANES;

/// Four numbers of a row.
type Quad = [f64; 4];

/// Vectors that hold a number for each of the rows.
pub trait Turned<S: Simd>: Sized {
    /// The first numbers of the rows, the second ones, and so on.
    fn columns(set: S, rows: &[Quad; MOST_LANES]) -> [Self; 4];
    /// The opposite.
    fn rows(columns: [Self; 4]) -> [Quad; MOST_LANES];
}

#[inline(always)]
fn load<S: Simd>(set: S, quad: &Quad) -> f64x4<S> {
    SimdBase::load_array_ref(set, quad)
}

#[inline(always)]
fn stored<S: Simd>(vector: f64x4<S>) -> Quad {
    let mut quad = [0.0; 4];
    SimdBase::store_array(vector, &mut quad);
    quad
}

/// Four rows of four numbers to their columns; the opposite is the same.
#[inline(always)]
fn turn<S: Simd>([a, b, c, d]: [f64x4<S>; 4]) -> [f64x4<S>; 4] {
    // Of a and c: their first two numbers in turn, then the last two; of b and d likewise.
    let ((ac_front, ac_back), (bd_front, bd_back)) = (a.interleave(c), b.interleave(d));
    let ((first, second), (third, fourth)) = (ac_front.interleave(bd_front), ac_back.interleave(bd_back));
    [first, second, third, fourth]
}

impl<S: Simd> Turned<S> for f64x2<S> {
    #[inline(always)]
    fn columns(set: S, [a, b, ..]: &[Quad; MOST_LANES]) -> [Self; 4] {
        let ((a_front, a_back), (b_front, b_back)) = (set.split_f64x4(load(set, a)), set.split_f64x4(load(set, b)));
        [a_front.zip_low(b_front), a_front.zip_high(b_front), a_back.zip_low(b_back), a_back.zip_high(b_back)]
    }
    #[inline(always)]
    fn rows([x, y, z, w]: [Self; 4]) -> [Quad; MOST_LANES] {
        let set = ExtractToken::token(&x);
        let mut rows = [[0.0; 4]; MOST_LANES];
        let [a, b, ..] = &mut rows;
        *a = stored(set.combine_f64x2(x.zip_low(y), z.zip_low(w)));
        *b = stored(set.combine_f64x2(x.zip_high(y), z.zip_high(w)));
        rows
    }
}

impl<S: Simd> Turned<S> for f64x4<S> {
    #[inline(always)]
    fn columns(set: S, [a, b, c, d, ..]: &[Quad; MOST_LANES]) -> [Self; 4] {
        turn([load(set, a), load(set, b), load(set, c), load(set, d)])
    }
    #[inline(always)]
    fn rows(columns: [Self; 4]) -> [Quad; MOST_LANES] {
        let [a, b, c, d] = turn(columns);
        let none = [0.0; 4];
        [stored(a), stored(b), stored(c), stored(d), none, none, none, none]
    }
}

impl<S: Simd> Turned<S> for f64x8<S> {
    #[inline(always)]
    fn columns(set: S, [a, b, c, d, e, f, g, h]: &[Quad; MOST_LANES]) -> [Self; 4] {
        let [x, y, z, w] = turn([load(set, a), load(set, b), load(set, c), load(set, d)]);
        let [p, q, r, s] = turn([load(set, e), load(set, f), load(set, g), load(set, h)]);
        [set.combine_f64x4(x, p), set.combine_f64x4(y, q), set.combine_f64x4(z, r), set.combine_f64x4(w, s)]
    }
    #[inline(always)]
    fn rows([x, y, z, w]: [Self; 4]) -> [Quad; MOST_LANES] {
        let set = ExtractToken::token(&x);
        let ((x, p), (y, q)) = (set.split_f64x8(x), set.split_f64x8(y));
        let ((z, r), (w, s)) = (set.split_f64x8(z), set.split_f64x8(w));
        let ([a, b, c, d], [e, f, g, h]) = (turn([x, y, z, w]), turn([p, q, r, s]));
        [stored(a), stored(b), stored(c), stored(d), stored(e), stored(f), stored(g), stored(h)]
    }
}
