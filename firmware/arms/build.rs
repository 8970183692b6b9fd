//! Generates the arms that are measured.

use firmware_generate::{Error, Scalar, write};

fn main() -> Result<(), Error> {
    let arms = [
        ("puma560", Scalar::F32),
        ("ur5", Scalar::F32),
        ("abb_irb2400", Scalar::F32),
        ("stanford", Scalar::F32),
        ("kuka_iiwa7_r800", Scalar::F32),
        ("jupiter", Scalar::F32),
        ("salman_rrr", Scalar::F32),
        ("puma560", Scalar::F64),
    ];
    write("arms.rs", &arms)
}
