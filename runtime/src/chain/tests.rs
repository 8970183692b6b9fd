//! Cases worked out by hand, and the Jacobian against differences of the forward kinematics.

#![allow(clippy::unwrap_used)]

use super::*;
use crate::pose::Pose;
use core::f64::consts::{FRAC_PI_2, PI};
use std::string::ToString;
use std::vec;

const QUARTER: f64 = FRAC_PI_2;

#[track_caller]
fn assert_pose(found: Isometry3<f64>, rotation: [[f64; 3]; 3], translation: [f64; 3]) {
    let gap = Pose { rotation, translation }.residual(&found.into());
    assert!(gap.position < 1e-14 && gap.orientation < 1e-15, "{gap:?}\n{}", Pose::from(found));
}

/// Two links of 2 and 1 in a plane: x = 2 cos q1 + cos(q1 + q2). The table is the same up to where `a` stands.
#[test]
fn planar_arm_in_both_conventions() {
    let standard =
        Chain::new(Convention::Standard, &[DhRow::revolute(2.0, 0.0, 0.0, 0.0), DhRow::revolute(1.0, 0.0, 0.0, 0.0)]);
    let modified =
        Chain::new(Convention::Modified, &[DhRow::revolute(0.0, 0.0, 0.0, 0.0), DhRow::revolute(2.0, 0.0, 0.0, 0.0)])
            .with_tool(DhFrame { xyz: [1.0, 0.0, 0.0], rpy: [0.0; 3] });
    let q = [0.3_f64, 0.5];
    let (s1, c1, s12, c12) = (0.3_f64.sin(), 0.3_f64.cos(), 0.8_f64.sin(), 0.8_f64.cos());
    let rotation = [[c12, -s12, 0.0], [s12, c12, 0.0], [0.0, 0.0, 1.0]];
    for arm in [&standard, &modified] {
        assert_pose(arm.forward(&q).unwrap(), rotation, [2.0 * c1 + c12, 2.0 * s1 + s12, 0.0]);
        let jacobian = arm.jacobian(&q).unwrap();
        let expected = [[-2.0 * s1 - s12, -s12], [2.0 * c1 + c12, c12], [0.0; 2], [0.0; 2], [0.0; 2], [1.0; 2]];
        for (row, expected) in jacobian.row_iter().zip(expected) {
            assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{jacobian}");
        }
    }
    // The conventions place the link frames differently: at the end of the link, or at its joint.
    let elbow = [2.0 * c1, 2.0 * s1, 0.0];
    let in_plane = |s: f64, c: f64| [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
    assert_pose(standard.link_poses(&q).unwrap()[0], in_plane(s1, c1), elbow);
    assert_pose(modified.link_poses(&q).unwrap()[0], in_plane(s1, c1), [0.0; 3]);
    assert_pose(modified.link_poses(&q).unwrap()[1], rotation, elbow);
}

/// All four parameters of one row, read off the definitions
/// standard `[c, -s ca, s sa, a c; s, c ca, -c sa, a s; 0, sa, ca, d]` and
/// modified `[c, -s, 0, a; s ca, c ca, -sa, -d sa; s sa, c sa, ca, d ca]`.
#[test]
fn one_row_is_the_textbook_matrix() {
    let (a, alpha, d, offset, q) = (0.7, 0.4, -0.3, 1.1, -0.6_f64);
    let ((s, c), (sa, ca)) = ((offset + q).sin_cos(), f64::sin_cos(alpha));
    let row = [DhRow::revolute(a, alpha, d, offset)];
    assert_pose(
        Chain::new(Convention::Standard, &row).forward(&[q]).unwrap(),
        [[c, -s * ca, s * sa], [s, c * ca, -c * sa], [0.0, sa, ca]],
        [a * c, a * s, d],
    );
    assert_pose(
        Chain::new(Convention::Modified, &row).forward(&[q]).unwrap(),
        [[c, -s, 0.0], [s * ca, c * ca, -sa], [s * sa, c * sa, ca]],
        [a, -d * sa, d * ca],
    );
    // The same frame from a prismatic row whose constants are exchanged.
    for convention in [Convention::Standard, Convention::Modified] {
        let turned = Chain::new(convention, &row).forward(&[q]).unwrap();
        let slid = Chain::new(convention, &[DhRow::prismatic(a, alpha, 0.2, offset + q)]).forward(&[d - 0.2]).unwrap();
        let gap = Pose::from(turned).residual(&slid.into());
        assert!(gap.position < 1e-15 && gap.orientation < 1e-15, "{gap:?}");
    }
}

#[test]
fn prismatic_joint_slides_along_its_axis() {
    // Turned by a quarter about x: the second axis points along -y.
    let arm = Chain::from_rows(
        Convention::Standard,
        [(JointKind::Prismatic, [0.0, QUARTER, 1.0, 0.0]), (JointKind::Prismatic, [0.0, 0.0, 0.5, 0.0])],
    );
    assert_eq!(arm.kinds(), vec![JointKind::Prismatic; 2]);
    let pose = arm.forward(&[0.25, 2.0]).unwrap();
    assert_eq!(pose.translation.vector, Vector3::new(0.0, -2.5, 1.25));
    let jacobian = arm.jacobian(&[0.25, 2.0]).unwrap();
    assert_eq!(jacobian.column(0).as_slice(), [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(jacobian.column(1).as_slice(), [0.0, -1.0, 0.0, 0.0, 0.0, 0.0]);
}

#[test]
fn fixed_rows_belong_to_the_link_before_them() {
    let arm = Chain::new(
        Convention::Standard,
        &[
            DhRow::fixed(0.0, 0.0, 1.0, QUARTER),
            DhRow::revolute(1.0, 0.0, 0.0, 0.0),
            DhRow::fixed(0.0, 0.0, 10.0, 0.0),
            DhRow::fixed(0.0, QUARTER, 20.0, 0.0),
            DhRow::revolute(2.0, 0.0, 0.0, 0.0),
            DhRow::fixed(3.0, 0.0, 0.0, 0.0),
        ],
    )
    .with_tool(DhFrame { xyz: [100.0, 0.0, 0.0], rpy: [0.0; 3] });
    assert_eq!(arm.dof(), 2);
    let links = arm.link_poses(&[0.0, QUARTER]).unwrap();
    assert_eq!(links.len(), 2);
    // After the quarter turn of the first row, x points along the base y; the second axis lies along the base x.
    assert_pose(links[0], [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [0.0, 1.0, 31.0]);
    assert_pose(links[1], [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]], [0.0, 1.0, 36.0]);
    let tool = arm.forward(&[0.0, QUARTER]).unwrap();
    assert_pose(tool, [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]], [0.0, 1.0, 136.0]);
}

#[test]
fn base_and_tool_stand_outside_the_rows() {
    let arm = Chain::new(Convention::Standard, &[DhRow::revolute(1.0, 0.0, 0.0, 0.0)])
        .with_base(DhFrame { xyz: [0.0, 0.0, 5.0], rpy: [0.0, 0.0, QUARTER] })
        .with_tool(DhFrame { xyz: [0.0, 2.0, 0.0], rpy: [PI, 0.0, 0.0] });
    let along_y = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]];
    assert_pose(arm.forward(&[0.0]).unwrap(), along_y, [-2.0, 1.0, 5.0]);
    assert_pose(
        arm.link_poses(&[0.0]).unwrap()[0],
        [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [0.0, 1.0, 5.0],
    );
    let frame = DhFrame { xyz: [1.0, 2.0, 3.0], rpy: [0.4, -0.7, 2.0] };
    let empty = Chain::new(Convention::Modified, &[]).with_base(frame);
    let expected = Pose::from_xyz_rpy(frame.xyz, frame.rpy);
    assert_pose(empty.forward(&[]).unwrap(), expected.rotation, expected.translation);
}

#[test]
fn a_table_gives_the_same_arm_by_value_and_by_reference() {
    const ROWS: &[DhRow] = &[DhRow::revolute(1.0, QUARTER, 0.0, 0.1), DhRow::prismatic(0.0, 0.0, 2.0, 0.0)];
    let tool = DhFrame { xyz: [0.0, 0.0, 1.0], rpy: [0.0; 3] };
    let table = DhTable { convention: Convention::Modified, rows: ROWS, base: DhFrame::IDENTITY, tool };
    let arm = Chain::new(Convention::Modified, ROWS).with_tool(tool);
    assert_eq!(Chain::from(&table), arm);
    assert_eq!(Chain::from(table), arm);
    assert_eq!((arm.rows(), arm.convention(), arm.dof()), (ROWS, Convention::Modified, table.dof()));
}

#[test]
fn a_wrong_number_of_joint_values_is_an_error() {
    let arm = Chain::new(
        Convention::Standard,
        &[DhRow::revolute(1.0, 0.0, 0.0, 0.0), DhRow::fixed(1.0, 0.0, 0.0, 0.0), DhRow::revolute(1.0, 0.0, 0.0, 0.0)],
    );
    for q in [&[][..], &[0.0], &[0.0; 3]] {
        let error = ChainError::JointCount { expected: 2, found: q.len() };
        assert_eq!(arm.forward(q), Err(error));
        assert_eq!(arm.link_poses(q), Err(error));
        assert_eq!(arm.jacobian(q), Err(error));
    }
    assert_eq!(arm.forward(&[0.0; 3]).unwrap_err().to_string(), "the arm has 2 joints, but 3 joint values were given");
}

/// Every column against `(x(q + h) - x(q - h)) / 2h`. The error is h^2/6 times the third derivative (below the reach
/// of 6) plus rounding over h: with h = 1e-5 both are below 1e-9.
#[test]
fn jacobian_is_the_derivative_of_forward() {
    let rows = [
        DhRow::fixed(0.1, 0.3, 0.2, -0.4),
        DhRow::revolute(0.5, QUARTER, 0.3, 0.2),
        DhRow::prismatic(-0.4, -0.7, 0.6, 0.9),
        DhRow::fixed(0.2, 1.1, -0.3, 0.5),
        DhRow::revolute(0.8, -QUARTER, 0.1, 0.0),
        DhRow::revolute(0.0, 0.6, 0.9, -1.3),
    ];
    let frame = DhFrame { xyz: [0.2, -0.3, 0.4], rpy: [0.7, 0.8, -0.9] };
    let q = [0.4, 0.35, -1.2, 2.1];
    let h = 1e-5;
    for convention in [Convention::Standard, Convention::Modified] {
        let arm = Chain::new(convention, &rows).with_base(frame).with_tool(frame);
        let jacobian = arm.jacobian(&q).unwrap();
        assert_eq!(jacobian.ncols(), 4);
        for (joint, column) in jacobian.column_iter().enumerate() {
            let at = |step: f64| {
                let mut moved = q;
                moved[joint] += step;
                arm.forward(&moved).unwrap()
            };
            let (low, high) = (at(-h), at(h));
            let linear = (high.translation.vector - low.translation.vector) / (2.0 * h);
            let angular = (high.rotation * low.rotation.inverse()).scaled_axis() / (2.0 * h);
            assert!((linear - column.fixed_rows::<3>(0)).norm() < 1e-9, "{convention:?} joint {joint}: {linear}");
            assert!((angular - column.fixed_rows::<3>(3)).norm() < 1e-9, "{convention:?} joint {joint}: {angular}");
        }
    }
}

#[test]
fn equal_tables_are_equal_chains() {
    let arm = |a: f64| Chain::new(Convention::Standard, &[DhRow::revolute(a, 0.3, 0.0, 0.4)]);
    let frame = DhFrame { xyz: [0.2, -0.3, 0.4], rpy: [0.7, 0.8, -0.9] };
    assert_eq!(arm(f64::INFINITY), arm(f64::INFINITY));
    assert_ne!(arm(f64::NAN), arm(f64::NAN));
    assert_eq!(arm(0.5).with_base(frame).with_tool(frame), arm(0.5).with_tool(frame).with_base(frame));
    assert_ne!(arm(0.5), arm(0.5).with_tool(frame));
    let shown = std::format!("{:?}", arm(0.5));
    assert!(shown.starts_with("Chain { convention: Standard, rows: [") && !shown.contains("constants"), "{shown}");
}
