//! Followers: one call of each for the digests, and the lines of the tool that are measured.

use denhart::follow::{
    Advance, Crossing, FollowError, FollowSettings, Follower, PathFollower, Progress, Rates, Step, Tracking,
};
use denhart::{Pose, Scalar};

use crate::aim::Aim;
use crate::{Bits, Case, Digest, Subject};

/// Period of a tick, s.
pub const PERIOD: f64 = 1e-3;

/// Digests a few ticks of a follower and of a path follower. The arm starts at `q_ref`, or at `q` where that is outside the
/// limits.
pub fn followers<S, T, const N: usize>(arm: &S, case: &Case<T, S::Target, N>, digest: &mut Digest)
where
    S: Subject<T, N>,
    S::Target: Aim<T>,
    T: Scalar + Bits,
{
    let rates = Rates { velocity: [T::ONE; N], acceleration: [T::from_f64(8.0); N] };
    let settings = FollowSettings::new(T::from_f64(PERIOD), rates).crossing(Crossing::Any);
    let mut found = S::Solutions::default();
    let start = Follower::new(arm, settings, &case.q_ref).is_ok();
    let start = if start { &case.q_ref } else { &case.q };
    match Follower::new(arm, settings, start) {
        Ok(mut follower) => {
            for _ in 0..2 {
                digest.add(&follower.step(arm, &case.target, &mut found));
            }
            digest.add(&follower.stop(arm));
        }
        Err(error) => digest.add(&error),
    }
    match PathFollower::new(arm, settings.held(), start) {
        Ok(mut follower) => {
            let path = |t: T| {
                let mut q = *start;
                for (q, qd) in q.iter_mut().zip(&case.qd) {
                    *q += *qd * t;
                }
                arm.target_at(&q)
            };
            digest.add(&follower.step(arm, path, T::ONE, &mut found));
        }
        Err(error) => digest.add(&error),
    }
}

impl<T: Bits, const N: usize> Bits for Step<T, N> {
    fn add_to(&self, digest: &mut Digest) {
        let Self { q, velocity, tracking, deviation, residual, branch, crossed, held, remaining } = self;
        digest.add(q);
        digest.add(velocity);
        digest.add(tracking);
        digest.add(deviation);
        digest.add(residual);
        digest.add(branch);
        digest.add(crossed);
        digest.add(held);
        digest.add(remaining);
    }
}

impl<T: Bits, const N: usize> Bits for Advance<T, N> {
    fn add_to(&self, digest: &mut Digest) {
        let Self { q, velocity, at, rate, state, branch, crossed } = self;
        digest.add(q);
        digest.add(velocity);
        digest.add(at);
        digest.add(rate);
        digest.add(state);
        digest.add(branch);
        digest.add(crossed);
    }
}

impl Bits for Tracking {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&(*self as usize));
    }
}

impl Bits for Progress {
    fn add_to(&self, digest: &mut Digest) {
        match self {
            Self::Full => digest.add(&1_usize),
            Self::Slowed => digest.add(&2_usize),
            Self::Blocked(tracking) => {
                digest.add(&3_usize);
                digest.add(tracking);
            }
            Self::Done => digest.add(&4_usize),
        }
    }
}

impl Bits for FollowError {
    fn add_to(&self, digest: &mut Digest) {
        match self {
            Self::Period => digest.add(&1_usize),
            Self::Rate(joint) => digest.add(&(2_usize, *joint)),
            Self::Length => digest.add(&3_usize),
            Self::Start(joint) => digest.add(&(4_usize, *joint)),
            Self::Combined(limit) => digest.add(&(5_usize, *limit)),
            Self::Locked(joint) => digest.add(&(6_usize, *joint)),
        }
    }
}

/// An arm whose followers are measured.
#[derive(Debug, Clone, Copy)]
pub struct Followed {
    /// Arm file and scalar, such as `puma560_f32`.
    pub name: &'static str,
    /// Velocities of the joints, degrees/s. Accelerations reach them in an eighth of a second.
    pub velocity: &'static [f64],
    /// A line all of whose ticks are exact.
    pub exact: Line,
    /// Lines past singularities, and out of reach.
    pub past: &'static [Line],
}

/// A straight line of the tool, which does not turn.
#[derive(Debug, Clone, Copy)]
pub struct Line {
    /// Joint values at its middle, degrees.
    pub middle: &'static [f64],
    /// From the middle to its end, in the arm's unit.
    pub half: [f64; 3],
    /// Duration, s.
    pub time: f64,
    /// Singularities through which a deviation may lead.
    pub crossing: Crossing,
}

impl Line {
    /// The target at a share of the line, from 0 to 1: at rest at both ends.
    pub fn target<S, T, const N: usize>(&self, arm: &S, share: f64) -> S::Target
    where
        S: Subject<T, N>,
        S::Target: Aim<T>,
        T: Scalar,
    {
        let way = 2.0 * share * share * share * (10.0 + share * (6.0 * share - 15.0)) - 1.0;
        let mut pose: Pose<T> = arm.forward(&joints(self.middle));
        for (at, half) in pose.translation.iter_mut().zip(self.half) {
            *at += T::from_f64(way * half);
        }
        S::Target::at(&pose, 0, T::ZERO, T::ZERO)
    }

    /// Joint values at its start, reached from its middle by small steps: on the branch of the middle.
    pub fn start<S, T, const N: usize>(&self, arm: &S) -> [T; N]
    where
        S: Subject<T, N>,
        S::Target: Aim<T>,
        T: Scalar,
    {
        const STEPS: u32 = 200;
        let mut q = joints(self.middle);
        for step in 1..=STEPS {
            let share = 0.5 * f64::from(STEPS - step) / f64::from(STEPS);
            let found = arm.inverse_near(&self.target(arm, share), &q);
            let usable = found.as_ref().iter().find(|solution| solution.is_exact() && solution.is_within_limits());
            q = usable.map_or(q, |solution| solution.q);
        }
        q
    }

    /// Ticks of the line.
    #[must_use]
    pub fn ticks(&self) -> u32 {
        (self.time / PERIOD) as u32
    }
}

impl Followed {
    /// The arm of a name, if it is measured.
    #[must_use]
    pub fn of(name: &str) -> Option<&'static Self> {
        FOLLOWED.iter().find(|followed| followed.name == name)
    }

    /// Settings for a line.
    #[must_use]
    pub fn settings<T: Scalar, const N: usize>(&self, line: &Line) -> FollowSettings<T, N> {
        let velocity: [T; N] = joints(self.velocity);
        let rates = Rates { velocity, acceleration: velocity.map(|velocity| T::from_f64(8.0) * velocity) };
        FollowSettings::new(T::from_f64(PERIOD), rates).crossing(line.crossing)
    }
}

/// Degrees as rad; 0 for a joint that has no value.
fn joints<T: Scalar, const N: usize>(degrees: &[f64]) -> [T; N] {
    let mut joints = [T::ZERO; N];
    for (joint, degrees) in joints.iter_mut().zip(degrees) {
        *joint = T::from_f64(degrees.to_radians());
    }
    joints
}

/// Velocities of the data sheets; of the last arm, those of 10,000 pulses a second.
pub const FOLLOWED: [Followed; 3] = [
    Followed {
        name: "ur5_f32",
        velocity: &[180.0; 6],
        exact: Line {
            middle: &[10.0, -60.0, 80.0, -40.0, 70.0, 30.0],
            half: [0.1, 0.05, 0.05],
            time: 1.0,
            crossing: Crossing::Wrist,
        },
        past: &[
            // The wrist is straight but for the angle of joint 5, which no motion of joint 1 changes.
            Line { middle: &[10.0, -60.0, 80.0, 70.0, 0.1, 30.0], ..ACROSS },
            Line { middle: &[10.0, -60.0, 80.0, 70.0, 1.0, 30.0], ..ACROSS },
            // Beyond the stretched arm.
            Line { middle: &[10.0, -60.0, 3.0, -40.0, 70.0, 30.0], half: [0.05, 0.01, 0.1], ..ACROSS },
        ],
    },
    Followed {
        name: "abb_irb2400_f32",
        velocity: &[150.0, 150.0, 150.0, 360.0, 360.0, 450.0],
        exact: Line {
            middle: &[10.0, 20.0, -30.0, 40.0, 50.0, 30.0],
            half: [0.05, 0.05, 0.05],
            time: 1.0,
            crossing: Crossing::Wrist,
        },
        past: &[
            Line { middle: &[10.0, 20.0, -30.0, 0.0, 0.05, 30.0], ..ACROSS },
            Line { middle: &[10.0, 20.0, -30.0, 0.0, 0.5, 30.0], ..ACROSS },
            // The center of the wrist passes the axis of joint 1, 1 mm and 10 mm beside it.
            Line { middle: &[10.0, -27.9, -34.377_468, 20.0, 50.0, 30.0], crossing: Crossing::Any, ..ACROSS },
            Line { middle: &[10.0, -27.2, -34.377_468, 20.0, 50.0, 30.0], crossing: Crossing::Any, ..ACROSS },
        ],
    },
    Followed {
        name: "salman_rrr_f32",
        velocity: &[281.25, 83.795, 150.0],
        exact: Line { middle: &[20.0, 70.0, -80.0], half: [50.0, 50.0, 20.0], time: 1.0, crossing: Crossing::Wrist },
        past: &[
            // Beside the cylinder about axis 1 that the arm does not reach.
            Line { middle: &[2.5, 111.87, -38.5], half: [100.0, 0.0, 0.0], time: 1.0, crossing: Crossing::Any },
            Line { middle: &[10.0, 111.7, -38.5], half: [100.0, 0.0, 0.0], time: 1.0, crossing: Crossing::Any },
            // Beyond the stretched arm.
            Line { middle: &[0.0, 37.0, 3.0], half: [30.0, 60.0, 40.0], time: 1.0, crossing: Crossing::Wrist },
        ],
    },
];

/// A line across the direction in which an arm at 10 degrees stands.
const ACROSS: Line = Line { middle: &[], half: [-0.026, 0.148, 0.0], time: 1.0, crossing: Crossing::Wrist };
