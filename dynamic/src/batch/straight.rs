//! Pose and Jacobian of many joint vectors.

use denhart::batch::{BLOCK, Lanes, Work, math};

use super::rows::{Rows, first, lanes_of, read, written};
use crate::function::Straight;

/// Evaluates a function for rows of joint values, and writes a row of results for each.
pub struct Evaluation<'a> {
    pub function: &'a Straight,
    pub q: &'a [f64],
    /// The results, in slices whose rows have so many of them.
    pub results: [(&'a mut [f64], usize); 2],
}

impl Work for Evaluation<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) {
        let Evaluation { function, q, results: [(poses, pose), (others, other)] } = self;
        let joints = function.joints.len().max(1);
        let (operations, start) = function.tape.parts();
        let mut rows = Rows::new(start);
        let (of_pose, of_others) = function.results.split_at_checked(pose).unwrap_or((&function.results, &[]));
        // A chunk of a slice that is not asked for is empty.
        let mut others = others.chunks_mut((other * BLOCK).max(1));
        for (q, poses) in q.chunks(joints * BLOCK).zip(poses.chunks_mut(pose * BLOCK)) {
            read(&mut rows, &function.joints, q, joints);
            let mut doubt = 0;
            for (sum, pair) in function.sums.iter().zip(&function.pairs) {
                for at in 0..BLOCK / L::WIDTH {
                    let mut angle = None;
                    for (joint, negative) in &sum.terms {
                        let value: L = rows.load(set, function.joints.get(*joint).copied().unwrap_or(usize::MAX), at);
                        angle = Some(signed(angle, value, *negative));
                    }
                    let angle = match (angle, sum.constant) {
                        (None, constant) => L::all(set, constant.unwrap_or(0.0)),
                        (Some(angle), None) => angle,
                        (Some(angle), Some(constant)) => angle + angle.of(constant),
                    };
                    let ((sin, cos), far) = math::sin_cos(angle);
                    rows.store(pair.sin, at, sin);
                    rows.store(pair.cos, at, cos);
                    doubt |= L::bits(far) << (at * L::WIDTH);
                }
            }
            rows.run::<L>(set, operations);
            written(&rows, of_pose, poses, pose);
            let others = others.next().unwrap_or(&mut []);
            written(&rows, of_others, others, other);
            for lane in lanes_of(doubt & first(q.len() / joints)) {
                again(function, joints, lane, q, (&mut *poses, pose), (&mut *others, other));
            }
        }
    }
}

/// The next term of a signed sum.
#[inline(always)]
pub fn signed<L: Lanes>(sum: Option<L>, value: L, negative: bool) -> L {
    match (sum, negative) {
        (None, false) => value,
        (None, true) => -value,
        (Some(sum), false) => sum + value,
        (Some(sum), true) => sum - value,
    }
}

/// One pose of the block by single calls.
#[cold]
#[inline(never)]
fn again(
    function: &Straight,
    joints: usize,
    lane: usize,
    q: &[f64],
    (poses, pose): (&mut [f64], usize),
    (others, other): (&mut [f64], usize),
) {
    let q = q.chunks_exact(joints).nth(lane).unwrap_or(&[]);
    let places = poses.iter_mut().skip(lane * pose).take(pose);
    function.run(q, places.chain(others.iter_mut().skip(lane * other).take(other)));
}
