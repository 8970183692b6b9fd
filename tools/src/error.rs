//! Why a tool does not give what was asked for.

use denhart_codegen::Errors;

/// Why a tool does not give what was asked for. Printed, it is the whole message, with a line `help: ..` where there is help.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Mistakes in an arm file, each with its place. Printed, every mistake behind the first one begins with `error: `.
    #[error("{}", each(.0))]
    Mistakes(Errors),
    /// An option that makes no sense.
    #[error("{0}")]
    Option(String),
    /// Text that is not what it is read as, or that no arm file can say.
    #[error("{0}")]
    Text(String),
}

impl From<Errors> for Error {
    fn from(mistakes: Errors) -> Self {
        Self::Mistakes(mistakes)
    }
}

/// The mistakes of a file as one message that stands behind `error: `.
fn each(mistakes: &Errors) -> String {
    mistakes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n\nerror: ")
}
