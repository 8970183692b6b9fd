//! The path of the tool.

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
/// Radius of the circles, and how far the second one leaves the workspace.
const RADIUS: f32 = 100.0;
const BEYOND: f32 = 2.0;

/// A part of the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// From home to the singularity of joint 1.
    Up,
    /// Home again.
    Down,
    /// To where the circles start.
    There,
    /// A circle that touches the edge of the workspace from inside.
    Touching,
    /// Outward, to the second circle.
    Outward,
    /// A circle that leaves the workspace.
    Leaving,
    /// Home.
    Home,
}

impl Part {
    /// In order.
    pub const ALL: [Self; 7] =
        [Self::Up, Self::Down, Self::There, Self::Touching, Self::Outward, Self::Leaving, Self::Home];

    /// Description of the part.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Up => "straight line, to the singularity of joint 1",
            Self::Down => "straight line, back",
            Self::There => "straight line, to the circles",
            Self::Touching => "circle that touches the edge of the workspace",
            Self::Outward => "straight line",
            Self::Leaving => "circle that leaves the workspace",
            Self::Home => "straight line, home",
        }
    }

    /// Duration of the part, ms.
    pub const fn ticks(self) -> u32 {
        match self {
            Self::Outward => 100,
            Self::Touching | Self::Leaving => 2_000,
            _ => 1_000,
        }
    }

    /// Returns true if targets on this part are out of reach.
    pub const fn leaves_the_workspace(self) -> bool {
        matches!(self, Self::Leaving)
    }

    /// The target after `step` of its ticks, mm.
    pub fn target(self, step: u32) -> [f32; 3] {
        let share = step as f32 / self.ticks() as f32;
        let (inner, outer) = (EDGE - RADIUS, EDGE - RADIUS + BEYOND);
        match self {
            Self::Up => line(HOME, TOP, share),
            Self::Down => line(TOP, HOME, share),
            Self::There => line(HOME, circle(inner, 0.0), share),
            Self::Touching => circle(inner, share),
            Self::Outward => line(circle(inner, 0.0), circle(outer, 0.0), share),
            Self::Leaving => circle(outer, share),
            Self::Home => line(circle(outer, 0.0), HOME, share),
        }
    }
}

fn line(from: [f32; 3], to: [f32; 3], share: f32) -> [f32; 3] {
    let [x, y, z] = from;
    let [u, v, w] = to;
    [x + (u - x) * share, y + (v - y) * share, z + (w - z) * share]
}

/// A circle with its center `distance` from the shoulder. It starts next to the shoulder, and is farthest out halfway.
fn circle(distance: f32, share: f32) -> [f32; 3] {
    let (sin, cos) = denhart::math::sin_cos(share * core::f32::consts::TAU);
    let (out, across) = (distance - RADIUS * cos, RADIUS * sin);
    let at = |shoulder: f32, direction: f32, sideways: f32| shoulder + out * direction + across * sideways;
    let ([x, y, z], [u, v, w], [i, j, k]) = (SHOULDER, OUT, ACROSS);
    [at(x, u, i), at(y, v, j), at(z, w, k)]
}
