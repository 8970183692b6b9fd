//! Inverse kinematics of six joints without three consecutive axes that meet or are parallel: one joint is held.
//!
//! One joint is held at an angle t. The others close the chain where a trigonometric polynomial of degree 8 in t has a
//! real root. [`meet`] serves arms with two neighboring axes that meet and two that are parallel, [`slides`] arms of which
//! two joints slide, [`general`] all others. Generated code has the constants of its arm, and calls a solver with a target; [`HeldJointSearch`] takes the
//! solver's candidates, and makes them solutions.

pub use denhart_core::{Candidate, Chain, Outcome, Transform, Visitor, general, meet, slides};

pub use crate::solve::HeldJointSearch;
