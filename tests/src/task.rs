//! Tasks of an arm's tool, and the error of a joint vector.
//!
//! A [`Goal`] always knows the whole pose. The arm's [`Task`] selects the part that counts, and so defines the error.

use denhart::{Chain, DhRow, JointKind, PlanarPose, PointAngle, PointAxis, Pose};
use denhart_dynamic::DynamicTarget;
use nalgebra::{Isometry3, Vector3};

/// Kind of a task: the part of the tool's pose that counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Position and orientation.
    Pose,
    /// The tool point.
    Position,
    /// The tool point and the direction of a tool axis: 0 for x to 2 for z.
    PositionAxis(usize),
    /// The tool point and the sum of the pitch joints.
    PositionAngle,
    /// The tool point in the base frame's x-y plane, and the direction of the tool's x axis in it.
    PlanarPose,
    /// The tool point in the base frame's x-y plane.
    PlanarPosition,
}

/// Most values that are given beside a target: four of ten joints.
pub const MOST_GIVEN: usize = 4;

/// A few things, one for each given joint, in the order of the call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Given<T> {
    list: [T; MOST_GIVEN],
    count: usize,
}

impl<T: Copy + PartialEq> Given<T> {
    /// All of an iterator.
    pub fn of(each: impl IntoIterator<Item = T>, none: T) -> Self {
        each.into_iter().fold(Self { list: [none; MOST_GIVEN], count: 0 }, |given, next| given.with(next))
    }

    const fn with(mut self, next: T) -> Self {
        self.list[self.count] = next;
        self.count += 1;
        self
    }

    pub fn as_slice(&self) -> &[T] {
        &self.list[..self.count]
    }

    pub fn iter(&self) -> impl Iterator<Item = T> {
        self.as_slice().iter().copied()
    }

    pub fn contains(&self, one: T) -> bool {
        self.as_slice().contains(&one)
    }

    pub const fn is_empty(&self) -> bool {
        self.count == 0
    }
}

impl Given<usize> {
    /// No joint.
    pub const NONE: Self = Self { list: [0; MOST_GIVEN], count: 0 };
}

impl Given<f64> {
    /// No value.
    pub const NONE: Self = Self { list: [0.0; MOST_GIVEN], count: 0 };

    /// Each with the index of its joint.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        self.list[..self.count].iter_mut()
    }
}

/// The task of an arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Task {
    pub kind: Kind,
    /// The joints whose values are arguments, from 0.
    pub given: Given<usize>,
    /// True for an inverse that holds a joint: see [`recover::check`](crate::recover::check).
    pub holds_a_joint: bool,
    /// So many poses of a suite may fail: those of docs/known-gaps.md.
    pub known_losses: usize,
}

impl Task {
    /// A task without a joint whose value is given.
    pub const fn new(kind: Kind) -> Self {
        Self { kind, given: Given::<usize>::NONE, holds_a_joint: false, known_losses: 0 }
    }

    /// The task of an inverse that holds a joint.
    pub const fn holding_a_joint(self) -> Self {
        Self { holds_a_joint: true, ..self }
    }

    /// Adds the value of joint `number`, counted from 1 as in arm files, as an argument behind those that there are.
    pub const fn redundant(self, number: usize) -> Self {
        Self { given: self.given.with(number - 1), ..self }
    }

    /// The task of an arm that fails at so many poses of a suite, as docs/known-gaps.md says.
    pub const fn losing(self, known_losses: usize) -> Self {
        Self { known_losses, ..self }
    }

    /// Number of equations, those of the given joints among them, as the last ones.
    pub fn equations(&self) -> usize {
        let asked = match self.kind {
            Kind::Pose => 6,
            Kind::PositionAxis(_) => 5,
            Kind::PositionAngle => 4,
            Kind::Position | Kind::PlanarPose => 3,
            Kind::PlanarPosition => 2,
        };
        asked + self.given.as_slice().len()
    }

    /// Returns true if only motion in the base frame's x-y plane counts.
    pub fn is_planar(&self) -> bool {
        matches!(self.kind, Kind::PlanarPose | Kind::PlanarPosition)
    }
}

/// Most equations a task has: six of a pose and one of each given joint.
pub const EQUATIONS: usize = 6 + MOST_GIVEN;

/// Goal of any task.
#[derive(Debug, Clone, Copy)]
pub struct Goal {
    pub pose: Isometry3<f64>,
    /// Sum of the pitch joints, rad; 0 unless the task asks for it.
    pub angle: f64,
    /// Values of the given joints.
    pub given: Given<f64>,
}

impl From<Isometry3<f64>> for Goal {
    fn from(pose: Isometry3<f64>) -> Self {
        Self { pose, angle: 0.0, given: Given::<f64>::NONE }
    }
}

/// The type of a target in the generated code.
pub trait Asked: Sized + Clone + std::fmt::Debug {
    /// The part of the goal that the task looks at.
    fn of(kind: Kind, goal: &Goal) -> Self;
}

impl Asked for Pose<f64> {
    fn of(_: Kind, goal: &Goal) -> Self {
        Pose::from(goal.pose)
    }
}

impl Asked for [f64; 3] {
    fn of(_: Kind, goal: &Goal) -> Self {
        goal.pose.translation.vector.into()
    }
}

impl Asked for [f64; 2] {
    fn of(_: Kind, goal: &Goal) -> Self {
        goal.pose.translation.vector.xy().into()
    }
}

impl Asked for PointAxis<f64> {
    fn of(kind: Kind, goal: &Goal) -> Self {
        let Kind::PositionAxis(axis) = kind else { panic!("the task of the list is not position_axis") };
        PointAxis::new(goal.pose.translation.vector.into(), tool_axis(&goal.pose, axis).into())
    }
}

impl Asked for PointAngle<f64> {
    fn of(_: Kind, goal: &Goal) -> Self {
        PointAngle::new(goal.pose.translation.vector.into(), goal.angle)
    }
}

impl Asked for PlanarPose<f64> {
    fn of(_: Kind, goal: &Goal) -> Self {
        let point = goal.pose.translation.vector;
        PlanarPose::new(point.x, point.y, heading(&goal.pose))
    }
}

impl<A: Asked> Asked for (A, f64) {
    fn of(kind: Kind, goal: &Goal) -> Self {
        (A::of(kind, goal), goal.given.as_slice()[0])
    }
}

impl<A: Asked, const K: usize> Asked for (A, [f64; K]) {
    fn of(kind: Kind, goal: &Goal) -> Self {
        (A::of(kind, goal), goal.given.as_slice().try_into().expect("as many values as the list has joints"))
    }
}

impl Asked for DynamicTarget {
    fn of(kind: Kind, goal: &Goal) -> Self {
        match kind {
            Kind::Pose => DynamicTarget::Pose(Asked::of(kind, goal)),
            Kind::Position => DynamicTarget::Position(Asked::of(kind, goal)),
            Kind::PositionAxis(_) => DynamicTarget::PositionAxis(Asked::of(kind, goal)),
            Kind::PositionAngle => DynamicTarget::PositionAngle(Asked::of(kind, goal)),
            Kind::PlanarPose => DynamicTarget::PlanarPose(Asked::of(kind, goal)),
            Kind::PlanarPosition => DynamicTarget::PlanarPosition(Asked::of(kind, goal)),
        }
    }
}

/// The tool's axis in the base frame: 0 for x to 2 for z.
pub fn tool_axis(pose: &Isometry3<f64>, axis: usize) -> Vector3<f64> {
    pose.rotation * Vector3::from(std::array::from_fn::<f64, 3, _>(|k| f64::from(u8::from(k == axis))))
}

/// Two unit vectors across a unit vector and across one another; the same two for the same vector.
pub fn across(axis: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let first = Vector3::ith(axis.iamin(), 1.0).cross(axis).normalize();
    [first, axis.cross(&first)]
}

/// Direction of the tool's x axis in the base frame's x-y plane, rad.
pub fn heading(pose: &Isometry3<f64>) -> f64 {
    let x = tool_axis(pose, 0);
    x.y.atan2(x.x)
}

/// How the joints add up to the angle of a `position_angle` task.
#[derive(Debug, Clone, Copy)]
pub struct Pitch<const N: usize> {
    /// `+-1` for a pitch joint, by the sense of its axis beside that of the first one; 0 for others.
    pub signs: [f64; N],
    /// The sum of the table's angles of these joints, with the same signs, rad.
    pub offset: f64,
}

impl<const N: usize> Pitch<N> {
    /// No joint counts.
    pub const NONE: Self = Self { signs: [0.0; N], offset: 0.0 };

    /// Every turning joint after the first one whose axis is parallel to that of the next that turns.
    pub fn of(chain: &Chain) -> Self {
        let jacobian = chain.jacobian(&[0.0; N]).expect("the chain has as many joints as the arm");
        let axis = |joint: usize| -> Vector3<f64> { jacobian.fixed_view::<3, 1>(3, joint).into() };
        let pitch = (1..N).map(axis).find(|axis| axis.norm() > 0.5).expect("a joint that pitches");
        let signs = std::array::from_fn(|joint| match axis(joint).dot(&pitch) {
            along if joint > 0 && along.abs() > 1.0 - 1e-9 => along.signum(),
            _ => 0.0,
        });
        let moving = chain.rows().iter().filter(|row| row.kind != JointKind::Fixed);
        let offset = moving.zip(&signs).map(|(DhRow { theta, .. }, sign)| theta * sign).sum();
        Self { signs, offset }
    }

    /// The angle at `q`, rad.
    pub fn angle(&self, q: &[f64; N]) -> f64 {
        self.offset + q.iter().zip(&self.signs).map(|(q, sign)| q * sign).sum::<f64>()
    }
}
