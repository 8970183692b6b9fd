//! Draws the table of an arm whose axes have a structure.

use clap::ValueEnum;
use denhart::{Convention, JointKind};

use super::structure::{self, Skeleton};
use super::table::{Deltas, Frame, Joint, Link, Table};
use crate::random::Random;

/// Which arms are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Three axes meet or are parallel in most of them.
    Common,
    /// The inverse holds a joint in most of them.
    HeldJoint,
    /// The arms of both other kinds in turn, with a calibration that moves their links by 1e-8 to 1e-3.
    Measured,
}

impl Kind {
    /// The beginning of the names of its arms. Those of a name are asked at the same joint vectors.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Common => "sweep",
            Kind::HeldJoint => "held_joint",
            Kind::Measured => "measured",
        }
    }
}

/// How the twists of an arm are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Twists {
    /// Multiples of 90 degrees.
    Square,
    /// Multiples of 15 degrees.
    Fifteen,
    /// Any, to a tenth of a degree.
    Odd,
}

/// Lengths and angles by the style of an arm.
#[derive(Debug)]
pub struct Style<'r> {
    pub random: &'r mut Random,
    twists: Twists,
    /// The size of its lengths.
    scale: f64,
    /// True if lengths of one arm are of many sizes.
    wide: bool,
    /// One length in so many is zero.
    zeros: usize,
}

impl Style<'_> {
    /// A length, often zero.
    pub fn length(&mut self) -> f64 {
        if self.random.below(self.zeros) == 0 { 0.0 } else { self.link() }
    }

    /// A length that is not zero.
    pub fn link(&mut self) -> f64 {
        let sign = if self.random.below(3) == 0 { -1.0 } else { 1.0 };
        let size = match self.wide {
            true => 10.0_f64.powf(self.random.uniform(-3.0, 0.0)),
            false => self.random.uniform(0.05, 1.0),
        };
        sign * digits(size * self.scale)
    }

    /// An angle between axes, or about one, degrees in (-180, 180].
    pub fn angle(&mut self) -> f64 {
        match self.twists {
            Twists::Square => self.random.pick(&[0.0, 90.0, -90.0, 180.0]),
            Twists::Fifteen => 15.0 * (self.random.below(24) as f64 - 11.0),
            Twists::Odd => (self.random.uniform(-180.0, 180.0) * 10.0).round() / 10.0,
        }
    }

    /// An angle between axes that are not parallel.
    pub fn twist(&mut self) -> f64 {
        loop {
            let angle = match self.twists {
                Twists::Square => self.random.pick(&[90.0, -90.0]),
                _ => self.angle(),
            };
            // Axes parallel but for a degree are another arm, drawn by `nearly`.
            if (1.0..179.0).contains(&angle.abs()) {
                return angle;
            }
        }
    }
}

/// Four digits, as in a data sheet.
fn digits(length: f64) -> f64 {
    if length == 0.0 {
        return 0.0;
    }
    let unit = 10.0_f64.powi(length.abs().log10().floor() as i32 - 3);
    let rounded = (length / unit).round() * unit;
    // The product has rounding of its own; the text of five digits has none.
    format!("{rounded:.4e}").parse().unwrap_or(rounded)
}

/// The arm of a kind, a seed and an index: the name of its structure and its table.
pub fn draw(kind: Kind, seed: u64, index: usize) -> (&'static str, Table) {
    let mut random = Random::named(&format!("{} {seed} {index}", kind.name()));
    if kind == Kind::Measured {
        let drawing = if index.is_multiple_of(2) { Kind::Common } else { Kind::HeldJoint };
        let (structure, table) = draw(drawing, seed, index);
        return (structure, measured(table, &mut random));
    }
    let twists = random.pick(&[Twists::Square, Twists::Square, Twists::Fifteen, Twists::Odd, Twists::Odd]);
    let scale = 10.0_f64.powf(random.uniform(-3.0, 3.0));
    let (wide, zeros) = (random.below(8) == 0, random.pick(&[2, 3, 6]));
    let mut style = Style { random: &mut random, twists, scale, wide, zeros };
    let (name, Skeleton { kinds, links, axes, inverse }) = match kind {
        Kind::HeldJoint => structure::draw_holding(&mut style),
        _ => structure::draw(&mut style, index),
    };
    let joints = kinds.iter().zip(axes).map(|(kind, (d, theta))| Joint { kind: *kind, d, theta, limits: None });
    let mut table = Table {
        convention: style.random.pick(&[Convention::Standard, Convention::Modified]),
        joints: joints.collect(),
        links,
        base: None,
        tool: None,
        unit: style.random.pick(&["m", "m", "cm", "mm", "in"]),
        radians: style.random.below(6) == 0,
        inverse,
        calibration: Vec::new(),
    };
    if table.convention == Convention::Standard {
        // The last row of this convention has a link of its own.
        if style.random.below(4) == 0
            && !name.starts_with("planar")
            && let Some(last) = table.links.last_mut()
        {
            *last = Link { a: style.length(), alpha: style.angle() };
        }
    } else if style.random.below(4) == 0
        && !name.starts_with("planar")
        && let Some(first) = table.links.first_mut()
    {
        *first = Link { a: style.length(), alpha: style.angle() };
    }
    if style.random.below(3) == 0 {
        limits(&mut table, &mut style);
    }
    if style.random.below(6) == 0 {
        split(&mut table, &mut style);
    }
    if !name.starts_with("planar") {
        table.base = (style.random.below(4) == 0).then(|| frame(&mut style));
        table.tool = (style.random.below(3) == 0).then(|| frame(&mut style));
    }
    (name, table)
}

/// An arm whose links are off by up to 1e-8 to 1e-3, in rad and in the sum of its lengths.
fn measured(mut table: Table, random: &mut Random) -> Table {
    let reach: f64 = table.joints.iter().map(|joint| joint.d.abs()).chain(table.links.iter().map(|l| l.a.abs())).sum();
    let most = 10.0_f64.powf(random.uniform(-8.0, -3.0));
    let mut deltas = |unit: f64| most * unit * random.uniform(-1.0, 1.0);
    table.calibration = (0..table.moving())
        .map(|_| Deltas { a: deltas(reach), alpha: deltas(1.0), d: deltas(reach), theta: deltas(1.0) })
        .collect();
    table
}

fn frame(style: &mut Style) -> Frame {
    let xyz = std::array::from_fn(|_| style.length());
    let turned = style.random.below(2) == 0;
    [xyz, std::array::from_fn(|_| if turned { style.angle() } else { 0.0 })]
}

/// Limits of most joints: around zero, on one side of it, or more than a turn.
fn limits(table: &mut Table, style: &mut Style) {
    for joint in &mut table.joints {
        if style.random.below(4) == 0 {
            continue;
        }
        joint.limits = match joint.kind {
            JointKind::Revolute => {
                let tens = |random: &mut Random, low, high| (random.uniform(low, high) / 10.0).round() * 10.0;
                match style.random.below(4) {
                    0 => Some([-360.0, 360.0]),
                    1 => {
                        let low = tens(style.random, -190.0, 150.0);
                        Some([low, low + tens(style.random, 30.0, 200.0)])
                    }
                    _ => Some([tens(style.random, -180.0, -20.0), tens(style.random, 20.0, 180.0)]),
                }
            }
            JointKind::Prismatic => {
                let travel = style.link().abs();
                Some(if style.random.below(2) == 0 { [0.0, travel] } else { [-travel, travel] })
            }
            JointKind::Fixed => None,
        };
    }
}

/// Part of a joint's offset in a constant row: the axes stay where they are.
fn split(table: &mut Table, style: &mut Style) {
    let at = style.random.below(table.joints.len());
    let (d, theta) = (style.link(), style.angle());
    let constant = Joint { kind: JointKind::Fixed, d, theta, limits: None };
    // The constant row turns about the joint's own axis: before it where links come after, after it where they come
    // before.
    let (row, link) = match table.convention {
        Convention::Standard => (at, at + 1),
        Convention::Modified => (at + 1, at + 1),
    };
    table.joints.insert(row, constant);
    table.links.insert(link, Link::default());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn drawn_again_it_is_the_same() {
        for kind in [Kind::Common, Kind::HeldJoint, Kind::Measured] {
            let texts = |seed| -> Vec<String> { (0..200).map(|index| draw(kind, seed, index).1.yaml("arm")).collect() };
            assert_eq!(texts(1), texts(1));
            assert_ne!(texts(1), texts(2));
        }
        assert_eq!(digits(0.123_456), 0.1235);
        assert_eq!(digits(-98_765.4), -98_770.0);
    }

    #[test]
    fn a_constant_row_leaves_the_axes_where_they_are() {
        let mut random = Random::new(5);
        for index in 0..300 {
            let (_, table) = draw(Kind::Common, 7, index);
            if table.joints.iter().any(|joint| joint.kind == JointKind::Fixed) {
                continue;
            }
            let mut style = Style { random: &mut random, twists: Twists::Odd, scale: 1.0, wide: false, zeros: 3 };
            let mut more = table.clone();
            split(&mut more, &mut style);
            let axes = |table: &Table| {
                let chain = table.chain();
                chain.jacobian(&vec![0.0; table.moving()]).unwrap()
            };
            // Up to a rigid motion about the split joint the axes before and after keep their relation: the Gram matrix
            // of neighbors is the same.
            let neighbors = |table: &Table| -> Vec<f64> {
                let jacobian = axes(table);
                let axis = |j: usize| jacobian.fixed_view::<3, 1>(3, j).into_owned();
                (1..table.moving()).map(|j| axis(j).dot(&axis(j - 1))).collect()
            };
            let (before, after) = (neighbors(&table), neighbors(&more));
            assert!(before.iter().zip(&after).all(|(x, y)| (x - y).abs() < 1e-9), "{table:?} {more:?}");
        }
    }
}
