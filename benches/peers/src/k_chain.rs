//! Serial arms of the crate `k`, made from the DH table.

use denhart::{Convention, DhFrame, DhRow, DhTable, JointKind, Pose};
use k::joint::Range;
use k::nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};
use k::{JointType, NodeBuilder, SerialChain};

/// The arm of a table, with limits where they are finite.
///
/// Each joint is one node, which turns or slides along z. The origin of a node is the transform between the joint
/// before and this joint. A fixed node holds the transform after the last joint.
pub fn chain(table: &DhTable, limits: &[[f64; 2]]) -> SerialChain<f64> {
    let mut limits = limits.iter();
    let mut origin = frame(&table.base);
    let mut nodes: Vec<k::Node<f64>> = Vec::new();
    for (index, row) in table.rows.iter().enumerate() {
        let (link, turn) = (link(row), about_z(row.theta, row.d));
        let (before, after) = match table.convention {
            Convention::Standard => (turn, link),
            Convention::Modified => (link * turn, Isometry3::identity()),
        };
        origin *= before;
        let joint_type = match row.kind {
            JointKind::Revolute => Some(JointType::Rotational { axis: Vector3::z_axis() }),
            JointKind::Prismatic => Some(JointType::Linear { axis: Vector3::z_axis() }),
            JointKind::Fixed => None,
        };
        if let Some(joint_type) = joint_type {
            let limits = limits.next().filter(|[low, high]| low.is_finite() && high.is_finite());
            let range = limits.map(|[low, high]| Range::new(*low, *high));
            nodes.push(node(&format!("joint{index}"), joint_type, range, origin));
            origin = Isometry3::identity();
        }
        origin *= after;
    }
    nodes.push(node("tool", JointType::Fixed, None, origin * frame(&table.tool)));
    for pair in nodes.windows(2) {
        pair[1].set_parent(&pair[0]);
    }
    SerialChain::from_end(nodes.last().expect("the tool"))
}

/// A pose in the library's own form.
pub fn target(pose: &Pose<f64>) -> Isometry3<f64> {
    let matrix = Matrix3::from_fn(|row, column| pose.rotation[row][column]);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix));
    Isometry3::from_parts(Vector3::from(pose.translation).into(), rotation)
}

fn node(name: &str, joint_type: JointType<f64>, limits: Option<Range<f64>>, origin: Isometry3<f64>) -> k::Node<f64> {
    NodeBuilder::new().name(name).joint_type(joint_type).limits(limits).origin(origin).into_node()
}

/// `Rx(alpha) Tx(a)`, in either order.
fn link(row: &DhRow) -> Isometry3<f64> {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), row.alpha);
    Isometry3::from_parts(Translation3::new(row.a, 0.0, 0.0), turn)
}

/// `Rz(theta) Tz(d)`, in either order. The joint's own motion is one of the same kind.
fn about_z(theta: f64, d: f64) -> Isometry3<f64> {
    let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), theta);
    Isometry3::from_parts(Translation3::new(0.0, 0.0, d), turn)
}

fn frame(frame: &DhFrame) -> Isometry3<f64> {
    let [[x, y, z], [roll, pitch, yaw]] = [frame.xyz, frame.rpy];
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}
