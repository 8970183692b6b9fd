//! The path of the tool.

use crate::tally::Tally;

/// Where the motors count 0, mm.
const HOME: [f32; 3] = [258.0, 10.0, 367.0];
/// Beside the first axis by as much as the links are: the two solutions of joint 1 meet.
const TOP: [f32; 3] = [0.0, 10.0, 600.0];
/// The shoulder's center, and the greatest distance from it: links of 197 and 258, 10 beside the axis.
const SHOULDER: [f32; 3] = [0.0, 0.0, 170.0];
const EDGE: f32 = 455.10987;
/// The way from the shoulder to where the circles come nearest to the edge, and a direction at right angles to it.
const OUT: [f32; 3] = [0.8, 0.0, 0.6];
const ACROSS: [f32; 3] = [0.0, 1.0, 0.0];
/// A line past the first axis at a distance of 20 mm: joint 1 turns by 130 degrees.
const BEFORE: [f32; 3] = [20.0, -150.0, 590.0];
const AFTER: [f32; 3] = [20.0, 150.0, 590.0];
/// Radius of the circles, and how far the second one leaves the workspace.
const RADIUS: f32 = 100.0;
const BEYOND: f32 = 2.0;
/// Half of the way of the tool for one pulse at the edge, mm: 12,800 pulses a turn. The motors round by as much.
const HALF_A_PULSE: f32 = 0.1;

/// A part of the path. The tool is at rest between two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// From home to the singularity of joint 1.
    Up,
    /// Home again.
    Down,
    /// To the line past the first axis.
    Aside,
    /// Past the first axis.
    Past,
    /// Home again.
    Back,
    /// To where the circles start.
    There,
    /// Half of a circle that touches the edge of the workspace from inside. The elbow turns round there, so the tool rests.
    ToTheEdge,
    /// The other half.
    FromTheEdge,
    /// Outward, to the second circle.
    Outward,
    /// Half of a circle that leaves the workspace.
    Leaving,
    /// The other half.
    Returning,
    /// Home.
    Home,
}

impl Part {
    /// In order.
    pub const ALL: [Self; 12] = [
        Self::Up,
        Self::Down,
        Self::Aside,
        Self::Past,
        Self::Back,
        Self::There,
        Self::ToTheEdge,
        Self::FromTheEdge,
        Self::Outward,
        Self::Leaving,
        Self::Returning,
        Self::Home,
    ];

    /// Description of the part.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Up => "straight line, to the singularity of joint 1",
            Self::Down => "straight line, back",
            Self::Aside => "straight line",
            Self::Past => "straight line past the first axis",
            Self::Back => "straight line, home",
            Self::There => "straight line, to the circles",
            Self::ToTheEdge => "half a circle, to the edge of the workspace",
            Self::FromTheEdge => "half a circle, from the edge",
            Self::Outward => "straight line",
            Self::Leaving => "half a circle, out of the workspace",
            Self::Returning => "half a circle, back into the workspace",
            Self::Home => "straight line, home",
        }
    }

    /// Duration of the part, ms.
    pub const fn ticks(self) -> u32 {
        match self {
            Self::Outward => 300,
            Self::Past | Self::Leaving | Self::Returning => 3_000,
            _ => 2_000,
        }
    }

    /// Returns true if its ticks stand to their targets as they should.
    pub fn expects(self, tally: &Tally) -> bool {
        let Tally { exact, rates, limits, reach, target, deviation, .. } = *tally;
        let told = exact + rates + limits + reach == self.ticks() && limits + target == 0;
        let ends = tally.ended_exact() || self == Self::Leaving;
        let there = match self {
            // Two branches meet. A rounded target is beside that place or beyond it, and a tick is not always exact.
            Self::Up | Self::Down | Self::ToTheEdge | Self::FromTheEdge => deviation < HALF_A_PULSE,
            Self::Past => rates > 0 && reach == 0,
            Self::Leaving | Self::Returning => reach > 0 && deviation < BEYOND + HALF_A_PULSE,
            _ => exact == self.ticks(),
        };
        told && ends && there
    }

    /// The target after `step` of its ticks, mm.
    pub fn target(self, step: u32) -> [f32; 3] {
        let share = smooth(step as f32 / self.ticks() as f32);
        let (inner, outer) = (EDGE - RADIUS, EDGE - RADIUS + BEYOND);
        match self {
            Self::Up => line(HOME, TOP, share),
            Self::Down => line(TOP, HOME, share),
            Self::Aside => line(HOME, BEFORE, share),
            Self::Past => line(BEFORE, AFTER, share),
            Self::Back => line(AFTER, HOME, share),
            Self::There => line(HOME, circle(inner, 0.0), share),
            Self::ToTheEdge => circle(inner, 0.5 * share),
            Self::FromTheEdge => circle(inner, 0.5 + 0.5 * share),
            Self::Outward => line(circle(inner, 0.0), circle(outer, 0.0), share),
            Self::Leaving => circle(outer, 0.5 * share),
            Self::Returning => circle(outer, 0.5 + 0.5 * share),
            Self::Home => line(circle(outer, 0.0), HOME, share),
        }
    }
}

fn line(from: [f32; 3], to: [f32; 3], share: f32) -> [f32; 3] {
    let [x, y, z] = from;
    let [u, v, w] = to;
    [x + (u - x) * share, y + (v - y) * share, z + (w - z) * share]
}

/// From 0 to 1, at rest at both ends.
fn smooth(share: f32) -> f32 {
    share * share * share * (10.0 + share * (6.0 * share - 15.0))
}

/// A circle with its center `distance` from the shoulder. It starts next to the shoulder, and is farthest out halfway.
fn circle(distance: f32, share: f32) -> [f32; 3] {
    let (sin, cos) = denhart::math::sin_cos(share * core::f32::consts::TAU);
    let (out, across) = (distance - RADIUS * cos, RADIUS * sin);
    let at = |shoulder: f32, direction: f32, sideways: f32| shoulder + out * direction + across * sideways;
    let ([x, y, z], [u, v, w], [i, j, k]) = (SHOULDER, OUT, ACROSS);
    [at(x, u, i), at(y, v, j), at(z, w, k)]
}
