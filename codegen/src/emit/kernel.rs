//! A stage as a call of its kernel.

use super::nest::Nest;
use super::tokens::{array, ident, integer, number};
use super::{angle, worked_out};
use crate::lower::kernel::{Argument, Phase};
use crate::lower::{Call, Counted, DefaultValue, Kernel, RootRange, Statement, Unit};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The measure of the numbers in an equation: lengths or directions.
pub fn measure(nest: &Nest, unit: Unit) -> TokenStream {
    let krate = &nest.target.krate;
    match unit {
        Unit::Length if nest.bound => quote!(length),
        Unit::Length => quote!(LENGTH),
        Unit::Direction => quote!(#krate::solve::Measure::DIRECTION),
    }
}

/// The first joint of a stage, after which its values are called.
pub fn joint(nest: &Nest, stage: usize) -> String {
    let joint = nest.plan.stages().nth(stage).and_then(|stage| stage.joints.first());
    joint.map_or_else(String::new, |joint| nest.plan.label(*joint).to_string())
}

fn prepared(nest: &Nest, what: &str, stage: usize) -> Ident {
    ident(&format!("{what}{}", joint(nest, stage)))
}

/// The expression that gives the stage's roots.
pub fn call(nest: &Nest, call: &Call) -> TokenStream {
    let krate = &nest.target.krate;
    let form = call.kernel.form();
    let function = ident(form.function);
    let arguments = form.arguments.iter().map(|of| argument(nest, call, of));
    let counted = counted(nest, call);
    quote!(#krate::solve::#function(#(#arguments),*) #counted)
}

fn argument(nest: &Nest, call: &Call, of: &Argument) -> TokenStream {
    match of {
        Argument::Default(place) => {
            call.defaults.get(*place).map_or_else(TokenStream::new, |of| default_value(nest, of))
        }
        Argument::Measure => measure(nest, call.unit),
        Argument::Number(e) => nest.writer().write(*e),
        Argument::Array(items) => array(items.iter().map(|item| argument(nest, call, item))),
        Argument::Tuple(items) => {
            let items = items.iter().map(|item| argument(nest, call, item));
            quote!((#(#items),*))
        }
        Argument::Struct(name, fields) => {
            let (krate, name) = (&nest.target.krate, ident(name));
            let fields = fields.iter().map(|(field, value)| {
                let (field, value) = (ident(field), argument(nest, call, value));
                quote!(#field: #value)
            });
            quote!(#krate::solve::#name { #(#fields),* })
        }
        Argument::Range(_) => {
            let name = range(nest, call);
            quote!(#name)
        }
    }
}

fn default_value(nest: &Nest, DefaultValue { joint, shift }: &DefaultValue) -> TokenStream {
    let value = match joint.map(integer) {
        Some(joint) => quote!(search.default(#joint)),
        None => quote!(search.virtual_default()),
    };
    if shift.is_zero() {
        return value;
    }
    let shift = angle::tokens(*shift, nest.target);
    quote!(#value.shifted(#shift))
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
pub fn range(nest: &Nest, call: &Call) -> Ident {
    let joint = joint(nest, call.stage);
    match (&call.kernel, call.range) {
        (_, RootRange::Elbow { .. }) => ident(&format!("ELBOW{}", joint.to_uppercase())),
        (_, RootRange::Cone { .. }) => ident(&format!("CONE{}", joint.to_uppercase())),
        (Kernel::Cone(_), _) => ident(&format!("cone{joint}")),
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
        Statement::Phase { stage, phase: Phase { y, x } } => {
            let (name, y, x) = (prepared(nest, "phase", *stage), writer.write(*y), writer.write(*x));
            quote!(let #name = #krate::solve::Turn::direction(#y, #x);)
        }
        Statement::Elbow { stage, range, line } => {
            let name = prepared(nest, "elbow", *stage);
            let [a, b, height] = range.inputs().map(|e| writer.write(e));
            let signed = line.map(|product| writer.write(product)).map(|product| quote!(.signed(#product)));
            quote!(let #name = #krate::solve::Elbow::new(#a, #b, #height) #signed;)
        }
        Statement::Cone { stage, range } => {
            let name = prepared(nest, "cone", *stage);
            let [along, across, cos, sin] = range.inputs().map(|e| writer.write(e));
            quote!(let #name = #krate::solve::Cone::new(#along, #across, #cos, #sin);)
        }
        _ => TokenStream::new(),
    }
}
