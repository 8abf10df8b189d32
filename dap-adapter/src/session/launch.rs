//! The life of a session: initialize, launch or attach, configurationDone, restart, terminate, disconnect.

use std::time::{Duration, Instant};

use dap::events::{BreakpointEventBody, Event, ExitedEventBody, ProcessEventBody, ThreadEventBody};
use dap::requests::DisconnectArguments;
use dap::types::{
    BreakpointEventReason, Capabilities, ExceptionBreakpointsFilter, OutputEventCategory,
    ProcessEventStartMethod, ThreadEventReason,
};
use serde_json::Value;

use technol_wire::message::{PlcState, Request as Ask, Response, StopReason, Stopped};

use crate::arguments::{AttachArguments, LaunchArguments, LinkArguments, Policy};
use crate::connection::Clock;
use crate::errors::RequestError;
use crate::request::Request;

use super::phase::Phase;
use super::stack::PLC_THREAD;
use super::{Answer, ClientTraits, How, Session, Stop, Timer, body};

/// MODULE_DONE and the control's own ending get this long.
const ENDING: Duration = Duration::from_secs(3);
/// The one exception filter.
pub(super) const FAULT_FILTER: &str = "fault";

impl Session {
    pub(super) fn initialize(&mut self, request: &Request) -> Answer {
        // Only preferences, each for itself: a client that leaves out even `adapterID` is served as well.
        let says = |field: &str, otherwise: bool| request.arguments[field].as_bool().unwrap_or(otherwise);
        self.client = ClientTraits {
            first_line: i64::from(says("linesStartAt1", true)),
            first_column: i64::from(says("columnsStartAt1", true)),
            invalidated: says("supportsInvalidatedEvent", false),
            progress: says("supportsProgressReporting", false),
            menus: request.arguments["clientID"] == "vscode",
        };
        self.phase = Phase::Initialized;
        body(&capabilities())
    }

    pub(super) fn launch(&mut self, request: &Request) -> Answer {
        let arguments: LaunchArguments = request.parse()?;
        let project = self.build(arguments.program.clone(), arguments.build)?;
        let spec = target_spec(arguments.target.as_deref(), &project, arguments.clock, &arguments.link);
        self.link_arguments = arguments.link.clone();
        self.load(project, &spec, arguments.download, How::Launch(arguments.clone()))?;
        self.loaded();
        Ok(Value::Null)
    }

    pub(super) fn attach(&mut self, request: &Request) -> Answer {
        let arguments: AttachArguments = request.parse()?;
        let project = self.build(arguments.program.clone(), arguments.build)?;
        let spec = target_spec(arguments.target.as_deref(), &project, Clock::Real, &arguments.link);
        self.link_arguments = arguments.link.clone();
        if matches!(spec, crate::connection::TargetSpec::Embedded { .. }) {
            return Err(RequestError::Connect(
                "an embedded target lives only as long as its session, so there is nothing to attach to; set `target` \
                 to \"tcp:HOST:PORT\" or \"serial:DEVICE\", or use a launch configuration"
                    .into(),
            ));
        }
        self.load(project, &spec, Policy::Never, How::Attach)?;
        self.loaded();
        Ok(Value::Null)
    }

    /// The program is there: break-points that came early are placed, the client may configure.
    fn loaded(&mut self) {
        self.phase = Phase::Configuring;
        for breakpoint in self.place_all_breakpoints() {
            let reason = BreakpointEventReason::Changed;
            self.after.push(Event::Breakpoint(BreakpointEventBody { reason, breakpoint }));
        }
        self.after.push(Event::Initialized);
    }

    pub(super) fn configuration_done(&mut self, _request: &Request) -> Answer {
        self.arm_breakpoints()?;
        let (_, debuggee) = self.parts()?;
        let (name, launched) = (debuggee.program.name.clone(), matches!(debuggee.how, How::Launch(_)));
        let held = if launched {
            self.start_program()?;
            None
        } else {
            self.tell_forced()?;
            self.held_at_attach()?
        };
        self.phase = Phase::Running;
        let start_method =
            if launched { ProcessEventStartMethod::Launch } else { ProcessEventStartMethod::Attach };
        self.after.push(Event::Process(ProcessEventBody {
            name,
            start_method: Some(start_method),
            ..ProcessEventBody::default()
        }));
        self.announce_cycle_thread();
        if let Some(stopped) = held {
            self.hold(stopped);
        }
        Ok(Value::Null)
    }

    /// Starts the PLC from power-on.
    fn start_program(&mut self) -> Result<(), RequestError> {
        self.end_program()?;
        let forces = self.forcing.is_active();
        let (target, debuggee) = self.parts()?;
        let How::Launch(arguments) = &debuggee.how else { return Ok(()) };
        let stop_on_entry = arguments.stop_on_entry && !arguments.no_debug;
        debuggee.stop = None;
        debuggee.fault = None;
        target.forget_stops();
        target.ask(Ask::Start { cold: true, stop_on_entry: stop_on_entry || forces })?;
        if forces { self.force_at_start(stop_on_entry) } else { Ok(()) }
    }

    /// Ends a program that is running, so that it can be started again.
    fn end_program(&mut self) -> Result<(), RequestError> {
        let deadline = Instant::now() + ENDING;
        let mut asked = false;
        loop {
            let (target, _) = self.parts()?;
            let Response::Status(status) = target.ask(Ask::Status)? else { return Ok(()) };
            if is_over(status.plc) {
                return Ok(());
            }
            if !asked {
                if status.held {
                    target.ask(Ask::Resume(technol_wire::message::Resume::Continue))?;
                }
                target.ask(Ask::Stop)?;
                asked = true;
            }
            if Instant::now() >= deadline {
                return Err(RequestError::Refused(
                    "the running program does not end (MODULE_DONE_FINISHED is not reached); switch the target off and on"
                        .into(),
                ));
            }
            target.pump(Duration::from_millis(10));
        }
    }

    /// When the program is already held: where.
    fn held_at_attach(&mut self) -> Result<Option<Stopped>, RequestError> {
        let (target, debuggee) = self.parts()?;
        let Response::Status(status) = target.ask(Ask::Status)? else { return Ok(None) };
        debuggee.plc = status.plc;
        if !status.held {
            if is_over(status.plc) {
                self.say("the PLC is not running; `plc start` in this console starts it");
            }
            return Ok(None);
        }
        let Response::CallStack(frames) = target.ask(Ask::CallStack)? else { return Ok(None) };
        let Response::Registers(registers) = target.ask(Ask::Registers)? else { return Ok(None) };
        let Some(top) = frames.first().copied() else { return Ok(None) };
        Ok(Some(Stopped {
            reason: StopReason::Pause,
            pc: top.pc,
            module: top.module,
            sequence: top.sequence,
            cycle: status.cycle,
            registers,
            frames,
        }))
    }

    /// Some clients forget stops of threads they never heard of.
    fn announce_cycle_thread(&mut self) {
        if self.threads_announced.insert(PLC_THREAD) {
            self.after.push(Event::Thread(ThreadEventBody {
                reason: ThreadEventReason::Started,
                thread_id: PLC_THREAD,
            }));
        }
    }

    /// Takes up a stop that was found, not reported.
    fn hold(&mut self, stopped: Stopped) {
        let events = self.stop_events(&stopped, None);
        self.after.extend(events);
        if let Some(debuggee) = &mut self.debuggee {
            debuggee.stop = Some(Stop { stopped, sequences: None });
            self.phase = Phase::Stopped;
        }
    }

    /// Builds again, loads what changed, starts from power-on. The client keeps its session.
    pub(super) fn restart(&mut self, request: &Request) -> Answer {
        let How::Launch(old) = self.debuggee()?.how.clone() else {
            return Err(RequestError::OutOfOrder {
                command: request.command.clone(),
                when: "after `attach`",
                remedy: "use a launch configuration to start the program anew",
            });
        };
        // A client may send the launch configuration as it is now.
        let arguments = match request.arguments.get("arguments") {
            Some(new) if new.get("program").is_some() => {
                Request { arguments: new.clone(), ..request.clone() }.parse::<LaunchArguments>()?
            }
            _ => old,
        };
        let project = self.build(arguments.program.clone(), arguments.build)?;
        self.reload(project, How::Launch(arguments))?;
        self.breakpoints.forget_modifications();
        for breakpoint in self.place_all_breakpoints() {
            let reason = BreakpointEventReason::Changed;
            self.after.push(Event::Breakpoint(BreakpointEventBody { reason, breakpoint }));
        }
        self.arm_breakpoints()?;
        self.start_program()?;
        self.phase = Phase::Running;
        Ok(Value::Null)
    }

    /// Ends the PLC in good order, through MODULE_DONE.
    pub(super) fn terminate(&mut self, _request: &Request) -> Answer {
        let stopped = self.phase == Phase::Stopped;
        if self.phase == Phase::Ended || self.debuggee.is_none() {
            self.end(None);
            return Ok(Value::Null);
        }
        let (target, debuggee) = self.parts()?;
        debuggee.stop = None;
        target.ask(Ask::SetBreakpoints { pcs: Vec::new() })?;
        let Response::Status(status) = target.ask(Ask::Status)? else {
            return Err(RequestError::Refused("it did not tell its state".into()));
        };
        if is_over(status.plc) {
            self.end(Some(0));
            return Ok(Value::Null);
        }
        if stopped || status.held {
            target.ask(Ask::Resume(technol_wire::message::Resume::Continue))?;
        }
        target.ask(Ask::Stop)?;
        self.phase = Phase::Running;
        self.terminating = true;
        self.start_timer(ENDING, Timer::GiveUpTerminate);
        Ok(Value::Null)
    }

    #[expect(clippy::unnecessary_wraps, reason = "handlers have one signature")]
    pub(super) fn disconnect(&mut self, request: &Request) -> Answer {
        let arguments: DisconnectArguments = request.parse().unwrap_or_default();
        self.leave_target(arguments.terminate_debuggee);
        self.finished = true;
        Ok(Value::Null)
    }

    /// Lets the target go. What was launched ends, what was attached to goes on, unless asked otherwise.
    pub(super) fn leave_target(&mut self, stop: Option<bool>) {
        let launched = self.debuggee.as_ref().is_some_and(|d| matches!(d.how, How::Launch(_)));
        self.again = None;
        self.let_forces_go();
        if let Some(mut target) = self.target.take() {
            target.goodbye(stop.unwrap_or(launched));
        }
        self.debuggee = None;
    }

    /// The session is over for the client; it still has to disconnect.
    pub(super) fn end(&mut self, exit_code: Option<i64>) {
        if self.phase == Phase::Ended {
            return;
        }
        self.phase = Phase::Ended;
        if let Some(exit_code) = exit_code {
            self.after.push(Event::Exited(ExitedEventBody { exit_code }));
        }
        self.after.push(Event::Terminated(None));
    }

    pub(super) fn on_timer(&mut self, timer: Timer) {
        match timer {
            Timer::ReleaseKey(key) => self.release_key(key),
            Timer::FaultWithoutDetails => self.announce_fault(),
            Timer::Overruns => self.tell_overruns(),
            Timer::Forced => self.tell_forced_at_stop(),
            Timer::GiveUpTerminate if self.terminating => {
                self.terminating = false;
                self.complain(
                    "the PLC did not end in time (MODULE_DONE_FINISHED is not reached); it is cut off",
                );
                self.leave_target(Some(true));
                self.end(Some(1));
            }
            Timer::GiveUpTerminate => {}
        }
        self.flush();
    }

    /// Sends events that follow no response.
    pub(super) fn flush(&mut self) {
        for event in std::mem::take(&mut self.after) {
            self.out.event(&event);
        }
    }

    pub(super) fn important(&mut self, text: &str) {
        self.output(OutputEventCategory::Important, text, None);
    }
}

/// Nothing is running.
pub(super) fn is_over(plc: PlcState) -> bool {
    matches!(plc, PlcState::Empty | PlcState::Stopped | PlcState::Halted | PlcState::Faulted)
}

fn target_spec(
    asked: Option<&str>,
    project: &crate::project::BuiltProject,
    clock: Clock,
    link: &LinkArguments,
) -> crate::connection::TargetSpec {
    use crate::connection::TargetSpec;
    let address = asked.or(project.target.as_deref()).map_or("embedded", str::trim);
    if address.is_empty() || address.eq_ignore_ascii_case("embedded") {
        TargetSpec::Embedded { project: project.root.clone(), machine: project.machine.clone(), clock }
    } else {
        TargetSpec::Address { address: address.to_owned(), token_file: link.token_file.clone() }
    }
}

/// What this adapter can do; a test compares it with the table of requests.
pub(super) fn capabilities() -> Capabilities {
    let yes = Some(true);
    Capabilities {
        supports_configuration_done_request: yes,
        supports_evaluate_for_hovers: yes,
        exception_breakpoint_filters: Some(vec![ExceptionBreakpointsFilter {
            filter: FAULT_FILTER.into(),
            label: "PLC faults".into(),
            description: Some("Stop where the PLC fails: division by zero, endless loop, …".into()),
            default: yes,
            ..ExceptionBreakpointsFilter::default()
        }]),
        supports_set_variable: yes,
        supports_completions_request: yes,
        supports_restart_request: yes,
        supports_value_formatting_options: yes,
        supports_exception_info_request: yes,
        support_terminate_debuggee: yes,
        supports_loaded_sources_request: yes,
        supports_set_expression: yes,
        supports_terminate_request: yes,
        supports_breakpoint_locations_request: yes,
        ..Capabilities::default()
    }
}
