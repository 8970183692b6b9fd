//! Joint values over time that bring the tool along a path of poses, for an arm known at run time: what `denhart follow`
//! prints.
//!
//! [`follow`] keeps the path, as [`denhart_dynamic::plan`] does, or the times of its poses, as [`denhart::follow`] does.
//!
//! ```
//! use denhart_dynamic::{DynamicArm, DynamicTarget, WholeTarget};
//! use denhart_tools::follow::{Asked, Keep, follow};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let arm = DynamicArm::from_yaml(
//!     "
//! name: elbow
//! convention: standard
//! units: {length: m, angle: deg}
//! joints:
//!   - {a: 0.3, alpha: 0, d: 0, theta: 0, max_velocity: 90}
//!   - {a: 0.2, alpha: 0, d: 0, theta: 0, max_velocity: 90}
//! ",
//! )?;
//! let targets = [[0.3, -0.1], [0.3, 0.1]].map(|point| WholeTarget::from(DynamicTarget::PlanarPosition(point)));
//! let motion = follow(&Asked::new(&arm, &targets, None)?, Keep::Path, &mut |_| true)?;
//! assert!(motion.obstacle.is_none() && motion.rows.len() > 100);
//! # Ok(())
//! # }
//! ```

mod asked;
mod keep_path;
mod keep_time;
mod motion;

use denhart_dynamic::DynamicView;

pub use asked::{Asked, Keep, Rates, Refused};
pub use motion::{Motion, Obstacle, Row};

/// The motion along the path, or the obstacle that no motion passes.
///
/// `watch` is told the path's parameter that is reached, now and then; the call ends when it returns false.
///
/// # Errors
/// An arm without inverse, or with more than 8 joints; what is asked for is impossible; a `watch` that ended it.
pub fn follow(asked: &Asked<'_>, keep: Keep, watch: &mut dyn FnMut(f64) -> bool) -> Result<Motion, Refused> {
    match asked.arm.joints() {
        2 => by::<2>(asked, keep, watch),
        3 => by::<3>(asked, keep, watch),
        4 => by::<4>(asked, keep, watch),
        5 => by::<5>(asked, keep, watch),
        6 => by::<6>(asked, keep, watch),
        7 => by::<7>(asked, keep, watch),
        8 => by::<8>(asked, keep, watch),
        joints => Err(Refused::Joints(joints)),
    }
}

fn by<const N: usize>(asked: &Asked<'_>, keep: Keep, watch: &mut dyn FnMut(f64) -> bool) -> Result<Motion, Refused> {
    let view: DynamicView<'_, N> = asked.arm.view()?;
    asked.check()?;
    match keep {
        Keep::Path => keep_path::motion(asked, &view, watch),
        Keep::Time => keep_time::motion(asked, &view, watch),
    }
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use denhart_dynamic::{DynamicArm, DynamicTarget, WholeTarget};

    use super::*;

    fn elbow(more: &str) -> DynamicArm {
        let row = |a: f64| format!("  - {{a: {a}, alpha: 0, d: 0, theta: 0{more}}}\n");
        let head = "name: elbow\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n";
        let text = format!("{head}{}{}", row(0.3), row(0.2));
        DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{error}"))
    }

    fn asked(arm: &DynamicArm) -> Asked<'_> {
        let targets = [[0.3, -0.1], [0.3, 0.1]].map(|point| WholeTarget::from(DynamicTarget::PlanarPosition(point)));
        Asked::new(arm, &targets, Some(&[0.0, 1.0])).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn a_watch_that_returns_false_ends_the_call() {
        let arm = elbow(", max_velocity: 90");
        for keep in [Keep::Path, Keep::Time] {
            let mut looks = 0;
            let mut count = |_: f64| {
                looks += 1;
                true
            };
            let whole = follow(&asked(&arm), keep, &mut count);
            assert!(whole.is_ok_and(|motion| motion.obstacle.is_none() && motion.rows.len() > 1000) && looks > 1);
            for last in [0, looks / 2] {
                let mut left = last;
                let mut watch = |_: f64| {
                    let goes_on = left > 0;
                    left -= i32::from(goes_on);
                    goes_on
                };
                assert_eq!(follow(&asked(&arm), keep, &mut watch), Err(Refused::Ended), "{keep:?}, {last} of {looks}");
            }
        }
    }

    #[test]
    fn rates_may_be_those_of_linked_motors() {
        let head = "name: elbow\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n";
        let row =
            |a: f64| format!("  - {{a: {a}, alpha: 0, d: 0, theta: 0, max_velocity: 30, max_acceleration: 300}}\n");
        let text = format!("{head}{}{}coupling: {{q2: {{q1: 1, q2: 1}}}}\n", row(0.3), row(0.2));
        let arm = DynamicArm::from_yaml(&text).unwrap_or_else(|error| panic!("{error}"));
        let most = 30.0_f64.to_radians();
        for keep in [Keep::Path, Keep::Time] {
            let mut fastest = [[0.0_f64; 3]; 2];
            for (motor_rates, fastest) in [false, true].into_iter().zip(&mut fastest) {
                let asked = Asked { motor_rates, ..asked(&arm) };
                let motion = follow(&asked, keep, &mut |_| true);
                let motion = motion.unwrap_or_else(|error| panic!("{keep:?} {motor_rates}: {error}"));
                for row in &motion.rows {
                    let [a, b] = row.velocity[..] else { panic!("{row:?}") };
                    for (fastest, rate) in fastest.iter_mut().zip([a, b, a + b]) {
                        *fastest = fastest.max(rate.abs());
                    }
                }
            }
            let [joints, motors] = fastest;
            assert!(joints[0].max(joints[1]) <= most * (1.0 + 1e-9), "{keep:?} {joints:?}");
            assert!(motors[0].max(motors[2]) <= most * (1.0 + 1e-9), "{keep:?} {motors:?}");
            assert!((motors[1] - joints[1]).abs() > 0.01, "{keep:?} {motors:?}");
        }
    }

    #[test]
    fn bounds_that_no_motion_keeps_are_refused() {
        let arm = elbow("");
        let text = |asked: &Asked<'_>, keep: Keep| {
            follow(asked, keep, &mut |_| true).map_or_else(|error| error.to_string(), |_| "a motion".to_owned())
        };
        assert_eq!(text(&asked(&arm), Keep::Path), "no velocity of q1, q2");
        let fast =
            Asked { rates: Rates { velocity: vec![2.0; 2], acceleration: vec![f64::INFINITY; 2] }, ..asked(&arm) };
        assert_eq!(text(&fast, Keep::Path), "a motion");
        for period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(
                text(&Asked { period, ..fast.clone() }, Keep::Time),
                format!("{period} is no time between rows")
            );
        }
        let many = text(&Asked { period: 1e-9, ..fast.clone() }, Keep::Time);
        assert_eq!(many, "0.000000001 s gives 1000000000 rows for 1.000 s");
        for tolerance in [0.0, f64::NAN] {
            let found = text(&Asked { tolerance, ..fast.clone() }, Keep::Path);
            assert_eq!(found, format!("{tolerance} is no distance from the path"));
        }
        let short = Asked { start: Some(vec![0.1; 3]), ..fast.clone() };
        assert!(text(&short, Keep::Path).contains('3'), "{}", text(&short, Keep::Path));
        let away = Asked { start: Some(vec![0.1; 2]), ..fast };
        assert!(text(&away, Keep::Time).contains("from the nearest solution of the first target"));
    }
}
