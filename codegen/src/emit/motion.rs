//! Methods that follow from pose and Jacobian, thin ones on the runtime's functions.

use super::tokens::{integer, number};
use super::{Target, docs};
use crate::lower::TaskMotion;
use crate::model::Model;
use proc_macro2::TokenStream;
use quote::quote;

/// Velocities, accelerations, the Jacobian's other forms and the manipulability, as methods.
pub fn methods(model: &Model, counted: &TaskMotion, target: &Target) -> TokenStream {
    let (krate, t, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let unit = model.length_unit.symbol();
    let manipulability = manipulability(model, counted, target);
    quote! {
        /// `velocity`, `acceleration`, `jacobian_dot`, `jacobian_tool`, `link_velocities`, `link_accelerations`.
        #krate::motion_methods!(#t, #n, #unit);
        #manipulability
    }
}

fn manipulability(model: &Model, counted: &TaskMotion, target: &Target) -> TokenStream {
    let (t, n) = (target.scalar.tokens(), integer(model.joints.len()));
    let (count, rows, value) = match counted {
        TaskMotion::All => (6, "all six rows of the Jacobian", quote!(self.jacobian(q).manipulability())),
        TaskMotion::Rows(counts, rows) => {
            let value = quote!(self.jacobian(q).manipulability_of([#(#counts),*]));
            (counts.iter().filter(|counts| **counts).count(), *rows, value)
        }
        TaskMotion::Axis(column) => {
            let column = integer(*column);
            let value = quote! {
                let (pose, jacobian) = self.forward_and_jacobian(q);
                jacobian.manipulability_pointing(pose.rotation.map(|row| row[#column]))
            };
            (5, "`vx vy vz` of the Jacobian and the two turns across the tool's axis", value)
        }
        TaskMotion::Angle(signs) => {
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
pub fn trait_methods(model: &Model, counted: &TaskMotion, target: &Target) -> TokenStream {
    let (name, t, n) = (&target.type_name, target.scalar.tokens(), integer(model.joints.len()));
    if *counted == TaskMotion::All {
        return TokenStream::new();
    }
    quote! {
        fn manipulability(&self, q: &[#t; #n]) -> #t {
            #name::manipulability(self, q)
        }
    }
}
