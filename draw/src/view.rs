//! Directions from which an arm is seen, and the way from space into the picture.

use denhart_dynamic::DynamicArm;

use crate::skeleton::Skeleton;
use crate::vector::{Flat, Vector, dot};

/// Turn of the camera about z and its height above the xy plane in the view `iso`, degrees. They are those of no drawing
/// by isometric rules: there, links at right angles would cover each other.
const ISO: [f64; 2] = [-58.0, 24.0];

/// Direction from which an arm is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum View {
    /// From the tip of the x axis: y to the right, z up.
    Front,
    /// From below the x axis (from -y): x to the right, z up.
    Side,
    /// From above: x to the right, y up.
    Top,
    /// From the right in front, a little above: z up.
    Iso,
}

impl View {
    /// The view that shows most of an arm: `Top` if all joints turn about, and slide at right angles to, the base z axis;
    /// else `Iso`.
    ///
    /// An arm that answers no joint values of 0 is seen in `Iso`.
    #[must_use]
    pub fn of(arm: &DynamicArm) -> Self {
        let Ok(skeleton) = Skeleton::of(arm, &vec![0.0; arm.joints()]) else { return View::Iso };
        let planar = skeleton.joints.iter().all(|joint| {
            let [x, y, z] = joint.axis;
            match joint.kind {
                denhart::JointKind::Prismatic => z.abs() < 1e-9,
                _ => x.abs() < 1e-9 && y.abs() < 1e-9,
            }
        });
        if planar { View::Top } else { View::Iso }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            View::Front => "front",
            View::Side => "side",
            View::Top => "top",
            View::Iso => "iso",
        }
    }

    /// Directions to the right, up, and toward the viewer.
    #[must_use]
    pub fn axes(self) -> [Vector; 3] {
        match self {
            View::Front => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
            View::Side => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
            View::Top => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            View::Iso => {
                let ((sa, ca), (se, ce)) = (ISO[0].to_radians().sin_cos(), ISO[1].to_radians().sin_cos());
                [[-sa, ca, 0.0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]]
            }
        }
    }
}

/// A view with its scale and place in the picture.
#[derive(Debug, Clone, Copy)]
pub struct Camera {
    right: Vector,
    up: Vector,
    /// Direction toward the viewer.
    pub toward: Vector,
    /// Pixels of a length unit.
    pub scale: f64,
    origin: Flat,
}

impl Camera {
    /// The camera that brings all points into a rectangle, at the largest scale at which they fit.
    pub fn fit(view: View, points: impl Iterator<Item = Vector> + Clone, [left, top, width, height]: [f64; 4]) -> Self {
        let [right, up, toward] = view.axes();
        let range = |axis: Vector| {
            let along = points.clone().map(|point| dot(point, axis));
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let ([x0, x1], [y0, y1]) = (range(right), range(up));
        let fits = |pixels: f64, length: f64| if length > 0.0 { pixels / length } else { f64::INFINITY };
        let scale = fits(width, x1 - x0).min(fits(height, y1 - y0));
        // All points are one: any scale shows it.
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        let origin = [left + 0.5 * (width - scale * (x0 + x1)), top + 0.5 * (height + scale * (y0 + y1))];
        Camera { right, up, toward, scale, origin }
    }

    /// The place of a point in the picture.
    pub fn place(&self, point: Vector) -> Flat {
        let [x, y] = self.direction(point);
        let [left, top] = self.origin;
        [left + self.scale * x, top + self.scale * y]
    }

    /// A direction in the picture: of a unit vector at most of length 1.
    pub fn direction(&self, vector: Vector) -> Flat {
        [dot(vector, self.right), -dot(vector, self.up)]
    }

    /// How near a point is to the viewer, length unit.
    pub fn depth(&self, point: Vector) -> f64 {
        dot(point, self.toward)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::{cross, distance};

    #[test]
    fn the_directions_are_right_handed() {
        for view in [View::Front, View::Side, View::Top, View::Iso] {
            let [right, up, toward] = view.axes();
            assert!(distance(cross(right, up), toward) < 1e-15, "{view:?}");
            assert!((dot(up, up) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn points_fill_the_rectangle() {
        let points = [[0.0; 3], [2.0, 0.0, 1.0]];
        let camera = Camera::fit(View::Side, points.into_iter(), [10.0, 20.0, 200.0, 400.0]);
        assert_eq!(camera.place([0.0; 3]), [10.0, 270.0]);
        assert_eq!(camera.place([2.0, 5.0, 1.0]), [210.0, 170.0]);
        let one = Camera::fit(View::Iso, [[0.0; 3]].into_iter(), [0.0, 0.0, 100.0, 100.0]);
        assert_eq!(one.place([0.0; 3]), [50.0, 50.0]);
    }
}
