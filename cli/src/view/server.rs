//! The server behind the page: this machine alone, one file, nothing that a foreign page may ask for.
//!
//! It listens at 127.0.0.1. A request has to name this host, so that no name of another one leads here; its origin, where it
//! has one, has to be this page; and it has to have the token of the address. No path of a request becomes a path of a file.

use std::fs;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::io::Read;
use std::path::PathBuf;

use tiny_http::{Header, Method, Request, Response, Server};

use super::page::{Given, page};

/// An arm file is a page or two. Longer texts are not written.
const LONGEST: u64 = 1_000_000;

/// The file behind a page.
pub struct Served {
    /// The arm file; none of a text from the standard input.
    file: Option<PathBuf>,
    /// Its text at the start.
    text: String,
    name: String,
    write: bool,
    token: String,
}

/// The parts of a request that count.
pub struct Asked<'a> {
    pub method: Method,
    /// Path and query.
    pub url: &'a str,
    pub host: Option<&'a str>,
    pub origin: Option<&'a str>,
}

/// The answer to a request.
#[derive(Debug, PartialEq, Eq)]
pub struct Answer {
    pub status: u16,
    pub kind: &'static str,
    pub body: String,
}

impl Answer {
    fn new(status: u16, kind: &'static str, body: impl Into<String>) -> Self {
        Self { status, kind, body: body.into() }
    }

    fn refused(status: u16, why: &str) -> Self {
        Self::new(status, "text/plain; charset=utf-8", why)
    }
}

impl Served {
    /// The file, or a text without one.
    pub fn new(file: Option<PathBuf>, text: String, name: String, write: bool) -> Self {
        Self { file, text, name, write, token: token() }
    }

    /// The address of the page at a port.
    fn address(&self, port: u16) -> String {
        format!("http://127.0.0.1:{port}/?token={}", self.token)
    }

    /// The answer to a request at a port. `body` is read only where a file is written.
    pub fn answer(&self, asked: &Asked, port: u16, body: &mut dyn FnMut() -> Result<String, String>) -> Answer {
        let hosts = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
        if !asked.host.is_some_and(|host| hosts.iter().any(|own| own == host)) {
            return Answer::refused(403, "another host");
        }
        if asked.origin.is_some_and(|origin| !hosts.iter().any(|own| format!("http://{own}") == origin)) {
            return Answer::refused(403, "another origin");
        }
        let (path, query) = asked.url.split_once('?').unwrap_or((asked.url, ""));
        let token = query.split('&').find_map(|part| part.strip_prefix("token="));
        if !token.is_some_and(|token| same(token, &self.token)) {
            return Answer::refused(403, "the address has another token: take it as the command prints it");
        }
        match (&asked.method, path) {
            (Method::Get, "/") => {
                let text = self.now().unwrap_or_else(|_| self.text.clone());
                let given = Given { text: &text, name: &self.name, follow: self.file.is_some(), write: self.write };
                Answer::new(200, "text/html; charset=utf-8", page(&given))
            }
            (Method::Get, "/arm") => match self.now() {
                Ok(text) => Answer::new(200, "text/plain; charset=utf-8", text),
                Err(why) => Answer::refused(500, &why),
            },
            (Method::Put, "/arm") if self.write => match body().and_then(|text| self.put(&text)) {
                Ok(()) => Answer::new(200, "text/plain; charset=utf-8", ""),
                Err(why) => Answer::refused(400, &why),
            },
            (Method::Put, "/arm") => Answer::refused(403, "`denhart view` without --write writes nothing"),
            (_, "/" | "/arm") => Answer::refused(405, "no such method"),
            _ => Answer::refused(404, "no such page"),
        }
    }

    /// The text of the file as it is now.
    fn now(&self) -> Result<String, String> {
        match &self.file {
            Some(file) => crate::arm::text(file).map(|(text, _)| text),
            None => Ok(self.text.clone()),
        }
    }

    fn put(&self, text: &str) -> Result<(), String> {
        let file = self.file.as_ref().ok_or("there is no file")?;
        fs::write(file, text).map_err(|error| format!("cannot write `{}`: {error}", file.display()))
    }
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
pub fn open(served: &Served) -> Result<(Server, String), String> {
    let server = Server::http("127.0.0.1:0").map_err(|error| format!("cannot listen at 127.0.0.1: {error}"))?;
    let port = port(&server).ok_or("cannot listen at 127.0.0.1")?;
    Ok((server, served.address(port)))
}

fn port(server: &Server) -> Option<u16> {
    server.server_addr().to_ip().map(|address| address.port())
}

/// Answers requests until the command is ended.
pub fn serve(server: &Server, served: &Served) {
    let Some(port) = port(server) else { return };
    for request in server.incoming_requests() {
        // A page that is closed takes no answer.
        let _ = reply(request, served, port);
    }
}

fn reply(mut request: Request, served: &Served, port: u16) -> std::io::Result<()> {
    let header = |name: &'static str| {
        let found = request.headers().iter().find(|header| header.field.equiv(name));
        found.map(|header| header.value.as_str().to_owned())
    };
    let (host, origin) = (header("Host"), header("Origin"));
    let (method, url) = (request.method().clone(), request.url().to_owned());
    let mut body = || read(&mut request);
    let asked = Asked { method, url: &url, host: host.as_deref(), origin: origin.as_deref() };
    let Answer { status, kind, body } = served.answer(&asked, port, &mut body);
    let fields = [
        ("Content-Type", kind),
        ("Cache-Control", "no-store"),
        ("X-Content-Type-Options", "nosniff"),
        ("X-Frame-Options", "DENY"),
        ("Referrer-Policy", "no-referrer"),
    ];
    let mut response = Response::from_string(body).with_status_code(status);
    for header in fields.iter().filter_map(|(name, value)| Header::from_bytes(*name, *value).ok()) {
        response.add_header(header);
    }
    request.respond(response)
}

/// The text of a request.
fn read(request: &mut Request) -> Result<String, String> {
    let mut text = String::new();
    let read = request.as_reader().take(LONGEST + 1).read_to_string(&mut text);
    read.map_err(|error| format!("no text: {error}"))?;
    if text.len() as u64 > LONGEST { Err("too long for an arm file".to_owned()) } else { Ok(text) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::*;

    const HERE: &str = "127.0.0.1:8000";

    fn served(write: bool) -> Served {
        Served::new(None, "name: a\n".to_owned(), "a.yaml".to_owned(), write)
    }

    fn status(served: &Served, method: Method, url: &str, host: Option<&str>, origin: Option<&str>) -> u16 {
        let asked = Asked { method, url, host, origin };
        served.answer(&asked, 8000, &mut || Ok("name: b\n".to_owned())).status
    }

    #[test]
    fn only_this_host_and_this_page_are_answered() {
        let served = served(false);
        let url = format!("/arm?token={}", served.token);
        let get = |host, origin| status(&served, Method::Get, &url, host, origin);
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
            assert_eq!(status(&served, Method::Get, &url, Some(HERE), None), 403, "{url}");
            assert_eq!(status(&served, Method::Put, &url, Some(HERE), None), 403, "{url}");
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
            assert_eq!(status(&served, Method::Get, &url, Some(HERE), None), 404, "{path}");
        }
    }

    #[test]
    fn a_file_is_written_only_where_that_was_allowed() {
        let url = |served: &Served| format!("/arm?token={}", served.token);
        let closed = served(false);
        assert_eq!(status(&closed, Method::Put, &url(&closed), Some(HERE), None), 403);
        // A text from the standard input has no file.
        let open = served(true);
        assert_eq!(status(&open, Method::Put, &url(&open), Some(HERE), None), 400);
        assert_eq!(status(&open, Method::Delete, &url(&open), Some(HERE), None), 405);
    }
}
