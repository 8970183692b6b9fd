//! Places of texts, so that none lies over another.

use crate::font::{CAPITAL, DEPTH, Font};
use crate::picture::{Dash, Paint, Picture, Role, Shape, Text};
use crate::vector::{Flat, distance};

/// Directions that are tried around the point of a label.
const DIRECTIONS: u32 = 16;
/// Gaps between the point and the label that are tried, px.
const GAPS: [f64; 9] = [0.0, 5.0, 11.0, 18.0, 27.0, 38.0, 52.0, 70.0, 92.0];
/// Steps of the raster on which a place is sought if none is free around the point, px.
const RASTER: f64 = 9.0;
/// Cost of a place beside the point from which on the whole picture is searched for a better one.
const CROWDED: f64 = 90.0;
/// A label farther from its point than this has a line to it, px.
const LEADER: f64 = 17.0;
/// Space around a label, px.
const SPACE: f64 = 2.5;

/// A rectangle: left, top, right, bottom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    /// Left end, px.
    pub left: f64,
    /// Upper end, px.
    pub top: f64,
    /// Right end, px.
    pub right: f64,
    /// Lower end, px.
    pub bottom: f64,
}

impl Area {
    /// A square around a point.
    pub fn around([x, y]: Flat, radius: f64) -> Self {
        Area { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius }
    }

    fn grown(self, by: f64) -> Self {
        Area { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    fn overlap(&self, other: &Area) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        if width > 0.0 && height > 0.0 { width * height } else { 0.0 }
    }

    /// True if another area is inside.
    pub fn holds(&self, other: &Area) -> bool {
        other.left >= self.left && other.top >= self.top && other.right <= self.right && other.bottom <= self.bottom
    }

    /// Length of the part of a line that is inside.
    pub fn length_inside(&self, [x0, y0]: Flat, [x1, y1]: Flat) -> f64 {
        let (mut first, mut last): (f64, f64) = (0.0, 1.0);
        for (start, step, low, high) in [(x0, x1 - x0, self.left, self.right), (y0, y1 - y0, self.top, self.bottom)] {
            if step.abs() < 1e-9 {
                if start < low || start > high {
                    return 0.0;
                }
            } else {
                let (a, b) = ((low - start) / step, (high - start) / step);
                first = first.max(a.min(b));
                last = last.min(a.max(b));
            }
        }
        (last - first).max(0.0) * distance([x0, y0], [x1, y1])
    }

    fn nearest_to(&self, [x, y]: Flat) -> Flat {
        [x.clamp(self.left, self.right), y.clamp(self.top, self.bottom)]
    }
}

/// A text that belongs to a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The point.
    pub at: Flat,
    /// The text keeps this distance from the point, px.
    pub clear: f64,
    /// The text.
    pub text: String,
    /// Font size, px.
    pub size: f64,
    /// Color.
    pub role: Role,
}

/// Things that labels keep away from.
#[derive(Debug, Default)]
pub struct Obstacles {
    lines: Vec<(Flat, Flat, f64)>,
    areas: Vec<(Area, f64)>,
    texts: Vec<Area>,
}

impl Obstacles {
    /// A line; `weight` says how much a label avoids each of its pixels.
    pub fn line(&mut self, from: Flat, to: Flat, weight: f64) {
        self.lines.push((from, to, weight));
    }

    /// Takes the last line back.
    pub fn without_last_line(&mut self) {
        self.lines.pop();
    }

    /// An area; `weight` says how much a label avoids it.
    pub fn area(&mut self, area: Area, weight: f64) {
        self.areas.push((area, weight));
    }

    /// A place where a text stands: no label covers it.
    pub fn text(&mut self, area: Area) {
        self.texts.push(area);
    }

    /// How bad it is to cover an area; `None` where a text is.
    fn cost(&self, area: &Area) -> Option<f64> {
        if self.texts.iter().any(|text| text.overlap(area) > 0.0) {
            return None;
        }
        let lines = self.lines.iter().map(|(from, to, weight)| weight * area.length_inside(*from, *to));
        let areas = self.areas.iter().map(|(other, weight)| weight * area.overlap(other).sqrt());
        Some(lines.chain(areas).sum())
    }

    /// How bad it is to draw a line here.
    pub fn cost_of_line(&self, from: Flat, to: Flat) -> f64 {
        let parts = 12;
        let step = |k: u32| {
            let t = f64::from(k) / f64::from(parts);
            [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]
        };
        let part = distance(from, to) / f64::from(parts);
        (0..=parts).map(|k| part * self.cost(&Area::around(step(k), 5.0)).unwrap_or(40.0).min(40.0)).sum::<f64>() / 10.0
    }
}

/// Writes labels, the first one first, each at its best place inside `bounds`.
///
/// A label for which no place is left is given back.
pub fn place(
    picture: &mut Picture,
    font: &Font,
    labels: &[Label],
    obstacles: &mut Obstacles,
    bounds: Area,
) -> Vec<Label> {
    let mut left_over = Vec::new();
    for label in labels {
        let width = font.width(&label.text, label.size);
        let Some((_, area)) = best(label, font, obstacles, bounds, true) else {
            left_over.push(label.clone());
            continue;
        };
        let near = area.nearest_to(label.at);
        let gap = distance(near, label.at);
        if gap > label.clear + LEADER {
            let from = between(label.at, near, label.clear / gap);
            picture.line(&[from, near], Paint::line(Role::Muted, 0.8).dashed(Dash::Dotted));
            obstacles.line(from, near, 0.6);
        }
        let at = [area.left, area.bottom - DEPTH * label.size];
        let text = Text { at, text: label.text.clone(), size: label.size, width, role: label.role };
        picture.shapes.push(Shape::Text(text));
        obstacles.text(area.grown(SPACE));
    }
    left_over
}

fn between(from: Flat, to: Flat, part: f64) -> Flat {
    [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])]
}

/// The best place of a label and how bad it is: free of texts, near its point, over as little else as can be. Where the
/// places around the point are bad, the whole picture is searched if `far` says so.
pub fn best(label: &Label, font: &Font, obstacles: &Obstacles, bounds: Area, far: bool) -> Option<(f64, Area)> {
    let (width, height) = (font.width(&label.text, label.size), (CAPITAL + DEPTH) * label.size);
    // How bad a place is; none where the label does not fit.
    let cost = |area: &Area| {
        let cost = obstacles.cost(&area.grown(1.0)).filter(|_| bounds.holds(area))?;
        let near = area.nearest_to(label.at);
        let led = distance(near, label.at) > label.clear + LEADER;
        let way = if led { 12.0 + 0.3 * obstacles.cost_of_line(label.at, near).min(200.0) } else { 0.0 };
        Some(cost + way)
    };
    // Equal costs stay equal whatever the rounding of a machine is: the first place wins.
    let rounded = |cost: f64| (cost * 100.0).round();
    let least = |a: &(f64, Area), b: &(f64, Area)| rounded(a.0).total_cmp(&rounded(b.0));
    let around = GAPS.iter().flat_map(|gap| (0..DIRECTIONS).map(move |direction| (*gap, direction)));
    let beside = around.filter_map(|(gap, direction)| {
        let angle = std::f64::consts::TAU * f64::from(direction) / f64::from(DIRECTIONS);
        let (sin, cos) = angle.sin_cos();
        // The label touches the circle around the point with the side or corner that is nearest.
        let reach = label.clear + gap;
        let [x, y] = [label.at[0] + reach * cos, label.at[1] - reach * sin];
        let left = x - 0.5 * width + 0.5 * width * snapped(cos);
        let top = y - 0.5 * height - 0.5 * height * snapped(sin);
        let area = Area { left, top, right: left + width, bottom: top + height };
        // To the right reads best.
        Some((cost(&area)? + 0.9 * gap + 1.5 * (1.0 - cos), area))
    });
    let near = beside.min_by(least);
    if !far || near.is_some_and(|(cost, _)| cost <= CROWDED) {
        return near;
    }
    let steps =
        |from: f64, to: f64| (0..).map(move |k: u32| from + RASTER * f64::from(k)).take_while(move |x| *x <= to);
    let raster = steps(bounds.top, bounds.bottom - height)
        .flat_map(|top| steps(bounds.left, bounds.right - width).map(move |left| (left, top)));
    let anywhere = raster.filter_map(|(left, top)| {
        let area = Area { left, top, right: left + width, bottom: top + height };
        Some((cost(&area)? + 30.0 + 0.9 * distance(area.nearest_to(label.at), label.at), area))
    });
    anywhere.chain(near).min_by(least)
}

/// A direction's component, with those near 0 and 1 made so: labels stand beside, above or below, or at a corner.
fn snapped(component: f64) -> f64 {
    (1.35 * component).clamp(-1.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_label_covers_another_one() {
        let mut picture = Picture { size: [300.0, 200.0], description: String::new(), shapes: Vec::new() };
        let label = |k: u32| Label {
            at: [150.0 + f64::from(k % 3), 100.0],
            clear: 6.0,
            text: format!("label {k}"),
            size: 13.0,
            role: Role::Ink,
        };
        let labels: Vec<Label> = (0..30).map(label).collect();
        let bounds = Area { left: 0.0, top: 0.0, right: 300.0, bottom: 200.0 };
        let left = place(&mut picture, &Font::new(), &labels, &mut Obstacles::default(), bounds);
        let texts: Vec<&Text> = picture
            .shapes
            .iter()
            .filter_map(|shape| if let Shape::Text(text) = shape { Some(text) } else { None })
            .collect();
        assert_eq!(texts.len() + left.len(), 30);
        assert!(texts.len() > 25);
        let area = |text: &Text| Area {
            left: text.at[0],
            top: text.at[1] - CAPITAL * text.size,
            right: text.at[0] + text.width,
            bottom: text.at[1] + DEPTH * text.size,
        };
        for (index, text) in texts.iter().enumerate() {
            assert!(texts.iter().skip(index + 1).all(|other| area(text).overlap(&area(other)) == 0.0), "{text:?}");
        }
    }

    #[test]
    fn a_line_is_cut_by_an_area() {
        let area = Area::around([0.0, 0.0], 1.0);
        assert_eq!(area.length_inside([-3.0, 0.0], [3.0, 0.0]), 2.0);
        assert_eq!(area.length_inside([-3.0, 2.0], [3.0, 2.0]), 0.0);
        assert_eq!(area.length_inside([0.0, 0.0], [0.0, 0.5]), 0.5);
    }
}
