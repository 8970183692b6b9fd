//! Arms in single precision, beside the same arms in double precision.

/// Calls `$with!` with every arm of this page: test name, type in single precision, type in double precision, file.
#[macro_export]
macro_rules! single_arms {
    ($with:ident) => {
        $with! {
            puma560 Puma560Single Puma560 "../specs/puma560.yaml";
            ur5 Ur5Single Ur5 "../specs/ur5.yaml";
            abb_irb2400 AbbIrb2400Single AbbIrb2400 "../specs/abb_irb2400.yaml";
            stanford StanfordSingle Stanford "../specs/stanford.yaml";
            spherical_shoulder_6r SphericalShoulder6rSingle SphericalShoulder6r "../specs/spherical_shoulder_6r.yaml";
            abb_irb120 AbbIrb120Single AbbIrb120 "../specs/abb_irb120.yaml";
        }
    };
}
