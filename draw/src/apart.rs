//! A posture in which the joints of an arm are seen apart.

use denhart::JointKind;
use denhart_dynamic::DynamicArm;

use crate::section::spread;
use crate::skeleton::Skeleton;
use crate::symbols::places;
use crate::vector::{Flat, cross, distance, length, off_line, sub};
use crate::view::{Camera, View};

/// Postures that are tried.
const POSTURES: u32 = 300;
/// The rectangle in which they are compared, px.
const INSIDE: [f64; 4] = [0.0, 0.0, 300.0, 230.0];
/// Farthest that a joint turns from 0, or from its limit next to 0, rad.
const TURN: f64 = 1.3;
/// Joints farther apart than this are told apart as well as can be, px.
const ENOUGH: f64 = 42.0;

/// Joint values within the limits, rad or length unit, at which joints, links and tool cover each other least in a view.
///
/// They are the best of a fixed list, so the same arm has the same ones. An arm that none of them suits stands at 0.
#[must_use]
pub fn apart(arm: &DynamicArm, view: View) -> Vec<f64> {
    let zero = vec![0.0; arm.joints()];
    let Ok(skeleton) = Skeleton::of(arm, &zero) else { return zero };
    let ranges: Vec<[f64; 2]> = arm
        .joint_kinds()
        .iter()
        .zip(arm.limits())
        .map(|(kind, [low, high])| {
            let middle = 0.0_f64.clamp(low.min(*high), high.max(*low));
            match kind {
                JointKind::Revolute => [(middle - TURN).max(*low), (middle + TURN).min(*high)],
                _ if (high - low).is_finite() => [0.7 * low + 0.3 * high, 0.2 * low + 0.8 * high],
                // A slide without an end moves by a part of the arm.
                _ => [0.3, 0.7].map(|part| middle + part * if skeleton.size() > 0.0 { skeleton.size() } else { 1.0 }),
            }
        })
        .collect();
    let posture = |number: u32| -> Vec<f64> {
        let bases = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29];
        let values = ranges.iter().zip(bases).zip(arm.joint_kinds());
        values
            .map(|(([low, high], base), kind)| round(*kind, low + (high - low) * spread(number, base), [*low, *high]))
            .collect()
    };
    let judged = (1..=POSTURES).map(posture).filter_map(|q| Some((clarity(arm, &q, view)?, q)));
    judged.max_by(|(a, _), (b, _)| a.total_cmp(b)).map_or(zero, |(_, q)| q)
}

/// The value in whole degrees, or with two digits, if that is in the range: a number to type.
fn round(kind: JointKind, value: f64, [low, high]: [f64; 2]) -> f64 {
    let rounded = match kind {
        JointKind::Revolute => value.to_degrees().round().to_radians(),
        _ => format!("{value:.1e}").parse().unwrap_or(value),
    };
    if (low..=high).contains(&rounded) { rounded } else { value }
}

/// How clear a posture is: the least distance of joints and tool, less what crosses and what is below the ground.
fn clarity(arm: &DynamicArm, q: &[f64], view: View) -> Option<f64> {
    let skeleton = Skeleton::of(arm, q).ok()?;
    let camera = Camera::fit(view, skeleton.points().copied(), INSIDE);
    let signs = places(&skeleton, &camera).into_iter().chain([skeleton.tool.translation]);
    let signs: Vec<Flat> = signs.map(|place| camera.place(place)).collect();
    let pairs = signs.iter().enumerate().flat_map(|(index, a)| signs.iter().skip(index + 1).map(|b| distance(*a, *b)));
    let least = pairs.fold(ENOUGH, f64::min);
    let mut lines: Vec<(usize, Flat, Flat)> = Vec::new();
    for (number, link) in skeleton.links.iter().enumerate() {
        for (from, to) in link.iter().zip(link.iter().skip(1)) {
            lines.push((number, camera.place(*from), camera.place(*to)));
        }
    }
    let crossings = lines.iter().enumerate().flat_map(|(index, a)| lines.iter().skip(index + 1).map(move |b| (a, b)));
    let crossings =
        crossings.filter(|((i, a, b), (j, c, d))| j - i > 1 && cross_each_other([*a, *b], [*c, *d])).count();
    // A sign on a link that is not its own looks like a joint of it.
    let covers = signs.iter().enumerate().flat_map(|(joint, sign)| lines.iter().map(move |line| (joint, sign, line)));
    let covers = covers.filter(|(joint, sign, (link, from, to))| {
        *link != *joint && *link != joint + 1 && off_line(**sign, *from, *to) < 14.0
    });
    let below = skeleton.points().filter(|[_, _, z]| *z < -0.02 * skeleton.size()).count();
    let cost = 14.0 * crossings as f64 + 8.0 * covers.count() as f64 + 6.0 * below as f64;
    // An arm seen from its end hides its links.
    let longest = lines.iter().map(|(_, from, to)| distance(*from, *to)).fold(0.0, f64::max);
    Some(least - cost + 0.02 * longest)
}

fn cross_each_other([a, b]: [Flat; 2], [c, d]: [Flat; 2]) -> bool {
    let side = |from: Flat, to: Flat, point: Flat| {
        let ([x, y], [u, v]) = (sub(to, from), sub(point, from));
        let [_, _, area] = cross([x, y, 0.0], [u, v, 0.0]);
        area / length([x, y]).max(1e-9)
    };
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn joints_are_seen_apart_within_their_limits() {
        let arm = DynamicArm::from_yaml(include_str!("../../specs/puma560.yaml")).unwrap();
        let q = apart(&arm, View::Iso);
        assert!(clarity(&arm, &q, View::Iso).unwrap() > clarity(&arm, &[0.0; 6], View::Iso).unwrap() + 10.0);
        for (q, [low, high]) in q.iter().zip(arm.limits()) {
            assert!(q >= low && q <= high);
        }
        assert_eq!(apart(&arm, View::Iso), q);
    }
}
