//! The font of all pictures, which comes along: widths of texts, and texts as outlines.

use ttf_parser::{Face, GlyphId, OutlineBuilder};

use crate::picture::Command;
use crate::vector::Flat;

/// Noto Sans, a subset: see the file NOTICE of this crate.
static BYTES: &[u8] = include_bytes!("../font/NotoSans-Regular.ttf");

/// Width of a character that the font lacks, in parts of the font size.
const UNKNOWN: f64 = 0.6;
/// Height of a capital letter and depth below the line, in parts of the font size.
pub const CAPITAL: f64 = 0.714;
/// Depth of letters below the line, in parts of the font size.
pub const DEPTH: f64 = 0.22;

/// The shipped font.
#[derive(Debug)]
pub struct Font {
    face: Option<Face<'static>>,
}

impl Font {
    /// The font.
    pub fn new() -> Self {
        Font { face: Face::parse(BYTES, 0).ok() }
    }

    fn units(&self) -> f64 {
        self.face.as_ref().map_or(1000.0, |face| f64::from(face.units_per_em()))
    }

    /// The glyph of a character; the minus is the dash of its width, which the font has.
    fn glyph(&self, letter: char) -> Option<GlyphId> {
        let letter = if letter == '\u{2212}' { '\u{2013}' } else { letter };
        self.face.as_ref()?.glyph_index(letter)
    }

    /// Width of a glyph in parts of the font size.
    fn advance(&self, glyph: Option<GlyphId>) -> f64 {
        let advance = glyph.and_then(|glyph| self.face.as_ref()?.glyph_hor_advance(glyph));
        advance.map_or(UNKNOWN, |advance| f64::from(advance) / self.units())
    }

    /// Width of a text of a font size, px.
    pub fn width(&self, text: &str, size: f64) -> f64 {
        text.chars().map(|letter| self.advance(self.glyph(letter))).sum::<f64>() * size
    }

    /// The text as outlines, its line beginning at `at`. A character that the font lacks is an empty box.
    pub fn outline(&self, text: &str, size: f64, at: Flat) -> Vec<Command> {
        let [mut x, y] = at;
        let mut commands = Vec::new();
        for letter in text.chars() {
            let glyph = self.glyph(letter);
            let scale = size / self.units();
            if let (Some(face), id) = (&self.face, glyph.unwrap_or(GlyphId(0))) {
                let mut outline = Outline { at: [x, y], scale, commands: &mut commands };
                face.outline_glyph(id, &mut outline);
            }
            x += self.advance(glyph) * size;
        }
        commands
    }
}

/// Receives the outline of one glyph.
struct Outline<'a> {
    at: Flat,
    scale: f64,
    commands: &'a mut Vec<Command>,
}

impl Outline<'_> {
    fn place(&self, x: f32, y: f32) -> Flat {
        let [left, line] = self.at;
        [left + self.scale * f64::from(x), line - self.scale * f64::from(y)]
    }
}

impl OutlineBuilder for Outline<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let end = self.place(x, y);
        self.commands.push(Command::Move(end));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let end = self.place(x, y);
        self.commands.push(Command::Line(end));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let end = self.place(x, y);
        self.commands.push(Command::Quadratic(self.place(x1, y1), end));
    }

    /// Fonts of this kind have quadratic curves alone; a cubic one is drawn by its middle tangent.
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.quad_to(0.5 * (x1 + x2), 0.5 * (y1 + y2), x, y);
    }

    fn close(&mut self) {
        self.commands.push(Command::Close);
    }
}
