//! The arms whose files come along.

use denhart::JointKind;
use denhart_codegen::spec::nearest;
use denhart_codegen::{Errors, check};

use crate::{Arm, Error};

/// The files of `specs/`, each behind a line `=== NAME`. The test `index` of the command holds them equal and writes them.
const FILES: &str = include_str!("arms.txt");

/// A known arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// The text of its arm file, YAML.
    pub arm_file: &'static str,
}

impl Preset {
    /// The source of its numbers: the first line of the file's comment.
    #[must_use]
    pub fn source(&self) -> &'static str {
        self.arm_file.lines().next().unwrap_or_default().trim_start_matches("# ")
    }

    /// R for each joint that turns, P for each that slides, from base to tool.
    ///
    /// # Errors
    /// Mistakes in the file. A test holds that there are none; so of [`task`](Self::task).
    pub fn joints(&self) -> Result<String, Errors> {
        let kinds = Arm::of_text(self.arm_file, self.name)?.chain.kinds();
        Ok(kinds.iter().map(|kind| if *kind == JointKind::Revolute { 'R' } else { 'P' }).collect())
    }

    /// The task of its inverse in closed form; none without one.
    ///
    /// # Errors
    /// As of [`joints`](Self::joints).
    pub fn task(&self) -> Result<Option<String>, Errors> {
        Ok(check(self.arm_file, self.name)?.task)
    }
}

/// All known arms, by name.
///
/// ```
/// let ur5 = denhart_tools::presets::presets().find(|preset| preset.name == "ur5");
/// assert_eq!(ur5.map(|ur5| ur5.joints()), Some(Ok("RRRRRR".to_owned())));
/// ```
pub fn presets() -> impl Iterator<Item = Preset> {
    let files = FILES.split("=== ").filter_map(|part| part.split_once('\n'));
    files.map(|(name, arm_file)| Preset { name, arm_file })
}

/// The arm of a name.
///
/// # Errors
/// The message, with the nearest name.
pub fn preset(name: &str) -> Result<Preset, Error> {
    presets().find(|preset| preset.name == name).ok_or_else(|| {
        let meant = nearest(name, presets().map(|preset| preset.name));
        let meant = meant.map_or_else(String::new, |word| format!("did you mean `{word}`? "));
        Error::Option(format!("no arm `{name}`\nhelp: {meant}`denhart arms` lists them"))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn every_arm_is_read_and_has_a_source() {
        let mut arms = 0;
        for preset in presets() {
            arms += 1;
            assert!(preset.arm_file.contains(&format!("\nname: {}\n", preset.name)), "{}", preset.name);
            assert!(!preset.source().is_empty() && !preset.joints().unwrap().is_empty(), "{}", preset.name);
        }
        assert!(arms > 50);
    }

    #[test]
    fn an_unknown_name_is_told_with_the_nearest_one() {
        assert!(preset("ur5").is_ok());
        assert_eq!(
            preset("ur55").unwrap_err().to_string(),
            "no arm `ur55`\nhelp: did you mean `ur5`? `denhart arms` lists them"
        );
    }
}
