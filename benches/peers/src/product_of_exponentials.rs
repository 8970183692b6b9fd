//! Arms of ik-geo: axes and the vectors between them at the zero configuration, taken from the DH table.

use denhart::{Chain, DhTable, Pose};
use ik_geo::inverse_kinematics::auxiliary::Kinematics;
use ik_geo::nalgebra::{Matrix3, Vector3, Vector6};

/// An arm, with the rotation of its tool at the zero configuration, which ik-geo takes to be none.
#[derive(Debug, Clone)]
pub struct GeoArm {
    kinematics: Kinematics<6, 7>,
    tool: Matrix3<f64>,
}

/// A decomposition of ik-geo, such as `three_parallel`.
pub type Decomposition = fn(&Matrix3<f64>, &Vector3<f64>, &Kinematics<6, 7>) -> (Vec<Vector6<f64>>, Vec<bool>);

/// A target in the form ik-geo takes.
pub type Target = (Matrix3<f64>, Vector3<f64>);

impl GeoArm {
    /// The arm of a table of six standard rows without base and tool.
    ///
    /// `points[i]`: number of the DH frame whose origin is the point on axis i + 1; frame 0 is the base. Each
    /// decomposition asks for its own, such as one point on all three axes of a wrist.
    pub fn new(table: &DhTable, points: [usize; 6]) -> Self {
        let links = Chain::from(*table).link_poses(&[0.0; 6]).expect("six joints");
        let frames: Vec<Pose<f64>> =
            std::iter::once(Pose::identity()).chain(links.into_iter().map(Pose::from)).collect();
        let origin = |frame: usize| Vector3::from(frames[frame].translation);
        let mut kinematics = Kinematics::<6, 7>::new();
        let mut last = Vector3::zeros();
        for (axis, &point) in points.iter().enumerate() {
            let z = frames[axis].rotation.map(|row| row[2]);
            kinematics.h.set_column(axis, &Vector3::from(z));
            kinematics.p.set_column(axis, &(origin(point) - last));
            last = origin(point);
        }
        kinematics.p.set_column(6, &(origin(6) - last));
        Self { kinematics, tool: matrix(&frames[6]) }
    }

    /// A pose in the form ik-geo takes.
    pub fn target(&self, pose: &Pose<f64>) -> Target {
        (matrix(pose) * self.tool.transpose(), Vector3::from(pose.translation))
    }

    /// Every solution, and whether it is only the closest approach.
    pub fn inverse(&self, decomposition: Decomposition, target: &Target) -> (Vec<Vector6<f64>>, Vec<bool>) {
        decomposition(&target.0, &target.1, &self.kinematics)
    }

    /// Pose of the tool in ik-geo's form.
    pub fn forward(&self, q: &[f64; 6]) -> Target {
        self.kinematics.forward_kinematics(&Vector6::from(*q))
    }
}

fn matrix(pose: &Pose<f64>) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| pose.rotation[row][column])
}
