//! Helix with `editors/helix/languages.toml`, in a terminal that tmux plays.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::lathe::Lathe;
use crate::program::{self, Found, Program};

const HELIX: Program = Program { name: "hx", variable: "TECHNOL_HX" };
const TMUX: Program = Program { name: "tmux", variable: "TECHNOL_TMUX" };

/// The screen shows what is waited for within this time.
const PATIENCE: Duration = Duration::from_secs(60);
/// A question that a server did not know the answer to yet is asked again after this time.
const AGAIN: Duration = Duration::from_secs(2);

/// A terminal; it goes away with this.
struct Terminal {
    tmux: Found,
    /// A server of our own, so that nobody's sessions are touched.
    socket: String,
}

impl Terminal {
    fn start(tmux: Found, helix: &Found, config: &Path, lathe: &Lathe) -> Terminal {
        let terminal = Terminal { tmux, socket: format!("technol-{}", std::process::id()) };
        let variable = |name: &str, value: &std::ffi::OsStr| format!("{name}={}", value.to_string_lossy());
        let folder = lathe.folder();
        terminal.tmux(&[
            "-f",
            "/dev/null",
            "new-session",
            "-d",
            "-x",
            "120",
            "-y",
            "40",
            "-c",
            &folder.to_string_lossy(),
            "env",
            "TERM=xterm-256color",
            &variable("PATH", &program::path_with_technol()),
            &variable("XDG_CONFIG_HOME", config.as_os_str()),
            &variable("XDG_CACHE_HOME", config.as_os_str()),
            &helix.path.to_string_lossy(),
            "spindle.plc",
        ]);
        terminal
    }

    fn tmux(&self, arguments: &[&str]) -> String {
        let output = Command::new(&self.tmux.path).args(["-L", &self.socket]).args(arguments).output();
        String::from_utf8_lossy(&output.expect("tmux runs").stdout).into_owned()
    }

    /// Keys by their names in tmux; anything else is typed.
    fn keys(&self, keys: &[&str]) {
        for key in keys {
            self.tmux(&["send-keys", key]);
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    fn screen(&self) -> String {
        self.tmux(&["capture-pane", "-p"])
    }

    fn wait(&self, what: &str, is_so: impl Fn(&str) -> bool) {
        assert!(self.shows(PATIENCE, &is_so), "{what}: this did not happen:\n{}", self.screen());
    }

    fn shows(&self, patience: Duration, is_so: &impl Fn(&str) -> bool) -> bool {
        let deadline = Instant::now() + patience;
        loop {
            if is_so(&self.screen()) {
                return true;
            }
            if Instant::now() >= deadline {
                return false;
            }
            std::thread::sleep(Duration::from_millis(100));
        }
    }

    /// Asks until there is an answer: a server that has just started has none.
    fn ask(&self, keys: &[&str], what: &str, is_so: impl Fn(&str) -> bool) {
        let deadline = Instant::now() + PATIENCE;
        loop {
            self.keys(keys);
            if self.shows(AGAIN, &is_so) {
                return;
            }
            assert!(Instant::now() < deadline, "{what}: this did not happen:\n{}", self.screen());
            self.keys(&["Escape"]);
        }
    }

    fn find(&self, text: &str) {
        self.keys(&["g", "g", "/", text, "Enter"]);
        self.wait("the line is found", |screen| screen.contains(text));
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        self.tmux(&["kill-server"]);
    }
}

/// The line at which the program stands.
fn stands_at(screen: &str, text: &str) -> bool {
    screen.lines().any(|line| line.contains('▶') && line.contains(text))
}

#[test]
fn helix_edits_and_debugs_with_our_configuration() {
    let (Some(helix), Some(tmux)) = (program::find(&HELIX), program::find_as(&TMUX, "-V")) else { return };
    let lathe = Lathe::copy();
    let config = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(config.path().join("helix")).expect("a folder");
    let ours = crate::binary::root().join("editors/helix/languages.toml");
    std::fs::copy(ours, config.path().join("helix/languages.toml")).expect("our configuration");
    let terminal = Terminal::start(tmux, &helix, config.path(), &lathe);
    terminal.wait("the file is open", |screen| screen.contains("MODULE_MAIN"));

    // Help, and the declaration in another file.
    terminal.find("LDR  SP_STAND");
    terminal.ask(&["Space", "k"], "help", |screen| screen.contains("main.plc"));
    terminal.keys(&["Escape"]);
    let in_main = |screen: &str| screen.contains("IP1:    DFM K_CW");
    terminal.ask(&["g", "d"], "the declaration", in_main);
    terminal.keys(&[":o spindle.plc", "Enter"]);

    // A mistake, while it is there.
    terminal.find("MODULE_MAIN");
    terminal.keys(&["o", "        LDR  NOBODY", "Escape"]);
    let reported = |screen: &str| screen.contains("NOBODY is not declared");
    terminal.wait("the mistake is shown", reported);
    terminal.keys(&["u"]);
    terminal.wait("it is gone", |screen| !reported(screen));

    // To a break-point, a step on, and what the registers hold.
    terminal.find("LOD  SP_STARTS");
    terminal.keys(&["Space", "G", "b", "Escape", ":debug-start launch .", "Enter"]);
    terminal.wait("it stops", |screen| stands_at(screen, "LOD  SP_STARTS"));
    terminal.keys(&["Space", "G", "n", "Escape"]);
    terminal.wait("it steps", |screen| stands_at(screen, "INR"));
    terminal.keys(&["Space", "G", "v"]);
    terminal.wait("the registers are shown", |screen| screen.contains("RLO: bit = "));
    terminal.keys(&["Escape", "Escape", "Space", "G", "t", "Escape"]);
    terminal.wait("the session is over", |screen| !screen.contains('▶'));
}
