//! The singularity margins of the smaller tasks: their product is the determinant of the task's Jacobian times a
//! constant.

use denhart::{InverseKinematics, Margin};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::singular::Svd;
use denhart_tests::subject::{Specified, Subject};
use denhart_tests::task::Asked;

fn proportional<A, const N: usize, const K: usize>(margins: impl Fn(&[f64; N]) -> [Margin<f64>; K])
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked>,
{
    let subject = Subject::new::<A>();
    let (space, mut random) = (Space::of(&subject), Random::named(&subject.name));
    let pairs: Vec<[f64; 2]> = (0..300)
        .map(|_| {
            let q = space.random(&mut random);
            let product: f64 = margins(&q).iter().map(|margin| margin.value).product();
            [Svd::at(&subject, &q).values.iter().product(), product.abs()]
        })
        .collect();
    let largest = pairs.iter().copied().max_by(|a, b| a[0].total_cmp(&b[0])).unwrap_or_default();
    let constant = largest[0] / largest[1];
    assert!(constant.is_finite() && constant != 0.0, "{}: {largest:?}", subject.name);
    for [determinant, product] in pairs {
        let off = (determinant - constant * product).abs();
        assert!(off <= 1e-12 * largest[0], "{}: {determinant:e} beside {product:e} times {constant}", subject.name);
    }
}

macro_rules! margins {
    ($($page:ident $name:ident;)*) => {$(
        #[test]
        fn $name() {
            use crate::$page::$name::Tested;
            proportional::<Tested, _, _>(|q| Tested.margins(q));
        }
    )*};
}

margins! {
    planar planar2r;
    planar planar3r;
    position anthro3r;
    position polar_rrp;
    position_angle al5d;
    position_angle jupiter;
    position_angle yaw_pitch_mounted;
    position_angle yaw_pitch_all_turned;
    position_angle crane_rrpr;
    position_angle digger_rrrp;
    position_angle beam_rprr;
    position_angle polar_rppr;
}
