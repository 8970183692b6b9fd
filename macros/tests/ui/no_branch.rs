//! No three consecutive axes of this arm meet or are parallel: its solutions have no names that last.

use denhart::{Arm, Branch};

#[derive(Arm)]
#[arm(yaml = "
name: general
convention: standard
units: {length: m, angle: deg}
joints:
  - {type: revolute, a: 0.3, alpha: 70, d: 0.1, theta: 0}
  - {type: revolute, a: 0.4, alpha: 50, d: 0.2, theta: 0}
  - {type: revolute, a: 0.2, alpha: 40, d: 0.3, theta: 0}
  - {type: revolute, a: 0.1, alpha: 80, d: 0.4, theta: 0}
  - {type: revolute, a: 0.3, alpha: 60, d: 0.1, theta: 0}
  - {type: revolute, a: 0.2, alpha: 30, d: 0.2, theta: 0}
")]
struct General;

fn main() {
    let pose = General.forward(&[0.0; 6]);
    println!("{:?}", General.inverse(&pose).len());
    println!("{:?}", General.inverse_branch(&pose, Branch::NONE));
}
