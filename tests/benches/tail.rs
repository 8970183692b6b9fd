//! How much longer than an ordinary call the slow calls of `inverse` take. The tables print the times of the calls over
//! the median time of ordinary targets. The tables also print the most cascades and evaluations of a call.
//!
//! `cargo bench -p denhart-tests --no-default-features --bench tail`

use std::time::Duration;

use denhart::effort::{Effort, effort_of};
use denhart::{Arm, DhTable, InverseKinematics};
use denhart_tests::poses::{SURFACE, Space, singular_surface};
use denhart_tests::random::Random;
use denhart_tests::subject::{Specified, Subject};
use denhart_tests::task::{Asked, EQUATIONS, Goal, Kind, Task};
use denhart_tests::timing::{Tail, least};

/// Defines the types of arms, and a function that prints their tables.
macro_rules! arms {
    ($tables:ident: $($Type:ident $dof:literal $name:literal $spec:literal $task:expr;)*) => {
        $(
            #[derive(Arm, Default)]
            #[arm(spec = $spec)]
            struct $Type;

            impl Specified<$dof> for $Type {
                const NAME: &'static str = $name;
                const TABLE: DhTable = Self::DH;
                const TASK: Task = $task;
            }
        )*

        fn $tables(options: Options) {
            $(table::<$Type, $dof>(options);)*
        }
    };
}

const POSE: Task = Task::new(Kind::Pose);
const AXIS_Z: Task = Task::new(Kind::PositionAxis(2));

arms! { published:
    Ur5 6 "ur5" "../specs/ur5.yaml" POSE;
    AbbIrb2400 6 "abb_irb2400" "../specs/abb_irb2400.yaml" POSE;
    Puma560 6 "puma560" "../specs/puma560.yaml" POSE;
    StaubliTx40 6 "staubli_tx40" "../specs/staubli_tx40.yaml" POSE;
    Stanford 6 "stanford" "../specs/stanford.yaml" POSE;
    KukaIiwa 7 "kuka_iiwa7_r800, q3 given" "../specs/kuka_iiwa7_r800.yaml" POSE.redundant(3);
    Al5d 4 "al5d" "../specs/al5d.yaml" Task::new(Kind::PositionAngle);
    Planar3r 3 "planar3r" "../specs/planar3r.yaml" Task::new(Kind::PlanarPose);
}

// Each has another structure: axes that meet or are parallel, joints that slide or are given, the task.
arms! { made_up:
    Meet123 6 "meet_123_a" "arms/meeting/meet_123_a.yaml" POSE;
    Meet234 6 "meet_234_a" "arms/meeting/meet_234_a.yaml" POSE;
    Meet345Square 6 "meet_345_square" "arms/meeting/meet_345_square.yaml" POSE;
    Meet456 6 "meet_456_a" "arms/meeting/meet_456_a.yaml" POSE;
    EqualLinks 6 "equal_links" "arms/meeting/equal_links.yaml" POSE;
    Wrist 6 "wrist_45_70" "arms/meeting/wrist_45_70.yaml" POSE;
    Parallel123 6 "parallel_123_a" "arms/parallel/parallel_123_a.yaml" POSE;
    Parallel234 6 "parallel_234_a" "arms/parallel/parallel_234_a.yaml" POSE;
    Parallel345Square 6 "parallel_345_square" "arms/parallel/parallel_345_square.yaml" POSE;
    Parallel456 6 "parallel_456_a" "arms/parallel/parallel_456_a.yaml" POSE;
    EqualLinksParallel 6 "equal_links_parallel" "arms/parallel/equal_links_parallel.yaml" POSE;
    SlideMeet123 6 "rrrrpr_meet_123" "arms/sliding/rrrrpr_meet_123.yaml" POSE;
    SlideMeet456 6 "rprrrr_meet_456" "arms/sliding/rprrrr_meet_456.yaml" POSE;
    SlideMeet234 6 "prrrrr_meet_234" "arms/sliding/prrrrr_meet_234.yaml" POSE;
    Gantry 6 "gantry_offset_wrist" "arms/sliding/gantry_offset_wrist.yaml" POSE;
    Rprprp 6 "rprprp" "arms/sliding/rprprp.yaml" POSE;
    SlideParallel234 6 "rrrrrp_parallel_234_square" "arms/sliding_parallel/rrrrrp_parallel_234_square.yaml" POSE;
    SlideParallel123 6 "rrrrpr_parallel_123" "arms/sliding_parallel/rrrrpr_parallel_123.yaml" POSE;
    SlideParallel456 6 "rprrrr_parallel_456" "arms/sliding_parallel/rprrrr_parallel_456.yaml" POSE;
    RailToStretch 6 "rail_to_stretch" "arms/sliding_parallel/rail_to_stretch.yaml" POSE;
    PumaOnARail 7 "puma_on_a_rail, q1 given" "arms/redundant_made_up/puma_on_a_rail.yaml" POSE.redundant(1);
    SkewParallel 7 "skew_parallel_234, q6 given" "arms/redundant_made_up/skew_parallel_234_q6.yaml" POSE.redundant(6);
    Scara 4 "scara_rrrp_mounted" "arms/pose_of_fewer_joints/scara_rrrp_mounted.yaml" POSE;
    ScorbotOffsets 5 "scorbot_offsets" "arms/pose_of_fewer_joints/scorbot_offsets.yaml" POSE;
    AxisMeet123 5 "meet_123_z" "arms/position_axis/meet_123_z.yaml" AXIS_Z;
    OffsetAxis 5 "pitches_and_offset_axis" "arms/position_axis/pitches_and_offset_axis.yaml" AXIS_Z;
    UrPointing 6 "ur_pointing, q6 given" "arms/position_redundant/ur_pointing_q6.yaml" AXIS_Z.redundant(6);
    RrrSkew 3 "rrr_skew" "arms/position/rrr_skew.yaml" Task::new(Kind::Position);
    YawPitch 4 "yaw_pitch_offsets" "arms/position_angle/yaw_pitch_offsets.yaml" Task::new(Kind::PositionAngle);
    Planar4r 4 "planar4r, q2 given" "arms/planar/planar4r_q2.yaml" Task::new(Kind::PlanarPose).redundant(2);
}

/// The targets that are ordinary, and those that have left the arm's reach.
const ORDINARY: &str = "random";
const BEYOND: [(&str, f64); 2] = [("out of reach by 1e-4", 1e-4), ("out of reach by 1e-2", 1e-2)];

#[derive(Clone, Copy)]
struct Options {
    /// Targets of a family, each of them also pushed.
    count: usize,
    /// How often each target is timed.
    passes: usize,
    /// How long its calls take each time, at least.
    steady: Duration,
}

/// A direction in which a target moves, a number for each equation.
type Twist = [f64; EQUATIONS];

fn table<A, const N: usize>(options: Options)
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked>,
{
    let (subject, arm) = (Subject::new::<A>(), A::default());
    let of = |goal: &Goal| A::Target::of(subject.task.kind, goal);
    let mut targets = Vec::new();
    let mut random = Random::named("tail");
    for (name, poses) in families(&subject, options.count, &mut random) {
        for q in &poses {
            let goal = subject.goal(q);
            let twist: Twist = std::array::from_fn(|_| random.uniform(-1.0, 1.0));
            let push = 10.0_f64.powi(random.below(12) as i32 - 13);
            targets.push((name.to_owned(), of(&goal)));
            targets.push((format!("{name}, pushed"), of(&subject.moved(&goal, &twist, push))));
        }
    }
    let tails: Vec<String> = names(&targets);
    let reaches = |goal: &Goal| A::status(&arm.inverse(&of(goal))).is_reachable();
    for _ in 0..options.count {
        let start = subject.goal(&Space::of(&subject).random(&mut random));
        let Some((edge, twist)) = edge(&subject, &start, &mut random, reaches) else { continue };
        for (name, push) in BEYOND {
            let goal = subject.moved(&edge, &twist, push);
            if !reaches(&goal) {
                targets.push((name.to_owned(), of(&goal)));
            }
        }
    }

    let times = least(&targets, options.passes, options.steady, |(_, target)| arm.inverse(target));
    let efforts: Vec<Effort> = targets.iter().map(|(_, target)| effort_of(|| arm.inverse(target)).1).collect();
    let line = |title: &str, unit: f64, counts: &dyn Fn(&str) -> bool| {
        let chosen = || (0..targets.len()).filter(|index| counts(&targets[*index].0));
        if chosen().next().is_none() {
            return;
        }
        let Tail { median, hundredth, thousandth, worst } = Tail::of(chosen().map(|index| times[index] / unit));
        let most = |of: fn(&Effort) -> usize| chosen().map(|index| of(&efforts[index])).max().unwrap_or(0);
        let (cascades, evaluations) = (most(|effort| effort.cascades), most(|effort| effort.evaluations));
        println!(
            "  {title:<41} {:>6} {median:>7.2} {hundredth:>7.1} {thousandth:>7.1} {worst:>7.1} {cascades:>8} \
             {evaluations:>11}",
            chosen().count(),
        );
    };
    let ordinary = Tail::of((0..targets.len()).filter(|index| targets[*index].0 == ORDINARY).map(|index| times[index]));
    println!(
        "{:<26} ordinary {:>5.0} ns {:>6} {:>7} {:>7} {:>7} {:>7} {:>8} {:>11}",
        subject.name, ordinary.median, "calls", "median", "99 %", "99.9 %", "worst", "cascades", "evaluations",
    );
    for name in &tails {
        line(name, ordinary.median, &|other| other == name);
    }
    line("all of these", ordinary.median, &|name| tails.iter().any(|other| other == name));
    for (name, _) in BEYOND {
        line(name, ordinary.median, &|other| other == name);
    }
    println!();
}

/// The families, `count` joint vectors of each.
fn families<const N: usize>(
    subject: &Subject<N>,
    count: usize,
    random: &mut Random,
) -> Vec<(&'static str, Vec<[f64; N]>)> {
    let space = Space::of(subject);
    let mut families = vec![
        (ORDINARY, (0..count).map(|_| space.random(random)).collect()),
        ("90 degree grid", space.grid_samples(4, count, random)),
        ("45 degree grid", space.grid_samples(8, count, random)),
    ];
    let singular = [
        space.two_special(random),
        space.three_special(random),
        space.all_special(random),
        singular_surface(subject, SURFACE, random),
    ];
    for family in singular.iter().filter(|family| !family.poses.is_empty()) {
        families.push((family.name, (0..count).map(|_| random.pick(&family.poses)).collect()));
    }
    families
}

/// The names in order, each once.
fn names<T>(targets: &[(String, T)]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (name, _) in targets {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}

/// The place where a target whose point moves in a random direction leaves the arm's reach. The second value is that
/// direction, of length 1. `None` if the target stays in reach.
fn edge<const N: usize>(
    subject: &Subject<N>,
    start: &Goal,
    random: &mut Random,
    reaches: impl Fn(&Goal) -> bool,
) -> Option<(Goal, Twist)> {
    const STEPS: usize = 50;
    let [x, y, z] = random.direction();
    let [x, y, z] = match subject.task.is_planar() {
        false => [x, y, z],
        true => [x / x.hypot(y), y / x.hypot(y), 0.0],
    };
    let mut twist = Twist::default();
    for (entry, component) in twist.iter_mut().zip([x, y, z]) {
        *entry = component;
    }
    let at = |size: f64| subject.moved(start, &twist, size);
    let size = |k: usize| 2.5 * k as f64 / STEPS as f64;
    let outside = (1..=STEPS).find(|k| !reaches(&at(size(*k))))?;
    let (mut inside, mut outside) = (size(outside - 1), size(outside));
    for _ in 0..60 {
        let middle = 0.5 * (inside + outside);
        if reaches(&at(middle)) { inside = middle } else { outside = middle }
    }
    Some((at(inside), twist))
}

fn main() {
    // `cargo test --benches` passes --test: a few targets show that it runs.
    let short = std::env::args().any(|argument| argument == "--test");
    let steady = Duration::from_micros(4);
    let options =
        if short { Options { count: 10, passes: 1, steady } } else { Options { count: 2000, passes: 9, steady } };
    published(options);
    made_up(options);
}
