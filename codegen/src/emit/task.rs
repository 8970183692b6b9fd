//! What the inverse of a task looks like from outside: its target, and how the search sees it.

use super::tokens::{ident, integer, number};
use super::{Target, angle};
use crate::model::{Angle, Axis, Model, Task};
use crate::solve::Plan;
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashSet;

/// The target of a plan's task.
pub struct TaskCode {
    /// Type of the target without the value of a locked joint.
    pub target: TokenStream,
    /// One sentence about it.
    pub doc: String,
    /// What makes a target a bad one, after "if the target".
    pub bad: &'static str,
    /// Statements before the search; after them `goal` is a reference to what is searched for.
    pub goal: TokenStream,
    /// The same for one residual, after `forward`.
    pub check: TokenStream,
    /// Statements that bind the target's symbols.
    pub unpack: TokenStream,
}

/// The code of a plan's task; `used` are the symbols that the plan reads.
pub fn task(model: &Model, plan: &Plan, target: &Target, used: &HashSet<String>) -> TaskCode {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let unit = model.length_unit.symbol();
    let field = |name: &str| {
        let (field, unused) = (ident(name), ident(&format!("_{name}")));
        if used.contains(name) { quote!(#field) } else { quote!(#field: #unused) }
    };
    let pattern = |name: &str| if used.contains(name) { ident(name) } else { ident(&format!("_{name}")) };
    let position = ["px", "py", "pz"].map(&pattern);
    let rows = (1..=3).map(|i| {
        let entries = (1..=3).map(|j| pattern(&format!("r{i}{j}")));
        quote!([#(#entries),*])
    });
    let frame = |from: TokenStream| {
        quote! {
            let [#(#rows),*] = #from.rotation;
            let [#(#position),*] = #from.translation;
        }
    };
    match plan.task.task {
        Task::Position => TaskCode {
            target: quote!([#scalar; 3]),
            doc: format!("`target`: where the tool point is to be, base frame, {unit}, `[3]`."),
            bad: "is not finite",
            goal: quote!(let goal = target;),
            check: quote!(target),
            unpack: quote!(let [#(#position),*] = *target;),
        },
        Task::PositionAxis => {
            let (column, letter) = match plan.task.axis {
                Axis::X => (0, "x"),
                Axis::Y => (1, "y"),
                Axis::Z => (2, "z"),
            };
            let column = integer(column);
            let unpack = frame(quote!(frame));
            TaskCode {
                target: quote!(#krate::PointAxis<#scalar>),
                doc: format!(
                    "`target`: where the tool point is to be ({unit}) and where the tool's {letter} axis is to point, \
                     base frame; the direction is normalized."
                ),
                bad: "is not finite or its direction shorter than 1e-12",
                goal: quote!(let goal = &#krate::solve::Pointing::new(target, #column);),
                check: quote!(&#krate::solve::Pointing::new(target, #column)),
                unpack: quote!(let frame = goal.frame(); #unpack),
            }
        }
        Task::PositionAngle => {
            let (signs, offset) = plan.task.angle.clone().unwrap_or((Vec::new(), Angle::ZERO));
            let (signs, offset) = (signs.into_iter().map(number), angle::tokens(offset, target));
            let goal = quote!(#krate::solve::InPlane::new(target, [#(#signs),*], #offset));
            TaskCode {
                target: quote!(#krate::PointAngle<#scalar>),
                doc: format!(
                    "`target`: where the tool point is to be (base frame, {unit}) and the sum of the pitch joints with \
                     their DH offsets (rad)."
                ),
                bad: "is not finite",
                goal: quote!(let goal = &#goal;),
                check: quote!(&#goal),
                unpack: {
                    let (angle, sin, cos) = (field("angle"), pattern("sin_angle"), pattern("cos_angle"));
                    quote! {
                        let #krate::PointAngle { point: [#(#position),*], #angle } = *target;
                        let (#sin, #cos) = #krate::math::sin_cos(target.angle);
                    }
                },
            }
        }
        Task::PlanarPose => TaskCode {
            target: quote!(#krate::PlanarPose<#scalar>),
            doc: format!(
                "`target`: position of the tool in the base frame's xy plane ({unit}) and direction of its x axis there (rad)."
            ),
            bad: "is not finite",
            goal: quote!(let goal = target;),
            check: quote!(target),
            unpack: {
                let ([px, py, _], phi) = (&position, field("phi"));
                let (sin, cos) = (pattern("sin_phi"), pattern("cos_phi"));
                quote! {
                    let #krate::PlanarPose { x: #px, y: #py, #phi } = *target;
                    let (#sin, #cos) = #krate::math::sin_cos(target.phi);
                }
            },
        },
        Task::PlanarPosition => TaskCode {
            target: quote!([#scalar; 2]),
            doc: format!("`target`: where the tool point is to be in the base frame's xy plane, {unit}, `[2]`."),
            bad: "is not finite",
            goal: quote!(let goal = target;),
            check: quote!(target),
            unpack: {
                let [px, py, _] = &position;
                quote!(let [#px, #py] = *target;)
            },
        },
        Task::Pose => TaskCode {
            target: quote!(#krate::Pose<#scalar>),
            doc: format!(
                "`target`: pose of the tool in the base frame, position in {unit}. A rotation that is off by at most 1e-3 \
                 stands for the nearest one; `deviation()` of the solutions says how far off it was."
            ),
            bad: "is not finite or its rotation is off by more",
            goal: quote! {
                let nearest = #krate::solve::nearest_rotation(target, &mut solutions);
                let goal = nearest.as_ref().unwrap_or(target);
            },
            check: quote!(target),
            unpack: frame(quote!(goal)),
        },
    }
}
