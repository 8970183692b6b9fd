//! Six joints between seven constant transforms.

use crate::transform::{cross, difference, dot};
use crate::{Scalar, Transform};

/// `T = C0 M1 C1 M2 C2 .. M6 C6`, where M is a joint: `Rz(q)`, or `Tz(q)` for a prismatic one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain<T> {
    /// C0 to C6: base, links and tool.
    pub links: [Transform<T>; 7],
    /// The joints that slide along z instead of turning about it.
    pub is_prismatic: [bool; 6],
    /// Unit of the lengths in errors, greater than 0. As [`Chain::new`] and [`Chain::gathered`] set it, the sum of the
    /// lengths of C1 to C6.
    pub reach: T,
}

/// Six numbers that vanish at a solution, with their derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Miss<T> {
    /// Target less position over reach, and half the sum of the vector products of the axes with those of the target:
    /// the rotation that is missing, as a vector of length `sin(angle)`.
    pub error: [T; 6],
    /// Row i, entry j: the derivative by joint j of coordinate i of the end's motion, lengths over reach. A step `dq`
    /// with `jacobian dq = error` removes the error.
    pub jacobian: [[T; 6]; 6],
    /// The greatest entry of the difference of the two poses, lengths over reach; not a number if one of them is not
    /// finite.
    pub residual: T,
}

impl<T: Scalar> Chain<T> {
    /// A chain whose reach is the sum of the lengths of C1 to C6, or 1 if all of them are 0.
    pub fn new(links: [Transform<T>; 7], is_prismatic: [bool; 6]) -> Self {
        let mut reach = T::ZERO;
        for link in links.iter().skip(1) {
            reach += dot(link.translation, link.translation).sqrt();
        }
        Self { links, is_prismatic, reach: if reach > T::ZERO { reach } else { T::ONE } }
    }

    /// Each link with the joint before it: `(M1, C1)` to `(M6, C6)` as prismatic or not, value, constant.
    #[inline]
    fn moves<'a>(&'a self, joints: &'a [T; 6]) -> impl Iterator<Item = (bool, T, &'a Transform<T>)> {
        let links = self.links.iter().skip(1);
        self.is_prismatic
            .iter()
            .zip(joints)
            .zip(links)
            .map(|((is_prismatic, joint), link)| (*is_prismatic, *joint, link))
    }

    /// The pose of the end.
    #[inline]
    pub fn pose(&self, joints: &[T; 6]) -> Transform<T> {
        let [base, ..] = self.links;
        self.moves(joints).fold(base, |pose, (is_prismatic, joint, link)| pose.then_move(is_prismatic, joint) * *link)
    }

    /// The greatest entry of the difference of the pose from the target, lengths over reach.
    #[inline]
    pub fn residual(&self, joints: &[T; 6], target: &Transform<T>) -> T {
        self.distance(&self.pose(joints), target)
    }

    /// Distance of the pose from the target, and the Jacobian.
    pub fn miss(&self, joints: &[T; 6], target: &Transform<T>) -> Miss<T> {
        let [mut pose, ..] = self.links;
        let mut axes = [([T::ZERO; 3], [T::ZERO; 3]); 6];
        for ((is_prismatic, joint, link), axis) in self.moves(joints).zip(&mut axes) {
            *axis = (pose.z(), pose.translation);
            pose = pose.then_move(is_prismatic, joint) * *link;
        }
        let unit = T::ONE / self.reach;
        let mut jacobian = [[T::ZERO; 6]; 6];
        for (joint, ((axis, point), is_prismatic)) in axes.iter().zip(self.is_prismatic).enumerate() {
            let (linear, angular) = if is_prismatic {
                (*axis, [T::ZERO; 3])
            } else {
                (cross(*axis, difference(pose.translation, *point)), *axis)
            };
            let column = linear.map(|x| x * unit).into_iter().chain(angular);
            jacobian.iter_mut().zip(column).for_each(|(row, entry)| row[joint] = entry);
        }
        let mut turn = [T::ZERO; 3];
        for (axis, wanted) in pose.axes().into_iter().zip(target.axes()) {
            turn.iter_mut().zip(cross(axis, wanted)).for_each(|(sum, x)| *sum += T::HALF * x);
        }
        let [x, y, z] = difference(target.translation, pose.translation).map(|x| x * unit);
        let [u, v, w] = turn;
        Miss { error: [x, y, z, u, v, w], jacobian, residual: self.distance(&pose, target) }
    }

    fn distance(&self, pose: &Transform<T>, target: &Transform<T>) -> T {
        let unit = T::ONE / self.reach;
        let rotations = pose.rotation.iter().flatten().zip(target.rotation.iter().flatten()).map(|(a, b)| *a - *b);
        let lengths = difference(pose.translation, target.translation).map(|x| x * unit);
        let mut greatest = T::ZERO;
        for x in rotations.chain(lengths) {
            // One that is not a number stays.
            greatest = if x.abs() <= greatest { greatest } else { x.abs() };
            if !greatest.is_finite() {
                return greatest;
            }
        }
        greatest
    }

    /// A chain with this pose at every joint vector, whose frames stand near each other.
    ///
    /// A constant displacement along a joint's axis commutes with the joint. So each joint's frame may slide along its
    /// axis, here to the foot of the frame before it. Axes that are nearly parallel have their common normal far away,
    /// and a calibrated table may have displacements of hundreds of meters that cancel. Here they are gone, and the
    /// reach is that of the arm.
    pub fn gathered(&self) -> Self {
        let mut links = self.links;
        for joint in 0..6 {
            let link = links[joint];
            let height = dot(link.translation, link.z());
            links[joint] = link.then_slide(-height);
            links[joint + 1].translation[2] += height;
        }
        Self::new(links, self.is_prismatic)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::math::sin_cos;

    pub(crate) fn tilted(angle: f64, translation: [f64; 3]) -> Transform<f64> {
        let (s, c) = sin_cos(angle);
        Transform { rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]], translation }
            .then_turn(sin_cos(2.0 * angle))
    }

    fn sample() -> Chain<f64> {
        let links = [0.3, -1.0, 0.7, 1.5, -0.4, 0.9, 2.0].map(|x| tilted(x, [0.2 * x, 0.1, 0.3 - x]));
        Chain::new(links, [false, false, true, false, true, false])
    }

    const JOINTS: [f64; 6] = [0.3, -0.8, 0.25, 2.0, -0.1, 1.2];

    #[test]
    fn the_jacobian_is_the_derivative_of_the_error() {
        let chain = sample();
        let target = chain.pose(&JOINTS);
        for joint in 0..6 {
            let mut moved = JOINTS;
            moved[joint] -= 1e-6;
            let error = chain.miss(&moved, &target).error;
            let column = chain.miss(&JOINTS, &target).jacobian.map(|row| row[joint]);
            assert!(error.iter().zip(column).all(|(e, c)| (e - 1e-6 * c).abs() < 1e-11), "{joint}");
        }
    }

    #[test]
    fn gathered_frames_leave_the_pose() {
        let mut far = sample();
        for (joint, height) in [(1, 263.0), (2, -257.0), (4, 12.0)] {
            far.links[joint] = far.links[joint].then_slide(height);
            far.links[joint + 1].translation[2] -= height;
        }
        let (near, target) = (far.gathered(), far.pose(&JOINTS));
        assert!(near.reach < 10.0);
        assert!(near.residual(&JOINTS, &target) < 1e-12);
    }

    #[test]
    fn a_target_that_is_no_number_is_never_near() {
        let chain = sample();
        let mut target = chain.pose(&JOINTS);
        for entry in [f64::NAN, f64::INFINITY] {
            target.rotation[0][0] = entry;
            let is_near = chain.residual(&JOINTS, &target) < 1e9;
            assert!(!is_near);
        }
    }
}
