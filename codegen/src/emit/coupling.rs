//! Linked joints: motor values from joint values and back, and the Jacobian of the motor rates.

use super::Target;
use super::docs;
use super::tokens::{Writer, ident, integer};
use crate::lower::{self, Linear, Straight};
use crate::model::{Coupling, JointKind, Model, joint_sum};
use proc_macro2::TokenStream;
use quote::quote;

/// The methods, and the expressions they use (for the dimensions to declare).
pub struct Linked {
    /// The methods.
    pub methods: TokenStream,
    /// The expressions.
    pub used: Vec<Straight>,
}

/// Nothing for an arm whose motors are its joints.
pub fn linked(model: &Model, target: &Target) -> Linked {
    match (&model.coupling, lower::linked(model)) {
        (Some(coupling), Some(linked)) => {
            let methods = methods(model, coupling, target, &linked);
            Linked { methods, used: vec![linked.to_motor.straight, linked.from_motor.straight] }
        }
        _ => Linked { methods: TokenStream::new(), used: Vec::new() },
    }
}

fn methods(model: &Model, coupling: &Coupling, target: &Target, linked: &lower::Linked) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let [to_body, from_body, columns] =
        [&linked.to_motor, &linked.from_motor, &linked.row].map(|linear| body(linear, target));
    let pattern = |letter: &str| {
        let names = (1..=model.joints.len()).map(|number| ident(&format!("{letter}{number}")));
        quote!([#(#names),*])
    };
    let [q, m, j] = ["q", "m", "j"].map(pattern);
    let joints = docs::joints(model);
    let slides = model.joints.iter().any(|joint| joint.kind == JointKind::Prismatic);
    let unit = if slides {
        format!("each in the unit of its joint (rad or {})", model.length_unit.symbol())
    } else {
        "rad".into()
    };
    let equations = equations(model, coupling);
    let motors = format!("{unit}, `[{n}]`");
    let to_doc = docs::lines(&format!(
        "Motor values at joint values `q`, {motors}: `motor = A q + b`.\n\n{joints}\n{equations}"
    ));
    let from_doc = docs::lines(&format!(
        "Joint values at motor values, {motors}: `q = A^-1 (motor - b)`, the inverse folded into the code.\n\n\
         The way back from `to_motor`; whole turns are kept."
    ));
    let jacobian_doc = docs::lines(&format!(
        "Geometric Jacobian with respect to the motors: `J(q) A^-1`, the tool's velocity for each motor's rate.\n\n\
         {joints} Rows `vx vy vz wx wy wz` in the base frame at the tool point, as `jacobian`; one column a motor, \
         `6 x {n}`. Its transpose gives the motors' torques that hold a force at the tool."
    ));
    quote! {
        #to_doc
        #[inline]
        #[must_use]
        pub fn to_motor(&self, q: &[#scalar; #n]) -> [#scalar; #n] {
            let #q = *q;
            #to_body
        }

        #from_doc
        #[inline]
        #[must_use]
        pub fn from_motor(&self, motor: &[#scalar; #n]) -> [#scalar; #n] {
            let #m = *motor;
            #from_body
        }

        #jacobian_doc
        #[inline]
        #[must_use]
        pub fn motor_jacobian(&self, q: &[#scalar; #n]) -> #krate::Jacobian<#scalar, #n> {
            let rows = self.jacobian(q).rows;
            #krate::Jacobian { rows: rows.map(|#j| { #columns }) }
        }
    }
}

/// The statements that the roots share, and the array of the roots.
fn body(linear: &Linear, target: &Target) -> TokenStream {
    let straight = &linear.straight;
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate: &target.krate, lanes: false };
    let statements = straight.shared.iter().map(|shared| writer.statement(*shared));
    let values = straight.roots.iter().map(|root| writer.write(*root));
    quote! {
        #(#statements)*
        [#(#values),*]
    }
}

/// The motors that are not their joints, as equations.
fn equations(model: &Model, coupling: &Coupling) -> String {
    let mut text = String::from("\n");
    for (index, (row, offset)) in coupling.matrix.iter().zip(&coupling.offset).enumerate() {
        let own = row.iter().enumerate().all(|(column, factor)| *factor == if column == index { 1.0 } else { 0.0 });
        if own && *offset == 0.0 {
            continue;
        }
        let offset = (*offset != 0.0).then(|| offset.to_string());
        let sum = joint_sum(row, offset, |factor| factor.to_string());
        let name = model.joints.get(index).map_or("", |joint| joint.name.as_str());
        let named = if name == format!("q{}", index + 1) { String::new() } else { format!(" ({name})") };
        text += &format!("- motor {}{named}: `{sum}`\n", index + 1);
    }
    text
}
