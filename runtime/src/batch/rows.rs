//! Rows of numbers, one of each lane, as vectors, and back: in groups of four columns, which are turned by shuffles.

use denhart_core::lanes::{Lanes, MOST_LANES};

use crate::{Jacobian, Pose};

/// Rows, as many as lanes. The last group of four columns overlaps the one before it where four does not divide their number.
#[inline(always)]
pub fn columns<L: Lanes, const K: usize>(set: L::Set, rows: &[[f64; K]]) -> [L; K] {
    let mut columns = [L::all(set, 0.0); K];
    for group in 0..K.div_ceil(4) {
        let at = begins(group, K);
        let mut quads = [[0.0; 4]; MOST_LANES];
        for (quad, row) in quads.iter_mut().zip(rows) {
            *quad = four(row, at);
        }
        for (column, turned) in columns.iter_mut().skip(at).zip(L::columns(set, &quads)) {
            *column = turned;
        }
    }
    columns
}

/// The first column of a group.
#[inline(always)]
const fn begins(group: usize, width: usize) -> usize {
    let at = 4 * group;
    if at + 4 > width { width.saturating_sub(4) } else { at }
}

/// Four numbers of a row; zeros beyond its end.
#[inline(always)]
fn four(row: &[f64], at: usize) -> [f64; 4] {
    match row.get(at..).and_then(<[f64]>::first_chunk::<4>) {
        Some(four) => *four,
        None => {
            let mut four = [0.0; 4];
            for (place, number) in four.iter_mut().zip(row) {
                *place = *number;
            }
            four
        }
    }
}

/// Poses, as many as lanes.
#[inline(always)]
pub fn poses<L: Lanes>(set: L::Set, poses: &[Pose<f64>]) -> Pose<L> {
    let [mut first, mut second, mut third] = [[[0.0; 4]; MOST_LANES]; 3];
    for (((first, second), third), pose) in first.iter_mut().zip(&mut second).zip(&mut third).zip(poses) {
        let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = (pose.rotation, pose.translation);
        (*first, *second, *third) = ([a, b, c, d], [e, f, g, h], [i, x, y, z]);
    }
    let ([a, b, c, d], [e, f, g, h]) = (L::columns(set, &first), L::columns(set, &second));
    let [i, x, y, z] = L::columns(set, &third);
    Pose { rotation: [[a, b, c], [d, e, f], [g, h, i]], translation: [x, y, z] }
}

/// Writes four numbers of a row, or as many as it has.
#[inline(always)]
pub fn put(row: &mut [f64], at: usize, four: &[f64; 4]) {
    match row.get_mut(at..).and_then(<[f64]>::first_chunk_mut::<4>) {
        Some(place) => *place = *four,
        None => {
            for (place, number) in row.iter_mut().zip(four) {
                *place = *number;
            }
        }
    }
}

/// Hands out the rows of the lanes, four numbers at a time: `(lane, first column, numbers)`, for [`put`].
#[inline(always)]
pub fn in_fours<L: Lanes>(columns: &[L], mut each: impl FnMut(usize, usize, &[f64; 4])) {
    let Some(last) = columns.last() else { return };
    for group in 0..columns.len().div_ceil(4) {
        let at = begins(group, columns.len());
        let mut four = [*last; 4];
        for (place, column) in four.iter_mut().zip(columns.iter().skip(at)) {
            *place = *column;
        }
        for (lane, numbers) in L::rows(four).iter().enumerate().take(L::WIDTH) {
            each(lane, at, numbers);
        }
    }
}

/// Writes the poses of the lanes.
#[inline(always)]
pub fn write_poses<'a, L: Lanes>(pose: &Pose<L>, out: impl Iterator<Item = &'a mut Pose<f64>>) {
    let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = (pose.rotation, pose.translation);
    let (first, second, third) = (L::rows([a, b, c, d]), L::rows([e, f, g, h]), L::rows([i, x, y, z]));
    for (((first, second), third), pose) in first.iter().zip(&second).zip(&third).zip(out) {
        let rotation = pose.rotation.as_flattened_mut();
        put(rotation, 0, first);
        put(rotation, 4, second);
        let [[.., corner], point] = [&mut pose.rotation[2], &mut pose.translation];
        [*corner, point[0], point[1], point[2]] = *third;
    }
}

/// Writes the Jacobians of the lanes.
#[inline(always)]
pub fn write_jacobians<L: Lanes, const N: usize>(jacobian: &Jacobian<L, N>, out: &mut [(Pose<f64>, Jacobian<f64, N>)]) {
    in_fours(jacobian.rows.as_flattened(), |lane, at, four| {
        if let Some((_, jacobian)) = out.get_mut(lane) {
            put(jacobian.rows.as_flattened_mut(), at, four);
        }
    });
}
