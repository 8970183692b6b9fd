//! The proof of an import: the file's forward kinematics beside the URDF's own at random configurations.

use denhart::Chain;

use super::mimic_coupling::{MimicCoupling, joint_value};
use super::path::Path;
use super::rigid::{Transform, difference};
use super::urdf::Robot;

/// How many configurations are compared.
pub const CONFIGURATIONS: usize = 1000;

/// The largest differences of two poses: of position, m, and of direction, rad.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Difference {
    pub position: f64,
    pub angle: f64,
}

impl Difference {
    /// True where neither difference is above that of `most`.
    pub fn is_within(self, most: Self) -> bool {
        self.position <= most.position && self.angle <= most.angle
    }

    /// The larger ones. What is no number is larger than any.
    pub fn max(self, other: Self) -> Self {
        let larger = |a: f64, b: f64| if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) };
        Self { position: larger(self.position, other.position), angle: larger(self.angle, other.angle) }
    }
}

/// The largest difference between `pose`, of the table's joint values, and the URDF's own, over random values of the
/// motors within their limits.
pub fn compare(robot: &Robot, path: &Path, coupling: &MimicCoupling, pose: &dyn Fn(&[f64]) -> Transform) -> Difference {
    let mut random = Random(0x5eed);
    (0..CONFIGURATIONS).fold(Difference::default(), |worst, _| {
        let motors: Vec<f64> = coupling
            .motors
            .iter()
            .map(|motor| {
                let [low, high] = motor.sampled_range();
                low + (high - low) * random.next()
            })
            .collect();
        let by_name = |name: &str| {
            let index = coupling.motors.iter().position(|motor| motor.name == name);
            index.and_then(|index| motors.get(index)).copied().unwrap_or(0.0)
        };
        let own = super::axes::pose(path, &|joint| joint_value(robot, joint, &by_name));
        let (position, angle) = difference(&pose(&coupling.joint_values(&motors)), &own);
        worst.max(Difference { position, angle })
    })
}

/// The pose of a chain; what it cannot compute is no number.
pub fn of_chain(chain: &Chain, q: &[f64]) -> Transform {
    let Ok(pose) = chain.forward(q) else { return Transform { r: [[f64::NAN; 3]; 3], p: [f64::NAN; 3] } };
    let pose = denhart::Pose::from(pose);
    Transform { r: pose.rotation, p: pose.translation }
}

/// Numbers in 0 to 1 (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
