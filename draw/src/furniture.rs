//! The frame of a picture: title, directions, scale, legend and notes.

use crate::canvas::Canvas;
use crate::font::Font;
use crate::labels::Area;
use crate::number::short;
use crate::picture::{Dash, Paint, Role, Shape, Text};
use crate::scene::Scene;
use crate::solutions::role;
use crate::symbols::{arrow, end_on};
use crate::vector::{Flat, length, moved};
use crate::view::View;

/// Below this width names are left out, px.
const SMALL: f64 = 480.0;
/// Height of the part with directions and scale, px.
const FOOT: f64 = 64.0;

/// The parts of a picture.
pub struct Frame {
    size: Flat,
    head: f64,
    margin: f64,
    /// Font size of labels, px.
    pub text: f64,
    /// A picture too small for long names.
    pub small: bool,
}

impl Frame {
    /// The frame of a drawing of a size.
    pub fn of(size: Flat) -> Self {
        let small = size[0] < SMALL;
        if small {
            Frame { size, head: 24.0, margin: 40.0, text: 12.5, small }
        } else {
            Frame { size, head: 48.0, margin: 66.0, text: 14.0, small }
        }
    }

    /// The rectangle of the arm: left, top, width, height. Dimensions stand beside it.
    pub fn inside(&self, dimensions: bool) -> [f64; 4] {
        let [width, height] = self.size;
        let beside = if dimensions { 1.7 * self.margin } else { self.margin };
        let above = if dimensions || self.small { 0.8 * self.margin } else { 0.55 * self.margin };
        [beside, self.head + above, width - 2.0 * beside, height - 2.0 * above]
    }

    /// The rectangle of the labels.
    pub fn bounds(&self) -> Area {
        let [width, height] = self.size;
        Area { left: 6.0, top: self.head + 2.0, right: width - 6.0, bottom: self.head + height - 2.0 }
    }

    fn bottom(&self) -> f64 {
        self.head + self.size[1]
    }
}

fn write(canvas: &mut Canvas, at: Flat, text: &str, size: f64, role: Role) -> f64 {
    let width = canvas.font.width(text, size);
    canvas.picture.shapes.push(Shape::Text(Text { at, text: text.to_owned(), size, width, role }));
    width
}

/// Words in lines of at most a width.
fn lines(font: &Font, text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match (lines.last_mut(), longer) {
            (Some(line), Some(longer)) if font.width(&longer, size) <= width => *line = longer,
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The text, cut at a width.
fn cut(font: &Font, text: &str, size: f64, width: f64) -> String {
    if font.width(text, size) <= width {
        return text.to_owned();
    }
    let mut short = String::new();
    for letter in text.chars() {
        short.push(letter);
        if font.width(&short, size) + size > width {
            break;
        }
    }
    short + "\u{2026}"
}

/// The name of the arm and the posture.
pub fn header(canvas: &mut Canvas, scene: &Scene, view: View, frame: &Frame) {
    let solved = scene.figures.iter().filter(|figure| figure.solution.is_some()).count();
    let mut words = Vec::new();
    if !scene.posture.is_empty() {
        words.push(scene.posture.clone());
    }
    if solved > 0 {
        words.push(if solved == 1 { "1 solution".to_owned() } else { format!("{solved} solutions") });
    }
    let second = words.join("; ");
    canvas.picture.description = format!("{}, {} view. {second}", scene.name, view.name());
    let width = frame.size[0] - 24.0;
    if frame.small {
        let name = cut(canvas.font, &scene.name, 13.0, width);
        write(canvas, [10.0, 18.0], &name, 13.0, Role::Ink);
        return;
    }
    let name = cut(canvas.font, &scene.name, 18.0, width - 190.0);
    let after = write(canvas, [12.0, 24.0], &name, 18.0, Role::Ink);
    let rest = format!("{} view, lengths in {}", view.name(), scene.length_unit);
    write(canvas, [12.0 + after + 12.0, 24.0], &rest, 12.5, Role::Muted);
    let second = cut(canvas.font, &second, 12.5, width);
    write(canvas, [12.0, 43.0], &second, 12.5, Role::Muted);
}

/// Directions and scale, then the legend and the notes, line by line.
pub fn footer(canvas: &mut Canvas, scene: &Scene, view: View, frame: &Frame) {
    let bottom = frame.bottom();
    directions(canvas, [34.0, bottom + 42.0], view);
    scale_bar(canvas, [82.0, bottom + 42.0], &scene.length_unit);
    let mut top = bottom + FOOT;
    if frame.small {
        canvas.picture.size = [frame.size[0], top];
        return;
    }
    top = legend(canvas, scene, frame, top);
    let (size, width) = (12.5, frame.size[0] - 24.0);
    let notes = std::mem::take(&mut canvas.notes);
    for note in notes {
        for line in lines(canvas.font, &note, size, width) {
            top += 17.0;
            let line = cut(canvas.font, &line, size, width);
            write(canvas, [12.0, top], &line, size, Role::Muted);
        }
    }
    canvas.picture.size = [frame.size[0], top + 12.0];
}

/// The directions of x, y and z in the view.
fn directions(canvas: &mut Canvas, at: Flat, view: View) {
    const LENGTH: f64 = 24.0;
    let [right, up, toward] = view.axes();
    for (index, (name, role)) in [("x", Role::X), ("y", Role::Y), ("z", Role::Z)].into_iter().enumerate() {
        let part = |axis: [f64; 3]| axis.get(index).copied().unwrap_or(0.0);
        let flat = [part(right), -part(up)];
        let label = if length(flat) < 0.1 {
            end_on(&mut canvas.picture, at, part(toward) > 0.0, 7.0, role);
            canvas.picture.circle(at, 5.5, Paint::line(role, 1.4));
            [at[0] - 12.0, at[1] + 11.0]
        } else {
            arrow(&mut canvas.picture, at, moved(at, flat, LENGTH), role, 1.6);
            let tip = moved(at, flat, LENGTH + 8.0 / length(flat).max(0.3));
            [tip[0] - 3.5, tip[1] + 4.0]
        };
        write(canvas, label, name, 12.5, role);
    }
}

/// A bar of a round length.
fn scale_bar(canvas: &mut Canvas, [left, middle]: Flat, unit: &str) {
    let longest = 110.0 / canvas.camera.scale;
    let power = 10f64.powf(longest.log10().floor());
    let round = [5.0, 2.0, 1.0].into_iter().map(|factor| factor * power).find(|length| *length <= longest);
    let Some(round) = round.filter(|length| length.is_finite() && *length > 0.0) else { return };
    let right = left + round * canvas.camera.scale;
    let paint = Paint::line(Role::Muted, 1.4);
    canvas.picture.line(&[[left, middle], [right, middle]], paint);
    for end in [left, right] {
        canvas.picture.line(&[[end, middle - 4.0], [end, middle + 4.0]], paint);
    }
    let text = format!("{} {unit}", short(round));
    write(canvas, [right + 8.0, middle + 4.5], &text, 12.5, Role::Muted);
}

/// Number, line and branch of each solution, in two columns where they fit.
fn legend(canvas: &mut Canvas, scene: &Scene, frame: &Frame, top: f64) -> f64 {
    const SIZE: f64 = 12.5;
    const ROW: f64 = 18.0;
    let entries: Vec<(usize, bool, String)> = scene
        .figures
        .iter()
        .filter_map(|figure| {
            let number = figure.solution?;
            let mut words = vec![number.to_string()];
            if !figure.branch.is_empty() {
                words.push(figure.branch.clone());
            }
            let mut text = words.join(" ");
            if figure.out_of_limits {
                text += " (out of limits)";
            }
            Some((number, figure.out_of_limits, text))
        })
        .collect();
    if entries.is_empty() {
        return top;
    }
    let widest = entries.iter().map(|(_, _, text)| canvas.font.width(text, SIZE)).fold(0.0, f64::max);
    let width = frame.size[0] - 24.0;
    let columns = if 2.0 * (widest + 62.0) <= width && entries.len() > 1 { 2 } else { 1 };
    let rows = entries.len().div_ceil(columns);
    for (index, (number, broken, text)) in entries.iter().enumerate() {
        let left = 12.0 + (index / rows) as f64 * width / columns as f64;
        let middle = top + ROW * (index % rows) as f64 + 8.0;
        let dash = if *broken { Dash::Dashed } else { Dash::Solid };
        canvas
            .picture
            .line(&[[left + 2.0, middle], [left + 34.0, middle]], Paint::line(role(*number), 3.6).dashed(dash));
        let text = cut(canvas.font, text, SIZE, width / columns as f64 - 50.0);
        write(canvas, [left + 44.0, middle + 4.5], &text, SIZE, Role::Ink);
    }
    top + ROW * rows as f64
}
