//! The singularity margins of every arm with an inverse: factors of the Jacobian's determinant, each zero at its
//! singularity.

use std::f64::consts::FRAC_PI_2;

use denhart::{InverseKinematics, Margin, Pose};
use denhart_tests::arms::{AbbIrb2400, Puma560, Stanford, Ur5};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::subject::{Specified, Subject};

/// Determinant of the Jacobian, lengths in reaches, by the chain.
fn determinant(subject: &Subject<6>, q: &[f64; 6]) -> f64 {
    let scaled = subject.scaled_jacobian(q);
    nalgebra::Matrix6::from_fn(|row, column| scaled[(row, column)]).determinant()
}

/// Over random joint vectors the product is the determinant times one constant, sign included. Every factor has places
/// where it is zero, and the determinant is zero at those places.
fn proportional<A, const K: usize>(margins: impl Fn(&[f64; 6]) -> [Margin<f64>; K])
where
    A: Specified<6> + InverseKinematics<f64, 6, Target = Pose<f64>>,
{
    let subject = Subject::new::<A>();
    let (space, mut random) = (Space::of(&subject), Random::named(&subject.name));
    let product = |q: &[f64; 6]| margins(q).iter().map(|margin| margin.value).product::<f64>();
    let samples: Vec<[f64; 6]> = (0..300).map(|_| space.random(&mut random)).collect();
    let pairs: Vec<[f64; 2]> = samples.iter().map(|q| [determinant(&subject, q), product(q)]).collect();
    let largest = pairs.iter().max_by(|a, b| a[0].abs().total_cmp(&b[0].abs())).copied().unwrap_or_default();
    let constant = largest[0] / largest[1];
    assert!(constant.is_finite() && constant != 0.0, "{}: {largest:?}", subject.name);
    for (q, [determinant, product]) in samples.iter().zip(&pairs) {
        // Some thousand roundings of the largest determinant.
        let tolerance = 1e-12 * largest[0].abs();
        assert!((determinant - constant * product).abs() <= tolerance, "{}: {q:?}", subject.name);
    }
    // Strokes of either sign, whatever the limits.
    let strokes = Space::new(&subject.kinds, &[[f64::NEG_INFINITY, f64::INFINITY]; 6], subject.reach);
    let samples: Vec<[f64; 6]> = (0..300).map(|_| strokes.random(&mut random)).collect();
    for factor in 0..K {
        assert!(vanishes(&subject, &samples, &margins, factor, largest[0].abs()), "{}: factor {factor}", subject.name);
    }
}

/// Bisects a change of sign between two samples: the determinant vanishes at it. Whether a change of sign was found.
fn vanishes<const K: usize>(
    subject: &Subject<6>,
    samples: &[[f64; 6]],
    margins: impl Fn(&[f64; 6]) -> [Margin<f64>; K],
    factor: usize,
    scale: f64,
) -> bool {
    let value = |q: &[f64; 6]| margins(q)[factor].value;
    let Some(pair) = samples.windows(2).find(|pair| value(&pair[0]) * value(&pair[1]) < 0.0) else { return false };
    let at = |t: f64| std::array::from_fn(|joint| pair[0][joint] + t * (pair[1][joint] - pair[0][joint]));
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if value(&at(middle)) * value(&pair[0]) > 0.0 { low = middle } else { high = middle }
    }
    let q = at(low);
    let found = determinant(subject, &q).abs();
    // The joints are known to a rounding, which moves the determinant by some roundings.
    assert!(found <= 1e-13 * scale.max(1.0), "{}: {:?} leaves {found:e} at {q:?}", subject.name, margins(&q)[factor]);
    true
}

macro_rules! margin_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {
        $(margin_tests! { @$kind $name $Type $dof })*
    };
    (@inverse $name:ident $Type:ident 6) => {
        #[test]
        fn $name() {
            use denhart_tests::arms::$Type;
            proportional::<$Type, _>(|q| $Type.margins(q));
        }
    };
    (@$kind:ident $name:ident $Type:ident $dof:tt) => {};
}

mod published {
    use super::proportional;
    denhart_tests::published_arms!(margin_tests);
}
mod made_up {
    use super::proportional;
    denhart_tests::made_up_arms!(margin_tests);
}

fn named<const K: usize>(margins: [Margin<f64>; K], name: &str) -> f64 {
    margins.iter().find(|margin| margin.name == name).map_or(f64::NAN, |margin| margin.value)
}

#[test]
fn singular_places_of_known_arms() {
    // Wrist straight.
    assert_eq!(named(Puma560.margins(&[0.3, 0.4, 0.5, 0.6, 0.0, 0.7]), "wrist"), 0.0);
    assert_eq!(named(AbbIrb2400.margins(&[0.3, 0.4, 0.5, 0.6, 0.0, 0.7]), "wrist"), 0.0);
    assert_eq!(named(Stanford.margins(&[0.3, 0.4, 0.5, 0.6, 0.0, 0.7]), "wrist"), 0.0);
    assert_eq!(named(Ur5.margins(&[0.3, 0.4, 0.5, 0.6, 0.0, 0.7]), "wrist"), 0.0);
    // Elbow straight: the Puma's second link is inclined by atan(a3 / d4).
    assert_eq!(named(Ur5.margins(&[0.3, 0.4, 0.0, 0.6, 0.2, 0.7]), "elbow"), 0.0);
    let straight = 0.0203_f64.atan2(0.4318) - FRAC_PI_2;
    assert!(named(Puma560.margins(&[0.3, 0.4, straight, 0.6, 0.2, 0.7]), "elbow").abs() < 1e-15);
    assert_eq!(named(Stanford.margins(&[0.3, 0.4, 0.0, 0.6, 0.2, 0.7]), "elbow"), 0.0);
    // Wrist center over axis 1, as far as the shoulder's offset allows: `a2 c2 + a3 c23 - d4 s23 = 0`.
    let q3 = 0.5_f64;
    // a cos q2 - b sin q2 = 0
    let (a, b) = (0.4318 + 0.0203 * q3.cos() - 0.4318 * q3.sin(), 0.0203 * q3.sin() + 0.4318 * q3.cos());
    let over = a.atan2(b);
    assert!(named(Puma560.margins(&[0.3, over, q3, 0.6, 0.2, 0.7]), "shoulder").abs() < 1e-15);
    // A joint vector that is not a number gives no margin that looks like one.
    assert!(Puma560.margins(&[f64::NAN; 6]).iter().all(|margin| margin.value.is_nan()));
}
