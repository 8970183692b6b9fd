//! Of each target the solution next to its reference, through the lanes of generated code.

use denhart_core::lanes::{InstructionSet, Lanes, MOST_LANES, Work};

use super::drivers::{Lengths, MOST_LEFT_OUT, status};
use super::rows::{columns, poses};
use super::{BatchInverse, Branches, Found, LeftOut, Summary};
use crate::limits::within_lanes;
use crate::solve::Tolerances;
use crate::windings::step_lanes;
use crate::{Flags, Pose};

/// The first solution within the limits of [`InverseKinematics::inverse_near`](crate::InverseKinematics::inverse_near), for
/// many targets, with the bits of single calls.
///
/// `q_ref`: a reference for each target, rad or length unit. `q`: the solution nearest to it on the turn next to it, where
/// the count of its `found` is 1; where it is 0 the row has no meaning. A target that no solution within the limits reaches
/// has the status of `inverse_near`: it may be reachable.
///
/// # Errors
/// Slices of unlike lengths; nothing is written then.
pub fn inverse_near<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    arm: &A,
    targets: &[Pose<f64>],
    q_ref: &[[f64; N]],
    q: &mut [[f64; N]],
    found: &mut [Found],
) -> Result<Summary, Lengths> {
    inverse_near_with(InstructionSet::best(), arm, targets, q_ref, q, found)
}

/// [`inverse_near()`] with one of the processor's instruction sets.
///
/// # Errors
/// As of [`inverse_near()`].
pub fn inverse_near_with<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    set: InstructionSet,
    arm: &A,
    targets: &[Pose<f64>],
    q_ref: &[[f64; N]],
    q: &mut [[f64; N]],
    found: &mut [Found],
) -> Result<Summary, Lengths> {
    for written in [q_ref.len(), q.len(), found.len()] {
        Lengths::check(targets.len(), written)?;
    }
    Ok(set.run(Near { arm, targets, q_ref, q, found }))
}

struct Near<'a, A, const N: usize, const S: usize> {
    arm: &'a A,
    targets: &'a [Pose<f64>],
    q_ref: &'a [[f64; N]],
    q: &'a mut [[f64; N]],
    found: &'a mut [Found],
}

impl<A: BatchInverse<N, S>, const N: usize, const S: usize> Work for Near<'_, A, N, S> {
    type Output = Summary;

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) -> Summary {
        let Near { arm, targets, q_ref, q, found } = self;
        let mut summary = Summary::default();
        let mut branches = Branches::<L, N, S>::new(set);
        let mut left_out = LeftOut::up_to(MOST_LEFT_OUT);
        let outputs = q.chunks_mut(L::WIDTH).zip(found.chunks_mut(L::WIDTH));
        let inputs = targets.chunks(L::WIDTH).zip(q_ref.chunks(L::WIDTH));
        for ((targets, q_ref), (q, found)) in inputs.zip(outputs) {
            let all = (1 << targets.len()) - 1;
            let mut doubt = all;
            // What is left over at the end takes single calls.
            if left_out.takes_lanes() && targets.len() == L::WIDTH {
                arm.inverse_lanes(set, &poses::<L>(set, targets), &mut branches);
                let nearest = Nearest::of::<A, L, S>(set, &branches, columns(set, q_ref));
                doubt = (branches.doubt() | nearest.doubt) & all;
                let mut least = [0.0; MOST_LANES];
                branches.least().write(&mut least);
                for (lane, (((q, found), best), least)) in
                    q.iter_mut().zip(&mut *found).zip(&nearest.best).zip(least).enumerate()
                {
                    let has = |mask: u32| mask >> lane & 1 != 0;
                    *found =
                        Found { status: status(has(nearest.exists), least, A::ARM_CONSTANTS.reach), ..Found::NOTHING };
                    if has(nearest.listed) {
                        *q = *best;
                        found.count = 1;
                        if let Some(flags) = found.flags.first_mut() {
                            *flags = Flags::EXACT;
                        }
                    }
                    if !has(doubt) {
                        summary.add(found);
                    }
                }
                left_out.note(doubt == all);
            }
            for (lane, (((target, q_ref), q), found)) in targets.iter().zip(q_ref).zip(q).zip(found).enumerate() {
                if doubt >> lane & 1 != 0 {
                    single(arm, target, q_ref, q, found);
                    summary.add(found);
                }
            }
        }
        summary
    }
}

/// The nearest solutions of a group.
struct Nearest<const N: usize> {
    /// The joint values of each lane.
    best: [[f64; N]; MOST_LANES],
    /// Lanes that have a solution, that have one within the limits, and that are in doubt.
    exists: u32,
    listed: u32,
    doubt: u32,
}

impl<const N: usize> Nearest<N> {
    #[inline(always)]
    fn of<A: BatchInverse<N, S>, L: Lanes, const S: usize>(
        set: L::Set,
        branches: &Branches<L, N, S>,
        q_ref: [L; N],
    ) -> Self {
        let constants = A::ARM_CONSTANTS;
        // What is not a number is no reference.
        let mut can_refer = L::mask(set, true);
        for (joint, q_ref) in q_ref.iter().enumerate() {
            let most = if constants.prismatic.contains(joint) { f64::MAX } else { f64::MOST_WOUND };
            can_refer = L::both(can_refer, q_ref.abs().at_most(q_ref.of(most)));
        }
        let mut this =
            Self { best: [[f64::NAN; N]; MOST_LANES], exists: 0, listed: 0, doubt: L::bits(L::not(can_refer)) };
        let mut least = [f64::INFINITY; MOST_LANES];
        for (values, exists) in branches.places() {
            this.exists |= exists;
            let mut turned = [[0.0; MOST_LANES]; N];
            let mut sum = L::all(set, 0.0);
            let (mut inside, mut unsure) = (L::mask(set, true), L::mask(set, false));
            let weights = constants.weights.iter().zip(constants.limits).zip(&mut turned);
            for (joint, ((value, q_ref), ((weight, limits), turned))) in
                values.iter().zip(&q_ref).zip(weights).enumerate()
            {
                let reach = constants.prismatic.contains(joint).then_some(constants.reach);
                let (value, step, wound) = step_lanes(set, *value, *q_ref, *limits, reach);
                unsure = L::either(unsure, wound);
                value.write(turned);
                sum = sum + sum.of(*weight) * step * step;
                // A joint on another turn may be outside limits that its angle in (-pi, pi] is within.
                inside = L::both(inside, within_lanes(value, *limits, value.abs()));
            }
            let unsure = L::bits(unsure) & exists;
            this.doubt |= unsure;
            let candidates = L::bits(inside) & exists & !unsure;
            let mut distance = [0.0; MOST_LANES];
            sum.write(&mut distance);
            for (lane, ((best, least), distance)) in this.best.iter_mut().zip(&mut least).zip(distance).enumerate() {
                // A distance that is no number, of a joint without weight, is no nearer than the one before it.
                let is_nearer = this.listed >> lane & 1 == 0 || distance < *least;
                if candidates >> lane & 1 == 0 || !is_nearer {
                    continue;
                }
                let mut q = [0.0; N];
                for (q, turned) in q.iter_mut().zip(&turned) {
                    *q = turned.get(lane).copied().unwrap_or(f64::NAN);
                }
                if constants.combined.iter().all(|limit| limit.holds(&q)) {
                    (*best, *least) = (q, distance);
                    this.listed |= 1 << lane;
                }
            }
        }
        this
    }
}

/// A target by the scalar inverse.
#[cold]
#[inline(never)]
fn single<A: BatchInverse<N, S>, const N: usize, const S: usize>(
    arm: &A,
    target: &Pose<f64>,
    q_ref: &[f64; N],
    q: &mut [f64; N],
    found: &mut Found,
) {
    let solutions = arm.inverse_near(target, q_ref);
    *found = Found::of_single_call(solutions.status(), solutions.deviation());
    if let Some(solution) = solutions.iter().find(|solution| solution.is_within_limits()) {
        *q = solution.q;
        found.count = 1;
        if let Some(flags) = found.flags.first_mut() {
            *flags = solution.flags;
        }
    }
}
