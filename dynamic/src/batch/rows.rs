//! Registers of a block of poses, and a tape run on them.

use denhart::batch::{BLOCK, Lanes, Row};

use crate::tape::{Code, Operation, Register};

/// The registers of a block, each with a number for every pose.
#[derive(Debug, Clone)]
pub struct Rows(Vec<Row>);

impl Rows {
    /// Registers that start with these values.
    pub fn new(start: &[f64]) -> Self {
        Rows(start.iter().map(|value| Row::all(*value)).collect())
    }

    /// The `at`-th vector of a register; zeros where there is none.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, set: L::Set, register: Register, at: usize) -> L {
        self.0.get(register).map_or(L::all(set, 0.0), |row| L::load(set, row, at))
    }

    /// The `at`-th vectors of several registers.
    #[inline(always)]
    pub fn all<L: Lanes, const K: usize>(&self, set: L::Set, registers: &[Register; K], at: usize) -> [L; K] {
        let mut values = [L::all(set, 0.0); K];
        for (value, register) in values.iter_mut().zip(registers) {
            *value = self.load(set, *register, at);
        }
        values
    }

    /// Sets the `at`-th vector of a register.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, register: Register, at: usize, value: L) {
        if let Some(row) = self.0.get_mut(register) {
            value.store(row, at);
        }
    }

    /// A register.
    #[inline(always)]
    pub fn row(&self, register: Register) -> Option<&Row> {
        self.0.get(register)
    }

    /// Copies a register.
    #[inline(always)]
    pub fn copy(&mut self, from: Register, to: Register) {
        if let Some(row) = self.0.get(from).copied()
            && let Some(place) = self.0.get_mut(to)
        {
            *place = row;
        }
    }

    /// Sets a register.
    #[inline(always)]
    pub fn put(&mut self, register: Register, row: &Row) {
        if let Some(place) = self.0.get_mut(register) {
            *place = *row;
        }
    }

    /// Sets a register for one pose.
    #[inline(always)]
    pub fn set(&mut self, register: Register, lane: usize, value: f64) {
        if let Some(place) = self.0.get_mut(register).and_then(|row| row.0.get_mut(lane)) {
            *place = value;
        }
    }

    /// Does some operations, in order.
    #[inline(always)]
    pub fn run<L: Lanes>(&mut self, set: L::Set, operations: &[Operation]) {
        for Operation { code, to, of } in operations {
            let Some((before, after)) = self.0.split_at_mut_checked(*to as usize) else { continue };
            let [Some(a), Some(b), Some(c), Some(d)] = of.map(|at| before.get(at as usize)) else { continue };
            let Some(to) = after.first_mut() else { continue };
            match code {
                Code::Add => each::<L, 2>(set, [a, b], to, |[a, b]| a + b),
                Code::Subtract => each::<L, 2>(set, [a, b], to, |[a, b]| a - b),
                Code::Multiply => each::<L, 2>(set, [a, b], to, |[a, b]| a * b),
                Code::Negate => each::<L, 1>(set, [a], to, |[a]| -a),
                Code::SquareRoot => each::<L, 1>(set, [a], to, |[a]| a.sqrt()),
                Code::Absolute => each::<L, 1>(set, [a], to, |[a]| a.abs()),
                Code::AddProduct => each::<L, 3>(set, [a, b, c], to, |[a, b, c]| a + b * c),
                Code::SubtractProduct => each::<L, 3>(set, [a, b, c], to, |[a, b, c]| a - b * c),
                Code::ProductLess => each::<L, 3>(set, [a, b, c], to, |[a, b, c]| a * b - c),
                Code::AddProducts => each::<L, 4>(set, [a, b, c, d], to, |[a, b, c, d]| a * b + c * d),
                Code::SubtractProducts => each::<L, 4>(set, [a, b, c, d], to, |[a, b, c, d]| a * b - c * d),
            }
        }
    }
}

#[inline(always)]
fn each<L: Lanes, const K: usize>(set: L::Set, of: [&Row; K], to: &mut Row, f: impl Fn([L; K]) -> L) {
    for at in 0..BLOCK / L::WIDTH {
        f(of.map(|row| L::load(set, row, at))).store(to, at);
    }
}

/// Writes registers of a block to rows of so many numbers; four at a time, whose rows stay in the cache.
#[inline(always)]
pub fn written(rows: &Rows, registers: &[Register], to: &mut [f64], width: usize) {
    let (fours, rest) = registers.as_chunks::<4>();
    for (number, four) in fours.iter().enumerate() {
        let [Some(a), Some(b), Some(c), Some(d)] = four.map(|register| rows.row(register)) else { continue };
        for (lane, place) in to.chunks_exact_mut(width.max(1)).take(BLOCK).enumerate() {
            let place = place.get_mut(4 * number..).and_then(<[f64]>::first_chunk_mut::<4>);
            if let Some(place) = place {
                *place = [a, b, c, d].map(|row| of_lane(row, lane));
            }
        }
    }
    for (number, register) in rest.iter().enumerate() {
        let Some(row) = rows.row(*register) else { continue };
        for (value, place) in row.0.iter().zip(to.chunks_exact_mut(width.max(1))) {
            if let Some(place) = place.get_mut(4 * fours.len() + number) {
                *place = *value;
            }
        }
    }
}

/// Reads rows of so many numbers, each column to its register.
#[inline(always)]
pub fn read(rows: &mut Rows, registers: &[Register], from: &[f64], width: usize) {
    for (number, register) in registers.iter().enumerate() {
        let Some(row) = rows.0.get_mut(*register) else { continue };
        for (place, numbers) in row.0.iter_mut().zip(from.chunks_exact(width.max(1))) {
            *place = numbers.get(number).copied().unwrap_or(f64::NAN);
        }
    }
}

/// The number of a lane.
#[inline(always)]
pub fn of_lane(row: &Row, lane: usize) -> f64 {
    // Without the remainder each access would be compared with the end.
    row.0.get(lane % BLOCK).copied().unwrap_or(f64::NAN)
}

/// The lanes of a mask, the first one first.
#[inline(always)]
pub fn lanes_of(mut mask: u32) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        if mask == 0 {
            return None;
        }
        let lane = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        Some(lane)
    })
}

/// A mask of the first lanes, as many as there are.
#[inline]
pub fn first(lanes: usize) -> u32 {
    if lanes >= BLOCK { u32::MAX } else { (1 << lanes) - 1 }
}
