//! Methods that follow from pose and Jacobian, thin ones on the runtime's functions.

use super::tokens::{integer, number};
use super::{Target, docs};
use crate::model::{Axis, Model, Task};
use crate::solve::Goal;
use proc_macro2::TokenStream;
use quote::quote;

/// The part of the tool's motion that the arm's task counts.
#[derive(Debug, Clone, PartialEq)]
pub enum Counted {
    /// All six rows of the Jacobian.
    All,
    /// Some of the rows `vx vy vz wx wy wz`, and their names.
    Rows([bool; 6], &'static str),
    /// The point, and the turns across the tool's axis with this column.
    Axis(usize),
    /// The point, and the sum of the joints by these signs.
    Angle(Vec<f64>),
}

/// The part counted by the task of the arm's inverse, else by the task that its file names.
pub fn counted(model: &Model, goal: Option<&Goal>) -> Counted {
    match (goal, goal.map(Goal::task).or(model.inverse.task)) {
        (_, Some(Task::Position)) => {
            Counted::Rows([true, true, true, false, false, false], "`vx vy vz` of the Jacobian")
        }
        (_, Some(Task::PlanarPosition)) => {
            Counted::Rows([true, true, false, false, false, false], "`vx vy` of the Jacobian")
        }
        (_, Some(Task::PlanarPose)) => {
            Counted::Rows([true, true, false, false, false, true], "`vx vy wz` of the Jacobian")
        }
        (Some(Goal::PositionAxis { column }), _) => Counted::Axis(*column),
        (_, Some(Task::PositionAxis)) => Counted::Axis(model.inverse.axis.unwrap_or(Axis::Z).column()),
        (Some(Goal::PositionAngle { signs, .. }), _) => Counted::Angle(signs.clone()),
        // Without an inverse the signs are not known.
        (_, Some(Task::PositionAngle | Task::Pose) | None) => Counted::All,
    }
}

/// Velocities, accelerations, the Jacobian's other forms and the manipulability, as methods.
pub fn methods(model: &Model, counted: &Counted, target: &Target) -> TokenStream {
    let (krate, t, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let unit = model.length_unit.symbol();
    let manipulability = manipulability(model, counted, target);
    quote! {
        /// `velocity`, `acceleration`, `jacobian_dot`, `jacobian_tool`, `link_velocities`, `link_accelerations`.
        #krate::motion_methods!(#t, #n, #unit);
        #manipulability
    }
}

fn manipulability(model: &Model, counted: &Counted, target: &Target) -> TokenStream {
    let (t, n) = (target.scalar.tokens(), integer(model.joints.len()));
    let (count, rows, value) = match counted {
        Counted::All => (6, "all six rows of the Jacobian", quote!(self.jacobian(q).manipulability())),
        Counted::Rows(counts, rows) => {
            let value = quote!(self.jacobian(q).manipulability_of([#(#counts),*]));
            (counts.iter().filter(|counts| **counts).count(), *rows, value)
        }
        Counted::Axis(column) => {
            let column = integer(*column);
            let value = quote! {
                let (pose, jacobian) = self.forward_and_jacobian(q);
                jacobian.manipulability_pointing(pose.rotation.map(|row| row[#column]))
            };
            (5, "`vx vy vz` of the Jacobian and the two turns across the tool's axis", value)
        }
        Counted::Angle(signs) => {
            let signs = signs.iter().map(|sign| number(*sign));
            let value = quote!(self.jacobian(q).manipulability_turning([#(#signs),*]));
            (4, "`vx vy vz` of the Jacobian and the rate of the tool's angle in its plane", value)
        }
    };
    let of = if count > model.joints.len() { "J^T J" } else { "J J^T" };
    let unit = model.length_unit.symbol();
    let doc = docs::lines(&format!("Yoshikawa's manipulability `sqrt(det({of}))`, J: {rows}, lengths in {unit}."));
    quote! {
        #doc
        #[must_use]
        pub fn manipulability(&self, q: &[#t; #n]) -> #t {
            #value
        }
    }
}

/// The methods of the trait whose defaults do not fit.
pub fn trait_methods(model: &Model, counted: &Counted, target: &Target) -> TokenStream {
    let (name, t, n) = (&target.type_name, target.scalar.tokens(), integer(model.joints.len()));
    if *counted == Counted::All {
        return TokenStream::new();
    }
    quote! {
        fn manipulability(&self, q: &[#t; #n]) -> #t {
            #name::manipulability(self, q)
        }
    }
}
