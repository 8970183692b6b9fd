//! Axes 5 and 6 of this arm are one line: it is singular everywhere.

use denhart::{Arm, Solutions, Status};

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
  - {type: revolute, a: 0, alpha: 0, d: 0.1, theta: 0}
  - {type: revolute, a: 0.2, alpha: 30, d: 0.2, theta: 0}
")]
struct General;

fn main() {
    let pose = General.forward(&[0.0; 6]);
    println!("{:?}", General.inverse(&pose).len());
    println!("{:?}", General.inverse_near(&pose, &[0.0; 6]).len());
    let mut kept: Solutions<f64, 6, { General::MAX_SOLUTIONS }> = Solutions::new(Status::BadTarget);
    General.inverse_into(&pose, &mut kept);
    println!("{}", General.target_at(&[0.0; 6]));
}
