//! Targets to run the same session against: in this process, behind TCP, behind a serial line.

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread::{self, JoinHandle};

use technol_target::{
    Address, Link, Notice, TargetCore, TargetHandle, TargetOptions, connect, serve_listener, spawn_embedded,
};

/// A target that is running somewhere.
pub(crate) trait Place {
    /// A new link to it; `None` when it takes only one in its life.
    fn link(&mut self) -> Option<Box<dyn Link>>;
}

pub(crate) struct Embedded {
    link: Option<Box<dyn Link>>,
    _handle: TargetHandle,
}

impl Embedded {
    pub(crate) fn new(options: TargetOptions) -> Embedded {
        let (link, handle) = spawn_embedded(options).unwrap();
        Embedded { link: Some(Box::new(link)), _handle: handle }
    }
}

impl Place for Embedded {
    fn link(&mut self) -> Option<Box<dyn Link>> {
        self.link.take()
    }
}

/// A thread that is told to end, and waited for.
pub(crate) struct Running {
    shutdown: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Running {
    pub(crate) fn spawn(work: impl FnOnce(&AtomicBool) + Send + 'static) -> Running {
        let shutdown = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&shutdown);
        Running { shutdown, thread: Some(thread::spawn(move || work(&flag))) }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.shutdown.store(true, Ordering::Relaxed);
        let ended = self.thread.take().map(JoinHandle::join);
        assert!(thread::panicking() || !matches!(ended, Some(Err(_))), "the target panicked");
    }
}

pub(crate) struct Tcp {
    pub(crate) address: Address,
    _target: Running,
}

impl Tcp {
    pub(crate) fn new(options: TargetOptions) -> Tcp {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let (tell, told) = mpsc::channel();
        let target = Running::spawn(move |shutdown| {
            let mut core = TargetCore::new(options).unwrap();
            let mut notice = |notice| {
                if let Notice::Listening(address) = notice {
                    tell.send(address).unwrap();
                }
            };
            serve_listener(&listener, &mut core, shutdown, &mut notice).unwrap();
        });
        Tcp { address: told.recv().unwrap(), _target: target }
    }
}

impl Place for Tcp {
    fn link(&mut self) -> Option<Box<dyn Link>> {
        Some(connect(&self.address).unwrap())
    }
}

#[cfg(unix)]
pub(crate) mod serial {
    //! Two pseudo terminals and what joins them: a null-modem cable.

    use std::fs::File;
    use std::io::{Read, Write};
    use std::os::fd::OwnedFd;
    use std::sync::mpsc;
    use std::thread;

    use nix::fcntl::{FcntlArg, OFlag, fcntl};
    use nix::pty::openpty;
    use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
    use nix::unistd::ttyname;
    use std::sync::atomic::{AtomicBool, Ordering};
    use technol_target::{Address, Link, TargetCore, TargetOptions, connect, serve_serial};

    use super::{Place, Running};

    pub(crate) struct Serial {
        address: Address,
        _target: Running,
        _cable: [Running; 2],
        /// Kept open, so that an end may be closed and opened again.
        _devices: [OwnedFd; 2],
    }

    pub(crate) fn terminal() -> (File, OwnedFd, String) {
        let pty = openpty(None, None).unwrap();
        let mut raw = tcgetattr(&pty.slave).unwrap();
        cfmakeraw(&mut raw);
        tcsetattr(&pty.slave, SetArg::TCSANOW, &raw).unwrap();
        fcntl(&pty.master, FcntlArg::F_SETFL(OFlag::O_NONBLOCK)).unwrap();
        let name = ttyname(&pty.slave).unwrap().to_str().unwrap().to_owned();
        (File::from(pty.master), pty.slave, name)
    }

    fn wire(mut from: File, mut to: File) -> Running {
        Running::spawn(move |shutdown: &AtomicBool| {
            let mut buffer = [0; 512];
            while !shutdown.load(Ordering::Relaxed) {
                match from.read(&mut buffer) {
                    // A full receiver loses what comes, as a serial line does.
                    Ok(count) if count > 0 => drop(to.write_all(&buffer[..count])),
                    _ => thread::sleep(std::time::Duration::from_micros(200)),
                }
            }
        })
    }

    impl Serial {
        pub(crate) fn new(options: TargetOptions) -> Serial {
            let (host_master, host_device, host_name) = terminal();
            let (target_master, target_device, target_name) = terminal();
            let there = wire(host_master.try_clone().unwrap(), target_master.try_clone().unwrap());
            let back = wire(target_master, host_master);
            let (tell, told) = mpsc::channel();
            let target = Running::spawn(move |shutdown| {
                let mut core = TargetCore::new(options).unwrap();
                let mut notice = |_| tell.send(()).unwrap();
                serve_serial(&target_name, 115_200, &mut core, shutdown, &mut notice).unwrap();
            });
            told.recv().unwrap();
            Serial {
                address: format!("serial:{host_name}").parse().unwrap(),
                _target: target,
                _cable: [there, back],
                _devices: [host_device, target_device],
            }
        }
    }

    impl Place for Serial {
        fn link(&mut self) -> Option<Box<dyn Link>> {
            Some(connect(&self.address).unwrap())
        }
    }
}
