//! Vectors in space and in the picture.

/// A point or vector in space, base frame, length unit of the arm.
pub type Vector = [f64; 3];

/// A point or vector in the picture, px: x to the right, y down.
pub type Flat = [f64; 2];

/// Sum of two vectors.
pub fn add<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    moved(a, b, 1.0)
}

/// Difference of two vectors.
pub fn sub<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    moved(a, b, -1.0)
}

/// The point `a + factor b`.
pub fn moved<const N: usize>(a: [f64; N], b: [f64; N], factor: f64) -> [f64; N] {
    let mut sum = a;
    for (x, y) in sum.iter_mut().zip(b) {
        *x += factor * y;
    }
    sum
}

/// The vector times a number.
pub fn scaled<const N: usize>(a: [f64; N], factor: f64) -> [f64; N] {
    a.map(|x| factor * x)
}

/// Scalar product.
pub fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Length of a vector.
pub fn length<const N: usize>(a: [f64; N]) -> f64 {
    dot(a, a).sqrt()
}

/// Distance of two points.
pub fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    length(sub(a, b))
}

/// The unit vector of a direction; `None` for a vector of length 0 or one that is not finite.
pub fn unit<const N: usize>(a: [f64; N]) -> Option<[f64; N]> {
    let length = length(a);
    (length > 0.0 && length.is_finite()).then(|| scaled(a, 1.0 / length))
}

/// Vector product.
pub fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// A unit vector at right angles to another one.
pub fn across(axis: Vector) -> Vector {
    let [x, y, z] = axis.map(f64::abs);
    let other = if z <= x.min(y) {
        [0.0, 0.0, 1.0]
    } else if x <= y {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    unit(cross(axis, other)).unwrap_or([1.0, 0.0, 0.0])
}

/// The point of a line nearest to another point.
pub fn nearest_on_line(point: Vector, direction: Vector, to: Vector) -> Vector {
    moved(point, direction, dot(sub(to, point), direction))
}

/// A quarter turn in the picture, counterclockwise as seen.
pub fn left_of([x, y]: Flat) -> Flat {
    [y, -x]
}

/// Distance of a point from a line between two points.
pub fn off_line(point: Flat, from: Flat, to: Flat) -> f64 {
    let way = sub(to, from);
    let part = dot(sub(point, from), way) / dot(way, way).max(1e-12);
    distance(point, moved(from, way, part.clamp(0.0, 1.0)))
}
