//! The command line that was probably meant: other words for subcommands and options, and lists without quotes.

use clap::error::ErrorKind;
use clap::{Command, Error};
use denhart_codegen::spec::WrittenAngle;

use crate::numbers::count;

/// Words of other tools for a subcommand.
const SUBCOMMANDS: [(&str, &str); 6] = [
    ("fk", "forward"),
    ("fkine", "forward"),
    ("ik", "inverse"),
    ("ikine", "inverse"),
    ("init", "new"),
    ("list", "arms"),
];
/// Words of other tools for an option of a subcommand.
const OPTIONS: [(&str, &str, &str); 6] = [
    ("forward", "--joints", "--q"),
    ("forward", "--angles", "--q"),
    ("inverse", "--joints", "--q"),
    ("inverse", "--target", "--pose"),
    ("inverse", "--goal", "--pose"),
    ("inverse", "--position", "--pose"),
];
/// Names of the values that are lists, as the help has them.
const LISTS: [&str; 3] = ["VALUES", "NUMBERS", "LAWS"];

/// A command line, corrected.
struct Corrected {
    subcommand: String,
    words: Vec<String>,
    /// Each thing that was wrong, in the order of the arguments.
    mistakes: Vec<String>,
    /// The first list that was without quotes, with its option.
    list: Option<String>,
}

/// The message for arguments that clap refuses, with the command line to type instead. None where that is not plain.
///
/// `words`: the arguments behind the name of the program. The line is shown whole if it is accepted.
pub fn suggestion(refused: &Error, words: &[String], command: &Command) -> Option<String> {
    if !matches!(refused.kind(), ErrorKind::InvalidSubcommand | ErrorKind::UnknownArgument) {
        return None;
    }
    let Corrected { subcommand, words, mistakes, list } = corrected(words, command)?;
    let (first, further) = mistakes.split_first()?;
    let line = words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ");
    let accepted =
        command.clone().try_get_matches_from([command.get_name()].into_iter().chain(words.iter().map(String::as_str)));
    let help = match (accepted.is_ok(), list) {
        (true, Some(_)) => format!("quote the list: denhart {line}"),
        (true, None) => format!("denhart {line}"),
        (false, Some(list)) => format!("quote the list: {list}; `denhart help {subcommand}` shows the other arguments"),
        (false, None) => format!("`denhart help {subcommand}` shows its arguments"),
    };
    let further: String = further.iter().map(|mistake| format!("\nerror: {mistake}")).collect();
    Some(format!("{first}{further}\nhelp: {help}"))
}

fn corrected(words: &[String], command: &Command) -> Option<Corrected> {
    let (typed, rest) = words.split_first()?;
    let mut mistakes = Vec::new();
    let renamed = SUBCOMMANDS.iter().find(|(other, _)| typed == other).map(|(_, own)| *own);
    let subcommand = renamed.unwrap_or(typed).to_owned();
    if renamed.is_some() {
        mistakes.push(format!("no subcommand `{typed}`: here it is `{subcommand}`"));
    }
    let own = command.find_subcommand(&subcommand)?;
    let known = |option: &str| {
        own.get_arguments().find(|argument| argument.get_long().is_some_and(|long| option == format!("--{long}")))
    };
    let is_list = |option: &str| {
        let names = known(option).and_then(|argument| argument.get_value_names()).unwrap_or_default();
        names.iter().any(|name| LISTS.contains(&name.as_str()))
    };
    let (mut fixed, mut list) = (vec![subcommand.clone()], None);
    let mut rest = rest.iter().peekable();
    while let Some(word) = rest.next() {
        let (typed, value) =
            word.split_once('=').map_or((word.as_str(), None), |(option, value)| (option, Some(value)));
        let synonym = OPTIONS.iter().find(|(of, other, _)| *of == subcommand && *other == typed);
        let option = synonym.filter(|_| known(typed).is_none()).map_or(typed, |(_, _, own)| own);
        if option != typed {
            mistakes.push(format!("no option `{typed}` of `{subcommand}`: here it is `{option}`"));
        }
        if !is_list(option) {
            fixed.push(value.map_or_else(|| option.to_owned(), |value| format!("{option}={value}")));
            continue;
        }
        fixed.push(option.to_owned());
        let Some(first) = value.map(str::to_owned).or_else(|| rest.next().cloned()) else { continue };
        let mut entries = vec![first];
        while let Some(next) = rest.next_if(|next| goes_on(entries.last(), next)) {
            entries.push(next.clone());
        }
        let joined = entries.join(" ");
        if entries.len() > 1 {
            mistakes.push(format!("{option} takes one argument, and its list is {}", count(entries.len(), "argument")));
            list.get_or_insert_with(|| format!("{option} {}", quoted(&joined)));
        }
        fixed.push(joined);
    }
    Some(Corrected { subcommand, words: fixed, mistakes, list })
}

/// True for a further entry of a list: a number, or anything behind a comma but an option.
fn goes_on(before: Option<&String>, word: &str) -> bool {
    let after_comma = before.is_some_and(|before| before.ends_with([',', ';']));
    let entry = word.trim_matches(['[', ']', '(', ')', '{', '}', ',', ';']).replace('\u{2212}', "-");
    let number = entry.trim_end_matches(|c: char| c.is_alphabetic() || c == '\u{b0}');
    let unit = entry.len() - number.len();
    let is_number = number.replace(',', ".").parse::<f64>().is_ok() && unit <= "degrees".len();
    (after_comma && !word.starts_with("--")) || is_number || WrittenAngle::parse(&entry).is_some()
}

/// A word as a shell takes it for one.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,+@%\\".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else if word.contains(['"', '$', '`', '!']) {
        format!("'{}'", word.replace('\'', r"'\''"))
    } else {
        format!("\"{word}\"")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_a_list_are_told_from_other_words() {
        for word in ["-90", "0.3", "1e-3,", "[0", "90]", "90deg", "0,5", "pi/2", "-90\u{b0}", "\u{2212}90"] {
            assert!(goes_on(Some(&"0".to_owned()), word), "{word}");
        }
        for word in ["arm.yaml", "--near", "-o", "7dof.yaml", "specs/ur5.yaml", "-", ""] {
            assert!(!goes_on(Some(&"0".to_owned()), word), "{word}");
        }
        assert!(goes_on(Some(&"t,".to_owned()), "2t") && !goes_on(Some(&"t,".to_owned()), "--to"));
    }

    #[test]
    fn words_are_quoted_where_a_shell_would_split_them() {
        for (word, shown) in [
            ("--q", "--q"),
            ("specs/ur5.yaml", "specs/ur5.yaml"),
            (r"C:\arm.yaml", r"C:\arm.yaml"),
            ("0 -90", "\"0 -90\""),
            ("20 sin(t)", "\"20 sin(t)\""),
            ("", "\"\""),
            ("$x it's", r"'$x it'\''s'"),
        ] {
            assert_eq!(quoted(word), shown);
        }
    }
}
