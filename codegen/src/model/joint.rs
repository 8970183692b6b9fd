//! The moving joints of an arm, and sums of their values.

/// Kind of a moving joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointKind {
    /// `q` is added to `theta`, rad.
    Revolute,
    /// `q` is added to `d`, length.
    Prismatic,
}

/// A moving joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// The name in the file, or `q1`, `q2`, ... Unique among the joints.
    pub name: String,
    /// The index of its row in the table.
    pub row: usize,
    /// Revolute or prismatic.
    pub kind: JointKind,
    /// Lowest and highest value, rad or length; infinite on a side without an end. `None` without limits.
    pub limits: Option<[f64; 2]>,
    /// The greatest velocity, rad/s or length/s; infinite without one.
    pub max_velocity: f64,
    /// The greatest acceleration, rad/s^2 or length/s^2; infinite without one.
    pub max_acceleration: f64,
}

/// A weighted sum of joint values and a constant as text, `q2 - 0.5 q3 + 90 deg`; `number` writes a factor.
pub fn joint_sum(factors: &[f64], constant: Option<String>, number: impl Fn(f64) -> String) -> String {
    let terms = factors.iter().zip(1..).filter(|(factor, _)| **factor != 0.0).map(|(factor, joint)| {
        let size = if factor.abs() == 1.0 { String::new() } else { number(factor.abs()) + " " };
        (*factor < 0.0, format!("{size}q{joint}"))
    });
    let constant =
        constant.map(|text| text.strip_prefix('-').map_or((false, text.clone()), |size| (true, size.into())));
    terms.chain(constant).fold(String::new(), |sum, (negative, term)| match (sum.is_empty(), negative) {
        (true, false) => term,
        (true, true) => format!("-{term}"),
        (false, false) => format!("{sum} + {term}"),
        (false, true) => format!("{sum} - {term}"),
    })
}
