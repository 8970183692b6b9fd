//! Arguments that are refused, with the command line that was probably meant.

use crate::{denhart, text};

/// The words as a shell would hand them on.
fn refused(words: &[&str]) -> String {
    let output = denhart(words);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{words:?}: {output:?}");
    text(&output.stderr)
}

#[test]
fn words_of_other_tools_lead_to_those_of_this_one() {
    for (words, mistake, help) in [
        (&["fk"][..], "no subcommand `fk`: here it is `forward`", "`denhart help forward` shows its arguments"),
        (&["ik"], "no subcommand `ik`: here it is `inverse`", "`denhart help inverse` shows its arguments"),
        (
            &["fk", "arm.yaml", "--q", "1, 2"],
            "no subcommand `fk`: here it is `forward`",
            "denhart forward arm.yaml --q \"1, 2\"",
        ),
        (
            &["inverse", "arm.yaml", "--target", "1 2 3"],
            "no option `--target` of `inverse`: here it is `--pose`",
            "denhart inverse arm.yaml --pose \"1 2 3\"",
        ),
        (
            &["inverse", "my arm.yaml", "--target=1 2 3", "--units=rad"],
            "no option `--target` of `inverse`: here it is `--pose`",
            "denhart inverse \"my arm.yaml\" --pose \"1 2 3\" --units=rad",
        ),
    ] {
        assert_eq!(refused(words), format!("error: {mistake}\nhelp: {help}\n"));
    }
    let all = refused(&["ik", "arm.yaml", "--target", "1", "2", "3"]);
    assert_eq!(all.lines().filter(|line| line.starts_with("error: ")).count(), 3, "{all}");
    assert!(all.ends_with("help: quote the list: denhart inverse arm.yaml --pose \"1 2 3\"\n"), "{all}");
}

#[test]
fn a_list_without_quotes_is_shown_with_them() {
    for (words, count, line) in [
        ("forward a.yaml --q 0 -90 90 0 0 0", 6, "forward a.yaml --q \"0 -90 90 0 0 0\""),
        ("forward --q 0 90 -90 a.yaml --links", 3, "forward --q \"0 90 -90\" a.yaml --links"),
        ("inverse a.yaml --pose 0.3 0.1 0.4 180 0 0", 6, "inverse a.yaml --pose \"0.3 0.1 0.4 180 0 0\""),
        ("inverse a.yaml --q=[0, -90, pi/2] --json", 3, "inverse a.yaml --q \"[0, -90, pi/2]\" --json"),
        ("inverse a.yaml --q 1,2 --near 0 1e-1", 2, "inverse a.yaml --q 1,2 --near \"0 1e-1\""),
        ("inverse a.yaml --quat 1 2 3 1 0 0 0", 7, "inverse a.yaml --quat \"1 2 3 1 0 0 0\""),
        ("trace a.yaml --law t, 2t --to 1 --step 1", 2, "trace a.yaml --law \"t, 2t\" --to 1 --step 1"),
    ] {
        let said = refused(&words.split(' ').collect::<Vec<_>>());
        assert!(said.contains(&format!("takes one argument, and its list is {count} arguments\n")), "{said}");
        assert!(said.ends_with(&format!("\nhelp: quote the list: denhart {line}\n")), "{said}");
    }
    // The line as a whole is wrong in another way, too.
    let said = refused(&["forward", "--q", "0", "-90", "90"]);
    assert!(said.contains("help: quote the list: --q \"0 -90 90\"; `denhart help forward` shows"), "{said}");
}

/// The help names a line that runs.
#[test]
fn the_line_of_the_help_is_accepted() {
    let said = refused(&["fk", "specs/planar2r.yaml", "--q", "10", "-20"]);
    let line = said.trim_end().rsplit("denhart ").next().unwrap();
    assert_eq!(line, "forward specs/planar2r.yaml --q \"10 -20\"");
    let (command, list) = line.split_once(" \"").unwrap();
    let words: Vec<&str> = command.split(' ').chain([list.trim_end_matches('"')]).collect();
    assert!(denhart(&words).status.success());
}

#[test]
fn other_mistakes_keep_their_message() {
    for (words, part) in [
        (&["fkk"][..], "unrecognized subcommand 'fkk'"),
        (&["inverse", "a.yaml", "--nera", "3"], "a similar argument exists: '--near'"),
        (&["expand", "a.yaml", "1", "2"], "unexpected argument '1'"),
        (&["forward", "a.yaml"], "--q <VALUES>"),
    ] {
        let said = refused(words);
        assert!(said.contains(part) && !said.contains("help: "), "{said}");
    }
}
