use crate::{Acceleration, Jacobian, Pose, Scalar, Twist, math};

/// A joint turns about z, and an arm slides along the link's x axis. At the end are a joint that turns about its z axis
/// and a link of length 0.3. Everything is in closed form.
fn polar<T: Scalar>(q: &[T; 3]) -> (Pose<T>, [Pose<T>; 3], Jacobian<T, 3>) {
    let [q1, r, q3] = *q;
    let l = T::from_f64(0.3);
    let ((s1, c1), (s13, c13)) = (math::sin_cos(q1), math::sin_cos(q1 + q3));
    let (o, i) = (T::ZERO, T::ONE);
    let turned = |s: T, c: T, x: T, y: T| Pose { rotation: [[c, -s, o], [s, c, o], [o, o, i]], translation: [x, y, o] };
    let (x, y) = (r * c1 + l * c13, r * s1 + l * s13);
    let tool = turned(s13, c13, x, y);
    let links = [turned(s1, c1, o, o), turned(s1, c1, r * c1, r * s1), turned(s13, c13, r * c1, r * s1)];
    let rows = [[-y, c1, -l * s13], [x, s1, l * c13], [o; 3], [o; 3], [o; 3], [i, o, i]];
    (tool, links, Jacobian { rows })
}

const Q: [f64; 3] = [0.4, 0.7, -1.1];
const QD: [f64; 3] = [0.9, -0.6, 1.3];
const QDD: [f64; 3] = [-0.5, 0.8, 0.7];

/// Velocity and acceleration of a point at the end of the radii `(length, rate, second rate)` at angles likewise.
fn point(radii: &[[[f64; 3]; 2]]) -> ([f64; 2], [f64; 2]) {
    let (mut velocity, mut acceleration) = ([0.0; 2], [0.0; 2]);
    for [[r, rd, rdd], [angle, w, wd]] in radii {
        let (s, c) = angle.sin_cos();
        for (k, [radial, tangential]) in [[c, -s], [s, c]].into_iter().enumerate() {
            velocity[k] += rd * radial + r * w * tangential;
            acceleration[k] += (rdd - r * w * w) * radial + (r * wd + 2.0 * rd * w) * tangential;
        }
    }
    (velocity, acceleration)
}

fn expected() -> [(Twist<f64>, Acceleration<f64>); 4] {
    let radius = [Q[1], QD[1], QDD[1]];
    let first = [Q[0], QD[0], QDD[0]];
    let both = [Q[0] + Q[2], QD[0] + QD[2], QDD[0] + QDD[2]];
    let link = |radii: &[[[f64; 3]; 2]], [_, w, wd]: [f64; 3]| {
        let ([x, y], [ax, ay]) = point(radii);
        let twist = Twist { linear: [x, y, 0.0], angular: [0.0, 0.0, w] };
        (twist, Acceleration { linear: [ax, ay, 0.0], angular: [0.0, 0.0, wd] })
    };
    let slide = [radius, first];
    [link(&[], first), link(&[slide], first), link(&[slide], both), link(&[slide, [[0.3, 0.0, 0.0], both]], both)]
}

/// Some twenty operations on values below 3.
const ROUNDING: f64 = 1e-14;

fn close<T: Scalar>(a: &[T], b: &[f64], tolerance: f64) {
    for (x, y) in a.iter().zip(b) {
        assert!((x.to_f64() - y).abs() < tolerance, "{a:?}\n{b:?}");
    }
}

fn check<T: Scalar>(tolerance: f64) {
    let (q, qd, qdd) = (Q.map(T::from_f64), QD.map(T::from_f64), QDD.map(T::from_f64));
    let (tool, links, jacobian) = polar(&q);
    let [.., (twist, acceleration)] = expected();
    close(&jacobian.velocity(&qd).to_array(), &twist.to_array(), tolerance);
    close(&jacobian.acceleration(&qd, &qdd).to_array(), &acceleration.to_array(), tolerance);
    let by_derivative = jacobian.derivative(&qd).mul(&qd);
    let without = jacobian.acceleration(&qd, &[T::ZERO; 3]).to_array().map(T::to_f64);
    close(&by_derivative, &without, tolerance);
    let twists = jacobian.link_velocities(&tool, &links, &qd);
    let accelerations = jacobian.link_accelerations(&tool, &links, &qd, &qdd);
    for ((twist, acceleration), (expected, expected_rate)) in twists.iter().zip(&accelerations).zip(expected()) {
        close(&twist.to_array(), &expected.to_array(), tolerance);
        close(&acceleration.to_array(), &expected_rate.to_array(), tolerance);
    }
}

#[test]
fn an_arm_of_three_joints_in_closed_form() {
    check::<f64>(ROUNDING);
    check::<f32>(ROUNDING * f64::from(f32::EPSILON) / f64::EPSILON);
}

/// `d J / d t` by a central difference of the closed form. The difference is off by `h^2 / 6` of third derivatives
/// below 30, and by a rounding over `h`.
#[test]
fn the_derivative_is_that_of_the_jacobian() {
    let h = 1e-5;
    let at = |h: f64| polar(&[0, 1, 2].map(|k| Q[k] + h * QD[k])).2;
    let (before, after) = (at(-h), at(h));
    let derivative = polar(&Q).2.derivative(&QD);
    for (row, (a, b)) in derivative.rows.iter().zip(after.rows.iter().zip(&before.rows)) {
        let difference: std::vec::Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - b) / (2.0 * h)).collect();
        close(row, &difference, 1e-9);
    }
}

#[test]
fn in_the_frame_of_the_tool() {
    let (tool, _, jacobian) = polar(&Q);
    let turned = jacobian.in_frame(&tool.rotation);
    let twist = jacobian.velocity(&QD);
    let [r0, r1, r2] = tool.rotation;
    let inward = |[x, y, z]: [f64; 3]| [0, 1, 2].map(|k| r0[k] * x + r1[k] * y + r2[k] * z);
    close(&turned.velocity(&QD).linear, &inward(twist.linear), ROUNDING);
    close(&turned.velocity(&QD).angular, &inward(twist.angular), ROUNDING);
    // At the joint's end of the last link the tool moves across it alone.
    let [_, _, third] = [0, 1, 2].map(|k| turned.column(k).unwrap_or_default());
    close(&third, &[0.0, 0.3, 0.0, 0.0, 0.0, 1.0], ROUNDING);
}

#[test]
fn not_finite_in_not_finite_out() {
    let (_, _, jacobian) = polar(&Q);
    assert!(!jacobian.velocity(&[f64::NAN, 0.0, 0.0]).is_finite());
    assert!(!jacobian.acceleration(&QD, &[0.0, f64::INFINITY, 0.0]).is_finite());
}
