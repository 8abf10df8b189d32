//! The mandatory modules around a few lines.

/// A main file with these data, this MODULE_MAIN and this MODULE_INIT; the other modules are empty.
pub(crate) fn program(data: &str, main: &str, init: &str) -> String {
    format!(
        "DATA\n{data}\nDATA_END\nMODULE_MAIN\n{main}\nMODULE_MAIN_END\n\
         MODULE_INPUT\nMODULE_INPUT_END\nMODULE_BLOCK_INIT\nMODULE_BLOCK_INIT_END\n\
         MODULE_BLOCK_DONE\nMODULE_BLOCK_DONE_END\n\
         MODULE_INIT\n{init}\n MODULE_INIT_FINISHED\nMODULE_INIT_END\n\
         MODULE_CLEAR\nMODULE_CLEAR_END\nMODULE_HALT\nMODULE_HALT_END\nSTOP\n"
    )
}
