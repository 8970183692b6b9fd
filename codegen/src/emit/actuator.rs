//! Motors that count pulses: the constants and thin methods around the runtime's.

use super::Target;
use super::docs;
use super::tokens::{integer, number};
use crate::model::{Actuator, JointKind, Model};
use proc_macro2::TokenStream;
use quote::quote;

/// Constants and methods; nothing for an arm without actuators.
pub fn methods(model: &Model, target: &Target) -> TokenStream {
    let Some(actuators) = &model.actuators else { return TokenStream::new() };
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let constants = constants(model, actuators, target);
    // Pulses count what the motors turn, which with a coupling is not what the joints turn.
    let from = quote!(#krate::actuator::from_pulses(&Self::ACTUATORS, pulses));
    let (motors, from) = match &model.coupling {
        Some(_) => (quote!(&self.to_motor(q)), quote!(self.from_motor(&#from))),
        None => (quote!(q), from),
    };
    let q = docs::joints(model);
    let whose = if model.coupling.is_some() { " of the motors, `to_motor(q)`," } else { "" };
    let to_doc = docs::lines(&format!(
        "Pulse counts{whose} at joint values `q`, from each home position, `[{n}]`.\n\n{q} Typed in degrees: \
         `joints_from_degrees` of the trait `Arm`.\n\
         Rounded to the nearest count, halves away from zero: `ROUND(pulses_per_unit (value - home))`. A count beyond \
         `i32` saturates, and a value that is not a number counts 0; `to_pulses_checked` reports both."
    ));
    let from_doc = docs::lines(&format!(
        "Joint values `[{n}]` at pulse counts `[{n}]`.{}",
        if model.coupling.is_some() { " The counts are those of the motors." } else { "" }
    ));
    let error_doc = docs::lines(&format!(
        "The arm with `q` rounded to pulses: counts, joint values `[{n}]`, the pose of the tool there, and how far that \
         pose is from `forward(q)`.\n\n{q} Positions in {}, angles in rad.",
        model.length_unit.symbol()
    ));
    quote! {
        #constants

        #to_doc
        #[inline]
        #[must_use]
        pub fn to_pulses(&self, q: &[#scalar; #n]) -> [i32; #n] {
            self.to_pulses_checked(q).0
        }

        /// Pulse counts as of `to_pulses`, and the motors (from 0) whose count is saturated or whose value is not a number.
        #[inline]
        #[must_use]
        pub fn to_pulses_checked(&self, q: &[#scalar; #n]) -> ([i32; #n], #krate::JointMask) {
            #krate::actuator::to_pulses(&Self::ACTUATORS, #motors)
        }

        #from_doc
        #[inline]
        #[must_use]
        pub fn from_pulses(&self, pulses: &[i32; #n]) -> [#scalar; #n] {
            #from
        }

        #error_doc
        #[must_use]
        pub fn quantized_error(&self, q: &[#scalar; #n]) -> #krate::Quantized<#scalar, #n> {
            let counted = self.to_pulses_checked(q);
            let reached = self.from_pulses(&counted.0);
            #krate::Quantized::new(counted, reached, &self.forward(q), self.forward(&reached))
        }
    }
}

fn constants(model: &Model, actuators: &[Actuator], target: &Target) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let entries = actuators.iter().map(|actuator| {
        let (pulses, home) = (number(actuator.pulses_per_unit), number(actuator.home));
        quote!(#krate::Actuator { pulses_per_unit: #pulses, home: #home })
    });
    let resolutions = actuators.iter().map(|actuator| number(actuator.resolution));
    let slides = model.joints.iter().any(|joint| joint.kind == JointKind::Prismatic);
    let unit = if slides { format!("rad (sliding joints: {})", model.length_unit.symbol()) } else { "rad".to_owned() };
    let of = if model.coupling.is_some() { "motor, of motor values" } else { "joint" };
    let actuators_doc = docs::lines(&format!("Pulse scale of each motor, pulses per {unit}, and its home position."));
    let resolution_doc = docs::lines(&format!("One pulse of each {of}: {unit}."));
    quote! {
        #actuators_doc
        pub const ACTUATORS: [#krate::Actuator<#scalar>; #n] = [#(#entries),*];
        #resolution_doc
        pub const RESOLUTION: [#scalar; #n] = [#(#resolutions),*];
    }
}
