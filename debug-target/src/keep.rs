//! Files of what outlives a program: PLC_MEM_BACKUP and tables that it changed.

use std::fmt;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use technol_machine::{ControlData, SimulatedControl, Table};

type Write = dyn Fn(&[Table]) -> io::Result<()> + Send + Sync;

/// Writes tables back to where they came from.
#[derive(Clone)]
pub struct TableWriter(Arc<Write>);

impl TableWriter {
    /// A writer that does this with all tables.
    pub fn new(write: impl Fn(&[Table]) -> io::Result<()> + Send + Sync + 'static) -> TableWriter {
        TableWriter(Arc::new(write))
    }
}

impl fmt::Debug for TableWriter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("TableWriter")
    }
}

/// Where things are kept. The default keeps nothing.
#[derive(Clone, Debug, Default)]
pub struct Keep {
    /// File of PLC_MEM_BACKUP.
    pub backup: Option<PathBuf>,
    /// Writer of tables; `None`: changes are forgotten.
    pub tables: Option<TableWriter>,
    saved: u64,
    written: Vec<Table>,
}

impl Keep {
    /// Keeps the memory in this file and tables by this writer.
    #[must_use]
    pub fn new(backup: Option<PathBuf>, tables: Option<TableWriter>) -> Keep {
        Keep { backup, tables, saved: 0, written: Vec::new() }
    }

    /// Completes what the control has on its disk by what was kept. A file that is not there yet holds nothing.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn load(&mut self, data: &mut ControlData) -> Result<(), String> {
        self.written.clone_from(&data.tables);
        let Some(path) = &self.backup else { return Ok(()) };
        match fs::read(path) {
            Ok(bytes) => data.backup = bytes,
            Err(error) if error.kind() == ErrorKind::NotFound => {}
            Err(error) => return Err(failed("cannot read the backed-up memory", path, &error)),
        }
        Ok(())
    }

    /// Writes what was saved since the last call; nothing when nothing was.
    ///
    /// # Errors
    /// A file cannot be written. What could not be written is tried again at the next saving.
    pub fn follow(&mut self, control: &SimulatedControl) -> Result<(), String> {
        if control.times_saved() == self.saved {
            return Ok(());
        }
        self.saved = control.times_saved();
        let data = control.data();
        if let Some(path) = &self.backup {
            replace(path, &data.backup).map_err(|e| failed("cannot save the backed-up memory", path, &e))?;
        }
        if let Some(tables) = self.tables.as_ref().filter(|_| self.written != data.tables) {
            (tables.0)(&data.tables).map_err(|e| format!("cannot write the tables: {e}"))?;
            self.written.clone_from(&data.tables);
        }
        Ok(())
    }

    /// Another control takes over, which has saved nothing yet.
    pub(crate) fn restart(&mut self) {
        self.saved = 0;
    }
}

fn failed(what: &str, path: &Path, error: &io::Error) -> String {
    format!("{what} {}: {error}", path.display())
}

/// Replaces a file as a whole, so that a failure half-way leaves the old one.
///
/// # Errors
/// It cannot be written.
pub fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".new");
    let new = path.with_file_name(name);
    fs::write(&new, bytes)?;
    fs::rename(&new, path)
}
