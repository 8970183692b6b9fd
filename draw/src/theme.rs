//! Colors.

use crate::picture::Role;

/// Colors of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Theme {
    /// Light, and dark where the viewer of the SVG prefers dark; a PNG is light.
    #[default]
    Auto,
    /// Dark lines on white.
    Light,
    /// Light lines on nearly black.
    Dark,
}

/// How many colors solutions have.
pub const SOLUTIONS: u8 = 8;

/// The colors of solutions on white and on nearly black: those of Okabe and Ito, without the yellow on white and the black
/// on black that nobody sees.
const COLORS: [[u32; 2]; SOLUTIONS as usize] = [
    [0x0072b2, 0x3d9fe8],
    [0xd55e00, 0xff7a24],
    [0x009e73, 0x1fc99a],
    [0xcc79a7, 0xe59ac6],
    [0x3a3f45, 0xe6e9ec],
    [0xe69f00, 0xb0702c],
    [0x56b4e9, 0xa5dcff],
    [0x8a5a2b, 0xf0e442],
];

/// The colors of a role: on a light and on a dark background, as `0xrrggbb`.
pub fn colors(role: Role) -> [u32; 2] {
    match role {
        Role::Background => [0xffffff, 0x14181d],
        Role::Ink => [0x1f2328, 0xe6e9ec],
        Role::Muted => [0x626c76, 0x98a2ac],
        Role::Link => [0x9aa7b4, 0x66727e],
        Role::Face => [0xe9edf1, 0x2c343c],
        Role::X => [0xc4500a, 0xff8a3d],
        Role::Y => [0x00805c, 0x1fc99a],
        Role::Z => [0x0064a0, 0x52adf0],
        Role::Measure => [0x7a3e8f, 0xcf9ae0],
        Role::Deciding => [0xc4138f, 0xff7ad9],
        Role::Region => [0xd8ebf7, 0x1c3547],
        Role::Target => [0xb3123f, 0xff6b8f],
        Role::Solution(number) => COLORS.get(usize::from(number % SOLUTIONS)).copied().unwrap_or([0, 0xffffff]),
    }
}

/// The name of a role in the style sheet of a picture.
pub fn class(role: Role) -> String {
    match role {
        Role::Background => "bg".to_owned(),
        Role::Ink => "ink".to_owned(),
        Role::Muted => "mut".to_owned(),
        Role::Link => "lnk".to_owned(),
        Role::Face => "fac".to_owned(),
        Role::X => "x".to_owned(),
        Role::Y => "y".to_owned(),
        Role::Z => "z".to_owned(),
        Role::Measure => "len".to_owned(),
        Role::Deciding => "axs".to_owned(),
        Role::Region => "reg".to_owned(),
        Role::Target => "tgt".to_owned(),
        Role::Solution(number) => format!("s{}", number % SOLUTIONS + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Linear light of a color, red, green and blue.
    fn linear(color: u32) -> [f64; 3] {
        [16, 8, 0].map(|shift| {
            let part = f64::from((color >> shift) & 0xff) / 255.0;
            if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
        })
    }

    fn product(matrix: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum())
    }

    /// Lightness and the two color axes of CIELAB.
    fn lab(linear: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = product([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]], linear);
        let [x, y, z] = [x / 0.9505, y, z / 1.089].map(|t: f64| t.max(1e-4).cbrt());
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// Eyes with all cones, and without those for long, middle and short waves (Machado, Oliveira, Fernandes 2009).
    const EYES: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    #[test]
    fn every_eye_tells_the_solutions_apart() {
        for theme in [0, 1] {
            for eye in EYES {
                let seen: Vec<[f64; 3]> = (0..SOLUTIONS)
                    .map(|number| lab(product(eye, linear(colors(Role::Solution(number))[theme]))))
                    .collect();
                for (i, a) in seen.iter().enumerate() {
                    for (j, b) in seen.iter().enumerate().skip(i + 1) {
                        let difference: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
                        assert!(difference > 15.0, "theme {theme}: {i} and {j} differ by {difference:.1}");
                    }
                }
            }
        }
    }

    #[test]
    fn texts_stand_out_from_the_background() {
        let luminance = |color: u32| product([[0.2126, 0.7152, 0.0722], [0.0; 3], [0.0; 3]], linear(color))[0];
        for theme in [0, 1] {
            for role in [Role::Ink, Role::Muted, Role::X, Role::Y, Role::Z, Role::Measure, Role::Deciding, Role::Target]
            {
                let mut pair = [colors(role)[theme], colors(Role::Background)[theme]].map(luminance);
                pair.sort_by(f64::total_cmp);
                let contrast = (pair[1] + 0.05) / (pair[0] + 0.05);
                assert!(contrast >= 4.5, "{role:?}: {contrast:.1}");
            }
        }
    }
}
