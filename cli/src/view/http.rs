//! One request and one answer a connection: HTTP/1.1 as far as a browser needs it here.
//!
//! Whatever a connection may take is bounded: the bytes of a request, the time of either direction, the number of connections.
//! A body is read where the answer asks for it, so a refused request costs its head alone.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Bytes of a request before its body. Browsers send one to two thousand.
const LONGEST_HEAD: usize = 16 * 1024;

/// Fields of a request.
const MOST_FIELDS: usize = 100;

/// Bytes of a body: an arm file is a page or two.
pub const LONGEST_BODY: usize = 1_000_000;

/// Time for a request, and for its answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// A browser keeps six connections to a host.
const MOST_CONNECTIONS: usize = 64;

/// Failures in a row to take a connection, each followed by a rest, before the server gives up.
const MOST_FAILURES: usize = 50;
const REST: Duration = Duration::from_millis(100);

/// The parts of a request that count.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Asked {
    pub method: String,
    /// Path and query.
    pub url: String,
    pub host: Option<String>,
    pub origin: Option<String>,
    /// The tag of the text that a write replaces.
    pub if_match: Option<String>,
    pub content_length: Option<String>,
    pub transfer_encoding: Option<String>,
}

const PLAIN: &str = "text/plain; charset=utf-8";

/// The answer to a request.
#[derive(Debug, PartialEq, Eq)]
pub struct Answer {
    pub status: u16,
    pub kind: &'static str,
    /// The tag of the text, for later writes.
    pub tag: Option<String>,
    pub body: String,
}

impl Answer {
    /// A page.
    pub fn page(html: String) -> Self {
        Self { status: 200, kind: "text/html; charset=utf-8", tag: None, body: html }
    }

    /// A text with its tag.
    pub fn text(tag: String, text: String) -> Self {
        Self { status: 200, kind: PLAIN, tag: Some(tag), body: text }
    }

    /// The reason why there is no other answer.
    pub fn refused(status: u16, why: impl Into<String>) -> Self {
        Self { status, kind: PLAIN, tag: None, body: why.into() }
    }
}

/// Reads the body of a request.
pub type Body<'a> = &'a mut dyn FnMut() -> Result<String, Answer>;

/// Answers requests until the command is ended.
///
/// # Errors
/// The message: no connection can be taken any more.
pub fn serve(listener: &TcpListener, answer: &(dyn Fn(&Asked, Body) -> Answer + Sync)) -> Result<(), String> {
    let open = AtomicUsize::new(0);
    thread::scope(|scope| {
        let mut failures = 0;
        loop {
            match listener.accept() {
                Ok((stream, _)) => {
                    failures = 0;
                    if open.fetch_add(1, Ordering::Relaxed) >= MOST_CONNECTIONS {
                        open.fetch_sub(1, Ordering::Relaxed);
                        continue;
                    }
                    let connection = || {
                        // A page that is closed takes no answer.
                        let _ = Connection::new(stream).answer(answer);
                        open.fetch_sub(1, Ordering::Relaxed);
                    };
                    if thread::Builder::new().spawn_scoped(scope, connection).is_err() {
                        open.fetch_sub(1, Ordering::Relaxed);
                    }
                }
                Err(error) => {
                    failures += 1;
                    if failures >= MOST_FAILURES {
                        return Err(format!("cannot take connections any more: {error}"));
                    }
                    thread::sleep(REST);
                }
            }
        }
    })
}

struct Connection {
    stream: TcpStream,
    /// Bytes that were read.
    bytes: Vec<u8>,
    /// Time at which the request has to be there.
    end: Instant,
}

impl Connection {
    fn new(stream: TcpStream) -> Self {
        Self { stream, bytes: Vec::new(), end: Instant::now() + PATIENCE }
    }

    fn answer(mut self, answer: &dyn Fn(&Asked, Body) -> Answer) -> io::Result<()> {
        let reply = match self.head()? {
            Ok((asked, length)) => {
                self.bytes.drain(..length);
                answer(&asked, &mut || self.body(&asked))
            }
            Err(refused) => refused,
        };
        self.write(&reply)?;
        self.stream.shutdown(Shutdown::Write)?;
        // A connection closed on unread bytes loses the answer on its way.
        self.end = Instant::now() + REST;
        while self.bytes.len() <= LONGEST_BODY && self.more()? > 0 {}
        Ok(())
    }

    /// The request up to its body, and the number of its bytes; or the answer to one that is none.
    fn head(&mut self) -> io::Result<Result<(Asked, usize), Answer>> {
        while self.bytes.len() <= LONGEST_HEAD {
            let mut fields = [httparse::EMPTY_HEADER; MOST_FIELDS];
            let mut request = httparse::Request::new(&mut fields);
            match request.parse(&self.bytes) {
                Ok(httparse::Status::Complete(length)) => return Ok(asked(&request).map(|asked| (asked, length))),
                Ok(httparse::Status::Partial) => {}
                Err(httparse::Error::TooManyHeaders) => break,
                Err(error) => return Ok(Err(Answer::refused(400, error.to_string()))),
            }
            if self.more()? == 0 {
                return Err(ErrorKind::UnexpectedEof.into());
            }
        }
        Ok(Err(Answer::refused(431, "the head of the request is too long")))
    }

    /// The text after the head, as long as the head says.
    fn body(&mut self, asked: &Asked) -> Result<String, Answer> {
        if asked.transfer_encoding.is_some() {
            return Err(Answer::refused(501, "a text in pieces is not taken"));
        }
        let length = asked.content_length.as_deref().ok_or_else(|| Answer::refused(411, "the text has no length"))?;
        let length: usize = length.parse().map_err(|_| Answer::refused(400, "the length of the text is no number"))?;
        if length > LONGEST_BODY {
            return Err(Answer::refused(413, "too long for an arm file"));
        }
        while self.bytes.len() < length {
            match self.more() {
                Ok(0) | Err(_) => return Err(Answer::refused(400, "the text ends before its length")),
                Ok(_) => {}
            }
        }
        let text = self.bytes.get(..length).unwrap_or_default().to_vec();
        String::from_utf8(text).map_err(|_| Answer::refused(400, "the text is not UTF-8"))
    }

    /// Reads some more bytes; 0 where none will follow.
    fn more(&mut self) -> io::Result<usize> {
        self.stream.set_read_timeout(Some(left(self.end)?))?;
        let mut chunk = [0; 16 * 1024];
        let count = self.stream.read(&mut chunk)?;
        self.bytes.extend_from_slice(chunk.get(..count).unwrap_or_default());
        Ok(count)
    }

    fn write(&mut self, answer: &Answer) -> io::Result<()> {
        let Answer { status, kind, tag, body } = answer;
        let tag = tag.as_ref().map(|tag| format!("ETag: \"{tag}\"\r\n")).unwrap_or_default();
        let length = body.len();
        let head = format!(
            "HTTP/1.1 {status} {}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{tag}Cache-Control: no-store\r\n\
             X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\n\
             Connection: close\r\n\r\n",
            reason(*status),
        );
        let end = Instant::now() + PATIENCE;
        for part in [head.as_bytes(), body.as_bytes()] {
            let mut part = part;
            while !part.is_empty() {
                self.stream.set_write_timeout(Some(left(end)?))?;
                match self.stream.write(part)? {
                    0 => return Err(ErrorKind::WriteZero.into()),
                    count => part = part.get(count..).unwrap_or_default(),
                }
            }
        }
        Ok(())
    }
}

/// The time until then.
fn left(end: Instant) -> io::Result<Duration> {
    let left = end.saturating_duration_since(Instant::now());
    if left.is_zero() { Err(ErrorKind::TimedOut.into()) } else { Ok(left) }
}

/// The parts of a request that count. None of them may stand there twice: two readers could take two of them.
fn asked(request: &httparse::Request) -> Result<Asked, Answer> {
    let mut asked = Asked {
        method: request.method.unwrap_or_default().to_owned(),
        url: request.path.unwrap_or_default().to_owned(),
        ..Asked::default()
    };
    for field in request.headers.iter() {
        let place = match field.name.to_ascii_lowercase().as_str() {
            "host" => &mut asked.host,
            "origin" => &mut asked.origin,
            "if-match" => &mut asked.if_match,
            "content-length" => &mut asked.content_length,
            "transfer-encoding" => &mut asked.transfer_encoding,
            _ => continue,
        };
        let value = String::from_utf8_lossy(field.value).into_owned();
        if place.replace(value).is_some() {
            return Err(Answer::refused(400, format!("{} stands there twice", field.name)));
        }
    }
    Ok(asked)
}

/// The words of a status.
fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        411 => "Length Required",
        412 => "Precondition Failed",
        413 => "Content Too Large",
        428 => "Precondition Required",
        431 => "Request Header Fields Too Large",
        500 => "Internal Server Error",
        501 => "Not Implemented",
        _ => "Bad Request",
    }
}
