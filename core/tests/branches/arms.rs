//! Tables of arms: a, alpha, d, theta of each joint, in m and degrees.

use denhart_core::math::sin_cos;
use denhart_core::{Chain, Transform};

use crate::support::Random;

pub type Table = [[f64; 4]; 6];

/// Robotics Toolbox for Python, model Jaco with a curved wrist.
const JACO: Table = [
    [0.0, 90.0, 0.2755, 0.0],
    [0.41, 180.0, 0.0, -90.0],
    [0.0, 90.0, -0.0098, 90.0],
    [0.0, 60.0, -0.250_197_125_000_789_2, 0.0],
    [0.0, 60.0, -0.085_794_250_001_578_39, -180.0],
    [0.0, 180.0, -0.211_597_125_000_789_2, 100.0],
];

/// Kinova's lengths of the Mico with a curved wrist, as the Robotics Toolbox makes a table of them.
const MICO: Table = [
    [0.0, 90.0, 0.2755, 0.0],
    [0.29, 180.0, 0.0, -90.0],
    [0.0, 90.0, -0.007, 90.0],
    [0.0, 60.0, -0.166_081_654_946_951_26, 0.0],
    [0.0, 60.0, -0.085_563_309_893_902_53, -180.0],
    [0.0, 180.0, -0.202_781_654_946_951_27, 100.0],
];

const fn crx(upper: f64, fore: f64, wrist: f64, flange: f64) -> Table {
    [
        [0.0, 0.0, 0.0, 0.0],
        [0.0, -90.0, 0.0, -90.0],
        [upper, 0.0, 0.0, 0.0],
        [0.0, -90.0, fore, 0.0],
        [0.0, 90.0, -wrist, 0.0],
        [0.0, -90.0, flange, 0.0],
    ]
}

/// uFactory's default kinematics.
const XARM6: Table = [
    [0.0, 0.0, 0.267, 0.0],
    [0.0, -90.0, 0.0, -79.349_949_087_697_35],
    [0.289_486_614_543_747_1, 0.0, 0.0, 79.349_949_087_697_35],
    [0.0775, -90.0, 0.3425, 0.0],
    [0.0, 90.0, 0.0, 0.0],
    [0.076, -90.0, 0.097, 0.0],
];

/// robotkinematicscatalogue, Kinova_Gen3_lite.
const GEN3_LITE: Table = [
    [0.0, 0.0, 0.24325, 180.0],
    [0.0, -90.0, 0.01, -90.0],
    [0.28, 0.0, 0.0, -90.0],
    [0.0, -90.0, 0.245, -90.0],
    [0.0, 90.0, -0.057, 0.0],
    [0.0, -90.0, 0.105, 0.0],
];

/// The arms by name.
pub fn named(name: &str) -> Chain<f64> {
    meet().into_iter().find_map(|(other, chain)| (other == name).then_some(chain)).unwrap()
}

/// Six arms with axes 4 and 5 that meet, and 2 and 3 parallel.
pub fn meet() -> [(&'static str, Chain<f64>); 6] {
    [
        ("jaco", standard(&JACO)),
        ("mico", standard(&MICO)),
        ("crx10", modified(&crx(0.71, 0.54, 0.15, 0.16))),
        ("crx5", modified(&crx(0.41, 0.43, 0.13, 0.145))),
        ("xarm6", modified(&XARM6)),
        ("gen3_lite", modified(&GEN3_LITE)),
    ]
}

/// Multiples of 90 degrees are exact.
fn tilt(alpha: f64) -> Transform<f64> {
    let (s, c) = match alpha.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => sin_cos(alpha.to_radians()),
    };
    Transform { rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]], translation: [0.0; 3] }
}

fn shift(translation: [f64; 3]) -> Transform<f64> {
    Transform { translation, ..Transform::IDENTITY }
}

fn turn(theta: f64, d: f64) -> Transform<f64> {
    Transform::IDENTITY.then_turn(sin_cos(theta.to_radians())).then_slide(d)
}

/// Denavit-Hartenberg, standard: `Rz(theta) Tz(d) Tx(a) Rx(alpha)`.
pub fn standard(table: &Table) -> Chain<f64> {
    let mut links = [Transform::IDENTITY; 7];
    for (link, [a, alpha, d, theta]) in links.iter_mut().skip(1).zip(table) {
        *link = turn(*theta, *d) * shift([*a, 0.0, 0.0]) * tilt(*alpha);
    }
    Chain::new(links, [false; 6]).gathered()
}

/// Denavit-Hartenberg, modified: `Rx(alpha) Tx(a) Rz(theta) Tz(d)`.
pub fn modified(table: &Table) -> Chain<f64> {
    let mut links = [Transform::IDENTITY; 7];
    for (i, [a, alpha, d, theta]) in table.iter().enumerate() {
        links[i] = links[i] * tilt(*alpha) * shift([*a, 0.0, 0.0]);
        links[i + 1] = turn(*theta, *d);
    }
    Chain::new(links, [false; 6]).gathered()
}

/// An arm with random links.
pub fn random(random: &mut Random) -> Chain<f64> {
    let table = core::array::from_fn(|_| {
        [random.within(-1.0, 1.0), random.within(-180.0, 180.0), random.within(-1.0, 1.0), 0.0]
    });
    standard(&table)
}
