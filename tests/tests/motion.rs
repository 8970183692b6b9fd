//! Velocities, accelerations, the Jacobian's derivative and other forms, and the manipulability. The arms are every arm
//! of `specs/` and one that points. The values are held beside numbers that carry their derivatives, beside
//! extrapolated differences of the chain, and beside singular values.

use std::path::Path;

use denhart::{Acceleration, Chain, DhTable, Jacobian, JointKind, Twist};
use denhart_tests::poses::Space;
use denhart_tests::random::Random;
use denhart_tests::series::{self, Series};
use denhart_tests::subject::{Specified, largest, reach};
use denhart_tests::task::{Kind, Task, across, tool_axis};
use nalgebra::DMatrix;

/// Bound on poses and Jacobians in `numeric.rs`, in reaches: some fifty roundings through ten transforms.
const ROUNDING: f64 = 1e-13;

/// Bound on poses and Jacobians in `scalar_f32.rs`, in reaches.
const SINGLE: f64 = 4e-6;

type Joints<const N: usize> = [f64; N];

/// The methods of an arm, its own and not those of the trait.
#[derive(Clone, Copy)]
struct Methods<const N: usize> {
    velocity: fn(&Joints<N>, &Joints<N>) -> Twist<f64>,
    acceleration: fn(&Joints<N>, &Joints<N>, &Joints<N>) -> Acceleration<f64>,
    jacobian_dot: fn(&Joints<N>, &Joints<N>) -> Jacobian<f64, N>,
    jacobian_tool: fn(&Joints<N>) -> Jacobian<f64, N>,
    link_velocities: fn(&Joints<N>, &Joints<N>) -> [Twist<f64>; N],
    link_accelerations: fn(&Joints<N>, &Joints<N>, &Joints<N>) -> [Acceleration<f64>; N],
    manipulability: fn(&Joints<N>) -> f64,
}

/// An arm under test.
struct Arm<const N: usize> {
    name: &'static str,
    table: DhTable,
    chain: Chain,
    reach: f64,
    kinds: [JointKind; N],
    limits: [[f64; 2]; N],
    counted: Counted,
    methods: Methods<N>,
}

impl<const N: usize> Arm<N> {
    /// The arm `A`, whose file has this text.
    fn new<A: Specified<N>>(text: &str, methods: Methods<N>) -> Self {
        let reach = reach(&A::TABLE, &A::LIMITS);
        let (table, chain) = (A::TABLE, Chain::from(A::TABLE));
        let counted = Counted::of(text);
        Self { name: A::NAME, table, chain, reach, kinds: A::JOINT_KINDS, limits: A::LIMITS, counted, methods }
    }

    /// Rates whose absolute values, strokes in reaches, are at most 1.
    fn rates(&self, random: &mut Random) -> Joints<N> {
        self.kinds.map(|kind| random.uniform(-1.0, 1.0) * if kind == JointKind::Revolute { 1.0 } else { self.reach })
    }

    /// Largest difference, linear parts in reaches.
    fn difference(&self, a: [f64; 6], b: [f64; 6]) -> f64 {
        largest((0..6).map(|k| (a[k] - b[k]) / if k < 3 { self.reach } else { 1.0 }))
    }

    fn check(&self) {
        let space = Space::new(&self.kinds, &self.limits, self.reach);
        let mut random = Random::named(self.name);
        let positions: Vec<Joints<N>> = (0..200)
            .map(|_| space.random(&mut random))
            .chain(space.grid_samples(4, 100, &mut Random::named(self.name)))
            .collect();
        for (index, q) in positions.iter().enumerate() {
            let (qd, qdd) = (self.rates(&mut random), self.rates(&mut random));
            self.beside_series(q, &qd, &qdd);
            self.in_the_tool(q, &qd);
            self.manipulability(q);
            if index % 8 == 0 {
                self.beside_differences(q, &qd, &qdd);
            }
        }
    }

    /// A velocity sums N columns, an acceleration another N and two products for each pair of them.
    fn beside_series(&self, q: &Joints<N>, qd: &Joints<N>, qdd: &Joints<N>) {
        let (first, second) = (ROUNDING * N as f64, ROUNDING * (N + 2 * N * N) as f64);
        let joints: [Series; N] = std::array::from_fn(|k| Series([q[k], qd[k], qdd[k]]));
        let (links, tool) = series::frames(&self.table, &joints);
        let (name, methods) = (self.name, &self.methods);

        let twist = (methods.velocity)(q, qd);
        let error = self.difference(twist.to_array(), tool.twist().to_array());
        assert!(error < first, "{name} at {q:?}: velocity {error:e}\n{twist}\n{}", tool.twist());
        let acceleration = (methods.acceleration)(q, qd, qdd);
        let error = self.difference(acceleration.to_array(), tool.acceleration().to_array());
        assert!(error < second, "{name} at {q:?}: acceleration {error:e}\n{acceleration}\n{}", tool.acceleration());

        let twists = (methods.link_velocities)(q, qd);
        let accelerations = (methods.link_accelerations)(q, qd, qdd);
        assert_eq!(links.len(), N);
        for (link, frame) in links.iter().enumerate() {
            let error = self.difference(twists[link].to_array(), frame.twist().to_array());
            assert!(error < first, "{name} at {q:?}: velocity of link {link} {error:e}");
            let error = self.difference(accelerations[link].to_array(), frame.acceleration().to_array());
            assert!(error < second, "{name} at {q:?}: acceleration of link {link} {error:e}");
        }

        let of_chain = self.chain.velocity(q, qd).unwrap();
        assert!(self.difference(of_chain.to_array(), tool.twist().to_array()) < first, "{name}: velocity of the chain");
        let of_chain = self.chain.acceleration(q, qd, qdd).unwrap();
        let error = self.difference(of_chain.to_array(), tool.acceleration().to_array());
        assert!(error < second, "{name} at {q:?}: acceleration of the chain {error:e}");
    }

    /// The joints move along `q + qd t + qdd t^2 / 2`, with rates scaled to a sum of at most 1. An entry of the
    /// Jacobian, in reaches, then has derivatives of order 1. Four central differences from step 1/4 on, extrapolated,
    /// are off by `(1/4)^8 / 4^6 / 9!`, below 1e-13. What remains are the roundings of the chain over the least step,
    /// with the weights of the extrapolation: twice `ROUNDING` times 32.
    fn beside_differences(&self, q: &Joints<N>, qd: &Joints<N>, qdd: &Joints<N>) {
        let scaled = |rates: &Joints<N>| rates.map(|rate| rate / (2 * N) as f64);
        let (qd, qdd) = (scaled(qd), scaled(qdd));
        let tolerance = 2.0 * ROUNDING * 32.0;
        let at = |t: f64| -> Joints<N> { std::array::from_fn(|k| q[k] + t * (qd[k] + 0.5 * t * qdd[k])) };

        let jacobian = |t: f64| self.chain.jacobian(&at(t)).unwrap().as_slice().to_vec();
        let expected = extrapolated(jacobian);
        let found = (self.methods.jacobian_dot)(q, &qd);
        let of_chain = self.chain.jacobian_dot(q, &qd).unwrap();
        for joint in 0..N {
            let unit = if self.kinds[joint] == JointKind::Revolute { 1.0 } else { self.reach };
            let expected: [f64; 6] = std::array::from_fn(|row| unit * expected[6 * joint + row]);
            let column = found.column(joint).unwrap().map(|x| unit * x);
            let error = self.difference(column, expected);
            assert!(error < tolerance, "{} at {q:?}: jacobian_dot {error:e}\n{found}", self.name);
            let column = std::array::from_fn(|row| unit * of_chain[(row, joint)]);
            assert!(self.difference(column, expected) < tolerance, "{}: jacobian_dot of the chain", self.name);
        }

        let velocity = |t: f64| {
            let rates: Joints<N> = std::array::from_fn(|k| qd[k] + t * qdd[k]);
            let product = self.chain.jacobian(&at(t)).unwrap() * nalgebra::DVector::from_row_slice(&rates);
            product.as_slice().to_vec()
        };
        let expected = extrapolated(velocity).try_into().unwrap();
        let found = (self.methods.acceleration)(q, &qd, &qdd);
        let error = self.difference(found.to_array(), expected);
        assert!(error < tolerance, "{} at {q:?}: acceleration {error:e}\n{found}\n{expected:?}", self.name);

        let origins = |t: f64| {
            let poses = self.chain.link_poses(&at(t)).unwrap();
            poses.iter().flat_map(|pose| pose.translation.vector.as_slice().to_vec()).collect::<Vec<_>>()
        };
        let expected = extrapolated(origins);
        for (link, twist) in (self.methods.link_velocities)(q, &qd).iter().enumerate() {
            let error = largest((0..3).map(|k| (twist.linear[k] - expected[3 * link + k]) / self.reach));
            assert!(error < tolerance, "{} at {q:?}: velocity of link {link} {error:e}", self.name);
        }
    }

    /// Turned back by the rotation of the tool, it gives the velocity in the base frame.
    fn in_the_tool(&self, q: &Joints<N>, qd: &Joints<N>) {
        let rotation = self.chain.forward(q).unwrap().rotation;
        let twist = (self.methods.jacobian_tool)(q).velocity(qd);
        let outward = |v: [f64; 3]| rotation * nalgebra::Vector3::from(v);
        let [x, y, z]: [f64; 3] = outward(twist.linear).into();
        let [a, b, c]: [f64; 3] = outward(twist.angular).into();
        let error = self.difference([x, y, z, a, b, c], (self.methods.velocity)(q, qd).to_array());
        assert!(error < 2.0 * ROUNDING * N as f64, "{} at {q:?}: jacobian_tool {error:e}", self.name);
    }

    /// Product of the singular values of the rows that the file's task counts. Each of them is off by roundings of the
    /// largest, where several vanish as where none does.
    fn manipulability(&self, q: &Joints<N>) {
        let jacobian = self.chain.jacobian(q).unwrap();
        let turning = jacobian.fixed_rows::<3>(3);
        // Rates of the point, and of turns about these axes.
        let about = |axes: &[nalgebra::Vector3<f64>]| {
            DMatrix::from_fn(3 + axes.len(), N, |row, joint| match row.checked_sub(3) {
                None => jacobian[(row, joint)],
                Some(axis) => axes[axis].dot(&turning.column(joint)),
            })
        };
        let matrix = match self.counted {
            Counted::Rows(counted) => jacobian.select_rows(counted),
            // The tool's angle turns about the axis of the pitch joints, which joint 2 is one of.
            Counted::Angle => about(&[turning.column(1).into_owned()]),
            Counted::Axis(axis) => about(&across(&tool_axis(&self.chain.forward(q).unwrap(), axis))),
        };
        let values = matrix.singular_values();
        let off = ROUNDING * largest(values.iter().copied());
        let expected: f64 = values.iter().product();
        let most: f64 = values.iter().map(|value| value + off).product();
        let found = (self.methods.manipulability)(q);
        let error = (found - expected).abs();
        assert!(error <= most - expected, "{} at {q:?}: manipulability {found:e}, {expected:e}", self.name);
    }
}

/// Single precision beside double at the same joint values and rates, these up to 1 rad/s.
fn check_single<S: denhart::Arm<f32, N> + Default, A: Specified<N>, const N: usize>() {
    let (single, double) = (S::default(), A::default());
    let reach = reach(&A::TABLE, &A::LIMITS);
    let space = Space::new(&A::JOINT_KINDS, &A::LIMITS, reach);
    let mut random = Random::named(A::NAME);
    let tolerance = SINGLE * (N + 2 * N * N) as f64;
    for _ in 0..200 {
        let [q, qd, qdd] = [(); 3].map(|()| space.random(&mut random).map(|x| (0.3 * x) as f32));
        let wide = |q: [f32; N]| q.map(f64::from);
        let found = single.acceleration(&q, &qd, &qdd).to_array();
        let expected = double.acceleration(&wide(q), &wide(qd), &wide(qdd)).to_array();
        let error = (0..6).map(|k| (f64::from(found[k]) - expected[k]) / if k < 3 { reach } else { 1.0 });
        let error = largest(error);
        assert!(error < tolerance, "{} at {q:?}: {error:e}", A::NAME);
        let velocities = single.link_velocities(&q, &qd).map(|twist| twist.to_array());
        for (found, expected) in velocities.iter().zip(double.link_velocities(&wide(q), &wide(qd))) {
            let expected = expected.to_array();
            let error = (0..6).map(|k| (f64::from(found[k]) - expected[k]) / if k < 3 { reach } else { 1.0 });
            assert!(largest(error) < tolerance, "{} at {q:?}", A::NAME);
        }
    }
}

/// Derivative at 0 by central differences of steps 1/4 to 1/32 and Richardson's extrapolation.
fn extrapolated(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let difference = |h: f64| -> Vec<f64> { f(h).iter().zip(f(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect() };
    let mut table: Vec<Vec<f64>> = [0.25, 0.125, 0.0625, 0.03125].map(difference).to_vec();
    let mut weight = 1.0;
    while table.len() > 1 {
        weight *= 4.0;
        table = table
            .windows(2)
            .map(|pair| {
                pair[1].iter().zip(&pair[0]).map(|(fine, coarse)| fine + (fine - coarse) / (weight - 1.0)).collect()
            })
            .collect();
    }
    table.remove(0)
}

/// Components that the task of an arm counts.
#[derive(Debug, Clone, Copy)]
enum Counted {
    /// Rows of the Jacobian.
    Rows(&'static [usize]),
    /// The point, and the turn about the pitch axis.
    Angle,
    /// The point, and the two turns across an axis of the tool: 0 for x to 2 for z.
    Axis(usize),
}

impl Counted {
    /// By the task in the text of an arm's file.
    fn of(text: &str) -> Self {
        let inverse = text.lines().find_map(|line| line.strip_prefix("inverse: {task: ")).unwrap_or("pose");
        match inverse.split([',', '}']).next().unwrap_or(inverse) {
            "position" => Self::Rows(&[0, 1, 2]),
            "planar_position" => Self::Rows(&[0, 1]),
            "planar_pose" => Self::Rows(&[0, 1, 5]),
            "position_angle" => Self::Angle,
            "position_axis" => {
                Self::Axis(["axis: x", "axis: y", "axis: z"].iter().position(|axis| inverse.contains(axis)).unwrap())
            }
            "pose" => Self::Rows(&[0, 1, 2, 3, 4, 5]),
            other => panic!("task {other}"),
        }
    }
}

/// The methods of an arm by its type.
macro_rules! methods {
    ($Robot:ident) => {
        Methods {
            velocity: |q, qd| $Robot.velocity(q, qd),
            acceleration: |q, qd, qdd| $Robot.acceleration(q, qd, qdd),
            jacobian_dot: |q, qd| $Robot.jacobian_dot(q, qd),
            jacobian_tool: |q| $Robot.jacobian_tool(q),
            link_velocities: |q, qd| $Robot.link_velocities(q, qd),
            link_accelerations: |q, qd, qdd| $Robot.link_accelerations(q, qd, qdd),
            manipulability: |q| $Robot.manipulability(q),
        }
    };
}

macro_rules! motion_tests {
    ($($name:ident $Type:ident $dof:tt $kind:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            use denhart_tests::arms::$Type as Robot;
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join($file);
            let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            Arm::<$dof>::new::<Robot>(&text, methods!(Robot)).check();
        }
    )*};
}

mod arms {
    use super::{Arm, Methods, Path};
    denhart_tests::published_arms!(motion_tests);
}

macro_rules! pointing {
    ($yaml:literal) => {
        /// An arm that places the tool point and points the tool's y axis, with base and tool.
        #[derive(Debug, Clone, Copy, Default, denhart::Arm)]
        #[arm(yaml = $yaml)]
        struct Pointing;

        impl Specified<5> for Pointing {
            const NAME: &'static str = "pointing";
            const TABLE: DhTable = Pointing::DH;
            const TASK: Task = Task::new(Kind::PositionAxis(1));
        }

        #[test]
        fn an_arm_that_points() {
            Arm::<5>::new::<Pointing>($yaml, methods!(Pointing)).check();
        }
    };
}

pointing! { "
name: pointing
convention: standard
units: {length: m, angle: deg}
inverse: {task: position_axis, axis: y, require: true}
base: {xyz: [0.1, -0.25, 0.08], rpy: [10, -35, 120]}
tool: {xyz: [0.015, -0.02, 0.03], rpy: [50, 20, -70]}
joints:
  - {a: 0.05, alpha: -90, d: 0.35, theta: 0}
  - {a: 0.3, alpha: 0, d: 0, theta: 0}
  - {a: 0.25, alpha: 0, d: 0, theta: 0}
  - {a: 0, alpha: -90, d: 0, theta: -90}
  - {a: 0, alpha: 0, d: 0.15, theta: 0}
" }

macro_rules! single_tests {
    ($($name:ident $Single:ident $Double:ident $file:literal;)*) => {$(
        #[test]
        fn $name() {
            super::check_single::<denhart_tests::arms::$Single, denhart_tests::arms::$Double, 6>();
        }
    )*};
}

mod single {
    denhart_tests::single_arms!(single_tests);
}
