//! Whole sessions: a client, the adapter, the protocol, and a scripted target.

mod breakpoints;
mod forcing;
mod inspecting;
mod lifecycle;
mod robustness;
mod stops;
mod watching;

use serde_json::{Value, json};
use tempfile::TempDir;

use technol_wire::message::{StopReason, Stopped};

use crate::client::{Client, ClientError, Mark};
use crate::mock::{Mock, SampleBuilder, stop_in_spindle};
use crate::sample;

/// A client with an adapter, a target and a project folder.
struct Setup {
    client: Client,
    mock: Mock,
    folder: TempDir,
}

impl Setup {
    fn new() -> Self {
        Setup::with(Mock::new(), |_| {})
    }

    fn with(mock: Mock, change: impl FnOnce(&mut SampleBuilder)) -> Self {
        let folder = TempDir::new().unwrap();
        for (name, text) in sample::texts() {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let mut builder = SampleBuilder { root: folder.path().to_owned(), ..SampleBuilder::default() };
        change(&mut builder);
        let client = Client::in_process(&mock.surroundings(builder)).unwrap();
        Setup { client, mock, folder }
    }

    fn path(&self, name: &str) -> String {
        self.folder.path().join(name).to_string_lossy().into_owned()
    }

    fn launch_arguments(&self) -> Value {
        json!({ "program": self.folder.path() })
    }

    /// Launched and running, with the stops that will come.
    fn launched(stops: Vec<Stopped>) -> Self {
        let mut setup = Setup::new();
        setup.mock.state().stops.extend(stops);
        let arguments = setup.launch_arguments();
        setup.client.start(arguments, &[]).unwrap();
        setup
    }

    /// Launched and stopped at line 20 of SPINDLE.
    fn stopped() -> Self {
        let mut setup = Setup::launched(vec![stop_in_spindle(StopReason::Breakpoint, 20)]);
        setup.client.event(Mark::START, "stopped").unwrap();
        setup
    }

    fn refusal(&mut self, command: &str, arguments: Value) -> String {
        match self.client.request(command, arguments) {
            Err(ClientError::Refused { message, .. }) => message,
            other => panic!("{command} was not refused: {other:?}"),
        }
    }

    /// `name = value` of variables.
    fn lines(variables: &[Value]) -> Vec<String> {
        let text = |v: &Value| v.as_str().unwrap_or_default().to_owned();
        variables.iter().map(|v| format!("{} = {}", text(&v["name"]), text(&v["value"]))).collect()
    }
}

impl Drop for Setup {
    fn drop(&mut self) {
        // The target's thread ends with the link.
        self.mock.state().cut = true;
    }
}
