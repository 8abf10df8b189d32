//! A target at the end of a link, for commands that ask it something: one question after another.

use std::collections::HashMap;
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use technol_target::{Address, Connector, Link, Token};
use technol_wire::message::{Failure as Refusal, PROTOCOL_VERSION, Request, Response, Status};
use technol_wire::{HostEvent, HostSession, Ticket};

use crate::exit::Failure;

/// A question that is not answered for this long is given up. A dead link is noticed within a second.
const PATIENCE: Duration = Duration::from_secs(30);

/// Where the token comes from: a file, or for a target on the network the environment.
pub(crate) fn token(file: Option<&Path>, address: Option<&Address>) -> Result<Option<Token>, Failure> {
    let elsewhere = match address {
        Some(Address::Tcp { host, .. }) => !is_this_computer(host),
        _ => false,
    };
    let token = match (file, std::env::var("TECHNOL_TOKEN")) {
        (Some(file), _) => Token::read(file),
        (None, Ok(text)) if elsewhere => Token::new(&text),
        _ => return Ok(None),
    };
    token.map(Some).map_err(|e| Failure::usage(e.to_string()))
}

fn is_this_computer(host: &str) -> bool {
    host == "localhost" || host.parse::<std::net::IpAddr>().is_ok_and(|ip| ip.is_loopback())
}

/// A session with a target.
pub(crate) struct Remote {
    link: Box<dyn Link>,
    session: HostSession,
    began: Instant,
    answers: HashMap<Ticket, Response>,
    downloaded: bool,
    lost: Option<String>,
    /// As the target told it at the beginning.
    pub(crate) status: Status,
    /// Bytes a second that the line carries, if that bounds it.
    pub(crate) line: Option<u32>,
}

impl Remote {
    /// Connects and says hello.
    pub(crate) fn connect(target: &str, token_file: Option<&Path>) -> Result<Remote, Failure> {
        let address: Address = target.parse().map_err(|e| Failure::usage(format!("{e}")))?;
        let token = token(token_file, Some(&address))?;
        let link = Connector::new(address, token).connect().map_err(|e| Failure::usage(e.to_string()))?;
        let since_epoch = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let number = since_epoch.as_nanos() as u32 ^ std::process::id().rotate_left(16);
        let mut remote = Remote {
            line: link.bytes_per_second(),
            session: HostSession::with_timing(number, link.timing()),
            link,
            began: Instant::now(),
            answers: HashMap::new(),
            downloaded: false,
            lost: None,
            status: Status {
                plc: technol_wire::message::PlcState::Empty,
                held: false,
                cycle: 0,
                program: None,
            },
        };
        let hello = remote.session.hello();
        match remote.answer(hello)? {
            Response::Hello { version, status, .. } if version == PROTOCOL_VERSION => remote.status = status,
            Response::Hello { version, .. } => {
                return Err(Failure::usage(format!(
                    "the target speaks version {version} of the protocol, this program {PROTOCOL_VERSION}; use programs of one release"
                )));
            }
            _ => return Err(Failure::usage("what answers there is not a TECHNOL target; check the address")),
        }
        Ok(remote)
    }

    /// The target can do this; bits of [`technol_wire::message::feature`].
    pub(crate) fn can(&self, feature: u32) -> bool {
        self.session.features() & feature != 0
    }

    /// Most bytes of one answer.
    pub(crate) fn most(&self) -> u16 {
        self.session.limits().map_or(256, |l| l.max_read)
    }

    /// Longest payload of a frame.
    pub(crate) fn payload(&self) -> u16 {
        self.session.limits().map_or(64, |l| l.max_payload)
    }

    /// Frames that arrived damaged here, and requests that were sent again.
    pub(crate) fn trouble(&self) -> (u32, u32) {
        (self.session.damaged_frames(), self.session.repeated_requests())
    }

    /// Asks; a refusal is an error.
    pub(crate) fn ask(&mut self, request: Request) -> Result<Response, Failure> {
        let ticket = self.session.request(request);
        match self.answer(ticket)? {
            Response::Failed(refusal) => Err(Failure::usage(refused(&refusal))),
            response => Ok(response),
        }
    }

    /// Sends the bytes of a download that was announced.
    pub(crate) fn download(&mut self, bytes: Vec<u8>) -> Result<(), Failure> {
        self.downloaded = false;
        self.session.download(bytes);
        while !self.downloaded {
            self.pump()?;
        }
        Ok(())
    }

    fn answer(&mut self, ticket: Ticket) -> Result<Response, Failure> {
        let deadline = Instant::now() + PATIENCE;
        loop {
            if let Some(response) = self.answers.remove(&ticket) {
                return Ok(response);
            }
            if Instant::now() >= deadline {
                return Err(Failure::usage("the target is there but does not answer this; try again"));
            }
            self.pump()?;
        }
    }

    fn pump(&mut self) -> Result<(), Failure> {
        if let Some(why) = &self.lost {
            return Err(Failure::usage(format!("the link to the target is lost: {why}")));
        }
        let gone = |e: std::io::Error| Failure::usage(format!("the link to the target is lost: {e}"));
        let now = self.now();
        let deadline = self.session.poll(now);
        let bytes = self.session.transmit();
        if !bytes.is_empty() {
            self.link.send(&bytes).map_err(gone)?;
        }
        let wait = deadline.map_or(0, |at| at.saturating_sub(self.now())).min(20_000);
        let mut buffer = [0; 4096];
        let count = self.link.receive(&mut buffer, Duration::from_micros(wait)).map_err(gone)?;
        self.session.receive(self.now(), &buffer[..count]);
        while let Some(event) = self.session.next() {
            match event {
                HostEvent::Response(ticket, response) => drop(self.answers.insert(ticket, response)),
                HostEvent::DownloadDone => self.downloaded = true,
                HostEvent::LinkLost(reason) => self.lost = Some(reason.to_string()),
                // Nobody asked for anything else.
                _ => {}
            }
        }
        Ok(())
    }

    fn now(&self) -> u64 {
        self.began.elapsed().as_micros() as u64
    }
}

impl Drop for Remote {
    fn drop(&mut self) {
        if self.lost.is_none() {
            let ticket = self.session.request(Request::Goodbye { stop: false });
            // A target that does not hear it notices the silence.
            let deadline = Instant::now() + Duration::from_millis(700);
            while !self.answers.contains_key(&ticket) && Instant::now() < deadline && self.pump().is_ok() {}
        }
    }
}

fn refused(refusal: &Refusal) -> String {
    match refusal {
        Refusal::NotFound(text) | Refusal::Refused(text) => text.clone(),
        Refusal::Unsupported => "the target cannot do that".to_owned(),
        Refusal::TooLarge => "that is too large for the target".to_owned(),
        Refusal::Incomplete => "what arrived at the target is not what was sent; try again".to_owned(),
        Refusal::Version => format!(
            "the target speaks another version of the protocol than this program ({PROTOCOL_VERSION}); use programs of one release"
        ),
        other => format!("the target refuses: {other:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_target_on_the_network_asks_the_environment_for_a_token() {
        assert!(is_this_computer("localhost") && is_this_computer("127.0.0.1") && is_this_computer("::1"));
        assert!(!is_this_computer("192.168.1.5") && !is_this_computer("plc.example"));
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), "short").unwrap();
        let error = token(Some(file.path()), None).unwrap_err().message;
        assert!(error.contains("at least 12 characters"), "{error}");
        assert!(token(None, Some(&Address::Tcp { host: "127.0.0.1".into(), port: 1 })).unwrap().is_none());
    }
}
