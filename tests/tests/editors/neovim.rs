//! Neovim with the files of `editors/neovim`.

use std::process::Command;

use crate::lathe::Lathe;
use crate::program::{self, Program};

/// Neovim: `TECHNOL_NVIM`, or the one on the PATH. Older than 0.10 it has no `vim.lsp.start` to speak of.
const NEOVIM: Program = Program { name: "nvim", variable: "TECHNOL_NVIM" };
const LEAST: (u32, u32) = (0, 10);

#[test]
fn neovim_edits_and_debugs_with_our_files() {
    let Some(neovim) = program::find(&NEOVIM) else { return };
    if neovim.version < LEAST {
        eprintln!("SKIPPED: Neovim {:?} is older than {LEAST:?}", neovim.version);
        return;
    }
    let lathe = Lathe::copy();
    let root = crate::binary::root();
    let mut command = Command::new(&neovim.path);
    command.args(["--headless", "-u", "NONE", "-i", "NONE", "-c"]);
    command.arg(format!("luafile {}", root.join("tests/tests/editors/neovim.lua").display()));
    command.env("TECHNOL_EDITOR", root.join("editors").join("neovim"));
    command.env("TECHNOL_LATHE", lathe.folder());
    command.env("PATH", program::path_with_technol());
    command.current_dir(lathe.folder());
    let output = program::run(command);
    let said = String::from_utf8_lossy(&output.stdout);
    let complained = String::from_utf8_lossy(&output.stderr);
    // Whoever reads the log of the tests sees what was left out.
    eprintln!("{said}");
    assert!(output.status.success(), "{said}\n{complained}");
    assert!(said.lines().filter(|line| line.ends_with(" ok")).count() >= 8, "{said}\n{complained}");
}
