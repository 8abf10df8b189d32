//! A null-modem cable made of two pseudo terminals: prints the two device names, one a line, and carries bytes
//! between them until its standard input ends. For tests of the serial link.

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
    use std::io::{Read, Write};

    use rustix::fs::{Mode, OFlags};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

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

    fn carry(mut from: File, mut to: File) {
        let mut buffer = [0; 256];
        while let Ok(n) = from.read(&mut buffer) {
            if n == 0 || to.write_all(&buffer[..n]).is_err() {
                break;
            }
        }
    }

    pub(super) fn run() -> std::io::Result<()> {
        let (left, right) = (open()?, open()?);
        println!("{}\n{}", left.device, right.device);
        std::io::stdout().flush()?;
        let (a, b) = (left.master.try_clone()?, right.master.try_clone()?);
        std::thread::spawn(move || carry(a, b));
        let (a, b) = (right.master.try_clone()?, left.master.try_clone()?);
        std::thread::spawn(move || carry(a, b));
        // The cable is pulled when whoever started it goes away.
        let mut rest = Vec::new();
        std::io::stdin().read_to_end(&mut rest)?;
        Ok(())
    }
}
