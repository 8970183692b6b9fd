//! The derive in surroundings that are hard on generated code: no prelude, names taken, the crate elsewhere, lints
//! denied.
#![deny(missing_docs, warnings, clippy::all, clippy::pedantic)]

/// No prelude, and names of the language and of `denhart` taken by other things. (Not those of the primitive types:
/// generated code says `f64`, as a reader expects.)
///
/// All arms here have an inverse: `#[diagnostic::on_unimplemented]`, which says why one has none, is a tool attribute,
/// and the names of the tools are part of the prelude.
#[no_implicit_prelude]
#[allow(non_camel_case_types, dead_code, unused_macros, missing_docs, clippy::pedantic)]
pub mod taken {
    pub struct Pose;
    pub struct Jacobian;
    pub struct Solutions;
    pub struct Solution;
    pub struct Status;
    pub struct Flags;
    pub struct Option;
    pub struct Result;
    pub struct Some;
    pub struct None;
    pub struct Ok;
    pub struct Err;
    pub trait Sized {}
    pub trait Copy {}
    pub trait Deref {}
    pub mod core {}
    pub mod std {}
    pub mod denhart {}
    pub mod math {}
    pub const N: () = ();
    pub const PI: () = ();
    pub fn sin_cos() {}
    pub fn sqrt() {}
    macro_rules! concat {
        () => {};
    }
    macro_rules! env {
        () => {};
    }
    macro_rules! include_bytes {
        () => {};
    }

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/ur5.yaml")]
    pub struct Ur5;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/stanford.yaml", scalar = "f32")]
    pub struct Stanford;

    /// A type parameter of generated code would hide a type of its name.
    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/puma560.yaml")]
    pub struct S;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/staubli_tx40.yaml")]
    pub struct Tx40;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/fanuc_lrmate200id.yaml")]
    pub struct Linked;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/salman_rrr.yaml")]
    pub struct Counting;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/jupiter.yaml", scalar = "f32")]
    pub struct PointAngle;

    #[derive(::denhart::Arm)]
    #[arm(spec = "arms/position_axis/scorbot_x.yaml")]
    pub struct PointAxis;

    #[derive(::denhart::Arm)]
    #[arm(spec = "../specs/planar3r.yaml")]
    pub struct PlanarPose;

    /// Fields with the names of locals and arguments of generated code.
    #[derive(::denhart::Arm)]
    #[arm(yaml = "
        name: reacher
        convention: standard
        units: {length: m, angle: deg}
        parameters: {q: 2, arm: 0.5, length: 0.25}
        inverse: {task: position}
        joints:
          - {type: revolute, a: 0, alpha: 90, d: 2*q, theta: 0}
          - {type: revolute, a: arm, alpha: 0, d: 0, theta: 0}
          - {type: revolute, a: -length, alpha: 0, d: 0, theta: 0}
    ")]
    pub struct Named {
        pub q: f64,
        pub arm: f64,
        pub length: f64,
    }
}

/// Arms with the names of what their code uses.
#[allow(non_camel_case_types, missing_docs)]
pub mod namesakes {
    #[derive(denhart::Arm)]
    #[arm(spec = "../specs/ur5.yaml")]
    pub struct Pose;

    #[derive(denhart::Arm)]
    #[arm(spec = "../specs/ur5.yaml")]
    pub struct r#Turn;

    #[derive(denhart::Arm)]
    #[arm(spec = "../specs/ur5.yaml")]
    pub struct Some;

    #[derive(denhart::Arm)]
    #[arm(spec = "../specs/ur5.yaml")]
    pub struct math;
}

/// `denhart` under another name and deeper in.
mod vendor {
    pub mod kinematics {
        pub use denhart::*;
    }
}

/// An arm whose code finds `denhart` by the path it is given.
#[derive(denhart::Arm)]
#[arm(spec = "../specs/abb_irb2400.yaml", crate = "crate::vendor::kinematics")]
pub struct Elsewhere;

/// An arm from its text, with a raw identifier.
#[derive(denhart::Arm)]
#[arm(
    scalar = "f32",
    yaml = "
        name: lever
        convention: standard
        units: {length: mm, angle: deg}
        joints:
          - {type: revolute, a: 500, alpha: 0, d: 0, theta: 0}
    "
)]
pub struct r#Lever;

#[test]
fn arms_work_in_hard_surroundings() {
    let pose: denhart::Pose<f64> = taken::Ur5.forward(&[0.0; 6]);
    assert!(pose.translation.iter().all(|x| x.is_finite()));
    assert_eq!(taken::Ur5::DOF, 6);
    assert_eq!(taken::Stanford::DOF, 6);
    assert_eq!(taken::Tx40.jacobian(&[0.0; 6]).rows.len(), 6);
    assert_eq!(Elsewhere::DOF, 6);
    let q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
    let pose = taken::Ur5.forward(&q);
    assert_eq!([namesakes::Pose.forward(&q), namesakes::Turn.forward(&q), namesakes::math.forward(&q)], [pose; 3]);
    assert_eq!(namesakes::Some.inverse(&pose).len(), namesakes::Pose.inverse(&pose).len());
    let named = taken::Named { q: 1.0, arm: 0.5, length: -1.0 };
    let tip = named.forward(&[0.0; 3]).translation;
    assert_eq!(tip.map(f64::to_bits), [1.5, 0.0, 2.0].map(f64::to_bits));
    assert!(named.inverse(&tip).iter().any(denhart::Solution::is_exact));
    assert_eq!(taken::Ur5.target_at(&q), pose);
    let tip = taken::PointAngle.target_at(&[0.1, 0.2, 0.3, 0.4]);
    assert!(taken::PointAngle.inverse(&tip).iter().any(denhart::Solution::is_exact));
    let tip = taken::PointAxis.target_at(&[0.1, 0.2, 0.3, 0.4, 0.5]);
    assert!(taken::PointAxis.inverse(&tip).iter().any(denhart::Solution::is_exact));
    let tip = taken::PlanarPose.target_at(&[0.1, 0.2, 0.3]);
    assert!(taken::PlanarPose.inverse(&tip).iter().any(denhart::Solution::is_exact));
    let tip: denhart::Pose<f32> = Lever.forward(&[0.0]);
    assert_eq!(tip.translation.map(f32::to_bits), [500.0, 0.0, 0.0].map(f32::to_bits));
}

/// Two arms in one function body, each in a scope of its own.
#[test]
fn an_arm_may_be_local() {
    #[derive(denhart::Arm)]
    #[arm(spec = "../specs/puma560.yaml")]
    struct Local;
    let target = Local.forward(&[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
    let inner = {
        #[derive(denhart::Arm)]
        #[arm(spec = "../specs/puma560.yaml")]
        struct Local;
        Local.forward(&[0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    };
    assert_eq!(target, inner);
    assert!(Local.inverse(&target).iter().any(|solution| solution.flags.contains(denhart::Flags::EXACT)));
}
