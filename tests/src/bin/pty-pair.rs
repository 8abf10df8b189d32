//! A null-modem cable made of two pseudo terminals: prints the two device names, one a line, and carries bytes
//! between them until its standard input ends. For tests of the serial link.
//!
//! `pty-pair [ERRORS [SECONDS]]`: this part of the bits arrives wrong, and after so many seconds each the cable carries
//! nothing for one.

#[cfg(unix)]
fn main() -> std::io::Result<()> {
    pair::run()
}

#[cfg(not(unix))]
fn main() {
    eprintln!("pty-pair: pseudo terminals exist on Unix only");
    std::process::exit(2);
}

#[cfg(unix)]
mod pair {
    use std::fs::File;
    use std::io::{Error, ErrorKind, Read, Write};
    use std::str::FromStr;
    use std::time::Instant;

    use rustix::fs::{Mode, OFlags};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};
    use technol_link_model::{Faults, Line, LineOptions};

    struct End {
        master: File,
        /// Held open so that the master does not see a hang-up while nobody else has the device.
        _slave: File,
        device: String,
    }

    fn open() -> std::io::Result<End> {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        let device = ptsname(&master, Vec::new())?.to_string_lossy().into_owned();
        let slave = rustix::fs::open(
            device.as_str(),
            OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC,
            Mode::empty(),
        )?;
        let mut settings = tcgetattr(&slave)?;
        settings.make_raw();
        tcsetattr(&slave, OptionalActions::Now, &settings)?;
        Ok(End { master: File::from(master), _slave: File::from(slave), device })
    }

    /// What is wrong with the cable.
    #[derive(Clone, Copy)]
    struct Trouble {
        errors: f64,
        /// Seconds from the end of one cut to the next.
        between_cuts: Option<u64>,
        begun: Instant,
    }

    impl Trouble {
        fn is_cut(self) -> bool {
            let second = self.begun.elapsed().as_secs();
            self.between_cuts.is_some_and(|between| second % (between + 1) == between)
        }
    }

    fn carry(mut from: File, mut to: File, trouble: Trouble, seed: u64) {
        // Only the damage of the model is wanted: the time of the bytes is that of the terminals.
        let faults = Faults::bit_errors(trouble.errors);
        let mut line = Line::new(LineOptions { faults, ..LineOptions::default() }, seed);
        let mut buffer = [0; 256];
        while let Ok(n) = from.read(&mut buffer) {
            if n == 0 {
                break;
            }
            if trouble.is_cut() {
                continue;
            }
            line.send(0, &buffer[..n]);
            if to.write_all(&line.arrived(u64::MAX)).is_err() {
                break;
            }
        }
    }

    fn argument<T: FromStr>(n: usize) -> std::io::Result<Option<T>> {
        let Some(text) = std::env::args().nth(n) else { return Ok(None) };
        let wrong = |_| Error::new(ErrorKind::InvalidInput, format!("`{text}` is no such number"));
        text.parse().map(Some).map_err(wrong)
    }

    pub(super) fn run() -> std::io::Result<()> {
        let (errors, between_cuts) = (argument(1)?.unwrap_or(0.0), argument(2)?);
        let trouble = Trouble { errors, between_cuts, begun: Instant::now() };
        let (left, right) = (open()?, open()?);
        println!("{}\n{}", left.device, right.device);
        std::io::stdout().flush()?;
        let (a, b) = (left.master.try_clone()?, right.master.try_clone()?);
        std::thread::spawn(move || carry(a, b, trouble, 1));
        let (a, b) = (right.master.try_clone()?, left.master.try_clone()?);
        std::thread::spawn(move || carry(a, b, trouble, 2));
        // The cable is pulled when whoever started it goes away.
        let mut rest = Vec::new();
        std::io::stdin().read_to_end(&mut rest)?;
        Ok(())
    }
}
