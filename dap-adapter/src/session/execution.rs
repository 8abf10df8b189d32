//! Going on, stepping, pausing.

use dap::responses::ContinueResponse;
use serde_json::{Value, json};

use technol_wire::message::{Request as Ask, Resume};

use crate::errors::RequestError;
use crate::request::Request;

use super::phase::Phase;
use super::stack::sequence_of_thread;
use super::{Answer, Session};

impl Session {
    pub(super) fn continue_(&mut self, _request: &Request) -> Answer {
        self.resume(Resume::Continue)?;
        let response = ContinueResponse { all_threads_continued: Some(true) };
        // The `dap` crate spells the field wrong.
        Ok(json!({ "allThreadsContinued": response.all_threads_continued }))
    }

    /// Stays in the mechanism whose thread is stepped, however many cycles it waits.
    pub(super) fn next(&mut self, request: &Request) -> Answer {
        let sequence = self.thread_argument(request)?;
        self.resume(Resume::Over { sequence })
    }

    pub(super) fn step_in(&mut self, _request: &Request) -> Answer {
        self.resume(Resume::Into)
    }

    pub(super) fn step_out(&mut self, _request: &Request) -> Answer {
        self.resume(Resume::Out)
    }

    pub(super) fn pause(&mut self, _request: &Request) -> Answer {
        if self.phase == Phase::Stopped {
            return Ok(Value::Null); // it stopped by itself meanwhile
        }
        let (target, _) = self.parts()?;
        match target.ask(Ask::Pause) {
            Err(RequestError::Refused(_)) if target.has_stop() => Ok(Value::Null),
            result => result.map(|_| Value::Null),
        }
    }

    fn resume(&mut self, how: Resume) -> Answer {
        let (target, debuggee) = self.parts()?;
        if debuggee.fault.is_some() {
            return Err(RequestError::Faulted);
        }
        target.ask(Ask::Resume(how))?;
        debuggee.stop = None;
        self.phase = Phase::Running;
        Ok(Value::Null)
    }

    /// The mechanism that `threadId` stands for; the one that is stopped when there is none.
    fn thread_argument(&self, request: &Request) -> Result<Option<u16>, RequestError> {
        let (debuggee, stop) = self.stop(request)?;
        let Some(id) = request.arguments["threadId"].as_i64() else {
            return Ok(stop.stopped.sequence);
        };
        sequence_of_thread(debuggee, id)
    }
}
