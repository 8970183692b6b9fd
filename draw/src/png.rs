//! A picture as PNG.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::DrawError;
use crate::document::{Letters, svg};
use crate::picture::Picture;
use crate::theme::Theme;

/// The bytes of a PNG file that is `width` pixels wide.
///
/// # Errors
/// A picture of no size, or too large for the memory.
pub fn png(picture: &Picture, theme: Theme, width: u32) -> Result<Vec<u8>, DrawError> {
    let failed = |reason: String| DrawError::Png(reason);
    // A PNG has one look: without the rules for dark viewers.
    let theme = if theme == Theme::Auto { Theme::Light } else { theme };
    let tree = Tree::from_str(&svg(picture, theme, Letters::Outlines), &Options::default());
    let tree = tree.map_err(|error| failed(error.to_string()))?;
    let scale = width as f32 / tree.size().width();
    let height = (tree.size().height() * scale).round() as u32;
    let mut pixels = Pixmap::new(width, height).ok_or_else(|| failed(format!("{width} x {height} pixels")))?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(error.to_string()))
}
