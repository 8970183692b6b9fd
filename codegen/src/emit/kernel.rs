//! A stage as a call of its kernel.

use super::nest::Nest;
use super::tokens::{ident, integer, number};
use super::{angle, worked_out};
use crate::lower::{Call, Counted, Home, Kernel, RootRange, Statement, Unit};
use crate::symbolic::Expr;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// What the numbers of an equation measure.
pub fn measure(nest: &Nest, unit: Unit) -> TokenStream {
    let krate = &nest.target.krate;
    match unit {
        Unit::Length if nest.bound => quote!(length),
        Unit::Length => quote!(LENGTH),
        Unit::Direction => quote!(#krate::solve::Measure::DIRECTION),
    }
}

/// The first joint of a stage, after which its values are called.
fn joint(nest: &Nest, stage: usize) -> String {
    let joint = nest.plan.stages().nth(stage).and_then(|stage| stage.joints.first());
    joint.map_or_else(String::new, |joint| nest.plan.label(*joint))
}

fn prepared(nest: &Nest, what: &str, stage: usize) -> Ident {
    ident(&format!("{what}{}", joint(nest, stage)))
}

/// The expression that gives the stage's roots.
pub fn call(nest: &Nest, call: &Call) -> TokenStream {
    let krate = &nest.target.krate;
    let writer = nest.writer();
    let w = |e: &Expr| writer.write(*e);
    let [home, other] = call.homes.map(|home| self::home(nest, home));
    let measure = measure(nest, call.unit);
    let row = |row: &[Expr; 3]| {
        let row = row.iter().map(w);
        quote!([#(#row),*])
    };
    match &call.kernel {
        Kernel::Offset { a, b, d } => {
            let (a, b, d) = (w(a), w(b), w(d));
            quote!(#krate::solve::offset(#home, #measure, #a, #b, #d))
        }
        Kernel::OffsetOfTwo { length, direction } => {
            let (length, direction) = (row(length), row(direction));
            let measure = self::measure(nest, Unit::Length);
            quote!(#krate::solve::offset_of_two(#home, #measure, #length, #direction))
        }
        Kernel::Distance { rho, .. } => {
            let (rho, range, counted) = (w(rho), range(nest, call), counted(nest, call));
            quote!(#krate::solve::distance(#home, #measure, #rho, #range) #counted)
        }
        Kernel::Cone { d, rho, .. } => {
            let (d, rho, range, counted) = (w(d), w(rho), range(nest, call), counted(nest, call));
            quote!(#krate::solve::cone(#home, #measure, #d, #rho, #range) #counted)
        }
        Kernel::Align { from, to } => {
            let (from, to) = (from.iter().map(w), to.iter().map(w));
            quote!(#krate::solve::align(#home, #measure, [#(#from),*], [#(#to),*]))
        }
        Kernel::Flip { m } => {
            let m = row(m);
            quote!(#krate::solve::flip(#home, #m))
        }
        Kernel::Wrist { m } => {
            let m = m.iter().map(row);
            quote!(#krate::solve::wrist(#home, [#(#m),*]))
        }
        Kernel::Slide { rho, across, middle } => {
            let (rho, across, middle) = (w(rho), w(across), w(middle));
            quote!(#krate::solve::slide(#measure, #rho, #across, #middle))
        }
        Kernel::SlideTo { denominator, numerator } => {
            let (denominator, numerator) = (w(denominator), w(numerator));
            quote!(#krate::solve::slide_to(#home, #measure, #denominator, #numerator))
        }
        Kernel::SlideTurning { stroke, rows } => {
            let (stroke, rows) = (stroke.iter().map(w), rows.iter().map(row));
            quote!(#krate::solve::slide_turning([#home, #other], #measure, [#(#stroke),*], [#(#rows),*]))
        }
        Kernel::Aim { moved, frames } => {
            let mut sights = moved.iter().zip(frames).map(|(moved, frame)| {
                let (moved, frame) = (row(moved), frame.iter().map(row));
                quote!(#krate::solve::Sight { moved: #moved, frame: [#(#frame),*] })
            });
            let (first, second) = (sights.next(), sights.next());
            quote!(#krate::solve::aim([#home, #other], #first, #second))
        }
        Kernel::Pair { p, q, across } => {
            let (p, q) = (p.iter().map(row), q.iter().map(row));
            let Some([x, z]) = across else {
                return quote!(#krate::solve::pair([#home, #other], #measure, [#(#p),*], [#(#q),*]));
            };
            let (x, z) = (x.iter().map(row), z.iter().map(row));
            let across = quote!([#(#x,)* #(#z),*]);
            quote!(#krate::solve::pair_turning([#home, #other], #measure, [#(#p),*], [#(#q),*], #across))
        }
        Kernel::PairSliding { line, scale, square, q, sliding, turning } => {
            let (line, q) = (row(line), row(q));
            let sliding = sliding.iter().map(|[factor, constant]| {
                let (factor, constant) = (w(factor), w(constant));
                quote!([#factor, #constant])
            });
            let turning = turning.iter().map(row);
            let across = quote!(([#(#sliding),*], [#(#turning),*]));
            let (scale, square) = (w(scale), square.iter().map(w));
            quote!(#krate::solve::pair_sliding(#measure, #line, #scale, [#(#square),*], #q, #across))
        }
        Kernel::Quadratic { coefficients } => {
            let coefficients = row(coefficients);
            quote!(#krate::solve::quadratic(#measure, #coefficients))
        }
    }
}

fn home(nest: &Nest, Home { joint, shift }: Home) -> TokenStream {
    let home = match joint.map(integer) {
        Some(joint) => quote!(search.home(#joint)),
        None => quote!(search.virtual_home()),
    };
    if shift.is_zero() {
        return home;
    }
    let shift = angle::tokens(shift, nest.target);
    quote!(#home.shifted(#shift))
}

/// The call that adds to a kernel's angle where it is counted from, if that is only known at run time.
fn counted(nest: &Nest, call: &Call) -> TokenStream {
    match call.counted {
        Counted::FromZero => TokenStream::new(),
        Counted::TurnedBack(x) => {
            let x = nest.writer().write(x);
            quote!(.turned_back(#x < 0.0))
        }
        Counted::FromPhase => {
            let name = prepared(nest, "phase", call.stage);
            quote!(.about(#name))
        }
    }
}

/// A range by its name: a constant one is an item.
fn range(nest: &Nest, call: &Call) -> Ident {
    let joint = joint(nest, call.stage);
    match (&call.kernel, call.range) {
        (_, RootRange::Elbow { .. }) => ident(&format!("ELBOW{}", joint.to_uppercase())),
        (_, RootRange::Cone { .. }) => ident(&format!("CONE{}", joint.to_uppercase())),
        (Kernel::Cone { .. }, _) => ident(&format!("cone{joint}")),
        _ => ident(&format!("elbow{joint}")),
    }
}

/// The item of a constant range, with its numbers worked out here.
pub fn range_item(nest: &Nest, call: &Call) -> TokenStream {
    let (krate, scalar) = (&nest.target.krate, nest.target.scalar.tokens());
    let (name, joint) = (range(nest, call), joint(nest, call.stage));
    match call.range {
        RootRange::None | RootRange::Prepared => TokenStream::new(),
        RootRange::Elbow { links: [a, b], max, min } => {
            let doc = format!(" Largest and smallest distance for joint {joint}: links of {a} and {b}.");
            let [max, min] = worked_out::distances([a, b], [max, min], nest.target);
            quote! {
                #[doc = #doc]
                const #name: #krate::solve::Elbow<#scalar> = #krate::solve::Elbow {
                    max: #max, min: #min, side: 1.0,
                };
            }
        }
        RootRange::Cone { max, min } => {
            let doc = format!(" Largest and smallest component for joint {joint}, each with the component across.");
            let (max, min) = (max.map(number), min.map(number));
            quote! {
                #[doc = #doc]
                const #name: #krate::solve::Cone<#scalar> =
                    #krate::solve::Cone { max: [#(#max),*], min: [#(#min),*] };
            }
        }
    }
}

/// A statement that works out what a kernel needs.
pub fn preparation(nest: &Nest, statement: &Statement) -> TokenStream {
    let krate = &nest.target.krate;
    let writer = nest.writer();
    match statement {
        Statement::Phase { stage, y, x } => {
            let (name, y, x) = (prepared(nest, "phase", *stage), writer.write(*y), writer.write(*x));
            quote!(let #name = #krate::solve::Turn::direction(#y, #x);)
        }
        Statement::Elbow { stage, a, b, height, line } => {
            let name = prepared(nest, "elbow", *stage);
            let [a, b, height] = [a, b, height].map(|e| writer.write(*e));
            let signed = line.map(|product| writer.write(product)).map(|product| quote!(.signed(#product)));
            quote!(let #name = #krate::solve::Elbow::new(#a, #b, #height) #signed;)
        }
        Statement::Cone { stage, along, across, cos, sin } => {
            let name = prepared(nest, "cone", *stage);
            let [along, across, cos, sin] = [along, across, cos, sin].map(|e| writer.write(*e));
            quote!(let #name = #krate::solve::Cone::new(#along, #across, #cos, #sin);)
        }
        _ => TokenStream::new(),
    }
}
