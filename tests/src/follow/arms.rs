//! Arms with the rates of their data sheets, and the box from which random joint values come.

use denhart::Arm;
use denhart::follow::Rates;

/// Rates and a box of an arm, in degrees.
#[derive(Debug, Clone, Copy)]
pub struct Data<const N: usize> {
    /// Name.
    pub name: &'static str,
    /// Velocities, degrees/s.
    pub velocity: [f64; N],
    /// Reach of the data sheet, m.
    pub reach: f64,
    /// Lowest and highest joint values that are drawn.
    pub drawn: [[f64; 2]; N],
}

/// An arm in double precision, and in single precision.
macro_rules! both {
    ($(#[$doc:meta])* $Double:ident $Single:ident $yaml:tt) => {
        $(#[$doc])*
        #[derive(Arm, Clone, Copy)]
        #[arm(yaml = $yaml)]
        pub struct $Double;

        #[doc = concat!("[`", stringify!($Double), "`] in single precision.")]
        #[derive(Arm, Clone, Copy)]
        #[arm(scalar = "f32", yaml = $yaml)]
        pub struct $Single;
    };
}

impl<const N: usize> Data<N> {
    /// The rates; accelerations reach the velocity in an eighth of a second.
    #[must_use]
    pub fn rates(&self) -> Rates<f64, N> {
        let velocity = self.velocity.map(f64::to_radians);
        Rates { velocity, acceleration: velocity.map(|v| 8.0 * v) }
    }
}

both! {
    /// KUKA KR210 R2700, the structure of specs/kuka_kr6_r700.yaml; limits of A4 to A6 from the data sheet.
    Kr210 Kr210Single "
name: kr210
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0.35, alpha: -90, d: 0.675, theta: 0, limits: [-185, 185]}
  - {a: 1.15, alpha: 0, d: 0, theta: 0, limits: [-140, -5]}
  - {a: -0.041, alpha: -90, d: 0, theta: -90, limits: [-120, 168]}
  - {a: 0, alpha: 90, d: 1.2, theta: 0, limits: [-350, 350]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-125, 125]}
  - {a: 0, alpha: 0, d: 0.215, theta: 180, limits: [-350, 350]}
"
}

/// The data of [`Kr210`].
pub const KR210: Data<6> = Data {
    name: "KR210",
    velocity: [123.0, 115.0, 112.0, 179.0, 172.0, 219.0],
    reach: 2.7,
    drawn: [[-90.0, 90.0], [-120.0, -30.0], [-20.0, 120.0], [-150.0, 150.0], [-100.0, 100.0], [-180.0, 180.0]],
};

both! {
    /// ABB IRB 2400, the table of specs/abb_irb2400.yaml with limits.
    Irb2400 Irb2400Single "
name: irb2400
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0.1, alpha: -90, d: 0.615, theta: 0, limits: [-180, 180]}
  - {a: 0.705, alpha: 0, d: 0, theta: -90, limits: [-110, 120]}
  - {a: 0.135, alpha: -90, d: 0, theta: 0, limits: [-120, 120]}
  - {a: 0, alpha: 90, d: 0.755, theta: 0, limits: [-200, 200]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-120, 120]}
  - {a: 0, alpha: 0, d: 0.085, theta: 180, limits: [-400, 400]}
"
}

/// The data of [`Irb2400`].
pub const IRB2400: Data<6> = Data {
    name: "IRB 2400",
    velocity: [150.0, 150.0, 150.0, 360.0, 360.0, 450.0],
    reach: 1.5,
    drawn: [[-90.0, 90.0], [-20.0, 60.0], [-60.0, 40.0], [-150.0, 150.0], [-100.0, 100.0], [-180.0, 180.0]],
};

both! {
    /// Universal Robots UR5, the table of specs/ur5.yaml with limits.
    Ur5 Ur5Single "
name: ur5
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0, alpha: 90, d: 0.089159, theta: 0, limits: [-360, 360]}
  - {a: -0.425, alpha: 0, d: 0, theta: 0, limits: [-360, 360]}
  - {a: -0.39225, alpha: 0, d: 0, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: 90, d: 0.10915, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: -90, d: 0.09465, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: 0, d: 0.0823, theta: 0, limits: [-360, 360]}
"
}

/// The data of [`Ur5`].
pub const UR5: Data<6> = Data { name: "UR5", velocity: [180.0; 6], reach: 0.85, drawn: [[-150.0, 150.0]; 6] };

both! {
    /// Unimation Puma 560, specs/puma560.yaml.
    Puma560 Puma560Single "
name: puma560
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0, alpha: 90, d: 0.67183, theta: 0, limits: [-160, 160]}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0, limits: [-45, 225]}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0, limits: [-225, 45]}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0, limits: [-110, 170]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-100, 100]}
  - {a: 0, alpha: 0, d: 0, theta: 0, limits: [-266, 266]}
"
}

/// The data of [`Puma560`].
pub const PUMA560: Data<6> = Data {
    name: "Puma 560",
    velocity: [82.0, 74.0, 122.0, 228.0, 241.0, 228.0],
    reach: 0.86,
    drawn: [[-90.0, 90.0], [0.0, 120.0], [-180.0, 0.0], [-100.0, 100.0], [-90.0, 90.0], [-180.0, 180.0]],
};

both! {
    /// KUKA LBR iiwa 7, the table of specs/kuka_iiwa7_r800.yaml with limits; joint 3 is given.
    Iiwa IiwaSingle "
name: iiwa
convention: modified
units: {length: m, angle: deg}
inverse: {task: pose, redundant: q3}
joints:
  - {a: 0, alpha: 0, d: 0.34, theta: 0, limits: [-170, 170]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-120, 120]}
  - {a: 0, alpha: 90, d: 0.4, theta: 0, limits: [-170, 170]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-120, 120]}
  - {a: 0, alpha: 90, d: 0.4, theta: 0, limits: [-170, 170]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-120, 120]}
  - {a: 0, alpha: 90, d: 0.126, theta: 0, limits: [-175, 175]}
"
}

/// The data of [`Iiwa`].
pub const IIWA: Data<7> = Data {
    name: "iiwa",
    velocity: [98.0, 98.0, 100.0, 130.0, 140.0, 180.0, 180.0],
    reach: 0.8,
    drawn: [
        [-120.0, 120.0],
        [-90.0, 90.0],
        [-90.0, 90.0],
        [-100.0, 100.0],
        [-120.0, 120.0],
        [-90.0, 90.0],
        [-120.0, 120.0],
    ],
};

both! {
    /// A Puma 560 without joint 6, with a torch: tests/arms/position_axis/puma_with_torch.yaml with limits.
    Torch TorchSingle "
name: torch
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: z, require: true}
joints:
  - {a: 0, alpha: 90, d: 0, theta: 0, limits: [-160, 160]}
  - {a: 0.4318, alpha: 0, d: 0, theta: 0, limits: [-45, 225]}
  - {a: 0.0203, alpha: -90, d: 0.15005, theta: 0, limits: [-225, 45]}
  - {a: 0, alpha: 90, d: 0.4318, theta: 0, limits: [-110, 170]}
  - {a: 0, alpha: -90, d: 0, theta: 0, limits: [-100, 100]}
tool: {xyz: [0, 0, 0.1], rpy: [0, 0, 0]}
"
}

/// The data of [`Torch`].
pub const TORCH: Data<5> = Data {
    name: "torch",
    velocity: [82.0, 74.0, 122.0, 228.0, 241.0],
    reach: 0.9,
    drawn: [[-90.0, 90.0], [0.0, 120.0], [-180.0, 0.0], [-100.0, 100.0], [-90.0, 90.0]],
};

both! {
    /// Three joints for a point, specs/anthro3r.yaml with limits.
    Anthro AnthroSingle "
name: anthro3r
convention: standard
units: {length: m, angle: deg}
inverse: {task: position}
joints:
  - {a: 0, alpha: 90, d: 0.35, theta: 0, limits: [-170, 170]}
  - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-30, 150]}
  - {a: 0.25, alpha: 0, d: 0, theta: 0, limits: [-150, 150]}
"
}

/// The data of [`Anthro`].
pub const ANTHRO: Data<3> = Data {
    name: "anthro3r",
    velocity: [150.0, 120.0, 180.0],
    reach: 0.55,
    drawn: [[-120.0, 120.0], [0.0, 120.0], [-120.0, 120.0]],
};

both! {
    /// Kinova's Jaco, specs/kinova_jaco.yaml: a joint is held, branches are numbered.
    Jaco JacoSingle "
name: kinova_jaco
convention: standard
units: {length: m, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0, alpha: 90, d: 0.2755, theta: 0, limits: [-360, 360]}
  - {a: 0.41, alpha: 180, d: 0, theta: -90, limits: [-133, 133]}
  - {a: 0, alpha: 90, d: -0.0098, theta: 90, limits: [-161, 161]}
  - {a: 0, alpha: 60, d: -0.2501971250007892, theta: 0, limits: [-360, 360]}
  - {a: 0, alpha: 60, d: -0.08579425000157839, theta: -180, limits: [-360, 360]}
  - {a: 0, alpha: 180, d: -0.2115971250007892, theta: 100, limits: [-360, 360]}
"
}

/// The data of [`Jaco`].
pub const JACO: Data<6> = Data {
    name: "jaco",
    velocity: [36.0, 36.0, 36.0, 48.0, 48.0, 48.0],
    reach: 0.9,
    drawn: [[-120.0, 120.0], [-80.0, 80.0], [-120.0, 120.0], [-150.0, 150.0], [-150.0, 150.0], [-150.0, 150.0]],
};

/// An arm whose motors 2 and 3 are linked, specs/fanuc_lrmate200id.yaml with limits, one of them of a sum.
#[derive(Arm, Clone, Copy)]
#[arm(yaml = "
name: lrmate
convention: modified
units: {length: mm, angle: deg}
inverse: {task: pose}
joints:
  - {a: 0, alpha: 0, d: 0, theta: 0, limits: [-170, 170]}
  - {a: 50, alpha: -90, d: 0, theta: -90, limits: [-100, 145]}
  - {a: 330, alpha: 0, d: 0, theta: 0, limits: [-140, 140]}
  - {a: 35, alpha: -90, d: 335, theta: 0, limits: [-190, 190]}
  - {a: 0, alpha: 90, d: 0, theta: 0, limits: [-125, 125]}
  - {a: 0, alpha: -90, d: 80, theta: 0, limits: [-360, 360]}
coupling:
  q3: {q2: -1, q3: -1}
  q4: {q4: -1}
")]
pub struct Linked;

/// The data of [`Linked`]; velocities of the motors.
pub const LINKED: Data<6> = Data {
    name: "lrmate",
    velocity: [450.0, 380.0, 520.0, 550.0, 545.0, 1000.0],
    reach: 717.0,
    drawn: [[-90.0, 90.0], [-40.0, 80.0], [-60.0, 60.0], [-150.0, 150.0], [-100.0, 100.0], [-180.0, 180.0]],
};
