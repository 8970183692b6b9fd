//! How far a joint vector is from each kind of singularity.

use denhart::{Branch, Elbow, Pose, Shoulder, Wrist, math};
use denhart_codegen::lower::{Branching, Factor, Input, Margins, Plane};

use crate::function::{Pair, sines};
use crate::tape::{Compiler, Places, Register, Tape};

/// One factor of the determinant of an arm's Jacobian: [`Margin`](denhart::Margin) of an arm known at run time.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicMargin {
    /// `shoulder`, `elbow`, `wrist`, or the joints (`q1 q3`) of equations that have no such name.
    pub name: String,
    /// Zero exactly at that singularity, of opposite signs on the two branches that meet there, without a unit.
    pub value: f64,
}

/// The factors, ready to evaluate.
#[derive(Debug, Clone)]
pub struct Factors {
    program: Margins,
    tape: Tape,
    places: Places,
    pairs: Vec<Pair>,
    reach: f64,
}

impl Factors {
    /// Margin factors of a program, with lengths relative to `reach`.
    pub fn new(program: &Margins, reach: f64) -> Self {
        let mut compiler = Compiler::new(&program.straight.graph, &program.straight.roots);
        let leaf = |slot: Option<_>, compiler: &mut Compiler| slot.map_or(Register::MAX, |slot| compiler.leaf(slot));
        let variables = program.variables.iter();
        let pairs = variables
            .map(|variable| Pair { sin: leaf(variable.sin, &mut compiler), cos: leaf(variable.cos, &mut compiler) })
            .collect();
        let plane = program.plane.iter().flat_map(|plane| [plane.sin, plane.cos]);
        for slot in plane.chain(program.joints.iter().copied()).chain(program.pose.iter().map(|(slot, _)| *slot)) {
            compiler.leaf(slot);
        }
        compiler.work_out(&program.straight.roots);
        let (tape, places) = compiler.finish();
        Factors { program: program.clone(), tape, places, pairs, reach }
    }

    /// The factors at `q`; `pose` is that of the tool there.
    pub fn at(&self, q: &[f64], pose: &Pose<f64>) -> Vec<DynamicMargin> {
        self.values(q, pose).map(|(factor, value)| DynamicMargin { name: factor.name.clone(), value }).collect()
    }

    /// The branch at `q` by the signs of the factors; `pose` is that of the tool there.
    pub fn branch(&self, q: &[f64], pose: &Pose<f64>) -> Branch {
        self.values(q, pose).fold(Branch::NONE, |branch, (factor, value)| match factor.branching {
            Branching::Shoulder => branch.with_shoulder(Shoulder::of_margin(value)),
            Branching::Elbow => branch.with_elbow(Elbow::of_margin(value)),
            Branching::Wrist => branch.with_wrist(Wrist::of_margin(value)),
            Branching::None | Branching::Root => branch,
        })
    }

    /// The place of the factor that is 0 where the wrist is singular.
    pub fn wrist(&self) -> Option<usize> {
        self.program.factors.iter().position(|factor| factor.branching == Branching::Wrist)
    }

    /// Each factor and its value at `q`.
    fn values(&self, q: &[f64], pose: &Pose<f64>) -> impl Iterator<Item = (&Factor, f64)> {
        let Margins { straight, factors, pose: read, joints, variables, plane } = &self.program;
        let mut registers = self.tape.registers();
        for (slot, value) in joints.iter().zip(q) {
            registers.set(self.places.of(*slot), *value);
        }
        for (slot, input) in read {
            let value = match input {
                Input::Rotation(row, column) => pose.rotation.get(*row).and_then(|row| row.get(*column)),
                Input::Position(component) => pose.translation.get(*component),
                _ => None,
            };
            registers.set(self.places.of(*slot), value.copied().unwrap_or(f64::NAN));
        }
        let angle = |joint: usize| q.get(joint).copied().unwrap_or(f64::NAN);
        let angles: Vec<f64> = variables
            .iter()
            .map(|variable| match variable.constant.is_zero() {
                true => angle(variable.joint),
                false => angle(variable.joint) - variable.constant.rad(),
            })
            .collect();
        sines(&mut registers, &angles, &self.pairs);
        if let Some(Plane { signs, offset, sin, cos }) = plane {
            let terms = signs.iter().zip(q).filter(|(sign, _)| **sign != 0.0);
            let sum = terms.fold(offset.rad(), |sum, (sign, q)| if *sign < 0.0 { sum - q } else { sum + q });
            let (sine, cosine) = math::sin_cos(sum);
            registers.set(self.places.of(*sin), sine);
            registers.set(self.places.of(*cos), cosine);
        }
        self.tape.run(0..self.tape.len(), &mut registers);
        let reach = self.reach;
        let scaled = move |value: f64, power: u32| match power {
            0 => value,
            1 => value / reach,
            2 => value / (reach * reach),
            _ => value / (reach * reach * reach),
        };
        factors.iter().zip(&straight.roots).map(move |(factor, root)| {
            let value = registers.get(self.places.of(*root));
            (factor, scaled(value, factor.power))
        })
    }
}
