//! The harmonics of the product of both branches.
#![allow(clippy::unwrap_used)]

use super::Slides;
use super::branch::Posed;
use crate::branches::Branches;
use crate::chain::Chain;
use crate::math::sin_cos;
use crate::{Transform, transform::dot};

/// A chain without structure, but for its two prismatic joints.
fn chain(first: usize, second: usize) -> Chain<f64> {
    let links = core::array::from_fn(|link| {
        let x = (3 * link + 1) as f64;
        let (s, c) = sin_cos(0.7 * x);
        let tilt = Transform {
            rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
            translation: [sin_cos(x).0, sin_cos(2.0 * x).0, sin_cos(3.0 * x).0],
        };
        tilt.then_turn(sin_cos(1.1 * x))
    });
    Chain::new(links, core::array::from_fn(|joint| joint == first || joint == second))
}

#[test]
fn the_product_of_the_branches_has_no_harmonic_above_the_fourth() {
    for (first, second) in [(0, 1), (0, 3), (2, 4), (1, 5), (2, 3), (0, 5)] {
        let chain = chain(first, second);
        for held in (0..6).filter(|joint| !chain.is_prismatic[*joint]) {
            let slides = Slides::holding(&chain, held).unwrap();
            let target = chain.pose(&[0.3, -1.2, 0.8, 2.0, -0.7, 1.9]);
            let posed = Posed::of(&slides, &target).unwrap();
            let sample = |turn: u32| posed.product(sin_cos(core::f64::consts::TAU * f64::from(turn) / 64.0 + 0.1)).0;
            let samples: [f64; 64] = core::array::from_fn(|turn| sample(turn as u32));
            let size = |harmonic: usize| {
                let angle = |turn: usize| core::f64::consts::TAU * (turn * harmonic % 64) as f64 / 64.0;
                let waves: [(f64, f64); 64] = core::array::from_fn(|turn| sin_cos(angle(turn)));
                let sum = |part: fn(&(f64, f64)) -> f64| -> f64 {
                    samples.iter().zip(&waves).map(|(value, wave)| value * part(wave)).sum()
                };
                let (odd, even) = (sum(|wave| wave.0), sum(|wave| wave.1));
                dot([odd, even, 0.0], [odd, even, 0.0]).sqrt()
            };
            let greatest = (0..32).map(size).fold(0.0_f64, f64::max);
            let highest = (0..32).rev().find(|harmonic| size(*harmonic) > 1e-12 * greatest);
            assert_eq!(highest, Some(4), "{first} {second}, held {held}");
        }
    }
}
