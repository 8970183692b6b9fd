//! The direction that a singular posture has lost, and one across it.

use denhart::{Arm, InverseKinematics, Pose};
use nalgebra::{Matrix6, SMatrix, SymmetricEigen};

use super::path::moved;

fn unit(a: [f64; 3]) -> [f64; 3] {
    let n = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    a.map(|x| x / n)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The twist that the arm loses at `q`, lengths over `reach`, and the least singular value. `locked`: this joint stays.
pub fn lost<A: Arm<f64, N>, const N: usize>(arm: &A, q: &[f64; N], reach: f64, locked: Option<usize>) -> ([f64; 6], f64) {
    let rows = arm.jacobian(q).rows;
    let scale = |row: usize, joint: usize| match Some(joint) == locked {
        true => 0.0,
        false if row < 3 => 1.0 / reach,
        false => 1.0,
    };
    let jacobian = SMatrix::<f64, 6, N>::from_fn(|row, joint| rows[row][joint] * scale(row, joint));
    let square: Matrix6<f64> = jacobian * jacobian.transpose();
    let eigen = SymmetricEigen::new(square);
    let least = (0..6).min_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b])).unwrap_or(0);
    let vector: [f64; 6] = std::array::from_fn(|row| eigen.eigenvectors[(row, least)]);
    // One of its two signs, the same on every platform.
    let side = [0.3, 0.7, -0.2, 0.5, 0.9, -0.4].iter().zip(vector).map(|(a, b)| a * b).sum::<f64>();
    (vector.map(|x| x.copysign(x * side)), eigen.eigenvalues[least].max(0.0).sqrt())
}

/// The direction lost in translation, and the one across it in which the singularity is left fastest.
pub fn directions<A, const N: usize>(
    arm: &A,
    q: &[f64; N],
    reach: f64,
    locked: Option<usize>,
    target: impl Fn(Pose<f64>) -> A::Target,
) -> [[f64; 3]; 2]
where
    A: InverseKinematics<f64, N>,
{
    let (w, _) = lost(arm, q, reach, locked);
    let n = unit([w[0], w[1], w[2]]);
    let a = unit(cross(n, if n[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] }));
    let b = cross(n, a);
    let (mut best, mut along) = (0.0, a);
    for k in 0..36 {
        let (s, c) = (f64::from(k) * 5f64.to_radians()).sin_cos();
        let u = [0, 1, 2].map(|i| a[i] * c + b[i] * s);
        let found = arm.inverse_near(&target(moved(&arm.forward(q), u, 0.02 * reach)), q);
        let Some(solution) = found.as_ref().first() else { continue };
        let near = solution.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 0.5);
        let (_, least) = lost(arm, &solution.q, reach, locked);
        if near && least > best {
            (best, along) = (least, u);
        }
    }
    [n, along]
}

/// The direction in which an arm is stretched, away from the base.
pub fn outward<A: Arm<f64, N>, const N: usize>(arm: &A, q: &[f64; N], reach: f64) -> [f64; 3] {
    let (w, _) = lost(arm, q, reach, None);
    let out = unit([w[0], w[1], w[2]]);
    let along = arm.forward(q).translation.iter().zip(out).map(|(a, b)| a * b).sum::<f64>();
    out.map(|x| x.copysign(x * along))
}
