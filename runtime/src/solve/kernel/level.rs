//! Levels: whether a stage has roots, as a number.

use super::tolerances::Tolerances;

/// A number that says whether a stage has roots: it has them if and only if `low <= value <= high`.
///
/// A stage with two roots a half difference h apart solves `cos(h) = value` between -1 and 1. A stage that a slide
/// solves needs a square that is not negative. An equation without a joint of its own needs the value 0. The value is
/// known outside its range too. A joint that turns points about an axis moves the value as `a + b cos(x - phi)`. With a
/// slide between that follows, the value moves as a polynomial of degree 2 over the square of the slide's coefficient,
/// the pole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) struct Level<T> {
    pub(in crate::solve) value: T,
    pub(in crate::solve) low: T,
    pub(in crate::solve) high: T,
    pub(in crate::solve) pole: T,
}

impl<T: Tolerances> Level<T> {
    /// Nothing is known.
    pub(in crate::solve) const NONE: Self = Self { value: T::NAN, low: T::NAN, high: T::NAN, pole: T::ONE };

    /// Returns true if the value is known.
    pub(in crate::solve) fn is_known(&self) -> bool {
        self.value.is_finite()
    }

    /// Returns true if only the pole, the coefficient of a prismatic joint, is known.
    pub(in crate::solve) fn is_slide(&self) -> bool {
        self.low.is_finite() && !self.is_known()
    }

    /// Returns true if the level is that of an equation without a joint of its own, and the equation holds.
    pub(in crate::solve) fn is_met(&self) -> bool {
        self.low == self.high && self.value.abs() <= T::COINCIDENT
    }
}

/// Level of a stage as its kernel leaves it: one number and its kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) enum LevelOf<T> {
    /// Nothing is known.
    Nothing,
    /// The cosine of half the difference of two angles.
    Cosine(T),
    /// A square, which must not be negative.
    Square(T),
    /// A value that has to vanish.
    Zero(T),
    /// The coefficient of a prismatic joint alone.
    Slide(T),
}

impl<T: Tolerances> From<LevelOf<T>> for Level<T> {
    fn from(level: LevelOf<T>) -> Self {
        match level {
            LevelOf::Nothing => Self::NONE,
            LevelOf::Cosine(value) => Self { value, low: -T::ONE, high: T::ONE, ..Self::NONE },
            LevelOf::Square(value) => Self { value, low: T::ZERO, high: T::MAX, ..Self::NONE },
            LevelOf::Zero(value) => Self { value, low: T::ZERO, high: T::ZERO, ..Self::NONE },
            LevelOf::Slide(pole) => Self { pole, low: T::ZERO, ..Self::NONE },
        }
    }
}

/// The level of a stage behind a free joint, and whether a slide stands between, whose coefficient is part of the pole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) struct Behind<T> {
    pub(in crate::solve) level: Level<T>,
    pub(in crate::solve) slides: bool,
}

impl<T: Tolerances> Behind<T> {
    /// No stage.
    pub(in crate::solve) const NONE: Self = Self { level: Level::NONE, slides: false };
}
