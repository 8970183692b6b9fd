//! Batches: many poses at the speed of the vector unit.
//!
//! The programs of the arm are evaluated for a block of poses at a time, in the lanes of vector registers. Every result
//! has the bits of a single call. A target that is not ordinary (near a singularity, at the edge of reach, drifted, not
//! finite) takes a single call.

mod inverse;
mod plan;
mod rows;
mod run;
mod sink;
mod straight;
mod target;

use std::sync::OnceLock;

use denhart::batch::{Found, InstructionSet, Summary};
use denhart_codegen::lower::Given;

use crate::{DynamicArm, DynamicError};
use inverse::Targets;
use plan::Plan;
use straight::Evaluation;

/// Memory of an arm for its batches.
#[derive(Debug, Default)]
pub struct ForLanes {
    /// Made at the first batch; none of an inverse that has no lane form.
    plan: OnceLock<Option<Plan>>,
    set: Option<InstructionSet>,
}

/// Numbers of a pose: the rotation by rows, then the position.
const POSE: usize = 12;

impl DynamicArm {
    /// Uses another instruction set for batches than the widest one of the processor: to compare and to measure.
    pub fn set_instruction_set(&mut self, set: InstructionSet) {
        self.lanes.set = Some(set);
    }

    /// Returns true if targets of the arm's inverse can take lanes. Without, every target of a batch takes a single call:
    /// for an arm that holds a joint, one that was measured or misses its structure, and one whose stages need a quartic.
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn inverse_has_lanes(&self) -> Result<bool, DynamicError> {
        Ok(self.plan()?.is_some())
    }

    fn plan(&self) -> Result<Option<&Plan>, DynamicError> {
        let program = self.inverse_program()?;
        Ok(self.lanes.plan.get_or_init(|| Plan::of(program, self.joint_kinds())).as_ref())
    }

    fn set(&self) -> InstructionSet {
        self.lanes.set.unwrap_or_else(InstructionSet::best)
    }

    /// The number of numbers of a target in [`inverse_batch`](Self::inverse_batch).
    ///
    /// # Errors
    /// An arm without inverse.
    pub fn target_width(&self) -> Result<usize, DynamicError> {
        Ok(target::width(&self.inverse_program()?.goal))
    }

    /// [`forward`](Self::forward) of many joint vectors. `q`: rows of joint values (rad, length unit). `poses`: rows of 12
    /// numbers, the rotation by rows, then the position (length unit).
    ///
    /// # Errors
    /// Slices that do not have the same number of rows; nothing is written then. So for all batches.
    pub fn forward_batch(&self, q: &[f64], poses: &mut [f64]) -> Result<(), DynamicError> {
        let rows = self.rows_of_joints(q)?;
        rows.check("poses", poses.len(), POSE)?;
        let results = [(poses, POSE), (&mut [][..], 0)];
        self.set().run(Evaluation { function: &self.forward, q, results });
        Ok(())
    }

    /// [`forward_and_jacobian`](Self::forward_and_jacobian) of many joint vectors. `q` and `poses` as of
    /// [`forward_batch`](Self::forward_batch). `jacobians`: of each the rows `vx vy vz wx wy wz`, a number for each joint.
    ///
    /// # Errors
    /// As of [`forward_batch`](Self::forward_batch).
    pub fn forward_and_jacobian_batch(
        &self,
        q: &[f64],
        poses: &mut [f64],
        jacobians: &mut [f64],
    ) -> Result<(), DynamicError> {
        let rows = self.rows_of_joints(q)?;
        let width = 6 * self.joints();
        rows.check("poses", poses.len(), POSE)?;
        rows.check("jacobians", jacobians.len(), width)?;
        let results = [(poses, POSE), (jacobians, width)];
        self.set().run(Evaluation { function: &self.both, q, results });
        Ok(())
    }

    /// [`jacobian`](Self::jacobian) of many joint vectors. `q` and `jacobians` as of
    /// [`forward_and_jacobian_batch`](Self::forward_and_jacobian_batch), which gives the poses in one pass: there the Jacobian is that of
    /// [`forward_and_jacobian`](Self::forward_and_jacobian), which may round otherwise.
    ///
    /// # Errors
    /// As of [`forward_batch`](Self::forward_batch).
    pub fn jacobian_batch(&self, q: &[f64], jacobians: &mut [f64]) -> Result<(), DynamicError> {
        let rows = self.rows_of_joints(q)?;
        let width = 6 * self.joints();
        rows.check("jacobians", jacobians.len(), width)?;
        let results = [(jacobians, width), (&mut [][..], 0)];
        self.set().run(Evaluation { function: &self.jacobian, q, results });
        Ok(())
    }

    /// [`inverse`](Self::inverse) of many targets.
    ///
    /// `targets`: rows of the numbers of the task's target. A pose is 12 numbers, the rotation by rows, then the position;
    /// another target has the numbers of its [`DynamicTarget`](crate::DynamicTarget) in their order. `given`: rows of the
    /// values that the inverse takes beside the target; empty where it takes none. `q`: of each target
    /// [`max_solutions`](Self::max_solutions) times as many numbers as joints. The first `count` joint vectors are the
    /// solutions, in the order of `inverse`; the others have no meaning. `found`: one for each target.
    ///
    /// # Errors
    /// An arm without inverse; as of [`forward_batch`](Self::forward_batch).
    pub fn inverse_batch(
        &self,
        targets: &[f64],
        given: &[f64],
        q: &mut [f64],
        found: &mut [Found],
    ) -> Result<Summary, DynamicError> {
        let program = self.inverse_program()?;
        let width = target::width(&program.goal);
        let rows = Rows::of("targets", targets.len(), width)?;
        let row = program.capacity * program.joints;
        rows.check("given", given.len(), program.given.values.len())?;
        rows.check("q", q.len(), row)?;
        rows.check("found", found.len(), 1)?;
        let solver = self.solver.as_deref().map_err(Clone::clone)?;
        Ok(self.set().run(Targets::<false> {
            plan: self.plan()?,
            program,
            solver,
            targets,
            width,
            references: &[],
            given,
            limits: self.limits(),
            q,
            row,
            found,
        }))
    }

    /// The first solution of [`inverse_near`](Self::inverse_near) within the arm's limits, of many targets: the one nearest to
    /// the reference. `targets` and `found` as of [`inverse_batch`](Self::inverse_batch). `q_ref` and `q`: rows of joint
    /// values. Where `count` is 0 the row of `q` has no meaning.
    ///
    /// # Errors
    /// As of [`inverse_batch`](Self::inverse_batch).
    pub fn inverse_near_batch(
        &self,
        targets: &[f64],
        q_ref: &[f64],
        q: &mut [f64],
        found: &mut [Found],
    ) -> Result<Summary, DynamicError> {
        let program = self.inverse_program()?;
        let width = target::width(&program.goal);
        let rows = Rows::of("targets", targets.len(), width)?;
        rows.check("q_ref", q_ref.len(), program.joints)?;
        rows.check("q", q.len(), program.joints)?;
        rows.check("found", found.len(), 1)?;
        let solver = self.solver.as_deref().map_err(Clone::clone)?;
        // The arm angle of a reference is a function of its own.
        let angles: Vec<f64> = match program.given.values.as_slice() {
            [Given::ArmAngle] => {
                q_ref.chunks_exact(program.joints.max(1)).map(|q| self.arm_angle(q)).collect::<Result<_, _>>()?
            }
            _ => Vec::new(),
        };
        Ok(self.set().run(Targets::<true> {
            plan: self.plan()?,
            program,
            solver,
            targets,
            width,
            references: q_ref,
            given: &angles,
            limits: self.limits(),
            q,
            row: program.joints,
            found,
        }))
    }

    fn rows_of_joints(&self, q: &[f64]) -> Result<Rows, DynamicError> {
        Rows::of("q", q.len(), self.joints())
    }
}

/// The slice of a batch that says how many rows there are.
#[derive(Debug, Clone, Copy)]
struct Rows {
    slice: &'static str,
    length: usize,
    width: usize,
}

impl Rows {
    fn of(slice: &'static str, length: usize, width: usize) -> Result<Self, DynamicError> {
        if length.checked_rem(width) == Some(0) || length == 0 {
            return Ok(Rows { slice, length, width });
        }
        Err(DynamicError::PartOfARow { slice, found: length, width })
    }

    /// Compares the length of another slice.
    fn check(self, slice: &'static str, found: usize, width: usize) -> Result<(), DynamicError> {
        let Rows { slice: beside, length, width: of } = self;
        let rows = length.checked_div(of).unwrap_or(0);
        if rows.checked_mul(width) == Some(found) {
            return Ok(());
        }
        Err(DynamicError::Rows { slice, found, width, beside, length, rows, of })
    }
}
