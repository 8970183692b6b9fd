//! The arm at its zero configuration, to hold against a drawing: joint axes, frame origins, pose of the tool, and reach.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart::{Chain, Pose};
use denhart_codegen::model::geometry::{Line, axes_at_zero};
use denhart_codegen::model::{self, JointKind, Model};

use crate::Arm;

/// The arm with all joints at 0, lengths in the file's unit.
#[derive(Debug)]
pub struct ZeroConfiguration {
    pub tool: Pose<f64>,
    /// The axis of each joint, in the direction of its positive motion. Each goes through its point nearest to the point
    /// before, the first through that nearest to the base's origin.
    pub axes: Vec<Line>,
    /// The origin of each joint's frame in the table, at the end of the fixed rows that follow the joint's row.
    pub frame_origins: Vec<[f64; 3]>,
    /// The farthest that the tool gets from the origin of the base within the limits of the joints; none where a slide
    /// has no limit. Limits of sums are not looked at.
    pub max_reach: Option<f64>,
    /// The joints whose limits leave 0 out.
    pub outside_limits: Vec<String>,
}

/// Computes it. None where the chain cannot: that is said elsewhere.
pub fn zero_configuration(arm: &Arm) -> Option<ZeroConfiguration> {
    let Arm { chain, model } = arm;
    let zero = vec![0.0; model.joints.len()];
    let tool = Pose::from(chain.forward(&zero).ok()?);
    let frame_origins = chain.link_poses(&zero).ok()?.iter().map(|pose| Pose::from(*pose).translation).collect();
    let leaves_out = |limits: [f64; 2]| limits[0] > 0.0 || limits[1] < 0.0;
    let outside_limits = model.joints.iter().filter(|joint| joint.limits.is_some_and(leaves_out));
    let outside_limits = outside_limits.map(|joint| joint.name.clone()).collect();
    let axes = axes_at_zero(&model::chain::Chain::of(model));
    Some(ZeroConfiguration { tool, axes, frame_origins, max_reach: max_reach(chain, model), outside_limits })
}

/// The largest distance of the tool from the origin. While one joint turns, the square of the distance is
/// `c + 2 m (u cos q + v sin q)`, with m the middle of the tool's circle and u, v its radii. While a joint slides, the
/// distance is largest at an end. Joint after joint goes to its best value, from several starts, until nothing grows.
fn max_reach(chain: &Chain, model: &Model) -> Option<f64> {
    const STARTS: usize = 8;
    const SWEEPS: usize = 40;
    let ends: Option<Vec<[f64; 2]>> = model.joints.iter().map(range).collect();
    let ends = ends?;
    let point = |q: &[f64]| chain.forward(q).ok().map(|pose| Pose::from(pose).translation);
    let square = |p: [f64; 3]| p.iter().map(|x| x * x).sum::<f64>();
    let mut best: f64 = 0.0;
    for start in 0..STARTS {
        // Spread over the ranges: fractions of multiples of an irrational number.
        let spread = |index: usize| ((start * model.joints.len() + index) as f64 * 0.618_033_988_749_895).fract();
        let mut q: Vec<f64> =
            ends.iter().enumerate().map(|(index, [low, high])| low + (high - low) * spread(index)).collect();
        let mut last = square(point(&q)?);
        for _ in 0..SWEEPS {
            for (index, (joint, [low, high])) in model.joints.iter().zip(&ends).enumerate() {
                let at = |value: f64| {
                    let mut moved = q.clone();
                    *moved.get_mut(index)? = value;
                    point(&moved)
                };
                let best = if joint.kind == JointKind::Revolute {
                    let (east, north, west) = (at(0.0)?, at(FRAC_PI_2)?, at(PI)?);
                    let [x, y] = [0, 1, 2].iter().fold([0.0, 0.0], |[x, y], axis| {
                        let of = |p: &[f64; 3]| p.get(*axis).copied().unwrap_or(0.0);
                        let (middle, radius) = ((of(&east) + of(&west)) / 2.0, (of(&east) - of(&west)) / 2.0);
                        [x + middle * radius, y + middle * (of(&north) - middle)]
                    });
                    let angle = y.atan2(x);
                    let turns = [angle - 2.0 * PI, angle, angle + 2.0 * PI, *low, *high];
                    let size = |turn: f64| x * turn.cos() + y * turn.sin();
                    let inside = turns.into_iter().filter(|turn| turn >= low && turn <= high);
                    inside.max_by(|a, b| size(*a).total_cmp(&size(*b)))
                } else {
                    let (shortest, longest) = (square(at(*low)?), square(at(*high)?));
                    Some(if shortest > longest { *low } else { *high })
                };
                *q.get_mut(index)? = best?;
            }
            let now = square(point(&q)?);
            if now <= last * (1.0 + 1e-12) {
                break;
            }
            last = now;
        }
        best = best.max(last);
    }
    Some(best.sqrt())
}

/// Where a joint may stand: a turn without limits is a whole turn. None of a slide without an end.
fn range(joint: &denhart_codegen::model::Joint) -> Option<[f64; 2]> {
    let [low, high] = joint.limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    match joint.kind {
        JointKind::Revolute => Some([low.max(-2.0 * PI), high.min(2.0 * PI)]).filter(|[low, high]| low <= high),
        JointKind::Prismatic => (low.is_finite() && high.is_finite()).then_some([low, high]),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    fn of(rows: &str) -> ZeroConfiguration {
        let text = format!("name: a\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n{rows}");
        zero_configuration(&Arm::of_text(&text, "a.yaml").unwrap()).unwrap()
    }

    #[test]
    fn the_farthest_of_a_planar_arm_is_its_length_unless_limits_bend_it() {
        let straight = of("  - {a: 0.5, alpha: 0, d: 0, theta: 0}\n  - {a: 0.3, alpha: 0, d: 0, theta: 0}\n");
        assert!((straight.max_reach.unwrap() - 0.8).abs() < 1e-12);
        assert_eq!(straight.tool.translation, [0.8, 0.0, 0.0]);
        assert_eq!(straight.frame_origins, [[0.5, 0.0, 0.0], [0.8, 0.0, 0.0]]);
        let bent =
            of("  - {a: 0.5, alpha: 0, d: 0, theta: 0}\n  - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [60, 90]}\n");
        let expected = (0.25 + 0.09 + 2.0 * 0.15 * 0.5_f64).sqrt();
        assert!((bent.max_reach.unwrap() - expected).abs() < 1e-12);
        assert_eq!(bent.outside_limits, ["q2"]);
    }

    #[test]
    fn a_slide_without_an_end_has_no_farthest_point() {
        let rows = "  - {type: prismatic, a: 0, alpha: 0, d: 0, theta: 0, limits: [0, null]}\n";
        assert_eq!(of(rows).max_reach, None);
        let rows = "  - {type: prismatic, a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-0.4, 0.2]}\n";
        assert!((of(rows).max_reach.unwrap() - 0.5).abs() < 1e-15);
    }
}
