//! Who knows the token gets in, without its being sent: the target asks a question (random bytes), the answer is
//! their HMAC-SHA-256 under the token; the target proves in the same way that it knows the token too.

use std::fmt;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use hmac::{Hmac, KeyInit, Mac};
use sha2::Sha256;
use technol_wire::frame::{self, kind};
use technol_wire::{Frame, FrameDecoder};

use crate::link::Link;
use crate::tcp::TcpLink;

/// Fewer characters can be guessed.
const LEAST: usize = 12;
/// Bytes of a question.
const NONCE: usize = 16;
/// Bytes of an answer.
const MAC: usize = 32;
/// Said before the questions, so that an answer of one end is none of the other.
const HOST: &[u8] = b"TECHNOL host 1";
const TARGET: &[u8] = b"TECHNOL target 1";
/// Longest wait for each step.
const PATIENCE: Duration = Duration::from_secs(3);
/// Whoever gave a wrong answer waits this long, so that guessing takes its time.
const PENALTY: Duration = Duration::from_millis(500);
/// Connections that are asked at the same time; more are closed.
const MOST_VISITORS: usize = 8;

/// A secret that both ends know.
#[derive(Clone)]
pub struct Token(Vec<u8>);

/// A token cannot be had.
#[derive(Debug, thiserror::Error)]
pub enum TokenError {
    /// It can be guessed.
    #[error("a token has at least {LEAST} characters; `openssl rand -hex 16` makes a good one")]
    Short,
    /// The file cannot be read.
    #[error("cannot read the token from {path}: {source}")]
    File {
        /// Its name.
        path: String,
        /// What the system says.
        source: io::Error,
    },
}

impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Token")
    }
}

impl Token {
    /// A token; white space around it does not count.
    ///
    /// # Errors
    /// It is too short.
    pub fn new(text: &str) -> Result<Token, TokenError> {
        let text = text.trim();
        if text.chars().count() < LEAST { Err(TokenError::Short) } else { Ok(Token(text.into())) }
    }

    /// Reads a file with nothing but the token.
    ///
    /// # Errors
    /// It cannot be read, or the token is too short.
    pub fn read(path: &Path) -> Result<Token, TokenError> {
        let text = fs::read_to_string(path)
            .map_err(|source| TokenError::File { path: path.display().to_string(), source })?;
        Token::new(&text)
    }

    fn mac(&self, who: &[u8], first: &[u8], second: &[u8]) -> io::Result<Hmac<Sha256>> {
        let mac = <Hmac<Sha256> as KeyInit>::new_from_slice(&self.0).map_err(io::Error::other)?;
        Ok(mac.chain_update(who).chain_update(first).chain_update(second))
    }

    /// The host's side: answers the target's question and checks its answer.
    pub(crate) fn prove(&self, link: &mut dyn Link) -> io::Result<()> {
        let mut ear = Ear::new();
        let question = ear.hear(link, kind::CHALLENGE, PATIENCE)?.ok_or_else(|| {
            failed("it did not ask for a token; it was started without one, or serves another debugger")
        })?;
        let ours = nonce()?;
        let mut payload = ours.to_vec();
        payload.extend_from_slice(&self.mac(HOST, &question.payload, &ours)?.finalize().into_bytes());
        say(link, kind::PROOF, &payload)?;
        let admission =
            ear.hear(link, kind::ADMISSION, PATIENCE)?.ok_or_else(|| failed("it did not answer any more"))?;
        if admission.payload.is_empty() {
            return Err(failed("it has another token"));
        }
        self.mac(TARGET, &ours, &question.payload)?
            .verify_slice(&admission.payload)
            .map_err(|_| failed("it does not know the token itself; it may be another computer"))
    }

    /// The target's side: asks, and lets in who knows the answer.
    pub(crate) fn admit(&self, link: &mut dyn Link) -> io::Result<()> {
        let question = nonce()?;
        say(link, kind::CHALLENGE, &question)?;
        let proof = Ear::new().hear(link, kind::PROOF, PATIENCE)?;
        let proof = proof.ok_or_else(|| failed("no answer to the question for the token"))?;
        let known = proof.payload.len() == NONCE + MAC && {
            let (theirs, answer) = proof.payload.split_at(NONCE);
            // Compared in constant time.
            self.mac(HOST, &question, theirs)?.verify_slice(answer).is_ok()
        };
        if !known {
            thread::sleep(PENALTY);
            say(link, kind::ADMISSION, &[])?;
            return Err(failed("a wrong token"));
        }
        let ours = self.mac(TARGET, &proof.payload[..NONCE], &question)?.finalize().into_bytes();
        say(link, kind::ADMISSION, &ours)
    }
}

fn failed(text: &str) -> io::Error {
    io::Error::new(ErrorKind::PermissionDenied, text)
}

fn nonce() -> io::Result<[u8; NONCE]> {
    let mut bytes = [0; NONCE];
    getrandom::fill(&mut bytes).map_err(|e| io::Error::other(e.to_string()))?;
    Ok(bytes)
}

fn say(link: &mut dyn Link, kind: u8, payload: &[u8]) -> io::Result<()> {
    let mut bytes = vec![frame::DELIMITER];
    frame::encode(kind, 0, payload, &mut bytes);
    link.send(&bytes)
}

/// Waits for frames of one kind.
struct Ear(FrameDecoder);

impl Ear {
    fn new() -> Ear {
        Ear(FrameDecoder::new(NONCE + MAC))
    }

    fn hear(&mut self, link: &mut dyn Link, kind: u8, patience: Duration) -> io::Result<Option<Frame>> {
        let deadline = Instant::now() + patience;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(None);
            }
            // One by one: what comes behind the frame is for somebody else.
            let mut byte = [0];
            if link.receive(&mut byte, left)? == 1
                && let Some(Ok(frame)) = self.0.push(byte[0])
                && frame.kind == kind
            {
                return Ok(Some(frame));
            }
        }
    }
}

type Visit = Result<(TcpLink, String), String>;

/// Connections that are asked for the token, each on a thread of its own, while the PLC runs on.
pub(crate) struct Visitors {
    outcome: Sender<Visit>,
    outcomes: Receiver<Visit>,
    asked: usize,
}

impl Default for Visitors {
    fn default() -> Visitors {
        let (outcome, outcomes) = channel();
        Visitors { outcome, outcomes, asked: 0 }
    }
}

impl Visitors {
    pub(crate) fn ask(&mut self, mut link: TcpLink, from: String, token: &Token) {
        if self.asked >= MOST_VISITORS {
            return; // closed
        }
        let (token, outcome) = (token.clone(), self.outcome.clone());
        let asking = thread::Builder::new().name("token".into()).spawn(move || {
            let visit = match token.admit(&mut link) {
                Ok(()) => Ok((link, from)),
                Err(error) => Err(format!("{from}: {error}")),
            };
            // Nobody waits for it any more when the target has ended.
            let _ = outcome.send(visit);
        });
        self.asked += usize::from(asking.is_ok());
    }

    /// The next one whose answer is there.
    pub(crate) fn admitted(&mut self) -> Option<Visit> {
        let visit = self.outcomes.try_recv().ok()?;
        self.asked -= 1;
        Some(visit)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // tests
mod tests {
    use super::*;
    use crate::pipe::{MemoryLink, pair};

    fn token(text: &str) -> Token {
        Token::new(text).unwrap()
    }

    /// What both ends say, and all bytes that the host sent.
    fn talk(host: &str, target: &str) -> (io::Result<()>, io::Result<()>) {
        let (mut near, mut far) = pair();
        let target = token(target);
        let asking = thread::spawn(move || target.admit(&mut far));
        let host = token(host).prove(&mut near);
        (host, asking.join().unwrap())
    }

    #[test]
    fn who_knows_the_token_gets_in() {
        let (host, target) = talk("a long secret token", "a long secret token\n");
        assert!(host.is_ok() && target.is_ok(), "{host:?} {target:?}");
    }

    #[test]
    fn who_does_not_stays_out() {
        let (host, target) = talk("a long secret token", "another secret token");
        assert_eq!(host.unwrap_err().to_string(), "it has another token");
        assert_eq!(target.unwrap_err().to_string(), "a wrong token");
    }

    /// A link that keeps what it sent.
    struct Overheard(MemoryLink, Vec<u8>);

    impl Link for Overheard {
        fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
            self.1.extend_from_slice(bytes);
            self.0.send(bytes)
        }

        fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
            self.0.receive(buffer, timeout)
        }
    }

    #[test]
    fn the_token_is_never_sent_and_an_answer_helps_nobody_else() {
        let (near, mut far) = pair();
        let (secret, asking) = (token("a long secret token"), token("a long secret token"));
        let target = thread::spawn(move || asking.admit(&mut far));
        let mut near = Overheard(near, Vec::new());
        secret.prove(&mut near).unwrap();
        target.join().unwrap().unwrap();
        assert!(!near.1.windows(6).any(|w| w == b"secret"));

        // The same answer to the next question.
        let (mut thief, mut far) = pair();
        let asking = token("a long secret token");
        let target = thread::spawn(move || asking.admit(&mut far));
        thief.send(&near.1).unwrap();
        assert_eq!(target.join().unwrap().unwrap_err().to_string(), "a wrong token");
    }

    #[test]
    fn a_target_that_only_pretends_to_know_the_token_is_found_out() {
        let (mut near, mut far) = pair();
        let pretending = thread::spawn(move || {
            say(&mut far, kind::CHALLENGE, &[1; NONCE]).unwrap();
            Ear::new().hear(&mut far, kind::PROOF, PATIENCE).unwrap().unwrap();
            say(&mut far, kind::ADMISSION, &[2; MAC]).unwrap();
        });
        let error = token("a long secret token").prove(&mut near).unwrap_err().to_string();
        assert!(error.starts_with("it does not know the token itself"), "{error}");
        pretending.join().unwrap();
    }

    /// Worked out with another implementation of HMAC.
    #[test]
    fn an_answer_looks_like_this() {
        let mac = token("0123456789ab").mac(HOST, &[1; NONCE], &[2; NONCE]).unwrap().finalize().into_bytes();
        let (first, last) = (&mac[..4], &mac[28..]);
        assert_eq!((first, last), (&[0x66, 0x91, 0xCF, 0x57][..], &[0xFC, 0x23, 0xB6, 0x67][..]));
    }

    #[test]
    fn a_token_that_can_be_guessed_is_refused() {
        assert!(matches!(Token::new(" 12345678901 "), Err(TokenError::Short)));
        assert!(Token::new("123456789012").is_ok());
        let error = Token::read(Path::new("/no/such/token")).unwrap_err().to_string();
        assert!(error.starts_with("cannot read the token from /no/such/token: "), "{error}");
    }
}
