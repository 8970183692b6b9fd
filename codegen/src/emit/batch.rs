//! Functions over lanes: many poses at a time, with the option `batch`.
//!
//! The text is that of the scalar functions. Numbers become lanes (`of(D6)`), a kernel is its lane form, and `branches`
//! takes the place of the search.

use super::nest::Nest;
use super::tokens::{Writer, array, bound, ident, integer};
use super::{Target, angle, docs, kinematics};
use crate::lower::kernel::{Argument, Phase};
use crate::lower::{
    self, BranchState, Call, Counted, Each, Function, Functions, Goal, Kernel, RootRange, Statement, Unit,
};
use crate::model::{Angle, Model};
use crate::solve::{self, InversePlan, Outline, Plan};
use crate::symbolic::Input;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;

/// The impls of an arm. An inverse without a lane form takes single calls; of an inverse whose target is more, or less, than a
/// pose there is none.
pub fn impls(model: &Model, functions: &Functions, plan: Option<&InversePlan>, target: &Target) -> TokenStream {
    let forward = forward(model, functions, target);
    let inverse = plan.map(|plan| {
        let lanes = plan.stages().and_then(|stages| inverse(model, stages, target));
        lanes.unwrap_or_else(|| single_calls(&plan.outline(), target))
    });
    quote!(#forward #inverse)
}

/// The impl of an inverse without a lane form.
fn single_calls(outline: &Outline<'_>, target: &Target) -> TokenStream {
    if outline.task.goal != solve::Goal::Pose || !outline.task.given.values.is_empty() {
        return TokenStream::new();
    }
    let (krate, name, scalar) = (&target.krate, &target.type_name, target.scalar.tokens());
    let (n, most) = (integer(outline.joints), integer(outline.capacity));
    let doc = docs::lines("This inverse has no form over lanes: each target takes a single call.");
    quote! {
        #doc
        impl #krate::batch::BatchInverse<#n, #most> for #name {
            const ARM_CONSTANTS: #krate::solve::ArmConstants<'static, #scalar, #n> = CONSTANTS;
        }
    }
}

/// A number in every lane.
fn of(target: &Target) -> TokenStream {
    let scalar = target.scalar.tokens();
    quote!(let of = |value: #scalar| L::all(set, value);)
}

fn forward(model: &Model, functions: &Functions, target: &Target) -> TokenStream {
    let (krate, name, n) = (&target.krate, &target.type_name, integer(model.joints.len()));
    let lanes = quote!(#krate::batch::Lanes);
    let pose = body(&functions.forward, target, |writer, roots| {
        let pose = kinematics::pose(writer, roots);
        quote!((#pose, far))
    });
    let both = body(&functions.both, target, |writer, roots| {
        let (pose, jacobian) = kinematics::pose_and_jacobian(writer, roots, model.joints.len());
        quote!((#pose, #jacobian, far))
    });
    let doc = docs::lines(
        "As `forward`, of several joint vectors: one in each lane. Lanes of the mask have an angle beyond the range of the sines \
         over lanes, and take a single call.",
    );
    let doc_of_both = docs::lines("As `forward_and_jacobian`, of several joint vectors.");
    quote! {
        impl #krate::batch::BatchArm<#n> for #name {
            #doc
            #[inline(always)]
            fn forward_lanes<L: #lanes>(&self, set: L::Set, q: [L; #n]) -> (#krate::Pose<L>, L::Mask) {
                #pose
            }

            #doc_of_both
            #[inline(always)]
            fn forward_and_jacobian_lanes<L: #lanes>(
                &self,
                set: L::Set,
                q: [L; #n],
            ) -> (#krate::Pose<L>, #krate::Jacobian<L, #n>, L::Mask) {
                #both
            }
        }
    }
}

fn body(function: &Function, target: &Target, result: impl Fn(&Writer, &[lower::Slot]) -> TokenStream) -> TokenStream {
    let krate = &target.krate;
    let straight = &function.straight;
    let writer = Writer { graph: &straight.graph, bound: &straight.names, krate, lanes: true };
    let pattern = (0..function.joints.len()).map(|joint| bound(&format!("q{}", joint + 1), function.reads(joint)));
    let name = |slot| bound(&straight.graph.leaf_name(slot).unwrap_or_default(), straight.reads(slot));
    let sines = function.turned.iter().map(|turned| name(turned.pair.sin));
    let cosines = function.turned.iter().map(|turned| name(turned.pair.cos));
    let sums = function.turned.iter().map(|turned| {
        let terms = turned.sum.terms.iter().map(|(joint, negative)| (ident(&format!("q{}", joint + 1)), *negative));
        sum(terms, turned.sum.constant, target)
    });
    let statements = straight.shared.iter().map(|e| writer.statement(*e));
    let result = result(&writer, &straight.roots);
    let body = quote! {
        let [#(#pattern),*] = q;
        let (([#(#sines),*], [#(#cosines),*]), far) = #krate::batch::math::sin_cos_array(set, [#(#sums),*]);
        #(#statements)*
        #result
    };
    let of = names(&body, "of").then(|| of(target));
    quote!(#of #body)
}

/// A sum of `(name, negative)` and a constant.
fn sum(terms: impl IntoIterator<Item = (Ident, bool)>, constant: Angle, target: &Target) -> TokenStream {
    let sum = angle::sum(terms, Angle::ZERO, target);
    if constant.is_zero() {
        return sum;
    }
    let negative = constant.rad() < 0.0;
    let size = angle::tokens(if negative { constant.neg() } else { constant }, target);
    if negative { quote!(#sum - of(#size)) } else { quote!(#sum + of(#size)) }
}

/// The impl of an inverse; `None` without a lane form.
fn inverse(model: &Model, plan: &Plan, target: &Target) -> Option<TokenStream> {
    let program = lower::stages(model, plan);
    if !has_lanes(&program) {
        return None;
    }
    let nest = Nest { plan, target, program: &program, bound: false, lanes: true, selects: false };
    let (krate, name, scalar) = (&target.krate, &target.type_name, target.scalar.tokens());
    let (n, most) = (integer(program.joints), integer(program.capacity));
    let input = |input: Input| bound(&input.name(), program.reads(input));
    let rotation = (0..3).map(|row| array((0..3).map(|column| input(Input::Rotation(row, column)))));
    let translation = array((0..3).map(|component| input(Input::Position(component))));
    let levels = nest.lane_levels();
    let (of, measures) = (names(&levels, "of").then(|| of(target)), nest.measures(&levels));
    let doc = docs::lines(
        "As `inverse`, of several targets: one in each lane. Each state is the lanes whose branch goes on. `branches` keeps the \
         solutions, and the lanes in doubt: these take a single call.",
    );
    Some(quote! {
        impl #krate::batch::BatchInverse<#n, #most> for #name {
            const ARM_CONSTANTS: #krate::solve::ArmConstants<'static, #scalar, #n> = CONSTANTS;

            #doc
            #[inline(always)]
            fn inverse_lanes<L: #krate::batch::Lanes>(
                &self,
                set: L::Set,
                target: &#krate::Pose<L>,
                branches: &mut #krate::batch::Branches<L, #n, #most>,
            ) {
                #of
                #measures
                let start = branches.begins(target, REACH);
                if !branches.go_on(start) {
                    return;
                }
                let [#(#rotation),*] = target.rotation;
                let #translation = target.translation;
                #levels
            }
        }
    })
}

/// Returns true if every statement has a lane form, for targets that are poses.
fn has_lanes(program: &lower::Inverse) -> bool {
    let statements = program.levels.iter().flat_map(|level| &level.body);
    let each = |statement: &Statement| match statement {
        Statement::Swivel { .. } => false,
        Statement::Solve(call) => matches!(
            call.kernel,
            Kernel::Offset(_)
                | Kernel::OffsetOfTwo(_)
                | Kernel::Distance(_)
                | Kernel::Cone(_)
                | Kernel::Align(_)
                | Kernel::Flip(_)
                | Kernel::Wrist(_)
                | Kernel::Slide(_)
                | Kernel::SlideTo(_)
        ),
        _ => true,
    };
    let is_pose = matches!(program.goal, Goal::Pose) && program.given.values.is_empty();
    is_pose && !program.in_doubt && program.off_table.is_none() && statements.into_iter().all(each)
}

impl Nest<'_> {
    fn calls(&self) -> impl Iterator<Item = &Call> {
        self.program.levels.iter().flat_map(|level| &level.body).filter_map(|statement| match statement {
            Statement::Solve(call) => Some(call),
            _ => None,
        })
    }

    /// The units of the equations that are there.
    fn measures(&self, levels: &TokenStream) -> TokenStream {
        let krate = &self.target.krate;
        let measure = |name: &str, scale: TokenStream, part: &str| {
            let (named, part) = (ident(name), ident(part));
            names(levels, name)
                .then(|| quote!(let #named = #krate::batch::LaneMeasure::new(#scale, CONSTANTS.tolerance.#part);))
        };
        let lengths = measure("lengths", quote!(REACH), "position");
        let directions = measure("directions", quote!(1.0), "orientation");
        quote!(#lengths #directions)
    }

    fn lane_levels(&self) -> TokenStream {
        let mut inner = TokenStream::new();
        let mut states = vec![BranchState::Start];
        for level in &self.program.levels {
            // After the last step of a level its state is that of the next one.
            let last = level.body.iter().rev().find_map(after);
            states.push(last.or(states.last().copied()).unwrap_or(BranchState::Start));
        }
        for (level, before) in self.program.levels.iter().zip(&states).rev() {
            let mut state = *before;
            let mut body = TokenStream::new();
            for statement in &level.body {
                body.extend(self.lane_statement(statement, state));
                state = after(statement).unwrap_or(state);
            }
            inner = match &level.each {
                None => quote!(#body #inner),
                Some(each) => self.lane_loop(each, &quote!(#body #inner)),
            };
        }
        inner
    }

    fn lane_loop(&self, each: &Each, body: &TokenStream) -> TokenStream {
        let number = self.number(each.stage);
        let (roots, index, state) =
            (ident(&format!("roots{number}")), ident(&format!("index{number}")), self.state(each.state));
        let pattern = self.pattern(&each.roots);
        let call = self.calls().find(|call| call.stage == each.stage);
        let count = integer(call.map_or(0, |call| call.kernel.form().roots));
        // Of the other kernels every lane has both roots.
        let on = call
            .filter(|call| matches!(call.kernel, Kernel::OffsetOfTwo(_)))
            .map(|_| quote!(let #state = #roots.on(#state, #index);));
        quote! {
            let mut #index = 0;
            while #index < #count {
                let #pattern = #roots.root(#index);
                #on
                #index += 1;
                if !branches.go_on(#state) {
                    continue;
                }
                #body
            }
        }
    }

    fn lane_statement(&self, statement: &Statement, state: BranchState) -> TokenStream {
        let krate = &self.target.krate;
        let writer = self.writer();
        let state = self.state(state);
        let prepared = |what: &str, stage: usize| ident(&format!("{what}{}", super::kernel::joint(self, stage)));
        match statement {
            Statement::Let(e) => writer.statement(*e),
            Statement::Phase { stage, phase: Phase { y, x } } => {
                let (name, y, x) = (prepared("phase", *stage), writer.write(*y), writer.write(*x));
                quote!(let #name = branches.direction(#state, #y, #x);)
            }
            Statement::Elbow { stage, range, line } => {
                let name = prepared("elbow", *stage);
                let [a, b, height] = range.inputs().map(|e| writer.write(e));
                let signed = line.map(|product| writer.write(product)).map(|product| quote!(.signed_lanes(#product)));
                quote!(let #name = #krate::solve::Elbow::new_lanes(#a, #b, #height) #signed;)
            }
            Statement::Cone { stage, range } => {
                let name = prepared("cone", *stage);
                let [along, across, cos, sin] = range.inputs().map(|e| writer.write(e));
                quote!(let #name = #krate::solve::Cone::new_lanes(#along, #across, #cos, #sin);)
            }
            Statement::Solve(call) => {
                let roots = ident(&format!("roots{}", self.number(call.stage)));
                let call = self.lane_call(call);
                quote!(let #roots = #call;)
            }
            Statement::Follow { stage, before } => {
                let (after, before) = (self.state(BranchState::Stage(*stage)), self.state(*before));
                let roots = ident(&format!("roots{}", self.number(*stage)));
                quote!(let #after = branches.follow(#before, &#roots);)
            }
            Statement::Only { stage, roots } => {
                let (pattern, roots) = (self.pattern(roots), ident(&format!("roots{}", self.number(*stage))));
                quote!(let #pattern = #roots.root(0);)
            }
            Statement::Angle { symbol, y, x, .. } => {
                let (symbol, y, x) = (self.leaf(*symbol), writer.write(*y), writer.write(*x));
                quote!(let #symbol = branches.angle(#state, #y, #x);)
            }
            Statement::Agree { index, before, unit, misses, .. } => {
                let (before, agreed) = (self.state(*before), self.state(BranchState::Agreed(*index)));
                let (measure, entries) = (measure(*unit), misses.iter().map(|e| writer.write(*e)));
                quote!(let #agreed = branches.agree(#before, #measure, [#(#entries),*]);)
            }
            Statement::Swivel { .. } => TokenStream::new(),
            Statement::Value { symbol, terms, constant } => {
                let terms = terms.iter().map(|(term, negative)| (self.leaf(*term), *negative));
                let (name, sum) = (self.leaf(*symbol), sum(terms, *constant, self.target));
                quote!(let #name = branches.wrap(#state, #sum);)
            }
            Statement::Push { state, q } => {
                let state = self.state(*state);
                let q = q.iter().map(|slot| self.leaf(*slot));
                quote!(branches.push(#state, [#(#q),*]);)
            }
        }
    }

    /// The lane form of a kernel: without default values, as no joint is free.
    fn lane_call(&self, call: &Call) -> TokenStream {
        let krate = &self.target.krate;
        let form = call.kernel.form();
        let function = ident(&format!("{}_lanes", form.function));
        let arguments = form.arguments.iter().filter_map(|of| match (of, &call.kernel) {
            (Argument::Default(_), _) | (Argument::Measure, Kernel::SlideTo(_)) => None,
            (Argument::Measure, Kernel::OffsetOfTwo(_)) => Some(quote!(lengths, directions)),
            _ => Some(self.lane_argument(call, of)),
        });
        let writer = self.writer();
        let counted = match call.counted {
            Counted::FromZero => TokenStream::new(),
            Counted::TurnedBack(x) => {
                let x = writer.write(x);
                quote!(.turned_back(#x))
            }
            Counted::FromPhase => {
                let name = ident(&format!("phase{}", super::kernel::joint(self, call.stage)));
                quote!(.about(#name))
            }
        };
        quote!(#krate::batch::#function(set, #(#arguments),*) #counted)
    }

    fn lane_argument(&self, call: &Call, of: &Argument) -> TokenStream {
        let krate = &self.target.krate;
        match of {
            Argument::Measure => {
                let measure = measure(call.unit);
                quote!(#measure)
            }
            Argument::Number(e) => self.writer().write(*e),
            Argument::Array(items) => array(items.iter().map(|item| self.lane_argument(call, item))),
            Argument::Range(_) => {
                let name = super::kernel::range(self, call);
                match call.range {
                    RootRange::Elbow { .. } => quote!(#krate::solve::Elbow::in_lanes(set, #name)),
                    RootRange::Cone { .. } => quote!(#krate::solve::Cone::in_lanes(set, #name)),
                    RootRange::None | RootRange::Prepared => quote!(#name),
                }
            }
            // Kernels with others have no lane form.
            Argument::Default(_) | Argument::Tuple(_) | Argument::Struct(..) => TokenStream::new(),
        }
    }
}

/// Returns true if a name stands in some code.
fn names(code: &TokenStream, name: &str) -> bool {
    code.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) => names(&group.stream(), name),
        TokenTree::Ident(ident) => ident == name,
        _ => false,
    })
}

/// The state of a branch after a statement that changes it.
fn after(statement: &Statement) -> Option<BranchState> {
    match statement {
        Statement::Follow { stage, .. } => Some(BranchState::Stage(*stage)),
        Statement::Agree { index, .. } => Some(BranchState::Agreed(*index)),
        _ => None,
    }
}

fn measure(unit: Unit) -> Ident {
    ident(match unit {
        Unit::Length => "lengths",
        Unit::Direction => "directions",
    })
}
