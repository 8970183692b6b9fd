//! The module of one arm.

use std::fmt;
use std::path::Path;

use denhart_codegen::Builder;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::Error;
use crate::functions::{Call, Functions, read};

/// The number type of an arm's code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scalar {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        })
    }
}

/// `pub mod puma560_f32 { .. }`: the generated code with the struct `Robot`, the type `Case`, and its functions called.
pub(crate) fn of(arm: &str, scalar: Scalar, path: &Path) -> Result<String, Error> {
    let name = format!("{arm}_{scalar}");
    let code = Builder::new(path).type_name("Robot").scalar(scalar.to_string().as_str()).generate()?;
    let Functions { calls, given, has_inverse } = read(&code, "Robot")?;
    let scalar = format_ident!("{scalar}");
    let target = if has_inverse {
        quote!(<Robot as ::denhart::InverseKinematics<#scalar, { Robot::DOF }>>::Target)
    } else {
        quote!(())
    };
    let timed = calls.iter().map(timed);
    let digests = calls.iter().map(digest);
    let timed_calls = calls.iter().map(|Call { name, keeps, .. }| {
        let name = format_ident!("{name}");
        if *keeps { quote!(#name(case, &mut kept());) } else { quote!(#name(case);) }
    });
    let kept = has_inverse.then(|| {
        quote! {
            /// A list that a caller keeps.
            pub type Kept = <Robot as ::denhart::InverseKinematics<#scalar, { Robot::DOF }>>::Solutions;
            /// An empty one.
            pub fn kept() -> Kept {
                Kept::new(::denhart::Status::BadTarget)
            }
            /// Calls of a follower and of a path follower.
            pub fn followers(case: &Case) {
                let mut digest = ::firmware_cases::Digest::new();
                ::firmware_cases::followers(&Robot, black_box(case), &mut digest);
                black_box(&digest);
            }
            /// A follower of the arm.
            pub type Follower = ::denhart::follow::Follower<#scalar, { Robot::DOF }>;
            /// Its settings.
            pub type FollowSettings = ::denhart::follow::FollowSettings<#scalar, { Robot::DOF }>;
            /// Calls `Follower::step`.
            #[inline(never)]
            pub fn follower_step(follower: &mut Follower, target: &#target, kept: &mut Kept) -> ::denhart::follow::Tracking {
                let step = black_box(follower).step(&Robot, black_box(target), kept);
                black_box(&step).tracking
            }
            /// Begins to follow, and calls `follower_step`.
            pub fn follower(case: &Case, kept: &mut Kept) {
                let rates = ::denhart::follow::Rates { velocity: case.qd, acceleration: case.qdd };
                let settings = FollowSettings::new(black_box(0.001), rates);
                if let Ok(mut follower) = Follower::new(&Robot, black_box(settings), black_box(&case.q)) {
                    follower_step(&mut follower, &case.target, kept);
                }
            }
        }
    });
    let (solutions, kept_solutions) = if has_inverse {
        (
            quote! {
                d(case, "solutions", &|case, digest| ::firmware_cases::solutions(&Robot, case, digest));
                d(case, "followers", &|case, digest| ::firmware_cases::followers(&Robot, case, digest));
            },
            quote!(::firmware_cases::solutions(&Robot, case, &mut digest);),
        )
    } else {
        (quote!(), quote!())
    };
    let subject = has_inverse.then(|| {
        // Without a joint that is given the number is not used.
        let joint = given.and_then(|joint| joint.strip_prefix('q')?.parse::<usize>().ok()).unwrap_or(1) - 1;
        quote! {
            impl ::firmware_cases::Subject<#scalar, { Robot::DOF }> for Robot {
                const NAME: &'static str = #name;
                const GIVEN: usize = #joint;
                fn each_function(case: &Case, d: ::firmware_cases::Each<'_, Case>) {
                    each_function(case, d);
                }
            }
        }
    });
    let more = quote! {
        /// The arguments of its functions.
        pub type Case = ::firmware_cases::Case<#scalar, #target, { Robot::DOF }>;
        /// Calls, of which the compiler knows neither arguments nor use.
        pub mod call {
            use super::{Case, Robot};
            use ::core::hint::black_box;
            /// Every call of this module but those of followers.
            pub fn every(case: &Case) {
                let case = black_box(case);
                #(#timed_calls)*
                let mut digest = ::firmware_cases::Digest::new();
                ::firmware_cases::poses(case, &mut digest);
                ::firmware_cases::numeric(&Robot, case, &mut digest);
                #kept_solutions
                black_box(&digest);
            }
            #kept
            #(#timed)*
        }
        /// Each function by its name, and how its results are digested.
        pub fn each_function(case: &Case, d: ::firmware_cases::Each<'_, Case>) {
            #(#digests)*
            #solutions
            d(case, "numeric", &|case, digest| ::firmware_cases::numeric(&Robot, case, digest));
            d(case, "poses", &|case, digest| ::firmware_cases::poses(case, digest));
        }
        #subject
    };
    Ok(format!("/// The arm `{arm}`.\n#[allow(dead_code)]\npub mod {name} {{\n{code}\n{more}\n}}\n"))
}

/// A function that makes the call and keeps its result.
fn timed(Call { name, arguments, many, keeps }: &Call) -> TokenStream {
    let (name, title) = (format_ident!("{name}"), format!("Calls `{name}`."));
    let hidden = arguments.iter().map(|argument| quote!(black_box(#argument)));
    let body = if *many {
        quote!(for item in Robot.#name(#(#hidden),*) { black_box(&item); })
    } else {
        quote!(black_box(&Robot.#name(#(#hidden),*));)
    };
    let list = keeps.then(|| quote!(, kept: &mut Kept));
    quote! {
        #[doc = #title]
        #[inline(never)]
        pub fn #name(case: &Case #list) { #body }
    }
}

/// The call whose result is digested.
fn digest(Call { name, arguments, many, keeps }: &Call) -> TokenStream {
    let (function, name) = (format_ident!("{name}"), name);
    let body = if *many {
        quote!(for item in Robot.#function(#(#arguments),*) { digest.add(&item); })
    } else if *keeps {
        quote!(let kept = &mut call::kept(); Robot.#function(#(#arguments),*); digest.add(kept);)
    } else {
        quote!(digest.add(&Robot.#function(#(#arguments),*));)
    };
    quote!(d(case, #name, &|case, digest| { #body });)
}
