//! `units:` and `convention:`.

use super::angle::AngleUnit;
use super::reader::{Fields, Reader};

/// The length unit of the file, which is also that of the generated code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthUnit {
    /// `m`
    Meter,
    /// `cm`
    Centimeter,
    /// `mm`
    Millimeter,
    /// `in`
    Inch,
}

impl LengthUnit {
    /// As a reader writes it after a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Meter => "m",
            Self::Centimeter => "cm",
            Self::Millimeter => "mm",
            Self::Inch => "in",
        }
    }
}

/// Which frame a row of the table belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`
    Standard,
    /// Craig: `Rx(alpha) Tx(a) Rz(theta) Tz(d)`, with `a` and `alpha` of the link before
    Modified,
}

const LENGTHS: &[(&str, LengthUnit)] = &[
    ("m", LengthUnit::Meter),
    ("cm", LengthUnit::Centimeter),
    ("mm", LengthUnit::Millimeter),
    ("in", LengthUnit::Inch),
];
const LENGTH_SYNONYMS: &[(&str, &str)] = &[
    ("meter", "m"),
    ("meters", "m"),
    ("metre", "m"),
    ("metres", "m"),
    ("centimeter", "cm"),
    ("centimeters", "cm"),
    ("millimeter", "mm"),
    ("millimeters", "mm"),
    ("inch", "in"),
    ("inches", "in"),
];
const ANGLES: &[(&str, AngleUnit)] = &[("deg", AngleUnit::Degree), ("rad", AngleUnit::Radian)];
const ANGLE_SYNONYMS: &[(&str, &str)] =
    &[("degree", "deg"), ("degrees", "deg"), ("°", "deg"), ("radian", "rad"), ("radians", "rad")];
const CONVENTIONS: &[(&str, Convention)] = &[("standard", Convention::Standard), ("modified", Convention::Modified)];
const CONVENTION_SYNONYMS: &[(&str, &str)] = &[
    ("classic", "standard"),
    ("classical", "standard"),
    ("distal", "standard"),
    ("craig", "modified"),
    ("mdh", "modified"),
    ("proximal", "modified"),
];

/// The two choices, for whoever has to make one.
const CONVENTION_HELP: &str = "\
write `convention: standard` if row i holds a_i, alpha_i, d_i, theta_i: Rz(theta) Tz(d) Tx(a) Rx(alpha),
or `convention: modified` (Craig) if row i holds a_{i-1}, alpha_{i-1}, d_i, theta_i: Rx(alpha) Tx(a) Rz(theta) Tz(d)";

/// The units of the file. The angle unit is `None` when it cannot be read: then plain numbers are not judged.
pub struct Units {
    pub length: LengthUnit,
    pub angle: Option<AngleUnit>,
}

impl Reader<'_> {
    pub fn units(&mut self, root: &Fields<'_>) -> Units {
        let mut units = Units { length: LengthUnit::Meter, angle: Some(AngleUnit::Degree) };
        let Some(field) = root.get("units") else {
            if !root.has("units") {
                let warning =
                    self.source.warning(&root.place, "no `units`: lengths are taken as m and angles as degrees");
                self.warnings.push(warning.help("write `units: {length: m, angle: deg}`"));
            }
            return units;
        };
        let Some(fields) = self.mapping(&field, "`units`", &["length", "angle"]) else {
            units.angle = None;
            return units;
        };
        match fields.get("length") {
            Some(field) => match self.choice(&field, LENGTHS, LENGTH_SYNONYMS) {
                Some(unit) => units.length = unit,
                None => self.advise("write all lengths of the file in one of these units"),
            },
            None if fields.has("length") => {}
            None => {
                self.warnings.push(self.source.warning(&field.place, "no `length` in `units`: lengths are taken as m"))
            }
        }
        match fields.get("angle") {
            Some(field) => {
                units.angle = self.choice(&field, ANGLES, ANGLE_SYNONYMS);
                if units.angle.is_none() {
                    self.advise("a single value may have a unit of its own, such as `90 deg`, `1.5 rad` or `pi/2`");
                }
            }
            None if fields.has("angle") => units.angle = None,
            None => {
                self.warnings.push(self.source.warning(&field.place, "no `angle` in `units`: angles are taken as deg"))
            }
        }
        units
    }

    /// The convention; there is no default because a wrong guess gives an arm that looks right.
    pub fn convention(&mut self, root: &Fields<'_>) -> Convention {
        let found = match root.get("convention") {
            Some(field) => {
                let found = self.choice(&field, CONVENTIONS, CONVENTION_SYNONYMS);
                if found.is_none() {
                    self.advise(CONVENTION_HELP);
                }
                found
            }
            None => {
                if !root.has("convention") {
                    let mistake = self.source.mistake(&root.place, "no `convention`: expected standard or modified");
                    self.mistakes.push(mistake.help(CONVENTION_HELP));
                }
                None
            }
        };
        found.unwrap_or(Convention::Standard)
    }
}
