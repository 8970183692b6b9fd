//! Targets that mean nothing, targets that mean the same in other words, and targets that are right up to a little.

use denhart::{InverseKinematics, PlanarPose, PointAngle, PointAxis, Pose, Status};
use denhart_dynamic::DynamicTarget;

use crate::inverse::{Answer, Derived, Inverse, Request};
use crate::poses::Space;
use crate::random::Random;
use crate::recover::{self, Form};
use crate::report::Report;
use crate::singular::Svd;
use crate::subject::{Specified, Subject};
use crate::task::{Asked, Goal};

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};
use std::f64::consts::TAU;

/// Values that are not finite.
const NO_NUMBERS: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A target that can be spoiled.
pub trait Spoil: Clone + std::fmt::Debug {
    /// Copies that cannot be meant, each with what is wrong about it.
    fn spoiled(&self) -> Vec<(String, Self)>;

    /// Copies that mean the same.
    fn same(&self) -> Vec<Self> {
        Vec::new()
    }

    /// A copy whose rotation is off by up to `size` in every entry, and the pose that the copy stands for. `None` where
    /// the target has no rotation matrix.
    fn almost(&self, _size: f64, _random: &mut Random) -> Option<(Self, Isometry3<f64>)> {
        None
    }

    /// Returns true if `inverse_near` reads the part that is spoiled. A given joint comes from the reference instead.
    fn is_bad_beside_a_reference(&self) -> bool {
        true
    }
}

/// The pose with the nearest rotation: the polar factor, from the singular value decomposition.
pub fn nearest(pose: &Pose<f64>) -> Isometry3<f64> {
    let rotation = Matrix3::from_fn(|row, column| pose.rotation[row][column]);
    let svd = rotation.svd(true, true);
    let polar = svd.u.expect("asked for") * svd.v_t.expect("asked for");
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(polar));
    Isometry3::from_parts(Translation3::from(pose.translation), rotation)
}

/// Copies with one number after the other replaced by what is none.
fn numbers<T: Clone, const K: usize>(target: &T, name: &str, at: impl Fn(&mut T) -> [&mut f64; K]) -> Vec<(String, T)> {
    let spoil = |(value, index): (f64, usize)| {
        let mut target = target.clone();
        *at(&mut target)[index] = value;
        (format!("{value} in the {name}"), target)
    };
    NO_NUMBERS.iter().flat_map(|value| (0..K).map(|index| (*value, index))).map(spoil).collect()
}

impl Spoil for Pose<f64> {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let mut targets = numbers(self, "translation", |t| t.translation.each_mut());
        for row in 0..3 {
            targets.extend(numbers(self, "rotation", |t| t.rotation[row].each_mut()));
        }
        let mut spoil = |what: String, change: &dyn Fn(&mut Self)| {
            let mut target = *self;
            change(&mut target);
            targets.push((what, target));
        };
        for scale in [1.0 + 2e-3, 1.0 - 2e-3, 2.0, 0.5, 0.0, 1e200] {
            spoil(format!("rotation times {scale}"), &|t| t.rotation = t.rotation.map(|row| row.map(|x| scale * x)));
        }
        spoil("x column longer by 2e-3".into(), &|t| (0..3).for_each(|row| t.rotation[row][0] *= 1.0 + 2e-3));
        spoil("z column shorter by 2e-3".into(), &|t| (0..3).for_each(|row| t.rotation[row][2] *= 1.0 - 2e-3));
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            spoil(format!("column {to} leans towards {from} by 2e-3"), &|t| {
                (0..3).for_each(|row| t.rotation[row][to] += 2e-3 * t.rotation[row][from]);
            });
        }
        for column in 0..3 {
            spoil(format!("column {column} mirrored"), &|t| (0..3).for_each(|row| t.rotation[row][column] *= -1.0));
        }
        spoil("mirrored through the origin".into(), &|t| t.rotation = t.rotation.map(|row| row.map(|x| -x)));
        spoil("rows exchanged".into(), &|t| t.rotation.swap(0, 1));
        targets
    }

    fn almost(&self, size: f64, random: &mut Random) -> Option<(Self, Isometry3<f64>)> {
        let mut almost = *self;
        almost.rotation.as_flattened_mut().iter_mut().for_each(|x| *x += random.uniform(-size, size));
        Some((almost, nearest(&almost)))
    }
}

impl<const K: usize> Spoil for [f64; K]
where
    Self: Asked,
{
    fn spoiled(&self) -> Vec<(String, Self)> {
        numbers(self, "point", |t| t.each_mut())
    }
}

impl Spoil for PointAxis<f64> {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let mut targets = numbers(self, "point", |t| t.point.each_mut());
        targets.extend(numbers(self, "axis", |t| t.axis.each_mut()));
        for length in [0.0, 1e-13, 1e-200, 1e-320] {
            targets.push((format!("axis of length {length}"), Self { axis: self.axis.map(|x| x * length), ..*self }));
        }
        targets
    }

    /// A direction of any length is one, from 1e-12 on and to where squares overflow.
    fn same(&self) -> Vec<Self> {
        let scaled = |length: f64| Self { axis: self.axis.map(|x| x * length), ..*self };
        [4e-12, 1e-6, 0.5, 1.0 - 1e-5, 3.0, 1e6, 1e200, 1e300].map(scaled).to_vec()
    }
}

impl Spoil for PointAngle<f64> {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let mut targets = numbers(self, "point", |t| t.point.each_mut());
        targets.extend(numbers(self, "angle", |t| [&mut t.angle]));
        targets
    }

    fn same(&self) -> Vec<Self> {
        [-2.0, -1.0, 1.0, 7.0].map(|turns| Self { angle: self.angle + turns * TAU, ..*self }).to_vec()
    }
}

impl Spoil for PlanarPose<f64> {
    fn spoiled(&self) -> Vec<(String, Self)> {
        numbers(self, "pose", |t| [&mut t.x, &mut t.y, &mut t.phi])
    }

    fn same(&self) -> Vec<Self> {
        [-2.0, -1.0, 1.0, 7.0].map(|turns| Self { phi: self.phi + turns * TAU, ..*self }).to_vec()
    }
}

impl<T: Spoil, const K: usize> Spoil for (T, [f64; K]) {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let mut targets: Vec<_> = self.0.spoiled().into_iter().map(|(what, target)| (what, (target, self.1))).collect();
        targets.extend(numbers(self, "given joints", |t| t.1.each_mut()));
        targets
    }

    fn same(&self) -> Vec<Self> {
        self.0.same().into_iter().map(|target| (target, self.1)).collect()
    }

    fn almost(&self, size: f64, random: &mut Random) -> Option<(Self, Isometry3<f64>)> {
        self.0.almost(size, random).map(|(target, nearest)| ((target, self.1), nearest))
    }

    fn is_bad_beside_a_reference(&self) -> bool {
        self.1.iter().all(|value| value.is_finite())
    }
}

impl<T: Spoil> Spoil for (T, f64) {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let mut targets: Vec<_> = self.0.spoiled().into_iter().map(|(what, target)| (what, (target, self.1))).collect();
        targets.extend(numbers(self, "given joint", |t| [&mut t.1]));
        targets
    }

    fn same(&self) -> Vec<Self> {
        self.0.same().into_iter().map(|target| (target, self.1)).collect()
    }

    fn almost(&self, size: f64, random: &mut Random) -> Option<(Self, Isometry3<f64>)> {
        self.0.almost(size, random).map(|(target, nearest)| ((target, self.1), nearest))
    }

    fn is_bad_beside_a_reference(&self) -> bool {
        self.1.is_finite()
    }
}

/// Applies a function to the target of each task.
macro_rules! each_task {
    ($target:expr, $inner:ident, $make:ident => $result:expr) => {
        each_task! {
            $target, $inner, $make => $result;
            Pose Position PositionAxis PositionAngle PlanarPose PlanarPosition
        }
    };
    ($target:expr, $inner:ident, $make:ident => $result:expr; $($task:ident)*) => {
        match $target {
            $(DynamicTarget::$task($inner) => {
                let $make = DynamicTarget::$task;
                $result
            })*
        }
    };
}
pub(crate) use each_task;

/// The target alone, or with the given value.
impl Spoil for Request {
    fn spoiled(&self) -> Vec<(String, Self)> {
        let given = self.given;
        let count = given.as_slice().len();
        let mut targets: Vec<_> = each_task!(&self.target, target, make => {
            target.spoiled().into_iter().map(|(what, t)| (what, Self { target: make(t), given })).collect()
        });
        for place in 0..count {
            targets.extend(numbers(self, "given joint", |t| {
                [t.given.iter_mut().nth(place).expect("a place below the count")]
            }));
        }
        targets
    }

    fn same(&self) -> Vec<Self> {
        each_task!(&self.target, target, make => {
            target.same().into_iter().map(|target| Self { target: make(target), ..*self }).collect()
        })
    }

    fn almost(&self, size: f64, random: &mut Random) -> Option<(Self, Isometry3<f64>)> {
        each_task!(&self.target, target, make => {
            target.almost(size, random).map(|(target, nearest)| (Self { target: make(target), ..*self }, nearest))
        })
    }

    fn is_bad_beside_a_reference(&self) -> bool {
        self.given.iter().all(f64::is_finite)
    }
}

/// Joint vectors of an arm that the suites make bad targets of.
const POSES: usize = 20;

/// [`check_some`] of a generated arm.
pub fn check<A, const N: usize>()
where
    A: Specified<N> + InverseKinematics<f64, N, Target: Asked + Spoil>,
{
    let subject = Subject::new::<A>();
    let mut report = Report::new(&subject.name);
    let mut random = Random::named(&subject.name);
    let inverse = Derived { arm: A::default(), kind: A::TASK.kind, one_branch: None };
    check_some(&subject, &inverse, POSES, &mut random, &mut report);
    report.assert_empty();
}

/// Checks targets that are spoiled. A target that cannot be meant is a BadTarget without solutions, and so is a
/// reference that is not finite. A target with an unchanged meaning has the same solutions. A pose that is off by
/// little stands for the pose with the nearest rotation.
pub fn check_some<I: Inverse<N, Target: Spoil>, const N: usize>(
    subject: &Subject<N>,
    inverse: &I,
    poses: usize,
    random: &mut Random,
    report: &mut Report,
) {
    let is_bad = |answer: &Answer<N>| answer.status == Status::BadTarget && answer.solutions.is_empty();
    let space = Space::of(subject);
    for _ in 0..poses {
        let q = space.random(random);
        let goal = subject.goal(&q);
        let target = inverse.target(&goal);
        for (what, spoiled) in target.spoiled() {
            report.count(&q);
            let mut answers = vec![inverse.all(&spoiled)];
            if spoiled.is_bad_beside_a_reference() {
                answers.push(inverse.near(&spoiled, &q));
            }
            for answer in answers.iter().filter(|answer| !is_bad(answer)) {
                report.fail("bad targets", "not a BadTarget", || format!("{what}: {spoiled:?}\n      {answer}"));
            }
        }
        for joint in 0..N {
            for value in NO_NUMBERS {
                let mut q_ref = q;
                q_ref[joint] = value;
                let answer = inverse.near(&target, &q_ref);
                if !is_bad(&answer) {
                    report.fail("bad references", "not a BadTarget", || format!("{q_ref:?}\n      {answer}"));
                }
            }
        }
        if Svd::at(subject, &q).least() < 1e-2 {
            continue;
        }
        let plain = subject.inverse(&goal);
        for same in target.same() {
            report.count(&q);
            let answer = inverse.all(&same);
            let is_there = |q: &[f64; N]| answer.exact().any(|s| subject.distance(&s.q, q, |_| true) < 1e-9);
            if answer.solutions.len() != plain.solutions.len() || !plain.exact().all(|s| is_there(&s.q)) {
                report
                    .fail("the same target", "other solutions", || format!("{same:?}\n      {answer}\n      {plain}"));
            }
        }
        // As printed with four digits, five, six, or rounded to single precision.
        for size in [5e-5, 5e-6, 5e-7, 6e-8, 1e-9, 1e-13] {
            let Some((almost, nearest)) = target.almost(size, random) else { continue };
            let (stands_for, answer) = (Goal { pose: nearest, ..goal }, inverse.all(&almost));
            recover::examine(subject, report, "almost rotations", &stands_for, &answer, Form::Principal);
            // The joints follow the target by its deviation over the least singular value, and some more where they bend.
            // An arm with fewer joints than equations cannot follow.
            let follows = subject.task.equations() == N;
            let reached = answer.exact().any(|s| subject.distance(&s.q, &q, |_| true) < 1e4 * size);
            let listed = answer.solutions.iter().any(|s| subject.distance(&s.q, &q, |_| true) < 1e4 * size);
            let expected = if follows { reached } else { listed || size > 1e-7 };
            if answer.status == Status::BadTarget || !expected {
                report.fail("almost rotations", "not used as the nearest rotation", || {
                    format!("by {size:e}\n      {}", recover::describe(subject, &stands_for, &q, &answer))
                });
            }
        }
    }
}
