//! A path through targets.

use denhart::solve::wrap;
use denhart::{PlanarPose, PointAngle, PointAxis, Pose};

use crate::{DynamicTarget, WholeTarget};

/// Where the direction of motion turns by more than this cosine's angle, 30 degrees, a path has a corner.
const CORNER: f64 = 0.866_025_403_784_438_6;
/// Ways shorter than this, relative to the whole path, have no direction.
const STAYS: f64 = 1e-12;

/// Why targets are no path. Targets count from 0 here, and from 1 in the message.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PathError {
    /// Less than two targets that differ.
    #[error("a path needs two targets that differ")]
    TooShort,
    /// Another number of times than of targets.
    #[error("{times} times for {targets} targets")]
    Times {
        /// The targets.
        targets: usize,
        /// The times.
        times: usize,
    },
    /// A time that is not finite, or not above the one before it.
    #[error("the time of target {} is not above the one before it", .0 + 1)]
    Unsorted(usize),
    /// A number of a target that is not finite.
    #[error("target {} is not finite", .0 + 1)]
    NotFinite(usize),
    /// A target of another task than the first, or with another number of values beside it.
    #[error("target {} is of another kind than the first", .0 + 1)]
    Kind(usize),
    /// A direction that is turned by half a turn from the one before it: no way between them is the shortest.
    #[error("target {} is turned by half a turn from the one before it: its way is not determined", .0 + 1)]
    HalfTurn(usize),
}

/// The turn of a target.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Turn {
    None,
    Axis([f64; 3]),
    Rotation([[f64; 3]; 3]),
}

/// A smooth path through targets of one task, over their times or over its own length.
///
/// Between two targets the path is a cubic in all numbers that add up: positions, angles by the shorter way, and the values
/// beside the target. A rotation is that of the target before, times the exponential of a cubic rotation vector; an axis is a
/// cubic, normalized. Velocities are continuous (a Hermite spline with the tangents of parabolas). Where the direction of
/// motion turns by more than 30 degrees the path has a corner: the tangents on both sides are its own, and between two corners
/// the path is straight. Its length counts a turn of 1 rad as `length`.
#[derive(Debug, Clone, PartialEq)]
pub struct TargetPath {
    kind: DynamicTarget,
    knots: Vec<Knot>,
    corners: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq)]
struct Knot {
    at: f64,
    /// Positions, then angles, then the values beside the target.
    numbers: Vec<f64>,
    turn: Turn,
    /// Rates of the numbers before and after the knot.
    rates: [Vec<f64>; 2],
    /// Angular velocity in the target's own frame, or derivative of the axis, before and after the knot.
    turning: [[f64; 3]; 2],
}

impl TargetPath {
    /// The path through these targets at these times; without times, at the length of the way to each. Targets that do not
    /// differ from the one before them are left out then.
    ///
    /// # Errors
    /// Less than two targets that differ; times that do not rise; numbers that are not finite; targets of several kinds.
    pub fn new(targets: &[WholeTarget], times: Option<&[f64]>, length: f64) -> Result<Self, PathError> {
        let Some(first) = targets.first() else { return Err(PathError::TooShort) };
        if let Some(times) = times {
            if times.len() != targets.len() {
                return Err(PathError::Times { targets: targets.len(), times: times.len() });
            }
            let mut last = f64::NEG_INFINITY;
            for (index, time) in times.iter().enumerate() {
                if !(time.is_finite() && *time > last) {
                    return Err(PathError::Unsorted(index));
                }
                last = *time;
            }
        }
        let start = times.and_then(|times| times.first()).copied().unwrap_or(0.0);
        let mut knots: Vec<Knot> = Vec::with_capacity(targets.len());
        let mut way = 0.0;
        for (index, target) in targets.iter().enumerate() {
            let is_other = target.target.task() != first.target.task() || target.given.len() != first.given.len();
            if is_other {
                return Err(PathError::Kind(index));
            }
            let (mut numbers, turn) = parts(target);
            let entries = match turn {
                Turn::None => Vec::new(),
                Turn::Axis(axis) => axis.to_vec(),
                Turn::Rotation(rotation) => rotation.as_flattened().to_vec(),
            };
            if !numbers.iter().chain(&entries).all(|number| number.is_finite()) {
                return Err(PathError::NotFinite(index));
            }
            if let Some(before) = knots.last() {
                for angle in angles(&target.target) {
                    if let (Some(number), Some(last)) = (numbers.get_mut(angle), before.numbers.get(angle)) {
                        *number = last + wrap(*number - last);
                    }
                }
                if let (Turn::Axis(a), Turn::Axis(b)) = (before.turn, turn)
                    && dot(a, b) < STAYS - 1.0
                {
                    return Err(PathError::HalfTurn(index));
                }
                way += size(&motion(before, &numbers, &turn, &first.target, length));
            }
            let at = match times.and_then(|times| times.get(index)) {
                Some(time) => time - start,
                None => way,
            };
            if times.is_none() && knots.last().is_some_and(|last| at <= last.at) {
                continue;
            }
            let rates = [vec![0.0; numbers.len()], vec![0.0; numbers.len()]];
            knots.push(Knot { at, numbers, turn, rates, turning: [[0.0; 3]; 2] });
        }
        if knots.len() < 2 {
            return Err(PathError::TooShort);
        }
        let mut path = TargetPath { kind: first.target, knots, corners: Vec::new() };
        path.set_rates(length, way);
        Ok(path)
    }

    /// The last parameter: the time from the first target to the last, or the length of the path.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.knots.last().map_or(0.0, |knot| knot.at)
    }

    /// The number of stretches between targets.
    #[must_use]
    pub fn stretches(&self) -> usize {
        self.knots.len().saturating_sub(1)
    }

    /// The parameters of its corners.
    pub fn corners(&self) -> impl Iterator<Item = f64> {
        self.corners.iter().filter_map(|corner| self.knots.get(*corner)).map(|knot| knot.at)
    }

    /// Rates at every knot, and the corners.
    fn set_rates(&mut self, length: f64, whole: f64) {
        let kind = self.kind;
        let ways: Vec<_> = self
            .knots
            .iter()
            .zip(self.knots.iter().skip(1))
            .map(|(a, b)| {
                let time = b.at - a.at;
                let rates: Vec<f64> = a.numbers.iter().zip(&b.numbers).map(|(a, b)| (b - a) / time).collect();
                let turning = turned(&a.turn, &b.turn).map(|x| x / time);
                (time, rates, turning, motion(a, &b.numbers, &b.turn, &kind, length))
            })
            .collect();
        let stays = |way: &[f64]| size(way) <= STAYS * whole;
        let is_corner = |a: &[f64], b: &[f64]| match (stays(a), stays(b)) {
            (false, false) => {
                let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                dot < CORNER * size(a) * size(b)
            }
            (a, b) => a != b,
        };
        for (index, (before, after)) in ways.iter().zip(ways.iter().skip(1)).enumerate() {
            let knot = index + 1;
            if is_corner(&before.3, &after.3) {
                self.corners.push(knot);
                continue;
            }
            let part = before.0 / (before.0 + after.0);
            let blend = |a: f64, b: f64| a + part * (b - a);
            let Some(knot) = self.knots.get_mut(knot) else { continue };
            for rates in &mut knot.rates {
                for (rate, (a, b)) in rates.iter_mut().zip(before.1.iter().zip(&after.1)) {
                    *rate = blend(*a, *b);
                }
            }
            let [ax, ay, az] = before.2;
            let [bx, by, bz] = after.2;
            knot.turning = [[blend(ax, bx), blend(ay, by), blend(az, bz)]; 2];
        }
        // Beside a corner, and at the ends, the second derivative is 0.
        let last = self.knots.len() - 1;
        let is_end = |index: usize, corners: &[usize]| index == 0 || index == last || corners.contains(&index);
        for (index, way) in ways.iter().enumerate() {
            let ends = [index, index + 1].map(|index| is_end(index, &self.corners));
            let free = |own: f64, other: f64, both: bool| if both { own } else { 1.5 * own - 0.5 * other };
            let (Some(from), Some(to)) = (self.knots.get(index).cloned(), self.knots.get(index + 1).cloned()) else {
                continue;
            };
            let both = ends == [true, true];
            let one = |other: &Knot, side: usize| {
                let rates = other.rates.get(side).into_iter().flatten();
                let rates = way.1.iter().zip(rates).map(|(own, other)| free(*own, *other, both)).collect::<Vec<_>>();
                let mut turning = way.2;
                let rotates = matches!(other.turn, Turn::Rotation(_));
                for (own, other) in turning.iter_mut().zip(other.turning.get(side).into_iter().flatten()) {
                    // Rotations keep to their own way: vectors of two frames do not add up.
                    *own = if rotates { *own } else { free(*own, *other, both) };
                }
                (rates, turning)
            };
            let [at_start, at_end] = ends;
            if at_start && let Some(knot) = self.knots.get_mut(index) {
                let (rates, turning) = one(&to, 0);
                let ([_, after], [_, turns]) = (&mut knot.rates, &mut knot.turning);
                (*after, *turns) = (rates, turning);
            }
            if at_end && let Some(knot) = self.knots.get_mut(index + 1) {
                let (rates, turning) = one(&from, 1);
                let ([before, _], [turns, _]) = (&mut knot.rates, &mut knot.turning);
                (*before, *turns) = (rates, turning);
            }
        }
    }

    /// The target at a parameter; before the first and after the last those ones.
    #[must_use]
    pub fn at(&self, at: f64) -> WholeTarget {
        let index = self.knots.partition_point(|knot| knot.at <= at).clamp(1, self.knots.len() - 1);
        let (Some(from), Some(to)) = (self.knots.get(index - 1), self.knots.get(index)) else {
            return WholeTarget::from(self.kind);
        };
        let time = to.at - from.at;
        let part = ((at - from.at) / time).clamp(0.0, 1.0);
        let rest = 1.0 - part;
        let (a, b) = ((1.0 + 2.0 * part) * rest * rest, part * part * (3.0 - 2.0 * part));
        let (c, d) = (time * part * rest * rest, -time * part * part * rest);
        let ([_, leaving], [arriving, _]) = (&from.rates, &to.rates);
        let ends = from.numbers.iter().zip(&to.numbers).zip(leaving.iter().zip(arriving));
        let numbers: Vec<f64> = ends.map(|((p, q), (u, v))| a * p + b * q + c * u + d * v).collect();
        let ([_, leaving], [arriving, _]) = (from.turning, to.turning);
        let turn = match (from.turn, to.turn) {
            (Turn::Axis(p), Turn::Axis(q)) => {
                let mut axis = [0.0; 3];
                for (axis, ((p, q), (u, v))) in axis.iter_mut().zip(p.iter().zip(&q).zip(leaving.iter().zip(&arriving)))
                {
                    *axis = a * p + b * q + c * u + d * v;
                }
                Turn::Axis(unit(axis))
            }
            (Turn::Rotation(p), Turn::Rotation(q)) => {
                let whole = turned(&from.turn, &to.turn);
                let arriving = vector_rate(whole, arriving);
                let mut vector = [0.0; 3];
                for (place, (whole, (u, v))) in vector.iter_mut().zip(whole.iter().zip(leaving.iter().zip(&arriving))) {
                    *place = b * whole + c * u + d * v;
                }
                let end = if part < 0.5 { p } else { q };
                // From the nearer end, so that both are met to the bit.
                let vector = if part < 0.5 { vector } else { from_end(whole, vector) };
                let turn = Pose::from_xyz_rotation_vector([0.0; 3], vector);
                Turn::Rotation((Pose { rotation: end, translation: [0.0; 3] } * turn).rotation)
            }
            (turn, _) => turn,
        };
        joined(&self.kind, &numbers, turn)
    }
}

/// The rotation vector of `exp(-whole) exp(vector)`.
fn from_end(whole: [f64; 3], vector: [f64; 3]) -> [f64; 3] {
    let [back, there] = [whole.map(|x| -x), vector].map(|x| Pose::from_xyz_rotation_vector([0.0; 3], x));
    (back * there).rotation_vector()
}

/// The derivative of a rotation vector whose rotation turns by `rate` in its own frame: the inverse of the right Jacobian of
/// the exponential (Chirikjian 2012, section 10.6).
fn vector_rate(vector: [f64; 3], rate: [f64; 3]) -> [f64; 3] {
    let square = dot(vector, vector);
    let angle = square.sqrt();
    let factor = if square < 1e-6 { 1.0 / 12.0 } else { (1.0 - 0.5 * angle / (0.5 * angle).tan()) / square };
    let once = cross(vector, rate);
    let [x, y, z] = cross(vector, once);
    let ([rx, ry, rz], [ox, oy, oz]) = (rate, once);
    [rx + 0.5 * ox + factor * x, ry + 0.5 * oy + factor * y, rz + 0.5 * oz + factor * z]
}

/// The numbers that add up, and the turn.
fn parts(target: &WholeTarget) -> (Vec<f64>, Turn) {
    let (mut numbers, turn) = match &target.target {
        DynamicTarget::Pose(pose) => (pose.translation.to_vec(), Turn::Rotation(pose.orthonormalized().rotation)),
        DynamicTarget::Position(point) => (point.to_vec(), Turn::None),
        DynamicTarget::PositionAxis(asked) => (asked.point.to_vec(), Turn::Axis(unit(asked.axis))),
        DynamicTarget::PositionAngle(asked) => ([&asked.point[..], &[asked.angle]].concat(), Turn::None),
        DynamicTarget::PlanarPose(asked) => (vec![asked.x, asked.y, asked.phi], Turn::None),
        DynamicTarget::PlanarPosition(point) => (point.to_vec(), Turn::None),
    };
    numbers.extend(target.given.iter());
    (numbers, turn)
}

/// The places of angles among the numbers.
fn angles(target: &DynamicTarget) -> std::ops::Range<usize> {
    match target {
        DynamicTarget::PositionAngle(_) => 3..4,
        DynamicTarget::PlanarPose(_) => 2..3,
        _ => 0..0,
    }
}

fn joined(kind: &DynamicTarget, numbers: &[f64], turn: Turn) -> WholeTarget {
    let number = |index: usize| numbers.get(index).copied().unwrap_or(f64::NAN);
    let point = [number(0), number(1), number(2)];
    let (target, taken) = match (kind, turn) {
        (DynamicTarget::Pose(_), Turn::Rotation(rotation)) => {
            (DynamicTarget::Pose(Pose { rotation, translation: point }), 3)
        }
        (DynamicTarget::PositionAxis(_), Turn::Axis(axis)) => {
            (DynamicTarget::PositionAxis(PointAxis::new(point, axis)), 3)
        }
        (DynamicTarget::Position(_), _) => (DynamicTarget::Position(point), 3),
        (DynamicTarget::PositionAngle(_), _) => (DynamicTarget::PositionAngle(PointAngle::new(point, number(3))), 4),
        (DynamicTarget::PlanarPose(_), _) => {
            (DynamicTarget::PlanarPose(PlanarPose::new(number(0), number(1), number(2))), 3)
        }
        (DynamicTarget::PlanarPosition(_), _) => (DynamicTarget::PlanarPosition([number(0), number(1)]), 2),
        (kind, _) => (*kind, 0),
    };
    WholeTarget::new(target, numbers.get(taken..).unwrap_or(&[]))
}

/// The way between two turns: a rotation vector in the frame of the first, or the difference of axes.
fn turned(a: &Turn, b: &Turn) -> [f64; 3] {
    match (a, b) {
        (Turn::Axis([ax, ay, az]), Turn::Axis([bx, by, bz])) => [bx - ax, by - ay, bz - az],
        (Turn::Rotation(a), Turn::Rotation(b)) => {
            let [a, b] = [a, b].map(|rotation| Pose { rotation: *rotation, translation: [0.0; 3] });
            (a.inverse() * b).rotation_vector()
        }
        _ => [0.0; 3],
    }
}

/// The way from a knot to a target as lengths: positions, then turns times `length`.
fn motion(from: &Knot, numbers: &[f64], turn: &Turn, kind: &DynamicTarget, length: f64) -> Vec<f64> {
    let positions = match kind {
        DynamicTarget::PlanarPosition(_) | DynamicTarget::PlanarPose(_) => 2,
        _ => 3,
    };
    let numbers = from.numbers.iter().zip(numbers).enumerate().map(|(index, (a, b))| {
        let way = b - a;
        if index < positions { way } else { way * length }
    });
    numbers.chain(turned(&from.turn, turn).map(|x| x * length)).collect()
}

/// The length of a way.
fn size(way: &[f64]) -> f64 {
    way.iter().fold(0.0, |sum, x| sum + x * x).sqrt()
}

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]

    use super::*;

    fn pose(xyz: [f64; 3], vector: [f64; 3]) -> WholeTarget {
        WholeTarget::from(DynamicTarget::Pose(Pose::from_xyz_rotation_vector(xyz, vector)))
    }

    fn posed(path: &TargetPath, at: f64) -> Pose<f64> {
        match path.at(at).target {
            DynamicTarget::Pose(pose) => pose,
            other => panic!("{other:?}"),
        }
    }

    /// The numbers of a target in a row.
    fn numbers(target: &WholeTarget) -> Vec<f64> {
        let (mut numbers, turn) = parts(target);
        match turn {
            Turn::None => {}
            Turn::Axis(axis) => numbers.extend(axis),
            Turn::Rotation(rotation) => numbers.extend(rotation.as_flattened()),
        }
        numbers
    }

    #[test]
    fn targets_of_every_task_are_met_at_their_times_with_continuous_velocity() {
        let along = |f: &dyn Fn(f64) -> DynamicTarget| -> Vec<WholeTarget> {
            (0..9).map(|k| WholeTarget::new(f(0.3 * f64::from(k)), &[0.1 * f64::from(k)])).collect()
        };
        let point = |s: f64| [s.sin(), s.cos(), 0.2 * s];
        let all = [
            along(&|s| DynamicTarget::Pose(Pose::from_xyz_rotation_vector(point(s), [0.5 * s, s.sin(), -0.3 * s]))),
            along(&|s| DynamicTarget::Position(point(s))),
            along(&|s| DynamicTarget::PositionAxis(PointAxis::new(point(s), unit([s.cos(), s.sin(), 0.5])))),
            along(&|s| DynamicTarget::PositionAngle(PointAngle::new(point(s), wrap(3.0 * s)))),
            along(&|s| DynamicTarget::PlanarPose(PlanarPose::new(s.sin(), s.cos(), wrap(3.0 * s)))),
            along(&|s| DynamicTarget::PlanarPosition([s.sin(), s.cos()])),
        ];
        let times = [0.0, 0.5, 0.9, 1.5, 1.9, 2.4, 3.0, 3.4, 4.0].map(|t| t + 7.0);
        for targets in &all {
            let path = TargetPath::new(targets, Some(&times), 1.0).unwrap();
            assert_eq!((path.end(), path.stretches(), path.corners().count()), (4.0, 8, 0), "{targets:?}");
            for (target, time) in targets.iter().zip(times) {
                let met = numbers(&path.at(time - 7.0));
                let near = met.iter().zip(numbers(target)).all(|(a, b)| wrap(a - b).abs() < 1e-14);
                assert!(near, "{met:?} {target:?}");
            }
            for time in &times[1..8] {
                const STEP: f64 = 1e-5;
                let at = |part: f64| numbers(&path.at(time - 7.0 + part * STEP));
                let (before, here, after) = (at(-1.0), at(0.0), at(1.0));
                for ((a, b), c) in before.iter().zip(&here).zip(&after) {
                    let (left, right) = ((b - a) / STEP, (c - b) / STEP);
                    assert!((left - right).abs() < 2e-3, "{left} {right} at {time}");
                }
            }
        }
    }

    #[test]
    fn a_turn_about_an_axis_stays_one() {
        let turned = |k: i32| pose([0.1 * f64::from(k), 0.0, 0.0], [0.0, 0.0, 0.8 * f64::from(k)]);
        let targets: Vec<WholeTarget> = (0..5).map(turned).collect();
        let path = TargetPath::new(&targets, None, 1.0).unwrap();
        for k in 0..=40 {
            let s = f64::from(k) / 40.0;
            let found = posed(&path, s * path.end());
            let expected = Pose::from_xyz_rotation_vector([0.4 * s, 0.0, 0.0], [0.0, 0.0, 3.2 * s]);
            assert!(found.residual(&expected).position < 1e-14 && found.residual(&expected).orientation < 1e-13, "{s}");
        }
    }

    #[test]
    fn a_square_keeps_its_sides_and_a_circle_is_round() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let targets = square.map(|[x, y]| pose([x, y, 0.0], [0.0; 3]));
        let path = TargetPath::new(&targets, None, 1.0).unwrap();
        assert_eq!(path.corners().collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
        for k in 0..=400 {
            let [x, y, _] = posed(&path, f64::from(k) / 100.0).translation;
            let side = [x, y, 1.0 - x, 1.0 - y].into_iter().fold(f64::INFINITY, |least, side| least.min(side.abs()));
            assert!(side < 1e-15, "{x} {y}");
        }
        let round: Vec<WholeTarget> = (0..=36)
            .map(|k| f64::from(k).to_radians() * 10.0)
            .map(|angle| pose([angle.cos(), angle.sin(), 0.0], [0.0; 3]))
            .collect();
        let path = TargetPath::new(&round, None, 1.0).unwrap();
        assert_eq!(path.corners().count(), 0);
        for k in 0..=1000 {
            let [x, y, _] = posed(&path, path.end() * f64::from(k) / 1000.0).translation;
            assert!((x.hypot(y) - 1.0).abs() < 2e-3, "{x} {y}");
        }
        // A stay is a corner at both ends, and a pose that is there twice counts once without times.
        let stay = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(|[x, y]| pose([x, y, 0.0], [0.0; 3]));
        let path = TargetPath::new(&stay, Some(&[0.0, 1.0, 2.0, 3.0]), 1.0).unwrap();
        assert_eq!(path.corners().collect::<Vec<_>>(), [1.0, 2.0]);
        assert_eq!(posed(&path, 1.5).translation, [1.0, 0.0, 0.0]);
        assert_eq!(TargetPath::new(&stay, None, 1.0).unwrap().stretches(), 2);
    }

    #[test]
    fn what_is_no_path_is_told() {
        let one = pose([0.0; 3], [0.0; 3]);
        let two = pose([1.0, 0.0, 0.0], [0.0; 3]);
        let path = |targets: &[WholeTarget], times: Option<&[f64]>| TargetPath::new(targets, times, 1.0).unwrap_err();
        assert_eq!(path(&[], None), PathError::TooShort);
        assert_eq!(path(&[one], Some(&[0.0])), PathError::TooShort);
        assert_eq!(path(&[one, one], None), PathError::TooShort);
        assert_eq!(path(&[one, two], Some(&[0.0])), PathError::Times { targets: 2, times: 1 });
        assert_eq!(path(&[one, two], Some(&[1.0, 1.0])), PathError::Unsorted(1));
        assert_eq!(path(&[one, two], Some(&[0.0, f64::NAN])), PathError::Unsorted(1));
        assert_eq!(path(&[one, pose([f64::NAN, 0.0, 0.0], [0.0; 3])], None), PathError::NotFinite(1));
        let other = WholeTarget::from(DynamicTarget::Position([0.0; 3]));
        assert_eq!(path(&[one, other], None), PathError::Kind(1));
        let axis =
            |z: f64| WholeTarget::from(DynamicTarget::PositionAxis(PointAxis::new([z, 0.0, 0.0], [0.0, 0.0, z])));
        assert_eq!(path(&[axis(1.0), axis(-1.0)], None), PathError::HalfTurn(1));
    }
}
