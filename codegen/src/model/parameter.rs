//! Parameters: which lengths are bound at run time, and the values their structure is decided on.

use super::arm::{Frame, Model, Parameter};
use super::chain::Chain;
use super::reach::reach;
use crate::spec::Length;
use std::collections::HashMap;

/// Which parameters of the file are bound at run time, by fields of the arm's struct. The others are their defaults,
/// as if the file had the numbers.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Bound {
    /// None.
    #[default]
    None,
    /// All of them.
    All,
    /// Parameters of these names; a name that is no parameter binds nothing.
    Fields(Vec<String>),
}

impl Bound {
    fn contains(&self, name: &str) -> bool {
        match self {
            Bound::None => false,
            Bound::All => true,
            Bound::Fields(names) => names.iter().any(|field| field == name),
        }
    }
}

impl Model {
    /// The arm with the bound parameters left as symbols, in the order of the file, and the others replaced by their
    /// defaults.
    pub fn bind(mut self, bound: &Bound) -> Model {
        self.parameters.retain(|parameter| bound.contains(&parameter.name));
        let fold = |length: &mut Length| {
            if length.parameter().is_some_and(|name| !bound.contains(name)) {
                *length = Length::Constant(length.default_value());
            }
        };
        let table = self.calibration.iter_mut().flat_map(|calibration| &mut calibration.table);
        for row in self.rows.iter_mut().chain(table) {
            fold(&mut row.a);
            fold(&mut row.d);
        }
        let frame = |frame: &mut Frame| frame.xyz.iter_mut().for_each(fold);
        frame(&mut self.base);
        frame(&mut self.tool);
        self
    }

    /// All lengths of the table: of the rows, the base and the tool.
    pub fn lengths(&self) -> impl Iterator<Item = &Length> {
        let rows = self.rows.iter().flat_map(|row| [&row.a, &row.d]);
        rows.chain(&self.base.xyz).chain(&self.tool.xyz)
    }

    /// Sets of parameter values without a special relation to each other or to the lengths that are numbers. What holds
    /// for all sets holds for the symbols. One empty set where there are no parameters.
    pub fn samples(&self) -> Vec<HashMap<String, f64>> {
        if self.parameters.is_empty() {
            return vec![HashMap::new()];
        }
        let scale = reach(self, &HashMap::new());
        let sample = |seed: f64| {
            let value = |(index, parameter): (usize, &Parameter)| {
                // Fractions of multiples of an irrational number: spread, and none twice.
                let spread = ((index as f64 + 1.0) * std::f64::consts::SQRT_2 + seed).fract();
                (parameter.name.clone(), scale * (0.2 + 0.3 * spread))
            };
            self.parameters.iter().enumerate().map(value).collect()
        };
        [0.137, 0.491, 0.773].map(sample).to_vec()
    }
}

impl Chain {
    /// The chain at each of the samples of its model.
    pub fn samples(&self, model: &Model) -> Vec<(Chain, f64)> {
        model.samples().iter().map(|values| (self.at(values), reach(model, values))).collect()
    }
}
