//! The part of a plane that the tool reaches within the limits of the joints, and the singular postures in it.

use denhart::JointKind;
use denhart_dynamic::DynamicArm;

use crate::DrawError;
use crate::contour::{contours, smoothed};
use crate::skeleton::Skeleton;
use crate::vector::{Flat, Vector};
use crate::view::View;

/// A section: in the plane `y = 0`, `x = 0` or `z = height` of the base frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// The region, as closed lines; holes are lines of their own.
    pub region: Vec<Vec<Vector>>,
    /// Curves on which the arm is singular.
    pub singular: Vec<Curves>,
    /// The plane in words.
    pub plane: String,
}

/// Curves on which one margin of an arm is 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// Name of the margin.
    pub margin: String,
    /// The curves.
    pub lines: Vec<Vec<Vector>>,
}

/// Cells of the raster along the longer side.
const CELLS: usize = 96;
/// Postures that are tried.
const POSTURES: u32 = 200_000;
/// Steps of two joints over their ranges for the singular curves.
const STEPS: usize = 72;
/// Bases in which postures are spread, one for each joint.
const BASES: [u32; 10] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29];
/// A turn without limits, or with wider ones, is half a turn either way.
const TURN: f64 = std::f64::consts::PI;

/// The plane of a section, and where its points lie in it.
#[derive(Clone, Copy)]
enum Plane {
    /// Through the base's z axis, the x axis to the right; false for the y axis.
    Upright(bool),
    /// At a height.
    Level(f64),
}

impl Plane {
    /// The point of the plane that a tool point turns to about the base's z axis, or comes to lie in: with the turn.
    fn turned(self, [x, y, z]: Vector) -> [(Flat, f64); 2] {
        let radius = x.hypot(y);
        let to_axis = match self {
            Plane::Upright(true) => -y.atan2(x),
            _ => std::f64::consts::FRAC_PI_2 - y.atan2(x),
        };
        [([radius, z], to_axis), ([-radius, z], to_axis + std::f64::consts::PI)]
    }

    /// Place in the plane, and distance from it.
    fn place(self, [x, y, z]: Vector) -> (Flat, f64) {
        match self {
            Plane::Upright(true) => ([x, z], y),
            Plane::Upright(false) => ([y, z], x),
            Plane::Level(height) => ([x, y], z - height),
        }
    }

    fn point(self, [u, v]: Flat) -> Vector {
        match self {
            Plane::Upright(true) => [u, 0.0, v],
            Plane::Upright(false) => [0.0, u, v],
            Plane::Level(height) => [u, v, height],
        }
    }

    fn words(self, unit: &str) -> String {
        match self {
            Plane::Upright(true) => "plane y = 0".to_owned(),
            Plane::Upright(false) => "plane x = 0".to_owned(),
            Plane::Level(height) => format!("plane z = {} {unit}", crate::number::short(height)),
        }
    }
}

/// Parts of a whole, spread evenly: the radical inverse of `index` in a base.
pub fn spread(mut index: u32, base: u32) -> f64 {
    let (mut value, mut part) = (0.0, 1.0);
    while index > 0 {
        part /= f64::from(base);
        value += part * f64::from(index % base);
        index /= base;
    }
    value
}

/// A raster over a part of a plane.
struct Raster {
    low: Flat,
    cell: f64,
    columns: usize,
    rows: usize,
    hit: Vec<bool>,
}

impl Raster {
    fn over(points: &[Flat]) -> Option<Self> {
        let range = |axis: usize| {
            let values = points.iter().map(|point| point.get(axis).copied().unwrap_or(0.0));
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let ([x0, x1], [y0, y1]) = (range(0), range(1));
        let size = (x1 - x0).max(y1 - y0);
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let cell = size / CELLS as f64;
        // Two empty cells all around close every outline.
        let cells = |length: f64| (length / cell).ceil() as usize + 5;
        let (columns, rows) = (cells(x1 - x0), cells(y1 - y0));
        let low = [x0 - 2.0 * cell, y0 - 2.0 * cell];
        Some(Raster { low, cell, columns, rows, hit: vec![false; columns * rows] })
    }

    fn mark(&mut self, [x, y]: Flat) {
        let [left, bottom] = self.low;
        let (column, row) = (((x - left) / self.cell) as usize, ((y - bottom) / self.cell) as usize);
        if column < self.columns
            && let Some(hit) = self.hit.get_mut(row * self.columns + column)
        {
            *hit = true;
        }
    }

    fn at(&self, column: usize, row: usize) -> bool {
        column < self.columns && self.hit.get(row * self.columns + column).copied().unwrap_or(false)
    }

    /// Grows the region by a cell, or shrinks it by one.
    fn grown(&self, grow: bool) -> Vec<bool> {
        let cell = |index: usize| {
            let (column, row) = (index % self.columns, index / self.columns);
            let mut around = [0, 1, 2].into_iter().flat_map(|i| [0, 1, 2].map(|j| (i, j)));
            let hit = |(i, j): (usize, usize)| {
                (column + i).checked_sub(1).zip((row + j).checked_sub(1)).is_some_and(|(c, r)| self.at(c, r))
            };
            if grow { around.any(hit) } else { around.all(hit) }
        };
        (0..self.hit.len()).map(cell).collect()
    }

    /// Fills gaps that are narrower than two cells.
    fn closed(mut self) -> Self {
        self.hit = self.grown(true);
        self.hit = self.grown(false);
        self
    }

    /// The outlines, by way of the middles between cells that are hit and cells that are not.
    fn outlines(&self) -> Vec<Vec<Flat>> {
        let field = |column: usize, row: usize| if self.at(column, row) { 1.0 } else { -1.0 };
        let middle = |[x, y]: Flat| [self.low[0] + (x + 0.5) * self.cell, self.low[1] + (y + 0.5) * self.cell];
        let lines = contours(self.columns, self.rows, &field);
        lines.into_iter().map(|line| smoothed(&line).into_iter().map(middle).collect()).collect()
    }
}

/// The section in the plane of a view: `Side` and `Iso` have the xz plane, `Front` has the yz plane, `Top` the plane at the
/// height of the tool at `q`.
///
/// The region is found by postures spread evenly over the limits; a slide without an end stays at `q`. The singular curves
/// hold all joints at `q` but two, and the first one where it turns the arm about the base's z axis.
///
/// # Errors
/// As of [`Skeleton::of`].
pub fn section(arm: &DynamicArm, q: &[f64], view: View) -> Result<Section, DrawError> {
    let skeleton = Skeleton::of(arm, q)?;
    let [_, _, height] = skeleton.tool.translation;
    let plane = match view {
        View::Front => Plane::Upright(false),
        View::Top => Plane::Level(height),
        View::Side | View::Iso => Plane::Upright(true),
    };
    let ways = Ways { arm, q, plane, turns: turns_about_base(&skeleton), ranges: ranges(arm, q) };
    let raster = ways.region();
    let outlines = raster.as_ref().map(Raster::outlines).unwrap_or_default();
    let in_space = |line: Vec<Flat>| line.into_iter().map(|point| plane.point(point)).collect();
    let unit = arm.length_unit().to_string();
    Ok(Section {
        region: outlines.into_iter().map(in_space).collect(),
        singular: ways.singular()?,
        plane: plane.words(&unit),
    })
}

/// The values that each joint takes.
fn ranges(arm: &DynamicArm, q: &[f64]) -> Vec<[f64; 2]> {
    let joints = arm.joint_kinds().iter().zip(arm.limits()).zip(q);
    joints
        .map(|((kind, [low, high]), q)| match kind {
            JointKind::Revolute if high - low >= 2.0 * TURN => [-TURN, TURN],
            JointKind::Prismatic if !(high - low).is_finite() => [*q, *q],
            _ => [*low, *high],
        })
        .collect()
}

/// True if joint 1 turns about the base's z axis: then it brings every tool point into an upright plane.
fn turns_about_base(skeleton: &Skeleton) -> bool {
    skeleton.joints.first().is_some_and(|joint| {
        let ([x, y, _], [u, v, _]) = (joint.point, joint.axis);
        let small = 1e-9 * (1.0 + skeleton.size());
        joint.kind == JointKind::Revolute && u.hypot(v) < 1e-9 && x.hypot(y) < small
    })
}

/// The ways of an arm into a plane.
struct Ways<'a> {
    arm: &'a DynamicArm,
    q: &'a [f64],
    plane: Plane,
    /// Joint 1 brings every tool point into the plane.
    turns: bool,
    ranges: Vec<[f64; 2]>,
}

impl Ways<'_> {
    /// The first joint that is not used to come into the plane.
    fn first(&self) -> usize {
        usize::from(self.turns && matches!(self.plane, Plane::Upright(_)))
    }

    /// Places in the plane of a posture's tool point. Joint 1 stands at 0 where it turns into the plane.
    fn places(&self, q: &[f64], slab: f64) -> [Option<Flat>; 2] {
        let Ok(pose) = self.arm.forward(q) else { return [None; 2] };
        if self.first() == 0 {
            let (place, off) = self.plane.place(pose.translation);
            return [(off.abs() <= slab).then_some(place), None];
        }
        let [low, high] = self.arm.limits().first().copied().unwrap_or([-TURN, TURN]);
        // The axis of joint 1 may point down: then it turns the other way.
        let upward = self.arm.jacobian(q).is_ok_and(|[.., wz]| wz.first().is_some_and(|wz| *wz > 0.0));
        let allowed = |turn: f64| {
            let turn = if upward { turn } else { -turn };
            let turns = [turn - 2.0 * TURN, turn, turn + 2.0 * TURN];
            turns.iter().any(|turn| (low - 1e-9..=high + 1e-9).contains(turn))
        };
        self.plane.turned(pose.translation).map(|(place, turn)| allowed(turn).then_some(place))
    }

    /// The raster of the region; `None` where the tool has one place, or none in the plane.
    fn region(&self) -> Option<Raster> {
        let mut points = Vec::new();
        let size = Skeleton::of(self.arm, self.q).ok()?.size();
        // A slab for arms that do not turn into the plane. In a plane of all motions it leaves nothing out.
        let slab = 0.01 * size;
        let mut q = self.q.to_vec();
        for posture in 1..=POSTURES {
            let mut bases = BASES.iter();
            for (joint, (q, [low, high])) in q.iter_mut().zip(&self.ranges).enumerate() {
                if joint < self.first() {
                    *q = 0.0;
                } else if let Some(base) = bases.next() {
                    *q = low + (high - low) * edged(spread(posture, *base));
                }
            }
            points.extend(self.places(&q, slab).into_iter().flatten().filter(|[x, y]| (x + y).is_finite()));
        }
        let mut raster = Raster::over(&points)?;
        for point in points {
            raster.mark(point);
        }
        Some(raster.closed())
    }

    /// Curves in the plane on which a margin is 0, by the name of the margin.
    fn singular(&self) -> Result<Vec<Curves>, DrawError> {
        let (i, j) = (self.first(), self.first() + 1);
        let (Some(across), Some(along)) = (self.ranges.get(i), self.ranges.get(j)) else { return Ok(Vec::new()) };
        let at = |[u, v]: Flat| {
            let mut q = self.q.to_vec();
            let values = [(i, u, across), (j, v, along)];
            for (joint, step, [low, high]) in values {
                if let Some(q) = q.get_mut(joint) {
                    // A step beyond each end of a whole turn: a singularity at the end is a change of sign there.
                    let beyond = if high - low >= 2.0 * TURN { 1.0 } else { 0.0 };
                    let part = (step - beyond) / (STEPS as f64 - 1.0 - 2.0 * beyond);
                    *q = low + (high - low) * part;
                }
            }
            if let Some(first) = q.first_mut().filter(|_| self.first() > 0) {
                *first = 0.0;
            }
            q
        };
        let mut fields: Vec<(String, Vec<f64>)> = Vec::new();
        for index in 0..STEPS * STEPS {
            let q = at([(index % STEPS) as f64, (index / STEPS) as f64]);
            for (number, margin) in self.arm.margins(&q)?.unwrap_or_default().into_iter().enumerate() {
                if fields.len() <= number {
                    fields.push((margin.name, Vec::new()));
                }
                // Rounding changes no sign.
                let value = if margin.value.abs() < 1e-10 { 0.0 } else { margin.value };
                if let Some((_, values)) = fields.get_mut(number) {
                    values.push(value);
                }
            }
        }
        let mut singular = Vec::new();
        for (name, values) in fields {
            let field = |column: usize, row: usize| values.get(row * STEPS + column).copied().unwrap_or(f64::NAN);
            let mut curves = Vec::new();
            for line in contours(STEPS, STEPS, &field) {
                // Where joint 1 may not turn there, the curve is cut.
                let mut parts: [Vec<Vector>; 2] = [Vec::new(), Vec::new()];
                for step in line {
                    for (part, place) in parts.iter_mut().zip(self.places(&at(step), f64::INFINITY)) {
                        match place {
                            Some(place) => part.push(self.plane.point(place)),
                            None => curves.push(std::mem::take(part)),
                        }
                    }
                }
                curves.extend(parts);
            }
            curves.retain(|curve| curve.len() > 1);
            if !curves.is_empty() {
                singular.push(Curves { margin: name, lines: curves });
            }
        }
        Ok(singular)
    }
}

/// A part of a range, with a little more at both ends, where the outline is.
fn edged(part: f64) -> f64 {
    (1.08 * part - 0.04).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::vector::length;

    #[test]
    fn two_links_reach_a_ring_between_their_singular_circles() {
        let text = "name: a\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n  - {a: 0.5, alpha: 0, d: 0, \
                    theta: 0}\n  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n";
        let arm = DynamicArm::from_yaml(text).unwrap();
        let section = section(&arm, &[0.3, 0.8], View::Top).unwrap();
        assert_eq!(section.region.len(), 2, "an outline and a hole");
        let cell = 1.6 / CELLS as f64;
        for point in section.region.iter().flatten() {
            let radius = length(*point);
            assert!((radius - 0.8).abs() < 2.0 * cell || (radius - 0.2).abs() < 2.0 * cell, "{radius}");
        }
        let [Curves { lines: curves, .. }] = section.singular.as_slice() else {
            unreachable!("{:?}", section.singular)
        };
        for point in curves.iter().flatten() {
            let radius = length(*point);
            assert!((radius - 0.8).abs() < 1e-3 || (radius - 0.2).abs() < 1e-3, "{radius}");
        }
    }

    #[test]
    fn an_arm_in_a_plane_at_right_angles_has_no_region() {
        let text = "name: a\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n  - {type: prismatic, a: 0, \
                    alpha: 0, d: 0, theta: 0}\n";
        let arm = DynamicArm::from_yaml(text).unwrap();
        assert!(section(&arm, &[0.0], View::Side).unwrap().region.is_empty());
    }
}
