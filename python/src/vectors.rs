//! Joint vectors of an arm: one or many, in and out.

use denhart_dynamic::{DynamicArm, DynamicError, Joints};
use pyo3::prelude::*;

use crate::arm::Arm;
use crate::array::{Numbers, Results, filled, shown};
use crate::share::{in_lanes, share, threads, told};
use crate::{error, target};

/// Rows from which a block of lanes takes less time than single calls.
const FEWEST: usize = 8;

/// The arguments `threads` and `out` of a batch.
pub type Threaded<'a, 'py> = (Option<i64>, Option<&'a Bound<'py, PyAny>>);

impl Arm {
    /// One joint vector.
    pub fn joints(&self, name: &str, object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let numbers = Numbers::read(name, object)?;
        if *numbers.shape() != [self.arm.joints()] {
            return Err(self.wrong_shape(name, numbers.shape(), None));
        }
        Ok(numbers.values()?.to_vec())
    }

    /// Joint values to begin with, which are finite.
    pub fn start(&self, object: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let start = self.joints("start", object)?;
        match start.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(error::value(format!("start: expected finite joint values, found {value}"))),
            None => Ok(start),
        }
    }

    /// A vector of as many numbers from one.
    pub fn linked<'py>(
        &self,
        name: &str,
        object: &Bound<'py, PyAny>,
        function: impl Fn(&DynamicArm, &[f64]) -> Result<Joints, DynamicError>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = object.py();
        let values = function(&self.arm, &self.joints(name, object)?).map_err(|error| error::dynamic(py, &error))?;
        filled(py, &[values.len()], values.iter().copied())
    }

    /// A joint vector of another shape than `(n,)`, or than `(rows, n)` where there may be several; 0 rows: any number.
    pub fn wrong_shape(&self, name: &str, found: &[usize], rows: Option<usize>) -> PyErr {
        let joints = self.arm.joints();
        let several = match rows {
            None => String::new(),
            Some(0) => format!(" or (N, {joints})"),
            Some(rows) => format!(" or ({rows}, {joints})"),
        };
        let names: Vec<&str> = self.arm.joint_names().collect();
        error::value(format!(
            "{name}: expected shape ({joints},){several}, found {}: {} has the joints {}",
            shown(found),
            self.arm.model().name,
            names.join(", ")
        ))
    }

    /// A function of joint vectors: of each of them `tail` numbers. `one` is the function of one, `many` that of rows, in
    /// lanes and to the same bits.
    fn rows<'py, M: Default>(
        &self,
        q: &Bound<'py, PyAny>,
        tail: &[usize],
        threaded: Option<Threaded<'_, 'py>>,
        one: impl Fn(&[f64], &mut [f64]) + Sync,
        many: impl Fn(&mut M, &[f64], &mut [f64]) + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = q.py();
        let numbers = Numbers::read("q", q)?;
        let joints = self.arm.joints();
        let values = numbers.values()?;
        let mut shape = [0, 0, 0];
        let (rows, shape) = match *numbers.shape() {
            [found] if found == joints && threaded.is_none() => (None, tail),
            [rows, found] if found == joints => {
                for (place, length) in shape.iter_mut().zip([rows].iter().chain(tail)) {
                    *place = *length;
                }
                (Some(rows), shape.get(..=tail.len()).unwrap_or(&[]))
            }
            _ if threaded.is_some() => {
                return Err(error::value(format!("q: expected shape (N, {joints}), found {}", shown(numbers.shape()))));
            }
            _ => return Err(self.wrong_shape("q", numbers.shape(), Some(0))),
        };
        let (asked, out) = threaded.unwrap_or((Some(1), None));
        let results = Results::given(py, out, shape)?;
        {
            let mut writable = results.writable()?;
            let places = writable.values()?;
            match rows {
                None => one(values, places),
                Some(rows) => {
                    let each: usize = tail.iter().product();
                    let joints = joints.max(1);
                    let job = in_lanes(asked, rows)?;
                    let jobs = values.chunks(job * joints).zip(places.chunks_mut(job * each));
                    let work = |memory: &mut M, (values, places): (&[f64], &mut [f64])| {
                        if values.len() >= FEWEST * joints {
                            return many(memory, values, places);
                        }
                        for (q, place) in values.chunks_exact(joints).zip(places.chunks_exact_mut(each)) {
                            one(q, place);
                        }
                    };
                    let threads = threads(asked, rows.div_ceil(job))?;
                    share(py, jobs, threads, work).map_err(|error| told(py, error, out.is_some()))?;
                }
            }
        }
        Ok(results.into_any())
    }

    /// Poses of one joint vector or of many.
    pub fn poses<'py>(
        &self,
        q: &Bound<'py, PyAny>,
        threaded: Option<Threaded<'_, 'py>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let one = |q: &[f64], place: &mut [f64]| self.write_pose(q, place);
        self.rows(q, &[4, 4], threaded, one, |numbers, q, places| self.write_poses(numbers, q, places))
    }

    /// Jacobians of one joint vector or of many.
    pub fn jacobians<'py>(
        &self,
        q: &Bound<'py, PyAny>,
        threaded: Option<Threaded<'_, 'py>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let one = |q: &[f64], place: &mut [f64]| self.write_jacobian(q, place);
        let many = |(): &mut (), q: &[f64], places: &mut [f64]| self.write_jacobians(q, places);
        self.rows(q, &[6, self.arm.joints()], threaded, one, many)
    }

    fn write_pose(&self, q: &[f64], place: &mut [f64]) {
        match self.arm.forward(q) {
            Ok(pose) => place.copy_from_slice(&target::matrix(&pose)),
            // The number of values is that of the joints.
            Err(_) => place.fill(f64::NAN),
        }
    }

    /// Poses of rows of joint values, with memory for their numbers as lanes give them.
    fn write_poses(&self, numbers: &mut Vec<f64>, q: &[f64], places: &mut [f64]) {
        numbers.resize(places.len() / 16 * 12, 0.0);
        if self.arm.forward_batch(q, numbers).is_err() {
            return places.fill(f64::NAN);
        }
        for (place, numbers) in places.as_chunks_mut().0.iter_mut().zip(numbers.as_chunks().0) {
            let &[a, b, c, d, e, f, g, h, i, x, y, z] = numbers;
            *place = [a, b, c, x, d, e, f, y, g, h, i, z, 0.0, 0.0, 0.0, 1.0];
        }
    }

    fn write_jacobians(&self, q: &[f64], places: &mut [f64]) {
        if self.arm.jacobian_batch(q, places).is_err() {
            places.fill(f64::NAN);
        }
    }

    fn write_jacobian(&self, q: &[f64], place: &mut [f64]) {
        match self.arm.jacobian(q) {
            Ok(rows) => {
                for (to, row) in place.chunks_exact_mut(self.arm.joints().max(1)).zip(&rows) {
                    to.copy_from_slice(row);
                }
            }
            Err(_) => place.fill(f64::NAN),
        }
    }

    /// `q`, and vectors beside it of the same shape.
    pub fn beside<'py, const K: usize>(
        &self,
        q: &Bound<'py, PyAny>,
        others: [(&str, &Bound<'py, PyAny>); K],
        one: impl Fn(&[f64], [&[f64]; K]) -> [f64; 6],
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = q.py();
        let joints = self.arm.joints();
        let numbers = Numbers::read("q", q)?;
        let shape = numbers.shape();
        let rows = match *shape {
            [found] if found == joints => None,
            [rows, found] if found == joints => Some(rows),
            _ => return Err(self.wrong_shape("q", shape, Some(0))),
        };
        let others = others.map(|(name, other)| {
            let read = Numbers::read(name, other)?;
            if read.shape() == shape {
                return Ok(read);
            }
            Err(error::value(format!(
                "{name}: expected the shape of q, {}, found {}",
                shown(shape),
                shown(read.shape())
            )))
        });
        let mut vectors: [&[f64]; K] = [&[]; K];
        for (vector, other) in vectors.iter_mut().zip(&others) {
            *vector = match other {
                Ok(other) => other.values()?,
                Err(error) => return Err(error.clone_ref(py)),
            };
        }
        let results = match rows {
            None => Results::new(py, &[6])?,
            Some(rows) => Results::new(py, &[rows, 6])?,
        };
        for (index, (q, place)) in numbers
            .values()?
            .chunks_exact(joints.max(1))
            .zip(results.writable()?.values()?.chunks_exact_mut(6))
            .enumerate()
        {
            let each = vectors.map(|vector| vector.get(index * joints..(index + 1) * joints).unwrap_or(&[]));
            place.copy_from_slice(&one(q, each));
        }
        Ok(results.into_any())
    }
}
