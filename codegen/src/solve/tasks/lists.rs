//! Arms with two joints more than their task needs, or with still more: lists of joints whose values could be given.

use super::attempt::attempt;
use crate::model::chain::Chain;
use crate::model::geometry::Geometry;
use crate::model::{Model, Redundant, Task};
use crate::solve::held_joint;
use crate::solve::loop_chain::LoopChain;
use crate::solve::unsupported::{self, Alternative};

/// The most lists that are looked at, for a message.
const MOST_TRIED: usize = 24;
/// The most lists that are found; a message names the first one.
const MOST_FOUND: usize = 3;

/// The lists with which the arm has an inverse for its task; those first that have the most joints with the file's own
/// list in common.
pub fn alternatives(model: &Model, chain: &Chain, geometry: &Geometry) -> Vec<Alternative> {
    let request = &model.inverse;
    let spare = unsupported::spare(model, request.task);
    if spare < 2 || request.redundant.has_arm_angle() {
        return Vec::new();
    }
    let shared = |list: &Vec<usize>| list.iter().filter(|joint| request.redundant.holds(**joint)).count();
    let mut lists = combinations(model.joints.len(), spare);
    lists.sort_by_key(|list| usize::MAX - shared(list));
    let task = request.task.unwrap_or(Task::Pose);
    // True in closed form, false for a held joint.
    let works = |given: &Redundant| {
        let joints = LoopChain::new(model, chain, geometry.reach, given);
        let is_closed = attempt(task, model, geometry, &joints).is_ok();
        (is_closed || held_joint::is_covered(model, joints)).then_some(is_closed)
    };
    let given = lists.into_iter().take(MOST_TRIED).map(|list| Redundant::of(&list));
    let others = given.filter(|given| given.joints().ne(request.redundant.joints()));
    let found = others.filter_map(|given| works(&given).map(|is_closed| (given, is_closed)));
    found
        .take(MOST_FOUND)
        .enumerate()
        .map(|(place, (given, is_closed))| {
            let names = given.written(&model.joints);
            let words = if place == 0 { format!("`redundant: {names}`") } else { String::new() };
            Alternative::new(words, request.task, Some(&names)).closed_if(is_closed)
        })
        .collect()
}

/// All choices of `k` numbers below `n`, each ascending, in the order of a dictionary.
pub fn combinations(n: usize, k: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for place in 0..k {
        let longer = |list: Vec<usize>| {
            let from = list.last().map_or(0, |last| last + 1);
            // The numbers that leave enough for the places behind.
            let to = (n + place + 1).saturating_sub(k);
            (from..to).map(move |next| list.iter().copied().chain([next]).collect::<Vec<usize>>())
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::combinations;

    #[test]
    fn choices() {
        assert_eq!(combinations(4, 2), [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
        assert_eq!(combinations(10, 4).len(), 210);
        assert_eq!(combinations(3, 3), [[0, 1, 2]]);
        assert_eq!(combinations(2, 3), [[0_usize; 0]; 0]);
    }
}
