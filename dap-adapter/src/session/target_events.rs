//! What the target reports, told to the client.

use std::time::Duration;

use dap::events::{ContinuedEventBody, Event, StoppedEventBody, ThreadEventBody};
use dap::types::{OutputEventCategory, StoppedEventReason, ThreadEventReason};

use technol_wire::message::{Event as Said, Fault, PlcState, Status, StopReason, Stopped};

use crate::target_link::TargetEvent;

use super::launch::is_over;
use super::phase::Phase;
use super::stack::{PLC_THREAD, fault_name, fault_text, position, thread_of_sequence};
use super::{How, Session, Stop, Timer};

/// The details of a fault follow its stop at once; after this long they will not come any more.
const DETAILS: Duration = Duration::from_millis(500);
/// Overruns come in swarms: they are counted for this long.
const OVERRUNS: Duration = Duration::from_secs(1);

impl Session {
    pub(super) fn take_target_events(&mut self) {
        while let Some(event) = self.target.as_mut().and_then(crate::target_link::TargetLink::next_event) {
            match event {
                TargetEvent::Event(said) => self.hear(said),
                TargetEvent::Lost(why) => self.lose_target(&why),
            }
            self.flush();
        }
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Stopped(stopped) => self.on_stopped(stopped),
            Said::Resumed => self.on_resumed(),
            Said::State(status) => self.on_state(status),
            Said::Fault(fault) => self.on_fault(fault),
            Said::Message { cycle, number, sub_id, set, parameters, pc } => {
                let sub_id = sub_id.map(|n| format!("/{n}")).unwrap_or_default();
                let values: Vec<String> = parameters.iter().map(i64::to_string).collect();
                let values =
                    if values.is_empty() { String::new() } else { format!(" ({})", values.join(", ")) };
                let what = if set { "" } else { " removed" };
                let text = format!("message {number}{sub_id}{what}{values}, cycle {cycle}");
                self.output_at(OutputEventCategory::Stdout, &text, pc);
            }
            Said::Overrun { fast, cycle } => self.on_overrun(fast, cycle),
            Said::Log(text) => self.say(&text),
        }
    }

    fn output_at(&mut self, category: OutputEventCategory, text: &str, pc: u32) {
        let at = self.debuggee.as_ref().and_then(|d| {
            let (file, line) = position(d, pc)?;
            Some((d.map.path(file)?.to_owned(), line))
        });
        self.output(category, text, at.as_ref().map(|(path, line)| (path.as_path(), *line)));
    }

    fn on_stopped(&mut self, stopped: Stopped) {
        let Some(debuggee) = &mut self.debuggee else { return };
        if self.terminating || !matches!(self.phase, Phase::Running | Phase::Stopped) {
            return;
        }
        let reason = stopped.reason;
        let known_fault = debuggee.fault.is_some();
        debuggee.stop = Some(Stop { stopped, sequences: None });
        if reason == StopReason::Fault {
            if known_fault {
                self.announce_fault();
            } else {
                self.start_timer(DETAILS, Timer::FaultWithoutDetails);
            }
            return;
        }
        self.announce_stop(None);
    }

    /// Tells the client about the stop that was just taken up.
    fn announce_stop(&mut self, text: Option<String>) {
        let Some(stopped) = self.debuggee.as_ref().and_then(|d| Some(d.stop.as_ref()?.stopped.clone()))
        else {
            return;
        };
        self.phase = Phase::Stopped;
        let events = self.stop_events(&stopped, text);
        self.after.extend(events);
        self.tell_forced_soon(stopped.reason);
    }

    /// `thread` (where it is new) and `stopped`.
    pub(super) fn stop_events(&mut self, stopped: &Stopped, text: Option<String>) -> Vec<Event> {
        let thread_id = thread_of_sequence(stopped.sequence);
        let mut events = Vec::new();
        if self.threads_announced.insert(thread_id) {
            let reason = ThreadEventReason::Started;
            events.push(Event::Thread(ThreadEventBody { reason, thread_id }));
        }
        let hit = self.breakpoints.at(stopped.pc);
        let (reason, description) = match stopped.reason {
            StopReason::Breakpoint => (StoppedEventReason::Breakpoint, "break-point"),
            StopReason::Step => (StoppedEventReason::Step, "step"),
            StopReason::Pause => (StoppedEventReason::Pause, "paused"),
            StopReason::Entry => (StoppedEventReason::Entry, "before the first statement"),
            StopReason::Fault => (StoppedEventReason::Exception, "PLC fault"),
        };
        // Short: editors show it beside the name of the thread; the frame has the place.
        events.push(Event::Stopped(StoppedEventBody {
            reason,
            description: Some(format!("{description}, cycle {}", stopped.cycle)),
            thread_id: Some(thread_id),
            preserve_focus_hint: None,
            text,
            all_threads_stopped: Some(true),
            hit_breakpoint_ids: (stopped.reason == StopReason::Breakpoint && !hit.is_empty()).then_some(hit),
        }));
        events
    }

    /// Somebody else let the program go on.
    pub(super) fn on_resumed(&mut self) {
        if self.phase != Phase::Stopped {
            return;
        }
        if let Some(debuggee) = &mut self.debuggee {
            debuggee.stop = None;
        }
        self.phase = Phase::Running;
        self.after.push(Event::Continued(ContinuedEventBody {
            thread_id: PLC_THREAD,
            all_threads_continued: Some(true),
        }));
    }

    pub(super) fn on_state(&mut self, status: Status) {
        let Some(debuggee) = &mut self.debuggee else { return };
        let before = std::mem::replace(&mut debuggee.plc, status.plc);
        if self.terminating && is_over(status.plc) {
            self.terminating = false;
            self.timers.retain(|(_, timer)| *timer != Timer::GiveUpTerminate);
            self.end(Some(0));
        } else if before != status.plc {
            self.say(&format!("PLC {}, cycle {}", state_name(status.plc), status.cycle));
        }
        if matches!(status.plc, PlcState::Starting | PlcState::Running)
            && let Some(debuggee) = &mut self.debuggee
        {
            debuggee.fault = None;
        }
    }

    fn on_fault(&mut self, fault: Fault) {
        let Some(debuggee) = &mut self.debuggee else { return };
        let text = format!("PLC fault: {}", fault_text(debuggee, &fault));
        let pc = fault.pc;
        debuggee.fault = Some(fault);
        self.output_at(OutputEventCategory::Stderr, &text, pc);
        let waiting = self.timers.len();
        self.timers.retain(|(_, timer)| *timer != Timer::FaultWithoutDetails);
        if self.timers.len() < waiting {
            self.announce_fault();
        }
    }

    /// The program has failed and stands: a stop, or the end of the session when nobody wants to look.
    pub(super) fn announce_fault(&mut self) {
        let Some(debuggee) = &self.debuggee else { return };
        if self.break_on_fault {
            let text = debuggee.fault.as_ref().map(|f| fault_name(f.kind).to_owned());
            self.announce_stop(text);
        } else if matches!(debuggee.how, How::Launch(_)) {
            self.end(Some(1));
        } else {
            self.important("the PLC stands after a fault");
        }
    }

    fn on_overrun(&mut self, fast: bool, cycle: u64) {
        self.overruns += 1;
        if self.overruns == 1 {
            let raster = if fast { "1 ms" } else { "20 ms" };
            self.complain(&format!("the {raster} raster was overrun in cycle {cycle}"));
            self.start_timer(OVERRUNS, Timer::Overruns);
        }
    }

    pub(super) fn tell_overruns(&mut self) {
        let more = std::mem::take(&mut self.overruns).saturating_sub(1);
        if more > 0 {
            self.complain(&format!("{more} more overruns within a second"));
        }
    }

    fn lose_target(&mut self, why: &str) {
        self.target = None;
        if self.begin_again(why) {
            return;
        }
        if matches!(self.phase, Phase::New | Phase::Initialized | Phase::Ended) {
            return;
        }
        self.important(&format!("the link to the target is lost: {why}"));
        self.leave_forces_behind();
        let asked_for = std::mem::take(&mut self.terminating);
        self.end(Some(i64::from(!asked_for)));
    }
}

fn state_name(state: PlcState) -> &'static str {
    match state {
        PlcState::Empty => "has no program",
        PlcState::Stopped => "stopped",
        PlcState::Starting => "starting (waits for MODULE_INIT_FINISHED)",
        PlcState::Running => "running",
        PlcState::Stopping => "stopping (waits for MODULE_DONE_FINISHED)",
        PlcState::Halted => "halted",
        PlcState::Faulted => "stands after a fault",
    }
}
