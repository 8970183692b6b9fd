//! Impls for an arm with a mistake, in which the calls that a user writes type-check. So the mistake is the only error.
//! These impls never run, as the crate does not compile; still they are total.

use denhart_codegen::ScalarKind;
use proc_macro2::TokenStream;
use quote::quote;
use syn::{DeriveInput, Ident, Path};

use crate::stub_motors::motors;

/// Joints of an arm whose file says nothing of them: by far the most arms have six.
const USUAL_JOINTS: usize = 6;

/// Properties of an arm that can be seen without a reader of YAML, in a file that may be broken.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// The number of moving rows; None if there is no row to be seen.
    pub joints: Option<usize>,
    /// `task` of `inverse`.
    pub task: Option<String>,
    /// True if `inverse` has a `redundant` joint, whose value is a further argument.
    pub redundant: bool,
    /// True if that is a list, whose values are an array.
    pub is_list: bool,
}

impl Outline {
    /// Counts the list items that are mappings (the rows; those of `combined_limits` have a `sum`) and not `fixed`.
    pub fn of(text: &str) -> Self {
        let lines = || text.lines().map(|line| line.split(" #").next().unwrap_or(line));
        let mut rows = Vec::new();
        for line in lines().filter(|line| !line.trim_start().starts_with('#')) {
            let begins_row = line.trim_start().starts_with("- ") && line.contains(':');
            match rows.last_mut() {
                _ if begins_row => rows.push(line.to_owned()),
                Some(row) => *row += line,
                None => {}
            }
        }
        let moving = rows.iter().filter(|row| !row.contains("fixed") && !row.contains("sum:")).count();
        let task = lines().find_map(|line| {
            let after = line.split_once("task:")?.1;
            after.split(|c: char| !(c.is_alphanumeric() || c == '_')).find(|word| !word.is_empty()).map(str::to_owned)
        });
        let mut after = lines().filter_map(|line| line.split_once("redundant:"));
        let after = after.next().map(|(_, after)| after.trim());
        // A list over several lines leaves the first one empty.
        let is_list = after.is_some_and(|after| after.is_empty() || after.starts_with('['));
        Self { joints: (moving > 0).then_some(moving), task, redundant: after.is_some(), is_list }
    }

    /// Returns true if `inverse` seems to take a pose.
    fn takes_pose(&self) -> bool {
        match &self.task {
            Some(task) => task == "pose",
            None => self.joints == Some(USUAL_JOINTS),
        }
    }

    /// The type of a target at joint values; a pose where no task can be seen.
    fn target_at(&self, krate: &Path, number: &TokenStream) -> TokenStream {
        match self.task.as_deref() {
            Some("position") => quote!([#number; 3]),
            Some("position_axis") => quote!(#krate::PointAxis<#number>),
            Some("position_angle") => quote!(#krate::PointAngle<#number>),
            Some("planar_pose") => quote!(#krate::PlanarPose<#number>),
            Some("planar_position") => quote!([#number; 2]),
            _ => quote!(#krate::Pose<#number>),
        }
    }
}

/// The impls. Where the number of joints is not known the functions take any; what they return has six.
pub fn stub(input: &DeriveInput, outline: &Outline, krate: &Path, scalar: ScalarKind) -> TokenStream {
    let name = &input.ident;
    let (generics, parameters, conditions) = input.generics.split_for_impl();
    let number = scalar_type(scalar);
    let joints = outline.joints.unwrap_or(USUAL_JOINTS);
    let q = outline.joints.map_or_else(|| quote!(N), |known| quote!(#known));
    let any = outline.joints.is_none().then(|| quote!(const N: ::core::primitive::usize));
    let any_list = any.as_ref().map(|any| quote!(<#any>));
    let (target, any_target) = if outline.takes_pose() {
        (quote!(#krate::Pose<#number>), None)
    } else {
        (quote!(Target), Some(quote!(Target: ?::core::marker::Sized)))
    };
    let target_at = outline.target_at(krate, &number);
    // Of a list the calls tell how long it is.
    let list = outline.is_list.then(|| quote!(const K: ::core::primitive::usize));
    let values = if outline.is_list { quote!([#number; K]) } else { number.clone() };
    let steps = if outline.is_list { quote!([::core::primitive::usize; K]) } else { quote!(::core::primitive::usize) };
    let given = outline.redundant.then(|| quote!(, _: #values));
    let motors = motors(krate, &number, joints, &q, any_list.as_ref());
    let any_target_and_list: Vec<_> =
        [any_target.clone(), Some(quote!(List)), list.clone()].into_iter().flatten().collect();
    let beside: Vec<_> = [any_target.clone(), list.clone()].into_iter().flatten().collect();
    let branch: Vec<_> = [any_target.clone(), any.clone(), list].into_iter().flatten().collect();
    let near: Vec<_> = [any_target, any].into_iter().flatten().collect();
    let solutions = quote!(#krate::Solutions<#number, #joints, 8>);
    let motion = motion(krate, &number, &q, any_list.as_ref());
    let traits = input.generics.params.is_empty().then(|| traits(name, outline, krate, &number));
    quote! {
        #[allow(dead_code, missing_docs, clippy::all)]
        impl #generics #name #parameters #conditions {
            pub const DOF: ::core::primitive::usize = #joints;
            pub const MAX_SOLUTIONS: ::core::primitive::usize = 8;
            pub const JOINT_NAMES: [&'static ::core::primitive::str; #joints] = [""; #joints];
            pub const LIMITS: [[#number; 2]; #joints] = [[0.0; 2]; #joints];
            pub const MAX_VELOCITY: [#number; #joints] = [0.0; #joints];
            pub const MAX_ACCELERATION: [#number; #joints] = [0.0; #joints];
            pub const LENGTH_UNIT: #krate::LengthUnit = #krate::LengthUnit::Meter;
            pub const DH: #krate::DhTable = #krate::DhTable {
                convention: #krate::Convention::Standard,
                rows: &[],
                base: #krate::DhFrame::IDENTITY,
                tool: #krate::DhFrame::IDENTITY,
            };
            pub fn forward #any_list (&self, _: &[#number; #q]) -> #krate::Pose<#number> {
                #krate::Pose::identity()
            }
            pub fn link_poses #any_list (&self, _: &[#number; #q]) -> [#krate::Pose<#number>; #q] {
                [#krate::Pose::identity(); #q]
            }
            pub fn jacobian #any_list (&self, _: &[#number; #q]) -> #krate::Jacobian<#number, #q> {
                #krate::Jacobian { rows: [[0.0; #q]; 6] }
            }
            pub fn forward_and_jacobian #any_list (
                &self,
                _: &[#number; #q],
            ) -> (#krate::Pose<#number>, #krate::Jacobian<#number, #q>) {
                (#krate::Pose::identity(), #krate::Jacobian { rows: [[0.0; #q]; 6] })
            }
            #motion
            pub fn nominal() -> Self {
                loop {}
            }
            pub fn dh_rows(&self) -> [#krate::DhRow; 0] {
                []
            }
            pub fn dh_base(&self) -> #krate::DhFrame {
                #krate::DhFrame::IDENTITY
            }
            pub fn dh_tool(&self) -> #krate::DhFrame {
                #krate::DhFrame::IDENTITY
            }
            pub fn inverse <#(#beside),*> (&self, _: &#target #given) -> #solutions {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }
            pub fn inverse_into <#(#any_target_and_list),*> (&self, _: &#target #given, _: &mut List) {}
            pub fn inverse_branch <#(#branch),*> (
                &self,
                _: &#target
                #given,
                _: #krate::Branch,
            ) -> ::core::result::Result<#krate::Solution<#number, #q>, #krate::Status<#number>> {
                ::core::result::Result::Err(#krate::Status::BadTarget)
            }
            pub fn residual <#(#near),*> (&self, _: &[#number; #q], _: &#target) -> #krate::Residual<#number> {
                #krate::Residual::ZERO
            }
            pub fn target_at #any_list (&self, _: &[#number; #q]) -> #target_at {
                loop {}
            }
            pub fn sample_redundancy <#(#beside),*> (
                &self,
                _: &#target,
                _: #steps,
            ) -> impl ::core::iter::Iterator<Item = (#values, #solutions)> {
                ::core::iter::empty()
            }
            pub fn arm_angle #any_list (&self, _: &[#number; #q]) -> #number {
                0.0
            }
            // Three are the usual ones: shoulder, elbow, wrist.
            pub fn margins #any_list (&self, _: &[#number; #q]) -> [#krate::Margin<#number>; 3] {
                loop {}
            }
            pub fn inverse_near <#(#near),*> (&self, _: &#target, _: &[#number; #q]) -> #solutions {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }
            pub fn inverse_near_into <#(#near,)* List> (&self, _: &#target, _: &[#number; #q], _: &mut List) {}
            #motors
        }
        #traits
    }
}

/// Stubs of the methods that follow from pose and Jacobian.
fn motion(krate: &Path, number: &TokenStream, q: &TokenStream, any_list: Option<&TokenStream>) -> TokenStream {
    let (joints, jacobian) = (quote!(&[#number; #q]), quote!(#krate::Jacobian { rows: [[0.0; #q]; 6] }));
    quote! {
        pub fn velocity #any_list (&self, _: #joints, _: #joints) -> #krate::Twist<#number> {
            #krate::Twist::zero()
        }
        pub fn acceleration #any_list (&self, _: #joints, _: #joints, _: #joints) -> #krate::Acceleration<#number> {
            #krate::Acceleration::zero()
        }
        pub fn jacobian_dot #any_list (&self, _: #joints, _: #joints) -> #krate::Jacobian<#number, #q> {
            #jacobian
        }
        pub fn jacobian_tool #any_list (&self, _: #joints) -> #krate::Jacobian<#number, #q> {
            #jacobian
        }
        pub fn link_velocities #any_list (&self, _: #joints, _: #joints) -> [#krate::Twist<#number>; #q] {
            [#krate::Twist::zero(); #q]
        }
        pub fn link_accelerations #any_list (
            &self,
            _: #joints,
            _: #joints,
            _: #joints,
        ) -> [#krate::Acceleration<#number>; #q] {
            [#krate::Acceleration::zero(); #q]
        }
        pub fn manipulability #any_list (&self, _: #joints) -> #number {
            0.0
        }
    }
}

/// The traits, for calls from code that is generic over arms.
fn traits(name: &Ident, outline: &Outline, krate: &Path, number: &TokenStream) -> TokenStream {
    let (q, any) = match outline.joints {
        Some(known) => (quote!(#known), None),
        None => (quote!(N), Some(quote!(<const N: ::core::primitive::usize>))),
    };
    let solutions = quote!(#krate::Solutions<#number, #q, 8>);
    quote! {
        #[automatically_derived]
        impl #any #krate::Arm<#number, #q> for #name {
            const LIMITS: [[#number; 2]; #q] = [[0.0; 2]; #q];
            const JOINT_NAMES: [&'static ::core::primitive::str; #q] = [""; #q];
            const JOINT_KINDS: [#krate::JointKind; #q] = [#krate::JointKind::Revolute; #q];
            fn forward(&self, _: &[#number; #q]) -> #krate::Pose<#number> {
                #krate::Pose::identity()
            }
            fn link_poses(&self, _: &[#number; #q]) -> [#krate::Pose<#number>; #q] {
                [#krate::Pose::identity(); #q]
            }
            fn jacobian(&self, _: &[#number; #q]) -> #krate::Jacobian<#number, #q> {
                #krate::Jacobian { rows: [[0.0; #q]; 6] }
            }
            fn forward_and_jacobian(
                &self,
                _: &[#number; #q],
            ) -> (#krate::Pose<#number>, #krate::Jacobian<#number, #q>) {
                (#krate::Pose::identity(), #krate::Jacobian { rows: [[0.0; #q]; 6] })
            }
        }
        #[automatically_derived]
        impl #any #krate::InverseKinematics<#number, #q> for #name {
            type Target = #krate::Pose<#number>;
            type Solutions = #solutions;
            const MAX_SOLUTIONS: ::core::primitive::usize = 8;
            fn inverse(&self, _: &Self::Target) -> Self::Solutions {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }
            fn inverse_near(&self, _: &Self::Target, _: &[#number; #q]) -> Self::Solutions {
                #krate::Solutions::new(#krate::Status::BadTarget)
            }
            fn residual(&self, _: &[#number; #q], _: &Self::Target) -> #krate::Residual<#number> {
                #krate::Residual::ZERO
            }
            fn target_at(&self, _: &[#number; #q]) -> Self::Target {
                #krate::Pose::identity()
            }
            fn deviation(
                &self,
                _: &[#number; #q],
                _: &Self::Target,
                _: &(#krate::Pose<#number>, #krate::Jacobian<#number, #q>),
            ) -> #krate::Deviation<#number, #q> {
                #krate::Deviation {
                    twist: [0.0; 6],
                    jacobian: #krate::Jacobian { rows: [[0.0; #q]; 6] },
                    given: #krate::JointMask::NONE,
                }
            }
            fn status(_: &Self::Solutions) -> #krate::Status<#number> {
                #krate::Status::BadTarget
            }
        }
        #[automatically_derived]
        impl #any #krate::InverseBranch<#number, #q> for #name {
            fn inverse_branch(
                &self,
                _: &#krate::Pose<#number>,
                _: #krate::Branch,
            ) -> ::core::result::Result<#krate::Solution<#number, #q>, #krate::Status<#number>> {
                ::core::result::Result::Err(#krate::Status::BadTarget)
            }
        }
    }
}

/// The number type of the generated code.
fn scalar_type(scalar: ScalarKind) -> TokenStream {
    match scalar {
        ScalarKind::F64 => quote!(::core::primitive::f64),
        ScalarKind::F32 => quote!(::core::primitive::f32),
    }
}
