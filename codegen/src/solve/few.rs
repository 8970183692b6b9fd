//! Arms with four or five joints: a plane that yaws, and one that stays upright (SCARA, gantry).

use super::asked::PlanTask;
use super::closure::{Closure, Link};
use super::plan::{Branching, Kernel, Plan, PlanStep, Unit};
use super::problem::Problem;
use super::rows::turned_back;
use super::sides::Side;
use super::{Refusal, planar, triple};
use crate::model::geometry::{Triple, TripleKind};
use crate::model::{Angle, Task};
use crate::symbolic::{Expr, Graph, Pair, Rigid, Vec3, transpose};

/// A yaw joint and three parallel pitch joints across it, whatever follows.
pub fn yaws_and_pitches(problem: &Problem) -> bool {
    let turns = problem.slots.iter().take(4).all(|slot| slot.turns);
    let parallel = problem.triples().contains(&Triple { first: 1, kind: TripleKind::Parallel });
    turns && problem.slots.len() >= 4 && parallel && problem.keeps_axis(1).is_none()
}

/// A yaw joint and three that move in a plane which it turns: parallel axes, or some of the joints sliding across them.
pub fn yaws_a_plane(problem: &Problem) -> bool {
    let yaws = problem.slots.first().is_some_and(|slot| slot.turns);
    let pitches = (1..4).find(|i| problem.slots.get(*i).is_some_and(|slot| slot.turns));
    let plane = problem.triples().contains(&Triple { first: 1, kind: TripleKind::Parallel });
    yaws && problem.slots.len() == 4 && plane && pitches.is_some_and(|pitch| !problem.are_parallel(0, pitch))
}

/// What the yaw joint leaves of the chain: `n`, the pitch axis before the yaw, and how far along it the chain ends, both
/// from what they are in the frame behind it.
fn across_plane(c: &mut Closure, pitch: Vec3, end: Vec3) -> (Vec3, Expr) {
    let yaw = c.link(0).forward;
    let n = c.g.apply3(&yaw.r, pitch);
    let n = c.clean3(n, Unit::Direction);
    let (offset, ends) = (c.g.dot3(n, yaw.p), c.g.dot3(pitch, end));
    let value = c.g.add(offset, ends);
    (n, c.clean(value, Unit::Length))
}

/// The pitch axis in the frame of joint 1.
const PITCH: Vec3 = [Expr::ZERO, Expr::ZERO, Expr::ONE];

/// A point and the sum of the pitch joints.
pub fn position_angle(mut problem: Problem, task: PlanTask) -> Result<Plan, Refusal> {
    // The tool counts with the plane: only a point is given.
    let tool = problem.take_tool();
    problem.probe.angle(["angle", "sin_angle", "cos_angle"]);
    problem.target.r = Graph::identity();
    let offsets: Vec<Angle> = problem.slots.iter().map(|slot| slot.offset).collect();
    let triple = Triple { first: 1, kind: TripleKind::Parallel };
    let mut c = Closure::new(problem, triple);
    let (link_a, link_b) = (c.link(1).forward, c.link(2).forward);
    let plane = link_a.then(&mut c.g, &link_b);
    // The frame of the first pitch joint, in that of joint 1.
    let frames = [Rigid::identity(), link_a, plane].map(|frame| frame.r);
    let turns = [1, 2, 3].map(|joint| c.turns(joint));
    let upright = frames.iter().zip(turns).find(|(_, turns)| *turns).map_or(Graph::identity(), |(frame, _)| *frame);
    let pitch = upright.map(|[_, _, z]| z);
    let end = plane.point(&mut c.g, tool.p);
    let point = c.link(3).back.p;
    let (n, value) = across_plane(&mut c, pitch, end);
    let row = turned_back(&mut c.g, n, point, Expr::ZERO);
    let label = c.label(0);
    let meaning =
        format!("Joint {label}: the tool point keeps its offset across the plane, `{{a}} cos + {{b}} sin = {{d}}`.");
    let d = c.g.sub(value, row.k);
    let kernel = Kernel::Offset { a: row.c, b: row.s, d };
    c.stage(&[(0, Angle::ZERO)], 0, Unit::Length, Branching::Shoulder, meaning, kernel);
    // Rotation of the plane: the angle about the pitch axis, and the constant turns of the links.
    let known = Pair { sin: c.g.symbol("sin_angle"), cos: c.g.symbol("cos_angle") };
    let columns = transpose(&plane.r).map(|axis| {
        let axis = c.g.apply3(&transpose(&upright), axis);
        let axis = c.g.rotate_z(known, axis);
        c.g.apply3(&upright, axis)
    });
    let r = transpose(&columns);
    let seen = c.move_back(0, point);
    let seen = c.link(0).back.point(&mut c.g, seen);
    let arm = c.g.apply3(&r, tool.p);
    let back = Rigid { r, p: c.g.sub3(seen, arm) };
    let forward = back.inverse(&mut c.g);
    let rest = Link { forward, back, target: true };
    let links = [c.link(1), c.link(2), rest];
    planar::solve(&mut c, [1, 2, 3], links)?;
    let mut signs = vec![0.0];
    for (frame, turns) in frames.iter().zip(turns) {
        let along = c.g.dot3(pitch, frame.map(|[_, _, z]| z));
        signs.push(if turns { c.value(along).map_or(1.0, f64::signum) } else { 0.0 });
    }
    let constant = signs.iter().zip(&offsets).fold(Angle::ZERO, |sum, (sign, offset)| match *sign {
        0.0 => sum,
        sign if sign < 0.0 => sum.add(offset.neg()),
        _ => sum.add(*offset),
    });
    let task = PlanTask { angle: Some((signs, constant)), ..task };
    Ok(c.finish(triple, task))
}

/// A whole pose for a yaw joint, three pitch joints and perhaps a roll joint: more equations than joints.
pub fn yawing_pose(problem: Problem, task: PlanTask) -> Result<Plan, Refusal> {
    let rolls = problem.slots.len() == 5;
    let triple = Triple { first: 1, kind: TripleKind::Parallel };
    let mut c = Closure::new(problem, triple);
    let last = if rolls { 4 } else { 3 };
    let flange = c.link(last).back;
    let (link_a, link_b) = (c.link(1).forward, c.link(2).forward);
    let plane = link_a.then(&mut c.g, &link_b);
    let label = c.label(0);
    if rolls {
        let link = c.link(3).forward;
        let outer = plane.then(&mut c.g, &link);
        if c.vanish(&Side::plane(c.link(3).back.z()), Unit::Direction) {
            return Err(Refusal::new("joints 4 and 5 turn about parallel axes: the arm cannot leave its plane"));
        }
        let (n, value) = across_plane(&mut c, PITCH, outer.p);
        let length = turned_back(&mut c.g, n, flange.p, Expr::ZERO);
        let direction = turned_back(&mut c.g, n, flange.z(), Expr::ZERO);
        let cosine = c.clean(Side::along(outer.z()), Unit::Direction);
        let row = |c: &mut Closure, row: super::rows::Row, value: Expr| [row.c, row.s, c.g.sub(value, row.k)];
        let kernel =
            Kernel::OffsetOfTwo { length: row(&mut c, length, value), direction: row(&mut c, direction, cosine) };
        let meaning = format!("Joint {label}: axis 5 keeps its offset and its angle to the plane of the pitch joints.");
        c.stage(&[(0, Angle::ZERO)], 0, Unit::Length, Branching::Shoulder, meaning, kernel);
        // The pitch axis as the flange sees it, and as the roll joint does.
        let seen = c.move_by(0, n);
        let seen = c.g.apply3(&flange.transposed(), seen);
        let sign = c.value(Side::along(plane.z())).map_or(1.0, f64::signum);
        let own = c.link(3).back.z().map(|e| if sign < 0.0 { c.g.neg(e) } else { e });
        let meaning = "Joint 5: turns the pitch axis from `[{from}]` to `[{to}]`.".to_string();
        let kernel = Kernel::Align { from: Side::plane(seen), to: Side::plane(own) };
        c.stage(&[(4, Angle::ZERO)], 4, Unit::Direction, Branching::None, meaning, kernel);
    } else {
        // The tool has the pitch axis fixed in it.
        let sign = c.value(Side::along(plane.z())).map_or(1.0, f64::signum);
        let axis = flange.z().map(|e| if sign < 0.0 { c.g.neg(e) } else { e });
        let n = c.clean3(c.link(0).forward.z(), Unit::Direction);
        let kernel = Kernel::Align { from: Side::plane(n), to: Side::plane(axis) };
        let meaning = format!("Joint {label}: turns the pitch axis from `[{{from}}]` to `[{{to}}]`.");
        c.stage(&[(0, Angle::ZERO)], 0, Unit::Direction, Branching::None, meaning, kernel);
        let miss = c.g.sub(Side::along(axis), Side::along(n));
        agreement(&mut c, "The pitch axis keeps its angle to the first axis.", Unit::Direction, vec![miss]);
        let (n, value) = across_plane(&mut c, PITCH, plane.p);
        let seen = c.move_back(0, flange.p);
        let offset = c.g.dot3(n, seen);
        let miss = c.g.sub(offset, value);
        agreement(&mut c, "The tool keeps its offset across the plane.", Unit::Length, vec![miss]);
    }
    triple::parallel(&mut c)?;
    Ok(c.finish(triple, PlanTask { overdetermined: true, ..task }))
}

/// A whole pose for three joints that move in a plane and a stroke across it.
pub fn upright_pose(problem: Problem, task: PlanTask) -> Result<Plan, Refusal> {
    let triple = Triple { first: 0, kind: TripleKind::Parallel };
    let mut c = Closure::new(problem, triple);
    let flange = c.link(3).back;
    let (link_a, link_b, link_c) = (c.link(0).forward, c.link(1).forward, c.link(2).forward);
    let still = link_a.then(&mut c.g, &link_b).then(&mut c.g, &link_c);
    // The stroke's direction in the frame of the first joint, which no joint turns.
    let own = c.clean3(still.z(), Unit::Direction);
    let (height, before) = (c.g.dot3(own, flange.p), c.g.dot3(own, still.p));
    let kernel = Kernel::SlideTo { denominator: Expr::ONE, numerator: c.g.sub(height, before) };
    let label = c.label(3);
    let meaning = format!("Joint {label}: the height of the tool.");
    c.stage(&[(3, Angle::ZERO)], 3, Unit::Length, Branching::None, meaning, kernel);
    let misses = c.g.sub3(flange.z(), own).to_vec();
    agreement(&mut c, "The stroke is parallel to the joints' axes.", Unit::Direction, misses);
    triple::parallel(&mut c)?;
    Ok(c.finish(triple, PlanTask { overdetermined: true, ..task }))
}

/// Equations that no joint can meet. They hold for what the arm can reach, and are kept for what it cannot.
fn agreement(c: &mut Closure, meaning: &str, unit: Unit, misses: Vec<Expr>) {
    c.push(PlanStep::Agreement { meaning: meaning.into(), unit, misses });
}

/// A pose or a point in the plane.
pub fn in_plane(mut problem: Problem, task: PlanTask) -> Result<Plan, Refusal> {
    let twist = if task.task == Task::PlanarPose { problem.tool_twist() } else { Some(Angle::ZERO) };
    let (true, Some(twist)) = (problem.is_planar(), twist) else {
        return Err(Refusal::new(format!(
            "the task `{}` needs axes parallel to the base z axis (sliding joints across it){}",
            task.task.name(),
            if task.task == Task::PlanarPose { " and a tool whose x axis lies in the plane" } else { "" }
        )));
    };
    problem.target.p = [problem.g.symbol("px"), problem.g.symbol("py"), Expr::ZERO];
    if task.task == Task::PlanarPose {
        problem.probe.angle(["phi", "sin_phi", "cos_phi"]);
        let phi = Pair { sin: problem.g.symbol("sin_phi"), cos: problem.g.symbol("cos_phi") };
        let twist = problem.g.constant_pair(twist, "TOOL_TWIST");
        let columns = Graph::identity().map(|axis| {
            let axis = problem.g.rotate_x(twist, axis);
            problem.g.rotate_z(phi, axis)
        });
        problem.target.r = transpose(&columns);
    } else {
        // The tool point alone: its frame turns on a virtual joint about z of the base.
        problem.target.r = Graph::identity();
        problem.append_upright();
    }
    let triple = Triple { first: 0, kind: TripleKind::Parallel };
    let mut c = Closure::new(problem, triple);
    let links = [c.link(0), c.link(1), c.link(2)];
    planar::solve(&mut c, [0, 1, 2], links)?;
    Ok(c.finish(triple, task))
}
