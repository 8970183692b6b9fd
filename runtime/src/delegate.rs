//! The bodies of the trait impls of a generated arm: each item is the arm's own of the same name.

/// The items of an `impl Arm` for a generated arm.
#[doc(hidden)]
#[macro_export]
macro_rules! delegate_arm {
    ($name:ident, $scalar:ty, $n:literal) => {
        const LIMITS: [[$scalar; 2]; $n] = $name::LIMITS;
        const JOINT_NAMES: [&'static ::core::primitive::str; $n] = $name::JOINT_NAMES;
        const JOINT_KINDS: [$crate::JointKind; $n] = $name::JOINT_KINDS;
        #[inline]
        fn forward(&self, q: &[$scalar; $n]) -> $crate::Pose<$scalar> {
            $name::forward(self, q)
        }
        #[inline]
        fn link_poses(&self, q: &[$scalar; $n]) -> [$crate::Pose<$scalar>; $n] {
            $name::link_poses(self, q)
        }
        #[inline]
        fn jacobian(&self, q: &[$scalar; $n]) -> $crate::Jacobian<$scalar, $n> {
            $name::jacobian(self, q)
        }
        #[inline]
        fn forward_and_jacobian(&self, q: &[$scalar; $n]) -> ($crate::Pose<$scalar>, $crate::Jacobian<$scalar, $n>) {
            $name::forward_and_jacobian(self, q)
        }
    };
}

/// The items of an `impl InverseKinematics` for a generated arm; `given`: a value comes with the target, or an array of
/// so many. At joint values it is this one.
#[doc(hidden)]
#[macro_export]
macro_rules! delegate_inverse {
    ($name:ident, $scalar:ty, $n:literal, $m:literal, $target:ty) => {
        type Target = $target;
        fn inverse(&self, target: &Self::Target) -> Self::Solutions {
            $name::inverse(self, target)
        }
        #[inline]
        fn inverse_into(&self, target: &Self::Target, solutions: &mut Self::Solutions) {
            $name::inverse_into(self, target, solutions)
        }
        fn inverse_near(&self, target: &Self::Target, q_ref: &[$scalar; $n]) -> Self::Solutions {
            $name::inverse_near(self, target, q_ref)
        }
        #[inline]
        fn inverse_near_into(&self, target: &Self::Target, q_ref: &[$scalar; $n], solutions: &mut Self::Solutions) {
            $name::inverse_near_into(self, target, q_ref, solutions)
        }
        fn residual(&self, q: &[$scalar; $n], target: &Self::Target) -> $crate::Residual<$scalar> {
            $name::residual(self, q, target)
        }
        #[inline]
        fn target_at(&self, q: &[$scalar; $n]) -> Self::Target {
            $name::target_at(self, q)
        }
        $crate::delegate_inverse!($scalar, $n, $m);
    };
    ($name:ident, $scalar:ty, $n:literal, $m:literal, $target:ty, given |$arm:ident, $q:ident| $given:expr) => {
        $crate::delegate_inverse!($name, $scalar, $n, $m, $target, $scalar, |$arm, $q| $given);
    };
    ($name:ident, $scalar:ty, $n:literal, $m:literal, $target:ty, given [$k:literal] |$arm:ident, $q:ident| $given:expr) => {
        $crate::delegate_inverse!($name, $scalar, $n, $m, $target, [$scalar; $k], |$arm, $q| $given);
    };
    ($name:ident, $scalar:ty, $n:literal, $m:literal, $target:ty, $values:ty, |$arm:ident, $q:ident| $given:expr) => {
        type Target = ($target, $values);
        const TAKES_VALUES: ::core::primitive::bool = true;
        fn inverse(&self, target: &Self::Target) -> Self::Solutions {
            $name::inverse(self, &target.0, target.1)
        }
        #[inline]
        fn inverse_into(&self, target: &Self::Target, solutions: &mut Self::Solutions) {
            $name::inverse_into(self, &target.0, target.1, solutions)
        }
        fn inverse_near(&self, target: &Self::Target, q_ref: &[$scalar; $n]) -> Self::Solutions {
            $name::inverse_near(self, &target.0, q_ref)
        }
        #[inline]
        fn inverse_near_into(&self, target: &Self::Target, q_ref: &[$scalar; $n], solutions: &mut Self::Solutions) {
            $name::inverse_near_into(self, &target.0, q_ref, solutions)
        }
        fn residual(&self, q: &[$scalar; $n], target: &Self::Target) -> $crate::Residual<$scalar> {
            $name::residual(self, q, &target.0)
        }
        fn target_at(&self, $q: &[$scalar; $n]) -> Self::Target {
            let $arm = self;
            ($name::target_at($arm, $q), $given)
        }
        $crate::delegate_inverse!($scalar, $n, $m);
    };
    ($scalar:ty, $n:literal, $m:literal) => {
        type Solutions = $crate::Solutions<$scalar, $n, $m>;
        const MAX_SOLUTIONS: ::core::primitive::usize = $m;
        fn status(solutions: &Self::Solutions) -> $crate::Status<$scalar> {
            solutions.status()
        }
        fn is_complete(solutions: &Self::Solutions) -> ::core::primitive::bool {
            solutions.is_complete()
        }
    };
}

/// The items of an `impl InverseBranch` for a generated arm; `given`: values come with the target.
#[doc(hidden)]
#[macro_export]
macro_rules! delegate_branch {
    ($name:ident, $scalar:ty, $n:literal) => {
        #[inline]
        fn inverse_branch(
            &self,
            target: &<Self as $crate::InverseKinematics<$scalar, $n>>::Target,
            branch: $crate::Branch,
        ) -> $crate::OneSolution<$scalar, $n> {
            $name::inverse_branch(self, target, branch)
        }
    };
    ($name:ident, $scalar:ty, $n:literal, given) => {
        #[inline]
        fn inverse_branch(
            &self,
            target: &<Self as $crate::InverseKinematics<$scalar, $n>>::Target,
            branch: $crate::Branch,
        ) -> $crate::OneSolution<$scalar, $n> {
            $name::inverse_branch(self, &target.0, target.1, branch)
        }
    };
}

/// The method of an `impl InverseKinematics` by which a list holds some branches alone. `branches`: the arm's function;
/// `given`: values come with the target, and go to that function as this expression of them.
#[doc(hidden)]
#[macro_export]
macro_rules! delegate_branch_near {
    ($scalar:ty, $n:literal, $branches:ident $(, given |$given:pat_param| $values:expr)?) => {
        fn inverse_branch_near_into(
            &self,
            target: &Self::Target,
            branch: $crate::Branch,
            q_ref: &[$scalar; $n],
            keeps_place: bool,
            solutions: &mut Self::Solutions,
        ) {
            $(let (target, $given) = (&target.0, target.1);)?
            solutions.reset_near($crate::Status::BadTarget, keeps_place);
            $branches(self, target, $($values,)? ::core::option::Option::Some(q_ref), branch, solutions);
        }
    };
}
