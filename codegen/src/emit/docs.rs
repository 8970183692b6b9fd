//! Doc texts of generated items.

use crate::model::{JointKind, Model};
use crate::symbolic::Cost;
use proc_macro2::TokenStream;
use quote::quote;

/// Widest line of a doc text.
const WIDTH: usize = 110;

/// A line broken at spaces so that no part is wider than [`WIDTH`] where that is possible; code in backticks stays
/// whole.
fn wrapped(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut code = false;
    for word in line.split(' ') {
        let Some(last) = out.last_mut() else { continue };
        let breaks = !code && !last.is_empty() && last.len() + 1 + word.len() > WIDTH;
        code ^= word.matches('`').count() % 2 == 1;
        if breaks {
            out.push(word.to_string());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    out
}

/// `/// ...`, one attribute a line.
pub fn lines(text: &str) -> TokenStream {
    let lines = text.lines().flat_map(wrapped).map(|line| {
        let line = if line.is_empty() { String::new() } else { format!(" {line}") };
        quote!(#[doc = #line])
    });
    quote!(#(#lines)*)
}

/// Text of a user as Markdown that shows it as it is: no links of `[mm]`, no code to be tested, no HTML. Addresses become
/// links. Code in backticks stays.
pub fn escaped(text: &str) -> String {
    text.lines().map(escaped_line).collect::<Vec<String>>().join("\n")
}

fn escaped_line(line: &str) -> String {
    let line = line.trim();
    // A fence would begin a block of code; a backtick without its pair, a span that ends anywhere.
    let fence = line.starts_with("```") || line.starts_with("~~~");
    let paired = line.matches('`').count().is_multiple_of(2) && !fence;
    let mut out = String::new();
    let mut code = false;
    for word in line.split_inclusive(' ') {
        let bare = word.trim_end();
        let opened = bare.trim_start_matches(['(', '<', '[']);
        let address = ["http://", "https://"].iter().any(|start| opened.starts_with(start)) && !code;
        if address {
            let before = bare.strip_suffix(opened).unwrap_or_default();
            out.extend(before.chars().map(|c| if c == '(' { c.to_string() } else { format!("\\{c}") }));
            let (word, bare) = (word.strip_prefix(before).unwrap_or(word), opened);
            let end = bare.trim_end_matches(['.', ',', ';', ':', ')', ']', '>']);
            let rest = word.strip_prefix(end).unwrap_or_default();
            out += &format!("<{end}>");
            out.extend(rest.chars().map(|c| if matches!(c, '>' | ']') { format!("\\{c}") } else { c.to_string() }));
            continue;
        }
        for c in word.chars() {
            if c == '`' && paired {
                code = !code;
            }
            let special = matches!(c, '[' | ']' | '<' | '>' | '*' | '\\') || (matches!(c, '`' | '~') && !paired);
            if special && !code {
                out.push('\\');
            }
            out.push(c);
        }
    }
    out
}

/// The numbers that a joint vector holds.
pub fn joints(model: &Model) -> String {
    let n = model.joints.len();
    let unit = model.length_unit.symbol();
    let sliding: Vec<String> = model
        .joints
        .iter()
        .enumerate()
        .filter(|(_, joint)| joint.kind == JointKind::Prismatic)
        .map(|(index, _)| format!("q{}", index + 1))
        .collect();
    if sliding.is_empty() {
        format!("`q`: joint angles, rad, `[{n}]`.")
    } else if sliding.len() == n {
        format!("`q`: strokes, {unit}, `[{n}]`.")
    } else {
        format!("`q`: joint angles, rad (strokes {} in {unit}), `[{n}]`.", sliding.join(", "))
    }
}

const POSE: &str = "rotation (dimensionless) and position in";

fn rows(model: &Model) -> String {
    let (n, unit) = (model.joints.len(), model.length_unit.symbol());
    format!("`vx vy vz` ({unit} per unit of `q`) and `wx wy wz` (rad per unit of `q`), one column a joint, `6 x {n}`.")
}

/// Docs of `forward`.
pub fn forward(model: &Model, cost: &Cost) -> String {
    let (n, unit, joints) = (model.joints.len(), model.length_unit.symbol(), joints(model));
    format!(
        "Pose of the tool in the base frame, `^0T_{n}(q)`.\n\n{joints} Returns {POSE} {unit}.\n{cost}.\n\n\
         Method: product of the link transforms, joints with parallel axes turned together, q1 last."
    )
}

/// Docs of `jacobian`.
pub fn jacobian(model: &Model, cost: &Cost) -> String {
    let (joints, rows) = (joints(model), rows(model));
    format!(
        "Geometric Jacobian of the tool point in the base frame.\n\n{joints} Rows {rows}\n{cost}.\n\n\
         Column of a turning joint: `z_i x (p - o_i)` and `z_i`; of a sliding joint: `z_i` and 0 (Whitney 1972)."
    )
}

/// Docs of `forward_and_jacobian`.
pub fn both(model: &Model, cost: &Cost) -> String {
    let (unit, joints, rows) = (model.length_unit.symbol(), joints(model), rows(model));
    format!(
        "Pose of the tool and geometric Jacobian, sharing their terms.\n\n{joints} Returns {POSE} {unit}; rows {rows}\n{cost}."
    )
}

/// Docs of link_poses.
pub fn link_poses(model: &Model, cost: &Cost) -> String {
    let (n, unit, joints) = (model.joints.len(), model.length_unit.symbol(), joints(model));
    format!(
        "Poses of the {n} links in the base frame: link i after joint i, with the fixed rows that follow it; the last \
         without the tool.\n\n{joints} Rotations are dimensionless, positions in {unit}.\n{cost}."
    )
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn a_comment_is_shown_as_it_is() {
        for (comment, shown) in [
            ("Lengths [mm], see <drawing>.", "Lengths \\[mm\\], see \\<drawing\\>."),
            ("```", "\\`\\`\\`"),
            ("~~~rust", "\\~\\~\\~rust"),
            ("`a[0]` is 2 * l2", "`a[0]` is 2 \\* l2"),
            ("an odd ` alone", "an odd \\` alone"),
            ("(https://denhart.example/a_b).", "(<https://denhart.example/a_b>)."),
            ("from https://denhart.example/a_b, page 3", "from <https://denhart.example/a_b>, page 3"),
            ("a\\b", "a\\\\b"),
            ("kuka_kr6_r700, 90 deg", "kuka_kr6_r700, 90 deg"),
        ] {
            assert_eq!(escaped(comment), shown);
        }
        assert_eq!(escaped("one\n\n[two]"), "one\n\n\\[two\\]");
    }
}
