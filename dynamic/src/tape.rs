//! Expressions as a list of operations on registers.

use std::collections::HashMap;
use std::ops::Range;

use denhart::math;
use denhart_codegen::lower::{Graph, Node, Slot};

/// A register, by its place.
pub type Register = usize;

/// One operation on up to four registers, which stand before that of the result.
#[derive(Debug, Clone, Copy)]
pub struct Operation {
    pub code: Code,
    pub to: u32,
    /// The operands a, b, c, d. Those that the code does not read repeat another.
    pub of: [u32; 4],
}

/// The kind of an operation. A product that only one sum needs is part of the sum: half of the operations of a pose are such
/// products, and each one left out saves a store, a load and a jump. Products are rounded as they are alone.
#[derive(Debug, Clone, Copy)]
pub enum Code {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a b
    Multiply,
    /// -a
    Negate,
    /// The square root of a.
    SquareRoot,
    /// The absolute value of a.
    Absolute,
    /// a + b c
    AddProduct,
    /// a - b c
    SubtractProduct,
    /// a b - c
    ProductLess,
    /// a b + c d
    AddProducts,
    /// a b - c d
    SubtractProducts,
}

impl Code {
    /// The result. An operand is read where the code has it.
    #[inline(always)]
    fn of(self, a: impl Fn() -> f64, b: impl Fn() -> f64, c: impl Fn() -> f64, d: impl Fn() -> f64) -> f64 {
        match self {
            Code::Add => a() + b(),
            Code::Subtract => a() - b(),
            Code::Multiply => a() * b(),
            Code::Negate => -a(),
            Code::SquareRoot => math::sqrt(a()),
            Code::Absolute => a().abs(),
            Code::AddProduct => a() + b() * c(),
            Code::SubtractProduct => a() - b() * c(),
            Code::ProductLess => a() * b() - c(),
            Code::AddProducts => a() * b() + c() * d(),
            Code::SubtractProducts => a() * b() - c() * d(),
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
        for Operation { code, to, of: [a, b, c, d] } in self.operations.get(operations).unwrap_or(&[]) {
            let [a, b, c, d] = [a, b, c, d].map(|at| || registers.get(*at as usize));
            let value = code.of(a, b, c, d);
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
/// Every expression has one register, but for a product that is part of the only sum it is needed for. The arithmetic is
/// that of the graph, in its order. Generated code does the same in the same order, so the results are equal to the bit.
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
    /// The products that are part of a sum, by their place in the graph.
    parts: Vec<bool>,
}

impl<'a> Compiler<'a> {
    /// Nothing yet, of a graph of which these expressions will be asked for.
    pub fn new(graph: &'a Graph, roots: &[Slot]) -> Self {
        let mut needs = vec![0; graph.size()];
        let mut need = |slot: Slot| {
            if let Some(needs) = needs.get_mut(slot.at()) {
                *needs += 1;
            }
        };
        for slot in graph.reachable(roots) {
            match graph.node(slot) {
                Node::Number(_) | Node::Symbol(_) => {}
                Node::Neg(a) | Node::Sqrt(a) => need(a),
                Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) => [a, b].into_iter().for_each(&mut need),
            }
        }
        let mut parts = vec![false; graph.size()];
        for slot in graph.reachable(roots) {
            let (Node::Add(a, b) | Node::Sub(a, b)) = graph.node(slot) else { continue };
            for operand in [a, b] {
                let product = matches!(graph.node(operand), Node::Mul(..)) && graph.constant(operand).is_none();
                if let (Some(part), Some(1)) = (parts.get_mut(operand.at()), needs.get(operand.at())) {
                    *part = product;
                }
            }
        }
        // A root is looked up, so it has a register.
        for root in roots {
            if let Some(part) = parts.get_mut(root.at()) {
                *part = false;
            }
        }
        Compiler {
            tape: Tape::default(),
            places: vec![None; graph.size()],
            numbers: HashMap::new(),
            constants: HashMap::new(),
            parts,
            graph,
        }
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
            if self.places.get(slot.at()).is_some_and(Option::is_some) || self.part(slot).is_some() {
                continue;
            }
            if let Some(value) = self.constant(slot) {
                self.number(slot, value);
                continue;
            }
            let operation = match self.graph.node(slot) {
                Node::Number(_) | Node::Symbol(_) => None,
                Node::Neg(a) => Some((Code::Negate, [a; 4])),
                Node::Add(a, b) => Some(match (self.part(a), self.part(b)) {
                    (None, None) => (Code::Add, [a, b, b, b]),
                    (None, Some([b, c])) => (Code::AddProduct, [a, b, c, c]),
                    (Some([a, c]), None) => (Code::AddProduct, [b, a, c, c]),
                    (Some([a, b]), Some([c, d])) => (Code::AddProducts, [a, b, c, d]),
                }),
                Node::Sub(a, b) => Some(match (self.part(a), self.part(b)) {
                    (None, None) => (Code::Subtract, [a, b, b, b]),
                    (None, Some([b, c])) => (Code::SubtractProduct, [a, b, c, c]),
                    (Some([a, c]), None) => (Code::ProductLess, [a, c, b, b]),
                    (Some([a, b]), Some([c, d])) => (Code::SubtractProducts, [a, b, c, d]),
                }),
                Node::Mul(a, b) => Some((Code::Multiply, [a, b, b, b])),
                Node::Sqrt(a) => Some(root(self.graph, a)),
            };
            // Operands of the length of one component need not have a register of their own.
            let operands = operation.map(|(code, of)| (code, of.map(|slot| self.leaf(slot) as u32)));
            let to = self.leaf(slot) as u32;
            if let Some((code, of)) = operands {
                self.tape.operations.push(Operation { code, to, of });
            }
        }
    }

    /// The factors of a product that is part of the only sum it is needed for.
    fn part(&self, slot: Slot) -> Option<[Slot; 2]> {
        match self.graph.node(slot) {
            Node::Mul(a, b) if self.parts.get(slot.at()) == Some(&true) => Some([a, b]),
            _ => None,
        }
    }

    /// The value of an expression of numbers and dimensions alone, by the operations of the tape.
    fn constant(&mut self, slot: Slot) -> Option<f64> {
        self.graph.constant(slot)?;
        let of = |e: &Slot| self.constants.get(e).copied();
        let value = match self.graph.node(slot) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            Node::Symbol(symbol) => symbol.value(),
            Node::Neg(a) => of(&a).map(|a| -a),
            Node::Add(a, b) => of(&a).zip(of(&b)).map(|(a, b)| a + b),
            Node::Sub(a, b) => of(&a).zip(of(&b)).map(|(a, b)| a - b),
            Node::Mul(a, b) => of(&a).zip(of(&b)).map(|(a, b)| a * b),
            Node::Sqrt(a) => match root(self.graph, a) {
                (Code::Absolute, [a, ..]) => of(&a).map(f64::abs),
                _ => of(&a).map(math::sqrt),
            },
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
fn root(graph: &Graph, of: Slot) -> (Code, [Slot; 4]) {
    match graph.node(of) {
        Node::Mul(x, y) if x == y => (Code::Absolute, [x; 4]),
        _ => (Code::SquareRoot, [of; 4]),
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
    fn arithmetic_is_that_of_the_graph() {
        let mut g = Graph::default();
        let [x, y, z] = ["x", "y", "z"].map(|name| g.symbol(name));
        let k = g.dimension(Dimension::LinkLength(0), 0.1);
        let (product, square) = (g.mul(k, x), g.mul(y, y));
        let sum = g.add(product, square);
        let length = g.norm(&[x, y]);
        let one = g.norm(&[y]);
        let negative = g.neg(sum);
        let products: [_; 6] = std::array::from_fn(|n| {
            let factor = g.number(n as f64 + 0.3);
            g.mul(factor, z)
        });
        let [a, b, c, d, e, f] = products;
        let plus = [g.add(x, a), g.add(b, y)];
        let less = [g.sub(x, c), g.sub(d, y), g.sub(e, f)];
        let roots = [sum, length, one, negative, plus[0], plus[1], less[0], less[1], less[2]];
        let mut compiler = Compiler::new(&g, &roots);
        let [at_x, at_y, at_z] = [x, y, z].map(|leaf| compiler.leaf(leaf));
        compiler.work_out(&roots);
        let (tape, places) = compiler.finish();
        let mut registers = tape.registers();
        let (x, y, z) = (0.7_f64, -0.3_f64, 1.9_f64);
        registers.set(at_x, x);
        registers.set(at_y, y);
        registers.set(at_z, z);
        tape.run(0..tape.len(), &mut registers);
        let sum = 0.1 * x + y * y;
        let lengths = [(x * x + y * y).sqrt(), y.abs()];
        let sums = [x + 0.3 * z, 1.3 * z + y, x - 2.3 * z, 3.3 * z - y, 4.3 * z - 5.3 * z];
        let expected = [sum, lengths[0], lengths[1], -sum].into_iter().chain(sums);
        for (root, expected) in roots.into_iter().zip(expected) {
            assert_eq!(registers.get(places.of(root)).to_bits(), expected.to_bits());
        }
        // y y is needed twice; every other product is part of its sum.
        assert_eq!(tape.len(), 11);
    }

    #[test]
    fn a_leaf_without_a_value_is_not_a_number() {
        let mut g = Graph::default();
        let x = g.symbol("x");
        let mut compiler = Compiler::new(&g, &[x]);
        compiler.work_out(&[x]);
        let (tape, places) = compiler.finish();
        assert!(tape.registers().get(places.of(x)).is_nan());
        assert!(tape.registers().get(Register::MAX).is_nan());
    }
}
