//! The stubs of what stands between joints and motors, see `fallback`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Path;

/// Methods and constants of linked joints and of actuators. `q`: the number of joints, a number or `N`. `any_list`: the
/// parameter `N` where the number is not known; `joints` is then a number in its place.
pub fn motors(
    krate: &Path,
    number: &TokenStream,
    joints: usize,
    q: &TokenStream,
    any_list: Option<&TokenStream>,
) -> TokenStream {
    quote! {
        pub const COMBINED_LIMITS: [#krate::CombinedLimit<#number, #joints>; 1] =
            [#krate::CombinedLimit { factors: [0.0; #joints], limits: [0.0; 2] }];
        pub const ACTUATORS: [#krate::Actuator<#number>; #joints] =
            [#krate::Actuator { pulses_per_unit: 1.0, home: 0.0 }; #joints];
        pub const RESOLUTION: [#number; #joints] = [1.0; #joints];
        pub fn to_motor #any_list (&self, q: &[#number; #q]) -> [#number; #q] {
            *q
        }
        pub fn from_motor #any_list (&self, motor: &[#number; #q]) -> [#number; #q] {
            *motor
        }
        pub fn motor_jacobian #any_list (&self, _: &[#number; #q]) -> #krate::Jacobian<#number, #q> {
            #krate::Jacobian { rows: [[0.0; #q]; 6] }
        }
        pub fn to_pulses #any_list (&self, _: &[#number; #q]) -> [::core::primitive::i32; #q] {
            [0; #q]
        }
        pub fn to_pulses_checked #any_list (
            &self,
            _: &[#number; #q],
        ) -> ([::core::primitive::i32; #q], #krate::JointMask) {
            ([0; #q], #krate::JointMask::NONE)
        }
        pub fn from_pulses #any_list (&self, _: &[::core::primitive::i32; #q]) -> [#number; #q] {
            [0.0; #q]
        }
        pub fn quantized_error #any_list (&self, q: &[#number; #q]) -> #krate::Quantized<#number, #q> {
            let tool = #krate::Pose::identity();
            #krate::Quantized::new(([0; #q], #krate::JointMask::NONE), *q, &tool, tool)
        }
    }
}
