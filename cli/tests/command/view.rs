//! `denhart view`: the page as a file, and behind its server.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};

use crate::{arm_file, command, denhart, text};

/// The command, which ends with the test.
struct Running {
    child: Child,
    /// `127.0.0.1:8000`.
    host: String,
    token: String,
}

impl Drop for Running {
    fn drop(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

impl Running {
    fn start(arguments: &[&str]) -> Self {
        let mut child = command(&[&["view", "--no-open"], arguments].concat())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().unwrap()).read_line(&mut line).unwrap();
        let (host, token) = line.trim().strip_prefix("http://").unwrap().split_once("/?token=").unwrap();
        assert!(host.starts_with("127.0.0.1:"), "{host}");
        let (host, token) = (host.to_owned(), token.to_owned());
        Running { child, host, token }
    }

    /// Status and text of the answer to bytes as they are.
    fn raw(&self, request: &str) -> (u16, String) {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        (head.split(' ').nth(1).unwrap().parse().unwrap(), body.to_owned())
    }

    fn ask(&self, method: &str, path: &str, headers: &str, body: &str) -> (u16, String) {
        let (host, length) = (&self.host, body.len());
        let headers = if headers.contains("Host:") { headers.to_owned() } else { format!("Host: {host}\r\n{headers}") };
        self.raw(&format!(
            "{method} {path} HTTP/1.1\r\n{headers}Connection: close\r\nContent-Length: {length}\r\n\r\n{body}"
        ))
    }

    fn arm(&self) -> String {
        format!("/arm?token={}", self.token)
    }
}

const ARM: &str = "name: first\nconvention: standard\njoints:\n  - {a: 0.5, alpha: 0, d: 0, theta: 0}\n";

fn file(name: &str) -> (PathBuf, String) {
    let path = arm_file(name, ARM);
    let shown = path.to_str().unwrap().to_owned();
    (path, shown)
}

#[test]
fn the_page_has_the_arm_and_follows_its_file() {
    let (path, shown) = file("view_follow.yaml");
    let running = Running::start(&[&shown]);
    let (status, page) = running.ask("GET", &format!("/?token={}", running.token), "", "");
    assert_eq!(status, 200);
    assert!(page.contains("name: first") && page.contains("\"follow\":true") && page.contains("\"write\":false"));
    assert_eq!(running.ask("GET", &running.arm(), "", ""), (200, ARM.to_owned()));
    let changed = ARM.replace("first", "second");
    fs::write(&path, &changed).unwrap();
    assert_eq!(running.ask("GET", &running.arm(), "", ""), (200, changed));
    // A file that is gone is told, and the command goes on.
    fs::remove_file(&path).unwrap();
    assert_eq!(running.ask("GET", &running.arm(), "", "").0, 500);
    assert_eq!(running.ask("GET", &format!("/?token={}", running.token), "", "").0, 200);
}

#[test]
fn nobody_else_is_answered() {
    let (_, shown) = file("view_foreign.yaml");
    let running = Running::start(&[&shown, "--write"]);
    let arm = running.arm();
    let port = running.host.rsplit(':').next().unwrap().to_owned();
    for headers in [
        "Host: evil.example\r\n".to_owned(),
        format!("Host: evil.example:{port}\r\n"),
        format!("Host: 127.0.0.1.evil.example:{port}\r\n"),
        "Origin: http://evil.example\r\n".to_owned(),
        "Origin: null\r\n".to_owned(),
    ] {
        assert_eq!(running.ask("GET", &arm, &headers, "").0, 403, "{headers}");
        assert_eq!(running.ask("PUT", &arm, &headers, "name: evil\n").0, 403, "{headers}");
    }
    assert_eq!(running.ask("GET", "/arm", "", "").0, 403);
    assert_eq!(running.ask("GET", "/arm?token=0123456789abcdef0123456789abcdef", "", "").0, 403);
    for path in ["/../Cargo.toml", "/..%2f..%2fetc/passwd", "/etc/passwd", "//etc/passwd", "/arm/../../../etc/passwd"] {
        let (status, body) = running.ask("GET", &format!("{path}?token={}", running.token), "", "");
        assert!(status == 404 && body.len() < 100, "{path}: {status}");
    }
    assert_eq!(fs::read_to_string(Path::new(&shown)).unwrap(), ARM);
}

#[test]
fn the_page_writes_only_with_its_option() {
    let (path, shown) = file("view_write.yaml");
    let changed = ARM.replace("first", "third");
    let closed = Running::start(&[&shown]);
    assert_eq!(closed.ask("PUT", &closed.arm(), "", &changed).0, 403);
    assert_eq!(fs::read_to_string(&path).unwrap(), ARM);
    let open = Running::start(&[&shown, "--write"]);
    let long = "#".repeat(1_000_001);
    assert_eq!(open.ask("PUT", &open.arm(), "", &long).0, 400);
    assert_eq!(fs::read_to_string(&path).unwrap(), ARM);
    assert_eq!(open.ask("PUT", &open.arm(), "", &changed).0, 200);
    assert_eq!(fs::read_to_string(&path).unwrap(), changed);
    let refused = denhart(&["view", "-", "--write", "--no-open"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn the_exported_page_has_everything() {
    let (path, shown) = file("view_export.yaml");
    let out = path.with_extension("html");
    let _ = fs::remove_file(&out);
    let named = out.to_str().unwrap();
    let output = denhart(&["view", &shown, "--export", named]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let page = fs::read_to_string(&out).unwrap();
    assert!(page.contains("name: first") && page.contains("\"follow\":false"));
    // Nothing is fetched: no address but names of XML and in texts, no file beside.
    for mark in ["src=\"http", "href=\"http", "url(http", "<link rel=\"stylesheet\"", "import(\"http"] {
        assert!(!page.contains(mark), "{mark}");
    }
    fs::write(&out, "mine").unwrap();
    let refused = denhart(&["view", &shown, "--export", named]);
    assert!(!refused.status.success() && text(&refused.stderr).contains("--force"));
    assert_eq!(fs::read_to_string(&out).unwrap(), "mine");
    assert!(denhart(&["view", &shown, "--export", named, "--force"]).status.success());
    let missing = denhart(&["view", "no_such_arm.yaml", "--no-open"]);
    assert_eq!(missing.status.code(), Some(1));
}
