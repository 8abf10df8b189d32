//! Break-points: from lines of an editor to statements on the target.

use std::collections::BTreeMap;

use dap::requests::{
    BreakpointLocationsArguments, SetBreakpointsArguments, SetExceptionBreakpointsArguments,
};
use dap::responses::{BreakpointLocationsResponse, SetBreakpointsResponse, SetExceptionBreakpointsResponse};
use dap::types::{Breakpoint, BreakpointLocation};

use technol_analysis::project::decode;
use technol_image::container::hash_bytes;
use technol_image::op::Pc;
use technol_wire::message::{BreakpointState, Request as Ask, Response};

use crate::errors::RequestError;
use crate::request::Request;
use crate::source_map::NoPlace;

use super::launch::FAULT_FILTER;
use super::{Answer, Debuggee, How, Session, body, sources};

/// Everything the client asked for, by the path it used.
#[derive(Debug, Default)]
pub(super) struct Breakpoints {
    files: BTreeMap<String, FileBreakpoints>,
    next_id: i64,
}

#[derive(Debug, Default)]
struct FileBreakpoints {
    asked: Vec<Asked>,
    /// The editor told that its text differs from what was built.
    modified: bool,
}

#[derive(Clone, Debug)]
struct Asked {
    id: i64,
    /// 1-based line as asked for.
    line: u32,
    /// A condition, hit count or log text came along.
    conditional: bool,
    placed: Result<(u32, Vec<Pc>), String>,
}

impl Breakpoints {
    /// Numbers of the break-points at an operation.
    pub(super) fn at(&self, pc: Pc) -> Vec<i64> {
        let all = self.files.values().flat_map(|f| &f.asked);
        all.filter(|a| a.placed.as_ref().is_ok_and(|(_, pcs)| pcs.contains(&pc))).map(|a| a.id).collect()
    }

    fn pcs(&self) -> Vec<Pc> {
        let all = self.files.values().flat_map(|f| &f.asked);
        let mut pcs: Vec<Pc> = all.filter_map(|a| a.placed.as_ref().ok()).flat_map(|p| p.1.clone()).collect();
        pcs.sort_unstable();
        pcs.dedup();
        pcs
    }

    /// The program was built from the files as they are now.
    pub(super) fn forget_modifications(&mut self) {
        for file in self.files.values_mut() {
            file.modified = false;
        }
    }

    /// Replaces the break-points of a file; one at a line that had one keeps its number.
    fn replace(&mut self, path: &str, lines: &[(u32, bool)], modified: bool) {
        let mut old = self.files.remove(path).unwrap_or_default().asked;
        let mut asked = Vec::new();
        for (line, conditional) in lines {
            let id = if let Some(at) = old.iter().position(|a| a.line == *line) {
                old.swap_remove(at).id
            } else {
                self.next_id += 1;
                self.next_id
            };
            asked.push(Asked { id, line: *line, conditional: *conditional, placed: Err(WAITING.into()) });
        }
        if !asked.is_empty() {
            self.files.insert(path.to_owned(), FileBreakpoints { asked, modified });
        }
    }
}

const WAITING: &str = "waits for the program to be loaded";

impl Session {
    pub(super) fn set_breakpoints(&mut self, request: &Request) -> Answer {
        let arguments: SetBreakpointsArguments = request.parse()?;
        let Some(path) = arguments.source.path.as_deref() else {
            return Err(RequestError::Source("break-points need a source with a path".into()));
        };
        #[allow(deprecated)] // old clients send nothing else
        let lines: Vec<(u32, bool)> = match (&arguments.breakpoints, &arguments.lines) {
            (Some(list), _) => list.iter().map(|b| self.line_in(b.line)).zip(conditions(request)).collect(),
            (None, Some(lines)) => lines.iter().map(|l| (self.line_in(*l), false)).collect(),
            (None, None) => Vec::new(),
        };
        self.breakpoints.replace(path, &lines, arguments.source_modified.unwrap_or(false));
        let mut breakpoints = self.place_breakpoints(path);
        if self.debuggee.is_some() {
            self.arm_breakpoints()?;
            breakpoints = self.shown(path);
        }
        body(&SetBreakpointsResponse { breakpoints })
    }

    /// Places the break-points of all files anew.
    pub(super) fn place_all_breakpoints(&mut self) -> Vec<Breakpoint> {
        let paths: Vec<String> = self.breakpoints.files.keys().cloned().collect();
        paths.iter().flat_map(|path| self.place_breakpoints(path)).collect()
    }

    fn place_breakpoints(&mut self, path: &str) -> Vec<Breakpoint> {
        if let (Some(debuggee), Some(file)) = (&self.debuggee, self.breakpoints.files.get_mut(path)) {
            for asked in &mut file.asked {
                asked.placed = place(debuggee, path, asked);
            }
        }
        self.shown(path)
    }

    /// Sends all break-points to the target; one the target refuses is not placed.
    pub(super) fn arm_breakpoints(&mut self) -> Result<(), RequestError> {
        let mut pcs = self.breakpoints.pcs();
        let (target, debuggee) = self.parts()?;
        if matches!(&debuggee.how, How::Launch(arguments) if arguments.no_debug) {
            pcs.clear();
        }
        let most = usize::from(target.limits().max_breakpoints);
        let surplus = if pcs.len() > most { pcs.split_off(most) } else { Vec::new() };
        let Response::Breakpoints(states) = target.ask(Ask::SetBreakpoints { pcs: pcs.clone() })? else {
            return Err(RequestError::Refused("it did not tell what became of the break-points".into()));
        };
        let refused = pcs.into_iter().zip(states).filter_map(|(pc, state)| Some((pc, refusal(state)?)));
        let refused: Vec<_> = refused.chain(surplus.into_iter().map(|pc| (pc, TOO_MANY))).collect();
        for asked in self.breakpoints.files.values_mut().flat_map(|f| &mut f.asked) {
            let Ok((_, placed)) = &mut asked.placed else { continue };
            let reason = refused.iter().find(|(pc, _)| placed.contains(pc)).map(|(_, reason)| *reason);
            placed.retain(|pc| !refused.iter().any(|(no, _)| no == pc));
            if let (true, Some(reason)) = (placed.is_empty(), reason) {
                asked.placed = Err(reason.to_owned());
            }
        }
        Ok(())
    }

    /// How the client is told about the break-points of a file.
    fn shown(&self, path: &str) -> Vec<Breakpoint> {
        let Some(file) = self.breakpoints.files.get(path) else { return Vec::new() };
        let changed = self.debuggee.is_some() && (file.modified || self.differs_from_build(path));
        let shown = file.asked.iter().map(|asked| {
            let (line, message) = match &asked.placed {
                Ok((line, _)) => {
                    let moved = *line != asked.line;
                    let message = match (changed, moved) {
                        (true, _) => Some(
                            "the file has changed since the build; restart to bring lines and code together"
                                .into(),
                        ),
                        (false, true) => {
                            Some(format!("line {} has no code; moved to the next line that has", asked.line))
                        }
                        (false, false) => None,
                    };
                    (*line, message)
                }
                Err(reason) => (asked.line, Some(reason.clone())),
            };
            Breakpoint {
                id: Some(asked.id),
                verified: asked.placed.is_ok(),
                message,
                source: Some(sources::source(std::path::Path::new(path))),
                line: Some(self.line_out(line)),
                ..Breakpoint::default()
            }
        });
        shown.collect()
    }

    /// The file on disk is not what the program was built from.
    fn differs_from_build(&self, path: &str) -> bool {
        let Some(debuggee) = &self.debuggee else { return false };
        let Some(file) = debuggee.map.file(path) else { return false };
        let built = debuggee.debug.files.get(usize::from(file)).map(|f| f.hash);
        let now = debuggee.map.path(file).and_then(|path| std::fs::read(path).ok());
        // The build sees the decoded text.
        let text = now.map(|bytes| decode(&bytes, debuggee.project.encoding).text);
        text.is_some_and(|text| Some(hash_bytes(text.as_bytes())) != built)
    }

    pub(super) fn set_exception_breakpoints(&mut self, request: &Request) -> Answer {
        let arguments: SetExceptionBreakpointsArguments = request.parse()?;
        self.break_on_fault = arguments.filters.iter().any(|f| f == FAULT_FILTER);
        let breakpoints = arguments.filters.iter().map(|filter| {
            let known = filter == FAULT_FILTER;
            let message = (!known).then(|| format!("there is no filter `{filter}`"));
            Breakpoint { verified: known, message, ..Breakpoint::default() }
        });
        body(&SetExceptionBreakpointsResponse { breakpoints: Some(breakpoints.collect()) })
    }

    pub(super) fn breakpoint_locations(&mut self, request: &Request) -> Answer {
        let arguments: BreakpointLocationsArguments = request.parse()?;
        let debuggee = self.debuggee()?;
        let file = arguments.source.path.as_deref().and_then(|p| debuggee.map.file(p));
        let from = self.line_in(arguments.line);
        let to = arguments.end_line.map_or(from, |l| self.line_in(l));
        let lines = file.map(|file| debuggee.map.lines(file, from, to)).unwrap_or_default();
        let breakpoints = lines
            .into_iter()
            .map(|line| BreakpointLocation { line: self.line_out(line), ..BreakpointLocation::default() })
            .collect();
        body(&BreakpointLocationsResponse { breakpoints })
    }
}

const TOO_MANY: &str = "the target has no room for more break-points; remove one";

fn refusal(state: BreakpointState) -> Option<&'static str> {
    match state {
        BreakpointState::Set => None,
        BreakpointState::NotAStatement => Some(NoPlace::NoCode.text()),
        BreakpointState::InFast => Some(NoPlace::Fast.text()),
        BreakpointState::InCont => Some(NoPlace::Cont.text()),
        BreakpointState::TooMany => Some(TOO_MANY),
    }
}

/// Which break-points carry a condition, a hit count or a log text. (The `dap` crate misspells two of the fields.)
fn conditions(request: &Request) -> impl Iterator<Item = bool> {
    let list = request.arguments["breakpoints"].as_array().cloned().unwrap_or_default();
    list.into_iter().map(|b| {
        ["condition", "hitCondition", "logMessage"]
            .iter()
            .any(|key| b[*key].as_str().is_some_and(|text| !text.trim().is_empty()))
    })
}

fn place(debuggee: &Debuggee, path: &str, asked: &Asked) -> Result<(u32, Vec<Pc>), String> {
    if asked.conditional {
        return Err(
            "conditions, hit counts and log points are not available on this target; use a plain break-point"
                .into(),
        );
    }
    let Some(file) = debuggee.map.file(path) else {
        return Err("the file does not belong to the program".into());
    };
    let everywhere = debuggee.project.break_everywhere;
    let placement = debuggee.map.place(&debuggee.program, &debuggee.debug, file, asked.line, everywhere);
    placement.map(|p| (p.line, p.pcs)).map_err(|reason| reason.text().to_owned())
}
