//! Real roots of a trigonometric polynomial of degree 8, by the signs of Bernstein coefficients on four arcs.
//!
//! On an arc of a quarter turn, in `x = tan(u / 2)`, the polynomial times `(1 + x^2)^8` is a polynomial of degree 16.
//! Its Bernstein coefficients change sign at least as often as it has roots, and as often modulo 2. No change: no root.
//! One change: one root, which Newton's method finds. More: the arc is halved.

use super::tables::{EVEN, HALF_ARC, ODD};
use super::{DEGREE, SAMPLES, TrigPolynomial, value_and_slope};
use crate::math::wrap;

/// The most roots of a list. A polynomial has 16; a multiple root may be listed in several pieces.
pub const MOST_ROOTS: usize = 24;
/// The most pieces that are looked at.
pub const MOST_NODES: usize = 400;
/// An arc is halved at most so often.
const DEPTH: u8 = 18;
/// More pieces than this cannot wait.
const STACK: usize = DEPTH as usize + 2;
/// A piece narrower than this, in x, whose halves have no change of sign, has a pair of roots which rounding or a
/// target just out of reach has made complex.
const NEAR: f64 = 0.1;
/// Pieces narrower than this part of the half arc are not halved because of their ends.
const NARROW: f64 = 0.02;
/// A root is doubtful if rounding may move it by more, rad.
const UNCERTAIN: f64 = 1e-7;
/// No root counts as farther from the others, rad.
const WIDEST: f64 = 0.1;
/// The most steps of Newton's method for one root.
const STEPS: usize = 12;

/// A real root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// The angle t, in (-pi, pi] rad.
    pub angle: f64,
    /// Its sine and cosine.
    pub sin_cos: (f64, f64),
    /// The derivative of the polynomial there.
    pub slope: f64,
    /// Two roots that meet, or nearly so: rounding decides how many there are.
    pub is_double: bool,
    /// A double root is somewhere within this half-angle tangent of the angle: all along the polynomial may be rounding.
    pub spread: f64,
    /// Double, or moved by rounding by more than 1e-7 rad.
    pub is_doubtful: bool,
}

/// The real roots of a polynomial, in the order of the arcs and along each of them.
#[derive(Clone, Copy, Debug)]
pub struct Roots {
    list: [Root; MOST_ROOTS],
    len: usize,
    /// Values of the polynomial are so far off.
    pub rounding: f64,
    /// The number of pieces that were looked at, at most [`MOST_NODES`].
    pub nodes: usize,
    /// False if the list was full or [`MOST_NODES`] was reached: roots may be missing.
    pub is_complete: bool,
}

impl Default for Roots {
    fn default() -> Self {
        Self::none(0.0)
    }
}

impl Roots {
    /// All bits zero: making a list is a single fill of memory.
    const ZERO: Self = {
        let (angle, sin_cos, slope, spread) = (0.0, (0.0, 0.0), 0.0, 0.0);
        let none = Root { angle, sin_cos, slope, is_double: false, spread, is_doubtful: false };
        Self { list: [none; MOST_ROOTS], len: 0, rounding: 0.0, nodes: 0, is_complete: false }
    };

    /// No root yet, of a polynomial whose values are `rounding` off.
    #[inline]
    pub(super) const fn none(rounding: f64) -> Self {
        let mut roots = Self::ZERO;
        (roots.rounding, roots.is_complete) = (rounding, true);
        roots
    }

    /// Empties the list, for a polynomial whose values are `rounding` off.
    pub(super) fn clear(&mut self, rounding: f64) {
        (self.len, self.rounding, self.nodes, self.is_complete) = (0, rounding, 0, true);
    }

    /// The roots that were found.
    #[inline]
    pub fn as_slice(&self) -> &[Root] {
        self.list.get(..self.len).unwrap_or(&self.list)
    }

    /// Returns true for a root that rounding moves by less than a thousandth of its distance from the others.
    pub fn is_apart(&self, root: &Root) -> bool {
        !root.is_double && self.rounding <= 1e-3 * self.gap(root) * root.slope.abs()
    }

    /// Distance of a root from the others, at most 0.1 rad.
    fn gap(&self, root: &Root) -> f64 {
        let others = self.as_slice().iter().filter(|other| *other != root);
        others.fold(WIDEST, |gap, other| gap.min(wrap(other.angle - root.angle).abs()))
    }

    /// A root may be off by this, rad. Those in doubt beside each other may be one multiple root.
    pub fn off(&self, root: &Root) -> f64 {
        let moved = self.rounding / root.slope.abs();
        if self.is_apart(root) { moved } else { root.spread.max(self.gap(root)) }
    }

    fn push(&mut self, root: Root) {
        match self.list.get_mut(self.len) {
            Some(place) => {
                *place = root;
                self.len += 1;
            }
            None => self.is_complete = false,
        }
    }
}

/// A part of an arc.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    /// Bernstein coefficients.
    pub(super) b: [f64; SAMPLES],
    /// Where it begins, in x.
    pub(super) low: f64,
    pub(super) width: f64,
    /// So often the arc has been halved.
    pub(super) depth: u8,
}

/// A quarter of the circle, with the polynomial in the angle from its middle.
struct Arc {
    /// The number of quarter turns from u = 0 to the middle.
    quarters: usize,
    cosines: [f64; DEGREE + 1],
    sines: [f64; DEGREE + 1],
    offset_sin_cos: (f64, f64),
    /// See [`find`].
    rounding: f64,
}

/// A function of x on an arc.
pub(super) trait Curve {
    /// Value and derivative, both times one positive number.
    fn at(&self, x: f64) -> (f64, f64);
    /// The root at x, a double one with its spread.
    fn root(&self, x: f64, spread: Option<f64>) -> Root;
}

/// Lists the roots of a polynomial. Coefficients up to the `rounding` of the list have no sign. A root is doubtful if values that
/// are so far off move it by more than 1e-7 rad. Out of line: the pieces are on the stack for as long as it takes.
#[inline(never)]
pub(super) fn find(polynomial: &TrigPolynomial, out: &mut Roots) {
    for quarters in 0..4 {
        let arc = Arc::of(polynomial, quarters, out.rounding);
        let piece = Piece { b: arc.bernstein(), low: -HALF_ARC, width: 2.0 * HALF_ARC, depth: 0 };
        isolate(&arc, piece, Range { half: HALF_ARC, near: NEAR }, out);
    }
}

/// The range that is searched.
#[derive(Clone, Copy)]
pub(super) struct Range {
    /// x is in `[-half, half]`.
    pub(super) half: f64,
    /// See [`NEAR`].
    pub(super) near: f64,
}

/// Lists the roots of a piece of a range.
pub(super) fn isolate(curve: &impl Curve, first: Piece, range: Range, out: &mut Roots) {
    let mut stack = [first; STACK];
    let mut waiting = 1_usize;
    while out.nodes < MOST_NODES
        && let Some(top) = waiting.checked_sub(1)
        && let Some([piece, left, ..]) = stack.get_mut(top..)
    {
        waiting = top;
        out.nodes += 1;
        if look_at(piece, left, curve, range, out) {
            waiting += 2;
        }
    }
    if waiting > 0 {
        out.is_complete = false;
    }
}

/// Lists the roots of a piece, or halves it: returns true if it has become its right half, with the other one in `left`.
#[inline(always)]
fn look_at(piece: &mut Piece, left: &mut Piece, curve: &impl Curve, range: Range, out: &mut Roots) -> bool {
    let Piece { b, low, width, depth } = piece;
    let (low, width, middle, floor) = (*low, *width, *low + 0.5 * *width, out.rounding);
    let signs = Signs::of(b, floor);
    // A root where two pieces meet has no change of sign in either: the first coefficient tells.
    let is_narrow = width < NARROW * range.half;
    let is_known = !signs.is_quiet && !signs.hides && (!signs.ends_quietly || is_narrow);
    if is_known && signs.changes <= 1 && b[0].abs() <= floor {
        out.push(curve.root(low, Some(width)));
    }
    if is_known && signs.changes == 0 {
        return false;
    }
    let (mut x, mut spread) = (middle, Some(0.5 * width));
    if is_known && signs.changes == 1 {
        (x, spread) = (refined(piece, curve), None);
    } else if !signs.is_quiet && *depth < DEPTH {
        piece.halve(left);
        let is_equal = |half: &Piece| Signs::of(&half.b, floor).are_equal();
        let is_pair = width < range.near && is_equal(left) && is_equal(piece);
        if !is_pair {
            return true;
        }
    }
    out.push(curve.root(x, spread));
    false
}

impl Piece {
    /// Leaves the right half here (de Casteljau).
    #[inline(always)]
    fn halve(&mut self, left: &mut Self) {
        self.width *= 0.5;
        self.depth += 1;
        (left.low, left.width, left.depth) = (self.low, self.width, self.depth);
        self.low += self.width;
        for (level, first) in left.b.iter_mut().enumerate() {
            *first = self.b[0];
            for i in 0..SAMPLES - 1 - level {
                self.b[i] = 0.5 * (self.b[i] + self.b[i + 1]);
            }
        }
    }
}

/// Signs of the coefficients of a piece.
struct Signs {
    /// Changes between coefficients that have a sign.
    changes: u32,
    /// Between two of them stand coefficients without a sign, whose true signs could add two changes: a multiple root.
    hides: bool,
    /// Two coefficients or more without a sign stand at an end: a multiple root near it.
    ends_quietly: bool,
    /// No coefficient has a sign.
    is_quiet: bool,
}

impl Signs {
    /// Coefficients up to `floor` have no sign. One that is not a number has none either.
    #[inline(always)]
    fn of(b: &[f64; SAMPLES], floor: f64) -> Self {
        let (mut changes, mut hides, mut ends_quietly, mut last, mut quiet) = (0, false, false, 0, 0);
        for x in b {
            let sign = i32::from(*x > floor) - i32::from(*x < -floor);
            if sign == 0 {
                quiet += 1;
                continue;
            }
            let is_change = sign * last < 0;
            changes += u32::from(is_change);
            hides |= last != 0 && quiet > u32::from(is_change);
            ends_quietly |= last == 0 && quiet > 1;
            (last, quiet) = (sign, 0);
        }
        Self { changes, hides, ends_quietly: ends_quietly || quiet > 1, is_quiet: last == 0 }
    }

    fn are_equal(&self) -> bool {
        self.changes == 0 && !self.hides && !self.ends_quietly && !self.is_quiet
    }
}

impl Arc {
    fn of(polynomial: &TrigPolynomial, quarters: usize, rounding: f64) -> Self {
        let (mut cosines, mut sines) = (polynomial.cosines, polynomial.sines);
        for (k, (a, b)) in cosines.iter_mut().zip(&mut sines).enumerate() {
            (*a, *b) = turned_by_quarters((*a, *b), quarters * k);
        }
        Self { quarters, cosines, sines, offset_sin_cos: polynomial.offset_sin_cos, rounding }
    }

    /// Bernstein coefficients on the whole arc.
    fn bernstein(&self) -> [f64; SAMPLES] {
        let (mut even, mut odd) = ([0.0; DEGREE + 1], [0.0; DEGREE]);
        for (a, row) in self.cosines.iter().zip(&EVEN) {
            even.iter_mut().zip(row).for_each(|(sum, entry)| *sum += a * entry);
        }
        for (b, row) in self.sines.iter().skip(1).zip(&ODD) {
            odd.iter_mut().zip(row).for_each(|(sum, entry)| *sum += b * entry);
        }
        let mut out = [0.0; SAMPLES];
        for (place, (x, y)) in even.iter().zip(&odd).enumerate() {
            out[place] = x + y;
            out[SAMPLES - 1 - place] = x - y;
        }
        out[DEGREE] = even[DEGREE];
        out
    }
}

impl Curve for Arc {
    #[inline(always)]
    fn at(&self, x: f64) -> (f64, f64) {
        let k = 1.0 / (1.0 + x * x);
        let (value, slope) = value_and_slope(&self.cosines, &self.sines, (2.0 * x * k, (1.0 - x * x) * k));
        (value, 2.0 * k * slope)
    }

    fn root(&self, x: f64, spread: Option<f64>) -> Root {
        let (sin, cos) = direction(x);
        let (_, slope) = value_and_slope(&self.cosines, &self.sines, (sin, cos));
        let once = turned_by_quarters((sin, cos), self.quarters);
        Root::new(turned(once, self.offset_sin_cos), slope, spread, self.rounding)
    }
}

/// A vector turned back by quarter turns: (x, y), (y, -x), (-x, -y), (-y, x). Out of line where size counts, see
/// `math::ONE_COPY`.
#[cfg_attr(any(target_os = "none", target_family = "wasm"), inline(never))]
#[cfg_attr(not(any(target_os = "none", target_family = "wasm")), inline)]
fn turned_by_quarters((x, y): (f64, f64), quarters: usize) -> (f64, f64) {
    let (first, second) = if quarters & 1 == 0 { (x, y) } else { (y, -x) };
    if quarters & 2 == 0 { (first, second) } else { (-first, -second) }
}

impl Root {
    /// A root of a function whose values are `rounding` off.
    pub(super) fn new((sin, cos): (f64, f64), slope: f64, spread: Option<f64>, rounding: f64) -> Self {
        let is_certain = rounding <= UNCERTAIN * slope.abs();
        let is_double = spread.is_some();
        let is_doubtful = is_double || !is_certain;
        let spread = spread.unwrap_or(0.0);
        Self { angle: crate::math::atan2(sin, cos), sin_cos: (sin, cos), slope, is_double, spread, is_doubtful }
    }
}

/// Sine and cosine of the angle with the half-angle tangent x.
#[inline(always)]
pub(super) fn direction(x: f64) -> (f64, f64) {
    let k = 1.0 / (1.0 + x * x);
    (2.0 * x * k, (1.0 - x * x) * k)
}

/// Sine and cosine of the sum of two angles.
#[inline(always)]
pub(super) fn turned((sin, cos): (f64, f64), (s, c): (f64, f64)) -> (f64, f64) {
    (sin * c + cos * s, cos * c - sin * s)
}

/// The only root of a piece with one change of sign, in x: Newton's method, kept inside a bracket.
fn refined(piece: &Piece, curve: &impl Curve) -> f64 {
    let Piece { b, low, width, .. } = piece;
    let (mut low, mut high) = (*low, low + width);
    let is_rising = b[0] < 0.0 || (b[0] == 0.0 && b[SAMPLES - 1] > 0.0);
    // The polygon of the coefficients crosses zero near the root.
    let mut share = 0.5;
    for (place, pair) in b.windows(2).enumerate() {
        if let [x, y] = pair
            && x * y < 0.0
        {
            share = (place as f64 + x / (x - y)) / (SAMPLES - 1) as f64;
            break;
        }
    }
    let mut x = low + (high - low) * share;
    for _ in 0..STEPS {
        let (value, slope) = curve.at(x);
        if (value > 0.0) == is_rising {
            high = x;
        } else {
            low = x;
        }
        let next = x - value / slope;
        if next >= low && next <= high {
            let step = (next - x).abs();
            x = next;
            if step < 1e-8 {
                break;
            }
        } else {
            x = 0.5 * (low + high);
        }
    }
    x
}
