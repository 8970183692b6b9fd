//! Solutions over the values of redundant joints.

use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::arm::Arm;
use crate::inverse::{Asked, drop};
use crate::{error, target};

/// Values that a sweep may take in all.
const MOST: usize = 1_000_000;

/// The argument `n`: a number of steps, or one for each value.
struct Steps {
    counts: Vec<usize>,
    is_list: bool,
}

impl Steps {
    fn read(n: &Bound<'_, PyAny>) -> PyResult<Self> {
        if let Ok(count) = n.extract() {
            return Ok(Self { counts: vec![count], is_list: false });
        }
        match n.extract() {
            Ok(counts) => Ok(Self { counts, is_list: true }),
            Err(_) => Err(error::kind(format!(
                "sweep: n: expected a whole number of steps from 0 on, or one for each value, found {}",
                n.repr()?
            ))),
        }
    }
}

/// Pairs of the values and the `Solutions` there.
pub fn sweep<'py>(
    of: &Bound<'py, Arm>,
    target: &Bound<'py, PyAny>,
    n: &Bound<'py, PyAny>,
    limits: &str,
) -> PyResult<Bound<'py, PyList>> {
    let py = of.py();
    let arm = &of.get().arm;
    let target = target::read(arm, target)?;
    let drop = drop(limits)?;
    let names = arm.given().map_err(|error| error::dynamic(py, &error))?;
    let Steps { counts, is_list } = Steps::read(n)?;
    match names.as_slice() {
        [] => return Err(error::value("sweep: this arm's inverse takes no value beside the target")),
        names if names.len() != counts.len() => {
            return Err(error::value(format!(
                "sweep: n has {} of steps, and this arm's inverse takes the values {}: expected {} counts",
                counts.len(),
                names.join(", "),
                names.len()
            )));
        }
        _ => {}
    }
    let all = counts.iter().fold(1, |all: usize, count| all.saturating_mul(*count));
    if all > MOST {
        return Err(error::value(format!("sweep: n: expected up to {MOST} values in all, found {all}")));
    }
    let found = py.detach(|| arm.sample_redundancy(&target, &counts)).map_err(|error| error::dynamic(py, &error))?;
    let list = PyList::empty(py);
    for (given, all) in found {
        py.check_signals()?;
        let value = match (is_list, given.as_slice()) {
            (false, [value]) => value.into_pyobject(py)?.into_any(),
            (_, values) => PyTuple::new(py, values)?.into_any(),
        };
        let asked = Asked { target, near: None, given, branch: None, drop };
        list.append((value, asked.answered(of.clone().unbind(), all)))?;
    }
    Ok(list)
}
