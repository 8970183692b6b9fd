//! Colors: on a terminal, and nowhere else.

use crate::{arm_file, command};

const ESCAPE: u8 = 0x1b;

/// Standard output and standard error together.
fn bytes(arguments: &[&str], environment: &[(&str, &str)]) -> Vec<u8> {
    let output = command(arguments).envs(environment.iter().copied()).output().unwrap();
    [output.stdout, output.stderr].concat()
}

#[test]
fn messages_flags_and_help_have_colors_that_no_pipe_sees() {
    let broken = arm_file("colors.yaml", "name: broken\nconvention: standrad\n");
    let warned = "name: bent\nconvention: standard\njoints:\n  - {a: 1, alpha: 0, d: 0, theta: 0}\n";
    let warned = arm_file("warned.yaml", warned);
    let (broken, warned) = (broken.to_str().unwrap(), warned.to_str().unwrap());
    let red = "\u{1b}[1m\u{1b}[31m";
    let (yellow, green) = ("\u{1b}[1m\u{1b}[33m", "\u{1b}[1m\u{1b}[32m");
    for (arguments, colored) in [
        (&["check", broken][..], format!("{red}error:\u{1b}[0m {broken}:2:13")),
        (&["expand", broken], format!("   = {green}help:\u{1b}[0m did you mean")),
        (&["check", warned], format!("{warned}:1:1: {yellow}warning:\u{1b}[0m no `units`")),
        (&["check", "specs/pumma560.yaml"], format!("\n{green}help:\u{1b}[0m did you mean")),
        (&["fk"], format!("{red}error:\u{1b}[0m no subcommand")),
        (&["inverse", "specs/ur5.yaml", "--nera", "3"], format!("{red}error:\u{1b}[0m unexpected argument")),
        (&["inverse", "specs/ur5.yaml", "--q", "1 1 1 1 1 1"], "\u{1b}[32mEXACT\u{1b}[0m".to_owned()),
        (&["forward", "--help"], "\u{1b}[1m--q\u{1b}[0m".to_owned()),
    ] {
        let forced = bytes(arguments, &[("CLICOLOR_FORCE", "1")]);
        assert!(String::from_utf8(forced.clone()).unwrap().contains(&colored), "{}", forced.escape_ascii());
        let plain: String = anstream::adapter::strip_str(std::str::from_utf8(&forced).unwrap()).to_string();
        for environment in [&[][..], &[("NO_COLOR", "1"), ("TERM", "xterm-256color")]] {
            let piped = bytes(arguments, environment);
            assert!(!piped.contains(&ESCAPE), "{arguments:?}: {}", piped.escape_ascii());
            assert_eq!(String::from_utf8(piped).unwrap(), plain);
        }
    }
}

/// Output for programs has no colors, even where they are forced.
#[test]
fn code_json_and_csv_have_no_colors() {
    for arguments in [
        &["expand", "specs/planar2r.yaml"][..],
        &["check", "--json", "specs/ur5.yaml"],
        &["inverse", "specs/ur5.yaml", "--q", "1 1 1 1 1 1", "--json"],
        &["arms", "--json"],
        &["new", "crane", "-o", "-"],
        &["trace", "specs/planar2r.yaml", "--law", "t, t", "--to", "1", "--step", "1"],
        &["schema"],
        &["completions", "bash"],
        &["man"],
    ] {
        let forced = bytes(arguments, &[("CLICOLOR_FORCE", "1")]);
        assert!(forced.len() > 50 && !forced.contains(&ESCAPE), "{arguments:?}");
    }
}
