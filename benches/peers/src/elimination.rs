//! A bare 6 x 6 solve: the yardstick for one iteration of a numeric inverse.

/// Solves `A x = b` by Gaussian elimination with partial pivoting (Golub and Van Loan, "Matrix Computations", algorithm
/// 3.4.1), in plain arrays.
pub fn solve(mut a: [[f64; 6]; 6], mut b: [f64; 6]) -> [f64; 6] {
    for k in 0..6 {
        let mut pivot = k;
        for i in k + 1..6 {
            if a[i][k].abs() > a[pivot][k].abs() {
                pivot = i;
            }
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        let inverse = 1.0 / a[k][k];
        for i in k + 1..6 {
            let factor = a[i][k] * inverse;
            for j in k + 1..6 {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..6).rev() {
        let mut sum = b[k];
        for j in k + 1..6 {
            sum -= a[k][j] * b[j];
        }
        b[k] = sum / a[k][k];
    }
    b
}
