//! The inverse of a matrix of decimal numbers, exact: a zero in it is a zero, and a half is a half.

use std::cmp::Ordering;

/// A square matrix, `[row][column]`.
pub type Matrix = Vec<Vec<f64>>;

/// The inverse, each entry off by a unit in its last place at most. `Err` with a row that is a combination of others if there is none.
///
/// Every number is taken as the shortest decimal that reads as it, which is how it was written. One third of
/// `[[0.3, 0.1]]` is the 0.1 of the file and not its nearest double. Gauss and Jordan's elimination in fractions of whole
/// numbers; in doubles, with the largest pivot, where these grow beyond 38 digits.
pub fn inverse(matrix: &[Vec<f64>]) -> Result<Matrix, usize> {
    match eliminate(matrix, Ratio::decimal) {
        Some(Ok(rows)) => Ok(rows.iter().map(|row| row.iter().map(Ratio::nearest).collect()).collect()),
        Some(Err(row)) => Err(row),
        None => {
            let inverse = eliminate(matrix, Some).unwrap_or(Err(0))?;
            // What rounding has left of a pivot that is zero makes an inverse that is none.
            if is_inverse(matrix, &inverse) { Ok(inverse) } else { Err(matrix.len().saturating_sub(1)) }
        }
    }
}

/// Returns true if the product is the unit matrix, up to the error that a motor's value may have.
fn is_inverse(matrix: &[Vec<f64>], inverse: &[Vec<f64>]) -> bool {
    let column = |j: usize| inverse.iter().map(move |row| row.get(j).copied().unwrap_or(f64::NAN));
    let product = |row: &[f64], j: usize| row.iter().zip(column(j)).map(|(a, b)| a * b).sum::<f64>();
    let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
    let fits = |(i, row): (usize, &Vec<f64>)| (0..matrix.len()).all(|j| (product(row, j) - unit(i, j)).abs() < 1e-9);
    matrix.iter().enumerate().all(fits)
}

/// Arithmetic of an elimination. `None` where a result is beyond the range of the number.
trait Number: Copy {
    const ZERO: Self;
    const ONE: Self;
    fn is_zero(self) -> bool;
    /// `self / other`, other not zero.
    fn over(self, other: Self) -> Option<Self>;
    /// `self - a b`
    fn less(self, a: Self, b: Self) -> Option<Self>;
    /// Which of two is the better pivot, neither being zero.
    fn compare(self, other: Self) -> Ordering;
}

type Rows<T> = Vec<Vec<T>>;

/// The inverse, or a row without a pivot; `None` beyond the range of the numbers.
fn eliminate<T: Number>(matrix: &[Vec<f64>], number: impl Fn(f64) -> Option<T>) -> Option<Result<Rows<T>, usize>> {
    let n = matrix.len();
    // Each row beside that of the unit matrix, and which row of the file it was.
    let mut rows: Vec<(usize, Vec<T>)> = Vec::new();
    for (row, entries) in matrix.iter().enumerate() {
        let mut entries = entries.iter().map(|entry| number(*entry)).collect::<Option<Vec<T>>>()?;
        entries.extend((0..n).map(|column| if row == column { T::ONE } else { T::ZERO }));
        rows.push((row, entries));
    }
    for column in 0..n {
        let entry = |row: &(usize, Vec<T>)| row.1.get(column).copied().unwrap_or(T::ZERO);
        let at = |index: &usize| rows.get(*index).map_or(T::ZERO, entry);
        let pivot = (column..n).filter(|row| !at(row).is_zero()).max_by(|a, b| at(a).compare(at(b)).then(b.cmp(a)));
        let Some(pivot) = pivot else {
            // What is left below has no share in this column: one of the rows there follows from the others.
            let zero = |row: &&(usize, Vec<T>)| row.1.iter().take(n).all(|x| x.is_zero());
            let rest = rows.get(column..).unwrap_or_default();
            return Some(Err(rest.iter().find(zero).or(rest.last()).map_or(column, |row| row.0)));
        };
        rows.swap(column, pivot);
        let (_, pivot) = rows.get_mut(column)?;
        let scale = pivot.get(column).copied()?;
        for value in pivot.iter_mut() {
            *value = value.over(scale)?;
        }
        let pivot = pivot.clone();
        for (index, row) in rows.iter_mut().enumerate() {
            let factor = entry(row);
            if index != column && !factor.is_zero() {
                for (value, above) in row.1.iter_mut().zip(&pivot) {
                    *value = value.less(factor, *above)?;
                }
            }
        }
    }
    Some(Ok(rows.into_iter().map(|(_, row)| row.into_iter().skip(n).collect()).collect()))
}

/// A fraction in lowest terms, the denominator positive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Ratio {
    above: i128,
    below: i128,
}

impl Ratio {
    /// `above / below`; `None` where that is nothing.
    fn new(above: i128, below: i128) -> Option<Self> {
        let divisor = i128::try_from(divisor(above.unsigned_abs(), below.unsigned_abs())).ok()?;
        let sign = if below < 0 { -1 } else { 1 };
        let lowest = |value: i128| value.checked_div(divisor).and_then(|value| value.checked_mul(sign));
        Some(Self { above: lowest(above)?, below: lowest(below).filter(|below| *below > 0)? })
    }

    /// The shortest decimal that reads as `value`.
    fn decimal(value: f64) -> Option<Self> {
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e')?;
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let exponent = exponent.parse::<i32>().ok()? - i32::try_from(fraction.len()).ok()?;
        let mantissa: i128 = format!("{whole}{fraction}").parse().ok()?;
        let power = 10_i128.checked_pow(exponent.unsigned_abs())?;
        if exponent < 0 { Self::new(mantissa, power) } else { Self::new(mantissa.checked_mul(power)?, 1) }
    }

    /// The nearest double, or the one beside it: numerator and denominator are rounded to 64 more bits than it has.
    fn nearest(&self) -> f64 {
        // Whole part and remainder apart: each has few digits in most inverses, and then nothing is rounded twice.
        let (whole, rest) = (self.above / self.below, self.above % self.below);
        whole as f64 + rest as f64 / self.below as f64
    }
}

/// The greatest common divisor (Euclid), at least 1.
fn divisor(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

impl Number for Ratio {
    const ZERO: Self = Self { above: 0, below: 1 };
    const ONE: Self = Self { above: 1, below: 1 };

    fn is_zero(self) -> bool {
        self.above == 0
    }

    fn over(self, other: Self) -> Option<Self> {
        // Crosswise first, so that the products stay small.
        let (a, b) = (Self::new(self.above, other.above)?, Self::new(other.below, self.below)?);
        Self::new(a.above.checked_mul(b.above)?, a.below.checked_mul(b.below)?)
    }

    fn less(self, a: Self, b: Self) -> Option<Self> {
        let (left, right) = (Self::new(a.above, b.below)?, Self::new(b.above, a.below)?);
        let (above, below) = (left.above.checked_mul(right.above)?, left.below.checked_mul(right.below)?);
        let common = i128::try_from(divisor(self.below.unsigned_abs(), below.unsigned_abs())).ok()?;
        let (own, other) = (below.checked_div(common)?, self.below.checked_div(common)?);
        let difference = self.above.checked_mul(own)?.checked_sub(above.checked_mul(other)?)?;
        Self::new(difference, self.below.checked_mul(own)?)
    }

    /// Any pivot is as good as another where nothing is rounded: the first.
    fn compare(self, _: Self) -> Ordering {
        Ordering::Equal
    }
}

impl Number for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    fn is_zero(self) -> bool {
        self == 0.0
    }

    fn over(self, other: Self) -> Option<Self> {
        Some(self / other)
    }

    fn less(self, a: Self, b: Self) -> Option<Self> {
        Some(self - a * b)
    }

    fn compare(self, other: Self) -> Ordering {
        self.abs().total_cmp(&other.abs())
    }
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
        assert_eq!(inverse(&[vec![1e-12]]), Ok(vec![vec![1e12]]));
    }

    /// As decimals these rows are multiples of each other; as doubles they are not.
    #[test]
    fn singular_matrices_name_a_row() {
        assert_eq!(inverse(&[vec![0.1, 0.2], vec![0.3, 0.6]]), Err(1));
        assert_eq!(inverse(&[vec![0.0, 0.0], vec![0.0, 1.0]]), Err(0));
        let ones = vec![1.0; 3];
        assert_eq!(inverse(&[vec![0.0, 1.0, 0.0], ones.clone(), ones]), Err(2));
    }

    #[test]
    fn singular_matrices_of_long_factors_are_singular() {
        let row = |k: f64| (0..10).map(|column| k / (7.3 + f64::from(column))).collect::<Vec<f64>>();
        let mut matrix: Matrix =
            (0..10).map(|i| (0..10).map(|j| 1.0 / (2.7 + f64::from(i * i) + f64::from(j) * 1.3)).collect()).collect();
        for (place, k) in [(3, 1.0), (7, 1.0 / 3.0)] {
            if let Some(slot) = matrix.get_mut(place) {
                *slot = row(k);
            }
        }
        assert!(inverse(&matrix).is_err());
    }

    /// Ten joints linked by factors of 17 digits: too many digits for fractions, and still an inverse.
    #[test]
    fn long_factors_fall_back_to_doubles() {
        let entry =
            |row: usize, column: usize| if row == column { 1.0 } else { 1.0 / (7.3 + (3 * row + column) as f64) };
        let matrix: Matrix = (0..10).map(|row| (0..10).map(|column| entry(row, column)).collect()).collect();
        let found = inverse(&matrix).unwrap_or_default();
        for (i, row) in matrix.iter().enumerate() {
            for j in 0..10 {
                let product: f64 =
                    row.iter().zip(&found).map(|(a, column)| a * column.get(j).copied().unwrap_or(9.0)).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-14, "{i} {j}: {product}");
            }
        }
    }
}
