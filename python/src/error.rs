//! Exceptions.

use denhart_dynamic::DynamicError;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

static ARM_ERROR: PyOnceLock<Py<PyType>> = PyOnceLock::new();

/// An `ArmError` with this text. The class is one of Python: only there can a class of the stable interface extend
/// `ValueError`.
pub fn arm(py: Python<'_>, message: impl ToString) -> PyErr {
    match ARM_ERROR.import(py, "denhart._names", "ArmError") {
        Ok(class) => PyErr::from_type(class.clone(), (message.to_string(),)),
        Err(error) => error,
    }
}

/// The exception of an error of the tools, with options as Python has them.
pub fn tools(py: Python<'_>, error: &denhart_tools::Error) -> PyErr {
    let text = error.to_string();
    arm(
        py,
        text.replace("--prefix: ", "prefix: ")
            .replace("--base ", "base=")
            .replace("--tool ", "tool=")
            .replace("`denhart arms` lists", "Arm.presets() lists"),
    )
}

/// The exception of an error of the solver.
pub fn dynamic(py: Python<'_>, error: &DynamicError) -> PyErr {
    let text = match error {
        DynamicError::NoInverse(reason) => format!(
            "no inverse kinematics: {reason}\nhelp: arm.numeric(target, start) solves any arm by iteration; arm.report() \
             names the tasks that this arm can do"
        ),
        other => other.to_string(),
    };
    arm(py, text)
}

/// A value that is wrong.
pub fn value(message: impl Into<String>) -> PyErr {
    PyValueError::new_err(message.into())
}

/// A type that is wrong.
pub fn kind(message: impl Into<String>) -> PyErr {
    PyTypeError::new_err(message.into())
}
