//! Targets as equations: the residual of a pose, and its derivative by the joints.

use super::kernel::tolerances::Tolerances;
use crate::math::{atan2, wrap};
use crate::vector::{column, cross, dot, norm, sub};
use crate::{Jacobian, JointMask, PlanarPose, PointAngle, PointAxis, Pose, Residual};

/// A target, as the search sees it. An equation that is not asked for is a row of zeros.
pub trait Goal<T, const N: usize> {
    /// Returns true if every number of the target is finite.
    fn is_finite(&self) -> bool;

    /// Position that the tool point has to reach.
    fn point(&self) -> [T; 3];

    /// Residual of the tool's pose at `q`.
    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T>
    where
        Self: Sized;

    /// Residual for the search, where it is small. A rotation by an angle counts by its chord, `2 sin(angle / 2)`.
    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T>;

    /// The error that a step has to undo: three lengths, three angles (small-angle vector).
    fn error(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6];

    /// Turns the geometric Jacobian into the derivative of that error by the joints.
    fn restrict(&self, pose: &Pose<T>, jacobian: &mut Jacobian<T, N>);

    /// The error for targets that are far away: angles count as such, up to half a turn.
    fn twist(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6]
    where
        Self: Sized,
    {
        self.error(q, pose)
    }

    /// The value of the virtual joint for the tool's `pose` near the target, rad: the turn about the tool's axis that leads from its
    /// frame to that of the target. `None` for other targets.
    fn virtual_value(&self, _: &Pose<T>) -> Option<T> {
        None
    }

    /// The joints whose value is given and that nothing may move.
    #[inline]
    fn given(&self) -> JointMask {
        JointMask::NONE
    }

    /// A joint vector with the given joints at their value.
    #[inline]
    fn placed(&self, q: [T; N]) -> [T; N] {
        q
    }
}

/// The whole pose. Its rotation comes from [`nearest_rotation`](super::nearest_rotation): all entries are finite, or
/// none is a number.
impl<T: Tolerances, const N: usize> Goal<T, N> for Pose<T> {
    #[inline]
    fn is_finite(&self) -> bool {
        let [[first, ..], ..] = self.rotation;
        let [x, y, z] = self.translation;
        [first, x, y, z].iter().all(|entry| entry.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        self.translation
    }

    fn residual(&self, _: &[T; N], pose: &Pose<T>) -> Residual<T> {
        Pose::residual(pose, self)
    }

    fn misses(&self, _: &[T; N], pose: &Pose<T>) -> Residual<T> {
        let position = norm(sub(self.translation, pose.translation));
        let rows = self.rotation.iter().zip(&pose.rotation);
        let square = rows.fold(T::ZERO, |sum, (a, b)| {
            let miss = sub(*a, *b);
            sum + dot(miss, miss)
        });
        Residual { position, orientation: (square * T::HALF).sqrt() }
    }

    fn error(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let [x, y, z] = sub(self.translation, pose.translation);
        // The axis of the rotation from `pose` to the goal, times the sine of its angle. This vector is half the sum
        // over the columns of the cross products, the columns of `pose` first. Its entries are half differences of dot
        // products of rows.
        let ([a, b, c], [d, e, f]) = (&pose.rotation, &self.rotation);
        let mut sines = [T::ZERO; 3];
        for (sine, (p, q, r, s)) in sines.iter_mut().zip([(b, f, c, e), (c, d, a, f), (a, e, b, d)]) {
            *sine = (dot(*p, *q) - dot(*r, *s)) * T::HALF;
        }
        let [u, v, w] = sines;
        [x, y, z, u, v, w]
    }

    fn restrict(&self, _: &Pose<T>, _: &mut Jacobian<T, N>) {}

    fn twist(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        pose.error_to(self)
    }
}

/// A point.
impl<T: Tolerances, const N: usize> Goal<T, N> for [T; 3] {
    #[inline]
    fn is_finite(&self) -> bool {
        self.iter().all(|x| x.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        *self
    }

    fn residual(&self, _: &[T; N], pose: &Pose<T>) -> Residual<T> {
        Residual { position: norm(sub(*self, pose.translation)), orientation: T::ZERO }
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.residual(q, pose)
    }

    fn error(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let [x, y, z] = sub(*self, pose.translation);
        [x, y, z, T::ZERO, T::ZERO, T::ZERO]
    }

    fn restrict(&self, _: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        let [_, _, _, turns @ ..] = &mut jacobian.rows;
        *turns = [[T::ZERO; N]; 3];
    }
}

/// A point and the direction of one of the tool's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pointing<T> {
    point: [T; 3],
    direction: [T; 3],
    column: usize,
}

impl<T: Tolerances> Pointing<T> {
    /// `column`: which of the tool's axes points, 0 for x to 2 for z. The direction is normalized.
    #[inline]
    pub fn new(target: &PointAxis<T>, column: usize) -> Self {
        // Scaled first, so that squares neither overflow nor vanish.
        let [x, y, z] = target.axis;
        let largest = x.abs().max(y.abs()).max(z.abs());
        let [x, y, z] = target.axis.map(|e| e / largest);
        let k = T::ONE / norm([x, y, z]);
        let short = !(largest >= T::from_f64(1e-12));
        let direction = [x * k, y * k, z * k].map(|e| if short { T::NAN } else { e });
        Pointing { point: target.point, direction, column }
    }

    /// A frame at the target whose z axis is the direction; its turn about that axis is arbitrary.
    #[inline]
    pub fn frame(&self) -> Pose<T> {
        let [x, y, z] = self.direction;
        // Two unit vectors across: Frisvad 2012 with the sign of z (Duff et al. 2017), which never divides by zero.
        let sign = if z < T::ZERO { -T::ONE } else { T::ONE };
        let a = -T::ONE / (sign + z);
        let b = x * y * a;
        let u = [T::ONE + sign * x * x * a, sign * b, -sign * x];
        let v = [b, sign + y * y * a, -y];
        let [[ux, uy, uz], [vx, vy, vz]] = [u, v];
        Pose { rotation: [[ux, vx, x], [uy, vy, y], [uz, vz, z]], translation: self.point }
    }
}

impl<T: Tolerances, const N: usize> Goal<T, N> for Pointing<T> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.point.iter().chain(&self.direction).all(|x| x.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        self.point
    }

    fn residual(&self, _: &[T; N], pose: &Pose<T>) -> Residual<T> {
        let axis = column(&pose.rotation, self.column);
        let orientation = atan2(norm(cross(axis, self.direction)), dot(axis, self.direction));
        Residual { position: norm(sub(self.point, pose.translation)), orientation }
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.residual(q, pose)
    }

    fn error(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let [x, y, z] = sub(self.point, pose.translation);
        let [u, v, w] = cross(column(&pose.rotation, self.column), self.direction);
        [x, y, z, u, v, w]
    }

    fn restrict(&self, pose: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        let [_, _, _, u, v, w] = &mut jacobian.rows;
        let axis = column(&pose.rotation, self.column);
        let [ax, ay, az] = axis;
        // A turn about the axis itself changes nothing.
        for ((u, v), w) in u.iter_mut().zip(v).zip(w) {
            let about = dot(axis, [*u, *v, *w]);
            (*u, *v, *w) = (*u - about * ax, *v - about * ay, *w - about * az);
        }
    }

    fn virtual_value(&self, pose: &Pose<T>) -> Option<T> {
        // The axis across that the generator takes for x, see `onto_z` there.
        let across = match self.column {
            0 => column(&pose.rotation, 2).map(|part| -part),
            _ => column(&pose.rotation, 0),
        };
        let Pose { rotation, .. } = self.frame();
        Some(atan2(-dot(across, column(&rotation, 1)), dot(across, column(&rotation, 0))))
    }

    fn twist(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let [x, y, z, turns @ ..] = self.error(q, pose);
        let sine = norm(turns);
        let angle = atan2(sine, dot(column(&pose.rotation, self.column), self.direction));
        // Opposite directions have no axis between them: any across will do, of which `frame` has one.
        let [u, v, w] = match sine > T::EPSILON {
            true => turns.map(|part| part * (angle / sine)),
            false if angle > T::ONE => column(&self.frame().rotation, 0).map(|part| part * angle),
            false => turns,
        };
        [x, y, z, u, v, w]
    }
}

/// A point and the sum of the pitch joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InPlane<T, const N: usize> {
    target: PointAngle<T>,
    signs: [T; N],
    offset: T,
}

impl<T: Tolerances, const N: usize> InPlane<T, N> {
    /// The angle is the sum of the joints by `signs` (0 for joints that do not count), plus `offset`.
    #[inline]
    pub fn new(target: &PointAngle<T>, signs: [T; N], offset: T) -> Self {
        InPlane { target: target.wrapped(), signs, offset }
    }

    fn missing(&self, q: &[T; N]) -> T {
        wrap(q.iter().zip(&self.signs).fold(self.target.angle - self.offset, |left, (q, sign)| left - *q * *sign))
    }
}

impl<T: Tolerances, const N: usize> Goal<T, N> for InPlane<T, N> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.target.angle.is_finite() && self.target.point.iter().all(|x| x.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        self.target.point
    }

    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        let position = norm(sub(self.target.point, pose.translation));
        Residual { position, orientation: self.missing(q).abs() }
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.residual(q, pose)
    }

    fn error(&self, q: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let [x, y, z] = sub(self.target.point, pose.translation);
        [x, y, z, self.missing(q), T::ZERO, T::ZERO]
    }

    fn restrict(&self, _: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        let [_, _, _, turns @ ..] = &mut jacobian.rows;
        *turns = [self.signs, [T::ZERO; N], [T::ZERO; N]];
    }
}

/// A pose in the plane.
impl<T: Tolerances, const N: usize> Goal<T, N> for PlanarPose<T> {
    #[inline]
    fn is_finite(&self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.phi.is_finite()
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        [self.x, self.y, T::ZERO]
    }

    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        let [x, y, _, turn, ..] = self.error(q, pose);
        Residual { position: norm([x, y, T::ZERO]), orientation: turn.abs() }
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.residual(q, pose)
    }

    fn error(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let ([x, y, _], [[c, ..], [s, ..], _]) = (pose.translation, pose.rotation);
        [self.x - x, self.y - y, T::ZERO, wrap(wrap(self.phi) - atan2(s, c)), T::ZERO, T::ZERO]
    }

    fn restrict(&self, _: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        let ([_, _, rest @ ..], none) = (&mut jacobian.rows, [T::ZERO; N]);
        let [.., turn] = *rest;
        *rest = [none, turn, none, none];
    }
}

/// A point in the plane.
impl<T: Tolerances, const N: usize> Goal<T, N> for [T; 2] {
    #[inline]
    fn is_finite(&self) -> bool {
        self.iter().all(|x| x.is_finite())
    }

    #[inline]
    fn point(&self) -> [T; 3] {
        let [x, y] = *self;
        [x, y, T::ZERO]
    }

    fn residual(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        let [x, y, ..] = Goal::<T, N>::error(self, q, pose);
        Residual { position: norm([x, y, T::ZERO]), orientation: T::ZERO }
    }

    fn misses(&self, q: &[T; N], pose: &Pose<T>) -> Residual<T> {
        self.residual(q, pose)
    }

    fn error(&self, _: &[T; N], pose: &Pose<T>) -> [T; 6] {
        let ([tx, ty], [x, y, _]) = (*self, pose.translation);
        [tx - x, ty - y, T::ZERO, T::ZERO, T::ZERO, T::ZERO]
    }

    fn restrict(&self, _: &Pose<T>, jacobian: &mut Jacobian<T, N>) {
        let [_, _, rest @ ..] = &mut jacobian.rows;
        *rest = [[T::ZERO; N]; 4];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::sin_cos;

    #[test]
    fn a_virtual_joint_turns_the_tool_to_the_frame_of_the_target() {
        for direction in [[0.0, 0.0, 1.0], [0.6, -0.8, 0.0], [0.1, 0.2, -0.7]] {
            for value in [-2.0, -0.5, 0.0, 1.0, 3.0] {
                let frame = Pointing::new(&PointAxis { point: [0.0; 3], axis: direction }, 2).frame();
                let [x, y, z] = [0, 1, 2].map(|k| column(&frame.rotation, k));
                let (sin, cos) = sin_cos(value);
                // The frame turned back by the value: the tool's frame with the axis as z.
                let across = [0, 1, 2].map(|k| x[k] * cos - y[k] * sin);
                let other = [0, 1, 2].map(|k| x[k] * sin + y[k] * cos);
                let negative = |v: [f64; 3]| v.map(|part| -part);
                let tools = [[z, other, negative(across)], [across, z, negative(other)], [across, other, z]];
                for (index, tool) in tools.into_iter().enumerate() {
                    let rotation = [0, 1, 2].map(|row| tool.map(|axis| axis[row]));
                    let goal = Pointing::new(&PointAxis { point: [0.0; 3], axis: direction }, index);
                    let pose = Pose { rotation, translation: [0.0; 3] };
                    let told = Goal::<f64, 1>::virtual_value(&goal, &pose);
                    assert!(
                        told.is_some_and(|told| (told - value).abs() < 1e-12),
                        "{index} {direction:?} {value} {told:?}"
                    );
                }
            }
        }
    }
}
