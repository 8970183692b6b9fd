//! An arm under test: its generated inverse beside the chain that judges it.

use std::fmt;

use denhart::{Chain, DhTable, InverseKinematics, JointKind, Pose, Solution, Status};
use nalgebra::{Isometry3, Matrix6xX};

/// The constants of a derived arm, for code that is generic over the arm.
pub trait Specified<const N: usize>: denhart::Arm<f64, N> + Default + Send + Sync + 'static {
    /// Name of the arm in its file.
    const NAME: &'static str;
    /// Its table.
    const TABLE: DhTable;
}

/// What a call of an inverse gave.
#[derive(Debug, Clone)]
pub struct Answer<const N: usize> {
    pub solutions: Vec<Solution<f64, N>>,
    pub status: Status<f64>,
}

impl<const N: usize> Answer<N> {
    /// The solutions that claim to reach the target.
    pub fn exact(&self) -> impl Iterator<Item = &Solution<f64, N>> {
        self.solutions.iter().filter(|solution| solution.is_exact())
    }
}

/// One solution a line: joint values, flags, free joints, branch, residual.
impl<const N: usize> fmt::Display for Answer<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} solutions, {:?}", self.solutions.len(), self.status)?;
        for s in &self.solutions {
            write!(f, "\n      {:?} {} {} ({}) {}", s.q, s.flags, s.free, s.branch, s.residual)?;
        }
        Ok(())
    }
}

/// The two inverse functions behind a pointer, so that the rules compile once and not once an arm.
trait Solver<const N: usize>: Send + Sync {
    fn inverse(&self, target: &Pose<f64>) -> Answer<N>;
    fn inverse_near(&self, target: &Pose<f64>, q_ref: &[f64; N]) -> Answer<N>;
}

struct Derived<A>(A);

impl<A, const N: usize> Solver<N> for Derived<A>
where
    A: InverseKinematics<f64, N, Target = Pose<f64>> + Send + Sync,
{
    fn inverse(&self, target: &Pose<f64>) -> Answer<N> {
        let solutions = self.0.inverse(target);
        Answer { solutions: solutions.as_ref().to_vec(), status: A::status(&solutions) }
    }

    fn inverse_near(&self, target: &Pose<f64>, q_ref: &[f64; N]) -> Answer<N> {
        let solutions = self.0.inverse_near(target, q_ref);
        Answer { solutions: solutions.as_ref().to_vec(), status: A::status(&solutions) }
    }
}

/// An arm under test.
pub struct Subject<const N: usize> {
    pub name: &'static str,
    /// The judge.
    pub chain: Chain,
    /// Sum of `|a| + |d|`, base and tool offset, and the longest travel of the prismatic joints; 1 if that is 0. Every
    /// tolerance on a length is relative to it.
    pub reach: f64,
    pub kinds: [JointKind; N],
    pub limits: [[f64; 2]; N],
    pub max_solutions: usize,
    solver: Box<dyn Solver<N>>,
}

impl<const N: usize> Subject<N> {
    /// The arm `A` with its generated inverse.
    pub fn new<A>() -> Self
    where
        A: Specified<N> + InverseKinematics<f64, N, Target = Pose<f64>>,
    {
        Self {
            name: A::NAME,
            chain: Chain::from(A::TABLE),
            reach: reach(&A::TABLE, &A::LIMITS),
            kinds: A::JOINT_KINDS,
            limits: A::LIMITS,
            max_solutions: A::MAX_SOLUTIONS,
            solver: Box::new(Derived(A::default())),
        }
    }

    /// Every branch, by the generated code.
    pub fn inverse(&self, target: &Pose<f64>) -> Answer<N> {
        self.solver.inverse(target)
    }

    /// Every branch next to `q_ref`, by the generated code.
    pub fn inverse_near(&self, target: &Pose<f64>, q_ref: &[f64; N]) -> Answer<N> {
        self.solver.inverse_near(target, q_ref)
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

    /// How far the tool at `q` is from `target`: position in reaches, orientation in rad.
    ///
    /// The angle is taken from the vector part of the quaternion, so that it is accurate down to rounding.
    pub fn miss(&self, target: &Isometry3<f64>, q: &[f64; N]) -> [f64; 2] {
        let reached = self.pose(q);
        let position = (reached.translation.vector - target.translation.vector).norm() / self.reach;
        let turn = target.rotation.rotation_to(&reached.rotation);
        [position, 2.0 * turn.vector().norm().atan2(turn.scalar().abs())]
    }

    /// How far the slides at `q` reach beyond their travel, as a factor on the reach: a slide at a thousand reaches
    /// cannot be given more finely than to a thousand roundings. 1 within the limits.
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

    /// What a joint is measured in: 1 rad for a revolute joint, the reach for a prismatic one.
    pub fn unit(&self, joint: usize) -> f64 {
        if self.kinds[joint] == JointKind::Revolute { 1.0 } else { self.reach }
    }

    /// Whether some joint is prismatic.
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
    let norm = |xyz: [f64; 3]| xyz.iter().map(|x| x * x).sum::<f64>().sqrt();
    let rows: f64 = table.rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
    let moving = table.rows.iter().filter(|row| row.kind != JointKind::Fixed);
    let travel: f64 = moving
        .zip(limits)
        .filter(|(row, _)| row.kind == JointKind::Prismatic)
        .map(|(_, [low, high])| low.abs().max(high.abs()))
        .filter(|travel| travel.is_finite())
        .sum();
    match rows + travel + norm(table.base.xyz) + norm(table.tool.xyz) {
        0.0 => 1.0,
        reach => reach,
    }
}
