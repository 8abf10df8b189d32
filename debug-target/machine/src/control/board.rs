//! What the operator sees of messages (manual 14.2): one transient message at a time, to be confirmed, with those behind
//! it waiting; and the list of persistent ones, which the program shows and removes.

use alloc::collections::VecDeque;
use alloc::vec::Vec;

use super::data::ControlData;
use super::messages::message;

/// Transient messages that wait; later ones are lost until one is confirmed.
const WAITING: usize = 64;
/// Persistent messages in the list.
const LISTED: usize = 256;

/// Kind of a message: how serious it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MessageKind {
    /// The system cannot go on.
    ErrCritical,
    /// An error.
    Err,
    /// An important warning.
    Wrn1,
    /// A warning.
    Wrn2,
    /// A warning of little importance.
    Wrn3,
    /// Information.
    Info,
    /// Only for the event log: nothing is shown.
    Event,
}

impl MessageKind {
    /// All kinds.
    pub const ALL: [MessageKind; 7] = [
        MessageKind::ErrCritical,
        MessageKind::Err,
        MessageKind::Wrn1,
        MessageKind::Wrn2,
        MessageKind::Wrn3,
        MessageKind::Info,
        MessageKind::Event,
    ];

    /// Its name in a file of messages (manual 14.4).
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            MessageKind::ErrCritical => "ErrCritical",
            MessageKind::Err => "Err",
            MessageKind::Wrn1 => "Wrn1",
            MessageKind::Wrn2 => "Wrn2",
            MessageKind::Wrn3 => "Wrn3",
            MessageKind::Info => "Info",
            MessageKind::Event => "Event",
        }
    }

    /// The kind of that name.
    #[must_use]
    pub fn of(name: &str) -> Option<MessageKind> {
        MessageKind::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// Messages of this kind go into the event log.
    #[must_use]
    pub fn is_logged(self) -> bool {
        matches!(self, MessageKind::ErrCritical | MessageKind::Err | MessageKind::Wrn1 | MessageKind::Event)
    }
}

/// What a file of messages says of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MessageText {
    /// How serious it is.
    pub kind: MessageKind,
    /// It stays until the program removes it; else the operator confirms it.
    pub persistent: bool,
    /// Its text, with `%d` and `%X` for values, in the code page of the control.
    pub text: Vec<u8>,
}

/// A message on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Its number.
    pub number: u32,
    /// Supplementary number.
    pub sub_id: Option<i64>,
    /// Values for its text.
    pub parameters: [Option<i64>; 3],
    /// Cycle in which it was reported.
    pub cycle: u64,
}

impl Shown {
    /// Its text with the values put in, in the code page of the control; empty when no file defines it and it is none of the
    /// control itself.
    #[must_use]
    pub fn text(&self, data: &ControlData) -> Vec<u8> {
        let mut rest = match data.message(self.number) {
            Some(known) => &known.text,
            None => message::text(self.number).as_bytes(),
        };
        let mut values = self.parameters.iter();
        let mut text = Vec::with_capacity(rest.len());
        while let Some((first, behind)) = rest.split_first() {
            let form = behind.first().copied().filter(|_| *first == b'%');
            rest = if let Some(form @ (b'd' | b'X')) = form {
                let value = values.next().copied().flatten().unwrap_or(0);
                let digits = if form == b'd' {
                    alloc::format!("{value}")
                } else {
                    alloc::format!("{:X}", value as u32)
                };
                text.extend_from_slice(digits.as_bytes());
                &behind[1..]
            } else {
                text.push(*first);
                behind
            };
        }
        text
    }
}

/// The messages on the screen. It never asks for memory once it exists.
#[derive(Clone, Debug)]
pub struct MessageBoard {
    transient: VecDeque<Shown>,
    persistent: Vec<Shown>,
    lost: u32,
}

impl Default for MessageBoard {
    fn default() -> MessageBoard {
        MessageBoard {
            transient: VecDeque::with_capacity(WAITING),
            persistent: Vec::with_capacity(LISTED),
            lost: 0,
        }
    }
}

impl MessageBoard {
    /// The transient message that waits to be confirmed, then those behind it.
    pub fn transient(&self) -> impl Iterator<Item = &Shown> {
        self.transient.iter()
    }

    /// The list of persistent messages, the oldest first.
    pub fn persistent(&self) -> impl Iterator<Item = &Shown> {
        self.persistent.iter()
    }

    /// Messages for which there was no room, since power-on.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost
    }

    /// The operator confirms the transient message; the next one takes its place.
    pub(super) fn acknowledge(&mut self) -> Option<Shown> {
        self.transient.pop_front()
    }

    /// A program reports (`set`) or removes a message.
    pub(super) fn report(&mut self, known: Option<&MessageText>, message: Shown, set: bool) {
        if known.is_some_and(|known| known.kind == MessageKind::Event) {
            return;
        }
        // A message that no file defines has to be confirmed, so that it is not overlooked.
        if known.is_some_and(|known| known.persistent) {
            self.list(message, set);
        } else if set {
            // The same once more, while it still waits, tells nothing new.
            let same = |it: &Shown| Shown { cycle: message.cycle, ..*it } == message;
            if self.transient.len() < WAITING && !self.transient.iter().any(same) {
                self.transient.push_back(message);
            } else if !self.transient.iter().any(same) {
                self.lost = self.lost.saturating_add(1);
            }
        }
    }

    fn list(&mut self, message: Shown, set: bool) {
        let same = |it: &Shown| (it.number, it.sub_id) == (message.number, message.sub_id);
        let at = self.persistent.iter().position(same);
        match (at, set) {
            (Some(at), true) => self.persistent[at].parameters = message.parameters,
            (Some(at), false) => drop(self.persistent.remove(at)),
            (None, true) if self.persistent.len() < LISTED => self.persistent.push(message),
            (None, true) => self.lost = self.lost.saturating_add(1),
            (None, false) => {}
        }
    }

    /// A start of the PLC: what the program listed is gone, what has to be confirmed stays unless the power was off.
    pub(super) fn start(&mut self, cold: bool) {
        self.persistent.clear();
        if cold {
            self.transient.clear();
            self.lost = 0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(number: u32, parameter: i64) -> Shown {
        Shown { number, sub_id: None, parameters: [Some(parameter), None, None], cycle: 0 }
    }

    fn known(kind: MessageKind, persistent: bool) -> MessageText {
        MessageText { kind, persistent, text: b"%d of %X, 100%%x %d".to_vec() }
    }

    fn numbers<'a>(shown: impl Iterator<Item = &'a Shown>) -> Vec<u32> {
        shown.map(|it| it.number).collect()
    }

    #[test]
    fn transient_messages_wait_and_are_confirmed_one_by_one() {
        let (mut board, err) = (MessageBoard::default(), known(MessageKind::Err, false));
        for number in [5, 6, 5, 7] {
            board.report(Some(&err), message(number, 1), true);
        }
        // Another value is another message; the end of a transient message means nothing.
        board.report(Some(&err), message(5, 2), true);
        board.report(Some(&err), message(6, 1), false);
        board.report(None, message(99, 0), true);
        assert_eq!(numbers(board.transient()), [5, 6, 7, 5, 99]);
        assert_eq!(board.acknowledge().map(|it| it.number), Some(5));
        assert_eq!(numbers(board.transient()), [6, 7, 5, 99]);
        board.start(false);
        assert_eq!(numbers(board.transient()), [6, 7, 5, 99]);
        board.start(true);
        assert_eq!(board.acknowledge(), None);
    }

    #[test]
    fn persistent_messages_are_listed_until_the_program_removes_them() {
        let (mut board, info) = (MessageBoard::default(), known(MessageKind::Info, true));
        for (number, set) in [(3, true), (4, true), (3, true), (4, false), (8, false)] {
            board.report(Some(&info), message(number, i64::from(number) + i64::from(set)), set);
        }
        let other = Shown { sub_id: Some(1), ..message(3, 0) };
        board.report(Some(&info), other, true);
        assert_eq!(numbers(board.persistent()), [3, 3]);
        board.report(Some(&info), Shown { sub_id: Some(2), ..message(3, 0) }, false);
        board.report(Some(&info), message(3, 0), false);
        assert_eq!(board.persistent().copied().collect::<Vec<_>>(), [other]);
        assert_eq!((numbers(board.transient()), board.acknowledge()), (Vec::new(), None));
        board.start(false);
        assert_eq!(numbers(board.persistent()), [0; 0]);
    }

    #[test]
    fn events_are_not_shown_and_what_finds_no_room_is_counted() {
        let mut board = MessageBoard::default();
        board.report(Some(&known(MessageKind::Event, false)), message(1, 0), true);
        assert_eq!(numbers(board.transient()), [0; 0]);
        for n in 0..WAITING as i64 + 3 {
            board.report(None, message(2, n), true);
        }
        for n in 0..LISTED as u32 + 2 {
            board.report(Some(&known(MessageKind::Wrn3, true)), message(n, 0), true);
        }
        assert_eq!(
            (board.transient().count(), board.persistent().count(), board.lost()),
            (WAITING, LISTED, 5)
        );
    }

    #[test]
    fn values_take_their_places_in_the_text() {
        let mut data = ControlData::default();
        data.messages.insert(7, known(MessageKind::Err, false));
        let shown = Shown { parameters: [Some(-12), Some(-1), None], ..message(7, 0) };
        assert_eq!(shown.text(&data), b"-12 of FFFFFFFF, 100%%x 0");
        assert_eq!(message(8, 0).text(&data), b"");
    }

    #[test]
    fn kinds_have_the_names_of_the_file() {
        for kind in MessageKind::ALL {
            assert_eq!(MessageKind::of(kind.name()), Some(kind));
        }
        assert_eq!(MessageKind::of("err"), None);
        let logged: Vec<_> =
            MessageKind::ALL.into_iter().filter(|kind| kind.is_logged()).map(MessageKind::name).collect();
        assert_eq!(logged, ["ErrCritical", "Err", "Wrn1", "Event"]);
    }
}
