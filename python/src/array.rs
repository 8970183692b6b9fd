//! Arrays of numpy, in and out.
//!
//! Results are allocated by calls of `numpy.empty`: where memory is short it raises `MemoryError`, and the constructors
//! of the crate `numpy` panic.

use std::hash::{DefaultHasher, Hash, Hasher};

use numpy::{
    PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyTuple};

use crate::error;

static EMPTY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
static ASARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
static REQUIRE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

fn function<'py>(
    py: Python<'py>,
    place: &'static PyOnceLock<Py<PyAny>>,
    name: &str,
) -> PyResult<&'py Bound<'py, PyAny>> {
    place.import(py, "numpy", name)
}

/// Numbers of an argument, as they lie in memory: in C order.
pub struct Numbers<'py>(PyReadonlyArrayDyn<'py, f64>);

impl<'py> Numbers<'py> {
    /// Reads an argument, which messages call `name`. An array of float64 in C order is not copied.
    pub fn read(name: &str, object: &Bound<'py, PyAny>) -> PyResult<Self> {
        if !object.is_exact_instance_of::<PyUntypedArray>() {
            refuse_masked(name, object)?;
        }
        if let Ok(array) = object.cast::<PyArrayDyn<f64>>()
            && array.is_c_contiguous()
            && array.is_aligned()
        {
            return Self::borrow(name, array);
        }
        let py = object.py();
        let array = function(py, &ASARRAY, "asarray")?.call1((object,)).map_err(|cause| {
            // Memory that is short is told as such.
            if cause.is_instance_of::<PyMemoryError>(py) {
                return cause;
            }
            let error = error::value(format!("{name}: expected an array of numbers, found {}", described(object)));
            error.set_cause(py, Some(cause));
            error
        })?;
        let dtype = array.getattr("dtype")?;
        let kind: String = dtype.getattr("kind")?.extract()?;
        match kind.as_str() {
            "f" | "i" | "u" => {}
            "O" => {
                return Err(error::kind(format!(
                    "{name}: expected an array of numbers, found one of objects: {}",
                    described(object)
                )));
            }
            _ => return Err(error::kind(format!("{name}: expected real numbers, found dtype {dtype}"))),
        }
        let options = PyDict::new(py);
        options.set_item("dtype", "float64")?;
        options.set_item("requirements", ("C", "A"))?;
        let array = function(py, &REQUIRE, "require")?.call((array,), Some(&options))?;
        Self::borrow(name, array.cast::<PyArrayDyn<f64>>()?)
    }

    fn borrow(name: &str, array: &Bound<'py, PyArrayDyn<f64>>) -> PyResult<Self> {
        array.try_readonly().map(Self).map_err(|_| {
            error::value(format!("{name}: the array is the out= of a call that is running, or overlaps it"))
        })
    }

    /// The shape.
    pub fn shape(&self) -> &[usize] {
        self.0.shape()
    }

    /// All numbers, the last index fastest.
    pub fn values(&self) -> PyResult<&[f64]> {
        self.0.as_slice().map_err(|error| error::value(error.to_string()))
    }
}

/// An array for results.
pub struct Results<'py>(Bound<'py, PyArrayDyn<f64>>);

impl<'py> Results<'py> {
    /// A new array of this shape.
    pub fn new(py: Python<'py>, shape: &[usize]) -> PyResult<Self> {
        Ok(Self(empty(py, shape, None)?.cast_into()?))
    }

    /// The array given by the user as `out=`, which has to have this shape; else a new one.
    pub fn given(py: Python<'py>, out: Option<&Bound<'py, PyAny>>, shape: &[usize]) -> PyResult<Self> {
        let Some(out) = out else { return Self::new(py, shape) };
        let expected = format!("a C-contiguous, writable numpy array of float64 with shape {}", shown(shape));
        let found = || {
            let Ok(dtype) = out.getattr("dtype") else { return described(out) };
            let shape = out.getattr("shape").map_or_else(|_| String::new(), |shape| shape.to_string());
            format!("{dtype} with shape {shape}")
        };
        let wrong = |what: &str| error::value(format!("out: expected {expected}, found {what}"));
        let Ok(array) = out.cast::<PyArrayDyn<f64>>() else { return Err(wrong(&found())) };
        refuse_masked("out", out)?;
        if array.shape() != shape {
            return Err(wrong(&found()));
        }
        if !array.is_c_contiguous() || !array.is_aligned() {
            return Err(wrong("one with gaps or in another order"));
        }
        Ok(Self(array.clone()))
    }

    /// The numbers, to be written.
    pub fn writable(&self) -> PyResult<Writable<'py>> {
        self.0.try_readwrite().map(Writable).map_err(|reason| {
            error::value(match reason {
                numpy::BorrowError::NotWriteable => "out: the array is read-only".to_owned(),
                _ => "out: the array overlaps an argument, or is in use by a call that is running".to_owned(),
            })
        })
    }

    /// The array, for Python.
    pub fn into_any(self) -> Bound<'py, PyAny> {
        self.0.into_any()
    }
}

/// Numbers of an array that nothing else reads or writes.
pub struct Writable<'py>(PyReadwriteArrayDyn<'py, f64>);

impl Writable<'_> {
    /// All numbers, the last index fastest.
    pub fn values(&mut self) -> PyResult<&mut [f64]> {
        self.0.as_slice_mut().map_err(|error| error::value(error.to_string()))
    }
}

/// A hash of numbers. Zeros of both signs are equal.
pub fn hash(numbers: impl IntoIterator<Item = f64>) -> u64 {
    let mut hasher = DefaultHasher::new();
    numbers.into_iter().for_each(|number| (number + 0.0).to_bits().hash(&mut hasher));
    hasher.finish()
}

/// Refuses a masked array, whose mask would be lost.
fn refuse_masked(name: &str, object: &Bound<'_, PyAny>) -> PyResult<()> {
    if object.cast::<PyUntypedArray>().is_ok() && object.hasattr("mask")? {
        return Err(error::kind(format!(
            "{name}: expected an array without a mask, found a masked one: give its .filled(..) or .data"
        )));
    }
    Ok(())
}

/// A new array of this shape, of float64 without another type.
pub fn empty<'py>(py: Python<'py>, shape: &[usize], dtype: Option<&str>) -> PyResult<Bound<'py, PyAny>> {
    let shape = PyTuple::new(py, shape)?;
    let empty = function(py, &EMPTY, "empty")?;
    match dtype {
        None => empty.call1((shape,)),
        Some(dtype) => empty.call1((shape, dtype)),
    }
}

/// A new array with these numbers.
pub fn filled<'py>(
    py: Python<'py>,
    shape: &[usize],
    numbers: impl IntoIterator<Item = f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let results = Results::new(py, shape)?;
    for (place, number) in results.writable()?.values()?.iter_mut().zip(numbers) {
        *place = number;
    }
    Ok(results.into_any())
}

/// A shape as Python writes it: `(6,)`, `(100, 6)`.
pub fn shown(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        shape => format!("({})", shape.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// An object in a few words, for messages.
fn described(object: &Bound<'_, PyAny>) -> String {
    let class = object.get_type();
    let name = class.name().map_or_else(|_| "an object".to_owned(), |name| name.to_string());
    match object.repr() {
        Ok(text) if text.to_string().len() <= 60 => format!("{name} {text}"),
        _ => name,
    }
}
