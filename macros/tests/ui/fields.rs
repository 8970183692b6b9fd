use denhart::Arm;

#[derive(Arm)]
#[arm(yaml = "
name: lever
convention: standard
units: {length: m, angle: deg}
joints: [{type: revolute, a: 0.5, alpha: 0, d: 0, theta: 0}]
")]
struct Lever {
    length: f64,
    height: f64,
}

fn main() {
    let lever = Lever { length: 0.5, height: 1.0 };
    println!("{:?}", lever.forward(&[0.0]));
}
