//! An arm under test: its inverse beside the chain that judges it.

use denhart::{Chain, DhFrame, DhRow, DhTable, InverseKinematics, JointKind};
use nalgebra::{Isometry3, Matrix6xX, Translation3, UnitQuaternion, Vector3};

pub use crate::inverse::Answer;
use crate::inverse::{Derived, Inverse, Solver};
use crate::task::{Asked, EQUATIONS, Given, Goal, Kind, Pitch, Task, across, heading, tool_axis};

/// The constants of a derived arm, for code that is generic over the arm.
pub trait Specified<const N: usize>: denhart::Arm<f64, N> + Default + Send + Sync + 'static {
    /// Name of the arm in its file.
    const NAME: &'static str;
    /// Its table.
    const TABLE: DhTable;
    /// Task of its inverse.
    const TASK: Task = Task::new(Kind::Pose);
}

/// An arm under test.
pub struct Subject<const N: usize> {
    pub name: String,
    /// The judge.
    pub chain: Chain,
    /// Sum of `|a| + |d|`, base and tool offset, and the longest travel of the prismatic joints; 1 if that is 0. Every
    /// tolerance on a length is relative to it.
    pub reach: f64,
    pub kinds: [JointKind; N],
    pub limits: [[f64; 2]; N],
    pub max_solutions: usize,
    /// Task of the inverse.
    pub task: Task,
    pitch: Pitch<N>,
    solver: Box<dyn Solver<N>>,
}

impl<const N: usize> Subject<N> {
    /// The arm `A` with its generated inverse.
    pub fn new<A>() -> Self
    where
        A: Specified<N> + InverseKinematics<f64, N, Target: Asked>,
    {
        let inverse = Derived { arm: A::default(), kind: A::TASK.kind, one_branch: None };
        let reach = reach(&A::TABLE, &A::LIMITS);
        Self::of(A::NAME, Chain::from(A::TABLE), reach, A::LIMITS, A::TASK, A::MAX_SOLUTIONS, inverse)
    }

    /// An arm from its parts; `reach` as [`length`] has it.
    pub fn of(
        name: &str,
        chain: Chain,
        reach: f64,
        limits: [[f64; 2]; N],
        task: Task,
        max_solutions: usize,
        inverse: impl Inverse<N> + 'static,
    ) -> Self {
        let pitch = if task.kind == Kind::PositionAngle { Pitch::of(&chain) } else { Pitch::NONE };
        let kinds = chain.kinds().try_into().expect("the chain has as many joints as the arm");
        Self {
            name: name.to_owned(),
            chain,
            reach,
            kinds,
            limits,
            max_solutions,
            task,
            pitch,
            solver: Box::new(inverse),
        }
    }

    /// Every branch, by the arm under test.
    pub fn inverse(&self, goal: &Goal) -> Answer<N> {
        self.solver.inverse(goal)
    }

    /// Every branch next to `q_ref`, by the arm under test.
    pub fn inverse_near(&self, goal: &Goal, q_ref: &[f64; N]) -> Answer<N> {
        self.solver.inverse_near(goal, q_ref)
    }

    /// Goal that the arm reaches at `q`, by the chain.
    pub fn goal(&self, q: &[f64; N]) -> Goal {
        let given = Given::of(self.task.given.iter().map(|joint| q[joint]), 0.0);
        Goal { pose: self.pose(q), angle: self.pitch.angle(q), given }
    }

    /// Pose of the tool, by the chain.
    pub fn pose(&self, q: &[f64; N]) -> Isometry3<f64> {
        self.chain.forward(q).expect("the chain has as many joints as the arm")
    }

    /// Jacobian by the chain, with lengths measured in reaches: `[6, N]`, no unit.
    pub fn scaled_jacobian(&self, q: &[f64; N]) -> Matrix6xX<f64> {
        let mut jacobian = self.chain.jacobian(q).expect("the chain has as many joints as the arm");
        for joint in 0..N {
            let unit = self.unit(joint);
            for row in 0..6 {
                jacobian[(row, joint)] *= if row < 3 { unit / self.reach } else { unit };
            }
        }
        jacobian
    }

    /// How the equations of the task change with the joints: column by joint, lengths in reaches, rows as in
    /// [`error`](Self::error). A given joint has nothing but its own equation.
    pub fn columns(&self, q: &[f64; N]) -> [[f64; EQUATIONS]; N] {
        let jacobian = self.scaled_jacobian(q);
        let directions = match self.task.kind {
            Kind::PositionAxis(axis) => across(&tool_axis(&self.pose(q), axis)),
            _ => [Vector3::zeros(); 2],
        };
        std::array::from_fn(|joint| {
            let mut rows = [0.0; EQUATIONS];
            if let Some((row, _)) = self.given_rows().find(|(_, given)| *given == joint) {
                rows[row] = 1.0;
                return rows;
            }
            let column = jacobian.column(joint);
            let turn: Vector3<f64> = column.fixed_rows::<3>(3).into();
            match self.task.kind {
                Kind::Pose => rows[..6].copy_from_slice(column.as_slice()),
                Kind::Position | Kind::PositionAxis(_) | Kind::PositionAngle => {
                    rows[..3].copy_from_slice(&column.as_slice()[..3]);
                }
                Kind::PlanarPose | Kind::PlanarPosition => rows[..2].copy_from_slice(&column.as_slice()[..2]),
            }
            match self.task.kind {
                Kind::PositionAxis(_) => directions.iter().zip(3..).for_each(|(d, row)| rows[row] = d.dot(&turn)),
                Kind::PositionAngle => rows[3] = self.pitch.signs[joint],
                Kind::PlanarPose => rows[2] = turn.z,
                Kind::Pose | Kind::Position | Kind::PlanarPosition => {}
            }
            rows
        })
    }

    /// The rows of the given joints' equations, with the joints: the last ones.
    fn given_rows(&self) -> impl Iterator<Item = (usize, usize)> {
        let first = self.task.equations() - self.task.given.as_slice().len();
        (first..).zip(self.task.given.iter())
    }

    /// Error that is left from `q` to the goal, one number an equation: lengths relative to reach, angles in rad, to
    /// first order.
    pub fn error(&self, goal: &Goal, q: &[f64; N]) -> [f64; EQUATIONS] {
        let reached = self.pose(q);
        let shift = (goal.pose.translation.vector - reached.translation.vector) / self.reach;
        let mut rows = [0.0; EQUATIONS];
        rows[..3].copy_from_slice(shift.as_slice());
        match self.task.kind {
            Kind::Pose => {
                let turn = (goal.pose.rotation * reached.rotation.inverse()).scaled_axis();
                rows[3..6].copy_from_slice(turn.as_slice());
            }
            Kind::PositionAxis(axis) => {
                let [here, there] = [&reached, &goal.pose].map(|pose| tool_axis(pose, axis));
                let turn = here.cross(&there);
                across(&here).iter().zip(3..).for_each(|(direction, row)| rows[row] = direction.dot(&turn));
            }
            Kind::PositionAngle => rows[3] = wrap(goal.angle - self.pitch.angle(q)),
            Kind::PlanarPose => rows[2] = wrap(heading(&goal.pose) - heading(&reached)),
            Kind::PlanarPosition => rows[2] = 0.0,
            Kind::Position => {}
        }
        for ((row, joint), value) in self.given_rows().zip(goal.given.iter()) {
            rows[row] = self.difference(joint, value, q[joint]);
        }
        rows
    }

    /// The goal moved by `size` along `twist`, a number for each equation as in [`error`](Self::error).
    pub fn moved(&self, goal: &Goal, twist: &[f64; EQUATIONS], size: f64) -> Goal {
        let t = twist.map(|t| t * size);
        let mut moved = *goal;
        for ((row, joint), value) in self.given_rows().zip(moved.given.iter_mut()) {
            *value += t[row] * self.unit(joint);
        }
        let mut shift = Vector3::new(t[0], t[1], t[2]);
        let turn = match self.task.kind {
            Kind::Pose => Vector3::new(t[3], t[4], t[5]),
            Kind::PositionAxis(axis) => {
                let [first, second] = across(&tool_axis(&goal.pose, axis));
                t[3] * first + t[4] * second
            }
            Kind::PlanarPose => Vector3::new(0.0, 0.0, t[2]),
            Kind::Position | Kind::PositionAngle | Kind::PlanarPosition => Vector3::zeros(),
        };
        if self.task.is_planar() {
            shift.z = 0.0;
        }
        if self.task.kind == Kind::PositionAngle {
            moved.angle += t[3];
        }
        let position = goal.pose.translation.vector + shift * self.reach;
        let rotation = UnitQuaternion::from_scaled_axis(turn) * goal.pose.rotation;
        moved.pose = Isometry3::from_parts(Translation3::from(position), rotation);
        moved
    }

    /// How far `q` is from what is asked for: position in reaches, orientation in rad. A given joint that is not where
    /// it has to be counts as orientation.
    ///
    /// Angles are taken from sine and cosine, so that they are accurate down to rounding.
    pub fn miss(&self, goal: &Goal, q: &[f64; N]) -> [f64; 2] {
        let reached = self.pose(q);
        let mut shift = reached.translation.vector - goal.pose.translation.vector;
        if self.task.is_planar() {
            shift.z = 0.0;
        }
        let orientation = match self.task.kind {
            Kind::Pose => {
                let turn = goal.pose.rotation.rotation_to(&reached.rotation);
                2.0 * turn.vector().norm().atan2(turn.scalar().abs())
            }
            Kind::PositionAxis(axis) => {
                let [here, there] = [&reached, &goal.pose].map(|pose| tool_axis(pose, axis));
                here.cross(&there).norm().atan2(here.dot(&there))
            }
            Kind::PositionAngle => wrap(goal.angle - self.pitch.angle(q)).abs(),
            Kind::PlanarPose => wrap(heading(&goal.pose) - heading(&reached)).abs(),
            Kind::Position | Kind::PlanarPosition => 0.0,
        };
        let given = self.task.given.iter().zip(goal.given.iter());
        let displaced = given.fold(0.0, |most: f64, (joint, value)| {
            let off = self.difference(joint, value, q[joint]).abs();
            if off > most || off.is_nan() { off } else { most }
        });
        // A number that is none stays one, as `max` would not have it.
        [shift.norm() / self.reach, if displaced > orientation { displaced } else { orientation }]
    }

    /// The sum of the absolute values of the slides at `q`, over the reach, and at least 1. The sum is a factor on the
    /// reach: a slide at a thousand reaches cannot be given more finely than to a thousand roundings. The factor is 1
    /// within finite limits, because the reach includes the travel.
    pub fn extension(&self, q: &[f64; N]) -> f64 {
        let slides = (0..N).filter(|&joint| self.kinds[joint] == JointKind::Prismatic);
        slides.map(|joint| q[joint].abs() / self.reach).sum::<f64>().max(1.0)
    }

    /// `a - b` of joint `joint` where whole turns are the same angle; a prismatic joint in reaches.
    pub fn difference(&self, joint: usize, a: f64, b: f64) -> f64 {
        match self.kinds[joint] {
            JointKind::Revolute => wrap(a - b),
            JointKind::Prismatic | JointKind::Fixed => (a - b) / self.reach,
        }
    }

    /// Largest difference of two joint vectors over the joints that `counts` names, whole turns apart.
    pub fn distance(&self, a: &[f64; N], b: &[f64; N], counts: impl Fn(usize) -> bool) -> f64 {
        largest((0..N).filter(|&joint| counts(joint)).map(|joint| self.difference(joint, a[joint], b[joint])))
    }

    /// Largest difference of two joint vectors, a whole turn being one; prismatic joints in reaches.
    pub fn distance_with_turns(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        largest((0..N).map(|joint| (a[joint] - b[joint]) / self.unit(joint)))
    }

    /// Unit of a joint: 1 rad for a revolute joint, the reach for a prismatic joint.
    pub fn unit(&self, joint: usize) -> f64 {
        if self.kinds[joint] == JointKind::Revolute { 1.0 } else { self.reach }
    }

    /// Returns true if some joint is prismatic.
    pub fn has_prismatic(&self) -> bool {
        self.kinds.contains(&JointKind::Prismatic)
    }
}

/// Largest absolute value; infinite if one is not a number.
pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(|x| if x.is_nan() { f64::INFINITY } else { x.abs() }).fold(0.0, f64::max)
}

/// The angle without whole turns, in `[-pi, pi]`.
pub fn wrap(angle: f64) -> f64 {
    use std::f64::consts::TAU;
    angle - TAU * (angle / TAU).round()
}

/// The length that tolerances are relative to, see [`Subject::reach`].
pub fn reach<const N: usize>(table: &DhTable, limits: &[[f64; 2]; N]) -> f64 {
    length(table.rows, [&table.base, &table.tool], limits)
}

/// Reach from the parts: rows, base and tool, limits of the joints.
pub fn length(rows: &[DhRow], frames: [&DhFrame; 2], limits: &[[f64; 2]]) -> f64 {
    let norm = |xyz: [f64; 3]| xyz.iter().map(|x| x * x).sum::<f64>().sqrt();
    let links: f64 = rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
    let moving = rows.iter().filter(|row| row.kind != JointKind::Fixed);
    let travel: f64 = moving
        .zip(limits)
        .filter(|(row, _)| row.kind == JointKind::Prismatic)
        .map(|(_, [low, high])| low.abs().max(high.abs()))
        .filter(|travel| travel.is_finite())
        .sum();
    match links + travel + frames.iter().map(|frame| norm(frame.xyz)).sum::<f64>() {
        0.0 => 1.0,
        reach => reach,
    }
}
