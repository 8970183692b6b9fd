//! Pictures of an arm.

use std::fs;
use std::path::PathBuf;

use denhart_draw::{Theme, View};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;

use crate::error;

/// A picture, as `Arm.draw` gives it. Jupyter shows it.
#[pyclass(frozen, module = "denhart")]
pub struct Picture {
    /// The picture as SVG text.
    #[pyo3(get)]
    pub svg: String,
    pub arm: String,
}

#[pymethods]
impl Picture {
    /// Writes the SVG to a file, whose name ends in .svg.
    #[allow(clippy::needless_pass_by_value)]
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        if path.extension().is_none_or(|kind| !kind.eq_ignore_ascii_case("svg")) {
            return Err(error::value(format!(
                "{}: pictures are SVG: write a name that ends in .svg (`denhart draw` of the command line writes PNG)",
                path.display()
            )));
        }
        py.detach(|| fs::write(&path, &self.svg)).map_err(|error| {
            let reason = error.to_string();
            let reason = reason.split(" (os error").next().unwrap_or_default().to_owned();
            PyOSError::new_err((error.raw_os_error(), reason, path))
        })
    }

    fn _repr_svg_(&self) -> &str {
        &self.svg
    }

    fn __repr__(&self) -> String {
        format!("<Picture of {}: .svg is its text, .save(path) writes it>", self.arm)
    }
}

/// A view by its name.
pub fn view(name: &str) -> PyResult<View> {
    [View::Front, View::Side, View::Top, View::Iso]
        .into_iter()
        .find(|view| view.name() == name)
        .ok_or_else(|| error::value(format!("view: expected \"front\", \"side\", \"top\" or \"iso\", found {name:?}")))
}

/// A theme by its name.
pub fn theme(name: &str) -> PyResult<Theme> {
    match name {
        "auto" => Ok(Theme::Auto),
        "light" => Ok(Theme::Light),
        "dark" => Ok(Theme::Dark),
        _ => Err(error::value(format!("theme: expected \"auto\", \"light\" or \"dark\", found {name:?}"))),
    }
}
