//! A scene as a picture.

use crate::aims::{aim, curves, region};
use crate::canvas::Canvas;
use crate::deciding::deciding;
use crate::figure::{arm, ground};
use crate::font::Font;
use crate::furniture::{Frame, footer, header};
use crate::labels::{Obstacles, place};
use crate::measures::{dimensions, frames, tool};
use crate::picture::Picture;
use crate::scene::Scene;
use crate::solutions::solutions;
use crate::symbols::places;
use crate::vector::{Flat, Vector};
use crate::view::{Camera, View};

/// The picture of a scene in a view. `size` is that of the drawing, px; lines of text below make the picture higher.
pub fn picture(scene: &Scene, view: View, size: Flat, font: &Font) -> Picture {
    let frame = Frame::of(size);
    let points = scene.figures.iter().flat_map(|figure| figure.skeleton.points().copied());
    let section = scene.section.iter().flat_map(|section| {
        section.region.iter().chain(section.singular.iter().flat_map(|curves| &curves.lines)).flatten().copied()
    });
    let target = scene.target.iter().map(|pose| pose.translation);
    let axes = scene.axes.iter().flat_map(|(axes, _)| axes);
    let axes = axes.flat_map(|one| one.lines.iter().flatten().chain(&one.point)).copied();
    let all = points.chain(section).chain(target).chain(axes);
    let camera = Camera::fit(view, all.clone(), frame.inside(scene.dimensions));
    // Signs of joints may stand beside the links.
    let signs: Vec<Vector> = scene
        .figures
        .iter()
        .filter(|figure| figure.solution.is_none())
        .flat_map(|figure| places(&figure.skeleton, &camera))
        .collect();
    let camera = Camera::fit(view, all.chain(signs.iter().copied()), frame.inside(scene.dimensions));
    let mut canvas = Canvas {
        picture: Picture { size, description: String::new(), shapes: Vec::new() },
        camera,
        font,
        obstacles: Obstacles::default(),
        labels: Vec::new(),
        notes: scene.notes.clone(),
        text: frame.text,
        small: frame.small,
    };
    region(&mut canvas, scene);
    ground(&mut canvas, scene.section.is_some());
    solutions(&mut canvas, scene);
    for figure in scene.figures.iter().filter(|figure| figure.solution.is_none()) {
        arm(&mut canvas, figure, !scene.frames);
    }
    if let Some(figure) = scene.figures.first() {
        if scene.dimensions {
            dimensions(&mut canvas, figure, &scene.length_unit, frame.bounds());
        }
        if scene.frames {
            frames(&mut canvas, figure);
        } else if figure.solution.is_none() {
            tool(&mut canvas, figure);
        }
        if let Some((axes, words)) = &scene.axes {
            deciding(&mut canvas, axes, words);
        }
        let asked = scene.frames || scene.dimensions;
        if asked && !figure.skeleton.far.is_empty() {
            canvas.notes.push(format!("far outside the picture: {}", figure.skeleton.far.join(", ")));
        }
    }
    curves(&mut canvas, scene);
    aim(&mut canvas, scene);
    let mut lost = Vec::new();
    let Canvas { picture, obstacles, labels, notes, .. } = &mut canvas;
    for label in place(picture, font, labels, obstacles, frame.bounds()) {
        lost.push(label.text);
    }
    if !lost.is_empty() {
        notes.push(format!("no room for: {}", lost.join("; ")));
    }
    header(&mut canvas, scene, view, &frame);
    footer(&mut canvas, scene, view, &frame);
    canvas.picture
}
