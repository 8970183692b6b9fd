//! The inverse that holds a joint: the constants of its solver, and the call.

use super::constants::Dimensions;
use super::inverse::{Inverse, measure};
use super::inverse_frame::{
    Solver, Sought, inverse_trait, items, methods, named_branch, search_type, solutions, sought,
};
use super::margins::table_branch;
use super::nest::Nest;
use super::solver_constants::{chain_constants, cuts, general, meet, structure};
use super::task::{TaskCode, task};
use super::tokens::{array, ident, integer, number};
use super::{Target, docs, given};
use crate::lower;
use crate::model::Model;
use crate::solve::{Goal, HeldJointPlan, Link, Method, Outline, Plan};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The code of the inverse.
pub fn held_joint(model: &Model, plan: &HeldJointPlan, target: &Target) -> Inverse {
    let program = lower::held_joint(model, plan);
    let task = task(model, &program, target);
    let outline = &plan.outline();
    let named = program.table_margins.as_ref().map(|margins| table_branch(margins, model, target));
    let branches = match named {
        Some(item) => Branches { item, method: named_branch(plan.joints, target, &task) },
        None => Branches::without_names(plan, target, &task),
    };
    let solver = Solver {
        gap: "the least miss of a candidate (the reach if there is none)",
        bound: "The call takes at most 300 evaluations of `forward_and_jacobian`, for any target; `is_complete()` of the\n\
                solutions is false where that is not enough, or where the equation has too few digits.",
        method: "one joint is held at the real roots of a polynomial; see the function `solve`.",
        function: ident("solve"),
        arguments: TokenStream::new(),
        branch: branches.method,
    };
    let (constants, item) = (solver_constants(plan, target), branches.item);
    let table = plan.stages_of_table();
    let table = table.as_ref().zip(program.of_table.as_deref());
    let starts = table.map(|table| Starts::of(model, table, outline, target));
    let own = starts.as_ref().map(|starts| &starts.items);
    Inverse {
        items: items(model, &program.constants, target, [TokenStream::new(), quote!(#own #constants #item)]),
        function: function(plan, target, &task, starts),
        methods: methods(model, outline, target, &task, &solver),
        trait_impl: inverse_trait(model, outline, plan.names.is_some(), None, target, &task, &solver),
    }
}

/// The method `inverse_branch`, and the item beside it: the function that names branches, or where there are no names the
/// trait whose message says why the call does not compile.
struct Branches {
    item: TokenStream,
    method: TokenStream,
}

impl Branches {
    fn without_names(plan: &HeldJointPlan, target: &Target, task: &TaskCode) -> Self {
        let outline = &plan.outline();
        let (krate, scalar, n) = (&target.krate, target.scalar.tokens(), integer(outline.joints));
        let name = &target.type_name;
        let (named, target_type) = (format_ident!("{name}NamesItsBranches"), &task.target);
        let argument = given::kind(&outline.task.given, target).map(|kind| quote!(, _given: #kind));
        let message =
            format!("the solutions of `{name}` are numbered anew at every target: no branch can be asked for");
        Branches {
            item: quote! {
                /// Implemented by nothing: its message says why no branch can be asked for.
                #[diagnostic::on_unimplemented(
                    message = #message,
                    label = "this arm has no branches with names",
                    note = "`inverse_near` lists the solution nearest to a joint vector first"
                )]
                pub trait #named {}
            },
            method: quote! {
                /// Does not compile: the solutions are numbered anew at every target.
                pub fn inverse_branch<Named: #named>(
                    &self,
                    _target: &#target_type
                    #argument,
                    _branch: Named,
                ) -> #krate::OneSolution<#scalar, #n> {
                    ::core::result::Result::Err(#krate::Status::BadTarget)
                }
            },
        }
    }
}

/// The stages of a measured arm's table, which give starts to solutions.
struct Starts {
    /// Constants beside the functions.
    items: TokenStream,
    /// The type of the search, before the function.
    search_type: TokenStream,
    /// Constants of the equations, in the function.
    dimensions: TokenStream,
    /// The statements that follow the stages.
    follow: TokenStream,
}

impl Starts {
    /// `table`: the plan of the table, and that as a program; `outline`: that of the arm that was measured.
    fn of(model: &Model, (table, program): (&Plan, &lower::Inverse), outline: &Outline, target: &Target) -> Self {
        let nest = Nest { plan: table, target, program, bound: false, lanes: false, selects: false };
        let (levels, ranges, measure) = (nest.levels(), nest.constants(), measure(model, target));
        let mut dimensions = Dimensions::default();
        dimensions.collect_from(&table.graph, &table.inputs());
        let unpack = task(model, program, target).unpack;
        let off = program.off_table.unwrap_or(0.0);
        let doc = docs::lines(&format!(
            "Follows every branch of the table, stage by stage. The arm that was measured is up to {off:.0e} off it: every branch \
             is verified. Where the table is singular, solutions are missing here."
        ));
        let off = number(off);
        Self {
            items: quote!(#measure #ranges),
            search_type: search_type(target, outline, false),
            dimensions: dimensions.items(model, target),
            follow: quote! {
                #unpack
                #doc
                let nest = |search: &mut InverseSearch<'_>, start| {
                    #levels
                };
                search.start_from_table(#off, nest);
            },
        }
    }
}

/// The constants of the solver, as items.
fn solver_constants(plan: &HeldJointPlan, target: &Target) -> TokenStream {
    let krate = &target.krate;
    // The ring's other constants are those of MEET.
    let is_read =
        |place: usize| !matches!(plan.method, Method::Meet { constants: Some(_), .. }) || matches!(place, 0 | 6);
    let links = chain_constants(&plan.chain, is_read, target);
    match &plan.method {
        Method::Meet { structure: found, constants: Some(constants) } => {
            let (value, structure) = (meet(constants, target), structure(found, target));
            let scalar = target.scalar.tokens();
            quote! {
                #links
                /// The axes that meet and the axes that are parallel.
                const STRUCTURE: #krate::held_joint::meet::Structure = #structure;
                /// Constants of the ring that begins with the held joint.
                const MEET: #krate::held_joint::meet::Meet<#scalar> = #value;
            }
        }
        Method::Meet { structure: found, constants: None } => {
            let structure = structure(found, target);
            quote! {
                #links
                /// The axes that meet and the axes that are parallel.
                const STRUCTURE: #krate::held_joint::meet::Structure = #structure;
            }
        }
        Method::Slides { .. } => links,
        Method::General { constants: Some(constants), .. } => general(constants, target),
        Method::General { cuts: chosen, constants: None } => {
            let value = cuts(chosen, target);
            quote! {
                #links
                /// The joints that are held, chosen when this code was generated.
                const CUTS: #krate::held_joint::general::Cuts = #value;
            }
        }
    }
}

/// The function that fills a list.
fn function(plan: &HeldJointPlan, target: &Target, task: &TaskCode, starts: Option<Starts>) -> TokenStream {
    let outline = &plan.outline();
    let (krate, scalar, type_name) = (&target.krate, target.scalar.tokens(), &target.type_name);
    let (n, m) = (integer(outline.joints), integer(outline.capacity));
    let solutions = solutions(outline, target);
    let target_type = &task.target;
    let argument = given::parameter(&outline.task.given, target).map(|argument| quote!(#argument,));
    let Sought { bind, name: sought } = sought(outline, task, target);
    let lines: Vec<String> = plan.describe().into_iter().map(|line| format!("- {line}")).collect();
    let doc = docs::lines(&format!("All solutions.\n\n{}", lines.join("\n")));
    let joint = |joint: usize| ident(&format!("q{}", joint + 1));
    let all: Vec<Ident> = (0..outline.joints).map(joint).collect();
    let six: Vec<Ident> = plan.chain.solved.iter().map(|number| joint(*number)).collect();
    let defaults = all.iter().map(|name| if six.contains(name) { quote!(#name) } else { quote!(_) });
    let frame = if outline.task.goal == Goal::Pose { quote!(goal) } else { quote!(frame) };
    let bind_frame = (outline.task.goal != Goal::Pose).then(|| quote!(let frame = goal.frame();));
    let virtual_joint = |name: TokenStream| (six.len() < 6).then_some(quote!(, #name));
    let (zero, unread) = (virtual_joint(quote!(0.0)), virtual_joint(quote!(_)));
    let (prepare, search) = search(plan, target);
    let run = if plan.lacks_a_turn() {
        quote!(run_with_turn(&CONSTANTS, near, |[#(#six),*, turn]| ([#(#all),*], turn), |visit| #search))
    } else if plan.names.is_some() {
        let named = quote!(|q| table_branch(#frame, q));
        quote!(run_named(&CONSTANTS, near, |[#(#six),*]| [#(#all),*], #named, |visit| #search))
    } else if let (Some(off), 6) = (plan.off_table, six.len()) {
        let off = number(off);
        quote!(run_unfolded(&CONSTANTS, near, #off, |[#(#six),*]| [#(#all),*], |visit| #search))
    } else {
        quote!(run_held_joint(&CONSTANTS, near, |[#(#six),* #unread]| [#(#all),*], |visit| #search))
    };
    let starts = starts.as_ref();
    let search_of = match starts {
        Some(_) => quote!(InverseSearch),
        None => quote!(#krate::held_joint::HeldJointSearch::<'_, #scalar, #n, #m>),
    };
    let in_doubt = starts.map(|_| quote!(.in_doubt()));
    let [search_type, dimensions, follow] = [
        starts.map(|starts| &starts.search_type),
        starts.map(|starts| &starts.dimensions),
        starts.map(|starts| &starts.follow),
    ];
    quote! {
        #search_type

        #doc
        fn solve(
            arm: &#type_name,
            target: &#target_type,
            #argument
            near: ::core::option::Option<&[#scalar; #n]>,
            solutions: &mut #solutions,
        ) {
            #dimensions
            #bind
            let mut search = #search_of::new(&CONSTANTS, arm, #sought, near, solutions) #in_doubt;
            if search.begins(near) {
                #follow
                #bind_frame
                let target = #krate::held_joint::Transform { rotation: #frame.rotation, translation: #frame.translation };
                let [#(#defaults),*] = search.defaults();
                let reference = [#(#six),* #zero];
                #prepare
                search.#run;
            }
        }
    }
}

/// Statements before the search, and the call of the solver.
fn search(plan: &HeldJointPlan, target: &Target) -> (TokenStream, TokenStream) {
    let krate = &target.krate;
    let links = array(plan.chain.links.iter().enumerate().map(|(place, link)| self::link(place, link)));
    match &plan.method {
        Method::Meet { constants: Some(_), .. } => {
            let end = |place: usize| {
                let link = plan.chain.links.get(place)?;
                let product = self::link(place, link);
                Some(if link.given.is_empty() { quote!(&#product) } else { quote!(&(#product)) })
            };
            let (base, tip) = (end(0), end(6));
            let prepare = quote! {
                let k1 = STRUCTURE.first_of_ring(#base, &target, #tip);
            };
            (prepare, quote!(MEET.search(&k1, &reference, visit)))
        }
        Method::Meet { constants: None, .. } => {
            let prepare = quote! {
                let ring = STRUCTURE.ring(&#links, &target);
                let meet = #krate::held_joint::meet::Meet::of(&STRUCTURE, &ring);
                let [k1, ..] = ring;
            };
            let search = quote! {
                match &meet {
                    ::core::option::Option::Some(meet) => meet.search(&k1, &reference, visit),
                    ::core::option::Option::None => #krate::held_joint::Outcome { is_complete: false },
                }
            };
            (prepare, search)
        }
        Method::Slides { turning, prismatic } => {
            let [turning, prismatic] =
                [&turning[..], &prismatic[..]].map(|joints| array(joints.iter().map(|joint| integer(*joint))));
            let prepare = quote! {
                let slides = #krate::held_joint::slides::Slides {
                    links: #links,
                    turning: #turning,
                    prismatic: #prismatic,
                };
            };
            (prepare, quote!(slides.search(&target, &reference, visit)))
        }
        Method::General { constants: Some(_), .. } => {
            (TokenStream::new(), quote!(GENERAL.search(&target, &reference, visit)))
        }
        Method::General { constants: None, .. } => {
            let is_prismatic = array(plan.chain.is_prismatic.iter());
            let prepare = quote!(let chain = #krate::held_joint::Chain::new(#links, #is_prismatic).gathered(););
            (prepare, quote!(CUTS.search(&chain, &target, &reference, visit)))
        }
    }
}

/// A link: its constant, with the joints that are given.
fn link(place: usize, link: &Link) -> TokenStream {
    let first = format_ident!("C{place}");
    let mut product = quote!(#first);
    for (number, joint) in link.given.iter().enumerate() {
        let after = format_ident!("C{place}_{}", number + 1);
        let (q, is_prismatic) = (ident(&format!("q{}", joint.joint + 1)), joint.is_prismatic);
        product = quote!(#product.then_move(#is_prismatic, #q) * #after);
    }
    product
}
