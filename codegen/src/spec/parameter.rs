//! `parameters:`, names for lengths that may be bound at run time.

use super::angle::AngleUnit;
use super::length::{Length, factored};
use super::nearest::nearest;
use super::place::{Place, Step};
use super::range;
use super::reader::{Field, Fields, Reader};
use super::suggestions;
use super::yaml::Node;

/// A parameter as written.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterSpec {
    /// Its name, the name of a field of the user's struct.
    pub name: String,
    /// Its value where nothing else is bound, length unit of the file.
    pub default: f64,
    /// Its key.
    pub place: Place,
}

/// Unit and parameters with which the lengths and angles of rows and frames are read.
#[derive(Clone, Copy)]
pub struct Context<'c> {
    /// The unit of plain angles; `None` where the file's unit is a mistake.
    pub angle: Option<AngleUnit>,
    /// The parameters; `None` where their list is a mistake.
    pub parameters: Option<&'c [ParameterSpec]>,
}

impl Reader<'_> {
    /// The parameters in the order of the file. One whose value is a mistake is in the list; without a legible name there
    /// is no list. So the uses of either are not mistakes too.
    pub fn parameters(&mut self, root: &Fields<'_>) -> Option<Vec<ParameterSpec>> {
        let Some(field) = root.get("parameters") else { return (!root.has("parameters")).then(Vec::new) };
        let Node::Mapping(entries) = field.node else {
            let help = "write a name and a length for each, such as `parameters: {l2: 0.425, l3: 0.392}`";
            self.unexpected(&field, "a mapping of names and lengths", Some(help.to_owned()));
            return None;
        };
        let mut parameters: Vec<ParameterSpec> = Vec::new();
        let mut legible = true;
        for (index, (key, node)) in entries.iter().enumerate() {
            if self.is_full() {
                break;
            }
            let place = field.place.to(Step::Key(index));
            let name = match key {
                Node::Text(name) if is_field_name(name) => name.clone(),
                _ => {
                    let message = format!("`{}` cannot be the name of a parameter", self.source.written(&place));
                    let help = "a parameter is a field of a struct: write letters, digits and `_`, no digit first, \
                                and no word of Rust, such as `l2`";
                    self.mistakes.push(self.source.mistake(&place, message).help(help));
                    legible = false;
                    continue;
                }
            };
            if let Some(first) = parameters.iter().find(|earlier| earlier.name == name) {
                let line = self.source.location(&first.place).line;
                let mistake = self.source.mistake(&place, format!("the parameter `{name}` occurs twice"));
                self.mistakes.push(mistake.help(format!("the first one is in line {line}: remove one of them")));
                continue;
            }
            let value_place = if *node == Node::Null { place.clone() } else { field.place.to(Step::Value(index)) };
            let default = self.number(&Field { node, place: value_place, key: name.clone() });
            parameters.push(ParameterSpec { name, default: default.unwrap_or(1.0), place });
        }
        legible.then_some(parameters)
    }

    /// A length: a number or a multiple of a parameter. Without a list of parameters no text is judged.
    pub fn length(&mut self, field: &Field<'_>, parameters: Option<&[ParameterSpec]>) -> Option<Length> {
        let text = match field.node {
            Node::Text(text) if field.node.number().is_none() => text,
            _ => return self.number(field).map(Length::Constant),
        };
        let parameters = parameters?;
        let names = || parameters.iter().map(|parameter| parameter.name.as_str());
        match factored(text) {
            Ok((factor, name)) => match parameters.iter().find(|parameter| parameter.name == name) {
                Some(parameter) => {
                    let default = factor * parameter.default;
                    self.within(range::LENGTH, field, default, "mind the factor and the parameter's own value")?;
                    self.lengths.push((default, field.place.clone()));
                    return Some(Length::Multiple { factor, parameter: name.to_owned(), default });
                }
                None if parameters.is_empty() => {
                    self.number(field);
                    self.advise(&format!("to name a length, add `parameters: {{{name}: 0.5}}` to the file"));
                }
                None => {
                    let message = format!("`{}`: no parameter is named `{name}`", field.key);
                    let meant = nearest(name, names()).map(|word| format!("did you mean `{word}`? "));
                    let listed: Vec<&str> = names().collect();
                    let help = format!("{}the parameters are {}", meant.unwrap_or_default(), listed.join(", "));
                    self.mistakes.push(self.source.mistake(&field.place, message).help(help));
                }
            },
            // A number that is not finite or has leading zeros has a message of its own.
            Err(expected) if !parameters.is_empty() && text.trim().parse::<f64>().is_err() => {
                let help = if expected.starts_with("a factor") { None } else { suggestions::expression(text) };
                self.unexpected(field, &format!("a number, or {expected}"), help);
            }
            Err(_) => {
                self.number(field);
            }
        }
        None
    }

    /// Says which parameters none of the `lengths` names.
    pub fn unused_parameters<'l>(&mut self, parameters: &[ParameterSpec], lengths: impl Iterator<Item = &'l Length>) {
        let used: Vec<&str> = lengths.filter_map(Length::parameter).collect();
        for parameter in parameters.iter().filter(|parameter| !used.contains(&parameter.name.as_str())) {
            if !self.may_warn() {
                break;
            }
            let message = format!("the parameter `{}` is not used", parameter.name);
            let warning = self.source.warning(&parameter.place, message);
            self.warnings.push(warning.help("write its name for an `a`, a `d` or an entry of `xyz`, or remove it"));
        }
    }
}

/// Returns true if a text can name a field as it stands: an identifier of Rust that is no keyword.
fn is_field_name(text: &str) -> bool {
    !text.starts_with("r#") && syn::parse_str::<syn::Ident>(text).is_ok()
}
