//! Three stepper motors: what a driver would be told.

/// Counts of the motors, in pulses from home.
#[derive(Debug)]
pub struct Steppers {
    counts: [i32; 3],
    most: [u32; 3],
}

impl Steppers {
    /// At home.
    pub const fn new() -> Self {
        Self { counts: [0; 3], most: [0; 3] }
    }

    /// Makes the pulses that lead to `counts`. On hardware this fills the compare registers of a timer.
    pub fn go_to(&mut self, counts: [i32; 3]) {
        for ((count, most), wanted) in self.counts.iter_mut().zip(&mut self.most).zip(counts) {
            *most = (*most).max(wanted.abs_diff(*count));
            *count = wanted;
        }
    }

    /// Where the motors stand.
    pub const fn counts(&self) -> [i32; 3] {
        self.counts
    }

    /// The most pulses of a tick: the highest rate that a driver has to make, in kHz.
    pub const fn most_in_a_tick(&self) -> [u32; 3] {
        self.most
    }
}
