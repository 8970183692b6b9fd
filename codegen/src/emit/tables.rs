//! The constants of an arm: joint names, limits, units, and the DH table itself.

use super::docs;
use super::tokens::{array, integer, number};
use super::{Scalar, Target, angle};
use crate::lower;
use crate::model::{Angle, Convention, Frame, Joint, JointKind, Length, LengthUnit, Model, Row, RowKind};
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
    let [velocities, accelerations] = rates(model, target);
    let rate_doc = |what: &str, unit: &str| {
        docs::lines(&format!(
            "Greatest {what} of every joint, rad/{unit} (sliding joints: {symbol}/{unit}); infinite where the file has none."
        ))
    };
    let (velocity_doc, acceleration_doc) = (rate_doc("velocity", "s"), rate_doc("acceleration", "s^2"));
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
        /// Kinds of the joints in order: revolute or prismatic.
        pub const JOINT_KINDS: [#krate::JointKind; #n] = #kinds;
        #limits_doc
        pub const LIMITS: [[#scalar; 2]; #n] = #limits;
        #velocity_doc
        pub const MAX_VELOCITY: [#scalar; #n] = #velocities;
        #acceleration_doc
        pub const MAX_ACCELERATION: [#scalar; #n] = #accelerations;
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
    array(model.joints.iter().map(|joint| kind(joint.kind)))
}

fn limits(model: &Model, target: &Target) -> TokenStream {
    let scalar = target.scalar.tokens();
    array(lower::limits(model).into_iter().map(|ends| array(ends.map(|end| limit(end, &scalar)))))
}

/// Greatest velocities and accelerations as array expressions.
fn rates(model: &Model, target: &Target) -> [TokenStream; 2] {
    let (scalar, n) = (target.scalar.tokens(), integer(model.joints.len()));
    let array = |rate: fn(&Joint) -> f64| {
        if model.joints.iter().all(|joint| rate(joint).is_infinite()) {
            return quote!([#scalar::INFINITY; #n]);
        }
        array(model.joints.iter().map(|joint| limit(rate(joint), &scalar)))
    };
    [array(|joint| joint.max_velocity), array(|joint| joint.max_acceleration)]
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
    let convention = match model.convention {
        Convention::Standard => quote!(Standard),
        Convention::Modified => quote!(Modified),
    };
    let length = |length: &Length| number(length.default_value());
    let rows = array(model.rows.iter().map(|row| dh_row(row, length, target)));
    let [base, tool] = [&model.base, &model.tool].map(|frame| dh_frame(frame, length, target));
    quote! {
        #krate::DhTable {
            convention: #krate::Convention::#convention,
            rows: &#rows,
            base: #base,
            tool: #tool,
        }
    }
}

/// The table is f64 whatever the scalar: it feeds the runtime chain.
fn rad(angle: Angle, target: &Target) -> TokenStream {
    angle::tokens(angle, &Target { scalar: Scalar::F64, ..target.clone() })
}

/// A row of the table, its lengths as they are written by `length`.
pub fn dh_row(row: &Row, length: impl Fn(&Length) -> TokenStream, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let kind = match row.kind {
        RowKind::Revolute => quote!(revolute),
        RowKind::Prismatic => quote!(prismatic),
        RowKind::Fixed => quote!(fixed),
    };
    let (a, d) = (length(&row.a), length(&row.d));
    let (alpha, theta) = (rad(row.alpha, target), rad(row.theta, target));
    quote!(#krate::DhRow::#kind(#a, #alpha, #d, #theta))
}

/// A constant frame of the table.
pub fn dh_frame(frame: &Frame, length: impl Fn(&Length) -> TokenStream, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let (xyz, rpy) = (array(frame.xyz.iter().map(length)), array(frame.rpy.map(|angle| rad(angle, target))));
    quote!(#krate::DhFrame { xyz: #xyz, rpy: #rpy })
}
