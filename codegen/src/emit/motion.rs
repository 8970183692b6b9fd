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
    let unit = model.length_unit.symbol();
    let manipulability = manipulability(model, task, target);
    quote! {
        /// `velocity`, `acceleration`, `jacobian_dot`, `jacobian_tool`, `link_velocities`, `link_accelerations`.
        #krate::motion_methods!(#t, #n, #unit);
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
    let unit = model.length_unit.symbol();
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
