//! Constants of the solvers that hold a joint, as code.

use super::Target;
use super::tokens::{array, integer, number};
use crate::model::numeric::Transform;
use crate::solve::SixJoints;
use denhart_core::general::{COORDINATES, Cut, Cuts, Elimination, General};
use denhart_core::meet::{Meet, Structure};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The links of six joints as constants `C0` to `C6`, those whose place `is_read`; behind a given joint `C2_1`.
pub fn chain_constants(six: &SixJoints, is_read: impl Fn(usize) -> bool, target: &Target) -> TokenStream {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let mut items = TokenStream::new();
    let solved = |place: usize| six.solved.get(place).map(|joint| joint + 1);
    let mut add = |name: String, doc: String, value: &Transform| {
        let (name, doc) = (format_ident!("{name}"), format!(" {doc}"));
        let value = transform(&denhart_core::Transform { rotation: value.r, translation: value.p }, target);
        items.extend(quote! {
            #[doc = #doc]
            const #name: #krate::held_joint::Transform<#scalar> = #value;
        });
    };
    for (place, link) in six.links.iter().enumerate().filter(|(place, _)| is_read(*place)) {
        let before = place.checked_sub(1).and_then(solved);
        let mut behind = before.map_or("The base".to_owned(), |joint| format!("Behind joint {joint}"));
        let next = solved(place).map_or("the tool".to_owned(), |joint| format!("joint {joint}"));
        let mut name = format!("C{place}");
        let mut value = &link.first;
        for (number, joint) in link.given.iter().enumerate() {
            add(name, format!("{behind}, up to joint {}, which is given.", joint.joint + 1), value);
            behind = format!("Behind joint {}", joint.joint + 1);
            name = format!("C{place}_{}", number + 1);
            value = &joint.after;
        }
        add(name, format!("{behind}, up to {next}."), value);
    }
    items
}

/// A rigid transform.
fn transform(value: &denhart_core::Transform<f64>, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let (rotation, translation) = (rows(&value.rotation), numbers(&value.translation));
    quote!(#krate::held_joint::Transform { rotation: #rotation, translation: #translation })
}

fn numbers(values: &[f64]) -> TokenStream {
    array(values.iter().map(|value| number(*value)))
}

fn rows<const K: usize>(values: &[[f64; K]]) -> TokenStream {
    array(values.iter().map(|row| numbers(row)))
}

fn indices(values: &[usize]) -> TokenStream {
    array(values.iter().map(|value| integer(*value)))
}

/// Where a chain has its axes that meet and its parallel axes.
pub fn structure(value: &Structure, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let Structure { joints, is_mirrored, is_antiparallel, is_constant } = value;
    let joints = indices(joints);
    quote! {
        #krate::held_joint::meet::Structure {
            joints: #joints,
            is_mirrored: #is_mirrored,
            is_antiparallel: #is_antiparallel,
            is_constant: #is_constant,
        }
    }
}

/// The constants of the solver `meet`.
pub fn meet(value: &Meet<f64>, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let Meet { is_antiparallel, has_equal_pairs, .. } = value;
    let joints = indices(&value.joints);
    let [point, normal, side] = [&value.point, &value.normal, &value.side].map(|vector| numbers(vector));
    let h_xy = numbers(&value.h_xy);
    let [k4, k5] = [&value.k4, &value.k5].map(|rotation| rows(rotation));
    macro_rules! fields {
        ($($field:ident)*) => {{
            $(let $field = number(value.$field);)*
            quote! {
                #krate::held_joint::meet::Meet {
                    /// The joints x1, x2, x3, x4, u, v of the ring, from 0: x1 is held, x3 is parallel to x4, u meets v in W.
                    joints: #joints,
                    is_antiparallel: #is_antiparallel,
                    /// The equation is a square: its root of degree 4 takes its place.
                    has_equal_pairs: #has_equal_pairs,
                    /// W, the axis of v and a direction across it, seen from behind v.
                    point: #point,
                    normal: #normal,
                    side: #side,
                    /// The parallel axes, seen from behind x2: their component across its axis, and along it.
                    h_xy: #h_xy,
                    $($field: #$field,)*
                    k4: #k4,
                    k5: #k5,
                }
            }
        }};
    }
    fields!(reach h_z eta across_x across_y height upper lower ratio_x ratio_y tilt cos_alpha x3_offset x4_offset lower_angle)
}

/// Where the ring of joints is cut.
fn cut(value: Cut, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let Cut { d, is_backward, is_swapped } = value;
    let d = integer(usize::from(d));
    quote!(#krate::held_joint::general::Cut { d: #d, is_backward: #is_backward, is_swapped: #is_swapped })
}

/// The cuts of an arm.
pub fn cuts(value: &Cuts, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let first = cut(value.first, target);
    let [second, third] = [value.second, value.third].map(|own| option(own.map(|own| cut(own, target))));
    quote!(#krate::held_joint::general::Cuts { first: #first, second: #second, third: #third })
}

fn option(value: Option<TokenStream>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}

/// The constants of the solver `general`, as items.
pub fn general(value: &General, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let name = |number: &str| format_ident!("{number}");
    let item = |identifier: &str, doc: &str, value: &Elimination| {
        let (name, value) = (name(identifier), elimination(value, target));
        quote! {
            #[doc = #doc]
            const #name: #krate::held_joint::general::Elimination = #value;
        }
    };
    let first_doc = " The first cut: constants of the equations in the held joint c and the joints e and f.";
    let first = item("FIRST", first_doc, &value.first);
    let second_doc = " The second cut, which holds another joint: for targets at which roots of the first one meet.";
    let second = value.second.as_ref().map(|second| item("SECOND", second_doc, second));
    let third_doc = " The third cut, for targets at which roots of the second one meet, too.";
    let third = value.third.as_ref().map(|third| item("THIRD", third_doc, third));
    let second_named = option(value.second.as_ref().map(|_| quote!(SECOND)));
    let third_named = option(value.third.as_ref().map(|_| quote!(THIRD)));
    quote! {
        #first
        #second
        #third
        /// The cuts in their order.
        const GENERAL: #krate::held_joint::general::General = #krate::held_joint::general::General {
            first: FIRST,
            second: #second_named,
            third: #third_named,
        };
    }
}

/// Rows over the coordinates of a line.
fn coordinate_rows(rows: &[[f64; COORDINATES]], target: &Target) -> TokenStream {
    let krate = &target.krate;
    array(rows.iter().map(|[px, py, pz, lx, ly, lz, square, product, mx, my, mz, ix, iy, iz]| {
        let vectors = [[px, py, pz], [lx, ly, lz], [mx, my, mz], [ix, iy, iz]];
        let [point, direction, moment, image] = vectors.map(|vector| numbers(&vector.map(|x| *x)));
        let products = numbers(&[*square, *product]);
        quote!(#krate::held_joint::general::row(#point, #direction, #products, #moment, #image))
    }))
}

fn elimination(value: &Elimination, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let cut = cut(value.cut, target);
    let ring = array(value.ring.iter().map(|link| transform(link, target)));
    let [before, behind] = [&value.before, &value.behind].map(|link| transform(link, target));
    let is_prismatic = array(value.is_prismatic.iter());
    let unit = number(value.unit);
    let [null, pseudo] = [&value.null[..], &value.pseudo[..]].map(|rows| coordinate_rows(rows, target));
    let (null_level, pseudo_level) = (numbers(&value.null_level), numbers(&value.pseudo_level));
    quote! {
        #krate::held_joint::general::Elimination {
            cut: #cut,
            /// The constants between the joints d, a, b, c, e, f of the ring; c is held.
            ring: #ring,
            /// The constants on both sides of the target.
            before: #before,
            behind: #behind,
            is_prismatic: #is_prismatic,
            /// Unit of length here.
            unit: #unit,
            /// Rows that are free of the joints a and b: of the 14 coordinates of d's axis, each a line a vector.
            null: #null,
            null_level: #null_level,
            /// Rows that give cos b, sin b, cos a, sin a of these coordinates.
            pseudo: #pseudo,
            pseudo_level: #pseudo_level,
        }
    }
}
