//! Joint values over time, as CSV and JSON.

use std::io::Write;

use denhart::Residual;
use denhart_dynamic::DynamicArm;
use denhart_tools::follow::{Keep, Motion, Obstacle, Row};
use serde_json::{Value, json};

use crate::Failure;
use crate::numbers::{Units, printed, short};

/// The answer of the command.
pub struct Answer {
    pub keep: Keep,
    pub motion: Motion,
}

/// The form of an answer.
#[derive(Clone, Copy)]
pub struct Form {
    pub units: Units,
    pub json: bool,
    /// The path's parameter is a time.
    pub is_timed: bool,
}

impl Form {
    fn joints(self, arm: &DynamicArm, values: &[f64]) -> Vec<f64> {
        arm.joint_kinds().iter().zip(values).map(|(kind, value)| self.units.of_joint(*kind, *value)).collect()
    }
}

impl Answer {
    /// The rows, or the reason why there are none.
    ///
    /// # Errors
    /// No way to print.
    pub fn write(&self, arm: &DynamicArm, form: Form, out: &mut dyn Write) -> Result<(), Failure> {
        match form.json {
            true => self.write_json(arm, form, out)?,
            false => self.write_csv(arm, form, out)?,
        }
        Ok(out.flush()?)
    }

    fn write_csv(&self, arm: &DynamicArm, form: Form, out: &mut dyn Write) -> Result<(), Failure> {
        if self.motion.rows.is_empty() {
            return Ok(());
        }
        let rest = ["at", "branch", "tracking", "off_by_position", "off_by_orientation"];
        let names: Vec<&str> = ["t"].into_iter().chain(arm.joint_names()).chain(rest).collect();
        writeln!(out, "{}", names.join(","))?;
        for Row { t, q, at, branch, tracking, off, .. } in &self.motion.rows {
            let q: Vec<String> = form.joints(arm, q).iter().map(|value| printed(*value)).collect();
            let [position, orientation] = [off.position, form.units.of(off.orientation)].map(printed);
            let (t, at, q) = (printed(*t), printed(*at), q.join(","));
            writeln!(out, "{t},{q},{at},\"{branch}\",{tracking},{position},{orientation}")?;
        }
        Ok(())
    }

    fn write_json(&self, arm: &DynamicArm, form: Form, out: &mut dyn Write) -> Result<(), Failure> {
        let obstacle = self
            .motion
            .obstacle
            .as_ref()
            .map(|obstacle| json!({ "at": obstacle.at, "branch": obstacle.branch, "reason": obstacle.reason }));
        let changes: Vec<Value> =
            self.motion.changes().map(|(t, from, to)| json!({ "t": t, "from": from, "to": to })).collect();
        let head = [
            ("arm", json!(arm.model().name)),
            ("length_unit", json!(arm.length_unit().to_string())),
            ("angle_unit", json!(form.units.symbol())),
            ("keep", json!(if self.keep == Keep::Path { "path" } else { "time" })),
            ("duration", json!(self.motion.rows.last().map(|row| row.t))),
            ("path_is_timed", json!(form.is_timed)),
            ("branch_changes", json!(changes)),
            ("obstacle", json!(obstacle)),
        ];
        writeln!(out, "{{")?;
        for (key, value) in head {
            writeln!(out, "  {}: {value},", json!(key))?;
        }
        write!(out, "  \"rows\": [")?;
        for (number, row) in self.motion.rows.iter().enumerate() {
            let off = json!({ "position": row.off.position, "orientation": form.units.of(row.off.orientation) });
            let row = json!({
                "t": row.t,
                "q": form.joints(arm, &row.q),
                "at": row.at,
                "branch": row.branch,
                "tracking": row.tracking,
                "off": off,
            });
            write!(out, "{}\n    {row}", if number == 0 { "" } else { "," })?;
        }
        writeln!(out, "\n  ]\n}}")?;
        Ok(())
    }

    /// The lines for people: the time, changes of the branch, deviations, and why the path does not go on.
    pub fn said(&self, arm: &DynamicArm, form: Form) -> Vec<String> {
        let mut lines = Vec::new();
        if let Some(last) = self.motion.rows.last() {
            let path = if form.is_timed { format!(", of a path of {} s", short(last.at)) } else { String::new() };
            lines.push(format!("{} s{path}", short(last.t)));
            for (t, from, to) in self.motion.changes() {
                lines.push(format!("at {} s from the branch {from} to {to}", short(t)));
            }
        }
        let most = |of: fn(&Residual<f64>) -> f64| self.motion.rows.iter().map(|row| of(&row.off)).fold(0.0, f64::max);
        let away: Vec<&Row> = self.motion.away().collect();
        if let [first, ..] = away[..] {
            let (position, orientation) = (most(|off| off.position), most(|off| off.orientation));
            lines.push(format!(
                "off the path from {} s on, in {} of {} rows, by at most {} {} and {} {}",
                short(first.t),
                away.len(),
                self.motion.rows.len(),
                short(position),
                arm.length_unit(),
                short(form.units.of(orientation)),
                form.units.symbol(),
            ));
        }
        if let Some(Obstacle { at, branch, reason }) = &self.motion.obstacle {
            let at = match form.is_timed {
                true => format!("{} s", short(*at)),
                false => format!("{} {} of its length", short(*at), arm.length_unit()),
            };
            let branch = if branch.is_empty() { String::new() } else { format!(", on the branch {branch}") };
            lines.push(match self.keep {
                Keep::Path => format!(
                    "error: no continuous path beyond {at}{branch}: {reason}\n\
                     help: begin elsewhere with --start, allow more with --tolerance, or keep the time with --keep time"
                ),
                Keep::Time if self.motion.rows.is_empty() => format!("error: no motion begins: {reason}"),
                Keep::Time => format!("error: the arm is away from the path at its end{branch}: {reason}"),
            });
        }
        lines
    }
}
