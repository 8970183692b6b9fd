//! Followers: the rows of the measured table, random splines, targets that jump, bad settings.

use denhart::follow::{Crossing, FollowError, FollowSettings, Follower, PathFollower, Progress, Rates, Step, Tracking};
use denhart::{Arm, Branch, InverseKinematics, JointMask, PointAxis, Pose, Scalar, Wrist};
use denhart_tests::follow::arms::{
    ANTHRO, Anthro, AnthroSingle, Data, IIWA, IRB2400, Iiwa, IiwaSingle, Irb2400, Irb2400Single, JACO, Jaco,
    JacoSingle, KR210, Kr210, Kr210Single, LINKED, Linked, PUMA560, Puma560, Puma560Single, TORCH, Torch, TorchSingle,
    UR5, Ur5, Ur5Single,
};
use denhart_tests::follow::random::{Jumps, Splines, jumps};
use denhart_tests::follow::table::{Case, PERIOD, elbow_arc, elbow_radial, limit, shoulder, wrist};
use denhart_tests::follow::watch::{Run, Watch, keep};

/// Splines and jumps of each arm here; `cargo run -p denhart-tests --bin follow` takes as many as asked for.
const COUNT: usize = 38;

fn run<A>(arm: &A, data: &Data<6>, case: &Case<6>, crossing: Crossing, accelerations: bool) -> Run
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let rates = if accelerations { data.rates() } else { Rates::velocity(data.rates().velocity) };
    let settings = FollowSettings::new(PERIOD, rates).crossing(crossing).length(0.1 * data.reach);
    let mut watch = Watch::new(arm, PERIOD, rates, settings, &case.q);
    for tick in 1..=(case.time / PERIOD) as usize + 500 {
        watch.tick(&(case.path)(tick as f64 * PERIOD));
    }
    watch.run
}

/// A row: mm, degrees and ms away are at most those given, with velocities alone and with accelerations too.
fn row<A>(arm: &A, data: &Data<6>, case: impl Fn(f64) -> Case<6>, crossing: Crossing, most: [[f64; 3]; 2])
where
    A: InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    for (accelerations, [mm, degrees, ms]) in [false, true].into_iter().zip(most) {
        for phase in [0.0, 0.5] {
            let run = run(arm, data, &case(phase), crossing, accelerations);
            assert!(run.holds(), "{run:?}");
            assert_eq!(run.end, Some(Tracking::Exact), "{run:?}");
            if phase == 0.0 {
                let [length, angle] = run.deviation;
                let (length, angle) = (length * 1e3, angle.to_degrees());
                assert!(length <= mm && angle <= degrees && run.away as f64 <= ms, "{length} mm, {angle}, {run:?}");
            }
        }
    }
}

/// The prototype's figures and a fifth.
#[test]
fn past_a_wrist() {
    let rows = [
        (0.0, [[1e-6, 1e-6, 0.0]; 2]),
        (1e-6, [[4.8e-4, 3.6e-4, 1.2], [4.8e-4, 4.8e-4, 31.2]]),
        (1e-4, [[0.0048, 0.0072, 27.6], [0.024, 0.036, 150.0]]),
        (1e-3, [[0.048, 0.072, 90.0], [0.132, 0.204, 273.0]]),
        (1e-2, [[0.48, 0.72, 283.0], [0.96, 1.44, 531.0]]),
    ];
    for (off, most) in rows {
        row(&Kr210, &KR210, |phase| wrist(off, phase), Crossing::Wrist, most);
    }
}

#[test]
fn past_a_shoulder() {
    let rows = [(1e-3, [[1.8, 0.36, 160.0], [4.56, 0.96, 386.0]]), (1e-2, [[25.0, 5.0, 1500.0], [50.0, 8.0, 1600.0]])];
    for (off, most) in rows {
        row(&Irb2400, &IRB2400, |phase| shoulder(off, phase), Crossing::Any, most);
    }
}

#[test]
fn to_the_edge_of_reach_and_beyond() {
    let radial = [[1e-6, 1e-6, 0.0], [142.8, 9.12, 756.0]];
    row(&Ur5, &UR5, |phase| elbow_radial(-1e-3, phase), Crossing::Wrist, radial);
    let arc = [[22.8, 3.48, 1159.0], [22.8, 3.84, 1481.0]];
    row(&Ur5, &UR5, |phase| elbow_arc(2e-2, phase), Crossing::Wrist, arc);
}

#[test]
fn past_a_limit() {
    let most = [[13.2, 21.6, 1578.0], [13.2, 21.6, 1609.0]];
    row(&Irb2400, &IRB2400, limit, Crossing::Wrist, most);
}

/// The path follower keeps the path: the time it takes, or why it does not go on.
#[test]
fn the_path_is_kept() {
    fn kept<A>(arm: &A, data: &Data<6>, case: &Case<6>) -> (f64, Progress)
    where
        A: InverseKinematics<f64, 6, Target = Pose<f64>>,
    {
        let rates = Rates::velocity(data.rates().velocity);
        let kept = keep(arm, rates, FollowSettings::new(PERIOD, rates), PERIOD, &case.path, case.time, &case.q);
        assert!(kept.rates[0] <= 1.0 + 1e-9 && kept.deviation < 1e-9, "{kept:?}");
        (kept.time, kept.end)
    }
    for (off, most) in [(0.0, 1.41), (1e-6, 2.48), (1e-4, 2.45), (1e-3, 2.37), (1e-2, 2.2)] {
        let (time, end) = kept(&Kr210, &KR210, &wrist(off, 0.0));
        assert!(end == Progress::Done && time < most, "{off}: {time} {end:?}");
    }
    let (time, end) = kept(&Irb2400, &IRB2400, &shoulder(1e-2, 0.0));
    assert!(end == Progress::Done && time < 2.19, "{time} {end:?}");
    assert_eq!(kept(&Ur5, &UR5, &elbow_arc(2e-2, 0.0)).1, Progress::Blocked(Tracking::Reach));
    assert_eq!(kept(&Irb2400, &IRB2400, &limit(0.0)).1, Progress::Blocked(Tracking::Limits));
}

/// A path that asks one joint to leave its range is blocked by that range, although other branches reach the target.
#[test]
fn a_limit_blocks_a_path_that_other_branches_reach() {
    let start = [0.3, -0.3, 0.2, 0.2, 0.6, -0.4];
    let rates = Rates::velocity(IRB2400.rates().velocity);
    for (joint, change) in [(0, 3.3), (0, -3.9), (4, 2.0)] {
        let path = |t: f64| {
            let mut q = start;
            q[joint] += change * t / 3.0;
            Irb2400.forward(&q)
        };
        let kept = keep(&Irb2400, rates, FollowSettings::new(PERIOD, rates), PERIOD, &path, 3.0, &start);
        assert_eq!(kept.end, Progress::Blocked(Tracking::Limits), "{joint}: {kept:?}");
    }
}

fn paths<A: InverseKinematics<T, N>, T: Scalar, const N: usize>(
    arm: &A,
    data: &Data<N>,
    target: impl Fn(&Pose<T>, &[T; N]) -> A::Target,
) {
    for accelerations in [false, true] {
        let splines = Splines { accelerations, count: COUNT / 2, seed: 7, only: None };
        let many = splines.follow(arm, data, &target, |_, _, _| {});
        assert!(many.paths[1] > 0 && many.holds(), "{} {many:?}", data.name);
    }
}

/// The splines of all arms, with numbers of one type.
macro_rules! paths {
    ($Irb2400:ident $Ur5:ident $Puma560:ident $Kr210:ident $Iiwa:ident $Torch:ident $Anthro:ident $Jaco:ident) => {
        paths(&$Irb2400, &IRB2400, |pose, _| *pose);
        paths(&$Ur5, &UR5, |pose, _| *pose);
        paths(&$Puma560, &PUMA560, |pose, _| *pose);
        paths(&$Kr210, &KR210, |pose, _| *pose);
        paths(&$Iiwa, &IIWA, |pose, q| (*pose, q[2]));
        paths(&$Torch, &TORCH, |pose, _| PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z)));
        paths(&$Anthro, &ANTHRO, |pose, _| pose.translation);
        paths(&$Jaco, &JACO, |pose, _| *pose);
    };
}

#[test]
fn splines_end_exact() {
    paths!(Irb2400 Ur5 Puma560 Kr210 Iiwa Torch Anthro Jaco);
}

#[test]
fn splines_end_exact_in_single_precision() {
    paths!(Irb2400Single Ur5Single Puma560Single Kr210Single IiwaSingle TorchSingle AnthroSingle JacoSingle);
}

/// Joint 4 of a torch has more than half a turn to go, inside its range, and the joint that leads takes it the other way first.
#[test]
fn a_goal_beyond_half_a_turn_is_reached() {
    let axis = |pose: &Pose<f64>, _: &[f64; 5]| PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z));
    for accelerations in [false, true] {
        let splines = Splines { accelerations, count: 473, seed: 1, only: Some(472) };
        let many = splines.follow(&Torch, &TORCH, axis, |_, _, _| {});
        assert!(many.away == 0 && many.holds(), "{many:?}");
    }
}

fn jumping<A: InverseKinematics<f64, N>, const N: usize>(
    arm: &A,
    data: &Data<N>,
    target: impl Fn(&[f64; N], f64) -> A::Target,
    bad: impl Fn() -> A::Target,
) {
    let jumps: Jumps = jumps(arm, data, Crossing::Wrist, COUNT, 3, target, bad);
    assert!(jumps.run.holds() && jumps.restless == 0 && jumps.bad > 0, "{} {jumps:?}", data.name);
    // The others are at limits of the branch that is followed, out of reach as every tenth, or slow: a far one takes some
    // arms longer than 3 s.
    assert!(jumps.ends[0] * 10 >= COUNT * 6, "{} {jumps:?}", data.name);
}

fn longer<A: Arm<f64, N>, const N: usize>(arm: &A, q: &[f64; N], factor: f64) -> Pose<f64> {
    let mut pose = arm.forward(q);
    pose.translation = pose.translation.map(|x| x * factor);
    pose
}

#[test]
fn targets_jump() {
    let mut bad = Pose::identity();
    bad.translation[1] = f64::NAN;
    let mirror = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], translation: [1.0, 0.0, 0.5] };
    jumping(&Irb2400, &IRB2400, |q, f| longer(&Irb2400, q, f), || bad);
    jumping(&Ur5, &UR5, |q, f| longer(&Ur5, q, f), || mirror);
    jumping(&Puma560, &PUMA560, |q, f| longer(&Puma560, q, f), || bad);
    jumping(&Kr210, &KR210, |q, f| longer(&Kr210, q, f), || mirror);
    jumping(&Iiwa, &IIWA, |q, f| (longer(&Iiwa, q, f), q[2]), || (Pose::identity(), f64::NAN));
    let axis = |pose: Pose<f64>| PointAxis::new(pose.translation, pose.rotation.map(|[_, _, z]| z));
    jumping(&Torch, &TORCH, |q, f| axis(longer(&Torch, q, f)), || PointAxis::new([0.5, 0.0, 0.0], [0.0; 3]));
    jumping(&Anthro, &ANTHRO, |q, f| longer(&Anthro, q, f).translation, || [f64::INFINITY; 3]);
    jumping(&Jaco, &JACO, |q, f| longer(&Jaco, q, f), || bad);
}

/// Joint values over 3 s, at rest at both ends.
fn between(a: &[f64; 6], b: &[f64; 6], tick: u32) -> [f64; 6] {
    let t = f64::from(tick.min(1500)) / 1500.0;
    let share = t * t * t * (10.0 + t * (6.0 * t - 15.0));
    std::array::from_fn(|joint| a[joint] + share * (b[joint] - a[joint]))
}

/// The center of the wrist passes the axis of joint 1, where the solution of the branch that is followed leaps by half a turn.
#[test]
fn an_exact_path_goes_on_along_the_branch_that_it_meets() {
    let (a, b) = ([0.0, -0.3, 0.0, 0.2, 0.6, -0.4], [0.5, -0.9, -0.92, 0.2, 0.6, -0.4]);
    for crossing in [Crossing::Exact, Crossing::Wrist, Crossing::Any] {
        let settings = FollowSettings::new(0.002, Rates { velocity: [3.0; 6], acceleration: [25.0; 6] });
        let mut follower = Follower::new(&Irb2400, settings.crossing(crossing), &a).unwrap();
        let (mut found, mut crossed) = (Irb2400.inverse(&Irb2400.forward(&a)), 0);
        for tick in 1..=1600 {
            let step = follower.step(&Irb2400, &Irb2400.forward(&between(&a, &b, tick)), &mut found);
            assert!(step.tracking.is_exact(), "{crossing:?}, tick {tick}: {step:?}");
            crossed += usize::from(step.crossed.is_some());
        }
        assert_eq!(crossed, 1);
    }
}

/// The tick in the middle of the path is at a straight wrist, where joints 4 and 6 could share their motion in any way.
#[test]
fn an_exact_path_goes_through_a_singular_tick_at_its_speed() {
    let (a, b) = ([0.1, -0.3, 0.2, 0.2, -0.4, -0.4], [0.5, -0.6, 0.1, 0.8, 0.4, 0.3]);
    let mut settings = FollowSettings::new(0.002, Rates { velocity: [3.0; 6], acceleration: [25.0; 6] });
    for crossing in [Crossing::Exact, Crossing::Wrist] {
        settings = settings.crossing(crossing);
        let mut follower = Follower::new(&Irb2400, settings, &a).unwrap();
        let mut found = Irb2400.inverse(&Irb2400.forward(&a));
        for tick in 1..=1600 {
            let q = between(&a, &b, tick);
            assert!(tick != 750 || q[4] == 0.0);
            let step = follower.step(&Irb2400, &Irb2400.forward(&q), &mut found);
            assert!(step.tracking.is_exact(), "{crossing:?}, tick {tick}: {step:?}");
        }
    }
}

/// At a straight wrist both names fit: the wrist has none. The first regular tick gives it one, and a deviation from there on
/// goes as from a regular start.
#[test]
fn a_start_at_a_straight_wrist_gets_its_name_beside_it() {
    let start = [0.3, -1.2, 1.4, -0.7, 0.0, 0.5];
    for bent in [-0.4, 0.4] {
        let mut regular = start;
        regular[4] = bent;
        let named = Ur5.inverse_near(&Ur5.forward(&regular), &regular).iter().next().map(|solution| solution.branch);
        let rates = Rates { velocity: [3.0; 6], acceleration: [25.0; 6] };
        let settings = FollowSettings::new(PERIOD, rates);
        let mut follower = Follower::new(&Ur5, settings, &start).unwrap();
        let mut by_path = PathFollower::new(&Ur5, settings, &start).unwrap();
        let mut found = Ur5.inverse(&Ur5.forward(&start));
        let mut end = follower.step(&Ur5, &Ur5.forward(&start), &mut found);
        assert!(end.tracking.is_exact() && end.branch.wrist().is_none(), "{end:?}");
        let path = |t: f64| Ur5.forward(&between(&start, &regular, (t / PERIOD) as u32));
        for tick in 1..=1600 {
            end = follower.step(&Ur5, &path(f64::from(tick) * PERIOD), &mut found);
            assert!(end.tracking.is_exact() && end.crossed.is_none(), "{tick}: {end:?}");
            let advance = by_path.step(&Ur5, path, 3.0, &mut found);
            assert!(advance.crossed.is_none());
        }
        assert_eq!(Some(end.branch), named);
        assert_eq!(Some(by_path.step(&Ur5, path, 3.0, &mut found).branch), named);
        // Back, past the straight wrist by 5 mrad.
        let off = Pose::from_xyz_rpy([0.0; 3], [0.0, 0.005, 0.0]);
        let mut beyond = regular;
        beyond[4] = -bent;
        let mut other = Follower::new(&Ur5, settings, &regular).unwrap();
        let mut most = [0.0_f64; 2];
        for tick in 0..2000_u32 {
            let mut target = Ur5.forward(&between(&regular, &beyond, tick));
            target.rotation = (off * target).rotation;
            for (most, follower) in most.iter_mut().zip([&mut follower, &mut other]) {
                *most = most.max(follower.step(&Ur5, &target, &mut found).residual.position);
            }
        }
        assert!(most[0] > 1e-5 && (most[0] - most[1]).abs() < 0.01 * most[1], "{most:?}");
    }
}

/// In single precision, by the velocity that is returned.
#[test]
fn single_precision() {
    let rates = KR210.rates();
    let single = |x: [f64; 6]| x.map(|x| x as f32);
    let rates = Rates { velocity: single(rates.velocity), acceleration: single(rates.acceleration) };
    for off in [0.0, 1e-4, 1e-3, 1e-2] {
        for phase in [0.0, 0.5] {
            let case = wrist(off, phase);
            let settings = FollowSettings::new(PERIOD as f32, rates);
            let mut watch = Watch::new(&Kr210Single, PERIOD as f32, rates, settings, &single(case.q));
            for tick in 1..=(case.time / PERIOD) as usize + 500 {
                let Pose { rotation, translation } = (case.path)(tick as f64 * PERIOD);
                let rotation = rotation.map(|row| row.map(|x| x as f32));
                watch.tick(&Pose { rotation, translation: translation.map(|x| x as f32) });
            }
            let run = watch.run;
            assert!(run.holds() && run.beyond <= 0.0 && run.deviation[0] < 2e-3, "{off} {run:?}");
            assert_eq!(run.end, Some(Tracking::Exact), "{off} {run:?}");
        }
    }
}

/// The rates are those of motors that are linked.
#[test]
fn linked_motors_keep_their_rates() {
    let rates = LINKED.rates();
    let settings = FollowSettings::new(PERIOD, rates).linked(|q| Linked.to_motor(q), |motor| Linked.from_motor(motor));
    let q = [0.2, 0.3, -0.2, 0.4, 0.9, 0.1];
    let mut follower = Follower::new(&Linked, settings, &q).expect("a start");
    let mut found = Linked.inverse(&Linked.forward(&q));
    let (mut motors, mut before) = (Linked.to_motor(&q), [0.0; 6]);
    let goals = [[1.0, 1.2, 0.6, -0.5, -0.8, 1.0], [-1.0, -0.5, -0.9, 0.5, 0.8, 1.0], [0.0, 1.5, -1.2, 0.5, 0.8, 0.0]];
    for goal in goals {
        let target = Linked.forward(&goal);
        let mut end = None;
        for _ in 0..3000 {
            let step = follower.step(&Linked, &target, &mut found);
            let now = Linked.to_motor(&step.q);
            for joint in 0..6 {
                let velocity = (now[joint] - motors[joint]) / PERIOD;
                assert!(velocity.abs() <= rates.velocity[joint] * (1.0 + 1e-9));
                let change = (velocity - before[joint]) / PERIOD;
                assert!(change.abs() <= rates.acceleration[joint] * (1.0 + 1e-6), "{joint}: {change}");
                before[joint] = velocity;
                let [low, high] = Linked::LIMITS[joint];
                assert!(step.q[joint] >= low - 1e-9 && step.q[joint] <= high + 1e-9);
            }
            motors = now;
            end = Some(step.tracking);
        }
        assert_eq!(end, Some(Tracking::Exact), "{goal:?}");
    }
}

/// A redundant joint follows the value that comes with the target, or stays.
#[test]
fn a_redundant_joint_is_given_or_held() {
    let rates = IIWA.rates();
    let q = [0.2, 0.6, 0.1, -1.2, 0.3, 0.8, 0.0];
    let [mut other, mut same] = [[0.4, 0.8, 0.5, -1.0, 0.1, 0.6, 0.2]; 2];
    (other[2], same[2]) = (0.5, q[2]);
    let end = |settings: FollowSettings<f64, 7>, pose: [f64; 7]| -> Step<f64, 7> {
        let target = (Iiwa.forward(&pose), 0.5);
        let mut watch = Watch::new(&Iiwa, PERIOD, rates, settings, &q);
        for _ in 0..1999 {
            watch.tick(&target);
        }
        let step = watch.tick(&target);
        assert!(watch.run.holds(), "{:?}", watch.run);
        step
    };
    let settings = FollowSettings::new(PERIOD, rates);
    let given = end(settings, other);
    assert!(given.tracking.is_exact() && given.q[2] == 0.5, "{given:?}");
    for settings in [settings.held(), settings.locked(JointMask::single(2))] {
        let held = end(settings, same);
        assert!(held.tracking.is_exact() && held.q[2] == q[2], "{held:?}");
    }
}

/// A tick that is short of its target names the joints that need more time, and no others.
#[test]
fn a_tick_names_the_joints_that_are_too_slow() {
    let q = [10.0, -80.0, 100.0, 20.0, 50.0, 30.0].map(f64::to_radians);
    let rates = KR210.rates();
    let settings = FollowSettings::new(PERIOD, rates);
    for slow in [vec![0], vec![4], vec![1, 5]] {
        let mut goal = q;
        slow.iter().for_each(|joint: &usize| goal[*joint] += 0.05);
        let mut watch = Watch::new(&Kr210, PERIOD, rates, settings, &q);
        let first = watch.tick(&Kr210.forward(&goal));
        assert_eq!((first.tracking, first.held.iter().collect::<Vec<_>>()), (Tracking::Rates, slow));
        let mut last = first;
        for _ in 0..500 {
            last = watch.tick(&Kr210.forward(&goal));
        }
        assert!(last.tracking.is_exact() && last.held.is_empty(), "{last:?}");
    }
}

/// A far branch is reached only by request, and the crossing is told.
#[test]
fn an_arm_goes_to_the_branch_that_it_is_sent_to() {
    let q = [10.0, -80.0, 100.0, 20.0, 50.0, 30.0].map(f64::to_radians);
    let rates = KR210.rates();
    let target = Kr210.forward(&q);
    let settings = FollowSettings::new(PERIOD, rates).crossing(Crossing::Exact);
    let mut watch = Watch::new(&Kr210, PERIOD, rates, settings, &q);
    let start = watch.tick(&target);
    assert!(start.tracking.is_exact() && start.crossed.is_none());
    let other = if start.branch.wrist() == Some(Wrist::Flip) { Wrist::NoFlip } else { Wrist::Flip };
    watch.follower.go_to_branch(&Kr210, start.branch.with_wrist(other));
    let mut crossed = None;
    let mut end = start;
    for _ in 0..4000 {
        end = watch.tick(&target);
        crossed = crossed.or(end.crossed);
    }
    assert!(end.tracking.is_exact() && end.branch.wrist() == Some(other), "{end:?}");
    assert_eq!(crossed, Some(start.branch));
    assert!(watch.run.holds(), "{:?}", watch.run);
}

/// A stop brakes to rest, from any motion.
#[test]
fn a_stop_brakes() {
    let case = wrist(1e-2, 0.0);
    let rates = KR210.rates();
    let mut watch = Watch::new(&Kr210, PERIOD, rates, FollowSettings::new(PERIOD, rates), &case.q);
    for tick in 1..700 {
        watch.tick(&(case.path)(f64::from(tick) * PERIOD));
    }
    let mut step = watch.stop();
    assert!(step.tracking == Tracking::Target && step.remaining.is_infinite());
    for _ in 0..200 {
        step = watch.stop();
    }
    assert_eq!(step.velocity, [0.0; 6]);
    assert!(watch.run.holds(), "{:?}", watch.run);
}

#[test]
fn bad_settings_and_starts_are_refused() {
    let (rates, q) = (KR210.rates(), [0.1, -1.0, 1.0, 0.1, 0.5, 0.1]);
    let refused = |settings: FollowSettings<f64, 6>, q: [f64; 6]| {
        let path = PathFollower::new(&Kr210, settings, &q).err();
        assert_eq!(Follower::new(&Kr210, settings, &q).err(), path);
        path
    };
    let settings = FollowSettings::new(PERIOD, rates);
    assert_eq!(refused(settings, q), None);
    for period in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(FollowSettings::new(period, rates), q), Some(FollowError::Period));
    }
    for velocity in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut slow = rates;
        slow.velocity[2] = velocity;
        assert_eq!(refused(FollowSettings::new(PERIOD, slow), q), Some(FollowError::Rate(2)));
    }
    let mut slow = rates;
    slow.acceleration[4] = 0.0;
    assert_eq!(refused(FollowSettings::new(PERIOD, slow), q), Some(FollowError::Rate(4)));
    assert_eq!(refused(settings.length(f64::NAN), q), Some(FollowError::Length));
    assert_eq!(refused(settings.locked(JointMask::single(6)), q), Some(FollowError::Locked(6)));
    for value in [f64::NAN, 0.5, f64::INFINITY] {
        let mut start = q;
        start[1] = value;
        assert_eq!(refused(settings, start), Some(FollowError::Start(1)));
    }
    assert_eq!(Branch::NONE.wrist(), None);
}
