//! The structures that are drawn: which axes meet, are parallel, slide.
//!
//! [`draw`] draws those with a closed form for the most part, [`draw_holding`] those whose inverse holds a joint.

use denhart::JointKind::{self, Prismatic, Revolute};

use super::draw::Style;
use super::table::Link;

/// Joints, the links before, between and after them, and each joint's offset and angle about its axis.
#[derive(Debug)]
pub struct Skeleton {
    pub kinds: Vec<JointKind>,
    pub links: Vec<Link>,
    pub axes: Vec<(f64, f64)>,
    /// The value of `inverse:` in the file.
    pub inverse: Option<String>,
}

type Draw = fn(&mut Style) -> Skeleton;

/// Each with its weight.
const STRUCTURES: [(&str, usize, Draw); 26] = [
    ("three of six meet", 12, |style| meeting(style, 6, false)),
    ("three of six meet, slides", 10, |style| meeting(style, 6, true)),
    ("spherical wrist", 8, spherical_wrist),
    ("three of six parallel", 12, |style| parallel(style, 6, false)),
    ("three of six parallel, slides", 8, |style| parallel(style, 6, true)),
    ("three of six in a plane, slides in it", 6, |style| in_a_plane(style, 6)),
    ("three turn, three slide", 5, three_and_three),
    ("gantry and wrist", 3, gantry),
    ("six axes at random", 2, |style| random(style, 6, 8)),
    ("three of five meet", 5, |style| meeting(style, 5, false)),
    ("three of five parallel", 5, |style| parallel(style, 5, false)),
    ("five with slides", 4, |style| {
        if style.random.below(2) == 0 { meeting(style, 5, true) } else { parallel(style, 5, true) }
    }),
    ("SCARA", 5, scara),
    ("yaw and three pitches", 4, yaw_pitches),
    ("four joints", 3, |style| random(style, 4, 4)),
    ("four joints to a point", 4, |style| asked(random(style, 4, 5), "position", style.random.below(4))),
    ("three joints to a point", 6, |style| asked_for(random(style, 3, 4), "position")),
    ("three joints", 3, |style| random(style, 3, 3)),
    ("planar", 4, planar),
    ("two joints", 2, |style| random(style, 2, 3)),
    ("one joint", 1, |style| random(style, 1, 3)),
    ("shoulder and wrist of seven", 3, |style| {
        let given = style.random.below(7);
        shoulder_and_wrist(style, given)
    }),
    ("one more joint than a wrist needs", 5, |style| one_more(style, meeting)),
    ("one more joint than parallel axes need", 4, |style| one_more(style, parallel)),
    ("seven without one given", 1, |style| random(style, 7, 6)),
    ("nearly parallel, nearly meeting", 2, nearly),
];

/// Structures without three axes that meet or are parallel, but by chance; each with its weight.
const HOLDING: [(&str, usize, Draw); 12] = [
    ("two meet and two are parallel", 4, meeting_and_parallel),
    ("six that turn", 3, |style| random(style, 6, usize::MAX)),
    ("six, one slides", 3, |style| sliding(style, 6, 1)),
    ("six, two slide", 3, |style| sliding(style, 6, 2)),
    ("seven, one given", 3, |style| given(random(style, 7, 12), style, "pose", 1)),
    ("seven that meet the next, one given", 3, |style| {
        let skeleton = meeting_the_next(style, 7);
        given(skeleton, style, "pose", 1)
    }),
    ("eight, two given", 3, |style| given(random(style, 8, 8), style, "pose", 2)),
    ("five to a point and an axis", 2, |style| {
        let axis = style.random.pick(&["x", "y", "z"]);
        Skeleton { inverse: Some(format!("{{task: position_axis, axis: {axis}}}")), ..random(style, 5, 6) }
    }),
    ("six to a point and an axis, one given", 1, |style| {
        given(random(style, 6, 8), style, "position_axis, axis: z", 1)
    }),
    ("five to a pose", 2, |style| random(style, 5, 6)),
    ("three of any kind to a point", 2, |style| asked_for(random(style, 3, 2), "position")),
    ("five to a point, two given", 2, |style| given(random(style, 5, 5), style, "position", 2)),
];

/// One arm of so many has this structure, in place of one by weight. The other arms of a seed do not change by it.
const AXIS_OF: usize = 32;
const AXIS: &str = "a point and an axis of the tool";

/// The structure of the arm of an index, by its weight.
pub fn draw(style: &mut Style, index: usize) -> (&'static str, Skeleton) {
    if index % AXIS_OF == AXIS_OF - 1 {
        return (AXIS, point_and_axis(style));
    }
    by_weight(style, &STRUCTURES)
}

/// A structure whose inverse holds a joint, by its weight.
pub fn draw_holding(style: &mut Style) -> (&'static str, Skeleton) {
    by_weight(style, &HOLDING)
}

fn by_weight(style: &mut Style, structures: &[(&'static str, usize, Draw)]) -> (&'static str, Skeleton) {
    let total = structures.iter().map(|(_, weight, _)| weight).sum();
    let mut left = style.random.below(total);
    let (name, _, draw) = structures
        .iter()
        .find(|(_, weight, _)| {
            let found = left < *weight;
            left = left.saturating_sub(*weight);
            found
        })
        .unwrap_or(&structures[0]);
    (name, draw(style))
}

/// The names, in the order of the table at the end.
pub fn names() -> impl Iterator<Item = &'static str> {
    let name = |(name, _, _): &(&'static str, usize, Draw)| *name;
    STRUCTURES.iter().map(name).chain([AXIS]).chain(HOLDING.iter().map(name))
}

fn asked_for(skeleton: Skeleton, task: &str) -> Skeleton {
    Skeleton { inverse: Some(format!("{{task: {task}}}")), ..skeleton }
}

fn asked(skeleton: Skeleton, task: &str, given: usize) -> Skeleton {
    Skeleton { inverse: Some(format!("{{task: {task}, redundant: q{}}}", given + 1)), ..skeleton }
}

/// The values of `count` joints, in any order, are given.
fn given(skeleton: Skeleton, style: &mut Style, task: &str, count: usize) -> Skeleton {
    let mut left: Vec<usize> = (1..=skeleton.kinds.len()).collect();
    let given: Vec<String> = (0..count).map(|_| format!("q{}", left.remove(style.random.below(left.len())))).collect();
    let given = if count == 1 { given.concat() } else { format!("[{}]", given.join(", ")) };
    Skeleton { inverse: Some(format!("{{task: {task}, redundant: {given}}}")), ..skeleton }
}

/// Joints of which so many slide.
fn sliding(style: &mut Style, joints: usize, slides: usize) -> Skeleton {
    let mut kinds = vec![Revolute; joints];
    let mut left: Vec<usize> = (0..joints).collect();
    for _ in 0..slides {
        kinds[left.remove(style.random.below(left.len()))] = Prismatic;
    }
    with(style, kinds)
}

/// Six joints that turn: two neighbors meet, two others are parallel.
fn meeting_and_parallel(style: &mut Style) -> Skeleton {
    let mut skeleton = random(style, 6, usize::MAX);
    let meet = style.random.below(5);
    let parallel = (meet + 2 + style.random.below(2)) % 5;
    skeleton.links[meet + 1] = Link { a: 0.0, alpha: style.twist() };
    skeleton.links[parallel + 1] = Link { a: style.link(), alpha: style.random.pick(&[0.0, 180.0]) };
    skeleton
}

/// Joints that turn; most axes meet the next one.
fn meeting_the_next(style: &mut Style, joints: usize) -> Skeleton {
    let mut skeleton = random(style, joints, usize::MAX);
    for link in &mut skeleton.links[1..joints] {
        if style.random.below(4) != 0 {
            *link = Link { a: 0.0, alpha: style.twist() };
        }
    }
    skeleton
}

/// Joints of which one in `slides` slides, with links at random.
fn random(style: &mut Style, joints: usize, slides: usize) -> Skeleton {
    let kinds = (0..joints).map(|_| if style.random.below(slides) == 0 { Prismatic } else { Revolute }).collect();
    with(style, kinds)
}

fn with(style: &mut Style, kinds: Vec<JointKind>) -> Skeleton {
    let count = kinds.len();
    let mut links = vec![Link::default()];
    links.extend((1..count).map(|_| link(style)));
    links.push(Link::default());
    let axes = (0..count).map(|_| (style.length(), style.angle())).collect();
    Skeleton { kinds, links, axes, inverse: None }
}

fn link(style: &mut Style) -> Link {
    // One in three is parallel, as in most arms.
    let alpha = if style.random.below(3) == 0 { style.angle() } else { style.twist() };
    Link { a: style.length(), alpha }
}

/// Five joints, asked for a point and the direction of an axis of the tool. The arm has a wrist of two axes, or three
/// axes that meet or are parallel.
fn point_and_axis(style: &mut Style) -> Skeleton {
    let skeleton = match style.random.below(6) {
        0 => meeting(style, 5, false),
        1 => parallel(style, 5, false),
        _ => {
            let mut skeleton = random(style, 5, 5);
            skeleton.kinds[3..].fill(Revolute);
            skeleton.links[4] = Link { a: 0.0, alpha: style.twist() };
            skeleton.links[5] = Link { a: 0.0, alpha: style.angle() };
            skeleton.axes[4].0 = style.length();
            skeleton
        }
    };
    let axis = style.random.pick(&["x", "y", "z"]);
    Skeleton { inverse: Some(format!("{{task: position_axis, axis: {axis}}}")), ..skeleton }
}

/// Three joints in a row, the first of them anywhere, are made what `make` says; one in `slides` slides.
fn three(style: &mut Style, joints: usize, slides: usize, make: fn(&mut Style, &mut Skeleton, usize)) -> Skeleton {
    let mut skeleton = random(style, joints, slides);
    let at = style.random.below(joints - 2);
    make(style, &mut skeleton, at);
    skeleton
}

/// Three axes in a row meet; of the other joints some slide.
fn meeting(style: &mut Style, joints: usize, slides: bool) -> Skeleton {
    three(style, joints, if slides { 2 } else { usize::MAX }, meet)
}

fn meet(style: &mut Style, skeleton: &mut Skeleton, at: usize) {
    skeleton.kinds[at..at + 3].fill(Revolute);
    for link in &mut skeleton.links[at + 1..at + 3] {
        *link = Link { a: 0.0, alpha: style.twist() };
    }
    skeleton.axes[at + 1].0 = 0.0;
}

/// The last three axes meet, at right angles.
fn spherical_wrist(style: &mut Style) -> Skeleton {
    let mut skeleton = random(style, 6, 12);
    meet(style, &mut skeleton, 3);
    for link in &mut skeleton.links[4..6] {
        link.alpha = style.random.pick(&[90.0, -90.0]);
    }
    // As in most arms the second and third axis are parallel.
    if style.random.below(2) == 0 {
        skeleton.links[2] = Link { a: style.link(), alpha: style.random.pick(&[0.0, 180.0]) };
    }
    skeleton
}

/// Three axes in a row are parallel; of the other joints some slide.
fn parallel(style: &mut Style, joints: usize, slides: bool) -> Skeleton {
    three(style, joints, if slides { 2 } else { usize::MAX }, line_up)
}

fn line_up(style: &mut Style, skeleton: &mut Skeleton, at: usize) {
    skeleton.kinds[at..at + 3].fill(Revolute);
    let equal = style.random.below(8) == 0;
    let first = style.link();
    for link in &mut skeleton.links[at + 1..at + 3] {
        *link = Link { a: if equal { first } else { style.link() }, alpha: style.random.pick(&[0.0, 0.0, 180.0]) };
    }
    tilt_beside(style, skeleton, at);
}

/// The axes beside joint `at` and the two after it are not parallel to these.
fn tilt_beside(style: &mut Style, skeleton: &mut Skeleton, at: usize) {
    for beside in [at, at + 3] {
        if beside > 0 && beside + 1 < skeleton.links.len() {
            skeleton.links[beside].alpha = style.twist();
        }
    }
}

/// Three joints move in a plane: axes that turn across it, slides in it.
fn in_a_plane(style: &mut Style, joints: usize) -> Skeleton {
    three(style, joints, 6, |style, skeleton, at| {
        slide_in_plane(style, skeleton, at);
        tilt_beside(style, skeleton, at);
    })
}

/// Makes joints `at` and the two after it move in one plane, one or two of them sliding in it.
fn slide_in_plane(style: &mut Style, skeleton: &mut Skeleton, at: usize) {
    let kinds = style.random.pick(&[
        [Prismatic, Revolute, Revolute],
        [Revolute, Prismatic, Revolute],
        [Revolute, Revolute, Prismatic],
        [Prismatic, Revolute, Prismatic],
    ]);
    skeleton.kinds[at..at + 3].copy_from_slice(&kinds);
    for between in 0..2 {
        let turns = kinds[between] == kinds[between + 1];
        let alpha = style.random.pick(if turns { &[0.0, 180.0] } else { &[90.0, -90.0] });
        skeleton.links[at + 1 + between] = Link { a: if turns { style.link() } else { style.length() }, alpha };
    }
    if kinds == [Revolute, Prismatic, Revolute] {
        // Both common normals of the slide lie across it and across the axes: no turn between them but half a turn.
        skeleton.axes[at + 1].1 = style.random.pick(&[0.0, 180.0]);
    }
}

/// Three joints that turn, in a row, and three that slide.
fn three_and_three(style: &mut Style) -> Skeleton {
    let at = style.random.below(4);
    let kinds = (0..6).map(|joint| if (at..at + 3).contains(&joint) { Revolute } else { Prismatic }).collect();
    with(style, kinds)
}

/// Three slides, each across the one before, and a wrist whose axes meet or do not.
fn gantry(style: &mut Style) -> Skeleton {
    let mut skeleton = with(style, vec![Prismatic, Prismatic, Prismatic, Revolute, Revolute, Revolute]);
    for link in &mut skeleton.links[1..3] {
        link.alpha = style.random.pick(&[90.0, -90.0]);
    }
    skeleton.axes[1].1 = style.random.pick(&[90.0, -90.0]);
    if style.random.below(2) == 0 {
        meet(style, &mut skeleton, 3);
    }
    skeleton
}

/// Three parallel axes and a slide along them, in any order.
fn scara(style: &mut Style) -> Skeleton {
    let at = style.random.below(4);
    let kinds = (0..4).map(|joint| if joint == at { Prismatic } else { Revolute }).collect();
    let mut skeleton = with(style, kinds);
    for link in &mut skeleton.links[1..4] {
        *link = Link { a: style.link(), alpha: style.random.pick(&[0.0, 180.0]) };
    }
    skeleton
}

/// A yaw joint and three parallel axes across it; asked for a point and the pitch, or for a pose.
fn yaw_pitches(style: &mut Style) -> Skeleton {
    let mut skeleton = with(style, vec![Revolute; 4]);
    line_up(style, &mut skeleton, 1);
    skeleton.links[1].alpha = style.random.pick(&[90.0, -90.0]);
    if style.random.below(3) == 0 {
        return asked_for(skeleton, "pose");
    }
    skeleton
}

/// Two or three joints that move in the base's xy plane.
fn planar(style: &mut Style) -> Skeleton {
    let joints = style.random.pick(&[2, 3, 3]);
    let mut skeleton = with(style, vec![Revolute; joints]);
    for link in &mut skeleton.links[1..joints] {
        *link = Link { a: style.link(), alpha: style.random.pick(&[0.0, 180.0]) };
    }
    // The last link, where the convention has one.
    skeleton.links[joints].a = style.link();
    skeleton
}

/// The first three axes meet, the last three too, with an elbow between.
fn shoulder_and_wrist(style: &mut Style, given: usize) -> Skeleton {
    let mut skeleton = with(style, vec![Revolute; 7]);
    meet(style, &mut skeleton, 0);
    meet(style, &mut skeleton, 4);
    if style.random.below(2) == 0 {
        // Without offsets at the elbow.
        for link in &mut skeleton.links[3..5] {
            *link = Link { a: 0.0, alpha: style.twist() };
        }
        skeleton.axes[2].0 = style.link();
        skeleton.axes[4].0 = style.link();
        skeleton.axes[3].0 = 0.0;
    }
    asked(skeleton, "pose", given)
}

/// A six-joint arm with a structure, and one more joint somewhere, whose value is given.
fn one_more(style: &mut Style, structure: fn(&mut Style, usize, bool) -> Skeleton) -> Skeleton {
    let slides = style.random.below(3) == 0;
    let mut skeleton = structure(style, 6, slides);
    let at = style.random.pick(&[0, 0, 1, 2, 3, 4, 5, 6]);
    let kind = if style.random.below(3) == 0 { Prismatic } else { Revolute };
    skeleton.kinds.insert(at, kind);
    let link = if at == 0 || at == 6 { Link { a: style.length(), alpha: style.twist() } } else { link(style) };
    let place = at.clamp(1, 6);
    skeleton.links.insert(place, link);
    skeleton.axes.insert(at, (style.length(), style.angle()));
    asked(skeleton, "pose", at)
}

/// Three axes that are parallel or meet but for little: no closed form, or one that must not be.
fn nearly(style: &mut Style) -> Skeleton {
    let little = style.random.pick(&[1e-3, 1e-5, 1e-7, 1e-9, 1e-12]);
    if style.random.below(2) == 0 {
        let mut skeleton = parallel(style, 6, false);
        let at = 1 + style.random.below(5);
        skeleton.links[at].alpha += little;
        skeleton
    } else {
        let mut skeleton = meeting(style, 6, false);
        let at = 1 + style.random.below(5);
        skeleton.links[at].a += little * style.link().abs();
        skeleton
    }
}
