//! The module `denhart._denhart`, which the Python package `denhart` re-exports.
//!
//! Thin functions over denhart-dynamic: they read arrays, call the solver without the lock of the interpreter where a
//! call is long, and write arrays. Every class is frozen, so that objects may be used by any number of threads at once;
//! the state of a follower is behind a lock.

mod arm;
mod array;
mod beyond;
mod error;
mod follow;
mod follower;
mod inverse;
mod picture;
mod share;
mod solutions;
mod sweep;
mod table;
mod target;
mod turns;
mod vectors;

use pyo3::prelude::*;

/// Compiled part of the package denhart.
#[pymodule(gil_used = false)]
mod _denhart {
    #[pymodule_export]
    use crate::arm::Arm;
    #[pymodule_export]
    use crate::follow::{Motion, Obstacle};
    #[pymodule_export]
    use crate::follower::{Follower, Step};
    #[pymodule_export]
    use crate::inverse::InverseBatch;
    #[pymodule_export]
    use crate::picture::Picture;
    #[pymodule_export]
    use crate::solutions::{NumericSolution, Solution, Solutions};
    #[pymodule_export]
    use crate::target::Target;
}
