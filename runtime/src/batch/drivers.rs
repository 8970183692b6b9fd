//! Slices of poses, through the lanes of generated code.

use core::fmt;

use denhart_core::lanes::{InstructionSet, Lanes, Work};

use super::{BatchArm, BatchInverse, Found, Summary};
use crate::limits::within;
use crate::{Flags, Jacobian, Pose, Status};

/// More lanes than any register has.
const MOST: usize = 8;

/// Groups of lanes left out at most before lanes are tried again.
const MOST_LEFT_OUT: usize = 2048;

/// Two slices of unlike lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lengths {
    /// Length of the slice that is read.
    pub read: usize,
    /// Length of the slice that is to be written.
    pub written: usize,
}

impl fmt::Display for Lengths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} are given, and places for {}", self.read, self.written)
    }
}

impl core::error::Error for Lengths {}

impl Lengths {
    fn check(read: usize, written: usize) -> Result<(), Self> {
        if read == written { Ok(()) } else { Err(Self { read, written }) }
    }
}

/// [`Arm::forward`](crate::Arm::forward) of many joint vectors, with the bits of single calls.
///
/// # Errors
/// Slices of unlike lengths; nothing is written then. So for all functions here.
pub fn forward<A: BatchArm<N>, const N: usize>(arm: &A, q: &[[f64; N]], out: &mut [Pose<f64>]) -> Result<(), Lengths> {
    forward_with(InstructionSet::best(), arm, q, out)
}

/// [`forward`] with one of the processor's instruction sets.
///
/// # Errors
/// As of [`forward`].
pub fn forward_with<A: BatchArm<N>, const N: usize>(
    set: InstructionSet,
    arm: &A,
    q: &[[f64; N]],
    out: &mut [Pose<f64>],
) -> Result<(), Lengths> {
    Lengths::check(q.len(), out.len())?;
    set.run(Forward { arm, q, out });
    Ok(())
}

/// [`Arm::forward_and_jacobian`](crate::Arm::forward_and_jacobian) of many joint vectors, with the bits of single calls.
///
/// # Errors
/// As of [`forward`].
pub fn forward_and_jacobian<A: BatchArm<N>, const N: usize>(
    arm: &A,
    q: &[[f64; N]],
    out: &mut [(Pose<f64>, Jacobian<f64, N>)],
) -> Result<(), Lengths> {
    Lengths::check(q.len(), out.len())?;
    InstructionSet::best().run(Both { arm, q, out });
    Ok(())
}

/// [`InverseKinematics::inverse`](crate::InverseKinematics::inverse) of many targets, with the bits of single calls.
///
/// The first `count` joint vectors of a target are its solutions, in the order of `inverse`; the others have no meaning.
///
/// # Errors
/// As of [`forward`].
pub fn inverse<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    arm: &A,
    targets: &[Pose<f64>],
    q: &mut [[[f64; N]; S]],
    found: &mut [Found],
) -> Result<Summary, Lengths> {
    inverse_with(InstructionSet::best(), arm, targets, q, found)
}

/// [`inverse()`] with one of the processor's instruction sets.
///
/// # Errors
/// As of [`forward`].
pub fn inverse_with<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    set: InstructionSet,
    arm: &A,
    targets: &[Pose<f64>],
    q: &mut [[[f64; N]; S]],
    found: &mut [Found],
) -> Result<Summary, Lengths> {
    Lengths::check(targets.len(), q.len())?;
    Lengths::check(targets.len(), found.len())?;
    Ok(set.run(Inverse { arm, targets, q, found }))
}

/// Numbers of the lanes, in memory.
type Column = [f64; MOST];

/// The number of a lane.
#[inline(always)]
fn of_lane(column: &Column, lane: usize) -> f64 {
    column.get(lane % MOST).copied().unwrap_or(f64::NAN)
}

/// Columns of the rows of some lanes, as vectors.
#[inline(always)]
fn columns<L: Lanes, const K: usize>(set: L::Set, rows: &[&[f64; K]; MOST]) -> [L; K] {
    let mut columns = [[0.0; MOST]; K];
    for (lane, row) in rows.iter().enumerate().take(L::WIDTH) {
        for (column, number) in columns.iter_mut().zip(*row) {
            if let Some(place) = column.get_mut(lane % MOST) {
                *place = *number;
            }
        }
    }
    let mut vectors = [L::all(set, 0.0); K];
    for (vector, column) in vectors.iter_mut().zip(&columns) {
        *vector = L::read(set, column);
    }
    vectors
}

/// Some rows, the last one again where there are fewer than lanes.
#[inline(always)]
fn filled<T>(rows: &[T]) -> Option<[&T; MOST]> {
    let last = rows.last()?;
    let mut filled = [last; MOST];
    for (place, row) in filled.iter_mut().zip(rows) {
        *place = row;
    }
    Some(filled)
}

struct Forward<'a, A, const N: usize> {
    arm: &'a A,
    q: &'a [[f64; N]],
    out: &'a mut [Pose<f64>],
}

impl<A: BatchArm<N>, const N: usize> Work for Forward<'_, A, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) {
        for (q, out) in self.q.chunks(L::WIDTH).zip(self.out.chunks_mut(L::WIDTH)) {
            let Some(rows) = filled(q) else { continue };
            let (pose, far) = self.arm.forward_lanes::<L>(set, columns(set, &rows));
            let pose = Written::of(&pose);
            let far = L::bits(far);
            for (lane, (q, out)) in q.iter().zip(out).enumerate() {
                *out = if far >> lane & 1 == 0 { pose.lane(lane) } else { again(self.arm, q) };
            }
        }
    }
}

struct Both<'a, A, const N: usize> {
    arm: &'a A,
    q: &'a [[f64; N]],
    out: &'a mut [(Pose<f64>, Jacobian<f64, N>)],
}

impl<A: BatchArm<N>, const N: usize> Work for Both<'_, A, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) {
        for (q, out) in self.q.chunks(L::WIDTH).zip(self.out.chunks_mut(L::WIDTH)) {
            let Some(rows) = filled(q) else { continue };
            let (pose, jacobian, far) = self.arm.forward_and_jacobian_lanes::<L>(set, columns(set, &rows));
            let pose = Written::of(&pose);
            let mut entries = [[[0.0; MOST]; N]; 6];
            for (to, from) in entries.iter_mut().flatten().zip(jacobian.rows.iter().flatten()) {
                from.write(to);
            }
            let far = L::bits(far);
            for (lane, (q, (to, jacobian))) in q.iter().zip(out).enumerate() {
                if far >> lane & 1 != 0 {
                    (*to, *jacobian) = both_again(self.arm, q);
                    continue;
                }
                *to = pose.lane(lane);
                for (to, column) in jacobian.rows.iter_mut().flatten().zip(entries.iter().flatten()) {
                    *to = of_lane(column, lane);
                }
            }
        }
    }
}

#[cold]
#[inline(never)]
fn again<A: BatchArm<N>, const N: usize>(arm: &A, q: &[f64; N]) -> Pose<f64> {
    arm.forward(q)
}

#[cold]
#[inline(never)]
fn both_again<A: BatchArm<N>, const N: usize>(arm: &A, q: &[f64; N]) -> (Pose<f64>, Jacobian<f64, N>) {
    arm.forward_and_jacobian(q)
}

/// Poses of the lanes, in memory.
struct Written {
    rotation: [[Column; 3]; 3],
    translation: [Column; 3],
}

impl Written {
    #[inline(always)]
    fn of<L: Lanes>(pose: &Pose<L>) -> Self {
        let mut written = Self { rotation: [[[0.0; MOST]; 3]; 3], translation: [[0.0; MOST]; 3] };
        let places = written.rotation.iter_mut().flatten().chain(&mut written.translation);
        for (place, number) in places.zip(pose.rotation.iter().flatten().chain(&pose.translation)) {
            number.write(place);
        }
        written
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> Pose<f64> {
        let Self { rotation: [x, y, z], translation: [p, q, r] } = self;
        let row = |[a, b, c]: &[Column; 3]| [of_lane(a, lane), of_lane(b, lane), of_lane(c, lane)];
        Pose { rotation: [row(x), row(y), row(z)], translation: [of_lane(p, lane), of_lane(q, lane), of_lane(r, lane)] }
    }
}

struct Inverse<'a, A, const N: usize, const S: usize> {
    arm: &'a A,
    targets: &'a [Pose<f64>],
    q: &'a mut [[[f64; N]; S]],
    found: &'a mut [Found],
}

impl<A: BatchInverse<N, S>, const N: usize, const S: usize> Work for Inverse<'_, A, N, S> {
    type Output = Summary;

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) -> Summary {
        let mut summary = Summary::default();
        let (mut left_out, mut next) = (0, 1);
        let outputs = self.q.chunks_mut(L::WIDTH).zip(self.found.chunks_mut(L::WIDTH));
        for (targets, (q, found)) in self.targets.chunks(L::WIDTH).zip(outputs) {
            let Some(rows) = filled(targets) else { continue };
            let all = (1 << targets.len()) - 1;
            let mut doubt = all;
            if left_out > 0 {
                left_out -= 1;
            } else {
                let branches = self.arm.inverse_lanes(set, &pose::<L>(set, &rows));
                doubt = branches.doubt() & all;
                for place in found.iter_mut() {
                    *place = Found::NOTHING;
                }
                for (values, exists) in branches.places() {
                    let mut columns = [[0.0; MOST]; N];
                    for (column, value) in columns.iter_mut().zip(values) {
                        value.write(column);
                    }
                    for (lane, (q, found)) in q.iter_mut().zip(found.iter_mut()).enumerate() {
                        if exists >> lane & 1 == 0 {
                            continue;
                        }
                        let number = usize::from(found.count);
                        let (Some(place), Some(flags)) = (q.get_mut(number), found.flags.get_mut(number)) else {
                            continue;
                        };
                        for (place, column) in place.iter_mut().zip(&columns) {
                            *place = of_lane(column, lane);
                        }
                        *flags = if inside::<A, N, S>(place) {
                            Flags::EXACT
                        } else {
                            Flags::EXACT.union(Flags::OUT_OF_LIMITS)
                        };
                        found.count += 1;
                    }
                }
                let mut least = [0.0; MOST];
                branches.least().write(&mut least);
                for (lane, found) in found.iter_mut().enumerate() {
                    found.status = status(found.count != 0, of_lane(&least, lane), A::ARM_CONSTANTS.reach);
                    if doubt >> lane & 1 == 0 {
                        summary.reached += usize::from(found.count != 0);
                    }
                }
                if doubt == all {
                    left_out = next;
                    next = (next * 2).min(MOST_LEFT_OUT);
                } else {
                    next = 1;
                }
            }
            for (lane, (target, (q, found))) in targets.iter().zip(q.iter_mut().zip(found)).enumerate() {
                if doubt >> lane & 1 != 0 {
                    single(self.arm, target, q, found);
                    summary.add(found);
                }
            }
        }
        summary
    }
}

/// Poses of some lanes.
#[inline(always)]
fn pose<L: Lanes>(set: L::Set, poses: &[&Pose<f64>; MOST]) -> Pose<L> {
    let numbers = |pose: &Pose<f64>| {
        let [[a, b, c], [d, e, f], [g, h, i]] = pose.rotation;
        let [x, y, z] = pose.translation;
        [a, b, c, d, e, f, g, h, i, x, y, z]
    };
    let mut columns = [[0.0; MOST]; 12];
    for (lane, pose) in poses.iter().enumerate().take(L::WIDTH) {
        for (column, number) in columns.iter_mut().zip(numbers(pose)) {
            if let Some(place) = column.get_mut(lane % MOST) {
                *place = number;
            }
        }
    }
    let [a, b, c, d, e, f, g, h, i, x, y, z] = &columns;
    let of = |column: &Column| L::read(set, column);
    Pose {
        rotation: [[of(a), of(b), of(c)], [of(d), of(e), of(f)], [of(g), of(h), of(i)]],
        translation: [of(x), of(y), of(z)],
    }
}

/// Returns true if a joint vector is within the limits, as the search marks it.
#[inline(always)]
fn inside<A: BatchInverse<N, S>, const N: usize, const S: usize>(q: &[f64; N]) -> bool {
    let constants = A::ARM_CONSTANTS;
    if !constants.limited && constants.combined.is_empty() {
        return true;
    }
    let mut inside = true;
    for (q, limits) in q.iter().zip(constants.limits) {
        inside &= within(*q, *limits, q.abs());
    }
    inside && constants.combined.iter().all(|limit| limit.holds(q))
}

/// The status of an ordinary target, as the search sets it.
#[inline(always)]
fn status(reached: bool, least: f64, reach: f64) -> Status<f64> {
    if reached {
        return Status::Reachable;
    }
    Status::Unreachable { residual: if least > 0.0 { least.min(f64::MAX) } else { reach } }
}

/// A target by the scalar inverse.
#[cold]
#[inline(never)]
fn single<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    arm: &A,
    target: &Pose<f64>,
    q: &mut [[f64; N]; S],
    found: &mut Found,
) {
    let solutions = arm.inverse(target);
    *found = Found { status: solutions.status(), deviation: solutions.deviation(), scalar: true, ..Found::NOTHING };
    for ((solution, place), flags) in solutions.iter().zip(q).zip(&mut found.flags) {
        *place = solution.q;
        *flags = solution.flags;
        found.count += 1;
    }
}
