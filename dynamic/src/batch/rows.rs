//! Registers of a block of poses, and a tape run on them.

use denhart::batch::{BLOCK, Lanes, MOST_LANES, Row};

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
        for Operation { code, to, a, b } in operations {
            let Some((before, after)) = self.0.split_at_mut_checked(*to as usize) else { continue };
            let Some(((a, b), to)) = before.get(*a as usize).zip(before.get(*b as usize)).zip(after.first_mut()) else {
                continue;
            };
            match code {
                Code::Add => of_two::<L>(set, a, b, to, |a, b| a + b),
                Code::Subtract => of_two::<L>(set, a, b, to, |a, b| a - b),
                Code::Multiply => of_two::<L>(set, a, b, to, |a, b| a * b),
                Code::Negate => of_two::<L>(set, a, a, to, |a, _| -a),
                Code::SquareRoot => of_two::<L>(set, a, a, to, |a, _| a.sqrt()),
                Code::Absolute => of_two::<L>(set, a, a, to, |a, _| a.abs()),
            }
        }
    }
}

#[inline(always)]
fn of_two<L: Lanes>(set: L::Set, a: &Row, b: &Row, to: &mut Row, f: impl Fn(L, L) -> L) {
    for at in 0..BLOCK / L::WIDTH {
        f(L::load(set, a, at), L::load(set, b, at)).store(to, at);
    }
}

/// The first of four columns of rows of so many numbers. The last four overlap those before where four does not divide the
/// width.
#[inline(always)]
fn begins(group: usize, width: usize) -> usize {
    (4 * group).min(width.saturating_sub(4))
}

/// Writes registers of a block to rows of so many numbers; four at a time, which are turned by shuffles.
#[inline(always)]
pub fn written<L: Lanes>(set: L::Set, rows: &Rows, registers: &[Register], to: &mut [f64], width: usize) {
    for group in 0..registers.len().div_ceil(4) {
        let column = begins(group, registers.len());
        let mut four = [Register::MAX; 4];
        for (place, register) in four.iter_mut().zip(registers.iter().skip(column)) {
            *place = *register;
        }
        for (at, to) in to.chunks_mut(width.max(1) * L::WIDTH).take(BLOCK / L::WIDTH).enumerate() {
            let turned = L::rows(rows.all(set, &four, at));
            for (numbers, row) in turned.iter().zip(to.chunks_exact_mut(width.max(1))) {
                match row.get_mut(column..).and_then(<[f64]>::first_chunk_mut::<4>) {
                    Some(place) => *place = *numbers,
                    None => {
                        for (place, number) in row.iter_mut().zip(numbers) {
                            *place = *number;
                        }
                    }
                }
            }
        }
    }
}

/// Reads rows of so many numbers, each column to its register; four at a time, which are turned by shuffles.
#[inline(always)]
pub fn read<L: Lanes>(set: L::Set, rows: &mut Rows, registers: &[Register], from: &[f64], width: usize) {
    for group in 0..registers.len().div_ceil(4) {
        let column = begins(group, registers.len());
        for (at, from) in from.chunks(width.max(1) * L::WIDTH).take(BLOCK / L::WIDTH).enumerate() {
            let mut four = [[f64::NAN; 4]; MOST_LANES];
            for (place, row) in four.iter_mut().zip(from.chunks_exact(width.max(1))) {
                match row.get(column..).and_then(<[f64]>::first_chunk::<4>) {
                    Some(numbers) => *place = *numbers,
                    None => {
                        for (place, number) in place.iter_mut().zip(row) {
                            *place = *number;
                        }
                    }
                }
            }
            for (register, value) in registers.iter().skip(column).zip(L::columns(set, &four)) {
                rows.store(*register, at, value);
            }
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
