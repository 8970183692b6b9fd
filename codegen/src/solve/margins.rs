//! How far a joint vector is from each kind of singularity: the factors of the Jacobian's determinant.
//!
//! The stages of a plan are six equations `f(target, q) = 0`, each in the joints of its stage and of those before it.
//! Where they hold, `df/dq` is block triangular, and `det J = det(df/dq) / det(df/dtarget)` up to sign. The equations are
//! coordinates of a point (Cartesian, or cylindrical with half the squared distance as one of them), of a direction
//! (height and azimuth on the unit sphere), or of a rotation, so the denominator is constant; the determinant is a
//! constant times the product of the stages' own derivatives, the pivots. Each vanishes exactly where two roots of its
//! stage meet.

use super::plan::{Branching, Kernel, Phase, Plan, Stage, Unit};
use crate::model::Task;
use crate::model::geometry::TripleKind;
use crate::symbolic::{Expr, Graph, Node, Pair, Vec3, transpose};

/// A pivot: `value / reach^power` has no unit.
#[derive(Debug, Clone)]
pub struct Factor {
    /// What it is a margin of: shoulder, elbow, wrist, or the stage's joints.
    pub name: String,
    /// The derivative, in the target's entries and the sines and cosines of the kernels' variables.
    pub value: Expr,
    /// How many lengths it is a product of.
    pub power: u32,
}

/// The factors that are not constant, in the order of the stages, and the graph they are in. None where there are more
/// equations than joints, or where what is read of the target is no entry of the tool's pose (a pointing axis).
pub fn margins(plan: &Plan) -> (Graph, Vec<Factor>) {
    let mut g = plan.graph.clone();
    let mut factors = Vec::new();
    if plan.task.overdetermined || plan.task.task == Task::PositionAxis {
        return (g, factors);
    }
    let wanted = |slot: &usize| plan.slots.get(*slot).is_some_and(|slot| slot.joint.is_some());
    for (index, stage) in plan.stages().enumerate() {
        let given_before = index > 0 && only_follows(plan, stage);
        if given_before || !stage.joints.iter().any(wanted) {
            continue;
        }
        let (value, power) = stage.pivot.map_or_else(|| pivot(&mut g, plan, stage), |value| (value, 1));
        if g.constant(value).is_none() {
            let joints: Vec<String> = stage.joints.iter().map(|joint| format!("q{}", plan.label(*joint))).collect();
            let name = match stage.branching {
                Branching::Shoulder => "shoulder".into(),
                Branching::Elbow => "elbow".into(),
                Branching::Wrist => "wrist".into(),
                Branching::None | Branching::Root => joints.join(" "),
            };
            factors.push(Factor { name, value, power });
        }
    }
    (g, factors)
}

/// A stage after the first that gives a second stroke: the determinant of both is the first one's pivot.
fn only_follows(plan: &Plan, stage: &Stage) -> bool {
    let slides = matches!(stage.kernel, Kernel::SlideTo { .. });
    let first = |stage: &Stage| matches!(stage.kernel, Kernel::SlideTo { .. });
    slides
        && match plan.triple.kind {
            TripleKind::Meeting => !stage.joints.contains(&between(plan)),
            TripleKind::Turning => {
                plan.stages().find(|stage| first(stage)).is_some_and(|first| first.joints != stage.joints)
            }
            TripleKind::Parallel => false,
        }
}

/// Joint y: the middle one of the three outside the triple.
fn between(plan: &Plan) -> usize {
    (plan.triple.first + 4) % 6
}

fn pivot(g: &mut Graph, plan: &Plan, stage: &Stage) -> (Expr, u32) {
    let [first, second] = [0, 1].map(|place| stage.joints.get(place).copied().unwrap_or(0));
    let length = u32::from(stage.unit == Unit::Length);
    match &stage.kernel {
        // An angle, whose derivative is 1.
        Kernel::Align { .. } | Kernel::OffsetOfTwo { .. } => (Expr::ONE, 0),
        Kernel::SlideTo { denominator, .. } => (*denominator, 0),
        Kernel::Offset { a, b, .. } => {
            let t = variable(g, plan, first);
            (derivative(g, [*a, *b], t), length)
        }
        Kernel::SlideTurning { stroke: [sx, sy], rows: [[a1, b1, _], [a2, b2, _]] } => {
            let t = variable(g, plan, first);
            let (first, second) = (derivative(g, [*a1, *b1], t), derivative(g, [*a2, *b2], t));
            let (left, right) = (g.mul(*sx, second), g.mul(*sy, first));
            (g.sub(left, right), 1)
        }
        Kernel::Distance { about, .. } => about_sine(g, plan, first, about, 2),
        Kernel::Cone { about, .. } => about_sine(g, plan, first, about, length),
        Kernel::Flip { .. } => (variable(g, plan, first).sin, 0),
        Kernel::Wrist { .. } => (variable(g, plan, second).sin, 0),
        Kernel::Slide { middle, .. } => {
            let position = g.symbol(format!("q{}", plan.label(first)));
            (g.sub(position, *middle), 1)
        }
        Kernel::Quadratic { coefficients: [a, b, _] } => {
            let position = g.symbol(format!("q{}", plan.label(first)));
            let ax = g.mul(*a, position);
            let twice = g.add(ax, ax);
            (g.add(twice, *b), 1)
        }
        Kernel::Aim { moved: [_, moved], frames: [[_, _, nx], frame] } => {
            let [_, _, nz] = *frame;
            let t = variable(g, plan, second);
            let seen = g.rotate_z(t, *moved);
            let h = g.apply3(&transpose(frame), seen);
            let normal = cross(g, *nx, nz);
            (g.dot3(normal, h), 0)
        }
        Kernel::Pair { p: [p1, p2], q: [q1, q2], .. } => {
            let (x, z) = (variable(g, plan, first), variable(g, plan, second));
            let slope = |g: &mut Graph, [c, s, _]: [Expr; 3], t: Pair| derivative(g, [c, s], t);
            let (px, qx) = (slope(g, *p1, x), slope(g, *p2, x));
            let (pz, qz) = (slope(g, *q1, z), slope(g, *q2, z));
            let (left, right) = (g.mul(px, qz), g.mul(qx, pz));
            (g.sub(left, right), pair_power(plan))
        }
        Kernel::PairSliding { line: [lc, ls, _], scale, square: [m, _], q: [qc, qs, _], .. } => {
            let position = g.symbol(format!("q{}", plan.label(first)));
            let z = variable(g, plan, second);
            let (line, square) = (derivative(g, [*lc, *ls], z), derivative(g, [*qc, *qs], z));
            let twice = g.add(position, position);
            let own = g.add(twice, *m);
            let (left, right) = (g.mul(line, own), g.mul(*scale, square));
            (g.sub(left, right), 2)
        }
    }
}

/// Lengths in the determinant of a pair: of a meeting point the component and the squared distance, or across a sliding
/// joint two components; of parallel axes a direction and a length.
fn pair_power(plan: &Plan) -> u32 {
    let across = plan.values.get(between(plan)).is_some_and(|value| value.sliding);
    match (plan.triple.kind, across) {
        (TripleKind::Parallel | TripleKind::Turning, _) => 1,
        (TripleKind::Meeting, true) => 2,
        (TripleKind::Meeting, false) => 3,
    }
}

/// Sine and cosine of a kernel's variable, by the names the stages use.
fn variable(g: &mut Graph, plan: &Plan, joint: usize) -> Pair {
    let number = plan.label(joint);
    let named = [format!("sin_t{number}"), format!("cos_t{number}")];
    let used = plan.graph.reachable(&plan.inputs()).into_iter().any(|e| match plan.graph.node(e) {
        Node::Symbol(symbol) => named.contains(&symbol.name),
        _ => false,
    });
    let [sin, cos] = if used { named } else { [format!("s{number}"), format!("c{number}")] };
    Pair { sin: g.symbol(sin), cos: g.symbol(cos) }
}

/// Of `a cos + b sin`: `b cos - a sin`.
fn derivative(g: &mut Graph, [a, b]: [Expr; 2], t: Pair) -> Expr {
    let (left, right) = (g.mul(b, t.cos), g.mul(a, t.sin));
    g.sub(left, right)
}

/// The sine of the angle from where the roots meet; if that place is only known at run time, times the length of the
/// vector that tells it, which is the product of the two radii.
fn about_sine(g: &mut Graph, plan: &Plan, joint: usize, about: &Option<Phase>, power: u32) -> (Expr, u32) {
    let t = variable(g, plan, joint);
    match about {
        None => (t.sin, 0),
        Some(Phase { y, x }) => {
            let (left, right) = (g.mul(*x, t.sin), g.mul(*y, t.cos));
            (g.sub(left, right), power)
        }
    }
}

fn cross(g: &mut Graph, [a, b, c]: Vec3, [d, e, f]: Vec3) -> Vec3 {
    let mut minor = |a: Expr, b: Expr, c: Expr, d: Expr| {
        let (left, right) = (g.mul(a, d), g.mul(b, c));
        g.sub(left, right)
    };
    [minor(b, c, e, f), minor(c, a, f, d), minor(a, b, d, e)]
}
