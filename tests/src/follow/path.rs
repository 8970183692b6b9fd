//! Paths of targets over time.

use denhart::Pose;

use crate::random::Random;

/// A target for each time in s.
pub type Path<G> = Box<dyn Fn(f64) -> G>;

/// A pose, its origin moved by `s` times `u`.
#[must_use]
pub fn moved(pose: &Pose<f64>, u: [f64; 3], s: f64) -> Pose<f64> {
    let mut pose = *pose;
    for (x, u) in pose.translation.iter_mut().zip(u) {
        *x += s * u;
    }
    pose
}

/// Distance along a line at time `t`: it starts and ends softly, over 0.2 s each, and has the speed `v` between.
#[must_use]
pub fn law(t: f64, total: f64, v: f64) -> f64 {
    let soft = 0.2;
    // The integral of the quintic that rises from 0 to 1 with derivatives of 0 at its ends.
    let rise = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        x.powi(4) * (2.5 - 3.0 * x + x * x)
    };
    let end = total / v + soft;
    if t < soft {
        v * soft * rise(t / soft)
    } else if t < end - soft {
        v * (t - 0.5 * soft)
    } else {
        total - v * soft * rise((end - t).max(0.0) / soft)
    }
}

/// A straight line of `total` m along `u` at `v` m/s, `shift` s later; and its duration.
#[must_use]
pub fn line(from: Pose<f64>, u: [f64; 3], total: f64, v: f64, shift: f64) -> (Path<Pose<f64>>, f64) {
    (Box::new(move |t| moved(&from, u, law(t + shift, total, v))), total / v + 0.2)
}

/// Duration of a [`spline`], s.
pub const SPLINE: f64 = 3.2;

/// A closed curve of three harmonics around a pose, up to `size` m away and turned by up to about 0.7 rad.
pub fn spline(around: Pose<f64>, size: f64, random: &mut Random) -> Path<Pose<f64>> {
    let a: [f64; 18] = std::array::from_fn(|_| random.uniform(-1.0, 1.0));
    Box::new(move |t| {
        let s = law(t, 6.0, 2.0);
        let part = |k: usize, size: f64| {
            size * (a[3 * k] * s.sin() + 0.5 * a[3 * k + 1] * (2.0 * s).sin() + 0.3 * a[3 * k + 2] * (3.0 * s).sin())
        };
        let mut pose = around * Pose::from_xyz_rpy([0.0; 3], [part(3, 0.4), part(4, 0.4), part(5, 0.4)]);
        for (k, x) in pose.translation.iter_mut().enumerate() {
            *x = around.translation[k] + part(k, size);
        }
        pose
    })
}
