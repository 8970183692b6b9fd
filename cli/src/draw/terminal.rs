//! Pictures on a terminal: a PNG behind the escape sequence that kitty or iTerm2 reads.

/// Bytes of base64 in one escape sequence of kitty.
const CHUNK: usize = 4096;

/// The escape sequences that a terminal reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Protocol {
    /// kitty and Ghostty.
    Kitty,
    /// iTerm2 and WezTerm.
    ITerm2,
}

impl Protocol {
    /// The protocol of the terminal that the variables of the environment name. A multiplexer in between shows nothing.
    pub fn of(variable: &dyn Fn(&str) -> Option<String>) -> Option<Self> {
        let is = |name: &str, values: &[&str]| variable(name).is_some_and(|value| values.contains(&value.as_str()));
        if variable("TMUX").is_some() || variable("STY").is_some() {
            return None;
        }
        if is("TERM", &["xterm-kitty", "xterm-ghostty"]) || variable("KITTY_WINDOW_ID").is_some() {
            return Some(Self::Kitty);
        }
        let iterm = is("TERM_PROGRAM", &["iTerm.app", "WezTerm"]) || is("LC_TERMINAL", &["iTerm2"]);
        iterm.then_some(Self::ITerm2)
    }
}

/// The text that shows a PNG.
pub fn escapes(protocol: Protocol, png: &[u8]) -> String {
    let data = base64(png);
    match protocol {
        Protocol::ITerm2 => format!("\x1b]1337;File=inline=1;size={}:{data}\x07\n", png.len()),
        Protocol::Kitty => {
            let mut text = String::new();
            let mut rest = data.as_str();
            let mut control = "a=T,f=100,";
            while let Some((chunk, after)) =
                rest.split_at_checked(CHUNK.min(rest.len())).filter(|(now, _)| !now.is_empty())
            {
                let more = u8::from(!after.is_empty());
                text += &format!("\x1b_G{control}m={more};{chunk}\x1b\\");
                (rest, control) = (after, "");
            }
            text + "\n"
        }
    }
}

/// Base64 with padding (RFC 4648).
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |index: usize| group.get(index).map_or(0, |byte| u32::from(*byte));
        let bits = (byte(0) << 16) | (byte(1) << 8) | byte(2);
        for place in 0..4 {
            let letter = LETTERS.get((bits >> (18 - 6 * place)) as usize & 63).copied().unwrap_or(b'=');
            text.push(if place <= group.len() { letter.into() } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_written_as_the_rfc_has_them() {
        for (bytes, text) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn a_long_picture_comes_in_pieces() {
        let text = escapes(Protocol::Kitty, &[7; 5000]);
        assert_eq!(text.matches("\x1b_G").count(), 2);
        assert!(
            text.starts_with("\x1b_Ga=T,f=100,m=1;") && text.contains("\x1b\\\x1b_Gm=0;") && text.ends_with("\x1b\\\n")
        );
        let text = escapes(Protocol::ITerm2, &[7; 5000]);
        assert!(text.starts_with("\x1b]1337;File=inline=1;size=5000:") && text.ends_with("\x07\n"));
    }

    #[test]
    fn terminals_are_known_by_their_variables() {
        let of = |pairs: &[(&str, &str)]| {
            Protocol::of(&|name| pairs.iter().find(|(other, _)| *other == name).map(|(_, value)| (*value).to_owned()))
        };
        assert_eq!(of(&[("TERM", "xterm-kitty")]), Some(Protocol::Kitty));
        assert_eq!(of(&[("TERM", "xterm-256color"), ("TERM_PROGRAM", "WezTerm")]), Some(Protocol::ITerm2));
        assert_eq!(of(&[("TERM", "xterm-kitty"), ("TMUX", "/tmp/tmux")]), None);
        assert_eq!(of(&[("TERM", "xterm-256color")]), None);
    }
}
