//! Levels: whether a stage has roots, as a number.

/// Level of a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::solve) enum LevelOf<T> {
    /// Nothing is known.
    Nothing,
    /// The cosine of half the difference of two angles, the roots of the stage: it has them if and only if the level is
    /// between -1 and 1. The level is known outside that range too. A joint before the stage that turns points about an
    /// axis moves the level as `a + b cos(x - phi)`.
    Cosine(T),
    /// A value that has to vanish, of an equation without a joint of its own. A joint before the stage moves it in the same
    /// way.
    Zero(T),
    /// The joint of the stage slides: what a joint before the stage does to later levels is not known.
    Slide,
}
