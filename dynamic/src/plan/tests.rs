#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::PI;

use denhart::{InverseKinematics, Pose, Residual};

use super::*;
use crate::{DynamicArm, DynamicTarget, DynamicView, WholeTarget};

/// An arm of the structure and the size of a KUKA KR 210, with the ranges of its data sheet.
const KR210: &str = "
name: kr210
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0.35, alpha: -90, d: 0.675, theta: 0, limits: [-185, 185]}
  - {a: 1.15, alpha: 0, d: 0, theta: 0, limits: [-140, -5]}
  - {a: -0.041, alpha: -90, d: 0, theta: -90, limits: [-120, 168]}
  - {a: 0, alpha: 90, d: 1.2, theta: 0, limits: [-350, 350]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-125, 125]}
  - {a: 0, alpha: 0, d: 0.215, theta: 180, limits: [-350, 350]}
";

fn two_bars(limits: &str) -> DynamicArm {
    let text = format!(
        "
name: two_bars
convention: standard
units: {{length: m, angle: deg}}
joints:
  - {{a: 0.3, alpha: 0, d: 0, theta: 0{limits}}}
  - {{a: 0.2, alpha: 0, d: 0, theta: 0}}
"
    );
    DynamicArm::from_yaml(&text).unwrap()
}

fn kr210_settings() -> PlanSettings<6> {
    let velocity = [123.0, 115.0, 112.0, 179.0, 172.0, 219.0].map(f64::to_radians);
    let tolerance = Residual { position: 2.7e-5, orientation: 1e-5 };
    PlanSettings { is_timed: true, ..PlanSettings::new(velocity, velocity.map(|v| 8.0 * v), tolerance) }
}

/// A smooth rise from 0 at the time 0 to 1 at the time 1.
fn rise(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * t * (10.0 - 15.0 * t + 6.0 * t * t)
}

/// Checks a motion every millisecond: rates, accelerations, limits and the path. Gives its duration.
fn resampled<A, const N: usize>(
    arm: &A,
    plan: &JointPath<N>,
    path: &impl Fn(f64) -> A::Target,
    settings: &PlanSettings<N>,
) -> f64
where
    A: InverseKinematics<f64, N>,
{
    const TICK: f64 = 1e-3;
    let trajectory = plan.timed();
    let ticks = (trajectory.duration() / TICK) as usize + 2;
    let points: Vec<TrajectoryPoint<N>> = (0..=ticks).map(|tick| trajectory.at(tick as f64 * TICK)).collect();
    for point in &points {
        let missed = arm.residual(&point.q, &path(point.at));
        assert!(settings.allows(&missed), "{missed:?} at {}", point.at);
        let inside = point.q.iter().zip(arm.limits()).all(|(q, [low, high])| (low..=high).contains(q));
        assert!(inside, "{:?}", point.q);
    }
    for window in points.windows(3) {
        let [a, b, c] = window else { continue };
        let (step, next) = (settings.way(&a.q, &b.q), settings.way(&b.q, &c.q));
        for joint in 0..N {
            let (velocity, acceleration) = (settings.velocity[joint], settings.acceleration[joint]);
            let change = (next[joint] - step[joint]).abs() / (TICK * TICK);
            let step = step[joint].abs() / TICK;
            assert!(step <= (1.0 + 1e-9) * velocity, "q{}: {} of the velocity at {}", joint + 1, step / velocity, b.at);
            assert!(
                change <= 1.02 * acceleration + 1e-7 / (TICK * TICK) * f64::EPSILON.sqrt(),
                "q{}: {} of the acceleration at {}",
                joint + 1,
                change / acceleration,
                b.at
            );
        }
        assert!(!settings.is_timed || b.at - a.at <= TICK * (1.0 + 1e-6), "ahead of the path at {}", b.at);
    }
    let last = points.last().unwrap();
    assert!((last.at - plan.samples().last().unwrap().at).abs() < 1e-9);
    trajectory.duration()
}

/// A line past the wrist's singular place, so far above it, at 0.5 m/s.
fn past_the_wrist(above: f64) -> (DynamicArm, Pose<f64>, [f64; 3]) {
    let arm = DynamicArm::from_yaml(KR210).unwrap();
    let q = [10.0_f64, -80.0, 100.0, 20.0, 0.0, 30.0].map(f64::to_radians);
    let mut pose = arm.forward(&q).unwrap();
    pose.translation[2] += above;
    let (sin, cos) = q[0].sin_cos();
    (arm, pose, [-sin, cos, 0.0])
}

#[test]
fn lines_past_the_wrist_keep_to_the_path_and_the_rates() {
    // The times of the slow methods beside: the swing of half a turn takes a second.
    for (above, most) in [(0.0, 1.41), (1e-6, 1.72), (1e-4, 3.0), (1e-3, 2.9), (1e-2, 2.6), (0.1, 2.0)] {
        let (arm, middle, along) = past_the_wrist(above);
        let view: DynamicView<6> = arm.view().unwrap();
        let path = |t: f64| {
            let way = 0.6 * (rise(t / 1.4) - 0.5);
            let mut pose = middle;
            for (place, along) in pose.translation.iter_mut().zip(along) {
                *place += along * way;
            }
            WholeTarget::from(DynamicTarget::Pose(pose))
        };
        let mut settings = kr210_settings();
        let plan = JointPath::new(&view, &path, 1.4, &settings, &mut |_| {}).unwrap();
        let time = resampled(&view, &plan, &path, &settings);
        assert!((1.4..most).contains(&time), "{above}: {time}");
        // From either side of the wrist there is a plan of its own.
        for start in [plan.samples()[0].q, flipped(plan.samples()[0].q)] {
            settings.start = Some(start);
            let own = JointPath::new(&view, &path, 1.4, &settings, &mut |_| {}).unwrap();
            assert_eq!(own.samples()[0].q.map(|q| (q * 1e9).round()), start.map(|q| (q * 1e9).round()));
            assert!(resampled(&view, &own, &path, &settings) > time - 1e-2);
        }
    }
}

/// The other posture of the wrist.
fn flipped([a, b, c, d, e, f]: [f64; 6]) -> [f64; 6] {
    let turned = |x: f64| if x > 0.0 { x - PI } else { x + PI };
    [a, b, c, turned(d), -e, turned(f)]
}

#[test]
fn a_place_in_the_middle_of_a_swing_does_not_hide_the_way_past_it() {
    // With an even number of intervals one of them ends at the closest place, with an odd number none.
    for intervals in [350, 351] {
        let (arm, middle, along) = past_the_wrist(1e-6);
        let view: DynamicView<6> = arm.view().unwrap();
        let path = |t: f64| {
            let mut pose = middle;
            for (place, along) in pose.translation.iter_mut().zip(along) {
                *place += along * (0.5 * t - 0.35);
            }
            WholeTarget::from(DynamicTarget::Pose(pose))
        };
        let settings = PlanSettings { intervals, ..kr210_settings() };
        let plan = JointPath::new(&view, &path, 1.4, &settings, &mut |_| {}).unwrap();
        assert_eq!(plan.crossings().count(), 1, "{intervals}");
        assert!(plan.timed().duration() < 1.8, "{intervals}: {}", plan.timed().duration());
    }
}

/// The tool of two bars on a circle about the base, in so many turns.
fn circle(turns: f64) -> impl Fn(f64) -> WholeTarget {
    move |s: f64| {
        let (sin, cos) = (turns * 2.0 * PI * s).sin_cos();
        WholeTarget::from(DynamicTarget::PlanarPosition([0.4 * cos, 0.4 * sin]))
    }
}

fn bars_settings(start: Option<[f64; 2]>) -> PlanSettings<2> {
    let tolerance = Residual { position: 5e-6, orientation: 1e-5 };
    PlanSettings { start, ..PlanSettings::new([1.0, 1.0], [4.0, 4.0], tolerance) }
}

#[test]
fn one_joint_alone_has_the_times_of_a_trapezoid() {
    let arm = two_bars("");
    let view: DynamicView<2> = arm.view().unwrap();
    let path = circle(0.5 / PI);
    let mut settings = bars_settings(None);
    let time = |settings: &PlanSettings<2>| {
        let plan = JointPath::new(&view, &path, 1.0, settings, &mut |_| {}).unwrap();
        resampled(&view, &plan, &path, settings)
    };
    // 1 rad at 1 rad/s, with 4 rad/s^2 at both ends.
    assert!((time(&settings) - 1.25).abs() < 2e-3, "{}", time(&settings));
    // 1 rad/s is not reached.
    settings.velocity = [3.0, 1.0];
    assert!((time(&settings) - 1.0).abs() < 2e-3, "{}", time(&settings));
    settings = PlanSettings { velocity: [1.0; 2], acceleration: [f64::INFINITY; 2], ..settings };
    assert!((time(&settings) - 1.0).abs() < 1e-9, "{}", time(&settings));
    // Half as fast as the path is timed: 0.5 rad/s, and 0.125 s for both ends.
    let slow = |s: f64| path(s / 2.0);
    let settings = PlanSettings { acceleration: [4.0; 2], is_timed: true, ..settings };
    let plan = JointPath::new(&view, &slow, 2.0, &settings, &mut |_| {}).unwrap();
    let time = resampled(&view, &plan, &slow, &settings);
    assert!((time - 2.125).abs() < 3e-3, "{time}");
}

#[test]
fn rates_of_linked_motors_bound_the_motion() {
    let arm = two_bars("");
    let view: DynamicView<2> = arm.view().unwrap();
    // Motor 2 turns the second bar against the base, and 0.3 rad away from it.
    let to_motor = |q: &[f64; 2]| [q[0], q[0] + q[1] + 0.3];
    let path = circle(0.5 / PI);
    let slow_second = PlanSettings { velocity: [3.0, 1.0], ..bars_settings(None) };
    let time = |settings: &PlanSettings<2>, path: &dyn Fn(f64) -> WholeTarget| {
        let plan = JointPath::new(&view, &path, 1.0, settings, &mut |_| {}).unwrap();
        resampled(&view, &plan, &path, settings)
    };
    // Joint 1 alone moves by 1 rad, and both motors do.
    assert!((time(&slow_second, &path) - 1.0).abs() < 2e-3);
    let linked = slow_second.linked(to_motor);
    assert_eq!(linked.motors, Some([[1.0, 0.0], [1.0, 1.0]]));
    assert!((time(&linked, &path) - 1.25).abs() < 2e-3, "{}", time(&linked, &path));
    // On a line both joints move, against each other for a part of the way.
    let line = |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([0.3, 0.3 * s - 0.15]));
    let (own, motors) = (bars_settings(None), bars_settings(None).linked(to_motor));
    let times = [time(&own, &line), time(&motors, &line)];
    assert!((times[0] - times[1]).abs() > 0.01, "{times:?}");
}

#[test]
fn accelerations_hold_between_the_ends_of_a_stretch_too() {
    let arm = two_bars("");
    let view: DynamicView<2> = arm.view().unwrap();
    let corner = |s: f64| {
        let [from, to, part] =
            if s < 1.0 { [[0.4, 0.2], [-0.3, 0.4], [s; 2]] } else { [[-0.3, 0.4], [0.3, 0.0], [s - 1.0; 2]] };
        WholeTarget::from(DynamicTarget::PlanarPosition([0, 1].map(|k| from[k] + part[k] * (to[k] - from[k]))))
    };
    let tolerance = Residual { position: 5e-6, orientation: 1e-5 };
    let settings = PlanSettings::new([3.0; 2], [15.0; 2], tolerance);
    let plan = JointPath::new(&view, &corner, 2.0, &settings, &mut |_| {}).unwrap();
    let trajectory = plan.timed();
    let step = 1e-5;
    let rate = |tick: f64| trajectory.at(tick * step).velocity;
    for tick in 0..(trajectory.duration() / step) as usize {
        let (a, b) = (rate(tick as f64), rate(tick as f64 + 1.0));
        let fastest = (b[0] - a[0]).abs().max((b[1] - a[1]).abs()) / step;
        assert!(fastest <= 15.0 * 1.001, "{fastest} at {}", tick as f64 * step);
    }
}

#[test]
fn every_stretch_has_a_speed_whatever_the_rates() {
    let arm = two_bars("");
    let view: DynamicView<2> = arm.view().unwrap();
    let line = |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([0.3, 0.2 * s - 0.1]));
    let fast = PlanSettings::new([1e12; 2], [15.0; 2], Residual { position: 5e-6, orientation: 1e-5 });
    let time = JointPath::new(&view, &line, 1.0, &fast, &mut |_| {}).unwrap().timed().duration();
    let near = PlanSettings { velocity: [30.0; 2], ..fast };
    let same = JointPath::new(&view, &line, 1.0, &near, &mut |_| {}).unwrap().timed().duration();
    assert!((time / same - 1.0).abs() < 0.01, "{time} {same}");
    for step in 0..60 {
        let velocity = 0.05 * 1.1_f64.powi(step);
        for acceleration in [1.0, 3.3, 10.0, 97.0] {
            let tolerance = Residual { position: 5e-6, orientation: 1e-5 };
            let settings = PlanSettings::new([velocity; 2], [acceleration * velocity; 2], tolerance);
            let plan = JointPath::new(&view, &line, 1.0, &settings, &mut |_| {}).unwrap();
            let trajectory = plan.timed();
            assert!(trajectory.duration() < 60.0 / velocity, "{velocity} {acceleration}: {}", trajectory.duration());
            if step % 20 == 15 {
                resampled(&view, &plan, &line, &settings);
            }
        }
    }
}

#[test]
fn turns_are_chosen_so_that_the_whole_path_fits() {
    let arm = two_bars(", limits: [-400, 400]");
    let view: DynamicView<2> = arm.view().unwrap();
    let path = circle(1.9);
    let settings = bars_settings(None);
    let plan = JointPath::new(&view, &path, 1.0, &settings, &mut |_| {}).unwrap();
    let [first, .., last] = plan.samples() else { panic!("no samples") };
    assert!((last.q[0] - first.q[0] - 3.8 * PI).abs() < 1e-6 && first.q[0] < -5.0, "{first:?} {last:?}");
    resampled(&view, &plan, &path, &settings);
    // From the other turn joint 1 ends at its limit.
    let start = [first.q[0] + 2.0 * PI, first.q[1]];
    let error = JointPath::new(&view, &path, 1.0, &bars_settings(Some(start)), &mut |_| {}).unwrap_err();
    let PlanError::NoPath { at, obstacle, .. } = error else { panic!("{error}") };
    let expected = (400_f64.to_radians() - start[0]) / (3.8 * PI);
    assert!(obstacle == Obstacle::WholeTurn(0) && (at - expected).abs() < 1e-6, "{error}: {expected}");
    // Without limits there is no end of turns.
    let free = two_bars("");
    let view: DynamicView<2> = free.view().unwrap();
    let plan = JointPath::new(&view, &circle(5.0), 1.0, &settings, &mut |_| {}).unwrap();
    let [first, .., last] = plan.samples() else { panic!("no samples") };
    assert!((last.q[0] - first.q[0] - 10.0 * PI).abs() < 1e-6);
}

#[test]
fn where_no_path_goes_on_the_reason_is_named() {
    let out = |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([0.3 + 0.3 * s, 0.0]));
    let arm = two_bars(", limits: [-400, 400]");
    let view: DynamicView<2> = arm.view().unwrap();
    let refused = |view: &DynamicView<2>, path: &dyn Fn(f64) -> WholeTarget, settings: PlanSettings<2>| {
        JointPath::new(view, &path, 1.0, &settings, &mut |_| {}).unwrap_err()
    };
    let error = refused(&view, &out, bars_settings(None));
    let PlanError::NoPath { at, obstacle: Obstacle::Reach, .. } = error else { panic!("{error}") };
    assert!((at - 2.0 / 3.0).abs() < 1e-6, "{error}");
    let short = two_bars(", limits: [-60, 60]");
    let view: DynamicView<2> = short.view().unwrap();
    let error = refused(&view, &circle(0.4), bars_settings(None));
    let PlanError::NoPath { at, obstacle: Obstacle::Limit(0), .. } = error else { panic!("{error}") };
    assert!(at > 0.1 && at < 0.7 && error.to_string().contains("q1 is at its limit"), "{error}");
    let away = |_: f64| WholeTarget::from(DynamicTarget::PlanarPosition([-0.4, 0.0]));
    let error = refused(&view, &away, bars_settings(None));
    assert!(matches!(error, PlanError::NoPath { at, obstacle: Obstacle::Limit(0), .. } if at == 0.0), "{error}");
    // Through the base: both bars would have to turn at once by half a turn.
    let equal = DynamicArm::from_yaml(
        "
name: equal
convention: standard
units: {length: m, angle: deg}
joints:
  - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-170, 170]}
  - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-178, 178]}
",
    )
    .unwrap();
    let view: DynamicView<2> = equal.view().unwrap();
    let through = |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([0.2 - 0.4 * s, 0.0]));
    let error = refused(&view, &through, bars_settings(None));
    assert!(matches!(error, PlanError::NoPath { obstacle: Obstacle::Limit(1), .. }), "{error}");
}

#[test]
fn settings_and_starts_that_are_none_are_refused() {
    let arm = two_bars(", limits: [-90, 90]");
    let view: DynamicView<2> = arm.view().unwrap();
    let path = circle(0.1);
    let refused = |settings: PlanSettings<2>, end: f64| {
        JointPath::new(&view, &path, end, &settings, &mut |_| {}).unwrap_err().to_string()
    };
    let plain = bars_settings(None);
    for velocity in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let said = refused(PlanSettings { velocity: [1.0, velocity], ..plain }, 1.0);
        assert!(said.contains("velocity of q2"), "{said}");
    }
    for acceleration in [0.0, -1.0, f64::NAN] {
        let said = refused(PlanSettings { acceleration: [acceleration, 1.0], ..plain }, 1.0);
        assert!(said.contains("acceleration of q1"), "{said}");
    }
    for position in [0.0, f64::NAN, f64::INFINITY] {
        let tolerance = Residual { position, orientation: 1e-5 };
        assert!(refused(PlanSettings { tolerance, ..plain }, 1.0).contains("tolerances"));
    }
    for end in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(plain, end).contains("path ends"));
    }
    assert!(refused(bars_settings(Some([2.0, 0.0])), 1.0).contains("outside the limits of q1"));
    assert!(refused(bars_settings(Some([f64::NAN, 0.0])), 1.0).contains("outside the limits of q1"));
    assert!(refused(bars_settings(Some([0.5, 0.5])), 1.0).contains("from the nearest solution"));
    let nowhere =
        |s: f64| WholeTarget::from(DynamicTarget::PlanarPosition([if s > 0.5 { f64::NAN } else { 0.4 }, 0.0]));
    let error = JointPath::new(&view, &nowhere, 1.0, &plain, &mut |_| {}).unwrap_err();
    assert!(matches!(error, PlanError::Target { at } if at > 0.5), "{error}");
}

#[test]
fn a_redundant_joint_goes_along_with_the_target() {
    let file = format!("{}/../specs/planar4r_redundant.yaml", env!("CARGO_MANIFEST_DIR"));
    let arm = DynamicArm::from_file(file).unwrap();
    let view: DynamicView<4> = arm.view().unwrap();
    let q = [0.3, 0.5, -0.4, 0.6];
    let (from, to) = (view.target_at(&q), view.target_at(&[0.7, 0.6, -0.3, 0.2]));
    let path = TargetPath::new(&[from, to], None, 1.0).unwrap();
    let tolerance = Residual { position: 1e-5, orientation: 1e-5 };
    let settings = PlanSettings { start: Some(q), ..PlanSettings::new([1.0; 4], [5.0; 4], tolerance) };
    let at = |at: f64| path.at(at);
    let plan = JointPath::new(&view, &at, path.end(), &settings, &mut |_| {}).unwrap();
    resampled(&view, &plan, &at, &settings);
    for sample in plan.samples() {
        let given = arm.held(&sample.q).unwrap();
        assert!((given[0] - at(sample.at).given[0]).abs() < 1e-9, "{sample:?}");
    }
}
