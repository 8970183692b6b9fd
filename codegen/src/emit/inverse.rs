//! The inverse: the plan as nested loops over the roots of its stages.

use super::block::Block;
use super::inverse_frame::{function, given, inverse_trait, items, methods};
use super::kernel::Calls;
use super::task::task;
use super::tokens::{Writer, ident};
use super::{Target, angle, docs};
use crate::model::Model;
use crate::solve::{Branching, Kernel, Plan, PlanStep, Stage, Unit};
use crate::symbolic::{Expr, Node};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::{HashMap, HashSet};

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

/// Statements before the next loop, and the loop's head.
#[derive(Default)]
struct Level {
    head: TokenStream,
    body: TokenStream,
}

struct Nest<'a> {
    plan: &'a Plan,
    target: &'a Target,
    block: Block<'a>,
    levels: Vec<Level>,
    /// The level at which a symbol is known.
    known: HashMap<String, usize>,
    used: HashSet<String>,
    trail: TokenStream,
    branch: TokenStream,
}

/// Emits the plan.
pub fn inverse(model: &Model, plan: &Plan, target: &Target) -> Inverse {
    let inputs = plan.inputs();
    let wanted = plan.values.iter().zip(&plan.slots).filter(|(_, slot)| slot.joint.is_some());
    let mut used: HashSet<String> = wanted.flat_map(|(v, _)| v.terms.iter().map(|(t, _)| t.clone())).collect();
    for e in plan.graph.reachable(&inputs) {
        if let Node::Symbol(symbol) = plan.graph.node(e) {
            used.insert(symbol.name);
        }
    }
    let labels = (1..=plan.joints()).map(|i| i.to_string()).chain(plan.slots.iter().map(|slot| slot.label.clone()));
    let prefixes = ["q", "index", "roots", "trail", "elbow", "cone", "phase"];
    let reserved = labels.flat_map(|label| prefixes.map(|prefix| format!("{prefix}{label}")));
    let names = [
        "agreed",
        "locked",
        "nearest",
        "search",
        "solutions",
        "start",
        "target",
        "near",
        "arm",
        "goal",
        "frame",
        "swing",
        "wanted",
    ];
    // The size of an arm with run-time parameters.
    let sizes: &[&str] = if model.parameters.is_empty() { &[] } else { &["reach", "facts", "length"] };
    let reserved = reserved.chain(names.iter().chain(sizes).map(|name| name.to_string()));
    let krate = &target.krate;
    let mut nest = Nest {
        plan,
        target,
        block: Block::new(&plan.graph, &inputs, reserved),
        levels: vec![Level::default()],
        known: HashMap::new(),
        used: used.clone(),
        trail: quote!(start),
        branch: quote!(#krate::Branch::NONE),
    };
    let mut calls = Calls::new(model, plan, target);
    for step in &plan.steps {
        match step {
            PlanStep::Stage(stage) => nest.stage(stage, &mut calls),
            PlanStep::Angle { name, meaning, y, x } => nest.angle(name, meaning, *y, *x),
            PlanStep::Agreement { meaning, unit, misses } => nest.agreement(meaning, calls.measure(*unit), misses),
            PlanStep::Swivel { names, meaning, .. } => {
                nest.swivel(names, meaning, &step.inputs(), calls.measure(Unit::Length));
            }
        }
    }
    nest.values();
    let body = nest.finish();
    let task = task(model, plan, target, &used);
    Inverse {
        items: items(model, plan, target, calls.items),
        function: function(model, plan, target, &task, &given_symbols(plan, target, &used), &body),
        methods: methods(model, plan, target, &task),
        trait_impl: inverse_trait(plan, target, &task),
    }
}

/// Sine and cosine of a joint whose value is given.
fn given_symbols(plan: &Plan, target: &Target, used: &HashSet<String>) -> TokenStream {
    let krate = &target.krate;
    if plan.task.swivel.is_some() {
        return quote!(let swing = #krate::math::sin_cos(arm_angle););
    }
    let (Some(locked), Some(q)) = (&plan.task.locked, given(plan)) else { return TokenStream::new() };
    let name = |letter: &str| {
        let name = format!("{letter}{}", locked.joint + 1);
        if used.contains(&name) { ident(&name) } else { ident(&format!("_{name}")) }
    };
    let (s, c) = (name("s"), name("c"));
    if locked.turns { quote!(let (#s, #c) = #krate::math::sin_cos(#q);) } else { TokenStream::new() }
}

impl Nest<'_> {
    fn deepest(&self) -> usize {
        self.levels.len().saturating_sub(1)
    }

    fn at(&mut self, level: usize, tokens: TokenStream) {
        if let Some(level) = self.levels.get_mut(level) {
            level.body.extend(tokens);
        }
    }

    /// The level from which on an expression can be evaluated.
    fn level(&self, e: Expr) -> usize {
        let graph = &self.plan.graph;
        graph
            .reachable(&[e])
            .into_iter()
            .filter_map(|x| match graph.node(x) {
                Node::Symbol(symbol) => self.known.get(&symbol.name).copied(),
                _ => None,
            })
            .max()
            .unwrap_or(0)
    }

    /// Binds what the inputs share, each at its level. Returns the level of the inputs together.
    fn bind(&mut self, inputs: &[Expr]) -> usize {
        for e in self.block.bind(inputs) {
            let statement = self.block.statement(e, &self.target.krate);
            let level = self.level(e);
            self.at(level, statement);
        }
        inputs.iter().map(|e| self.level(*e)).max().unwrap_or(0)
    }

    fn stage(&mut self, stage: &Stage, calls: &mut Calls) {
        let level = self.bind(&stage.kernel.inputs());
        let call = calls.call(stage, &self.block);
        for (inputs, statement) in calls.before.drain(..) {
            let level = inputs.iter().map(|e| self.level(*e)).max().unwrap_or(0);
            self.at(level, statement);
        }
        let number: String = stage.joints.iter().map(|j| self.plan.label(*j)).collect();
        let roots = ident(&format!("roots{number}"));
        let meaning = docs::lines(&self.meaning(stage));
        let (before, trail) = (self.trail.clone(), ident(&format!("trail{number}")));
        self.at(level, quote!(#meaning let #roots = #call;));
        let follow = quote!(let #trail = search.follow(&#before, &#roots););
        let deepest = self.deepest();
        self.at(deepest, follow);
        if stage.kernel.roots() == 1 {
            let pattern = self.pattern(stage);
            self.at(deepest, quote!(let #pattern = #roots.only();));
        } else {
            self.levels.push(Level::default());
            let pattern = self.pattern(stage);
            let index = ident(&format!("index{number}"));
            if let Some(level) = self.levels.last_mut() {
                let part = match stage.branching {
                    Branching::None => quote!(::core::option::Option::None),
                    Branching::Shoulder => quote!(wanted.shoulder()),
                    Branching::Elbow => quote!(wanted.elbow()),
                    Branching::Wrist => quote!(wanted.wrist()),
                    Branching::Root => quote!(wanted.root()),
                };
                level.head = quote!(for (#index, &#pattern) in #roots.each(&#trail, #part));
            }
            self.name_branch(stage, &index);
        }
        self.trail = quote!(#trail);
    }

    fn name_branch(&mut self, stage: &Stage, index: &proc_macro2::Ident) {
        let krate = &self.target.krate;
        self.branch.extend(match stage.branching {
            Branching::None => TokenStream::new(),
            Branching::Shoulder => quote!(.with_shoulder(#krate::Shoulder::of_root(#index))),
            Branching::Elbow => quote!(.with_elbow(#krate::Elbow::of_root(#index))),
            Branching::Wrist => quote!(.with_wrist(#krate::Wrist::of_root(#index))),
            Branching::Root => quote!(.with_root_index(#index)),
        });
    }

    /// `[Turn { value: q1, sin: s1, cos: c1 }]` with the fields in use.
    fn pattern(&mut self, stage: &Stage) -> TokenStream {
        let level = self.deepest();
        let krate = &self.target.krate;
        let mut patterns = Vec::new();
        for joint in &stage.joints {
            let number = self.plan.label(*joint);
            let mut fields = Vec::new();
            for (field, names) in [
                ("value", [format!("q{number}"), format!("t{number}")]),
                ("sin", [format!("s{number}"), format!("sin_t{number}")]),
                ("cos", [format!("c{number}"), format!("cos_t{number}")]),
            ] {
                for name in names {
                    if self.used.contains(&name) {
                        let (field, symbol) = (ident(field), ident(&name));
                        fields.push(quote!(#field: #symbol));
                        self.known.insert(name, level);
                    }
                }
            }
            patterns.push(match fields.len() {
                0 => quote!(_),
                3 => quote!(#krate::solve::Turn { #(#fields),* }),
                _ => quote!(#krate::solve::Turn { #(#fields,)* .. }),
            });
        }
        quote!([#(#patterns),*])
    }

    fn angle(&mut self, name: &str, meaning: &str, y: Expr, x: Expr) {
        let level = self.bind(&[y, x]);
        let krate = &self.target.krate;
        let writer = Writer { graph: &self.plan.graph, bound: &self.block.bound, krate };
        let (symbol, doc) = (ident(name), docs::lines(meaning));
        let (y, x) = (writer.write(y), writer.write(x));
        self.at(level, quote!(#doc let #symbol = #krate::math::atan2(#y, #x);));
        self.known.insert(name.to_string(), level);
    }

    fn agreement(&mut self, meaning: &str, measure: TokenStream, misses: &[Expr]) {
        self.bind(misses);
        let krate = &self.target.krate;
        let writer = Writer { graph: &self.plan.graph, bound: &self.block.bound, krate };
        let entries = misses.iter().map(|e| writer.write(*e));
        let (before, doc) = (&self.trail, docs::lines(meaning));
        let statement = quote!(#doc let agreed = search.agree(&#before, #measure, [#(#entries),*]););
        let deepest = self.deepest();
        self.at(deepest, statement);
        self.trail = quote!(agreed);
    }

    fn swivel(&mut self, names: &[[String; 3]; 3], meaning: &str, inputs: &[Expr], length: TokenStream) {
        let level = self.bind(inputs);
        let krate = &self.target.krate;
        let writer = Writer { graph: &self.plan.graph, bound: &self.block.bound, krate };
        let vectors = inputs.chunks(3).map(|vector| {
            let entries = vector.iter().map(|e| writer.write(*e));
            quote!([#(#entries),*])
        });
        let rows = names.iter().map(|row| {
            let row = row.iter().map(|name| ident(name));
            quote!([#(#row),*])
        });
        let doc = docs::lines(meaning);
        let vectors: Vec<TokenStream> = vectors.collect();
        let statement = quote!(#doc let [#(#rows),*] = #krate::solve::swivel(#(#vectors),*, swing););
        self.at(level, statement);
        let (before, wrist) = (&self.trail, vectors.first());
        let homes = quote!([search.home(0), search.home(1)]);
        let doc = docs::lines("A wrist in the shoulder leaves joints 1 and 2 free.");
        self.at(level, quote!(#doc let swung = search.directed(&#before, #length, #wrist, #homes);));
        self.trail = quote!(swung);
        for name in names.iter().flatten() {
            self.known.insert(name.clone(), level);
        }
    }

    /// Joint values that are not a kernel's value as it is.
    fn values(&mut self) {
        for (slot, value) in self.plan.slots.iter().zip(&self.plan.values) {
            let name = format!("q{}", slot.label);
            if slot.joint.is_none() || value.terms.iter().any(|(term, _)| *term == name) {
                continue;
            }
            let level = value.terms.iter().filter_map(|(term, _)| self.known.get(term)).max().copied().unwrap_or(0);
            let mut sum = TokenStream::new();
            for (position, (term, negative)) in value.terms.iter().enumerate() {
                let term = ident(term);
                sum.extend(match (position, negative) {
                    (0, false) => quote!(#term),
                    (_, false) => quote!(+ #term),
                    (_, true) => quote!(- #term),
                });
            }
            if !value.constant.is_zero() {
                let negative = value.constant.rad() < 0.0;
                let size = angle::tokens(if negative { value.constant.neg() } else { value.constant }, self.target);
                sum.extend(if negative { quote!(- #size) } else { quote!(+ #size) });
            }
            let (name, krate) = (ident(&name), &self.target.krate);
            self.at(level, quote!(let #name = #krate::solve::wrap(#sum);));
        }
    }

    fn finish(mut self) -> TokenStream {
        let q = (1..=self.plan.joints()).map(|i| ident(&format!("q{i}")));
        let (trail, branch) = (&self.trail, &self.branch);
        let push = quote!(let branch = #branch; search.push(&#trail, [#(#q),*], branch););
        let deepest = self.deepest();
        self.at(deepest, push);
        let mut inner = TokenStream::new();
        for Level { head, body } in self.levels.into_iter().rev() {
            inner = if head.is_empty() { quote!(#body #inner) } else { quote!(#head { #body #inner }) };
        }
        inner
    }

    /// The stage's explanation with its quantities filled in.
    fn meaning(&self, stage: &Stage) -> String {
        let krate = &self.target.krate;
        let writer = Writer { graph: &self.plan.graph, bound: &self.block.bound, krate };
        let text = |e: Expr| {
            let tokens = writer.write(e).to_string();
            let path = format!("{krate} :: math :: sqrt ");
            tokens.replace(&path, "sqrt").replace("(- ", "(-").replace(", - ", ", -").replace("arm . ", "arm.")
        };
        let text = |e: Expr| match text(e) {
            zero if zero == "0.0" => "0".to_string(),
            text => text.strip_prefix("- ").map_or_else(|| text.clone(), |rest| format!("-{rest}")),
        };
        let list = |items: &[Expr]| items.iter().map(|e| text(*e)).collect::<Vec<_>>().join(", ");
        let mut out = stage.meaning.clone();
        // What is too long for a sentence can be read in the call below it.
        let fill = |out: &mut String, key: &str, value: String| {
            let value = if value.len() > 70 { "...".to_string() } else { value };
            *out = out.replace(&format!("{{{key}}}"), &value);
        };
        match &stage.kernel {
            Kernel::Offset { a, b, d } => {
                let factor = |e: Expr| {
                    let text = text(e);
                    if text.trim_start_matches('-').contains([' ']) { format!("({text})") } else { text }
                };
                fill(&mut out, "a", factor(*a));
                fill(&mut out, "b", factor(*b));
                fill(&mut out, "d", text(*d));
                out = out.replace(" cos + -", " cos - ");
            }
            Kernel::Distance { rho, range, .. } => {
                if range.height == Expr::ZERO {
                    out = out.replace(" + h^2", "").replace(", `h = {h}`", "");
                }
                fill(&mut out, "rho", text(*rho));
                fill(&mut out, "a", text(range.a));
                fill(&mut out, "b", text(range.b));
                fill(&mut out, "h", text(range.height));
            }
            Kernel::Cone { d, .. } => fill(&mut out, "d", text(*d)),
            Kernel::Align { from, to } => {
                fill(&mut out, "from", list(from));
                fill(&mut out, "to", list(to));
            }
            Kernel::Flip { m } => fill(&mut out, "m", list(m)),
            Kernel::Slide { rho, .. } => fill(&mut out, "rho", text(*rho)),
            _ => {}
        }
        let shift = stage.joints.first().and_then(|joint| {
            let value = self.plan.values.get(*joint)?;
            let degrees = (value.constant.rad().to_degrees() * 1e6).round() / 1e6;
            let (label, sign) = (self.plan.label(*joint), if degrees < 0.0 { '-' } else { '+' });
            (!value.constant.is_zero()).then(|| format!("; `q{label} = t{label} {sign} {} deg`", degrees.abs()))
        });
        fill(&mut out, "shift", shift.unwrap_or_default());
        out
    }
}
