//! The inverse: its program as nested loops over the roots of its stages.

use super::inverse_frame::{Body, Solver, function, inverse_branch, inverse_trait, items, methods, named_branch};
use super::kernel;
use super::margins::table_branch;
use super::nest::Nest;
use super::task::task;
use super::tokens::{array, bound, ident, integer};
use super::{Target, angle, docs, parameters};
use crate::lower::kernel::Quantity;
use crate::lower::{self, BranchState, Branching, Call, Each, Given, Part, Root, Statement};
use crate::model::Model;
use crate::solve::{Plan, Stage};
use crate::symbolic::{Expr, Input};
use proc_macro2::TokenStream;
use quote::quote;

/// The code of an inverse.
pub struct Inverse {
    /// Constant items.
    pub items: TokenStream,
    /// The function `branches(arm, target, near)`.
    pub function: TokenStream,
    /// Methods `inverse`, `inverse_near` and `residual`.
    pub methods: TokenStream,
    /// The impl of the trait.
    pub trait_impl: TokenStream,
}

/// Emits the plan. `dimensions` are constants of its equations alone.
pub fn inverse(model: &Model, plan: &Plan, dimensions: &TokenStream, target: &Target) -> Inverse {
    let program = lower::stages(model, plan);
    let selects = program.follows_single_branches();
    let nest = Nest { plan, target, program: &program, bound: !model.parameters.is_empty(), lanes: false, selects };
    let body = Body { dimensions, given_symbols: given_symbols(&program, target), levels: nest.levels() };
    let task = task(model, &program, target);
    let outline = &plan.outline();
    let solver = Solver {
        gap: "the least gap of an equation without a root",
        bound: "The call takes at most 12 cascades and 200 evaluations of `forward_and_jacobian`, for any target.",
        method: "Pieper (1968) and cyclic closure around three axes that meet or are parallel; the stages are\n\
                 documented where they are solved.",
        function: ident("branches"),
        arguments: if selects { quote!(ALL,) } else { TokenStream::new() },
        branch: if selects { inverse_branch(plan, target, &task) } else { named_branch(plan.joints(), target, &task) },
    };
    let names = program.table_margins.as_ref().map(|margins| table_branch(margins, model, target));
    let ranges = nest.constants();
    Inverse {
        items: items(model, &program.constants, target, [measure(model, target), quote!(#ranges #names)]),
        function: function(model, plan, &program, target, &task, &body),
        methods: methods(model, outline, target, &task, &solver),
        trait_impl: inverse_trait(model, outline, true, lower::margins(plan).as_ref(), target, &task, &solver),
    }
}

/// The scale of every length comparison.
pub(super) fn measure(model: &Model, target: &Target) -> TokenStream {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    if !model.parameters.is_empty() {
        return parameters::reach(model, target);
    }
    quote! {
        /// Lengths are compared relative to the reach.
        const LENGTH: #krate::solve::Measure<#scalar> = #krate::solve::Measure::length(REACH);
    }
}

/// Sines and cosines of the joints whose values are given.
fn given_symbols(program: &lower::Inverse, target: &Target) -> TokenStream {
    let krate = &target.krate;
    let name = |input: Input| bound(&input.name(), program.reads(input));
    let symbols = program.given.values.iter().map(|given| match *given {
        Given::ArmAngle => quote!(let swing = #krate::math::sin_cos(arm_angle);),
        Given::Joint { joint, revolute: true } => {
            let (s, c, q) = (name(Input::SinGiven(joint)), name(Input::CosGiven(joint)), name(Input::Given(joint)));
            quote!(let (#s, #c) = #krate::math::sin_cos(#q);)
        }
        Given::Joint { revolute: false, .. } => TokenStream::new(),
    });
    symbols.collect()
}

impl Nest<'_> {
    /// The selection of all branches, and the constant ranges of the stages.
    pub(super) fn constants(&self) -> TokenStream {
        let krate = &self.target.krate;
        let statements = self.program.levels.iter().flat_map(|level| &level.body);
        let mut calls: Vec<&Call> = statements
            .filter_map(|statement| match statement {
                Statement::Solve(call) => Some(call),
                _ => None,
            })
            .collect();
        calls.sort_by_key(|call| call.stage);
        let ranges = calls.into_iter().map(|call| kernel::range_item(self, call));
        let all = self.selects.then(|| quote!(const ALL: #krate::solve::Every = #krate::solve::Every;));
        quote! {
            #all
            #(#ranges)*
        }
    }

    pub(super) fn levels(&self) -> TokenStream {
        let mut inner = TokenStream::new();
        for level in self.program.levels.iter().rev() {
            let body = level.body.iter().map(|statement| self.statement(statement));
            inner = match &level.each {
                None => quote!(#(#body)* #inner),
                Some(each) => {
                    let head = self.head(each);
                    quote!(#head { #(#body)* #inner })
                }
            };
        }
        inner
    }

    fn head(&self, each: &Each) -> TokenStream {
        let number = self.number(each.stage);
        let (roots, index, state) =
            (ident(&format!("roots{number}")), ident(&format!("index{number}")), self.state(each.state));
        let pattern = self.pattern(&each.roots);
        let part = match each.branching {
            Branching::None => None,
            Branching::Shoulder => Some("shoulder"),
            Branching::Elbow => Some("elbow"),
            Branching::Wrist => Some("wrist"),
            Branching::Root => Some("root"),
        };
        let part = match part.filter(|_| self.selects).map(ident) {
            Some(part) => quote!(wanted.#part()),
            None => quote!(::core::option::Option::None),
        };
        let each = ident(if each.flips { "each_flip" } else { "each" });
        quote!(for (#index, &#pattern) in #roots.#each(&#state, #part))
    }

    /// The name of a branch, from the roots that it follows.
    fn branch(&self) -> TokenStream {
        let krate = &self.target.krate;
        let mut branch = quote!(#krate::Branch::NONE);
        for each in self.program.levels.iter().filter_map(|level| level.each.as_ref()) {
            let index = ident(&format!("index{}", self.number(each.stage)));
            branch.extend(match each.branching {
                Branching::None => TokenStream::new(),
                Branching::Shoulder => quote!(.with_shoulder(#krate::Shoulder::of_root(#index))),
                Branching::Elbow => quote!(.with_elbow(#krate::Elbow::of_root(#index))),
                Branching::Wrist => quote!(.with_wrist(#krate::Wrist::of_root(#index))),
                Branching::Root => quote!(.with_root_index(#index)),
            });
        }
        branch
    }

    /// `[Turn { value: q1, sin: s1, cos: c1 }]` with the fields in use.
    pub(super) fn pattern(&self, roots: &[Root]) -> TokenStream {
        let krate = &self.target.krate;
        let patterns = roots.iter().map(|Root(parts)| {
            let fields = parts.iter().map(|(part, symbol)| {
                let field = match part {
                    Part::Value => quote!(value),
                    Part::Sin => quote!(sin),
                    Part::Cos => quote!(cos),
                };
                let symbol = self.leaf(*symbol);
                quote!(#field: #symbol)
            });
            match parts.len() {
                0 => quote!(_),
                3 => quote!(#krate::solve::Turn { #(#fields),* }),
                _ => quote!(#krate::solve::Turn { #(#fields,)* .. }),
            }
        });
        quote!([#(#patterns),*])
    }

    fn statement(&self, statement: &Statement) -> TokenStream {
        let krate = &self.target.krate;
        let writer = self.writer();
        let w = |e: &Expr| writer.write(*e);
        match statement {
            Statement::Let(e) => writer.statement(*e),
            Statement::Phase { .. } | Statement::Elbow { .. } | Statement::Cone { .. } => {
                kernel::preparation(self, statement)
            }
            Statement::Solve(call) => {
                let roots = ident(&format!("roots{}", self.number(call.stage)));
                let stage = self.plan.stages().nth(call.stage);
                let meaning = stage.map(|stage| docs::lines(&self.meaning(stage)));
                let call = kernel::call(self, call);
                quote!(#meaning let #roots = #call;)
            }
            Statement::Follow { stage, before } => {
                let (state, before) = (self.state(BranchState::Stage(*stage)), self.state(*before));
                let roots = ident(&format!("roots{}", self.number(*stage)));
                quote!(let #state = search.follow(&#before, &#roots);)
            }
            Statement::Only { stage, roots } => {
                let (pattern, roots) = (self.pattern(roots), ident(&format!("roots{}", self.number(*stage))));
                quote!(let #pattern = #roots.only();)
            }
            Statement::Angle { symbol, y, x, meaning } => {
                let (symbol, doc, y, x) = (self.leaf(*symbol), docs::lines(meaning), w(y), w(x));
                quote!(#doc let #symbol = #krate::math::atan2(#y, #x);)
            }
            Statement::Agree { index, before, unit, misses, meaning } => {
                let (before, agreed) = (self.state(*before), self.state(BranchState::Agreed(*index)));
                let (measure, doc) = (kernel::measure(self, *unit), docs::lines(meaning));
                let entries = misses.iter().map(w);
                quote!(#doc let #agreed = search.agree(&#before, #measure, [#(#entries),*]);)
            }
            Statement::Swivel { joints: [first, second], symbols, vectors, before, meaning } => {
                let vectors = vectors.each_ref().map(|vector| array(vector.iter().map(w)));
                let rows = symbols.iter().map(|row| array(row.iter().map(|symbol| self.leaf(*symbol))));
                let (doc, wrist, before) = (docs::lines(meaning), vectors.first(), self.state(*before));
                let swung = self.state(BranchState::Swung);
                let length = kernel::measure(self, lower::Unit::Length);
                let free = format!("A wrist in the shoulder leaves joints {} and {} free.", first + 1, second + 1);
                let (free, first, second) = (docs::lines(&free), integer(*first), integer(*second));
                quote! {
                    #doc let [#(#rows),*] = #krate::solve::swivel(#(#vectors),*, swing);
                    #free let #swung =
                        search.directed(&#before, #length, #wrist, [search.default(#first), search.default(#second)]);
                }
            }
            Statement::Value { symbol, terms, constant } => {
                let terms = terms.iter().map(|(term, negative)| (self.leaf(*term), *negative));
                let (name, sum) = (self.leaf(*symbol), angle::sum(terms, *constant, self.target));
                quote!(let #name = #krate::solve::wrap(#sum);)
            }
            Statement::Push { state, q } => {
                let (state, branch) = (self.state(*state), self.branch());
                let q = q.iter().map(|slot| self.leaf(*slot));
                quote!(let branch = #branch; search.push(&#state, [#(#q),*], branch);)
            }
        }
    }

    /// The stage's explanation with its quantities filled in.
    fn meaning(&self, stage: &Stage) -> String {
        let krate = &self.target.krate;
        let writer = self.writer();
        let text = |e: Expr| {
            let tokens = writer.write(e).to_string();
            let path = format!("{krate} :: math :: sqrt ");
            tokens.replace(&path, "sqrt").replace("(- ", "(-").replace(", - ", ", -").replace("arm . ", "arm.")
        };
        let text = |e: Expr| match text(e) {
            zero if zero == "0.0" => "0".to_string(),
            text => text.strip_prefix("- ").map_or_else(|| text.clone(), |rest| format!("-{rest}")),
        };
        let mut out = stage.meaning.clone();
        // What is too long for a sentence can be read in the call below it.
        let fill = |out: &mut String, key: &str, value: String| {
            let value = if value.len() > 70 { "...".to_string() } else { value };
            *out = out.replace(&format!("{{{key}}}"), &value);
        };
        for (key, quantity) in stage.kernel.form().quantities {
            let value = match quantity {
                Quantity::Value(e) => text(e),
                Quantity::Coefficient(e) => {
                    let text = text(e);
                    if text.trim_start_matches('-').contains([' ']) { format!("({text})") } else { text }
                }
                Quantity::List(items) => items.iter().map(|e| text(*e)).collect::<Vec<_>>().join(", "),
            };
            fill(&mut out, key, value);
        }
        out = out.replace(" cos + -", " cos - ");
        let shift = stage.joints.first().and_then(|joint| {
            let value = self.plan.values.get(*joint)?;
            let label = self.plan.label(*joint);
            (!value.constant.is_zero()).then(|| format!("; `q{label} = t{label} {}`", angle::addend(value.constant)))
        });
        fill(&mut out, "shift", shift.unwrap_or_default());
        out
    }
}
