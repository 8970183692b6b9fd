//! The arms that a program is built for and the functions that it calls, chosen by features.

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
        #[cfg(feature = "ur5_measured_f32")]
        $each!(ur5_measured_f32, f32);
        #[cfg(feature = "puma560_f64")]
        $each!(puma560_f64, f64);
        #[cfg(feature = "extra")]
        $each!(extra, f32);
    };
}

/// Calls the chosen functions of an arm's module `call` with a case.
#[macro_export]
macro_rules! calls {
    ($call:path, $case:expr) => {{
        #[allow(unused_imports)]
        use $call as call;
        let case = $case;
        let _ = case;
        #[cfg(feature = "forward")]
        call::forward(case);
        #[cfg(feature = "forward_and_jacobian")]
        call::forward_and_jacobian(case);
        #[cfg(feature = "inverse")]
        call::inverse(case);
        #[cfg(feature = "inverse_into")]
        call::inverse_into(case, &mut call::kept());
        #[cfg(feature = "inverse_near")]
        call::inverse_near(case);
        #[cfg(feature = "inverse_branch")]
        call::inverse_branch(case);
        #[cfg(feature = "follower")]
        call::follower(case, &mut call::kept());
    }};
}
