//! How a scene is drawn.

use crate::document::{Letters, svg};
use crate::font::Font;
use crate::paint::picture;
use crate::picture::Picture;
use crate::scene::Scene;
use crate::theme::Theme;
use crate::vector::Flat;
use crate::view::View;

/// Sizes of a drawing that are used, px.
const SIZES: [f64; 2] = [160.0, 4000.0];

/// How a scene is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Style {
    /// From where.
    pub view: View,
    /// In which colors.
    pub theme: Theme,
    /// Width and height of the drawing without title, legend and notes, px; from 160 to 4000. Below a width of 480 names,
    /// legend and notes are left out.
    pub size: Flat,
}

impl Style {
    /// 720 by 440 px, in the colors that the viewer prefers.
    #[must_use]
    pub fn of(view: View) -> Self {
        Style { view, theme: Theme::Auto, size: [720.0, 440.0] }
    }

    /// This style in other colors.
    #[must_use]
    pub fn with_theme(self, theme: Theme) -> Self {
        Style { theme, ..self }
    }

    /// This style at another size.
    #[must_use]
    pub fn with_size(self, width: f64, height: f64) -> Self {
        Style { size: [width, height], ..self }
    }
}

impl Scene {
    /// The picture.
    #[must_use]
    pub fn picture(&self, style: &Style) -> Picture {
        let [least, most] = SIZES;
        let size = style.size.map(|size| if size.is_finite() { size.clamp(least, most) } else { most });
        picture(self, style.view, size, &Font::new())
    }

    /// The picture as SVG. Its texts are texts, and take the width of the shipped font in any viewer.
    #[must_use]
    pub fn svg(&self, style: &Style) -> String {
        svg(&self.picture(style), style.theme, Letters::Text)
    }

    /// The picture as SVG with its texts as outlines of the shipped font: larger, and alike in every viewer.
    #[must_use]
    pub fn outlined_svg(&self, style: &Style) -> String {
        svg(&self.picture(style), style.theme, Letters::Outlines)
    }

    /// The picture as a PNG file, `width` pixels wide. Its texts are drawn in the shipped font.
    ///
    /// # Errors
    /// More pixels than fit into memory.
    #[cfg(feature = "png")]
    pub fn png(&self, style: &Style, width: u32) -> Result<Vec<u8>, crate::DrawError> {
        crate::png::png(&self.picture(style), style.theme, width)
    }
}
