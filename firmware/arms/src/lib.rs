//! The arms that are measured. Each is a module with the struct `Robot`, the type `Case` of its functions' arguments,
//! and a call of each function.

#![no_std]

include!(concat!(env!("OUT_DIR"), "/arms.rs"));

/// One more arm, for `sheet.sh`.
#[cfg(feature = "extra")]
pub mod extra {
    include!(concat!(env!("OUT_DIR"), "/extra.rs"));
}

/// Calls a macro with the module and the scalar of each arm.
#[macro_export]
macro_rules! each_arm {
    ($each:ident) => {
        $each!(puma560_f32, f32);
        $each!(ur5_f32, f32);
        $each!(abb_irb2400_f32, f32);
        $each!(stanford_f32, f32);
        $each!(kuka_iiwa7_r800_f32, f32);
        $each!(jupiter_f32, f32);
        $each!(salman_rrr_f32, f32);
        $each!(ur5_measured_f32, f32);
        $each!(puma560_f64, f64);
    };
}
