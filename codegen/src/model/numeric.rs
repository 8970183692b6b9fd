//! Numeric rigid transforms: what the structure of an arm is decided on.

use super::angle::Angle;
use super::arm::Frame;
use super::chain::Elementary;
use crate::spec::Length;

type V = [f64; 3];

/// `v -> r v + p`, `r[row][column]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    /// Rotation.
    pub r: [V; 3],
    /// Translation.
    pub p: V,
}

impl Transform {
    /// Changes nothing.
    pub const IDENTITY: Transform = Transform { r: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], p: [0.0; 3] };

    /// A turn about z.
    pub fn rotate_z(sin: f64, cos: f64) -> Transform {
        Transform { r: [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]], ..Transform::IDENTITY }
    }

    /// A turn about x.
    pub fn rotate_x(sin: f64, cos: f64) -> Transform {
        Transform { r: [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]], ..Transform::IDENTITY }
    }

    /// A turn about y.
    pub fn rotate_y(sin: f64, cos: f64) -> Transform {
        Transform { r: [[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]], ..Transform::IDENTITY }
    }

    /// A translation.
    pub fn shift(p: V) -> Transform {
        Transform { p, ..Transform::IDENTITY }
    }

    /// A constant frame, parameters at their defaults.
    pub fn frame(frame: &Frame) -> Transform {
        Transform::of_origin(frame.xyz.each_ref().map(Length::default_value), frame.rpy)
    }

    /// `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`
    pub fn of_origin(xyz: V, [roll, pitch, yaw]: [Angle; 3]) -> Transform {
        Transform::shift(xyz)
            .then(&Transform::rotate_z(yaw.sin(), yaw.cos()))
            .then(&Transform::rotate_y(pitch.sin(), pitch.cos()))
            .then(&Transform::rotate_x(roll.sin(), roll.cos()))
    }

    /// A constant factor of the chain, parameters at their defaults; a joint at zero (with its offset).
    pub fn of(step: &Elementary) -> Transform {
        match step {
            Elementary::RotateX { angle, .. } => Transform::rotate_x(angle.sin(), angle.cos()),
            Elementary::RotateZ { angle, .. } => Transform::rotate_z(angle.sin(), angle.cos()),
            Elementary::Revolute { offset, .. } => Transform::rotate_z(offset.sin(), offset.cos()),
            Elementary::ShiftX { length, .. } => Transform::shift([length.default_value(), 0.0, 0.0]),
            Elementary::ShiftZ { length, .. } => Transform::shift([0.0, 0.0, length.default_value()]),
            Elementary::Prismatic { .. } => Transform::IDENTITY,
            Elementary::Frame { frame, .. } => Transform::frame(frame),
        }
    }

    /// `self` after `inner`.
    pub fn then(&self, inner: &Transform) -> Transform {
        Transform::of_columns([0, 1, 2].map(|j| self.turn(inner.axis(j))), self.point(inner.p))
    }

    /// The transform whose rotation has these columns.
    pub fn of_columns(columns: [V; 3], p: V) -> Transform {
        Transform { r: [0, 1, 2].map(|i| columns.map(|column| at(column, i))), p }
    }

    /// The transform that undoes it.
    pub fn inverse(&self) -> Transform {
        Transform { r: [0, 1, 2].map(|j| self.axis(j)), p: self.turned_back(self.p).map(|x| -x) }
    }

    /// Column `j` of the rotation.
    pub fn axis(&self, j: usize) -> V {
        self.r.map(|row| at(row, j))
    }

    /// `r v`
    pub fn turn(&self, v: V) -> V {
        self.r.map(|row| dot(row, v))
    }

    /// `r^T v`
    pub fn turned_back(&self, v: V) -> V {
        [0, 1, 2].map(|j| dot(self.axis(j), v))
    }

    /// `r^T (v - p)`
    pub fn seen(&self, v: V) -> V {
        self.turned_back(sub(v, self.p))
    }

    /// `r v + p`
    pub fn point(&self, v: V) -> V {
        scaled(self.turn(v), self.p, 1.0)
    }
}

fn at(v: V, i: usize) -> f64 {
    v.get(i).copied().unwrap_or(0.0)
}

/// `a . b`
pub fn dot([a, b, c]: V, [d, e, f]: V) -> f64 {
    a * d + b * e + c * f
}

/// `a x b`
pub fn cross([a, b, c]: V, [d, e, f]: V) -> V {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

/// `a - b`
pub fn sub([a, b, c]: V, [d, e, f]: V) -> V {
    [a - d, b - e, c - f]
}

/// `a + k b`
pub fn scaled([a, b, c]: V, [d, e, f]: V, k: f64) -> V {
    [a + k * d, b + k * e, c + k * f]
}

/// Euclidean norm.
pub fn length(v: V) -> f64 {
    dot(v, v).sqrt()
}

/// Distance of two points.
pub fn distance(a: V, b: V) -> f64 {
    length(sub(a, b))
}
