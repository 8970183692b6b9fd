//! Pose and Jacobian by one sweep from the tool to the base.
//!
//! Every vector is carried in the current frame and turned by one joint after the other, so the rotation by q1 comes last.
//! The vectors are the tool's axes, its position, and the Jacobian columns of the joints passed. A run of joints with
//! parallel axes turns by the sum of their angles at once; its link lengths enter along the partial sums.

use super::link::{self, Run};
use crate::model::chain::{Chain, Elementary};
use crate::symbolic::{Angles, Cost, Dimension, Expr, Graph, Products, Vec3, transpose};

/// Column of the geometric Jacobian in the base frame, at the tool point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// Linear velocity for unit joint rate.
    pub v: Vec3,
    /// Angular velocity for unit joint rate.
    pub w: Vec3,
}

/// Result of a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// The tool's pose.
    Forward,
    /// The Jacobian.
    Jacobian,
    /// Both.
    Both,
}

/// A kinematic function as expressions.
#[derive(Debug, Clone)]
pub struct Kinematics {
    /// The arena.
    pub graph: Graph,
    /// The sines and cosines it needs.
    pub angles: Angles,
    /// Rotation of the tool, `[row][column]`.
    pub rotation: [[Expr; 3]; 3],
    /// Position of the tool point.
    pub translation: Vec3,
    /// Jacobian columns, by joint.
    pub columns: Vec<Column>,
    /// Operations.
    pub cost: Cost,
}

/// The cheapest of the equivalent forms. Constants go outward or stay as built; the last link's length goes through the
/// chain, or along the approach vector at the end.
pub fn kinematics(chain: &Chain, wanted: Wanted) -> Kinematics {
    let late: &[bool] = if wanted == Wanted::Forward { &[true, false] } else { &[false] };
    let mut best: Option<Kinematics> = None;
    for products in [Products::AsBuilt, Products::ConstantsOutward] {
        for late in late {
            let candidate = Sweep::run(chain, wanted, products, *late);
            if best.as_ref().is_none_or(|b| candidate.cost.arithmetic() < b.cost.arithmetic()) {
                best = Some(candidate);
            }
        }
    }
    best.unwrap_or_else(|| Sweep::run(chain, wanted, Products::AsBuilt, false))
}

struct Sweep {
    g: Graph,
    angles: Angles,
    /// Axes of the tool: normal, orientation (sliding) and approach vector.
    axes: [Vec3; 3],
    p: Vec3,
    /// Length still to be added along a carried direction.
    late: Option<(Expr, Vec3)>,
    columns: Vec<(usize, Column)>,
    /// The joint that is passed next, from 1; 0 before the base.
    next: usize,
}

impl Sweep {
    fn run(chain: &Chain, wanted: Wanted, products: Products, late: bool) -> Kinematics {
        let mut sweep = Sweep {
            g: Graph::new(products),
            angles: Angles::default(),
            axes: Graph::identity(),
            p: [Expr::ZERO; 3],
            late: None,
            columns: Vec::new(),
            next: 0,
        };
        let mut end = chain.transforms.len();
        let mut defer = late;
        while let Some(step) = end.checked_sub(1).and_then(|i| chain.transforms.get(i)) {
            if step.joint().is_some() && defer {
                sweep.defer();
                defer = false;
            }
            let start = run_start(chain, end);
            let passed = chain.transforms.get(..end).unwrap_or_default();
            sweep.next = passed.iter().rev().find_map(Elementary::joint).map_or(0, |joint| joint + 1);
            match (step, chain.transforms.get(start..end)) {
                (Elementary::Revolute { .. }, Some(run)) => {
                    sweep.planar_run(run);
                    end = start;
                }
                _ => {
                    sweep.single(step);
                    end -= 1;
                }
            }
        }
        sweep.finish(wanted)
    }

    /// Leaves a translation along z to be added along the carried z direction when the sweep is done.
    fn defer(&mut self) {
        let [x, y, z] = self.p;
        if x == Expr::ZERO && y == Expr::ZERO && z != Expr::ZERO {
            self.late = Some((z, [Expr::ZERO, Expr::ZERO, Expr::ONE]));
            self.p = [Expr::ZERO; 3];
        }
    }

    fn vectors(&mut self, mut f: impl FnMut(&mut Graph, Vec3) -> Vec3) {
        for axis in &mut self.axes {
            *axis = f(&mut self.g, *axis);
        }
        self.p = f(&mut self.g, self.p);
        if let Some((_, direction)) = &mut self.late {
            *direction = f(&mut self.g, *direction);
        }
        for (_, column) in &mut self.columns {
            column.v = f(&mut self.g, column.v);
            column.w = f(&mut self.g, column.w);
        }
    }

    fn single(&mut self, step: &Elementary) {
        match step {
            Elementary::Prismatic { joint } => {
                let z = [Expr::ZERO, Expr::ZERO, Expr::ONE];
                self.columns.push((*joint, Column { v: z, w: [Expr::ZERO; 3] }));
                let displacement = link::displacement(&mut self.g, *joint);
                self.p = self.g.add3(self.p, [Expr::ZERO, Expr::ZERO, displacement]);
            }
            _ => {
                let factor = link::elementary(&mut self.g, step);
                self.vectors(|g, v| g.apply3(&factor.r, v));
                self.suggest("t", self.next);
                self.p = self.g.add3(self.p, factor.p);
                link::suggest(&mut self.g, self.p, &format!("r{}", self.next), self.next);
            }
        }
    }

    /// Joints with parallel axes, from the last to the first; `run` starts and ends with a revolute joint.
    fn planar_run(&mut self, run: &[Elementary]) {
        // Up to and including each transform.
        let mut whole = Run::start();
        let mut partial = Vec::with_capacity(run.len());
        for transform in run {
            whole.pass(transform);
            partial.push(whole.clone());
        }
        let total = self.angles.pair(&mut self.g, &whole.sum);
        self.vectors(|g, v| whole.turn(g, total, v));
        let frame = run.first().and_then(Elementary::joint).unwrap_or(0);
        self.name_vectors(frame);
        let last = run.last().and_then(Elementary::joint).map_or(frame, |joint| joint + 1);
        link::suggest(&mut self.g, self.p, &format!("r{last}"), frame);
        for (step, Run { sum, reversed }) in run.iter().zip(partial).rev() {
            let g = &mut self.g;
            let signed = |g: &mut Graph, e: Expr| if reversed { g.neg(e) } else { e };
            match step {
                Elementary::Revolute { joint, .. } => {
                    link::suggest(g, self.p, &format!("r{}", joint + 1), frame);
                    let [x, y, _] = self.p;
                    let back = g.neg(y);
                    let v = [signed(g, back), signed(g, x), Expr::ZERO];
                    let w = [Expr::ZERO, Expr::ZERO, signed(g, Expr::ONE)];
                    self.columns.push((*joint, Column { v, w }));
                }
                Elementary::ShiftX { length, row } => {
                    let pair = self.angles.pair(g, &sum);
                    let a = g.length(Dimension::LinkLength(*row), length);
                    let along = g.scale3(a, [pair.cos, pair.sin, Expr::ZERO]);
                    self.p = g.add3(self.p, along);
                }
                Elementary::ShiftZ { length, row } => {
                    let d = g.length(Dimension::LinkOffset(*row), length);
                    let d = signed(g, d);
                    self.p = g.add3(self.p, [Expr::ZERO, Expr::ZERO, d]);
                }
                Elementary::Prismatic { joint } => {
                    let z = [Expr::ZERO, Expr::ZERO, signed(g, Expr::ONE)];
                    self.columns.push((*joint, Column { v: z, w: [Expr::ZERO; 3] }));
                    let displacement = link::displacement(g, *joint);
                    let displacement = signed(g, displacement);
                    self.p = g.add3(self.p, [Expr::ZERO, Expr::ZERO, displacement]);
                }
                Elementary::RotateX { .. } | Elementary::RotateZ { .. } | Elementary::Frame { .. } => {}
            }
        }
        link::name(&mut self.g, self.p, "p", frame);
    }

    /// Suggests the names of [`Sweep::name_vectors`] with a letter before.
    fn suggest(&mut self, before: &str, frame: usize) {
        let g = &mut self.g;
        for (vector, what) in self.axes.iter().chain([&self.p]).zip(["n", "o", "a", "p"]) {
            link::suggest(g, *vector, &format!("{before}{what}"), frame);
        }
        for (joint, column) in &self.columns {
            link::suggest(g, column.v, &format!("{before}v{}", joint + 1), frame);
            link::suggest(g, column.w, &format!("{before}z{}", joint + 1), frame);
        }
    }

    fn name_vectors(&mut self, frame: usize) {
        let g = &mut self.g;
        for (axis, what) in self.axes.iter().zip(["n", "o", "a"]) {
            link::name(g, *axis, what, frame);
        }
        for (joint, column) in &self.columns {
            link::name(g, column.v, &format!("v{}", joint + 1), frame);
            link::name(g, column.w, &format!("z{}", joint + 1), frame);
        }
    }

    fn finish(mut self, wanted: Wanted) -> Kinematics {
        if let Some((length, direction)) = self.late.take() {
            let along = self.g.scale3(length, direction);
            self.p = self.g.add3(self.p, along);
        }
        self.columns.sort_by_key(|(joint, _)| *joint);
        let columns: Vec<Column> = self.columns.into_iter().map(|(_, column)| column).collect();
        let rotation = transpose(&self.axes);
        let mut roots = Vec::new();
        if wanted != Wanted::Jacobian {
            roots.extend(rotation.iter().flatten().chain(&self.p));
        }
        if wanted != Wanted::Forward {
            roots.extend(columns.iter().flat_map(|c| c.v.iter().chain(&c.w)));
        }
        let cost = link::finish(&self.g, &mut self.angles, &roots);
        Kinematics { graph: self.g, angles: self.angles, rotation, translation: self.p, columns, cost }
    }
}

/// Start of the run of parallel revolute joints that ends just before `end`. Axes stay parallel across shifts, turns
/// about z, prismatic joints along z, and half turns about x.
fn run_start(chain: &Chain, end: usize) -> usize {
    let mut start = end.saturating_sub(1);
    for (index, step) in chain.transforms.iter().enumerate().take(end).rev() {
        match step {
            Elementary::Revolute { .. } => start = index,
            Elementary::ShiftX { .. }
            | Elementary::ShiftZ { .. }
            | Elementary::RotateZ { .. }
            | Elementary::Prismatic { .. } => {}
            Elementary::RotateX { angle, .. } if angle.quarter_turns() == Some(2) => {}
            Elementary::RotateX { .. } | Elementary::Frame { .. } => break,
        }
    }
    start
}
