//! Seven joints whose shoulder axes and whose wrist axes intersect, with the arm angle given.
//!
//! The elbow follows from the distance between shoulder and wrist. The upper arm's rotation follows from the wrist center
//! of the target and the arm angle. Shoulder and wrist are triples that give a rotation each.

use super::kernel::Unit;
use super::loop_chain::LoopChain;
use super::loop_closure::LoopClosure;
use super::plan::{Branching, Plan, PlanStep};
use super::rank;
use super::sides::Side;
use super::task::{Goal, PlanTask, SwivelConstants};
use super::triple;
use super::unsupported::Unsupported;
use crate::model::chain::Chain;
use crate::model::geometry::{Line, Triple, TripleKind, foot};
use crate::model::numeric::Transform;
use crate::model::{Model, Redundant};
use crate::symbolic::{Expr, Rigid, transpose};

/// The plan, or why the arm has no arm angle.
///
/// # Errors
/// If there are not seven joints that turn, three axes intersecting at the shoulder and three at the wrist; if the arm is
/// singular everywhere.
pub fn plan(mut joints: LoopChain, model: &Model, chain: &Chain) -> Result<Plan, Unsupported> {
    let triples = joints.triples();
    let meets = |first: usize| triples.contains(&Triple { first, kind: TripleKind::Intersecting });
    let seven = joints.loop_joints.len() == 7 && joints.loop_joints.iter().all(|slot| slot.revolute);
    if !(seven && meets(0) && meets(4)) {
        return Err(Unsupported::new(
            "an arm angle needs seven joints that turn, axes 1, 2, 3 meeting in a point and axes 5, 6, 7 in another",
        ));
    }
    let Some(first) = first_in_a_row(&joints) else {
        return Err(Unsupported::new(
            "an arm angle needs its seven joints in a row: no joint between them may be given",
        ));
    };
    rank::check_redundant(&joints)?;
    let names = [["u11", "u12", "u13"], ["u21", "u22", "u23"], ["u31", "u32", "u33"]];
    let swung = names.map(|row| row.map(|name| joints.g.symbol(name)));
    let shoulder = Triple { first: 0, kind: TripleKind::Intersecting };
    let (given, reach) = (joints.given.clone(), joints.reach);
    let mut c = LoopClosure::new(joints, shoulder);
    c.move_to_intersection();
    // Both triples with their intersection as origin.
    c.move_triple_to_intersection([3, 4, 5, 6]);
    let flange = c.link(6).back;
    let wrist = flange.p;
    let upper = c.link(2);
    let elbow = Side {
        joint: 3,
        undone: false,
        revolute: true,
        moved: c.clean3(c.link(3).forward.p, Unit::Length),
        origin: c.clean3(upper.back.p, Unit::Length),
        axis: upper.back.z(),
    };
    c.g.name_each(&wrist, "wrist_");
    let rho = c.g.norm(&wrist);
    let label = c.label(3);
    c.g.name(rho, format!("rho{label}"));
    let meaning = format!(
        "Joint {label}: the wrist center is `{{rho}}` from the shoulder, `{{rho}}^2 = a^2 + b^2 + h^2 + 2 a b cos(t)` \
                   with `a = {{a}}`, `b = {{b}}`, `h = {{h}}`{{shift}}."
    );
    elbow.distance(&mut c, rho, false, meaning);
    let turned = elbow.point(&mut c);
    let moved = upper.forward.point(&mut c.g, turned);
    let axis = upper.forward.z();
    let along = c.g.dot3(upper.forward.p, axis);
    let foot = c.g.scale3(along, axis);
    let foot = c.g.sub3(upper.forward.p, foot);
    let foot = c.clean3(foot, Unit::Length);
    c.push(PlanStep::Swivel {
        rotation: swung,
        joints: [0, 1],
        meaning: "Rotation of the upper arm, frame 3 in frame 0: the wrist where it has to be, the elbow swung by the \
                  arm angle."
            .into(),
        wrist,
        moved,
        axis,
        elbow: foot,
    });
    triple::rotation(&mut c, &swung, [0, 1, 2], Branching::Shoulder);
    // (upper arm, elbow, forearm)^T flange
    let pair = c.pair(3);
    let turn = Rigid { r: c.g.rotation_z(pair), p: [Expr::ZERO; 3] };
    let fore = upper.forward.then(&mut c.g, &turn);
    let link = c.link(3).forward;
    let fore = fore.then(&mut c.g, &link);
    let seen = c.g.matmul(&transpose(&swung), &flange.r);
    let left = c.g.matmul(&transpose(&fore.r), &seen);
    triple::rotation(&mut c, &left, [4, 5, 6], Branching::Wrist);
    Ok(c.finish(
        shoulder,
        PlanTask { swivel: constants(model, chain, reach, first), ..PlanTask::new(Goal::Pose, given) },
    ))
}

/// The first of the joints, from 0, if they follow one another in the arm.
fn first_in_a_row(joints: &LoopChain) -> Option<usize> {
    let places: Option<Vec<usize>> = joints.loop_joints.iter().map(|slot| slot.label.arm()).collect();
    let places = places?;
    let first = *places.first()?;
    places.iter().copied().eq(first..first + places.len()).then_some(first)
}

/// Where shoulder, wrist and elbow axis lie, as numbers; `first`: the first of the seven joints.
fn constants(model: &Model, chain: &Chain, reach: f64, first: usize) -> Option<SwivelConstants> {
    let whole = LoopChain::new(model, chain, reach, &Redundant::default());
    let sample = whole.generic.samples().first()?;
    let (axes, _) = whole.axes_and_tool(sample, 0);
    // The link that carries the shoulder, and the first joint's frame in it.
    let carrier = first.checked_sub(1).map_or(Transform::IDENTITY, |joint| whole.body(chain, joint));
    let own = whole.frame_before(first, sample);
    let frame = Transform::of_columns([0, 1, 2].map(|j| carrier.turned_back(own.axis(j))), [0.0; 3]).r;
    let shoulder = carrier.seen(intersection_point(&axes, first)?);
    let wrist = intersection_point(&axes, first + 4)?;
    let body = whole.body(chain, first + 3);
    let elbow = axes.get(first + 3)?;
    Some(SwivelConstants {
        first,
        shoulder: Transform { r: frame.map(|row| as_written(row, 1.0)), p: as_written(shoulder, reach) },
        wrist: as_written(body.seen(wrist), reach),
        axis: as_written(body.turned_back(elbow.direction), 1.0),
        elbow: as_written(body.seen(elbow.point), reach),
    })
}

/// Numbers without the rounding that computing them left: none beside `scale`, and else to 14 digits.
fn as_written(v: [f64; 3], scale: f64) -> [f64; 3] {
    v.map(|x| {
        let unit = 1e-14 * scale;
        if x.abs() < unit { 0.0 } else { format!("{x:.13e}").parse().unwrap_or(x) }
    })
}

/// Where two consecutive axes intersect.
fn intersection_point(axes: &[Line], first: usize) -> Option<[f64; 3]> {
    foot(axes.get(first)?, axes.get(first + 1)?)
}
