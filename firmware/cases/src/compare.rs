//! Lines that the chip and the host print, to be compared.

use core::fmt;

use denhart::Scalar;

use crate::aim::Aim;
use crate::{Digest, Family, Maker, Subject};

/// Cases of an arm.
pub const CASES: usize = 2_000;

/// Prints the names of the arm's functions, then a line for each case: its number, its family, and the digest of each
/// function's result.
pub fn digests<S, T, const N: usize>(print: &mut dyn FnMut(fmt::Arguments<'_>))
where
    S: Subject<T, N>,
    S::Target: Aim<T>,
    T: Scalar,
{
    let arm = S::default();
    let mut maker = Maker::new(2);
    for number in 0..CASES {
        let family = Family::ALL.get(number % Family::ALL.len()).copied().unwrap_or(Family::Random);
        let case = maker.case::<S, T, N>(&arm, family);
        if number == 0 {
            print(format_args!("ARM {} functions", S::NAME));
            S::each_function(&case, &mut |_, name, _| print(format_args!(" {name}")));
            print(format_args!("\n"));
        }
        print(format_args!("{} {number} {}", S::NAME, family.name()));
        S::each_function(&case, &mut |case, _, digested| {
            let mut digest = Digest::new();
            digested(case, &mut digest);
            print(format_args!(" {:08x}", digest.value()));
        });
        print(format_args!("\n"));
    }
}
