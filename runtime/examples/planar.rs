//! Balerao et al. 2023, planar arms with two and three joints: both tables of the inverse, whose links change from row to
//! row. The links are fields of the arms, bound at run time.
//!
//! `cargo run --release --example planar`

use denhart::{Arm, PlanarPose};

#[derive(Arm)]
#[arm(spec = "examples/arms/planar2r.yaml")]
struct Planar2r {
    l1: f64,
    l2: f64,
}

#[derive(Arm)]
#[arm(spec = "examples/arms/planar3r.yaml")]
struct Planar3r {
    l1: f64,
    l2: f64,
    l3: f64,
}

/// x, y, links, cm; theta1, theta2 as printed, degrees, both with both signs.
const TABLE_1: [([f64; 2], [f64; 2], [f64; 2]); 3] = [
    ([16.0, 13.0], [10.0, 20.0], [33.258, 100.806]),
    ([15.0, 5.0], [15.0, 10.0], [19.326, 104.477]),
    ([12.99, 2.5], [10.0, 5.0], [8.214, 60.006]),
];

/// x, y, cm, and phi, degrees; links, cm; the two solutions, degrees.
type ThreeLinks = ([f64; 3], [f64; 3], [[f64; 3]; 2]);

/// Recomputed and rounded; the paper cuts off after three decimals.
const TABLE_2: [ThreeLinks; 3] = [
    ([16.0, 13.0, 180.0], [20.0, 10.0, 7.0], [[10.275, 60.330, 109.395], [48.677, -60.330, 191.653]]),
    ([15.0, 5.0, 110.0], [15.0, 10.0, 4.0], [[-32.438, 100.670, 41.768], [41.111, -100.670, 169.559]]),
    ([12.99, 2.5, 130.0], [10.0, 5.0, 2.0], [[-8.298, 37.128, 101.170], [16.055, -37.128, 151.073]]),
];

fn main() {
    println!("Table 1: two links. The signs that the paper prints belong to no solution but the first.");
    for ([x, y], [l1, l2], [theta1, theta2]) in TABLE_1 {
        println!("\n({x}, {y}), links {l1}, {l2}\n  paper  theta1 = +-{theta1}, theta2 = +-{theta2}");
        let arm = Planar2r { l1, l2 };
        for solution in &arm.inverse(&[x, y]) {
            println!("  here   {}", solution.display_for(&arm));
        }
    }
    println!("\n\nTable 2: three links. Angles differ by whole turns.");
    for ([x, y, phi], [l1, l2, l3], paper) in TABLE_2 {
        println!("\n({x}, {y}) at {phi} degrees, links {l1}, {l2}, {l3}");
        for [theta1, theta2, theta3] in paper {
            println!("  table  [{theta1:.3}, {theta2:.3}, {theta3:.3}]");
        }
        let arm = Planar3r { l1, l2, l3 };
        for solution in &arm.inverse(&PlanarPose::new(x, y, phi.to_radians())) {
            println!("  here   {}", solution.display_for(&arm));
        }
    }
}
