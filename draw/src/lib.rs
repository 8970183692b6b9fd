//! Pictures of robot arms.
//!
//! An arm and joint values become a [`Scene`]: a plain list of things in space. A scene becomes a [`Picture`] in a
//! [`View`], and a picture becomes SVG or, with the feature `png`, PNG. The same input gives the same bytes: coordinates are
//! rounded to a tenth of a pixel, and the font comes along. Nothing here reads files or asks the system, so that the crate
//! compiles to WebAssembly.
//!
//! ```
//! use denhart_draw::{Scene, Style, View};
//! use denhart_dynamic::DynamicArm;
//!
//! # fn main() -> Result<(), denhart_draw::DrawError> {
//! let arm = DynamicArm::from_yaml(
//!     "
//! name: elbow
//! convention: standard
//! units: {length: m, angle: deg}
//! joints:
//!   - {a: 0.3, alpha: 0, d: 0, theta: 0}
//!   - {a: 0.2, alpha: 0, d: 0, theta: 0}
//! ",
//! )?;
//! let scene = Scene::of(&arm, &[0.4, 0.9])?.with_dimensions();
//! let svg = scene.svg(&Style::of(View::Top));
//! assert!(svg.starts_with("<svg") && svg.contains("a1 0.3 m"));
//! # Ok(())
//! # }
//! ```
//!
//! - A joint that turns is a cylinder about its axis, one that slides is a box along it. The arrow on the axis shows the
//!   positive motion by the right hand.
//! - Links lead along the axes and at right angles between them, as the lengths of a table do. Where frames of a table lie
//!   far from the arm, its links do not.
//! - Texts never lie over each other. One without a place stands in the notes below the picture.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod aims;
mod apart;
mod canvas;
mod contour;
mod deciding;
mod document;
mod error;
mod figure;
mod font;
mod furniture;
mod labels;
mod measures;
mod number;
mod paint;
mod picture;
#[cfg(feature = "png")]
mod png;
mod scene;
mod section;
mod skeleton;
mod solutions;
mod style;
mod symbols;
mod theme;
mod vector;
mod view;

pub use apart::apart;
pub use deciding::{DecidingLines, deciding_words};
pub use error::DrawError;
pub use picture::{Command, Dash, Paint, Picture, Role, Shape, Text};
pub use scene::{Figure, Miss, Scene};
pub use section::{Curves, Section, section};
pub use skeleton::{Joint, Measure, NamedFrame, Skeleton};
pub use style::Style;
pub use theme::Theme;
pub use vector::{Flat, Vector};
pub use view::View;
