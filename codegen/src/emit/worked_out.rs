//! Constants that are worked out from short ones, written as they are worked out: `0.425 + 0.3922`, not `0.8171999999999999`.
//!
//! In double precision the compiler computes the same bits. In single precision it would not, so the number stays.

use super::tokens::number;
use super::{Scalar, Target};
use crate::model::{Length, Model, beside_rows};
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

/// Whether a number may have been written by somebody.
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

/// The reach: the lengths of the rows, one after the other, then strokes and frames.
pub fn reach(reach: f64, model: &Model, target: &Target) -> TokenStream {
    let (mut sum, mut tokens) = (0.0, TokenStream::new());
    let mut add = |term: f64, written: TokenStream| {
        if term != 0.0 {
            tokens = if sum == 0.0 { written } else { quote!(#tokens + #written) };
            sum += term;
        }
    };
    let value = |length: &Length| length.at(&HashMap::new()).abs();
    for row in &model.rows {
        let (a, d) = (value(&row.a), value(&row.d));
        let [first, second] = [a, d].map(number);
        let written = match (a == 0.0, d == 0.0) {
            (true, _) => second,
            (_, true) => first,
            _ => quote!((#first + #second)),
        };
        add(a + d, written);
    }
    for term in beside_rows(model, &HashMap::new()) {
        add(term, number(term));
    }
    written(reach, sum, tokens, target)
}

/// The tolerance on a position: that of the file, else a millionth of the reach.
pub fn position_tolerance(reach: f64, model: &Model, target: &Target) -> TokenStream {
    match model.inverse.tolerance_length {
        Some(tolerance) => number(tolerance),
        None => written(1e-6 * reach, 1e-6 * reach, quote!(0.000001 * REACH), target),
    }
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
