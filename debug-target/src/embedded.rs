//! A target on a thread of its own, inside this process.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};

use crate::core::{TargetCore, TargetOptions};
use crate::pipe::{MemoryLink, pair};
use crate::serve::serve;
use crate::simulation::SimulationError;

/// A running embedded target. It ends when this is dropped, or when its link is.
#[derive(Debug)]
pub struct TargetHandle {
    shutdown: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// Starts a target and gives the debugger's end of the link to it.
///
/// # Errors
/// A program or a machine that is wrong.
pub fn spawn_embedded(options: TargetOptions) -> Result<(MemoryLink, TargetHandle), SimulationError> {
    let mut core = TargetCore::new(options)?;
    let (near, far) = pair();
    let shutdown = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&shutdown);
    let thread = thread::spawn(move || {
        serve(Box::new(far), &mut core, &flag);
    });
    Ok((near, TargetHandle { shutdown, thread: Some(thread) }))
}

impl Drop for TargetHandle {
    fn drop(&mut self) {
        self.shutdown.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // The thread has nothing to report; a panic in it has already been printed.
            let _ = thread.join();
        }
    }
}
