//! Namespace prefixes that a URDF uses and does not declare, such as `drake:`. Readers of URDF take them for a part of
//! the name; for an XML parser with namespaces they are mistakes.

use std::borrow::Cow;

use roxmltree::{Document, Error};

/// The most prefixes that are declared. Each one costs another parse of the file.
const MOST: usize = 32;

/// The text with every undeclared prefix declared in the start tag of its root element. The lines stay as they are.
///
/// A text that is no XML for another reason comes back as it is read up to there.
pub fn declared(text: &str) -> Cow<'_, str> {
    let mut text = Cow::Borrowed(text);
    let Some(at) = after_root_name(&text) else { return text };
    for _ in 0..MOST {
        let Err(Error::UnknownNamespace(prefix, _)) = Document::parse(&text) else { break };
        text.to_mut().insert_str(at, &format!(" xmlns:{prefix}=\"urn:undeclared:{prefix}\""));
    }
    text
}

/// The place after the name of the root element. Comments and processing instructions stand before it.
fn after_root_name(text: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        at += text.get(at..)?.find('<')? + 1;
        let rest = text.get(at..)?;
        let end = match rest {
            _ if rest.starts_with("!--") => "-->",
            _ if rest.starts_with('?') => "?>",
            _ => return Some(at + rest.find(|c: char| c.is_whitespace() || matches!(c, '/' | '>'))?),
        };
        at += rest.find(end)?;
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    #[test]
    fn undeclared_prefixes_of_elements_and_attributes_are_declared_once() {
        let text = "<?xml version=\"1.0\"?>\n<!-- <robot a:b=\"1\"> -->\n<robot\n name=\"r\">\n\
                    <drake:a drake:b=\"1\"/><link viz:c=\"2\" name=\"d:e\"><![CDATA[<f:g/>]]></link><!-- <h:i/> --></robot>";
        let read = declared(text);
        let added = " xmlns:viz=\"urn:undeclared:viz\" xmlns:drake=\"urn:undeclared:drake\"";
        assert_eq!(read, text.replace("<robot\n", &format!("<robot{added}\n")));
        Document::parse(&read).unwrap();
    }

    #[test]
    fn other_texts_are_left_as_they_are() {
        for text in ["<a xmlns:b=\"c\" b:d=\"1\"/>", "<a><b></a>", "no XML", "<!-- <a:b/>", "<?xml", "<", ""] {
            assert_eq!(declared(text), text);
        }
    }
}
