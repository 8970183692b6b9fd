use denhart::Arm;

#[derive(Arm)]
#[arm(yml = "name: lever", warn, warn, scalar = "double")]
struct Mistyped;

#[derive(Arm)]
struct Bare;

#[derive(Arm)]
#[arm(scalar = "f32")]
struct Nowhere;

#[derive(Arm)]
#[arm("specs/ur5.yaml")]
struct WithoutKey;

#[derive(Arm)]
#[arm(spec, scalar = f32)]
struct Unquoted;

#[derive(Arm)]
#[arm(yaml = "
name: lever
convention: standard
units: {length: m, angle: deg}
joints: [{type: revolute, a: 0.5, alpha: 0, d: 0, theta: 0}]
")]
enum Choice {
    Lever,
}

fn main() {
    println!("{:?} {:?}", Mistyped.forward(&[0.0; 6]), Bare.forward(&[0.0; 6]));
    println!("{:?} {:?}", Nowhere.forward(&[0.0; 6]), Choice::Lever.forward(&[0.0]));
}
