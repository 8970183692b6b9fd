//! The geometry of an arm at joint values: joints, links between them, frames and lengths of its table.

use denhart::{JointKind, Pose};
use denhart_codegen::model::{self, Convention, Frame, Length, Model, Row, RowKind};
use denhart_dynamic::DynamicArm;

use crate::DrawError;
use crate::vector::{Vector, distance, length, moved, nearest_on_line};

/// Points of the table farther from the arm than this many sizes of the arm are not drawn, and no joint stands there: those of
/// nearly parallel axes. Size is measured along the shortest way over all axes, which has no column of a SCARA arm.
const FAR: f64 = 2.0;

/// Corners closer than this part of their distance from the origin are one.
const SAME: f64 = 1e-12;

/// A joint of an arm in one posture.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Name in the arm file.
    pub name: String,
    /// Revolute or prismatic.
    pub kind: JointKind,
    /// The point of the table where the joint's row begins to move along the axis; where that is far from the arm, the point
    /// of the axis nearest to the point of the joint before.
    pub point: Vector,
    /// Unit direction of the positive motion.
    pub axis: Vector,
    /// Joint value, rad or length unit.
    pub value: f64,
}

/// A frame of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedFrame {
    /// Number of the row that ends in it; 0 is the frame before the first row.
    pub name: String,
    /// Its pose in the base frame.
    pub pose: Pose<f64>,
}

/// A length of the table between two points.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// `a2`, `d4`: the key and the number of the row; `base` and `tool` with the axis of the frame.
    pub name: String,
    /// Length as in the table, with its sign; of a slide without the joint value.
    pub value: f64,
    /// Start of the length.
    pub from: Vector,
    /// End of the length.
    pub to: Vector,
}

/// An arm in one posture.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    /// The joints in order.
    pub joints: Vec<Joint>,
    /// Corners of each link: from the origin to joint 1, from each joint to the next one, from the last one to the tool.
    pub links: Vec<Vec<Vector>>,
    /// Frames of the table, that before the first row first.
    pub frames: Vec<NamedFrame>,
    /// Lengths of the table that are not 0.
    pub measures: Vec<Measure>,
    /// The tool frame.
    pub tool: Pose<f64>,
    /// Names of frames and lengths that lie too far from the arm to be drawn.
    pub far: Vec<String>,
}

/// The column of a pose: direction of its x, y or z axis.
pub(crate) fn column(pose: &Pose<f64>, index: usize) -> Vector {
    pose.rotation.map(|row| row.get(index).copied().unwrap_or(0.0))
}

impl Skeleton {
    /// The arm at joint values, rad or length unit.
    ///
    /// # Errors
    /// Another number of joint values, one that is not finite, points that are not.
    pub fn of(arm: &DynamicArm, q: &[f64]) -> Result<Self, DrawError> {
        // Counts the joint values.
        arm.forward(q)?;
        if let Some((joint, value)) = (1..).zip(q).find(|(_, value)| !value.is_finite()) {
            return Err(DrawError::NotFinite { joint, value: *value });
        }
        let walked = |size: f64| {
            let mut walk = Walk::new(arm.model(), size);
            for (number, row) in (1..).zip(&arm.model().rows) {
                walk.row(number, row, arm.model(), q);
            }
            walk.finish(arm.model())
        };
        // The size of the arm, by points that are near each other, tells which points of the table are near.
        let size = walked(0.0).size();
        let skeleton = walked(size);
        let finite = |point: &Vector| point.iter().all(|x| x.is_finite());
        if skeleton.points().all(finite) { Ok(skeleton) } else { Err(DrawError::TooLarge) }
    }

    /// Corners of all links.
    pub fn points(&self) -> impl Iterator<Item = &Vector> + Clone {
        self.links.iter().flatten()
    }

    /// The largest distance of a corner from the origin.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.points().map(|point| length(*point)).fold(0.0, f64::max)
    }
}

/// The way along the rows of a table.
struct Walk {
    pose: Pose<f64>,
    /// Size of the arm.
    size: f64,
    /// The point of the last joint.
    before: Vector,
    joints: Vec<Joint>,
    links: Vec<Vec<Vector>>,
    frames: Vec<NamedFrame>,
    measures: Vec<Measure>,
}

fn constant(frame: &Frame) -> Pose<f64> {
    Pose::from_xyz_rpy(frame.xyz.each_ref().map(Length::default_value), frame.rpy.map(|angle| angle.rad()))
}

impl Walk {
    fn new(model: &Model, size: f64) -> Self {
        let mut walk = Walk {
            pose: Pose::identity(),
            size,
            before: [0.0; 3],
            joints: Vec::new(),
            links: Vec::new(),
            frames: Vec::new(),
            measures: Vec::new(),
        };
        walk.constant_frame("base", &model.base);
        walk.frames.push(NamedFrame { name: "0".to_owned(), pose: walk.pose });
        walk
    }

    /// Base or tool: one length along an axis is measured, a displacement along several ones is named by its components.
    fn constant_frame(&mut self, name: &str, frame: &Frame) {
        let from = self.pose;
        self.pose = self.pose.compose(&constant(frame));
        let xyz = frame.xyz.each_ref().map(Length::default_value);
        let mut corner = from.translation;
        for (index, (value, axis)) in xyz.into_iter().zip(["x", "y", "z"]).enumerate() {
            if value != 0.0 {
                let to = moved(corner, column(&from, index), value);
                self.measures.push(Measure { name: format!("{name} {axis}"), value, from: corner, to });
                corner = to;
            }
        }
    }

    /// A turn about z and a displacement along it by `value`, then by `slide` of a sliding joint; or both along x.
    fn screw(&mut self, name: String, about_z: bool, angle: f64, value: f64, slide: f64) {
        let from = self.pose.translation;
        let axis = column(&self.pose, if about_z { 2 } else { 0 });
        let (xyz, rpy) = match about_z {
            true => ([0.0, 0.0, value + slide], [0.0, 0.0, angle]),
            false => ([value, 0.0, 0.0], [angle, 0.0, 0.0]),
        };
        self.pose = self.pose.compose(&Pose::from_xyz_rpy(xyz, rpy));
        if value != 0.0 {
            self.measures.push(Measure { name, value, from, to: moved(from, axis, value) });
        }
    }

    fn row(&mut self, number: usize, row: &Row, model: &Model, q: &[f64]) {
        let value = row.joint.and_then(|joint| q.get(joint)).copied();
        let (turn, slide) = match (row.kind, value) {
            (RowKind::Revolute, Some(q)) => (q, 0.0),
            (RowKind::Prismatic, Some(q)) => (0.0, q),
            _ => (0.0, 0.0),
        };
        let twist = |walk: &mut Self| {
            walk.screw(format!("a{number}"), false, row.alpha.rad(), row.a.default_value(), 0.0);
        };
        if model.convention == Convention::Modified {
            twist(self);
        }
        if let (Some(joint), Some(value)) = (row.joint.and_then(|joint| model.joints.get(joint)), value) {
            self.joint(joint, value);
        }
        self.screw(format!("d{number}"), true, row.theta.rad() + turn, row.d.default_value(), slide);
        if model.convention == Convention::Standard {
            twist(self);
        }
        self.frames.push(NamedFrame { name: number.to_string(), pose: self.pose });
    }

    /// A joint whose axis is z of the frame here, and the link that ends at it.
    fn joint(&mut self, joint: &model::Joint, value: f64) {
        let axis = column(&self.pose, 2);
        let nearest = nearest_on_line(self.pose.translation, axis, self.before);
        let own = self.pose.translation;
        let point = if distance(own, nearest) <= FAR * self.size { own } else { nearest };
        self.link_to(point);
        let kind = match joint.kind {
            model::JointKind::Revolute => JointKind::Revolute,
            model::JointKind::Prismatic => JointKind::Prismatic,
        };
        self.joints.push(Joint { name: joint.name.clone(), kind, point, axis, value });
        self.before = point;
    }

    /// A link from the joint before: along its axis, then at right angles to it.
    fn link_to(&mut self, end: Vector) {
        let mut link = vec![self.before];
        if let Some(joint) = self.joints.last() {
            link.push(nearest_on_line(joint.point, joint.axis, end));
        }
        link.push(end);
        link.dedup_by(|a, b| distance(*a, *b) <= SAME * (length(*a) + length(*b)));
        self.links.push(link);
    }

    fn finish(mut self, model: &Model) -> Skeleton {
        let flange = self.pose;
        self.constant_frame("tool", &model.tool);
        // A tool is drawn along its own displacement.
        self.link_to(flange.translation);
        if let Some(link) = self.links.last_mut()
            && distance(flange.translation, self.pose.translation) > 0.0
        {
            link.push(self.pose.translation);
        }
        let Walk { pose: tool, joints, links, frames, measures, .. } = self;
        let size = links.iter().flatten().map(|point| length(*point)).fold(0.0, f64::max);
        let near = |point: Vector| links.iter().flatten().any(|corner| distance(*corner, point) <= FAR * size);
        let is_near = |measure: &Measure| near(measure.from) && near(measure.to);
        let (frames, far_frames): (Vec<_>, Vec<_>) = frames.into_iter().partition(|frame| near(frame.pose.translation));
        let (measures, far_measures): (Vec<_>, Vec<_>) = measures.into_iter().partition(is_near);
        let far = far_frames.into_iter().map(|frame| format!("frame {}", frame.name));
        let far = far.chain(far_measures.into_iter().map(|measure| measure.name)).collect();
        Skeleton { joints, links, frames, measures, tool, far }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;
    use crate::vector::sub;

    fn arm(rows: &str) -> DynamicArm {
        let text = format!("name: a\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n{rows}");
        DynamicArm::from_yaml(&text).unwrap()
    }

    #[test]
    fn links_lead_along_the_axes_to_the_tool() {
        let arm = arm("  - {a: 0.1, alpha: 90, d: 0.4, theta: 0}\n  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n");
        let skeleton = Skeleton::of(&arm, &[0.0, 0.0]).unwrap();
        let links = &skeleton.links;
        assert_eq!(links[0], [[0.0; 3]]);
        assert_eq!(links[1], [[0.0; 3], [0.0, 0.0, 0.4], [0.1, 0.0, 0.4]]);
        assert!(distance(*links[2].last().unwrap(), arm.forward(&[0.0; 2]).unwrap().translation) < 1e-15);
        let names: Vec<&str> = skeleton.measures.iter().map(|measure| measure.name.as_str()).collect();
        assert_eq!(names, ["d1", "a1", "a2"]);
        let apart = skeleton.tool.residual(&arm.forward(&[0.0; 2]).unwrap());
        assert!(apart.position < 1e-15 && apart.orientation < 1e-15, "{apart:?}");
    }

    #[test]
    fn the_joints_stand_on_the_axes_of_the_arm() {
        let text = include_str!("../../specs/kuka_kr6_r700.yaml");
        let arm = DynamicArm::from_yaml(text).unwrap();
        let q = [0.3, -0.8, 0.9, 0.4, -0.7, 0.2];
        let skeleton = Skeleton::of(&arm, &q).unwrap();
        let (tool, jacobian) = arm.forward_and_jacobian(&q).unwrap();
        for (index, joint) in skeleton.joints.iter().enumerate() {
            let column = [0, 1, 2, 3, 4, 5].map(|row: usize| jacobian[row][index]);
            let arm_length = sub(tool.translation, joint.point);
            let velocity = crate::vector::cross(joint.axis, arm_length);
            for (a, b) in column.iter().zip(velocity.iter().chain(&joint.axis)) {
                assert!((a - b).abs() < 1e-9, "joint {index}: {column:?}");
            }
        }
    }

    #[test]
    fn frames_of_nearly_parallel_axes_are_left_out() {
        let rows = "  - {a: 0, alpha: 0.1, d: 100, theta: 0}\n  - {a: 0.3, alpha: 0, d: -100, theta: 0}\n";
        let skeleton = Skeleton::of(&arm(rows), &[0.0, 0.0]).unwrap();
        assert!(skeleton.size() < 1.0, "{skeleton:?}");
        assert_eq!(skeleton.far, ["frame 1", "d1", "d2"]);
    }

    #[test]
    fn a_scara_arm_stands_on_its_column() {
        let rows = |d1: f64, d4: f64| {
            format!(
                "  - {{a: 0.25, alpha: 0, d: {d1}, theta: 0}}\n  - {{a: 0.2, alpha: 180, d: 0, theta: 0}}\n  - {{type: \
                 prismatic, a: 0, alpha: 0, d: 0, theta: 0}}\n  - {{a: 0, alpha: 0, d: {d4}, theta: 0}}\n"
            )
        };
        // The second arm's quill reaches down to the floor: no tool tells how high its links are.
        for (d1, d4) in [(0.3, 0.05), (0.6, 0.55)] {
            let skeleton = Skeleton::of(&arm(&rows(d1, d4)), &[0.0, 0.0, 0.05, 0.0]).unwrap();
            assert_eq!(skeleton.links[1], [[0.0; 3], [0.0, 0.0, d1], [0.25, 0.0, d1]]);
            let heights: Vec<f64> = skeleton.joints.iter().map(|joint| joint.point[2]).collect();
            for (height, expected) in heights.iter().zip([0.0, d1, d1, d1 - 0.05]) {
                assert!((height - expected).abs() < 1e-12, "{heights:?}");
            }
            let tool = skeleton.links[4].last().unwrap();
            assert!((tool[2] - (d1 - 0.05 - d4)).abs() < 1e-12, "{:?}", skeleton.links[4]);
        }
    }

    #[test]
    fn a_joint_value_that_is_none_is_told() {
        let one = arm("  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n");
        assert!(matches!(Skeleton::of(&one, &[f64::NAN]), Err(DrawError::NotFinite { joint: 1, .. })));
        assert!(matches!(Skeleton::of(&one, &[]), Err(DrawError::Arm(_))));
        let slide = arm("  - {type: prismatic, a: 0.3, alpha: 0, d: 0, theta: 0}\n");
        assert_eq!(Skeleton::of(&slide, &[1e308]).map(|_| ()), Ok(()));
    }
}
