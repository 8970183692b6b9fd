//! The page, with the arm that it opens.

use serde_json::json;

/// The page as `playground/build.sh --accept` writes it.
const PAGE: &str = include_str!("page.html");

/// The element that has the arm.
const EMPTY: &str = "<script type=\"application/json\" id=\"opened\">null</script>";

/// The arm that a page opens.
pub struct Given<'a> {
    pub text: &'a str,
    pub name: &'a str,
    /// The page asks for changes of the file.
    pub follow: bool,
    /// The page may write the file.
    pub write: bool,
}

/// The page with an arm. No text of an arm ends its element: `<` is written as an escape.
pub fn page(given: &Given) -> String {
    let Given { text, name, follow, write } = given;
    let data =
        json!({"text": text, "name": name, "follow": follow, "write": write}).to_string().replace('<', "\\u003c");
    let filled = format!("<script type=\"application/json\" id=\"opened\">{data}</script>");
    PAGE.replacen(EMPTY, &filled, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_arm_ends_its_element() {
        let text = "name: </script><script>alert(1)</script>\n";
        let html = page(&Given { text, name: "<b>.yaml", follow: false, write: false });
        assert!(html.contains("\\u003c/script>\\u003cscript>alert(1)") && !html.contains("<script>alert(1)"));
        assert!(html.contains("\"name\":\"\\u003cb>.yaml\"") && !html.contains(EMPTY));
    }
}
