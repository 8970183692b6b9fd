//! A call of a kernel of the runtime, with its numbers taken from registers.

use denhart::solve::{self, Cone, DefaultValue, Elbow, Measure, Roots, Sight, Turn};
use denhart_codegen::lower::kernel::{
    Aim, Align, Flip, Offset, OffsetOfTwo, Pair, PairSliding, Quadratic, Slide, SlideTo, SlideTurning, Wrist,
};
use denhart_codegen::lower::{Call, Counted, Kernel, Slot, Unit};

use crate::tape::{Places, Registers};

/// The most roots of a stage.
pub const MOST_ROOTS: usize = 4;

/// The roots of a stage: so many joints, at most so many roots.
#[derive(Debug, Clone, Copy)]
pub enum AnyRoots {
    OneOfOne(Roots<f64, 1, 1>),
    TwoOfOne(Roots<f64, 1, 2>),
    TwoOfTwo(Roots<f64, 2, 2>),
    TwoOfThree(Roots<f64, 3, 2>),
    ThreeOfTwo(Roots<f64, 2, 3>),
    FourOfTwo(Roots<f64, 2, 4>),
}

/// Does the same with the roots of every kind.
macro_rules! with_roots {
    ($roots:expr, $stage:ident => $action:expr) => {
        match $roots {
            $crate::kernel::AnyRoots::OneOfOne($stage) => $action,
            $crate::kernel::AnyRoots::TwoOfOne($stage) => $action,
            $crate::kernel::AnyRoots::TwoOfTwo($stage) => $action,
            $crate::kernel::AnyRoots::TwoOfThree($stage) => $action,
            $crate::kernel::AnyRoots::ThreeOfTwo($stage) => $action,
            $crate::kernel::AnyRoots::FourOfTwo($stage) => $action,
        }
    };
}
pub(crate) use with_roots;

/// State of a stage while it is solved: its constant ranges and its roots.
#[derive(Debug, Clone, Copy)]
pub struct Known {
    pub phase: Turn<f64>,
    pub elbow: Elbow<f64>,
    pub cone: Cone<f64>,
    pub roots: Option<AnyRoots>,
}

impl Known {
    /// Nothing yet.
    pub const NOTHING: Self = Known {
        phase: Turn::ZERO,
        elbow: Elbow { max: f64::NAN, min: f64::NAN, side: 1.0 },
        cone: Cone { max: [f64::NAN; 2], min: [f64::NAN; 2] },
        roots: None,
    };
}

/// The values of expressions.
#[derive(Clone, Copy)]
pub struct Values<'a> {
    pub places: &'a Places,
    pub registers: &'a Registers,
}

impl Values<'_> {
    /// The value of an expression.
    #[inline]
    pub fn of(self, slot: Slot) -> f64 {
        self.registers.get(self.places.of(slot))
    }

    /// The values of several.
    #[inline]
    pub fn all<const K: usize>(self, slots: &[Slot; K]) -> [f64; K] {
        slots.map(|slot| self.of(slot))
    }

    /// The values of rows.
    #[inline]
    pub fn rows<const K: usize, const R: usize>(self, rows: &[[Slot; K]; R]) -> [[f64; K]; R] {
        rows.each_ref().map(|row| self.all(row))
    }
}

/// Unit of an equation, with its typical size.
pub fn measure(unit: Unit, reach: f64) -> Measure<f64> {
    match unit {
        Unit::Length => Measure::length(reach),
        Unit::Direction => Measure::DIRECTION,
    }
}

/// Solves a stage. The roots are written where they stay: a copy of them costs as much as a small kernel.
pub fn solve(call: &Call, defaults: [DefaultValue<f64>; 2], known: &mut Known, reach: f64, values: Values) {
    let measure = measure(call.unit, reach);
    let [default, outer] = defaults;
    let v = |slot: &Slot| values.of(*slot);
    known.roots = Some(match &call.kernel {
        Kernel::Offset(Offset { a, b, d }) => AnyRoots::TwoOfOne(solve::offset(default, measure, v(a), v(b), v(d))),
        Kernel::OffsetOfTwo(OffsetOfTwo { length, direction }) => {
            let (length, direction) = (values.all(length), values.all(direction));
            AnyRoots::TwoOfOne(solve::offset_of_two(default, measure, length, direction))
        }
        Kernel::Distance(kernel) => {
            let stage = solve::distance(default, measure, v(&kernel.rho), known.elbow);
            AnyRoots::TwoOfOne(counted(stage, call.counted, known, values))
        }
        Kernel::Cone(kernel) => {
            let stage = solve::cone(default, measure, v(&kernel.d), v(&kernel.rho), known.cone);
            AnyRoots::TwoOfOne(counted(stage, call.counted, known, values))
        }
        Kernel::Align(Align { from, to }) => {
            AnyRoots::OneOfOne(solve::align(default, measure, values.all(from), values.all(to)))
        }
        Kernel::Flip(Flip { m }) => AnyRoots::TwoOfTwo(solve::flip(outer, values.all(m))),
        Kernel::Wrist(Wrist { m }) => AnyRoots::TwoOfThree(solve::wrist(default, values.rows(m))),
        Kernel::Slide(Slide { rho, across, middle }) => {
            AnyRoots::TwoOfOne(solve::slide(measure, v(rho), v(across), v(middle)))
        }
        Kernel::SlideTo(SlideTo { denominator, numerator }) => {
            AnyRoots::OneOfOne(solve::slide_to(default, measure, v(denominator), v(numerator)))
        }
        Kernel::SlideTurning(SlideTurning { direction, rows }) => {
            AnyRoots::TwoOfTwo(solve::slide_turning(defaults, measure, values.all(direction), values.rows(rows)))
        }
        Kernel::Aim(Aim { moved: [x, z], frames: [frame_x, frame_z] }) => {
            let sight = |moved, frame| Sight { moved: values.all(moved), frame: values.rows(frame) };
            AnyRoots::ThreeOfTwo(solve::aim(defaults, sight(x, frame_x), sight(z, frame_z)))
        }
        Kernel::Pair(Pair { p, q, across, .. }) => {
            let (p, q) = (values.rows(p), values.rows(q));
            AnyRoots::FourOfTwo(match across {
                None => solve::pair(defaults, measure, p, q),
                Some([[a, b], [c, d]]) => solve::pair_turning(defaults, measure, p, q, values.rows(&[*a, *b, *c, *d])),
            })
        }
        Kernel::PairSliding(PairSliding { line, scale, square, q, sliding, turning }) => {
            let across = (values.rows(sliding), values.rows(turning));
            let (line, square, q) = (values.all(line), values.all(square), values.all(q));
            AnyRoots::FourOfTwo(solve::pair_sliding(measure, line, v(scale), square, q, across))
        }
        Kernel::Quadratic(Quadratic { coefficients }) => {
            AnyRoots::TwoOfOne(solve::quadratic(measure, values.all(coefficients)))
        }
    });
}

/// The roots with the angle counted from where it is.
fn counted(stage: Roots<f64, 1, 2>, from: Counted, known: &Known, values: Values) -> Roots<f64, 1, 2> {
    match from {
        Counted::FromZero => stage,
        Counted::TurnedBack(slot) => stage.turned_back(values.of(slot) < 0.0),
        Counted::FromPhase => stage.about(known.phase),
    }
}
