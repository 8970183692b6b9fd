//! Of an arm without a file nothing is known, not even how many joints it has.

use denhart::{Arm, Pose};

#[derive(Arm)]
#[arm(spec = "/no/such/arm.yaml")]
struct Missing;

fn main() {
    let q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
    let pose: Pose<f64> = Missing.forward(&q);
    println!("{:?} {:?}", Missing.jacobian(&q), Missing.link_poses(&q).len());
    for solution in Missing.inverse(&pose) {
        println!("{:?}", solution.q);
    }
    println!("{:?}", Missing.inverse_near(&pose, &q).status());
}
