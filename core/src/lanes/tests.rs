//! Rows turned into vectors and back.

use super::{InstructionSet, Lanes, MOST_LANES, Work};

struct Turning;

impl Work for Turning {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, set: L::Set) {
        let number = |row: usize, column: usize| (10 * row + column) as f64;
        let rows: [[f64; 4]; MOST_LANES] =
            core::array::from_fn(|row| core::array::from_fn(|column| number(row, column)));
        let columns = L::columns(set, &rows);
        for (column, vector) in columns.iter().enumerate() {
            let mut numbers = [f64::NAN; MOST_LANES];
            vector.write(&mut numbers);
            for (row, found) in numbers.iter().enumerate().take(L::WIDTH) {
                assert_eq!(*found, number(row, column));
            }
        }
        let back = L::rows(columns);
        assert_eq!(back[..L::WIDTH], rows[..L::WIDTH]);
    }
}

#[test]
fn rows_turn_into_columns_and_back() {
    for set in InstructionSet::available().into_iter().flatten() {
        set.run(Turning);
    }
}

/// Vectors wider than the registers of a processor without AVX-512 are turned, too.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[test]
fn eight_rows_turn_by_narrower_registers() {
    use fearless_simd::{Level, f64x8};

    if let Some(set) = Level::new().as_sse2() {
        Turning.run::<f64x8<_>>(set);
    }
}
