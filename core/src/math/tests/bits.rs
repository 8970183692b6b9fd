//! Bits of results, equal on every platform and at every optimization level.

use super::random::Random;
use crate::math;

#[test]
fn sin_cos_double() {
    let table = [
        (0.1, 0x3fb98eae_cb8bcb2c, 0x3fefd712_f9a817c0),
        (0.5, 0x3fdeaee8_744b05f0, 0x3fec1528_065b7d50),
        (0.7853981633974483, 0x3fe6a09e_667f3bcc, 0x3fe6a09e_667f3bcd),
        (1.0, 0x3feaed54_8f090cee, 0x3fe14a28_0fb5068c),
        (1.5707963267948966, 0x3ff00000_00000000, 0x3c91a626_33145c07),
        (2.0, 0x3fed18f6_ead1b446, 0xbfdaa226_57537205),
        (-2.5, 0xbfe326af_0dcfcab1, 0xbfe9a2f7_ef858b7d),
        (3.141592653589793, 0x3ca1a626_33145c07, 0xbff00000_00000000),
        (10.0, 0xbfe1689e_f5f34f52, 0xbfead9ac_890c6b1f),
        (1234.5, 0x3fc29c53_1dfd031b, 0xbfefa8f2_ceb78372),
        (-200000.0, 0x3fb24aab_e12ccc46, 0x3fefeb0f_c71f0a89),
        (1e22, 0xbfeb453a_b76bf397, 0x3fe0be2c_ef01c8f4),
    ];
    for (x, sine, cosine) in table {
        let (s, c) = math::sin_cos::<f64>(x);
        assert_eq!((s.to_bits(), c.to_bits()), (sine, cosine), "{x}");
    }
}

#[test]
fn sin_cos_single() {
    let table = [
        (0.1, 0x3dcc7577, 0x3f7eb898),
        (0.5, 0x3ef57744, 0x3f60a940),
        (1.0, 0x3f576aa4, 0x3f0a5141),
        (-2.5, 0xbf193578, 0xbf4d17c0),
        (3.1415927, 0xb3bbbd2e, 0xbf800000),
        (100.0, 0xbf01a12e, 0x3f5cc0ee),
        (1234.5, 0x3e14e299, 0xbf7d4796),
        (1e22, 0xbf3becc4, 0x3f2dd6f7),
    ];
    for (x, sine, cosine) in table {
        let (s, c) = math::sin_cos::<f32>(x);
        assert_eq!((s.to_bits(), c.to_bits()), (sine, cosine), "{x}");
    }
}

#[test]
fn atan2_double() {
    let table = [
        (0.1, 1.0, 0x3fb983e2_82e2cc4d),
        (1.0, 0.3, 0x3ff4782c_babc8157),
        (0.45, 1.0, 0x3fdb1009_e9ee79bc),
        (-2.0, 1.5, 0xbfedac67_0561bb4f),
        (0.2, -3.0, 0x400899a6_7091335f),
        (-7.0, -0.01, 0xbff927d5_4b3a71e4),
        (1e-320, 3e-320, 0x3fd4978f_a3269ee1),
        (3e300, -1e300, 0x3ffe47df_3d0dd4d1),
    ];
    for (y, x, angle) in table {
        assert_eq!(math::atan2::<f64>(y, x).to_bits(), angle, "{y} {x}");
    }
}

#[test]
fn atan2_single() {
    let table = [
        (0.1, 1.0, 0x3dcc1f14),
        (1.0, 0.3, 0x3fa3c166),
        (0.45, 1.0, 0x3ed8804f),
        (-2.0, 1.5, 0xbf6d6338),
        (0.2, -3.0, 0x4044cd34),
        (1e-40, 3e-40, 0x3ea4bc4e),
    ];
    for (y, x, angle) in table {
        assert_eq!(math::atan2::<f32>(y, x).to_bits(), angle, "{y} {x}");
    }
}

#[test]
fn angle_double() {
    let table = [
        (0.6, 0.8, 0x3fe4978f_a3269ee1),
        (-0.8, 0.6, 0xbfedac67_0561bb50),
        (0.28, -0.96, 0x4006dcc5_7bb565fc),
        (-0.96, -0.28, 0xbffdac67_0561bb50),
        (0.007999744, 0.9999680015359508, 0x3f806236_eaaf595f),
        (0.9, -0.8, 0x40033049_66e1dfb5),
    ];
    for (sin, cos, angle) in table {
        assert_eq!(math::angle::<f64>(sin, cos).to_bits(), angle, "{sin} {cos}");
    }
}

#[test]
fn angle_single() {
    let table = [
        (0.6, 0.8, 0x3f24bc7e),
        (-0.8, 0.6, 0xbf6d6338),
        (0.28, -0.96, 0x4036e62c),
        (-0.96, -0.28, 0xbfed6338),
        (0.9, -0.8, 0x4019824c),
    ];
    for (sin, cos, angle) in table {
        assert_eq!(math::angle::<f32>(sin, cos).to_bits(), angle, "{sin} {cos}");
    }
}

/// One number from the bits of ten thousand results (FNV-1a, word by word).
#[test]
fn digest_of_many() {
    let mut random = Random(31);
    let mut digest = 0xcbf2_9ce4_8422_2325_u64;
    for _ in 0..1_000 {
        let (a, b) = (random.signed() * 4.0, random.signed() * 4.0);
        let ((s, c), (s1, c1)) = (math::sin_cos(a), math::sin_cos(a as f32));
        let far = math::sin_cos(b * 1e18).0;
        let doubles = [s, c, far, math::atan2(a, b), math::wrap(a + b), math::hypot(a, b)];
        let singles = [s1, c1, math::atan2(a as f32, b as f32), math::wrap(b as f32)];
        for bits in doubles.into_iter().map(f64::to_bits).chain(singles.into_iter().map(|v| u64::from(v.to_bits()))) {
            digest = (digest ^ bits).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    assert_eq!(digest, 0x7eba_faa7_decb_3083);
}
