//! How far a joint vector is from each kind of singularity: the factors of the Jacobian's determinant.
//!
//! The stages of a plan are six equations `f(target, q) = 0`, each in the joints of its stage and of those before it.
//! Where they hold, `df/dq` is block triangular, and `det J = det(df/dq) / det(df/dtarget)` up to sign.
//!
//! The equations are coordinates of a point, of a direction (height and azimuth on the unit sphere), or of a rotation. Those
//! of a point are Cartesian, or cylindrical with half the squared distance as one of them. So the denominator is constant:
//! the determinant is a constant times the product of the stages' own derivatives, the pivots. Each vanishes exactly where
//! two roots of its stage are equal.

use super::kernel::{Kernel, Pivot};
use super::plan::{Branching, Plan, Stage};
use crate::model::Task;
use crate::model::geometry::TripleKind;
use crate::symbolic::{Expr, Graph};

/// A pivot: `value / reach^power` has no unit.
#[derive(Debug, Clone)]
pub struct Factor {
    /// Name of the margin: shoulder, elbow, wrist, or the stage's joints.
    pub name: String,
    /// The name of the two branches that its signs tell apart.
    pub branching: Branching,
    /// The derivative, in the target's entries and the sines and cosines of the kernels' variables.
    pub value: Expr,
    /// How many lengths it is a product of.
    pub power: u32,
}

/// The factors that are not constant, in the order of the stages, and the graph they are in. None where there are more
/// equations than joints, none for a pointing axis, whose target is no entry of the tool's pose, and none for the equations of a measured arm's table.
pub fn margins(plan: &Plan) -> (Graph, Vec<Factor>) {
    let mut g = plan.graph.clone();
    let mut factors = Vec::new();
    if plan.off_table.is_some() || plan.task.overdetermined || plan.task.goal.task() == Task::PositionAxis {
        return (g, factors);
    }
    for (index, stage) in plan.stages().enumerate() {
        let given_before = index > 0 && only_follows(plan, stage);
        if given_before || stage.joints.iter().all(|slot| plan.joint(*slot).is_none()) {
            continue;
        }
        let own = |g: &mut Graph| stage.kernel.pivot(g, &stage.variables());
        let Pivot { value, power } = stage.pivot.map_or_else(|| own(&mut g), |value| Pivot { value, power: 1 });
        if g.constant(value).is_none() {
            let joints: Vec<String> = plan.labels(stage).iter().map(|label| format!("q{label}")).collect();
            let name = match stage.branching {
                Branching::Shoulder => "shoulder".into(),
                Branching::Elbow => "elbow".into(),
                Branching::Wrist => "wrist".into(),
                Branching::None | Branching::Root => joints.join(" "),
            };
            factors.push(Factor { name, branching: stage.branching, value, power });
        }
    }
    (g, factors)
}

/// The plan of a measured arm's table with its own margins, if their signs name branches of a pose.
pub fn naming_table(plan: &Plan) -> Option<Plan> {
    let plan = Plan { missed: None, off_table: None, ..plan.clone() };
    let named = |factor: &Factor| !matches!(factor.branching, Branching::None | Branching::Root);
    let names = plan.task.goal.task() == Task::Pose && margins(&plan).1.iter().any(named);
    names.then_some(plan)
}

/// A stage after the first that gives a second displacement: the determinant of both is the first one's pivot.
fn only_follows(plan: &Plan, stage: &Stage) -> bool {
    let linear = |stage: &Stage| matches!(stage.kernel, Kernel::SlideTo(_));
    linear(stage)
        && match plan.triple.kind {
            TripleKind::Intersecting => !stage.joints.contains(&between(plan)),
            TripleKind::Turning => {
                plan.stages().find(|stage| linear(stage)).is_some_and(|first| first.joints != stage.joints)
            }
            TripleKind::Parallel => false,
        }
}

/// Joint y: the middle one of the three outside the triple.
fn between(plan: &Plan) -> usize {
    (plan.triple.first + 4) % 6
}
