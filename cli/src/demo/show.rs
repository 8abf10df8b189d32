//! What the demonstration prints.

use std::path::Path;
use std::time::Duration;

use crate::out::say;
use crate::paint::Paint;

/// Lines of source shown before and after the line of interest.
const CONTEXT: usize = 2;

/// The printer.
#[derive(Clone, Copy)]
pub(super) struct Show {
    paint: Paint,
}

impl Show {
    pub(super) fn new(paint: Paint) -> Show {
        Show { paint }
    }

    pub(super) fn title(self, text: &str) {
        say!("{}", self.paint.bold(text));
    }

    /// A part of the demonstration, and how a user would do it.
    pub(super) fn step(self, what: &str, how: &str) {
        say!("\n{} {}  {}", self.paint.cyan("▶"), self.paint.bold(what), self.paint.dim(how));
    }

    /// What came out, and how long it took.
    pub(super) fn fact(self, text: &str, took: Duration) {
        let took = format!("({:.1} ms)", took.as_secs_f64() * 1000.0);
        say!("  {} {text} {}", self.paint.green("✔"), self.paint.dim(took));
    }

    pub(super) fn heading(self, text: &str) {
        say!("  {}", self.paint.bold(text));
    }

    pub(super) fn item(self, text: &str) {
        let (name, rest) = text.split_once(" · ").unwrap_or((text, ""));
        say!("    {} {rest}", self.paint.cyan(name));
    }

    pub(super) fn watch(self, name: &str, value: &str) {
        say!("    {name:<12} {}", self.paint.cyan(value));
    }

    /// A source line among its neighbours.
    pub(super) fn source(self, path: &Path, source: &str, line: usize) {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        say!("  {}", self.paint.dim(format!("{name}:{line}")));
        let first = line.saturating_sub(CONTEXT).max(1);
        for (n, text) in source.lines().enumerate().map(|(n, text)| (n + 1, text)) {
            if n == line {
                say!("  {} {}", self.paint.yellow(format!("→{n:>4}")), self.paint.bold(text));
            } else if (first..=line + CONTEXT).contains(&n) {
                say!("   {} {text}", self.paint.dim(format!("{n:>4}")));
            }
        }
    }

    /// What to try next.
    pub(super) fn next(self) {
        say!("\n{}", self.paint.bold("Try next"));
        for (command, what) in [
            (
                "technol run examples/lathe --cycles 1000 --print SP_TURNS,T_ACTUAL,BLOCKS",
                "a whole part program",
            ),
            (
                "technol run examples/lathe --cycles 1000 --fault ccw-contactor-dead",
                "the same with a dead contactor",
            ),
            ("technol explain TEX0 --language cs", "the help page that the editor shows on hover"),
            (
                "technol target --listen tcp:127.0.0.1:5700 --machine examples/lathe/machine.toml",
                "a target to attach to",
            ),
        ] {
            say!("  {}\n      {}", self.paint.cyan(command), self.paint.dim(what));
        }
        say!("  VS Code, Helix, Neovim: editors/*/README.md; first steps: docs/tutorial.md");
    }
}
