//! The inverse of a matrix of decimal numbers, exact: a zero in it is a zero, and a half is a half.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A square matrix, `[row][column]`.
pub type Matrix = Vec<Vec<f64>>;

/// The inverse, each entry rounded once. `Err` with a row that is a combination of others if there is none.
///
/// Every number is taken as the shortest decimal that reads as it, which is how it was written: one third of
/// `[[0.3, 0.1]]` is the 0.1 of the file and not its nearest double. Gauss and Jordan's elimination in rationals.
pub fn inverse(matrix: &[Vec<f64>]) -> Result<Matrix, usize> {
    let n = matrix.len();
    let unit = |row: usize, column: usize| if row == column { BigRational::one() } else { BigRational::zero() };
    // Each row beside that of the unit matrix, and which row of the file it was.
    let mut rows: Vec<(usize, Vec<BigRational>)> = matrix
        .iter()
        .enumerate()
        .map(|(row, entries)| {
            let entries = entries.iter().map(|entry| decimal(*entry));
            (row, entries.chain((0..n).map(|column| unit(row, column))).collect())
        })
        .collect();
    for column in 0..n {
        let entry = |row: &(usize, Vec<BigRational>)| row.1.get(column).cloned().unwrap_or_else(BigRational::zero);
        let Some(pivot) = (column..n).find(|row| rows.get(*row).is_some_and(|row| !entry(row).is_zero())) else {
            // What is left below has no share in this column: one of the rows there follows from the others.
            let zero = |row: &&(usize, Vec<BigRational>)| row.1.iter().take(n).all(Zero::is_zero);
            let rest = rows.get(column..).unwrap_or_default();
            return Err(rest.iter().find(zero).or(rest.last()).map_or(column, |row| row.0));
        };
        rows.swap(column, pivot);
        let Some((_, pivot)) = rows.get_mut(column) else { continue };
        let Some(scale) = pivot.get(column).cloned() else { continue };
        for value in pivot.iter_mut() {
            *value = value.clone() / &scale;
        }
        let pivot = pivot.clone();
        for (index, row) in rows.iter_mut().enumerate() {
            let factor = entry(row);
            if index != column && !factor.is_zero() {
                for (value, above) in row.1.iter_mut().zip(&pivot) {
                    *value = value.clone() - factor.clone() * above;
                }
            }
        }
    }
    Ok(rows.iter().map(|(_, row)| row.iter().skip(n).map(nearest).collect()).collect())
}

/// The shortest decimal that reads as `value`.
fn decimal(value: f64) -> BigRational {
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let exponent = exponent.parse::<i32>().unwrap_or(0) - i32::try_from(fraction.len()).unwrap_or(0);
    let mantissa: BigRational = format!("{whole}{fraction}").parse().unwrap_or_else(|_| BigRational::zero());
    let ten = BigRational::from_integer(10.into());
    mantissa * ten.pow(exponent)
}

fn nearest(value: &BigRational) -> f64 {
    let magnitude = value.abs().to_f64().unwrap_or(f64::INFINITY);
    if value.is_negative() { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_are_exact() {
        let fanuc = [vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, -1.0, -1.0]];
        assert_eq!(inverse(&fanuc), Ok(fanuc.to_vec()));
        assert_eq!(inverse(&[vec![100.0, 0.0], vec![-1.0, 80.0]]), Ok(vec![vec![0.01, 0.0], vec![1.25e-4, 0.0125]]));
        assert_eq!(inverse(&[vec![0.0, 2.0], vec![-0.1, 0.0]]), Ok(vec![vec![0.0, -10.0], vec![0.5, 0.0]]));
        assert_eq!(inverse(&[vec![3.0]]), Ok(vec![vec![1.0 / 3.0]]));
        assert_eq!(inverse(&[vec![1e-300]]), Ok(vec![vec![1e300]]));
    }

    /// As decimals these rows are multiples of each other; as doubles they are not.
    #[test]
    fn singular_matrices_name_a_row() {
        assert_eq!(inverse(&[vec![0.1, 0.2], vec![0.3, 0.6]]), Err(1));
        assert_eq!(inverse(&[vec![0.0, 0.0], vec![0.0, 1.0]]), Err(0));
        let ones = vec![1.0; 3];
        assert_eq!(inverse(&[vec![0.0, 1.0, 0.0], ones.clone(), ones]), Err(2));
    }
}
