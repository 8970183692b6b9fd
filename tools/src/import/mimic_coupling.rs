//! The mimic joints of a URDF as the `coupling` of an arm file: which motor moves which joint.
//!
//! A motor is a joint that mimics none. The values of the table's joints are `w = M u + c` of the motors' values u.
//! Joints on one line of which one mimics are one row of the table, whose value is their sum. An arm file says
//! `u = A w + b`, so M has to be square and invertible.

use std::f64::consts::PI;

use denhart_codegen::model::rational::inverse;

use super::axes::{Axes, Axis, axes};
use super::path::Path;
use super::rigid::{ROUNDING, cross, dot, length, sub};
use super::urdf::{Joint, Kind, Robot};

/// A motor: a joint of the URDF with a value of its own.
#[derive(Debug, Clone)]
pub struct Motor {
    pub name: String,
    /// Its name in the arm file: another one where that means another joint there.
    pub file_name: String,
    pub turns: bool,
    /// Where every joint that follows it keeps its limits.
    pub limits: Option<[f64; 2]>,
    /// The greatest one with which every joint that follows it keeps its velocity.
    pub velocity: Option<f64>,
}

impl Motor {
    /// The values that samples are taken from: the limits, else one turn or 2 m; from the only end of a range as far.
    pub fn sampled_range(&self) -> [f64; 2] {
        let free = if self.turns { PI } else { 1.0 };
        match self.limits.unwrap_or([-free, free]) {
            [low, high] if high.is_infinite() => [low, low + 2.0 * free],
            [low, high] if low.is_infinite() => [high - 2.0 * free, high],
            ends => ends,
        }
    }
}

/// The axes of the table and what moves them; axis i is named after motor i.
#[derive(Debug, Clone)]
pub struct MimicCoupling {
    pub axes: Axes,
    pub motors: Vec<Motor>,
    /// `w = matrix u + constant`
    pub matrix: Vec<Vec<f64>>,
    pub constant: Vec<f64>,
    /// Per axis, the joints of the URDF that it is the sum of.
    pub sums: Vec<Vec<String>>,
    /// The ranges of the axes that one motor drives. A sum of several motors has none.
    pub limits: Vec<Option<[f64; 2]>>,
    /// The greatest velocities of the axes that one motor drives.
    pub velocities: Vec<Option<f64>>,
}

/// A joint's value as `multiplier * motor + offset`.
#[derive(Debug, Clone)]
struct MimicLaw {
    motor: String,
    multiplier: f64,
    offset: f64,
}

/// One axis, or several on one line: the values of its joints with their signs.
struct Group {
    axis: Axis,
    terms: Vec<(String, f64, MimicLaw)>,
}

/// The value of a joint under values of the motors.
pub fn joint_value(robot: &Robot, joint: &Joint, motor: &dyn Fn(&str) -> f64) -> f64 {
    match mimic_law(robot, joint) {
        Ok(MimicLaw { motor: name, multiplier, offset }) => multiplier * motor(&name) + offset,
        Err(_) => f64::NAN,
    }
}

/// The law of a joint's motor. A mimic of a mimic follows the last one.
fn mimic_law(robot: &Robot, joint: &Joint) -> Result<MimicLaw, String> {
    let (mut at, mut multiplier, mut offset) = (joint, 1.0, 0.0);
    for _ in 0..=robot.joints.len() {
        let Some(mimic) = &at.mimic else { return Ok(MimicLaw { motor: at.name.clone(), multiplier, offset }) };
        offset += multiplier * mimic.offset;
        multiplier *= mimic.multiplier;
        at = robot
            .joints
            .iter()
            .find(|other| other.name == mimic.joint)
            .ok_or_else(|| format!("joint `{}` mimics `{}`, which is no joint", at.name, mimic.joint))?;
    }
    Err(format!("joint `{}` mimics itself by way of others", joint.name))
}

/// The coupling of a path's joints.
///
/// # Errors
/// Joints whose motion no `coupling` can say.
pub fn mimic_coupling(robot: &Robot, path: &Path) -> Result<MimicCoupling, String> {
    for passed in &path.joints {
        mimic_law(robot, passed.joint)?;
    }
    // A multiplier of 0: the joint stands still.
    let held = |joint: &Joint| mimic_law(robot, joint).ok().filter(|law| law.multiplier == 0.0).map(|law| law.offset);
    let Axes { axes: lines, tool } = axes(path, &held);
    let joint_of = |name: &str| robot.joints.iter().find(|joint| joint.name == name);
    let mut groups: Vec<Group> = Vec::new();
    let size = lines.iter().map(|axis| length(axis.point)).fold(length(tool.p), f64::max);
    for axis in lines {
        let Some(joint) = joint_of(&axis.name) else { continue };
        let law = mimic_law(robot, joint)?;
        let mimics = |name: &str| joint_of(name).is_some_and(|joint| joint.mimic.is_some());
        match groups.last_mut() {
            Some(group)
                if same_line(&group.axis, &axis, size)
                    && (mimics(&axis.name) || group.terms.iter().any(|(name, ..)| mimics(name))) =>
            {
                let sign = dot(group.axis.direction, axis.direction).signum();
                group.terms.push((axis.name, sign, law));
            }
            _ => groups.push(Group { terms: vec![(axis.name.clone(), 1.0, law)], axis }),
        }
    }
    let motors = motors(robot, &groups)?;
    let entry = |group: &Group, motor: &Motor| -> f64 {
        group
            .terms
            .iter()
            .filter(|(_, _, law)| law.motor == motor.name)
            .map(|(_, sign, law)| sign * law.multiplier)
            .sum()
    };
    let matrix = groups.iter().map(|group| motors.iter().map(|motor| entry(group, motor)).collect()).collect();
    let constant = groups.iter().map(|g| g.terms.iter().map(|(_, sign, law)| sign * law.offset).sum()).collect();
    let sums = groups.iter().map(|group| group.terms.iter().map(|(name, ..)| name.clone()).collect()).collect();
    let limits = groups.iter().map(|group| range(&motors, group)).collect();
    let velocities = groups.iter().map(|group| velocity(&motors, group)).collect();
    let axes = groups.into_iter().zip(&motors).map(|(group, motor)| Axis { name: motor.name.clone(), ..group.axis });
    let axes = Axes { axes: axes.collect(), tool };
    let mut motors = motors;
    rename(&mut motors);
    Ok(MimicCoupling { axes, motors, matrix, constant, sums, limits, velocities })
}

/// The values of a motor at which every joint that follows it keeps its limits; `multiplier * motor + offset` each.
///
/// # Errors
/// Limits that exclude each other.
fn motor_range(robot: &Robot, groups: &[Group], motor: &str) -> Result<Option<[f64; 2]>, String> {
    let limits_of = |name: &str| robot.joints.iter().find(|joint| joint.name == name).and_then(|joint| joint.limits);
    let followers = groups.iter().flat_map(|group| &group.terms).filter(|(_, _, law)| law.motor == motor);
    let of_followers = followers
        .filter(|(_, _, law)| law.multiplier != 0.0)
        .filter_map(|(name, _, law)| Some(sorted(limits_of(name)?.map(|end| (end - law.offset) / law.multiplier))));
    let all = limits_of(motor).into_iter().chain(of_followers);
    match all.reduce(|[a, b], [c, d]| [a.max(c), b.min(d)]) {
        Some([low, high]) if low > high => {
            Err(format!("joint `{motor}` and the joints that mimic it have no value within the limits of all"))
        }
        range => Ok(range),
    }
}

/// The velocity of a motor at which no joint that follows it is faster than its own.
fn motor_velocity(robot: &Robot, groups: &[Group], motor: &str) -> Option<f64> {
    let of = |name: &str| robot.joints.iter().find(|joint| joint.name == name).and_then(|joint| joint.velocity);
    let followers = groups.iter().flat_map(|group| &group.terms).filter(|(_, _, law)| law.motor == motor);
    let followers = followers.filter(|(_, _, law)| law.multiplier != 0.0);
    let each = followers.filter_map(|(name, _, law)| Some(of(name)? / law.multiplier.abs()));
    of(motor).into_iter().chain(each).reduce(f64::min)
}

/// The motor of an axis that one motor drives.
fn only_motor<'m>(motors: &'m [Motor], group: &Group) -> Option<&'m Motor> {
    let (_, _, MimicLaw { motor: name, .. }) = group.terms.first()?;
    let alone = group.terms.iter().all(|(_, _, law)| law.motor == *name);
    motors.iter().find(|motor| motor.name == *name).filter(|_| alone)
}

/// The greatest velocity of an axis that one motor drives.
fn velocity(motors: &[Motor], group: &Group) -> Option<f64> {
    let factor: f64 = group.terms.iter().map(|(_, sign, law)| sign * law.multiplier).sum();
    let velocity = only_motor(motors, group)?.velocity? * factor.abs();
    (velocity > 0.0).then_some(velocity)
}

/// The range of an axis that one motor drives.
fn range(motors: &[Motor], group: &Group) -> Option<[f64; 2]> {
    let limits = only_motor(motors, group)?.limits?;
    let sum = |of: fn(&MimicLaw) -> f64| group.terms.iter().map(|(_, sign, law)| sign * of(law)).sum::<f64>();
    let (factor, constant) = (sum(|law| law.multiplier), sum(|law| law.offset));
    Some(sorted(limits.map(|end| factor * end + constant)))
}

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    if a <= b { [a, b] } else { [b, a] }
}

fn same_line(one: &Axis, other: &Axis, size: f64) -> bool {
    let parallel = length(cross(one.direction, other.direction)) < ROUNDING;
    let apart = cross(sub(other.point, one.point), one.direction);
    one.turns == other.turns && parallel && (!one.turns || length(apart) <= ROUNDING * size.max(1.0))
}

/// One motor a row: of a joint in it that mimics none, else the one that its joints mimic.
fn motors(robot: &Robot, groups: &[Group]) -> Result<Vec<Motor>, String> {
    let mut motors: Vec<Motor> = Vec::new();
    let own =
        |group: &Group| group.terms.iter().find(|(name, _, law)| *name == law.motor).map(|(name, ..)| name.clone());
    let owned: Vec<Option<String>> = groups.iter().map(own).collect();
    for (group, own) in groups.iter().zip(&owned) {
        let free = |name: &String| !owned.contains(&Some(name.clone())) && !motors.iter().any(|m| m.name == *name);
        let name =
            own.clone().or_else(|| group.terms.iter().map(|(_, _, law)| law.motor.clone()).find(|name| free(name)));
        let first = group.terms.first();
        let Some(name) = name else {
            let (joint, motor) =
                first.map_or((String::new(), String::new()), |(name, _, law)| (name.clone(), law.motor.clone()));
            return Err(format!(
                "joint `{joint}` moves with `{motor}`, which also moves an axis of its own in this chain: \
                 two rows of one motor, which no `coupling` can say\n\
                 help: end the chain before it with --tool, or begin it after `{motor}` with --base"
            ));
        };
        let Some(joint) = robot.joints.iter().find(|joint| joint.name == name) else { continue };
        if (joint.kind == Kind::Turning) != group.axis.turns {
            return Err(format!("joint `{}` mimics `{name}`: one turns, the other slides", group.axis.name));
        }
        let limits = motor_range(robot, groups, &name)?;
        let velocity = motor_velocity(robot, groups, &name);
        motors.push(Motor { file_name: name.clone(), name, turns: group.axis.turns, limits, velocity });
    }
    // What a row takes of a motor that slides where it turns has no place in an arm file.
    for group in groups {
        for (name, _, law) in &group.terms {
            let motor = motors.iter().find(|motor| motor.name == law.motor);
            match motor {
                Some(motor) if motor.turns == group.axis.turns => {}
                Some(motor) => {
                    return Err(format!("joint `{name}` mimics `{}`: one turns, the other slides", motor.name));
                }
                None => {
                    return Err(format!(
                        "joint `{name}` follows `{}`, which is not in this chain, beside another joint on the same line\n\
                         help: name other links with --base and --tool",
                        law.motor
                    ));
                }
            }
        }
    }
    Ok(motors)
}

/// In an arm file `q2` is joint 2. Where the URDF counts otherwise, as from `q0`, all such names get another beginning.
fn rename(motors: &mut [Motor]) {
    let number = |name: &str| name.strip_prefix('q').and_then(|digits| digits.parse::<usize>().ok());
    let count = motors.len();
    let another = |(index, motor): (usize, &Motor)| {
        number(&motor.name).is_some_and(|number| number != index + 1 && (1..=count).contains(&number))
    };
    if !motors.iter().enumerate().any(another) {
        return;
    }
    let taken: Vec<String> = motors.iter().map(|motor| motor.name.clone()).collect();
    for motor in motors.iter_mut().filter(|motor| number(&motor.name).is_some()) {
        let mut name = format!("joint_{}", motor.name);
        while taken.contains(&name) {
            name.push('_');
        }
        motor.file_name = name;
    }
}

impl MimicCoupling {
    /// The joints that have another name in the file: that of the URDF, and the new one.
    pub fn renamed(&self) -> Vec<(&str, &str)> {
        let pairs = self.motors.iter().map(|motor| (motor.name.as_str(), motor.file_name.as_str()));
        pairs.filter(|(name, file_name)| name != file_name).collect()
    }

    /// True where every joint is its own motor.
    pub fn is_identity(&self) -> bool {
        let unit =
            |(i, row): (usize, &Vec<f64>)| row.iter().enumerate().all(|(j, x)| *x == f64::from(u8::from(i == j)));
        self.matrix.iter().enumerate().all(unit) && self.constant.iter().all(|x| *x == 0.0)
    }

    /// The table's joint values at values of the motors.
    pub fn joint_values(&self, motors: &[f64]) -> Vec<f64> {
        let of =
            |(row, constant): (&Vec<f64>, &f64)| constant + row.iter().zip(motors).map(|(a, u)| a * u).sum::<f64>();
        self.matrix.iter().zip(&self.constant).map(of).collect()
    }

    /// `A` and `b` of `u = A w + b`.
    ///
    /// # Errors
    /// Motors that the joints' values do not determine.
    pub fn inverted(&self) -> Result<(Vec<Vec<f64>>, Vec<f64>), String> {
        let names = || self.motors.iter().map(|motor| motor.name.as_str()).collect::<Vec<_>>().join(", ");
        let inverse = invert(&self.matrix).ok_or_else(|| {
            format!("the joints do not determine their motors {}: some move together\nhelp: name other links with --base and --tool", names())
        })?;
        let offset = inverse.iter().map(|row| 0.0 - row.iter().zip(&self.constant).map(|(a, c)| a * c).sum::<f64>());
        let offset = offset.collect();
        Ok((inverse, offset))
    }
}

/// The inverse, without what rounding of multipliers leaves of a pivot that is zero: one over it is an entry.
fn invert(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    inverse(matrix).ok().filter(|inverse| inverse.iter().flatten().all(|entry| entry.abs() < 1e9))
}

#[cfg(test)]
mod tests {
    use super::invert;

    #[test]
    fn inverses_and_singular_matrices() {
        assert_eq!(invert(&[vec![1.0, 0.0], vec![-1.0, 1.0]]), Some(vec![vec![1.0, 0.0], vec![1.0, 1.0]]));
        assert_eq!(invert(&[vec![0.0, 2.0], vec![-0.5, 0.0]]), Some(vec![vec![0.0, -2.0], vec![0.5, 0.0]]));
        assert_eq!(invert(&[vec![1.0, 1.0], vec![1.0, 1.0]]), None);
        // A product of multipliers, 0.30000000000000004, beside the number it stands for.
        assert_eq!(invert(&[vec![0.3, 1.0], vec![0.1 * 3.0, 1.0]]), None);
    }
}
