//! Reference data: poses, Jacobians and complete sets of solutions, computed apart from this project.

use std::path::PathBuf;

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion};
use serde::Deserialize;

/// One arm of `data/*.json`.
#[derive(Debug, Deserialize)]
pub struct Reference {
    pub name: String,
    pub dof: usize,
    #[serde(rename = "observed_real_solution_counts")]
    pub counts: Counts,
    pub samples: Vec<Sample>,
}

/// Number of real solutions of each sample's pose.
#[derive(Debug, Deserialize)]
pub struct Counts {
    /// For the full pose, limits left aside; one number a sample.
    #[serde(rename = "full_pose_real_counts_per_config_no_limits")]
    pub pose: Option<Vec<usize>>,
}

/// A joint vector with its pose and Jacobian.
#[derive(Debug, Deserialize)]
pub struct Sample {
    /// `[N]`, rad or length unit.
    pub q: Vec<f64>,
    /// Homogeneous matrix of the tool in the base frame, row by row.
    pub pose: Matrix4,
    /// `[6][N]`, base frame, rows vx vy vz wx wy wz.
    pub jacobian: Vec<Vec<f64>>,
}

/// All real solutions of one pose.
#[derive(Debug, Deserialize)]
pub struct Truth {
    pub arm: String,
    pub pose: Matrix4,
    pub real_solution_count: usize,
    /// `[count][N]`, angles in `(-pi, pi]`.
    pub solutions: Vec<Vec<f64>>,
}

/// A homogeneous matrix, row by row.
pub type Matrix4 = [[f64; 4]; 4];

/// Rotation and translation of a homogeneous matrix, as they are.
pub fn pose(matrix: &Matrix4) -> denhart::Pose<f64> {
    denhart::Pose {
        rotation: std::array::from_fn(|row| std::array::from_fn(|column| matrix[row][column])),
        translation: std::array::from_fn(|row| matrix[row][3]),
    }
}

/// The rigid motion of a homogeneous matrix.
pub fn isometry(matrix: &Matrix4) -> Isometry3<f64> {
    let rotation = Matrix3::from_fn(|row, column| matrix[row][column]);
    Isometry3::from_parts(
        Translation3::new(matrix[0][3], matrix[1][3], matrix[2][3]),
        UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation)),
    )
}

/// The reference of an arm.
pub fn load(name: &str) -> Reference {
    parse(name)
}

/// Every pose whose solutions are all known.
pub fn truths() -> Vec<Truth> {
    parse("inverse_truth")
}

fn parse<T: serde::de::DeserializeOwned>(name: &str) -> T {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data").join(format!("{name}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
