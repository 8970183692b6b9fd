//! Pose, Jacobian, link poses and motor values: straight arithmetic.

use denhart::math;
use denhart_codegen::lower::{AngleSum, Function, Linear, Slot};

use crate::tape::{Compiler, Places, Register, Registers, Tape};

/// Sines and cosines of as many angles as a vector unit takes at once.
const AT_ONCE: usize = 4;

/// Where sine and cosine of an angle go.
#[derive(Debug, Clone, Copy)]
pub struct Pair {
    pub sin: Register,
    pub cos: Register,
}

/// Sines and cosines of several angles: the bits are those of one at a time.
pub fn sines(registers: &mut Registers, angles: &[f64], pairs: &[Pair]) {
    let (fours, rest) = angles.as_chunks::<AT_ONCE>();
    let (of_fours, of_rest) = pairs.as_chunks::<AT_ONCE>();
    for (angles, pairs) in fours.iter().zip(of_fours) {
        several(registers, *angles, pairs);
    }
    match (rest, of_rest) {
        ([a, b, c], [x, y, z]) => several(registers, [*a, *b, *c], &[*x, *y, *z]),
        ([a, b], [x, y]) => several(registers, [*a, *b], &[*x, *y]),
        _ => {
            for (angle, pair) in rest.iter().zip(of_rest) {
                let (sin, cos) = math::sin_cos(*angle);
                registers.set(pair.sin, sin);
                registers.set(pair.cos, cos);
            }
        }
    }
}

fn several<const K: usize>(registers: &mut Registers, angles: [f64; K], pairs: &[Pair; K]) {
    let (sines, cosines) = math::sin_cos_array(angles);
    for (pair, (sin, cos)) in pairs.iter().zip(sines.into_iter().zip(cosines)) {
        registers.set(pair.sin, sin);
        registers.set(pair.cos, cos);
    }
}

/// A function of the joint values.
#[derive(Debug, Clone)]
pub struct Straight {
    pub tape: Tape,
    pub joints: Vec<Register>,
    pub sums: Vec<Sum>,
    pub pairs: Vec<Pair>,
    pub results: Vec<Register>,
}

impl Straight {
    /// That of a program.
    pub fn new(function: &Function) -> Self {
        let straight = &function.straight;
        let mut this = Self::of(&straight.graph, &function.joints, &straight.roots, |compiler| {
            let pair = |sin: Slot, cos: Slot, compiler: &mut Compiler| Pair {
                sin: compiler.leaf(sin),
                cos: compiler.leaf(cos),
            };
            function.turned.iter().map(|turned| pair(turned.pair.sin, turned.pair.cos, compiler)).collect()
        });
        this.sums = function.turned.iter().map(|turned| Sum::new(&turned.sum)).collect();
        this
    }

    /// That of a coupling.
    pub fn linear(linear: &Linear) -> Self {
        Self::of(&linear.straight.graph, &linear.values, &linear.straight.roots, |_| Vec::new())
    }

    fn of(
        graph: &denhart_codegen::lower::Graph,
        values: &[Slot],
        roots: &[Slot],
        pairs: impl Fn(&mut Compiler) -> Vec<Pair>,
    ) -> Self {
        let mut compiler = Compiler::new(graph, roots);
        let joints = values.iter().map(|slot| compiler.leaf(*slot)).collect();
        let pairs = pairs(&mut compiler);
        compiler.work_out(roots);
        let (tape, places): (Tape, Places) = compiler.finish();
        Straight { tape, joints, sums: Vec::new(), pairs, results: roots.iter().map(|root| places.of(*root)).collect() }
    }

    /// Evaluates it: puts every result, in order, to its place.
    pub fn run<'p>(&self, q: &[f64], places: impl IntoIterator<Item = &'p mut f64>) {
        let mut registers = self.tape.registers();
        for (at, value) in self.joints.iter().zip(q) {
            registers.set(*at, *value);
        }
        let mut angles = [0.0; 2 * AT_ONCE];
        for (sums, pairs) in self.sums.chunks(angles.len()).zip(self.pairs.chunks(angles.len())) {
            for (angle, sum) in angles.iter_mut().zip(sums) {
                *angle = sum.value(q);
            }
            sines(&mut registers, angles.get(..sums.len()).unwrap_or(&[]), pairs);
        }
        self.tape.run(0..self.tape.len(), &mut registers);
        for (place, at) in places.into_iter().zip(&self.results) {
            *place = registers.get(*at);
        }
    }
}

/// A signed sum of joint angles and a constant angle, rad.
#[derive(Debug, Clone)]
pub struct Sum {
    pub terms: Vec<(usize, bool)>,
    pub constant: Option<f64>,
}

impl Sum {
    /// From the generator's.
    pub fn new(sum: &AngleSum) -> Self {
        let constant = (!sum.constant.is_zero()).then(|| sum.constant.rad());
        Sum { terms: sum.terms.clone(), constant }
    }

    /// At joint values.
    pub fn value(&self, q: &[f64]) -> f64 {
        let joint = |joint: &usize| q.get(*joint).copied().unwrap_or(f64::NAN);
        let Some(((first, negative), rest)) = self.terms.split_first() else { return self.constant.unwrap_or(0.0) };
        let first = if *negative { -joint(first) } else { joint(first) };
        let sum = rest.iter().fold(first, |sum, (index, negative)| match negative {
            true => sum - joint(index),
            false => sum + joint(index),
        });
        self.constant.map_or(sum, |constant| sum + constant)
    }
}
