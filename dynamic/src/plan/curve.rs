//! The joint path as a curve of cubics.

use denhart::InverseKinematics;

use super::{JointSample, PlanSettings};

/// How far the middle of a stretch may be from its chord, relative to the chord: its direction turns by 8 times that, rad.
const SAGITTA: f64 = 0.01;
/// How far the middle of a stretch may be from the middle of its chord along it, relative to the chord.
const UNEVEN: f64 = 0.1;
/// Stretches shorter than this are not halved, s at full rate.
const SHORTEST: f64 = 1e-6;
/// Places nearer than this are one, s at full rate.
const ONE: f64 = 1e-12;
/// How often a stretch is halved at most.
const DEPTH: u32 = 20;
/// How often the first and the last stretch are halved: from rest the speed rises over the first one.
const ENDS: usize = 8;
/// Rounds of halving where the curve leaves the path.
const ROUNDS: usize = 8;
/// The most knots of a curve, with those of the search.
const MOST: usize = 400_000;
/// A solution in the middle of a stretch belongs to it up to this part of its length.
const BESIDE: f64 = 0.25;

/// A place of the curve and the derivatives there, by the length `s`: the way at full rate, Euclidean over the joints, and
/// over the path's parameter too where that is a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Knot<const N: usize> {
    pub s: f64,
    pub at: f64,
    pub q: [f64; N],
    pub at_ds: f64,
    pub q_ds: [f64; N],
}

/// Cubics through knots, with one tangent at each (Hermite).
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<const N: usize> {
    pub knots: Vec<Knot<N>>,
}

/// A joint vector between two.
pub fn between<const N: usize>(a: &[f64; N], b: &[f64; N], part: f64) -> [f64; N] {
    let mut q = *a;
    for (q, b) in q.iter_mut().zip(b) {
        *q += part * (*b - *q);
    }
    q
}

/// The factors of both ends and both tangents (over the length) at `part` of a cubic.
fn hermite(part: f64) -> [f64; 4] {
    let rest = 1.0 - part;
    [(1.0 + 2.0 * part) * rest * rest, part * part * (3.0 - 2.0 * part), part * rest * rest, -part * part * rest]
}

/// The factors of the first derivative.
fn hermite_1(part: f64) -> [f64; 4] {
    let rest = 1.0 - part;
    [-6.0 * part * rest, 6.0 * part * rest, rest * (1.0 - 3.0 * part), part * (3.0 * part - 2.0)]
}

/// The factors of the second derivative.
fn hermite_2(part: f64) -> [f64; 4] {
    [12.0 * part - 6.0, 6.0 - 12.0 * part, 6.0 * part - 4.0, 6.0 * part - 2.0]
}

/// A stretch between two knots.
#[derive(Debug, Clone, Copy)]
pub struct Stretch<'a, const N: usize> {
    pub from: &'a Knot<N>,
    pub to: &'a Knot<N>,
}

impl<const N: usize> Stretch<'_, N> {
    pub fn length(&self) -> f64 {
        self.to.s - self.from.s
    }

    fn joints(&self, [a, b, c, d]: [f64; 4], scale: f64) -> [f64; N] {
        let (c, d) = (c * self.length(), d * self.length());
        let ends = self.from.q.iter().zip(&self.to.q);
        let tangents = self.from.q_ds.iter().zip(&self.to.q_ds);
        let mut values = [0.0; N];
        for (value, ((q0, q1), (t0, t1))) in values.iter_mut().zip(ends.zip(tangents)) {
            *value = (a * q0 + b * q1 + c * t0 + d * t1) * scale;
        }
        values
    }

    pub fn q(&self, part: f64) -> [f64; N] {
        self.joints(hermite(part), 1.0)
    }

    pub fn q_ds(&self, part: f64) -> [f64; N] {
        self.joints(hermite_1(part), 1.0 / self.length())
    }

    pub fn q_ds2(&self, part: f64) -> [f64; N] {
        self.joints(hermite_2(part), 1.0 / (self.length() * self.length()))
    }

    /// The path's parameter.
    pub fn at(&self, part: f64) -> f64 {
        let [a, b, c, d] = hermite(part);
        a * self.from.at + b * self.to.at + self.length() * (c * self.from.at_ds + d * self.to.at_ds)
    }

    /// Its derivative by the length.
    pub fn at_ds(&self, part: f64) -> f64 {
        let [a, b, c, d] = hermite_1(part);
        (a * self.from.at + b * self.to.at) / self.length() + c * self.from.at_ds + d * self.to.at_ds
    }
}

type Point<const N: usize> = (f64, [f64; N]);

impl<const N: usize> Curve<N> {
    /// The curve through the places of a plan, with more between them where it turns.
    pub fn through<A: InverseKinematics<f64, N>>(
        samples: &[JointSample<N>],
        arm: &A,
        path: &impl Fn(f64) -> A::Target,
        settings: &PlanSettings<N>,
    ) -> Self {
        let found = arm.inverse(&path(0.0));
        let mut maker = Maker { arm, path, settings, limits: arm.limits(), found };
        let mut points = maker.refined(samples);
        for _ in 0..ROUNDS {
            let curve = Curve::of(&points, settings);
            let mut left = false;
            let mut more = Vec::with_capacity(points.len());
            for stretch in curve.stretches() {
                more.push((stretch.from.at, stretch.from.q));
                let leaves = |part: f64| !settings.allows(&arm.residual(&stretch.q(part), &path(stretch.at(part))));
                let may = stretch.length() > SHORTEST && curve.knots.len() < MOST;
                if may && [0.25, 0.5, 0.75].into_iter().any(leaves) {
                    more.push(maker.middle(&(stretch.from.at, stretch.from.q), &(stretch.to.at, stretch.to.q)));
                    left = true;
                }
            }
            more.extend(curve.knots.last().map(|knot| (knot.at, knot.q)));
            points = more;
            if !left {
                return curve;
            }
        }
        Curve::of(&points, settings)
    }

    /// The curve through points. Its tangent at a point is that of the parabola through it and its neighbors.
    fn of(points: &[Point<N>], settings: &PlanSettings<N>) -> Self {
        let mut knots: Vec<Knot<N>> = Vec::with_capacity(points.len());
        for (at, q) in points {
            let way = knots.last().map(|last| (last.s, chord(settings, &(last.at, last.q), &(*at, *q))));
            match way {
                Some((_, way)) if way < ONE => continue,
                way => knots.push(Knot {
                    s: way.map_or(0.0, |(s, way)| s + way),
                    at: *at,
                    q: *q,
                    at_ds: 0.0,
                    q_ds: [0.0; N],
                }),
            }
        }
        let slopes: Vec<(f64, f64, [f64; N])> = knots
            .windows(2)
            .filter_map(|pair| {
                let [from, to] = pair else { return None };
                let length = to.s - from.s;
                let mut slope = [0.0; N];
                for (slope, (a, b)) in slope.iter_mut().zip(from.q.iter().zip(&to.q)) {
                    *slope = (b - a) / length;
                }
                Some((length, (to.at - from.at) / length, slope))
            })
            .collect();
        let last = slopes.len();
        for (index, knot) in knots.iter_mut().enumerate() {
            let inner = index.clamp(1, last.saturating_sub(1).max(1));
            let (Some(before), Some(after)) = (slopes.get(inner - 1), slopes.get(inner)) else {
                // A curve of one stretch is a line.
                if let Some((_, at_ds, q_ds)) = slopes.first() {
                    (knot.at_ds, knot.q_ds) = (*at_ds, *q_ds);
                }
                continue;
            };
            let (left, right) = (before.0, after.0);
            // The parabola's slope changes by this part of the difference from the first slope on.
            let part = match index {
                0 => -left / (left + right),
                _ if index == last => (left + 2.0 * right) / (left + right),
                _ => left / (left + right),
            };
            knot.at_ds = before.1 + part * (after.1 - before.1);
            knot.q_ds = between(&before.2, &after.2, part);
        }
        Curve { knots }
    }

    pub fn stretches(&self) -> impl Iterator<Item = Stretch<'_, N>> {
        self.knots.iter().zip(self.knots.iter().skip(1)).map(|(from, to)| Stretch { from, to })
    }
}

/// The way between two points at full rate, s.
fn chord<const N: usize>(settings: &PlanSettings<N>, a: &Point<N>, b: &Point<N>) -> f64 {
    let way = settings.way(&a.1, &b.1);
    let joints = way.iter().zip(settings.paces()).map(|(way, pace)| way / pace);
    let own = if settings.is_timed { b.0 - a.0 } else { 0.0 };
    joints.fold(own * own, |sum, way| sum + way * way).sqrt()
}

struct Maker<'a, A: InverseKinematics<f64, N>, F, const N: usize> {
    arm: &'a A,
    path: &'a F,
    settings: &'a PlanSettings<N>,
    limits: [[f64; 2]; N],
    /// The list of solutions that is kept.
    found: A::Solutions,
}

impl<A: InverseKinematics<f64, N>, F: Fn(f64) -> A::Target, const N: usize> Maker<'_, A, F, N> {
    /// The point in the middle of the path between two: the solution there, or the middle of the joints where no solution is
    /// beside that, as in a crossing.
    fn middle(&mut self, a: &Point<N>, b: &Point<N>) -> Point<N> {
        let at = 0.5 * (a.0 + b.0);
        let q = between(&a.1, &b.1, 0.5);
        let length = a.1.iter().zip(&b.1).fold(0.0, |most: f64, (a, b)| most.max((b - a).abs()));
        self.arm.inverse_given_near_into(&(self.path)(at), &q, &mut self.found);
        let is_beside = |other: &[f64; N]| {
            let mut joints = other.iter().zip(&q).zip(&self.limits);
            joints.all(|((other, q), [low, high])| {
                (other - q).abs() <= BESIDE * length && *other >= *low && *other <= *high
            })
        };
        let solution = self.found.as_ref().iter().find(|solution| solution.is_exact() && is_beside(&solution.q));
        (at, solution.map_or(q, |solution| solution.q))
    }

    /// The points of the samples, and more between them until each stretch is nearly straight and even.
    fn refined(&mut self, samples: &[JointSample<N>]) -> Vec<Point<N>> {
        let mut points: Vec<Point<N>> = Vec::with_capacity(2 * samples.len());
        for sample in samples {
            let end = (sample.at, sample.q);
            let Some(start) = points.last().copied() else {
                points.push(end);
                continue;
            };
            // The ends of the stretches ahead, the next one last.
            let mut ahead = vec![(end, DEPTH)];
            let mut from = start;
            while let Some((to, depth)) = ahead.pop() {
                let middle = self.middle(&from, &to);
                if depth > 0 && points.len() < MOST && !self.is_straight(&from, &middle, &to) {
                    ahead.push((to, depth - 1));
                    ahead.push((middle, depth - 1));
                } else {
                    points.push(to);
                    from = to;
                }
            }
        }
        for _ in 0..ENDS {
            for is_last in [false, true] {
                let index = if is_last { points.len().saturating_sub(2) } else { 0 };
                if let (Some(a), Some(b)) = (points.get(index), points.get(index + 1)) {
                    let middle = self.middle(a, b);
                    points.insert(index + 1, middle);
                }
            }
        }
        points
    }

    fn is_straight(&self, a: &Point<N>, middle: &Point<N>, b: &Point<N>) -> bool {
        let length = chord(self.settings, a, b);
        if length <= SHORTEST {
            return true;
        }
        let timed = if self.settings.is_timed { 1.0 } else { 0.0 };
        let off = self.settings.way(&between(&a.1, &b.1, 0.5), &middle.1);
        let ways = self.settings.way(&a.1, &b.1).into_iter().zip(off).zip(self.settings.paces());
        let ways = ways.map(|((way, off), pace)| (way / pace, off / pace));
        let own = (timed * (b.0 - a.0), timed * (middle.0 - 0.5 * (a.0 + b.0)));
        let (mut along, mut square) = (0.0, 0.0);
        for (way, off) in ways.chain([own]) {
            along += way * off / length;
            square += off * off;
        }
        let across = (square - along * along).max(0.0).sqrt();
        across <= SAGITTA * length && along.abs() <= UNEVEN * length
    }
}
