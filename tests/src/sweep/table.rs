//! A table that is drawn: the numbers that are written into an arm file, and the chain that judges what is read from it.

use std::fmt::{self, Display, Write};

use denhart::{Chain, Convention, DhFrame, DhRow, JointKind};

/// A joint before a convention is chosen: what turns and shifts about its axis.
#[derive(Debug, Clone, Copy)]
pub struct Joint {
    pub kind: JointKind,
    /// Offset along the axis, length unit.
    pub d: f64,
    /// Angle about the axis, degrees.
    pub theta: f64,
    /// Lower and upper limit, degrees or length unit.
    pub limits: Option<[f64; 2]>,
}

/// The constant transform between two axes: along and about their common normal.
#[derive(Debug, Clone, Copy, Default)]
pub struct Link {
    /// Distance of the axes, length unit.
    pub a: f64,
    /// Angle between the axes, degrees.
    pub alpha: f64,
}

/// Deltas of a measured row: lengths in the length unit, angles in rad.
#[derive(Debug, Clone, Copy)]
pub struct Deltas {
    pub a: f64,
    pub alpha: f64,
    pub d: f64,
    pub theta: f64,
}

/// A constant frame: position in the length unit; roll, pitch, yaw in degrees.
pub type Frame = [[f64; 3]; 2];

/// A drawn arm.
#[derive(Debug, Clone)]
pub struct Table {
    pub convention: Convention,
    /// Joints and constant rows in order.
    pub joints: Vec<Joint>,
    /// One more than joints. The first counts in the modified convention alone, the last in the standard one alone.
    pub links: Vec<Link>,
    pub base: Option<Frame>,
    pub tool: Option<Frame>,
    /// The symbol of the length unit.
    pub unit: &'static str,
    /// True if angles are written in radians.
    pub radians: bool,
    /// The lines after the head, such as `inverse: {task: position}`.
    pub inverse: Option<String>,
    /// Deltas of each moving joint's row; empty for an arm that was not measured.
    pub calibration: Vec<Deltas>,
}

impl Table {
    /// The number of joints that move.
    pub fn moving(&self) -> usize {
        self.joints.iter().filter(|joint| joint.kind != JointKind::Fixed).count()
    }

    /// Joints with the link that their row has.
    fn rows(&self) -> impl Iterator<Item = (&Joint, &Link)> {
        let first = match self.convention {
            Convention::Standard => 1,
            Convention::Modified => 0,
        };
        self.joints.iter().zip(self.links.iter().skip(first))
    }

    /// The chain of these numbers, by way of no file.
    pub fn chain(&self) -> Chain {
        let angle = |degrees: f64| if self.radians { Written::of(degrees).rad() } else { degrees.to_radians() };
        let row = |(joint, link): (&Joint, &Link)| DhRow {
            kind: joint.kind,
            a: link.a,
            alpha: angle(link.alpha),
            d: joint.d,
            theta: angle(joint.theta),
        };
        let frame =
            |frame: &Option<Frame>| frame.map_or(DhFrame::IDENTITY, |[xyz, rpy]| DhFrame { xyz, rpy: rpy.map(angle) });
        let mut rows: Vec<DhRow> = self.rows().map(row).collect();
        let moving = rows.iter_mut().filter(|row| row.kind != JointKind::Fixed);
        for (row, deltas) in moving.zip(&self.calibration) {
            row.a += deltas.a;
            row.alpha += deltas.alpha;
            row.d += deltas.d;
            row.theta += deltas.theta;
        }
        Chain::new(self.convention, &rows).with_base(frame(&self.base)).with_tool(frame(&self.tool))
    }

    /// The arm file.
    pub fn yaml(&self, name: &str) -> String {
        let convention = match self.convention {
            Convention::Standard => "standard",
            Convention::Modified => "modified",
        };
        let unit = if self.radians { "rad" } else { "deg" };
        let mut text =
            format!("name: {name}\nconvention: {convention}\nunits: {{length: {}, angle: {unit}}}\n", self.unit);
        // Writing to a string cannot fail.
        if let Some(inverse) = &self.inverse {
            let _ = writeln!(text, "inverse: {inverse}");
        }
        let angle = |degrees: f64| if self.radians { Written::of(degrees).to_string() } else { format!("{degrees:?}") };
        let angles = |degrees: &[f64]| degrees.iter().map(|d| angle(*d)).collect::<Vec<_>>().join(", ");
        for (key, frame) in [("base", &self.base), ("tool", &self.tool)] {
            if let Some([xyz, rpy]) = frame {
                let _ = writeln!(text, "{key}: {{xyz: {xyz:?}, rpy: [{}]}}", angles(rpy));
            }
        }
        text.push_str("joints:\n");
        for (joint, link) in self.rows() {
            let kind = match joint.kind {
                JointKind::Revolute => "",
                JointKind::Prismatic => "type: prismatic, ",
                JointKind::Fixed => "type: fixed, ",
            };
            let (alpha, theta) = (angle(link.alpha), angle(joint.theta));
            let _ = write!(text, "  - {{{kind}a: {:?}, alpha: {alpha}, d: {:?}, theta: {theta}", link.a, joint.d);
            if let Some(limits) = joint.limits {
                let limits = match joint.kind {
                    JointKind::Revolute => format!("[{}]", angles(&limits)),
                    _ => format!("{limits:?}"),
                };
                let _ = write!(text, ", limits: {limits}");
            }
            text.push_str("}\n");
        }
        if !self.calibration.is_empty() {
            text.push_str("calibration:\n");
        }
        for (joint, Deltas { a, alpha, d, theta }) in (1..).zip(&self.calibration) {
            let _ = writeln!(text, "  q{joint}: {{a: {a:e}, alpha: {alpha:e} rad, d: {d:e}, theta: {theta:e} rad}}");
        }
        text
    }
}

/// An angle in a file of radians.
enum Written {
    /// Twelfths of pi.
    Exact(i32),
    /// Radians, rounded as people write them.
    Rounded(f64),
}

impl Written {
    fn of(degrees: f64) -> Self {
        let twelfths = (degrees / 15.0).round();
        match twelfths * 15.0 == degrees {
            true => Written::Exact(twelfths as i32),
            false => Written::Rounded((degrees.to_radians() * 1e6).round() / 1e6),
        }
    }

    fn rad(&self) -> f64 {
        match self {
            Written::Exact(twelfths) => f64::from(*twelfths) * std::f64::consts::PI / 12.0,
            Written::Rounded(rad) => *rad,
        }
    }
}

impl Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Written::Exact(0) => f.write_str("0"),
            Written::Exact(twelfths) => write!(f, "{twelfths}*pi/12"),
            Written::Rounded(rad) => write!(f, "{rad:?}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_conventions_are_one_chain() {
        let joint = |d, theta| Joint { kind: JointKind::Revolute, d, theta, limits: None };
        let link = |a, alpha| Link { a, alpha };
        let table = |convention| Table {
            convention,
            joints: vec![joint(0.1, 20.0), joint(0.2, -30.0)],
            links: vec![Link::default(), link(0.3, 40.0), Link::default()],
            base: None,
            tool: None,
            unit: "m",
            radians: false,
            inverse: None,
            calibration: Vec::new(),
        };
        let q = [0.4, -1.2];
        let [standard, modified] =
            [Convention::Standard, Convention::Modified].map(|c| table(c).chain().forward(&q).unwrap());
        assert!((standard.to_matrix() - modified.to_matrix()).norm() < 1e-15);
        assert!(table(Convention::Standard).yaml("two").contains("  - {a: 0.3, alpha: 40.0, d: 0.1, theta: 20.0}\n"));
        assert!(table(Convention::Modified).yaml("two").contains("  - {a: 0.3, alpha: 40.0, d: 0.2, theta: -30.0}\n"));
    }
}
