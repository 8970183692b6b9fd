//! The whole of an arm: constants, methods and trait impls.

use super::constants::Dimensions;
use super::held_joint::held_joint;
use super::inverse::{Inverse as InverseCode, inverse};
use super::margins::margins;
use super::target_at::target_at;
use super::tokens::integer;
use super::{Target, actuator, combined_limits, coupling, docs, given, kinematics, motion, parameters, paths, tables};
use crate::lower::{Functions, TaskMotion, task_motion};
use crate::model::Model;
use crate::solve::{GivenValues, InversePlan, Unsupported};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The plan of the inverse, or why there is none.
pub type Inverse = Result<InversePlan, Unsupported>;

/// Everything the code is made from.
pub struct Arm<'a> {
    /// The checked arm.
    pub model: &'a Model,
    /// Its kinematic functions.
    pub functions: &'a Functions,
    /// Its plan, or why there is none.
    pub inverse: &'a Inverse,
    /// True if the functions are to exist over lanes, too.
    #[cfg(feature = "batch")]
    pub batch: bool,
}

/// The struct item, for front ends that write a whole file.
pub fn item(arm: &Arm, target: &Target) -> TokenStream {
    let (name, joints) = (&arm.model.name, arm.model.joints.len());
    let doc = format!("The arm `{name}`: {joints} moving joint{}.\n", if joints == 1 { "" } else { "s" });
    parameters::item(arm.model, &docs::lines(&doc), target)
}

/// Docs of the type: the head comment of the file, and why there is no inverse if there is none.
fn impl_doc(arm: &Arm) -> String {
    let comment = arm.model.source.iter().map(|source| docs::escaped(source));
    let unsupported =
        arm.inverse.as_ref().err().map(|unsupported| format!("No inverse kinematics: {}.", unsupported.reason));
    let calibrated = arm.model.calibration.as_ref().map(|calibration| {
        let lines = crate::settings::calibrated(calibration, arm.model);
        let lines: Vec<&str> = lines.iter().map(|line| line.trim_start()).collect();
        let (first, deltas) = lines.split_first().map_or(("", &lines[..0]), |(first, deltas)| (*first, deltas));
        let list: String = deltas.iter().map(|line| format!("\n- {line}")).collect();
        format!("{first}\n{list}")
    });
    comment.chain(calibrated).chain(unsupported).collect::<Vec<String>>().join("\n\n")
}

/// All impls, wrapped so that their constants have names of their own.
pub fn impls(arm: &Arm, target: &Target) -> TokenStream {
    let (model, name) = (arm.model, &target.type_name);
    let functions = kinematics::functions(model, arm.functions, target);
    let mut dimensions = Dimensions::default();
    let linked = coupling::linked(model, target);
    let Functions { forward, jacobian, both, links } = arm.functions;
    let used = [forward, jacobian, both, links].map(|function| &function.straight);
    for straight in used.into_iter().chain(&linked.used) {
        dimensions.collect(straight);
    }
    let inverse_code = match arm.inverse {
        Ok(InversePlan::HeldJoint(plan)) => {
            let mut code = held_joint(model, plan, target);
            code.methods.extend(target_at(model, &plan.outline(), target));
            code
        }
        Ok(InversePlan::Stages(plan)) => {
            // The equations of a measured arm are those of its table, whose dimensions have other values under the same names.
            let mut of_table = Dimensions::default();
            let of_equations = if plan.off_table.is_some() { &mut of_table } else { &mut dimensions };
            of_equations.collect_from(&plan.graph, &plan.inputs());
            let margins = margins(model, plan, target, &mut dimensions);
            let mut code = inverse(model, plan, &of_table.items(model, target), target);
            code.methods.extend([target_at(model, &plan.outline(), target), margins]);
            code
        }
        Err(unsupported) => without_inverse(model, unsupported, target),
    };
    let InverseCode { items, function, methods, trait_impl } = inverse_code;
    let dimensions = dimensions.items(model, target);
    let associated = tables::associated(model, target);
    let motors = [combined_limits::constant(model, target), linked.methods, actuator::methods(model, target)];
    let bound = parameters::methods(model, target);
    let counted = task_motion(model, arm.inverse.as_ref().ok().map(|plan| &plan.outline().task.goal));
    let arm_trait = arm_trait(model, &counted, target);
    let motion = motion::methods(model, &counted, target);
    let doc = docs::lines(&impl_doc(arm));
    #[cfg(feature = "batch")]
    let lanes = arm.batch.then(|| super::batch::impls(model, arm.functions, arm.inverse.as_ref().ok(), target));
    #[cfg(not(feature = "batch"))]
    let lanes = TokenStream::new();
    let body = quote! {
        #dimensions
        #items

        #doc
        impl #name {
            #associated
            #bound
            #functions
            #motion
            #methods
            #(#motors)*
        }

        #function

        #arm_trait
        #trait_impl
        #lanes
    };
    let (imports, body) = paths::shortened(body, &target.krate, name);
    quote! {
        // Numbers are written as the arm file has them or in full precision; names follow the field's notation. No
        // program uses every constant of its arm.
        #[allow(
            clippy::all,
            clippy::pedantic,
            dead_code,
            unused_doc_comments,
            non_snake_case,
            reason = "generated code"
        )]
        const _: () = {
            #imports
            #body
        };
    }
}

fn arm_trait(model: &Model, counted: &TaskMotion, target: &Target) -> TokenStream {
    let (krate, scalar, name, n) =
        (&target.krate, target.scalar.tokens(), &target.type_name, integer(model.joints.len()));
    let motion = motion::trait_methods(model, counted, target);
    quote! {
        #[automatically_derived]
        impl #krate::Arm<#scalar, #n> for #name {
            #krate::delegate_arm!(#name, #scalar, #n);
            #motion
        }
    }
}

/// An arm without an inverse has the methods all the same: a call says why it does not compile.
fn without_inverse(model: &Model, unsupported: &Unsupported, target: &Target) -> InverseCode {
    let name = &target.type_name;
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    // What it returns lets the rest of the call type-check: the message is the only error.
    let none = quote!(#krate::Solutions<#scalar, #n, 1>);
    let note = unsupported.hint.clone().unwrap_or_else(|| "`denhart::numeric` solves any arm by iteration".to_owned());
    let message = format!("`{name}` has no inverse kinematics: {}", unsupported.reason);
    let values = GivenValues::of(&model.inverse.redundant, &model.joints);
    let given = given::kind(&values, target).map(|kind| quote!(, _given: #kind));
    let solvable = format_ident!("{name}HasInverse");
    let doc = docs::lines(&format!("Does not compile: {}.", unsupported.reason));
    InverseCode {
        items: quote! {
            /// Implemented by nothing: its message says why there is no inverse.
            #[diagnostic::on_unimplemented(
                message = #message,
                label = "this arm has no inverse kinematics",
                note = #note
            )]
            pub trait #solvable {}
        },
        function: TokenStream::new(),
        trait_impl: TokenStream::new(),
        methods: quote! {
            /// There is no inverse.
            pub const MAX_SOLUTIONS: usize = 0;

            #doc
            pub fn inverse<Target: #solvable>(&self, _target: Target #given) -> #none {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }

            #doc
            pub fn inverse_into<Target: #solvable, List>(&self, _target: Target #given, _solutions: &mut List) {}

            #doc
            pub fn inverse_branch<Target: #solvable>(
                &self,
                _target: Target,
                _branch: #krate::Branch,
            ) -> ::core::result::Result<#krate::Solution<#scalar, #n>, #krate::Status<#scalar>> {
                ::core::result::Result::Err(#krate::Status::BadTarget)
            }

            #doc
            pub fn inverse_near<Target: #solvable>(&self, _target: Target, _q_ref: &[#scalar; #n]) -> #none {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }

            #doc
            pub fn inverse_near_into<Target: #solvable, List>(
                &self,
                _target: Target,
                _q_ref: &[#scalar; #n],
                _solutions: &mut List,
            ) {
            }

            #doc
            pub fn target_at<Joints: #solvable>(&self, _q: &Joints) -> #krate::Pose<#scalar> {
                #krate::Pose::identity()
            }
        },
    }
}
