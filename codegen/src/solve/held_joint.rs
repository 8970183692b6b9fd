//! Six joints of any structure: one joint is held at the real roots of a polynomial, the other five follow.
//!
//! An arm without three consecutive axes that meet or are parallel has no closed form in stages. Its chain goes as numbers
//! to the solvers of [`denhart_core`], which generated code calls as well. Five joints become six with a virtual one behind
//! the tool: for a direction it turns about the tool's axis, for a pose its value has to be 0.

use std::f64::consts::{FRAC_PI_2, PI};

use denhart_core::general::{Cut, Cuts, General};
use denhart_core::meet::{Meet, Structure};
use denhart_core::slides::Slides;
use denhart_core::{Chain as NumericChain, Transform as NumericTransform, choice};

use super::deciding_axes::{AxesRelation, DecidingAxes};
use super::loop_chain::LoopChain;
use super::plan::Plan;
use super::rank::{self, ToolMotion};
use super::task::{Given, Goal, Outline, PlanTask};
use super::tasks::{pose_of_five, position_axis};
use super::unsupported::Unsupported;
use crate::model::chain::Chain;
use crate::model::geometry::Geometry;
use crate::model::numeric::Transform;
use crate::model::{Axis, Model, Redundant, Task};

/// An inverse that holds a joint.
#[derive(Debug, Clone)]
pub struct HeldJointPlan {
    /// The task, with what is given beside the target.
    pub task: PlanTask,
    /// The number of the arm's joints.
    pub joints: usize,
    /// Reach of the arm, length unit.
    pub reach: f64,
    /// The six joints that are solved, between their links.
    pub chain: SixJoints,
    /// The solver.
    pub method: Method,
    /// Why there is no closed form in stages.
    pub no_stages: Unsupported,
    /// The plan of a measured arm's table, where the signs of its margins name the branches.
    pub names: Option<Box<Plan>>,
    /// How far the links of a measured arm are off the table, relative to reach and in rad.
    pub off_table: Option<f64>,
}

/// The solver of an inverse that holds a joint.
#[derive(Debug, Clone, PartialEq)]
pub enum Method {
    /// Two neighboring axes meet, two neighboring axes are parallel.
    Meet {
        /// Which ones.
        structure: Structure,
        /// The constants; none where a link that they depend on is known in the call only.
        constants: Option<Box<Meet<f64>>>,
    },
    /// Two of the six joints slide.
    Slides {
        /// The joints t, x, y, z that turn, in the order of the ring. The first one is held.
        turning: [usize; 4],
        /// The joints that slide, in the order of the ring.
        prismatic: [usize; 2],
    },
    /// Any structure, of which one joint may slide.
    General {
        /// Which joints are held.
        cuts: Cuts,
        /// The constants; none where a link is known in the call only, or the first cut has the target among its constants.
        constants: Option<Box<General>>,
    },
}

/// `T = C0 M1 C1 M2 C2 .. M6 C6` of the six joints that are solved. A joint whose value is given is a part of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct SixJoints {
    /// C0 to C6.
    pub links: Vec<Link>,
    /// The joints of the arm that are solved, from 0. With five of them the sixth joint of the chain is a virtual one.
    pub solved: Vec<usize>,
    /// Which of them slide.
    pub is_prismatic: [bool; 6],
}

/// `first M(q) after M(q) after ..` of the joints whose value is given, if any.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Before the first given joint.
    pub first: Transform,
    /// The given joints in order.
    pub given: Vec<GivenJoint>,
}

/// A joint whose value is given, and the constant behind it.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenJoint {
    /// The joint of the arm, from 0.
    pub joint: usize,
    /// True for a joint that slides.
    pub is_prismatic: bool,
    /// The constant transform behind it.
    pub after: Transform,
}

/// The value of given joints, rad or the file's unit, at which a structure is looked at: special for no arm.
const GENERIC: f64 = 0.7;

/// The plan of an arm for which there are no stages.
///
/// # Errors
/// `no_stages`, if the arm has not the joints that its task needs, is singular everywhere, or has lengths that are known at
/// run time only.
pub fn plan(
    model: &Model,
    chain: &Chain,
    geometry: &Geometry,
    no_stages: Unsupported,
) -> Result<HeldJointPlan, Unsupported> {
    let asked = asked(model, chain, geometry);
    let Some((task, six, method)) = asked.and_then(|(task, six)| Some((task, six.clone(), Method::of(&six)?))) else {
        return Err(no_stages);
    };
    Ok(HeldJointPlan {
        task,
        joints: model.joints.len(),
        reach: geometry.reach,
        chain: six,
        method,
        no_stages,
        names: None,
        off_table: None,
    })
}

/// The task for which an arm without stages has an inverse.
pub fn goal(model: &Model, chain: &Chain, geometry: &Geometry) -> Option<Goal> {
    asked(model, chain, geometry).map(|(task, _)| task.goal)
}

/// The plan of the table of a measured arm, where two of its axes meet and two are parallel: the other structures take as
/// long on the arm itself.
pub fn plan_of_table(
    model: &Model,
    chain: &Chain,
    geometry: &Geometry,
    no_stages: Unsupported,
) -> Option<HeldJointPlan> {
    let meets = holding(model, chain, geometry, &model.inverse.redundant)? == Holding::Meet;
    if meets { plan(model, chain, geometry, no_stages).ok() } else { None }
}

/// The task of the file and its six joints; `None` if no joint of them can be held.
fn asked(model: &Model, chain: &Chain, geometry: &Geometry) -> Option<(PlanTask, SixJoints)> {
    six_joints(model, chain, geometry, &model.inverse.redundant)
}

/// The task of the file and the six joints beside those that are given; `None` if no joint of them can be held.
fn six_joints(model: &Model, chain: &Chain, geometry: &Geometry, given: &Redundant) -> Option<(PlanTask, SixJoints)> {
    let joints = LoopChain::new(model, chain, geometry.reach, given);
    let (task, joints, addition) = closed(model, joints)?;
    let whole = addition.to(LoopChain::new(model, chain, geometry.reach, &Redundant::default()));
    let six = SixJoints::of(&whole, given, joints.reach)?;
    Some((task, six.gathered()))
}

/// The task of the file, the chain that has six joints for it, and what was added; `None` if no joint of them can be held.
fn closed(model: &Model, joints: LoopChain) -> Option<(PlanTask, LoopChain, Addition)> {
    let request = &model.inverse;
    if joints.given.values.contains(&Given::ArmAngle) {
        return None;
    }
    let candidates = match (request.task, joints.loop_joints.len()) {
        (None | Some(Task::Pose), 6) => vec![(PlanTask::new(Goal::Pose, joints.given.clone()), Addition::Nothing)],
        (_, 5) if pose_of_five::is_asked(model, &joints) => vec![(pose_of_five::task(&joints), Addition::Turn)],
        // Without a named task a joint is given that a pose needs: the reason says so.
        (None, 5) if !joints.given.is_empty() => Vec::new(),
        (None | Some(Task::PositionAxis), 5) => {
            let axes = request.axis.map_or_else(|| vec![Axis::Z, Axis::X, Axis::Y], |axis| vec![axis]);
            let task = |axis: Axis| PlanTask::new(Goal::PositionAxis { column: axis.column() }, joints.given.clone());
            axes.into_iter().map(|axis| (task(axis), Addition::About(axis))).collect()
        }
        _ => Vec::new(),
    };
    candidates.into_iter().find_map(|(task, addition)| {
        let chain = addition.to(joints.clone());
        can_hold_a_joint(model, &chain).then_some((task, chain, addition))
    })
}

/// Virtual joint behind the tool.
#[derive(Debug, Clone, Copy)]
enum Addition {
    /// None.
    Nothing,
    /// A turn about an axis of the tool, which the task leaves open.
    About(Axis),
    /// A turn that has to be 0.
    Turn,
}

impl Addition {
    fn to(self, mut chain: LoopChain) -> LoopChain {
        match self {
            Addition::Nothing => {}
            Addition::About(axis) => position_axis::turn(&mut chain, axis),
            Addition::Turn => pose_of_five::turn(&mut chain),
        }
        chain
    }
}

/// Returns true if a plan that holds a joint takes a choice of that joint.
pub fn takes_a_choice(model: &Model, chain: &Chain, geometry: &Geometry) -> bool {
    asked(model, chain, geometry).is_some_and(|(_, six)| {
        let slides = six.is_prismatic.iter().filter(|slides| **slides).count();
        slides < 2 && Structure::of(&six.at(&[]), six.known()).is_none()
    })
}

/// Returns true if the task of the file has an inverse that holds a joint, with the given joints of `joints`.
pub fn is_covered(model: &Model, joints: LoopChain) -> bool {
    closed(model, joints).is_some()
}

/// How a joint of six can be held, as far as that is known without a choice of the joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holding {
    /// [`Method::Slides`].
    Slides,
    /// [`Method::Meet`].
    Meet,
    /// [`Method::General`].
    General,
}

/// How the six joints beside those that are given are solved; `None` if no joint of them can be held.
pub fn holding(model: &Model, chain: &Chain, geometry: &Geometry, given: &Redundant) -> Option<Holding> {
    let (_, six) = six_joints(model, chain, geometry, given)?;
    let slides = six.is_prismatic.iter().filter(|slides| **slides).count();
    Some(match Structure::of(&six.at(&[]), six.known()) {
        _ if slides == 2 => Holding::Slides,
        Some(_) => Holding::Meet,
        None => Holding::General,
    })
}

/// Returns true for a chain of six joints with constant links that is not singular everywhere.
fn can_hold_a_joint(model: &Model, joints: &LoopChain) -> bool {
    let slides = joints.loop_joints.iter().filter(|slot| !slot.revolute).count();
    model.parameters.is_empty()
        && joints.loop_joints.len() == 6
        && slides <= 2
        && rank::check(joints, ToolMotion::Pose).is_ok()
}

/// Cuts of a chain of which no cut serves where a link of [`Meet`] is short. A call asks further ones, and rings beside the
/// chain's own.
const LAST: Cuts = Cuts { first: Cut::OF_ARM[0], second: None, third: None };

/// Round values of a given joint, rad or units of length.
const ROUND: [f64; 4] = [0.0, FRAC_PI_2, PI, -FRAC_PI_2];

/// A round value of the given joints with which a link of [`Meet`] is short for a structure, as where a third axis passes
/// through the point in which two meet.
fn vanishes_at(six: &SixJoints, structure: &Structure) -> Option<f64> {
    let is_short = |angle: &f64| {
        let chain = six.at(&vec![*angle; six.given()]);
        let meet = Meet::of(structure, &structure.ring(&chain.links, &chain.pose(&[GENERIC; 6])));
        !meet.is_some_and(|meet| meet.has_long_links())
    };
    ROUND.into_iter().find(is_short).filter(|_| six.given() > 0)
}

impl Method {
    /// The solver of a chain; `None` if no joint can be held.
    fn of(six: &SixJoints) -> Option<Self> {
        let chain = six.at(&[]);
        if six.is_prismatic.iter().filter(|slides| **slides).count() == 2 {
            let somewhere = six.at(&vec![GENERIC; six.given()]);
            let Slides { turning, prismatic, .. } = Slides::of(&somewhere)?;
            return Some(Method::Slides { turning, prismatic });
        }
        let is_constant = six.given() == 0;
        if let Some(structure) = Structure::of(&chain, six.known()) {
            // With cuts, the call asks for the structure first.
            if let Some(angle) = vanishes_at(six, &structure) {
                let cuts = choice::choose_given(&|_| six.at(&vec![angle; six.given()]));
                return Some(Method::General { cuts: cuts.unwrap_or(LAST), constants: None });
            }
            let ring = structure.ring(&chain.links, &NumericTransform::IDENTITY);
            let constants = structure.is_constant.then(|| Meet::of(&structure, &ring)).flatten().map(Box::new);
            return Some(Method::Meet { structure, constants });
        }
        let slides: Vec<bool> = six.given_joints().map(|joint| joint.is_prismatic).collect();
        let cuts = choice::choose_given(&|angle| {
            // A given displacement is a part of the reach, as an angle is a part of half a turn.
            let values: Vec<f64> =
                slides.iter().map(|slides| angle() * if *slides { 0.5 * chain.reach / PI } else { 1.0 }).collect();
            six.at(&values)
        })?;
        // The constants of a cut of the target are computed in the call.
        let is_constant = is_constant && !cuts.first.is_of_target();
        let constants = if is_constant { Some(Box::new(General::of(&chain, &cuts)?)) } else { None };
        Some(Method::General { cuts, constants })
    }
}

/// Up to this distance from its table the stages of a measured arm's table give starts, before [`Method::General`]. Where one
/// of them is nearly singular, the arm's own equation finds what they miss. By itself that equation loses single roots, since
/// axes of it are nearly parallel.
const FEW_DIGITS: f64 = 1e-4;

/// Up to this distance a table that holds a joint gives the only starts.
pub(super) const NEAR_HELD_TABLE: f64 = 3e-7;

impl HeldJointPlan {
    /// The plan in stages of a measured arm's table, where it gives starts to solutions.
    pub fn stages_of_table(&self) -> Option<Plan> {
        let off = self.off_table.filter(|off| *off <= FEW_DIGITS)?;
        let plan = self.names.as_deref().filter(|_| matches!(self.method, Method::General { .. }))?;
        Some(Plan { missed: Some(off), off_table: Some(off), ..plan.clone() })
    }

    /// Task, joints, capacity and reach.
    pub fn outline(&self) -> Outline<'_> {
        let capacity = if matches!(self.method, Method::Slides { .. }) { 8 } else { 16 };
        Outline { task: &self.task, joints: self.joints, capacity, reach: self.reach }
    }

    /// Returns true if the sixth joint of the chain is a virtual one whose value has to be 0.
    pub fn lacks_a_turn(&self) -> bool {
        self.task.overdetermined
    }

    /// The joint that is named where a virtual one is free: the last that is solved.
    pub fn stands_for(&self) -> Option<usize> {
        self.chain.solved.last().copied().filter(|_| self.chain.solved.len() < 6)
    }

    /// Returns true if `f32` has enough digits for the solver.
    pub fn fits_single(&self) -> bool {
        matches!(self.method, Method::Meet { .. } | Method::Slides { .. })
    }

    /// The structure in words, one line a fact.
    pub fn describe(&self) -> Vec<String> {
        let joint = |joint: usize| self.chain.solved.get(joint).map(|joint| format!("q{}", joint + 1));
        let held = |place: usize| joint(place).unwrap_or_else(|| "the virtual turn".to_owned());
        let structure = match &self.method {
            Method::Meet { structure, .. } => {
                let [x1, ..] = structure.joints;
                let axes: Vec<String> = self.deciding_axes().into_iter().map(|axes| axes.words).collect();
                format!("{}: one equation of degree 8 in {}", axes.join(", "), held(x1))
            }
            Method::Slides { turning: [first, ..], prismatic: [a, b] } => {
                let joints = [*a.min(b), *a.max(b)].map(|place| self.chain.solved.get(place).map_or(0, |q| q + 1));
                let [a, b] = joints;
                format!("joints {a} and {b} slide: one equation of degree 4 in {}", held(*first))
            }
            Method::General { cuts, .. } => {
                let first = held(cuts.first.held());
                let others = cuts.second.into_iter().chain(cuts.third).map(|cut| held(cut.held()));
                let others: Vec<String> = others.map(|joint| format!(", in {joint} where its roots meet")).collect();
                format!("one equation of degree 8 in {first}{}", others.concat())
            }
        };
        let addition = (self.chain.solved.len() < 6).then(|| match &self.task.goal {
            Goal::PositionAxis { column } => {
                format!("a virtual joint turns the tool about its axis {}", Axis::letter(*column))
            }
            _ => "a virtual joint turns the tool: solutions are those where its value is 0".to_owned(),
        });
        let slower =
            "slower than a closed form, whose equations are of degree 2: roots are isolated, solutions verified";
        let named = self
            .names
            .as_ref()
            .map(|_| "branches have the names of the table's, by the signs of its margins".to_owned());
        let mut lines = vec![self.no_stages.alone.clone()];
        lines.extend(addition);
        lines.extend([structure, slower.to_owned()]);
        lines.extend(self.words_on_the_table());
        lines.extend(named);
        if !self.no_stages.closed.is_empty() {
            lines.push(format!("in closed form: `{}`", self.no_stages.closed.join("`, `")));
        }
        lines
    }

    /// The part that the table of a measured arm has in its inverse, in words.
    fn words_on_the_table(&self) -> Option<String> {
        let few = "has too few digits";
        match self.method {
            Method::General { .. } => self.stages_of_table().map(|_| {
                format!("the table's branches give starts, too: so near the table the equation {few} for some roots")
            }),
            // An arm that is farther off has this structure itself.
            _ => self
                .off_table
                .filter(|off| *off <= NEAR_HELD_TABLE)
                .map(|_| format!("the equation is that of the table: so near it that of the measured arm {few}")),
        }
    }

    /// The two axes that meet and the two that are parallel; none for the other methods.
    pub fn deciding_axes(&self) -> Vec<DecidingAxes> {
        let Method::Meet { structure, .. } = &self.method else { return Vec::new() };
        let [_, _, x3, x4, u, v] = structure.joints;
        let pairs = [([u, v], AxesRelation::Meet, "meet"), ([x3, x4], AxesRelation::Parallel, "are parallel")];
        let axes = |(places, relation, words): ([usize; 2], AxesRelation, &str)| {
            let joints = places.iter().filter_map(|place| self.chain.solved.get(*place)).copied().collect();
            DecidingAxes { joints, relation, words: format!("{} {words}", self.axes(places)) }
        };
        pairs.map(axes).to_vec()
    }

    /// Two axes of the chain: `axes 4 and 5`, `axis 5 and the tool's axis z`.
    fn axes(&self, places: [usize; 2]) -> String {
        let [a, b] = places.map(|place| self.chain.solved.get(place).map(|joint| joint + 1));
        let virtual_axis = match self.task.goal {
            Goal::PositionAxis { column } => format!("the tool's axis {}", Axis::letter(column)),
            _ => "the virtual axis".to_owned(),
        };
        match (a, b) {
            (Some(a), Some(b)) => format!("axes {a} and {b}"),
            (Some(own), None) | (None, Some(own)) => format!("axis {own} and {virtual_axis}"),
            (None, None) => virtual_axis,
        }
    }
}

/// Numbers below this, of lengths over reach too, are the rounding of 0.
const ROUNDING: f64 = 1e-12;

/// A link without the rounding of zeros.
fn cleaned(link: &Transform, reach: f64) -> Transform {
    let clean = |x: f64, unit: f64| if x.abs() < ROUNDING * unit { 0.0 } else { x };
    Transform { r: link.r.map(|row| row.map(|x| clean(x, 1.0))), p: link.p.map(|x| clean(x, reach)) }
}

impl SixJoints {
    /// The six joints of a chain, of which some are given.
    fn of(whole: &LoopChain, given: &Redundant, reach: f64) -> Option<Self> {
        let sample = whole.generic.samples().first()?;
        let mut six = SixJoints { links: Vec::new(), solved: Vec::new(), is_prismatic: [false; 6] };
        six.links.push(Link { first: cleaned(&whole.numeric(0, sample), reach), given: Vec::new() });
        for (place, slot) in whole.loop_joints.iter().enumerate() {
            let is_prismatic = !slot.revolute;
            // The row's theta is a part of the link behind the joint.
            let offset = Transform::rotate_z(slot.offset.sin(), slot.offset.cos());
            let after = cleaned(&offset.then(&whole.numeric(place + 1, sample)), reach);
            let own = slot.label.arm();
            match own {
                Some(joint) if given.holds(joint) => {
                    six.links.last_mut()?.given.push(GivenJoint { joint, is_prismatic, after });
                    continue;
                }
                Some(joint) => six.solved.push(joint),
                None => {}
            }
            *six.is_prismatic.get_mut(six.links.len() - 1)? = is_prismatic;
            six.links.push(Link { first: after, given: Vec::new() });
        }
        (six.links.len() == 7).then_some(six)
    }

    /// The chain with the given joints at their values, in the order of the chain.
    pub fn at(&self, given: &[f64]) -> NumericChain<f64> {
        let mut values = given.iter().copied();
        let mut links = [NumericTransform::IDENTITY; 7];
        for (place, link) in links.iter_mut().zip(&self.links) {
            *place = core(&link.first);
            for joint in &link.given {
                let value = values.next().unwrap_or(0.0);
                *place = place.then_move(joint.is_prismatic, value) * core(&joint.after);
            }
        }
        NumericChain::new(links, self.is_prismatic)
    }

    /// With the frame of each joint slid along its axis next to the frame before. No joint value changes, and lengths that
    /// cancel are gone. Links that depend on a given joint stay as they are: so do the others.
    fn gathered(mut self) -> Self {
        if self.given() == 0 {
            let chain = self.at(&[]).gathered();
            for (link, gathered) in self.links.iter_mut().zip(chain.links) {
                link.first = cleaned(&Transform { r: gathered.rotation, p: gathered.translation }, chain.reach);
            }
        }
        self
    }

    /// The links that no given joint is a part of.
    pub fn known(&self) -> [bool; 7] {
        let mut known = [true; 7];
        for (known, link) in known.iter_mut().zip(&self.links) {
            *known = link.given.is_empty();
        }
        known
    }

    /// The number of given joints.
    pub fn given(&self) -> usize {
        self.given_joints().count()
    }

    /// The given joints, in the order of the chain.
    pub fn given_joints(&self) -> impl Iterator<Item = &GivenJoint> {
        self.links.iter().flat_map(|link| &link.given)
    }
}

/// A transform as the solvers have it.
pub fn core(transform: &Transform) -> NumericTransform<f64> {
    NumericTransform { rotation: transform.r, translation: transform.p }
}
