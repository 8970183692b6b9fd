//! The method `target_at`: the target of the arm's task at joint values.

use super::task::target_type;
use super::tokens::{bound, ident, integer};
use super::{Target, angle, docs, given};
use crate::lower::Goal;
use crate::model::Model;
use crate::solve::Outline;
use crate::symbolic::AngleSum;
use proc_macro2::TokenStream;
use quote::quote;

/// The method.
pub fn target_at(model: &Model, outline: &Outline, target: &Target) -> TokenStream {
    let (scalar, n, goal) = (target.scalar.tokens(), integer(outline.joints), &outline.task.goal);
    let (target_type, body) = (target_type(goal, target), body(outline, target));
    let given = &outline.task.given;
    let (names, words) = (given::names(given), given::in_words(given));
    let names: Vec<String> = names.iter().map(ToString::to_string).collect();
    let call = match names.as_slice() {
        [] => "`inverse(&target)`".to_owned(),
        names if given.is_list => format!("`inverse(&target, [{}])` with the {words} of `q`", names.join(", ")),
        names => format!("`inverse(&target, {})` with the {words} of `q`", names.concat()),
    };
    let doc = docs::lines(&format!(
        "The target of the task `{}` at joint values `q`.\n\n\
         {} Away from singularities {call} lists `q`, its angles brought into (-pi, pi].",
        goal.task().name(),
        docs::joints(model),
    ));
    quote! {
        #doc
        #[inline]
        #[must_use]
        pub fn target_at(&self, q: &[#scalar; #n]) -> #target_type {
            #body
        }
    }
}

fn body(outline: &Outline, target: &Target) -> TokenStream {
    let krate = &target.krate;
    match &outline.task.goal {
        Goal::Pose => quote!(self.forward(q)),
        Goal::Position => quote!(self.forward(q).translation),
        Goal::PositionAxis { column } => {
            let column = integer(*column);
            quote! {
                let pose = self.forward(q);
                #krate::PointAxis::new(pose.translation, pose.rotation.map(|row| row[#column]))
            }
        }
        goal @ Goal::PositionAngle { .. } => {
            let sum = goal.angle_sum().unwrap_or_else(AngleSum::zero);
            let turns = |joint: usize| sum.terms.iter().any(|(term, _)| *term == joint);
            let name = |joint: usize| format!("q{}", joint + 1);
            let joints = (0..outline.joints).map(|joint| bound(&name(joint), turns(joint)));
            let terms = sum.terms.iter().map(|(joint, negative)| (ident(&name(*joint)), *negative));
            let angle = angle::sum(terms, sum.constant, target);
            quote! {
                let [#(#joints),*] = *q;
                #krate::PointAngle::new(self.forward(q).translation, #krate::math::wrap(#angle))
            }
        }
        Goal::PlanarPose => quote! {
            let #krate::Pose { rotation: [[c, ..], [s, ..], _], translation: [x, y, _] } = self.forward(q);
            #krate::PlanarPose::new(x, y, #krate::math::atan2(s, c))
        },
        Goal::PlanarPosition => quote! {
            let [x, y, _] = self.forward(q).translation;
            [x, y]
        },
    }
}
