//! Slices of poses, through the lanes of generated code.

use core::fmt;

use denhart_core::lanes::{InstructionSet, Lanes, MOST_LANES, Work};

use super::rows::{columns, in_fours, poses, put, write_jacobians, write_poses};
use super::{BatchArm, BatchInverse, Branches, Found, LeftOut, Summary};
use crate::limits::within_lanes;
use crate::{Flags, Jacobian, Pose, Status};

/// Groups of lanes left out at most before lanes are tried again.
pub(super) const MOST_LEFT_OUT: usize = 2048;

/// Two slices of unlike lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lengths {
    /// Length of the first slice, that of the joint vectors or the targets.
    pub read: usize,
    /// Length of the first other one that differs: of references, or of one that is to be written.
    pub written: usize,
}

impl fmt::Display for Lengths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "slices of {} and of {} rows: a call takes slices of one length", self.read, self.written)
    }
}

impl core::error::Error for Lengths {}

impl Lengths {
    pub(super) fn check(read: usize, written: usize) -> Result<(), Self> {
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
    forward_and_jacobian_with(InstructionSet::best(), arm, q, out)
}

/// [`forward_and_jacobian`] with one of the processor's instruction sets.
///
/// # Errors
/// As of [`forward`].
pub fn forward_and_jacobian_with<A: BatchArm<N>, const N: usize>(
    set: InstructionSet,
    arm: &A,
    q: &[[f64; N]],
    out: &mut [(Pose<f64>, Jacobian<f64, N>)],
) -> Result<(), Lengths> {
    Lengths::check(q.len(), out.len())?;
    set.run(Both { arm, q, out });
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

struct Forward<'a, A, const N: usize> {
    arm: &'a A,
    q: &'a [[f64; N]],
    out: &'a mut [Pose<f64>],
}

impl<A: BatchArm<N>, const N: usize> Work for Forward<'_, A, N> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) {
        let Self { arm, q, out } = self;
        let whole = in_lanes::<L>(q.len());
        let Some((q, rest_of_q)) = q.split_at_checked(whole) else { return };
        let Some((out, rest)) = out.split_at_mut_checked(whole) else { return };
        for (q, out) in q.chunks_exact(L::WIDTH).zip(out.chunks_exact_mut(L::WIDTH)) {
            let (pose, far) = arm.forward_lanes::<L>(set, columns(set, q));
            write_poses(&pose, out.iter_mut());
            if L::bits(far) != 0 {
                again(arm, q, out);
            }
        }
        again(arm, rest_of_q, rest);
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
        let Self { arm, q, out } = self;
        let whole = in_lanes::<L>(q.len());
        let Some((q, rest_of_q)) = q.split_at_checked(whole) else { return };
        let Some((out, rest)) = out.split_at_mut_checked(whole) else { return };
        for (q, out) in q.chunks_exact(L::WIDTH).zip(out.chunks_exact_mut(L::WIDTH)) {
            let (pose, jacobian, far) = arm.forward_and_jacobian_lanes::<L>(set, columns(set, q));
            write_poses(&pose, out.iter_mut().map(|(pose, _)| pose));
            write_jacobians(&jacobian, out);
            if L::bits(far) != 0 {
                both_again(arm, q, out);
            }
        }
        both_again(arm, rest_of_q, rest);
    }
}

/// How many rows of so many run in lanes: whole groups. Loops over arrays that the compiler leaves alone take longer than
/// single calls, and take none.
const fn in_lanes<L: Lanes>(rows: usize) -> usize {
    if L::EXPLICIT { rows - rows % L::WIDTH } else { 0 }
}

/// Poses by single calls: of a group with an angle that is too large for lanes, and what is left over.
#[cold]
#[inline(never)]
fn again<A: BatchArm<N>, const N: usize>(arm: &A, q: &[[f64; N]], out: &mut [Pose<f64>]) {
    for (q, pose) in q.iter().zip(out) {
        *pose = arm.forward(q);
    }
}

/// Poses and Jacobians by single calls.
#[cold]
#[inline(never)]
fn both_again<A: BatchArm<N>, const N: usize>(arm: &A, q: &[[f64; N]], out: &mut [(Pose<f64>, Jacobian<f64, N>)]) {
    for (q, both) in q.iter().zip(out) {
        *both = arm.forward_and_jacobian(q);
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
        let mut branches = Branches::<L, N, S>::new(set);
        let mut last = Last::new();
        let mut left_out = LeftOut::up_to(MOST_LEFT_OUT);
        let outputs = self.q.chunks_mut(L::WIDTH).zip(self.found.chunks_mut(L::WIDTH));
        for (targets, (q, found)) in self.targets.chunks(L::WIDTH).zip(outputs) {
            let all = (1 << targets.len()) - 1;
            let mut doubt = all;
            if left_out.takes_lanes() {
                let slices = (targets.get(..L::WIDTH), q.get_mut(..L::WIDTH), found.get_mut(..L::WIDTH));
                let (group, q_of_lanes, found_of_lanes) = match slices {
                    (Some(targets), Some(q), Some(found)) => (targets, q, found),
                    _ => last.of(targets),
                };
                // As many as lanes, so that the loops over them have no ends to look for.
                let (Some(group), Some(q_of_lanes), Some(found_of_lanes)) =
                    (group.get(..L::WIDTH), q_of_lanes.get_mut(..L::WIDTH), found_of_lanes.get_mut(..L::WIDTH))
                else {
                    continue;
                };
                self.arm.inverse_lanes(set, &poses::<L>(set, group), &mut branches);
                doubt = branches.doubt() & all;
                for place in found_of_lanes.iter_mut() {
                    *place = Found::NOTHING;
                }
                let mut counts = [0; MOST_LANES];
                for (values, exists) in branches.places() {
                    if exists & all == 0 {
                        continue;
                    }
                    // Without branches, which would be foretold badly: a lane without this solution writes it to the
                    // place of its next one.
                    in_fours(values, |lane, at, four| {
                        if let (Some(q), Some(count)) = (q_of_lanes.get_mut(lane), counts.get(lane))
                            && let Some(place) = q.get_mut(*count)
                        {
                            put(place, at, four);
                        }
                    });
                    let inside = inside::<A, L, N, S>(set, values);
                    for (lane, ((q, found), count)) in
                        q_of_lanes.iter().zip(found_of_lanes.iter_mut()).zip(&mut counts).enumerate()
                    {
                        let (Some(place), Some(flags)) = (q.get(*count), found.flags.get_mut(*count)) else { continue };
                        let combined = A::ARM_CONSTANTS.combined.iter().all(|limit| limit.holds(place));
                        let fact = if combined && inside >> lane & 1 != 0 {
                            Flags::EXACT
                        } else {
                            Flags::EXACT.union(Flags::OUT_OF_LIMITS)
                        };
                        let has = (exists >> lane & 1) as usize;
                        *flags = if has != 0 { fact } else { Flags::NONE };
                        *count += has;
                    }
                }
                let mut least = [0.0; MOST_LANES];
                branches.least().write(&mut least);
                for (lane, ((found, least), count)) in found_of_lanes.iter_mut().zip(least).zip(counts).enumerate() {
                    found.count = count as u8;
                    found.status = status(found.count != 0, least, A::ARM_CONSTANTS.reach);
                    if doubt >> lane & 1 == 0 {
                        summary.reached += usize::from(found.count != 0);
                    }
                }
                if targets.len() < L::WIDTH {
                    last.hand_out(q, found);
                }
                left_out.note(doubt == all);
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

/// Targets of lanes, and where their solutions go.
type Block<'a, const N: usize, const S: usize> = (&'a [Pose<f64>], &'a mut [[[f64; N]; S]], &'a mut [Found]);

/// The last targets where they are fewer than lanes, and places for their solutions.
struct Last<const N: usize, const S: usize> {
    targets: [Pose<f64>; MOST_LANES],
    q: [[[f64; N]; S]; MOST_LANES],
    found: [Found; MOST_LANES],
}

impl<const N: usize, const S: usize> Last<N, S> {
    fn new() -> Self {
        // Filled up with targets that are none: their lanes are in doubt, and belong to nobody.
        let none = Pose { rotation: [[0.0; 3]; 3], translation: [0.0; 3] };
        Self { targets: [none; MOST_LANES], q: [[[0.0; N]; S]; MOST_LANES], found: [Found::NOTHING; MOST_LANES] }
    }

    #[cold]
    #[inline(never)]
    fn of(&mut self, targets: &[Pose<f64>]) -> Block<'_, N, S> {
        for (place, target) in self.targets.iter_mut().zip(targets) {
            *place = *target;
        }
        (&self.targets, &mut self.q, &mut self.found)
    }

    /// Copies what was found.
    #[cold]
    #[inline(never)]
    fn hand_out(&self, q: &mut [[[f64; N]; S]], found: &mut [Found]) {
        for ((q, found), (of_q, of_found)) in q.iter_mut().zip(found).zip(self.q.iter().zip(&self.found)) {
            (*q, *found) = (*of_q, *of_found);
        }
    }
}

/// Lanes whose joint values are within their limits, as the search marks them.
#[inline(always)]
fn inside<A: BatchInverse<N, S>, L: Lanes, const N: usize, const S: usize>(set: L::Set, q: &[L; N]) -> u32 {
    let constants = A::ARM_CONSTANTS;
    if !constants.limited && constants.combined.is_empty() {
        return u32::MAX;
    }
    let mut inside = L::mask(set, true);
    for (q, limits) in q.iter().zip(constants.limits) {
        inside = L::both(inside, within_lanes(*q, *limits, q.abs()));
    }
    L::bits(inside)
}

/// The status of an ordinary target, as the search sets it.
#[inline(always)]
pub(super) fn status(reached: bool, least: f64, reach: f64) -> Status<f64> {
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
    *found = Found::of_single_call(solutions.status(), solutions.deviation());
    for ((solution, place), flags) in solutions.iter().zip(q).zip(&mut found.flags) {
        *place = solution.q;
        *flags = solution.flags;
        found.count += 1;
    }
}
