//! The inverse of a task from outside: its target, and how the search sees that.

use super::tokens::{array, bound, ident, integer, number};
use super::{Target, angle};
use crate::lower::{Goal, Inverse};
use crate::model::{Axis, Model};
use crate::symbolic::Input;
use proc_macro2::TokenStream;
use quote::quote;

/// The target of a plan's task.
pub struct TaskCode {
    /// Type of the target, as of [`target_type`].
    pub target: TokenStream,
    /// One sentence about it.
    pub doc: String,
    /// The conditions of a bad target, as they follow "if the target".
    pub bad: &'static str,
    /// A reference to the runtime's `Goal` of the target.
    pub goal: TokenStream,
    /// Statements that bind the target's symbols.
    pub unpack: TokenStream,
}

/// Type of a task's target, without what is given beside it.
pub fn target_type(goal: &Goal, target: &Target) -> TokenStream {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    match goal {
        Goal::Pose => quote!(#krate::Pose<#scalar>),
        Goal::Position => quote!([#scalar; 3]),
        Goal::PositionAxis { .. } => quote!(#krate::PointAxis<#scalar>),
        Goal::PositionAngle { .. } => quote!(#krate::PointAngle<#scalar>),
        Goal::PlanarPose => quote!(#krate::PlanarPose<#scalar>),
        Goal::PlanarPosition => quote!([#scalar; 2]),
    }
}

/// The code of a program's task.
pub fn task(model: &Model, program: &Inverse, target: &Target) -> TaskCode {
    let (krate, target_type) = (&target.krate, target_type(&program.goal, target));
    let unit = model.length_unit.symbol();
    let pattern = |input: Input| bound(&input.name(), program.reads(input));
    let field = |input: Input| {
        let (field, name) = (ident(&input.name()), pattern(input));
        if program.reads(input) { quote!(#field) } else { quote!(#field: #name) }
    };
    let position = Input::POSITION.map(pattern);
    let rows = Input::ROTATION.map(|row| array(row.map(pattern)));
    let frame = |from: TokenStream| {
        quote! {
            let [#(#rows),*] = #from.rotation;
            let [#(#position),*] = #from.translation;
        }
    };
    match &program.goal {
        Goal::Position => TaskCode {
            target: target_type,
            doc: format!("`target`: where the tool point is to be, base frame, {unit}, `[3]`."),
            bad: "is not finite",
            goal: quote!(target),
            unpack: quote!(let [#(#position),*] = *target;),
        },
        Goal::PositionAxis { column } => {
            let letter = Axis::letter(*column);
            let column = integer(*column);
            let unpack = frame(quote!(frame));
            TaskCode {
                target: target_type,
                doc: format!(
                    "`target`: where the tool point is to be ({unit}) and where the tool's {letter} axis is to point, \
                     base frame; the direction is normalized."
                ),
                bad: "is not finite or its direction shorter than 1e-12",
                goal: quote!(&#krate::solve::Pointing::new(target, #column)),
                unpack: quote!(let frame = goal.frame(); #unpack),
            }
        }
        Goal::PositionAngle { signs, offset } => {
            let (signs, offset) = (signs.iter().copied().map(number), angle::tokens(*offset, target));
            let goal = quote!(#krate::solve::InPlane::new(target, [#(#signs),*], #offset));
            TaskCode {
                target: target_type,
                doc: format!(
                    "`target`: where the tool point is to be (base frame, {unit}) and the sum of the pitch joints with \
                     their DH offsets (rad)."
                ),
                bad: "is not finite",
                goal: quote!(&#goal),
                unpack: {
                    let (angle, sin, cos) = (field(Input::Angle), pattern(Input::SinAngle), pattern(Input::CosAngle));
                    quote! {
                        let target = target.wrapped();
                        let #krate::PointAngle { point: [#(#position),*], #angle } = target;
                        let (#sin, #cos) = #krate::math::sin_cos(target.angle);
                    }
                },
            }
        }
        Goal::PlanarPose => TaskCode {
            target: target_type,
            doc: format!(
                "`target`: position of the tool in the base frame's xy plane ({unit}) and direction of its x axis there (rad)."
            ),
            bad: "is not finite",
            goal: quote!(target),
            unpack: {
                let ([px, py, _], phi) = (&position, field(Input::Phi));
                let (sin, cos) = (pattern(Input::SinPhi), pattern(Input::CosPhi));
                quote! {
                    let target = target.wrapped();
                    let #krate::PlanarPose { x: #px, y: #py, #phi } = target;
                    let (#sin, #cos) = #krate::math::sin_cos(target.phi);
                }
            },
        },
        Goal::PlanarPosition => TaskCode {
            target: target_type,
            doc: format!("`target`: where the tool point is to be in the base frame's xy plane, {unit}, `[2]`."),
            bad: "is not finite",
            goal: quote!(target),
            unpack: {
                let [px, py, _] = &position;
                quote!(let [#px, #py] = *target;)
            },
        },
        Goal::Pose => TaskCode {
            target: target_type,
            doc: format!(
                "`target`: pose of the tool in the base frame, position in {unit}. A rotation that is off by at most 1e-3 \
                 stands for the nearest one; `deviation()` of the solutions says how far off it was."
            ),
            bad: "is not finite or its rotation is off by more",
            goal: quote!(target),
            unpack: frame(quote!(goal)),
        },
    }
}
