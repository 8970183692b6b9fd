//! The surroundings of the loops of an inverse: constants, the function's frame, and the methods.

use super::task::TaskCode;
use super::tokens::{array, ident, integer, number};
use super::{Target, combined_limits, docs, given, parameters, worked_out};
use crate::lower::{ArmConstants, Inverse, Margins};
use crate::model::{JointKind, Model};
use crate::solve::{Branching, Given, GivenValues, Goal, Outline, Plan};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// Reach, tolerances and limits as constants; `measure` and `own` are those of the solver.
pub(super) fn items(
    model: &Model,
    constants: &ArmConstants,
    target: &Target,
    [measure, own]: [TokenStream; 2],
) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(model.joints.len()));
    let reach = worked_out::reach(constants.reach, model, target);
    let limited = constants.limited;
    let sliding = constants
        .prismatic
        .iter()
        .map(|joint| integer(*joint))
        .map(|index| quote!(.union(#krate::JointMask::single(#index))));
    let weights = constants.weights.iter().copied().map(number);
    let length = worked_out::position_tolerance(constants, model, target);
    let angle = number(constants.angle);
    let unit = model.length_unit.symbol();
    let reach_doc = format!(" Reach of the arm, {unit}: the scale of every length comparison.");
    let type_name = &target.type_name;
    let combined = combined_limits::reference(model, target);
    let stands_for = match constants.stands_for.map(integer) {
        Some(last) => quote!(#krate::JointMask::single(#last)),
        None => quote!(#krate::JointMask::NONE),
    };
    let wrist = match constants.wrist.map(|joints| joints.map(integer)) {
        Some(joints) => {
            let joints = array(joints);
            quote!(::core::option::Option::Some(#joints))
        }
        None => quote!(::core::option::Option::None),
    };
    let constants_doc = if model.parameters.is_empty() {
        " Constants of the arm for the search."
    } else {
        " Constants of the arm for the search; the reach is that of the file's lengths."
    };
    quote! {
        #[doc = #reach_doc]
        const REACH: #scalar = #reach;
        #measure
        #[doc = #constants_doc]
        const CONSTANTS: #krate::solve::ArmConstants<#scalar, #n> = #krate::solve::ArmConstants {
            limits: &#type_name::LIMITS,
            combined: #combined,
            weights: &[#(#weights),*],
            limited: #limited,
            prismatic: #krate::JointMask::NONE #(#sliding)*,
            stands_for: #stands_for,
            wrist: #wrist,
            reach: REACH,
            tolerance: #krate::Residual { position: #length, orientation: #angle },
        };
        #own
    }
}

pub(super) fn solutions(outline: &Outline, target: &Target) -> TokenStream {
    let (krate, scalar, n, m) =
        (&target.krate, target.scalar.tokens(), integer(outline.joints), integer(outline.capacity));
    quote!(#krate::Solutions<#scalar, #n, #m>)
}

/// The statements that bind what is searched for, and its name.
pub(super) struct Sought {
    pub(super) bind: TokenStream,
    pub(super) name: Ident,
}

/// The goal of a search, and its name.
pub(super) fn sought(outline: &Outline, task: &TaskCode, target: &Target) -> Sought {
    let krate = &target.krate;
    let goal = &task.goal;
    let mut bind = match outline.task.goal {
        Goal::Pose => quote! {
            let mut nearest = ::core::option::Option::None;
            let goal = #krate::solve::nearest_rotation(target, &mut nearest, solutions);
        },
        _ => quote!(let goal = #goal;),
    };
    let locked = given::locked(outline, target);
    let name = ident(if locked.is_some() { "locked" } else { "goal" });
    bind.extend(locked);
    Sought { bind, name }
}

/// The parts of the function that solves.
pub(super) struct Body<'a> {
    /// Constants of the equations alone.
    pub(super) dimensions: &'a TokenStream,
    /// Sines and cosines of the joints whose values are given.
    pub(super) given_symbols: TokenStream,
    /// The loops.
    pub(super) levels: TokenStream,
}

/// The function around the loops.
pub(super) fn function(
    model: &Model,
    plan: &Plan,
    program: &Inverse,
    target: &Target,
    task: &TaskCode,
    body: &Body<'_>,
) -> TokenStream {
    let Body { dimensions, given_symbols, levels } = body;
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let n = integer(plan.joints());
    let outline = &plan.outline();
    let solutions = solutions(outline, target);
    let type_name = &target.type_name;
    let lines: Vec<String> = crate::solve::describe(plan).into_iter().map(|line| format!("- {line}")).collect();
    let selects = program.follows_single_branches();
    let followed =
        if selects { "All branches of the inverse, or those that are wanted." } else { "All branches of the inverse." };
    let doc = docs::lines(&format!("{followed}\n\n{}", lines.join("\n")));
    let (target_type, unpack) = (&task.target, &task.unpack);
    let argument = given::parameter(&outline.task.given, target).map(|argument| quote!(#argument,));
    let Sought { bind: goal, name: sought } = sought(outline, task, target);
    let (constants, sizes) = if model.parameters.is_empty() {
        (quote!(&CONSTANTS), TokenStream::new())
    } else {
        (quote!(&constants), parameters::sizes(model, target))
    };
    let search_type = search_type(target, outline, program.decoupled);
    let nest_doc = if program.decoupled {
        "Follows every branch, stage by stage. The search repeats it with two free joints at other places, where two families of \
         solutions cross."
    } else {
        "Follows every branch, stage by stage. The search repeats it with a free joint at another place, where a later stage has no \
         root with that joint at its default."
    };
    let nest_doc = docs::lines(nest_doc);
    let miss = plan.missed.map(|by| match plan.off_table {
        Some(_) => format!(
            "The equations and the dimensions above are those of the table. The arm that was measured is up to {by:.0e} off it: \
             every branch is verified."
        ),
        None => format!("The axes miss the structure of the equations by {by:.0e}: every branch is verified."),
    });
    let lacking = plan.lacks_a_turn().then_some(
        "The equations are those of a chain with a joint more, whose value has to be 0: every branch is verified.",
    );
    let missed_doc = miss.as_deref().or(lacking).map(docs::lines);
    let in_doubt = program.in_doubt.then(|| quote!(.in_doubt()));
    let run = match program.off_table {
        Some(off) => {
            let off = number(off);
            let name = match program.table_margins {
                Some(_) => quote!(|q, branch| *branch = table_branch(goal, q)),
                None => quote!(|_, _| {}),
            };
            quote!(run_measured(#constants, near, #off, #name, nest))
        }
        None => quote!(run(#constants, near, nest)),
    };
    let wanted = selects.then(|| {
        // Without a choice between roots there is nothing to select.
        let wanted = ident(if program.capacity > 1 { "wanted" } else { "_wanted" });
        quote!(#wanted: impl #krate::solve::Select,)
    });
    quote! {
        #search_type

        #doc
        fn branches(
            arm: &#type_name,
            target: &#target_type,
            #argument
            near: ::core::option::Option<&[#scalar; #n]>,
            #wanted
            solutions: &mut #solutions,
        ) {
            #dimensions
            #sizes
            #goal
            #missed_doc
            let mut search = InverseSearch::new(#constants, arm, #sought, near, solutions) #in_doubt;
            if search.begins(near) {
                #unpack
                #given_symbols
                #nest_doc
                let nest = |search: &mut InverseSearch<'_>, start| {
                    #levels
                };
                search.#run;
            }
        }
    }
}

/// The type of a search that follows stages.
pub(super) fn search_type(target: &Target, outline: &Outline, decoupled: bool) -> TokenStream {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let (open, doc) = if decoupled {
        (0, "The search of an arm on which no later stage sees where a free joint is.")
    } else {
        (
            outline.capacity,
            "The search; it remembers the branches that are missed with a free joint at its default value.",
        )
    };
    let [n, m, open] = [outline.joints, outline.capacity, open].map(integer);
    let doc = docs::lines(&format!("{doc} Its numbers: joints, solutions, branches that may be missed."));
    quote! {
        #doc
        type InverseSearch<'a> = #krate::solve::Search<'a, #scalar, #n, #m, #open>;
    }
}

/// Docs and calls by which the methods of a closed form differ from those of a held joint.
pub(super) struct Solver<'a> {
    /// The residual of `Unreachable`.
    pub(super) gap: &'a str,
    /// The bound of a call, a sentence.
    pub(super) bound: &'a str,
    /// The method and its source.
    pub(super) method: &'a str,
    /// The function that fills a list.
    pub(super) function: Ident,
    /// Its arguments behind the reference.
    pub(super) arguments: TokenStream,
    /// The method `inverse_branch`.
    pub(super) branch: TokenStream,
}

/// `inverse`, `inverse_near`, both into a list of the caller, `inverse_branch` and `residual`.
pub(super) fn methods(
    model: &Model,
    outline: &Outline,
    target: &Target,
    task: &TaskCode,
    solver: &Solver,
) -> TokenStream {
    let (krate, scalar, n, m) =
        (&target.krate, target.scalar.tokens(), integer(outline.joints), integer(outline.capacity));
    let solutions = solutions(outline, target);
    let Solver { gap, bound, method, function, arguments, branch } = solver;
    let values = &outline.task.given;
    let fixed = fixed(values);
    let doc = docs::lines(&format!(
        "Every joint vector that reaches `target`: up to {m} branches, in a fixed order.\n\n\
         {}\n{}Angles are in (-pi, pi], each solution once.\n\
         A joint that a singular target leaves free is named in `free`. It is at 0 (or its limit nearest to 0), unless \
         joints after it need another value.\n\
         Status: `Reachable`, `Unreachable` with {gap}, or `BadTarget` if the \
         target {}{}. The gap is not the distance to the workspace; `numeric` finds that.\n\
         {bound}\n\
         Limits only set a flag; filter with `within_limits()`.\n\n\
         Method: {method}",
        task.doc,
        fixed,
        task.bad,
        if model.parameters.is_empty() { "" } else { ", or a length of the arm is not finite" },
    ));
    let (target_type, goal) = (&task.target, &task.goal);
    let argument = given::argument(values, target).map(|argument| quote!(, #argument));
    let pass = given::passed(values).map(|given| quote!(#given,));
    let unpack = given::unpacked(values);
    let pass_wrapped = given::wrapped(values, target).map(|given| quote!(#given,));
    let pass_taken = given::collected(values).map(|given| quote!(#given,));
    let from_reference = given::from_reference(values);
    let arm_angle = arm_angle(outline, target);
    let sample = sample_redundancy(model, outline, target, task);
    let held = match values.values.len() {
        0 => "a free joint stays at its value".to_owned(),
        1 => format!("{} and free joints stay at their value", given::in_words(values)),
        _ => format!("{} and free joints stay at their values", given::in_words(values)),
    };
    let near = docs::lines(&format!(
        "The solutions of `inverse` with each joint next to `q_ref`, the nearest first; {held} in `q_ref`.\n\n\
         Each revolute joint is on the turn nearest to `q_ref`: inside the limits, if `q_ref` is inside and such a turn \
         exists. {} A `q_ref` that is not finite, or an angle in it beyond 2048 rad (f32: 64), is a \
         `BadTarget`.",
        distance(model)
    ));
    let list = quote!(let mut solutions = #krate::Solutions::new(#krate::Status::BadTarget););
    quote! {
        #arm_angle
        #sample

        /// The largest number of solutions of `inverse`.
        pub const MAX_SOLUTIONS: usize = #m;

        #doc
        #[inline(always)]
        #[must_use]
        pub fn inverse(&self, target: &#target_type #argument) -> #solutions {
            #list
            self.inverse_into(target, #pass &mut solutions);
            solutions
        }

        /// Like `inverse`, but overwrites `solutions` and saves a copy.
        #[inline(always)]
        pub fn inverse_into(&self, target: &#target_type #argument, solutions: &mut #solutions) {
            solutions.reset(#krate::Status::BadTarget);
            #unpack
            #function(self, target, #pass_wrapped ::core::option::Option::None, #arguments solutions);
        }

        #branch

        #near
        #[inline(always)]
        #[must_use]
        pub fn inverse_near(&self, target: &#target_type, q_ref: &[#scalar; #n]) -> #solutions {
            #list
            self.inverse_near_into(target, q_ref, &mut solutions);
            solutions
        }

        /// Like `inverse_near`, but overwrites `solutions` and saves a copy.
        #[inline(always)]
        pub fn inverse_near_into(&self, target: &#target_type, q_ref: &[#scalar; #n], solutions: &mut #solutions) {
            #from_reference
            solutions.reset(#krate::Status::BadTarget);
            #function(self, target, #pass_taken ::core::option::Option::Some(q_ref), #arguments solutions);
        }

        /// Residual of `q` for the target, by `forward`.
        #[must_use]
        pub fn residual(&self, q: &[#scalar; #n], target: &#target_type) -> #krate::Residual<#scalar> {
            #krate::solve::Goal::residual(#goal, q, &self.forward(q))
        }
    }
}

/// The lines on the given values in the documentation of `inverse`.
fn fixed(values: &GivenValues) -> String {
    let swing = "how far the elbow is swung about the line from shoulder to wrist, rad; see `arm_angle()`";
    match values.values.as_slice() {
        [] => String::new(),
        [Given::ArmAngle] if !values.is_list => format!("`arm_angle`: {swing}.\n"),
        [_] if !values.is_list => format!("{}: value of the redundant joint.\n", given::in_words(values)),
        [_] => format!("`given`: the value of {}.\n", given::in_words(values)),
        _ => {
            let angle = if values.values.contains(&Given::ArmAngle) { "\n`arm_angle`: " } else { "" };
            let swing = if angle.is_empty() { String::new() } else { format!("{angle}{swing}.") };
            format!("`given`: the values of {}, in this order.{swing}\n", given::in_words(values))
        }
    }
}

/// The method `inverse_branch` of an arm whose branches have names.
pub(super) fn inverse_branch(plan: &Plan, target: &Target, task: &TaskCode) -> TokenStream {
    let outline = &plan.outline();
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(outline.joints));
    let target_type = &task.target;
    let values = &outline.task.given;
    let argument = given::argument(values, target).map(|argument| quote!(, #argument));
    let unpack = given::unpacked(values);
    let pass = given::wrapped(values, target).map(|given| quote!(#given,));
    let doc = docs::lines(
        "The solution of `inverse` on one branch, without computing the others; or the status that says why there is none \
         (`Unreachable` with the gap at which the branch ends). Where branches meet, either gives the one solution, \
         flagged `BOUNDARY`. Components unset in `branch` match any value.",
    );
    // Without a flip only the branch is followed.
    let one =
        if plan.flip().is_some() { quote!(solutions.one_on(branch)) } else { quote!(solutions.first_or_status()) };
    quote! {
        #doc
        #[inline]
        pub fn inverse_branch(
            &self,
            target: &#target_type
            #argument,
            branch: #krate::Branch,
        ) -> #krate::OneSolution<#scalar, #n> {
            let mut solutions = #krate::Solutions::new(#krate::Status::BadTarget);
            #unpack
            branches(self, target, #pass ::core::option::Option::None, branch, &mut solutions);
            #one
        }
    }
}

/// The method that gives the solution of a name.
pub(super) fn named_branch(joints: usize, target: &Target, task: &TaskCode) -> TokenStream {
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(joints));
    let target_type = &task.target;
    quote! {
        /// The first solution of `inverse` with a name, or the status that says why there is none: `Unreachable` with the
        /// reach where solutions have other names. Components unset in `branch` match any value.
        #[inline]
        pub fn inverse_branch(&self, target: &#target_type, branch: #krate::Branch) -> #krate::OneSolution<#scalar, #n> {
            let mut solutions = #krate::Solutions::new(#krate::Status::BadTarget);
            self.inverse_into(target, &mut solutions);
            solutions.named(branch, REACH)
        }
    }
}

/// The arm angle of a joint vector.
fn arm_angle(outline: &Outline, target: &Target) -> Option<TokenStream> {
    let constants = outline.task.swivel.as_ref()?;
    let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(outline.joints));
    let vector = |v: [f64; 3]| array(v.map(number));
    let rows = array(constants.shoulder.r.map(vector));
    let (origin, wrist, axis, elbow) =
        (vector(constants.shoulder.p), vector(constants.wrist), vector(constants.axis), vector(constants.elbow));
    // The shoulder may stand on a link.
    let carrier = constants.first.checked_sub(1);
    let carried = carrier.map(|_| quote!(carrier *));
    let places = (0..=constants.first + 3).map(|place| match place {
        place if Some(place) == carrier => ident("carrier"),
        place if place == constants.first + 3 => ident("link"),
        _ => ident("_"),
    });
    let links = quote!(let [#(#places,)* ..] = self.link_poses(q););
    let (before, links) = if carrier.is_some() { (Some(links), None) } else { (None, Some(links)) };
    Some(quote! {
        /// The arm angle of a joint vector, rad in (-pi, pi]: how far the elbow is swung about the line from shoulder
        /// to wrist. The angle counts from the side of the first joint's axis. Where the wrist lies on that axis, the
        /// angle counts from the side of the base's x axis. A stretched arm has the side of joint 4's axis, turned by a
        /// right angle.
        #[must_use]
        pub fn arm_angle(&self, q: &[#scalar; #n]) -> #scalar {
            #before
            let swivel = #krate::solve::Swivel::<#scalar> {
                shoulder: #carried #krate::Pose { rotation: #rows, translation: #origin },
                wrist: #wrist,
                axis: #axis,
                elbow: #elbow,
            };
            #links
            swivel.angle(&link)
        }
    })
}

/// A walk over the values of a redundant joint.
fn sample_redundancy(model: &Model, outline: &Outline, target: &Target, task: &TaskCode) -> Option<TokenStream> {
    let (krate, scalar) = (&target.krate, target.scalar.tokens());
    let (solutions, target_type) = (solutions(outline, target), &task.target);
    let values = &outline.task.given;
    let (ranges, wholes): (Vec<_>, Vec<_>) =
        values.values.iter().map(|value| given::range(model, *value, target)).unzip();
    let count = integer(ranges.len());
    match values.values.as_slice() {
        [] => None,
        _ if values.is_list => Some(quote! {
            /// Walks the given values through a grid: each through its limits (without limits: a whole turn, or plus and minus
            /// the reach; the arm angle through a whole turn) in as many equal steps as its `n` says, the last one fastest.
            /// Yields the values, each the middle of its step, and their solutions; allocates nothing.
            pub fn sample_redundancy(
                &self,
                target: &#target_type,
                n: [usize; #count],
            ) -> impl ::core::iter::Iterator<Item = ([#scalar; #count], #solutions)> {
                #krate::solve::grid([#((#ranges, #wholes)),*], n).map(move |given| (given, self.inverse(target, given)))
            }
        }),
        [Given::ArmAngle, ..] => Some(quote! {
            /// Walks the arm angle through a whole turn in `n` equal steps and solves for each, the middle of its step.
            /// Yields the angle and its solutions; allocates nothing.
            pub fn sample_redundancy(
                &self,
                target: &#target_type,
                n: usize,
            ) -> impl ::core::iter::Iterator<Item = (#scalar, #solutions)> {
                let whole = <#scalar as #krate::Scalar>::PI;
                #krate::solve::steps(-whole, whole, whole, n).map(move |value| (value, self.inverse(target, value)))
            }
        }),
        [Given::Joint { joint, revolute }, ..] => {
            let doc = docs::lines(&format!(
                "Walks the redundant joint `q{}` through its limits (without limits: {}) in `n` equal steps and solves for each \
                 value, the middle of its step. Yields the value and its solutions; allocates nothing.",
                joint + 1,
                if *revolute { "a whole turn" } else { "plus and minus the reach" }
            ));
            Some(quote! {
                #doc
                pub fn sample_redundancy(
                    &self,
                    target: &#target_type,
                    n: usize,
                ) -> impl ::core::iter::Iterator<Item = (#scalar, #solutions)> {
                    let [low, high] = #(#ranges)*;
                    #krate::solve::steps(low, high, #(#wholes)*, n).map(move |value| (value, self.inverse(target, value)))
                }
            })
        }
    }
}

/// The trait impl, whose target includes the value of a redundant joint; `branches`: they have names. `margins`: those
/// that the arm's method of that name gives.
pub(super) fn inverse_trait(
    model: &Model,
    outline: &Outline,
    branches: bool,
    margins: Option<&Margins>,
    target: &Target,
    task: &TaskCode,
    solver: &Solver,
) -> TokenStream {
    let (krate, scalar, name) = (&target.krate, target.scalar.tokens(), &target.type_name);
    let (n, m) = (integer(outline.joints), integer(outline.capacity));
    let target_type = &task.target;
    let takes_value = (!outline.task.given.is_empty()).then(|| quote!(, given));
    let given = given::at_joints(&outline.task.given);
    let branch = branches.then(|| {
        quote! {
            #[automatically_derived]
            impl #krate::InverseBranch<#scalar, #n> for #name {
                #krate::delegate_branch!(#name, #scalar, #n #takes_value);
            }
        }
    });
    let following = following(model, outline, margins, target, task, solver);
    quote! {
        #[automatically_derived]
        impl #krate::InverseKinematics<#scalar, #n> for #name {
            #krate::delegate_inverse!(#name, #scalar, #n, #m, #target_type #given);
            #following
        }
        #branch
    }
}

/// The items of the trait that followers of a path call.
fn following(
    model: &Model,
    outline: &Outline,
    margins: Option<&Margins>,
    target: &Target,
    task: &TaskCode,
    solver: &Solver,
) -> TokenStream {
    let (krate, scalar, name) = (&target.krate, target.scalar.tokens(), &target.type_name);
    let n = integer(outline.joints);
    let (goal, Solver { function, arguments, .. }) = (&task.goal, solver);
    let values = &outline.task.given;
    let names = given::collected(values);
    let unpack = names.as_ref().map(|names| quote!(let (target, #names) = (&target.0, target.1);));
    let locked = given::locked(outline, target);
    let sought = ident(if locked.is_some() { "locked" } else { "goal" });
    let wrapped = given::wrapped(values, target);
    // A plan that follows its branches one by one can leave out others.
    let near = match wrapped {
        _ if !arguments.is_empty() => {
            let given = wrapped.map(|wrapped| quote!(, given |#names| #wrapped));
            Some(quote!(#krate::delegate_branch_near!(#scalar, #n, #function #given);))
        }
        Some(wrapped) => Some(quote! {
            fn inverse_branch_near_into(
                &self,
                target: &Self::Target,
                _branch: #krate::Branch,
                q_ref: &[#scalar; #n],
                keeps_place: bool,
                solutions: &mut Self::Solutions,
            ) {
                #unpack
                solutions.reset_near(#krate::Status::BadTarget, keeps_place);
                #function(self, target, #wrapped, ::core::option::Option::Some(q_ref), solutions);
            }
        }),
        None => None,
    };
    let factors = margins.map(|margins| {
        let place = margins.factors.iter().position(|factor| factor.branching == Branching::Wrist).map(integer);
        let wrist = place.map(|place| {
            quote! {
                fn wrist_factor(&self) -> ::core::option::Option<usize> {
                    ::core::option::Option::Some(#place)
                }
            }
        });
        quote! {
            fn factors(&self, q: &[#scalar; #n], factors: &mut [#scalar]) -> usize {
                #krate::Margin::write(&#name::margins(self, q), factors)
            }
            #wrist
        }
    });
    let combined = (!model.combined_limits.is_empty()).then(|| {
        quote! {
            fn combined_limits(&self) -> &[#krate::CombinedLimit<#scalar, #n>] {
                &#name::COMBINED_LIMITS
            }
        }
    });
    quote! {
        fn deviation(
            &self,
            q: &[#scalar; #n],
            target: &Self::Target,
            at: &(#krate::Pose<#scalar>, #krate::Jacobian<#scalar, #n>),
        ) -> #krate::Deviation<#scalar, #n> {
            #unpack
            let goal = #goal;
            #locked
            #krate::Deviation::new(#sought, q, at)
        }
        #near
        #factors
        #combined
    }
}

/// How the distance from a reference is measured.
fn distance(model: &Model) -> String {
    let slides = model.joints.iter().any(|joint| joint.kind == JointKind::Prismatic);
    let unit = if slides { "rad, strokes over the reach" } else { "rad" };
    match &model.inverse.weights {
        Some(weights) => format!("Distance: `sqrt(sum w_i (q_i - q_ref_i)^2)` ({unit}), `w = {weights:?}`."),
        None => format!("Distance: Euclidean ({unit})."),
    }
}
