//! The arms that a program is built for, chosen by features.

#![no_std]

/// Calls a macro with the module of each chosen arm.
#[macro_export]
macro_rules! chosen {
    ($each:ident) => {
        #[cfg(feature = "puma560_f32")]
        $each!(puma560_f32, f32);
        #[cfg(feature = "ur5_f32")]
        $each!(ur5_f32, f32);
        #[cfg(feature = "abb_irb2400_f32")]
        $each!(abb_irb2400_f32, f32);
        #[cfg(feature = "stanford_f32")]
        $each!(stanford_f32, f32);
        #[cfg(feature = "kuka_iiwa7_r800_f32")]
        $each!(kuka_iiwa7_r800_f32, f32);
        #[cfg(feature = "jupiter_f32")]
        $each!(jupiter_f32, f32);
        #[cfg(feature = "salman_rrr_f32")]
        $each!(salman_rrr_f32, f32);
        #[cfg(feature = "puma560_f64")]
        $each!(puma560_f64, f64);
    };
}
