//! Which request is possible when, and who answers it: one table.

use crate::errors::RequestError;
use crate::request::Request;

use super::{Answer, Session};

/// Where the session stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Before `initialize`.
    New = 1,
    /// Before `launch` or `attach`.
    Initialized = 2,
    /// The program is loaded, the client sets break-points.
    Configuring = 4,
    Running = 8,
    Stopped = 16,
    /// `terminated` was sent.
    Ended = 32,
}

const NEW: u8 = Phase::New as u8;
const INITIALIZED: u8 = Phase::Initialized as u8;
const CONFIGURING: u8 = Phase::Configuring as u8;
const RUNNING: u8 = Phase::Running as u8;
const STOPPED: u8 = Phase::Stopped as u8;
const ENDED: u8 = Phase::Ended as u8;
const LOADED: u8 = CONFIGURING | RUNNING | STOPPED;
const ANY: u8 = NEW | INITIALIZED | LOADED | ENDED;

/// A request this adapter knows.
pub(crate) struct Command {
    pub(crate) name: &'static str,
    /// Phases in which it is possible.
    phases: u8,
    /// The field of the capabilities that tells the client about it; `None`: every adapter has it.
    #[cfg_attr(not(test), expect(dead_code, reason = "a test compares it with the capabilities"))]
    pub(crate) capability: Option<&'static str>,
    pub(crate) handler: fn(&mut Session, &Request) -> Answer,
}

const fn basic(name: &'static str, phases: u8, handler: fn(&mut Session, &Request) -> Answer) -> Command {
    Command { name, phases, capability: None, handler }
}

const fn optional(
    name: &'static str,
    phases: u8,
    capability: &'static str,
    handler: fn(&mut Session, &Request) -> Answer,
) -> Command {
    Command { name, phases, capability: Some(capability), handler }
}

/// All requests.
pub(crate) const COMMANDS: &[Command] = &[
    basic("initialize", NEW, Session::initialize),
    basic("launch", INITIALIZED, Session::launch),
    basic("attach", INITIALIZED, Session::attach),
    optional(
        "configurationDone",
        CONFIGURING,
        "supportsConfigurationDoneRequest",
        Session::configuration_done,
    ),
    basic("setBreakpoints", INITIALIZED | LOADED, Session::set_breakpoints),
    optional(
        "setExceptionBreakpoints",
        INITIALIZED | LOADED,
        "exceptionBreakpointFilters",
        Session::set_exception_breakpoints,
    ),
    optional(
        "breakpointLocations",
        LOADED,
        "supportsBreakpointLocationsRequest",
        Session::breakpoint_locations,
    ),
    optional("loadedSources", LOADED, "supportsLoadedSourcesRequest", Session::loaded_sources),
    basic("source", LOADED, Session::source),
    basic("threads", LOADED, Session::threads),
    basic("continue", STOPPED, Session::continue_),
    basic("pause", RUNNING | STOPPED, Session::pause),
    basic("next", STOPPED, Session::next),
    basic("stepIn", STOPPED, Session::step_in),
    basic("stepOut", STOPPED, Session::step_out),
    basic("stackTrace", STOPPED, Session::stack_trace),
    basic("scopes", STOPPED, Session::scopes),
    basic("variables", RUNNING | STOPPED, Session::variables),
    optional("setVariable", RUNNING | STOPPED, "supportsSetVariable", Session::set_variable),
    basic("evaluate", LOADED, Session::evaluate),
    optional("setExpression", LOADED, "supportsSetExpression", Session::set_expression),
    optional("completions", LOADED, "supportsCompletionsRequest", Session::completions),
    optional("exceptionInfo", STOPPED, "supportsExceptionInfoRequest", Session::exception_info),
    optional("restart", RUNNING | STOPPED, "supportsRestartRequest", Session::restart),
    optional("terminate", INITIALIZED | LOADED | ENDED, "supportsTerminateRequest", Session::terminate),
    basic("disconnect", ANY, Session::disconnect),
    basic("technol/subscribe", LOADED, Session::subscribe),
    basic("technol/trace", LOADED, Session::trace),
    basic("technol/force", LOADED, Session::force),
    basic("technol/forced", LOADED, Session::forced),
];

/// Whether the request is possible now.
pub(crate) fn check(command: &Command, phase: Phase) -> Result<(), RequestError> {
    if command.phases & phase as u8 != 0 {
        return Ok(());
    }
    if phase == Phase::Running && command.phases & STOPPED != 0 {
        return Err(RequestError::NotStopped { command: command.name.into() });
    }
    let (when, remedy) = match phase {
        Phase::New => ("before `initialize`", "send `initialize` first"),
        Phase::Initialized if command.phases == NEW => ("twice", "start another session"),
        Phase::Initialized => ("before `launch` or `attach`", "launch or attach first"),
        Phase::Configuring if command.phases & INITIALIZED != 0 => ("twice", "disconnect first"),
        Phase::Configuring if command.phases == NEW => ("twice", "start another session"),
        Phase::Configuring => ("before the program runs", "send `configurationDone` first"),
        Phase::Running | Phase::Stopped => ("in a session that is under way", "disconnect first"),
        Phase::Ended => ("after the session has ended", "start debugging again"),
    };
    Err(RequestError::OutOfOrder { command: command.name.into(), when, remedy })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write;

    /// The table is the specification: a change shows here.
    #[test]
    fn legality_of_each_request_in_each_phase() {
        let phases = [
            Phase::New,
            Phase::Initialized,
            Phase::Configuring,
            Phase::Running,
            Phase::Stopped,
            Phase::Ended,
        ];
        let mut table = String::new();
        for command in COMMANDS {
            let marks: String =
                phases.iter().map(|p| if check(command, *p).is_ok() { 'x' } else { '-' }).collect();
            writeln!(table, "{marks} {}", command.name).unwrap();
        }
        // new, initialized, configuring, running, stopped, ended
        let expected = "\
x----- initialize
-x---- launch
-x---- attach
--x--- configurationDone
-xxxx- setBreakpoints
-xxxx- setExceptionBreakpoints
--xxx- breakpointLocations
--xxx- loadedSources
--xxx- source
--xxx- threads
----x- continue
---xx- pause
----x- next
----x- stepIn
----x- stepOut
----x- stackTrace
----x- scopes
---xx- variables
---xx- setVariable
--xxx- evaluate
--xxx- setExpression
--xxx- completions
----x- exceptionInfo
---xx- restart
-xxxxx terminate
xxxxxx disconnect
--xxx- technol/subscribe
--xxx- technol/trace
--xxx- technol/force
--xxx- technol/forced
";
        assert_eq!(table, expected);
    }

    #[test]
    fn a_request_at_the_wrong_time_is_told_what_to_do() {
        for (name, phase, text) in [
            ("launch", Phase::New, "`launch` is not possible before `initialize`; send `initialize` first"),
            ("initialize", Phase::Initialized, "`initialize` is not possible twice; start another session"),
            ("launch", Phase::Configuring, "`launch` is not possible twice; disconnect first"),
            (
                "launch",
                Phase::Stopped,
                "`launch` is not possible in a session that is under way; disconnect first",
            ),
            ("next", Phase::Running, "`next` needs a program that is stopped; use `pause` first"),
            (
                "next",
                Phase::Configuring,
                "`next` is not possible before the program runs; send `configurationDone` first",
            ),
            (
                "evaluate",
                Phase::Initialized,
                "`evaluate` is not possible before `launch` or `attach`; launch or attach first",
            ),
            (
                "threads",
                Phase::Ended,
                "`threads` is not possible after the session has ended; start debugging again",
            ),
        ] {
            let command = COMMANDS.iter().find(|c| c.name == name).unwrap();
            assert_eq!(check(command, phase).unwrap_err().to_string(), text);
        }
    }
}
