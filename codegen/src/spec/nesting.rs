//! How deep a text nests brackets. The YAML library's time grows with the square of that depth.

/// An arm file nests four deep, and the library ends at 128. Brackets within a text that is not quoted count too.
const DEEPEST: usize = 1000;

/// Line and column, from 1, of the first bracket beyond the deepest. Brackets in quotes and comments do not count.
pub fn too_deep(text: &str) -> Option<(usize, usize)> {
    let mut depth = 0_usize;
    let (mut line, mut column) = (1, 0);
    let mut before = '\n';
    let mut quote = None;
    let mut is_comment = false;
    for letter in text.chars() {
        // What a backslash stands before in double quotes, and all of a comment, means nothing.
        let is_plain = match quote {
            Some(open) => {
                let is_escaped = open == '"' && before == '\\';
                quote = quote.filter(|_| is_escaped || letter != open);
                false
            }
            None => !is_comment,
        };
        (line, column) = if letter == '\n' { (line + 1, 0) } else { (line, column + 1) };
        is_comment &= letter != '\n';
        if is_plain {
            // A quote within a word is an apostrophe, and a number sign within a word is a letter.
            let is_start = before.is_whitespace() || matches!(before, '[' | '{' | ',' | ':');
            match letter {
                '[' | '{' => depth += 1,
                ']' | '}' => depth = depth.saturating_sub(1),
                '"' | '\'' if is_start => quote = Some(letter),
                '#' if is_start => is_comment = true,
                _ => {}
            }
            if depth > DEEPEST {
                return Some((line, column));
            }
        }
        // A backslash that is escaped itself escapes nothing.
        before = if quote == Some('"') && before == '\\' && letter == '\\' { ' ' } else { letter };
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_that_nest_count() {
        let deep = |open: &str| format!("name: a\nb: {}", open.repeat(1001));
        assert_eq!(too_deep(&deep("[")), Some((2, 1004)));
        assert_eq!(too_deep(&deep("{")), Some((2, 1004)));
        assert_eq!(too_deep(&deep("[\n")), Some((1002, 1)));
        assert_eq!(too_deep(&"[".repeat(1000)), None);
        assert_eq!(too_deep(&"[1, 2], ".repeat(5000)), None);
    }

    #[test]
    fn quotes_and_comments_do_not() {
        let many = "[".repeat(2000);
        for text in [
            format!("a: \"{many}\"\n"),
            format!("a: '{many}'\n"),
            format!("# {many}\na: 1\n"),
            format!("a: \"\\\"{many}\"\n"),
            format!("a: [1] # {many}\n"),
        ] {
            assert_eq!(too_deep(&text), None, "{}", text.get(..10).unwrap_or_default());
        }
        // An apostrophe opens no quote, an escaped backslash escapes no end of one, a comment ends with its line.
        for text in
            [format!("a: it's {many}"), format!("a: \"\\\\\" {many}"), format!("# '\n{many}"), format!("a: b#c {many}")]
        {
            assert!(too_deep(&text).is_some(), "{}", text.get(..10).unwrap_or_default());
        }
    }
}
