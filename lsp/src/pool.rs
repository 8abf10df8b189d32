//! The threads that compute answers.

use std::thread;

use crossbeam_channel::{Sender, unbounded};

/// A piece of work.
type Job = Box<dyn FnOnce() + Send>;

/// A few threads that take work in the order it comes. They end once the pool is dropped and their work is done;
/// nobody waits for them.
#[derive(Debug)]
pub(crate) struct Pool {
    jobs: Sender<Job>,
}

impl Pool {
    /// Starts the threads: as many as the machine runs at once, but two at least, so that a long computation
    /// leaves room for a short one, and four at most.
    pub(crate) fn start() -> std::io::Result<Pool> {
        let (jobs, queue) = unbounded::<Job>();
        let count = thread::available_parallelism().map_or(2, usize::from).clamp(2, 4);
        for number in 0..count {
            let queue = queue.clone();
            thread::Builder::new()
                .name(format!("worker-{number}"))
                .stack_size(8 * 1024 * 1024)
                .spawn(move || queue.iter().for_each(|job| job()))?;
        }
        Ok(Pool { jobs })
    }

    /// Hands work to the next free thread. The work must not panic.
    pub(crate) fn run(&self, job: impl FnOnce() + Send + 'static) {
        // The queue lives as long as its threads, and those end only after this sender is gone.
        let _ = self.jobs.send(Box::new(job));
    }
}
