use denhart::Arm;

#[derive(Arm)]
#[arm(yaml = "
name: planar
convention: standard
units: {length: m, angle: deg}
parameters: {l2: 0.425, l3: 0.392}
joints:
  - {type: revolute, a: l2, alpha: 0, d: 0, theta: 0}
  - {type: revolute, a: l3, alpha: 0, d: 0, theta: 0}
")]
struct Planar {
    l2: f32,
    l4: f64,
}

fn main() {
    let arm = Planar { l2: 0.5, l4: 1.0 };
    println!("{:?} {:?} {}", arm.forward(&[0.0; 2]), arm.dh_rows(), Planar::DOF);
    println!("{:?}", Planar::nominal().jacobian(&[0.0; 2]));
}
