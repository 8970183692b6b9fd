//! Why a target has no solution.

use std::cell::RefCell;
use std::fmt;

use denhart_codegen::lower::{Statement, Unit};

use crate::solver::Asked;
use crate::trace::Trace;
use crate::{DynamicArm, DynamicError, DynamicSolutions, DynamicTarget};

/// The equation that ends the branch of a target without solution that gets farthest.
///
/// Printed, it is the line of `denhart check` on that equation, with what it misses a root by:
/// `q3: two points a given distance apart, law of cosines (2 roots): missed by a distance of 0.2`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DynamicMiss {
    /// The place of the equation among those of the inverse, from 0.
    pub stage: usize,
    /// The joints that it would give: `q3`.
    pub joints: Vec<String>,
    /// The equation in the words of `denhart check`.
    pub equation: &'static str,
    /// How far it is from having a root, length unit or rad; `None` of a quartic, which does not tell.
    pub gap: Option<f64>,
    /// True for an equation of directions, whose gap is an angle.
    pub is_direction: bool,
}

impl fmt::Display for DynamicMiss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: ", self.joints.join(", "), self.equation)?;
        match (self.gap, self.is_direction) {
            (None, _) => write!(f, "no real root"),
            (Some(gap), true) => write!(f, "missed by an angle of {gap:.3} rad"),
            (Some(gap), false) => write!(f, "missed by a distance of {gap:.4}"),
        }
    }
}

impl DynamicArm {
    /// Why a target has no solution: of the branch that gets farthest the first equation without a root. `None` of a target with
    /// an exact solution, one that is no target, one that fails the forward kinematics at its end, and of an inverse that
    /// holds a joint.
    ///
    /// The gap is that of one equation, with the joints before it on their roots. It is not the distance to the workspace.
    ///
    /// # Errors
    /// As of [`inverse`](Self::inverse).
    ///
    /// ```
    /// use denhart_dynamic::{DynamicArm, DynamicTarget};
    ///
    /// # fn main() -> Result<(), denhart_dynamic::DynamicError> {
    /// let rows = "[{a: 0.3, alpha: 0, d: 0, theta: 0}, {a: 0.2, alpha: 0, d: 0, theta: 0}]";
    /// let arm = DynamicArm::from_yaml(&format!("convention: standard\njoints: {rows}\n"))?;
    /// let miss = arm.why(&DynamicTarget::PlanarPosition([0.0, 0.8]), &[])?;
    /// assert!(miss.is_some_and(|miss| miss.joints == ["q2"] && !miss.is_direction));
    /// assert!(arm.why(&DynamicTarget::PlanarPosition([0.0, 0.4]), &[])?.is_none());
    /// # Ok(())
    /// # }
    /// ```
    pub fn why(&self, target: &DynamicTarget, given: &[f64]) -> Result<Option<DynamicMiss>, DynamicError> {
        let given = &self.beside(given)?;
        let (trace, mut solutions) = (RefCell::new(Trace::default()), DynamicSolutions::default());
        self.solver(target)?.solve(&Asked { trace: Some(&trace), ..Asked::all(target, given) }, &mut solutions);
        let Some((stage, gap)) = trace.into_inner().ended.filter(|_| !solutions.status().is_reachable()) else {
            return Ok(None);
        };
        let statements = self.inverse_program()?.levels.iter().flat_map(|level| &level.body);
        let mut call = statements.rev().filter_map(|statement| match statement {
            Statement::Solve(call) if call.stage == stage => Some(call),
            _ => None,
        });
        Ok(call.next().map(|call| DynamicMiss {
            stage,
            joints: call.labels.iter().map(|label| format!("q{label}")).collect(),
            equation: call.kernel.form().description,
            gap,
            is_direction: call.unit == Unit::Direction,
        }))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use denhart::Pose;

    fn ur5() -> DynamicArm {
        DynamicArm::from_yaml(include_str!("../../specs/ur5.yaml")).unwrap()
    }

    #[test]
    fn a_far_target_ends_at_the_triangle_and_one_at_the_axis_before_it() {
        let far = Pose { translation: [2.0, 0.0, 0.3], ..Pose::identity() };
        let miss = ur5().why(&DynamicTarget::Pose(far), &[]).unwrap().unwrap();
        assert!(miss.equation.contains("law of cosines") && miss.gap.unwrap() > 0.5, "{miss}");
        assert!(miss.to_string().starts_with("q3: two points a given distance apart"), "{miss}");
        // Nearer to the base's axis than the wrist's offset: no turn of joint 1 brings it there.
        let near = Pose { translation: [0.01, 0.0, 0.3], ..Pose::identity() };
        let near = ur5().why(&DynamicTarget::Pose(near), &[]).unwrap().unwrap();
        assert!(near.stage < miss.stage && near.joints == ["q1"], "{near}");
    }

    #[test]
    fn a_target_that_is_reached_has_no_miss() {
        let arm = ur5();
        let target = arm.target_at(&[0.3, -1.0, 1.2, 0.4, 0.9, -0.2]).unwrap();
        assert_eq!(arm.why(&target, &[]).unwrap(), None);
    }

    #[test]
    fn the_answer_is_that_of_the_ordinary_call() {
        let arm = ur5();
        let target = DynamicTarget::Pose(Pose { translation: [0.4, 0.2, 0.3], ..Pose::identity() });
        let before = arm.inverse(&target, &[]).unwrap();
        let _ = arm.why(&target, &[]).unwrap();
        assert_eq!(arm.inverse(&target, &[]).unwrap(), before);
    }
}
