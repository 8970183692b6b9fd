//! `combined_limits:`, ranges of sums of joint values.

use super::angle::AngleUnit;
use super::place::Place;
use super::reader::{Field, Fields, Reader};
use super::value::{JointRef, WrittenValue};
use super::yaml::Node;

/// The range of a sum of joint values.
#[derive(Debug, Clone)]
pub struct CombinedLimitSpec {
    /// The joints with their factors, and where each name stands.
    pub terms: Vec<(JointRef, f64, Place)>,
    /// Where the sum stands.
    pub sum: Place,
    /// Lowest and highest value; `None` where there is no end on that side.
    pub limits: [Option<(WrittenValue, Place)>; 2],
    /// Where the limits stand.
    pub place: Place,
}

const HELP: &str = "write `combined_limits: [{sum: {q2: 1, q3: 1}, limits: [-90, 150]}]`";

impl Reader<'_> {
    /// The combined limits, empty where there are none.
    pub fn combined_limits(&mut self, root: &Fields<'_>, unit: Option<AngleUnit>) -> Vec<CombinedLimitSpec> {
        let Some(field) = root.get("combined_limits") else { return Vec::new() };
        let Node::List(entries) = field.node else {
            self.unexpected(&field, "a list of sums with their limits", Some(HELP.to_owned()));
            return Vec::new();
        };
        let entry = |(number, entry)| {
            let key = format!("combined_limits entry {number}");
            self.combined_limit(&Field { key, ..entry }, unit)
        };
        (1..).zip(field.items(entries)).filter_map(entry).collect()
    }

    fn combined_limit(&mut self, field: &Field<'_>, unit: Option<AngleUnit>) -> Option<CombinedLimitSpec> {
        let fields = self.mapping(field, "an entry of `combined_limits`", &["sum", "limits"])?;
        let missing: Vec<&str> = ["sum", "limits"].into_iter().filter(|key| !fields.has(key)).collect();
        if let Some(key) = missing.first() {
            let mistake = self.source.mistake(&field.place, format!("`{}` has no `{key}`", field.key));
            self.mistakes.push(mistake.help(HELP));
        }
        let sum = fields.get("sum");
        let terms = sum.as_ref().and_then(|field| self.sum(field));
        let limits = fields.get("limits");
        let ends = limits.as_ref().and_then(|field| self.ends(field, unit));
        Some(CombinedLimitSpec { terms: terms?, sum: sum?.place, limits: ends?, place: limits?.place })
    }

    /// `{q2: 1, q3: -0.5}`, or `[q2, q3]` for factors of 1.
    fn sum(&mut self, field: &Field<'_>) -> Option<Vec<(JointRef, f64, Place)>> {
        let mut terms = Vec::new();
        let mut whole = true;
        if let Node::List(nodes) = field.node {
            for entry in field.items(nodes) {
                match self.text(&entry, "a joint's name", "write the joints of the sum, such as `sum: [q2, q3]`") {
                    Some(name) => terms.push((JointRef::Named(name), 1.0, entry.place)),
                    None => whole = false,
                }
            }
        } else {
            for named in self.by_joint(field, "`sum`", HELP)? {
                match self.factor(&named.field) {
                    Some(factor) => terms.push((JointRef::Named(named.name), factor, named.at)),
                    None => whole = false,
                }
            }
        }
        whole.then_some(terms)
    }

    fn ends(&mut self, field: &Field<'_>, unit: Option<AngleUnit>) -> Option<[Option<(WrittenValue, Place)>; 2]> {
        let help = "write `limits: [-90, 150]`, the lowest and the highest value of the sum; null is no limit";
        let ends: [Field<'_>; 2] = self.list(field, "[lowest, highest]", help)?;
        let mut whole = true;
        let ends = ends.map(|end| {
            if *end.node == Node::Null {
                return None;
            }
            let value = self.value(&end, unit).map(|value| (value, end.place));
            whole &= value.is_some();
            value
        });
        whole.then_some(ends)
    }
}
