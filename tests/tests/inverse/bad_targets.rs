//! Targets that are no poses, and targets that are poses up to a little.

use denhart::{Pose, Status};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::recover::{self, Form};
use denhart_tests::report::Report;
use denhart_tests::singular::Svd;
use denhart_tests::subject::Subject;

/// A numbered spoiled copy of a pose.
fn spoiled(pose: &Pose<f64>) -> Vec<(String, Pose<f64>)> {
    let mut targets = Vec::new();
    let mut spoil = |what: String, change: &dyn Fn(&mut Pose<f64>)| {
        let mut target = *pose;
        change(&mut target);
        targets.push((what, target));
    };
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in 0..9 {
            spoil(format!("{value} in the rotation"), &|t| t.rotation[index / 3][index % 3] = value);
        }
        for index in 0..3 {
            spoil(format!("{value} in the translation"), &|t| t.translation[index] = value);
        }
    }
    for scale in [1.0 + 1e-5, 1.0 - 1e-5, 2.0, 0.5, 0.0, 1e200] {
        spoil(format!("rotation times {scale}"), &|t| t.rotation = t.rotation.map(|row| row.map(|x| scale * x)));
    }
    spoil("x column longer by 1e-5".into(), &|t| (0..3).for_each(|row| t.rotation[row][0] *= 1.0 + 1e-5));
    spoil("z column shorter by 1e-5".into(), &|t| (0..3).for_each(|row| t.rotation[row][2] *= 1.0 - 1e-5));
    for (from, to) in [(0, 1), (1, 2), (2, 0)] {
        spoil(format!("column {to} leans towards {from} by 1e-5"), &|t| {
            (0..3).for_each(|row| t.rotation[row][to] += 1e-5 * t.rotation[row][from]);
        });
    }
    for column in 0..3 {
        spoil(format!("column {column} mirrored"), &|t| (0..3).for_each(|row| t.rotation[row][column] *= -1.0));
    }
    spoil("mirrored through the origin".into(), &|t| t.rotation = t.rotation.map(|row| row.map(|x| -x)));
    spoil("rows exchanged".into(), &|t| t.rotation.swap(0, 1));
    targets
}

/// Not finite, not a rotation, left-handed: a BadTarget without solutions. Within 1e-7 of a rotation: used as given.
pub fn check(subject: &Subject<6>) {
    let mut report = Report::new(subject.name);
    let mut random = Random::named(subject.name);
    let space = Space::of(subject);
    for _ in 0..20 {
        let q = space.random(&mut random);
        let target = subject.pose(&q);
        let pose = Pose::from(target);
        for (what, spoiled) in spoiled(&pose) {
            report.count();
            for answer in [subject.inverse(&spoiled), subject.inverse_near(&spoiled, &q)] {
                if answer.status != Status::BadTarget || !answer.solutions.is_empty() {
                    report.fail("bad targets", "not a BadTarget", || format!("{what}: {spoiled:?}\n      {answer}"));
                }
            }
        }
        for joint in 0..6 {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let mut q_ref = q;
                q_ref[joint] = value;
                let answer = subject.inverse_near(&pose, &q_ref);
                if answer.status != Status::BadTarget || !answer.solutions.is_empty() {
                    report.fail("bad references", "not a BadTarget", || format!("{q_ref:?}\n      {answer}"));
                }
            }
        }
        if Svd::at(subject, &q).least() < 1e-2 {
            continue;
        }
        for size in [1e-7, 1e-9, 1e-13] {
            let mut almost = pose;
            almost.rotation.as_flattened_mut().iter_mut().for_each(|x| *x += random.uniform(-size, size));
            let answer = subject.inverse(&almost);
            recover::examine(subject, &mut report, "almost rotations", &target, &answer, Form::Principal);
            // The joints follow the target by its deviation over the least singular value, and some more where they bend.
            let found = answer.solutions.iter().any(|s| subject.distance(&s.q, &q, |_| true) < 1e4 * size);
            if answer.status == Status::BadTarget || !found {
                report.fail("almost rotations", "not used as given", || {
                    format!("by {size:e}\n      {}", recover::describe(subject, &target, &q, &answer))
                });
            }
        }
    }
    report.assert_nothing_new();
}
