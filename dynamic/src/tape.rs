//! Expressions as a list of operations on registers.

use std::collections::HashMap;
use std::ops::Range;

use denhart::math;
use denhart_codegen::lower::{Graph, Node, Slot};

/// A register, by its place.
pub type Register = usize;

/// One operation: `to = a code b`. The operands stand before the result.
#[derive(Debug, Clone, Copy)]
pub struct Operation {
    pub code: Code,
    pub to: u32,
    pub a: u32,
    pub b: u32,
}

/// The kind of an operation.
#[derive(Debug, Clone, Copy)]
pub enum Code {
    Add,
    Subtract,
    Multiply,
    Negate,
    SquareRoot,
    Absolute,
}

impl Code {
    #[inline]
    fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Code::Add => a + b,
            Code::Subtract => a - b,
            Code::Multiply => a * b,
            Code::Negate => -a,
            Code::SquareRoot => math::sqrt(a),
            Code::Absolute => a.abs(),
        }
    }
}

/// Operations, and the registers they work on. Registers of constants have their values before the first operation.
#[derive(Debug, Clone, Default)]
pub struct Tape {
    operations: Vec<Operation>,
    start: Vec<f64>,
}

impl Tape {
    /// The registers before the first operation.
    #[inline]
    pub fn registers(&self) -> Registers {
        Registers(self.start.clone())
    }

    /// Does some operations, in order.
    #[inline]
    pub fn run(&self, operations: Range<usize>, registers: &mut Registers) {
        for Operation { code, to, a, b } in self.operations.get(operations).unwrap_or(&[]) {
            let value = code.of(registers.get(*a as usize), registers.get(*b as usize));
            registers.set(*to as usize, value);
        }
    }

    /// The number of operations.
    pub fn len(&self) -> usize {
        self.operations.len()
    }

    /// The operations, and the values of the registers before the first one.
    #[cfg(feature = "batch")]
    pub fn parts(&self) -> (&[Operation], &[f64]) {
        (&self.operations, &self.start)
    }
}

/// The values of registers.
#[derive(Debug, Clone)]
pub struct Registers(Vec<f64>);

impl Registers {
    /// The value of a register; not a number where there is none.
    #[inline]
    pub fn get(&self, at: Register) -> f64 {
        self.0.get(at).copied().unwrap_or(f64::NAN)
    }

    /// Sets a register.
    #[inline]
    pub fn set(&mut self, at: Register, value: f64) {
        if let Some(place) = self.0.get_mut(at) {
            *place = value;
        }
    }
}

/// Makes a tape of the expressions of a graph.
///
/// Every expression has one register. The operations are those of the graph, one by one and in its order. Generated
/// code does them in the same order, so the results are equal to the bit.
#[derive(Debug)]
pub struct Compiler<'a> {
    graph: &'a Graph,
    tape: Tape,
    /// Registers by the place of an expression in the graph.
    places: Vec<Option<u32>>,
    /// Registers of numbers, by their bits.
    numbers: HashMap<u64, u32>,
    /// Values of the expressions that are constant.
    constants: HashMap<Slot, f64>,
}

impl<'a> Compiler<'a> {
    /// Nothing yet.
    pub fn new(graph: &'a Graph) -> Self {
        let places = vec![None; graph.size()];
        Compiler { graph, tape: Tape::default(), places, numbers: HashMap::new(), constants: HashMap::new() }
    }

    /// The register of a leaf, or of an expression that is worked out already.
    pub fn leaf(&mut self, slot: Slot) -> Register {
        let fresh = u32::try_from(self.tape.start.len()).unwrap_or(u32::MAX);
        match self.places.get_mut(slot.at()) {
            Some(Some(known)) => *known as Register,
            Some(place) => {
                *place = Some(fresh);
                self.tape.start.push(f64::NAN);
                fresh as Register
            }
            None => Register::MAX,
        }
    }

    /// Appends what the expressions still need.
    pub fn work_out(&mut self, slots: &[Slot]) {
        for slot in self.graph.reachable(slots) {
            if self.places.get(slot.at()).is_some_and(Option::is_some) {
                continue;
            }
            if let Some(value) = self.constant(slot) {
                self.number(slot, value);
                continue;
            }
            let operation = match self.graph.node(slot) {
                Node::Number(_) | Node::Symbol(_) => None,
                Node::Neg(a) => Some((Code::Negate, a, a)),
                Node::Add(a, b) => Some((Code::Add, a, b)),
                Node::Sub(a, b) => Some((Code::Subtract, a, b)),
                Node::Mul(a, b) => Some((Code::Multiply, a, b)),
                Node::Sqrt(a) => Some(root(self.graph, a)),
            };
            // Operands of the length of one component need not have a register of their own.
            let operands = operation.map(|(code, a, b)| (code, self.leaf(a), self.leaf(b)));
            let to = self.leaf(slot) as u32;
            if let Some((code, a, b)) = operands {
                self.tape.operations.push(Operation { code, to, a: a as u32, b: b as u32 });
            }
        }
    }

    /// The value of an expression of numbers and dimensions alone, by the operations of the tape.
    fn constant(&mut self, slot: Slot) -> Option<f64> {
        self.graph.constant(slot)?;
        let of = |e: &Slot| self.constants.get(e).copied();
        let value = match self.graph.node(slot) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            Node::Symbol(symbol) => symbol.value(),
            Node::Neg(a) => of(&a).map(|a| Code::Negate.of(a, a)),
            Node::Add(a, b) => of(&a).zip(of(&b)).map(|(a, b)| Code::Add.of(a, b)),
            Node::Sub(a, b) => of(&a).zip(of(&b)).map(|(a, b)| Code::Subtract.of(a, b)),
            Node::Mul(a, b) => of(&a).zip(of(&b)).map(|(a, b)| Code::Multiply.of(a, b)),
            Node::Sqrt(a) => {
                let (code, a, _) = root(self.graph, a);
                of(&a).map(|a| code.of(a, a))
            }
        }?;
        self.constants.insert(slot, value);
        Some(value)
    }

    /// Gives an expression the register of a number.
    fn number(&mut self, slot: Slot, value: f64) {
        let next = u32::try_from(self.tape.start.len()).unwrap_or(u32::MAX);
        let register = *self.numbers.entry(value.to_bits()).or_insert(next);
        if register == next {
            self.tape.start.push(value);
        }
        if let Some(place) = self.places.get_mut(slot.at()) {
            *place = Some(register);
        }
    }

    /// The number of operations so far.
    pub fn len(&self) -> usize {
        self.tape.len()
    }

    /// The tape, and the register of each expression by its place in the graph.
    pub fn finish(self) -> (Tape, Places) {
        (self.tape, Places(self.places))
    }
}

/// The length of a vector of one component is its absolute value.
fn root(graph: &Graph, of: Slot) -> (Code, Slot, Slot) {
    match graph.node(of) {
        Node::Mul(x, y) if x == y => (Code::Absolute, x, x),
        _ => (Code::SquareRoot, of, of),
    }
}

/// The register of each expression.
#[derive(Debug, Clone, Default)]
pub struct Places(Vec<Option<u32>>);

impl Places {
    /// The register of an expression.
    #[inline]
    pub fn of(&self, slot: Slot) -> Register {
        self.0.get(slot.at()).copied().flatten().map_or(Register::MAX, |at| at as Register)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use denhart_codegen::lower::Dimension;

    #[test]
    fn operations_are_those_of_the_graph() {
        let mut g = Graph::default();
        let [x, y] = ["x", "y"].map(|name| g.symbol(name));
        let k = g.dimension(Dimension::LinkLength(0), 0.1);
        let (product, square) = (g.mul(k, x), g.mul(y, y));
        let sum = g.add(product, square);
        let length = g.norm(&[x, y]);
        let one = g.norm(&[y]);
        let negative = g.neg(sum);
        let roots = [sum, length, one, negative];
        let mut compiler = Compiler::new(&g);
        let [at_x, at_y] = [x, y].map(|leaf| compiler.leaf(leaf));
        compiler.work_out(&roots);
        let (tape, places) = compiler.finish();
        let mut registers = tape.registers();
        let (x, y) = (0.7_f64, -0.3_f64);
        registers.set(at_x, x);
        registers.set(at_y, y);
        tape.run(0..tape.len(), &mut registers);
        let expected = [0.1 * x + y * y, (x * x + y * y).sqrt(), y.abs(), -(0.1 * x + y * y)];
        for (root, expected) in roots.into_iter().zip(expected) {
            assert_eq!(registers.get(places.of(root)).to_bits(), expected.to_bits());
        }
    }

    #[test]
    fn a_leaf_without_a_value_is_not_a_number() {
        let mut g = Graph::default();
        let x = g.symbol("x");
        let mut compiler = Compiler::new(&g);
        compiler.work_out(&[x]);
        let (tape, places) = compiler.finish();
        assert!(tape.registers().get(places.of(x)).is_nan());
        assert!(tape.registers().get(Register::MAX).is_nan());
    }
}
