//! The server behind the page: this machine alone, one file, nothing that a foreign page may ask for.
//!
//! It listens at 127.0.0.1. A request has to name this host, so that no name of another one leads here; its origin, where it
//! has one, has to be this page; and it has to have the token of the address. No path of a request becomes a path of a file.

use std::fs;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::http::{self, Answer, Asked, Body, LONGEST_BODY};
use super::page::{Given, page};

/// The file behind a page.
pub struct Served {
    /// The arm file; none of a text from the standard input.
    file: Option<PathBuf>,
    /// Its text at the start.
    text: String,
    name: String,
    write: bool,
    token: String,
    tags: RandomState,
    /// One write after the other.
    writing: Mutex<()>,
}

impl Served {
    /// The file, or a text without one.
    pub fn new(file: Option<PathBuf>, text: String, name: String, write: bool) -> Self {
        Self { file, text, name, write, token: token(), tags: RandomState::new(), writing: Mutex::new(()) }
    }

    /// The address of the page at a port.
    fn address(&self, port: u16) -> String {
        format!("http://127.0.0.1:{port}/?token={}", self.token)
    }

    /// The answer to a request at a port. `body` is read only where a file is written.
    pub fn answer(&self, asked: &Asked, port: u16, body: Body) -> Answer {
        let hosts = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        if !asked.host.as_ref().is_some_and(|host| hosts.contains(host)) {
            return Answer::refused(403, "another host");
        }
        if asked.origin.as_ref().is_some_and(|origin| !hosts.iter().any(|own| format!("http://{own}") == *origin)) {
            return Answer::refused(403, "another origin");
        }
        let (path, query) = asked.url.split_once('?').unwrap_or((&asked.url, ""));
        let token = query.split('&').find_map(|part| part.strip_prefix("token="));
        if !token.is_some_and(|token| same(token, &self.token)) {
            return Answer::refused(403, "the address has another token: take it as the command prints it");
        }
        match (asked.method.as_str(), path) {
            ("GET", "/") => {
                let text = self.now().unwrap_or_else(|_| self.text.clone());
                let given = Given { text: &text, name: &self.name, follow: self.file.is_some(), write: self.write };
                Answer::page(page(&given))
            }
            ("GET", "/arm") => match self.now() {
                Ok(text) => Answer::text(self.tag(&text), text),
                Err(why) => Answer::refused(500, why),
            },
            ("PUT", "/arm") if self.write => {
                self.put(asked.if_match.as_deref(), body).unwrap_or_else(|refused| refused)
            }
            ("PUT", "/arm") => Answer::refused(403, "`denhart view` without --write writes nothing"),
            (_, "/" | "/arm") => Answer::refused(405, "no such method"),
            _ => Answer::refused(404, "no such page"),
        }
    }

    /// The text of the file as it is now.
    fn now(&self) -> Result<String, String> {
        let Some(file) = &self.file else { return Ok(self.text.clone()) };
        // Anything may stand in the file's place by now: a pipe would never end.
        let is_text = fs::metadata(file).is_ok_and(|facts| facts.is_file() && facts.len() <= LONGEST_BODY as u64);
        if !is_text && file.exists() {
            return Err(format!("`{}` is no file of up to a megabyte", file.display()));
        }
        crate::arm::text(file).map(|(text, _)| text)
    }

    /// The tag of a text: equal for equal texts, while the command runs.
    fn tag(&self, text: &str) -> String {
        format!("{:016x}", self.tags.hash_one(text))
    }

    /// Writes the file, if it still has the text that the page has seen.
    fn put(&self, seen: Option<&str>, body: Body) -> Result<Answer, Answer> {
        let file = self.file.as_ref().ok_or_else(|| Answer::refused(400, "there is no file"))?;
        let seen = seen.ok_or_else(|| Answer::refused(428, "the request does not say which text it replaces"))?;
        let text = body()?;
        let _one = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        // A file that is gone has no text to lose.
        if file.exists() {
            let now = self.now().map_err(|why| Answer::refused(412, why))?;
            if seen != format!("\"{}\"", self.tag(&now)) {
                return Err(Answer::refused(412, "the file has changed since the page read it"));
            }
        }
        replace(file, &text)
            .map_err(|error| Answer::refused(400, format!("cannot write `{}`: {error}", file.display())))?;
        Ok(Answer::text(self.tag(&text), String::new()))
    }
}

/// Replaces a file at once: another program sees the old text or the new one, whatever happens in between.
fn replace(file: &Path, text: &str) -> std::io::Result<()> {
    // A link stays a link.
    let file = fs::canonicalize(file).unwrap_or_else(|_| file.to_path_buf());
    let permissions = fs::metadata(&file).map(|facts| facts.permissions()).ok();
    if permissions.as_ref().is_some_and(fs::Permissions::readonly) {
        return Err(std::io::ErrorKind::PermissionDenied.into());
    }
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}", std::process::id()));
    let beside = file.with_file_name(name);
    let written = fs::write(&beside, text)
        .and_then(|()| permissions.map_or(Ok(()), |permissions| fs::set_permissions(&beside, permissions)))
        .and_then(|()| fs::rename(&beside, &file));
    if written.is_err() {
        let _ = fs::remove_file(&beside);
    }
    written
}

/// Letters that nobody guesses: the keys of the standard library's hash are random bits of the system.
fn token() -> String {
    let part = |number: u64| {
        let mut hasher = RandomState::new().build_hasher();
        hasher.write_u64(number);
        format!("{:016x}", hasher.finish())
    };
    (0..2).map(part).collect()
}

/// Compares all letters, wherever the first difference is.
fn same(one: &str, other: &str) -> bool {
    one.len() == other.len() && one.bytes().zip(other.bytes()).fold(0, |off, (a, b)| off | (a ^ b)) == 0
}

/// Listens at a free port, and the address to open.
///
/// # Errors
/// The message: no port.
pub fn open(served: &Served) -> Result<(TcpListener, String), String> {
    let cannot = |error| format!("cannot listen at 127.0.0.1: {error}");
    let listener = TcpListener::bind(("127.0.0.1", 0)).map_err(cannot)?;
    let port = listener.local_addr().map_err(cannot)?.port();
    Ok((listener, served.address(port)))
}

/// Answers requests until the command is ended.
///
/// # Errors
/// The message: no connection can be taken any more.
pub fn serve(listener: &TcpListener, served: &Served) -> Result<(), String> {
    let port = listener.local_addr().map_err(|error| error.to_string())?.port();
    http::serve(listener, &|asked, body| served.answer(asked, port, body))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    const HERE: &str = "127.0.0.1:8000";

    fn served(write: bool) -> Served {
        Served::new(None, "name: a\n".to_owned(), "a.yaml".to_owned(), write)
    }

    fn status(served: &Served, method: &str, url: &str, host: Option<&str>, origin: Option<&str>) -> u16 {
        let [host, origin] = [host, origin].map(|name| name.map(str::to_owned));
        let asked = Asked { method: method.to_owned(), url: url.to_owned(), host, origin, ..Asked::default() };
        served.answer(&asked, 8000, &mut || Ok("name: b\n".to_owned())).status
    }

    #[test]
    fn only_this_host_and_this_page_are_answered() {
        let served = served(false);
        let url = format!("/arm?token={}", served.token);
        let get = |host, origin| status(&served, "GET", &url, host, origin);
        assert_eq!(get(Some(HERE), None), 200);
        assert_eq!(get(Some("localhost:8000"), Some("http://127.0.0.1:8000")), 200);
        for host in [None, Some(""), Some("127.0.0.1"), Some("127.0.0.1:8001"), Some("evil.example:8000")] {
            assert_eq!(get(host, None), 403, "{host:?}");
        }
        for origin in ["null", "http://evil.example", "https://127.0.0.1:8000", "http://127.0.0.1:80001", ""] {
            assert_eq!(get(Some(HERE), Some(origin)), 403, "{origin}");
        }
    }

    #[test]
    fn nothing_is_answered_without_the_token() {
        let served = served(true);
        let token = served.token.clone();
        assert_eq!(token.len(), 32);
        let half = token.get(..16).unwrap();
        for url in [
            "/".to_owned(),
            "/arm".to_owned(),
            "/?token=".to_owned(),
            format!("/?token={half}"),
            format!("/?t={token}"),
        ] {
            assert_eq!(status(&served, "GET", &url, Some(HERE), None), 403, "{url}");
            assert_eq!(status(&served, "PUT", &url, Some(HERE), None), 403, "{url}");
        }
        assert_ne!(token, Served::new(None, String::new(), String::new(), false).token);
    }

    #[test]
    fn no_path_leads_to_another_file() {
        let served = served(false);
        let paths = [
            "/arm/",
            "/../arm",
            "//arm",
            "/arm/../../etc/passwd",
            "/%2e%2e/arm",
            "/etc/passwd",
            "/arm%00",
            "arm",
            "file:///etc/passwd",
        ];
        for path in paths {
            let url = format!("{path}?token={}", served.token);
            assert_eq!(status(&served, "GET", &url, Some(HERE), None), 404, "{path}");
        }
    }

    #[test]
    fn a_file_is_written_only_where_that_was_allowed() {
        let url = |served: &Served| format!("/arm?token={}", served.token);
        let closed = served(false);
        assert_eq!(status(&closed, "PUT", &url(&closed), Some(HERE), None), 403);
        // A text from the standard input has no file.
        let open = served(true);
        assert_eq!(status(&open, "PUT", &url(&open), Some(HERE), None), 400);
        assert_eq!(status(&open, "DELETE", &url(&open), Some(HERE), None), 405);
    }
}
