//! Rank of an arm's Jacobian at generic configurations: tells whether the arm can do its task at all.

use super::Unsupported;
use super::loop_chain::LoopChain;

/// Relative size below which a direction counts as missing.
const MISSING: f64 = 1e-9;
/// So many generic configurations.
const SAMPLES: usize = 4;

/// The motion of the tool that a task needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToolMotion {
    /// Point and orientation.
    Pose,
    /// The point alone.
    Point,
}

/// Fails for a chain that is singular everywhere.
///
/// # Errors
/// Names the joints that can always move without moving the tool.
pub fn check(chain: &LoopChain, motion: ToolMotion) -> Result<(), Unsupported> {
    let mut idle = None;
    for seed in 0..SAMPLES {
        let columns = columns(chain, motion, seed);
        match eliminate(&columns) {
            (_, None) => return Ok(()),
            (_, Some(motion)) => idle = Some(motion),
        }
    }
    let named: Vec<String> = idle
        .unwrap_or_default()
        .iter()
        .zip(&chain.loop_joints)
        .filter(|(share, _)| share.abs() > 1e-6)
        .map(|(_, slot)| match slot.label.arm() {
            Some(joint) => format!("joint {}", joint + 1),
            None => "the turn that the task leaves open".to_string(),
        })
        .collect();
    let (last, rest) =
        named.split_last().map_or((String::new(), String::new()), |(last, rest)| (last.clone(), rest.join(", ")));
    let together = if rest.is_empty() { last } else { format!("{rest} and {last} together") };
    Err(Unsupported::new(format!("the arm is singular everywhere: {together} can always move without moving the tool")))
}

/// Fails for a chain of more than six joints that moves the tool in fewer than six ways wherever it is.
///
/// # Errors
/// Says in how many ways the tool moves.
pub fn check_redundant(chain: &LoopChain) -> Result<(), Unsupported> {
    let ranks = (0..SAMPLES).map(|seed| eliminate(&columns(chain, ToolMotion::Pose, seed)).0);
    match ranks.max() {
        Some(most) if most < 6 => Err(Unsupported::new(format!(
            "the arm is singular everywhere: its {} joints move the tool in {most} of the six ways only",
            chain.loop_joints.len()
        ))),
        _ => Ok(()),
    }
}

/// The columns of the Jacobian, lengths over reach.
fn columns(chain: &LoopChain, motion: ToolMotion, seed: usize) -> Vec<[f64; 6]> {
    use crate::model::numeric::{cross, sub};
    let Some(sample) = chain.generic.samples().first() else { return Vec::new() };
    let (axes, tool) = chain.axes_and_tool(sample, seed);
    axes.iter()
        .zip(&chain.loop_joints)
        .map(|(axis, slot)| {
            let [x, y, z] = axis.direction;
            if !slot.revolute {
                return [x, y, z, 0.0, 0.0, 0.0];
            }
            let [u, v, w] = cross(axis.direction, sub(tool.p, axis.point)).map(|e| e / chain.reach);
            let turn = if motion == ToolMotion::Pose { [x, y, z] } else { [0.0; 3] };
            let [x, y, z] = turn;
            [u, v, w, x, y, z]
        })
        .collect()
}

/// The rank of the columns, and a combination of them that vanishes, if there is one: by elimination with complete
/// pivoting.
fn eliminate(columns: &[[f64; 6]]) -> (usize, Option<Vec<f64>>) {
    // Each column with the combination of the original ones that it has become.
    let count = columns.len();
    let mut rows: Vec<(Vec<f64>, Vec<f64>)> = columns
        .iter()
        .enumerate()
        .map(|(i, column)| (column.to_vec(), (0..count).map(|j| f64::from(u8::from(i == j))).collect()))
        .collect();
    while let Some((place, pivot, size)) = largest(&rows) {
        if size <= MISSING {
            return (count - rows.len(), rows.into_iter().next().map(|(_, combination)| combination));
        }
        let (chosen, combination) = rows.swap_remove(place);
        let head = chosen.get(pivot).copied().unwrap_or(1.0);
        for (row, own) in &mut rows {
            let factor = row.get(pivot).copied().unwrap_or(0.0) / head;
            row.iter_mut().zip(&chosen).for_each(|(a, b)| *a -= factor * b);
            own.iter_mut().zip(&combination).for_each(|(a, b)| *a -= factor * b);
        }
    }
    (count, None)
}

fn largest(rows: &[(Vec<f64>, Vec<f64>)]) -> Option<(usize, usize, f64)> {
    let entries =
        rows.iter().enumerate().flat_map(|(i, (row, _))| row.iter().enumerate().map(move |(j, e)| (i, j, e.abs())));
    entries.max_by(|a, b| a.2.total_cmp(&b.2))
}
