//! The arm that was measured: its rows, and how far its links are from those of the table.

use super::angle::Angle;
use super::arm::{Calibration, FarthestLink, Model, Row};
use super::chain::{Chain, Elementary};
use super::joint::Joint;
use super::joint_names::named;
use super::numeric::{Transform, length};
use crate::error::Diagnostic;
use crate::spec::{CalibrationSpec, Length, Place, Spec};

/// A link may be displaced by this part of the reach.
const DISPLACED: f64 = 0.1;
/// A link may be turned by this, rad.
const TURNED: f64 = 0.1;
/// Beyond this share of these it is remarked: 2 % of the reach, 1.1 degrees.
const IMPLAUSIBLE: f64 = 0.2;

/// The rows with the calibration of the file added, and what was added to which joint.
pub fn added(
    spec: &Spec,
    joints: &[Joint],
    rows: &mut [Row],
    mistakes: &mut Vec<Diagnostic>,
) -> Option<Vec<(usize, [f64; 4])>> {
    let calibration = spec.calibration.as_ref()?;
    let mut deltas = Vec::new();
    for delta in &calibration.deltas {
        let Some(joint) = named(spec, joints, "calibration", &delta.joint, &delta.place, mistakes) else { continue };
        if deltas.iter().any(|(other, _)| *other == joint) {
            let mistake =
                spec.source.mistake(&delta.place, format!("`calibration`: joint {} is named twice", joint + 1));
            mistakes.push(mistake.help("write one entry for a joint"));
            continue;
        }
        let Some(row) = joints.get(joint).and_then(|joint| rows.get_mut(joint.row)) else { continue };
        let [alpha, theta] = [delta.alpha, delta.theta].map(Angle::from);
        for (key, place, by) in [("a", &mut row.a, delta.a), ("d", &mut row.d, delta.d)] {
            match place {
                Length::Constant(value) => *value += by,
                Length::Multiple { .. } if by == 0.0 => {}
                Length::Multiple { parameter, .. } => {
                    let message =
                        format!("`calibration`: `{key}` of joint {} is the parameter `{parameter}`", joint + 1);
                    let help =
                        "write the number in place of the parameter, or leave this length out of the calibration";
                    mistakes.push(spec.source.mistake(&delta.place, message).help(help));
                }
            }
        }
        row.alpha = row.alpha.add(alpha);
        row.theta = row.theta.add(theta);
        deltas.push((joint, [delta.a, alpha.rad(), delta.d, theta.rad()]));
    }
    Some(deltas)
}

/// The calibration of `model`, whose table alone is `nominal`.
///
/// Frames are slid along their joints' axes and turned about them first, which changes no pose: nearly parallel axes have
/// their common normal far away and in any direction. A table of such an arm may have two lengths of hundreds of meters that
/// cancel, and three angles of half a radian.
pub fn compared(
    spec: &Spec,
    written: &CalibrationSpec,
    deltas: Vec<(usize, [f64; 4])>,
    [nominal, model]: [&Model; 2],
    mistakes: &mut Vec<Diagnostic>,
) -> Calibration {
    let table = gathered(nominal);
    let own = turned_to(&table, gathered(model));
    let pairs: Vec<[Transform; 2]> = table.into_iter().zip(own).map(|(table, own)| [table, own]).collect();
    let reach: f64 = pairs.iter().map(|[table, _]| length(table.p)).sum();
    let mut calibration = Calibration {
        deltas,
        displaced: 0.0,
        turned: 0.0,
        farthest: FarthestLink::default(),
        table: nominal.rows.clone(),
    };
    for (link, [table, own]) in pairs.iter().enumerate() {
        let between = table.inverse().then(own);
        let (by, angle) = (length(between.p), angle(&between.r));
        // Slides alone have no links.
        let share = if reach > 0.0 { by / (DISPLACED * reach) } else { 0.0 }.max(angle / TURNED);
        if share > calibration.farthest.share {
            calibration.farthest = FarthestLink { joint: link.saturating_sub(1), share, displaced: by, turned: angle };
        }
        calibration.displaced = calibration.displaced.max(by);
        calibration.turned = calibration.turned.max(angle);
    }
    if calibration.farthest.share > 1.0 {
        let (message, place) = off_the_table(spec, written, &calibration);
        let help = "numbers are in the file's `units`: look for radians among degrees, millimeters among meters, whole rows, or \
                    another arm's calibration";
        mistakes.push(spec.source.mistake(place, message).help(help));
    }
    calibration
}

/// A warning of an arm that is farther off its table than measured arms are.
pub fn implausible(spec: &Spec, calibration: &Calibration) -> Option<Diagnostic> {
    let written = spec.calibration.as_ref().filter(|_| calibration.farthest.share > IMPLAUSIBLE)?;
    let (message, place) = off_the_table(spec, written, calibration);
    let help = "measured arms are a few millimeters and tenths of a degree off: look for another unit, or for another arm's numbers";
    Some(spec.source.warning(place, message).help(help))
}

/// The distance of the arm from its table, in words, and the entry of the link that is most off.
fn off_the_table<'a>(spec: &Spec, written: &'a CalibrationSpec, calibration: &Calibration) -> (String, &'a Place) {
    let FarthestLink { joint, displaced, turned, .. } = calibration.farthest;
    let entry = written.deltas.get(calibration.deltas.iter().position(|(own, _)| *own == joint).unwrap_or(0));
    let message = format!(
        "`calibration` moves link {} by {displaced:.3} {} and turns it by {:.2} deg: expected a measured arm near its table",
        joint + 1,
        spec.length_unit.symbol(),
        turned.to_degrees()
    );
    (message, entry.map_or(&written.place, |entry| &entry.place))
}

/// Links with the frame of each joint turned about its axis, so that each link has nearly the rotation that the table has.
fn turned_to(table: &[Transform], mut links: Vec<Transform>) -> Vec<Transform> {
    let behind = links.len().saturating_sub(1);
    let mut turn = Transform::IDENTITY;
    for (number, (link, wanted)) in links.iter_mut().zip(table).enumerate() {
        *link = turn.inverse().then(link);
        if number < behind {
            let [[xx, xy, _], [yx, yy, _], _] = wanted.inverse().then(link).r;
            // The turn for which the trace of what is left is greatest.
            let (sin, cos) = (xy - yx, xx + yy);
            let size = length([sin, cos, 0.0]);
            turn = if size > 0.0 { Transform::rotate_z(sin / size, cos / size) } else { Transform::IDENTITY };
            *link = link.then(&turn);
        }
    }
    links
}

/// The angle of a rotation, rad.
fn angle(r: &[[f64; 3]; 3]) -> f64 {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *r;
    length([zy - yz, xz - zx, yx - xy]).atan2(xx + yy + zz - 1.0)
}

/// The links of an arm, parameters at their defaults: before, between and behind its joints. The frame of each joint is
/// slid along its axis next to the frame before.
fn gathered(model: &Model) -> Vec<Transform> {
    let mut links = vec![Transform::IDENTITY];
    for step in &Chain::of(model).transforms {
        let Some(last) = links.last_mut() else { continue };
        match step {
            Elementary::Prismatic { .. } => links.push(Transform::IDENTITY),
            Elementary::Revolute { .. } => links.push(Transform::of(step)),
            _ => *last = last.then(&Transform::of(step)),
        }
    }
    let mut slid = 0.0;
    let behind = links.len().saturating_sub(1);
    for (number, link) in links.iter_mut().enumerate() {
        *link = Transform::shift([0.0, 0.0, -slid]).then(link);
        slid = 0.0;
        if number < behind {
            let [x, y, z] = link.axis(2);
            let [px, py, pz] = link.p;
            slid = -(x * px + y * py + z * pz);
            *link = link.then(&Transform::shift([0.0, 0.0, slid]));
        }
    }
    links
}
