//! Dynamic programming over branches and turns.

use std::collections::HashMap;

use denhart::solve::wrap;
use denhart::{Branch, InverseKinematics, JointKind, Solution, Status, Windings};

use super::{JointSample, Obstacle, PlanError, PlanSettings};

/// The largest step of a joint between two places, rad.
const STEP: f64 = 0.05;
/// How often an interval is halved at most.
const DEPTH: u32 = 26;
/// The most places that halving adds.
const MOST_ADDED: usize = 100_000;
/// The most joint vectors that a plan begins with: turns of all solutions of the first target.
const MOST_STARTS: usize = 4096;
/// A start is this near to a solution, rad.
const NEAR: f64 = 1e-3;
/// Joint vectors nearer than this, rad, are one.
const ONE: f64 = 1e-9;
/// A value is this near to its limit, relative to 1 and itself, by rounding.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// A way past a swing ends before this many times the interval in which it was met.
const PAST: f64 = 3.5;
/// Places between two reports of progress.
const BETWEEN_REPORTS: usize = 64;

/// A joint vector at a place, with the cheapest way to it.
#[derive(Debug, Clone, Copy)]
struct Node<const N: usize> {
    q: [f64; N],
    branch: Branch,
    /// It is one of a family, and stands where the way before it was.
    is_free: bool,
    cost: f64,
    /// The layer and the number of the node before it.
    from: (usize, usize),
}

struct Layer<const N: usize> {
    at: f64,
    nodes: Vec<Node<N>>,
}

/// A node from which no way leads to the next place. Where a joint swings there, a way may lead past the swing.
struct Waiting<const N: usize> {
    node: Node<N>,
    at: f64,
    /// Its layer and its number there.
    index: (usize, usize),
    /// The last parameter that such a way may end at.
    until: f64,
}

/// A place ahead.
struct Place<G, const N: usize> {
    at: f64,
    target: G,
    solutions: Vec<Solution<f64, N>>,
    /// How often the interval before it was halved.
    depth: u32,
}

struct Search<'a, A, F, const N: usize> {
    arm: &'a A,
    path: &'a F,
    settings: &'a PlanSettings<N>,
    limits: [[f64; 2]; N],
    kinds: [JointKind; N],
}

/// The joint path of the least cost.
pub fn search<A: InverseKinematics<f64, N>, F: Fn(f64) -> A::Target, const N: usize>(
    arm: &A,
    path: &F,
    end: f64,
    settings: &PlanSettings<N>,
    progress: &mut dyn FnMut(f64),
) -> Result<Vec<JointSample<N>>, PlanError> {
    let search = Search { arm, path, settings, limits: arm.limits(), kinds: arm.joint_kinds() };
    let intervals = settings.intervals.clamp(16, MOST_ADDED);
    let first = search.place(0.0, 0)?;
    let mut layers = vec![Layer { at: 0.0, nodes: search.starts(&first)? }];
    let mut waiting: Vec<Waiting<N>> = Vec::new();
    // The place that no way but one past a swing leads beyond.
    let mut ended = None;
    let mut added = 0;
    for number in 1..=intervals {
        let at = if number == intervals { end } else { end * number as f64 / intervals as f64 };
        // The places up to here, the next one last.
        let mut ahead = vec![search.place(at, 0)?];
        while let Some(place) = ahead.last_mut() {
            let Some(before) = layers.last() else { break };
            let (middle, index) = (0.5 * (before.at + place.at), layers.len() - 1);
            waiting.retain(|waiting| waiting.until >= place.at);
            let Next { nodes, left, halve } = search.advance(before, index, &waiting, place);
            if halve && place.depth < DEPTH && added < MOST_ADDED && middle > before.at && middle < place.at {
                let until = before.at + PAST * (place.at - before.at);
                for (number, node) in left {
                    let index = (index, number);
                    if waiting.last().is_none_or(|last| last.index < index) {
                        waiting.push(Waiting { node, at: before.at, index, until });
                    }
                }
                place.depth += 1;
                added += 1;
                let depth = place.depth;
                ahead.push(search.place(middle, depth)?);
                continue;
            }
            if nodes.is_empty() && !before.nodes.is_empty() {
                ended = Some(search.obstacle(before, place));
            }
            if nodes.is_empty() && waiting.is_empty() {
                let nowhere = PlanError::NoPath { at: before.at, branch: Branch::NONE, obstacle: Obstacle::Reach };
                return Err(ended.unwrap_or(nowhere));
            }
            layers.push(Layer { at: place.at, nodes });
            ahead.pop();
            if layers.len() % BETWEEN_REPORTS == 0 {
                progress(layers.last().map_or(0.0, |layer| layer.at));
            }
        }
    }
    match (layers.last().is_some_and(|last| last.nodes.is_empty()), ended) {
        (true, Some(error)) => Err(error),
        _ => Ok(cheapest(&layers)),
    }
}

/// The cheapest way, read from its end.
fn cheapest<const N: usize>(layers: &[Layer<N>]) -> Vec<JointSample<N>> {
    let by_cost = |(_, a): &(usize, &Node<N>), (_, b): &(usize, &Node<N>)| a.cost.total_cmp(&b.cost);
    let last = layers.last().and_then(|layer| layer.nodes.iter().enumerate().min_by(by_cost));
    let mut index = (layers.len().saturating_sub(1), last.map_or(0, |(index, _)| index));
    let mut samples = Vec::with_capacity(layers.len());
    for _ in layers {
        let Some(layer) = layers.get(index.0) else { break };
        let Some(node) = layer.nodes.get(index.1) else { break };
        samples.push((JointSample { at: layer.at, q: node.q, branch: node.branch }, node.is_free));
        if index.0 == 0 {
            break;
        }
        index = node.from;
    }
    samples.reverse();
    // A member of a singular family between two solutions that are none is left out: it stands where the way before it was,
    // and the curve crosses the family in the direction of both.
    let is_free = |index: Option<usize>| index.and_then(|index| samples.get(index)).is_none_or(|(_, free)| *free);
    let stays = |index: usize| !is_free(Some(index)) || is_free(index.checked_sub(1)) || is_free(Some(index + 1));
    (0..samples.len()).filter(|index| stays(*index)).filter_map(|index| Some(samples.get(index)?.0)).collect()
}

/// Nodes of the next place, and the ones before it that no way leads on from.
struct Next<const N: usize> {
    nodes: Vec<Node<N>>,
    /// The nodes before it, with their numbers, that no way leads on from, and not for the limits.
    left: Vec<(usize, Node<N>)>,
    /// The interval needs to be halved.
    halve: bool,
}

/// The nodes of a place, each once.
struct Nodes<const N: usize> {
    nodes: Vec<Node<N>>,
    /// By the number of the solution and the turns of the joints.
    known: HashMap<(usize, [i64; N]), usize>,
}

impl<const N: usize> Nodes<N> {
    /// Adds a node at a solution of this number, or one of a singular family; of two at one joint vector the cheaper stays.
    fn take<A, F>(
        &mut self,
        new: Node<N>,
        solution: &Solution<f64, N>,
        number: Option<usize>,
        search: &Search<A, F, N>,
    ) {
        let index = match number {
            Some(number) => {
                let mut turns = [0; N];
                for (turns, (q, own)) in turns.iter_mut().zip(new.q.iter().zip(&solution.q)) {
                    *turns = ((q - own) / std::f64::consts::TAU).round() as i64;
                }
                *self.known.entry((number, turns)).or_insert(self.nodes.len())
            }
            None => {
                let is_there = |old: &Node<N>| search.distance(&old.q, &new.q) <= ONE;
                self.nodes.iter().position(is_there).unwrap_or(self.nodes.len())
            }
        };
        match self.nodes.get_mut(index) {
            Some(old) if old.cost <= new.cost => {}
            Some(old) => *old = new,
            None => self.nodes.push(new),
        }
    }
}

/// A way between two places: targets between them by the part of the way, and the time that the path takes.
struct Stretch<'a, G> {
    targets: Vec<(f64, G)>,
    span: f64,
    inner: Box<dyn Fn(f64) -> (f64, G) + 'a>,
}

/// Outcome of a way to a solution.
enum Way<const N: usize> {
    /// It stands, and ends here.
    Stands([f64; N]),
    /// It would stand but for the limits.
    Outside,
    /// The tool leaves the path, or a joint moves too far.
    Leaves,
}

impl<A, F, const N: usize> Search<'_, A, F, N> {
    /// The largest difference of a joint, rad.
    fn distance(&self, a: &[f64; N], b: &[f64; N]) -> f64 {
        let length = self.settings.length();
        let each = a.iter().zip(b).zip(&self.kinds).map(|((a, b), kind)| match kind {
            JointKind::Revolute => (a - b).abs(),
            _ => (a - b).abs() / length,
        });
        each.fold(0.0, f64::max)
    }
}

impl<A: InverseKinematics<f64, N>, F: Fn(f64) -> A::Target, const N: usize> Search<'_, A, F, N> {
    /// The target of a place and its exact solutions.
    fn place(&self, at: f64, depth: u32) -> Result<Place<A::Target, N>, PlanError> {
        let target = (self.path)(at);
        let found = self.arm.inverse(&target);
        if A::status(&found) == Status::BadTarget {
            return Err(PlanError::Target { at });
        }
        let solutions = found.as_ref().iter().filter(|solution| solution.is_exact()).copied().collect();
        Ok(Place { at, target, solutions, depth })
    }

    /// The nodes of the first place.
    fn starts(&self, place: &Place<A::Target, N>) -> Result<Vec<Node<N>>, PlanError> {
        let node = |q, branch| Node { q, branch, is_free: false, cost: 0.0, from: (0, 0) };
        let Some(start) = &self.settings.start else {
            let turns = place.solutions.iter().flat_map(|solution| {
                let windings = Windings::new(&solution.q, &self.limits, &self.kinds);
                windings.map(|q| node(q, solution.branch)).filter(|node| self.sums_hold(&node.q))
            });
            let nodes: Vec<Node<N>> = turns.take(MOST_STARTS).collect();
            if nodes.is_empty() {
                return Err(self.no_start(place));
            }
            return Ok(nodes);
        };
        let outside = |(q, [low, high]): (&f64, &[f64; 2])| !(*q >= *low - slack(*q) && *q <= *high + slack(*q));
        if let Some(joint) = start.iter().zip(&self.limits).position(outside) {
            return Err(PlanError::StartOutside { joint });
        }
        let near = self.near(&place.target, start);
        let nearest = near
            .as_ref()
            .iter()
            .filter(|solution| solution.is_exact())
            .filter_map(|solution| {
                let q = self.next_to(start, &solution.q);
                Some((self.distance(start, &q), self.inside(q)?, solution.branch))
            })
            .min_by(|(a, ..), (b, ..)| a.total_cmp(b));
        match nearest {
            Some((distance, q, branch)) if distance <= NEAR => Ok(vec![node(q, branch)]),
            Some((distance, q, _)) => Err(PlanError::StartAway { distance, nearest: q.to_vec() }),
            None => Err(self.no_start(place)),
        }
    }

    /// Why no joint vector reaches the first target.
    fn no_start(&self, place: &Place<A::Target, N>) -> PlanError {
        let Some(solution) = place.solutions.first() else {
            return PlanError::NoPath { at: place.at, branch: Branch::NONE, obstacle: Obstacle::Reach };
        };
        let obstacle = self.broken(&solution.q);
        PlanError::NoPath { at: place.at, branch: solution.branch, obstacle }
    }

    /// The solutions next to a joint vector, with the target's own given values.
    fn near(&self, target: &A::Target, q: &[f64; N]) -> A::Solutions {
        let mut near = self.arm.inverse(target);
        self.arm.inverse_given_near_into(target, q, &mut near);
        near
    }

    /// The solution with each joint on the turn next to `q`.
    fn next_to(&self, q: &[f64; N], solution: &[f64; N]) -> [f64; N] {
        let mut next = *solution;
        for ((next, q), kind) in next.iter_mut().zip(q).zip(&self.kinds) {
            if *kind == JointKind::Revolute {
                *next = q + wrap(*next - q);
            }
        }
        next
    }

    /// The joint vector, if it is within all limits. A value beyond one by rounding is put there.
    fn inside(&self, mut q: [f64; N]) -> Option<[f64; N]> {
        for (q, [low, high]) in q.iter_mut().zip(&self.limits) {
            if !(*q >= *low - slack(*q) && *q <= *high + slack(*q)) {
                return None;
            }
            *q = q.max(*low).min(*high);
        }
        self.sums_hold(&q).then_some(q)
    }

    fn sums_hold(&self, q: &[f64; N]) -> bool {
        self.arm.combined_limits().iter().all(|limit| limit.holds(q))
    }

    /// The nodes at the next place, and those of the layer before that no way leads on from.
    fn advance(&self, before: &Layer<N>, layer: usize, waiting: &[Waiting<N>], place: &Place<A::Target, N>) -> Next<N> {
        let mut next = Nodes { nodes: Vec::new(), known: HashMap::new() };
        let has_free = place.solutions.iter().any(|solution| !solution.free.is_empty());
        let mut left = Vec::new();
        let (mut limited, mut swings) = (false, false);
        let way = self.stretch(before.at, place.at, 2);
        for (number, node) in before.nodes.iter().enumerate() {
            let (mut goes_on, mut outside) = (false, false);
            let mut take = |solution: &Solution<f64, N>, key: Option<usize>| match self.way(node, solution, &way) {
                Way::Stands(q) => {
                    goes_on = true;
                    next.take(self.node(node, (layer, number), q, solution, &way), solution, key, self);
                }
                Way::Outside => outside = true,
                Way::Leaves => {}
            };
            for (number, solution) in place.solutions.iter().enumerate() {
                take(solution, Some(number));
            }
            // Each way has its own member of a singular family.
            if has_free {
                let near = self.near(&place.target, &node.q);
                for solution in near.as_ref().iter().filter(|one| one.is_exact() && !one.free.is_empty()) {
                    take(solution, None);
                }
            }
            limited |= !goes_on && outside;
            if !goes_on && !outside {
                swings = true;
                left.push((number, *node));
            }
        }
        for waiting in waiting.iter().filter(|waiting| waiting.index.0 < layer) {
            let near = |(_, solution): &(usize, &Solution<f64, N>)| {
                let q = self.next_to(&waiting.node.q, &solution.q);
                self.distance(&waiting.node.q, &q) <= STEP
            };
            let Some((number, solution)) = place.solutions.iter().enumerate().find(near) else { continue };
            let way = self.stretch(waiting.at, place.at, 8);
            if let Way::Stands(q) = self.way(&waiting.node, solution, &way) {
                next.take(self.node(&waiting.node, waiting.index, q, solution, &way), solution, Some(number), self);
            }
        }
        let halve = swings || (limited && next.nodes.is_empty());
        Next { nodes: next.nodes, left, halve }
    }

    /// The inner targets of a way, so many parts of it apart.
    fn stretch(&self, from: f64, to: f64, parts: u32) -> Stretch<'_, A::Target> {
        let inner = move |part: f64| (part, (self.path)(from + part * (to - from)));
        let targets = (1..parts).map(|k| inner(f64::from(k) / f64::from(parts))).collect();
        let span = if self.settings.is_timed { to - from } else { 0.0 };
        Stretch { targets, span, inner: Box::new(inner) }
    }

    /// The node at the end of a way.
    fn node(
        &self,
        from: &Node<N>,
        index: (usize, usize),
        q: [f64; N],
        solution: &Solution<f64, N>,
        way: &Stretch<A::Target>,
    ) -> Node<N> {
        // Of two ways of the same time the one of less motion.
        let time = self.settings.time(&from.q, &q).max(way.span);
        let cost = from.cost + time + 1e-6 * self.distance(&from.q, &q);
        Node { q, branch: solution.branch, is_free: !solution.free.is_empty(), cost, from: index }
    }

    fn way(&self, node: &Node<N>, solution: &Solution<f64, N>, way: &Stretch<A::Target>) -> Way<N> {
        let q = self.next_to(&node.q, &solution.q);
        if self.distance(&node.q, &q) > STEP {
            return Way::Leaves;
        }
        let on_path = |part: f64, target: &A::Target| {
            let between = super::curve::between(&node.q, &q, part);
            self.settings.allows(&self.arm.residual(&between, target))
        };
        let on_quarter = |part: f64| {
            let (part, target) = (way.inner)(part);
            on_path(part, &target)
        };
        // Around a crossing the middle alone may be on the path by symmetry.
        let stays = way.targets.iter().all(|(part, target)| on_path(*part, target))
            && (node.branch == solution.branch || [0.25, 0.75].into_iter().all(on_quarter));
        match (stays, self.inside(q)) {
            (true, Some(q)) => Way::Stands(q),
            (true, None) => Way::Outside,
            (false, _) => Way::Leaves,
        }
    }

    /// The limit that a joint vector breaks.
    fn broken(&self, q: &[f64; N]) -> Obstacle {
        let outside = |(q, [low, high]): (&f64, &[f64; 2])| !(*q >= *low - slack(*q) && *q <= *high + slack(*q));
        let Some(joint) = q.iter().zip(&self.limits).position(outside) else { return Obstacle::CombinedLimit };
        let turns = q
            .iter()
            .zip(&self.limits)
            .zip(&self.kinds)
            .nth(joint)
            .is_some_and(|((q, limits), kind)| Windings::new(&[*q], &[*limits], &[*kind]).next().is_some());
        if turns { Obstacle::WholeTurn(joint) } else { Obstacle::Limit(joint) }
    }

    /// Why no way goes on from these nodes, by the cheapest of them.
    fn obstacle(&self, before: &Layer<N>, place: &Place<A::Target, N>) -> PlanError {
        let no_path = |branch, obstacle| PlanError::NoPath { at: before.at, branch, obstacle };
        let Some(node) = before.nodes.iter().min_by(|a, b| a.cost.total_cmp(&b.cost)) else {
            return no_path(Branch::NONE, Obstacle::Reach);
        };
        let near = self.near(&place.target, &node.q);
        let exact = || near.as_ref().iter().filter(|solution| solution.is_exact());
        let ways = exact().map(|solution| {
            let q = self.next_to(&node.q, &solution.q);
            (self.distance(&node.q, &q), q, solution.branch)
        });
        let Some((distance, q, _)) = ways.clone().min_by(|(a, ..), (b, ..)| a.total_cmp(b)) else {
            return no_path(node.branch, Obstacle::Reach);
        };
        if distance <= STEP && self.inside(q).is_none() {
            return no_path(node.branch, self.broken(&q));
        }
        let same = ways.filter(|(_, _, branch)| *branch == node.branch).min_by(|(a, ..), (b, ..)| a.total_cmp(b));
        let before_it = self.near(&(self.path)(before.at), &node.q);
        let ends = before_it.as_ref().iter().filter(|solution| solution.is_exact()).count() > exact().count();
        let obstacle = match same {
            // Of numbered branches another one may have the number.
            Some((_, q, branch)) if !(ends && branch.root().is_some()) => {
                let moved = node.q.iter().zip(&q).map(|(a, b)| (a - b).abs());
                let most = moved.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b));
                Obstacle::Singularity(most.map_or(0, |(joint, _)| joint))
            }
            _ => Obstacle::Reach,
        };
        no_path(node.branch, obstacle)
    }
}

fn slack(value: f64) -> f64 {
    ROUNDING * (1.0 + value.abs())
}
