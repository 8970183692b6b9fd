//! The linear system of one step.

use crate::math::Scalar;

/// Solves `A x = b` for a symmetric positive definite `A`, of which the upper triangle is read.
///
/// `A = L D L^T`, without square roots and without interchanges, which a definite matrix does not need (Golub and Van
/// Loan, "Matrix Computations", section 4.1). A pivot that rounding made smaller than `floor` is taken as `floor`.
#[inline(always)]
pub(super) fn solve<T: Scalar>(mut a: [[T; 6]; 6], b: [T; 6], floor: T) -> [T; 6] {
    let mut x = b;
    let mut inverse = [T::ZERO; 6];
    // Written out by rows, as loops whose ends are constants: the compiler then unrolls and vectorizes them.
    macro_rules! eliminate {
        ($($k:literal: $($i:literal)*;)*) => {$(
            let pivot = a[$k][$k];
            inverse[$k] = T::ONE / if pivot < floor { floor } else { pivot };
            $(
                let factor = a[$k][$i] * inverse[$k];
                for j in $i..6 {
                    a[$i][j] -= factor * a[$k][j];
                }
                x[$i] -= factor * x[$k];
            )*
        )*};
    }
    eliminate! {
        0: 1 2 3 4 5;
        1: 2 3 4 5;
        2: 3 4 5;
        3: 4 5;
        4: 5;
        5: ;
    }
    macro_rules! substitute {
        ($($k:literal)*) => {$(
            let mut sum = x[$k];
            for j in $k + 1..6 {
                sum -= a[$k][j] * x[j];
            }
            x[$k] = sum * inverse[$k];
        )*};
    }
    x[5] *= inverse[5];
    substitute! { 4 3 2 1 0 }
    x
}
