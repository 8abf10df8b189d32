//! Real editors with the files of `editors/`. Who does not have an editor skips its test, and is told so;
//! `cargo xtask test` lists what was skipped at its end.

#[path = "../common/binary.rs"]
#[allow(dead_code)] // parts of it are for other tests
mod binary;
#[path = "../common/lathe.rs"]
#[allow(dead_code)]
mod lathe;

mod program;

#[cfg(unix)]
mod helix;
mod neovim;
