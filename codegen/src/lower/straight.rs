//! Arithmetic without branches.

use super::{Block, Names, Slot};
use crate::symbolic::Graph;
use std::collections::HashSet;

/// Expressions, and which of them are worked out once under a name.
#[derive(Debug, Clone)]
pub struct Straight {
    /// The arena.
    pub graph: Graph,
    /// Slots bound before the results, in evaluation order.
    pub shared: Vec<Slot>,
    /// The names of the shared ones.
    pub names: Names,
    /// The results.
    pub roots: Vec<Slot>,
    /// Everything the results are made of.
    read: HashSet<Slot>,
}

impl Straight {
    /// Binds what the roots share; `reserved` names are in use already.
    pub fn new(graph: Graph, roots: Vec<Slot>, reserved: impl IntoIterator<Item = String>) -> Self {
        let mut block = Block::new(&graph, &roots, reserved);
        let shared = block.bind(&roots);
        let names = block.bound;
        let read = graph.reachable(&roots).into_iter().collect();
        Straight { graph, shared, names, roots, read }
    }

    /// Returns true if a result depends on a slot.
    pub fn reads(&self, slot: Slot) -> bool {
        self.read.contains(&slot)
    }
}
