//! What follows from pose and Jacobian: thin methods on the runtime's functions.

use super::arm::Inverse;
use super::tokens::integer;
use super::{Target, docs};
use crate::model::{Model, Task};
use proc_macro2::TokenStream;
use quote::quote;

/// The task that the arm is for: the one of its inverse, else the one its file names.
pub fn task(model: &Model, inverse: &Inverse) -> Option<Task> {
    inverse.as_ref().ok().map(|plan| plan.task.task).or(model.inverse.task)
}

/// Velocities, accelerations, the Jacobian's other forms and the manipulability, as methods.
pub fn methods(model: &Model, task: Option<Task>, target: &Target) -> TokenStream {
    let (krate, t, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let unit = docs::unit(model);
    let velocity = docs::lines(&format!(
        "Velocity of the tool point ({unit}/s) and angular velocity (rad/s) in the base frame, for rates `qd`: `J qd`."
    ));
    let acceleration = docs::lines(&format!(
        "Second derivative of the tool point ({unit}/s^2), derivative of the angular velocity: `J qdd + dJ/dt qd`."
    ));
    let manipulability = manipulability(model, task, target);
    quote! {
        #velocity
        #[inline]
        #[must_use]
        pub fn velocity(&self, q: &[#t; #n], qd: &[#t; #n]) -> #krate::Twist<#t> {
            self.jacobian(q).velocity(qd)
        }
        #acceleration
        #[inline]
        #[must_use]
        pub fn acceleration(&self, q: &[#t; #n], qd: &[#t; #n], qdd: &[#t; #n]) -> #krate::Acceleration<#t> {
            self.jacobian(q).acceleration(qd, qdd)
        }
        /// Derivative by time of [`Self::jacobian`], for rates `qd`.
        #[must_use]
        pub fn jacobian_dot(&self, q: &[#t; #n], qd: &[#t; #n]) -> #krate::Jacobian<#t, #n> {
            self.jacobian(q).derivative(qd)
        }
        /// Geometric Jacobian of the tool point in the axes of the tool.
        #[must_use]
        pub fn jacobian_tool(&self, q: &[#t; #n]) -> #krate::Jacobian<#t, #n> {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.in_frame(&tool.rotation)
        }
        /// Velocities of the frames of [`Self::link_poses`] in the base frame, each at its own origin.
        #[must_use]
        pub fn link_velocities(&self, q: &[#t; #n], qd: &[#t; #n]) -> [#krate::Twist<#t>; #n] {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.link_velocities(&tool, &self.link_poses(q), qd)
        }
        /// Accelerations of the same frames.
        #[must_use]
        pub fn link_accelerations(
            &self,
            q: &[#t; #n],
            qd: &[#t; #n],
            qdd: &[#t; #n],
        ) -> [#krate::Acceleration<#t>; #n] {
            let (tool, jacobian) = self.forward_and_jacobian(q);
            jacobian.link_accelerations(&tool, &self.link_poses(q), qd, qdd)
        }
        #manipulability
    }
}

/// The rows `vx vy vz wx wy wz` that the arm's task counts, where those are some of the six, and their names.
fn counts(task: Option<Task>) -> Option<([bool; 6], &'static str)> {
    match task {
        Some(Task::Position) => Some(([true, true, true, false, false, false], "`vx vy vz`")),
        Some(Task::PlanarPosition) => Some(([true, true, false, false, false, false], "`vx vy`")),
        Some(Task::PlanarPose) => Some(([true, true, false, false, false, true], "`vx vy wz`")),
        _ => None,
    }
}

fn manipulability(model: &Model, task: Option<Task>, target: &Target) -> TokenStream {
    let (t, n) = (target.scalar.tokens(), integer(model.joints.len()));
    let (rows, call) = match counts(task) {
        Some((counts, rows)) => (rows, quote!(manipulability_of([#(#counts),*]))),
        None => ("all six rows", quote!(manipulability())),
    };
    let rows_counted = counts(task).map_or(6, |(counts, _)| counts.iter().filter(|counts| **counts).count());
    let of = if rows_counted > model.joints.len() { "J^T J" } else { "J J^T" };
    let unit = docs::unit(model);
    let doc = docs::lines(&format!(
        "Yoshikawa's manipulability `sqrt(det({of}))`, J: {rows} of the Jacobian, lengths in {unit}."
    ));
    quote! {
        #doc
        #[must_use]
        pub fn manipulability(&self, q: &[#t; #n]) -> #t {
            self.jacobian(q).#call
        }
    }
}

/// What the trait's defaults do not give.
pub fn trait_methods(model: &Model, task: Option<Task>, target: &Target) -> TokenStream {
    let (name, t, n) = (&target.type_name, target.scalar.tokens(), integer(model.joints.len()));
    if counts(task).is_none() {
        return TokenStream::new();
    }
    quote! {
        fn manipulability(&self, q: &[#t; #n]) -> #t {
            #name::manipulability(self, q)
        }
    }
}
