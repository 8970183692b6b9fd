//! How the joint axes lie: which are parallel, which intersect, decided on numbers at a generic configuration.
//!
//! Lengths are compared relative to the reach of the arm, angles in rad; see [`TOLERANCE`].

use super::arm::Model;
use super::chain::{Chain, Elementary};
use super::joint::JointKind;
use super::numeric::{Transform, cross, distance, dot, length, scaled, sub};
pub use super::reach::reach;
use std::cell::Cell;
use std::collections::HashMap;

/// Structure is decided within this, relative to reach for lengths and in rad for angles.
pub const TOLERANCE: f64 = 1e-10;

/// A structure that an arm misses by no more than this holds to rounding: 64 units of it, as the generated code has it.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Decides on numbers whether a structure holds, and remembers by how much an arm misses those that do.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Decisions {
    largest: Cell<f64>,
}

impl Decisions {
    /// Returns true if a number is as good as zero; a length is given relative to reach.
    pub fn vanishes(&self, miss: f64) -> bool {
        let vanishes = miss.abs() <= TOLERANCE;
        if vanishes {
            self.largest.set(self.largest.get().max(miss.abs()));
        }
        vanishes
    }

    /// Largest miss of a structure that was said to hold, if it is more than rounding.
    pub fn missed(&self) -> Option<f64> {
        Some(self.largest.get()).filter(|miss| *miss > ROUNDING)
    }
}

/// A joint axis as a line in the base frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// A point on the axis: the origin of the joint's frame.
    pub point: [f64; 3],
    /// Its unit direction.
    pub direction: [f64; 3],
}

/// Relation of two axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Relation {
    /// Both axes are one line.
    Coincident,
    /// Parallel or anti-parallel, at a distance.
    Parallel {
        /// Distance between the lines.
        distance: f64,
    },
    /// They intersect in a point at an angle.
    Intersecting {
        /// The angle between the directions, rad.
        angle: f64,
    },
    /// Neither.
    Skew {
        /// Distance between the lines.
        distance: f64,
        /// The angle between the directions, rad.
        angle: f64,
    },
}

/// Kind of three consecutive axes that are solvable in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TripleKind {
    /// All three intersect in one point.
    Intersecting,
    /// All three are parallel; or they move in a plane, some of them sliding across the direction of the others.
    Parallel,
    /// Three revolute joints, wherever their axes are; the other three joints are prismatic.
    Turning,
}

impl TripleKind {
    /// Relation of the three axes, in words; `slides` if one of the joints is prismatic.
    pub fn words(self, slides: bool) -> &'static str {
        match self {
            TripleKind::Intersecting => "meet in a point",
            TripleKind::Parallel if slides => "move in a plane",
            TripleKind::Parallel => "are parallel",
            TripleKind::Turning => "turn the tool, the others slide",
        }
    }
}

/// Three consecutive axes that intersect in a point or are parallel (or move in a plane).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Triple {
    /// The first of the three joints, from 0.
    pub first: usize,
    /// Which kind.
    pub kind: TripleKind,
}

/// The axes of an arm and what they do.
#[derive(Debug, Clone, PartialEq)]
pub struct Geometry {
    /// Sum of all lengths of the chain, and of the longest displacements; 1 if that is zero. In the file's length unit.
    pub reach: f64,
    /// The axes at a generic configuration.
    pub axes: Vec<Line>,
    /// The relation of each pair of consecutive axes.
    pub relations: Vec<Relation>,
    /// All triples.
    pub triples: Vec<Triple>,
    /// For every three consecutive revolute axes: the first joint and by how much they miss a common point.
    pub misses: Vec<(usize, f64)>,
}

/// Analyzes the axes of a chain. With run-time parameters only what holds for all their values is said; distances are
/// those at the defaults where these are not special.
pub fn geometry(model: &Model, chain: &Chain) -> Geometry {
    let mut geometry = analyzed(model, chain, reach(model, &HashMap::new()));
    if !model.parameters.is_empty() {
        for (chain, reach) in chain.samples(model) {
            geometry.weaken(analyzed(model, &chain, reach));
        }
    }
    geometry
}

impl Geometry {
    /// Keeps what also holds for other values of the parameters.
    fn weaken(&mut self, other: Geometry) {
        for (relation, other) in self.relations.iter_mut().zip(other.relations) {
            if other.generality() > relation.generality() {
                *relation = other;
            }
        }
        self.triples.retain(|triple| other.triples.contains(triple));
        for ((_, miss), (_, other)) in self.misses.iter_mut().zip(other.misses) {
            if *miss <= TOLERANCE * self.reach {
                *miss = other;
            }
        }
    }
}

impl Relation {
    fn generality(self) -> u8 {
        match self {
            Relation::Coincident => 0,
            Relation::Parallel { .. } | Relation::Intersecting { .. } => 1,
            Relation::Skew { .. } => 2,
        }
    }
}

fn analyzed(model: &Model, chain: &Chain, reach: f64) -> Geometry {
    let axes = axes(chain, reach);
    let decisions = Decisions::default();
    let pairs = axes.iter().zip(axes.iter().skip(1));
    let relations: Vec<Relation> = pairs.map(|(a, b)| relation(a, b, reach, &decisions)).collect();
    let turns: Vec<bool> = model.joints.iter().map(|joint| joint.kind == JointKind::Revolute).collect();
    let (triples, misses) = triples(&axes, &turns, reach, &decisions);
    Geometry { reach, axes, relations, triples, misses }
}

/// The triples among axes, some of which turn, and by how much three that turn miss a common point.
pub fn triples(axes: &[Line], turns: &[bool], reach: f64, decisions: &Decisions) -> (Vec<Triple>, Vec<(usize, f64)>) {
    let mut triples = Vec::new();
    let mut misses = Vec::new();
    for (first, lines) in axes.windows(3).enumerate() {
        let [a, b, c] = lines else { continue };
        let turning: Vec<&Line> =
            lines.iter().zip(turns.iter().skip(first)).filter(|(_, turns)| **turns).map(|(line, _)| line).collect();
        if turning.len() < 3 {
            let sliding = lines.iter().zip(turns.iter().skip(first)).filter(|(_, turns)| !**turns);
            let along = |u: &Line, v: &Line| decisions.vanishes(length(cross(u.direction, v.direction)));
            let across = |u: &Line, v: &Line| decisions.vanishes(dot(u.direction, v.direction));
            if let Some(normal) = turning.first()
                && turning.iter().all(|line| along(line, normal))
                && sliding.into_iter().all(|(line, _)| across(line, normal))
            {
                triples.push(Triple { first, kind: TripleKind::Parallel });
            }
            continue;
        }
        let parallel = |u: &Line, v: &Line| {
            matches!(relation(u, v, reach, decisions), Relation::Parallel { .. } | Relation::Coincident)
        };
        let miss = common_point_miss(a, b, c);
        if let Some(miss) = miss {
            misses.push((first, miss));
        }
        if parallel(a, b) && parallel(b, c) {
            triples.push(Triple { first, kind: TripleKind::Parallel });
        } else if miss.is_some_and(|miss| decisions.vanishes(miss / reach)) {
            triples.push(Triple { first, kind: TripleKind::Intersecting });
        }
    }
    (triples, misses)
}

/// The axes with every joint at a value that is special for no arm.
fn axes(chain: &Chain, reach: f64) -> Vec<Line> {
    let mut current = Transform::IDENTITY;
    let mut axes = Vec::new();
    for step in &chain.transforms {
        if let Some(joint) = step.joint() {
            axes.push(Line { point: current.p, direction: current.axis(2) });
            current = current.then(&generic_motion(joint, matches!(step, Elementary::Revolute { .. }), reach));
        }
        current = current.then(&Transform::of(step));
    }
    axes
}

/// Joint `i` at a value that is special for no arm: multiples of the golden angle have no special relation to each other.
pub fn generic_motion(i: usize, turns: bool, reach: f64) -> Transform {
    let generic = 0.618_033_988_749_895 * (i as f64 + 1.0) + 0.271_828;
    if turns {
        Transform::rotate_z(generic.sin(), generic.cos())
    } else {
        Transform::shift([0.0, 0.0, reach * (0.3 + 0.1 * generic.sin())])
    }
}

/// The relation of two lines.
pub fn relation(a: &Line, b: &Line, reach: f64, decisions: &Decisions) -> Relation {
    let between = sub(b.point, a.point);
    let normal = cross(a.direction, b.direction);
    let (sine, cosine) = (length(normal), dot(a.direction, b.direction));
    if decisions.vanishes(sine) {
        let apart = length(cross(between, a.direction));
        return if decisions.vanishes(apart / reach) {
            Relation::Coincident
        } else {
            Relation::Parallel { distance: apart }
        };
    }
    let angle = sine.atan2(cosine);
    let apart = dot(between, normal).abs() / sine;
    if decisions.vanishes(apart / reach) {
        Relation::Intersecting { angle }
    } else {
        Relation::Skew { distance: apart, angle }
    }
}

/// Distance by which three lines miss a common point, the largest of three. Two are the distances of the outer lines
/// from the middle one, the third is the distance between their feet. `None` if an outer line is parallel to the middle
/// one.
fn common_point_miss(a: &Line, b: &Line, c: &Line) -> Option<f64> {
    let (on_a, from_a) = nearest(a, b)?;
    let (on_c, from_c) = nearest(c, b)?;
    Some(distance(on_a, from_a).max(distance(on_c, from_c)).max(distance(from_a, from_c)))
}

/// The point of the first line that is nearest to the second; `None` if they are parallel.
pub fn foot(a: &Line, b: &Line) -> Option<[f64; 3]> {
    nearest(a, b).map(|(foot, _)| foot)
}

/// The feet of the common normal, on the first line and on the second.
fn nearest(a: &Line, b: &Line) -> Option<([f64; 3], [f64; 3])> {
    let between = sub(b.point, a.point);
    let cosine = dot(a.direction, b.direction);
    let normal = cross(a.direction, b.direction);
    let sine2 = dot(normal, normal);
    if sine2 <= TOLERANCE * TOLERANCE {
        return None;
    }
    let (along_a, along_b) = (dot(between, a.direction), dot(between, b.direction));
    let s = (along_a - cosine * along_b) / sine2;
    let t = (cosine * along_a - along_b) / sine2;
    Some((scaled(a.point, a.direction, s), scaled(b.point, b.direction, t)))
}
