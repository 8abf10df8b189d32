//! The processes of a session: adapter, target, cable. None of them outlives its test.

use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use technol_dap::client::Client;

use crate::binary::technol;
use crate::lathe::Lathe;

/// Longer than anything here takes on a busy machine.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// A child process whose output is read line by line; ended with this.
pub(crate) struct Process {
    child: Child,
    lines: Receiver<String>,
    /// Held open: some programs end when it closes.
    _input: Option<ChildStdin>,
}

impl Process {
    pub(crate) fn start(program: &Path, arguments: &[&str]) -> Process {
        let mut child = Command::new(program)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap_or_else(|e| panic!("{}: {e}", program.display()));
        let output = child.stdout.take().expect("a pipe");
        let (sender, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let input = child.stdin.take();
        Process { child, lines, _input: input }
    }

    /// The next line it prints.
    pub(crate) fn line(&mut self) -> String {
        self.lines.recv_timeout(PATIENCE).expect("the program prints a line")
    }

    /// The address in the next line: `listening at ADDRESS`.
    pub(crate) fn address(&mut self) -> String {
        let line = self.line();
        line.strip_prefix("listening at ").unwrap_or_else(|| panic!("an address in `{line}`")).to_owned()
    }

    pub(crate) fn is_running(&mut self) -> bool {
        self.child.try_wait().expect("a child").is_none()
    }

    /// As pulling the plug.
    pub(crate) fn kill(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        self.child.wait().expect("a child");
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.kill();
    }
}

/// Where the program runs.
pub(crate) struct Site {
    /// As the launch arguments name it.
    pub(crate) address: String,
    /// The target, unless it is in the adapter.
    pub(crate) target: Option<Process>,
    _cable: Option<Process>,
}

impl Site {
    /// In the adapter.
    pub(crate) fn embedded() -> Site {
        Site { address: "embedded".to_owned(), target: None, _cable: None }
    }

    /// A target with the lathe's machine at a free port.
    pub(crate) fn tcp(lathe: &Lathe) -> Site {
        let mut target = target(lathe, "--listen", "tcp:127.0.0.1:0");
        Site { address: target.address(), target: Some(target), _cable: None }
    }

    /// A target with the lathe's machine behind two pseudo terminals.
    #[cfg(unix)]
    #[expect(clippy::unnecessary_wraps, reason = "other systems have no pseudo terminals")]
    pub(crate) fn serial(lathe: &Lathe) -> Option<Site> {
        Some(Site::behind(lathe, &[]))
    }

    /// The same where this part of the bits arrives wrong, and that is cut for a second after so many seconds each.
    #[cfg(unix)]
    pub(crate) fn noisy(lathe: &Lathe, errors: f64, between_cuts: u32) -> Site {
        Site::behind(lathe, &[&errors.to_string(), &between_cuts.to_string()])
    }

    #[cfg(unix)]
    fn behind(lathe: &Lathe, cable: &[&str]) -> Site {
        let mut cable = Process::start(Path::new(env!("CARGO_BIN_EXE_pty-pair")), cable);
        let (near, far) = (cable.line(), cable.line());
        let mut target = target(lathe, "--serial", &far);
        assert_eq!(target.address(), format!("serial:{far}@115200"));
        Site { address: format!("serial:{near}@115200"), target: Some(target), _cable: Some(cable) }
    }

    #[cfg(not(unix))]
    pub(crate) fn serial(_: &Lathe) -> Option<Site> {
        eprintln!("NOT TESTED: the serial line, this system has no pseudo terminals");
        None
    }

    pub(crate) fn launch(&self, lathe: &Lathe) -> Value {
        json!({ "program": lathe.folder(), "target": self.address, "clock": "virtual" })
    }
}

fn target(lathe: &Lathe, option: &str, place: &str) -> Process {
    let machine = lathe.path("machine.toml");
    Process::start(technol(), &["target", option, place, "--clock", "virtual", "--machine", &machine])
}

/// `technol dap` on standard input and output.
pub(crate) struct Adapter {
    pub(crate) client: Client,
    child: Child,
}

impl Adapter {
    pub(crate) fn start() -> Adapter {
        let mut child = Command::new(technol())
            .arg("dap")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the adapter starts");
        let mut client =
            Client::new(child.stdout.take().expect("a pipe"), child.stdin.take().expect("a pipe"));
        client.set_patience(PATIENCE);
        Adapter { client, child }
    }

    /// Started and past `initialize`.
    pub(crate) fn initialized() -> Adapter {
        let mut adapter = Adapter::start();
        adapter.client.initialize().expect("initialize");
        adapter
    }

    /// Why the adapter refuses a request.
    pub(crate) fn refusal(&mut self, command: &str, arguments: Value) -> String {
        refusal(&mut self.client, command, arguments)
    }

    /// Waits for the end of the process: its exit code.
    pub(crate) fn exit_code(&mut self) -> Option<i32> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if let Some(status) = self.child.try_wait().expect("a child") {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        panic!("the adapter did not end");
    }
}

impl Drop for Adapter {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Why the adapter refuses a request.
pub(crate) fn refusal(client: &mut Client, command: &str, arguments: Value) -> String {
    match client.request(command, arguments) {
        Err(technol_dap::client::ClientError::Refused { message, .. }) => message,
        other => panic!("`{command}` was to be refused: {other:?}"),
    }
}
