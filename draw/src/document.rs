//! A picture as SVG. The same picture gives the same bytes.

use std::collections::BTreeSet;

use svg::Node;
use svg::node::element::{Element, Style};

use crate::font::Font;
use crate::number::coordinate;
use crate::picture::{Command, Dash, Paint, Picture, Role, Shape, Text};
use crate::theme::{Theme, class, colors};

/// How texts are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Letters {
    /// As text, which can be searched and copied; drawn with the viewer's font, at the width of the shipped one.
    Text,
    /// As outlines of the shipped font.
    Outlines,
}

/// The SVG file.
pub fn svg(picture: &Picture, theme: Theme, letters: Letters) -> String {
    let [width, height] = picture.size.map(coordinate);
    let mut root = Element::new("svg");
    root.assign("xmlns", "http://www.w3.org/2000/svg");
    root.assign("viewBox", format!("0 0 {width} {height}"));
    root.assign("width", width.clone());
    root.assign("height", height.clone());
    root.assign("role", "img");
    root.assign("data-by", "denhart draw");
    let mut title = Element::new("title");
    title.append(svg::node::Text::new(printable(&picture.description)));
    root.append(title);
    root.append(Style::new(style_sheet(picture, theme)));
    let mut back = Element::new("rect");
    back.assign("class", "f-bg");
    back.assign("width", width);
    back.assign("height", height);
    root.append(back);
    let font = Font::new();
    for shape in &picture.shapes {
        match shape {
            Shape::Path(commands, paint) => root.append(path(commands, paint)),
            Shape::Ellipse(center, radii, turn, paint) => root.append(ellipse(*center, *radii, *turn, paint)),
            Shape::Text(text) => match letters {
                Letters::Text => root.append(written(text)),
                Letters::Outlines => {
                    let outline = font.outline(&text.text, text.size, text.at);
                    let halo = Paint::both(Role::Background, Role::Background, HALO);
                    root.append(path(&outline, &halo));
                    root.append(path(&outline, &Paint::fill(text.role)));
                }
            },
        }
    }
    root.to_string() + "\n"
}

/// Width of the gap around the letters of a text, px, on both sides together.
const HALO: f64 = 3.5;

/// Text without characters that XML refuses.
fn printable(text: &str) -> String {
    text.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}

fn roles(picture: &Picture) -> BTreeSet<Role> {
    let mut roles = BTreeSet::from([Role::Background]);
    for shape in &picture.shapes {
        match shape {
            Shape::Path(_, paint) | Shape::Ellipse(_, _, _, paint) => {
                roles.extend(paint.fill);
                roles.extend(paint.stroke.map(|(role, _)| role));
            }
            Shape::Text(text) => drop(roles.insert(text.role)),
        }
    }
    roles
}

fn style_sheet(picture: &Picture, theme: Theme) -> String {
    let rules = |dark: bool| {
        let mut rules = String::new();
        let mut names = BTreeSet::new();
        for role in roles(picture) {
            let [light_color, dark_color] = colors(role);
            let color = if dark { dark_color } else { light_color };
            let name = class(role);
            if names.insert(name.clone()) {
                rules += &format!(".f-{name}{{fill:#{color:06x}}}.s-{name}{{stroke:#{color:06x}}}\n");
            }
        }
        let [light_color, dark_color] = colors(Role::Background);
        rules + &format!("text{{stroke:#{:06x}}}\n", if dark { dark_color } else { light_color })
    };
    let common = format!(
        "path,ellipse{{fill:none;stroke-linecap:round;stroke-linejoin:round}}\n\
         text{{font-family:'Noto Sans','DejaVu Sans',Verdana,sans-serif;paint-order:stroke;stroke-width:{HALO}px;\
         stroke-linejoin:round}}\n"
    );
    match theme {
        Theme::Light => common + &rules(false),
        Theme::Dark => common + &rules(true),
        Theme::Auto => {
            format!("{common}{}@media (prefers-color-scheme:dark){{\n{}}}\n", rules(false), rules(true))
        }
    }
}

fn painted(element: &mut Element, paint: &Paint) {
    let mut classes = Vec::new();
    classes.extend(paint.fill.map(|role| format!("f-{}", class(role))));
    if let Some((role, width)) = paint.stroke {
        classes.push(format!("s-{}", class(role)));
        element.assign("stroke-width", coordinate(width));
        let dashes = match paint.dash {
            Dash::Solid => None,
            Dash::Dashed => Some(format!("{} {}", coordinate(2.0 + 1.2 * width), coordinate(3.0 + 1.4 * width))),
            Dash::Axis => Some("9 3 1.5 3".to_owned()),
            Dash::Dotted => Some("3 3".to_owned()),
        };
        if let Some(dashes) = dashes {
            element.assign("stroke-dasharray", dashes);
        }
    }
    element.assign("class", classes.join(" "));
}

fn path(commands: &[Command], paint: &Paint) -> Element {
    let mut data = String::new();
    for command in commands {
        match command {
            Command::Move([x, y]) => data += &format!("M{} {}", coordinate(*x), coordinate(*y)),
            Command::Line([x, y]) => data += &format!("L{} {}", coordinate(*x), coordinate(*y)),
            Command::Quadratic([a, b], [x, y]) => {
                data += &format!("Q{} {} {} {}", coordinate(*a), coordinate(*b), coordinate(*x), coordinate(*y));
            }
            Command::Close => data.push('Z'),
        }
    }
    let mut element = Element::new("path");
    element.assign("d", data);
    painted(&mut element, paint);
    element
}

fn ellipse([x, y]: [f64; 2], [along, across]: [f64; 2], turn: f64, paint: &Paint) -> Element {
    let mut element = Element::new("ellipse");
    element.assign("cx", coordinate(x));
    element.assign("cy", coordinate(y));
    element.assign("rx", coordinate(along));
    element.assign("ry", coordinate(across));
    let turn = coordinate(turn);
    if along != across && turn != "0" {
        element.assign("transform", format!("rotate({turn} {} {})", coordinate(x), coordinate(y)));
    }
    painted(&mut element, paint);
    element
}

fn written(text: &Text) -> Element {
    let mut element = Element::new("text");
    let [x, y] = text.at;
    element.assign("x", coordinate(x));
    element.assign("y", coordinate(y));
    element.assign("font-size", coordinate(text.size));
    element.assign("textLength", coordinate(text.width));
    element.assign("lengthAdjust", "spacingAndGlyphs");
    element.assign("class", format!("f-{}", class(text.role)));
    element.append(svg::node::Text::new(printable(&text.text)));
    element
}
