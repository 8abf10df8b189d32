//! A link that is lost and comes back: the session goes on with its break-points.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

use technol_image::container::content_hash;
use technol_wire::message::{LostPolicy, Request as Ask, Status, feature};

use crate::arguments::OnLinkLost;
use crate::connection::{ByteLink, TargetSpec};
use crate::errors::RequestError;
use crate::target_link::TargetLink;

use super::Session;
use super::phase::Phase;

/// Between two tries.
const PAUSE: Duration = Duration::from_millis(250);

/// Tries to reach a target again.
pub(super) struct Again {
    until: Instant,
    next: Instant,
    /// A try that is under way, on a thread of its own: opening a link may take seconds.
    attempt: Option<Receiver<Result<Box<dyn ByteLink>, String>>>,
    /// Why the last one failed.
    why: String,
}

impl Session {
    /// A link to a target somewhere else is tried again, unless the user wants to be asked.
    pub(super) fn may_reconnect(&self) -> bool {
        self.link_arguments.reconnect > 0 && matches!(self.spec, Some(TargetSpec::Address { .. }))
    }

    /// The link is lost: begins to try again, if that makes sense now.
    pub(super) fn begin_again(&mut self, why: &str) -> bool {
        let in_session = matches!(self.phase, Phase::Configuring | Phase::Running | Phase::Stopped);
        if !in_session || self.terminating || self.debuggee.is_none() || !self.may_reconnect() {
            return false;
        }
        self.tell_loss(why);
        self.watching.lost();
        let (now, why) = (Instant::now(), why.to_owned());
        self.again = Some(Again { until: now + self.patience(), next: now + PAUSE, attempt: None, why });
        true
    }

    fn patience(&self) -> Duration {
        Duration::from_secs(u64::from(self.link_arguments.reconnect))
    }

    fn tell_loss(&mut self, why: &str) {
        let meanwhile = match self.link_arguments.on_link_lost {
            OnLinkLost::RunOn => "a program that was stopped runs on meanwhile",
            OnLinkLost::StayStopped => "a program that was stopped stays so",
            OnLinkLost::StopPlc => "a PLC whose program was stopped is stopped",
        };
        let seconds = self.link_arguments.reconnect;
        self.important(&format!(
            "the link to the target is lost: {why}; it is tried again for {seconds} s; {meanwhile}"
        ));
    }

    /// Lets the tries go on; called all the time.
    pub(super) fn try_again(&mut self) {
        let Some(again) = &mut self.again else { return };
        let now = Instant::now();
        let outcome = match &again.attempt {
            Some(attempt) => match attempt.try_recv() {
                Ok(outcome) => outcome,
                Err(TryRecvError::Empty) => return,
                Err(TryRecvError::Disconnected) => Err("the try was given up".to_owned()),
            },
            None if now >= again.until => {
                let why = again.why.clone();
                self.leave_forces_behind();
                self.give_up(&format!("the target did not come back: {why}"));
                return;
            }
            None if now < again.next => return,
            None => {
                let attempt = self.attempt();
                if let Some(again) = &mut self.again {
                    again.attempt = Some(attempt);
                }
                return;
            }
        };
        let result = outcome.map_err(RequestError::Connect).and_then(|link| {
            self.target = Some(TargetLink::new(link));
            self.greet()
        });
        match result {
            Ok(status) => self.take_up(status),
            Err(error) => self.try_later(&error),
        }
    }

    fn attempt(&self) -> Receiver<Result<Box<dyn ByteLink>, String>> {
        let (done, outcome) = channel();
        if let Some(spec) = self.spec.clone() {
            let connector = Arc::clone(&self.connector);
            // Nobody waits for it when the session has ended.
            std::thread::spawn(move || done.send(connector.connect(&spec)));
        }
        outcome
    }

    fn try_later(&mut self, error: &RequestError) {
        self.target = None;
        if let Some(again) = &mut self.again {
            again.attempt = None;
            again.next = Instant::now() + PAUSE;
            again.why = error.to_string();
        }
    }

    fn give_up(&mut self, why: &str) {
        self.again = None;
        self.target = None;
        self.important(why);
        self.end(Some(1));
        self.flush();
    }

    /// The target is there again: it gets back what it lost with the session, and the client hears how things are.
    fn take_up(&mut self, status: Status) {
        let same = self.debuggee.as_ref().is_some_and(|d| status.program == Some(content_hash(&d.program)));
        if !same {
            // What was forced went with the program.
            self.forcing.forget();
            self.give_up(
                "the target is back, but with another program or none; it was probably switched off and on",
            );
            return;
        }
        let again = self.again.take();
        if let Err(error) = self.restore() {
            self.again = again;
            self.try_later(&error);
            return;
        }
        self.say("the link to the target is back");
        if !status.held && self.phase == Phase::Stopped {
            self.on_resumed();
        }
        self.on_state(status);
        self.flush();
    }

    /// What a target forgets with its host.
    fn restore(&mut self) -> Result<(), RequestError> {
        self.tell_policy()?;
        self.force_again()?;
        if self.phase != Phase::Configuring {
            self.arm_breakpoints()?;
        }
        self.watching.resume();
        Ok(())
    }

    /// Tells the target what to do when the link is lost.
    pub(super) fn tell_policy(&mut self) -> Result<(), RequestError> {
        let policy = LostPolicy::from(self.link_arguments.on_link_lost);
        let Some(target) = &mut self.target else { return Ok(()) };
        if target.features() & feature::LOST_POLICY != 0 {
            target.ask(Ask::OnLinkLost(policy))?;
        } else if policy != LostPolicy::RunOn {
            self.complain(
                "this target does not know `onLinkLost`: a stopped program runs on when the link is lost",
            );
        }
        Ok(())
    }

    /// Waits until the target is there again, in the middle of a download.
    pub(super) fn reach_again(&mut self, why: &str) -> Result<(), RequestError> {
        self.tell_loss(why);
        let until = Instant::now() + self.patience();
        let mut last = why.to_owned();
        while Instant::now() < until {
            self.target = None;
            self.aside(|| std::thread::sleep(PAUSE))?;
            let Some(spec) = self.spec.clone() else { break };
            let connector = Arc::clone(&self.connector);
            match self.aside(move || connector.connect(&spec))? {
                Ok(link) => {
                    self.target = Some(TargetLink::new(link));
                    match self.greet().and_then(|_| self.tell_policy()) {
                        Ok(()) => {
                            self.say("the link to the target is back");
                            return Ok(());
                        }
                        Err(error) => last = error.to_string(),
                    }
                }
                Err(error) => last = error,
            }
        }
        self.target = None;
        Err(RequestError::LinkLost(last))
    }
}
