//! `denhart view`: the page as a file, and behind its server.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::Duration;

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

    fn connect(&self) -> TcpStream {
        TcpStream::connect(&self.host).unwrap()
    }

    /// Status, head and text of the answer to bytes as they are, after which nothing more is sent.
    fn raw(&self, request: &str) -> (u16, String, String) {
        let mut stream = self.connect();
        stream.write_all(request.as_bytes()).unwrap();
        stream.shutdown(Shutdown::Write).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        (head.split(' ').nth(1).unwrap().parse().unwrap(), head.to_owned(), body.to_owned())
    }

    /// The tag of the file's text as it is now, with its quotation marks.
    fn tag(&self) -> String {
        let (_, head, _) = self.raw(&format!("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", self.arm(), self.host));
        head.lines().find_map(|line| line.strip_prefix("ETag: ")).unwrap().to_owned()
    }

    fn ask(&self, method: &str, path: &str, headers: &str, body: &str) -> (u16, String) {
        let (host, length) = (&self.host, body.len());
        let headers = if headers.contains("Host:") { headers.to_owned() } else { format!("Host: {host}\r\n{headers}") };
        let (status, _, body) = self.raw(&format!(
            "{method} {path} HTTP/1.1\r\n{headers}Connection: close\r\nContent-Length: {length}\r\n\r\n{body}"
        ));
        (status, body)
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
    let seen = format!("If-Match: {}\r\n", open.tag());
    let long = "#".repeat(1_000_001);
    assert_eq!(open.ask("PUT", &open.arm(), &seen, &long).0, 413);
    assert_eq!(open.ask("PUT", &open.arm(), "", &changed).0, 428);
    // A text that ends early, one without a length, one in pieces.
    let put = format!("PUT {} HTTP/1.1\r\nHost: {}\r\n{seen}", open.arm(), open.host);
    assert_eq!(open.raw(&format!("{put}Content-Length: 5000\r\n\r\nname: a\n")).0, 400);
    assert_eq!(open.raw(&format!("{put}\r\nname: a\n")).0, 411);
    assert_eq!(open.raw(&format!("{put}Transfer-Encoding: chunked\r\n\r\n1\r\na\r\n0\r\n\r\n")).0, 501);
    assert_eq!(fs::read_to_string(&path).unwrap(), ARM);
    assert_eq!(open.ask("PUT", &open.arm(), &seen, &changed).0, 200);
    assert_eq!(fs::read_to_string(&path).unwrap(), changed);
    // The page has not seen what another program has written since.
    let foreign = ARM.replace("first", "foreign");
    fs::write(&path, &foreign).unwrap();
    assert_eq!(open.ask("PUT", &open.arm(), &seen, &changed).0, 412);
    assert_eq!(fs::read_to_string(&path).unwrap(), foreign);
    let beside: Vec<_> =
        fs::read_dir(path.parent().unwrap()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    let name = path.file_name().unwrap().to_str().unwrap();
    assert!(!beside.iter().any(|other| other.to_str().unwrap().starts_with(&format!("{name}."))), "{beside:?}");
    let refused = denhart(&["view", "-", "--write", "--no-open"]);
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn a_connection_that_asks_for_too_much_harms_no_other() {
    let (_, shown) = file("view_greedy.yaml");
    let running = Running::start(&[&shown, "--write"]);
    let host = &running.host;
    // Lengths that nobody has memory for, of requests that are refused and of one that is not.
    for length in ["1000000000000", "18446744073709551615", "99999999999999999999999", "-1"] {
        let (status, ..) = running.raw(&format!("POST / HTTP/1.1\r\nHost: evil\r\nContent-Length: {length}\r\n\r\nx"));
        assert_eq!(status, 403, "{length}");
        let put = format!("PUT {} HTTP/1.1\r\nHost: {host}\r\nIf-Match: {}\r\n", running.arm(), running.tag());
        let (status, ..) = running.raw(&format!("{put}Content-Length: {length}\r\n\r\nx"));
        assert!(status == 413 || status == 400, "{length}: {status}");
    }
    // Connections that wait: without a request, in its head, in its body.
    let starts = ["", "GET / HTTP/1.1\r\n", "POST / HTTP/1.1\r\nHost: evil\r\nContent-Length: 1000000\r\n\r\n"];
    let waiting: Vec<TcpStream> = (0..30)
        .map(|number| {
            let mut stream = running.connect();
            stream.write_all(starts[number % 3].as_bytes()).unwrap();
            stream
        })
        .collect();
    assert_eq!(running.ask("GET", &running.arm(), "", ""), (200, ARM.to_owned()));
    drop(waiting);
    // A head without an end, one with too many fields, names that stand there twice, and no HTTP.
    let get = format!("GET {} HTTP/1.1\r\nHost: {host}\r\n", running.arm());
    assert_eq!(running.raw(&format!("{get}X: {}\r\n\r\n", "x".repeat(20_000))).0, 431);
    assert_eq!(running.raw(&format!("{get}{}\r\n", "X: x\r\n".repeat(200))).0, 431);
    assert_eq!(running.raw(&format!("{get}Host: evil.example\r\n\r\n")).0, 400);
    assert_eq!(running.raw(&format!("{get}Origin: http://{host}\r\nOrigin: http://evil.example\r\n\r\n")).0, 400);
    assert_eq!(running.raw("\0\x01\x02 nothing\r\n\r\n").0, 400);
    assert_eq!(running.ask("GET", &running.arm(), "", ""), (200, ARM.to_owned()));
}

#[test]
fn more_connections_than_are_taken_end() {
    let (_, shown) = file("view_many.yaml");
    let running = Running::start(&[&shown]);
    let mut waiting: Vec<TcpStream> = (0..100).map(|_| running.connect()).collect();
    let mut last = waiting.pop().unwrap();
    last.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
    assert_eq!(last.read(&mut [0]).unwrap_or(0), 0);
    drop(waiting);
    drop(last);
    // The others have ended by the next question, or soon.
    let answered = (0..50).any(|_| {
        std::thread::sleep(Duration::from_millis(100));
        let mut stream = running.connect();
        let request = format!("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", running.arm(), running.host);
        let mut answer = String::new();
        stream.write_all(request.as_bytes()).is_ok()
            && stream.read_to_string(&mut answer).is_ok()
            && answer.contains(ARM)
    });
    assert!(answered);
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
