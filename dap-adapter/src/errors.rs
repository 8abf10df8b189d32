//! Why a request is refused: what, where, and what to do about it.

use thiserror::Error;

use technol_wire::message::Failure;

/// An error response.
#[derive(Clone, Debug, PartialEq, Error)]
pub(crate) enum RequestError {
    #[error("the request `{command}` is not known here")]
    Unknown { command: String },
    #[error("the message is not valid JSON: {reason}")]
    NotJson { reason: String },
    #[error("the arguments of `{command}` do not fit: {reason}")]
    Arguments { command: String, reason: String },
    #[error("`{command}` is not possible {when}; {remedy}")]
    OutOfOrder { command: String, when: &'static str, remedy: &'static str },
    #[error("`{command}` needs a program that is stopped; use `pause` first")]
    NotStopped { command: String },
    #[error("the PLC stands after a fault; restart it to go on")]
    Faulted,
    #[error("{0}")]
    Build(#[from] crate::project::BuildFailure),
    #[error("{0}")]
    Connect(String),
    #[error(
        "the target runs another program than `{program}`{running}; \
         launch with `download: \"ifStale\"` to replace it, or open the sources it was built from"
    )]
    OtherProgram { program: String, running: String },
    #[error("the target speaks protocol {theirs}, this adapter {ours}; update the older one")]
    Protocol { theirs: u16, ours: u16 },
    #[error("the link to the target is lost ({0}); check the cable or the target, then start again")]
    LinkLost(String),
    #[error("the target did not answer within {0} s; it may be overloaded or the link very bad")]
    Silent(u64),
    #[error("the target refuses: {0}")]
    Refused(String),
    #[error("{0}")]
    Expression(String),
    #[error("there is no {what} number {id} any more; the program has gone on since")]
    Stale { what: &'static str, id: i64 },
    #[error("`{name}` cannot be changed: {reason}")]
    ReadOnly { name: String, reason: &'static str },
    #[error("{0}")]
    Value(String),
    #[error("{0}")]
    Source(String),
    #[error("cancelled")]
    Cancelled,
}

impl RequestError {
    /// Number that stays the same whatever the text.
    pub(crate) fn id(&self) -> i64 {
        match self {
            RequestError::Unknown { .. } => 1,
            RequestError::NotJson { .. } => 2,
            RequestError::Arguments { .. } => 3,
            RequestError::OutOfOrder { .. } => 4,
            RequestError::NotStopped { .. } => 5,
            RequestError::Faulted => 6,
            RequestError::Build(_) => 10,
            RequestError::Connect(_) => 11,
            RequestError::OtherProgram { .. } => 12,
            RequestError::Protocol { .. } => 13,
            RequestError::LinkLost(_) => 14,
            RequestError::Silent(_) => 15,
            RequestError::Refused(_) => 16,
            RequestError::Expression(_) => 20,
            RequestError::Stale { .. } => 21,
            RequestError::ReadOnly { .. } => 22,
            RequestError::Value(_) => 23,
            RequestError::Source(_) => 24,
            RequestError::Cancelled => 30,
        }
    }

    /// Worth a message box; the others are shown where they were asked for.
    pub(crate) fn show_user(&self) -> bool {
        !matches!(
            self,
            RequestError::Unknown { .. }
                | RequestError::NotStopped { .. }
                | RequestError::Expression(_)
                | RequestError::Stale { .. }
                | RequestError::Source(_)
                | RequestError::Cancelled
        )
    }

    /// The words for `message` that clients act on.
    pub(crate) fn word(&self) -> Option<&'static str> {
        match self {
            RequestError::NotStopped { .. } => Some("notStopped"),
            RequestError::Cancelled => Some("cancelled"),
            _ => None,
        }
    }
}

impl From<Failure> for RequestError {
    fn from(failure: Failure) -> Self {
        let text = match failure {
            Failure::Unsupported => "it is too old to know this request; update it".into(),
            Failure::Malformed => "it could not read the request".into(),
            Failure::Version => "it needs another protocol version; update the older side".into(),
            Failure::NoSession => "it knows no debug session; start debugging again".into(),
            Failure::NoProgram => "it has no program; launch with `download: \"ifStale\"`".into(),
            Failure::NotStopped => "the program has to be stopped in the debugger first".into(),
            Failure::NotRunning => "the PLC is not running; start it with `plc start` or restart".into(),
            Failure::OutOfRange => "the address lies outside PLC memory".into(),
            Failure::Incomplete => "the program did not arrive complete; download it again".into(),
            Failure::BadProgram(why) => format!("it cannot load the program: {why}"),
            Failure::NotFound(what) | Failure::Refused(what) => what,
            Failure::TooLarge => "it has no room for that much".into(),
        };
        RequestError::Refused(text)
    }
}
