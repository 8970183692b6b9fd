//! Balerao et al. 2023, inverse kinematics of planar arms with two and three joints: every row has links of its own.

use denhart::numeric::Task;
use denhart::{Arm, PlanarPose};
use serde::Deserialize;
use serde::de::{Deserializer, Error};

use crate::agreement::Both;
use crate::tables::{off, radians, rows, same_solutions};

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/planar2r.yaml")]
struct Planar2r {
    l1: f64,
    l2: f64,
}

#[derive(Clone, Copy, Arm)]
#[arm(spec = "../specs/planar3r.yaml")]
struct Planar3r {
    l1: f64,
    l2: f64,
    l3: f64,
}

/// 1e-12 of reach, the bound of EXACT, over the elbow's amplitude, which is above 0.1 in every row.
const TOLERANCE: f64 = 1e-11;

/// A decimal as the paper prints it.
fn decimal<'a, D: Deserializer<'a>>(deserializer: D) -> Result<f64, D::Error> {
    String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
}

#[derive(Deserialize)]
struct TwoLinks {
    #[serde(deserialize_with = "decimal")]
    px: f64,
    #[serde(deserialize_with = "decimal")]
    py: f64,
    #[serde(deserialize_with = "decimal")]
    l1: f64,
    #[serde(deserialize_with = "decimal")]
    l2: f64,
    solutions_deg: [[f64; 2]; 2],
    printed: String,
}

impl TwoLinks {
    fn arm(&self) -> Planar2r {
        Planar2r { l1: self.l1, l2: self.l2 }
    }

    /// The two angles that the paper prints with both signs, degrees.
    fn printed(&self) -> [f64; 2] {
        let mut numbers =
            self.printed.split("=+-").skip(1).map(|text| text.split(' ').next().unwrap().parse().unwrap());
        [numbers.next().unwrap(), numbers.next().unwrap()]
    }
}

#[derive(Deserialize)]
struct ThreeLinks {
    #[serde(deserialize_with = "decimal")]
    x: f64,
    #[serde(deserialize_with = "decimal")]
    y: f64,
    #[serde(deserialize_with = "decimal")]
    phi: f64,
    l: [String; 3],
    solutions_deg: [[f64; 3]; 2],
}

#[test]
fn table_1_with_the_links_of_each_row() {
    let table: Vec<TwoLinks> = rows("planar2r_inverse");
    assert_eq!(table.len(), 3);
    for row in table {
        let solutions = row.arm().inverse(&[row.px, row.py]);
        assert!(solutions.iter().all(|solution| solution.is_exact()), "{solutions:?}");
        let found: Vec<_> = solutions.iter().map(|solution| solution.q).collect();
        same_solutions(&found, &row.solutions_deg.map(radians), TOLERANCE);
        for q in found {
            let [x, y, z] = row.arm().forward(&q).translation;
            assert!(off(&[x, y, z], &[row.px, row.py, 0.0]) < 1e-12 * (row.l1 + row.l2), "{q:?}");
        }
    }
}

/// Printed: `+-theta1, +-theta2`, cut off after three decimals. True: the second solution has another theta1
/// altogether, and its theta2 has the opposite sign. The elbow is mirrored at the line to the target and not at the x
/// axis.
#[test]
fn misprint_table_1_pairs_the_signs_wrongly() {
    let true_pairs = [
        [[-33.258069, 100.806923], [111.445787, -100.806923]],
        [[-19.326295, 104.477512], [56.196193, -104.477512]],
        [[-8.214770, 60.006550], [30.002183, -60.006550]],
    ];
    for (row, pairs) in rows::<TwoLinks>("planar2r_inverse").iter().zip(true_pairs) {
        for (exact, decimals) in row.solutions_deg.iter().zip(&pairs) {
            assert!(off(exact, decimals) <= 0.5001e-6, "{exact:?} {decimals:?}");
        }
        let [first, second] = row.printed();
        // Cut off, not rounded.
        let cut = pairs[0].map(|angle| (angle.abs() * 1e3).floor() / 1e3);
        assert_eq!([first, second], cut);
        let misses = |q: [f64; 2]| {
            let [x, y, _] = row.arm().forward(&radians(q)).translation;
            f64::hypot(x - row.px, y - row.py)
        };
        // What two angles, each up to 0.001 degrees off, move the tool.
        let digits = 0.001_f64.to_radians() * (row.l1 + 2.0 * row.l2);
        assert!(misses([-first, second]) < digits);
        for signs in [[first, second], [first, -second], [-first, -second]] {
            assert!(misses(signs) > 1.0, "{signs:?} reaches ({}, {}) after all", row.px, row.py);
        }
    }
}

#[test]
fn table_2_with_the_links_of_each_row() {
    let table: Vec<ThreeLinks> = rows("planar3r_inverse");
    assert_eq!(table.len(), 3);
    for row in table {
        let [l1, l2, l3] = row.l.map(|length| length.parse().unwrap());
        let arm = Planar3r { l1, l2, l3 };
        let target = PlanarPose::new(row.x, row.y, row.phi.to_radians());
        let solutions = arm.inverse(&target);
        assert!(solutions.iter().all(|solution| solution.is_exact()), "{solutions:?}");
        let found: Vec<_> = solutions.iter().map(|solution| solution.q).collect();
        // Angles of the table are not brought into (-180, 180].
        same_solutions(&found, &row.solutions_deg.map(radians), TOLERANCE);
        for (q, residual) in found.iter().zip(solutions.verify(&arm, &target)) {
            assert!(residual.position < 1e-12 * (l1 + l2 + l3) && residual.orientation < 1e-12, "{q:?}: {residual}");
        }
    }
}

/// The paper prints Table 2 cut off after three decimals. With these angles the tool misses the target, by less than a
/// thousandth of a degree in each joint moves the tool.
#[test]
fn misprint_table_2_is_cut_off() {
    for row in rows::<ThreeLinks>("planar3r_inverse") {
        let [l1, l2, l3]: [f64; 3] = row.l.map(|length| length.parse().unwrap());
        for exact in row.solutions_deg {
            let cut = exact.map(|angle| (angle * 1e3).trunc() / 1e3);
            let [x, y, _] = Planar3r { l1, l2, l3 }.forward(&radians(cut)).translation;
            let missed = f64::hypot(x - row.x, y - row.y);
            let digits = 0.001_f64.to_radians() * (l1 + 2.0 * l2 + 3.0 * l3);
            assert!(missed > 0.0 && missed < digits, "{missed}");
        }
    }
}

#[test]
fn closed_form_and_iteration_agree() {
    for row in rows::<TwoLinks>("planar2r_inverse") {
        let task = Task::Components([true, true, false, false, false, false]);
        let both = Both { arm: row.arm(), task, length: row.l1 + row.l2 };
        both.agree("planar2r", |arm, q| {
            let [x, y, _] = arm.forward(q).translation;
            arm.inverse(&[x, y]).iter().map(|solution| solution.q).collect()
        });
    }
    for row in rows::<ThreeLinks>("planar3r_inverse") {
        let [l1, l2, l3]: [f64; 3] = row.l.map(|length| length.parse().unwrap());
        let task = Task::Components([true, true, false, false, false, true]);
        let both = Both { arm: Planar3r { l1, l2, l3 }, task, length: l1 + l2 + l3 };
        both.agree("planar3r", |arm, q| {
            let [x, y, _] = arm.forward(q).translation;
            let target = PlanarPose::new(x, y, q.iter().sum());
            arm.inverse(&target).iter().map(|solution| solution.q).collect()
        });
    }
}
