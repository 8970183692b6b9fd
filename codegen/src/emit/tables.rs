//! The constants of an arm: joint names, limits, units, and the DH table itself.

use super::docs;
use super::tokens::{integer, number};
use super::{Target, angle};
use crate::model::{Convention, Frame, JointKind, LengthUnit, Model, RowKind};
use proc_macro2::TokenStream;
use quote::quote;

/// The constants as associated items of the type.
pub fn associated(model: &Model, target: &Target) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let names = model.joints.iter().map(|joint| &joint.name);
    let limits = limits(model, target);
    let kinds = kinds(model, target);
    let unit = match model.length_unit {
        LengthUnit::Meter => quote!(Meter),
        LengthUnit::Centimeter => quote!(Centimeter),
        LengthUnit::Millimeter => quote!(Millimeter),
        LengthUnit::Inch => quote!(Inch),
    };
    let dh = dh_table(model, target);
    let symbol = model.length_unit.symbol();
    let limits_doc = docs::lines(&format!(
        "Lower and upper limit of every joint, rad (sliding joints: {symbol}); infinite where the file has none."
    ));
    let unit_doc = docs::lines(&format!("Unit of all lengths: {symbol}."));
    let mut text = String::from(
        "The Denavit-Hartenberg table, rows `(a, alpha, d, theta)`; lengths in [`Self::LENGTH_UNIT`], angles in rad.",
    );
    if !model.parameters.is_empty() {
        text += "\nThe parameters are at the values of the arm file; `dh_rows` has those of an arm.";
    }
    let dh_doc = docs::lines(&text);
    quote! {
        /// Number of moving joints.
        pub const DOF: usize = #n;
        /// Names of the joints.
        pub const JOINT_NAMES: [&'static str; #n] = [#(#names),*];
        /// What each joint does.
        pub const JOINT_KINDS: [#krate::JointKind; #n] = #kinds;
        #limits_doc
        pub const LIMITS: [[#scalar; 2]; #n] = #limits;
        #unit_doc
        pub const LENGTH_UNIT: #krate::LengthUnit = #krate::LengthUnit::#unit;
        #dh_doc
        pub const DH: #krate::DhTable = #dh;
    }
}

/// Kinds as an array expression.
fn kinds(model: &Model, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let kind = |kind: JointKind| match kind {
        JointKind::Revolute => quote!(#krate::JointKind::Revolute),
        JointKind::Prismatic => quote!(#krate::JointKind::Prismatic),
    };
    if let [first, rest @ ..] = model.joints.as_slice()
        && rest.iter().all(|joint| joint.kind == first.kind)
    {
        let (kind, n) = (kind(first.kind), integer(model.joints.len()));
        return quote!([#kind; #n]);
    }
    let kinds = model.joints.iter().map(|joint| kind(joint.kind));
    quote!([#(#kinds),*])
}

fn limits(model: &Model, target: &Target) -> TokenStream {
    let scalar = target.scalar.tokens();
    let end = |value: f64| limit(value, &scalar);
    let rows = model.joints.iter().map(|joint| {
        let [low, high] = joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let (low, high) = (end(low), end(high));
        quote!([#low, #high])
    });
    quote!([#(#rows),*])
}

/// The end of a range.
pub(super) fn limit(value: f64, scalar: &TokenStream) -> TokenStream {
    if value == f64::INFINITY {
        quote!(#scalar::INFINITY)
    } else if value == f64::NEG_INFINITY {
        quote!(#scalar::NEG_INFINITY)
    } else {
        number(value)
    }
}

fn dh_table(model: &Model, target: &Target) -> TokenStream {
    let krate = &target.krate;
    // The table is f64 whatever the scalar: it feeds the runtime chain.
    let exact = Target { scalar: super::Scalar::F64, ..target.clone() };
    let convention = match model.convention {
        Convention::Standard => quote!(Standard),
        Convention::Modified => quote!(Modified),
    };
    let rows = model.rows.iter().map(|row| {
        let kind = match row.kind {
            RowKind::Revolute => quote!(revolute),
            RowKind::Prismatic => quote!(prismatic),
            RowKind::Fixed => quote!(fixed),
        };
        let (a, d) = (number(row.a.default_value()), number(row.d.default_value()));
        let (alpha, theta) = (angle::tokens(row.alpha, &exact), angle::tokens(row.theta, &exact));
        quote!(#krate::DhRow::#kind(#a, #alpha, #d, #theta))
    });
    let frame = |frame: &Frame| {
        let xyz = frame.xyz.each_ref().map(|x| number(x.default_value()));
        let rpy = frame.rpy.map(|a| angle::tokens(a, &exact));
        quote!(#krate::DhFrame { xyz: [#(#xyz),*], rpy: [#(#rpy),*] })
    };
    let (base, tool) = (frame(&model.base), frame(&model.tool));
    quote! {
        #krate::DhTable {
            convention: #krate::Convention::#convention,
            rows: &[#(#rows),*],
            base: #base,
            tool: #tool,
        }
    }
}
