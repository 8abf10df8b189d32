//! Targets to run the same session against: in this process, behind TCP, behind a serial line.

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread::{self, JoinHandle};

use technol_target::{
    Address, Link, Notice, TargetCore, TargetHandle, TargetOptions, Token, connect, serve_listener,
    spawn_embedded,
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
        Tcp::guarded(options, None)
    }

    /// One that asks for a token.
    pub(crate) fn guarded(options: TargetOptions, token: Option<Token>) -> Tcp {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let (tell, told) = mpsc::channel();
        let target = Running::spawn(move |shutdown| {
            let mut core = TargetCore::new(options).unwrap();
            let mut notice = |notice| {
                if let Notice::Listening(address) = notice {
                    tell.send(address).unwrap();
                }
            };
            serve_listener(&listener, token.as_ref(), &mut |link| link, &mut core, shutdown, &mut notice)
                .unwrap();
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
    use technol_link_model::{Faults, Line, LineOptions};
    use technol_target::{Address, Link, SerialPlace, TargetCore, TargetOptions, connect, serve_serial};

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

    fn wire(mut from: File, mut to: File, noise: Faults, seed: u64) -> Running {
        // Only its damage is wanted here; the time of the bytes is that of the terminals.
        let mut line = Line::new(LineOptions { faults: noise, ..LineOptions::default() }, seed);
        Running::spawn(move |shutdown: &AtomicBool| {
            let mut buffer = [0; 512];
            while !shutdown.load(Ordering::Relaxed) {
                match from.read(&mut buffer) {
                    // A full receiver loses what comes, as a serial line does.
                    Ok(count) if count > 0 => {
                        line.send(0, &buffer[..count]);
                        drop(to.write_all(&line.arrived(u64::MAX)));
                    }
                    _ => thread::sleep(std::time::Duration::from_micros(200)),
                }
            }
        })
    }

    impl Serial {
        pub(crate) fn new(options: TargetOptions) -> Serial {
            Serial::noisy(options, Faults::default())
        }

        /// A cable on which things go wrong.
        pub(crate) fn noisy(options: TargetOptions, noise: Faults) -> Serial {
            let (host_master, host_device, host_name) = terminal();
            let (target_master, target_device, target_name) = terminal();
            let there = wire(host_master.try_clone().unwrap(), target_master.try_clone().unwrap(), noise, 1);
            let back = wire(target_master, host_master, noise, 2);
            let (tell, told) = mpsc::channel();
            let target = Running::spawn(move |shutdown| {
                let mut core = TargetCore::new(options).unwrap();
                let mut notice = |_| tell.send(()).unwrap();
                let place = SerialPlace::new(&target_name, 115_200, false);
                let mut as_it_is = |link| link;
                serve_serial(place, &mut as_it_is, &mut core, shutdown, &mut notice).unwrap();
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
