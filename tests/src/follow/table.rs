//! The rows of the measured table.

use std::f64::consts::PI;

use denhart::{Arm, InverseKinematics, Pose};

use super::arms::{Data, IRB2400, Irb2400, KR210, Kr210, UR5, Ur5};
use super::path::{Path, law, line, moved};
use super::sight::{directions, outward};

/// Period of the ticks, s.
pub const PERIOD: f64 = 1e-3;

/// A path, and where the arm starts.
pub struct Case<const N: usize> {
    /// Targets over time.
    pub path: Path<Pose<f64>>,
    /// Duration, s.
    pub time: f64,
    /// Joint values at its start.
    pub q: [f64; N],
}

fn nearest<A, const N: usize>(arm: &A, target: &Pose<f64>, q: &[f64; N]) -> [f64; N]
where
    A: InverseKinematics<f64, N, Target = Pose<f64>>,
{
    let found = arm.inverse_near(target, q);
    found.as_ref().iter().find(|s| s.is_exact() && s.is_within_limits()).map_or(*q, |s| s.q)
}

/// A line past a singular posture `q` at the distance `off`, `half` m to either side, at `v` m/s. A tick falls on the
/// closest place, `phase` of a tick later.
fn past<A>(arm: &A, data: &Data<6>, q: [f64; 6], off: f64, [half, v]: [f64; 2], phase: f64) -> Case<6>
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let [n, u] = directions(arm, &q, data.reach, None, |pose| pose);
    let middle = arm.forward(&q);
    let start = moved(&moved(&middle, u, -half), n, off);
    let closest = half / v + 0.1;
    let shift = closest - (closest / PERIOD).floor() * PERIOD + phase * PERIOD;
    let (path, time) = line(start, u, 2.0 * half, v, shift);
    // From the middle outward by small steps, to start on the branch of `q`.
    let mut at = q;
    for k in 1..=400 {
        at = nearest(arm, &moved(&moved(&middle, u, -half * f64::from(k) / 400.0), n, off), &at);
    }
    let q = nearest(arm, &path(0.0), &at);
    Case { path, time, q }
}

/// Past the wrist singularity of a KR210.
#[must_use]
pub fn wrist(off: f64, phase: f64) -> Case<6> {
    let q = [10.0, -80.0, 100.0, 20.0, 0.0, 30.0].map(f64::to_radians);
    past(&Kr210, &KR210, q, off, [0.3, 0.5], phase)
}

/// Past the shoulder singularity of an IRB 2400: the center of the wrist passes the axis of joint 1.
#[must_use]
pub fn shoulder(off: f64, phase: f64) -> Case<6> {
    let mut q = [10.0, 0.0, 0.0, 20.0, 50.0, 30.0].map(f64::to_radians);
    q[2] = -0.6;
    let radius = |q2: f64| Irb2400.link_poses(&[0.0, q2, q[2], q[3], q[4], q[5]])[3].translation[0];
    let (mut low, mut high) = (-1.5, 0.5);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if radius(low) * radius(middle) <= 0.0 { high = middle } else { low = middle }
    }
    q[1] = low;
    past(&Irb2400, &IRB2400, q, off, [0.15, 0.25], phase)
}

/// Radially out to `beyond` the reach of a UR5, and back.
#[must_use]
pub fn elbow_radial(beyond: f64, phase: f64) -> Case<6> {
    let (middle, out, _, bent) = stretched();
    let total = 0.1;
    let path: Path<Pose<f64>> = Box::new(move |t| {
        let way = total * ((t + phase * PERIOD).clamp(0.0, 1.0) * PI).sin().powi(2);
        moved(&middle, out, way - total + beyond)
    });
    let q = first(&path, &bent);
    Case { path, time: 1.0, q }
}

/// An arc that leaves the reach of a UR5 by `beyond`.
#[must_use]
pub fn elbow_arc(beyond: f64, phase: f64) -> Case<6> {
    let (middle, out, tangent, bent) = stretched();
    let path: Path<Pose<f64>> = Box::new(move |t| {
        let (s, c) = (law(t + phase * PERIOD, 2.4, 1.25) - 1.2).sin_cos();
        moved(&moved(&middle, tangent, 0.2 * s), out, beyond - 0.2 * (1.0 - c))
    });
    let q = first(&path, &bent);
    Case { path, time: 2.4 / 1.25 + 0.2, q }
}

fn first(path: &Path<Pose<f64>>, q: &[f64; 6]) -> [f64; 6] {
    Ur5.inverse_near(&path(0.0), q).as_ref().first().map_or(*q, |s| s.q)
}

/// The pose of a stretched UR5, outward, across, and joint values with the elbow bent.
fn stretched() -> (Pose<f64>, [f64; 3], [f64; 3], [f64; 6]) {
    let q = [10.0, -60.0, 0.0, -40.0, 70.0, 30.0].map(f64::to_radians);
    let out = outward(&Ur5, &q, UR5.reach);
    let cross = |a: [f64; 3], b: [f64; 3]| {
        let c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let n = c.iter().map(|x| x * x).sum::<f64>().sqrt();
        c.map(|x| x / n)
    };
    let tangent = cross(cross(out, [0.0, 0.0, 1.0]), out);
    let mut bent = q;
    bent[2] = 0.5;
    bent[1] -= 0.25;
    bent[3] -= 0.25;
    (Ur5.forward(&q), out, tangent, bent)
}

/// Joint 5 of an IRB 2400 past its limit by 19 degrees, and back.
#[must_use]
pub fn limit(phase: f64) -> Case<6> {
    let q = [10.0, 20.0, -30.0, 20.0, 110.0, 30.0].map(f64::to_radians);
    let path: Path<Pose<f64>> = Box::new(move |t| {
        let x = ((t + phase * PERIOD) / 2.2).clamp(0.0, 1.0);
        let mut p = q;
        p[4] += 0.5 * (x * PI).sin().powi(2);
        Irb2400.forward(&p)
    });
    Case { path, time: 2.2, q }
}
