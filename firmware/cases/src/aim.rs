//! Targets of every task.

use denhart::{PlanarPose, PointAngle, PointAxis, Pose, Scalar};

/// A target: made from a pose of the tool, moved, and its numbers changed.
pub trait Aim<T: Scalar>: Copy {
    /// All zeros.
    const BLANK: Self;
    /// How many candidates [`Aim::at`] has for a pose.
    const CANDIDATES: usize = 1;
    /// The target at `pose`, one of the candidates. A pose alone does not determine which axis of the tool an arm
    /// points. Nor does a pose determine how an arm counts the angle in its own plane. `angle`: how far candidate 0
    /// misses in orientation, rad; `given`: the value of the joint that comes with the target.
    fn at(pose: &Pose<T>, candidate: usize, angle: T, given: T) -> Self;
    /// Its point times `factor`.
    fn pushed(self, factor: T) -> Self;
    /// Each of its numbers changed by `change`, the point's last.
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self;
}

impl<T: Scalar> Aim<T> for Pose<T> {
    const BLANK: Self = Pose { rotation: [[T::ZERO; 3]; 3], translation: [T::ZERO; 3] };
    fn at(pose: &Pose<T>, _: usize, _: T, _: T) -> Self {
        *pose
    }
    fn pushed(self, factor: T) -> Self {
        Pose { translation: self.translation.map(|x| x * factor), ..self }
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        Pose { rotation: self.rotation.map(|row| row.map(&mut *change)), translation: self.translation.map(change) }
    }
}

impl<T: Scalar> Aim<T> for [T; 3] {
    const BLANK: Self = [T::ZERO; 3];
    fn at(pose: &Pose<T>, _: usize, _: T, _: T) -> Self {
        pose.translation
    }
    fn pushed(self, factor: T) -> Self {
        self.map(|x| x * factor)
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        self.map(change)
    }
}

impl<T: Scalar> Aim<T> for [T; 2] {
    const BLANK: Self = [T::ZERO; 2];
    fn at(pose: &Pose<T>, _: usize, _: T, _: T) -> Self {
        let [x, y, _] = pose.translation;
        [x, y]
    }
    fn pushed(self, factor: T) -> Self {
        self.map(|x| x * factor)
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        self.map(change)
    }
}

impl<T: Scalar> Aim<T> for PlanarPose<T> {
    const BLANK: Self = PlanarPose { x: T::ZERO, y: T::ZERO, phi: T::ZERO };
    fn at(pose: &Pose<T>, _: usize, _: T, _: T) -> Self {
        let ([x, y, _], [[cos, ..], [sin, ..], _]) = (pose.translation, pose.rotation);
        PlanarPose { x, y, phi: sin.atan2(cos) }
    }
    fn pushed(self, factor: T) -> Self {
        PlanarPose { x: self.x * factor, y: self.y * factor, ..self }
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        PlanarPose { phi: change(self.phi), x: change(self.x), y: change(self.y) }
    }
}

impl<T: Scalar> Aim<T> for PointAngle<T> {
    const BLANK: Self = PointAngle { point: [T::ZERO; 3], angle: T::ZERO };
    const CANDIDATES: usize = 3;
    fn at(pose: &Pose<T>, candidate: usize, angle: T, _: T) -> Self {
        let angle = match candidate {
            0 => T::ZERO,
            1 => angle,
            _ => -angle,
        };
        PointAngle { point: pose.translation, angle }
    }
    fn pushed(self, factor: T) -> Self {
        PointAngle { point: self.point.map(|x| x * factor), ..self }
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        PointAngle { angle: change(self.angle), point: self.point.map(change) }
    }
}

impl<T: Scalar> Aim<T> for PointAxis<T> {
    const BLANK: Self = PointAxis { point: [T::ZERO; 3], axis: [T::ZERO; 3] };
    const CANDIDATES: usize = 3;
    fn at(pose: &Pose<T>, candidate: usize, _: T, _: T) -> Self {
        let axis = pose.rotation.map(|[x, y, z]| match candidate {
            0 => x,
            1 => y,
            _ => z,
        });
        PointAxis { point: pose.translation, axis }
    }
    fn pushed(self, factor: T) -> Self {
        PointAxis { point: self.point.map(|x| x * factor), ..self }
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        PointAxis { axis: self.axis.map(&mut *change), point: self.point.map(change) }
    }
}

impl<T: Scalar, G: Aim<T>> Aim<T> for (G, T) {
    const BLANK: Self = (G::BLANK, T::ZERO);
    const CANDIDATES: usize = G::CANDIDATES;
    fn at(pose: &Pose<T>, candidate: usize, angle: T, given: T) -> Self {
        (G::at(pose, candidate, angle, given), given)
    }
    fn pushed(self, factor: T) -> Self {
        (self.0.pushed(factor), self.1)
    }
    fn changed(self, change: &mut dyn FnMut(T) -> T) -> Self {
        (self.0.changed(change), change(self.1))
    }
}

impl<T: Scalar> Aim<T> for () {
    const BLANK: Self = ();
    fn at(_: &Pose<T>, _: usize, _: T, _: T) -> Self {}
    fn pushed(self, _: T) -> Self {}
    fn changed(self, _: &mut dyn FnMut(T) -> T) -> Self {}
}
