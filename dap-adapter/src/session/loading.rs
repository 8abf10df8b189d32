//! Getting a program onto a target: build, connect, compare, download.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use dap::events::{Event, ProgressEndEventBody, ProgressStartEventBody, ProgressUpdateEventBody};
use dap::types::OutputEventCategory;

use technol_image::container::{content_hash, encode_program};
use technol_image::op::Op;
use technol_image::program::ContentHash;
use technol_wire::message::{PROTOCOL_VERSION, PlcState, Request as Ask, Response, Status};

use crate::arguments::Policy;
use crate::connection::TargetSpec;
use crate::errors::RequestError;
use crate::ports;
use crate::project::{BuildFailure, BuiltProject, Problem};
use crate::source_map::SourceMap;
use crate::target_link::TargetLink;
use crate::tree::Tree;

use super::{Debuggee, How, Session};

/// Problems listed in the debug console.
const LISTED: usize = 100;

impl Session {
    /// Builds, and tells the outcome in the debug console.
    pub(super) fn build(&mut self, program: PathBuf, policy: Policy) -> Result<BuiltProject, RequestError> {
        let builder = Arc::clone(&self.builder);
        let result = self.aside(move || builder.build(&program, policy))?;
        match result {
            Ok(project) => {
                self.list(OutputEventCategory::Stderr, "error", &project.configuration_errors);
                self.list(OutputEventCategory::Console, "warning", &project.warnings);
                self.say(&project.summary);
                if project.image.debug.is_none() {
                    let (path, reason) = (project.root, "it was built without debug information".into());
                    return Err(BuildFailure::NoImage { path, reason }.into());
                }
                Ok(project)
            }
            Err(failure) => {
                if let BuildFailure::Errors(problems) = &failure {
                    self.list(OutputEventCategory::Stderr, "error", problems);
                }
                Err(failure.into())
            }
        }
    }

    fn list(&mut self, category: OutputEventCategory, kind: &str, problems: &[Problem]) {
        for p in problems.iter().take(LISTED) {
            let text =
                format!("{}:{}:{}: {kind} [{}]: {}", p.file.display(), p.line, p.column, p.code, p.message);
            self.output(category.clone(), &text, Some((&p.file, p.line)));
        }
        if problems.len() > LISTED {
            self.output(category, &format!("… and {} more", problems.len() - LISTED), None);
        }
    }

    /// Connects and makes sure that the target has this program.
    pub(super) fn load(
        &mut self,
        project: BuiltProject,
        spec: &TargetSpec,
        download: Policy,
        how: How,
    ) -> Result<(), RequestError> {
        let connector = Arc::clone(&self.connector);
        let wanted = spec.clone();
        let link = self.aside(move || connector.connect(&wanted))?.map_err(RequestError::Connect)?;
        self.target = Some(TargetLink::new(link));
        self.spec = Some(spec.clone());
        let result = self.greet().and_then(|status| {
            self.tell_policy()?;
            self.provide(&project, status, download)
        });
        match result {
            Ok(plc) => {
                self.debuggee = Some(debuggee(project, plc, how));
                Ok(())
            }
            Err(error) => {
                // The way is free for another try.
                if let Some(mut target) = self.target.take() {
                    target.goodbye(false);
                }
                Err(error)
            }
        }
    }

    /// Replaces the program on the target that is already connected.
    pub(super) fn reload(&mut self, project: BuiltProject, how: How) -> Result<(), RequestError> {
        let How::Launch(arguments) = &how else { return Ok(()) };
        let download = arguments.download;
        let (target, _) = self.parts()?;
        let Response::Status(status) = target.ask(Ask::Status)? else {
            return Err(RequestError::Refused("it did not tell its state".into()));
        };
        let plc = self.provide(&project, status, download)?;
        self.debuggee = Some(debuggee(project, plc, how));
        self.watch_again();
        Ok(())
    }

    pub(super) fn greet(&mut self) -> Result<Status, RequestError> {
        let Some(target) = &mut self.target else {
            return Err(RequestError::LinkLost("there is no target".into()));
        };
        match target.greet()? {
            Response::Hello { version, .. } if version != PROTOCOL_VERSION => {
                Err(RequestError::Protocol { theirs: version, ours: PROTOCOL_VERSION })
            }
            Response::Hello { status, .. } => Ok(status),
            _ => Err(RequestError::Connect(
                "what answers there is not a TECHNOL target; check the address".into(),
            )),
        }
    }

    /// Downloads the program when it has to be; answers the state of the PLC.
    fn provide(
        &mut self,
        project: &BuiltProject,
        status: Status,
        policy: Policy,
    ) -> Result<PlcState, RequestError> {
        let hash = content_hash(&project.image.program);
        let same = status.program == Some(hash);
        match policy {
            Policy::IfStale | Policy::Never if same => Ok(status.plc),
            Policy::Never => Err(RequestError::OtherProgram {
                program: project.image.program.name.clone(),
                running: status.program.map_or_else(|| ": it has none".into(), |_| String::new()),
            }),
            Policy::IfStale | Policy::Always => {
                self.download(&encode_program(&project.image.program), hash)?;
                Ok(PlcState::Stopped)
            }
        }
    }

    /// Loads a program. When the link is lost meanwhile and comes back, what has arrived need not be sent again.
    fn download(&mut self, bytes: &[u8], hash: ContentHash) -> Result<(), RequestError> {
        loop {
            match self.download_once(bytes.to_vec(), hash) {
                Err(RequestError::LinkLost(why)) if self.may_reconnect() => self.reach_again(&why)?,
                other => return other,
            }
        }
    }

    fn download_once(&mut self, bytes: Vec<u8>, hash: ContentHash) -> Result<(), RequestError> {
        let len = bytes.len() as u32;
        let Some(target) = &mut self.target else {
            return Err(RequestError::LinkLost("there is no target".into()));
        };
        target.ask(Ask::Download { len, hash })?;
        target.download(bytes);
        self.progress_start(len);
        let result = self.wait_for_download(len);
        self.progress_end();
        result?;
        if let Some(target) = &mut self.target {
            target.ask(Ask::Commit)?;
        }
        self.say(&format!("downloaded {len} bytes"));
        Ok(())
    }

    fn wait_for_download(&mut self, len: u32) -> Result<(), RequestError> {
        let mut told = 0;
        loop {
            let Some(target) = &mut self.target else { return Err(RequestError::Cancelled) };
            target.pump(Duration::from_millis(20));
            let transfer = target.transfer();
            if let Some(why) = target.lost() {
                return Err(RequestError::LinkLost(why.to_owned()));
            }
            if transfer.complete {
                return Ok(());
            }
            let percent = u64::from(transfer.done) * 100 / u64::from(len.max(1));
            if percent >= told + 5 {
                told = percent;
                self.progress_update(percent as i64);
            }
            if self.interrupted() {
                return Err(RequestError::Cancelled);
            }
        }
    }

    fn progress_start(&mut self, len: u32) {
        if self.client.progress {
            self.out.event(&Event::ProgressStart(ProgressStartEventBody {
                progress_id: "download".into(),
                title: "Downloading the PLC program".into(),
                message: Some(format!("{len} bytes")),
                percentage: Some(0),
                ..ProgressStartEventBody::default()
            }));
        }
    }

    fn progress_update(&mut self, percentage: i64) {
        if self.client.progress {
            self.out.event(&Event::ProgressUpdate(ProgressUpdateEventBody {
                progress_id: "download".into(),
                message: None,
                percentage: Some(percentage),
            }));
        }
    }

    fn progress_end(&mut self) {
        if self.client.progress {
            let progress_id = "download".into();
            self.out.event(&Event::ProgressEnd(ProgressEndEventBody { progress_id, message: None }));
        }
    }
}

fn debuggee(project: BuiltProject, plc: PlcState, how: How) -> Debuggee {
    let program = Arc::new(project.image.program.clone());
    let debug = Arc::new(project.image.debug.clone().unwrap_or_default());
    let map = SourceMap::new(&project.root, &program, &debug, project.encoding);
    let machine = program.code.iter().any(|op| matches!(op, Op::Assembler { .. } | Op::AssemblerJump { .. }));
    let ports = ports::used(&program, &debug);
    let tree = Tree::new(&debug, &ports, machine);
    Debuggee { how, project, program, debug, map, ports, tree, plc, stop: None, fault: None }
}
