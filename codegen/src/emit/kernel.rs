//! A stage of the plan as a call of its kernel.

use super::block::Block;
use super::tokens::{Writer, ident, integer, number};
use super::{Target, angle, worked_out};
use crate::model::Model;
use crate::solve::{ElbowRange, Kernel, Phase, Plan, Range, Stage, Unit};
use crate::symbolic::Expr;
use proc_macro2::TokenStream;
use quote::quote;

/// Calls of kernels, and the constants they need.
pub struct Calls<'a> {
    plan: &'a Plan,
    target: &'a Target,
    /// Constant items collected so far.
    pub items: TokenStream,
    /// Whether lengths are compared to a reach that is known at run time only.
    bound: bool,
    /// Statements that the last call needs before it, each with the expressions it reads: what is the same for every
    /// root of the stages before is worked out once.
    pub before: Vec<(Vec<Expr>, TokenStream)>,
}

impl<'a> Calls<'a> {
    /// None yet.
    pub fn new(model: &Model, plan: &'a Plan, target: &'a Target) -> Self {
        let bound = !model.parameters.is_empty();
        Calls { plan, target, items: TokenStream::new(), bound, before: Vec::new() }
    }

    /// What the numbers of an equation measure.
    pub fn measure(&self, unit: Unit) -> TokenStream {
        let krate = &self.target.krate;
        match unit {
            Unit::Length if self.bound => quote!(length),
            Unit::Length => quote!(LENGTH),
            Unit::Direction => quote!(#krate::solve::Measure::DIRECTION),
        }
    }

    /// The expression that gives the stage's roots.
    pub fn call(&mut self, stage: &Stage, block: &Block) -> TokenStream {
        let krate = &self.target.krate;
        let writer = Writer { graph: &self.plan.graph, bound: &block.bound, krate };
        let w = |e: &Expr| writer.write(*e);
        let home = self.home(stage);
        let measure = self.measure(stage.unit);
        let row = |row: &[Expr; 3]| {
            let row = row.iter().map(w);
            quote!([#(#row),*])
        };
        let joint = stage.joints.first().map_or_else(String::new, |j| self.plan.label(*j));
        match &stage.kernel {
            Kernel::Offset { a, b, d } => {
                let (a, b, d) = (w(a), w(b), w(d));
                quote!(#krate::solve::offset(#home, #measure, #a, #b, #d))
            }
            Kernel::OffsetOfTwo { length, direction } => {
                let (length, direction) = (row(length), row(direction));
                let measure = self.measure(Unit::Length);
                quote!(#krate::solve::offset_of_two(#home, #measure, #length, #direction))
            }
            Kernel::Distance { rho, range, about } => {
                let rho = w(rho);
                // Links along one line are stretched or folded: that needs no angle.
                let (line, about) = match about {
                    Some(Phase { y, x }) if *y == Expr::ZERO => (Some(*x), None),
                    about => (None, about.as_ref()),
                };
                let range = self.elbow(&joint, range, line, &writer);
                let about = about.map(|phase| self.phase(&joint, *phase, &writer));
                quote!(#krate::solve::distance(#home, #measure, #rho, #range) #about)
            }
            Kernel::Cone { d, rho, range, about } => {
                let (d, rho) = (w(d), w(rho));
                let range = self.cone(&joint, range, &writer);
                let about = about.map(|phase| self.phase(&joint, phase, &writer));
                quote!(#krate::solve::cone(#home, #measure, #d, #rho, #range) #about)
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
                let other = self.home_of(stage, 1);
                quote!(#krate::solve::slide_turning([#home, #other], #measure, [#(#stroke),*], [#(#rows),*]))
            }
            Kernel::Aim { moved, frames } => {
                let mut sights = moved.iter().zip(frames).map(|(moved, frame)| {
                    let (moved, frame) = (row(moved), frame.iter().map(row));
                    quote!(#krate::solve::Sight { moved: #moved, frame: [#(#frame),*] })
                });
                let (first, second) = (sights.next(), sights.next());
                let other = self.home_of(stage, 1);
                quote!(#krate::solve::aim([#home, #other], #first, #second))
            }
            Kernel::Pair { p, q, across } => {
                let (p, q) = (p.iter().map(row), q.iter().map(row));
                let second = self.home_of(stage, 1);
                let Some([x, z]) = across else {
                    return quote!(#krate::solve::pair([#home, #second], #measure, [#(#p),*], [#(#q),*]));
                };
                let (x, z) = (x.iter().map(row), z.iter().map(row));
                let across = quote!([#(#x,)* #(#z),*]);
                quote!(#krate::solve::pair_turning([#home, #second], #measure, [#(#p),*], [#(#q),*], #across))
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

    fn home(&self, stage: &Stage) -> TokenStream {
        let free = match &stage.kernel {
            // The outer joint of a flip is the one that can be free.
            Kernel::Flip { .. } => 1,
            _ => 0,
        };
        self.home_of(stage, free)
    }

    fn home_of(&self, stage: &Stage, place: usize) -> TokenStream {
        let joint = stage.joints.get(place).copied().unwrap_or(0);
        let shift = if place == 0 || matches!(stage.kernel, Kernel::Flip { .. }) {
            stage.home
        } else {
            self.plan.values.get(joint).map_or(stage.home, |value| value.constant.neg())
        };
        let home = match self.plan.joint(joint).map(integer) {
            Some(joint) => quote!(search.home(#joint)),
            None => quote!(search.virtual_home()),
        };
        if shift.is_zero() {
            return home;
        }
        let shift = angle::tokens(shift, self.target);
        quote!(#home.shifted(#shift))
    }

    fn constant(&self, e: Expr) -> Option<f64> {
        self.plan.graph.constant(e)
    }

    /// The call that adds to a kernel's angle where it is counted from, if that is only known at run time.
    fn phase(&mut self, joint: &str, phase: Phase, writer: &Writer) -> TokenStream {
        let krate = &self.target.krate;
        let name = ident(&format!("phase{joint}"));
        let (y, x) = (writer.write(phase.y), writer.write(phase.x));
        // Links along one line are stretched or folded: that needs no angle.
        if phase.y == Expr::ZERO {
            return quote!(.turned_back(#x < 0.0));
        }
        let statement = quote!(let #name = #krate::solve::Turn::direction(#y, #x););
        self.before.push((vec![phase.y, phase.x], statement));
        quote!(.about(#name))
    }

    /// A constant range becomes an item, with its numbers worked out here.
    fn elbow(&mut self, joint: &str, range: &ElbowRange, line: Option<Expr>, writer: &Writer) -> TokenStream {
        let krate = &self.target.krate;
        let values = [range.a, range.b, range.height].map(|e| self.constant(e));
        let [Some(a), Some(b), Some(height)] = values else {
            let [a, b, height] = [range.a, range.b, range.height].map(|e| writer.write(e));
            let name = ident(&format!("elbow{joint}"));
            let signed = line.map(|product| writer.write(product)).map(|product| quote!(.signed(#product)));
            let statement = quote!(let #name = #krate::solve::Elbow::new(#a, #b, #height) #signed;);
            self.before.push(([range.a, range.b, range.height].into_iter().chain(line).collect(), statement));
            return quote!(#name);
        };
        let name = ident(&format!("ELBOW{}", joint.to_uppercase()));
        let scalar = self.target.scalar.tokens();
        let doc = format!(" Largest and smallest distance for joint {joint}: links of {a} and {b}.");
        let range = [(a + b).hypot(height), (a - b).hypot(height)];
        let [max, min] = worked_out::distances([a, b], range, self.target);
        self.items.extend(quote! {
            #[doc = #doc]
            const #name: #krate::solve::Elbow<#scalar> = #krate::solve::Elbow {
                max: #max, min: #min, side: 1.0,
            };
        });
        quote!(#name)
    }

    fn cone(&mut self, joint: &str, range: &Range, writer: &Writer) -> TokenStream {
        let krate = &self.target.krate;
        let all = [range.along, range.across, range.cos, range.sin];
        let [Some(along), Some(across), Some(cos), Some(sin)] = all.map(|e| self.constant(e)) else {
            let [along, across, cos, sin] = all.map(|e| writer.write(e));
            let name = ident(&format!("cone{joint}"));
            let statement = quote!(let #name = #krate::solve::Cone::new(#along, #across, #cos, #sin););
            self.before.push((vec![range.along, range.across, range.cos, range.sin], statement));
            return quote!(#name);
        };
        let name = ident(&format!("CONE{}", joint.to_uppercase()));
        let scalar = self.target.scalar.tokens();
        let doc = format!(" Largest and smallest component for joint {joint}, each with the component across.");
        // Rounding of a product of exact angles must not look like an angle of 1e-17.
        let size = along.hypot(across);
        let clean = |x: f64| if x.abs() <= 1e-15 * size { 0.0 } else { x };
        let max = [along * cos + across * sin, across * cos - along * sin].map(|x| number(clean(x)));
        let min = [along * cos - across * sin, across * cos + along * sin].map(|x| number(clean(x)));
        self.items.extend(quote! {
            #[doc = #doc]
            const #name: #krate::solve::Cone<#scalar> =
                #krate::solve::Cone { max: [#(#max),*], min: [#(#min),*] };
        });
        quote!(#name)
    }
}
