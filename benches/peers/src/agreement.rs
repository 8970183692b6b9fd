//! Check that two sides solve one arm: only then their times can be compared.

use std::fmt;

use denhart::{Chain, DhTable, Pose};

/// Result of one side over a set of targets.
#[derive(Debug)]
pub struct Agreement {
    name: String,
    targets: usize,
    solutions: usize,
    missing: usize,
    worst: f64,
}

/// Solutions that reach the target within this, in m and rad, count; the libraries promise less than denhart.
const CLOSES: f64 = 1e-6;

/// Judges by the plain chain what `inverse` gives for the poses of `joints`.
pub fn judge(
    name: &str,
    table: &DhTable,
    joints: &[[f64; 6]],
    targets: &[Pose<f64>],
    inverse: impl Fn(usize) -> Vec<[f64; 6]>,
) -> Agreement {
    let chain = Chain::from(*table);
    let mut found = Agreement { name: name.to_owned(), targets: targets.len(), solutions: 0, missing: 0, worst: 0.0 };
    for (index, (q, target)) in joints.iter().zip(targets).enumerate() {
        let miss = |q: &[f64; 6]| {
            let reached = Pose::from(chain.forward(q).expect("six joints"));
            let residual = target.residual(&reached);
            residual.position.max(residual.orientation)
        };
        let solutions: Vec<[f64; 6]> = inverse(index).into_iter().filter(|q| miss(q) < CLOSES).collect();
        let same = |solution: &[f64; 6]| solution.iter().zip(q).all(|(a, b)| wrap(a - b).abs() < 1e-5);
        found.missing += usize::from(!solutions.iter().any(same));
        found.solutions += solutions.len();
        found.worst = solutions.iter().map(miss).fold(found.worst, f64::max);
    }
    found
}

impl Agreement {
    /// # Panics
    /// When the joints were not found again for 99 targets of 100: the two sides do not mean the same arm.
    #[must_use]
    pub fn asserted(self) -> Self {
        assert!(self.missing * 100 <= self.targets, "not the same arm: {self}");
        self
    }
}

fn wrap(angle: f64) -> f64 {
    use std::f64::consts::TAU;
    angle - TAU * (angle / TAU).round()
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, targets, solutions, missing, worst } = self;
        let mean = *solutions as f64 / *targets as f64;
        write!(f, "  {name:<42} {mean:>5.2} solutions a target, {missing} of {targets} joint vectors lost, ")?;
        write!(f, "largest residual {worst:.0e}")
    }
}
