//! Values given beside the target: how the code takes them, names them and passes them on.
//!
//! One value is an argument of its own, `q3`. Those of a list are an array, `given`, which the functions inside take apart.

use super::Target;
use super::tokens::{array, ident, integer};
use crate::model::Model;
use crate::solve::{Given, GivenValues, Outline};
use crate::symbolic::Input;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

impl Given {
    /// The name of the value.
    fn name(self) -> Ident {
        match self {
            Given::ArmAngle => ident("arm_angle"),
            Given::Joint { joint, .. } => ident(&Input::Given(joint).name()),
        }
    }
}

/// The names of the values; none where nothing is given.
pub fn names(values: &GivenValues) -> Vec<Ident> {
    values.values.iter().map(|given| given.name()).collect()
}

/// The names in words: `q1` and `q4`.
pub fn in_words(values: &GivenValues) -> String {
    let names: Vec<String> = names(values).iter().map(|name| format!("`{name}`")).collect();
    match names.as_slice() {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.concat(),
    }
}

/// One of these, of one value or a list; nothing where nothing is given.
fn either(
    values: &GivenValues,
    one: impl FnOnce(&Ident) -> TokenStream,
    list: impl FnOnce(&[Ident]) -> TokenStream,
) -> Option<TokenStream> {
    let names = names(values);
    match names.first() {
        None => None,
        Some(_) if values.is_list => Some(list(&names)),
        Some(name) => Some(one(name)),
    }
}

/// The type of the argument.
pub fn kind(values: &GivenValues, target: &Target) -> Option<TokenStream> {
    let (scalar, count) = (target.scalar.tokens(), integer(values.values.len()));
    either(values, |_| quote!(#scalar), |_| quote!([#scalar; #count]))
}

/// The argument of a method: `q3: f64`, `given: [f64; 2]`.
pub fn argument(values: &GivenValues, target: &Target) -> Option<TokenStream> {
    let kind = kind(values, target)?;
    either(values, |name| quote!(#name: #kind), |_| quote!(given: #kind))
}

/// The argument of a function that reads the values: `q3: f64`, `[q1, q4]: [f64; 2]`.
pub fn parameter(values: &GivenValues, target: &Target) -> Option<TokenStream> {
    let kind = kind(values, target)?;
    either(values, |name| quote!(#name: #kind), |names| quote!([#(#names),*]: #kind))
}

/// The argument as a method passes it to another one.
pub fn passed(values: &GivenValues) -> Option<TokenStream> {
    either(values, |name| quote!(#name), |_| quote!(given))
}

/// The statement that takes an array apart, for [`wrapped`] and [`collected`].
pub fn unpacked(values: &GivenValues) -> Option<TokenStream> {
    values.is_list.then(|| {
        let names = names(values);
        quote!(let [#(#names),*] = given;)
    })
}

/// The values by their names, as they are passed on.
pub fn collected(values: &GivenValues) -> Option<TokenStream> {
    either(values, |name| quote!(#name), |names| array(names.iter()))
}

/// The values by their names, with angles of joints in (-pi, pi]: sums with a given angle lose no digits to its turns.
pub fn wrapped(values: &GivenValues, target: &Target) -> Option<TokenStream> {
    let krate = &target.krate;
    let each = |given: &Given| {
        let name = given.name();
        let turns = matches!(given, Given::Joint { revolute: true, .. });
        if turns { quote!(#krate::solve::wrap(#name)) } else { quote!(#name) }
    };
    let each: Vec<TokenStream> = values.values.iter().map(each).collect();
    either(values, |_| quote!(#(#each)*), |_| array(each.iter()))
}

/// The statements that bind the values at a joint vector `q_ref`.
pub fn from_reference(values: &GivenValues) -> TokenStream {
    let last = values.joints().map(|(joint, _)| joint).max();
    let joints = last.map(|last| {
        let places = (0..=last).map(|joint| match values.holds(joint) {
            true => Given::Joint { joint, revolute: true }.name(),
            false => ident("_"),
        });
        quote!(let [#(#places,)* ..] = *q_ref;)
    });
    let angle = values.values.contains(&Given::ArmAngle);
    let angle = angle.then(|| quote!(let arm_angle = self.arm_angle(q_ref);));
    quote!(#joints #angle)
}

/// The values at a joint vector `q` of `arm`, for the macro that implements the trait.
pub fn at_joints(values: &GivenValues) -> Option<TokenStream> {
    let each = |given: &Given| match given {
        Given::ArmAngle => quote!(arm.arm_angle(q)),
        Given::Joint { joint, .. } => {
            let joint = integer(*joint);
            quote!(q[#joint])
        }
    };
    let each: Vec<TokenStream> = values.values.iter().map(each).collect();
    let arm = if values.values.contains(&Given::ArmAngle) { ident("arm") } else { ident("_arm") };
    let count = integer(each.len());
    either(
        values,
        |_| quote!(, given |#arm, q| #(#each)*),
        |_| {
            let each = array(each.iter());
            quote!(, given [#count] |#arm, q| #each)
        },
    )
}

/// The statements that bind `locked`, the goal in which the joints with given values do not move.
pub fn locked(outline: &Outline, target: &Target) -> Option<TokenStream> {
    let krate = &target.krate;
    // The arm angle holds no joint: a number beyond the last.
    let joint = |given: &Given| match given {
        Given::Joint { joint, .. } => integer(*joint),
        Given::ArmAngle => integer(outline.joints),
    };
    let values = &outline.task.given;
    let joints: Vec<_> = values.values.iter().map(joint).collect();
    either(
        values,
        |name| quote!(let locked = &#krate::solve::Locked::new(goal, #(#joints)*, #name);),
        |names| {
            quote! {
                let held = [#((#joints, #names)),*];
                let locked = &#krate::solve::AllLocked::new(goal, &held);
            }
        },
    )
}

/// Limits of a value, and half of the range that it has without limits: for the walk over all values.
pub fn range(model: &Model, given: Given, target: &Target) -> (TokenStream, TokenStream) {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let turn = quote!(<#scalar as #krate::Scalar>::PI);
    match given {
        Given::ArmAngle => (quote!([-#turn, #turn]), turn),
        Given::Joint { joint, revolute } => {
            let joint = integer(joint);
            let whole = match revolute {
                true => turn,
                false if model.parameters.is_empty() => quote!(REACH),
                false => quote!(reach(self)),
            };
            (quote!(Self::LIMITS[#joint]), whole)
        }
    }
}
