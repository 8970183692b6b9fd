//! Constants that are worked out from short ones, written as they are worked out: `0.425 + 0.3922`, not `0.8171999999999999`.
//!
//! In double precision the compiler computes the same bits. In single precision it would not, so the number stays.

use super::tokens::number;
use super::{Scalar, Target};
use crate::lower::ArmConstants;
use crate::model::{DEFAULT_TOLERANCE, Model, ReachTerm, reach_terms};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashMap;

/// Digits that a number has which somebody wrote.
const WRITTEN: usize = 15;

/// `value` by its sum where it has more digits than anybody writes, and the sum has its bits; else as it is.
fn written(value: f64, sum: f64, tokens: TokenStream, target: &Target) -> TokenStream {
    let better = target.scalar == Scalar::F64 && !is_short(value) && sum.to_bits() == value.to_bits();
    if better { tokens } else { number(value) }
}

/// True for a number that somebody may have written.
fn is_short(value: f64) -> bool {
    format!("{value:e}").chars().take_while(|c| *c != 'e').filter(char::is_ascii_digit).count() <= WRITTEN
}

/// Largest and smallest distance of the ends of two links.
pub fn distances([a, b]: [f64; 2], values: [f64; 2], target: &Target) -> [TokenStream; 2] {
    if !is_short(a) || !is_short(b) {
        return values.map(number);
    }
    let (long, short) = (a.abs().max(b.abs()), a.abs().min(b.abs()));
    let [first, second] = [a.abs(), b.abs()].map(number);
    let sum = quote!(#first + #second);
    let [first, second] = [long, short].map(number);
    let difference = quote!(#first - #second);
    let [max, min] = values;
    [written(max, a.abs() + b.abs(), sum, target), written(min, long - short, difference, target)]
}

/// The reach: the lengths of the rows, one after the other, then displacements and frames.
pub fn reach(reach: f64, model: &Model, target: &Target) -> TokenStream {
    let (mut sum, mut tokens) = (0.0, TokenStream::new());
    let mut add = |term: f64, written: TokenStream| {
        if term != 0.0 {
            tokens = if sum == 0.0 { written } else { quote!(#tokens + #written) };
            sum += term;
        }
    };
    let defaults = HashMap::new();
    for term in reach_terms(model) {
        let value = term.at(&defaults);
        let written = match term {
            ReachTerm::Row(lengths) => match lengths.map(|length| length.at(&defaults).abs()) {
                [a, d] if a != 0.0 && d != 0.0 => {
                    let [a, d] = [a, d].map(number);
                    quote!((#a + #d))
                }
                _ => number(value),
            },
            _ => number(value),
        };
        add(value, written);
    }
    written(reach, sum, tokens, target)
}

/// The tolerance on a position: that of the file, else a share of the reach.
pub fn position_tolerance(constants: &ArmConstants, model: &Model, target: &Target) -> TokenStream {
    match model.inverse.tolerance_length {
        Some(tolerance) => number(tolerance),
        None => written(constants.length, constants.length, share_of(&quote!(REACH)), target),
    }
}

/// The tolerance on a position of an arm whose reach is known at run time.
pub fn bound_tolerance(model: &Model) -> TokenStream {
    model.inverse.tolerance_length.map_or_else(|| share_of(&quote!(reach)), number)
}

fn share_of(reach: &TokenStream) -> TokenStream {
    let share = number(DEFAULT_TOLERANCE);
    quote!(#share * #reach)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::tokens::ident;

    #[test]
    fn sums_stand_for_their_own_bits_only() {
        let text = |links: [f64; 2], height: f64, scalar| {
            let [a, b] = links;
            let target = Target { scalar, krate: quote!(::denhart), type_name: ident("Arm1") };
            let values = [(a + b).hypot(height), (a - b).hypot(height)];
            distances(links, values, &target).map(|tokens| tokens.to_string())
        };
        let sum = ["0.8171999999999999", "0.032799999999999996"];
        assert_eq!(text([-0.425, -0.3922], 0.0, Scalar::F64), ["0.425 + 0.3922", "0.425 - 0.3922"]);
        assert_eq!(text([-0.425, -0.3922], 0.0, Scalar::F32), sum);
        assert_eq!(text([0.425, -0.3922], 0.0, Scalar::F64), [sum[1], sum[0]]);
        assert_eq!(text([0.5, 0.25], 0.0, Scalar::F64), ["0.75", "0.25"]);
        assert!(text([0.425, 0.3922], 0.1, Scalar::F64).iter().all(|text| !text.contains(' ')));
    }
}
