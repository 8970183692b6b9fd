//! The table of an arm evaluated over numbers that carry two derivatives by time. Such numbers are truncated power
//! series, also called dual numbers of second order. Poses come with their velocities and accelerations, exact to
//! rounding and without a Jacobian.

use std::ops::{Add, Mul};

use denhart::{Acceleration, Convention, DhFrame, DhTable, JointKind, Twist};

/// A value with its first and second derivative by time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series(pub [f64; 3]);

impl Series {
    fn constant(value: f64) -> Self {
        Self([value, 0.0, 0.0])
    }

    fn sin(self) -> Self {
        let Self([x, dx, ddx]) = self;
        Self([x.sin(), x.cos() * dx, x.cos() * ddx - x.sin() * dx * dx])
    }

    fn cos(self) -> Self {
        let Self([x, dx, ddx]) = self;
        Self([x.cos(), -x.sin() * dx, -x.sin() * ddx - x.cos() * dx * dx])
    }

    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl Add for Series {
    type Output = Self;

    fn add(self, Self([b, db, ddb]): Self) -> Self {
        let Self([a, da, dda]) = self;
        Self([a + b, da + db, dda + ddb])
    }
}

impl Mul for Series {
    type Output = Self;

    fn mul(self, Self([b, db, ddb]): Self) -> Self {
        let Self([a, da, dda]) = self;
        Self([a * b, da * b + a * db, dda * b + 2.0 * da * db + a * ddb])
    }
}

/// The upper three rows of a homogeneous matrix.
#[derive(Debug, Clone, Copy)]
pub struct Frame([[Series; 4]; 3]);

impl Frame {
    fn of(entries: [[f64; 4]; 3]) -> Self {
        Self(entries.map(|row| row.map(Series::constant)))
    }

    fn shift([x, y, z]: [Series; 3]) -> Self {
        let mut frame = Self::of([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]);
        (frame.0[0][3], frame.0[1][3], frame.0[2][3]) = (x, y, z);
        frame
    }

    /// A turn about axis 0, 1 or 2.
    fn turn(axis: usize, angle: Series) -> Self {
        let mut frame = Self::shift([Series::constant(0.0); 3]);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        (frame.0[i][i], frame.0[j][j]) = (angle.cos(), angle.cos());
        (frame.0[i][j], frame.0[j][i]) = (angle.sin().neg(), angle.sin());
        frame
    }

    fn constant(frame: &DhFrame) -> Self {
        let [roll, pitch, yaw] = frame.rpy.map(Series::constant);
        let shift = Self::shift(frame.xyz.map(Series::constant));
        shift * Self::turn(2, yaw) * Self::turn(1, pitch) * Self::turn(0, roll)
    }

    /// Velocity of the origin and of the rotation, `dR/dt R^T`.
    pub fn twist(&self) -> Twist<f64> {
        Twist { linear: self.derivative(1), angular: self.turning(1) }
    }

    /// The second derivative of the origin, and the derivative of the angular velocity: the skew part of
    /// `d2R/dt2 R^T`, as `dR/dt dR^T/dt` is symmetric.
    pub fn acceleration(&self) -> Acceleration<f64> {
        Acceleration { linear: self.derivative(2), angular: self.turning(2) }
    }

    fn derivative(&self, order: usize) -> [f64; 3] {
        self.0.map(|row| row[3].0[order])
    }

    /// Axis vector of the skew part of the product of the derivative of the rotation and its transpose.
    fn turning(&self, order: usize) -> [f64; 3] {
        let product = |i: usize, j: usize| (0..3).map(|k| self.0[i][k].0[order] * self.0[j][k].0[0]).sum::<f64>();
        [(2, 1), (0, 2), (1, 0)].map(|(i, j)| 0.5 * (product(i, j) - product(j, i)))
    }
}

impl Mul for Frame {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let rotated = |row: [Series; 4], column: usize| {
            (0..3).map(|k| row[k] * other.0[k][column]).fold(Series::constant(0.0), Series::add)
        };
        Self(self.0.map(|row| {
            let [x, y, z, p] = [0, 1, 2, 3].map(|column| rotated(row, column));
            [x, y, z, p + row[3]]
        }))
    }
}

/// The frames of the links and of the tool for joint values with two derivatives.
pub fn frames(table: &DhTable, joints: &[Series]) -> (Vec<Frame>, Frame) {
    let mut values = joints.iter();
    let mut links: Vec<Frame> = Vec::new();
    let mut frame = Frame::constant(&table.base);
    for row in table.rows {
        let [mut d, mut theta] = [row.d, row.theta].map(Series::constant);
        match row.kind {
            JointKind::Revolute => theta = theta + *values.next().expect("one value per joint"),
            JointKind::Prismatic => d = d + *values.next().expect("one value per joint"),
            JointKind::Fixed => {}
        }
        let zero = Series::constant(0.0);
        let along = Frame::turn(2, theta) * Frame::shift([zero, zero, d]);
        let twist = Frame::shift([Series::constant(row.a), zero, zero]) * Frame::turn(0, Series::constant(row.alpha));
        frame = match table.convention {
            Convention::Standard => frame * along * twist,
            Convention::Modified => frame * twist * along,
        };
        match (row.kind, links.last_mut()) {
            (JointKind::Fixed, Some(link)) => *link = frame,
            (JointKind::Fixed, None) => {}
            _ => links.push(frame),
        }
    }
    (links, frame * Frame::constant(&table.tool))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// sin^2 + cos^2 = 1, whose derivatives vanish; and the double angle.
    #[test]
    fn series_obey_the_identities() {
        let x = Series([0.7, -1.3, 2.1]);
        let one = x.sin() * x.sin() + x.cos() * x.cos();
        let double = (x + x).sin();
        let product = Series::constant(2.0) * x.sin() * x.cos();
        for k in 0..3 {
            assert!((one.0[k] - if k == 0 { 1.0 } else { 0.0 }).abs() < 1e-14, "{one:?}");
            assert!((double.0[k] - product.0[k]).abs() < 1e-14, "{double:?} {product:?}");
        }
    }

    /// A point on a circle: `w x r` and `w x (w x r) + wd x r`.
    #[test]
    fn a_turning_point() {
        let (w, wd) = (1.5, -0.4);
        let arm = Frame::shift([2.0, 0.0, 0.0].map(Series::constant));
        let frame = Frame::turn(2, Series([0.0, w, wd])) * arm;
        assert_eq!(frame.twist(), Twist { linear: [0.0, 2.0 * w, 0.0], angular: [0.0, 0.0, w] });
        let expected = Acceleration { linear: [-2.0 * w * w, 2.0 * wd, 0.0], angular: [0.0, 0.0, wd] };
        assert_eq!(frame.acceleration(), expected);
    }
}
