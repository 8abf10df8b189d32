//! `technol demo`: the whole chain on the lathe example, through the real adapter and wire.
//!
//! It is a script that a user could follow by hand in an editor: check, build, break inside a mechanism, look, step,
//! set a value, run on to the end of a reversal.

mod show;

use std::path::{Path, PathBuf};
use std::time::Instant;

use serde_json::{Value, json};
use technol_analysis::Severity;
use technol_dap::client::{Client, ClientError};

use crate::arguments::DemoArguments;
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;
use crate::paint::Paint;
use show::Show;

/// The statement of the reversal that the demonstration stops at.
const DEAD_TIME: &str = "TIM  CNT_DEAD,T_DEAD";
/// The statement that every way through the mechanism ends with.
const END: &str = "FL   0,SP_REQ_CW,SP_REQ_CCW,SP_REQ_STOP";
/// What is worth looking at during a reversal.
const WATCHED: &[&str] = &["SP_WANT_CW", "K_CW", "K_CCW", "SP_STAND", "CNT_DEAD", "SP_TURNS"];

impl From<ClientError> for Failure {
    fn from(error: ClientError) -> Failure {
        Failure::usage(format!("the demonstration failed: {error}"))
    }
}

/// Runs the demonstration.
pub(crate) fn demo(arguments: &DemoArguments) -> Outcome {
    let folder = match &arguments.path {
        Some(path) => path.clone(),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/lathe"),
    };
    let folder = folder.canonicalize().map_err(|e| {
        Failure::usage(format!("{}: {e}; name a copy of examples/lathe: technol demo PATH", folder.display()))
    })?;
    let show = Show::new(Paint::stdout());
    show.title("technol: edit, check, build, run, break, step, watch");
    let project = check(&folder, show)?;
    build(&project, show)?;
    debug(&folder, arguments.backup.as_deref(), show)?;
    show.next();
    Ok(exit::OK)
}

fn check(folder: &Path, show: Show) -> Result<Project, Failure> {
    show.step("Check the project", "technol check examples/lathe");
    let start = Instant::now();
    let project = Project::open(folder)?;
    let findings = project.findings()?;
    let took = start.elapsed();
    let errors = findings.iter().flat_map(|(_, list)| list).filter(|d| d.severity == Severity::Error).count();
    if errors > 0 {
        return Err(Failure {
            code: exit::ERRORS,
            message: format!("{}: {errors} errors", folder.display()),
        });
    }
    let lines: usize = project.loaded.files.iter().map(|f| f.text.lines().count()).sum();
    show.fact(&format!("{lines} lines in {} files, no errors", project.loaded.files.len()), took);
    Ok(project)
}

fn build(project: &Project, show: Show) -> Result<(), Failure> {
    show.step("Build it", "technol build examples/lathe --listing");
    let start = Instant::now();
    let built = crate::build::image(project)?;
    let bytes = technol_image::container::encode_program(&built.image.program).len();
    let hash = crate::build::hex(&built.hash[..4]);
    let program = &built.image.program;
    show.fact(
        &format!(
            "{} operations, {} mechanisms, {bytes} bytes to download, hash {hash}…",
            program.code.len(),
            program.sequences.len().saturating_sub(2)
        ),
        start.elapsed(),
    );
    Ok(())
}

/// A line of a source file that the demonstration stops at.
struct Stop {
    path: PathBuf,
    line: u32,
}

fn find(folder: &Path, file: &str, text: &str) -> Result<Stop, Failure> {
    let path = folder.join(file);
    let source =
        std::fs::read_to_string(&path).map_err(|e| Failure::usage(format!("{}: {e}", path.display())))?;
    match source.lines().position(|line| line.trim().starts_with(text)) {
        Some(n) => Ok(Stop { path, line: n as u32 + 1 }),
        None => Err(Failure::usage(format!("{} does not contain `{text}`", path.display()))),
    }
}

fn debug(folder: &Path, backup: Option<&Path>, show: Show) -> Result<(), Failure> {
    let dead_time = find(folder, "spindle.plc", DEAD_TIME)?;
    let end = find(folder, "spindle.plc", END)?;
    let path = dead_time.path.to_string_lossy().into_owned();

    show.step(
        "Debug it on the embedded target",
        &format!("break-point in spindle.plc, line {}", dead_time.line),
    );
    let start = Instant::now();
    let mut client = Client::in_process(&crate::dap::surroundings_with(backup))?;
    let launch = json!({ "program": folder, "target": "embedded", "clock": "virtual" });
    let mark = client.mark();
    client.start(launch, &[(&path, &[dead_time.line])])?;
    let stopped = client.event(mark, "stopped")?;
    let thread = stopped["threadId"].as_i64().unwrap_or_default();
    show.fact(
        "the part program reversed the spindle: stopped inside the mechanism SP_CONTROL",
        start.elapsed(),
    );
    location(&mut client, thread, show)?;
    registers(&mut client, thread, show)?;
    mechanisms(&mut client, show)?;
    watches(&mut client, show)?;

    show.step("Step", "over the dead time: the mechanism waits, cycles go by");
    for _ in 0..2 {
        client.go("next", thread)?;
        location(&mut client, thread, show)?;
    }

    show.step("Set a variable", "CNT_DEAD := 14, the dead time is over one cycle later");
    let frame = client.top_frame(thread)?;
    client.request(
        "setExpression",
        json!({ "expression": "CNT_DEAD", "value": "14", "frameId": frame["id"] }),
    )?;
    show.watch("CNT_DEAD", &client.evaluate("CNT_DEAD", "watch")?);

    show.step("Run on to the end of the reversal", &format!("break-point in line {}", end.line));
    client.set_breakpoints(&path, &[end.line])?;
    client.go("continue", thread)?;
    location(&mut client, thread, show)?;
    watches(&mut client, show)?;
    client.disconnect(json!({ "terminateDebuggee": true }))?;
    client.end();
    Ok(())
}

fn location(client: &mut Client, thread: i64, show: Show) -> Result<(), Failure> {
    let frame = client.top_frame(thread)?;
    let path = PathBuf::from(frame["source"]["path"].as_str().unwrap_or_default());
    let line = frame["line"].as_u64().unwrap_or_default() as usize;
    let source = std::fs::read_to_string(&path).unwrap_or_default();
    show.source(&path, &source, line);
    Ok(())
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

fn registers(client: &mut Client, thread: i64, show: Show) -> Result<(), Failure> {
    let frame = client.top_frame(thread)?;
    show.heading("Registers");
    for variable in client.scope(&frame, "Registers")? {
        if ["RLO", "DR16", "DR64", "DR_REAL"].contains(&text(&variable, "name")) {
            show.watch(text(&variable, "name"), text(&variable, "value"));
        }
    }
    Ok(())
}

fn mechanisms(client: &mut Client, show: Show) -> Result<(), Failure> {
    show.heading("Mechanisms at work");
    let threads = client.request("threads", Value::Null)?;
    for thread in threads["threads"].as_array().into_iter().flatten() {
        show.item(text(thread, "name"));
    }
    Ok(())
}

fn watches(client: &mut Client, show: Show) -> Result<(), Failure> {
    show.heading("Variables");
    for name in WATCHED {
        show.watch(name, &client.evaluate(name, "watch")?);
    }
    Ok(())
}
